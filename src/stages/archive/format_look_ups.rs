//! What `FORMAT.md` says of look-ups between texels.

use diffraction_build::tables::model::Basis;

/// The look-up that tables for every direction are promised for.
pub(super) fn between_texels(basis: Basis, size: usize) -> String {
    if basis == Basis::Taylor {
        return "- Between centres interpolate linearly in both axes.\n".to_owned();
    }
    let middle = size.saturating_sub(1) / 2;
    format!(
        "- Between centres take the **cubic B-spline** through the texels: that is what the tolerance bounds (`errors`: `total, spline
  look-up`). Linear interpolation needs no preparation and errs by `total`. Once, when a table is read, turn values into
  coefficients: texels farther than `d = {middle} + 2` from the middle one take the value of that nearest to the point at `d` in the
  same direction (the zeros there must not ring); then along rows, and along columns, for a line `a_0 .. a_m` that goes on mirrored,
  with `z = sqrt(3) - 2`: `a_0 = sum z^k a_k` over k from 0 to 56, `a_k += z a_(k-1)` upwards, `a_m = z (a_m + z a_(m-1)) / (z^2 - 1)`,
  `a_k = z (a_(k+1) - a_k)` downwards, and all times 6. With `f = c - floor(c)`, `g = 1 - f` the coefficients at `floor(c) - 1` to
  `floor(c) + 2` count `g^3/6`, `2/3 - f^2 + f^3/2`, `2/3 - g^2 + g^3/2`, `f^3/6`, likewise over rows. Hardware takes four linear
  fetches for the sixteen: pairs `w_0, w_1` and `w_2, w_3`, each at its second's share. Lobe and cross patches: cubic, see below.
",
    )
}
