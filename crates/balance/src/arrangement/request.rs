//! What the search over arrangements is asked.

use crate::BalanceError;
use lanchester_model::Engine;
use lanchester_task::{Criterion, Limit, Load};
use serde::Serialize;
use std::f64::consts::TAU;

/// What is wanted, what may be fitted, where, and how large the parts are.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ArrangementRequest {
    /// What is judged: its peak over the cycle at the highest speed.
    pub criterion: Judged,
    /// Where the mounts are.
    pub mounts: MountPlaces,
    /// What is good enough.
    pub target: Target,
    /// Further limits that every arrangement must hold, e.g. on the roll moment.
    pub limits: Vec<Limit>,
    /// Cylinder spacings [m] to try; empty: that of the engine.
    pub spacings: Vec<f64>,
    /// Weights on crankshaft 1.
    pub crank: CrankWeights,
    /// Orders for which shafts may be fitted.
    pub shaft_orders: Vec<u32>,
    /// Most shafts, 0 to 4.
    pub most_shafts: usize,
    /// Planes [m] of the weights of double shafts; `None`: the outermost cylinder planes.
    pub shaft_planes: Option<[f64; 2]>,
    /// Where shafts may stand.
    pub positions: Positions,
    /// How shafts that turn with the crank are driven.
    pub drive: DriveRule,
    /// Sizes of the parts.
    pub parts: PartSizes,
}

impl Default for ArrangementRequest {
    /// Smallest peak force with everything allowed, gears, shafts on a ring just outside the crank sweep.
    fn default() -> Self {
        ArrangementRequest {
            criterion: Judged::Force,
            mounts: MountPlaces::Engine,
            target: Target::None,
            limits: Vec::new(),
            spacings: Vec::new(),
            crank: CrankWeights::OuterThrows,
            shaft_orders: vec![1, 2],
            most_shafts: 4,
            shaft_planes: None,
            positions: Positions::Ring { step: TAU / 48.0 },
            drive: DriveRule::Gears,
            parts: PartSizes::default(),
        }
    }
}

/// What is judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Judged {
    /// Peak of the resultant force.
    Force,
    /// Peak of the resultant couple about the origin.
    Couple,
    /// Peak of the largest force at any mount.
    MountForce,
}

impl Judged {
    /// The criterion that balancing minimises.
    pub fn criterion(self) -> Criterion {
        Criterion::Peak(match self {
            Judged::Force => Load::Force,
            Judged::Couple => Load::Couple,
            Judged::MountForce => Load::LargestMountForce,
        })
    }

    /// Name for tables: "force", "couple", "mount force".
    pub fn name(self) -> &'static str {
        match self {
            Judged::Force => "force",
            Judged::Couple => "couple",
            Judged::MountForce => "mount force",
        }
    }

    /// SI unit.
    pub fn unit(self) -> &'static str {
        match self {
            Judged::Couple => "N m",
            Judged::Force | Judged::MountForce => "N",
        }
    }
}

/// Where the mounts are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MountPlaces {
    /// Those of the engine file.
    Engine,
    /// Two mounts on the crank axis, this far apart [m], symmetric about the origin. Those of the reference engine
    /// too.
    Spacing(f64),
}

/// What is good enough.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Target {
    /// Nothing in particular: the front is all that is wanted.
    None,
    /// At most this, in the criterion's SI unit.
    Limit {
        /// Largest value that is good enough.
        most: f64,
    },
    /// No worse than another engine as it stands.
    Reference {
        /// The other engine.
        engine: Box<Engine>,
        /// Share of its value that counts: 0.5 compares a twin with half a four.
        share: f64,
    },
}

/// Weights on crankshaft 1.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CrankWeights {
    /// None may be added.
    None,
    /// In the planes of the first and the last throw.
    OuterThrows,
    /// In the plane of every throw.
    Throws,
    /// In these planes [m].
    Planes(Vec<f64>),
}

/// Where shafts may stand.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Positions {
    /// Around crankshaft 1, every `step` [rad], each as near to the crank as its weights and the rods let it.
    Ring {
        /// Angle between neighbouring positions [rad].
        step: f64,
    },
    /// At these points `[x, y]` [m].
    Points {
        /// Allowed positions.
        points: Vec<[f64; 2]>,
    },
    /// On a grid in a box.
    Box {
        /// Lowest and highest x [m].
        x: [f64; 2],
        /// Lowest and highest y [m].
        y: [f64; 2],
        /// Distance between neighbouring positions [m].
        step: f64,
    },
}

