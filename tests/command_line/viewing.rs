//! `view` and `export --form viewer`: what is served and what is refused, over plain sockets; what is written.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::place::{HEAD, LASERS, Place, ROUGH, WAVE, contents};

const PAGE_FILES: [&str; 3] = ["index.html", "viewer.js", "viewer.css"];

/// An atlas of two specimens.
fn atlas() -> Place {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH, WAVE].concat());
    place
}

/// A file of the page as it lies in the repository.
fn page(name: &str) -> Vec<u8> {
    std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("viewer/dist").join(name)).unwrap()
}

/// A running `view`; ended when dropped.
struct Serving {
    child: Child,
    port: u16,
}

impl Serving {
    fn start(place: &Place, line: &str) -> Self {
        Self::start_with(place, line, |_| {})
    }

    fn start_with(place: &Place, line: &str, change: impl FnOnce(&mut Command)) -> Self {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("diffraction-atlas"));
        command.args(line.split(' ')).current_dir(place.folder()).stdout(Stdio::piped()).stderr(Stdio::piped());
        change(&mut command);
        let mut child = command.spawn().unwrap();
        let mut first = String::new();
        BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut first).unwrap();
        let port = first.trim().strip_prefix("http://127.0.0.1:").and_then(|rest| rest.strip_suffix('/'));
        let port = port.unwrap_or_else(|| panic!("{first:?}")).parse().unwrap();
        Self { child, port }
    }

    /// The answer to a request, written as it is.
    fn raw(&self, request: &str) -> Answer {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        stream.write_all(request.as_bytes()).unwrap();
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).unwrap();
        Answer::parse(&bytes)
    }

    fn ask(&self, method: &str, target: &str) -> Answer {
        let port = self.port;
        self.raw(&format!("{method} {target} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n"))
    }

    fn with_host(&self, host: &str) -> Answer {
        self.raw(&format!("GET / HTTP/1.1\r\n{host}Connection: close\r\n\r\n"))
    }

    /// Ends it as Ctrl-C does; status and what it said on stderr.
    fn interrupt(mut self, signal: &str) -> (Option<i32>, String) {
        let sent = Command::new("kill").args([signal, &self.child.id().to_string()]).status().unwrap();
        assert!(sent.success());
        let mut said = String::new();
        self.child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        (self.child.wait().unwrap().code(), said)
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        // Already ended where the test has seen to it.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

struct Answer {
    status: u16,
    headers: BTreeMap<String, String>,
    body: Vec<u8>,
}

impl Answer {
    fn parse(bytes: &[u8]) -> Self {
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").unwrap_or_else(|| panic!("{bytes:?}"));
        let head = std::str::from_utf8(&bytes[..end]).unwrap();
        let mut lines = head.split("\r\n");
        let status = lines.next().unwrap().split(' ').nth(1).unwrap().parse().unwrap();
        let pair = |line: &str| {
            let (name, value) = line.split_once(':').unwrap();
            (name.to_ascii_lowercase(), value.trim().to_owned())
        };
        Self { status, headers: lines.map(pair).collect(), body: bytes[end + 4..].to_vec() }
    }

    fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }
}

#[test]
fn the_page_and_the_files_of_the_version_are_served_with_their_types() {
    let place = atlas();
    let serving = Serving::start(&place, "view out/small --no-open");
    for (target, name, content_type) in [
        ("/", "index.html", "text/html; charset=utf-8"),
        ("/?a=b", "index.html", "text/html; charset=utf-8"),
        ("/viewer.js", "viewer.js", "text/javascript; charset=utf-8"),
        ("/viewer%2Ecss", "viewer.css", "text/css; charset=utf-8"),
    ] {
        let answer = serving.ask("GET", target);
        assert_eq!((answer.status, answer.headers["content-type"].as_str()), (200, content_type), "{target}");
        assert!(answer.body == page(name), "{target}");
        let policy = &answer.headers["content-security-policy"];
        assert!(policy.contains("default-src 'self'") && !policy.contains("http"), "{policy}");
        assert_eq!(answer.headers["x-content-type-options"], "nosniff");
    }
    let published = contents(&place.path("out/small/v0001"));
    for (path, bytes) in &published {
        let answer = serving.ask("GET", &format!("/atlas/{path}"));
        assert_eq!(answer.status, 200, "{path}");
        assert!(&answer.body == bytes || path == "report.html", "{path}");
        let head = serving.ask("HEAD", &format!("/atlas/{path}"));
        assert_eq!((head.status, head.body.len()), (200, 0), "{path}");
        assert_eq!(head.headers["content-length"], answer.body.len().to_string(), "{path}");
        let content_type = &answer.headers["content-type"];
        assert_eq!(content_type == "image/x-exr", path.ends_with(".exr"), "{path}: {content_type}");
    }
    let told: Value = serde_json::from_slice(&serving.ask("GET", "/atlas/viewer.json").body).unwrap();
    assert_eq!(told["specimens"], serde_json::json!(["rough", "wave"]));
    assert!(published.contains_key(told["heights"]["rough"].as_str().unwrap()), "{told}");

    // The published report names the command; served, it links to the page.
    let report = String::from_utf8(published["report.html"].clone()).unwrap();
    let served = serving.ask("GET", "/atlas/report.html").text();
    assert!(report.contains("<code>diffraction-atlas view</code>") && !report.contains("../index.html"));
    assert!(served.contains("<a href=\"../index.html\">") && !served.contains("diffraction-atlas view"));
}

