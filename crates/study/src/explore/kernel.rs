//! Loads of many cranks of one block: all that two cranks of a space differ by is the angle of each throw.
//!
//! Everything is a sum over groups, and what one group adds depends on its place and angle alone. One row holds what a
//! group adds to all first- and second-order components; a crank is the sum of as many rows as it has groups.
//!
//! ```text
//! cylinder on axis b, crank at phi = a - b of it, plane z:
//!   force   f_n e^{i (n phi + b)} forward,  f_-n e^{i (-n phi + b)} backward;   couple: i z times the force
//!   torque  T_n e^{i n phi},   roll moment  R_n e^{i n phi}
//! turning: throw, big ends and web weights: one forward force of order 1 each, at their planes
//! ```
//! `f_n`, `f_-n`, `T_n`, `R_n` are those of one cylinder on axis 0 with the crank at 0, from `lanchester-mechanism`.

use crate::explore::as_given::ArrangedLoads;
use crate::explore::layout::{Layout, cylinder, engine};
use crate::explore::layout_orders::{LayoutOrders, ROW};
use crate::explore::parts::Parts;
use lanchester_mechanism::{
    Beam, BeamModel, LoadError, LoadRequest, Mechanism, Part, Selection, turning_loads,
};
use lanchester_model::Throw;
use lanchester_results::OrderLoads;
use num_complex::Complex64;

/// Loads of one cylinder on axis 0, in the plane of the origin, with the crank at 0: orders 1 and 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct UnitCylinder([OrderLoads; 2]);

impl UnitCylinder {
    pub fn new(parts: &Parts, rod_ratio: f64) -> Result<UnitCylinder, LoadError> {
        let throw = Throw {
            crankshaft: 0,
            angle: 0.0,
            z: 0.0,
            radius: parts.crank_radius,
            unbalance: 0.0,
            unbalance_offset: 0.0,
            webs: None,
        };
        let mains = vec![-parts.web_distance, parts.web_distance];
        let engine = engine(parts, vec![throw], vec![cylinder(parts, rod_ratio)], Vec::new(), mains);
        let request = LoadRequest { max_order: 2, samples: 1, ..LoadRequest::default() };
        let orders = |part: Part| Ok(Mechanism::of(&engine, &request, Selection::Part(part))?.orders());
        let (mass, inertia) = (orders(Part::Reciprocating)?, orders(Part::RodInertia)?);
        Ok(UnitCylinder([1, 2].map(|n| OrderLoads {
            roll_moment: mass[n].roll_moment + inertia[n].roll_moment,
            shaft_torque: mass[n].shaft_torque + inertia[n].shaft_torque,
            ..mass[n]
        })))
    }

    /// Adds a cylinder on axis `b` in plane `z` with its crank at `a`.
    fn add_to(&self, orders: &mut LayoutOrders, a: f64, b: f64, z: f64) {
        let axis = Complex64::cis(b);
        for (index, unit) in self.0.iter().enumerate() {
            let turned = Complex64::cis((index + 1) as f64 * (a - b));
            let force = [unit.force_forward * turned * axis, unit.force_backward * turned.conj() * axis];
            for sense in 0..2 {
                orders.force[index][sense] += force[sense];
                orders.couple[index][sense] += Complex64::new(0.0, z) * force[sense];
            }
            orders.roll_moment[index] += unit.roll_moment * turned;
            orders.shaft_torque[index] += unit.shaft_torque * turned;
        }
    }
}

/// Cases that differ by the angles of their throws alone, prepared.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Block {
    /// By group, then by angle.
    rows: Vec<[f64; ROW]>,
    /// Number of angles of a throw.
    angles: usize,
    /// `e^{i angle}`.
    turns: Vec<Complex64>,
    /// Bending moment at every station by a throw at angle 0 of every group [N m], station by station.
    bending: Vec<Complex64>,
    /// Load on every main bearing by a throw at angle 0 of every group [N], main by main.
    mains: Vec<Complex64>,
    groups: usize,
}

impl Block {
    /// Prepares all cranks whose throws take `angles`, with the sizes of `layout`.
    pub fn new(parts: &Parts, unit: &UnitCylinder, layout: &Layout, angles: &[f64]) -> Block {
        let (axes, leads, places) = (layout.bank_axes(), layout.pin_leads(), layout.bank_places());
        let square = parts.speed * parts.speed;
        let mut rows = Vec::with_capacity(layout.groups() * angles.len());
        for group in 0..layout.groups() {
            let plane = layout.group_plane(group);
            for &angle in angles {
                let mut orders = LayoutOrders::default();
                for bank in 0..axes.len() {
                    let (pin, z) = (angle + leads[bank], plane + places[bank]);
                    unit.add_to(&mut orders, pin, axes[bank], z);
                }
                let turn = Complex64::cis(angle);
                for (z, force) in turning(parts, layout, group) {
                    orders.add_turning(z, force * square * turn);
                }
                rows.push(orders.row());
            }
        }
        let (bending, mains) = beam_rows(parts, layout);
        Block {
            rows,
            angles: angles.len(),
            turns: angles.iter().map(|&angle| Complex64::cis(angle)).collect(),
            bending,
            mains,
            groups: layout.groups(),
        }
    }

