//! Pictures of a crankshaft under load and of its modes: the deformed surface in bands of colour.

use super::modes::CrankModes;
use super::statics::{StaticStress, StressCase};
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg};
use lanchester_flex::mesh::{Mesh, SurfaceFace, surface};
use lanchester_flex::picture::{colour, shown_factor};

/// Bands of colour.
const BANDS: usize = 10;
/// Steps of the shade by which faces stand out that look elsewhere.
const SHADES: f64 = 4.0;
/// Share of the length of the crankshaft by which the largest displacement is shown.
const SHOWN: f64 = 0.03;
/// The same of a mode, which stands before the crankshaft at rest.
const SHOWN_OF_MODE: f64 = 0.06;
/// Directions to the eye from both sides, in the frame of the crankshaft; x is up.
const EYES: [[f64; 3]; 2] = [[0.45, 0.75, 0.5], [-0.35, -0.75, -0.5]];
/// Modes that are drawn.
const MODES: usize = 6;

/// What is drawn on a surface.
struct Drawing<'a> {
    mesh: &'a Mesh,
    faces: &'a [SurfaceFace],
    displacements: &'a [[f64; 3]],
    factor: f64,
    /// Values at the nodes, from 0 to 1.
    parts: &'a [f64],
    /// Whether the body at rest stands behind it.
    at_rest: bool,
}

/// Colour of the body at rest.
const REST: &str = "#b9bfc8";

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

/// A polygon of one band and shade.
struct Patch {
    depth: f64,
    tone: (usize, u8),
    corners: Vec<(f64, f64)>,
}