#[test]
fn nothing_else_is_served() {
    let place = atlas();
    place.write("secret.txt", "secret");
    std::fs::write(place.path("out/small/v0001/rough/unlisted.txt"), "secret").unwrap();
    let serving = Serving::start(&place, "view out/small --no-open");
    for target in [
        "/atlas",
        "/atlas/",
        "/atlas/rough",
        "/atlas/rough/",
        "/atlas/rough/unlisted.txt",
        "/atlas/../latest",
        "/atlas/../../../secret.txt",
        "/../secret.txt",
        "/atlas/%2e%2e/latest",
        "/atlas/%2e%2e%2f%2e%2e%2f%2e%2e%2fsecret.txt",
        "/atlas/..%5c..%5csecret.txt",
        "/atlas/%252e%252e/latest",
        "/atlas/rough/../atlas.json",
        "/atlas/./atlas.json",
        "/atlas//atlas.json",
        "//etc/passwd",
        "/etc/passwd",
        "/atlas/%00atlas.json",
        "/atlas/%ff",
        "/latest",
        "/v0001/atlas.json",
        "etc/passwd",
        "http://127.0.0.1/etc/passwd",
    ] {
        let answer = serving.ask("GET", target);
        assert_eq!(answer.status, 404, "{target}");
        assert!(!answer.text().contains("secret") && !answer.text().contains("root"), "{target}: {}", answer.text());
    }
    for method in ["POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "PROPFIND"] {
        let answer = serving.ask(method, "/");
        assert_eq!((answer.status, answer.headers["allow"].as_str()), (405, "GET, HEAD"), "{method}");
    }
    let port = serving.port;
    for host in [
        String::new(),
        "Host: evil.example\r\n".into(),
        format!("Host: evil.example:{port}\r\n"),
        "Host: 127.0.0.1\r\n".into(),
        format!("Host: 127.0.0.1:{}\r\n", port ^ 1),
        format!("Host: 127.0.0.1.evil.example:{port}\r\n"),
        format!("Host: 127.0.0.1:{port}\r\nHost: evil.example\r\n"),
    ] {
        let answer = serving.with_host(&host);
        assert_eq!(answer.status, 421, "{host}");
        assert!(answer.text().starts_with("This server answers for 127.0.0.1"), "{host}");
    }
    assert_eq!(serving.with_host(&format!("host: LOCALHOST:{port}\r\n")).status, 200);
    // Not on other addresses of this machine.
    assert!(TcpStream::connect(("127.0.0.2", port)).is_err());
    // A client that says nothing, and one that is not HTTP, keep nobody from being answered.
    let connect = |text: &str| {
        let mut stream = TcpStream::connect(("127.0.0.1", port)).unwrap();
        stream.write_all(text.as_bytes()).unwrap();
        stream
    };
    let odd = ["", "hello\r\n\r\n", "GET / HTTP/9.9\r\n\r\n", "GET / HTTP/1.1\r\nnonsense\r\n\r\n", "\u{16}\u{3}\u{1}"];
    let open: Vec<TcpStream> = odd.iter().cycle().take(20).map(|text| connect(text)).collect();
    assert_eq!(serving.ask("GET", "/").status, 200);
    drop(open);
}

#[test]
fn a_file_that_was_changed_since_is_not_served() {
    let place = atlas();
    let serving = Serving::start(&place, "view out/small/v0001 --no-open");
    let path = place.path("out/small/v0001/rough/table.000.exr");
    let mut bytes = std::fs::read(&path).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    std::fs::write(&path, &bytes).unwrap();
    let answer = serving.ask("GET", "/atlas/rough/table.000.exr");
    assert_eq!((answer.status, answer.headers["content-type"].as_str()), (500, "text/plain; charset=utf-8"));
    assert!(answer.text().contains("does not match its digest"), "{}", answer.text());
    assert_eq!(serving.ask("GET", "/atlas/wave/table.000.exr").status, 200);
}

