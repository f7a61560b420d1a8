//! The server on loopback: the page, the files of one version, and nothing else.
//!
//! A path is looked up among the names that are served, never put together with a folder; so there is none that climbs out.
//! Other pages in the same browser may send requests here: a `Host` that is not this server's is refused, so that no name that
//! was pointed at loopback can read what is served.

use std::net::{Ipv4Addr, TcpListener};
use std::thread;

use percent_encoding::percent_decode_str;
use tiny_http::{Header, Method, Request, Response, Server};

use crate::stages::viewer::content::Content;
use crate::stages::viewer::page;
use diffraction_brdf::error::{Error, Result};

/// Answers at a time: as many as browsers ask for at once.
const WORKERS: usize = 6;

/// What the page may do: its own files, pictures and data that it makes itself, nothing from elsewhere.
const PAGE_POLICY: &str = "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; \
    img-src 'self' data: blob:; connect-src 'self' data: blob:; media-src 'self' blob:; worker-src 'self' blob:; \
    object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
/// What a report may do: it holds its looks and pictures itself.
const REPORT_POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src 'self' data:; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// A server that has its port and answers once it runs.
pub(crate) struct Loopback {
    server: Server,
    port: u16,
}

impl Loopback {
    /// Takes a port of 127.0.0.1; any that is free for `None`.
    ///
    /// # Errors
    /// [`Error::Call`] for a port that is taken or not allowed.
    pub(crate) fn bind(port: Option<u16>) -> Result<Self> {
        let asked = port.unwrap_or(0);
        let refused = |error: std::io::Error| {
            let reason = match error.kind() {
                std::io::ErrorKind::AddrInUse => "it is in use".to_owned(),
                std::io::ErrorKind::PermissionDenied => "this user may not take it".to_owned(),
                _ => error.to_string(),
            };
            let advice = "name another with `--port`, or leave it out for one that is free";
            Error::Call(format!("port {asked} of 127.0.0.1 cannot be had: {reason}; {advice}"))
        };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, asked)).map_err(refused)?;
        let port = listener.local_addr().map_err(refused)?.port();
        let server = Server::from_listener(listener, None)
            .map_err(|error| Error::Call(format!("port {port} of 127.0.0.1 cannot be served: {error}")))?;
        Ok(Self { server, port })
    }

    /// Address of the page.
    pub(crate) fn url(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Ends [`Self::run`], from any thread.
    pub(crate) fn stop(&self) {
        for _ in 0..WORKERS {
            self.server.unblock();
        }
    }

    /// Answers until it is stopped.
    pub(crate) fn run(&self, content: &Content) {
        thread::scope(|scope| {
            for _ in 0..WORKERS {
                scope.spawn(|| {
                    while let Ok(request) = self.server.recv() {
                        let answer = answer(&request, self.port, content);
                        // Whoever hung up does not want it any more.
                        let _ = request.respond(answer.response());
                    }
                });
            }
        });
    }
}

/// An answer before it becomes HTTP.
struct Answer {
    status: u16,
    content_type: &'static str,
    policy: &'static str,
    body: Vec<u8>,
}

impl Answer {
    fn found(path: &str, body: Vec<u8>) -> Self {
        let content_type = content_type(path);
        let of_page = page::FILES.iter().any(|(name, _)| *name == path);
        Self { status: 200, content_type, policy: if of_page { PAGE_POLICY } else { REPORT_POLICY }, body }
    }

    /// A refusal in words.
    fn refusal(status: u16, text: &str) -> Self {
        let body = format!("{text}\n").into_bytes();
        Self { status, content_type: content_type(".txt"), policy: REPORT_POLICY, body }
    }

    fn response(self) -> Response<std::io::Cursor<Vec<u8>>> {
        let fixed = [
            ("Content-Type", self.content_type),
            ("Content-Security-Policy", self.policy),
            ("X-Content-Type-Options", "nosniff"),
            ("Referrer-Policy", "no-referrer"),
            ("Cross-Origin-Resource-Policy", "same-origin"),
            ("Cache-Control", "no-store"),
        ];
        let allow = (self.status == 405).then_some(("Allow", "GET, HEAD"));
        // Lengths are known: never in chunks.
        let mut response =
            Response::from_data(self.body).with_status_code(self.status).with_chunked_threshold(usize::MAX);
        for (name, value) in fixed.into_iter().chain(allow) {
            let header = Header::from_bytes(name, value).expect("names and values above are ASCII");
            response.add_header(header);
        }
        response
    }
}

fn answer(request: &Request, port: u16, content: &Content) -> Answer {
    if !is_for_us(request, port) {
        return Answer::refusal(421, &format!("This server answers for 127.0.0.1:{port} alone."));
    }
    if !matches!(request.method(), Method::Get | Method::Head) {
        return Answer::refusal(405, "Only GET and HEAD are answered.");
    }
    match look_up(request.url(), content) {
        Ok(Some((path, body))) => Answer::found(&path, body),
        Ok(None) => Answer::refusal(404, "There is no such file here."),
        Err(error) => Answer::refusal(500, &error.to_string()),
    }
}

/// Whether the request names this server, once.
fn is_for_us(request: &Request, port: u16) -> bool {
    let mut hosts = request.headers().iter().filter(|header| header.field.equiv("Host"));
    let ours =
        |host: &str| ["127.0.0.1", "localhost"].iter().any(|name| host.eq_ignore_ascii_case(&format!("{name}:{port}")));
    hosts.next().is_some_and(|host| ours(host.value.as_str().trim())) && hosts.next().is_none()
}

/// The name and the bytes of what a request's target means; `None` for what is not served.
fn look_up(target: &str, content: &Content) -> Result<Option<(String, Vec<u8>)>> {
    let path = target.split(['?', '#']).next().unwrap_or_default();
    let Some(encoded) = path.strip_prefix('/') else { return Ok(None) };
    let Ok(path) = percent_decode_str(encoded).decode_utf8() else { return Ok(None) };
    let path = if path.is_empty() { page::INDEX_FILE } else { &path };
    if let Some((name, text)) = page::FILES.iter().find(|(name, _)| *name == path) {
        return Ok(Some(((*name).to_owned(), text.as_bytes().to_vec())));
    }
    match path.strip_prefix(page::ATLAS_FOLDER).and_then(|rest| rest.strip_prefix('/')) {
        None => Ok(None),
        Some(below) => Ok(content.read(below)?.map(|bytes| (path.to_owned(), bytes))),
    }
}

/// The type that goes with a file's ending.
fn content_type(path: &str) -> &'static str {
    match path.rsplit_once('.').map_or("", |(_, ending)| ending) {
        "html" => "text/html; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "json" => "application/json",
        "exr" => "image/x-exr",
        "png" => "image/png",
        "md" | "txt" => "text/plain; charset=utf-8",
        "csv" => "text/csv; charset=utf-8",
        _ => "application/octet-stream",
    }
}
