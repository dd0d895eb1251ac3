//! One case in physical terms, and as an engine.

use crate::explore::as_given::Arrangement;
use crate::explore::counterweight_pattern::CounterweightPattern;
use crate::explore::firing::{FiringUnit, Neighbours};
use crate::explore::parts::Parts;
use crate::explore::shaft_set::ShaftSet;
use lanchester_model::{
    Counterweight, Crankshaft, Cylinder, Engine, EngineParts, Ratio, Rod, RodJoint, RodMassRule, Rotation,
    SpeedRange, Strokes, Throw,
};
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Widest V whose bisector is the x axis; beyond it x is the axis of bank 1 (book, "Conventions").
const WIDEST_V: f64 = 170.0 * PI / 180.0;

/// A layout: one case of a space.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Layout {
    /// Number of the case.
    pub case: u128,
    /// Cylinders: of two banks those of bank 1 first.
    pub cylinders: usize,
    /// Distance of neighbouring groups [m]; the mean where cylinders stay where they are.
    pub spacing: f64,
    /// The two banks; `None` in line, and where cylinders stay where they are.
    pub banks: Option<BankPair>,
    /// Crank radius over rod length; the mean where rods stay what they are.
    pub rod_ratio: f64,
    /// Weights on the webs.
    pub counterweights: CounterweightPattern,
    /// Balance shafts.
    pub shafts: ShaftSet,
    /// Angle of each group's throw (of split pins: of bank 1's) from the first [rad].
    pub throw_angles: Vec<f64>,
    /// Crank angle [rad] in the cycle at which each cylinder fires, by its number; `None` where firing is left out.
    pub firing_angles: Option<Vec<f64>>,
    /// The engine whose cylinders stay where they are; `None` in line and of two banks alike.
    #[serde(skip)]
    #[schemars(skip)]
    pub arrangement: Option<Arc<Arrangement>>,
}

/// How two banks stand.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BankPair {
    /// Angle between them [rad].
    pub bank_angle: f64,
    /// How far the pin of bank 2 stands ahead of that of bank 1 [rad]; 0: shared pins.
    pub split_angle: f64,
    /// How far bank 2 stands behind bank 1 along the crank [m].
    pub stagger: f64,
}

impl Layout {
    /// Groups along the crank.
    pub fn groups(&self) -> usize {
        self.throw_angles.len()
    }

    /// Directions of the banks' axes [rad].
    pub fn bank_axes(&self) -> Vec<f64> {
        match self.banks {
            None => vec![0.0],
            Some(BankPair { bank_angle, .. }) if bank_angle <= WIDEST_V => {
                vec![-0.5 * bank_angle, 0.5 * bank_angle]
            }
            Some(BankPair { bank_angle, .. }) => vec![0.0, bank_angle],
        }
    }

    /// How far the pin of each bank stands ahead of the throw [rad].
    pub fn pin_leads(&self) -> Vec<f64> {
        self.banks.map_or(vec![0.0], |pair| vec![0.0, pair.split_angle])
    }

    /// How far the cylinders of each bank stand behind the middle of their group [m].
    pub fn bank_places(&self) -> Vec<f64> {
        self.banks.map_or(vec![0.0], |pair| vec![-0.5 * pair.stagger, 0.5 * pair.stagger])
    }

    /// Whether the two rods of a group have a pin each.
    pub fn has_split_pins(&self) -> bool {
        self.banks.is_some_and(|pair| pair.split_angle != 0.0)
    }

    /// Plane of a group [m]: the origin is the middle of the crankshaft.
    pub fn group_plane(&self, group: usize) -> f64 {
        (group as f64 - 0.5 * (self.groups() as f64 - 1.0)) * self.spacing
    }

    /// Numbers of the cylinders in the order of firing, that of cylinder 1 first; `None` where firing is left out.
    /// Cylinders that fire together stand by number.
    pub fn firing_order(&self) -> Option<Vec<usize>> {
        let angles = self.firing_angles.as_ref()?;
        let cycle = if angles.iter().any(|&a| a >= TAU) { 2.0 * TAU } else { TAU };
        let after = |cylinder: usize| {
            let angle = (angles[cylinder] - angles[0]).rem_euclid(cycle);
            if cycle - angle < 1e-6 { 0.0 } else { angle }
        };
        let mut order: Vec<usize> = self.firing_cylinders();
        order.sort_by(|&a, &b| {
            let steps = |cylinder| (after(cylinder) * 1e6).round();
            steps(a).total_cmp(&steps(b)).then(a.cmp(&b))
        });
        Some(order.into_iter().map(|cylinder| cylinder + 1).collect())
    }

