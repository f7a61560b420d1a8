//! Paths in a manifest: relative to its folder, with `*`, `?`, and `[...]` in any component.

use std::collections::BTreeSet;
use std::io;
use std::path::{Component, Path, PathBuf};

use glob::{MatchOptions, Pattern};

/// Most files that one pattern may match: far beyond any specimen, and a bound on memory.
pub(crate) const MATCHES_MAX: usize = 100_000;

/// As in a shell: hidden files must be asked for.
const LIKE_A_SHELL: MatchOptions =
    MatchOptions { case_sensitive: true, require_literal_separator: true, require_literal_leading_dot: true };

/// The existing files that a path or pattern names, sorted; empty where there is none.
pub(crate) fn expand(base: &Path, pattern: &str) -> io::Result<Vec<PathBuf>> {
    let literal = base.join(pattern);
    if literal.is_file() {
        return Ok(vec![literal]);
    }
    if !has_wildcard(pattern) {
        return Ok(Vec::new());
    }
    let mut found = BTreeSet::from([base.to_owned()]);
    for component in Path::new(pattern).components() {
        let name = component.as_os_str();
        let wild = match component {
            Component::Normal(name) => Some(name.to_string_lossy()).filter(|name| has_wildcard(name)),
            // A root replaces what stands before it; `..` and `.` are kept as written.
            _ => None,
        };
        let wild = wild.map(|name| compiled(&name));
        let mut next = BTreeSet::new();
        for folder in &found {
            match &wild {
                Some(pattern) => add_matches(folder, pattern, &mut next)?,
                None => {
                    next.insert(folder.join(name));
                }
            }
            if next.len() > MATCHES_MAX {
                let message = format!("it matches more than {MATCHES_MAX} files");
                return Err(io::Error::other(message));
            }
        }
        found = next;
    }
    Ok(found.into_iter().filter(|path| path.is_file()).collect())
}

/// Whether a text holds a wildcard.
pub(crate) fn has_wildcard(text: &str) -> bool {
    text.contains(['*', '?', '['])
}

/// Adds the entries of a folder that match; a folder that does not exist has none.
fn add_matches(folder: &Path, pattern: &Pattern, found: &mut BTreeSet<PathBuf>) -> io::Result<()> {
    let here = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let entries = match std::fs::read_dir(here) {
        Ok(entries) => entries,
        Err(error) if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => {
            return Ok(());
        }
        Err(error) => return Err(error),
    };
    for entry in entries {
        let name = entry?.file_name();
        if pattern.matches_with(&name.to_string_lossy(), LIKE_A_SHELL) {
            found.insert(folder.join(&name));
        }
        if found.len() > MATCHES_MAX {
            break;
        }
    }
    Ok(())
}

/// What is wrong with a path that should name a file and does not, for a message about its key; a folder is there, but no file.
pub(crate) fn no_file(place: &Path) -> String {
    let what = if place.is_dir() { "a folder where a file is expected" } else { "a file that does not exist" };
    format!("names {what}: {}", place.display())
}

/// A pattern for one component of a path. A bracket that is not closed is a character like any other, and `**` is `*`.
fn compiled(pattern: &str) -> Pattern {
    let mut text = pattern.to_owned();
    while text.contains("**") {
        text = text.replace("**", "*");
    }
    loop {
        match Pattern::new(&text) {
            Ok(pattern) => return pattern,
            // With single stars only a bracket can be wrong.
            Err(error) => {
                let at = text.char_indices().nth(error.pos).map_or(text.len(), |(at, _)| at);
                text.replace_range(at..at + 1, "[[]");
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_match_as_in_a_shell() {
        for (pattern, name, expected) in [
            ("*.tif", "a.tif", true),
            ("*.tif", "a.tiff", false),
            ("a*b*c", "aXbXbXc", true),
            ("a*b*c", "aXbXbX", false),
            ("snake_?.tif", "snake_1.tif", true),
            ("snake_?.tif", "snake_12.tif", false),
            ("[a-c]?", "b9", true),
            ("[!a-c]?", "b9", false),
            ("[]x]", "]", true),
            ("[ab", "[ab", true),
            ("[!ab", "[!ab", true),
            ("a[b[c]*", "a[bc", true),
            ("a[b[c]*", "ax", false),
            ("é[", "é[", true),
            ("A*", "a", false),
            ("**.tif", "a.tif", true),
            ("*", ".hidden", false),
            ("[.]*", ".hidden", false),
            (".*", ".hidden", true),
            ("~*", "~a", true),
            ("*", "", true),
            ("é*", "échelle", true),
            ("", "", true),
            ("", "a", false),
        ] {
            let found = compiled(pattern).matches_with(name, LIKE_A_SHELL);
            assert_eq!(found, expected, "{pattern} {name}");
        }
    }

    #[test]
    fn many_stars_do_not_explode() {
        let pattern = "*a".repeat(30) + "b";
        assert!(!compiled(&pattern).matches_with(&"a".repeat(300), LIKE_A_SHELL));
    }

    #[test]
    fn folders_are_walked_in_order() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["s2/b.tif", "s1/a.tif", "s1/.hidden.tif", "s1/b.png", "[x].tif"] {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, "").unwrap();
        }
        let names = |pattern: &str| -> Vec<String> {
            expand(folder.path(), pattern)
                .unwrap()
                .iter()
                .map(|path| path.strip_prefix(folder.path()).unwrap().to_string_lossy().into_owned())
                .collect()
        };
        assert_eq!(names("s?/*.tif"), ["s1/a.tif", "s2/b.tif"]);
        assert_eq!(names("s1/.*"), ["s1/.hidden.tif"]);
        assert_eq!(names("[x].tif"), ["[x].tif"], "a literal name wins over its meaning as a pattern");
        assert!(names("s*").is_empty(), "folders are not files");
        assert!(names("nowhere/*.tif").is_empty());
        assert!(names("s1/a.tif/*").is_empty());
    }
}
