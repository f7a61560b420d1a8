//! Paths in a manifest: relative to its folder, with `*`, `?`, and `[...]` in any component.

use std::collections::BTreeSet;
use std::io;
use std::path::{Component, Path, PathBuf};

use glob::{MatchOptions, Pattern};

use super::keys;

/// Most files that one pattern may match: far beyond any specimen, and a bound on memory.
pub(crate) const MATCHES_MAX: usize = 100_000;

/// Most names among which a like one is looked for.
const NAMES_MAX: usize = 10_000;

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
                // A folder whose own name holds brackets is meant as it is written.
                Some(_) if folder.join(name).is_dir() => {
                    next.insert(folder.join(name));
                }
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
    format!("names {what}: {}{}", place.display(), hint(place))
}

/// What is wrong with a pattern that matches nothing, and what may be meant.
pub(crate) fn no_match(base: &Path, pattern: &str) -> String {
    let place = base.join(pattern);
    let mut hint = hint(&place);
    let folder = place.parent().unwrap_or(Path::new(""));
    let name = place.file_name().unwrap_or_default().to_string_lossy();
    let in_any_case = MatchOptions { case_sensitive: false, ..LIKE_A_SHELL };
    let like = names_in(folder).into_iter().find(|known| compiled(&name).matches_with(known, in_any_case));
    if let Some(known) = like {
        hint = format!("; names keep their case, and `{known}` is there");
    } else if pattern.contains('[') {
        hint += "; brackets stand for one of the characters between them, `[[]` for a bracket";
    }
    format!("matches no file: {}{hint}", place.display())
}

/// What may be meant by a path that is not there: `~`, another folder, or a name like it.
fn hint(place: &Path) -> String {
    if place.components().any(|part| part.as_os_str() == "~") {
        return "; `~` is a shell's word for the home folder: write the whole path".into();
    }
    if place.exists() {
        return String::new();
    }
    let is_there = |folder: &&Path| folder.as_os_str().is_empty() || folder.is_dir();
    let folder = place.parent().unwrap_or(Path::new(""));
    if !is_there(&folder) && !has_wildcard(&folder.to_string_lossy()) {
        let above = folder.ancestors().find(is_there).unwrap_or(Path::new(""));
        let missing = folder.strip_prefix(above).ok().and_then(|rest| rest.components().next());
        return missing.map_or(String::new(), |part| format!("; there is no folder {}", above.join(part).display()));
    }
    let names = names_in(folder);
    let known: Vec<&str> = names.iter().map(String::as_str).collect();
    let name = place.file_name().unwrap_or_default().to_string_lossy();
    keys::nearest(&name, &known).map_or(String::new(), |near| format!("; did you mean `{near}`?"))
}

/// Names of the files and folders in a folder, sorted; some of them where there are very many.
fn names_in(folder: &Path) -> Vec<String> {
    let here = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let Ok(entries) = std::fs::read_dir(here) else { return Vec::new() };
    let named = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut names: Vec<String> = named.take(NAMES_MAX).collect();
    names.sort();
    names
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

    #[test]
    fn what_may_be_meant_is_said() {
        let folder = tempfile::tempdir().unwrap();
        let base = folder.path();
        std::fs::create_dir_all(base.join("[lab] scans")).unwrap();
        for name in ["snake_1.TIF", "beetle.tif", "[lab] scans/a.tif"] {
            std::fs::write(base.join(name), "").unwrap();
        }
        for (name, expected) in [
            ("beetel.tif", "did you mean `beetle.tif`?"),
            ("scan/beetle.tif", "there is no folder"),
            ("~/beetle.tif", "`~` is a shell's word"),
            ("[lab] scans", "a folder where a file is expected"),
        ] {
            let message = no_file(&base.join(name));
            assert!(message.contains(expected), "{message}");
        }
        for (pattern, expected) in [
            ("*.tif", ""),
            ("snake_*.tif", "`snake_1.TIF` is there"),
            ("~/*.tif", "`~`"),
            ("[ab]x.tif", "`[[]` for a bracket"),
            ("nowhere/*.tif", "there is no folder"),
        ] {
            let message = no_match(base, pattern);
            assert!(message.contains(expected), "{message}");
        }
        // A folder whose name holds brackets is found as it is written.
        assert_eq!(expand(base, "[lab] scans/*.tif").unwrap().len(), 1);
    }
}
