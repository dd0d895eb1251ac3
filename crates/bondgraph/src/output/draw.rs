//! A graph as SVG: half arrows, causal strokes, stores that follow and free bonds marked, activated bonds as full arrows.
//!
//! Junctions and two-ports stand in columns by their distance from the first source, in rows by branches; one-ports stand above and
//! below their junction. The graph of an engine stands in tiles: block and crank, every cylinder, rotor and mount.

use crate::causality::Causality;
use crate::expression::{Id, Var};
use crate::graph::{Graph, Kind, Law};
use crate::output::export::escaped;
use crate::output::tiles::{Tiled, tiled};
use crate::run::simulate::Simulation;
use serde::Serialize;
use std::collections::VecDeque;
use std::fmt::Write;

/// Distance of columns, of rows, and of one-ports from their junction.
const COLUMN: f64 = 150.0;
const ROW: f64 = 250.0;
const LIMB: f64 = 95.0;
const SPREAD: f64 = 84.0;
const MARGIN: f64 = 70.0;
const INK: &str = "#1b1f24";
const FOLLOWS: &str = "#b45309";
const FREE: &str = "#b91c1c";
const SIGNAL: &str = "#1d4ed8";

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
    /// Whether it is a store that follows others.
    pub follows: bool,
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
    let layout = layout(graph);
    let places = &layout.places;
    let most = |k: usize| places.iter().map(|place| place[k]).fold(0.0, f64::max) + MARGIN;
    let follows = |index: usize| {
        let ports = &graph.elements[index].ports;
        ports.iter().any(|bond| causality.following_bonds.contains(bond) && graph.bonds[*bond].to == index)
    };
    Placed {
        size: [most(0), most(1)],
        elements: (graph.elements.iter().enumerate())
            .map(|(index, element)| DrawnElement {
                name: element.name.clone(),
                kind: element.written.clone(),
                at: places[index],
                follows: follows(index),
            })
            .collect(),
        bonds: (0..graph.bonds.len()).map(|bond| drawn_bond(graph, causality, &layout, bond)).collect(),
        tiles: (layout.tiles.iter())
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

/// Places of elements: tiles for the graph of an engine, columns and rows for any other.
fn layout(graph: &Graph) -> Tiled {
    tiled(graph).unwrap_or_else(|| Tiled { places: places(graph), ..Tiled::default() })
}

/// The drawing of a graph with its causality.
pub fn drawing(graph: &Graph, causality: &Causality) -> String {
    let layout = layout(graph);
    let places = &layout.places;
    let right = places.iter().map(|p| p[0]).fold(0.0, f64::max) + MARGIN;
    let bottom = places.iter().map(|p| p[1]).fold(0.0, f64::max) + MARGIN;
    let right = layout.tiles.iter().map(|tile| tile.corner[0] + tile.size[0] + 20.0).fold(right, f64::max);
    let width = right.max(460.0);
    let bottom = layout.tiles.iter().map(|tile| tile.corner[1] + tile.size[1]).fold(bottom, f64::max);
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
    for tile in &layout.tiles {
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
    if layout.tiles.is_empty() {
        activated(graph, places, &mut svg);
    }
    for bond in 0..graph.bonds.len() {
        half_arrow(graph, causality, &layout, bond, &mut svg);
    }
    for (_, [x, y], name) in layout.stubs.values() {
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"9\" fill=\"#6b7280\" text-anchor=\"end\">{}</text>",
            x - 2.0,
            y + 3.0,
            escaped(name)
        );
    }
    for (index, element) in graph.elements.iter().enumerate() {
        let [x, y] = places[index];
        let follows = element
            .ports
            .iter()
            .any(|bond| causality.following_bonds.contains(bond) && graph.bonds[*bond].to == index);
        let colour = if follows { FOLLOWS } else { INK };
        let name = if follows { format!("{} (follows)", element.name) } else { element.name.clone() };
        let kind = escaped(&element.written);
        let core = element.is_junction() || element.ports.len() > 1;
        // The name of a junction stands on the side with fewer bonds.
        let above = element.ports.iter().filter(|bond| {
            let ends = &graph.bonds[**bond];
            let other = if ends.from == index { ends.to } else { ends.from };
            places[other][1] < y
        });
        let name_at = if above.count() > 1 { y + 27.0 } else { y - 15.0 };
        let (kind_y, name_x, name_y, anchor) = if core && !element.is_junction() {
            (y + 6.0, x, y - 17.0, "middle")
        } else if core {
            (y + 6.0, x + 12.0, name_at, "start")
        } else if limb_is_up(graph, places, index) {
            (y + 2.0, x, y - 18.0, "middle")
        } else {
            (y + 8.0, x, y + 25.0, "middle")
        };
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{kind_y:.1}\" font-size=\"18\" font-weight=\"600\" text-anchor=\"middle\" fill=\"{colour}\">{kind}</text>\n\
             <text x=\"{name_x:.1}\" y=\"{name_y:.1}\" font-size=\"11\" text-anchor=\"{anchor}\" fill=\"{colour}\" \
             stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\">{}</text>",
            escaped(&name)
        );
    }
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
    svg + "</svg>\n"
}

