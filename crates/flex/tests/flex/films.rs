//! Crankshafts that rest in the oil films of their main bearings.

use crate::crank::{one_throw, throws};
use lanchester_film::{Cavitation, FilmTable, JournalBearing};
use lanchester_flex::FlexError;
use lanchester_flex::crank_case::{
    BearingSurfaces, CrankCase, CrankLoad, CrankSupport, FilmBearing, PinLoad, PinPressure, crank_support,
};
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::crank_solve::solve_crank;
use lanchester_flex::oil_pressure::OilPressure;
use lanchester_flex::statics::SolveOptions;
use lanchester_flex::train::{BearingPlace, FilmInstant, TrainLaw};
use std::f64::consts::TAU;
use std::sync::Arc;

const SPEED: f64 = 300.0;

const OPTIONS: CrankMeshOptions = CrankMeshOptions { size: 14e-3, fillet_elements: 2, fillets: true };

fn single() -> (CrankMesh, Vec<FilmBearing>) {
    let engine = one_throw("pin_fillet = \"5 mm\"\njournal_fillet = \"5 mm\"");
    let mesh = crank_mesh(&engine, 0, OPTIONS).unwrap();
    let table = Arc::new(FilmTable::new(0.02 / 0.055, Cavitation::Gumbel).unwrap());
    let film = |(index, z): (usize, f64)| FilmBearing {
        place: place(&format!("main bearing {}", index + 1), &format!("MAIN_{}", index + 1), z),
        law: TrainLaw::Film {
            bearing: JournalBearing::new(0.0275, 0.02, 3e-5).unwrap(),
            table: Arc::clone(&table),
            viscosity: 8e-3,
            roughness: 0.0,
        },
        housing: None,
    };
    // In the middle of the surfaces between fillets and ends, where the support on journals holds them.
    let middles = ["MAIN_1", "MAIN_2"].map(|name| surface(&mesh, name)[0]);
    let films = middles.into_iter().enumerate().map(film).collect();
    (mesh, films)
}

/// Middle and width of a bearing surface along the crankshaft [m].
fn surface(mesh: &CrankMesh, set: &str) -> [f64; 2] {
    let nodes = &mesh.mesh.set(set).unwrap().nodes;
    let z = nodes.iter().map(|node| mesh.mesh.nodes[*node as usize][2]);
    let [low, high] = z.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], z| [z.min(a), z.max(b)]);
    [0.5 * (low + high), high - low]
}

fn place(name: &str, set: &str, z: f64) -> BearingPlace {
    BearingPlace { name: name.to_owned(), set: set.to_owned(), z, width: 0.02 }
}

fn load(films: &[FilmBearing], force: [f64; 2]) -> CrankLoad {
    CrankLoad {
        pins: vec![PinLoad { pin: 1, force }],
        films: films.to_vec(),
        speed: SPEED,
        ..CrankLoad::default()
    }
}

fn solve(mesh: &CrankMesh, support: &CrankSupport, loads: &[CrankLoad]) -> Result<Vec<CrankCase>, FlexError> {
    solve_crank(mesh, support, loads, SolveOptions::default())
}

#[test]
fn both_journals_carry_half_of_the_load_at_a_thickness_of_their_own() {
    let (mesh, films) = single();
    let loads = [load(&films, [-20e3, 5e3]), load(&films, [-2e3, 0.0])];
    let found = solve(&mesh, &CrankSupport::Films, &loads).unwrap();
    let held = solve(&mesh, &CrankSupport::Journals, &loads).unwrap();
    for (own, held) in found.iter().zip(&held) {
        let [x, y, z] = own.solution.load;
        for axis in 0..3 {
            assert!(
                (own.solution.load[axis] - held.solution.load[axis]).abs() < 1e-6,
                "{:?}",
                own.solution.load
            );
            let rest = own.solution.load[axis] + own.solution.reaction[axis];
            assert!(rest.abs() <= 1e-9 * x.hypot(y).hypot(z), "{rest} N are left");
        }
        // One throw between two equal mains: by the lever each carries half, whatever its film.
        for film in &own.films {
            let miss = (film.force[0] + 0.5 * x).hypot(film.force[1] + 0.5 * y);
            assert!(miss <= 1e-4 * x.hypot(y), "{film:?} of {x} {y}");
            let e = film.eccentricity[0].hypot(film.eccentricity[1]);
            assert!((film.least_film + e - 3e-5).abs() < 1e-12 && film.least_edge_film < film.least_film);
        }
        // What bends a determinate crankshaft does not depend on what holds it: fillets of the pin, away from the journals.
        for (peak, other) in
            own.peaks.iter().zip(&held.peaks).filter(|(peak, _)| peak.name.starts_with("pin"))
        {
            let ratio = peak.stress.unwrap().von_mises / other.stress.unwrap().von_mises;
            assert!((ratio - 1.0).abs() < 0.02, "{}: {ratio}", peak.name);
        }
    }
    let least = |case: &CrankCase| case.films.iter().map(|own| own.least_film).fold(f64::INFINITY, f64::min);
    assert!(least(&found[0]) < 0.5 * least(&found[1]));
    // The energy is that of the body: the films add none, and softer supports change little of it.
    let ratio = found[0].solution.energy / held[0].solution.energy;
    assert!((0.9..1.3).contains(&ratio), "{ratio}");
}