impl Drawing<'_> {
    fn place(&self, node: u32) -> [f64; 3] {
        let (at, u) = (self.mesh.nodes[node as usize], self.displacements[node as usize]);
        std::array::from_fn(|k| at[k] + self.factor * u[k])
    }

    fn band(&self, parts: impl Iterator<Item = f64>) -> usize {
        let (sum, count) = parts.fold((0.0, 0.0), |(sum, count), part| (sum + part, count + 1.0));
        ((sum / count * BANDS as f64) as usize).min(BANDS - 1)
    }

    /// Faces that look to the eye, the farthest first. A face of several bands is cut at its mid-side nodes.
    fn patches(&self, eye: [f64; 3]) -> Vec<Patch> {
        let eye = unit(eye);
        let right = unit(cross([1.0, 0.0, 0.0], eye));
        let up = cross(eye, right);
        let mut patches = Vec::new();
        for face in self.faces {
            let corners = face.nodes.len() / 2;
            let places: Vec<[f64; 3]> = face.nodes.iter().map(|node| self.place(*node)).collect();
            let spans: [[f64; 3]; 2] = [1, 2].map(|k: usize| {
                let (from, to) = if corners == 3 { (0, k) } else { (k - 1, k + 1) };
                std::array::from_fn(|a| places[to][a] - places[from][a])
            });
            let facing = dot(unit(cross(spans[0], spans[1])), eye);
            // Bent faces at the rim may show a part.
            if facing.is_nan() || facing < -0.2 {
                continue;
            }
            let shade = (facing.max(0.0) * SHADES).round() as u8;
            let value = |k: usize| self.parts[face.nodes[k] as usize];
            let mut push = |which: &[usize]| {
                let band = self.band(which.iter().map(|k| value(*k)));
                let depth = which.iter().map(|k| dot(places[*k], eye)).sum::<f64>() / which.len() as f64;
                let corners = which.iter().map(|k| (dot(places[*k], right), -dot(places[*k], up))).collect();
                patches.push(Patch { depth, tone: (band, shade), corners });
            };
            let bands: Vec<usize> =
                (0..face.nodes.len()).map(|k| self.band(std::iter::once(value(k)))).collect();
            if bands.iter().all(|band| *band == bands[0]) {
                push(
                    &(0..2 * corners)
                        .map(|k| if k % 2 == 0 { k / 2 } else { corners + k / 2 })
                        .collect::<Vec<_>>(),
                );
                continue;
            }
            for k in 0..corners {
                push(&[k, corners + k, corners + (k + corners - 1) % corners]);
            }
            if corners == 3 {
                push(&[3, 4, 5]);
            } else {
                push(&[4, 5, 6]);
                push(&[4, 6, 7]);
            }
        }
        patches.sort_by(|a, b| a.depth.total_cmp(&b.depth));
        patches
    }

    fn draw(&self, eye: [f64; 3], width: f64, svg_of: impl Fn(f64) -> Svg) -> Svg {
        let patches = self.patches(eye);
        let rest = match self.at_rest {
            true => Drawing { factor: 0.0, ..*self }.patches(eye),
            false => Vec::new(),
        };
        let all = patches.iter().chain(&rest).flat_map(|patch| &patch.corners);
        let (mut low, mut high) = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
        for (x, y) in all {
            low = (low.0.min(*x), low.1.min(*y));
            high = (high.0.max(*x), high.1.max(*y));
        }
        let margin = 6.0;
        // Broad or tall: within the width, and no taller than it.
        let scale =
            ((width - 2.0 * margin) / (high.0 - low.0)).min((width - 2.0 * margin) / (high.1 - low.1));
        let height = scale * (high.1 - low.1) + 2.0 * margin;
        let aside = (width - scale * (high.0 - low.0)) / 2.0;
        let mut svg = svg_of(height);
        let at = |(x, y): &(f64, f64)| (aside + scale * (x - low.0), margin + scale * (y - low.1));
        let mut outline = Path::new();
        for patch in &rest {
            let mut corners = patch.corners.iter().map(at);
            if let Some(first) = corners.next() {
                outline = corners.fold(outline.move_to(first), Path::line_to).close();
            }
        }
        if !rest.is_empty() {
            svg.fill(REST, &outline);
        }
        let mut open: Option<((usize, u8), Path)> = None;
        for patch in &patches {
            let mut corners = patch.corners.iter().map(at);
            let (tone, mut path) = match open.take() {
                Some((tone, path)) if tone == patch.tone => (tone, path),
                other => {
                    if let Some((tone, path)) = other {
                        svg.fill(&hexadecimal(tone), &path);
                    }
                    (patch.tone, Path::new())
                }
            };
            if let Some(first) = corners.next() {
                path = corners.fold(path.move_to(first), Path::line_to).close();
            }
            open = Some((tone, path));
        }
        if let Some((tone, path)) = open {
            svg.fill(&hexadecimal(tone), &path);
        }
        svg
    }
}

