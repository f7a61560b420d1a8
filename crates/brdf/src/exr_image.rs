//! RGB images in OpenEXR files: the container of tables and of rendered pictures.
//!
//! Row 0 is the first scan line (the top), channel 0 is R. The numbers are data, not colours to be managed: the header
//! carries `colorInteropID = "data"` and neither chromaticities nor a white luminance. The same image and attributes
//! give the same bytes everywhere.

use std::io::Cursor;
use std::path::Path;

use exr::image::write::WritableImage;
use exr::prelude::{
    AttributeValue, Blocks, Compression, Encoding, Image, IntegerBounds, IntoSample, Layer, LayerAttributes, LineOrder,
    ReadChannels, ReadLayers, SpecificChannels, Text, Vec2,
};
use half::f16;
use ndarray::Array3;
use serde_json::Value;

use crate::error::{Error, Result};
use crate::exr_header;
pub use crate::exr_header::{Layout, Precision};
use crate::files;
use crate::json;

/// Name of the string attribute that holds all attributes as one JSON text.
const JSON_ATTRIBUTE: &str = "diffractionAtlas";
/// Prefix of the attributes that repeat the single strings and numbers for tools that list headers.
const PREFIX: &str = "atlas:";
/// Longest name that every version of OpenEXR reads.
const NAME_BYTES_MAX: usize = 31;

/// Writes an image of shape `[rows, columns, 3]` as a whole (beside, then renamed).
///
/// `attributes` is a JSON object. It is stored as text in the attribute `diffractionAtlas`; its strings, integers and other numbers
/// stand again under the prefix `atlas:` as `string`, `int` and `float`.
/// Values that the number format cannot hold are an error: nothing is clipped in silence.
pub fn write_rgb(path: &Path, image: &Array3<f32>, precision: Precision, attributes: &Value) -> Result<()> {
    write_window(path, image, Place::whole(image), precision, attributes)
}

/// As [`write_rgb`] for an image that is a window of a larger one: the header's data window is `place`, its display window
/// the larger image.
pub fn write_window(
    path: &Path,
    image: &Array3<f32>,
    place: Place,
    precision: Precision,
    attributes: &Value,
) -> Result<()> {
    check_values(path, image, precision)?;
    files::replace(path, &encode(path, image, place, precision, attributes)?)
}

/// Where an image lies in a larger one; both in rows and columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// Row and column of the larger image at which it begins.
    pub first: [usize; 2],
    /// Rows and columns of the larger image.
    pub whole: [usize; 2],
}

impl Place {
    /// An image by itself.
    pub fn whole(image: &Array3<f32>) -> Self {
        let (rows, columns, _) = image.dim();
        Self { first: [0; 2], whole: [rows, columns] }
    }
}

/// Reads an image that [`write_rgb`] wrote, and its attributes. What the file states is checked against its bytes first,
/// so a hostile file cannot ask for more memory than 1032 times its size or 2 GiB.
pub fn read_rgb(path: &Path) -> Result<(Array3<f32>, Value)> {
    let bytes = files::read(path)?;
    decode(&bytes).map_err(|what| bad(path, what))
}

/// Checks that the file is complete and readable as far as its header and the places of its blocks tell.
pub fn check_file(path: &Path) -> Result<Layout> {
    let bytes = files::read(path)?;
    let layout = exr_header::check(&bytes).map_err(|what| bad(path, what))?;
    read_attributes(&bytes).map_err(|what| bad(path, what))?;
    Ok(layout)
}

fn bad(path: &Path, what: String) -> Error {
    Error::bad_file(path, what, "Restore the file, or run the pipeline again to publish a new version of the atlas.")
}

fn check_values(path: &Path, image: &Array3<f32>, precision: Precision) -> Result<()> {
    assert!(image.dim().2 == 3 && !image.is_empty(), "an image has three channels and at least one pixel");
    let holds = |value: f32| match precision {
        Precision::Half => f16::from_f32(value).is_finite(),
        Precision::Float => value.is_finite(),
    };
    let lost = image.iter().filter(|&&value| !holds(value)).count();
    if lost == 0 {
        return Ok(());
    }
    let bits = 8 * precision.bytes();
    Err(Error::limit(
        format!("{}: {lost} values are not finite as {bits}-bit floats", path.display()),
        "Store as \"float\" where the values are finite; otherwise look for extreme settings of this specimen.",
    ))
}

