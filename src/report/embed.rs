//! Pictures inside the page: PNG files as data URIs.

use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD as BASE64;
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};

use crate::report::svg::escape;
use diffraction_brdf::error::{Error, Result};

/// Bytes of PNG that one page holds; beyond it pictures are linked, so that the report of a
/// thousand specimens still opens.
pub(crate) const EMBEDDED_MAX_BYTES: usize = 96 << 20;

/// A picture ready for the page.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Picture {
    /// A data URI, or the relative path where the page was full.
    pub href: String,
    /// Size in pixels.
    pub size_px: [u32; 2],
}

/// The pictures of one page, embedded in the order they are asked for.
pub(crate) struct Album<'a> {
    source: &'a dyn Fn(&str) -> Option<Vec<u8>>,
    /// The way from the page to the folder that paths start from.
    up: &'static str,
    room_bytes: usize,
    /// How many pictures found no room and are linked.
    pub linked: usize,
}

impl<'a> Album<'a> {
    /// An album that asks `source` for the bytes of a path and embeds up to `room_bytes` of them.
    pub fn new(source: &'a dyn Fn(&str) -> Option<Vec<u8>>, room_bytes: usize) -> Self {
        Self { source, up: "./", room_bytes, linked: 0 }
    }

    /// An album of a page in a folder below; all its pictures are linked.
    pub fn of_page_below(source: &'a dyn Fn(&str) -> Option<Vec<u8>>) -> Self {
        Self { up: "../", ..Self::new(source, 0) }
    }

    /// The picture at `path`; `None` where the source has none. Fails on bytes that are no PNG.
    pub fn picture(&mut self, path: &str) -> Result<Option<Picture>> {
        let Some(bytes) = (self.source)(path) else {
            return Ok(None);
        };
        let size_px = png_size(&bytes).ok_or_else(|| {
            Error::bad_file(
                Path::new(path),
                "is not a PNG picture and cannot go into the report",
                "run the atlas again; if it comes back, report it as a bug",
            )
        })?;
        let href = if bytes.len() <= self.room_bytes {
            self.room_bytes -= bytes.len();
            data_uri(&bytes)
        } else {
            self.linked += 1;
            self.url(path)
        };
        Ok(Some(Picture { href, size_px }))
    }

    /// An `img` element for the picture, or a note that it is missing.
    pub fn img(&mut self, path: &str, alt: &str) -> Result<String> {
        Ok(match self.picture(path)? {
            Some(Picture { href, size_px }) => format!(
                r#"<img src="{}" width="{}" height="{}" alt="{}"{}/>"#,
                escape(&href),
                size_px[0],
                size_px[1],
                escape(alt),
                // What lies beside the page is read when it comes into view.
                if href.starts_with("data:") { "" } else { r#" loading="lazy""# }
            ),
            None => missing(path),
        })
    }

    /// A path as a URL from the page; it begins with a dot, so that no name can be taken for a scheme.
    fn url(&self, path: &str) -> String {
        format!("{}{}", self.up, utf8_percent_encode(path, PLAIN))
    }

    /// [`Self::img`] as a link to the picture's own file, which lies beside the page.
    pub fn linked_img(&mut self, path: &str, alt: &str) -> Result<String> {
        let img = self.img(path, alt)?;
        Ok(if img.starts_with("<img") { format!(r#"<a href="{}">{img}</a>"#, escape(&self.url(path))) } else { img })
    }
}

/// What stands in the place of a picture that is not there.
pub fn missing(path: &str) -> String {
    format!(r#"<div class="gone">picture missing: {}</div>"#, escape(path))
}

/// Width and height from the header of a PNG file; `None` for anything else.
fn png_size(bytes: &[u8]) -> Option<[u32; 2]> {
    let rest = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n\x00\x00\x00\x0dIHDR")?;
    let number = |at: usize| Some(u32::from_be_bytes(rest.get(at..at + 4)?.try_into().ok()?));
    let size = [number(0)?, number(4)?];
    (size[0] > 0 && size[1] > 0).then_some(size)
}

/// The bytes of a PNG file as an address.
pub(crate) fn data_uri(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", BASE64.encode(png))
}

/// What stays as it is in the path of a URL.
const PLAIN: &AsciiSet = &NON_ALPHANUMERIC.remove(b'/').remove(b'.').remove(b'_').remove(b'-').remove(b'~');

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_render::render::png_image::encode_png;

    fn png() -> Vec<u8> {
        encode_png(&ndarray::Array3::zeros((4, 6, 3))).unwrap()
    }

    #[test]
    fn a_full_album_links_and_counts() {
        let source = |_: &str| Some(png());
        let mut album = Album::new(&source, png().len());
        let first = album.picture("a/b.png").unwrap().unwrap();
        assert!(first.href.starts_with("data:image/png;base64,iVBORw0KGgo"));
        assert_eq!(first.size_px, [6, 4]);
        let second = album.picture("javascript:a b/<\"ü.png").unwrap().unwrap();
        assert_eq!(second.href, "./javascript%3Aa%20b/%3C%22%C3%BC.png");
        assert_eq!(album.linked, 1);
    }

    #[test]
    fn what_is_no_png_is_an_error_and_what_is_missing_is_said() {
        let source = |path: &str| (path == "x").then(|| b"<svg/>".to_vec());
        let mut album = Album::new(&source, 1000);
        assert!(album.picture("x").is_err());
        assert!(album.img("<y>", "").unwrap().contains("missing: &lt;y&gt;"));
        let mut cut = png();
        cut.truncate(20);
        assert_eq!(png_size(&cut), None);
    }
}
