//! Dialects of CSV that are taken, and faults that are named with their place.

use std::fs::File;

use super::*;

fn parse_with(text: &str, acceptance_deg: f64) -> Result<Measurement> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("r.csv");
    std::fs::write(&file, text).unwrap();
    read(&MeasuredConfig { file, acceptance_deg, bandwidth_nm: 0.0, export: None })
}

fn parse(text: &str) -> Measurement {
    parse_with(text, 1.0).unwrap()
}

const HEAD: &str = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,wavelength_nm";

#[test]
fn dialects_mean_the_same() {
    let plain = parse(&format!("{HEAD},brdf_per_sr\n10,0,-20.5,180,500,0.25\n10,0,-20.5,180,510,-0.5\n"));
    assert_eq!(plain.angles_deg, [[10.0, 0.0, -20.5, 180.0]; 2]);
    assert_eq!(plain.wavelength_nm, [500.0, 510.0]);
    assert_eq!(plain.columns[0].values, [0.25, -0.5]);
    assert_eq!(plain.notes, ["1 of 2 values of `brdf_per_sr` are negative, as a dark reading leaves them"]);
    for text in [
        // A byte-order mark, CRLF, comments, blank lines and quotes.
        "\u{feff}# lamp A\r\n\"theta_i_deg\", phi_i_deg ,theta_r_deg,phi_r_deg,Wavelength_nm,BRDF_per_sr\r\n\r\n\
         10,0,-20.5,180,500,0.25\r\n#\r\n10, 0, -20.5, 180, 510, -5e-1\r\n",
        // Semicolons and decimal commas; columns in another order.
        "BRDF_per_sr;wavelength_nm;theta_i_deg;phi_i_deg;theta_r_deg;phi_r_deg\n\
         0,25;500;10;0;-20,5;180\n-0,5;510;10;-0;-20,5;180\n",
        "theta_i_deg\tphi_i_deg\ttheta_r_deg\tphi_r_deg\twavelength_nm\tBRDF_per_sr\n\
         10\t0\t-20.5\t180\t500\t0.25\n10\t0\t-20.5\t180\t510\t-0.5\n",
    ] {
        let other = parse(text);
        assert_eq!((&other.angles_deg, &other.wavelength_nm), (&plain.angles_deg, &plain.wavelength_nm), "{text}");
        assert_eq!(other.columns[0].values, plain.columns[0].values, "{text}");
        assert_eq!(other.columns[0].name, "BRDF_per_sr");
    }
}

#[test]
fn vectors_mean_their_angles() {
    let head = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,wavelength_nm,brdf_per_sr";
    let found = parse(&format!("{head}\n0,2,2,0,0,5,500,0.25\n0,2,2,-1,0,1,510,0.5\n"));
    for (angles, expected) in found.angles_deg.iter().zip([[45.0, 90.0, 0.0, 0.0], [45.0, 90.0, 45.0, 180.0]]) {
        assert!(angles.iter().zip(expected).all(|(angle, wanted)| (angle - wanted).abs() < 1e-12), "{angles:?}");
    }
    for (row, expected) in [
        ("0,0,1,1,0,0,500,1", "within 89.9 degrees"),
        ("0,0,0,0,0,1,500,1", "within 89.9 degrees"),
        ("0,0,x,1,0,0,500,1", "`wi_z`"),
    ] {
        let message = parse_with(&format!("{head}\n{row}\n"), 1.0).unwrap_err().to_string();
        assert!(message.contains(":2:") && message.contains(expected), "{message}");
    }
    let message = parse_with("wi_x,wi_y,wi_z,wo_x,wo_y,wavelength_nm,brdf_per_sr\n", 1.0).unwrap_err().to_string();
    assert!(message.contains("`wo_z` is missing"), "{message}");
}

#[test]
fn several_columns_labels_per_cent_and_gaps() {
    let file = parse(&format!(
        "{HEAD},brdf_per_sr:first,brdf_per_sr:second,reflectance_factor_percent,operator\n\
         0,0,1,0,500,1,,50,x\n0,0,1,0,501,2,3,25,y\n"
    ));
    let [first, second, factor] = &file.columns[..] else { panic!("three columns") };
    assert_eq!((first.kind, first.values.as_slice()), (Kind::Brdf, &[1.0, 2.0][..]));
    assert!(second.values[0].is_nan() && second.values[1] == 3.0);
    assert_eq!((factor.kind, factor.values.as_slice()), (Kind::RadianceFactor, &[0.5, 0.25][..]));
    assert_eq!(file.notes.len(), 2, "{:?}", file.notes);
    assert!(
        file.notes[0].contains("`operator`")
            && file.notes[1].contains("1 cells of `brdf_per_sr:second` hold no number")
    );
}

