//! The module as the page uses it: one question after another, files that the page handed in.

use lanchester_answers::Reply;
use lanchester_web::Module;

fn json(reply: &Reply) -> serde_json::Value {
    serde_json::from_slice(&reply.bytes).expect("replies are JSON")
}

#[test]
fn the_module_answers_the_one_list_of_questions() {
    let module = Module::default();
    let session = module.answer("GET /api/session", b"");
    assert_eq!((session.status, session.kind), (200, "application/json"));
    let session = json(&session);
    assert_eq!((&session["folder"], &session["file"]), (&"this browser".into(), &serde_json::Value::Null));
    let text = &session["templates"][0]["text"];
    let body = serde_json::json!({ "text": text, "samples": 12 }).to_string();
    let loads = module.answer("POST /api/loads", body.as_bytes());
    assert_eq!(loads.status, 200);
    assert_eq!(json(&loads)["total"]["trace"]["theta"].as_array().map(Vec::len), Some(12));
    for (head, body, status) in [
        ("POST /api/loads", "{}", 400),
        ("POST /api/loads", "{\"text\":\"\"}", 422),
        ("GET /api/loads", "", 404),
        ("", "", 404),
    ] {
        let reply = module.answer(head, body.as_bytes());
        assert_eq!(reply.status, status, "{head}");
        assert!(json(&reply)["message"].is_string(), "{head}");
    }
}

#[test]
fn files_of_the_page_are_opened_saved_and_named() {
    let module = Module::default();
    let ask = |head: &str, body: serde_json::Value| module.answer(head, body.to_string().as_bytes());
    assert_eq!(ask("PUT /shelf", serde_json::json!({ "a.toml": "one", "p.csv": "1" })).status, 200);
    let opened = ask("POST /api/file/open", serde_json::json!({ "name": "a.toml" }));
    assert_eq!(json(&opened)["text"], "one");
    assert_eq!(json(&module.answer("GET /api/session", b""))["files"], serde_json::json!(["a.toml"]));
    let over = &json(&opened)["revision"];
    let save = |revision: &serde_json::Value| {
        ask("PUT /api/file", serde_json::json!({ "name": "a.toml", "text": "two", "revision": revision }))
    };
    assert_eq!(save(over).status, 200);
    let conflict = save(over);
    assert_eq!((conflict.status, &json(&conflict)["found"]), (409, &"changed".into()));
}
