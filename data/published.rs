//! Published numbers, the engines that they belong to, and pressures over the cycle.

macro_rules! embedded {
    ($($path:literal),* $(,)?) => {
        &[$(($path, include_str!(concat!("../validation/", $path)))),*]
    };
}

/// Every data file of `validation/`, by its path there, in the order of the page.
pub const FILES: &[(&str, &str)] = embedded![
    "twin-cylinder-thesis/source.json",
    "twin-cylinder-thesis/figures.json",
    "twin-cylinder-thesis/boxer-in-phase.toml",
    "twin-cylinder-thesis/boxer-out-of-phase.toml",
    "twin-cylinder-thesis/in-line-four.toml",
    "twin-cylinder-thesis/in-line-in-phase.toml",
    "twin-cylinder-thesis/in-line-out-of-phase.toml",
    "twin-cylinder-thesis/single.toml",
    "twin-cylinder-thesis/table-01.json",
    "twin-cylinder-thesis/table-02.json",
    "twin-cylinder-thesis/table-03.json",
    "twin-cylinder-thesis/table-04.json",
    "twin-cylinder-thesis/table-05.json",
    "twin-cylinder-thesis/table-06.json",
    "twin-cylinder-thesis/table-07.json",
    "twin-cylinder-thesis/table-08.json",
    "twin-cylinder-thesis/table-09.json",
    "twin-cylinder-thesis/table-10.json",
    "twin-cylinder-thesis/table-11.json",
    "twin-cylinder-thesis/table-12.json",
    "twin-cylinder-thesis/table-13.json",
    "twin-cylinder-thesis/table-14.json",
    "twin-cylinder-thesis/table-15.json",
    "twin-cylinder-thesis/table-16.json",
    "twin-cylinder-thesis/table-17.json",
    "twin-cylinder-thesis/table-18.json",
    "twin-cylinder-thesis/table-19.json",
    "twin-cylinder-thesis/table-20.json",
    "twin-cylinder-thesis/table-21.json",
    "twin-cylinder-thesis/table-22.json",
    "twin-cylinder-thesis/table-23.json",
    "twin-cylinder-thesis/table-24.json",
    "twin-cylinder-thesis/table-25.json",
    "twin-cylinder-thesis/table-26.json",
    "twin-cylinder-thesis/table-27.json",
    "twin-cylinder-thesis/table-28.json",
    "twin-cylinder-thesis/table-29.json",
    "twin-cylinder-thesis/table-30.json",
    "twin-cylinder-thesis/table-31.json",
    "twin-cylinder-thesis/table-32.json",
    "twin-cylinder-thesis/table-33.json",
    "twin-cylinder-thesis/table-34.json",
    "twin-cylinder-thesis/table-35.json",
    "twin-cylinder-thesis/table-36.json",
    "twin-cylinder-thesis/table-37.json",
    "twin-cylinder-thesis/table-38.json",
    "twin-cylinder-thesis/table-39.json",
    "twin-cylinder-thesis/table-40.json",
    "twin-cylinder-thesis/table-41.json",
    "twin-cylinder-thesis/table-42.json",
    "twin-cylinder-thesis/table-43.json",
    "twin-cylinder-thesis/table-44.json",
    "twin-cylinder-thesis/table-45.json",
    "twin-cylinder-thesis/table-46.json",
    "twin-cylinder-thesis/table-47.json",
    "twin-cylinder-thesis/table-48.json",
    "twin-cylinder-thesis/table-49.json",
    "twin-cylinder-thesis/table-50.json",
    "twin-cylinder-thesis/table-51.json",
    "twin-cylinder-thesis/table-52.json",
    "twin-cylinder-thesis/table-53.json",
    "twin-cylinder-thesis/table-54.json",
    "twin-cylinder-thesis/table-55.json",
    "twin-cylinder-thesis/section-5.json",
    "twin-cylinder-thesis/text.json",
    "three-four-cylinder-thesis/source.json",
    "three-four-cylinder-thesis/figures.json",
    "three-four-cylinder-thesis/four-cylinder.toml",
    "three-four-cylinder-thesis/four-cylinder-simulated.toml",
    "three-four-cylinder-thesis/three-cylinder.toml",
    "three-four-cylinder-thesis/three-cylinder-simulated.toml",
    "three-four-cylinder-thesis/section-1.3.json",
    "three-four-cylinder-thesis/table-3.1.json",
    "three-four-cylinder-thesis/table-3.2.json",
    "three-four-cylinder-thesis/table-3.3.json",
    "three-four-cylinder-thesis/tables-3.4-3.8.json",
    "three-four-cylinder-thesis/section-3.6.json",
    "three-four-cylinder-thesis/table-4.2.json",
    "three-four-cylinder-thesis/table-4.3.json",
    "three-four-cylinder-thesis/table-4.4.json",
    "three-four-cylinder-thesis/table-3.9.json",
    "three-four-cylinder-thesis/figures-3.23-3.27.json",
    "three-four-cylinder-thesis/figures-4.12-4.16.json",
    "flexible-paper/source.json",
    "flexible-paper/figures.json",
    "flexible-paper/single.toml",
    "flexible-paper/rigid-run.toml",
    "flexible-paper/three-mains.toml",
    "flexible-paper/three-mains-films.toml",
    "flexible-paper/two-mains.toml",
    "flexible-paper/thin-web.toml",
    "flexible-paper/bearing-films.json",
    "flexible-paper/bearing-models.json",
    "flexible-paper/crankpin.json",
    "flexible-paper/text.json",
    "flexible-paper/static-case.json",
    "balancing-tool-paper/source.json",
    "balancing-tool-paper/figures.json",
    "balancing-tool-paper/in-line-three.toml",
    "balancing-tool-paper/v4-90.toml",
    "balancing-tool-paper/table-2.json",
    "balancing-tool-paper/table-3.json",
    "balancing-tool-paper/table-5.json",
    "balancing-tool-paper/text.json",
    "two-plane-example/source.json",
    "two-plane-example/two-planes.toml",
    "two-plane-example/two-planes.json",
    "balance-grade-example/source.json",
    "balance-grade-example/tool-holder.toml",
    "balance-grade-example/grade.json",
    "bobweight-example/source.json",
    "bobweight-example/ford-400.toml",
    "bobweight-example/bobweight.json",
    "torsional-chains/source.json",
    "torsional-chains/marine-geared-set.toml",
    "torsional-chains/marine-geared-set.json",
    "torsional-chains/six-masses.toml",
    "torsional-chains/six-masses.json",
    "modelica-engines/source.json",
    "modelica-engines/v6.toml",
    "modelica-engines/single-gas.toml",
    "modelica-engines/single.toml",
    "modelica-engines/slider-crank.toml",
    "modelica-engines/v6.json",
    "modelica-engines/single-gas.json",
    "modelica-engines/single.json",
    "modelica-engines/slider-crank.json",
    "oil-films/source.json",
    "oil-films/finite-films.json",
    "oil-films/short-bearing.json",
    "elastic-bodies/source.json",
    "elastic-bodies/elastic-bodies.json",
    "mechanisms/source.json",
    "mechanisms/squeezer.json",
];

