//! Who carries a load on a crankshaft: its neighbours among the main bearings, as by a lever (book, eq. 13.2).
//!
//! A load in the plane of a main bearing that moves across it is carried by other neighbours on either side: there the derivatives on both
//! sides differ.

use super::gas_force::Window;
use super::over_time::known;
use super::quantity::Quantity;
use super::train::{Train, Vector};
use lanchester_model::Throw;
use lanchester_task::Varied;
use num_dual::Dual64;

/// Planes closer than this are one [m].
const SAME_PLANE: f64 = 1e-12;

/// Main bearings of one crankshaft.
struct Row {
    crankshaft: usize,
    planes: Vec<Dual64>,
}

/// Main bearings of an engine: crankshaft 1 first, each from the free end on.
pub(super) struct Mains {
    rows: Vec<Row>,
    sign: f64,
}

impl Mains {
    pub fn of(train: &Train<'_>) -> Mains {
        let rows = (0..train.engine.crankshafts.len())
            .map(|crankshaft| Row { crankshaft, planes: planes(train, crankshaft) })
            .filter(|row| row.planes.len() > 1);
        Mains { rows: rows.collect(), sign: train.side.sign() }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.rows.iter().map(|row| row.planes.len()).sum()
    }

    /// Share of a load on `crankshaft` in the plane `z` that main bearing `main` of all carries.
    fn share(&self, main: usize, crankshaft: usize, z: Dual64) -> Dual64 {
        let mut first = 0;
        for row in &self.rows {
            if row.crankshaft == crankshaft {
                let [front, rear] = row.carriers(z, self.sign);
                let share = (z - row.planes[front]) / (row.planes[rear] - row.planes[front]);
                return match main.checked_sub(first) {
                    Some(own) if own == front => known(1.0) - share,
                    Some(own) if own == rear => share,
                    _ => known(0.0),
                };
            }
            first += row.planes.len();
        }
        known(0.0)
    }

    /// Force of the journal on main bearing `main` [N], x and y.
    pub fn force(&self, main: usize, train: &Train<'_>, theta: Dual64, windows: &[Window]) -> Vector {
        let mut sum = [known(0.0); 2];
        let share = |crankshaft: usize, z: Dual64| self.share(main, crankshaft, z);
        // What other main bearings carry need not be known.
        let counts = |share: Dual64| share.re != 0.0 || share.eps != 0.0;
        let is_carried = |crankshaft: usize, z: Dual64| counts(share(crankshaft, z));
        let mut add = |share: Dual64, force: Vector| sum = [0, 1].map(|k| sum[k] + force[k] * share);
        for turning in train.turning_on_cranks(theta, is_carried) {
            let force = turning.direction.map(|along| -turning.unbalance * along.v2);
            add(share(turning.crankshaft, turning.z), force);
        }
        let of_rod = |index: usize| {
            let cylinder = &train.engine.cylinders[index];
            let z = train.plane(train.part(Varied::CylinderPlane, index, cylinder.z), cylinder.z);
            share(train.engine.throws[cylinder.throw].crankshaft, z)
        };
        for (index, forces) in train.pin_forces(theta, windows, |index| counts(of_rod(index))) {
            add(of_rod(index), forces.on_crank);
        }
        sum
    }
}

impl Row {
    /// The two main bearings beside a load, the last two on either end for one beyond them.
    fn carriers(&self, z: Dual64, sign: f64) -> [usize; 2] {
        let last = self.planes.len() - 1;
        let is_behind = |main: &&Dual64| {
            let apart = z - **main;
            if apart.re.abs() > SAME_PLANE { apart.re > 0.0 } else { sign * apart.eps > 0.0 }
        };
        let bay = self.planes[1..last].iter().filter(is_behind).count();
        [bay, bay + 1]
    }
}

/// Planes of the main bearings of a crankshaft, each an input itself: those of the file or midway between throws stretch with the spacing; those beside a lone
/// throw without webs stand off by a multiple of its crank radius.
pub(super) fn planes(train: &Train<'_>, crankshaft: usize) -> Vec<Dual64> {
    let engine = train.engine;
    let planes = engine.main_planes(crankshaft);
    let all_stretch = planes.len() != 2 || engine.crankshafts[crankshaft].mains.is_some();
    let throws = engine.throws.iter().enumerate().filter(|(_, throw)| throw.crankshaft == crankshaft);
    let mut throws: Vec<(usize, &Throw)> = throws.collect();
    throws.sort_by(|a, b| a.1.z.total_cmp(&b.1.z));
    let ends = [throws.first(), throws.last()];
    let before: usize = (0..crankshaft).map(|index| engine.main_planes(index).len()).sum();
    let moved = |place: usize| train.of(Quantity::MainPlane, before + place, 0.0);
    let plane = |(place, z): (usize, f64)| match ends.get(place).copied().flatten() {
        Some((index, throw)) if !all_stretch && throw.webs.is_none() => {
            let radius = train.part(Varied::CrankRadius, *index, throw.radius);
            let beside = (z - throw.z) / throw.radius;
            train.plane(moved(place) + throw.z, throw.z) + radius * beside
        }
        _ => train.plane(moved(place) + z, z),
    };
    planes.into_iter().enumerate().map(plane).collect()
}
