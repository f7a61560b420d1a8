//! The page with everything in one HTML file, which works from the disk.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};

use crate::stages::viewer::content::Content;
use crate::stages::viewer::page;
use crate::stages::viewer::text::encoded;
use diffraction_brdf::error::{Error, Result};

/// Class of the elements that hold the atlas's files, each with its path and its length in bytes.
const FILE_CLASS: &str = "atlas-file";

/// The page with its program, its looks and the atlas's files in it. It may load nothing: its policy allows its own script by
/// digest, and what the script makes.
///
/// # Errors
/// A file of the atlas that is not as it was published.
pub(crate) fn single_file(content: &Content) -> Result<String> {
    let mut data = String::new();
    for path in content.needed() {
        let (path, bytes) = match content.halves(&path)? {
            Some(halves) => (format!("{path}.halves"), halves),
            None => match content.read(&path)? {
                Some(bytes) => (path, bytes),
                None => return Err(Error::Call(format!("{path}: the atlas does not list it"))),
            },
        };
        data += &file_element(&path, &bytes);
    }
    assemble(page::INDEX, page::SCRIPT, page::STYLE, &data)
}

/// A file as an element that nothing runs.
fn file_element(path: &str, bytes: &[u8]) -> String {
    let path = path.replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;");
    let length = bytes.len();
    let text = encoded(bytes);
    format!(
        "<script type=\"text/plain\" class=\"{FILE_CLASS}\" data-path=\"{path}\" data-bytes=\"{length}\">{text}</script>"
    )
}

fn assemble(index: &str, script: &str, style: &str, data: &str) -> Result<String> {
    let script = in_script(script);
    let style = style.replace("</", "<\\/");
    let digest = STANDARD.encode(Sha256::digest(script.as_bytes()));
    let policy = format!(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-{digest}'; \
         style-src 'unsafe-inline'; img-src data: blob:; connect-src data: blob:; media-src blob:; worker-src blob:; \
         base-uri 'none'; form-action 'none'\">"
    );
    let (before, tag, after) = element(index, "<script", "</script>", "viewer.js")?;
    let module = if tag.contains("type=\"module\"") { " type=\"module\"" } else { "" };
    // Where it stood a plain script would run before what follows it; a deferred one runs at the end, as this does.
    let later = tag.contains(" defer") || !module.is_empty();
    let program = format!("{data}<script{module}>{script}</script>");
    let page = if later {
        let rest = [before, after].concat();
        let at = rest.rfind("</body>").ok_or_else(|| unfit("it has no </body>"))?;
        [&rest[..at], &program, &rest[at..]].concat()
    } else {
        [before, &program, after].concat()
    };
    let (before, _, after) = element(&page, "<link", ">", "viewer.css")?;
    let page = format!("{before}<style>{style}</style>{after}");
    let head = page.find("<head>").ok_or_else(|| unfit("it has no <head>"))? + "<head>".len();
    Ok([&page[..head], &policy, &page[head..]].concat())
}

/// Text inside a script element: what would end the element, or open a comment in it, is written so that it means the same.
fn in_script(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('<') {
        let (before, from) = rest.split_at(at);
        out += before;
        let ends = from.get(..8).is_some_and(|start| start.eq_ignore_ascii_case("</script"));
        let (written, taken) = match ends {
            true => ("<\\/", 2),
            false if from.starts_with("<!--") => ("<\\x21", 2),
            false => ("<", 1),
        };
        out += written;
        rest = &from[taken..];
    }
    out + rest
}

/// What comes before an element that refers to a file, the element, and what follows it.
fn element<'a>(page: &'a str, opens: &str, closes: &str, file: &str) -> Result<(&'a str, &'a str, &'a str)> {
    let place = page.find(&format!("{file}\"")).ok_or_else(|| unfit(&format!("it does not refer to {file}")))?;
    let start = page[..place].rfind(opens).ok_or_else(|| unfit(&format!("{file} stands in no {opens}>")))?;
    let end = page[place..].find(closes).ok_or_else(|| unfit(&format!("{opens}> has no end")))? + place + closes.len();
    Ok((&page[..start], &page[start..end], &page[end..]))
}

fn unfit(what: &str) -> Error {
    Error::limit(
        format!("the viewer's page cannot be put into one file: {what}"),
        "this is a bug of the program; please report it with this message",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const INDEX: &str = "<!doctype html><html><head><meta charset=\"utf-8\"><link rel=\"stylesheet\" href=\"./viewer.css\">\
        <script src=\"viewer.js\" defer></script></head><body><p>a</p></body></html>";

    #[test]
    fn nothing_is_referred_to_and_the_data_come_before_the_program() {
        let page = assemble(INDEX, "run()", "p{color:red}", &file_element("a/\"b\".png", b"A")).unwrap();
        assert!(!page.contains("src=") && !page.contains("href="), "{page}");
        let order = [
            "<style>p{color:red}</style>",
            "<p>a</p>",
            "data-path=\"a/&quot;b&quot;.png\" data-bytes=\"1\"> @</script>",
            "<script>run()",
        ];
        let places: Vec<usize> = order.iter().map(|part| page.find(part).expect(part)).collect();
        assert!(places.is_sorted(), "{places:?} in {page}");
        assert!(page.contains(&format!("'sha256-{}'", STANDARD.encode(Sha256::digest(b"run()")))));
    }

    #[test]
    fn what_would_end_the_script_is_written_otherwise() {
        let page = assemble(INDEX, "const a = '</Script><!--<'", "", "").unwrap();
        assert_eq!(page.matches("</script>").count(), 1, "{page}");
        assert!(page.contains(r"'<\/Script><\x21--<'"), "{page}");
    }

    #[test]
    fn a_page_of_another_make_is_refused() {
        let told = assemble("<head></head>", "", "", "{}").unwrap_err().to_string();
        assert!(told.contains("it does not refer to viewer.js"), "{told}");
    }
}
