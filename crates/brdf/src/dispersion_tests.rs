use super::*;
use crate::material::reflectance;

fn reflectance_at(name: &str, nm: f64) -> f64 {
    reflectance(Dispersion::substance(name).unwrap().material_at(nm).unwrap(), 1.0)
}

#[test]
fn every_name_has_a_table_that_holds_what_is_seen() {
    assert_eq!(substances().len(), 10);
    for name in substances() {
        let table = Dispersion::substance(name).unwrap_or_else(|| panic!("{name}"));
        assert_eq!(table.name(), name);
        assert!(matches!(table.origin(), Origin::Literature(text) if text.contains("(19") || text.contains("(20")));
        let [low, high] = table.range_nm();
        assert!(low <= 360.0 && high >= 830.0, "{name}: {low} to {high}");
        assert_eq!(metals().contains(&name), Dispersion::metal(name).is_some());
        assert_eq!(table.material_at(low - 1e-9).or(table.material_at(high + 1e-9)), None, "{name}");
        let text = serde_json::to_string(&table).unwrap();
        assert_eq!(serde_json::from_str::<Dispersion>(&text).unwrap(), table);
    }
    assert_eq!(Dispersion::metal("silica"), None);
    assert_eq!(Dispersion::substance("unobtainium"), None);
}

/// Percent reflected by fresh mirrors (G. Hass, in the American Institute of Physics Handbook, 1972): films made and measured by
/// others than those of the tables.
#[test]
fn mirrors_reflect_as_others_measured() {
    let at = [400.0, 450.0, 500.0, 550.0, 650.0, 700.0];
    for (name, percent) in [
        ("aluminium", [92.4, 92.2, 91.8, 91.5, 90.5, 89.7]),
        ("silver", [95.6, 97.1, 97.9, 98.3, 98.8, 98.9]),
        ("gold", [38.7, 38.7, 47.7, 81.7, 95.5, 97.0]),
        ("copper", [47.5, 55.2, 60.0, 66.9, 96.6, 97.5]),
    ] {
        for (nm, percent) in at.into_iter().zip(percent) {
            let found = 100.0 * reflectance_at(name, nm);
            // Copper's edge, 30 nm wide, lies 10 nm further to the red in these films.
            let most = if name == "copper" && nm == 550.0 { 7.0 } else { 4.0 };
            assert!((found - percent).abs() < most, "{name} at {nm} nm: {found:.1} against {percent}");
        }
    }
}

#[test]
fn the_rest_reflects_what_is_known_of_it() {
    for (name, nm, known, most) in [
        // Fused silica: n = 1.4585 at the yellow line of sodium.
        ("silica", 589.3, ((1.4585f64 - 1.0) / 2.4585).powi(2), 2e-5),
        ("silicon", 550.0, 0.37, 0.01),
        ("silicon", 400.0, 0.48, 0.02),
        ("nickel", 550.0, 0.62, 0.04),
        ("chromium", 550.0, 0.56, 0.03),
    ] {
        let found = reflectance_at(name, nm);
        assert!((found - known).abs() < most, "{name} at {nm} nm: {found} against {known}");
    }
    // The values that the publication states beside its formula, to the digits given.
    for (name, stated) in [("chitin", [1.572, 1.552, 1.541]), ("beta_keratin", [1.569, 1.556, 1.548])] {
        for (nm, n) in [400.0, 500.0, 600.0].into_iter().zip(stated) {
            let found = Dispersion::substance(name).unwrap().index_at(nm).unwrap();
            assert!((found[0] - n).abs() < 1e-3 && found[1] == 0.0, "{name} at {nm} nm: {found:?}");
        }
    }
}

/// Two properties of glass that catalogues state.
#[test]
fn silica_has_its_abbe_number() {
    let silica = Dispersion::substance("silica").unwrap();
    let n = |nm: f64| silica.index_at(nm).unwrap()[0];
    let abbe = (n(587.6) - 1.0) / (n(486.1) - n(656.3));
    assert!((n(587.6) - 1.458_46).abs() < 2e-5 && (abbe - 67.82).abs() < 0.05, "{} {abbe}", n(587.6));
}

