//! The block and its mounts.

use super::reader::Reader;
use crate::document::{Field, Section, Spot};
use lanchester_diagnostic::Mistake;
use lanchester_model::{Block, InertiaFault, MovingParts};
use lanchester_model::{FRAME_AXES, MAX_LOSS_FACTOR, Mount, MountPoint, MountSpring};
use lanchester_units::{Dimension, readable};

/// Two directions stand at a right angle if the cosine between them is less than this (about 1 degree); the second is
/// then turned the rest of the way.
const RIGHT_ANGLE: f64 = 0.02;

/// Directions within this of unit length and of a right angle are taken as they are.
const EXACT: f64 = 1e-15;

/// Keys that say nothing without a stiffness.
const OF_SPRING: [&str; 6] = ["direction", "second_direction", "damping", "loss_factor", "preload", "table"];

impl<'a> Reader<'a> {
    pub(super) fn mounts(&mut self) -> Option<Vec<Mount>> {
        let sections = self.root.tables("mount").or(&[])?;
        let mounts: Vec<Option<Mount>> =
            sections.iter().enumerate().map(|(index, section)| self.mount(index, section)).collect();
        for (index, mount) in mounts.iter().enumerate() {
            let Some(mount) = mount else { continue };
            let twin = mounts[..index].iter().position(|other| {
                other.as_ref().is_some_and(|other| (other.x, other.y, other.z) == (mount.x, mount.y, mount.z))
            });
            if let Some(twin) = twin {
                let (one, two) = (twin + 1, index + 1);
                self.mistakes.push(
                    Mistake::error(
                        "E0507",
                        sections[index].span.clone(),
                        format!("mounts {one} and {two} stand in one place"),
                    )
                    .related(sections[twin].span.clone(), "the other"),
                );
            }
        }
        self.check_unique_parts("mount", sections, &mounts, |mount| &mount.name);
        self.all_or_none(sections);
        let stiff = sections.iter().find(|section| section.has("stiffness"));
        match (stiff, self.section("block")) {
            (Some(stiff), (None, false)) => self.missing(
                stiff.key_span("stiffness"),
                "`stiffness` needs the body that stands on the mounts, and [block] is missing".into(),
                self.root.example("block"),
            ),
            (None, (Some(block), _)) if self.whole => self.mistakes.push(
                Mistake::warning(
                    "W0204",
                    block.span.clone(),
                    "[block] has no effect, since no mount has a stiffness",
                )
                .hint("give every [[mount]] a `stiffness`"),
            ),
            _ => {}
        }
        mounts.into_iter().collect()
    }

    /// A block moves on all of its mounts: each has a stiffness, or none has.
    fn all_or_none(&mut self, sections: &'a [Section]) {
        let Some(stiff) = sections.iter().position(|section| section.has("stiffness")) else { return };
        for (index, section) in sections.iter().enumerate().filter(|(_, section)| !section.has("stiffness")) {
            self.missing(
                section.span.clone(),
                format!("mount {} needs a `stiffness`, since mount {} has one", index + 1, stiff + 1),
                section.example("stiffness"),
            );
        }
    }

    fn mount(&mut self, index: usize, section: &'a Section) -> Option<Mount> {
        let name = section.text("name").or(format!("mount {}", index + 1));
        let [x, y, z] = ["x", "y", "z"].map(|key| self.required(section, key, section.number(key)));
        let spring = self.spring(section);
        Some(Mount { name: name?, x: x?, y: y?, z: z?, spring: spring? })
    }

    /// The outer `None` says bad, the inner one absent.
    fn spring(&mut self, section: &'a Section) -> Option<Option<MountSpring>> {
        if !section.has("stiffness") {
            for key in OF_SPRING.into_iter().filter(|key| section.has(key)) {
                self.without_effect(section, key, "`stiffness` is missing", &section.example("stiffness"));
            }
            return Some(None);
        }
        let stiffness = self.stiffness(section);
        let damping = self.three(section, "damping", section.numbers("damping"));
        let loss_factor = self.loss_factor(section);
        let preload = section.number("preload").or(0.0);
        let points = section.tables("table").or(&[]);
        let table = points.and_then(|points| self.points(points));
        if section.has("loss_factor") && section.has("table") {
            self.without_effect(section, "loss_factor", "`table` has its own", "move it into the table");
        }
        let even = |values: &Option<[f64; 3]>| values.is_none_or(|v| v[1] == v[2]);
        let even_points = table
            .iter()
            .flatten()
            .all(|p: &MountPoint| p.stiffness[1] == p.stiffness[2] && p.loss_factor[1] == p.loss_factor[2]);
        let round = even(&stiffness) && even(&damping) && even(&loss_factor) && even_points;
        let axes = self.axes(section, round);
        Some(Some(MountSpring {
            axes: axes?,
            stiffness: stiffness?,
            damping: damping?,
            loss_factor: loss_factor?,
            preload: preload?,
            table: table?,
        }))
    }