/// How shafts are driven.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DriveRule {
    /// Spur gears alone; a shaft that turns as its driver does needs an idler.
    Gears,
    /// A chain or toothed belt for a shaft that turns as its driver does, gears for the others.
    ChainOrBelt,
}

/// Sizes of the parts. Lengths in m, `None`: a rule that the answer states.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PartSizes {
    /// Radius of the circle that the crank with its weights sweeps [m]; `None`: crank radius and big end.
    pub crank_sweep: Option<f64>,
    /// Outer radius of a big end about its eye [m]; `None`: 0.75 of the crank radius.
    pub big_end_radius: Option<f64>,
    /// Width of a rod's shank in the plane across the crank [m]; `None`: half the crank radius.
    pub rod_width: Option<f64>,
    /// Wall between bore and crankcase [m].
    pub cylinder_wall: f64,
    /// Outer radius of the weights of a shaft (half discs) [m]; `None`: from the length that there is for them.
    pub weight_sweep: Option<f64>,
    /// Distance of a crank weight's centre of gravity from the axis [m]; `None`: the crank radius.
    pub crank_weight_radius: Option<f64>,
    /// Radius of a balance shaft [m].
    pub shaft_radius: f64,
    /// Radius of the crankshaft where gears run past it [m]; `None`: half the crank radius.
    pub crank_journal_radius: Option<f64>,
    /// Density of weights, shafts and gears [kg/m^3].
    pub density: f64,
    /// Least distance between parts that must not touch [m].
    pub clearance: f64,
    /// Module of the gears [m]: teeth reach this far beyond the pitch circle.
    pub gear_module: f64,
    /// Width of the gears [m].
    pub gear_width: f64,
    /// Planes [m] of the two bearings of every shaft; `None`: just beyond its weights.
    pub bearing_planes: Option<[f64; 2]>,
    /// Friction coefficient of the shaft bearings, at the shaft's radius.
    pub bearing_friction: f64,
    /// Efficiency of one mesh (or chain).
    pub mesh_efficiency: f64,
}

impl Default for PartSizes {
    /// Steel; 12 mm shaft radius; 3 mm clearance; module 2 mm, 12 mm wide; friction 0.005; 99 % a mesh.
    fn default() -> Self {
        PartSizes {
            crank_sweep: None,
            big_end_radius: None,
            rod_width: None,
            cylinder_wall: 0.005,
            weight_sweep: None,
            crank_weight_radius: None,
            shaft_radius: 0.012,
            crank_journal_radius: None,
            density: 7850.0,
            clearance: 0.003,
            gear_module: 0.002,
            gear_width: 0.012,
            bearing_planes: None,
            bearing_friction: 0.005,
            mesh_efficiency: 0.99,
        }
    }
}