#[test]
fn what_cannot_be_served_is_said() {
    let place = atlas();
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port();
    let refused = place.call(&format!("view out/small --no-open --port {port}")).ended(2);
    assert!(refused.stderr.contains(&format!("port {port} ")) && refused.stderr.contains("in use"), "{refused:?}");
    assert_eq!(refused.stdout, "");
    place.call("view out/small --no-open --port 0").ended(2);

    let refused = place.call("view out/nothing --no-open").ended(2);
    assert!(refused.stderr.contains("there is no such folder"), "{refused:?}");
    std::fs::create_dir(place.path("plain")).unwrap();
    let refused = place.call("view plain --no-open").ended(2);
    assert!(refused.stderr.contains("this is no atlas"), "{refused:?}");

    let version = place.path("out/small/v0001");
    let lobe = version.join("rough/lobe.exr");
    let whole = std::fs::read(&lobe).unwrap();
    std::fs::write(&lobe, &whole[..whole.len() - 1]).unwrap();
    let refused = place.call("view out/small/v0001 --no-open").ended(1);
    assert!(refused.stderr.contains("lobe.exr") && refused.stderr.contains("published were"), "{refused:?}");
    std::fs::write(&lobe, &whole).unwrap();
    std::fs::write(version.join("atlas.json"), "{}").unwrap();
    place.call("view out/small/v0001 --no-open").ended(1);
}

#[cfg(unix)]
#[test]
fn a_link_in_the_atlas_is_refused() {
    let place = atlas();
    place.write("secret.txt", "secret");
    std::os::unix::fs::symlink(place.path("secret.txt"), place.path("out/small/v0001/rough/link.txt")).unwrap();
    let refused = place.call("view out/small --no-open").ended(1);
    assert!(
        refused.stderr.contains("link.txt") && refused.stderr.contains("neither a file nor a folder"),
        "{refused:?}"
    );
    place.call("export out/small --form viewer --out site").ended(1);
    assert!(!place.path("site").exists());
}

