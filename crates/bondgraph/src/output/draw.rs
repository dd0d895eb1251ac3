//! A graph as SVG: half arrows, causal strokes, stores that follow and free bonds marked, activated bonds as full arrows.
//!
//! Beside the name of an element stands its value, where a number or a short expression says its law. The graph of an engine stands in
//! tiles: block and crank, every cylinder, rotor and mount.

use crate::causality::Causality;
use crate::expression::{Id, Var};
use crate::graph::{Graph, Law};
use crate::output::export::escaped;
use crate::output::label::{Label, follows, labels};
use crate::output::layout::{MARGIN, Places, places};
use crate::output::tiles::{Tiled, tiled};
use crate::run::simulate::Simulation;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write;

const INK: &str = "#1b1f24";
const FOLLOWS: &str = "#b45309";
const FREE: &str = "#b91c1c";
const SIGNAL: &str = "#1d4ed8";
const VALUE: &str = "#4b5563";

/// A graph with the places of its elements and bonds, for pictures that others draw; lengths in pixels, y downwards.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Placed {
    /// Size of the picture.
    pub size: [f64; 2],
    /// Its elements.
    pub elements: Vec<DrawnElement>,
    /// Its bonds.
    pub bonds: Vec<DrawnBond>,
    /// Tiles of an engine's graph; none of any other.
    pub tiles: Vec<DrawnTile>,
}

/// A tile of an engine's graph: block and crank, a cylinder, a rotor, a mount.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DrawnTile {
    /// What is in it.
    pub title: String,
    /// Its upper left corner.
    pub corner: [f64; 2],
    /// Its size.
    pub size: [f64; 2],
}

/// The name of what a bond to another tile leads to, at its far end.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DrawnName {
    /// Where it ends.
    pub at: [f64; 2],
    /// The name.
    pub name: String,
}

/// An element in its place.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DrawnElement {
    /// Its name.
    pub name: String,
    /// Its kind as it is written.
    pub kind: String,
    /// Its middle.
    pub at: [f64; 2],
    /// Middle and base line of the letters of its kind.
    pub kind_at: [f64; 2],
    /// Its name, and its value where a number or a short expression says its law.
    pub labels: Vec<DrawnLabel>,
    /// Whether it is a store that follows others.
    pub follows: bool,
}

/// Words beside an element.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DrawnLabel {
    /// Their base line, at the side that `anchor` names.
    pub at: [f64; 2],
    /// Which side stands there.
    pub anchor: LabelAnchor,
    /// The words.
    pub text: String,
    /// Whether they are the value; else the name.
    pub is_value: bool,
}

/// Which side of words stands at their place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LabelAnchor {
    /// Their left.
    Start,
    /// Their middle.
    Middle,
    /// Their right.
    End,
}

impl LabelAnchor {
    /// Its word in SVG.
    fn word(self) -> &'static str {
        match self {
            LabelAnchor::Start => "start",
            LabelAnchor::Middle => "middle",
            LabelAnchor::End => "end",
        }
    }
}

/// A bond in its place.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DrawnBond {
    /// Its name, by which its series are called.
    pub name: String,
    /// Its ends along the half arrow.
    pub line: [[f64; 2]; 2],
    /// End of the barb at its head.
    pub barb: [f64; 2],
    /// Ends of the causal stroke.
    pub stroke: [[f64; 2]; 2],
    /// Whether its store follows others.
    pub follows: bool,
    /// Whether its causality is free, within an algebraic loop.
    pub free: bool,
    /// Where it leads, if that is in another tile.
    pub leads_to: Option<DrawnName>,
}

/// Places of a graph with its causality.
pub fn placed(graph: &Graph, causality: &Causality) -> Placed {
    let layout = layout(graph, causality);
    let Layout { labels, tiled, beside } = &layout;
    let drawn = |(index, label): (usize, &Label)| {
        let element = &graph.elements[index];
        let (kind_at, labels) = lettering(graph, tiled, index, label, beside.get(&index).copied());
        DrawnElement {
            name: element.name.clone(),
            kind: element.written.clone(),
            at: tiled.places[index],
            kind_at,
            labels,
            follows: follows(graph, causality, index),
        }
    };
    let [width, height] = layout.extent();
    // As much room on the right as on the left.
    let farthest = tiled.places.iter().map(|place| place[0]).fold(0.0, f64::max) + MARGIN;
    Placed {
        size: [width.max(farthest), height],
        elements: labels.iter().enumerate().map(drawn).collect(),
        bonds: (0..graph.bonds.len()).map(|bond| drawn_bond(graph, causality, &layout.tiled, bond)).collect(),
        tiles: (layout.tiled.tiles.iter())
            .map(|tile| DrawnTile { title: tile.title.clone(), corner: tile.corner, size: tile.size })
            .collect(),
    }
}