impl ArrangementRequest {
    /// Refuses numbers without a meaning.
    pub(crate) fn check(&self) -> Result<(), BalanceError> {
        let refuse = |quantity, device: &str, needed, got| {
            Err(BalanceError::Number { quantity, device: device.to_owned(), needed, got })
        };
        let positive = |v: f64| v.is_finite() && v > 0.0;
        let parts = &self.parts;
        let lengths = [
            ("crank sweep", parts.crank_sweep),
            ("big-end radius", parts.big_end_radius),
            ("rod width", parts.rod_width),
            ("weight sweep", parts.weight_sweep),
            ("radius of the crank weights", parts.crank_weight_radius),
            ("journal radius of the crank", parts.crank_journal_radius),
            ("shaft radius", Some(parts.shaft_radius)),
            ("density", Some(parts.density)),
            ("module", Some(parts.gear_module)),
            ("gear width", Some(parts.gear_width)),
        ];
        for (quantity, value) in lengths {
            if let Some(got) = value.filter(|v| !positive(*v)) {
                return refuse(quantity, "parts", "above 0", got);
            }
        }
        for (quantity, got) in [
            ("clearance", parts.clearance),
            ("wall of the cylinders", parts.cylinder_wall),
            ("friction of the bearings", parts.bearing_friction),
        ] {
            if !(got.is_finite() && got >= 0.0) {
                return refuse(quantity, "parts", "0 or more", got);
            }
        }
        if !(parts.mesh_efficiency > 0.0 && parts.mesh_efficiency <= 1.0) {
            return refuse("efficiency", "meshes", "above 0 and at most 1", parts.mesh_efficiency);
        }
        if let Some(got) = self.spacings.iter().copied().find(|s| !(s.is_finite() && *s >= 0.0)) {
            return refuse("spacing", "cylinders", "0 or more", got);
        }
        if let MountPlaces::Spacing(got) = self.mounts
            && !positive(got)
        {
            return refuse("spacing", "mounts", "above 0", got);
        }
        match &self.target {
            Target::Limit { most } if !positive(*most) => {
                return refuse("limit", self.criterion.name(), "above 0", *most);
            }
            Target::Reference { share, engine } if !positive(*share) => {
                return refuse("share", &engine.name, "above 0", *share);
            }
            _ => {}
        }
        if self.most_shafts > 4 {
            return refuse("number", "shafts", "0 to 4", self.most_shafts as f64);
        }
        if let Some(got) = self.shaft_orders.iter().find(|o| !(1..=2).contains(*o)) {
            return refuse("order", "shafts", "1 or 2", f64::from(*got));
        }
        for (device, planes) in [("double shafts", self.shaft_planes), ("bearings", parts.bearing_planes)] {
            if let Some([front, rear]) = planes
                && !(front.is_finite() && rear.is_finite() && front < rear)
            {
                return refuse("distance of the two planes", device, "above 0", rear - front);
            }
        }
        if let CrankWeights::Planes(planes) = &self.crank
            && let Some(got) = planes.iter().copied().find(|z| !z.is_finite())
        {
            return refuse("plane", "crank weights", "finite", got);
        }
        self.positions.check()
    }
}

/// Most allowed positions: with pairs of shafts their number counts twice.
const MOST_POSITIONS: usize = 400;

impl Positions {
    fn check(&self) -> Result<(), BalanceError> {
        let refuse = |quantity, needed, got| {
            Err(BalanceError::Number { quantity, device: "allowed positions".to_owned(), needed, got })
        };
        let finite = |v: &[f64]| v.iter().all(|v| v.is_finite() && v.abs() < 1e3);
        match self {
            Positions::Ring { step } if !(*step >= TAU / MOST_POSITIONS as f64 && *step <= TAU) => {
                refuse("step", "from 0.9 to 360 deg (in rad: 0.0157 to 6.2832)", *step)
            }
            Positions::Points { points } if points.is_empty() || points.len() > MOST_POSITIONS => {
                refuse("number", "1 to 400", points.len() as f64)
            }
            Positions::Points { points } => match points.iter().find(|p| !finite(&p[..])) {
                Some(p) => refuse("coordinate", "within 1000 m", if finite(&p[..1]) { p[1] } else { p[0] }),
                None => Ok(()),
            },
            Positions::Box { x, y, step } => {
                if !(finite(x) && finite(y) && x[0] <= x[1] && y[0] <= y[1]) {
                    return refuse("extent", "0 or more", (x[1] - x[0]).min(y[1] - y[0]));
                }
                let count = ((x[1] - x[0]) / step + 1.0).floor() * ((y[1] - y[0]) / step + 1.0).floor();
                if *step > 0.0 && count <= MOST_POSITIONS as f64 {
                    Ok(())
                } else {
                    refuse("step", "so large that there are at most 400 of them", *step)
                }
            }
            Positions::Ring { .. } => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_is_allowed_and_nonsense_is_not() {
        assert_eq!(ArrangementRequest::default().check(), Ok(()));
        let wrong: [fn(&mut ArrangementRequest); 9] = [
            |r| r.target = Target::Limit { most: -1.0 },
            |r| r.mounts = MountPlaces::Spacing(0.0),
            |r| r.spacings = vec![0.088, f64::NAN],
            |r| r.most_shafts = 5,
            |r| r.shaft_orders = vec![3],
            |r| r.parts.mesh_efficiency = 0.0,
            |r| r.shaft_planes = Some([0.1, 0.1]),
            |r| r.positions = Positions::Points { points: Vec::new() },
            |r| r.positions = Positions::Box { x: [0.0, 1.0], y: [0.0, 1.0], step: 0.001 },
        ];
        for (index, spoil) in wrong.into_iter().enumerate() {
            let mut request = ArrangementRequest::default();
            spoil(&mut request);
            assert!(matches!(request.check(), Err(BalanceError::Number { .. })), "case {index}");
        }
    }
}
