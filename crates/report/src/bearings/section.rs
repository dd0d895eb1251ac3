//! The section of the report on what pistons, pins and bearings carry.

use crate::bearings::tables::{BearingSizes, bearings_tables, without_mains_words};
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::plot::{AnglePlot, Series};
use crate::kit::polar::polar_panel;
use crate::kit::section::Section;
use lanchester_mechanism::{BearingLoads, CylinderBearings};
use num_complex::Complex64;

/// Two loads that differ by less than this share of their largest are the same.
const SAME: f64 = 1e-6;

/// Loads of the bearings at one speed.
#[derive(Debug, Clone, Copy)]
pub struct BearingsInput<'a> {
    /// All loads together first; then, as far as they are to be drawn, those of gas and of inertia.
    pub parts: &'a [BearingLoads],
    /// Without counterweights, where the engine has some.
    pub bare: Option<&'a BearingLoads>,
    /// Sizes of the bearings, as far as they are known.
    pub sizes: BearingSizes,
}

/// Pistons, pins and bearings, as a section of a report; `None` where there is nothing to show.
pub fn bearings_section(input: &BearingsInput<'_>) -> Option<Section> {
    let whole = input.parts.first()?;
    let groups = alike(&whole.cylinders);
    let mut figures = over_angle(input.parts, &groups);
    figures.extend(crankpins(input.parts, &groups));
    figures.extend(mains(input.parts));
    let rpm = number::terminal(number::rpm(whole.speed), 0);
    let words = format!(
        "At {rpm} rpm under {}. Main bearings are loaded throw by throw, each stretch between two of them on its own.",
        whole.part.name()
    );
    let section = Section::new("bearings", "Bearings", "Pistons, pins and bearings")
        .lead(lead(whole))
        .words(words)
        .paragraphs(without_mains_words(whole))
        .rows(figures)
        .tables(bearings_tables(whole, input.parts, input.bare, input.sizes));
    Some(section)
}

/// The most loaded main bearing, and the largest loads of rods and pistons.
fn lead(loads: &BearingLoads) -> String {
    let newtons = |value: f64| format!("{} N", number::short(value, 4));
    let largest = |of: fn(&CylinderBearings) -> f64| loads.cylinders.iter().map(of).fold(0.0, f64::max);
    let several = loads.mains.iter().any(|main| main.crankshaft > 1);
    let main = loads.mains.iter().max_by(|a, b| a.load.peak.value.total_cmp(&b.load.peak.value));
    let main = main.map_or_else(String::new, |main| {
        let of = if several { format!(" of crankshaft {}", main.crankshaft) } else { String::new() };
        format!("Main bearing {}{of} carries most, {}. ", main.main, newtons(main.load.peak.value))
    });
    format!(
        "{main}Crankpins carry up to {}, piston pins up to {}; the side thrust is at most {}.",
        newtons(largest(|one| one.lower_pin.peak.value)),
        newtons(largest(|one| one.piston_pin.peak.value)),
        newtons(largest(|one| one.largest_thrust.value.abs()))
    )
}

/// Cylinders of which the loads are the same but for the time: places in the list.
fn alike(cylinders: &[CylinderBearings]) -> Vec<Vec<usize>> {
    let mut groups: Vec<(Vec<usize>, [Vec<f64>; 4])> = Vec::new();
    for (index, cylinder) in cylinders.iter().enumerate() {
        let part = |of: fn(&Complex64) -> f64| cylinder.rod_frame.iter().map(of).collect();
        let mut traces =
            [cylinder.side_thrust.clone(), cylinder.radial.clone(), part(|f| f.re), part(|f| f.im)];
        for trace in &mut traces {
            trace.sort_by(f64::total_cmp);
        }
        match groups.iter_mut().find(|(_, known)| same(known, &traces)) {
            Some((members, _)) => members.push(index),
            None => groups.push((vec![index], traces)),
        }
    }
    groups.into_iter().map(|(members, _)| members).collect()
}

/// Whether sorted traces hold the same values.
fn same(one: &[Vec<f64>; 4], other: &[Vec<f64>; 4]) -> bool {
    one.iter().zip(other).all(|(one, other)| {
        let largest = one.iter().chain(other).fold(0.0f64, |m, v| m.max(v.abs()));
        one.len() == other.len() && one.iter().zip(other).all(|(a, b)| (a - b).abs() <= SAME * largest)
    })
}

/// "cylinder 2", "cylinders 1, 3", "all cylinders".
fn named(group: &[usize], count: usize) -> String {
    match group {
        [only] => format!("cylinder {}", only + 1),
        all if all.len() == count => "all cylinders".to_owned(),
        some => {
            let numbers: Vec<String> = some.iter().map(|k| (k + 1).to_string()).collect();
            format!("cylinders {}", numbers.join(", "))
        }
    }
}

/// At whose angles cylinders alike are drawn.
fn at_angles_of(group: &[usize]) -> String {
    match group {
        [first, _, ..] => format!(" Drawn at the angles of cylinder {}.", first + 1),
        [] | [_] => String::new(),
    }
}