/// Largest width of a bond that carries power.
const WIDEST: f64 = 14.0;
/// Most frames of a moving drawing.
const FRAMES: usize = 120;

/// The drawing with bonds as wide as the power through them, moving over `seconds` again and again: black along the half arrow, red
/// against it.
pub fn moving_drawing(graph: &Graph, causality: &Causality, run: &Simulation, seconds: f64) -> String {
    let still = drawing(graph, causality);
    let placed = placed(graph, causality);
    let power = |bond: &DrawnBond| run.values(&format!("{}.power", bond.name)).unwrap_or_default();
    let largest = placed.bonds.iter().flat_map(power).fold(0.0f64, |most, p| most.max(p.abs()));
    let count = run.time.len();
    let step = count.div_ceil(FRAMES).max(1);
    let mut flows = String::new();
    for bond in &placed.bonds {
        let frames: Vec<f64> = power(bond).iter().step_by(step).copied().collect();
        if largest == 0.0 || frames.is_empty() {
            continue;
        }
        let widths: Vec<String> =
            frames.iter().map(|p| format!("{:.1}", WIDEST * (p.abs() / largest).sqrt())).collect();
        let colours: Vec<&str> = frames.iter().map(|p| if *p < 0.0 { FREE } else { SIGNAL }).collect();
        let [[ax, ay], [bx, by]] = bond.line;
        let _ = writeln!(
            flows,
            "<path d=\"M{ax:.1} {ay:.1}L{bx:.1} {by:.1}\" stroke-width=\"0\" stroke=\"{SIGNAL}\" opacity=\"0.35\" stroke-linecap=\"round\">\
             <title>{}</title>\
             <animate attributeName=\"stroke-width\" dur=\"{seconds}s\" repeatCount=\"indefinite\" values=\"{}\"/>\
             <animate attributeName=\"stroke\" dur=\"{seconds}s\" repeatCount=\"indefinite\" calcMode=\"discrete\" values=\"{}\"/></path>",
            escaped(&bond.name),
            widths.join(";"),
            colours.join(";")
        );
    }
    still.replacen("fill=\"#ffffff\"/>\n", &format!("fill=\"#ffffff\"/>\n{flows}"), 1)
}

/// Where everything stands: tiles for the graph of an engine, columns and rows for any other.
struct Layout {
    labels: Vec<Label>,
    tiled: Tiled,
    beside: BTreeMap<usize, f64>,
}

impl Layout {
    /// How far everything reaches, with a margin.
    fn extent(&self) -> [f64; 2] {
        let Layout { labels, tiled, beside } = self;
        let end = |(element, [x, y]): (usize, &[f64; 2])| {
            let wide = match beside.get(&element) {
                Some(side) if *side > 0.0 => labels[element].left + labels[element].right + 16.0,
                _ => labels[element].right,
            };
            [x + wide + 20.0, y + MARGIN]
        };
        let ends: Vec<[f64; 2]> = tiled.places.iter().enumerate().map(end).collect();
        let corners = (tiled.tiles.iter())
            .map(|tile| [tile.corner[0] + tile.size[0] + 20.0, tile.corner[1] + tile.size[1]]);
        let ends: Vec<[f64; 2]> = if tiled.tiles.is_empty() { ends } else { corners.collect() };
        [0, 1].map(|k| ends.iter().map(|end| end[k]).fold(0.0, f64::max))
    }
}

fn layout(graph: &Graph, causality: &Causality) -> Layout {
    let labels = labels(graph, causality);
    if let Some(tiled) = tiled(graph, &labels) {
        return Layout { labels, tiled, beside: BTreeMap::new() };
    }
    let Places { at, beside } = places(graph, &labels);
    Layout { labels, tiled: Tiled { places: at, ..Tiled::default() }, beside }
}

