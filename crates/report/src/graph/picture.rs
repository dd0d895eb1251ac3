//! Tiles of an engine's bond graph, those that are alike drawn once.

use crate::kit::figure::{Figure, Panel};
use crate::kit::svg::{Anchor, Path, Svg};
use lanchester_bondgraph::{DrawnTile, LabelAnchor, Placed};

/// A tile that is drawn, and the titles of those like it.
pub(crate) struct Kept<'a> {
    pub(crate) tile: &'a DrawnTile,
    pub(crate) alike: Vec<&'a str>,
    /// Names of its elements.
    pub(crate) elements: Vec<&'a str>,
}

/// A name without its numbers.
pub(crate) fn stem(name: &str) -> String {
    name.chars().filter(|letter| !letter.is_ascii_digit()).collect()
}

fn within(tile: &DrawnTile, [x, y]: [f64; 2]) -> bool {
    let inside = |at: f64, corner: f64, size: f64| at >= corner && at <= corner + size;
    inside(x, tile.corner[0], tile.size[0]) && inside(y, tile.corner[1], tile.size[1])
}

/// The tiles of a graph, of those with the same elements but for their numbers the first alone.
pub(crate) fn kept(placed: &Placed) -> Vec<Kept<'_>> {
    let mut found: Vec<(Vec<String>, Kept<'_>)> = Vec::new();
    for tile in &placed.tiles {
        let elements: Vec<&str> = (placed.elements.iter())
            .filter(|element| within(tile, element.at))
            .map(|element| element.name.as_str())
            .collect();
        let mut stems: Vec<String> = elements.iter().map(|name| stem(name)).collect();
        stems.sort();
        match found.iter_mut().find(|(known, _)| *known == stems) {
            Some((_, kept)) => kept.alike.push(&tile.title),
            None => found.push((stems, Kept { tile, alike: Vec::new(), elements })),
        }
    }
    found.into_iter().map(|(_, kept)| kept).collect()
}

/// The drawing: a panel for each kind of tile.
pub(crate) fn picture(placed: &Placed) -> Option<Figure> {
    let panels: Vec<Panel> = kept(placed).iter().map(|kept| panel(placed, kept)).collect();
    if panels.is_empty() {
        return None;
    }
    Some(Figure {
        id: "bond-graph-drawing".into(),
        title: "The engine as a bond graph".into(),
        caption: "Half arrows: positive power. Bars across a bond: the causal stroke, where the effort arrives. Dashed: stores that \
                  follow others. A short bond leads to the element of another tile that is named at its end."
            .into(),
        columns: 1,
        panels,
    })
}

fn panel(placed: &Placed, kept: &Kept<'_>) -> Panel {
    let tile = kept.tile;
    let [left, top] = tile.corner;
    let place = |[x, y]: [f64; 2]| (x - left, y - top);
    let mut svg = Svg::new(tile.size[0], tile.size[1] + 10.0);
    let title = match kept.alike.as_slice() {
        [] => tile.title.clone(),
        alike => format!("{}; the same: {}", tile.title, alike.join(", ")),
    };
    svg.text("strong", (4.0, 16.0), Anchor::Start, &title);
    for bond in &placed.bonds {
        let ends =
            if bond.leads_to.is_some() { vec![bond.line[0], bond.line[1]] } else { bond.line.to_vec() };
        if !ends.iter().all(|end| within(tile, *end)) {
            continue;
        }
        let class = if bond.follows { "limit" } else { "outline" };
        svg.path(class, &Path::through([place(bond.line[0]), place(bond.line[1]), place(bond.barb)]));
        svg.line("crank", place(bond.stroke[0]), place(bond.stroke[1]));
        if let Some(far) = &bond.leads_to {
            svg.name("muted small", place(far.at), Anchor::End, &far.name);
        }
    }
    for element in placed.elements.iter().filter(|element| within(tile, element.at)) {
        svg.name("strong halo", place(element.kind_at), Anchor::Middle, &element.kind);
        for label in &element.labels {
            let anchor = match label.anchor {
                LabelAnchor::Start => Anchor::Start,
                LabelAnchor::Middle => Anchor::Middle,
                LabelAnchor::End => Anchor::End,
            };
            match label.is_value {
                true => svg.text("muted small halo", place(label.at), anchor, &label.text),
                false => svg.name("muted small halo", place(label.at), anchor, &label.text),
            }
        }
    }
    let description = format!("{}: {}.", tile.title, kept.elements.join(", "));
    Panel::new(svg, description)
}
