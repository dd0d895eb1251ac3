//! The torsional chain: inertias joined by shafts, a tree with any speed ratios.
//!
//! Angles are those of the shafts at their mean speed taken away. A station at the ratio rho (its speed over that of the reference) has the
//! referred angle phi = angle / rho; inertias, dampings and stiffnesses count rho^2 times at the reference, torques rho times:
//!
//! ```text
//! J phi'' + C phi' + K phi = T        K = SUM k_s rho_s^2 b_s b_s^T,   b_s = e_from - e_to                                      (50.1)
//! ```
//! A shaft's own twist is rho_s (phi_from - phi_to), its torque k_s times that; both ends turn with it at rest, so rigid turning twists nothing.

use crate::error::{ChainFault, TorsionError};
use serde::Serialize;

/// An inertia of the chain.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Station {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: StationKind,
    /// Moment of inertia about its own axis [kg m^2].
    pub inertia: f64,
    /// Damping against the ground, at its own speed [N m s/rad].
    pub damping: f64,
    /// Its speed over that of the reference (crankshaft 1).
    pub ratio: f64,
}

/// What a station is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StationKind {
    /// The seismic ring of a damper.
    Ring,
    /// The free end: hub of the damper, pulley.
    Nose,
    /// The throw with this index.
    Throw(usize),
    /// The flywheel, or the primary side of a dual-mass flywheel.
    Flywheel,
    /// Behind the flywheel, or a branch.
    Driven,
    /// A pendulum absorber.
    Pendulum,
    /// Anything else.
    Other,
}

/// What joins two stations.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Shaft {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: ShaftKind,
    /// Index of the station at its front end.
    pub from: usize,
    /// Index of the station at its rear end.
    pub to: usize,
    /// Stiffness at its own speed [N m/rad].
    pub stiffness: f64,
    /// Stiffness over the square of the reference speed, of a pendulum in the centrifugal field [N m s^2/rad^3].
    pub spin_stiffness: f64,
    /// Viscous damping of its twist [N m s/rad].
    pub damping: f64,
    /// Loss factor of its stiffness [1].
    pub loss_factor: f64,
    /// Its speed over that of the reference.
    pub ratio: f64,
    /// Section in which its stress is told, where it is a shaft of known size.
    pub section: Option<ShaftSection>,
}

/// What a shaft is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ShaftKind {
    /// A piece of crankshaft or any shaft.
    Shaft,
    /// What joins the ring of a damper to its hub; its stiffness may be 0.
    Damper,
    /// The suspension of a pendulum.
    Pendulum,
    /// A clutch, a dual-mass flywheel, a coupling.
    Coupling,
}

/// A round section.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ShaftSection {
    /// Outer diameter [m].
    pub diameter: f64,
    /// Diameter of the bore [m].
    pub bore: f64,
}

impl ShaftSection {
    /// Polar section modulus [m^3].
    pub fn modulus(self) -> f64 {
        let (outer, inner) = (self.diameter, self.bore);
        std::f64::consts::PI * (outer.powi(4) - inner.powi(4)) / (16.0 * outer)
    }
}

impl Station {
    /// A station at the reference speed without damping.
    pub fn new(name: impl Into<String>, kind: StationKind, inertia: f64) -> Station {
        Station { name: name.into(), kind, inertia, damping: 0.0, ratio: 1.0 }
    }
}

impl Shaft {
    /// A shaft at the reference speed without damping.
    pub fn new(name: impl Into<String>, from: usize, to: usize, stiffness: f64) -> Shaft {
        Shaft {
            name: name.into(),
            kind: ShaftKind::Shaft,
            from,
            to,
            stiffness,
            spin_stiffness: 0.0,
            damping: 0.0,
            loss_factor: 0.0,
            ratio: 1.0,
            section: None,
        }
    }

    /// Stiffness at its own speed while the reference turns at `speed` [rad/s].
    pub fn stiffness_at(&self, speed: f64) -> f64 {
        self.stiffness + self.spin_stiffness * speed * speed
    }
}

/// A chain that is known to be valid: a tree of two or more stations, each with an inertia.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Chain {
    stations: Vec<Station>,
    shafts: Vec<Shaft>,
    /// Stations in an order in which every one stands after its parent; the first is the root.
    #[serde(skip)]
    order: Vec<usize>,
    /// Parent of each station and the shaft to it; that of the root is itself.
    #[serde(skip)]
    parents: Vec<(usize, usize)>,
}

