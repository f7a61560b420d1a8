//! TIFF scans: tells the dialects apart, chooses the page, and collects what its tags say.

use super::channels::{self, Channel, Named};
use super::config::ReadConfig;
use super::directory::{Directory, TiffFile};
use super::refusal::{Parsed, Refusal};
use super::stored::{RawScan, Stored};
use super::tiff_pixels::{self, Content, Page, Second};
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
    // ImageJ and OME describe the whole file on its first page. A description that cannot be read is looked at below.
    let first_description = directories[0].text(270).ok().flatten().unwrap_or_default();
    let names = names(directories, &first_description);
    let page = choose(&pages, &names, config)?;
    let directory = &directories[page];
    let mut scan = RawScan::of("TIFF", tiff_pixels::decode(directory, config.max_samples)?);
    scan.page = page;
    scan.channel = names[page].clone();
    orient(&mut scan.stored, &pages[page], &mut scan.warnings)?;
    if pages[page].photometric == 0 {
        scan.warnings.push(
            "the file is to be shown with 0 as white (WhiteIsZero); heights are its numbers as \
             stored, not inverted"
                .to_owned(),
        );
    }
    if pages[page].second == Some(Second::Channel) {
        scan.warnings.push("each pixel holds two numbers, of which the first is read".to_owned());
    }
    scan.no_data = no_data(directory, &mut scan.warnings);
    if let Some(description) = imagej::parse(&first_description) {
        imagej::check_stack(&description, directories.len(), config)?;
        scan.format = "ImageJ TIFF";
        let applied = imagej::apply(&mut scan, &description, &directories[0]);
        keep_going(&mut scan, applied);
    } else if ome::is_ome(&first_description) {
        scan.format = "OME-TIFF";
        let applied = ome::apply(&mut scan, &first_description);
        keep_going(&mut scan, applied);
    } else {
        let applied =
            directory.text(270).and_then(|text| free_text::apply(&mut scan, &text.unwrap_or_default(), directory));
        keep_going(&mut scan, applied);
    }
    Ok(scan)
}

/// Broken metadata are a reason why the calibration is not known; with pitch and height from the caller the scan is as good as any.
fn keep_going(scan: &mut RawScan, applied: Parsed<()>) {
    let Err(refusal) = applied else { return };
    scan.unit_nm = Err(refusal.what.clone());
    if scan.pitch_nm.is_err() {
        scan.pitch_nm = Err(refusal.what.clone());
    }
    scan.warnings.push(format!("its own calibration is broken and not used: {}", refusal.what));
}

/// What the pages are called: by OME, by their page name, or by a description of a few words.
fn names(directories: &[Directory], first_description: &str) -> Vec<Option<String>> {
    const LONGEST: usize = 80;
    let is_name = |text: &str| {
        !text.is_empty() && text.chars().count() <= LONGEST && !text.contains(['\n', '=', '<', '{', '\u{FFFD}'])
    };
    let of_ome = match ome::is_ome(first_description) {
        true => ome::names(first_description, directories.len()),
        false => vec![None; directories.len()],
    };
    let of_page = |(directory, of_ome): (&Directory, Option<String>)| {
        let tag = |tag: u16| directory.text(tag).ok().flatten().map(|text| text.trim().to_owned());
        of_ome.or_else(|| [285, 270].into_iter().filter_map(tag).find(|text| is_name(text)))
    };
    directories.iter().zip(of_ome).map(of_page).collect()
}

/// The page to read: the one asked for, or the only one that can be meant.
fn choose(pages: &[Page], names: &[Option<String>], config: &ReadConfig) -> Parsed<usize> {
    let label = |page: usize| match &names[page] {
        Some(name) => format!("{name}, {}", pages[page].summary()),
        None => pages[page].summary(),
    };
    let labelled: Vec<_> = (0..pages.len()).map(|page| Channel { page, name: label(page), is_length: None }).collect();
    if let Some(page) = config.page.filter(|&page| page >= pages.len()) {
        return Err(Refusal::new(
            format!("there is no page {page}, counted from 0 ({})", channels::list(&labelled)),
            format!("set {} to one of these", config.words.page.replace("{}", "N")),
        ));
    }
    let channel = |page: usize| Channel { page, name: names[page].clone().unwrap_or_default(), is_length: None };
    if config.page.is_some() || config.channel.is_some() {
        let all: Vec<_> = (0..pages.len()).map(channel).collect();
        return channels::choose(&all, config).map(|(page, _)| page);
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
        (0..pages.len()).filter(|&index| is_scan(&pages[index]) && full_size(&pages[index])).map(channel).collect();
    if let [only] = &candidates[..] {
        return Ok(only.page);
    }
    // Names decide where every page has one and just one of them is a height's.
    let is_height = |channel: &&Channel| matches!(channels::named(&channel.name), Named::Height(_));
    let heights: Vec<_> = candidates.iter().filter(is_height).collect();
    match (&heights[..], candidates.iter().all(|channel| channels::named(&channel.name) != Named::Unknown)) {
        ([only], true) => Ok(only.page),
        _ => Err(Refusal::new(
            format!("the file has several pages that may be the scan ({})", channels::list(&labelled)),
            format!("say which one: {}, counted from 0", channels::suggest(&candidates, config)),
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

/// GDAL's no-data value, tag 42113; an empty one is none.
fn no_data(directory: &Directory, warnings: &mut Vec<String>) -> Option<f64> {
    let text = match directory.text(42113) {
        Ok(text) => text?,
        Err(refusal) => {
            warnings.push(refusal.what);
            return None;
        }
    };
    let value = text.trim().parse().ok();
    if value.is_none() && !text.trim().is_empty() {
        warnings.push(format!(
            "its no-data value (tag 42113) is {:?}, not a number, and is not used",
            text.chars().take(40).collect::<String>()
        ));
    }
    value
}
