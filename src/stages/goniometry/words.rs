//! Where the colours are, in a sentence: runs of hues along the angle, in light from straight above.

use std::fmt::Write;

use super::strips::{Plane, SetUp, Strip};
use diffraction_brdf::direction::Xyz;
use diffraction_build::ground::hue::Hue;

/// A radiance factor below which everything is called dark, and the same relative to the brightest beside the mirror.
const DARK: f64 = 0.01;
const DARK_SHARE: f64 = 0.02;

/// Largest angle in degrees that is told of: towards grazing everything grows bright.
const ANGLE_MAX_DEG: f64 = 75.0;

/// Two orders are told apart where the light between them falls below this share of the fainter one.
const GAP: f64 = 0.3;

/// The ends of a run are where it reaches this share of its peak.
const RUN_ENDS: f64 = 0.05;

/// The mirror's light ends where it has fallen to this share, or rises again.
const MIRROR_ENDS: f64 = 0.02;

/// Width in degrees below which a run is called a glint.
const GLINT_DEG: f64 = 3.0;

/// Most runs told on a side, and how many degrees two sides may differ and pass for alike.
const RUNS_MAX: usize = 2;
const ALIKE_DEG: f64 = 2.5;

/// Angles over which the light is on.
#[derive(Debug, Clone, PartialEq)]
struct Run {
    from_deg: f64,
    to_deg: f64,
    /// Names of the hues at both ends.
    hues: [String; 2],
    peak: f64,
}

/// What one sees in light from straight above, against this white.
pub(super) fn sentence(strips: &[Strip], white: Xyz) -> String {
    let normal = |plane| strips.iter().find(|strip| strip.set_up == SetUp::NormalIncidence && strip.plane == plane);
    let planes: Vec<(&str, &Strip)> = [("x", Plane::Xz), ("y", Plane::Yz)]
        .into_iter()
        .filter_map(|(axis, plane)| Some((axis, normal(plane)?)))
        .collect();
    let Some((_, first)) = planes.first() else { return String::new() };
    let above = first.xyz[first.angles_deg().position(|angle| angle == 0.0).unwrap_or(0)].map(f64::from);
    let mut text = match Hue::of(above, white) {
        None => "In light from straight above it is dark from there.".to_string(),
        Some(hue) => format!("In light from straight above it looks {} from there.", hue.name()),
    };
    let sides = planes.iter().map(|(axis, strip)| (*axis, [1.0, -1.0].map(|sign| side(strip, sign))));
    let sides: Vec<_> = sides.collect();
    let brightest = sides.iter().flat_map(|(_, sides)| sides).flatten().map(|(_, xyz)| xyz[1]).fold(0.0, f64::max);
    let dark = DARK.max(DARK_SHARE * brightest);
    for (axis, pair) in &sides {
        let [plus, minus] = pair.each_ref().map(|side| runs(side, dark, white));
        if are_alike(&plus, &minus) {
            let _ = write!(text, " Tilted along {axis}, either way, it {}.", describe(&plus));
        } else {
            let _ = write!(
                text,
                " Tilted towards +{axis} it {}, towards −{axis} it {}.",
                describe(&plus),
                describe(&minus)
            );
        }
    }
    text
}

/// Angles from the end of the mirror's light on, with colours, towards one side; all of them where it stands out nowhere.
fn side(strip: &Strip, sign: f64) -> Vec<(f64, Xyz)> {
    let values = strip.angles_deg().zip(&strip.xyz).map(|(angle, xyz)| (sign * angle, xyz.map(f64::from)));
    let mut values: Vec<(f64, Xyz)> = values.filter(|(angle, _)| (0.0..=ANGLE_MAX_DEG).contains(angle)).collect();
    values.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mirror = values.first().map_or(0.0, |(_, xyz)| xyz[1]);
    let is_past = |pair: &[(f64, Xyz)]| pair[0].1[1] < MIRROR_ENDS * mirror || pair[1].1[1] > pair[0].1[1];
    values.split_off(values.windows(2).position(is_past).unwrap_or(0))
}

/// Runs of light, the brightest few, by angle.
fn runs(side: &[(f64, Xyz)], dark: f64, white: Xyz) -> Vec<Run> {
    let mut found: Vec<Run> = side
        .split(|(_, xyz)| xyz[1] < dark)
        .filter(|lit| !lit.is_empty())
        .flat_map(orders)
        .filter_map(|lit| run(lit, white))
        .collect();
    // What is narrow and joins the mirror's light is its edge.
    let joins_mirror = |run: &Run| side.first().is_some_and(|(angle, _)| run.from_deg <= *angle);
    found.retain(|run| !(run.is_narrow() && joins_mirror(run)));
    found.sort_by(|a, b| b.peak.total_cmp(&a.peak));
    found.truncate(RUNS_MAX);
    found.sort_by(|a, b| a.from_deg.total_cmp(&b.from_deg));
    found
}

/// A stretch of light, cut where it nearly goes out between two peaks.
fn orders(lit: &[(f64, Xyz)]) -> Vec<&[(f64, Xyz)]> {
    let luminance = |n: usize| lit[n].1[1];
    let largest = |from: usize, to: usize| (from..to).map(luminance).fold(0.0, f64::max);
    let is_gap = |n: &usize| luminance(*n) < GAP * largest(0, *n).min(largest(n + 1, lit.len()));
    let deepest = (0..lit.len()).filter(is_gap).min_by(|a, b| luminance(*a).total_cmp(&luminance(*b)));
    match deepest {
        None => vec![lit],
        Some(cut) => {
            let (left, right) = lit.split_at(cut);
            [orders(left), orders(right)].concat()
        }
    }
}