impl Chain {
    /// The chain of these stations and shafts.
    ///
    /// # Errors
    /// [`TorsionError::Chain`] with all faults at once: a station without inertia, a shaft without stiffness, a number that is negative or none, ends that
    /// do not exist, more stations than shafts hold together, a loop.
    pub fn new(stations: Vec<Station>, shafts: Vec<Shaft>) -> Result<Chain, TorsionError> {
        let mut faults = Vec::new();
        if stations.len() < 2 {
            faults.push(fault(
                "chain",
                format!("needed are two stations or more, got {}", stations.len()),
                "add stations",
            ));
        }
        for (index, station) in stations.iter().enumerate() {
            let place = format!("station {} ({})", index + 1, station.name);
            let mut check = |what: &str, value: f64, is_good: bool, needed: &str, remedy: &str| {
                if !is_good || !value.is_finite() {
                    faults.push(fault(&place, format!("{what} must be {needed}, got {value}"), remedy));
                }
            };
            let remedy = "give its moment of inertia, or join it to its neighbour";
            check("the inertia [kg m2]", station.inertia, station.inertia > 0.0, "more than 0", remedy);
            check(
                "the damping [N m s/rad]",
                station.damping,
                station.damping >= 0.0,
                "0 or more",
                "leave it out or give a loss",
            );
            check(
                "the speed ratio",
                station.ratio,
                station.ratio != 0.0,
                "other than 0",
                "give its speed over that of the crankshaft",
            );
        }
        let count = stations.len();
        for (index, shaft) in shafts.iter().enumerate() {
            let place = format!("shaft {} ({})", index + 1, shaft.name);
            let mut check = |what: &str, value: f64, is_good: bool, needed: &str, remedy: &str| {
                if !is_good || !value.is_finite() {
                    faults.push(fault(&place, format!("{what} must be {needed}, got {value}"), remedy));
                }
            };
            let floats = shaft.kind == ShaftKind::Damper && shaft.damping > 0.0 || shaft.spin_stiffness > 0.0;
            let (is_stiff, needed) = if floats {
                (shaft.stiffness >= 0.0, "0 or more")
            } else {
                (shaft.stiffness > 0.0, "more than 0")
            };
            check(
                "the stiffness [N m/rad]",
                shaft.stiffness,
                is_stiff,
                needed,
                "give its stiffness; where it is rigid, join its two inertias",
            );
            check(
                "the stiffness over speed squared",
                shaft.spin_stiffness,
                shaft.spin_stiffness >= 0.0,
                "0 or more",
                "leave it out",
            );
            check(
                "the damping [N m s/rad]",
                shaft.damping,
                shaft.damping >= 0.0,
                "0 or more",
                "leave it out or give a loss",
            );
            check(
                "the loss factor",
                shaft.loss_factor,
                (0.0..10.0).contains(&shaft.loss_factor),
                "0 or more and less than 10",
                "steel has some 0.01, rubber 0.1 to 0.3",
            );
            check(
                "the speed ratio",
                shaft.ratio,
                shaft.ratio != 0.0,
                "other than 0",
                "give its speed over that of the crankshaft",
            );
            if let Some(section) = shaft.section {
                let fits = section.diameter > 0.0 && section.bore >= 0.0 && section.bore < section.diameter;
                check(
                    "the bore [m]",
                    section.bore,
                    fits,
                    "less than the diameter",
                    "give diameter and bore of the shaft",
                );
            }
            for (end, station) in [("front", shaft.from), ("rear", shaft.to)] {
                if station >= count {
                    faults.push(fault(
                        &place,
                        format!("its {end} end is station {}, of {count}", station + 1),
                        "name a station that is there",
                    ));
                }
            }
            if shaft.from == shaft.to {
                faults.push(fault(&place, "both ends are the same station".into(), "name two stations"));
            }
        }
        if !faults.is_empty() {
            return Err(TorsionError::Chain(faults));
        }
        let (order, parents) = walk(&stations, &shafts, &mut faults);
        if !faults.is_empty() {
            return Err(TorsionError::Chain(faults));
        }
        Ok(Chain { stations, shafts, order, parents })
    }

    /// A plain chain at one speed without damping: shaft `i` joins station `i` to the next.
    ///
    /// # Errors
    /// As [`Chain::new`]; where there are not as many shafts as stations less one.
    pub fn plain(inertias: &[f64], stiffnesses: &[f64]) -> Result<Chain, TorsionError> {
        let stations = inertias
            .iter()
            .enumerate()
            .map(|(i, j)| Station::new(format!("{}", i + 1), StationKind::Other, *j))
            .collect();
        let shafts = stiffnesses
            .iter()
            .enumerate()
            .map(|(i, k)| Shaft::new(format!("{}-{}", i + 1, i + 2), i, i + 1, *k))
            .collect();
        Chain::new(stations, shafts)
    }

    /// Its stations.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// Its shafts.
    pub fn shafts(&self) -> &[Shaft] {
        &self.shafts
    }

