//! `eval`: BRDF values for a list of directions, from an atlas or straight from the scan.

mod args;
mod scan;
mod tables;
mod values;
mod written;

pub(crate) use args::EvalArgs;

use crate::cli::destination;
use crate::cli::directions;
use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::cli::terminal;
use crate::error::Result;
use args::EvalSource;
use diffraction_brdf::direction::Vec3;
use diffraction_brdf::error::Error;
use diffraction_brdf::files;
use diffraction_brdf::json;
use scan::from_scan;
use tables::from_tables;
use values::{Evaluated, with_colour};
use written::{to_npy, whole};

/// Evaluates and writes the table.
///
/// # Errors
/// Wrong directions, an unreadable atlas or manifest, or the reference's.
pub(crate) fn run(args: &EvalArgs, global: &Global) -> Result<Outcome> {
    let source = args.source()?;
    if let Some(out) = &args.out {
        destination::check_file(out, &args.inputs(), args.force)?;
    }
    let directions = directions::read(&args.directions)?;
    if !directions.ignored.is_empty() && !global.quiet {
        let ignored = directions.ignored.join(", ");
        terminal::say(&format!("note: {}: not used: {ignored}\n", args.directions.display()));
    }
    let pairs: Vec<(Vec3, Vec3)> = directions.rows.iter().map(directions::Row::pair).collect();
    let Evaluated { table, white } = match source {
        EvalSource::Tables(atlas) => from_tables(atlas, args, &pairs)?,
        EvalSource::Reference(path) => from_scan(path, args, global, &pairs)?,
    };
    let table = match white.filter(|_| args.colour) {
        Some(white) => with_colour(table, white),
        None => table,
    };
    let whole = whole(&directions, table, if args.long { &args.wavelengths_nm } else { &[] });
    let bytes = if args.npy {
        to_npy(&whole)
    } else if args.json {
        let text = json::pretty(&whole.to_json());
        text.map_err(|error| Error::Call(format!("these values have no form in JSON: {error}")))?.into_bytes()
    } else {
        whole.to_csv().into_bytes()
    };
    match &args.out {
        Some(path) => {
            destination::create_parent(path)?;
            files::replace(path, &bytes)?;
        }
        // Text: NumPy's form needs a file.
        None => output::print(&String::from_utf8_lossy(&bytes))?,
    }
    Ok(Outcome::Done)
}
