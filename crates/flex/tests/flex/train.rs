//! The crank train on a small shaft: its body in the turning frame, laws in their limits, energy, same bits.

mod free;
mod shells;

use lanchester_film::{Cavitation, FilmTable, JournalBearing, JournalMotion};
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::element::ElementKind;
use lanchester_flex::mesh::{NodeSet, mapped_block, quality};
use lanchester_flex::train::{
    BasisOptions, BearingPlace, CrankBody, CrankTrain, CycleOptions, CycleOutcome, CycleState, ImposedMotion,
    PeriodicForce, Slider, TrainCycles, TrainCylinder, TrainLaw, TrainMain, crank_basis, run_cycles,
    run_cycles_watched,
};
use lanchester_flex::{FlexError, Material};
use lanchester_numerics::{ComplexLu, Lu};
use num_complex::Complex64;
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

const LENGTH: f64 = 0.4;
const RADIUS: f64 = 0.01;

fn places() -> Vec<BearingPlace> {
    let at =
        |name: &str, z: f64| BearingPlace { name: name.to_owned(), set: name.to_owned(), z, width: 0.06 };
    vec![at("MAIN_1", 0.04), at("MAIN_2", LENGTH - 0.04), at("PIN_1", 0.5 * LENGTH)]
}

/// A round shaft, twenty diameters long, with a fine bore; two journals and a pin about its own axis.
fn shaft() -> CrankMesh {
    let mut mesh = mapped_block(ElementKind::Hexahedron, [1, 8, 20], Material::steel(), |[r, a, z]| {
        let (sin, cos) = (TAU * a).sin_cos();
        let (sin, cos) = if a == 1.0 { (0.0, 1.0) } else { (sin, cos) };
        let radius = 0.002 + (RADIUS - 0.002) * r;
        [radius * cos, radius * sin, LENGTH * z]
    });
    for place in places() {
        let nodes = mesh.pick(|at| {
            (at[0].hypot(at[1]) - RADIUS).abs() < 1e-6 && (at[2] - place.z).abs() <= 0.5 * place.width + 1e-9
        });
        mesh.sets.push(NodeSet { name: place.set, nodes });
    }
    let end = mesh.pick(|at| at[2] > LENGTH - 1e-9);
    mesh.sets.push(NodeSet { name: "FLYWHEEL".to_owned(), nodes: end });
    let quality = quality(&mesh).unwrap();
    let body_mass = quality.mass;
    CrankMesh {
        mesh,
        quality,
        corners: Vec::new(),
        webs: Vec::new(),
        weights: Vec::new(),
        body_mass,
        left_out: Vec::new(),
    }
}

fn body() -> &'static (CrankBody, Vec<f64>) {
    static BODY: OnceLock<(CrankBody, Vec<f64>)> = OnceLock::new();
    BODY.get_or_init(|| {
        let options = BasisOptions { modes: 8, tilt: true, ..BasisOptions::default() };
        let basis = crank_basis(&shaft(), &places(), options, &|_| {}).unwrap();
        (basis.body, basis.frequencies)
    })
}

/// The equations at `exp(i s t)` in a frame that turns with `w`, without damping.
fn dynamic(body: &CrankBody, w: f64, s: Complex64) -> Vec<Complex64> {
    let n = body.size();
    (0..n * n)
        .map(|k| {
            let diagonal = if k / n == k % n { body.stiffness[k / n] - s * s } else { Complex64::ZERO };
            diagonal + Complex64::I * s * 2.0 * w * body.gyroscopic[k] - w * w * body.centrifugal[k]
        })
        .collect()
}

