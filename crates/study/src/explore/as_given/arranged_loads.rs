//! What each group of an arrangement adds to the loads, its throw at lead 0.
//!
//! When a group leads by a, all that it does comes earlier by a:
//!
//! ```text
//! order n   forward part times e^{i n a}, backward part times e^{-i n a}, roll moment and torque times e^{i n a}
//! ```
//! for offset cylinders and articulated rods as for any other linkage: nothing of its motion is used.

use crate::explore::as_given::arrangement::Arrangement;
use crate::explore::counterweight_pattern::CounterweightPattern;
use crate::explore::layout_orders::LayoutOrders;
use crate::explore::parts::Parts;
use lanchester_mechanism::{Beam, BeamModel, LoadError, LoadRequest, Mechanism, Part, Selection};
use num_complex::Complex64;

/// Loads of the groups of an arrangement with one pattern of weights on the webs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ArrangedLoads {
    /// Loads on the block by group.
    orders: Vec<LayoutOrders>,
    /// Bending moment at every station of every crankshaft by every group [N m], station by station.
    pub bending: Vec<Complex64>,
    /// Load on every main bearing by every group [N], main by main.
    pub mains: Vec<Complex64>,
    /// Sum of the weights [kg m].
    pub counterweights: f64,
}

impl ArrangedLoads {
    pub fn of(
        parts: &Parts,
        arrangement: &Arrangement,
        pattern: &CounterweightPattern,
    ) -> Result<ArrangedLoads, LoadError> {
        let groups = arrangement.groups();
        let engine = arrangement.engine(parts, pattern, &vec![0.0; groups], None);
        let request = LoadRequest { max_order: 2, samples: 1, ..LoadRequest::default() };
        let mut orders = vec![LayoutOrders::default(); groups];
        for index in 0..engine.cylinders.len() {
            let own = Mechanism::of(&engine, &request, Selection::Cylinder(index))?.orders();
            orders[arrangement.group_of(index)].add([&own[1], &own[2]]);
        }
        for (group, orders) in orders.iter_mut().enumerate() {
            let alone = engine.with(|parts| {
                // The weights of a throw follow each other in the order of the throws.
                let owners = (0..arrangement.throws.len()).flat_map(|throw| {
                    arrangement.web_weights(pattern, throw).into_iter().map(move |_| throw)
                });
                let mut owners = owners.map(|throw| arrangement.group_of_throw[throw]);
                parts.counterweights.retain(|_| owners.next() == Some(group));
            });
            let alone = alone.expect("invariant: an engine without some of its weights is one");
            let own = Mechanism::of(&alone, &request, Selection::Part(Part::Counterweights))?.orders();
            orders.add([&own[1], &own[2]]);
        }
        let mut loads = ArrangedLoads {
            orders,
            bending: Vec::new(),
            mains: Vec::new(),
            counterweights: engine.counterweights.iter().map(|weight| weight.unbalance).sum(),
        };
        for crankshaft in 0..arrangement.crankshafts.len() {
            loads.add_beams(parts, arrangement, pattern, crankshaft);
        }
        Ok(loads)
    }

    /// Loads of a group with this lead [rad].
    pub fn orders_at(&self, group: usize, lead: f64) -> LayoutOrders {
        let mut orders = self.orders[group];
        for index in 0..2 {
            let turn = Complex64::cis((index + 1) as f64 * lead);
            orders.force[index][0] *= turn;
            orders.force[index][1] *= turn.conj();
            orders.couple[index][0] *= turn;
            orders.couple[index][1] *= turn.conj();
            orders.roll_moment[index] *= turn;
            orders.shaft_torque[index] *= turn;
        }
        orders
    }

    /// Influences of the groups on bending moments and main loads of one crankshaft, by what turns with it.
    fn add_beams(
        &mut self,
        parts: &Parts,
        arrangement: &Arrangement,
        pattern: &CounterweightPattern,
        crankshaft: usize,
    ) {
        let groups = arrangement.groups();
        let square = parts.speed * parts.speed;
        let sense = arrangement.sense(crankshaft);
        let own = arrangement.crankshafts[crankshaft].mains.as_deref();
        let mains = own.expect("invariant: crankshafts of an arrangement have main bearings");
        let Some(free) = Beam::new(mains, BeamModel::FreeBeam) else { return };
        let Some(cut) = Beam::new(mains, BeamModel::ThrowByThrow) else { return };
        let mut by_group: Vec<Vec<(f64, Complex64)>> = vec![Vec::new(); groups];
        for (index, throw) in arrangement.throws.iter().enumerate() {
            if throw.crankshaft != crankshaft {
                continue;
            }
            let riders = arrangement.cylinders.iter().filter(|cylinder| cylinder.throw == index);
            let big_ends = riders.map(|cylinder| (cylinder.z, cylinder.rod.big_end_mass * throw.radius));
            let turning = big_ends
                .chain([(throw.unbalance_plane(), throw.unbalance)])
                .chain(arrangement.web_weights(pattern, index));
            // Counted as crankshaft 1 turns, so that a lead turns it forward on every crankshaft.
            let direction = Complex64::cis(sense * throw.angle) * square;
            let group = arrangement.group_of_throw[index];
            by_group[group].extend(turning.map(|(z, unbalance)| (z, unbalance * direction)));
        }
        // Between loads and mains the moment runs straight: it is largest at one of them.
        let mut stations: Vec<f64> =
            by_group.iter().flatten().map(|load| load.0).chain(mains.iter().copied()).collect();
        stations.sort_by(f64::total_cmp);
        stations.dedup();
        for station in stations {
            self.bending.extend(by_group.iter().map(|loads| {
                let moments = loads.iter().map(|&(z, force)| force * free.moment_influence(station, z));
                moments.sum::<Complex64>()
            }));
        }
        let mut carried = vec![Complex64::ZERO; mains.len() * groups];
        for (group, loads) in by_group.iter().enumerate() {
            for &(z, force) in loads {
                for (main, share) in cut.shares(z) {
                    carried[main * groups + group] += share * force;
                }
            }
        }
        self.mains.extend(carried);
    }
}