/// The synthetic pressure traces, and gas laws of others as traces, by the names under which engine files ask for them.
pub const TRACES: [(&str, &str); 6] = [
    ("pressure-1000.csv", include_str!("../validation/traces/pressure-1000.csv")),
    ("pressure-2000.csv", include_str!("../validation/traces/pressure-2000.csv")),
    ("pressure-3000.csv", include_str!("../validation/traces/pressure-3000.csv")),
    ("pressure-4000.csv", include_str!("../validation/traces/pressure-4000.csv")),
    ("../traces/modelica-v6.csv", include_str!("../validation/traces/modelica-v6.csv")),
    ("../traces/modelica-single.csv", include_str!("../validation/traces/modelica-single.csv")),
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn every_file_of_the_folder_is_embedded_once() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("validation");
        let mut found = Vec::new();
        for source in std::fs::read_dir(folder).unwrap() {
            let source = source.unwrap().path();
            // Other folders hold evidence that tests read, not printed numbers.
            if !source.join("source.json").is_file() {
                continue;
            }
            for file in std::fs::read_dir(&source).unwrap() {
                let file = file.unwrap().path();
                let name = |p: &Path| p.file_name().unwrap().to_str().unwrap().to_string();
                if name(&file) != "README.md" {
                    found.push(format!("{}/{}", name(&source), name(&file)));
                }
            }
        }
        let mut embedded: Vec<_> = FILES.iter().map(|(path, _)| path.to_string()).collect();
        found.sort();
        embedded.sort();
        assert_eq!(found, embedded);
    }
}
