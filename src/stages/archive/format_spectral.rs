//! The section of `FORMAT.md` on spectral tables.

use super::format_look_ups::between_texels;
use diffraction_brdf::spectral_storage::{StoredSpectral, StoredSpectralLobe};
use diffraction_build::tables::model::Basis;

/// The section for a specimen's spectral tables; empty where there are none. `alone` where there are no others, whose look-ups the page
/// tells.
pub(super) fn spectral_section(spectral: Option<&StoredSpectral>, alone: bool) -> String {
    let Some(spectral) = spectral else { return String::new() };
    let StoredSpectral { shortest_nm, longest_nm, tables, .. } = spectral;
    let size = spectral.xi_per_nm.samples;
    let grows = spectral.lobe.as_ref().is_some_and(|lobe| lobe.is_of_source);
    format!(
        "## Single wavelengths, other lights

`spectral` in `specimen.json` names tables that hold no light and no observer: the BRDF at every wavelength `lambda` from
`lambda_0 = shortest_nm`, here {shortest_nm} nm, upwards. They stand on their own; `table.NNN.exr` and `lobe.exr` are not read.

- `spectral.images`: `spectral.NNN.exr`, {count} files of {size} x {size} texels for {tables} tables, **three to a file**: table n is
  channel `n mod 3` of file `floor(n / 3)`, R before G before B. Axes are spatial frequencies, `xi = u / lambda` along columns and
  `eta = v / lambda` along rows, from `-2 / lambda_0` to `2 / lambda_0` between centres, row 0 at the positive end. With
  `r = lambda_0 / lambda` and `(u', v', w') = r (u, v, w)` that is column `{last} (u' + 2) / 4`, row `{last} (2 - v') / 4`.
{lobe}- `f(lambda, wi, wo) = r^4 D (sum_n table_n T_n(2t - 1) + cross) + {share}C lobe`, with `t = |w'| / sqrt(4 - u'^2 - v'^2)`, at most 1,
  and `T_n`, `D`, `C` as on this page. With the scalar factor `lobe = power exp(-(2 pi sigma rho / {lobe_nm})^2)`,
  `rho = sqrt(u^2 + v^2)`; with the vector factor the same with the image's distance `sqrt(u^2 + v^2 + 4 h_i h_o)` is added. No
  lobe: 0.
- `spectral.dispersion`, where there is one: the material's index `n + i k` by wavelength, to be used in `D` and `C` in place of
  `optics.material`. Between its wavelengths follow monotone cubics: Hermite's, slopes at a knot the harmonic mean of the secants
  to both sides, weighted by `(2 b + a, 2 a + b) / 3 (a + b)` with the widths `a` before and `b` after the knot; 0 where the secants
  differ in sign, and at the ends the secant itself.
- X, Y, Z under a light of spectrum `S`: `sum f S x / sum S y` and so on over wavelengths from {shortest_nm} to {longest_nm} nm,
  `x`, `y`, `z` the observer's. Steps have to resolve the orders: for a direction `rho` from the mirror's, in wavenumber
  `1 / lambda`, Gaussian pulses of the deviation `1 / (2 pi sqrt(2) spectral.sigma_nm rho)` or wider.
- `spectral.check_values`: directions with wavelengths and `f`: `brdf_spline` by splines, `brdf` by linear look-ups.
{between}",
        count = spectral.images.len(),
        share = if grows { "" } else { "r^2 " },
        lobe_nm = if grows { "lambda_0" } else { "lambda" },
        last = size.saturating_sub(1),
        between = if alone { between_texels(Basis::Chebyshev, size) } else { "- Look-ups between texels are those of Files.\n".to_owned() },
        lobe = spectral.lobe.as_ref().map_or(String::new(), lobe_files),
    )
}

fn lobe_files(lobe: &StoredSpectralLobe) -> String {
    let (samples, sigma_nm) = (lobe.half_abs_w.samples, lobe.sigma_nm);
    let mut text = format!(
        "- `spectral_lobe.exr`, one row of {samples} texels with three equal channels: `power` over `|w'| / 2` from 0 to 1, linear in
  between. `sigma = spectral.lobe.sigma_nm`, here {sigma_nm} nm.
",
    );
    if lobe.is_of_source {
        text += "  `sigma_grows`: it is that at `lambda_0`, and grows in proportion to the wavelength, as under a source of fixed size. The
  lobe is then the same at every wavelength. Where it does not grow, `r^2 C lobe` and `rho / lambda` stand below.\n";
    }
    match &lobe.cross {
        None => text += "- `cross` is 0 here.\n",
        Some(cross) => {
            text += &format!(
                "- `spectral_cross.NNN.exr`: {} patches of {side} x {side} texels, packed as the tables are, `xi` from `-k` to `k` and
  `eta` from `k` down, `k = spectral.lobe.cross.xi_per_nm.last`. `cross = sum_n patch_n T_n(2t - 1) / |w'|`, 0 outside.
",
                cross.patches,
                side = cross.xi_per_nm.samples,
            );
        }
    }
    text
}