/// Piston and crankpin over the crank angle, for one of the cylinders alike.
fn over_angle(parts: &[BearingLoads], groups: &[Vec<usize>]) -> Vec<Figure> {
    let of_group = |group: &Vec<usize>| {
        let first = *group.first()?;
        let count = parts.first()?.cylinders.len();
        let panel = |quantity: &str, of: &dyn Fn(&CylinderBearings) -> Vec<f64>| -> Panel {
            let values: Vec<Vec<f64>> = parts.iter().map(|loads| of(&loads.cylinders[first])).collect();
            let series = parts.iter().zip(&values).enumerate().map(|(style, (loads, values))| Series {
                name: loads.part.name().to_owned(),
                style,
                values,
            });
            let (theta, period) = (&parts[0].theta, parts[0].period);
            AnglePlot { quantity, unit: "N", theta, period, series: series.collect() }.panel()
        };
        let mut panels = vec![
            panel("Rod on the piston pin, along the cylinder", &|c| {
                c.piston_pin.load.iter().map(|f| f.re).collect()
            }),
            panel("Side thrust of the piston on the wall", &|c| c.side_thrust.clone()),
        ];
        if !parts[0].cylinders[first].radial.is_empty() {
            panels.push(panel("Rod on the crankpin, outward", &|c| c.radial.clone()));
            panels.push(panel("Rod on the crankpin, in the sense of rotation", &|c| c.tangential.clone()));
        }
        Some(Figure {
            id: format!("rod-forces-{}", first + 1),
            title: format!("Piston and crankpin over the cycle, {}", named(group, count)),
            caption: format!(
                "Positive towards the cylinder head, along v, away from the crank axis.{}",
                at_angles_of(group)
            ),
            panels,
            columns: 2,
        })
    };
    groups.iter().filter_map(of_group).collect()
}

/// Crankpins as the pin and as the rod feel them, one of the cylinders alike.
fn crankpins(parts: &[BearingLoads], groups: &[Vec<usize>]) -> Option<Figure> {
    let count = parts.first()?.cylinders.len();
    let reach = parts
        .iter()
        .flat_map(|loads| &loads.cylinders)
        .map(|cylinder| cylinder.lower_pin.peak.value)
        .fold(0.0, f64::max);
    let mut panels = Vec::new();
    for group in groups {
        let Some(first) = group.first().copied() else { continue };
        let name = named(group, count);
        if !parts[0].cylinders[first].radial.is_empty() {
            panels.push(polar_panel(
                parts,
                [&format!("On the pin outward, {name}"), "on the pin, in the sense of rotation"],
                reach,
                |loads| {
                    let own = &loads.cylinders[first];
                    own.radial.iter().zip(&own.tangential).map(|(r, t)| Complex64::new(*r, *t)).collect()
                },
            ));
        }
        panels.push(polar_panel(
            parts,
            [&format!("On the rod towards the piston, {name}"), "on the rod, across"],
            reach,
            |loads| loads.cylinders[first].rod_frame.clone(),
        ));
    }
    Some(Figure {
        id: "crankpins".to_owned(),
        title: "Polar diagrams of the crankpins".to_owned(),
        caption: "Load over the cycle in the frame that turns with the pin, and with opposite sign in that of the rod; all to one scale."
            .to_owned(),
        panels,
        columns: 2,
    })
}

/// All main bearings in the block's frame, and their journals in that which turns with them.
fn mains(parts: &[BearingLoads]) -> Vec<Figure> {
    let Some(whole) = parts.first().filter(|loads| !loads.mains.is_empty()) else { return Vec::new() };
    let reach =
        parts.iter().flat_map(|loads| &loads.mains).map(|main| main.load.peak.value).fold(0.0, f64::max);
    let several = whole.mains.iter().any(|main| main.crankshaft > 1);
    let panels = |side: &str, across: &str, of: &dyn Fn(&BearingLoads, usize) -> Vec<Complex64>| {
        let panel = |(k, main): (usize, &lanchester_mechanism::MainBearing)| {
            let shaft = if several { format!("crankshaft {}, ", main.crankshaft) } else { String::new() };
            let name = format!("{side} ({shaft}main {})", main.main);
            polar_panel(parts, [&name, across], reach, |loads| of(loads, k))
        };
        whole.mains.iter().enumerate().map(panel).collect::<Vec<_>>()
    };
    vec![
        Figure {
            id: "main-bearings-polar".to_owned(),
            title: "Polar diagrams of the main bearings".to_owned(),
            caption: "Journal on bearing over the cycle, in the frame of the block; all to one scale.".to_owned(),
            panels: panels("On the bearing, x", "on the bearing, y", &|loads, k| {
                loads.mains[k].load.load.clone()
            }),
            columns: 3,
        },
        Figure {
            id: "main-journals-polar".to_owned(),
            title: "Polar diagrams of the main journals".to_owned(),
            caption: "Bearing on journal over the cycle, in the frame that turns with the journal; all to one scale."
                .to_owned(),
            panels: panels("On the journal, along throw 1", "on the journal, a quarter turn on", &|loads, k| {
                loads.mains[k].journal_frame.clone()
            }),
            columns: 3,
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_have_names() {
        assert_eq!(named(&[1], 4), "cylinder 2");
        assert_eq!(named(&[0, 2], 4), "cylinders 1, 3");
        assert_eq!(named(&[0, 1], 2), "all cylinders");
    }
}
