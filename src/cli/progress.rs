//! Progress on stderr: a bar on a terminal, plain lines elsewhere, nothing when asked to be quiet.

use std::fs::File;
use std::io::{IsTerminal, Write};
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use indicatif::{ProgressBar, ProgressStyle};

use super::terminal;
use diffraction_brdf::error::{Error, Result};
use diffraction_build::ground::progress::{Progress, Silent};

/// Where there is no terminal, a stage says how far it is this often.
const LINE_INTERVAL: Duration = Duration::from_secs(20);

/// A stage that took less than this leaves no line: what a reader looks for is where the time went.
const LINE_WORTH: Duration = Duration::from_millis(500);

/// The listener that suits where stderr goes.
pub(crate) fn reporter(quiet: bool) -> Box<dyn Progress> {
    if quiet {
        Box::new(Silent)
    } else if std::io::stderr().is_terminal() {
        Box::new(Bar::new())
    } else {
        Box::new(Lines::new(std::io::stderr()))
    }
}

/// A listener whose messages are appended to a file besides, each with the time.
pub(crate) struct Logged {
    shown: Box<dyn Progress>,
    file: Option<Mutex<File>>,
}

impl Logged {
    /// Opens the file, where there is to be one.
    ///
    /// # Errors
    /// A file that cannot be written to.
    pub fn new(shown: Box<dyn Progress>, file: Option<&Path>) -> Result<Self> {
        let open = |path: &Path| {
            let file = File::options().create(true).append(true).open(path);
            file.map(Mutex::new).map_err(|e| Error::disk(path, "open the log", e))
        };
        Ok(Self { shown, file: file.map(open).transpose()? })
    }

    /// Appends lines that are shown elsewhere.
    pub fn note(&self, text: &str) {
        let Some(file) = &self.file else { return };
        let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
        let now = humantime::format_rfc3339_seconds(SystemTime::now().max(UNIX_EPOCH));
        let lines: String = text.lines().map(|line| format!("{now} {line}\n")).collect();
        // A log that cannot be written must not stop the work.
        let _ = file.write_all(lines.as_bytes());
    }
}

impl Progress for Logged {
    fn stage(&self, name: &str, total: u64) {
        self.shown.stage(name, total);
    }

    fn advance(&self, n: u64) {
        self.shown.advance(n);
    }

    fn message(&self, text: &str) {
        self.note(text);
        self.shown.message(text);
    }

    fn finish(&self) {
        self.shown.finish();
    }
}

/// A bar that is redrawn in place; long stages leave a line.
#[derive(Debug)]
struct Bar {
    bar: ProgressBar,
    current: Mutex<Option<Stage>>,
}

/// The stage under way.
#[derive(Debug, Clone)]
struct Stage {
    name: String,
    total: u64,
    done: u64,
    started: Instant,
    last_line: Instant,
}

impl Stage {
    fn new(name: &str, total: u64) -> Self {
        let now = Instant::now();
        Self { name: name.to_owned(), total, done: 0, started: now, last_line: now }
    }

    /// The line it leaves, where it took long enough to deserve one.
    fn summary(&self, worth: Duration) -> Option<String> {
        let took = self.started.elapsed();
        (took >= worth).then(|| format!("{} ({:.1} s)", self.name, took.as_secs_f64()))
    }
}

/// What a thread that panicked left behind is still good enough for display.
fn lock(stage: &Mutex<Option<Stage>>) -> MutexGuard<'_, Option<Stage>> {
    stage.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Bar {
    fn new() -> Self {
        Self { bar: ProgressBar::hidden(), current: Mutex::new(None) }
    }

    fn style(total: u64) -> ProgressStyle {
        let template = if total == 0 { "{spinner} {msg} {elapsed}" } else { "{msg:32!} [{bar:30}] {pos}/{len} {eta}" };
        // The templates are constants; should one be wrong, the library's own style is as good.
        ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()).progress_chars("=> ")
    }
}

