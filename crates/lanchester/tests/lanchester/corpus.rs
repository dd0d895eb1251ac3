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

#[test]
fn kept_corpus_of_the_runs_in_time() {
    replay("simulate", checks::simulate);
}

#[test]
fn what_is_changed_is_accepted_as_it_is() {
    checks::unchanged();
}

/// A check for inputs that nobody chose: a linear congruence, so that every run sees the same ones.
fn changed(target: &str, check: fn(&[u8])) {
    let mut state = 20_u64;
    let mut next = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as u8
    };
    for _ in 0..300 {
        let data: Vec<u8> = (0..1 + 3 * (1 + usize::from(next()) % 6)).map(|_| next()).collect();
        if std::panic::catch_unwind(|| check(&data)).is_err() {
            panic!("the input {data:?} breaks `{target}`");
        }
    }
}

#[test]
fn changed_graphs() {
    changed("graph", checks::graph);
}

#[test]
fn changed_runs_in_time() {
    changed("simulate", checks::simulate);
}
