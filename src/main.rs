//! The command-line program; everything it does is in the library.

use std::process::ExitCode;

use diffraction_atlas::stages::usage::{HeapCounter, lend_heap_counter};
use peak_alloc::PeakAlloc;

/// The system's allocator, which counts.
#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

fn main() -> ExitCode {
    lend_heap_counter(HeapCounter {
        live_bytes: || HEAP.current_usage(),
        peak_bytes: || HEAP.peak_usage(),
        restart: || HEAP.reset_peak_usage(),
    });
    diffraction_atlas::cli::main(std::env::args_os())
}
