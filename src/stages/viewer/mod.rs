//! The viewer: the page that shows an atlas in a browser, served on this machine or written as files.

pub(crate) mod content;
pub(crate) mod halves;
pub(crate) mod page;
pub(crate) mod server;
pub(crate) mod single_file;
mod text;
pub(crate) mod written;
