//! Paths in a manifest: relative to its folder, with `*`, `?`, and `[...]` in any component.

use std::collections::BTreeSet;
use std::io;
use std::path::{Component, Path, PathBuf};

/// Most files that one pattern may match: far beyond any specimen, and a bound on memory.
pub const MATCHES_MAX: usize = 100_000;

/// The existing files that a path or pattern names, sorted; empty where there is none.
pub fn expand(base: &Path, pattern: &str) -> io::Result<Vec<PathBuf>> {
    let literal = base.join(pattern);
    if literal.is_file() {
        return Ok(vec![literal]);
    }
    if !has_wildcard(pattern) {
        return Ok(Vec::new());
    }
    let mut found = BTreeSet::from([base.to_owned()]);
    for component in Path::new(pattern).components() {
        let mut next = BTreeSet::new();
        for folder in &found {
            match component {
                Component::Normal(name) => {
                    let name = name.to_string_lossy();
                    if has_wildcard(&name) {
                        add_matches(folder, &name, &mut next)?;
                    } else {
                        next.insert(folder.join(name.as_ref()));
                    }
                }
                // A root replaces what stands before it; `..` and `.` are kept as written.
                other => {
                    next.insert(folder.join(other.as_os_str()));
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
pub fn has_wildcard(text: &str) -> bool {
    text.contains(['*', '?', '['])
}

/// Adds the entries of a folder that match; a folder that does not exist has none.
fn add_matches(folder: &Path, pattern: &str, found: &mut BTreeSet<PathBuf>) -> io::Result<()> {
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
        let text = name.to_string_lossy();
        // As in a shell: hidden files must be asked for.
        if text.starts_with('.') && !pattern.starts_with('.') {
            continue;
        }
        if matches(pattern, &text) {
            found.insert(folder.join(&name));
        }
        if found.len() > MATCHES_MAX {
            break;
        }
    }
    Ok(())
}

/// One unit of a pattern.
#[derive(Debug, Clone, PartialEq)]
enum Token {
    Any,
    One,
    Exactly(char),
    Set { negated: bool, ranges: Vec<(char, char)> },
}

/// Whether a name matches a pattern of `*`, `?`, `[abc]`, `[a-z]`, `[!abc]`.
fn matches(pattern: &str, name: &str) -> bool {
    let tokens = tokens(pattern);
    let name: Vec<char> = name.chars().collect();
    let (mut token, mut at) = (0, 0);
    // Where to go on after the last `*` if a later token fails: one more character to the `*`.
    let mut retry: Option<(usize, usize)> = None;
    while at < name.len() {
        match tokens.get(token) {
            Some(Token::Any) => {
                retry = Some((token + 1, at + 1));
                token += 1;
            }
            Some(one) if takes(one, name[at]) => {
                token += 1;
                at += 1;
            }
            _ => {
                let Some((after_star, from)) = retry else {
                    return false;
                };
                (token, at) = (after_star, from);
                retry = Some((after_star, from + 1));
            }
        }
    }
    tokens[token..].iter().all(|token| *token == Token::Any)
}

fn takes(token: &Token, c: char) -> bool {
    match token {
        Token::Any => false,
        Token::One => true,
        Token::Exactly(expected) => *expected == c,
        Token::Set { negated, ranges } => ranges.iter().any(|(low, high)| (*low..=*high).contains(&c)) != *negated,
    }
}

fn tokens(pattern: &str) -> Vec<Token> {
    let chars: Vec<char> = pattern.chars().collect();
    let mut tokens = Vec::new();
    let mut at = 0;
    while at < chars.len() {
        match chars[at] {
            '*' => tokens.push(Token::Any),
            '?' => tokens.push(Token::One),
            '[' => {
                if let Some((set, end)) = set(&chars, at) {
                    tokens.push(set);
                    at = end;
                } else {
                    // Without its closing bracket it is a character like any other.
                    tokens.push(Token::Exactly('['));
                }
            }
            other => tokens.push(Token::Exactly(other)),
        }
        at += 1;
    }
    tokens
}

/// The set that opens at `start`, and the index of its closing bracket.
fn set(chars: &[char], start: usize) -> Option<(Token, usize)> {
    let negated = chars.get(start + 1) == Some(&'!');
    let first = start + 1 + usize::from(negated);
    // A closing bracket in first place belongs to the set.
    let end = (first + 1..chars.len()).find(|&at| chars[at] == ']')?;
    let mut ranges = Vec::new();
    let mut at = first;
    while at < end {
        if at + 2 < end && chars[at + 1] == '-' {
            ranges.push((chars[at], chars[at + 2]));
            at += 3;
        } else {
            ranges.push((chars[at], chars[at]));
            at += 1;
        }
    }
    Some((Token::Set { negated, ranges }, end))
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
            ("*", "", true),
            ("é*", "échelle", true),
            ("", "", true),
            ("", "a", false),
        ] {
            assert_eq!(matches(pattern, name), expected, "{pattern} {name}");
        }
    }

    #[test]
    fn many_stars_do_not_explode() {
        let pattern = "*a".repeat(30) + "b";
        assert!(!matches(&pattern, &"a".repeat(300)));
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