#[test]
fn a_housing_that_yields_moves_the_shell_and_not_the_share_of_the_load() {
    // Of two mains each carries its half, whatever its housing: the shells go with it.
    let (mesh, films) = single();
    let soft: Vec<FilmBearing> =
        films.iter().map(|own| FilmBearing { housing: Some(2e8), ..own.clone() }).collect();
    let loads = [load(&films, [-20e3, 5e3]), load(&soft, [-20e3, 5e3])];
    let found = solve(&mesh, &CrankSupport::Films, &loads).unwrap();
    for (rigid, soft) in found[0].films.iter().zip(&found[1].films) {
        let size = rigid.force[0].hypot(rigid.force[1]);
        assert!((rigid.force[0] - soft.force[0]).hypot(rigid.force[1] - soft.force[1]) < 1e-3 * size);
        assert!((rigid.least_film / soft.least_film - 1.0).abs() < 1e-2, "{rigid:?} {soft:?}");
        assert_eq!(rigid.shell, [0.0; 2]);
        let [x, y] = [0, 1].map(|k| soft.shell[k] + soft.force[k] / 2e8);
        assert!(x.hypot(y) < 1e-9 * size / 2e8 + 1e-15, "{x} {y}");
    }
}

#[test]
fn stiff_films_share_a_load_as_journals_on_their_axis_and_slack_ones_leave_it_to_the_outer_mains() {
    let layout = "cylinders = 2\ncrank_angles = [\"0 deg\", \"0 deg\"]";
    let engine = throws(layout, "pin_fillet = \"6 mm\"\njournal_fillet = \"6 mm\"");
    let mesh = crank_mesh(&engine, 0, OPTIONS).unwrap();
    let films = |clearance: f64, viscosity: f64| -> Vec<FilmBearing> {
        let film = |index: usize| {
            let [z, width] = surface(&mesh, &format!("MAIN_{}", index + 1));
            let bearing = JournalBearing::new(0.0275, width, clearance).unwrap();
            let table = Arc::new(FilmTable::new(bearing.slenderness(), Cavitation::Gumbel).unwrap());
            let name = format!("main bearing {}", index + 1);
            FilmBearing {
                place: BearingPlace { width, ..place(&name, &format!("MAIN_{}", index + 1), z) },
                law: TrainLaw::Film { bearing, table, viscosity, roughness: 0.0 },
                housing: None,
            }
        };
        (0..3).map(film).collect()
    };
    let pins = vec![PinLoad { pin: 1, force: [-8e3, 1e3] }, PinLoad { pin: 2, force: [-8e3, 1e3] }];
    let load = |films: Vec<FilmBearing>| CrankLoad {
        pins: pins.clone(),
        films,
        speed: SPEED,
        ..CrankLoad::default()
    };
    let held = solve(&mesh, &CrankSupport::Journals, &[load(Vec::new())]).unwrap().remove(0);
    let loads = [load(films(3e-6, 0.5)), load(films(4e-5, 8e-3))];
    let [stiff, slack]: [CrankCase; 2] =
        loads.map(|own| solve(&mesh, &CrankSupport::Films, &[own]).unwrap().remove(0));
    let share = |case: &CrankCase| -> Vec<f64> {
        let forces: Vec<f64> =
            case.solution.spring_forces[..6].chunks(2).map(|own| own[0].hypot(own[1])).collect();
        let all: f64 = forces.iter().sum();
        forces.iter().map(|own| own / all).collect()
    };
    let [on_axis, thin, wide] = [&held, &stiff, &slack].map(share);
    for k in 0..3 {
        assert!((on_axis[k] - thin[k]).abs() < 0.01, "{on_axis:?} {thin:?}");
    }
    assert!(wide[1] < 0.75 * on_axis[1], "{on_axis:?} {wide:?}");
    // Fillets of the loaded middle journal see how the pressure lies on it; those of the pins only what bends the crankshaft.
    for ((name, one), (_, other)) in peaks(&stiff).iter().zip(&peaks(&held)) {
        assert!(!name.starts_with("pin") || (one / other - 1.0).abs() < 0.02, "{name}: {one} {other}");
    }
}