#[test]
fn between_wavelengths_the_index_is_smooth_and_stays_between_its_neighbours() {
    let origin = || Origin::Literature("nobody (2000)".into());
    let rows = [[400.0, 1.0, 2.0], [450.0, 1.5, 2.0], [500.0, 0.2, 3.0], [520.0, 0.2, 3.5], [600.0, 0.9, 3.6]];
    let table = Dispersion::new("steps", origin(), &rows).unwrap();
    for pair in rows.windows(2) {
        assert_eq!(table.index_at(pair[0][0]), Some([pair[0][1], pair[0][2]]));
        for step in 0..=100 {
            let nm = pair[0][0] + f64::from(step) / 100.0 * (pair[1][0] - pair[0][0]);
            let found = table.index_at(nm).unwrap();
            for (part, found) in found.into_iter().enumerate() {
                let [a, b] = [pair[0][part + 1], pair[1][part + 1]];
                assert!((a.min(b) - 1e-12..=a.max(b) + 1e-12).contains(&found), "{nm}: {found}");
            }
        }
    }
    assert_eq!(table.index_at(600.0), Some([0.9, 3.6]));
    // No kinks at the knots: slopes to both sides agree.
    for nm in [450.0, 500.0, 520.0] {
        let slope = |from: f64, to: f64| {
            let [a, b] = [from, to].map(|nm| table.index_at(nm).unwrap()[1]);
            (b - a) / (to - from)
        };
        assert!((slope(nm - 1e-4, nm) - slope(nm, nm + 1e-4)).abs() < 1e-4, "{nm}");
    }
    // A straight line stays one.
    let line = Dispersion::new("line", origin(), &[[400.0, 1.0, 1.0], [430.0, 1.3, 1.6], [500.0, 2.0, 3.0]]).unwrap();
    let [n, k] = line.index_at(477.0).unwrap();
    assert!((n - 1.77).abs() < 1e-12 && (k - 2.54).abs() < 1e-12, "{n} {k}");
}

#[test]
fn formulas_are_met_between_the_wavelengths_at_which_they_are_tabulated() {
    let chitin = Dispersion::substance("chitin").unwrap();
    for nm in [362.5, 402.2, 561.3, 828.0] {
        let exact = 1.517 + 8.8e3 / (nm * nm);
        let error = (chitin.index_at(nm).unwrap()[0] - exact).abs();
        assert!(error < 1e-5, "{nm}: {error:e}");
    }
}

#[test]
fn tables_that_are_none_are_refused_by_name() {
    let of = |rows: &[[f64; 3]]| Dispersion::new("x", Origin::Literature(String::new()), rows);
    for (rows, expected) in [
        (&[[500.0, 1.0, 0.0]][..], "fewer than two"),
        (&[[500.0, 1.0, 0.0], [500.0, 1.0, 0.0]], "must increase"),
        (&[[500.0, 1.0, 0.0], [f64::NAN, 1.0, 0.0]], "not above 0"),
        (&[[0.0, 1.0, 0.0], [500.0, 1.0, 0.0]], "not above 0"),
        (&[[400.0, 0.0, 1.0], [500.0, 1.0, 0.0]], "n = 0"),
        (&[[400.0, f64::INFINITY, 1.0], [500.0, 1.0, 0.0]], "n = inf"),
        (&[[400.0, 1.0, -1.0], [500.0, 1.0, 0.0]], "k = -1"),
        (&[[400.0, 1.0, f64::NAN], [500.0, 1.0, 0.0]], "k = NaN"),
        (&[[400.0, 0.9, 0.0], [500.0, 1.0, 0.0]], "below 1 where k is 0"),
    ] {
        let message = of(rows).unwrap_err().to_string();
        assert!(message.contains(expected), "{rows:?}: {message}");
    }
    let text = serde_json::to_string(&of(&[[400.0, 1.0, 0.0], [500.0, 1.0, 0.0]]).unwrap()).unwrap();
    assert!(serde_json::from_str::<Dispersion>(&text.replace("\"n\":[1.0,", "\"n\":[")).is_err());
    assert!(serde_json::from_str::<Dispersion>(&text.replace("\"k\":[0.0,", "\"k\":[-1.0,")).is_err());
}
