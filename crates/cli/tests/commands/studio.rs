//! The studio's server, asked as a browser, another program and an attacker would.

use super::program::{examples, folder, message, output};
use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A server in a folder of its own; it ends with the test.
struct Server {
    child: Child,
    /// `127.0.0.1:41857`.
    host: String,
    token: String,
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Server {
    fn start(folder: &Path, path: &str) -> Server {
        Server::start_with(folder, path, &[])
    }

    fn start_with(folder: &Path, path: &str, options: &[&str]) -> Server {
        let mut child = Command::new(env!("CARGO_BIN_EXE_lanchester"))
            .args(["studio", path, "--no-open"])
            .args(options)
            .current_dir(folder)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let address = line.trim().strip_prefix("http://").unwrap_or_else(|| panic!("{line}"));
        let (host, token) = address.split_once("/?token=").unwrap();
        Server { child, host: host.to_owned(), token: token.to_owned() }
    }

    /// Status, head and body of an answer.
    fn ask(&self, method: &str, path: &str, headers: &[(&str, &str)], body: &[u8]) -> (u16, String, Vec<u8>) {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let mut head =
            format!("{method} {path} HTTP/1.1\r\nconnection: close\r\ncontent-length: {}\r\n", body.len());
        if !headers.iter().any(|(name, _)| *name == "host") {
            head += &format!("host: {}\r\n", self.host);
        }
        for (name, value) in headers {
            head += &format!("{name}: {value}\r\n");
        }
        stream.write_all((head + "\r\n").as_bytes()).unwrap();
        // A server that refuses a long body does not read it.
        let _ = stream.write_all(body);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let end = answer.windows(4).position(|four| four == b"\r\n\r\n").expect("an answer has a head");
        let head = String::from_utf8(answer[..end].to_vec()).unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        (status, head.to_ascii_lowercase(), answer[end + 4..].to_vec())
    }

    fn json(&self, status: u16, method: &str, path: &str, question: &Value) -> Value {
        // The server does not read a body that no question has: it would close the connection over it.
        let body = if question.is_null() { Vec::new() } else { serde_json::to_vec(question).unwrap() };
        let (got, _, answer) = self.ask(method, path, &[("x-lanchester-token", &self.token)], &body);
        let text = String::from_utf8_lossy(&answer);
        assert_eq!(got, status, "{path}: {text}");
        serde_json::from_slice(&answer).unwrap_or_else(|error| panic!("{path}: {error}: {text}"))
    }

    fn post(&self, path: &str, question: &Value) -> Value {
        self.json(200, "POST", path, question)
    }
}

fn three(test: &str) -> (std::path::PathBuf, String) {
    let folder = folder(test);
    let text = fs::read_to_string(examples().join("in-line-3-counterweights.toml")).unwrap();
    fs::write(folder.join("three.toml"), &text).unwrap();
    (folder, text)
}

#[test]
fn the_answers_are_those_of_the_commands() {
    let (folder, text) = three("studio-answers");
    let server = Server::start(&folder, "three.toml");
    let of_command =
        |arguments: &[&str]| -> Value { serde_json::from_str(&output(&folder, 0, arguments)).unwrap() };
    let mut loads = of_command(&["loads", "three.toml", "--format", "json"]);
    loads.as_object_mut().unwrap().remove("internal");
    assert_eq!(server.post("/api/loads", &json!({ "text": text })), loads);
    let short = server.post("/api/loads", &json!({ "text": text, "curves": "whole" }));
    assert_eq!(short["total"], loads["total"]);
    for of in ["parts", "cylinders"] {
        let [own, found] = [&loads, &short].map(|answer| answer[of].as_array().expect("a list"));
        for (own, found) in own.iter().zip(found).map(|(own, found)| (&own["loads"], &found["loads"])) {
            assert_eq!((&found["peaks"], &found["orders"]), (&own["peaks"], &own["orders"]));
            assert_eq!(found["trace"]["force_x"], json!([]));
        }
    }
    assert_eq!(short["motion"][0]["stroke"], loads["motion"][0]["stroke"]);
    assert_eq!(short["motion"][0]["trace"]["velocity"], json!([]));
    let bearings = of_command(&["bearings", "three.toml", "--format", "json"]);
    assert_eq!(server.post("/api/bearings", &json!({ "text": text })), bearings);
    let balance = of_command(&["balance", "three.toml", "--format", "json"]);
    let answer = server.post("/api/balance", &json!({ "text": text, "free": "balance" }));
    assert_eq!(answer["answer"]["weights"], balance["weights"]);
    assert_eq!(answer["answer"]["stages"], balance["stages"]);
    // The page asks for what the weights do to the engine by itself.
    let mut design = of_command(&["counterweight", "design", "three.toml", "--format", "json"]);
    assert!(design.as_object_mut().and_then(|design| design.remove("consequences")).is_some());
    assert_eq!(server.post("/api/counterweight/design", &json!({ "text": text }))["designs"], design);
    let arrangements = of_command(&["balance", "three.toml", "--search", "--format", "json"]);
    assert_eq!(server.post("/api/arrangements", &json!({ "text": text })), arrangements);
    let question = serde_json::to_vec(&json!({ "text": text, "name": "three.toml" })).unwrap();
    let (status, _, report) =
        server.ask("POST", "/api/report", &[("x-lanchester-token", &server.token)], &question);
    assert_eq!(
        (status, String::from_utf8(report).unwrap()),
        (200, output(&folder, 0, &["report", "three.toml", "--output", "-"]))
    );
}

#[test]
fn an_edit_keeps_the_rest_and_a_saved_file_is_what_was_sent() {
    let (folder, text) = three("studio-edit");
    let server = Server::start(&folder, "three.toml");
    let file = server.json(200, "GET", "/api/session", &json!(null))["file"].clone();
    assert_eq!(file["text"], text);
    let edits = json!([{ "path": "counterweight[0].unbalance", "value": "3.2 oz in" }]);
    let reading = server.post("/api/engine", &json!({ "text": text, "edits": edits }));
    let new = reading["text"].as_str().unwrap();
    assert_eq!(new.lines().zip(text.lines()).filter(|(a, b)| a != b).count(), 1);
    assert!(
        reading["engine"]["counterweights"][0]["unbalance"]
            .as_f64()
            .is_some_and(|u| (u - 2.304e-3).abs() < 1e-6)
    );
    let saved = server.json(
        200,
        "PUT",
        "/api/file",
        &json!({ "name": "three.toml", "text": new, "revision": file["revision"] }),
    );
    assert_eq!(fs::read_to_string(folder.join("three.toml")).unwrap(), new);
    // Another program writes; what was read is not what stands there.
    fs::write(folder.join("three.toml"), "# other\n").unwrap();
    let refused = server.json(
        409,
        "PUT",
        "/api/file",
        &json!({ "name": "three.toml", "text": text, "revision": saved["revision"] }),
    );
    assert!(refused["message"].as_str().unwrap().contains("another program changed three.toml"), "{refused}");
    assert_eq!(refused["found"], "changed");
    assert_eq!(fs::read_to_string(folder.join("three.toml")).unwrap(), "# other\n");
    let taken = server.json(
        409,
        "PUT",
        "/api/file",
        &json!({ "name": "three.toml", "text": text, "revision": null }),
    );
    assert!(taken["message"].as_str().unwrap().contains("exists already"), "{taken}");
    assert_eq!(taken["found"], "exists");
    fs::remove_file(folder.join("three.toml")).unwrap();
    let question = json!({ "name": "three.toml", "text": text, "revision": saved["revision"] });
    let removed = server.json(409, "PUT", "/api/file", &question);
    assert_eq!(removed["found"], "removed");
    assert!(!folder.join("three.toml").exists());
}

#[test]
fn no_question_has_a_field_that_is_ignored() {
    let (folder, text) = three("studio-fields");
    let server = Server::start(&folder, "three.toml");
    let description: Value =
        serde_json::from_str(&output(&folder, 0, &["studio", "--describe", "openapi"])).unwrap();
    let mut asked = 0;
    for (path, methods) in description["paths"].as_object().unwrap() {
        for (method, question) in methods.as_object().unwrap() {
            if question.get("requestBody").is_none() {
                continue;
            }
            let question = json!({ "text": text, "surprise": 1 });
            let refused = server.json(400, &method.to_uppercase(), path, &question);
            let message = refused["message"].as_str().unwrap();
            assert!(message.contains("surprise") || message.contains("unknown field"), "{path}: {message}");
            asked += 1;
        }
    }
    assert!(asked > 15, "{asked} questions with a body");
}

/// A search of hundreds of boxes, which takes many seconds: given amounts in free directions on a V6, and a shaft to be placed.
fn long_search() -> Value {
    let text = fs::read_to_string(examples().join("v6-60.toml")).unwrap();
    let shaft = "-1 @ -200 mm .. 200 mm, 150 mm .. 300 mm @ -200 mm .. 0 mm, 0 mm .. 200 mm \
                 @ optional, least 0.01 kg m, most 0.01 kg m";
    let amount = "0.013 kg m";
    json!({ "text": text, "free": "throws", "least": amount, "most": amount, "shafts": [shaft], "minimise": ["couple"] })
}

/// Sends a question and does not wait for the answer.
fn send(server: &Server, lane: &str, question: &Value) -> TcpStream {
    send_to(server, "/api/balance", lane, question)
}

fn send_to(server: &Server, path: &str, lane: &str, question: &Value) -> TcpStream {
    let body = serde_json::to_vec(question).unwrap();
    let mut stream = TcpStream::connect(&server.host).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    write!(
        stream,
        "POST {path} HTTP/1.1\r\nhost: {}\r\nconnection: close\r\nx-lanchester-token: {}\r\n\
         x-lanchester-client: window\r\nx-lanchester-lane: {lane}\r\ncontent-length: {}\r\n\r\n",
        server.host,
        server.token,
        body.len()
    )
    .unwrap();
    stream.write_all(&body).unwrap();
    stream
}

/// The server may come to a newer question before an older one, which is then the newer of the two: newer ones are sent until the older
/// one is answered.
#[test]
fn a_newer_question_breaks_an_older_one_off() {
    let (folder, text) = three("studio-newer");
    let server = Server::start(&folder, "three.toml");
    let older = send(&server, "balance", &long_search());
    let older = std::thread::spawn(move || {
        let (mut stream, mut answer) = (older, String::new());
        stream.read_to_string(&mut answer).map(|_| answer)
    });
    let mut answered = 0;
    while answered == 0 || !older.is_finished() {
        let mut newer = send(&server, "balance", &json!({ "text": text }));
        let mut answer = String::new();
        newer.read_to_string(&mut answer).unwrap();
        // Only the older one, where the server comes to it last, breaks this one off.
        let broken_off = answer.contains("409") && answer.contains("a newer question");
        assert!(broken_off || answer.contains("200 OK"), "{answer}");
        answered += usize::from(!broken_off);
    }
    let answer = older.join().unwrap().unwrap();
    assert!(answer.contains("409") && answer.contains("a newer question"), "{answer}");
}

#[test]
fn a_window_that_goes_away_holds_no_processor() {
    let (folder, text) = three("studio-away");
    let server = Server::start(&folder, "three.toml");
    // More than there are processors: if they went on, nobody else would get an answer within the minute.
    let windows: Vec<TcpStream> =
        (0..64).map(|lane| send(&server, &lane.to_string(), &long_search())).collect();
    // Some are being computed by then, or none on a slow machine: the answer comes in either case.
    std::thread::sleep(Duration::from_millis(300));
    drop(windows);
    assert!(server.post("/api/loads", &json!({ "text": text }))["speed"].is_number());
}

#[test]
fn a_mistake_tells_its_key_and_a_question_about_no_engine_its_mistakes() {
    let (folder, text) = three("studio-mistakes");
    let server = Server::start(&folder, ".");
    let wrong = text.replacen("web_thickness = \"", "web_thickness = \"x", 1);
    let reading = server.post("/api/engine", &json!({ "text": wrong }));
    assert!(reading["engine"].is_null());
    assert_eq!(reading["diagnostics"][0]["path"], "crank.body.web_thickness");
    let refused = server.json(422, "POST", "/api/loads", &json!({ "text": wrong }));
    assert_eq!(refused["diagnostics"][0]["code"], reading["diagnostics"][0]["code"]);
    let none = server.json(422, "POST", "/api/mounts", &json!({ "text": text }));
    assert!(none["hint"].as_str().unwrap().contains("[block]"), "{none}");
    // Without gas there is the torque of inertia.
    let torque = server.post("/api/torque", &json!({ "text": text }));
    assert_eq!(torque["torque"]["with_gas"], false);
    for (path, question) in [
        ("/api/loads", json!({ "text": text, "speed": -1 })),
        ("/api/loads", json!({ "text": text, "samples": u64::MAX })),
        ("/api/loads", json!({ "text": text, "samples": 0 })),
        ("/api/arrangements", json!({ "text": text, "most_shafts": 99 })),
        ("/api/arrangements/adopt", json!({ "search": { "text": text }, "choice": 0 })),
        ("/api/counterweight/front", json!({ "text": text, "against": "inertia", "count": 1_000_000 })),
        ("/api/counterweight/shape", json!({ "text": text, "weight": "none" })),
        ("/api/balance", json!({ "text": text, "minimise": ["beauty"] })),
        ("/api/balance", json!({ "text": text, "free": "none" })),
        ("/api/balance", json!({ "text": text, "shafts": ["-1 @ nowhere"] })),
        ("/api/balance", json!({ "text": text, "shafts": ["-1 @ 0 mm, 0 mm @ 0 mm"] })),
        ("/api/balance", json!({ "text": text, "locked": ["nobody"] })),
        ("/api/balance", json!({ "text": text, "free": "webs", "locked": ["web 1"] })),
        ("/api/balance", json!({ "text": text, "cancel": ["force order 1"], "limits": ["couple = 5 N m"] })),
        ("/api/balance", json!({ "text": text, "most": "-1 kg m" })),
        ("/api/balance", json!({ "text": text, "step": "0 g mm" })),
        ("/api/balance", json!({ "text": text, "equal_parts": true })),
        ("/api/balance", json!({ "text": text, "budget": "cheap" })),
        ("/api/balance", json!({ "text": text, "speeds": ["fast"] })),
        ("/api/balance", json!({ "text": text, "give_up": ["beauty = 1 %"] })),
        (
            "/api/balance",
            json!({ "text": text, "robust": 10, "worst_share": "120 %", "minimise": ["couple"] }),
        ),
        ("/api/balance", json!({ "text": text, "worst_share": "5 %" })),
        ("/api/balance", json!({ "text": text, "robust": 10, "budget": "3", "minimise": ["couple"] })),
        ("/api/engine", json!({ "text": text, "edits": [{ "path": "crank[", "value": 1 }] })),
    ] {
        let refused = server.json(422, "POST", path, &question);
        assert!(refused["message"].as_str().is_some_and(|message| !message.is_empty()), "{path} {refused}");
        assert!(refused["hint"].as_str().is_some_and(|hint| !hint.is_empty()), "{path} {question} {refused}");
    }
    let unread = server.json(400, "POST", "/api/loads", &json!({ "texts": text }));
    assert!(unread["message"].as_str().unwrap().contains("`text`"), "{unread}");
}

/// Steps and equal parts of the studio are those of the command line.
#[test]
fn weights_in_steps_are_those_of_the_command() {
    let (folder, text) = three("studio-steps");
    let server = Server::start(&folder, "three.toml");
    let asked = json!({ "text": text, "free": "webs", "minimise": ["couple"], "step": "500 g mm", "most": "0.005 kg m", "equal_parts": true });
    let found = server.post("/api/balance", &asked);
    let weights = found["answer"]["weights"].as_array().unwrap();
    let amount = |weight: &Value| {
        let part = |k: usize| weight["unbalance"][k].as_f64().unwrap();
        part(0).hypot(part(1))
    };
    let used: Vec<f64> = weights.iter().map(amount).filter(|amount| *amount > 0.0).collect();
    assert!(!used.is_empty(), "{found}");
    for amount in &used {
        assert!((amount / 5e-4 - (amount / 5e-4).round()).abs() < 1e-9, "{amount}");
        assert!((amount - used[0]).abs() < 1e-12, "{used:?}");
    }
    assert!(found["robust"].is_null(), "{found}");
}

#[test]
fn nobody_else_gets_in() {
    let (folder, text) = three("studio-gate");
    fs::write(folder.parent().unwrap().join("outside.toml"), &text).unwrap();
    let server = Server::start(&folder, "three.toml");
    let token = ("x-lanchester-token", server.token.as_str());
    let status = |headers: &[(&str, &str)], path: &str| server.ask("GET", path, headers, b"").0;
    assert_eq!(status(&[token], "/api/session"), 200);
    assert_eq!(status(&[], "/api/session"), 401);
    assert_eq!(status(&[("x-lanchester-token", "guess")], "/api/session"), 401);
    assert_eq!(status(&[token, ("host", "evil.example")], "/api/session"), 403);
    assert_eq!(status(&[token, ("origin", "http://evil.example")], "/api/session"), 403);
    assert_eq!(status(&[token, ("origin", &format!("http://{}", server.host))], "/api/session"), 200);
    assert_eq!(status(&[], "/../../etc/passwd"), 404);
    // One host, one origin, one token: a second one is not the one that somebody checked.
    assert_eq!(status(&[token, ("host", &server.host), ("host", "evil.example")], "/api/session"), 403);
    assert_eq!(status(&[token, ("host", &server.host), ("host", &server.host)], "/api/session"), 403);
    assert_eq!(status(&[token, ("x-lanchester-token", "guess")], "/api/session"), 401);
    assert_eq!(status(&[token], "http://evil.example/api/session"), 403);
    let (status, head, _) = server.ask("GET", "/", &[], b"");
    assert!(status == 200 && head.contains("content-security-policy: default-src 'self'"), "{head}");
    for name in ["../outside.toml", "/etc/passwd", "..\\outside.toml", "three.txt", ""] {
        let refused = server.json(422, "POST", "/api/file/open", &json!({ "name": name }));
        assert!(refused["hint"].is_string(), "{name}: {refused}");
        server.json(422, "PUT", "/api/file", &json!({ "name": name, "text": "x", "revision": null }));
    }
    let gas = text.clone() + "\n[gas]\n[[gas.trace]]\nfile = \"../outside.toml\"\nspeed = \"1000 rpm\"\n";
    let refused = server.json(403, "POST", "/api/torque", &json!({ "text": gas }));
    assert!(refused["message"].as_str().unwrap().contains("outside of the folder"), "{refused}");
}

/// Every answer, refusals and pages included, is kept by nobody and is nothing but what it says.
/// Linux answers at all of 127.0.0.0/8: the second address stands for that of a container.
#[test]
#[cfg(target_os = "linux")]
fn other_interfaces_reach_it_only_where_that_is_asked_for_and_with_the_token() {
    let (folder, _) = three("studio-interfaces");
    let at_another = |server: &Server| server.host.replace("127.0.0.1", "127.0.0.2");
    let alone = Server::start(&folder, "three.toml");
    assert!(TcpStream::connect(at_another(&alone)).is_err());
    let mut server = Server::start_with(&folder, "three.toml", &["--all-interfaces"]);
    let (own, another) = (server.host.clone(), at_another(&server));
    server.host = another;
    let status = |headers: &[(&str, &str)]| server.ask("GET", "/api/session", headers, b"").0;
    let token = ("x-lanchester-token", server.token.as_str());
    assert_eq!(status(&[("host", &own), token]), 200);
    assert_eq!(status(&[("host", &own)]), 401);
    assert_eq!(status(&[token]), 403);
}

#[test]
fn every_answer_is_guarded() {
    let (folder, text) = three("studio-headers");
    let server = Server::start(&folder, "three.toml");
    let token = ("x-lanchester-token", server.token.as_str());
    let question = serde_json::to_vec(&json!({ "text": text, "name": "three.toml" })).unwrap();
    for (method, path, headers, body) in [
        ("GET", "/", &[][..], &b""[..]),
        ("GET", "/nothing", &[], b""),
        ("GET", "/api/session", &[], b""),
        ("GET", "/api/session", &[token], b""),
        ("GET", "/api/session", &[token, ("host", "evil.example")], b""),
        ("POST", "/api/report", &[token], &question),
        ("POST", "/api/loads", &[token], b"{"),
        ("POST", "/api/session", &[token], b""),
    ] {
        let (status, head, _) = server.ask(method, path, headers, body);
        for header in
            ["x-content-type-options: nosniff", "cache-control: no-store", "referrer-policy: no-referrer"]
        {
            assert!(head.contains(header), "{method} {path} {status}: {head}");
        }
        assert_eq!(head.matches("cache-control").count(), 1, "{head}");
    }
}

/// The licences of others that are in program and page: printed, and served to whoever has the page.
#[test]
fn notices_of_third_parties_come_with_program_and_page() {
    let (folder, _) = three("studio-notices");
    let printed = output(&folder, 0, &["licences"]);
    for part in [
        "  parquet 60",
        "  axum 0.8",
        "  three 0.187.0: MIT",
        "  svelte 5",
        "  @codemirror/view 6",
        "Copyright",
    ] {
        assert!(printed.contains(part), "{part}");
    }
    assert!(!printed.contains("lanchester-cli") && printed.len() > 50_000);
    let server = Server::start(&folder, "three.toml");
    let (status, head, body) = server.ask("GET", "/third-party.txt", &[], b"");
    assert!(status == 200 && head.contains("text/plain"), "{head}");
    assert_eq!(String::from_utf8(body).unwrap(), printed);
}

/// Who connects and says nothing, or half of something, is not waited for.
#[test]
fn silence_is_not_waited_for() {
    let (folder, _) = three("studio-slow");
    let server = Server::start(&folder, "three.toml");
    let begun = |text: &str| {
        let mut stream = TcpStream::connect(&server.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(50))).unwrap();
        stream.write_all(text.as_bytes()).unwrap();
        stream
    };
    let head = format!(
        "POST /api/loads HTTP/1.1\r\nhost: {}\r\nx-lanchester-token: {}\r\ncontent-length: 900\r\n\r\n{{",
        server.host, server.token
    );
    let slow = [begun(""), begun("GET / HTTP/1.1\r\nhost: x"), begun(&head)];
    let since = std::time::Instant::now();
    let ends = slow.map(|mut stream| {
        let mut said = String::new();
        stream.read_to_string(&mut said).expect("the connection ends");
        said
    });
    assert!(since.elapsed() < Duration::from_secs(45), "{:?}", since.elapsed());
    assert!(ends[2].contains("408"), "{ends:?}");
}