#[test]
fn bending_frequencies_of_a_turning_shaft_part_by_its_speed() {
    let (body, frequencies) = body();
    let n = body.size();
    let bending = TAU * frequencies[0];
    assert!((frequencies[1] / frequencies[0] - 1.0).abs() < 1e-6, "a pair: {frequencies:?}");
    for w in [100.0, 400.0] {
        for wanted in [bending - w, bending + w] {
            // Zero of the smallest eigenvalue: secant on the reciprocal of u.Z^-1.u, whose zeros are the frequencies.
            let start: Vec<Complex64> =
                (0..n).map(|k| Complex64::new(1.0, 0.3 * k as f64) / (1.0 + k as f64)).collect();
            let value = |s: f64| {
                let mut x = start.clone();
                ComplexLu::new(n, dynamic(body, w, s.into())).unwrap().solve(&mut x);
                let product: Complex64 = start.iter().zip(&x).map(|(a, b)| a.conj() * b).sum();
                product.inv()
            };
            let (mut a, mut b) = (wanted * 1.003, wanted * 0.998);
            let (mut at_a, mut at_b) = (value(a), value(b));
            for _ in 0..30 {
                let next = b - (at_b * (b - a) / (at_b - at_a)).re;
                (a, at_a) = (b, at_b);
                (b, at_b) = (next, value(next));
                if (b - a).abs() < 1e-9 * b {
                    break;
                }
            }
            assert!((b / wanted - 1.0).abs() < 2e-3, "{w}: {b} instead of {wanted}");
        }
    }
}

#[test]
fn a_translation_that_stands_still_turns_backwards_in_the_frame() {
    let (body, _) = body();
    let n = body.size();
    // Rigid coordinates of a translation along x and along y: both bearings move alike, nothing turns.
    let rows: Vec<&Vec<f64>> =
        body.rows[..2].iter().flat_map(|rows| rows.iter()).chain([&body.turning]).collect();
    let matrix: Vec<f64> = rows.iter().flat_map(|row| row[..5].to_vec()).collect();
    let factors = Lu::new(5, matrix).unwrap();
    let solved = |side: [f64; 5]| {
        let mut q = side.to_vec();
        factors.solve(&mut q);
        q
    };
    let (x, y) = (solved([1.0, 0.0, 1.0, 0.0, 0.0]), solved([0.0, 1.0, 0.0, 1.0, 0.0]));
    let w = 418.9;
    // x + i y with exp(i W t) turns against the frame.
    let z: Vec<Complex64> =
        (0..n).map(|k| if k < 5 { Complex64::new(x[k], y[k]) } else { Complex64::ZERO }).collect();
    let matrix = dynamic(body, w, w.into());
    let size = z.iter().map(|z| z.norm()).fold(0.0, f64::max);
    for row in matrix.chunks(n) {
        let rest: Complex64 = row.iter().zip(&z).map(|(a, b)| a * b).sum();
        // Elastic coordinates take part by G and N of rounding alone.
        assert!(rest.norm() < 1e-7 * w * w * size, "{rest}");
    }
    // The mass of the shaft from its coordinates.
    let mass: f64 = x.iter().map(|x| x * x).sum();
    let mesh = shaft();
    assert!((mass / mesh.quality.mass - 1.0).abs() < 1e-9, "{mass} {}", mesh.quality.mass);
}

#[test]
fn a_round_bar_twists_between_the_middles_of_its_journals_as_a_bar() {
    use lanchester_flex::crank_twist::{TwistEnd, TwistSpan, throw_twists};
    let mut crank = shaft();
    // Whole rings of faces: a surface is that of faces whose nodes all belong to it.
    for (set, [from, to]) in [("MAIN_1", [0.02, 0.06]), ("MAIN_2", [LENGTH - 0.06, LENGTH - 0.02])] {
        let on = |at: &[f64; 3]| {
            (at[0].hypot(at[1]) - RADIUS).abs() < 1e-6 && at[2] > from - 1e-9 && at[2] < to + 1e-9
        };
        let nodes = crank.mesh.pick(|at| on(at));
        crank.mesh.sets.iter_mut().filter(|own| own.name == set).for_each(|own| own.nodes = nodes.clone());
    }
    let end = |set: &str, z: f64| TwistEnd { set: set.to_owned(), z, diameters: [2.0 * RADIUS, 0.004] };
    let span = TwistSpan { throw: 0, ends: [end("MAIN_1", 0.04), end("MAIN_2", LENGTH - 0.04)] };
    let found = throw_twists(&crank, &[span], Default::default(), &|_| {}).unwrap();
    let steel = Material::steel();
    let modulus = steel.youngs_modulus / (2.0 * (1.0 + steel.poisson_ratio));
    let polar = TAU / 64.0 * ((2.0 * RADIUS).powi(4) - 0.004f64.powi(4));
    let wanted = modulus * polar / (LENGTH - 0.08);
    // Eight elements around a circle have 0.1 % less of its polar moment of area.
    for k in [found[0].free, found[0].held] {
        assert!((k / wanted - 1.0).abs() < 5e-3, "{k} {wanted}");
    }
}

