//! The crank with its bobweights: what stands where along it, and what is left.

use super::crank::noise;
use crate::kit::axis::Axis;
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::plot::value_axis;
use crate::kit::svg::{Anchor, Svg, text_width};
use crate::kit::view::View;
use lanchester_workshop::{CrankUnbalance, PlaneUnbalance};
use num_complex::Complex64;

const WIDTH: f64 = 460.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 14.0;
const TOP: f64 = 66.0;
const BOTTOM: f64 = 48.0;
const HEIGHT: f64 = 300.0;
/// Half the distance between a throw's bar and its counterweight's, and half a bar's width [px].
const BESIDE: f64 = 7.0;
const HALF: f64 = 5.0;
const RADIUS: f64 = 110.0;

/// Both components of all unbalances along the crank, and the dynamic unbalance in its two planes.
pub fn crank_figure(answer: &CrankUnbalance) -> Figure {
    Figure {
        id: "crank-unbalance".to_owned(),
        title: format!("{}: {} with bobweights", answer.engine, answer.crankshaft),
        caption: "Unbalance along the crank, by its two components at theta = 0. Full bars: throws with their bobweights; open bars: \
                  counterweights; dashed lines: the two planes. Round: what is left, as unbalances in the two planes and as their sum, seen \
                  from the free end."
            .to_owned(),
        panels: vec![along(answer, "x", |u| u.re), along(answer, "y", |u| u.im), left(answer)],
        columns: 2,
    }
}

/// Unbalances that stand in one plane, added up, by rising z.
fn by_plane(parts: &[PlaneUnbalance]) -> Vec<(f64, Complex64)> {
    let mut planes: Vec<(f64, Complex64)> = Vec::new();
    for part in parts {
        match planes.iter_mut().find(|(z, _)| (z - part.z).abs() < 1e-7) {
            Some((_, sum)) => *sum += part.unbalance,
            None => planes.push((part.z, part.unbalance)),
        }
    }
    planes.sort_by(|a, b| a.0.total_cmp(&b.0));
    planes
}

/// The unit for amounts up to `largest` [kg m], and what divides them.
fn unit(largest: f64) -> (&'static str, f64) {
    if largest >= 1e-3 { ("kg mm", 1e-3) } else { ("g mm", 1e-6) }
}

fn along(answer: &CrankUnbalance, axis: &str, component: impl Fn(Complex64) -> f64) -> Panel {
    let [throws, weights] = [&answer.throws, &answer.counterweights].map(|parts| by_plane(parts));
    // One scale for both components, so that they can be compared.
    let all = || throws.iter().chain(&weights);
    let reach = all().fold(0.0f64, |m, (_, u)| m.max(u.re.abs()).max(u.im.abs()));
    let (unit, divisor) = unit(reach);
    let amounts = Axis::of(-reach / divisor, reach / divisor, 6);
    let places = all().map(|(z, _)| *z).chain(answer.planes.iter().map(|plane| plane.z));
    let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)));
    let margin = (0.06 * (high - low)).max(1e-3);
    let (low, high) = (1e3 * (low - margin), 1e3 * (high + margin));
    let round = Axis::of(low, high, 6);
    let lengths = Axis::stepped(low, high, round.step());
    let (right, bottom) = (WIDTH - RIGHT, TOP + HEIGHT);
    let mut svg = Svg::new(WIDTH, bottom + BOTTOM);
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("unbalance along {axis} [{unit}]"));
    value_axis(&mut svg, &amounts, TOP, bottom);
    for &tick in &lengths.ticks {
        let x = lengths.place(tick, LEFT, right);
        svg.text("small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, lengths.decimals));
    }
    svg.text(
        "muted small",
        ((LEFT + right) / 2.0, bottom + 37.0),
        Anchor::Middle,
        "z [mm], to the flywheel end",
    );
    let x = |z: f64| lengths.place(1e3 * z, LEFT, right);
    for (row, plane) in answer.planes.iter().enumerate() {
        let at = x(plane.z);
        svg.line("thin dashed", (at, TOP - 6.0), (at, bottom));
        // The names of close planes stand above one another, both within the drawing.
        let half = 0.5 * text_width(&plane.name, 11.5);
        let centre = at.clamp((4.0 + half).min(WIDTH / 2.0), (WIDTH - 4.0 - half).max(WIDTH / 2.0));
        svg.name("muted small", (centre, TOP - 26.0 + 15.0 * row as f64), Anchor::Middle, &plane.name);
    }
    let bar = |svg: &mut Svg, class: &str, at: f64, value: f64| {
        let (zero, end) = (amounts.place(0.0, bottom, TOP), amounts.place(value / divisor, bottom, TOP));
        if (zero - end).abs() > 0.3 {
            svg.rect(class, at - HALF, zero, 2.0 * HALF, end - zero);
        }
    };
    for (z, unbalance) in &throws {
        bar(&mut svg, "bar1", x(*z) - BESIDE, component(*unbalance));
    }
    for (z, unbalance) in &weights {
        bar(&mut svg, "bar2", x(*z) + BESIDE, component(*unbalance));
    }
    let sum = |list: &[(f64, Complex64)]| list.iter().map(|(_, u)| component(*u)).sum::<f64>();
    let description = format!(
        "Unbalance along {axis} over z: throws with bobweights in {} planes, {} {unit} together; counterweights in {} planes, {} {unit}.",
        throws.len(),
        number::short(clean(sum(&throws), noise(answer)) / divisor, 4),
        weights.len(),
        number::short(clean(sum(&weights), noise(answer)) / divisor, 4),
    );
    Panel::new(svg, description)
}

