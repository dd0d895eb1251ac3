//! Elastic bodies with known answers, by the finite elements of the flexible crankshaft.
//!
//! | quantity | what it is |
//! |---|---|
//! | `elastic plate N` | stress at the point D of NAFEMS' thick plate LE10 with 4 N elements across, 6 N around and 2 N through it [Pa] |
//! | `elastic cylinder pressed`, `elastic cylinder turning` | hoop stress at the bore of a long cylinder: 20 and 50 mm, 40 MPa within; 20 and 100 mm, 1000 rad/s [Pa] |
//! | `elastic bar torsion N` | N-th torsional frequency of a free round bar of 400 mm, 40 mm in diameter [Hz] |
//! | `elastic shoulder bending N`, `elastic shoulder torsion N` | von Mises stress over the nominal one in the fillet of a stepped shaft with N elements across the fillet |
//! | `elastic shoulder bending N limit`, `elastic shoulder torsion N limit` | what it tends to by N elements and half as many, N a multiple of 4 |

use lanchester::flex::FlexError;
use lanchester::flex::case::StaticCase;
use lanchester::flex::crank_mesh::{CrankMeshOptions, crank_mesh};
use lanchester::flex::element::ElementKind;
use lanchester::flex::known_bodies::{
    held_quarter, hoop_stress, pressed_quarter, quarter_cylinder, shoulder_factors, thick_plate_stress,
    torsional_frequencies,
};
use lanchester::flex::statics::{SolveOptions, solve_static};
use std::collections::BTreeMap;
use std::sync::{Mutex, OnceLock, PoisonError};

/// Elements across, around and through the plate, for each N.
const PLATE: [usize; 3] = [4, 6, 2];
/// Elements through the wall of the cylinders.
const THROUGH: usize = 16;
/// Inner and outer radius and height of the pressed and of the turning cylinder [m].
const PRESSED: [f64; 3] = [0.02, 0.05, 0.01];
const TURNING: [f64; 3] = [0.02, 0.1, 0.02];
/// Pressure [Pa] and speed [rad/s].
const PRESSURE: f64 = 40e6;
const SPEED: f64 = 1000.0;
/// Length and radius of the bar [m], its layers, and modes that hold three of torsion.
const BAR: [f64; 2] = [0.4, 0.02];
const LAYERS: usize = 24;
const MODES: usize = 26;
/// The stepped shaft: two journals of 50 mm with fillets of 3 mm at a disc of 60 mm.
const SHAFT: &str = r#"
name = "stepped shaft"
speed = "1000 rpm"
[layout]
type = "in-line"
cylinders = 1
spacing = "300 mm"
[crank]
stroke = "50 mm"
web_distance = "70 mm"
[crank.body]
density = "7850 kg/m3"
journal_diameter = "50 mm"
pin_diameter = "50 mm"
web_thickness = "40 mm"
web_radius = "30 mm"
pin_end_radius = "30 mm"
end_journals = ["100 mm", "100 mm"]
journal_fillet = "3 mm"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
"#;
/// Its diameter [m].
const DIAMETER: f64 = 0.05;
/// Its elements away from fillets [m]; its crank radius, which is next to nothing [m].
const SIZE: f64 = 16e-3;
const RADIUS: f64 = 1e-6;

/// A number of an elastic body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ElasticKey {
    Plate {
        fineness: usize,
    },
    Pressed,
    Turning,
    Bar {
        mode: usize,
    },
    Shoulder {
        torsion: bool,
        elements: usize,
    },
    /// What meshes of so many elements and of half as many tend to.
    ShoulderLimit {
        torsion: bool,
        elements: usize,
    },
}

