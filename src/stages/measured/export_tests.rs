//! Exports of spectrometers as their programs write them, and what is said of others.

use std::path::PathBuf;

use super::super::kind::Kind;
use super::*;

fn config(column: Option<&str>) -> (MeasuredConfig, ExportConfig) {
    let export = ExportConfig {
        angles_deg: [45.0, 0.0, -0.0, 180.0],
        kind: Kind::RadianceFactor,
        percent: true,
        white_reflectance: 0.98,
        column: column.map(String::from),
    };
    let file = PathBuf::from("r.txt");
    (MeasuredConfig { file, acceptance_deg: 0.0, bandwidth_nm: 0.0, export: Some(export.clone()) }, export)
}

fn read_as(text: &str, column: Option<&str>) -> Result<Measurement> {
    let (config, export) = config(column);
    measurement(&config, &export, text, String::new())
}

const OCEAN: &str = "Data from r.txt Node\n\nDate: Tue Mar 01 10:11:12 CET 2022\nUser: lab\nIntegration Time (sec): 1,000000E-1\n\
                     Number of Pixels in Spectrum: 3\n>>>>>Begin Spectral Data<<<<<\n400,5\t10,0\n401,0\t20,0\n401,5\t-0,5\n\
                     >>>>>End Spectral Data<<<<<\n";
const AVANTES: &str = "Sample\r\nIntegration time: 50,00 ms\r\nAverage: 10 scans\r\nWave   ;Sample   ;Dark     ;Reference;Reflectance\r\n\
                       [nm]   ;[counts] ;[counts] ;[counts]\t;[%]\r\n\r\n 400,5; 100; 5; 900; 10,0\r\n 401,0; 200; 5; 900; 20,0\r\n 401,5; 0; 5; 900; -0,5\r\n";
const CRAIC: &str = "\u{feff}\"Wavelength (nm)\",\"Reflectance (%)\"\n400.5,10\n401.0,20\n401.5,-0.5\n";
const PLAIN: &str = "401.5   -0.5\n401.0   20\n 400.5  10.0\n";
const JCAMP: &str = "##TITLE= wing $$ a comment\n##JCAMP-DX= 4.24\n##DATA TYPE= REFLECTANCE SPECTRUM\n##XUNITS= NANOMETERS\n##YUNITS= % R\n\
                     ##FIRSTX= 400.5\n##LASTX= 401.5\n##NPOINTS= 3\n##XFACTOR= 0.5\n##YFACTOR= 0.5\n##XYDATA= (X++(Y..Y))\n801 20+40\n803-1\n##END=\n";
const JCAMP_POINTS: &str = "##TITLE=x\n##XUNITS=1/CM\n##YUNITS=R\n##XYPOINTS=(XY..XY)\n24968.789013732834, 10; 24937.655860349127, 20\n24906.600249066, -0.5\n##END=\n";

#[test]
fn programs_exports_mean_the_same() {
    for (text, column, name) in [
        (OCEAN, None, "spectrum"),
        (AVANTES, Some("reflectance"), "Reflectance"),
        (AVANTES, Some("5"), "Reflectance"),
        (CRAIC, None, "Reflectance (%)"),
        (PLAIN, None, "spectrum"),
        (&PLAIN.replace(['.'], ","), None, "spectrum"),
        (JCAMP, None, "% r"),
        (JCAMP_POINTS, None, "r"),
    ] {
        let found = read_as(text, column).unwrap_or_else(|error| panic!("{text}: {error}"));
        let mut rows: Vec<(f64, f64)> =
            found.wavelength_nm.iter().copied().zip(found.columns[0].values.iter().copied()).collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        for ((nm, value), expected) in rows.iter().zip([(400.5, 0.098), (401.0, 0.196), (401.5, -0.0049)]) {
            assert!((nm - expected.0).abs() < 1e-6 && (value - expected.1).abs() < 1e-12, "{text}: {rows:?}");
        }
        assert_eq!(rows.len(), 3, "{text}");
        assert_eq!((found.columns[0].name.as_str(), found.columns[0].kind), (name, Kind::RadianceFactor));
        assert_eq!(found.angles_deg, [[45.0, 0.0, 0.0, 180.0]; 3]);
        assert_eq!(found.notes.len(), 1, "a negative value is noted: {:?}", found.notes);
    }
}

#[test]
fn what_was_not_measured_is_counted() {
    let text = "199 1\n200 1\n300 NaN\n400 2\n500 --\n2600 3\n";
    let found = read_as(text, None).unwrap();
    assert_eq!(found.wavelength_nm, [200.0, 300.0, 400.0, 500.0]);
    assert_eq!(found.notes.len(), 2, "{:?}", found.notes);
    assert!(found.notes[0].starts_with("2 rows") && found.notes[1].starts_with("2 cells"), "{:?}", found.notes);
}

#[test]
fn what_cannot_be_told_is_refused_in_words() {
    let packed = JCAMP.replace("801 20+40\n803-1", "801B0DK");
    for (text, column, expected) in [
        ("", None, "no lines of two or more numbers"),
        ("wavelength reflectance\n", None, "no lines of two"),
        ("0.4 1\n0.5 2\n", None, "are they in nm?"),
        (AVANTES, None, "\"Sample\", \"Dark\", \"Reference\", \"Reflectance\"; say which"),
        (AVANTES, Some("white"), "no column of values \"white\""),
        (AVANTES, Some("1"), "no column of values"),
        ("400 -1\n401 0\n", None, "no value above 0"),
        (packed.as_str(), None, "packed"),
        ("##TITLE=x\n##XYDATA=(X++(Y..Y))\n1 2 3\n##END=\n", None, "FIRSTX"),
        ("##TITLE=x\n##XUNITS=eV\n##XYPOINTS=(XY..XY)\n1 2\n##END=\n", None, "XUNITS"),
        ("##TITLE=x\n##END=\n", None, "neither XYDATA"),
    ] {
        let message = read_as(text, column).unwrap_err().to_string();
        assert!(message.contains(expected) && message.starts_with("r.txt: "), "{text}: {message}");
    }
}
