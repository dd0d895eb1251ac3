//! Forces that ideal joints of the bond graph do not show, from compliant ones, held against the reactions of the multibody simulation.
//!
//! A body of mass m on a joint of stiffness k follows the load F of rigid joints but for
//!
//! ```text
//! m q'' = m F''/k = F'' / w_n^2        so that of order n of F the share (n w/w_n)^2 is missing
//! ```
//! and but for the deflection itself, which moves the pins by F/k: both fall with 1/k. A step of the pressure makes every joint ring, whatever
//! its stiffness; it has died away after some periods. What rings in one of the rods that hang on a master rod shakes the master, and with it
//! all of them: they ring together, with the mass of all on the crankpin, whose damper `c = 2 zeta sqrt(k m_rod)` makes it die away with
//!
//! ```text
//! exp(-c t / (2 SUM m)) = exp(-zeta w_n t sqrt(m_rod / SUM m)),       w_n^2 = k / SUM m
//! ```

use crate::bond_graph::gauge_pressures;
use crate::crosscheck::pair::Pair;
use lanchester_bondgraph::{
    CompliantJoints, EngineDrive, EngineJoints, EngineRequest, Graph, Method, Simulation as GraphRun,
    SimulationRequest, engine_graph, equations,
};
use lanchester_multibody::LowerPin;
use lanchester_report::CrossRow;
use lanchester_results::PeriodicCurve;
use std::f64::consts::TAU;

/// Share by which forces of compliant joints may differ from those of rigid ones.
const BAR: f64 = 1e-2;
/// Natural frequency of the heaviest piston with its rod, and of all that hang on a master rod with it, on their joints over the speed.
const STIFF: f64 = 400.0;
const DAMPING: f64 = 0.7;
const STEPS: f64 = 1e-7;
/// Samples of a revolution.
const SAMPLES: f64 = 90.0;
/// How long a joint rings behind a step of the pressure where nothing hangs on its rod [rad]: `exp(-0.7 400 x)` is 1e-6 there.
const RINGS: f64 = 0.05;
/// Within this angle a sample is at a step [rad].
const AT_STEP: f64 = 1e-6;
/// A step of the pressure is more than this share of its largest within so small an angle [rad].
const STEP: [f64; 2] = [8e-3, 1e-3];

/// Side thrust, piston pins, lower pins; none where the bodies cannot move by themselves.
pub(crate) fn joint_rows(pair: &Pair<'_>) -> Vec<CrossRow> {
    let Some(run) = compliant_run(pair) else { return Vec::new() };
    let shares = pair.train.main_shares(&[]);
    let theta = run.values("theta").unwrap_or_default();
    let steps: Vec<Vec<f64>> =
        pair.gas.unwrap_or_default().iter().map(|gas| steps_of(&gas.cylinder)).collect();
    let joints: Vec<[Joint<'_>; 6]> = (1..=pair.engine.cylinders.len()).map(|k| joints_of(&run, k)).collect();
    let groups: Vec<Group> = (0..pair.engine.cylinders.len()).map(|index| Group::of(pair, index)).collect();
    let quiet_from = groups.iter().map(|group| group.rings).fold(0.0, f64::max);
    let mut kinds = [[0.0f64; 3]; 3];
    for (sample, theta) in theta.iter().enumerate().skip(1) {
        let theirs = pair.reactions(*theta, &shares);
        for (index, theirs) in theirs.cylinders.iter().enumerate() {
            // A sample at a step may lie on either side of it, as its angle is rounded.
            let rings = |cylinder: usize| {
                let own = pair.train.own_angle(cylinder, *theta) + AT_STEP;
                let period = pair.gas.map_or(TAU, |gas| gas[cylinder].cylinder.period());
                let since = |step: &f64| (own - step).rem_euclid(period);
                let long = groups[index].rings + AT_STEP;
                steps.get(cylinder).is_some_and(|steps| steps.iter().any(|step| since(step) < long))
            };
            if *theta < quiet_from || groups[index].cylinders.iter().any(|own| rings(*own)) {
                continue;
            }
            let [along, across, x, y, upper, under] = joints[index].map(|own| own.at(sample));
            let axis = pair.train.cylinders[index].axis;
            let pin = [along * axis.re - across * axis.im, along * axis.im + across * axis.re];
            let (lower, side) = ([x, y], upper + under);
            let pairs = [
                ([side, 0.0], [theirs.side_thrust, 0.0]),
                (pin, [theirs.piston_pin.force[0], theirs.piston_pin.force[1]]),
                (lower, [theirs.lower_pin.force[0], theirs.lower_pin.force[1]]),
            ];
            for (kind, (ours, theirs)) in kinds.iter_mut().zip(pairs) {
                let size = |force: [f64; 2]| force[0].hypot(force[1]);
                let off = size([ours[0] - theirs[0], ours[1] - theirs[1]]);
                kind[0] = kind[0].max(size(ours));
                kind[1] = kind[1].max(size(theirs));
                kind[2] = if off.is_nan() { f64::INFINITY } else { kind[2].max(off) };
            }
        }
    }
    let names = ["side thrust", "piston pins", "crankpins and knuckle pins"];
    let largest = kinds.iter().fold(0.0f64, |most, kind| most.max(kind[1]));
    let rows = names.into_iter().zip(kinds).map(|(name, [ours, theirs, off])| {
        let scale = theirs.max(0.1 * largest);
        let name = format!("{name}, bond graph with compliant joints");
        let mut row = CrossRow::held(&name, "N", None, [ours, theirs, off, scale], BAR);
        (row.closed_form, row.bond_graph) = (None, row.closed_form);
        row.reason = Some("ideal joints of the bond graph have no pins and walls".into());
        row
    });
    rows.collect()
}

/// Cylinders whose rods hang on one another: a master rod with its articulated rods, or one rod alone.
struct Group {
    cylinders: Vec<usize>,
    /// How long their joints ring behind a step of the pressure [rad].
    rings: f64,
}

impl Group {
    /// That of this cylinder.
    fn of(pair: &Pair<'_>, index: usize) -> Group {
        let cylinders = together(pair, index);
        let is_master = |own: &&usize| pair.train.cylinders[**own].lower_pin == LowerPin::Crankpin;
        let master = cylinders.iter().find(is_master).filter(|_| cylinders.len() > 1);
        let share = master.map_or(1.0, |own| pair.engine.cylinders[*own].rod.mass() / mass(pair, &cylinders));
        Group { rings: RINGS / share.sqrt(), cylinders }
    }
}

/// Cylinders whose rods hang on the same master rod as this one's, itself among them.
fn together(pair: &Pair<'_>, index: usize) -> Vec<usize> {
    let master = |index: usize| match pair.train.cylinders[index].lower_pin {
        LowerPin::Knuckle { master, .. } => master,
        LowerPin::Crankpin => index,
    };
    (0..pair.train.cylinders.len()).filter(|other| master(*other) == master(index)).collect()
}

/// Of pistons and rods of these cylinders [kg].
fn mass(pair: &Pair<'_>, cylinders: &[usize]) -> f64 {
    let own = |index: &usize| {
        let cylinder = &pair.engine.cylinders[*index];
        cylinder.piston_mass + cylinder.rod.mass()
    };
    cylinders.iter().map(own).sum()
}

/// Spring and damper of a joint at the samples.
#[derive(Clone, Copy)]
struct Joint<'a> {
    spring: &'a [f64],
    damper: &'a [f64],
}