const PERIOD: f64 = TAU;
const SPEED: f64 = 300.0;

/// A rod without mass whose big end stands on the shaft's axis: it carries the gas force to the pin, against x.
fn pusher(samples: Vec<f64>, law: TrainLaw) -> TrainCylinder {
    TrainCylinder {
        number: 1,
        surface: 2,
        pin: [0.0, 0.0],
        slider: Slider {
            angle: 0.0,
            offset: 0.0,
            length: 0.2,
            piston: 0.0,
            rod: 0.0,
            centre: 0.05,
            inertia: 0.0,
        },
        law,
        housing: None,
        gas: PeriodicForce { period: PERIOD, samples },
    }
}

/// A train whose pin is held by a stiff arm on the surface of the body.
fn train(mut body: CrankBody, mains: TrainLaw, cylinder: TrainCylinder) -> CrankTrain {
    let (turn, [x, y]) = (&body.turns[cylinder.surface], &mut body.rows[cylinder.surface]);
    for (k, turn) in turn.iter().enumerate() {
        x[k] -= cylinder.pin[1] * turn;
        y[k] += cylinder.pin[0] * turn;
    }
    let main = |k: usize| TrainMain { number: k + 1, surface: k, law: mains.clone(), housing: None };
    CrankTrain {
        body,
        mains: vec![main(0), main(1)],
        cylinders: vec![cylinder],
        motion: ImposedMotion::constant(SPEED, PERIOD),
        ratio: 1.0,
        phase: 0.0,
    }
}

fn options() -> CycleOptions {
    CycleOptions { samples: 96, tolerance: 1e-5, ..CycleOptions::default() }
}

fn swinging(mean: f64, share: f64) -> Vec<f64> {
    (0..96).map(|k| mean * (1.0 + share * (TAU * k as f64 / 96.0).sin())).collect()
}

fn film(clearance: f64) -> TrainLaw {
    static TABLE: OnceLock<Arc<FilmTable>> = OnceLock::new();
    let bearing = JournalBearing::new(RADIUS, 0.02, clearance).unwrap();
    let table =
        TABLE.get_or_init(|| Arc::new(FilmTable::new(bearing.slenderness(), Cavitation::Gumbel).unwrap()));
    TrainLaw::Film { bearing, table: Arc::clone(table), viscosity: 0.02, roughness: 0.0 }
}

fn tilted(clearance: f64) -> TrainLaw {
    let bearing = JournalBearing::new(RADIUS, 0.02, clearance).unwrap();
    TrainLaw::TiltedFilm { bearing, viscosity: 0.02, roughness: 0.0 }
}

fn periodic(train: &CrankTrain) -> TrainCycles {
    let found = run_cycles(train, options()).unwrap();
    assert_eq!(found.outcome, CycleOutcome::Periodic, "{:?} {:?}", found.orbit_change, found.stress_change);
    let energy = found.recorded[0].energy;
    assert!(energy.error() <= 1e-4, "{energy:?}");
    found
}

/// Mean and first order of a bearing's orbit.
fn orders(found: &TrainCycles) -> ([f64; 2], [Complex64; 2]) {
    let instants = &found.recorded[0].instants;
    let n = instants.len() as f64;
    let mean = [0, 1].map(|k| instants.iter().map(|own| own.main_places[0][k]).sum::<f64>() / n);
    let first = [0, 1].map(|k| {
        instants
            .iter()
            .map(|own| own.main_places[0][k] * Complex64::cis(-own.theta) * 2.0 / n)
            .sum::<Complex64>()
    });
    (mean, first)
}

