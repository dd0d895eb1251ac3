//! Bond graphs to start from.

macro_rules! embedded {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("../examples/bond-graphs/", $name, ".toml")))),*]
    };
}

/// The graph files of `examples/bond-graphs/`, by their names without ending, in the order of a course.
pub const BOND_GRAPHS: &[(&str, &str)] = embedded![
    "mass-spring-damper",
    "stick-slip",
    "dc-motor",
    "two-tanks",
    "two-tanks-turbulent",
    "gear-train",
    "slider-crank",
    "slider-crank-elastic",
    "double-pendulum",
    "double-pendulum-stiff",
    "prismatic-pair",
    "prismatic-pair-printed",
    "hydraulic-press",
    "thermal-chain",
    "torsion-chain",
    "single-cylinder",
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn every_graph_of_the_folder_is_embedded_once() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/bond-graphs");
        let entries = std::fs::read_dir(folder).unwrap();
        let mut found: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        let mut embedded: Vec<_> = BOND_GRAPHS.iter().map(|(name, _)| format!("{name}.toml")).collect();
        found.sort();
        embedded.sort();
        assert_eq!(found, embedded);
    }
}