#[test]
fn faults_are_named_with_file_line_and_column() {
    let row = |cells: &str| format!("{HEAD},brdf_per_sr\n0,0,0,0,500,1\n{cells}\n");
    for (text, place, expected) in [
        (String::new(), ":1:1:", "no line of column names"),
        ("# only\n\n".into(), ":1:1:", "no line of column names"),
        (format!("{HEAD},brdf_per_sr\n"), ":1:1:", "no rows"),
        (format!("{HEAD}\n0,0,0,0,500\n"), ":1:1:", "no column says what kind"),
        (format!("{HEAD},reflectance\n0,0,0,0,500,1\n"), ":1:59:", "`reflectance` does not say its kind"),
        (format!("{HEAD},relative\n0,0,0,0,500,1\n"), ":1:59:", "`relative_power`"),
        (format!("{HEAD},brdf_per_sr_percent\n"), ":1:59:", "cannot be in per cent"),
        (format!("{HEAD},brdf_per_sr,brdf_per_sr\n"), ":1:71:", "stands twice"),
        (format!("# a\n{},brdf_per_sr\n", HEAD.replace("wavelength_nm", "wavelength_um")), ":2:45:", "`wavelength_um`"),
        (format!("{},brdf_per_sr\n", HEAD.replace("phi_r_deg", "azimuth")), ":1:1:", "`phi_r_deg` is missing"),
        (row("0,0,0,0,500"), ":3:1:", "expected 6 cells"),
        (row("0,0,0,0,500,0,1"), ":3:1:", "separate cells by semicolons"),
        (row("0,0,0,0,510,x"), ":3:13:", "`x` in the column `brdf_per_sr` is not a finite number"),
        (row("0,0, x,0,510,1"), ":3:6:", "`x` in the column `theta_r_deg`"),
        (row("90,0,0,0,510,1"), ":3:1:", "`theta_i_deg` must lie between -89.9 and 89.9"),
        (row("0,0,0,400,510,1"), ":3:7:", "`phi_r_deg` must lie"),
        (format!("{HEAD},brdf_per_sr\n0,0,0,0,0.51,1\n0,0,0,0,0.52,1\n"), ":1:1:", "are they in nm?"),
        (row("0,0,0,0,,1"), ":3:9:", "`` in the column `wavelength_nm`"),
        (format!("{HEAD},brdf_per_sr\n0,0,0,0,500,-1\n0,0,0,0,500,0\n"), ":1:1:", "no value above 0"),
    ] {
        let message = parse_with(&text, 1.0).unwrap_err().to_string();
        assert!(message.contains(&format!("r.csv{place}")) && message.contains(expected), "{text:?}: {message}");
    }
    let cone = format!("{HEAD},cone_reflectance\n0,0,0,0,500,1\n");
    assert_eq!(parse_with(&cone, 1.0).unwrap().columns[0].kind, Kind::ConeReflectance);
    assert!(parse_with(&cone, 0.0).unwrap_err().to_string().contains("`acceptance_deg`"));
}

#[test]
fn what_is_no_text_or_too_long_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("r.csv");
    let config = MeasuredConfig { file: file.clone(), acceptance_deg: 0.0, bandwidth_nm: 0.0, export: None };
    std::fs::write(&file, [b'I', b'I', 42, 0]).unwrap();
    assert!(read(&config).unwrap_err().to_string().contains("this is no text"));
    let mut text = format!("{HEAD},brdf_per_sr\n");
    text.push_str(&"0,0,0,0,500,1\n".repeat(ROWS_MAX + 1));
    std::fs::write(&file, text).unwrap();
    assert!(read(&config).unwrap_err().to_string().contains("more than 200000 rows"));
    // A sparse file: its size alone is too much.
    File::options().write(true).open(&file).unwrap().set_len(BYTES_MAX + 1).unwrap();
    assert!(read(&config).unwrap_err().to_string().contains("64 MiB"));
}

#[test]
fn rows_that_cannot_be_compared_are_counted() {
    let rows = "0,0,0,0,199,1\n0,0,0,0,500,NaN\n0,0,0,0,510,inf\n0,0,0,0,520,2\n0,0,0,0,9000,1\n";
    let file = parse(&format!("{HEAD},brdf_per_sr\n{rows}"));
    assert_eq!(file.wavelength_nm, [500.0, 510.0, 520.0]);
    assert!(file.columns[0].values[..2].iter().all(|value| value.is_nan()));
    assert_eq!(file.notes.len(), 2, "{:?}", file.notes);
    assert!(file.notes[0].starts_with("2 rows with wavelengths outside") && file.notes[1].starts_with("2 cells"));
}
