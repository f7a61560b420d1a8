//! The page: three files built from `viewer/`, part of the program.

/// The page itself.
pub(crate) const INDEX: &str = include_str!("../../../viewer/dist/index.html");
/// Its program.
pub(crate) const SCRIPT: &str = include_str!("../../../viewer/dist/viewer.js");
/// Its looks.
pub(crate) const STYLE: &str = include_str!("../../../viewer/dist/viewer.css");

/// Name of the page's file.
pub(crate) const INDEX_FILE: &str = "index.html";
/// The files by their names, which refer to each other.
pub(crate) const FILES: [(&str, &str); 3] = [(INDEX_FILE, INDEX), ("viewer.js", SCRIPT), ("viewer.css", STYLE)];
/// Folder of the atlas's files, beside the page.
pub(crate) const ATLAS_FOLDER: &str = "atlas";

/// What a report says where no viewer lies beside it.
pub(crate) const REPORT_WITHOUT: &str = "To turn it by hand in a browser: <code>diffraction-atlas view</code>.";
/// What it says where one does.
const REPORT_BESIDE: &str = "<a href=\"../index.html\">Turn it by hand in the viewer</a>.";

/// A report as it is beside the viewer: with a link to it in place of the command that would show it.
pub(crate) fn report_beside(report: &str) -> String {
    report.replacen(REPORT_WITHOUT, REPORT_BESIDE, 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_refers_to_its_own_files_and_to_nothing_else() {
        for name in ["viewer.js", "viewer.css"] {
            assert_eq!(INDEX.matches(&format!("{name}\"")).count(), 1, "{name}");
        }
        for elsewhere in ["http://", "https://", "\"//", "\"/"] {
            let found = INDEX.replace("http://www.w3.org/", "").contains(elsewhere);
            assert!(!found, "{elsewhere} in index.html");
        }
    }

    #[test]
    fn a_report_links_to_the_viewer_beside_it() {
        let report = format!("<p>{REPORT_WITHOUT}</p>");
        assert_eq!(report_beside(&report), format!("<p>{REPORT_BESIDE}</p>"));
        assert_eq!(report_beside("<p>older</p>"), "<p>older</p>");
    }
}