/// The drawing of a graph with its causality.
pub fn drawing(graph: &Graph, causality: &Causality) -> String {
    let layout = layout(graph, causality);
    let [width, bottom] = layout.extent();
    let Layout { labels, tiled, beside } = layout;
    let places = &tiled.places;
    let width = width.max(460.0);
    let legend = bottom + 10.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {:.0}\" width=\"{width:.0}\" height=\"{:.0}\" \
         font-family=\"system-ui, sans-serif\" role=\"img\">\n<title>Bond graph {}</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        legend + 50.0,
        legend + 50.0,
        escaped(&graph.name)
    );
    let _ = writeln!(
        svg,
        "<text x=\"20\" y=\"30\" font-size=\"16\" font-weight=\"600\" fill=\"{INK}\">{}</text>",
        escaped(&graph.name)
    );
    frames(&tiled, &mut svg);
    if tiled.tiles.is_empty() {
        activated(graph, places, &mut svg);
    }
    for bond in 0..graph.bonds.len() {
        half_arrow(graph, causality, &tiled, bond, &mut svg);
    }
    for (here, [x, y], name) in tiled.stubs.values() {
        let (anchor, shift) = if *x < places[*here][0] { ("end", -2.0) } else { ("start", 2.0) };
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"9\" fill=\"#6b7280\" text-anchor=\"{anchor}\">{}</text>",
            x + shift,
            y + 3.0,
            escaped(name)
        );
    }
    for (index, label) in labels.iter().enumerate() {
        let colour = if follows(graph, causality, index) { FOLLOWS } else { INK };
        let lettering = lettering(graph, &tiled, index, label, beside.get(&index).copied());
        symbol(&graph.elements[index].written, &lettering, colour, &mut svg);
    }
    legend_lines(legend, &mut svg);
    svg + "</svg>\n"
}

/// Tiles with their titles.
fn frames(tiled: &Tiled, svg: &mut String) {
    for tile in &tiled.tiles {
        let ([x, y], [width, height]) = (tile.corner, tile.size);
        let _ = writeln!(
            svg,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" rx=\"8\" fill=\"#f6f7f9\" stroke=\"#d5dae1\"/>\n\
             <text x=\"{:.1}\" y=\"{:.1}\" font-size=\"13\" font-weight=\"600\" fill=\"{INK}\">{}</text>",
            x + 12.0,
            y + 21.0,
            escaped(&tile.title)
        );
    }
}

fn legend_lines(legend: f64, svg: &mut String) {
    let words = [
        (INK, "half arrow: positive power; stroke: the effort arrives there"),
        (FOLLOWS, "store that follows others"),
        (FREE, "free causality: algebraic loop"),
        (SIGNAL, "signal"),
    ];
    let mut x = 20.0;
    for (colour, word) in words {
        let y = if colour == INK { legend + 12.0 } else { legend + 32.0 };
        let _ =
            writeln!(svg, "<text x=\"{x:.0}\" y=\"{y:.0}\" font-size=\"11\" fill=\"{colour}\">{word}</text>");
        if colour != INK {
            x += 7.0 * word.len() as f64;
        }
    }
}

