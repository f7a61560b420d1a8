//! TIFF scans: tells the dialects apart, chooses the page, and collects what its tags say.

use super::config::ReadConfig;
use super::directory::{Directory, TiffFile};
use super::refusal::{Parsed, Refusal};
use super::stored::{Line, RawScan, Stored};
use super::tiff_pixels::{self, Content, Page};
use super::{free_text, imagej, jpk, ome, park};

/// Reads any TIFF.
pub(super) fn read(bytes: &[u8], config: &ReadConfig) -> Parsed<RawScan> {
    let directories = TiffFile::new(bytes).directories()?;
    if park::is_park(&directories[0])? {
        park::read(&directories[0], config)
    } else if jpk::is_jpk(&directories) {
        jpk::read(&directories, config)
    } else {
        read_plain(&directories, config)
    }
}

/// A TIFF whose pixels are the scan and whose calibration, if any, is in standard tags.
fn read_plain(directories: &[Directory], config: &ReadConfig) -> Parsed<RawScan> {
    let pages = directories.iter().map(Page::new).collect::<Parsed<Vec<_>>>()?;
    let page = choose(&pages, config.page)?;
    let directory = &directories[page];
    let mut warnings = Vec::new();
    let mut stored = tiff_pixels::decode(directory, config.max_samples)?;
    orient(&mut stored, &pages[page], &mut warnings)?;
    if pages[page].photometric == 0 {
        warnings.push(
            "the file is to be shown with 0 as white (WhiteIsZero); heights are its numbers as \
             stored, not inverted"
                .to_owned(),
        );
    }

    // ImageJ and OME describe the whole file on its first page.
    let first_description = directories[0].text(270)?.unwrap_or_default();
    let own_description = directory.text(270)?.unwrap_or_default();
    let no_data = no_data(directory)?;
    let mut scan = RawScan {
        format: "TIFF",
        page,
        channel: None,
        stored,
        no_data,
        numbers: Line::IDENTITY,
        unit_nm: Err("no tag gives a height unit".to_owned()),
        pitch_nm: Err("no tag gives a pixel size".to_owned()),
        warnings,
    };
    if let Some(description) = imagej::parse(&first_description) {
        imagej::check_stack(&description, directories.len(), config.page)?;
        imagej::apply(&mut scan, &description, &directories[0])?;
    } else if ome::is_ome(&first_description) {
        ome::apply(&mut scan, &first_description)?;
    } else {
        free_text::apply(&mut scan, &own_description, directory)?;
    }
    Ok(scan)
}

/// The page to read: the one asked for, or the only one that can be meant.
fn choose(pages: &[Page], asked: Option<usize>) -> Parsed<usize> {
    let list = || {
        let shown = pages.iter().enumerate().take(20);
        let mut lines =
            shown.map(|(index, page)| format!("page {index}: {}", page.summary())).collect::<Vec<_>>().join("; ");
        if pages.len() > 20 {
            lines += &format!("; ... {} pages in all", pages.len());
        }
        lines
    };
    if let Some(page) = asked {
        return if page < pages.len() {
            Ok(page)
        } else {
            Err(Refusal::new(
                format!("there is no page {page}, counted from 0 ({})", list()),
                "set `page` to one of these",
            ))
        };
    }
    let is_scan = |page: &Page| matches!(page.content, Content::Grey(_) | Content::OddGrey { .. }) && !page.preview;
    let area = |page: &Page| page.size[0].saturating_mul(page.size[1]);
    let Some(largest) = pages.iter().filter(|page| is_scan(page)).max_by_key(|page| area(page)) else {
        // Nothing grey: the first page's own refusal explains best.
        return Ok(0);
    };
    // Thumbnails that do not say so are smaller than half the scan.
    let full_size = |page: &Page| (0..2).all(|axis| page.size[axis].saturating_mul(2) >= largest.size[axis]);
    let candidates: Vec<_> =
        (0..pages.len()).filter(|&index| is_scan(&pages[index]) && full_size(&pages[index])).collect();
    match candidates[..] {
        [only] => Ok(only),
        _ => Err(Refusal::new(
            format!("the file has several pages that may be the scan ({})", list()),
            format!("add `page = {}` or another, counted from 0, to say which one", candidates[0]),
        )),
    }
}

/// Puts row 0 at the top and column 0 at the left, as the orientation tag asks.
fn orient(stored: &mut Stored, page: &Page, warnings: &mut Vec<String>) -> Parsed<()> {
    let orientation = page.orientation;
    let (rows, columns) = match orientation {
        1 => return Ok(()),
        2 => (false, true),
        3 => (true, true),
        4 => (true, false),
        _ => {
            return Err(Refusal::new(
                format!("the file is to be shown turned (orientation {orientation})"),
                "save it upright",
            ));
        }
    };
    if rows {
        stored.flip_rows();
    }
    if columns {
        stored.flip_columns();
    }
    warnings.push(format!("mirrored, as its orientation tag ({orientation}) asks"));
    Ok(())
}

/// GDAL's no-data value, tag 42113.
fn no_data(directory: &Directory) -> Parsed<Option<f64>> {
    let Some(text) = directory.text(42113)? else {
        return Ok(None);
    };
    match text.trim().parse() {
        Ok(value) => Ok(Some(value)),
        Err(_) => Err(Refusal::damaged(format!(
            "its no-data value (tag 42113) is {:?}, not a number",
            text.chars().take(40).collect::<String>()
        ))),
    }
}