impl ElasticKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<ElasticKey> {
        let words: Vec<&str> = text.strip_prefix("elastic ")?.split(' ').collect();
        let number = |word: &str, most: usize| word.parse().ok().filter(|own| (1..=most).contains(own));
        match words[..] {
            ["plate", fineness] => Some(ElasticKey::Plate { fineness: number(fineness, 6)? }),
            ["cylinder", "pressed"] => Some(ElasticKey::Pressed),
            ["cylinder", "turning"] => Some(ElasticKey::Turning),
            ["bar", "torsion", mode] => Some(ElasticKey::Bar { mode: number(mode, 3)? }),
            ["shoulder", load @ ("bending" | "torsion"), elements, ref rest @ ..] => {
                let elements = number(elements, 12).filter(|own: &usize| own.is_multiple_of(2))?;
                let torsion = load == "torsion";
                match *rest {
                    [] => Some(ElasticKey::Shoulder { torsion, elements }),
                    ["limit"] if elements.is_multiple_of(4) => {
                        Some(ElasticKey::ShoulderLimit { torsion, elements })
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Its value.
    pub fn of(self) -> Result<f64, String> {
        let found = match self {
            ElasticKey::Plate { fineness } => thick_plate_stress(PLATE.map(|cells| cells * fineness)),
            ElasticKey::Pressed => cylinder(PRESSED, |mesh| pressed_quarter(mesh, PRESSED, PRESSURE)),
            ElasticKey::Turning => {
                cylinder(TURNING, |mesh| StaticCase { speed: SPEED, ..held_quarter(mesh, TURNING[2]) })
            }
            ElasticKey::Bar { mode } => {
                // All rows of the bar are of one solution.
                static BAR_MODES: OnceLock<Result<Vec<f64>, String>> = OnceLock::new();
                let found = BAR_MODES.get_or_init(|| {
                    torsional_frequencies(BAR, LAYERS, MODES).map_err(|error| error.to_string())
                });
                let found = found.as_ref().map_err(Clone::clone)?;
                return found
                    .get(mode - 1)
                    .copied()
                    .ok_or_else(|| format!("{} torsional modes", found.len()));
            }
            ElasticKey::Shoulder { torsion, elements } => return shoulder(torsion, elements),
            ElasticKey::ShoulderLimit { torsion, elements } => {
                // Stress of quadratic elements errs with the square of their size.
                let [coarse, fine] = [shoulder(torsion, elements / 2)?, shoulder(torsion, elements)?];
                return Ok((4.0 * fine - coarse) / 3.0);
            }
        };
        found.map_err(|error| error.to_string())
    }
}

fn cylinder(
    sizes: [f64; 3],
    case: impl Fn(&lanchester::flex::mesh::Mesh) -> StaticCase,
) -> Result<f64, FlexError> {
    let mesh = quarter_cylinder(ElementKind::Wedge, THROUGH, sizes);
    let solution = solve_static(&mesh, &case(&mesh), SolveOptions::default())?;
    Ok(hoop_stress(&mesh, &solution.displacements, sizes[0]))
}

/// Bending and torsion with so many elements across the fillet are of one mesh and its factor.
fn shoulder(torsion: bool, fillet_elements: usize) -> Result<f64, String> {
    type Factors = Result<[Vec<f64>; 2], String>;
    static FACTORS: Mutex<BTreeMap<usize, Factors>> = Mutex::new(BTreeMap::new());
    let mut known = FACTORS.lock().unwrap_or_else(PoisonError::into_inner);
    let found = known.entry(fillet_elements).or_insert_with(|| shoulders(fillet_elements));
    let found = found.as_ref().map_err(Clone::clone)?;
    found[usize::from(torsion)].first().copied().ok_or_else(|| "the shaft has no fillet".to_owned())
}

fn shoulders(fillet_elements: usize) -> Result<[Vec<f64>; 2], String> {
    let reading = lanchester::file::read(SHAFT);
    let engine = reading.engine().ok_or("the shaft cannot be read")?;
    let engine =
        engine.with(|parts| parts.throws[0].radius = RADIUS).map_err(|_| "the shaft has no throw")?;
    let options = CrankMeshOptions { size: SIZE, fillet_elements, fillets: true };
    let found = crank_mesh(&engine, 0, options).and_then(|shaft| shoulder_factors(&shaft, DIAMETER));
    found.map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        assert_eq!(ElasticKey::parse("elastic bar torsion 2"), Some(ElasticKey::Bar { mode: 2 }));
        let shoulder = ElasticKey::Shoulder { torsion: false, elements: 4 };
        assert_eq!(ElasticKey::parse("elastic shoulder bending 4"), Some(shoulder));
        let limit = ElasticKey::ShoulderLimit { torsion: true, elements: 8 };
        assert_eq!(ElasticKey::parse("elastic shoulder torsion 8 limit"), Some(limit));
        for name in [
            "elastic",
            "elastic bar torsion 4",
            "elastic shoulder bending 3",
            "elastic shoulder pull 4",
            "elastic shoulder bending 6 limit",
        ] {
            assert_eq!(ElasticKey::parse(name), None, "{name}");
        }
    }
}
