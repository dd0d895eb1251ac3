//! The torsional chain of an engine: inertias from the one list of what turns, rods and pistons by their exact motion, stiffnesses from the file, from
//! finite elements, or from the sizes of the crankshaft.

use crate::chain::{Chain, Shaft, ShaftKind, ShaftSection, Station, StationKind};
use crate::crank_train::{inertia_orders, train_inertia};
use crate::error::{ChainFault, TorsionError};
use crate::ker_wilson;
use crate::pendulum::Pendulum;
use lanchester_model::{
    BranchPlace, CrankElement, CrankElementForm, DrivelineInertia, Engine, GearEnd, RotatingBody,
    RotatingKind, TorsionDesign,
};
use serde::Serialize;

/// Loss factor of a crankshaft where the file gives no damping at all.
const ASSUMED_LOSS: f64 = 0.01;
/// Young's modulus [Pa] and Poisson's ratio of steel, where the file gives no material.
const STEEL: [f64; 2] = [210e9, 0.3];

/// What a chain is made of.
#[derive(Debug, Clone)]
pub struct CrankChainInput<'a> {
    /// The engine.
    pub engine: &'a Engine,
    /// All that turns at a fixed ratio: [`lanchester_model::EngineParts::rotating_bodies`].
    pub bodies: &'a [RotatingBody],
    /// Of each throw the inertia of its pin, webs and counterweights [kg m^2], where the crankshaft is a body.
    pub throws: &'a [Option<f64>],
    /// What is behind the flywheel, in order.
    pub driveline: &'a [DrivelineInertia],
    /// Stiffness of throws between the middles of their journals by another method [N m/rad], with the index of the throw: of finite elements.
    pub stiffness: &'a [(usize, f64)],
}

/// A chain with where its numbers come from.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankChain {
    /// The chain.
    pub chain: Chain,
    /// Station of each throw.
    pub throws: Vec<usize>,
    /// Inertia of each throw by its parts.
    pub parts: Vec<ThrowParts>,
    /// For each shaft its stiffness by Ker Wilson's lengths [N m/rad], where the crankshaft has sizes.
    pub ker_wilson: Vec<Option<f64>>,
    /// What the file does not say and was assumed, and what was left out.
    pub notes: Vec<String>,
}

/// Inertia of a throw about the axis of its crankshaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowParts {
    /// Index of the throw.
    pub throw: usize,
    /// Part of the crankshaft [kg m^2].
    pub crank: f64,
    /// Rods and pistons, mean over the cycle [kg m^2].
    pub train: f64,
    /// Amplitude of the inertia of rods and pistons over the cycle, half of largest less least [kg m^2].
    pub fluctuation: f64,
}

/// The chain of an engine.
///
/// # Errors
/// [`TorsionError::Needs`] with all that the engine does not say, each with the key that would give it.
pub fn crank_chain(input: &CrankChainInput<'_>) -> Result<CrankChain, TorsionError> {
    let engine = input.engine;
    let none = TorsionDesign::default();
    let design = engine.torsion.as_ref().unwrap_or(&none);
    let mut builder = Builder {
        input,
        design,
        stations: Vec::new(),
        shafts: Vec::new(),
        ker_wilson: Vec::new(),
        throws: vec![usize::MAX; engine.throws.len()],
        parts: Vec::new(),
        needs: Vec::new(),
        notes: Vec::new(),
        loss: 0.0,
    };
    builder.loss = builder.loss_factor();
    builder.build()
}

struct Builder<'a> {
    input: &'a CrankChainInput<'a>,
    design: &'a TorsionDesign,
    stations: Vec<Station>,
    shafts: Vec<Shaft>,
    ker_wilson: Vec<Option<f64>>,
    throws: Vec<usize>,
    parts: Vec<ThrowParts>,
    needs: Vec<ChainFault>,
    notes: Vec<String>,
    loss: f64,
}

/// A piece of crankshaft between two planes.
#[derive(Debug, Clone, Copy, Default)]
struct Piece {
    stiffness: Option<f64>,
    ker_wilson: Option<f64>,
    section: Option<ShaftSection>,
}

