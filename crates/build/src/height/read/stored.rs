//! A scan as its file holds it: samples, what they are numbers of, and where that is said.

use half::f16;

/// Type of a stored sample. All its values are exact in `f64`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SampleKind {
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    F16,
    F32,
    F64,
}

impl SampleKind {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::U8 => "u8",
            Self::I8 => "i8",
            Self::U16 => "u16",
            Self::I16 => "i16",
            Self::U32 => "u32",
            Self::I32 => "i32",
            Self::F16 => "f16",
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    pub(super) fn bytes(self) -> usize {
        match self {
            Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 | Self::F16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Whether a bare unit is enough to make samples of this type heights. Samples of 8 and 16 bits are
    /// as a rule stretched to their range, which a unit does not undo.
    pub(super) fn unit_is_enough(self) -> bool {
        self.range().is_none() || self.bytes() >= 4
    }

    /// Smallest and largest value of an integer type.
    pub(super) fn range(self) -> Option<[f64; 2]> {
        Some(match self {
            Self::U8 => [0.0, f64::from(u8::MAX)],
            Self::I8 => [f64::from(i8::MIN), f64::from(i8::MAX)],
            Self::U16 => [0.0, f64::from(u16::MAX)],
            Self::I16 => [f64::from(i16::MIN), f64::from(i16::MAX)],
            Self::U32 => [0.0, f64::from(u32::MAX)],
            Self::I32 => [f64::from(i32::MIN), f64::from(i32::MAX)],
            Self::F16 | Self::F32 | Self::F64 => return None,
        })
    }

    /// A number as this type would store it, to compare with stored samples.
    pub(super) fn rounded(self, value: f64) -> f64 {
        match self {
            Self::F16 => f16::from_f64(value).to_f64(),
            Self::F32 => f64::from(value as f32),
            _ => value,
        }
    }
}

/// Samples as stored, row 0 at the +y edge, `values.len() == size[0] * size[1]`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stored {
    pub(super) size: [usize; 2],
    pub(super) kind: SampleKind,
    pub(super) values: Vec<f64>,
}

impl Stored {
    pub(super) fn of(size: [u32; 2], kind: SampleKind, values: Vec<f64>) -> Self {
        Self { size: size.map(|side| side as usize), kind, values }
    }

    /// Puts the last row first.
    pub(super) fn flip_rows(&mut self) {
        let [nx, ny] = self.size;
        for row in 0..ny / 2 {
            let (upper, lower) = self.values.split_at_mut((ny - 1 - row) * nx);
            upper[row * nx..(row + 1) * nx].swap_with_slice(&mut lower[..nx]);
        }
    }

    /// Puts the last column first.
    pub(super) fn flip_columns(&mut self) {
        for row in self.values.chunks_exact_mut(self.size[0].max(1)) {
            row.reverse();
        }
    }
}

/// A statement of the file with its place, or the reason why there is none.
pub(super) type Found<T> = std::result::Result<Sourced<T>, String>;

/// A value and where in the file it stands, such as "ImageJ description".
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sourced<T> {
    pub(super) value: T,
    pub(super) from: String,
}

impl<T> Sourced<T> {
    pub(super) fn new(value: T, from: impl Into<String>) -> Self {
        Self { value, from: from.into() }
    }
}

/// `number = scale * sample + offset`: the straight line a file may put before its unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    pub(super) scale: f64,
    pub(super) offset: f64,
}

impl Line {
    pub(super) const IDENTITY: Self = Self { scale: 1.0, offset: 0.0 };
}

/// What every format reader hands over for calibration.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RawScan {
    pub(super) format: &'static str,
    pub(super) page: usize,
    pub(super) channel: Option<String>,
    pub(super) stored: Stored,
    /// A stored value that means "no data".
    pub(super) no_data: Option<f64>,
    /// From stored samples to the file's numbers.
    pub(super) numbers: Line,
    /// nm per unit of the file's numbers.
    pub(super) unit_nm: Found<f64>,
    /// Sample spacing in nm along x and y.
    pub(super) pitch_nm: Found<[f64; 2]>,
    /// By how much the scanner's fast axis is turned against x, counterclockwise, in degrees.
    pub(super) angle_deg: Option<f64>,
    pub(super) warnings: Vec<String>,
}

impl RawScan {
    /// Samples of which nothing else is known.
    pub(super) fn of(format: &'static str, stored: Stored) -> Self {
        Self {
            format,
            page: 0,
            channel: None,
            stored,
            no_data: None,
            numbers: Line::IDENTITY,
            unit_nm: Err("nothing in the file gives a height unit".to_owned()),
            pitch_nm: Err("nothing in the file gives a pixel size".to_owned()),
            angle_deg: None,
            warnings: Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flips_of_odd_and_even_sizes() {
        let mut odd = Stored { size: [2, 3], kind: SampleKind::F64, values: vec![1., 2., 3., 4., 5., 6.] };
        odd.flip_rows();
        assert_eq!(odd.values, [5., 6., 3., 4., 1., 2.]);
        odd.flip_columns();
        assert_eq!(odd.values, [6., 5., 4., 3., 2., 1.]);
        let mut even = Stored { size: [1, 2], kind: SampleKind::F64, values: vec![1., 2.] };
        even.flip_rows();
        assert_eq!(even.values, [2., 1.]);
    }

    #[test]
    fn no_data_compares_as_stored() {
        assert_eq!(SampleKind::F32.rounded(-3.4e38), f64::from(-3.4e38f32));
        assert_eq!(SampleKind::F64.rounded(0.1), 0.1);
    }
}
