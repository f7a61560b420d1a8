//! Shares of the tolerance that tables restricted to scenes may take, each with its cause.

/// Interpolating between texels with ranges of their own, in first and in second order of how much the ranges differ.
pub(super) const RANGE_SHARES: [f64; 2] = [0.5, 0.1];

/// The basis. Pictures may look at nothing but the one direction in twenty that errs by more than the tables' share.
pub(in crate::tables) const BASIS_SHARE: f64 = 0.125;

/// The nodes of a ring over its own `|w|`, within which texels have ranges of their own.
pub(in crate::tables) const RING_SHARE: f64 = 0.1;

/// Nodes over an interval wider than need be: twice that of the ring's own range, so that where as many suffice for that,
/// it seldom hangs on the texels tried. Beside what steps in wavelength and texels' ranges are given, half the tolerance
/// each, it adds a fiftieth where errors add as squares.
pub(super) const WIDE_SHARE: f64 = 2.0 * RING_SHARE;