    /// A copy with other stations and shafts.
    ///
    /// # Errors
    /// As [`Chain::new`].
    pub fn with(
        &self,
        change: impl FnOnce(&mut Vec<Station>, &mut Vec<Shaft>),
    ) -> Result<Chain, TorsionError> {
        let (mut stations, mut shafts) = (self.stations.clone(), self.shafts.clone());
        change(&mut stations, &mut shafts);
        Chain::new(stations, shafts)
    }

    /// Index of the first station of a kind.
    pub fn station(&self, kind: StationKind) -> Option<usize> {
        self.stations.iter().position(|station| station.kind == kind)
    }

    /// Index of the shaft that joins a damper's ring to its hub.
    pub fn damper(&self) -> Option<usize> {
        self.shafts.iter().position(|shaft| shaft.kind == ShaftKind::Damper)
    }

    /// Index of the free end of the crankshaft: its nose, else the first throw, else the first station.
    pub fn nose(&self) -> usize {
        let throw = || self.stations.iter().position(|station| matches!(station.kind, StationKind::Throw(_)));
        self.station(StationKind::Nose).or_else(throw).unwrap_or(0)
    }

    /// Index of the flywheel; without one the last station.
    pub fn flywheel(&self) -> usize {
        self.station(StationKind::Flywheel).unwrap_or(self.stations.len() - 1)
    }

    /// Sum of all inertias at the reference [kg m^2].
    pub fn total_inertia(&self) -> f64 {
        (0..self.stations.len()).map(|station| self.referred_inertia(station)).sum()
    }

    /// Inertia of a station at the reference [kg m^2].
    pub fn referred_inertia(&self, station: usize) -> f64 {
        let own = &self.stations[station];
        own.inertia * own.ratio * own.ratio
    }

    /// Share of the strain energy of a shape (angles of the stations at their own speeds) that shafts of this kind hold, while the reference turns at
    /// `speed` [rad/s]; 0 where nothing is strained.
    pub fn strain_share(&self, shape: &[f64], kind: ShaftKind, speed: f64) -> f64 {
        let angle = |station: usize| shape[station] / self.stations[station].ratio;
        let energies = self.shafts.iter().enumerate().map(|(index, shaft)| {
            let twist = angle(shaft.to) - angle(shaft.from);
            (shaft.kind, self.referred_stiffness(index, speed) * twist * twist)
        });
        let (own, all) = energies.fold((0.0, 0.0), |(own, all), (of, energy)| {
            (if of == kind { own + energy } else { own }, all + energy)
        });
        if all > 0.0 { own / all } else { 0.0 }
    }

    /// Stiffness of a shaft at the reference, which turns at `speed` [rad/s] [N m/rad].
    pub fn referred_stiffness(&self, shaft: usize, speed: f64) -> f64 {
        let own = &self.shafts[shaft];
        own.stiffness_at(speed) * own.ratio * own.ratio
    }

    /// Stations in an order in which every one stands after its parent; the first is the root.
    pub(crate) fn order(&self) -> &[usize] {
        &self.order
    }

    /// Parent of a station and the shaft to it.
    pub(crate) fn parent(&self, station: usize) -> (usize, usize) {
        self.parents[station]
    }
}

fn fault(place: &str, what: String, remedy: &str) -> ChainFault {
    ChainFault { place: place.to_owned(), what, remedy: remedy.to_owned() }
}

/// The tree from the last station as its root.
fn walk(
    stations: &[Station],
    shafts: &[Shaft],
    faults: &mut Vec<ChainFault>,
) -> (Vec<usize>, Vec<(usize, usize)>) {
    let count = stations.len();
    let root = count - 1;
    let (mut order, mut parents) = (vec![root], vec![(root, usize::MAX); count]);
    let mut is_known = vec![false; count];
    is_known[root] = true;
    let mut used = vec![false; shafts.len()];
    let mut next = 0;
    while next < order.len() {
        let station = order[next];
        next += 1;
        for (index, shaft) in shafts.iter().enumerate() {
            if used[index] || (shaft.from != station && shaft.to != station) {
                continue;
            }
            used[index] = true;
            let other = if shaft.from == station { shaft.to } else { shaft.from };
            if is_known[other] {
                let what = "it closes a loop of shafts, and a chain is a tree".to_owned();
                let place = format!("shaft {} ({})", index + 1, shaft.name);
                faults.push(fault(
                    &place,
                    what,
                    "leave out one shaft of the loop, or join parallel shafts into one",
                ));
                continue;
            }
            is_known[other] = true;
            parents[other] = (station, index);
            order.push(other);
        }
    }
    for (index, _) in is_known.iter().enumerate().filter(|(_, known)| !**known) {
        let place = format!("station {} ({})", index + 1, stations[index].name);
        let what = format!(
            "nothing joins it to the rest: {count} stations need {} shafts, got {}",
            count - 1,
            shafts.len()
        );
        faults.push(fault(&place, what, "add the shaft that joins it, or leave it out"));
    }
    (order, parents)
}