#[test]
fn a_bushing_with_the_linearised_film_has_its_small_orbit() {
    let (body, _) = body();
    let rigid = body.rigid();
    let law = film(20e-6);
    let found =
        periodic(&train(rigid.clone(), law.clone(), pusher(swinging(2000.0, 0.004), TrainLaw::Rigid)));
    let (mean, swing) = orders(&found);
    // K and C from differences of the film's force about the mean.
    let TrainLaw::Film { bearing, table, viscosity, .. } = &law else { unreachable!() };
    let force = |e: [f64; 2], rate: [f64; 2]| {
        let motion = JournalMotion {
            eccentricity: e,
            velocity: rate,
            entrainment: 0.5 * SPEED,
            ..JournalMotion::default()
        };
        let own = table.impedance(e.map(|part| part / bearing.clearance), motion.closing()).unwrap();
        own.force.map(|part| part * bearing.force_scale(*viscosity))
    };
    let slope = |is_place: bool| {
        let h = if is_place { 1e-10 } else { 1e-7 };
        let column = |k: usize| {
            let shifted = |sign: f64| {
                let mut by = [0.0; 2];
                by[k] = sign * h;
                if is_place { force([mean[0] + by[0], mean[1] + by[1]], [0.0; 2]) } else { force(mean, by) }
            };
            let (low, high) = (shifted(-1.0), shifted(1.0));
            [0, 1].map(|row| -(high[row] - low[row]) / (2.0 * h))
        };
        let (a, b) = (column(0), column(1));
        [[a[0], b[0]], [a[1], b[1]]]
    };
    let linear = TrainLaw::Bushing { stiffness: slope(true), damping: slope(false) };
    let swings: Vec<f64> = swinging(2000.0, 0.004).iter().map(|force| force - 2000.0).collect();
    let found = periodic(&train(rigid, linear, pusher(swings, TrainLaw::Rigid)));
    let (_, wanted) = orders(&found);
    let size = wanted.iter().map(|e| e.norm()).fold(0.0, f64::max);
    for k in 0..2 {
        // The orbit is 0.1 % of the clearance: what is not linear is of that share.
        assert!((swing[k] - wanted[k]).norm() < 4e-3 * size, "{k}: {} {}", swing[k], wanted[k]);
    }
    assert!(size > 1e-9 && size < 1e-6, "{size}");
}

#[test]
fn a_film_without_clearance_is_a_rigid_bearing() {
    let (body, _) = body();
    let gas = || swinging(1500.0, 0.8);
    let exact = periodic(&train(body.clone(), TrainLaw::Rigid, pusher(gas(), TrainLaw::Rigid)));
    let loads = |found: &TrainCycles| -> Vec<[f64; 2]> {
        found.recorded[0].instants.iter().map(|own| own.main_forces[0]).collect()
    };
    let exact = loads(&exact);
    let largest = exact.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    let off = |clearance: f64| {
        // Whirl with half the speed and the slow squeeze of so stiff a film need hundreds of cycles to settle; the loads do not wait for them.
        let own = train(body.clone(), film(clearance), pusher(gas(), TrainLaw::Rigid));
        let found = run_cycles(&own, CycleOptions { most_cycles: 12, ..options() }).unwrap();
        let pairs = loads(&found).into_iter().zip(&exact).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
        pairs.fold(0.0, f64::max) / largest
    };
    let [wide, narrow] = [off(100e-6), off(2e-6)];
    // The rigid run repeats to 1e-4 of its loads.
    assert!(narrow < 3e-4 && wide > 10.0 * narrow, "{wide} {narrow}");
}

/// A real rod and piston on a pin beside the axis.
fn cylinder(law: TrainLaw) -> TrainCylinder {
    let gas = (0..96).map(|k| 3000.0 * (-((k as f64 - 8.0) / 6.0).powi(2)).exp()).collect();
    TrainCylinder {
        number: 1,
        surface: 2,
        pin: [0.03, 0.0],
        slider: Slider {
            angle: 0.4,
            offset: 0.002,
            length: 0.12,
            piston: 0.3,
            rod: 0.35,
            centre: 0.035,
            inertia: 9e-4,
        },
        law,
        housing: None,
        gas: PeriodicForce { period: PERIOD, samples: gas },
    }
}

