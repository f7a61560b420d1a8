//! Frames around maps over all viewing directions: rings of angle, axes, light and mirror, orders of the strongest periods.

use crate::report::frames::period_letter;
use crate::report::svg::{at, escape};
use crate::stages::goniometry::ReflectionMap;
use crate::stages::results::Period;

/// Sizes in SVG units: the frame's side, and the disc's centre and radius.
const SIDE: f64 = 400.0;
const CENTRE: f64 = 200.0;
const RADIUS: f64 = 172.0;

/// Polar angles of the rings in degrees.
const RINGS_DEG: [f64; 5] = [15.0, 30.0, 45.0, 60.0, 75.0];

/// Ends of the visible spectrum in nm that an order is drawn between.
const ORDER_NM: [f64; 2] = [420.0, 680.0];

/// Most orders to either side that are drawn of the strongest period, and of others; most periods.
const ORDERS_MAX: [i32; 2] = [2, 1];
const PERIODS_MAX: usize = 3;

/// Where along the line of an order its name stands, period by period.
const LABELS_AT: [f64; PERIODS_MAX] = [1.0, 0.5, 0.0];

/// The frame of a map: `href` is the picture's address, the periods are those of the heights.
pub(crate) fn map_frame(href: &str, map: &ReflectionMap, periods: &[Period]) -> String {
    let light = [map.light_theta_deg.to_radians().sin(), 0.0];
    let mirror = [-light[0], 0.0];
    let mut body = format!(
        r#"<image href="{}" x="{low}" y="{low}" width="{side}" height="{side}" style="clip-path:circle(50%)"/><circle class="box" cx="{CENTRE}" cy="{CENTRE}" r="{RADIUS}"/>"#,
        escape(href),
        low = at(CENTRE - RADIUS),
        side = at(2.0 * RADIUS),
    );
    body += &rings();
    body += &axes();
    for (index, period) in periods.iter().enumerate().take(PERIODS_MAX) {
        body += &orders(index, period, mirror);
    }
    body += &mark(light, "light");
    if mirror != light {
        body += &mark(mirror, "mirror");
    }
    let label = format!(
        "Colours over all viewing directions, light {} degrees from the normal towards +x",
        map.light_theta_deg
    );
    format!(r#"<svg class="plot" viewBox="0 0 {SIDE} {SIDE}" role="img" aria-label="{}">{body}</svg>"#, escape(&label))
}

/// Place of a direction with these cosines.
fn place([x, y]: [f64; 2]) -> [f64; 2] {
    [CENTRE + RADIUS * x, CENTRE - RADIUS * y]
}

fn rings() -> String {
    let ring = |angle: f64| {
        let radius = RADIUS * angle.to_radians().sin();
        format!(
            r#"<circle class="ring" cx="{CENTRE}" cy="{CENTRE}" r="{}"/><text class="on small" x="{}" y="{}" text-anchor="middle">{angle}°</text>"#,
            at(radius),
            at(CENTRE - radius * std::f64::consts::FRAC_1_SQRT_2),
            at(CENTRE + radius * std::f64::consts::FRAC_1_SQRT_2 + 4.0),
        )
    };
    RINGS_DEG.into_iter().map(ring).collect()
}

fn axes() -> String {
    let end = CENTRE + RADIUS;
    format!(
        r#"<path class="tick" d="M{end} {CENTRE}h12m-4 -3l4 3l-4 3"/><text x="{}" y="{}">x</text><path class="tick" d="M{CENTRE} {}v-12m-3 4l3 -4l3 4"/><text x="{}" y="{}">y</text>"#,
        at(end + 15.0),
        at(CENTRE + 4.0),
        at(CENTRE - RADIUS),
        at(CENTRE + 7.0),
        at(CENTRE - RADIUS - 7.0),
    )
}

/// Where the grating equation sends the visible spectrum: `m λ / d` from the mirror's direction, along the grating vector.
fn orders(index: usize, period: &Period, mirror: [f64; 2]) -> String {
    if !(period.period_nm.is_finite() && period.period_nm > 0.0 && period.direction_deg.is_finite()) {
        return String::new();
    }
    let (sin, cos) = period.direction_deg.to_radians().sin_cos();
    let at_nm = |order: i32, nm: f64| {
        let shift = f64::from(order) * nm / period.period_nm;
        [mirror[0] + shift * cos, mirror[1] + shift * sin]
    };
    let is_seen = |[x, y]: [f64; 2]| x.hypot(y) < 0.999;
    let mut body = String::new();
    let most = ORDERS_MAX[index.min(1)];
    for order in (-most..=most).filter(|order| *order != 0) {
        let steps = (0..=26).map(|step| ORDER_NM[0] + (ORDER_NM[1] - ORDER_NM[0]) * f64::from(step) / 26.0);
        let seen: Vec<[f64; 2]> = steps.map(|nm| at_nm(order, nm)).filter(|d| is_seen(*d)).map(place).collect();
        let (Some(first), Some(last)) = (seen.first(), seen.last()) else { continue };
        let line = format!("M{} {}L{} {}", at(first[0]), at(first[1]), at(last[0]), at(last[1]));
        // Neighbouring periods are named at different places of their lines, none beyond the rim.
        let share = LABELS_AT[index.min(LABELS_AT.len() - 1)];
        let [x, y] = within([0, 1].map(|axis| first[axis] + share * (last[axis] - first[axis])));
        body += &format!(
            r#"<path class="order" d="{line}"/><text class="on small" x="{}" y="{}" text-anchor="middle">{}{}</text>"#,
            at(x - 13.0 * sin),
            at(y - 13.0 * cos.abs() + 4.0),
            period_letter(index),
            if order > 0 { format!("+{order}") } else { format!("−{}", -order) },
        );
    }
    body
}

/// A place for a label: the same, or as far from the middle as a label fits inside the rim.
fn within([x, y]: [f64; 2]) -> [f64; 2] {
    let distance = (x - CENTRE).hypot(y - CENTRE);
    let factor = ((RADIUS - 18.0) / distance.max(1.0)).min(1.0);
    [CENTRE + factor * (x - CENTRE), CENTRE + factor * (y - CENTRE)]
}

fn mark(direction: [f64; 2], name: &str) -> String {
    let [x, y] = place(direction);
    let drawn = match name {
        "light" => format!(
            r#"<circle class="under" cx="{0}" cy="{1}" r="6"/><circle class="mark" cx="{0}" cy="{1}" r="6"/>"#,
            at(x),
            at(y)
        ),
        _ => ["under", "mark"]
            .map(|class| format!(r#"<path class="{class}" d="M{} {}h12m-6 -6v12"/>"#, at(x - 6.0), at(y)))
            .concat(),
    };
    format!(r#"{drawn}<text class="on small" x="{}" y="{}" text-anchor="middle">{name}</text>"#, at(x), at(y + 19.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(light_theta_deg: f64) -> ReflectionMap {
        ReflectionMap { png: "a/b.png".into(), light_theta_deg, white_level: 1.0 }
    }

    fn period(period_nm: f64, direction_deg: f64) -> Period {
        Period { period_nm, direction_deg, relative_power: 1.0 }
    }

    /// Ends of the lines of orders, as direction cosines.
    fn drawn(svg: &str) -> Vec<[f64; 4]> {
        let lines = svg.split(r#"class="order" d="M"#).skip(1).map(|rest| rest.split('"').next().unwrap());
        let numbers = |line: &str| -> Vec<f64> { line.split([' ', 'L']).map(|part| part.parse().unwrap()).collect() };
        lines
            .map(|line| {
                let n = numbers(line);
                [(n[0] - CENTRE) / RADIUS, (CENTRE - n[1]) / RADIUS, (n[2] - CENTRE) / RADIUS, (CENTRE - n[3]) / RADIUS]
            })
            .collect()
    }

    #[test]
    fn orders_lie_where_the_grating_equation_has_them() {
        let svg = map_frame("x", &map(0.0), &[period(1600.0, 90.0)]);
        let [a, b, c, d] = drawn(&svg)[2];
        assert!(a.abs() < 1e-3 && c.abs() < 1e-3, "along y: {a} {c}");
        assert!((b - 420.0 / 1600.0).abs() < 1e-3 && (d - 680.0 / 1600.0).abs() < 1e-3, "{b} {d}");
        let tilted = map_frame("x", &map(45.0), &[period(1600.0, 0.0)]);
        let mirror = -f64::sqrt(0.5);
        assert!(
            (drawn(&tilted).iter().map(|line| line[0]).fold(1.0, f64::min) - (mirror - 420.0 / 1600.0)).abs() < 1e-3
        );
    }

    #[test]
    fn periods_without_orders_above_the_surface_draw_none() {
        let svg = map_frame("x", &map(0.0), &[period(314.0, 0.0), period(f64::NAN, 0.0)]);
        assert!(drawn(&svg).is_empty(), "{svg}");
    }
}
