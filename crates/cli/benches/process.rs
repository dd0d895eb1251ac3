//! How long the whole program takes, from start to exit, for the in-line four and the V12 of the gallery; a run in time and a cross-check.
#![allow(clippy::unwrap_used, reason = "a benchmark fails by panicking")]

use criterion::{Criterion, criterion_group, criterion_main};
use std::path::Path;
use std::process::{Command, Stdio};

fn run(folder: &Path, arguments: &[&str]) {
    let status = Command::new(env!("CARGO_BIN_EXE_lanchester"))
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::null())
        .status()
        .unwrap();
    assert!(status.success(), "{arguments:?}");
}

fn bench(criterion: &mut Criterion) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("process");
    std::fs::create_dir_all(&folder).unwrap();
    for layout in ["in-line-4", "v12-60"] {
        let file = format!("{layout}.toml");
        let _ = std::fs::remove_file(folder.join(&file));
        run(&folder, &["new", layout, "--output", &file]);
        let mut group = criterion.benchmark_group(format!("process, {layout}"));
        group.bench_function("loads", |b| b.iter(|| run(&folder, &["loads", &file])));
        group.bench_function("report", |b| b.iter(|| run(&folder, &["report", &file])));
        group.finish();
    }
}

/// The crank train in time, and the closed form against it: goals of 50 ms and 1 s.
fn in_time(criterion: &mut Criterion) {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut group = criterion.benchmark_group("process, in time");
    group.bench_function("simulate a V6", |b| {
        b.iter(|| run(&examples, &["simulate", "v6-60.toml", "--imposed"]))
    });
    group.bench_function("crosscheck an in-line four", |b| {
        b.iter(|| run(&examples, &["crosscheck", "in-line-4.toml"]))
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(30).measurement_time(std::time::Duration::from_secs(3));
    targets = bench, in_time
}
criterion_main!(benches);