#[test]
fn pressure_of_a_film_carries_its_force_and_loads_the_pin_with_it() {
    let (mesh, films) = single();
    let pin = place("big end of cylinder 1", "PIN_1", 0.5 * (films[0].place.z + films[1].place.z));
    let journal = JournalBearing::new(0.024, 0.02, 2.5e-5).unwrap();
    let law = TrainLaw::Film {
        bearing: journal,
        table: Arc::new(FilmTable::new(journal.slenderness(), Cavitation::Reynolds).unwrap()),
        viscosity: 8e-3,
        roughness: 0.0,
    };
    let instant = FilmInstant {
        eccentricity: [1.9e-5, 1.2e-5],
        rate: [2e-4, -1e-4],
        entrainment: 140.0,
        tilt: [[0.0; 2]; 2],
    };
    let oil = OilPressure::of_film(&pin, &law, &instant).unwrap().unwrap();
    // F = - INTEGRAL p n R da dz, by the rule of middles.
    let (n, m) = (7200, 400);
    let mut sum = [0.0; 2];
    for i in 0..n {
        let angle = TAU * (i as f64 + 0.5) / n as f64;
        for j in 0..m {
            let z = pin.z + 0.02 * ((j as f64 + 0.5) / m as f64 - 0.5);
            let p = oil.at(angle, z) * journal.radius * TAU / n as f64 * 0.02 / m as f64;
            (sum[0], sum[1]) = (sum[0] - p * angle.cos(), sum[1] - p * angle.sin());
        }
    }
    let size = oil.force[0].hypot(oil.force[1]);
    assert!((sum[0] - oil.force[0]).hypot(sum[1] - oil.force[1]) < 5e-3 * size, "{sum:?} {:?}", oil.force);
    assert_eq!([oil.at(0.5, pin.z + 0.0101), oil.at(0.5, pin.z - 0.0101)], [0.0; 2]);
    let force = oil.force;
    let spread = |pressure| CrankLoad { pressure, oil: vec![oil.clone()], ..load(&[], force) };
    let loads = [spread(PinPressure::Film), spread(PinPressure::Cosine)];
    let found = solve(&mesh, &CrankSupport::Journals, &loads).unwrap();
    for axis in 0..3 {
        let [a, b] = [0, 1].map(|k| found[k].solution.load[axis]);
        assert!((a - b).abs() < 1e-6 * size, "{a} {b}");
    }
    // Narrower and more to the middle, it deforms the pin more; far from it only the resultant counts.
    let ratio = found[0].solution.energy / found[1].solution.energy;
    assert!(ratio > 1.02, "{ratio}");
    let far = |own: &PeakOf<'_>| own.0.starts_with("journal");
    let [film, cosine] = [0, 1].map(|k| peaks(&found[k]));
    for ((name, one), (_, other)) in film.iter().zip(&cosine).filter(|(own, _)| far(own)) {
        assert!((one / other - 1.0).abs() < 0.03, "{name}: {one} {other}");
    }
}

/// Name and stress of a fillet.
type PeakOf<'a> = (&'a str, f64);

fn peaks(case: &CrankCase) -> Vec<PeakOf<'_>> {
    case.peaks.iter().map(|own| (own.name.as_str(), own.stress.unwrap().von_mises)).collect()
}

#[test]
fn what_cannot_rest_in_films_is_refused() {
    let (mesh, films) = single();
    let refused = |loads: &[CrankLoad]| solve(&mesh, &CrankSupport::Films, loads).unwrap_err().to_string();
    let still = CrankLoad { speed: 0.0, ..load(&films, [-1e3, 0.0]) };
    assert!(refused(&[still]).contains("at standstill a film carries nothing"));
    assert!(refused(&[load(&[], [-1e3, 0.0])]).contains("oil film of each main bearing"));
    assert!(refused(&[load(&films, [-1e3, 0.0]), load(&films[1..], [-1e3, 0.0])]).contains("1 films"));
    let heavy = CrankLoad { speed: 0.1, ..load(&films, [-4e5, 0.0]) };
    assert!(refused(&[heavy]).contains("main bearing 1: under this load"), "thin");
    let dry = CrankLoad { pressure: PinPressure::Film, ..load(&films, [-1e3, 0.0]) };
    assert!(refused(&[dry]).contains("pressure of an oil film"));
    let surfaces = BearingSurfaces::new(&mesh);
    assert_eq!(crank_support(&mesh, &surfaces, &CrankSupport::Films, 0.0).unwrap_err(), FlexError::Nonlinear);
    let rings = CrankSupport::Rings { thickness: 5e-3, modulus: 210e9 };
    let pressed = CrankLoad { pressure: PinPressure::Film, ..load(&[], [-1e3, 0.0]) };
    assert!(solve(&mesh, &rings, &[pressed]).unwrap_err().to_string().contains("on the outside of a ring"));
}