impl Builder<'_> {
    fn loss_factor(&mut self) -> f64 {
        let design = self.design;
        let material = self.input.engine.crank_material.as_ref().and_then(|material| material.loss_factor);
        let has_damping = design.absolute_damping.is_some() || design.relative_damping.is_some();
        match design.loss_factor.or(material) {
            Some(loss) => loss,
            None if has_damping => 0.0,
            None => {
                self.note(format!("damping of the crankshaft is not given: a loss factor of {ASSUMED_LOSS} is assumed; give damping in [torsion]"));
                ASSUMED_LOSS
            }
        }
    }

    /// What holds of several crankshafts is noted once.
    fn note(&mut self, words: impl Into<String>) {
        let words = words.into();
        if !self.notes.contains(&words) {
            self.notes.push(words);
        }
    }

    fn need(&mut self, place: &str, what: &str, remedy: &str) {
        self.needs.push(ChainFault {
            place: place.to_owned(),
            what: what.to_owned(),
            remedy: remedy.to_owned(),
        });
    }

    fn build(mut self) -> Result<CrankChain, TorsionError> {
        let engine = self.input.engine;
        if engine.throws.is_empty() {
            self.need("throws", "needed is one or more, got none", "give the throws of the crankshaft");
        }
        let geared = self.geared();
        let hub = self.design.damper.map_or(0.0, |damper| damper.hub_inertia)
            + self.design.nose_inertia.unwrap_or(0.0);
        let has_nose = self.design.damper.is_some() || hub > 0.0;
        let at_nose = self.design.gears == GearEnd::Nose;
        if let Some(damper) = &self.design.damper {
            self.stations.push(Station::new("damper ring", StationKind::Ring, damper.ring_inertia));
            self.shafts.push(Shaft {
                kind: ShaftKind::Damper,
                damping: damper.damping,
                loss_factor: damper.loss_factor,
                ..Shaft::new("damper", 0, 1, damper.stiffness)
            });
            self.ker_wilson.push(None);
        }
        if has_nose {
            let inertia = hub + if at_nose { geared } else { 0.0 };
            let name = if self.design.damper.is_some() { "hub" } else { "nose" };
            self.stations.push(Station::new(name, StationKind::Nose, inertia));
        }
        let cranks: Vec<usize> =
            (0..engine.crankshafts.len()).filter(|index| !self.along(*index).is_empty()).collect();
        let (inner, rear) = self.pieces(&cranks, has_nose);
        let mut piece = inner.into_iter();
        let mut ends = Vec::new();
        for &crankshaft in &cranks {
            let order = self.along(crankshaft);
            let ratio = engine.crankshafts[crankshaft].ratio.value();
            let mut before = (crankshaft == 0 && has_nose).then(|| self.stations.len() - 1);
            for throw in order {
                let parts = self.throw_parts(throw, crankshaft);
                let mut inertia = parts.crank + parts.train;
                if crankshaft == 0 && before.is_none() && at_nose && geared > 0.0 {
                    inertia += geared;
                    self.note("balance shafts and gears count at the first throw: the crankshaft has no nose with an inertia");
                }
                let station = self.stations.len();
                self.stations.push(Station {
                    damping: self.design.absolute_damping.unwrap_or(0.0),
                    ratio,
                    ..Station::new(format!("throw {}", throw + 1), StationKind::Throw(throw), inertia)
                });
                self.throws[throw] = station;
                self.parts.push(parts);
                if let Some(before) = before {
                    self.crank_shaft(before, station, ratio, piece.next());
                }
                before = Some(station);
            }
            ends.extend(before.map(|last| (last, ratio, crankshaft)));
        }
        let flywheel = self.flywheel(if at_nose { 0.0 } else { geared });
        for ((last, ratio, crankshaft), piece) in ends.into_iter().zip(rear) {
            if crankshaft > 0 {
                self.note(format!(
                    "crankshaft {} is joined to the flywheel by rigid gears at its own flywheel end",
                    crankshaft + 1
                ));
            }
            self.crank_shaft(last, flywheel, ratio, Some(piece));
        }
        self.driveline(flywheel);
        self.branches(flywheel, has_nose);
        if !self.needs.is_empty() {
            return Err(TorsionError::Needs(self.needs));
        }
        let mut chain = Chain::new(self.stations, self.shafts)?;
        for own in &self.design.pendulums {
            let station = self.throws[own.throw];
            let pendulum = Pendulum {
                station,
                mass: own.mass,
                pivot_radius: own.pivot_radius,
                length: own.length,
                number: own.number,
                damping: own.damping,
            };
            chain = pendulum.on(&chain)?;
            self.ker_wilson.push(None);
        }
        Ok(CrankChain {
            chain,
            throws: self.throws,
            parts: self.parts,
            ker_wilson: self.ker_wilson,
            notes: self.notes,
        })
    }

    /// Throws of a crankshaft along z.
    fn along(&self, crankshaft: usize) -> Vec<usize> {
        let throws = &self.input.engine.throws;
        let mut own: Vec<usize> =
            (0..throws.len()).filter(|throw| throws[*throw].crankshaft == crankshaft).collect();
        own.sort_by(|a, b| throws[*a].z.total_cmp(&throws[*b].z));
        own
    }

    fn crank_shaft(&mut self, from: usize, to: usize, ratio: f64, piece: Option<Piece>) {
        let piece = piece.unwrap_or_default();
        let name = format!("{} to {}", self.stations[from].name, self.stations[to].name);
        // What lacks a stiffness has been told of already.
        let stiffness = piece.stiffness.unwrap_or(1.0);
        self.shafts.push(Shaft {
            damping: self.design.relative_damping.unwrap_or(0.0),
            loss_factor: self.loss,
            ratio,
            section: piece.section,
            ..Shaft::new(name, from, to, stiffness)
        });
        self.ker_wilson.push(piece.ker_wilson);
    }

    /// Inertia of balance shafts and gears at crankshaft 1.
    fn geared(&mut self) -> f64 {
        let mut sum = 0.0;
        for body in self.input.bodies.iter().filter(|body| body.is_geared()) {
            match body.referred() {
                Some(inertia) => sum += inertia.value,
                None => self.note(format!(
                    "the inertia of {} is not known and not counted; give {}",
                    body.name, body.key
                )),
            }
        }
        sum
    }

    fn throw_parts(&mut self, throw: usize, crankshaft: usize) -> ThrowParts {
        let along = self.along(crankshaft);
        let many = along.len().max(1) as f64;
        let body = self.input.bodies.iter().find(|body| body.kind == RotatingKind::Crankshaft(crankshaft));
        let total = body.and_then(|body| body.inertia).map(|inertia| inertia.value);
        let shares: Option<Vec<f64>> =
            along.iter().map(|own| self.input.throws.get(*own).copied().flatten()).collect();
        let own = along.iter().position(|other| *other == throw).unwrap_or(0);
        let crank = match (total, &shares) {
            (Some(total), Some(shares)) => {
                let sum: f64 = shares.iter().sum();
                if total >= sum { shares[own] + (total - sum) / many } else { shares[own] * total / sum }
            }
            (Some(total), None) => total / many,
            (None, _) => 0.0,
        };
        if own == 0 {
            match (total, &shares) {
                (None, _) => {
                    let what = "the inertia of the crankshaft is needed, it is not given";
                    self.need(
                        "crankshaft",
                        what,
                        "give the sizes in [crank.body], or crankshaft_inertia in [flywheel]",
                    );
                }
                (Some(_), None) => self.note(
                    "the inertia of the crankshaft is shared equally by its throws: its shape is not known",
                ),
                (Some(_), Some(_)) => {
                    self.note("journals, nose and flange of the crankshaft count equally at all throws")
                }
            }
        }
        let samples = train_inertia(self.input.engine, throw);
        let (train, _) = inertia_orders(&samples, 1);
        let (least, most) =
            samples.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
        ThrowParts { throw, crank, train, fluctuation: 0.5 * (most - least) }
    }

    fn flywheel(&mut self, geared: f64) -> usize {
        let body = self.input.bodies.iter().find(|body| body.kind == RotatingKind::Flywheel);
        let inertia =
            body.and_then(|body| body.inertia).map(|inertia| inertia.value).filter(|inertia| *inertia > 0.0);
        if inertia.is_none() {
            let what = "its inertia is needed, it is not given";
            self.need(
                "flywheel",
                what,
                "give inertia in [flywheel]; of an engine without one that of the flange and coupling",
            );
        }
        self.stations.push(Station::new("flywheel", StationKind::Flywheel, inertia.unwrap_or(1.0) + geared));
        self.stations.len() - 1
    }

    fn driveline(&mut self, flywheel: usize) {
        let (mut before, mut ratio) = (flywheel, 1.0);
        for (index, link) in self.input.driveline.iter().enumerate() {
            ratio *= link.ratio;
            let station = self.stations.len();
            let name = format!("driveline {}", index + 1);
            if link.stiffness <= 0.0 {
                let what = "its stiffness is 0, which joins it to nothing in torsion";
                self.need(&name, what, "give its stiffness, or leave it out");
            }
            self.stations
                .push(Station { ratio, ..Station::new(name.clone(), StationKind::Driven, link.inertia) });
            // Stiffness and damping count at the speed of the inertia behind the spring.
            self.shafts.push(Shaft {
                kind: ShaftKind::Coupling,
                damping: link.damping,
                ratio,
                ..Shaft::new(format!("coupling {}", index + 1), before, station, link.stiffness)
            });
            self.ker_wilson.push(None);
            before = station;
        }
    }

    fn branches(&mut self, flywheel: usize, has_nose: bool) {
        let first = self.stations.len();
        for branch in &self.design.branches {
            let at = match branch.at {
                BranchPlace::Flywheel => flywheel,
                BranchPlace::Throw(throw) => self.throws[throw],
                BranchPlace::Branch(index) => first + index,
                BranchPlace::Nose => {
                    if !has_nose {
                        self.note(format!(
                            "{} hangs on the first throw: the crankshaft has no nose with an inertia",
                            branch.name
                        ));
                    }
                    let nose = self.stations.iter().position(|station| station.kind == StationKind::Nose);
                    nose.or_else(|| {
                        self.stations.iter().position(|station| matches!(station.kind, StationKind::Throw(_)))
                    })
                    .unwrap_or(0)
                }
            };
            let ratio = self.stations[at].ratio * branch.ratio;
            let station = self.stations.len();
            self.stations.push(Station {
                ratio,
                ..Station::new(branch.name.clone(), StationKind::Other, branch.inertia)
            });
            self.shafts.push(Shaft {
                kind: ShaftKind::Coupling,
                damping: branch.damping,
                ratio,
                ..Shaft::new(format!("shaft of {}", branch.name), at, station, branch.stiffness)
            });
            self.ker_wilson.push(None);
        }
    }

    /// Pieces of these crankshafts: those before the last throw, crankshaft by crankshaft, and those to the flywheel, one for each.
    fn pieces(&mut self, cranks: &[usize], has_nose: bool) -> (Vec<Piece>, Vec<Piece>) {
        let engine = self.input.engine;
        let (mut inner, mut last): (Vec<Piece>, Vec<Piece>) = (Vec::new(), Vec::new());
        let modulus = self.shear_modulus();
        for &crankshaft in cranks {
            let along = self.along(crankshaft);
            let Ok(elements) = engine.crank_elements(crankshaft) else {
                let nose = usize::from(crankshaft == 0 && has_nose);
                inner.extend(std::iter::repeat_n(Piece::default(), (along.len() + nose).saturating_sub(1)));
                last.push(Piece::default());
                continue;
            };
            let mut own = self.pieces_of_sizes(&elements, &along, modulus);
            if !(crankshaft == 0 && has_nose) {
                own.remove(0);
            }
            last.extend(own.pop());
            inner.extend(own);
        }
        let given = &self.design.stiffness;
        let mut place = 0;
        let mut taken = 0;
        for (rear, &crankshaft) in last.iter_mut().zip(cranks) {
            let nose = usize::from(crankshaft == 0 && has_nose);
            let many = (self.along(crankshaft).len() + nose).saturating_sub(1);
            for piece in &mut inner[place..place + many] {
                piece.stiffness = given.get(taken).copied().or(piece.stiffness);
                taken += 1;
            }
            place += many;
            rear.stiffness = given.get(taken).copied().or(rear.stiffness);
            taken += 1;
        }
        if !given.is_empty() && taken != given.len() {
            let what = format!(
                "{taken} stiffnesses are needed, one for each piece of the crankshaft, got {}",
                given.len()
            );
            self.need("crankshaft", &what, "give as many in [torsion] stiffness");
        }
        if inner.iter().chain(&last).any(|piece| piece.stiffness.is_none()) {
            let what = "its torsional stiffness is needed, it is not given";
            self.need(
                "crankshaft",
                what,
                "give stiffness in [torsion], or the sizes in [crank.body] with the distance of the webs",
            );
        }
        (inner, last)
    }

    fn shear_modulus(&mut self) -> f64 {
        let material = self.input.engine.crank_material.unwrap_or_default();
        let (young, poisson) = (material.youngs_modulus(), material.poisson_ratio());
        if self.design.stiffness.is_empty() && (young.is_none() || poisson.is_none()) {
            self.note("the material of the crankshaft is not given: stiffnesses are those of steel, 210 GPa and 0.3");
        }
        let young = young.map_or(STEEL[0], |value| value.value);
        young / (2.0 * (1.0 + poisson.map_or(STEEL[1], |value| value.value)))
    }

    /// Pieces of one crankshaft: from its front end to the first throw, between throws, from the last throw to its rear end.
    fn pieces_of_sizes(&mut self, elements: &[CrankElement], along: &[usize], modulus: f64) -> Vec<Piece> {
        let parts = ker_wilson::flexibilities(elements);
        if let Some(clipped) = parts.iter().find(|part| part.is_clipped) {
            self.note(format!(
                "{} joins two bars that overlap so far that Ker Wilson's formula has no length for it: it counts as rigid",
                elements[clipped.element].name()
            ));
        }
        let values: Vec<f64> = parts.iter().map(|part| part.value).collect();
        let factors = self.throw_factors(elements, along, &values, modulus);
        let pin_of = |throw: usize| {
            elements.iter().position(
                |element| matches!(element.form, CrankElementForm::Pin { throw: own, .. } if own == throw),
            )
        };
        let mut pins = Vec::new();
        for throw in along {
            if let Some(pin) = pin_of(*throw) {
                pins.push(pin);
            }
        }
        // By how much the other method is softer, of the front and the rear half of an element.
        let throw_at = |index: usize, is_rear: bool| -> Option<usize> {
            let element = &elements[index];
            match element.form {
                CrankElementForm::Journal { .. } => {
                    let mut others: Box<dyn Iterator<Item = &CrankElement>> = if is_rear {
                        Box::new(elements[index + 1..].iter())
                    } else {
                        Box::new(elements[..index].iter().rev())
                    };
                    others.find_map(CrankElement::throw)
                }
                _ => element.throw(),
            }
        };
        let factor = |index: usize, is_rear: bool| {
            let throw = throw_at(index, is_rear);
            throw.and_then(|throw| factors.iter().find(|own| own.0 == throw)).map_or(1.0, |own| own.1)
        };
        let between = |from: Option<usize>, to: Option<usize>| {
            let first = from.unwrap_or(0);
            let last = to.unwrap_or(elements.len() - 1);
            let (mut plain, mut scaled) = (0.0, 0.0);
            for index in first..=last {
                for is_rear in [false, true] {
                    // Of the pins at both planes the halves that lie between.
                    if (Some(index) == from && !is_rear) || (Some(index) == to && is_rear) {
                        continue;
                    }
                    let half = 0.5 * values[index];
                    plain += half;
                    scaled += half * factor(index, is_rear);
                }
            }
            let inside = elements[first..=last].iter().filter(|element| {
                matches!(element.form, CrankElementForm::Journal { .. } | CrankElementForm::Pin { .. })
            });
            Piece {
                stiffness: Some(ker_wilson::stiffness(scaled, modulus)),
                ker_wilson: Some(ker_wilson::stiffness(plain, modulus)),
                section: ker_wilson::weakest(inside),
            }
        };
        let mut pieces = vec![between(None, pins.first().copied())];
        pieces.extend(pins.windows(2).map(|pair| between(Some(pair[0]), Some(pair[1]))));
        pieces.push(between(pins.last().copied(), None));
        pieces
    }

    /// Flexibility of throws by the other method over that of Ker Wilson.
    fn throw_factors(
        &self,
        elements: &[CrankElement],
        along: &[usize],
        values: &[f64],
        modulus: f64,
    ) -> Vec<(usize, f64)> {
        let is_own = |throw: usize, index: usize| {
            elements.get(index).is_some_and(|element| element.throw() == Some(throw))
        };
        let of = |throw: usize| -> f64 {
            let mut sum = 0.0;
            for (index, element) in elements.iter().enumerate() {
                if is_own(throw, index) {
                    sum += values[index];
                } else if matches!(element.form, CrankElementForm::Journal { .. }) {
                    let beside = usize::from(is_own(throw, index + 1))
                        + usize::from(index > 0 && is_own(throw, index - 1));
                    sum += 0.5 * beside as f64 * values[index];
                }
            }
            sum
        };
        let given = self
            .input
            .stiffness
            .iter()
            .filter(|(throw, stiffness)| along.contains(throw) && *stiffness > 0.0);
        given
            .map(|(throw, stiffness)| (*throw, ker_wilson::stiffness(of(*throw), modulus) / stiffness))
            .collect()
    }
}

/// Stiffness of a throw between the middles of its journals by Ker Wilson's lengths [N m/rad]; `None` where the engine has no sizes.
pub fn throw_stiffness(engine: &Engine, throw: usize, shear_modulus: f64) -> Option<f64> {
    let crankshaft = engine.throws.get(throw)?.crankshaft;
    let elements = engine.crank_elements(crankshaft).ok()?;
    let values = ker_wilson::flexibilities(&elements);
    let is_own = |index: usize| elements.get(index).is_some_and(|element| element.throw() == Some(throw));
    let mut sum = 0.0;
    for (index, element) in elements.iter().enumerate() {
        if is_own(index) {
            sum += values[index].value;
        } else if matches!(element.form, CrankElementForm::Journal { .. }) {
            let beside = usize::from(is_own(index + 1)) + usize::from(index > 0 && is_own(index - 1));
            sum += 0.5 * beside as f64 * values[index].value;
        }
    }
    Some(ker_wilson::stiffness(sum, shear_modulus))
}
