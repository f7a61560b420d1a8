//! Output conventions: results on stdout, messages on stderr, exit status 0, 1, 2, or 75.

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use serde::Serialize;

use super::terminal;
use crate::error;
use diffraction_brdf::atlas::{self, INDEX_FILE, LATEST_FILE};
use diffraction_brdf::error::{Error, Result};

/// How a command that ran to its end has ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Everything was done.
    Done,
    /// What was compared is not the same; the result says how.
    Different,
    /// The rest was done; what was not is listed, a line each.
    Failures(Vec<String>),
}

/// Writes a result to stdout.
///
/// # Errors
/// [`Error::Disk`] where stdout cannot be written; a reader that closed the pipe has had enough, which
/// is no error.
pub(crate) fn print(text: &str) -> Result<()> {
    written(terminal::print(text))
}

fn written(outcome: io::Result<()>) -> Result<()> {
    match outcome {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Error::disk(Path::new("standard output"), "write", error))
        }
        _ => Ok(()),
    }
}

/// Writes a result to stdout as indented JSON.
///
/// # Errors
/// As [`print()`].
pub(crate) fn print_json(value: &impl Serialize) -> Result<()> {
    let mut text = serde_json::to_string_pretty(value)
        .map_err(|error| Error::Call(format!("this result has no form in JSON: {error}")))?;
    text.push('\n');
    written(terminal::print_json(&text))
}

/// Whether a folder is an atlas or a version of one, whole or damaged.
pub(crate) fn is_atlas(folder: &Path) -> bool {
    let is_version = |name: &std::ffi::OsStr| {
        name.to_str()
            .and_then(|name| name.strip_prefix('v'))
            .is_some_and(|number| number.len() >= 4 && number.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let holds_versions =
        || std::fs::read_dir(folder).is_ok_and(|entries| entries.flatten().any(|entry| is_version(&entry.file_name())));
    [INDEX_FILE, LATEST_FILE].iter().any(|name| folder.join(name).exists()) || holds_versions()
}

/// The version's folder that a path means. Where newer versions are damaged, says so on stderr: the answer is an older one.
///
/// # Errors
/// A path that is no atlas, or none whose files are all there.
pub(crate) fn version_folder(path: &Path) -> Result<PathBuf> {
    let found = atlas::resolve(path)?;
    for what in &found.passed_over {
        let folder = found.folder.display();
        terminal::say(&format!("warning: a newer version is damaged, {folder} is taken in its place: {what}\n"));
    }
    Ok(found.folder)
}

/// Reports errors and failures on stderr and gives the exit status.
pub(crate) fn conclude(outcome: error::Result<Outcome>) -> ExitCode {
    let (text, status) = conclusion(outcome);
    terminal::say(&text);
    ExitCode::from(status)
}

fn conclusion(outcome: error::Result<Outcome>) -> (String, u8) {
    match outcome {
        Ok(Outcome::Done) => (String::new(), 0),
        Ok(Outcome::Different) => (String::new(), 1),
        Ok(Outcome::Failures(failures)) => {
            let lines: String = failures.iter().map(|failure| format!("failed: {failure}\n")).collect();
            (format!("{lines}{} failed; the rest is done\n", failures.len()), 1)
        }
        Err(error) => (format!("error: {error}\n"), error.exit_status()),
    }
}

/// A number of bytes for people: `512 B`, `3.4 MiB`.
pub(crate) fn bytes_in_words(bytes: u64) -> String {
    const UNITS: [&str; 5] = ["B", "KiB", "MiB", "GiB", "TiB"];
    let mut value = bytes as f64;
    let mut unit = 0;
    while value >= 1024.0 && unit + 1 < UNITS.len() {
        value /= 1024.0;
        unit += 1;
    }
    if unit == 0 { format!("{bytes} B") } else { format!("{value:.1} {}", UNITS[unit]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exit_status_says_whose_fault_it_is() {
        assert_eq!(conclusion(Ok(Outcome::Done)), (String::new(), 0));
        let failures = vec!["snake_b: no pitch".to_owned()];
        let (text, status) = conclusion(Ok(Outcome::Failures(failures)));
        assert_eq!((text.as_str(), status), ("failed: snake_b: no pitch\n1 failed; the rest is done\n", 1));
        assert_eq!(conclusion(Err(Error::Call("no".into()).into())), ("error: no\n".into(), 2));
        assert_eq!(conclusion(Err(error::Error::Gpu("lost".into()))).1, 1);
    }

    #[test]
    fn bytes_keep_their_magnitude() {
        assert_eq!(bytes_in_words(1023), "1023 B");
        assert_eq!(bytes_in_words(1536), "1.5 KiB");
        assert_eq!(bytes_in_words(3 << 40), "3.0 TiB");
        assert_eq!(bytes_in_words(u64::MAX), "16777216.0 TiB");
    }
}