    /// Prepares all cranks of an arrangement whose groups take `angles`.
    pub fn of_arrangement(loads: &ArrangedLoads, groups: usize, angles: &[f64]) -> Block {
        let row = |group| angles.iter().map(move |&angle| loads.orders_at(group, angle).row());
        Block {
            rows: (0..groups).flat_map(row).collect(),
            angles: angles.len(),
            turns: angles.iter().map(|&angle| Complex64::cis(angle)).collect(),
            bending: loads.bending.clone(),
            mains: loads.mains.clone(),
            groups,
        }
    }

    /// Loads of one layout without shafts.
    pub fn of_layout(parts: &Parts, layout: &Layout) -> Result<LayoutOrders, LoadError> {
        if let Some(arrangement) = &layout.arrangement {
            let loads = ArrangedLoads::of(parts, arrangement, &layout.counterweights)?;
            let block = Block::of_arrangement(&loads, layout.groups(), &layout.throw_angles);
            return Ok(block.orders(&(0..layout.groups() as u16).collect::<Vec<u16>>()));
        }
        let unit = UnitCylinder::new(parts, layout.rod_ratio)?;
        let block = Block::new(parts, &unit, layout, &layout.throw_angles);
        let throws: Vec<u16> = (0..layout.groups() as u16).collect();
        Ok(block.orders(&throws))
    }

    /// Loads of the crank whose throws stand at the angles of these places in the list, without shafts.
    #[inline]
    pub fn orders(&self, throws: &[u16]) -> LayoutOrders {
        let mut sum = [0.0; ROW];
        for (rows, &throw) in self.rows.chunks_exact(self.angles).zip(throws) {
            let row = &rows[throw as usize];
            for k in 0..ROW {
                sum[k] += row[k];
            }
        }
        LayoutOrders::of(&sum)
    }

    /// Largest bending moment along the crank by what turns with it, as a free beam [N m].
    pub fn bending_moment(&self, throws: &[u16]) -> f64 {
        self.largest(&self.bending, throws)
    }

    /// Largest load on a main bearing by what turns with the crank, throw by throw [N].
    pub fn main_load(&self, throws: &[u16]) -> f64 {
        self.largest(&self.mains, throws)
    }

    fn largest(&self, influences: &[Complex64], throws: &[u16]) -> f64 {
        let square = influences.chunks_exact(self.groups).map(|influence| {
            let turned = influence.iter().zip(throws).map(|(i, &throw)| i * self.turns[throw as usize]);
            turned.sum::<Complex64>().norm_sqr()
        });
        square.fold(0.0, f64::max).sqrt()
    }
}

/// What turns with the crank at a group whose throw stands at angle 0: planes [m] and unbalances [kg m].
fn turning(parts: &Parts, layout: &Layout, group: usize) -> Vec<(f64, Complex64)> {
    let mut at_zero = layout.clone();
    at_zero.throw_angles[group] = 0.0;
    let plane = layout.group_plane(group);
    let (leads, places) = (layout.pin_leads(), layout.bank_places());
    let mut turning = at_zero.web_weights(parts, group);
    let rod = parts.rod_big_end_mass * parts.crank_radius;
    turning.extend(
        leads.iter().zip(&places).map(|(lead, place)| (plane + place, Complex64::from_polar(rod, *lead))),
    );
    if layout.has_split_pins() {
        let half = 0.5 * parts.throw_unbalance;
        let pins = leads.iter().zip(&places);
        turning.extend(pins.map(|(lead, place)| (plane + place, Complex64::cis(*lead) * half)));
    } else {
        turning.push((plane, Complex64::from(parts.throw_unbalance)));
    }
    turning
}

/// Bending moment at every station (free beam) and load on every main bearing (throw by throw) by each group with its
/// throw at angle 0.
fn beam_rows(parts: &Parts, layout: &Layout) -> (Vec<Complex64>, Vec<Complex64>) {
    let mains = layout.mains();
    let beam = |model| Beam::new(&mains, model).expect("invariant: the spacing is positive");
    let (free, cut) = (beam(BeamModel::FreeBeam), beam(BeamModel::ThrowByThrow));
    let square = parts.speed * parts.speed;
    let by_group: Vec<Vec<(f64, Complex64)>> = (0..layout.groups())
        .map(|group| turning(parts, layout, group).into_iter().map(|(z, u)| (z, u * square)).collect())
        .collect();
    // Between loads and mains the moment runs straight: it is largest at one of them.
    let all = turning_loads(&layout.bare_engine(parts), 0, parts.speed);
    let mut stations: Vec<f64> = all.iter().map(|load| load.0).chain(mains.iter().copied()).collect();
    stations.sort_by(f64::total_cmp);
    stations.dedup();
    let bending = stations
        .iter()
        .flat_map(|&station| {
            let free = &free;
            by_group.iter().map(move |loads| {
                let sum: Complex64 = loads.iter().map(|&(z, f)| f * free.moment_influence(station, z)).sum();
                Complex64::I * sum
            })
        })
        .collect();
    let mut carried = vec![Complex64::ZERO; mains.len() * layout.groups()];
    for (group, loads) in by_group.iter().enumerate() {
        for &(z, force) in loads {
            for (main, share) in cut.shares(z) {
                carried[main * layout.groups() + group] += share * force;
            }
        }
    }
    (bending, carried)
}
