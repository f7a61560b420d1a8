//! What documents name: paths, links, and the glossary's names in the code.

use std::path::Path;

/// Folders at the root whose paths documents write in full.
const FOLDERS: [&str; 9] =
    ["src/", "crates/", "tests/", "docs/", "examples/", "benches/", "specimens/", "tools/", ".ci/"];

/// Paths in backticks, from the root, and links, from the document's own folder, that lead nowhere. A path with a placeholder or a
/// pattern in it is none.
pub fn dead_paths(root: &Path, document: &str, text: &str) -> Vec<String> {
    let folder = root.join(document).parent().expect("a document lies in a folder").to_owned();
    let named = between(text, "`", "`")
        .filter(|path| FOLDERS.iter().any(|start| path.starts_with(start)))
        .filter(|path| !path.contains(|c: char| c.is_whitespace() || "*{<".contains(c)))
        .map(|path| (path, root.join(path)));
    let linked = between(text, "](", ")")
        .map(|link| link.split('#').next().unwrap_or_default())
        .filter(|link| !link.is_empty() && !link.contains("://"))
        .map(|link| (link, folder.join(link)));
    let dead = named.chain(linked).filter(|(_, path)| !path.exists());
    dead.map(|(name, _)| format!("{document} names {name}, which is not there")).collect()
}

/// Names in the code that a glossary's row gives and none of its files holds. Files and names are the last two cells of a row.
pub fn dead_names(root: &Path, glossary: &str) -> Vec<String> {
    let mut dead = Vec::new();
    for row in glossary.lines().filter(|line| line.starts_with('|')) {
        // A bar within a cell is escaped.
        let row = row.replace("\\|", "");
        let cells: Vec<&str> = row.trim_matches('|').split('|').collect();
        let [.., names, files] = cells[..] else { continue };
        let text: String =
            between(files, "`", "`").filter_map(|file| std::fs::read_to_string(root.join(file)).ok()).collect();
        for name in between(names, "`", "`") {
            let last = name.rsplit("::").next().unwrap_or(name);
            if !text.contains(last) {
                dead.push(format!("{name} is in none of {}", files.trim()));
            }
        }
    }
    dead
}

/// What stands between two marks, line by line.
fn between<'a>(text: &'a str, open: &'a str, close: &'a str) -> impl Iterator<Item = &'a str> {
    text.lines().flat_map(move |line| {
        let mut rest = line;
        std::iter::from_fn(move || {
            let (_, behind) = rest.split_once(open)?;
            let (inside, behind) = behind.split_once(close)?;
            rest = behind;
            Some(inside)
        })
    })
}