fn limb_is_up(graph: &Graph, places: &[[f64; 2]], index: usize) -> bool {
    let bond = &graph.bonds[graph.elements[index].ports[0]];
    let other = if bond.from == index { bond.to } else { bond.from };
    places[index][1] < places[other][1]
}

/// Where each element stands.
fn places(graph: &Graph) -> Vec<[f64; 2]> {
    let count = graph.elements.len();
    let core: Vec<bool> = graph.elements.iter().map(|e| e.is_junction() || e.ports.len() > 1).collect();
    let neighbours = |element: usize| {
        graph.elements[element].ports.iter().map(move |bond| {
            let bond = &graph.bonds[*bond];
            if bond.from == element { bond.to } else { bond.from }
        })
    };
    let mut depth: Vec<Option<usize>> = vec![None; count];
    let mut row = vec![0usize; count];
    let mut next_row = 0;
    let is_source = |element: usize| matches!(graph.elements[element].kind, Kind::Se | Kind::Sf);
    let mut starts: Vec<usize> = (0..count).filter(|e| core[*e] && neighbours(*e).any(is_source)).collect();
    starts.extend((0..count).filter(|e| core[*e]));
    for start in starts {
        if depth[start].is_some() {
            continue;
        }
        let first_row = next_row;
        depth[start] = Some(0);
        row[start] = next_row;
        let mut waiting = VecDeque::from([start]);
        // Rows that are taken in each column, so that branches stand below one another.
        let mut taken: Vec<(usize, usize)> = vec![(0, next_row)];
        while let Some(at) = waiting.pop_front() {
            let column = depth[at].unwrap_or(0) + 1;
            // What goes on stands straight ahead, what ends there below.
            let mut ahead: Vec<usize> = neighbours(at).filter(|other| core[*other]).collect();
            ahead.sort_by_key(|other| std::cmp::Reverse(neighbours(*other).filter(|n| core[*n]).count()));
            for other in ahead {
                if depth[other].is_none() {
                    let mut wanted = row[at];
                    while taken.contains(&(column, wanted)) {
                        wanted += 1;
                    }
                    depth[other] = Some(column);
                    row[other] = wanted;
                    taken.push((column, wanted));
                    waiting.push_back(other);
                }
            }
        }
        let used = (0..count).filter(|e| depth[*e].is_some()).map(|e| row[e]).max().unwrap_or(first_row);
        next_row = used + 1;
    }
    let mut limbs: Vec<[Vec<usize>; 2]> = vec![[Vec::new(), Vec::new()]; count];
    for element in 0..count {
        if core[element] {
            for other in neighbours(element).filter(|other| !core[*other]).collect::<Vec<_>>() {
                let [up, down] = &mut limbs[element];
                if is_source(other) && up.len() <= down.len() || up.len() < down.len() {
                    up.push(other);
                } else {
                    down.push(other);
                }
            }
        }
    }
    // Columns as wide as the limbs within them need.
    let columns = depth.iter().flatten().max().map_or(1, |most| most + 1);
    let mut widest = vec![1usize; columns];
    for element in 0..count {
        if let Some(column) = depth[element] {
            let most = limbs[element].iter().map(Vec::len).max().unwrap_or(0);
            widest[column] = widest[column].max(most);
        }
    }
    let mut across = Vec::new();
    let mut at = MARGIN;
    for column in 0..columns {
        let half = SPREAD * (widest[column] - 1) as f64 / 2.0;
        at += half;
        across.push(at);
        at += half.max(0.0) + COLUMN - 30.0 * f64::from(u8::from(widest[column] > 1));
    }
    let mut places = vec![[MARGIN, MARGIN]; count];
    for element in 0..count {
        let Some(column) = depth[element] else { continue };
        let (x, y) = (across[column], MARGIN + LIMB + 20.0 + ROW * row[element] as f64);
        places[element] = [x, y];
        for (side, limb) in limbs[element].iter().enumerate() {
            for (index, other) in limb.iter().enumerate() {
                let shift = SPREAD * (index as f64 - (limb.len() - 1) as f64 / 2.0);
                let down = if side == 0 { -LIMB } else { LIMB };
                places[*other] = [x + shift, y + down];
            }
        }
    }
    // One-ports bonded to one another, without a junction.
    let mut y = MARGIN + LIMB + 20.0 + ROW * next_row as f64;
    for bond in &graph.bonds {
        if !core[bond.from] && !core[bond.to] {
            places[bond.from] = [MARGIN, y];
            places[bond.to] = [MARGIN + COLUMN, y];
            y += ROW / 2.0;
        }
    }
    places
}

/// What lines keep clear of an element, above its middle and below, where its name is.
const ABOVE: f64 = 15.0;
const BELOW: f64 = 29.0;

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
        leads_to: stub.map(|(_, [x, y], name)| DrawnName { at: [x - 2.0, y + 3.0], name: name.clone() }),
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
        for origin in origins.into_iter().filter(|origin| *origin != index) {
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