/// Questions whose windows have gone do not pile up: no more are computed than there are processors.
#[cfg(target_os = "linux")]
#[test]
fn nothing_is_computed_for_windows_that_have_gone() {
    let (folder, text) = three("studio-gone");
    let server = Server::start(&folder, "three.toml");
    server.post("/api/loads", &json!({ "text": text }));
    let tasks = || fs::read_dir(format!("/proc/{}/task", server.child.id())).unwrap().count();
    let processors = std::thread::available_parallelism().unwrap().get();
    let before = tasks();
    let mut most = before;
    for round in 0..40 {
        // Questions of no lane, each left at once.
        let question = json!({ "text": text, "against": "inertia", "count": 60 });
        let stream = send_to(&server, "/api/counterweight/front", &format!("{round}"), &question);
        std::thread::sleep(Duration::from_millis(10));
        drop(stream);
        most = most.max(tasks());
    }
    std::thread::sleep(Duration::from_millis(100));
    most = most.max(tasks());
    // Those that compute, and one or two that read files meanwhile.
    assert!(most <= before + processors + 2, "{before} threads became {most}");
    server.post("/api/loads", &json!({ "text": text }));
}

/// The token is in no argument list, which every user of a machine can read: the browser gets a page of its user alone.
#[cfg(target_os = "linux")]
#[test]
fn the_browser_is_led_by_a_page_of_its_own_user() {
    use std::os::unix::fs::PermissionsExt;
    let (folder, _) = three("studio-browser");
    let script =
        "#!/bin/sh\necho \"$@\" > arguments\nstat -c %a \"$1\" > mode\ncp \"$1\" page && mv page seen\n";
    fs::write(folder.join("xdg-open"), script).unwrap();
    fs::set_permissions(folder.join("xdg-open"), fs::Permissions::from_mode(0o755)).unwrap();
    let path = format!("{}:{}", folder.display(), std::env::var("PATH").unwrap());
    let mut child = Command::new(env!("CARGO_BIN_EXE_lanchester"))
        .args(["studio", "three.toml"])
        .env("PATH", path)
        .env("TMPDIR", &folder)
        .current_dir(&folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
    let since = std::time::Instant::now();
    while !folder.join("seen").exists() {
        assert!(since.elapsed() < Duration::from_secs(30), "no browser was opened");
        std::thread::sleep(Duration::from_millis(20));
    }
    let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    let (arguments, page) = (read("arguments"), read("seen"));
    let token = line.trim().split_once("token=").unwrap().1;
    assert!(!arguments.contains(token) && arguments.trim().ends_with(".html"), "{arguments}");
    assert_eq!(read("mode").trim(), "600");
    assert!(page.contains(&format!("url={}", line.trim())), "{page}");
    // It goes with the studio.
    assert!(Path::new(arguments.trim()).exists());
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(child.wait().unwrap().success());
    assert!(!Path::new(arguments.trim()).exists());
}

#[test]
fn a_huge_question_is_refused_and_the_server_lives() {
    let (folder, text) = three("studio-huge");
    let server = Server::start(&folder, "three.toml");
    let token = ("x-lanchester-token", server.token.as_str());
    let (status, ..) = server.ask("POST", "/api/engine", &[token], &vec![b' '; 25 << 20]);
    assert_eq!(status, 413);
    let long = "#".repeat(5 << 20);
    let reading = server.post("/api/engine", &json!({ "text": long }));
    assert_eq!(reading["diagnostics"][0]["code"], "E0003");
    server.json(422, "PUT", "/api/file", &json!({ "name": "long.toml", "text": long, "revision": null }));
    assert!(!folder.join("long.toml").exists());
    server.post("/api/loads", &json!({ "text": text }));
}

#[test]
fn a_change_on_the_disk_is_told() {
    let (folder, _) = three("studio-events");
    let server = Server::start(&folder, "three.toml");
    let stream = TcpStream::connect(&server.host).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    write!(&stream, "GET /api/events?token={} HTTP/1.1\r\nhost: {}\r\n\r\n", server.token, server.host)
        .unwrap();
    let mut lines = BufReader::new(&stream).lines();
    let mut told =
        || lines.by_ref().map_while(Result::ok).find(|line| line.starts_with("data: ")).expect("an event");
    assert!(told().contains("In-line three"));
    fs::write(folder.join("three.toml"), "# other\n").unwrap();
    assert!(told().contains("# other"));
    fs::remove_file(folder.join("three.toml")).unwrap();
    assert_eq!(told(), "data: null");
}

#[test]
fn what_cannot_be_served_is_told() {
    let (folder, _) = three("studio-start");
    let server = Server::start(&folder, "three.toml");
    let port = server.host.rsplit(':').next().unwrap();
    let taken = message(&folder, 2, &["studio", "three.toml", "--no-open", "--port", port]);
    assert!(taken.contains(&format!("the port {port} is taken")) && taken.contains("hint: "), "{taken}");
    let missing = message(&folder, 2, &["studio", "four.toml", "--no-open"]);
    assert!(missing.contains("four.toml") && missing.contains("hint: "), "{missing}");
    let nowhere = message(&folder, 2, &["studio", "nowhere/four.toml", "--no-open"]);
    assert!(nowhere.contains("nowhere") && nowhere.contains("hint: "), "{nowhere}");
}

/// The tab Simulate shows the run that the command makes, thinned, and refuses what the command refuses.
#[test]
fn the_simulation_is_that_of_the_command() {
    let folder = folder("studio-simulate");
    let text = fs::read_to_string(examples().join("generator-set-3.toml")).unwrap();
    let text = text.replace("duration = \"24 s\"", "duration = \"0.6 s\"");
    fs::write(folder.join("set.toml"), &text).unwrap();
    let server = Server::start(&folder, "set.toml");
    let ours: Value =
        serde_json::from_str(&output(&folder, 0, &["simulate", "set.toml", "--format", "json"])).unwrap();
    let run = &ours["run"];
    let answer = server.post("/api/simulate", &json!({ "text": text }));
    assert_eq!(answer["complete"], true);
    let series = |value: &Value| value.as_array().map_or(0, Vec::len);
    let count = series(&answer["time"]);
    assert!(count > 100 && count <= 4000, "{count}");
    for curve in ["theta", "speed", "position", "orientation"] {
        assert_eq!(series(&answer[curve]), count, "{curve}");
        let last = |samples: &Value| samples.as_array().unwrap().last().unwrap().clone();
        assert_eq!(last(&answer[curve]), last(&run["samples"][curve]), "{curve}");
    }
    // As many forces as the engine has mounts, main bearings and cylinders, one value a sample.
    for (curves, many) in [("mounts", 4), ("mains", 4), ("side_thrust", 3)] {
        let own = answer[curves].as_array().unwrap();
        assert_eq!(own.len(), many, "{curves}");
        assert!(own.iter().all(|curve| series(&curve["values"]) == count), "{curves}");
    }
    let told: Vec<&str> =
        answer["events"].as_array().unwrap().iter().filter_map(|e| e["what"].as_str()).collect();
    assert!(told.contains(&"the starter lets go") && told.len() == series(&run["events"]), "{told:?}");
    let works = answer["energy"].as_array().unwrap().iter().map(|part| part["energy"].as_f64().unwrap());
    let largest = works.clone().map(f64::abs).fold(0.0, f64::max);
    assert!(works.sum::<f64>().abs() < 1e-6 * largest, "what goes in comes out: {:?}", answer["energy"]);
    // Form fields go before the file.
    let fixed = json!({ "text": text, "on_mounts": false, "imposed": true, "speed": 150.0, "revolutions": 2.0, "gas": false });
    let fixed = server.post("/api/simulate", &fixed);
    assert_eq!((series(&fixed["position"]), series(&fixed["mounts"])), (0, 0));
    assert!(fixed["speed"].as_array().unwrap().iter().all(|w| (w.as_f64().unwrap() - 150.0).abs() < 1e-9));
    // What cannot be run is refused with words, as the command does.
    for (key, value, words) in [
        ("speed", json!(-1.0), "0 or more"),
        ("revolutions", json!(1e9), "revolutions"),
        ("misfire", json!([4]), "from 1 to 3"),
        ("load", json!("5 kg"), "load"),
        ("sped", json!(1.0), "sped"),
    ] {
        let mut question = json!({ "text": text });
        question[key] = value;
        let body = serde_json::to_vec(&question).unwrap();
        let token = [("x-lanchester-token", server.token.as_str())];
        let (status, _, answer) = server.ask("POST", "/api/simulate", &token, &body);
        let answer = String::from_utf8_lossy(&answer);
        assert!((400..500).contains(&status) && answer.contains(words), "{key}: {status} {answer}");
    }
}

/// Points and gears of a run: those of the file and of the form, one value a sample, as the command has them.
#[test]
fn the_simulation_has_points_and_gears() {
    let folder = folder("studio-simulate-points");
    let more = "\n[[simulation.point]]\nname = \"carburettor\"\nx = \"200 mm\"\nz = \"50 mm\"\n\n[[simulation.mesh]]\nshaft = \"balancer\"\npressure_angle = \"20 deg\"\nz = \"-160 mm\"\n";
    let text = fs::read_to_string(examples().join("three-cylinder.toml")).unwrap() + more;
    fs::write(folder.join("three.toml"), &text).unwrap();
    let server = Server::start(&folder, "three.toml");
    let told = output(
        &folder,
        0,
        &[
            &["simulate", "three.toml", "--for", "2 revolutions"][..],
            &["--format", "json", "--point", "0.35 m, 0 m, 0.1 m"],
        ]
        .concat(),
    );
    let ours: Value = serde_json::from_str(&told).unwrap();
    let answer = server
        .post("/api/simulate", &json!({ "text": text, "revolutions": 2.0, "points": [[0.35, 0.0, 0.1]] }));
    let points = answer["points"].as_array().unwrap();
    let names: Vec<&str> = points.iter().filter_map(|point| point["name"].as_str()).collect();
    assert_eq!(names, ["carburettor", "350, 0, 100 mm"]);
    for (own, command) in points.iter().zip(ours["points"].as_array().unwrap()) {
        let places = |point: &Value| -> Vec<[f64; 3]> {
            let all = point["displacement"].as_array().unwrap().iter();
            all.map(|at| [0, 1, 2].map(|k| at[k].as_f64().unwrap())).collect()
        };
        let (own, command) = (places(own), places(command));
        assert_eq!(own.len(), command.len());
        let apart = own.iter().flatten().zip(command.iter().flatten()).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) < 1e-15, "the same paths");
        assert!(own[100][0].abs() > 1e-7, "it moves");
    }
    let reactions = ours["run"]["samples"]["reactions"].as_array().unwrap();
    let [torques, forces] = ["gear_torques", "gear_forces"].map(|curves| {
        let [curve] = &answer[curves].as_array().unwrap()[..] else { panic!("one shaft: {answer}") };
        assert_eq!(curve["name"], "balancer");
        curve["values"].as_array().unwrap().iter().map(|own| own.as_f64().unwrap()).collect::<Vec<_>>()
    });
    assert_eq!((torques.len(), forces.len()), (reactions.len(), reactions.len()));
    for (k, all) in reactions.iter().enumerate() {
        let rotor = &all["rotors"][1];
        let size: f64 =
            rotor["gear_force"].as_array().unwrap().iter().map(|f| f.as_f64().unwrap().powi(2)).sum();
        assert_eq!(torques[k], rotor["gear_torque"].as_f64().unwrap());
        assert!((forces[k] - size.sqrt()).abs() < 1e-12 * (1.0 + forces[k]));
    }
    assert!(forces.iter().any(|force| *force > 1.0), "the teeth carry something");
    let body = serde_json::to_vec(&json!({ "text": text, "points": vec![[0.0; 3]; 17] })).unwrap();
    let token = [("x-lanchester-token", server.token.as_str())];
    let (status, _, refused) = server.ask("POST", "/api/simulate", &token, &body);
    let refused = String::from_utf8_lossy(&refused);
    assert!((400..500).contains(&status) && refused.contains("at most 16 points"), "{status} {refused}");
}