fn encode(path: &Path, image: &Array3<f32>, place: Place, precision: Precision, attributes: &Value) -> Result<Vec<u8>> {
    let (rows, columns, _) = image.dim();
    let [[row, column], [all_rows, all_columns]] = [place.first, place.whole];
    assert!(row + rows <= all_rows && column + columns <= all_columns, "a window lies within its image");
    let at = |x: usize, y: usize| [image[[y, x, 0]], image[[y, x, 1]], image[[y, x, 2]]];
    let encoded = match precision {
        Precision::Half => encode_as(image, place, attributes, |x, y| at(x, y).map(f16::from_f32).into()),
        Precision::Float => encode_as(image, place, attributes, |x, y| at(x, y).into()),
    };
    let mut bytes = encoded.map_err(|e| {
        Error::limit(format!("{}: the image cannot be encoded: {e}", path.display()), "Choose a smaller size.")
    })?;
    exr_header::sort_attributes(&mut bytes).expect("the encoder writes a header that can be parsed");
    Ok(bytes)
}

/// Encodes on the calling thread: callers write many images in parallel, and a pool per file would be wasteful.
fn encode_as<Sample: IntoSample>(
    image: &Array3<f32>,
    place: Place,
    attributes: &Value,
    pixel: impl Sync + Fn(usize, usize) -> (Sample, Sample, Sample),
) -> exr::error::Result<Vec<u8>> {
    let (height, width, _) = image.dim();
    let encoding =
        Encoding { compression: Compression::ZIP16, blocks: Blocks::ScanLines, line_order: LineOrder::Increasing };
    // Sides are far below 2^31.
    let vector = |[rows, columns]: [usize; 2]| Vec2(columns as i32, rows as i32);
    let layer = Layer::new(
        (width, height),
        LayerAttributes {
            layer_position: vector(place.first),
            other: header_attributes(attributes).collect(),
            ..LayerAttributes::default()
        },
        encoding,
        SpecificChannels::rgb(|Vec2(x, y)| pixel(x, y)),
    );
    let [rows, columns] = place.whole;
    let mut image = Image::from_layer(layer);
    image.attributes.display_window = IntegerBounds::new((0, 0), (columns, rows));
    let mut bytes = Vec::new();
    image.write().non_parallel().to_buffered(Cursor::new(&mut bytes))?;
    Ok(bytes)
}

fn header_attributes(attributes: &Value) -> impl Iterator<Item = (Text, AttributeValue)> {
    let object = attributes.as_object().expect("the attributes of an image are a JSON object");
    let text = |text: &str| AttributeValue::Text(Text::from_slice_unchecked(text.as_bytes()));
    let fixed = [
        (Text::from("colorInteropID"), text("data")),
        (Text::from(JSON_ATTRIBUTE), text(&json::canonical(attributes))),
    ];
    let single = object.iter().filter_map(move |(key, value)| {
        let value = match value {
            Value::String(string) if !string.is_empty() => text(string),
            Value::Number(number) => match number.as_i64().and_then(|integer| i32::try_from(integer).ok()) {
                Some(integer) => AttributeValue::I32(integer),
                None => AttributeValue::F32(number.as_f64()? as f32),
            },
            _ => return None,
        };
        let name = format!("{PREFIX}{key}");
        (name.len() <= NAME_BYTES_MAX).then(|| (Text::from_slice_unchecked(name.as_bytes()), value))
    });
    fixed.into_iter().chain(single)
}

fn decode(bytes: &[u8]) -> std::result::Result<(Array3<f32>, Value), String> {
    let layout = exr_header::check(bytes)?;
    let attributes = read_attributes(bytes)?;
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |_, _| Array3::<f32>::zeros((layout.height, layout.width, 3)),
            |image, Vec2(x, y), (r, g, b): (f32, f32, f32)| {
                image[[y, x, 0]] = r;
                image[[y, x, 1]] = g;
                image[[y, x, 2]] = b;
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))
        .map_err(|e| format!("its pixels cannot be decoded: {e}"))?;
    Ok((image.layer_data.channel_data.pixels, attributes))
}

fn read_attributes(bytes: &[u8]) -> std::result::Result<Value, String> {
    let (attributes, _) = exr_header::attributes(bytes)?;
    let text = exr_header::find(&attributes, JSON_ATTRIBUTE, "string")?;
    serde_json::from_slice(text).map_err(|e| format!("its attribute `{JSON_ATTRIBUTE}` is not JSON: {e}"))
}

#[cfg(test)]
#[path = "exr_image_tests.rs"]
mod tests;
