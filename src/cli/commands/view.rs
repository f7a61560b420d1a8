//! `view`: an atlas in the browser, from a server on this machine.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use crate::cli::commands::list;
use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::cli::terminal;
use crate::error::Result;
use crate::stages::viewer::content::Content;
use crate::stages::viewer::server::Loopback;
use diffraction_brdf::error::{self, Error};

/// How long answers under way are waited for at the end.
const GRACE: Duration = Duration::from_secs(1);

/// Folder of atlases where none is named.
const ATLASES: &str = "out/atlas";

/// Arguments of `view`.
#[derive(Debug, Clone, PartialEq, Eq, clap::Args)]
#[command(
    after_help = "Serves the page and the atlas's files on 127.0.0.1, to programs of this machine alone, until Ctrl-C.\n\n\
                  Example:\n  diffraction-atlas view out/atlas/squamates --port 8080"
)]
pub(crate) struct ViewArgs {
    /// An atlas, or one version of it [default: the one in out/atlas]
    pub atlas: Option<PathBuf>,
    /// Port to serve on [default: one that is free]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub port: Option<u16>,
    /// Do not open the browser
    #[arg(long)]
    pub no_open: bool,
}

/// Serves until Ctrl-C.
///
/// # Errors
/// A folder that is no atlas, a damaged version, or a port that cannot be had.
pub(crate) fn run(args: &ViewArgs, global: &Global) -> Result<Outcome> {
    let atlas = args.atlas.clone().map_or_else(|| only_atlas(Path::new(ATLASES)), Ok)?;
    let folder = output::version_folder(&atlas)?;
    let content = Content::open(&folder, &[])?;
    let server = Arc::new(Loopback::bind(args.port)?);
    let stopped = Arc::clone(&server);
    let on_signal = move || {
        stopped.stop();
        // An answer that nobody takes keeps its thread; it is not waited for.
        thread::sleep(GRACE);
        std::process::exit(0);
    };
    ctrlc::set_handler(on_signal)
        .map_err(|error| Error::limit(format!("Ctrl-C cannot be caught: {error}"), "start the program anew"))?;
    output::print(&format!("{}\n", server.url()))?;
    if !global.quiet {
        terminal::say(&format!("{} from {}; Ctrl-C ends it\n", content.name(), folder.display()));
    }
    if !args.no_open {
        open_browser(server.url());
    }
    server.run(&content);
    Ok(Outcome::Done)
}

/// The one atlas in a folder of atlases.
fn only_atlas(folder: &Path) -> error::Result<PathBuf> {
    let atlases = if folder.is_dir() { list::list(folder)? } else { Vec::new() };
    match atlases.as_slice() {
        [one] => Ok(folder.join(&one.name)),
        [] => Err(Error::Call(format!("there is no atlas in {}; name one, or make one with `run`", folder.display()))),
        several => {
            let names: Vec<&str> = several.iter().map(|atlas| atlas.name.as_str()).collect();
            Err(Error::Call(format!("name one of the atlases in {}: {}", folder.display(), names.join(", "))))
        }
    }
}

/// Opens the address beside the server; where there is no browser, says so.
fn open_browser(url: String) {
    thread::spawn(move || {
        if let Err(error) = open::that_detached(&url) {
            terminal::say(&format!("no browser could be opened ({error}): open {url}\n"));
        }
    });
}