/// Where the letters of an element stand, and its name and value.
fn lettering(
    graph: &Graph,
    tiled: &Tiled,
    index: usize,
    label: &Label,
    beside: Option<f64>,
) -> ([f64; 2], Vec<DrawnLabel>) {
    let element = &graph.elements[index];
    let places = &tiled.places;
    let [x, y] = places[index];
    let others: Vec<[f64; 2]> = (element.ports.iter())
        .filter(|bond| !tiled.stubs.contains_key(bond))
        .map(|bond| {
            let ends = &graph.bonds[*bond];
            places[if ends.from == index { ends.to } else { ends.from }]
        })
        .collect();
    let above = others.iter().filter(|[_, oy]| *oy < y - 20.0).count();
    let straight_above = others.iter().any(|[ox, oy]| (ox - x).abs() < 20.0 && *oy < y);
    let ahead = others.iter().any(|[ox, _]| *ox > x + 45.0);
    let is_core = element.is_junction() || element.ports.len() > 1;
    // A name stands where few bonds are: of a junction on the side with fewer, of a one-port away from its bond.
    let (kind_y, name_x, name_y, anchor) = match beside {
        Some(side) => (
            y + 6.0,
            x + 14.0 * side,
            y - 2.0,
            if side < 0.0 { LabelAnchor::End } else { LabelAnchor::Start },
        ),
        None if element.is_junction() && !ahead => (y + 6.0, x + 16.0, y + 4.0, LabelAnchor::Start),
        None if element.is_junction() => {
            (y + 6.0, x + 12.0, if above > 1 { y + 27.0 } else { y - 15.0 }, LabelAnchor::Start)
        }
        None if is_core && straight_above => (y + 6.0, x + 14.0, y - 15.0, LabelAnchor::Start),
        None if tiled.to_the_right.contains(&index) && is_core => {
            (y + 6.0, x - 4.0, y - 17.0, LabelAnchor::Start)
        }
        None if is_core => (y + 6.0, x - 16.0, y - 17.0, LabelAnchor::Start),
        None if limb_is_up(graph, places, index) => (y + 2.0, x, y - 18.0, LabelAnchor::Middle),
        None => (y + 8.0, x, y + 25.0, LabelAnchor::Middle),
    };
    // The value stands below the name of a one-port, which stands higher for it, and behind that of a two-port.
    let lift = if !is_core && label.value.is_some() && name_y < y - 10.0 { 12.0 } else { 0.0 };
    let (along, down) = if is_core { (label.name_width() + 5.0, 0.0) } else { (0.0, 12.0) };
    let name = DrawnLabel { at: [name_x, name_y - lift], anchor, text: label.name.clone(), is_value: false };
    let value = label.value.as_ref().map(|value| DrawnLabel {
        at: [name_x + along, name_y - lift + down],
        anchor,
        text: value.clone(),
        is_value: true,
    });
    ([x, kind_y], std::iter::once(name).chain(value).collect())
}

/// The letters of an element with its name and value.
fn symbol(written: &str, ([x, y], labels): &([f64; 2], Vec<DrawnLabel>), colour: &str, svg: &mut String) {
    let _ = writeln!(
        svg,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"18\" font-weight=\"600\" text-anchor=\"middle\" fill=\"{colour}\">{}</text>",
        escaped(written)
    );
    for DrawnLabel { at: [x, y], anchor, text, is_value } in labels {
        let (colour, anchor) = (if *is_value { VALUE } else { colour }, anchor.word());
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"11\" text-anchor=\"{anchor}\" fill=\"{colour}\" \
             stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\">{}</text>",
            escaped(text)
        );
    }
}

fn limb_is_up(graph: &Graph, places: &[[f64; 2]], index: usize) -> bool {
    let bond = &graph.bonds[graph.elements[index].ports[0]];
    let other = if bond.from == index { bond.to } else { bond.from };
    places[index][1] < places[other][1]
}

/// What lines keep clear of an element, above its middle and below, where its name is.
const ABOVE: f64 = 15.0;
const BELOW: f64 = 29.0;

/// Distance of two bonds between the same elements.
const ASIDE: f64 = 15.0;
/// All of many.
const WHOLE: f64 = 56.0;

/// Ends of a line between two elements, clear of their letters, whose half widths are given, and of the names below them.
fn line(a: [f64; 2], b: [f64; 2], wide: [f64; 2]) -> ([f64; 2], [f64; 2], [f64; 2]) {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let length = dx.hypot(dy).max(1.0);
    let (ux, uy) = (dx / length, dy / length);
    let gap = |wide: f64, down: f64| {
        let tall = if down > 0.0 { BELOW } else { ABOVE };
        (wide * ux.abs() + tall * uy.abs()).min(length / 3.0)
    };
    let (first, last) = (gap(wide[0], uy), gap(wide[1], -uy));
    ([a[0] + first * ux, a[1] + first * uy], [b[0] - last * ux, b[1] - last * uy], [ux, uy])
}

