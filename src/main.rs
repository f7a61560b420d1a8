//! The command-line program; everything it does is in the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    diffraction_atlas::cli::main(std::env::args_os())
}
