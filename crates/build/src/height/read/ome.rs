//! Calibration in OME-XML: physical pixel sizes; OME has no height unit.

use roxmltree::{Document, Node, ParsingOptions};

use super::refusal::{Parsed, Refusal};
use super::stored::{Found, RawScan, Sourced};
use super::unit::LengthUnit;

/// More elements than any scan needs; bounds the parser's memory.
const NODES_MAX: u32 = 200_000;

/// More attributes than any element has; the parser compares each with all others.
const ATTRIBUTES_MAX: usize = 4096;

/// No fewer than the attributes of any element, by the equals signs between opening brackets, of which values hold none.
fn attributes_bound(text: &str) -> usize {
    text.split('<').map(|piece| piece.bytes().filter(|&byte| byte == b'=').count()).max().unwrap_or(0)
}

/// Whether a description is OME-XML.
pub(super) fn is_ome(description: &str) -> bool {
    let text = description.trim_start();
    text.starts_with('<') && text.contains("<OME")
}

/// Fills in what the OME-XML says of the page.
pub(super) fn apply(scan: &mut RawScan, description: &str) -> Parsed<()> {
    scan.unit_nm = Err("OME-TIFF has no height unit".to_owned());
    let document = parsed(description)?;
    let Some(pixels) = pixels_of(&document, scan.page) else {
        scan.pitch_nm = Err("its OME-XML does not describe this page".to_owned());
        return Ok(());
    };
    scan.pitch_nm = pitch(pixels);
    Ok(())
}

fn parsed(description: &str) -> Parsed<Document<'_>> {
    if attributes_bound(description) > ATTRIBUTES_MAX {
        return Err(Refusal::damaged(format!("its OME-XML has an element with more than {ATTRIBUTES_MAX} attributes")));
    }
    let options = ParsingOptions { nodes_limit: NODES_MAX, ..ParsingOptions::default() };
    Document::parse_with_options(description.trim(), options)
        .map_err(|error| Refusal::damaged(format!("its OME-XML is not XML: {error}")))
}

/// The channel that each of `pages` pages holds, where that is certain: one image, and a page for each of its channels.
pub(super) fn names(description: &str, pages: usize) -> Vec<Option<String>> {
    let none = vec![None; pages];
    let Ok(document) = parsed(description) else { return none };
    let mut all = document.descendants().filter(|node| node.has_tag_name_of("Pixels"));
    let (Some(pixels), None) = (all.next(), all.next()) else { return none };
    let channels = pixels.children().filter(|node| node.has_tag_name_of("Channel"));
    let names: Vec<_> = channels.map(|channel| channel.attribute("Name").map(str::to_owned)).collect();
    if names.len() == pages { names } else { none }
}

/// Compares local names: the namespace differs between OME versions.
trait LocalName {
    fn has_tag_name_of(&self, name: &str) -> bool;
}

impl LocalName for Node<'_, '_> {
    fn has_tag_name_of(&self, name: &str) -> bool {
        self.is_element() && self.tag_name().name() == name
    }
}

/// The `Pixels` element of a page: the only one, or the one whose `TiffData` names the page.
fn pixels_of<'a, 'input>(document: &'a Document<'input>, page: usize) -> Option<Node<'a, 'input>> {
    let mut all = document.descendants().filter(|node| node.has_tag_name_of("Pixels"));
    let first = all.next()?;
    let Some(second) = all.next() else {
        return Some(first);
    };
    let names_page = |pixels: &Node| {
        pixels.children().filter(|node| node.has_tag_name_of("TiffData")).any(|data| {
            let number =
                |name: &str, default: usize| data.attribute(name).map_or(Some(default), |text| text.parse().ok());
            let Some((start, count)) = number("IFD", 0).zip(number("PlaneCount", 1)) else {
                return false;
            };
            page.checked_sub(start).is_some_and(|offset| offset < count)
        })
    };
    [first, second].into_iter().chain(all).find(names_page)
}

fn pitch(pixels: Node) -> Found<[f64; 2]> {
    let side = |size: &str, unit: &str| {
        let length: f64 = pixels
            .attribute(size)
            .ok_or_else(|| format!("its OME-XML has no {size}"))?
            .trim()
            .parse()
            .map_err(|_| format!("its OME-XML's {size} is not a number"))?;
        // The schema's default unit is the micrometre.
        let unit = pixels.attribute(unit).unwrap_or("\u{b5}m");
        let unit =
            LengthUnit::parse(unit).ok_or_else(|| format!("its OME-XML measures {size} in {unit:?}, not a length"))?;
        Ok::<f64, String>(length * unit.to_nm())
    };
    Ok(Sourced::new(
        [side("PhysicalSizeX", "PhysicalSizeXUnit")?, side("PhysicalSizeY", "PhysicalSizeYUnit")?],
        "OME-XML",
    ))
}