/// Rounding is nothing.
fn clean(value: f64, noise: f64) -> f64 {
    if value.abs() <= noise { 0.0 } else { value }
}

/// What is left: in the two planes, and their sum.
fn left(answer: &CrankUnbalance) -> Panel {
    let noise = noise(answer);
    let [first, second] = &answer.planes;
    let drawn = [
        ("a1", first.name.clone(), first.unbalance),
        ("a2", second.name.clone(), second.unbalance),
        ("a0", "static".to_owned(), answer.static_unbalance),
    ];
    let reach = drawn.iter().fold(0.0f64, |m, (_, _, u)| m.max(u.norm()));
    let (unit, divisor) = unit(reach);
    let centre = (WIDTH / 2.0, TOP + RADIUS + 30.0);
    let mut svg = Svg::new(WIDTH, centre.1 + RADIUS + 40.0);
    svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("what is left [{unit}]"));
    if reach <= noise {
        svg.circle("dot", centre, 4.0);
        svg.text("small strong", (centre.0, centre.1 + 24.0), Anchor::Middle, "no unbalance");
        return Panel::new(svg, "No unbalance is left.");
    }
    let rings = Axis::of(0.0, reach / divisor, 3);
    let outer = RADIUS / rings.high;
    let view = View::new(answer.rotation, centre, outer / divisor);
    for &ring in rings.ticks.iter().filter(|ring| **ring > 0.0) {
        svg.circle("grid", centre, ring * outer);
    }
    for quarter in 0..4 {
        let direction = Complex64::cis(f64::from(quarter) * std::f64::consts::FRAC_PI_2);
        svg.line("grid", centre, View { scale: RADIUS, ..view }.at(direction));
        let (x, y) = View { scale: RADIUS + 20.0, ..view }.at(direction);
        svg.text("muted small", (x, y + 4.0), Anchor::Middle, &format!("{}\u{b0}", 90 * quarter));
    }
    let mut row = 0.0;
    for (class, name, unbalance) in &drawn {
        if unbalance.norm() > noise {
            svg.arrow(&format!("arrow {class}"), centre, view.at(*unbalance), 11.0);
        }
        let y = 36.0 + 17.0 * row;
        svg.arrow(&format!("arrow {class}"), (8.0, y - 4.0), (34.0, y - 4.0), 9.0);
        svg.name("small", (42.0, y), Anchor::Start, &format!("{name}: {}", amount(*unbalance, noise)));
        row += 1.0;
    }
    for &ring in rings.ticks.iter().filter(|ring| **ring > 0.0) {
        let (x, y) = View { scale: ring * outer, ..view }.at(Complex64::cis(0.8));
        svg.text("muted small halo", (x, y + 4.0), Anchor::Middle, &number::fixed(ring, rings.decimals));
    }
    let told: Vec<String> =
        drawn.iter().map(|(_, name, u)| format!("{name} {}", amount(*u, noise))).collect();
    Panel::new(svg, format!("What is left: {}.", told.join("; ")))
}

fn amount(unbalance: Complex64, noise: f64) -> String {
    if unbalance.norm() <= noise {
        return "none".to_owned();
    }
    let (unit, divisor) = unit(unbalance.norm());
    let degrees = super::mass::rotor_degrees(unbalance.arg(), 1);
    format!("{} {unit} at {}\u{b0}", number::short(unbalance.norm() / divisor, 4), number::fixed(degrees, 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_file::{read, template};
    use lanchester_workshop::{Plane, crank_unbalance};

    fn figure(bobweight: f64) -> Figure {
        let engine = read(template("v8-crossplane").unwrap().text).engine().unwrap();
        let planes = [("front", -0.2), ("rear", 0.2)].map(|(name, z)| Plane { name: name.into(), z });
        let bobs = vec![bobweight; 4];
        crank_figure(&crank_unbalance(&engine, 0, &bobs, &planes, None).unwrap())
    }

    /// The gallery's V8 is in balance with 1620 g on its pins.
    #[test]
    fn nothing_left_is_said_so() {
        let panels = figure(1.620).panels;
        assert_eq!(panels.len(), 3);
        assert_eq!(panels[2].description, "No unbalance is left.");
        // Throws 1 and 4 oppose one another along x: four planes, no sum.
        assert!(panels[0].description.contains("in 4 planes, 0 kg mm together"), "{}", panels[0].description);
    }

    /// 16 g more on every pin: 0.016 kg * 38.1 mm * 111 mm sqrt(10) over 400 mm = 534.9 g mm in either plane.
    #[test]
    fn what_is_left_is_told() {
        let panels = figure(1.636).panels;
        assert!(panels[2].description.contains("front 534.9 g mm"), "{}", panels[2].description);
        assert!(panels[2].description.ends_with("static none."), "{}", panels[2].description);
    }
}