#[test]
fn energy_balances_for_every_law_and_bits_are_the_same_again() {
    let (body, _) = body();
    for law in [
        TrainLaw::Rigid,
        TrainLaw::bushing(2e8, 5e3),
        TrainLaw::Contact { clearance: 20e-6, stiffness: 2e8, damping: 2e4 },
        film(20e-6),
    ] {
        let own = train(body.clone(), law.clone(), cylinder(law.clone()));
        let few = CycleOptions { most_cycles: 4, ..options() };
        let found = run_cycles(&own, few).unwrap();
        assert!(!found.recorded.is_empty(), "{law:?}: {:?}", found.outcome);
        for cycle in &found.recorded {
            let energy = cycle.energy;
            assert!(energy.error() <= 1e-4, "{law:?}: {energy:?}");
            // Bearings and damping take, gas gives.
            assert!(energy.gas > 1.0 && energy.damping >= 0.0 && energy.bearings > -1e-6, "{energy:?}");
        }
        if law != TrainLaw::Rigid {
            assert_eq!(run_cycles(&own, few).unwrap(), found, "the same bits");
        }
    }
}

#[test]
fn the_flywheel_drives_with_the_torque_that_the_gas_leaves() {
    let (body, _) = body();
    let found = periodic(&train(body.clone(), TrainLaw::Rigid, cylinder(TrainLaw::Rigid)));
    let energy = found.recorded[0].energy;
    // Rigid bearings take nothing; what the gas gives the flywheel takes but for the material's damping.
    assert_eq!(energy.bearings, 0.0);
    assert!((energy.gas + energy.drive - energy.damping).abs() < 1e-4 * energy.turnover, "{energy:?}");
    assert!(energy.drive < 0.0);
}

#[test]
fn a_train_that_cannot_run_is_refused_or_breaks_off_as_an_outcome() {
    let (body, _) = body();
    let mut own = train(body.clone(), TrainLaw::Rigid, cylinder(TrainLaw::Rigid));
    own.mains.pop();
    assert!(matches!(run_cycles(&own, options()), Err(FlexError::Number { .. })));
    let mut own = train(body.clone(), TrainLaw::Rigid, cylinder(TrainLaw::Rigid));
    own.motion.speed = 0.0;
    assert!(matches!(run_cycles(&own, options()), Err(FlexError::Number { .. })));
    let mut own = train(body.clone(), TrainLaw::Rigid, cylinder(TrainLaw::Rigid));
    own.mains[1].surface = 9;
    assert!(matches!(run_cycles(&own, options()), Err(FlexError::Number { .. })));
    // A pin further out than the rod is long.
    let mut own = train(body.clone(), TrainLaw::Rigid, cylinder(TrainLaw::Rigid));
    own.cylinders[0].pin = [0.2, 0.0];
    let found = run_cycles(&own, options()).unwrap();
    assert!(matches!(found.outcome, CycleOutcome::Broken { .. }) && found.recorded.is_empty());
}

#[test]
fn a_run_that_is_stopped_leaves_its_last_whole_cycle() {
    let (body, _) = body();
    let own = train(body.clone(), film(20e-6), cylinder(film(20e-6)));
    let goes_on = |state: CycleState| state.cycles < 2 || state.part < 0.5;
    let found = run_cycles_watched(&own, options(), &goes_on).unwrap();
    assert_eq!(found.outcome, CycleOutcome::Stopped);
    assert_eq!((found.cycles, found.recorded.len()), (2, 1));
    assert_eq!(found.recorded[0].instants.len(), 96 / 8);
    let at_once = run_cycles_watched(&own, options(), &|_| false).unwrap();
    assert!(at_once.outcome == CycleOutcome::Stopped && at_once.recorded.is_empty());
}

