//! Attacks on the studio: whatever is sent, nothing leaks, nothing is written outside, and the next honest question is answered.

use super::ground::{Ground, PATIENCE, start};
use crate::workspace::root;
use anyhow::{Context, Result, ensure};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};

/// Stands outside of the folder of the studio.
const SECRET: &str = "secret-outside-of-the-folder";

struct Studio {
    child: Child,
    host: String,
    token: String,
}

impl Drop for Studio {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Studio {
    fn start(ground: &Ground) -> Result<Studio> {
        let mut command = ground.command(&["studio", "inside", "--no-open"]);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn()?;
        let mut line = String::new();
        BufReader::new(child.stdout.take().context("no output")?).read_line(&mut line)?;
        let address = line.trim().strip_prefix("http://").context("no address")?;
        let (host, token) = address.split_once("/?token=").context("no token")?;
        Ok(Studio { child, host: host.to_owned(), token: token.to_owned() })
    }

    /// Sends bytes and reads what comes, which may be nothing.
    fn send(&self, bytes: &[u8], waits: bool) -> Result<String> {
        let mut stream = TcpStream::connect(&self.host).context("the studio takes no connection")?;
        stream.set_read_timeout(Some(PATIENCE))?;
        // A server that refuses does not read to the end.
        let _ = stream.write_all(bytes);
        let mut answer = Vec::new();
        if waits {
            let _ = stream.read_to_end(&mut answer);
        }
        Ok(String::from_utf8_lossy(&answer).into_owned())
    }

    fn question(&self, method: &str, path: &str, head: &str, body: &str) -> Vec<u8> {
        format!(
            "{method} {path} HTTP/1.1\r\nconnection: close\r\n{head}content-length: {}\r\n\r\n{body}",
            body.len()
        )
        .into_bytes()
    }

    /// The head of an honest question.
    fn own(&self) -> String {
        format!("host: {}\r\nx-lanchester-token: {}\r\n", self.host, self.token)
    }
}

pub fn run(ground: &mut Ground) -> Result<u64> {
    let inside = ground.folder.join("inside");
    fs::create_dir(&inside)?;
    fs::copy(root().join("examples/in-line-4.toml"), inside.join("four.toml"))?;
    fs::write(ground.folder.join("outside.toml"), format!("name = \"{SECRET}\"\n"))?;
    #[cfg(unix)]
    std::os::unix::fs::symlink("../outside.toml", inside.join("link.toml"))?;
    let studio = Studio::start(ground)?;
    let session = studio.question("GET", "/api/session", &studio.own(), "");
    let mut count = 0;
    while ground.goes_on(count) {
        let waits = ground.random.below(8) > 0;
        let (bytes, refused) = attack(ground, &studio);
        let answer = start(&studio.send(&bytes, waits)?);
        let sent = String::from_utf8_lossy(&bytes[..bytes.len().min(400)]).into_owned();
        ensure!(!answer.contains(SECRET), "a file outside leaked to\n{sent}");
        ensure!(!answer.starts_with("HTTP/1.1 5"), "a fault of our own:\n{sent}\n{answer}");
        ensure!(
            !refused || !answer.starts_with("HTTP/1.1 2"),
            "what had to be refused was answered:\n{sent}\n{answer}"
        );
        let honest = studio.send(&session, true)?;
        let named = honest.contains("four.toml");
        let honest = start(&honest);
        ensure!(honest.starts_with("HTTP/1.1 200") && named, "no answer after\n{sent}\n{honest}");
        count += 1;
    }
    let names: Vec<_> = fs::read_dir(&ground.folder)?.flatten().map(|entry| entry.file_name()).collect();
    let known = ["inside", "outside.toml", "stdout", "stderr"];
    ensure!(names.iter().all(|name| known.iter().any(|other| name == other)), "the studio wrote {names:?}");
    ensure!(
        fs::read_to_string(ground.folder.join("outside.toml"))?.contains(SECRET),
        "a file outside was written"
    );
    Ok(count)
}

/// Bytes to send, and whether they must be refused.
fn attack(ground: &mut Ground, studio: &Studio) -> (Vec<u8>, bool) {
    let random = &mut ground.random;
    let own = studio.own();
    let host = format!("host: {}\r\n", studio.host);
    let names = [
        "../outside.toml",
        "..%2foutside.toml",
        "..\\\\outside.toml",
        "/etc/passwd",
        "link.toml",
        "inside/../../outside.toml",
        "./four.toml",
        "four.toml\\u0000",
        "\\u001b[31m.toml",
        ".toml",
        "",
    ];
    let name = *random.pick(&names);
    match random.below(12) {
        0 => (studio.question("POST", "/api/file/open", &own, &format!("{{\"name\":\"{name}\"}}")), true),
        1 => {
            let name = if name.contains("u001b") { "../outside.toml" } else { name };
            let body = format!("{{\"name\":\"{name}\",\"text\":\"x\",\"revision\":null}}");
            (studio.question("PUT", "/api/file", &own, &body), true)
        }
        2 => (studio.question("GET", &format!("/../{name}").replace(' ', ""), &host, ""), true),
        3 => {
            let others = ["evil.example", "127.0.0.1:1", "localhost", "[::1]", "127.0.0.1.evil.example"];
            let head = format!("host: {}\r\nx-lanchester-token: {}\r\n", random.pick(&others), studio.token);
            (studio.question("GET", "/api/session", &head, ""), true)
        }
        4 => (studio.question("GET", "/api/session", &format!("{own}{host}"), ""), true),
        5 => (
            studio.question("GET", "/api/session", &format!("{own}origin: http://evil.example\r\n"), ""),
            true,
        ),
        6 => {
            let mut token = studio.token.clone();
            token.truncate(random.below(token.len()));
            let head = format!("{host}x-lanchester-token: {token}\r\n");
            (studio.question("GET", "/api/session", &head, ""), true)
        }
        7 => {
            let long = "a".repeat((64 << 10) + random.below(400_000));
            (studio.question("GET", "/api/session", &format!("{own}x-long: {long}\r\n"), ""), true)
        }
        8 => {
            let deep = "[".repeat(1 + random.below(200_000));
            (studio.question("POST", "/api/loads", &own, &deep), true)
        }
        9 => {
            let body = " ".repeat((24 << 20) + 1 + random.below(1000));
            (studio.question("POST", "/api/engine", &own, &body), true)
        }
        10 => {
            let noise: Vec<u8> = (0..1 + random.below(3000)).map(|_| random.byte()).collect();
            let mut bytes = studio.question("POST", "/api/balance", &own, &"x".repeat(noise.len()));
            let at = bytes.len() - noise.len();
            bytes[at..].copy_from_slice(&noise);
            (bytes, true)
        }
        _ => ((0..1 + random.below(300)).map(|_| random.byte()).chain(*b"\r\n\r\n").collect(), true),
    }
}
