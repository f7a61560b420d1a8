//! The server on loopback: the page, the files of one version, and nothing else.
//!
//! A path is looked up among the names that are served, never put together with a folder; so there is none that climbs out.
//! Other pages in the same browser may send requests here: a `Host` that is not this server's is refused, so that no name that
//! was pointed at loopback can read what is served.

use std::io::{self, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use percent_encoding::percent_decode_str;

use crate::stages::viewer::content::Content;
use crate::stages::viewer::page;
use diffraction_brdf::error::{Error, Result};

/// Connections at a time; each has a thread, so that a silent one keeps nobody waiting.
const CONNECTIONS_MAX: usize = 256;
/// How long a request may take to arrive, and an answer to be taken.
const PATIENCE: Duration = Duration::from_secs(10);
/// Most bytes of a request without a body.
const REQUEST_MAX: usize = 16 << 10;
/// Most headers of a request.
const HEADERS_MAX: usize = 64;

/// What the page may do: its own files, pictures and data that it makes itself, nothing from elsewhere.
const PAGE_POLICY: &str = "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; \
    img-src 'self' data: blob:; connect-src 'self' data: blob:; media-src 'self' blob:; worker-src 'self' blob:; \
    object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
/// What a report may do: it holds its looks and pictures itself.
const REPORT_POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src 'self' data:; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// A server that has its port and answers once it runs.
pub(crate) struct Loopback {
    listener: TcpListener,
    port: u16,
    stopped: AtomicBool,
}

impl Loopback {
    /// Takes a port of 127.0.0.1; any that is free for `None`.
    ///
    /// # Errors
    /// [`Error::Call`] for a port that is taken or not allowed.
    pub(crate) fn bind(port: Option<u16>) -> Result<Self> {
        let asked = port.unwrap_or(0);
        let refused = |error: io::Error| {
            let reason = match error.kind() {
                io::ErrorKind::AddrInUse => "it is in use".to_owned(),
                io::ErrorKind::PermissionDenied => "this user may not take it".to_owned(),
                _ => error.to_string(),
            };
            let advice = "name another with `--port`, or leave it out for one that is free";
            Error::Call(format!("port {asked} of 127.0.0.1 cannot be had: {reason}; {advice}"))
        };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, asked)).map_err(refused)?;
        let port = listener.local_addr().map_err(refused)?.port();
        Ok(Self { listener, port, stopped: AtomicBool::new(false) })
    }

    /// Address of the page.
    pub(crate) fn url(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Ends [`Self::run`], from any thread.
    pub(crate) fn stop(&self) {
        self.stopped.store(true, Ordering::SeqCst);
        // Wakes the one that waits for a connection.
        let _ = TcpStream::connect((Ipv4Addr::LOCALHOST, self.port));
    }

    /// Answers until it is stopped.
    pub(crate) fn run(&self, content: &Content) {
        let open = AtomicUsize::new(0);
        thread::scope(|scope| {
            loop {
                let accepted = self.listener.accept();
                if self.stopped.load(Ordering::SeqCst) {
                    return;
                }
                match accepted {
                    Ok((stream, _)) if open.load(Ordering::SeqCst) < CONNECTIONS_MAX => {
                        open.fetch_add(1, Ordering::SeqCst);
                        let open = &open;
                        scope.spawn(move || {
                            // Whoever hung up does not want an answer any more.
                            let _ = converse(stream, self.port, content);
                            open.fetch_sub(1, Ordering::SeqCst);
                        });
                    }
                    Ok(_) => {}
                    // Out of file handles, say: those in use come back.
                    Err(_) => thread::sleep(Duration::from_millis(20)),
                }
            }
        });
    }
}

/// One request and its answer.
fn converse(mut stream: TcpStream, port: u16, content: &Content) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let mut bytes = Vec::new();
    let request = loop {
        let mut part = [0; 2048];
        let count = stream.read(&mut part)?;
        if count == 0 {
            return Ok(());
        }
        bytes.extend_from_slice(&part[..count]);
        match Request::parse(&bytes) {
            Some(parsed) => break parsed,
            None if bytes.len() > REQUEST_MAX => break Err(()),
            None => {}
        }
    };
    let (answer, head_alone) = match &request {
        Ok(request) => (answer(request, port, content), request.method == "HEAD"),
        Err(()) => (Answer::refusal(400, "This is no request that is understood here."), false),
    };
    stream.write_all(answer.head().as_bytes())?;
    if !head_alone {
        stream.write_all(&answer.body)?;
    }
    stream.flush()
}

/// What is read of a request.
struct Request {
    method: String,
    target: String,
    /// Every `Host` that it names.
    hosts: Vec<String>,
}

impl Request {
    /// The request that these bytes begin with; `None` where more must come, an error where it is none.
    fn parse(bytes: &[u8]) -> Option<std::result::Result<Self, ()>> {
        let mut headers = [httparse::EMPTY_HEADER; HEADERS_MAX];
        let mut request = httparse::Request::new(&mut headers);
        match request.parse(bytes) {
            Ok(httparse::Status::Partial) => return None,
            Err(_) => return Some(Err(())),
            Ok(httparse::Status::Complete(_)) => {}
        }
        let hosts = request.headers.iter().filter(|header| header.name.eq_ignore_ascii_case("host"));
        Some(Ok(Self {
            method: request.method.unwrap_or_default().to_owned(),
            target: request.path.unwrap_or_default().to_owned(),
            hosts: hosts.map(|host| String::from_utf8_lossy(host.value).trim().to_owned()).collect(),
        }))
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

    /// Status and headers; the connection ends with the answer.
    fn head(&self) -> String {
        let reason = match self.status {
            200 => "OK",
            400 => "Bad Request",
            404 => "Not Found",
            405 => "Method Not Allowed",
            421 => "Misdirected Request",
            _ => "Internal Server Error",
        };
        let allow = if self.status == 405 { "Allow: GET, HEAD\r\n" } else { "" };
        format!(
            "HTTP/1.1 {} {reason}\r\nContent-Type: {}\r\nContent-Length: {}\r\nContent-Security-Policy: {}\r\n\
             X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n\
             Cross-Origin-Resource-Policy: same-origin\r\nCache-Control: no-store\r\n{allow}Connection: close\r\n\r\n",
            self.status,
            self.content_type,
            self.body.len(),
            self.policy
        )
    }
}

fn answer(request: &Request, port: u16, content: &Content) -> Answer {
    let ours =
        |host: &str| ["127.0.0.1", "localhost"].iter().any(|name| host.eq_ignore_ascii_case(&format!("{name}:{port}")));
    match request.hosts.as_slice() {
        [host] if ours(host) => {}
        _ => return Answer::refusal(421, &format!("This server answers for 127.0.0.1:{port} alone.")),
    }
    if request.method != "GET" && request.method != "HEAD" {
        return Answer::refusal(405, "Only GET and HEAD are answered.");
    }
    match look_up(&request.target, content) {
        Ok(Some((path, body))) => Answer::found(&path, body),
        Ok(None) => Answer::refusal(404, "There is no such file here."),
        Err(error) => Answer::refusal(500, &error.to_string()),
    }
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