impl Run {
    /// Whether it is a glint rather than a run of colours.
    fn is_narrow(&self) -> bool {
        self.to_deg - self.from_deg < GLINT_DEG
    }
}

/// A run with the hues of its ends; `None` where nothing is lit.
fn run(lit: &[(f64, Xyz)], white: Xyz) -> Option<Run> {
    let peak = lit.iter().map(|(_, xyz)| xyz[1]).fold(0.0, f64::max);
    let bright = |value: &&(f64, Xyz)| value.1[1] >= RUN_ENDS * peak;
    let (first, last) = (lit.iter().find(bright)?, lit.iter().rfind(bright)?);
    let hues = [first, last].map(|(_, xyz)| Hue::of(*xyz, white).map_or_else(|| "dark".into(), |hue| hue.name()));
    Some(Run { from_deg: first.0, to_deg: last.0, hues, peak })
}

fn are_alike(plus: &[Run], minus: &[Run]) -> bool {
    let is_near = |a: f64, b: f64| (a - b).abs() <= ALIKE_DEG;
    plus.len() == minus.len()
        && plus.iter().zip(minus).all(|(a, b)| {
            a.hues == b.hues
                && is_near(a.from_deg, b.from_deg)
                && is_near(a.to_deg, b.to_deg)
                && b.peak > GAP * a.peak
                && a.peak > GAP * b.peak
        })
}

/// Runs as the end of "it …".
fn describe(runs: &[Run]) -> String {
    if runs.is_empty() {
        return "stays dark".into();
    }
    let told = runs.iter().map(|run| {
        let [from, to] = [run.from_deg, run.to_deg];
        if run.is_narrow() {
            return format!("glints {} at {:.0}°", run.hues[0], 0.5 * (from + to));
        }
        match &run.hues {
            [first, last] if first == last => format!("is {first} from {from}° to {to}°"),
            [first, last] => format!("runs from {first} to {last} between {from}° and {to}°"),
        }
    });
    told.collect::<Vec<_>>().join(" and ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::spectrum::observer_2deg;

    const EVEN: Xyz = [1.0; 3];

    /// What a grating shows along its plane in light of equal energy: at each angle the wavelengths `d sin(θ) / m`.
    fn grating(plane: Plane, period_nm: f64, orders: &[(i32, f64)]) -> Strip {
        let value = |angle: i32| {
            let reach_nm = period_nm * f64::from(angle).to_radians().sin();
            let mut xyz = [0.0; 3];
            for (order, strength) in orders {
                let nm = reach_nm / f64::from(*order);
                if (380.0..780.0).contains(&nm) {
                    (0..3).for_each(|c| xyz[c] += strength * observer_2deg(nm)[c]);
                }
            }
            if angle == 0 { [50.0; 3] } else { xyz.map(|value| value as f32) }
        };
        Strip { set_up: SetUp::NormalIncidence, plane, first_deg: -85, xyz: (-85..=85).map(value).collect() }
    }

    fn dark(plane: Plane) -> Strip {
        grating(plane, 1000.0, &[])
    }

    #[test]
    fn a_gratings_first_order_runs_from_blue_to_red_where_the_equation_has_it() {
        let strips = [grating(Plane::Xz, 1600.0, &[(1, 1.0), (-1, 1.0)]), dark(Plane::Yz)];
        let told = sentence(&strips, EVEN);
        assert!(told.starts_with("In light from straight above it looks white from there."), "{told}");
        assert!(told.contains("Tilted along x, either way, it runs from blue to red between"), "{told}");
        assert!(told.ends_with("Tilted along y, either way, it stays dark."), "{told}");
        let found = runs(&side(&strips[0], 1.0), DARK, EVEN);
        assert_eq!(found.len(), 1, "{found:?}");
        // There the eye sees a twentieth of its best, where a run is said to end.
        for (angle, nm) in [(found[0].from_deg, 453.0), (found[0].to_deg, 661.0)] {
            let expected = f64::asin(nm / 1600.0).to_degrees();
            assert!((angle - expected).abs() < 1.0, "{angle}: {expected}");
        }
    }

    #[test]
    fn a_blaze_shows_its_colours_on_one_side() {
        let told = sentence(&[grating(Plane::Xz, 1600.0, &[(1, 1.0)]), dark(Plane::Yz)], EVEN);
        assert!(
            told.contains("Tilted towards +x it runs from blue to red") && told.contains("towards −x it stays dark."),
            "{told}"
        );
        let turned = sentence(&[dark(Plane::Xz), grating(Plane::Yz, 1600.0, &[(1, 1.0)])], EVEN);
        assert!(
            turned.contains("towards +y it runs from blue") && turned.contains("along x, either way, it stays dark"),
            "{turned}"
        );
    }

    #[test]
    fn orders_are_told_apart_and_a_short_period_shows_none() {
        let two = runs(&side(&grating(Plane::Xz, 2500.0, &[(1, 1.0), (2, 0.5)]), 1.0), DARK, EVEN);
        assert_eq!(two.len(), 2, "{two:?}");
        assert!(two[0].to_deg <= two[1].from_deg && two[1].to_deg > 30.0, "{two:?}");
        let none = sentence(&[grating(Plane::Xz, 314.0, &[(1, 1.0), (-1, 1.0)]), dark(Plane::Yz)], EVEN);
        assert!(none.contains("Tilted along x, either way, it stays dark."), "{none}");
    }

    #[test]
    fn an_even_haze_is_white() {
        let haze = |plane| Strip { xyz: vec![[0.3; 3]; 171], ..dark(plane) };
        let told = sentence(&[haze(Plane::Xz), haze(Plane::Yz)], EVEN);
        assert!(told.contains("Tilted along x, either way, it is white from 0° to 75°."), "{told}");
    }
}
