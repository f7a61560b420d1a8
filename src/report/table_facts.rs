//! What the report says about tables: how many, of what, from what.

use crate::report::numbers;
use crate::stages::results::{BuildResult, SpectralResult};
use diffraction_build::tables::model::{Basis, Rounding, Storage};

/// "6 Chebyshev, half".
pub(crate) fn tables_short(built: &BuildResult) -> String {
    format!(
        "{} {}, {}",
        built.tables,
        basis(built.basis),
        match built.storage {
            Storage::Half => "half",
            Storage::Float => "float",
        }
    )
}

/// "501 × 501".
pub(crate) fn grid_short(built: &BuildResult) -> String {
    format!("{0} × {0}", built.size)
}

pub(crate) fn tables(built: &BuildResult) -> String {
    format!(
        "{}, {} texels, {} stored, for a tolerance of {}",
        tables_short(built),
        grid_short(built),
        numbers::bytes(built.stored_bytes),
        numbers::round_percent(built.tolerance),
    )
}

/// Tables of single wavelengths.
pub(crate) fn spectral_tables(found: &SpectralResult) -> String {
    let [shortest, longest] = found.range_nm.map(|nm| numbers::round_number(nm, 4));
    let format = match found.storage {
        Storage::Half => "16-bit",
        Storage::Float => "32-bit",
    };
    format!(
        "{} of {size} × {size}, {format} floats, {}: any wavelength from {shortest} nm, any light up to {longest} nm",
        found.tables,
        numbers::bytes(found.stored_bytes),
        size = found.size,
    )
}

/// The number format and what it does.
pub(crate) fn format_of(storage: Storage, rounding: Rounding) -> String {
    let number = |share| numbers::number(share, 2);
    let Rounding { half, float, allowed } = rounding;
    let allowed = number(allowed);
    match storage {
        Storage::Half => {
            format!("16-bit floats: 95 % of colours shift by less than {} ({allowed} is allowed)", number(half))
        }
        Storage::Float => format!(
            "32-bit floats: 95 % of colours shift by less than {} ({allowed} is allowed, 16-bit ones come to {})",
            number(float),
            number(half)
        ),
    }
}

pub(crate) fn texels(built: &BuildResult) -> String {
    if built.prefilter_width > 0.0 {
        format!("averages over {} in u and v", numbers::round_number(built.prefilter_width, 3))
    } else {
        "point samples".into()
    }
}

/// Texels from the rim of (u, v) within which look-ups err by more than a thousandth or so: docs/accuracy.md.
const RIM_TEXELS: f64 = 2.0;

/// From which polar angle on two directions on one side lie at the rim.
pub(crate) fn rim(built: &BuildResult) -> String {
    let texel = 4.0 / (built.size.max(3) - 1) as f64;
    let theta_deg = (1.0 - 0.5 * RIM_TEXELS * texel).clamp(0.0, 1.0).asin().to_degrees();
    format!(
        "look-ups err by a thousandth and more where light and viewer are both beyond {}° on one side",
        numbers::round_number(theta_deg, 3)
    )
}

pub(crate) fn made_from(built: &BuildResult) -> String {
    let record = &built.record;
    let [shortest, longest] = record.wavelength_step_nm;
    let steps = if longest > 0.0 {
        format!(" in steps of {} to {}", numbers::number(shortest, 2), numbers::with_unit(longest, 2, "nm"))
    } else {
        String::new()
    };
    format!(
        "{} transforms × {} window{}, up to {} wavelengths{steps}, {} samples, in {}",
        record.transforms,
        numbers::count(record.windows as u64),
        if record.windows == 1 { "" } else { "s" },
        record.wavelengths_max,
        numbers::count(record.samples),
        taken(built),
    )
}

/// "0.41 s (predicted 0.35 s; 0.70 s of processor time), with 64 MB of memory (predicted 59 MB)".
fn taken(built: &BuildResult) -> String {
    let in_brackets = |parts: Vec<String>| match parts.is_empty() {
        true => String::new(),
        false => format!(" ({})", parts.join("; ")),
    };
    let seconds = built.predicted.iter().map(|cost| format!("predicted {}", numbers::seconds(cost.seconds)));
    let processor = built.build_cpu_s.iter().map(|s| format!("{} of processor time", numbers::seconds(*s)));
    let mut taken = numbers::seconds(built.build_s) + &in_brackets(seconds.chain(processor).collect());
    if let Some(bytes) = built.memory_bytes {
        let memory =
            built.predicted.iter().map(|cost| format!("predicted {}", numbers::bytes(cost.memory_bytes as u64)));
        taken += &format!(", with {} of memory{}", numbers::bytes(bytes), in_brackets(memory.collect()));
    }
    taken
}

fn basis(basis: Basis) -> &'static str {
    match basis {
        Basis::Chebyshev => "Chebyshev",
        Basis::Taylor => "Taylor",
    }
}
