//! The worked examples that ship with the program.

const EXAMPLES: [(&str, &str); 14] = [
    ("twin-in-line-in-phase", include_str!("../../../../examples/twin-in-line-in-phase.toml")),
    ("twin-in-line-out-of-phase", include_str!("../../../../examples/twin-in-line-out-of-phase.toml")),
    (
        "twin-in-line-in-phase-shorter",
        include_str!("../../../../examples/twin-in-line-in-phase-shorter.toml"),
    ),
    (
        "twin-in-line-out-of-phase-shorter",
        include_str!("../../../../examples/twin-in-line-out-of-phase-shorter.toml"),
    ),
    ("twin-boxer-in-phase", include_str!("../../../../examples/twin-boxer-in-phase.toml")),
    ("twin-boxer-out-of-phase", include_str!("../../../../examples/twin-boxer-out-of-phase.toml")),
    ("in-line-3", include_str!("../../../../examples/in-line-3.toml")),
    ("in-line-4", include_str!("../../../../examples/in-line-4.toml")),
    ("in-line-4-crank-by-elements", include_str!("../../../../examples/in-line-4-crank-by-elements.toml")),
    ("in-line-4-mounts", include_str!("../../../../examples/in-line-4-mounts.toml")),
    ("twin-270-choices", include_str!("../../../../examples/twin-270-choices.toml")),
    ("generator-set-3", include_str!("../../../../examples/generator-set-3.toml")),
    ("single-gas", include_str!("../../../../examples/single-gas.toml")),
    ("v6-60", include_str!("../../../../examples/v6-60.toml")),
];

#[test]
fn examples_read_without_a_complaint() {
    for (name, text) in EXAMPLES {
        let reading = lanchester_file::read(text);
        let shown = lanchester_file::render(&reading.diagnostics, name, text, false);
        assert!(reading.file.is_some() && reading.diagnostics.is_empty(), "{shown}");
    }
}
