//! Positions in a manifest's text, turned into messages with file, line, column, and a caret.
//!
//! Kept by hand: `annotate-snippets` and `miette` print whole reports of their own shape and would replace the 30 lines of
//! the excerpt alone. Line and column as parts of the error, carets that stand right at any width of a tab, lines cut
//! around the caret, and what must not reach a terminal would remain.

use std::ops::Range;

use crate::error::Error;

/// A manifest's text and the name it goes by in messages.
#[derive(Debug, Clone, Copy)]
pub struct Source<'t> {
    /// The whole text; spans are byte ranges in it.
    pub text: &'t str,
    /// The path as the user gave it.
    pub file: &'t str,
}

/// Most characters of a source line that an excerpt shows.
const EXCERPT_CHARACTERS: usize = 100;

impl Source<'_> {
    /// An error at a byte range of the text.
    pub fn error(&self, span: Range<usize>, message: impl Into<String>) -> Error {
        let start = floor_boundary(self.text, span.start);
        let end = floor_boundary(self.text, span.end).max(start);
        let line_start = self.text[..start].rfind('\n').map_or(0, |at| at + 1);
        let line_end = self.text[start..].find('\n').map_or(self.text.len(), |at| start + at);
        let line = self.text[..start].matches('\n').count() + 1;
        // A byte-order mark is invisible: editors do not count it as a column.
        let before = self.text[line_start..start].trim_start_matches('\u{feff}');
        let inside = &self.text[start..end.min(line_end)];
        let after = &self.text[end.min(line_end)..line_end];
        Error::Manifest {
            file: self.file.to_owned(),
            line,
            column: before.chars().count() + 1,
            message: printable(&message.into()),
            excerpt: excerpt(line, before, inside, after.trim_end_matches('\r')),
        }
    }
}

/// The largest character boundary not above `at`.
fn floor_boundary(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// The line with carets under `inside`; long lines are cut around them.
fn excerpt(line: usize, before: &str, inside: &str, after: &str) -> String {
    let shown_before = last_characters(before, EXCERPT_CHARACTERS / 2);
    let shown_inside = first_characters(inside, EXCERPT_CHARACTERS / 2);
    let room = EXCERPT_CHARACTERS - shown_before.chars().count() - shown_inside.chars().count();
    let shown_after = if shown_inside.len() < inside.len() { "" } else { first_characters(after, room) };
    let lead = if shown_before.len() < before.len() { "…" } else { "" };
    let shown = printable(&format!("{lead}{shown_before}{shown_inside}{shown_after}"));
    // Tabs are kept below the line, so that the caret stands under its text at any tab width.
    let pad: String = format!("{lead}{shown_before}").chars().map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
    let carets = "^".repeat(shown_inside.trim_end().chars().count().max(1));
    let number = line.to_string();
    let gutter = " ".repeat(number.len());
    format!(" {number} | {shown}\n {gutter} | {pad}{carets}")
}

fn last_characters(text: &str, count: usize) -> &str {
    let skip = text.chars().count().saturating_sub(count);
    let at = text.char_indices().nth(skip).map_or(text.len(), |(at, _)| at);
    &text[at..]
}

fn first_characters(text: &str, count: usize) -> &str {
    let at = text.char_indices().nth(count).map_or(text.len(), |(at, _)| at);
    &text[..at]
}

/// Control characters and those without width replaced, so that no text steers the terminal or moves a caret.
fn printable(text: &str) -> String {
    let kept = |c: char| matches!(c, '\t' | '\n') || !(c.is_control() || is_format(c));
    text.chars().map(|c| if kept(c) { c } else { '\u{fffd}' }).collect()
}

/// Joiners, marks of direction, separators of lines, tags: characters of format, which no key or path needs.
fn is_format(c: char) -> bool {
    matches!(u32::from(c), 0xad | 0x61c | 0x200b..=0x200f | 0x2028..=0x202e | 0x2060..=0x206f | 0xfeff | 0xfff9..=0xfffb
        | 0xe0000..=0xe007f)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(text: &str, span: Range<usize>) -> (usize, usize, String) {
        let source = Source { text, file: "m.toml" };
        match source.error(span, "wrong") {
            Error::Manifest { line, column, excerpt, .. } => (line, column, excerpt),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn columns_count_characters_from_one() {
        let text = "a = 1\nµµ = 22 # tail\r\n";
        let at = text.find("22").unwrap();
        assert_eq!(parts(text, at..at + 2), (2, 6, " 2 | µµ = 22 # tail\n   |      ^^".to_owned()));
    }

    #[test]
    fn spans_over_several_lines_mark_the_first() {
        let (line, column, excerpt) = parts("[\n1,\n2]", 0..7);
        assert_eq!((line, column), (1, 1));
        assert_eq!(excerpt, " 1 | [\n   | ^");
    }

    #[test]
    fn every_span_of_awkward_text_gives_a_message() {
        let text = "\u{feff}é\t\u{1b}[31m\r\n\n€";
        for start in 0..=text.len() + 2 {
            for end in start..=text.len() + 2 {
                let (_, _, excerpt) = parts(text, start..end);
                assert!(excerpt.contains('^') && !excerpt.contains('\u{1b}'));
            }
        }
    }

    #[test]
    fn nothing_steers_the_terminal_or_moves_the_caret() {
        let text = "a\u{202e}b\u{200b}\u{7}\u{9b}X = 1";
        let at = text.find('X').unwrap();
        let error = Source { text, file: "m.toml" }.error(at..at + 1, "found \"\u{1b}[2J\u{202e}\"");
        let Error::Manifest { message, excerpt, .. } = error else { panic!("{error:?}") };
        assert_eq!(message, "found \"\u{fffd}[2J\u{fffd}\"");
        assert_eq!(excerpt, " 1 | a\u{fffd}b\u{fffd}\u{fffd}\u{fffd}X = 1\n   |       ^");
    }

    #[test]
    fn long_lines_are_cut_around_the_caret() {
        let text = format!("{}X{}", "a".repeat(5000), "b".repeat(5000));
        let (line, column, excerpt) = parts(&text, 5000..5001);
        assert_eq!((line, column), (1, 5001));
        assert!(excerpt.lines().all(|line| line.chars().count() < 120));
        let [shown, carets] = excerpt.lines().collect::<Vec<_>>()[..] else { panic!("two lines expected") };
        let caret = carets.chars().position(|c| c == '^').unwrap();
        assert_eq!(shown.chars().nth(caret), Some('X'));
    }
}