/// Colour of a band in a shade.
fn hexadecimal((band, shade): (usize, u8)) -> String {
    let light = 0.62 + 0.38 * f64::from(shade) / SHADES;
    let [r, g, b] = colour((band as f64 + 0.5) / BANDS as f64).map(|x| (255.0 * light * x).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn length(u: &[f64; 3]) -> f64 {
    dot(*u, *u).sqrt()
}

/// Bands with their limits, below a drawing.
fn legend(svg: &mut Svg, width: f64, top: f64, limits: &dyn Fn(usize) -> String) {
    let step = (width - 20.0) / BANDS as f64;
    for band in 0..BANDS {
        let left = 10.0 + step * band as f64;
        let corners = [(left, top), (left + step, top), (left + step, top + 12.0), (left, top + 12.0)];
        svg.fill(&hexadecimal((band, SHADES as u8)), &Path::through(corners).close());
    }
    for band in (0..=BANDS).step_by(2) {
        let anchor = match band {
            0 => Anchor::Start,
            BANDS => Anchor::End,
            _ => Anchor::Middle,
        };
        svg.text("small", (10.0 + step * band as f64, top + 27.0), anchor, &limits(band));
    }
}

impl StaticStress {
    /// The case with the largest fillet stress: the deformed crankshaft from both sides in bands of von Mises stress.
    pub fn figures(&self) -> Vec<Figure> {
        self.worst().map(|case| self.case_figure(case)).into_iter().collect()
    }

    fn case_figure(&self, case: &StressCase) -> Figure {
        const WIDTH: f64 = 720.0;
        let mesh = &self.sheet.crank.mesh;
        let (faces, _) = surface(mesh);
        let largest = case.worst().and_then(|peak| peak.stress).map_or(1.0, |stress| stress.von_mises);
        let parts: Vec<f64> =
            case.result.stresses.iter().map(|own| own.stress.von_mises() / largest).collect();
        let displacements = &case.result.solution.displacements;
        let factor = shown_factor(mesh, displacements, SHOWN);
        let drawing = Drawing { mesh, faces: &faces, displacements, factor, parts: &parts, at_rest: false };
        let panel = |(k, eye): (usize, &[f64; 3])| {
            let below = if k == 0 { 0.0 } else { 34.0 };
            let mut svg = drawing.draw(*eye, WIDTH, |height| Svg::new(WIDTH, height + below));
            if below > 0.0 {
                let top = svg.height - 32.0;
                let limit = |band: usize| {
                    let value = 1e-6 * largest * band as f64 / BANDS as f64;
                    let unit = if band == BANDS { " MPa" } else { "" };
                    format!("{}{unit}", number::short(value, 3))
                };
                legend(&mut svg, WIDTH, top, &limit);
            }
            let side = if k == 0 { "one side" } else { "the other side" };
            Panel::new(svg, format!("The deformed crankshaft from {side}, coloured by von Mises stress."))
        };
        let place = case.worst().map_or(String::new(), |peak| peak.name.clone());
        Figure {
            id: "stress-contours".to_owned(),
            title: "Von Mises stress, from both sides".to_owned(),
            caption: format!(
                "{}. Displacements {factor} times; red begins at {} MPa, the largest fillet stress is {} MPa at {place}. Surfaces under the pressure of a load may go beyond the \
                 scale.",
                case.name,
                number::short(0.9e-6 * largest, 3),
                number::short(1e-6 * largest, 4),
            ),
            panels: EYES.iter().enumerate().map(panel).collect(),
            columns: 1,
        }
    }
}

impl CrankModes {
    /// Shapes of the first modes, coloured by the size of their motion.
    pub fn figures(&self) -> Vec<Figure> {
        const WIDTH: f64 = 350.0;
        let mesh = &self.sheet.crank.mesh;
        let (faces, _) = surface(mesh);
        let panel = |(k, mode): (usize, &lanchester_flex::modes::Mode)| {
            let largest = mode.shape.iter().map(length).fold(f64::MIN_POSITIVE, f64::max);
            let parts: Vec<f64> = mode.shape.iter().map(|u| length(u) / largest).collect();
            let displacements = &mode.shape;
            let factor = shown_factor(mesh, displacements, SHOWN_OF_MODE);
            let drawing =
                Drawing { mesh, faces: &faces, displacements, factor, parts: &parts, at_rest: true };
            let words = format!(
                "{}: {} Hz, {}",
                k + 1,
                number::short(mode.frequency, 4),
                super::modes::kind_words(mode.kind)
            );
            let mut svg = drawing.draw(EYES[0], WIDTH, |height| Svg::new(WIDTH, height + 22.0));
            let top = svg.height - 7.0;
            svg.text("small", (10.0, top), Anchor::Start, &words);
            Panel::new(svg, format!("Mode {words}."))
        };
        let panels: Vec<Panel> = self.modes.modes.iter().take(MODES).enumerate().map(panel).collect();
        if panels.is_empty() {
            return Vec::new();
        }
        vec![Figure {
            id: "stress-modes".to_owned(),
            title: "Natural modes".to_owned(),
            caption: "Each mode at its largest deflection, drawn so that it can be seen, before the crankshaft at rest in grey; blue rests, red moves most.".to_owned(),
            panels,
            columns: 2,
        }]
    }
}
