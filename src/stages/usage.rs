//! What the process uses, where the system tells: memory on the heap over a stretch of work, processor time of a stage.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::results::StageTime;
use super::stage::Stage;

/// An allocator that counts what lives on the heap. Installing one takes a program; a library is lent it. The program
/// does so with the feature `count-memory`, the tests of forecasts always.
#[derive(Debug, Clone, Copy)]
pub struct HeapCounter {
    /// Bytes that live now.
    pub live_bytes: fn() -> usize,
    /// The most that lived since it was last restarted.
    pub peak_bytes: fn() -> usize,
    /// Makes what lives now the peak.
    pub restart: fn(),
}

static HEAP: OnceLock<HeapCounter> = OnceLock::new();

/// Lends the counter of the program's allocator, once.
pub fn lend_heap_counter(counter: HeapCounter) {
    // A second one would be of the same allocator.
    let _ = HEAP.set(counter);
}

/// Does some work, and gives the most bytes that lived on the heap meanwhile beyond those at its start; `None` where
/// nobody counts. Work of other threads counts too; one stretch at a time can be measured.
pub fn with_heap_bytes<T>(work: impl FnOnce() -> T) -> (T, Option<u64>) {
    let Some(heap) = HEAP.get() else { return (work(), None) };
    (heap.restart)();
    let before = (heap.live_bytes)();
    let done = work();
    (done, Some((heap.peak_bytes)().saturating_sub(before) as u64))
}

/// Whether somebody counts what lives on the heap.
pub(crate) fn is_heap_counted() -> bool {
    HEAP.get().is_some()
}

/// Whether several specimens are made at once, so that the process's time is no single one's.
static SHARED: AtomicBool = AtomicBool::new(false);

/// Says whether several specimens are made at once from now on: then no stage knows its processor time.
pub(crate) fn share_processor(shared: bool) {
    SHARED.store(shared, Ordering::Relaxed);
}

/// Share of the free memory that a run takes where nobody says otherwise.
const FREE_SHARE: f64 = 0.75;

/// Bytes of memory that a run may take: a share of what is free. Where the system does not tell, as much as there may be.
pub(crate) fn memory_to_take() -> u64 {
    match memory_free() {
        u64::MAX => u64::MAX,
        bytes => (bytes as f64 * FREE_SHARE) as u64,
    }
}

/// Bytes of memory that are free, of the machine or of the group of processes that it is held to. Where the system does not tell, as many
/// as there may be.
pub(crate) fn memory_free() -> u64 {
    let number = |path: &str| std::fs::read_to_string(path).ok()?.trim().parse::<u64>().ok();
    let field = |path: &str, name: &str| {
        let text = std::fs::read_to_string(path).ok()?;
        let line = text.lines().find_map(|line| line.strip_prefix(name))?;
        line.trim().trim_end_matches("kB").trim().parse::<u64>().ok()
    };
    // The second version of control groups; without a limit the file says "max". What is kept of files gives way.
    let group = number("/sys/fs/cgroup/memory.max").zip(number("/sys/fs/cgroup/memory.current"));
    let of_files = field("/sys/fs/cgroup/memory.stat", "inactive_file ").unwrap_or(0);
    let of_group = group.map(|(most, now)| most.saturating_sub(now.saturating_sub(of_files)));
    let of_machine = field("/proc/meminfo", "MemAvailable:").map(|kib| kib << 10);
    of_group.into_iter().chain(of_machine).min().unwrap_or(u64::MAX)
}

/// Seconds that all threads of the process have run, in the kernel and outside; `None` but on Linux.
fn processor_s() -> Option<f64> {
    // Linux counts in hundredths of a second whatever its own clock (USER_HZ, proc(5)).
    const TICKS_PER_S: f64 = 100.0;
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The second field, the program's name, may hold spaces; utime and stime are the 14th and 15th.
    let mut fields = stat.rsplit_once(')')?.1.split_whitespace().skip(11);
    let mut ticks = || fields.next()?.parse::<f64>().ok();
    Some((ticks()? + ticks()?) / TICKS_PER_S)
}

/// Measures how long a stage takes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stopwatch {
    started: Instant,
    processor_s: Option<f64>,
}

impl Stopwatch {
    /// From now on.
    pub fn start() -> Self {
        let is_alone = !SHARED.load(Ordering::Relaxed);
        Self { started: Instant::now(), processor_s: if is_alone { processor_s() } else { None } }
    }

    /// What the stage took until now.
    pub fn read(&self, stage: Stage, specimen: Option<&str>) -> StageTime {
        StageTime {
            name: stage,
            specimen: specimen.map(Into::into),
            wall_s: self.started.elapsed().as_secs_f64(),
            cpu_s: processor_s().zip(self.processor_s).map(|(now, then)| now - then),
        }
    }
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::{Stage, Stopwatch};

    #[test]
    fn work_takes_processor_time_and_sleep_does_not() {
        let idle = Stopwatch::start();
        std::thread::sleep(std::time::Duration::from_millis(30));
        let idle = idle.read(Stage::Plan, None);
        assert!(idle.wall_s >= 0.03 && idle.cpu_s.is_some());
        let busy = Stopwatch::start();
        let mut sum = 0u64;
        // Other tests may be counted too: processor time is the process's.
        while busy.read(Stage::BuildTables, Some("a")).cpu_s.unwrap() < 0.05 {
            sum = std::hint::black_box((0..100_000).fold(sum, |a, b| a.wrapping_mul(31) ^ b));
        }
    }
}
