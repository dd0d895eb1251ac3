//! Bodies that follow block and crank: the rows of their transformers.

use super::Builder;
use super::request::EngineBlock;
use super::words::{combination, matrix};

/// The flows that bodies follow, in the order of the transformers' ports.
#[derive(Debug, Clone)]
pub(crate) struct Frame {
    pub(crate) block: EngineBlock,
    /// Junctions of the block, then of the crank.
    pub(crate) junctions: Vec<&'static str>,
    /// Axes in which bodies move.
    pub(crate) axes: Vec<&'static str>,
}

/// A point or vector fixed to a body: its components in block axes, from the block's centre, and their rates by the crank angle, as texts.
#[derive(Debug, Clone)]
pub(crate) struct Arm {
    pub(crate) at: [String; 3],
    pub(crate) rate: [String; 2],
}

impl Frame {
    pub(crate) fn new(block: EngineBlock) -> Frame {
        let (junctions, axes): (&[&str], &[&str]) = match block {
            EngineBlock::Fixed => (&["crank"], &["x", "y"]),
            EngineBlock::Plane => (&["vx", "vy", "wz", "crank"], &["x", "y"]),
            EngineBlock::Space | EngineBlock::Held => {
                (&["vx", "vy", "vz", "wx", "wy", "wz", "crank"], &["x", "y", "z"])
            }
        };
        Frame { block, junctions: junctions.to_vec(), axes: axes.to_vec() }
    }

    /// Component `row` in ground axes of a vector in block axes.
    pub(crate) fn turned(&self, row: usize, vector: [&str; 3]) -> String {
        let product = |factor: &str, text: &str| match text {
            "0" => "0".to_owned(),
            "1" => factor.to_owned(),
            _ if text.contains(' ') => format!("{factor}*({text})"),
            _ => format!("{factor}*{text}"),
        };
        match self.block {
            EngineBlock::Fixed => vector[row].to_owned(),
            EngineBlock::Plane => {
                let (cos, sin) = ([vector[0], vector[1]], [vector[1], vector[0]]);
                let sign = if row == 0 { -1.0 } else { 1.0 };
                let (a, b) = (product("cos_roll", cos[row]), product("sin_roll", sin[row]));
                combination(&[(1.0, &a), (sign, &b)])
            }
            EngineBlock::Space | EngineBlock::Held => {
                let parts: Vec<String> = (0..3)
                    .map(|column| product(&format!("r{}{}", row + 1, column + 1), vector[column]))
                    .collect();
                combination(&[(1.0, &parts[0]), (1.0, &parts[1]), (1.0, &parts[2])])
            }
        }
    }

    /// Rows of the velocity of a point, or of the rate of a vector that is fixed to no point.
    pub(crate) fn rows(&self, arm: &Arm, is_point: bool) -> Vec<Vec<String>> {
        let [x, y, z] = [&arm.at[0], &arm.at[1], &arm.at[2]].map(String::as_str);
        let minus = |text: &str| combination(&[(-1.0, text)]);
        let [minus_x, minus_y, minus_z] = [minus(x), minus(y), minus(z)];
        let [dx, dy] = [&arm.rate[0], &arm.rate[1]].map(String::as_str);
        (0..self.axes.len())
            .map(|row| {
                let mut entries = Vec::new();
                if self.block != EngineBlock::Fixed {
                    for column in 0..self.axes.len() {
                        entries.push(if is_point && column == row { "1" } else { "0" }.to_owned());
                    }
                }
                if self.block.is_spatial() {
                    entries.push(self.turned(row, ["0", &minus_z, y]));
                    entries.push(self.turned(row, [z, "0", &minus_x]));
                }
                if self.block != EngineBlock::Fixed {
                    entries.push(self.turned(row, [&minus_y, x, "0"]));
                }
                entries.push(self.turned(row, [dx, dy, "0"]));
                entries
            })
            .collect()
    }
}

impl Builder<'_> {
    /// A transformer from the flows of block and crank; gives the number of its first port out.
    pub(crate) fn follower(&mut self, name: &str, rows: &[Vec<String>]) -> usize {
        self.follower_of(name, rows, &[])
    }

    /// The same with more columns, of the flows of other junctions.
    pub(crate) fn follower_of(&mut self, name: &str, rows: &[Vec<String>], others: &[String]) -> usize {
        self.element(name, "MTF", &[("matrix", &matrix(rows))]);
        let junctions: Vec<String> =
            self.frame.junctions.iter().map(|own| (*own).to_owned()).chain(others.iter().cloned()).collect();
        for (port, junction) in junctions.iter().enumerate() {
            self.bond(junction, &format!("{name}.{}", port + 1));
        }
        junctions.len() + 1
    }

    /// A point mass with its weight.
    pub(crate) fn point(&mut self, name: &str, mass: &str, arm: &Arm) {
        let rows = self.frame.rows(arm, true);
        let first = self.follower(&format!("{name}_motion"), &rows);
        let axes = self.frame.axes.clone();
        for (k, axis) in axes.into_iter().enumerate() {
            let store = format!("{name}_{axis}");
            self.element(&store, "I", &[("inertia", mass), ("domain", "translation")]);
            self.out(&format!("{name}_motion.{}", first + k), &store, name, axis, k, mass);
        }
    }

    /// Bonds a port of a transformer to a store, with the weight that acts there.
    pub(crate) fn out(&mut self, port: &str, store: &str, name: &str, axis: &str, k: usize, mass: &str) {
        let part = if self.request.gravity == 0.0 { 0.0 } else { self.numbers.gravity[k] };
        if part == 0.0 {
            self.bond(port, store);
            return;
        }
        let junction = format!("{name}_v{axis}");
        let weight = format!("{name}_weight_{axis}");
        self.element(&junction, "1", &[("domain", "translation")]);
        self.bond(port, &junction);
        if !store.is_empty() {
            self.bond(&junction, store);
        }
        self.element(&weight, "Se", &[("effort", &combination(&[(part, &format!("{mass}*g"))]))]);
        self.bond(&weight, &junction);
    }

    /// A point of the block's axes as seen from the block's centre.
    pub(crate) fn seen_from_centre(&self, k: usize, place: f64) -> f64 {
        if self.moves() { place - self.numbers.block_centre[k] } else { place }
    }
}