#[test]
fn without_a_name_the_only_atlas_is_shown() {
    let place = atlas();
    let refused = place.call("view --no-open").ended(2);
    assert!(refused.stderr.contains("there is no atlas in out/atlas"), "{refused:?}");
    std::fs::create_dir(place.path("out/atlas")).unwrap();
    std::fs::rename(place.path("out/small"), place.path("out/atlas/small")).unwrap();
    let serving = Serving::start(&place, "view --no-open");
    assert_eq!(serving.ask("GET", "/atlas/atlas.json").status, 200);
    drop(serving);
    let copied = place.path("out/atlas/other/v0001");
    std::fs::create_dir_all(&copied).unwrap();
    std::fs::copy(place.path("out/atlas/small/v0001/atlas.json"), copied.join("atlas.json")).unwrap();
    let refused = place.call("view --no-open").ended(2);
    assert!(refused.stderr.contains("name one of the atlases in out/atlas: other, small"), "{refused:?}");
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it_in_good_order_and_a_browser_that_cannot_be_opened_is_only_said() {
    use std::os::unix::fs::PermissionsExt;

    let place = atlas();
    let serving = Serving::start(&place, "view out/small --no-open");
    let idle = TcpStream::connect(("127.0.0.1", serving.port)).unwrap();
    let (status, said) = serving.interrupt("-INT");
    assert_eq!((status, said.as_str()), (Some(0), "small from out/small/v0001; Ctrl-C ends it\n"));
    drop(idle);
    let (status, said) = Serving::start(&place, "--quiet view out/small --no-open").interrupt("-TERM");
    assert_eq!((status, said.as_str()), (Some(0), ""));

    // Programs are looked for in a folder of our own.
    let bin = place.path("bin");
    std::fs::create_dir(&bin).unwrap();
    let serving = Serving::start_with(&place, "--quiet view out/small", |command| _ = command.env("PATH", &bin));
    // Long enough for the attempt on a busy machine.
    std::thread::sleep(Duration::from_secs(3));
    assert_eq!(serving.ask("GET", "/").status, 200);
    let port = serving.port;
    let (status, said) = serving.interrupt("-INT");
    assert_eq!(status, Some(0));
    assert!(said.starts_with("no browser could be opened") && said.contains(&format!("127.0.0.1:{port}/")), "{said}");

    if cfg!(target_os = "linux") {
        let opener = bin.join("xdg-open");
        let opened = place.path("opened.txt");
        std::fs::write(&opener, format!("#!/bin/sh\necho \"$1\" > '{}'\n", opened.display())).unwrap();
        std::fs::set_permissions(&opener, std::fs::Permissions::from_mode(0o755)).unwrap();
        let serving = Serving::start_with(&place, "view out/small", |command| _ = command.env("PATH", &bin));
        let started = Instant::now();
        while std::fs::read_to_string(&opened).unwrap_or_default().is_empty() {
            assert!(started.elapsed() < Duration::from_secs(20), "no browser was asked for");
            std::thread::sleep(Duration::from_millis(20));
        }
        let address = format!("http://127.0.0.1:{}/\n", serving.port);
        assert_eq!(std::fs::read_to_string(&opened).unwrap(), address);
    }
}

#[test]
fn the_viewer_is_written_as_files_and_as_one() {
    let place = atlas();
    let said = place.call("export out/small --form viewer --specimen wave --out pages/site").ended(0).stdout;
    assert!(said.starts_with("exported the viewer to pages/site, "), "{said}");
    let site = contents(&place.path("pages/site"));
    let published = contents(&place.path("out/small/v0001"));
    for name in PAGE_FILES {
        assert!(site[name] == page(name), "{name}");
    }
    let told: Value = serde_json::from_slice(&site["atlas/viewer.json"]).unwrap();
    assert_eq!(told["specimens"], serde_json::json!(["wave"]));
    let of_atlas: BTreeMap<&str, &Vec<u8>> =
        site.iter().filter_map(|(path, bytes)| Some((path.strip_prefix("atlas/")?, bytes))).collect();
    assert_eq!(site.len(), of_atlas.len() + PAGE_FILES.len());
    for needed in ["atlas.json", "wave/specimen.json", "wave/table.000.exr", "wave/lobe.exr", "wave/spectral.000.exr"] {
        assert!(of_atlas.contains_key(needed), "{needed}");
    }
    for (path, bytes) in of_atlas.iter().filter(|(path, _)| **path != "viewer.json") {
        assert!(published[*path] == **bytes && !path.starts_with("rough"), "{path}");
    }
    place.call("export out/small --form viewer --out pages/site").ended(2);
    assert!(contents(&place.path("pages/site")) == site, "what is there stays");

    let line = "export out/small --form viewer --specimen wave --single-file --out pages/wave.html";
    place.call(line).ended(0);
    let page = std::fs::read_to_string(place.path("pages/wave.html")).unwrap();
    let inside: BTreeMap<String, Vec<u8>> = page.split("class=\"atlas-file\"").skip(1).map(file_in_page).collect();
    // Tables are there as half floats where these take less, all else as it is.
    let path_of = |key: &'_ str| key.strip_suffix(".halves").unwrap_or(key).to_owned();
    assert!(inside.keys().map(|key| path_of(key)).eq(of_atlas.keys().map(|path| (*path).to_owned())));
    for (key, found) in &inside {
        let published = of_atlas[&*path_of(key)];
        match key.ends_with(".halves") {
            true => assert!(found.starts_with(b"DDAT") && found.len() < published.len(), "{key}"),
            false => assert_eq!(found, published, "{key}"),
        }
    }
    assert!(inside.keys().any(|key| key.ends_with(".halves")), "no table is packed: {:?}", inside.keys());
    for left_out in ["wave/result.json", "wave/reflection_00deg.png"] {
        assert!(published.contains_key(left_out) && !of_atlas.contains_key(left_out), "{left_out}");
    }
    let own = page.replace("http://www.w3.org/", "");
    for name in ["viewer.js", "viewer.css"] {
        for start in ["=\"", "=\"./"] {
            assert!(!own.contains(&format!("{start}{name}\"")), "{name} is still outside");
        }
    }
    place.call(line).ended(2);
    let left: Vec<String> = contents(&place.path("pages")).into_keys().filter(|path| path.contains(".part")).collect();
    assert_eq!(left, [""; 0]);

    place.call("export out/small --form viewer --specimen newt --out pages/other").ended(2);
    place.call("export out/small --form shaders --single-file --out pages/other").ended(2);
    assert!(!place.path("pages/other").exists());
}

/// What an element of the page says of a file, from behind its class on: seven bits a character, by the definition.
fn file_in_page(element: &str) -> (String, Vec<u8>) {
    let value = |name: &str| element.split(&format!("{name}=\"")).nth(1).unwrap().split('"').next().unwrap().to_owned();
    let length: usize = value("data-bytes").parse().unwrap();
    let text = element.split_once('>').unwrap().1.split("</script>").next().unwrap();
    let sevens = |letter: char| match u32::from(letter) {
        code if code < 0x100 => vec![code],
        code => vec![[0, 13, 60][((code - 0x100) >> 7) as usize], code & 0x7f],
    };
    let (mut bytes, mut held, mut bits) = (Vec::new(), 0, 0);
    for seven in text.chars().flat_map(sevens) {
        held = (held << 7 | seven) & 0x7fff;
        bits += 7;
        if bits >= 8 {
            bits -= 8;
            bytes.push((held >> bits) as u8);
        }
    }
    bytes.truncate(length);
    assert_eq!(bytes.len(), length, "{}", value("data-path"));
    (value("data-path"), bytes)
}