    /// Cylinders that fire, from 0: of a chamber that pistons share the first.
    fn firing_cylinders(&self) -> Vec<usize> {
        match &self.arrangement {
            Some(arrangement) => arrangement.chambers(),
            None => (0..self.cylinders).collect(),
        }
    }

    /// What fires once a cycle.
    pub(crate) fn firing_units(&self) -> Vec<FiringUnit> {
        if let Some(arrangement) = &self.arrangement {
            let chambers = arrangement.chambers().into_iter().zip(&arrangement.top_dead_centres);
            return chambers
                .map(|(first, &axis)| FiringUnit { group: arrangement.group_of(first), lead: 0.0, axis })
                .collect();
        }
        let banks = self.bank_axes().into_iter().zip(self.pin_leads());
        banks
            .flat_map(|(axis, lead)| (0..self.groups()).map(move |group| FiringUnit { group, lead, axis }))
            .collect()
    }

    /// Top dead centre of cylinder 1 in the first revolution [rad].
    pub fn first_firing(&self) -> f64 {
        let first = self.firing_units()[0];
        (first.axis - (self.throw_angles[first.group] + first.lead)).rem_euclid(TAU)
    }

    /// Numbers of chambers as numbers of cylinders: all pistons of a chamber have its own.
    pub(crate) fn by_cylinder(&self, by_chamber: Vec<f64>) -> Vec<f64> {
        let Some(arrangement) = &self.arrangement else { return by_chamber };
        let firsts = arrangement.chambers();
        let chamber = |index: usize, first: Option<usize>| {
            firsts.partition_point(|chamber| *chamber < first.unwrap_or(index))
        };
        let pistons = arrangement.cylinders.iter().enumerate();
        pistons.map(|(index, piston)| by_chamber[chamber(index, piston.chamber)]).collect()
    }

    /// Which of [`Layout::firing_units`] stand side by side.
    pub(crate) fn neighbours(&self) -> Neighbours {
        let Some(arrangement) = &self.arrangement else { return Neighbours::Banks(self.groups()) };
        let chambers = arrangement.chambers();
        let unit = |cylinder| chambers.partition_point(|first| *first < cylinder);
        Neighbours::Pairs(arrangement.neighbours().into_iter().map(|pair| pair.map(unit)).collect())
    }

    /// Largest difference of a firing interval from the even one [rad]; `None` where firing is left out.
    pub fn unevenness(&self, strokes: Strokes) -> Option<f64> {
        let cycle = TAU * f64::from(strokes.revolutions());
        let all = self.firing_angles.as_ref()?;
        let mut angles: Vec<f64> =
            self.firing_cylinders().into_iter().map(|cylinder| all[cylinder]).collect();
        angles.sort_by(f64::total_cmp);
        let even = cycle / angles.len() as f64;
        let next = angles.iter().skip(1).copied().chain([angles[0] + cycle]);
        Some(angles.iter().zip(next).map(|(angle, next)| (next - angle - even).abs()).fold(0.0, f64::max))
    }

    /// Planes of the main bearings [m]: midway between neighbouring groups, and as far beyond the outermost ones.
    pub(crate) fn mains(&self) -> Vec<f64> {
        (0..=self.groups()).map(|main| self.group_plane(main) - 0.5 * self.spacing).collect()
    }

    /// Weights on the webs of a group: plane [m] and unbalance [kg m] as a vector that turns with the crank.
    pub(crate) fn web_weights(&self, parts: &Parts, group: usize) -> Vec<(f64, Complex64)> {
        let leads = self.pin_leads();
        let pins: Complex64 = leads.iter().map(|lead| Complex64::cis(self.throw_angles[group] + lead)).sum();
        let mean = pins / leads.len() as f64;
        let riders = leads.len() as f64;
        let pattern = &self.counterweights;
        let rotating = parts.throw_unbalance + riders * parts.rod_big_end_mass * parts.crank_radius;
        let reciprocating = riders * parts.reciprocating_mass() * parts.crank_radius;
        let weight = -0.5 * (pattern.rotating * rotating + pattern.reciprocating * reciprocating) * mean;
        let plane = self.group_plane(group);
        [-0.5, 0.5]
            .into_iter()
            .enumerate()
            .filter(|(side, _)| pattern.webs.as_ref().is_none_or(|webs| webs[2 * group + side]))
            .map(|(_, side)| (plane + side * parts.web_distance, weight))
            .collect()
    }

