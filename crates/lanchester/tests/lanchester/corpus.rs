//! Replays the kept fuzz corpus (`fuzz/seeds`) on stable: what once broke anything stays mended.

use crate::checks;

use std::path::Path;

fn replay(target: &str, check: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds").join(target);
    let mut files = 0;
    for entry in std::fs::read_dir(&folder).expect("the corpus is kept") {
        let path = entry.expect("its folder can be read").path();
        let data = std::fs::read(&path).expect("its files can be read");
        if std::panic::catch_unwind(|| check(&data)).is_err() {
            panic!("the kept input {} breaks `{target}`", path.display());
        }
        files += 1;
    }
    assert!(files >= 20, "only {files} kept inputs for `{target}`");
}

#[test]
fn kept_corpus_of_the_reader() {
    replay("read", checks::read);
}

#[test]
fn kept_corpus_of_the_loads() {
    replay("loads", checks::loads);
}

#[test]
fn kept_corpus_of_the_workshop() {
    replay("workshop", checks::workshop);
}

#[test]
fn kept_corpus_of_the_graphs() {
    replay("graph", checks::graph);
}

#[test]
fn kept_corpus_of_the_optima() {
    replay("balance", checks::balance);
}
