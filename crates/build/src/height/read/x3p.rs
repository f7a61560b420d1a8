//! X3P files of ISO 25178-72 (formerly ISO 5436-2): a zip archive with `main.xml` and the samples.

use roxmltree::{Document, Node, ParsingOptions};

use super::archive::Archive;
use super::binary::Binary;
use super::config::ReadConfig;
use super::refusal::{Parsed, Refusal};
use super::stored::{Line, RawScan, SampleKind, Sourced, Stored};
use super::text;
use super::tiff_pixels::checked_size;

/// The member that makes an archive an X3P file.
pub(super) const MAIN: &str = "main.xml";
/// Longest `main.xml` and most elements and texts in it: a million samples stand in there at most, more than any program writes.
const MAIN_BYTES: u64 = 64 << 20;
const NODES_MAX: u32 = 4_000_000;
/// Metres, the only unit of the standard, in nm.
const METRE_NM: f64 = 1e9;

/// Reads the surface.
pub(super) fn read(archive: &Archive, config: &ReadConfig) -> Parsed<RawScan> {
    if config.page.is_some_and(|page| page > 0) {
        return Err(Refusal::new("an X3P file holds one surface (page 0)", "leave the page out"));
    }
    let main = archive.read(MAIN, MAIN_BYTES)?;
    let main = text::decode(&main);
    let document = Document::parse_with_options(
        main.trim(),
        ParsingOptions { nodes_limit: NODES_MAX, ..ParsingOptions::default() },
    )
    .map_err(|error| Refusal::damaged(format!("its main.xml is not XML: {error}")))?;
    let find = |path: &[&str]| path.iter().try_fold(document.root_element(), |node, name| child(node, name));
    let words = |path: &[&str]| find(path).and_then(|node| node.text()).map_or("", str::trim);
    check_kind(&words)?;
    let side = |name: &str| {
        let text = words(&["Record3", "MatrixDimension", name]);
        let side = text.parse::<u64>().ok().filter(|&side| side > 0);
        side.ok_or_else(|| Refusal::damaged(format!("its {name} is {text:?}, not a number of samples")))
    };
    if side("SizeZ")? != 1 {
        return Err(Refusal::new("this X3P file holds several layers", "export one surface alone"));
    }
    let size = checked_size([side("SizeX")?, side("SizeY")?], config.max_samples)?;
    let kind = match words(&["Record1", "Axes", "CZ", "DataType"]) {
        "I" => SampleKind::I16,
        "L" => SampleKind::I32,
        "F" => SampleKind::F32,
        "D" => SampleKind::F64,
        other => return Err(Refusal::damaged(format!("its samples are of the type {other:?}, not I, L, F or D"))),
    };
    let samples = u64::from(size[0]) * u64::from(size[1]);
    let mut values = match words(&["Record3", "DataLink", "PointDataLink"]) {
        "" => listed(find(&["Record3", "DataList"]), samples)?,
        link => {
            let data = archive.read(link, samples * kind.bytes() as u64)?;
            Binary::little(&data).samples(0, size, kind)?
        }
    };
    match words(&["Record3", "DataLink", "ValidPointsLink"]) {
        "" => {}
        link => mask(&mut values, &archive.read(link, samples.div_ceil(8))?)?,
    }
    let number = |path: &[&str], default: f64| match words(path) {
        "" => Some(default),
        text => text.parse::<f64>().ok(),
    };
    let scale = number(&["Record1", "Axes", "CZ", "Increment"], 1.0);
    let offset = number(&["Record1", "Axes", "CZ", "Offset"], 0.0);
    let line = scale.zip(offset).filter(|(scale, offset)| scale.is_finite() && *scale != 0.0 && offset.is_finite());
    let pitch =
        ["CX", "CY"].map(|axis| number(&["Record1", "Axes", axis, "Increment"], f64::NAN).unwrap_or(f64::NAN).abs());
    Ok(RawScan {
        numbers: line.map_or(Line::IDENTITY, |(scale, offset)| Line { scale, offset }),
        unit_nm: match line {
            Some(_) => Ok(Sourced::new(METRE_NM, "X3P axes")),
            None => Err("its X3P height axis has no usable increment and offset".to_owned()),
        },
        pitch_nm: if pitch.iter().all(|pitch| *pitch > 0.0) {
            Ok(Sourced::new(pitch.map(|pitch| pitch * METRE_NM), "X3P axes"))
        } else {
            Err("its X3P axes have no increments".to_owned())
        },
        ..RawScan::of("X3P", Stored::of(size, kind, values))
    })
}

/// A child element by its local name.
fn child<'a, 'input>(node: Node<'a, 'input>, name: &str) -> Option<Node<'a, 'input>> {
    node.children().find(|child| child.is_element() && child.tag_name().name() == name)
}

/// Refuses profiles, point clouds and axes without a constant step.
fn check_kind<'w>(words: &impl Fn(&[&str]) -> &'w str) -> Parsed<()> {
    let feature = words(&["Record1", "FeatureType"]);
    let steps = ["CX", "CY"].map(|axis| words(&["Record1", "Axes", axis, "AxisType"]));
    if !matches!(feature, "SUR" | "") || steps != ["I", "I"] {
        return Err(Refusal::new(
            format!("this X3P file holds {feature:?} with axes {steps:?}, not a surface (SUR) on a regular grid (I)"),
            "export the height map on a regular grid",
        ));
    }
    Ok(())
}

/// Samples that stand in the XML itself: the third of three coordinates, or the only number; empty where there is none.
fn listed(list: Option<Node>, samples: u64) -> Parsed<Vec<f64>> {
    let list = list.ok_or_else(|| Refusal::damaged("its main.xml has neither samples nor a link to them"))?;
    let datum = |node: Node| {
        let text = node.text().unwrap_or("").trim();
        match text.rsplit(';').next().map(str::trim) {
            None | Some("") => Ok(f64::NAN),
            Some(number) => {
                number.parse().map_err(|_| Refusal::damaged(format!("a datum of its main.xml is {text:?}")))
            }
        }
    };
    let values = list.children().filter(Node::is_element).map(datum).collect::<Parsed<Vec<f64>>>()?;
    if values.len() as u64 == samples {
        Ok(values)
    } else {
        Err(Refusal::damaged(format!("its main.xml lists {} samples of {samples}", values.len())))
    }
}

/// Makes NaN of samples whose bit is 0, lowest bit first.
fn mask(values: &mut [f64], bits: &[u8]) -> Parsed<()> {
    if bits.len() < values.len().div_ceil(8) {
        return Err(Refusal::damaged("its mask of valid points is cut short"));
    }
    for (index, value) in values.iter_mut().enumerate() {
        if (bits[index / 8] >> (index % 8)) & 1 == 0 {
            *value = f64::NAN;
        }
    }
    Ok(())
}