    /// The layout without its shafts as an engine.
    pub(crate) fn bare_engine(&self, parts: &Parts) -> Engine {
        if let Some(arrangement) = &self.arrangement {
            let firing = self.firing_angles.as_ref();
            let by_chamber: Option<Vec<f64>> =
                firing.map(|all| self.firing_cylinders().into_iter().map(|cylinder| all[cylinder]).collect());
            return arrangement.engine(
                parts,
                &self.counterweights,
                &self.throw_angles,
                by_chamber.as_deref(),
            );
        }
        let (axes, leads, places) = (self.bank_axes(), self.pin_leads(), self.bank_places());
        let split = self.has_split_pins();
        let (mut throws, mut on_throw) = (Vec::new(), vec![0; self.cylinders]);
        for group in 0..self.groups() {
            let plane = self.group_plane(group);
            let pins = if split { 2 } else { 1 };
            for bank in 0..axes.len() {
                on_throw[bank * self.groups() + group] = throws.len() + if split { bank } else { 0 };
            }
            for pin in 0..pins {
                throws.push(Throw {
                    crankshaft: 0,
                    angle: self.throw_angles[group] + if split { leads[pin] } else { 0.0 },
                    z: plane + if split { places[pin] } else { 0.0 },
                    radius: parts.crank_radius,
                    unbalance: parts.throw_unbalance / pins as f64,
                    unbalance_offset: 0.0,
                    webs: None,
                });
            }
        }
        let cylinders = (0..self.cylinders)
            .map(|index| {
                let (bank, group) = (index / self.groups(), index % self.groups());
                Cylinder {
                    throw: on_throw[index],
                    angle: axes[bank],
                    z: self.group_plane(group) + places[bank],
                    firing_angle: self.firing_angles.as_ref().map(|angles| angles[index]),
                    chamber: None,
                    ..cylinder(parts, self.rod_ratio)
                }
            })
            .collect();
        let counterweights = (0..self.groups())
            .flat_map(|group| self.web_weights(parts, group))
            .enumerate()
            .map(|(index, (z, weight))| Counterweight {
                name: format!("web weight {}", index + 1),
                crankshaft: 0,
                z,
                unbalance: weight.norm(),
                angle: weight.arg(),
                part: None,
            })
            .collect();
        engine(parts, throws, cylinders, counterweights, self.mains())
    }
}

/// The cylinder of the parts on throw 1, its axis along +x in the plane of the origin.
pub(crate) fn cylinder(parts: &Parts, rod_ratio: f64) -> Cylinder {
    Cylinder {
        throw: 0,
        angle: 0.0,
        z: 0.0,
        offset: 0.0,
        pin_offset: 0.0,
        bore: Some(parts.bore),
        piston_mass: parts.piston_mass,
        rod: Rod {
            length: parts.crank_radius / rod_ratio,
            big_end_mass: parts.rod_big_end_mass,
            small_end_mass: parts.rod_small_end_mass,
            inertia: parts.rod_inertia,
            axial_inertia: 0.0,
            mass_rule: RodMassRule::WeighedEnds,
            joint: RodJoint::Crankpin,
        },
        firing_angle: None,
        chamber: None,
    }
}

/// An engine of these parts on one crankshaft.
pub(crate) fn engine(
    parts: &Parts,
    throws: Vec<Throw>,
    cylinders: Vec<Cylinder>,
    counterweights: Vec<Counterweight>,
    mains: Vec<f64>,
) -> Engine {
    let parts = EngineParts {
        name: "layout".to_string(),
        strokes: parts.strokes,
        rotation: Rotation::Clockwise,
        speed: SpeedRange { lowest: parts.speed, highest: parts.speed },
        crankshafts: vec![Crankshaft {
            name: "crankshaft".to_string(),
            ratio: Ratio::ONE,
            phase: 0.0,
            x: 0.0,
            y: 0.0,
            mains: Some(mains),
        }],
        throws,
        cylinders,
        counterweights,
        ..EngineParts::default()
    };
    Engine::new(parts).expect("invariant: the space of layouts holds engines that turn")
}
