//! x
#[test]
fn dump() {
    let dir = std::path::Path::new("/tmp/pv/scenes");
    std::fs::create_dir_all(dir).unwrap();
    for t in lanchester::model::templates() {
        let e = lanchester::model::read(t.text).engine.unwrap();
        std::fs::write(
            dir.join(format!("{}.json", t.name)),
            serde_json::to_string(&lanchester::scene(&e)).unwrap(),
        )
        .unwrap();
    }
    for n in ["in-line-3-counterweights", "in-line-4-shafts", "v6-60"] {
        let t = std::fs::read_to_string(format!("/work/wt/page-view/examples/{n}.toml")).unwrap();
        let e = lanchester::model::read(&t).engine.unwrap();
        std::fs::write(
            dir.join(format!("ex-{n}.json")),
            serde_json::to_string(&lanchester::scene(&e)).unwrap(),
        )
        .unwrap();
    }
}