/// `q.(N - S) q`.
fn centrifugal(body: &CrankBody, q: &[f64]) -> f64 {
    let rows = body.centrifugal.chunks(body.size()).zip(q);
    rows.map(|(row, own)| own * row.iter().zip(q).map(|(n, q)| n * q).sum::<f64>()).sum()
}

#[test]
fn a_turning_shaft_is_stiffened_by_its_centrifugal_stress() {
    let (body, _) = body();
    let n = body.size();
    // Rotation about the axis changes no distance from it; the straight displacements of N alone would: q.N q = J.
    assert!(centrifugal(body, &body.euler_load).abs() < 1e-7 * body.polar, "{}", body.polar);
    // Tilt about x through the middle: the inertia about z grows by that of z^2 less that of y^2 (rigid, to second order).
    let rows: Vec<&Vec<f64>> = body.rows[..2].iter().flatten().chain([&body.turning]).collect();
    let factors = Lu::new(5, rows.iter().flat_map(|row| row[..5].to_vec()).collect()).unwrap();
    let arm = 0.5 * LENGTH - 0.04;
    let mut q = vec![0.0, arm, 0.0, -arm, 0.0];
    factors.solve(&mut q);
    q.resize(n, 0.0);
    let wanted = shaft().quality.mass * LENGTH * LENGTH / 12.0 - 0.5 * body.polar;
    let got = centrifugal(body, &q);
    assert!((got / wanted - 1.0).abs() < 1e-6, "{got} {wanted}");
    // Of the twist, whose N is 1, the stress along a long turning cylinder, nu/(4 (1 - nu)) rho W^2 (R^2 - 2 r^2), leaves this.
    let twist = (5..n).max_by(|a, b| body.turning[*a].abs().total_cmp(&body.turning[*b].abs())).unwrap();
    let steel = Material::steel();
    let shear = steel.youngs_modulus / (2.0 * (1.0 + steel.poisson_ratio));
    let wave = body.stiffness[twist] * steel.density / shear;
    let wanted = steel.poisson_ratio / (12.0 * (1.0 - steel.poisson_ratio)) * RADIUS * RADIUS * wave;
    let got = body.centrifugal[twist * (n + 1)];
    // One element through the radius has a stress that falls with r^2 to a quarter.
    assert!((got / wanted - 1.0).abs() < 0.3 && wanted < 0.01, "{got} {wanted}");
}

#[test]
fn a_crankshaft_that_turns_stays_as_far_from_its_axis_as_it_is() {
    let engine = crate::crank::one_throw("");
    let options = CrankMeshOptions { size: 24e-3, fillet_elements: 2, fillets: true };
    let crank = crank_mesh(&engine, 0, options).unwrap();
    let place = |name: &str| {
        let set = crank.mesh.sets.iter().find(|set| set.name == name).unwrap();
        let z = set.nodes.iter().map(|node| crank.mesh.nodes[*node as usize][2]);
        let [low, high] = z.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], z| [a.min(z), b.max(z)]);
        BearingPlace {
            name: name.to_owned(),
            set: name.to_owned(),
            z: 0.5 * (low + high),
            width: 0.8 * (high - low),
        }
    };
    let places = ["MAIN_1", "MAIN_2", "PIN_1"].map(place);
    let basis = crank_basis(&crank, &places, BasisOptions { modes: 12, ..BasisOptions::default() }, &|_| {});
    let body = basis.unwrap().body;
    let got = centrifugal(&body, &body.euler_load);
    // The mains carry the throw: their forces have no moment about the axis however it is turned, but for facets of their surfaces.
    assert!(got.abs() < 3e-5 * body.polar, "{got} {}", body.polar);
    // A rotation moves the pin along its circle: its straight displacement is its arm times that of its surface.
    let moved = |row: &[f64]| row.iter().zip(&body.euler_load).map(|(c, q)| c * q).sum::<f64>();
    let arm = 0.5 * 95.5e-3;
    let along = [moved(&body.rows[2][0]), moved(&body.rows[2][1]), moved(&body.turns[2])];
    assert!(
        (along[0].hypot(along[1]) / arm - 1.0).abs() < 2e-3 && (along[2] - 1.0).abs() < 1e-6,
        "{along:?}"
    );
}
