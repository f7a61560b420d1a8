//! The command-line program; everything it does is in the library.

use std::process::ExitCode;

/// The system's allocator, which counts: each allocation of every thread waits for one counter, so only on request.
#[cfg(feature = "count-memory")]
#[global_allocator]
static HEAP: peak_alloc::PeakAlloc = peak_alloc::PeakAlloc;

fn main() -> ExitCode {
    diffraction_atlas::cli::surroundings::ensure_surroundings();
    #[cfg(feature = "count-memory")]
    diffraction_atlas::stages::usage::lend_heap_counter(diffraction_atlas::stages::usage::HeapCounter {
        live_bytes: || HEAP.current_usage(),
        peak_bytes: || HEAP.peak_usage(),
        restart: || HEAP.reset_peak_usage(),
    });
    diffraction_atlas::cli::main(std::env::args_os())
}