/// How far a bond is drawn beside the straight line, where others join the same elements.
fn aside(graph: &Graph, bond: usize) -> f64 {
    let ends = |bond: usize| {
        let own = &graph.bonds[bond];
        (own.from.min(own.to), own.from.max(own.to))
    };
    let alike: Vec<usize> = (0..graph.bonds.len()).filter(|other| ends(*other) == ends(bond)).collect();
    let place = alike.iter().position(|other| *other == bond).unwrap_or(0) as f64;
    let towards = if graph.bonds[bond].from < graph.bonds[bond].to { 1.0 } else { -1.0 };
    let distance = ASIDE.min(WHOLE / alike.len() as f64);
    towards * distance * (place - (alike.len() as f64 - 1.0) / 2.0)
}

fn drawn_bond(graph: &Graph, causality: &Causality, layout: &Tiled, bond: usize) -> DrawnBond {
    let ends = &graph.bonds[bond];
    let stub = layout.stubs.get(&bond);
    let wide = |end: usize| match stub {
        Some((here, ..)) if *here != end => 2.0,
        _ => 11.0 + 6.0 * graph.elements[end].written.len() as f64,
    };
    let place = |end: usize| match stub {
        Some((here, far, _)) if *here != end => *far,
        Some((here, far, _)) => [layout.places[*here][0], far[1]],
        None => layout.places[end],
    };
    let (a, b, [ux, uy]) = line(place(ends.from), place(ends.to), [ends.from, ends.to].map(wide));
    let aside = if stub.is_some() { 0.0 } else { aside(graph, bond) };
    let [a, b] = [a, b].map(|[x, y]| [x - aside * uy, y + aside * ux]);
    // The barb on the side that looks down or right, at the head; the stroke across, where the effort arrives.
    let (nx, ny) = if uy.abs() > ux.abs() { (1.0, 0.0) } else { (0.0, 1.0) };
    let stroke = if causality.stroke_at_head[bond] { b } else { a };
    let half = if stub.is_some() { 5.0 } else { 8.0 };
    let (sx, sy) = (-uy * half, ux * half);
    DrawnBond {
        name: graph.bond_name(bond),
        line: [a, b],
        barb: [b[0] - 11.0 * ux + 7.0 * nx, b[1] - 11.0 * uy + 7.0 * ny],
        stroke: [[stroke[0] - sx, stroke[1] - sy], [stroke[0] + sx, stroke[1] + sy]],
        follows: causality.following_bonds.contains(&bond),
        free: causality.free_bonds.contains(&bond),
        leads_to: stub.map(|(here, [x, y], name)| {
            // A name ends at its place, also one at the right.
            let wide = if *x < layout.places[*here][0] { -2.0 } else { 4.0 + 5.0 * name.len() as f64 };
            DrawnName { at: [x + wide, y + 3.0], name: name.clone() }
        }),
    }
}

fn half_arrow(graph: &Graph, causality: &Causality, layout: &Tiled, bond: usize, svg: &mut String) {
    let drawn = drawn_bond(graph, causality, layout, bond);
    let is_short = layout.stubs.contains_key(&bond);
    let ([a, b], barb, [first, last]) = (drawn.line, drawn.barb, drawn.stroke);
    let colour = match (drawn.free, drawn.follows) {
        (true, _) => FREE,
        (false, true) => FOLLOWS,
        _ => INK,
    };
    let upright = (b[1] - a[1]).abs() > (b[0] - a[0]).abs();
    let (nx, ny) = if upright { (1.0, 0.0) } else { (0.0, 1.0) };
    let _ = writeln!(
        svg,
        "<path d=\"M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.4\"/>\n\
         <path d=\"M{:.1} {:.1}L{:.1} {:.1}\" stroke=\"{colour}\" stroke-width=\"2.6\"/>",
        a[0], a[1], b[0], b[1], barb[0], barb[1], first[0], first[1], last[0], last[1],
    );
    if !is_short {
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"9\" fill=\"#6b7280\" text-anchor=\"middle\">{}</text>",
            0.5 * (a[0] + b[0]) - 9.0 * nx,
            0.5 * (a[1] + b[1]) - 5.0 * ny + 3.0 * nx,
            bond + 1
        );
    }
}

/// Places from which signals are drawn to one element; of more, names at its arrow say which they are.
const MOST_ORIGINS: usize = 2;