impl Progress for Bar {
    fn stage(&self, name: &str, total: u64) {
        self.finish();
        *lock(&self.current) = Some(Stage::new(name, total));
        self.bar.set_draw_target(indicatif::ProgressDrawTarget::stderr());
        self.bar.reset();
        self.bar.set_style(Self::style(total));
        self.bar.set_length(total);
        self.bar.set_message(terminal::clean(name).into_owned());
        self.bar.enable_steady_tick(Duration::from_millis(200));
    }

    fn advance(&self, n: u64) {
        self.bar.inc(n);
    }

    fn message(&self, text: &str) {
        self.bar.suspend(|| terminal::say(&format!("{text}\n")));
    }

    fn finish(&self) {
        if let Some(stage) = lock(&self.current).take() {
            self.bar.disable_steady_tick();
            self.bar.finish_and_clear();
            if let Some(line) = stage.summary(LINE_WORTH) {
                terminal::say(&format!("{line}\n"));
            }
        }
    }
}

/// Plain lines: one for each stage that took long, and now and then its share before.
#[derive(Debug)]
struct Lines<W> {
    out: Mutex<W>,
    current: Mutex<Option<Stage>>,
    interval: Duration,
    worth: Duration,
}

impl<W: Write> Lines<W> {
    fn new(out: W) -> Self {
        Self { out: Mutex::new(out), current: Mutex::new(None), interval: LINE_INTERVAL, worth: LINE_WORTH }
    }

    fn line(&self, text: &str) {
        let mut out = self.out.lock().unwrap_or_else(PoisonError::into_inner);
        // Progress that cannot be shown must not stop the work.
        let _ = writeln!(out, "{}", terminal::clean(text));
    }
}

impl<W: Write + Send> Progress for Lines<W> {
    fn stage(&self, name: &str, total: u64) {
        self.finish();
        *lock(&self.current) = Some(Stage::new(name, total));
    }

    fn advance(&self, n: u64) {
        let mut current = lock(&self.current);
        let Some(stage) = current.as_mut() else {
            return;
        };
        stage.done = stage.done.saturating_add(n);
        if stage.total == 0 || stage.done >= stage.total || stage.last_line.elapsed() < self.interval {
            return;
        }
        stage.last_line = Instant::now();
        let percent = 100.0 * stage.done as f64 / stage.total as f64;
        let text = format!("{}: {percent:.0} %", stage.name);
        drop(current);
        self.line(&text);
    }

    fn message(&self, text: &str) {
        self.line(text);
    }

    fn finish(&self) {
        let finished = lock(&self.current).take();
        if let Some(line) = finished.and_then(|stage| stage.summary(self.worth)) {
            self.line(&line);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(interval: Duration, worth: Duration, work: impl Fn(&dyn Progress)) -> String {
        let lines = Lines { interval, worth, ..Lines::new(Vec::new()) };
        work(&lines);
        String::from_utf8(lines.out.into_inner().unwrap()).unwrap()
    }

    fn two_stages(progress: &dyn Progress) {
        progress.stage("read", 3);
        progress.advance(3);
        progress.message("odd unit");
        progress.stage("build", 0);
        progress.advance(1);
        progress.finish();
        progress.finish();
    }

    #[test]
    fn long_stages_leave_one_line_and_short_ones_none() {
        let text = lines(LINE_INTERVAL, Duration::ZERO, two_stages);
        let starts = ["odd unit", "read (", "build ("];
        assert_eq!(text.lines().count(), starts.len(), "{text}");
        assert!(text.lines().zip(starts).all(|(line, start)| line.starts_with(start)), "{text}");
        assert_eq!(lines(LINE_INTERVAL, Duration::from_secs(3600), two_stages), "odd unit\n");
    }

    #[test]
    fn long_stages_say_how_far_they_are() {
        let text = lines(Duration::ZERO, LINE_WORTH, |progress| {
            progress.stage("build", 8);
            progress.advance(2);
            progress.advance(4);
            progress.advance(2);
        });
        assert_eq!(text, "build: 25 %\nbuild: 75 %\n");
    }

    #[test]
    fn the_bar_takes_any_order_of_calls() {
        let bar = Bar::new();
        bar.advance(1);
        bar.finish();
        assert!(lock(&bar.current).is_none());
        assert!(ProgressStyle::with_template("{msg:32!} [{bar:30}] {pos}/{len} {eta}").is_ok());
    }
}