    /// A stiffness, positive in some direction.
    fn stiffness(&mut self, section: &'a Section) -> Option<[f64; 3]> {
        let given = self.required(section, "stiffness", section.numbers("stiffness"));
        let values = self.three_of(section, "stiffness", given?)?;
        if values.iter().all(|&k| k == 0.0) {
            let message = "a mount must be stiff in at least one direction, got 0 in all";
            self.mistakes.push(
                Mistake::error("E1401", section.value_span("stiffness"), message)
                    .hint(section.example("stiffness")),
            );
            return None;
        }
        Some(values)
    }

    fn loss_factor(&mut self, section: &'a Section) -> Option<[f64; 3]> {
        let values = self.three(section, "loss_factor", section.numbers("loss_factor"))?;
        if let Some(bad) = values.into_iter().find(|l| *l > MAX_LOSS_FACTOR) {
            let message = format!("`loss_factor` must lie between 0 and {MAX_LOSS_FACTOR}, got {bad}");
            self.mistakes.push(
                Mistake::error("E1403", section.value_span("loss_factor"), message)
                    .hint("it is the tangent of the loss angle, such as 0.1 for rubber"),
            );
            return None;
        }
        Some(values)
    }

    /// The rows of a table, which must rise.
    fn points(&mut self, sections: &'a [Section]) -> Option<Vec<MountPoint>> {
        let one = |reader: &mut Self, section: &'a Section| {
            let frequency = reader.required(section, "frequency", section.number("frequency"));
            let stiffness = reader.stiffness(section);
            let loss_factor = reader.loss_factor(section);
            Some(MountPoint {
                angular_frequency: frequency?,
                stiffness: stiffness?,
                loss_factor: loss_factor?,
            })
        };
        let points: Vec<Option<MountPoint>> = sections.iter().map(|section| one(self, section)).collect();
        let points: Vec<MountPoint> = points.into_iter().collect::<Option<_>>()?;
        let falls = points.windows(2).position(|w| w[1].angular_frequency <= w[0].angular_frequency);
        if let Some(place) = falls {
            let message = "the frequencies of a mount's table must rise";
            self.mistakes.push(
                Mistake::error("E1404", sections[place + 1].value_span("frequency"), message)
                    .label("not above the one before")
                    .related(sections[place].value_span("frequency"), "the one before"),
            );
            return None;
        }
        Some(points)
    }

    /// The three directions of a mount; `round`: it is the same across the first.
    fn axes(&mut self, section: &'a Section, round: bool) -> Option<[[f64; 3]; 3]> {
        if !section.has("direction") {
            if section.has("second_direction") {
                let hint = section.example("direction");
                self.without_effect(section, "second_direction", "`direction` is missing", &hint);
                return None;
            }
            return Some(FRAME_AXES);
        }
        let first = self.direction(section, "direction", FRAME_AXES[0])?;
        if !section.has("second_direction") && !round {
            self.missing(
                section.key_span("direction"),
                "`direction` needs `second_direction` beside it, since the mount is not the same across it"
                    .into(),
                section.example("second_direction"),
            );
            return None;
        }
        // Any direction across the first will do where the mount is round.
        let aside = (0..3).min_by(|&a, &b| first[a].abs().total_cmp(&first[b].abs())).unwrap_or(0);
        let across = cross(first, FRAME_AXES[aside]);
        let second = if section.has("second_direction") {
            self.direction(section, "second_direction", FRAME_AXES[1])?
        } else {
            unit(across)?
        };
        let cosine = dot(first, second);
        if cosine.abs() > RIGHT_ANGLE {
            let message = format!(
                "`second_direction` must be at a right angle to `direction`, got {:.1} deg",
                cosine.clamp(-1.0, 1.0).acos().to_degrees()
            );
            self.mistakes.push(
                Mistake::error("E1402", section.value_span("second_direction"), message)
                    .related(section.value_span("direction"), "the first"),
            );
            return None;
        }
        let second = if cosine.abs() <= EXACT {
            second
        } else {
            unit([0, 1, 2].map(|j| second[j] - cosine * first[j]))?
        };
        Some([first, second, cross(first, second)])
    }

    /// A direction of unit length.
    fn direction(&mut self, section: &'a Section, key: &str, default: [f64; 3]) -> Option<[f64; 3]> {
        let given = match section.numbers(key) {
            Field::Absent => return Some(default),
            Field::Bad => return None,
            Field::Given(spot) => spot.value,
        };
        let values = self.exactly_three(section, key, &given)?;
        let unit = unit(values);
        if unit.is_none() {
            let message = format!("`{key}` must point somewhere, got 0 in all components");
            self.mistakes
                .push(Mistake::error("E1402", section.value_span(key), message).hint(section.example(key)));
        }
        unit
    }

    /// One value for all directions, or three; 0 if the key is not there.
    fn three(&mut self, section: &'a Section, key: &str, field: Field<Vec<Spot<f64>>>) -> Option<[f64; 3]> {
        match field {
            Field::Absent => Some([0.0; 3]),
            Field::Bad => None,
            Field::Given(spot) => self.three_of(section, key, spot.value),
        }
    }

    fn three_of(&mut self, section: &'a Section, key: &str, values: Vec<Spot<f64>>) -> Option<[f64; 3]> {
        match values.as_slice() {
            [one] => Some([one.value; 3]),
            values => self.exactly_three(section, key, values),
        }
    }

    fn exactly_three(&mut self, section: &'a Section, key: &str, values: &[Spot<f64>]) -> Option<[f64; 3]> {
        if let [a, b, c] = values {
            return Some([a.value, b.value, c.value]);
        }
        let message = format!("`{key}` needs three numbers, got {}", values.len());
        self.mistakes
            .push(Mistake::error("E0206", section.value_span(key), message).hint(section.example(key)));
        None
    }

    /// `[block]`: the outer `None` says bad, the inner one absent.
    pub(super) fn block(&mut self) -> Option<Option<Block>> {
        let (section, broken) = self.section("block");
        let Some(section) = section else { return (!broken).then_some(None) };
        let mass = self.required(section, "mass", section.number("mass"));
        let centre = self.required(section, "centre", section.numbers("centre"));
        let centre = centre.and_then(|list| self.exactly_three(section, "centre", &list));
        let inertia = self.required(section, "inertia", section.numbers("inertia"));
        let inertia = inertia.and_then(|list| self.inertia(section, &list));
        let moving_parts = section.word("moving_parts").or("included");
        let gravity = self.direction(section, "gravity", [-1.0, 0.0, 0.0]);
        let torque = match section.numbers("driveline_torque") {
            Field::Given(spot) if spot.value.len() == 1 => Some([0.0, 0.0, spot.value[0].value]),
            field => self.three(section, "driveline_torque", field),
        };
        let (inertia, products) = inertia?;
        let block = Block {
            mass: mass?,
            centre: centre?,
            inertia,
            products,
            moving_parts: if moving_parts? == "added" { MovingParts::Added } else { MovingParts::Included },
            gravity: gravity?,
            driveline_torque: torque?,
        };
        let Some(fault) = block.inertia_fault() else { return Some(Some(block)) };
        let (axes, planes) = (["xx", "yy", "zz"], ["xy", "yz", "zx"]);
        let text = |value| readable(value, Dimension::Inertia);
        let message = match fault {
            InertiaFault::NotPositive(k) => {
                format!("moment of inertia {} must be positive, got {}", axes[k], text(block.inertia[k]))
            }
            InertiaFault::Triangle(k) => format!(
                "moment of inertia {} must be at most the other two together, {}, got {}",
                axes[k],
                text(block.inertia[(k + 1) % 3] + block.inertia[(k + 2) % 3]),
                text(block.inertia[k])
            ),
            InertiaFault::Product(k, most) => format!(
                "product of inertia {} must be at most {} in amount, got {}",
                planes[k],
                text(most),
                text(block.products[k])
            ),
            InertiaFault::Products => "the three products of inertia contradict one another".to_owned(),
        };
        self.mistakes.push(
            Mistake::error("E1405", section.value_span("inertia"), message)
                .label("no body has this inertia")
                .hint("moments and products are about the centre of mass, along the axes of the frame"),
        );
        None
    }

    /// Moments and products of inertia.
    fn inertia(&mut self, section: &'a Section, list: &[Spot<f64>]) -> Option<([f64; 3], [f64; 3])> {
        match list {
            [a, b, c] => Some(([a.value, b.value, c.value], [0.0; 3])),
            [a, b, c, d, e, f] => Some(([a.value, b.value, c.value], [d.value, e.value, f.value])),
            _ => {
                let message = format!("`inertia` needs three numbers or six, got {}", list.len());
                self.mistakes.push(
                    Mistake::error("E0206", section.value_span("inertia"), message)
                        .hint(section.example("inertia")),
                );
                None
            }
        }
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The vector with unit length; `None` if it has none.
fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    let largest = vector.iter().fold(0.0f64, |largest, v| largest.max(v.abs()));
    if largest == 0.0 {
        return None;
    }
    let size = dot(vector, vector).sqrt();
    if (size - 1.0).abs() <= EXACT {
        return Some(vector);
    }
    let vector = vector.map(|v| v / largest);
    let size = dot(vector, vector).sqrt();
    Some(vector.map(|v| v / size))
}