/// One full arrow for all signals that an element reads.
fn named_signals([x, y]: [f64; 2], names: &str, svg: &mut String) {
    let _ = writeln!(
        svg,
        "<path d=\"M{:.1} {:.1}L{:.1} {:.1}\" stroke=\"{SIGNAL}\" stroke-dasharray=\"4 3\"/>\n\
         <path d=\"M{:.1} {:.1}l-8.6 2.6l5.2 5.2Z\" fill=\"{SIGNAL}\"/>\n\
         <text x=\"{:.1}\" y=\"{:.1}\" font-size=\"10\" fill=\"{SIGNAL}\" text-anchor=\"end\" stroke=\"#ffffff\" stroke-width=\"3\" \
         paint-order=\"stroke\">{}</text>",
        x - 36.0,
        y + 44.0,
        x - 8.0,
        y + 14.0,
        x - 6.0,
        y + 12.0,
        x - 14.0,
        y + 56.0,
        escaped(names)
    );
}

/// Signals as thin full arrows from where they are taken to the laws that they enter.
fn activated(graph: &Graph, places: &[[f64; 2]], svg: &mut String) {
    let reads = |ids: &[Id]| -> (Vec<usize>, Vec<usize>) {
        let (mut from, mut signals) = (Vec::new(), Vec::new());
        for var in graph.pool.variables(ids) {
            match var {
                Var::Effort(bond) | Var::Flow(bond) | Var::Displacement(bond) | Var::Momentum(bond) => {
                    let ends = &graph.bonds[bond as usize];
                    from.push(if graph.elements[ends.from].is_junction() { ends.from } else { ends.to });
                }
                Var::Signal(signal) => signals.push(signal as usize),
                _ => {}
            }
        }
        (from, signals)
    };
    for (index, element) in graph.elements.iter().enumerate() {
        let laws: Vec<Id> = match &element.law {
            Law::Source(id) | Law::Ratio(id) => vec![*id],
            Law::Resistor { effort, flow } => effort.iter().chain(flow).copied().collect(),
            Law::Resistors { laws, .. } => laws.clone(),
            Law::Matrix(rows) => rows.iter().flatten().copied().collect(),
            _ => Vec::new(),
        };
        let (_, mut waiting) = reads(&laws);
        let first = waiting.clone();
        let mut seen: Vec<usize> = Vec::new();
        let mut origins = Vec::new();
        while let Some(signal) = waiting.pop() {
            if !seen.contains(&signal) {
                seen.push(signal);
                let (from, more) = reads(&[graph.signals[signal].value]);
                origins.extend(from);
                waiting.extend(more);
            }
        }
        origins.sort_unstable();
        origins.dedup();
        let mut names: Vec<&str> = first.iter().map(|signal| graph.signals[*signal].name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        origins.retain(|origin| *origin != index);
        if origins.len() > MOST_ORIGINS {
            named_signals(places[index], &names.join(", "), svg);
            continue;
        }
        for origin in origins {
            let ([ax, ay], [bx, by]) = (places[origin], places[index]);
            let (mx, my) = (0.5 * (ax + bx), 0.5 * (ay + by) + 62.0);
            let (tx, ty) = (bx - 4.0, by + 15.0);
            let (dx, dy) = (tx - mx, ty - my);
            let length = dx.hypot(dy).max(1.0);
            let (ux, uy) = (dx / length, dy / length);
            let _ = writeln!(
                svg,
                "<path d=\"M{:.1} {:.1}Q{mx:.1} {my:.1} {tx:.1} {ty:.1}\" fill=\"none\" stroke=\"{SIGNAL}\" stroke-width=\"1\" stroke-dasharray=\"4 3\"/>\n\
                 <path d=\"M{tx:.1} {ty:.1}L{:.1} {:.1}L{:.1} {:.1}Z\" fill=\"{SIGNAL}\"/>\n\
                 <text x=\"{:.1}\" y=\"{:.1}\" font-size=\"10\" fill=\"{SIGNAL}\" text-anchor=\"middle\">{}</text>",
                ax + 4.0,
                ay + 14.0,
                tx - 8.0 * ux - 3.5 * uy,
                ty - 8.0 * uy + 3.5 * ux,
                tx - 8.0 * ux + 3.5 * uy,
                ty - 8.0 * uy - 3.5 * ux,
                mx,
                0.5 * (0.5 * (ay + by) + 15.0 + my) + 12.0,
                escaped(&names.join(", "))
            );
        }
    }
}