impl Joint<'_> {
    fn at(&self, sample: usize) -> f64 {
        // Without a spring there is no joint; a damper may be absent.
        self.spring.get(sample).unwrap_or(&f64::NAN) + self.damper.get(sample).unwrap_or(&0.0)
    }
}

/// Piston pin along and across the cylinder, lower pin along x and y, both contacts of the skirt.
fn joints_of(run: &GraphRun, k: usize) -> [Joint<'_>; 6] {
    ["pin{}_along", "pin{}_across", "crankpin{}_x", "crankpin{}_y", "contact{}_1", "contact{}_2"].map(
        |name| {
            let name = name.replace("{}", &k.to_string());
            let of = |part: &str| run.values(&format!("{name}_{part}.effort")).unwrap_or_default();
            Joint { spring: of("spring"), damper: of("damper") }
        },
    )
}

/// One cycle at imposed speed, block fixed, as in condition A.
fn compliant_run(pair: &Pair<'_>) -> Option<GraphRun> {
    let all = 0..pair.engine.cylinders.len();
    let heaviest = all.map(|index| mass(pair, &together(pair, index))).fold(0.0, f64::max);
    let stiffness = heaviest * (STIFF * pair.speed).powi(2);
    let mut request = EngineRequest::free(pair.speed, 1.0);
    request.drive = EngineDrive::Imposed;
    request.joints = EngineJoints::Compliant(CompliantJoints {
        stiffness,
        skirt_stiffness: 0.5 * stiffness,
        damping_ratio: DAMPING,
        ..CompliantJoints::default()
    });
    request.pressures = pair.gas.map(gauge_pressures).unwrap_or_default();
    let turns = if pair.gas.is_some() { f64::from(pair.engine.strokes.revolutions()) } else { 1.0 };
    let count = (turns * SAMPLES).round();
    let duration = turns * TAU / pair.speed;
    let places: Vec<f64> = (1..=count as usize).map(|k| duration * k as f64 / count).collect();
    let graph = Graph::new(&engine_graph(pair.engine, &request).ok()?).ok()?;
    let found = equations(&graph).ok()?;
    // Steps are held by stability, but a factor of hundreds of states at each would cost far more.
    let method = Some(Method::Explicit);
    let asked = SimulationRequest { duration, tolerance: STEPS, method, ..found.request() };
    let run = found.simulate_at(&asked, &places);
    run.complete.then_some(run)
}

/// Where a pressure makes a step [rad].
fn steps_of(pressure: &PeriodicCurve) -> Vec<f64> {
    let [share, width] = STEP;
    let knots = pressure.knots();
    let largest = knots.iter().map(|knot| pressure.at(*knot).abs()).fold(0.0, f64::max);
    let is_step = |knot: &f64| (pressure.at(*knot) - pressure.at(knot - width)).abs() > share * largest;
    knots.iter().copied().filter(is_step).collect()
}
