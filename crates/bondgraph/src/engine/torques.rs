//! What turns and brakes the crank: drive, starter, driveline, load, friction, torques over the angle.
//!
//! ```text
//! twist of a link     d' = rho w_before - w_own        torque k d + c d'       w: speeds relative to the block
//! starter             i T (1 - i w/w_free), none below 0, until w reaches its speed
//! ```
//! An inertia of the driveline turns with the block: it holds the momentum J (w + Omega_z).

use super::Builder;
use super::request::{EngineBlock, EngineDrive, LoadLaw, load_at};
use super::words::{combination, number, quantity};
use crate::curve::Curve;
use crate::unit::Unit;
use lanchester_model::LoadCurve;

/// N m.
const TORQUE: Unit = Unit::of([2, 1, -2, 0, 0]);
/// rad/s.
const SPEED: Unit = Unit::of([0, 0, -1, 0, 0]);

impl Builder<'_> {
    /// Whether something acts on crankshaft 1 from the ground.
    pub(crate) fn acts_from_ground(&self) -> bool {
        let request = self.request;
        let on_crank = request.driveline.is_empty();
        (on_crank && request.load.torque != LoadLaw::None && !request.load.reacts_on_block)
            || !request.torque.is_empty()
            || (request.drive == EngineDrive::Imposed
                && (request.against_ground || self.is_driven_from_ground()))
            || request.starter.is_some_and(|starter| !starter.reacts_on_block)
    }

    /// Whether the torque of an imposed speed comes from the ground: where the block moves. A block that is held still carries it, so that its roll moment
    /// is that of the crank train.
    fn is_driven_from_ground(&self) -> bool {
        self.moves() && self.request.block != EngineBlock::Held
    }

    /// Effort of the friction by the speed `f` of the crank: dry, in proportion to it, and to its square.
    fn friction(&self) -> Option<String> {
        let [linear, square] = self.request.friction_growth;
        let terms = [
            (self.request.friction_torque, "N m", "sign(f)"),
            (linear, "N m s", "f"),
            (square, "N m s2", "f*abs(f)"),
        ];
        let terms: Vec<String> = (terms.into_iter())
            .filter(|(size, ..)| *size != 0.0)
            .map(|(size, unit, of_speed)| format!("{}*{of_speed}", quantity(size, unit)))
            .collect();
        (!terms.is_empty()).then(|| terms.join(" + "))
    }

    /// Load, friction, starter and drive.
    pub(crate) fn torques(&mut self) {
        let absolute = if self.moves() { "spin" } else { "crank" };
        let end = self.driveline();
        self.load(&end);
        if let Some(law) = self.friction() {
            self.element("friction", "R", &[("effort", &law)]);
            self.bond("crank", "friction");
        }
        if let Some(starter) = self.request.starter {
            self.integral("starter_on", "0 rad/s", "1");
            self.graph = std::mem::take(&mut self.graph)
                .event(&format!("crank.flow - {}", quantity(starter.until, "rad/s")), &[("starter_on", "0")]);
            let law = format!(
                "starter_on*{}*max(1 - crank.flow/({}), 0)",
                quantity(starter.ratio * starter.stall_torque, "N m"),
                quantity(starter.free_speed / starter.ratio, "rad/s")
            );
            self.element("starter", "MSe", &[("effort", &law)]);
            self.bond("starter", if starter.reacts_on_block { "crank" } else { absolute });
        }
        if !self.request.torque.is_empty() {
            let terms: Vec<String> = self
                .request
                .torque
                .iter()
                .flat_map(|[order, sin, cos]| [(order, sin, "sin"), (order, cos, "cos")])
                .filter(|(_, amount, _)| **amount != 0.0)
                .map(|(order, amount, wave)| {
                    format!("{}*{wave}({}*theta)", quantity(*amount, "N m"), number(*order))
                })
                .collect();
            if !terms.is_empty() {
                self.element("given_torque", "MSe", &[("effort", &terms.join(" + "))]);
                self.bond("given_torque", absolute);
            }
        }
        if self.request.drive == EngineDrive::Imposed {
            let points = self.request.profile.clone();
            let flow = match Curve::straight(&points, false, [Unit::SECOND, SPEED]) {
                Some(curve) => {
                    self.graph.tables.push(("given_speed".into(), curve));
                    "table(given_speed, t)".to_owned()
                }
                None => quantity(self.request.speed, "rad/s"),
            };
            if self.is_driven_from_ground() && !self.request.against_ground {
                // A speed relative to the block, by a torque from the ground.
                self.element("drive", "MSf", &[("flow", &format!("{flow} + wz.flow"))]);
                self.bond("drive", absolute);
            } else {
                self.element("drive", "Sf", &[("flow", &flow)]);
                self.bond("drive", if self.request.against_ground { absolute } else { "crank" });
            }
        }
    }

    /// Inertias behind the flywheel; gives the junctions of the last one, relative to the block and absolute, and its angle.
    fn driveline(&mut self) -> [String; 3] {
        let start = self.request.start.spin[2];
        let (mut before, mut speed, mut angle) =
            ("crank".to_owned(), self.request.speed, self.request.start_angle);
        let mut ends = ["crank", if self.moves() { "spin" } else { "crank" }, "theta"].map(str::to_owned);
        let links = self.request.driveline.clone();
        for (index, link) in links.iter().enumerate() {
            let k = index + 1;
            (speed, angle) = (link.ratio * speed, link.ratio * angle);
            let behind: f64 = links[k..].iter().map(|link| link.ratio).product();
            let torque = behind * load_at(&self.request.load.torque, speed * behind, angle * behind);
            let twist = if link.stiffness > 0.0 { torque / link.stiffness } else { 0.0 };
            angle -= twist;
            let own = format!("link{k}");
            let store = format!("driveline{k}");
            self.element(&own, "1", &[("domain", "rotation")]);
            let absolute = if self.moves() {
                let (together, spin) = (format!("link{k}_together"), format!("link{k}_spin"));
                self.element(&together, "0", &[("domain", "rotation")]);
                self.element(&spin, "1", &[("domain", "rotation")]);
                self.bond("wz", &together);
                self.bond(&own, &together);
                self.bond(&together, &spin);
                spin
            } else {
                own.clone()
            };
            let flow = speed + if self.moves() { start } else { 0.0 };
            let keys = [("inertia", quantity(link.inertia, "kg m2")), ("flow", quantity(flow, "rad/s"))];
            self.element(&store, "I", &[(keys[0].0, &keys[0].1), (keys[1].0, &keys[1].1)]);
            self.bond(&absolute, &store);
            let (gear, coupling, twisting) =
                (format!("link{k}_gear"), format!("link{k}_coupling"), format!("link{k}_twist"));
            self.element(&gear, "TF", &[("ratio", &number(link.ratio))]);
            self.element(&coupling, "0", &[("domain", "rotation")]);
            self.element(&twisting, "1", &[("domain", "rotation")]);
            self.bond(&before, &format!("{gear}.1"));
            self.bond(&format!("{gear}.2"), &coupling);
            self.bond(&coupling, &own);
            if k == 1 && self.changing.has("clutch_closed") {
                self.element("clutch", "MTF", &[("ratio", "clutch_closed")]);
                self.bond(&coupling, "clutch.1");
                self.bond("clutch.2", &twisting);
            } else {
                self.bond(&coupling, &twisting);
            }
            if link.stiffness != 0.0 {
                let spring = format!("link{k}_spring");
                let keys = [
                    ("stiffness", quantity(link.stiffness, "N m/rad")),
                    ("displacement", quantity(twist, "rad")),
                ];
                self.element(&spring, "C", &[(keys[0].0, &keys[0].1), (keys[1].0, &keys[1].1)]);
                self.bond(&twisting, &spring);
            }
            if link.damping != 0.0 || link.stiffness == 0.0 {
                let damper = format!("link{k}_damper");
                self.element(&damper, "R", &[("effort", &format!("{}*f", quantity(link.damping, "N m s")))]);
                self.bond(&twisting, &damper);
            }
            let before_it = std::mem::replace(&mut ends, [own.clone(), absolute, format!("link{k}_angle")]);
            if self.request.load.torque.is_over_angle() {
                let opens = k == 1 && self.changing.has("clutch_closed");
                if link.stiffness > 0.0 && !opens {
                    let turned = combination(&[(link.ratio, &before_it[2])]);
                    self.signal(&ends[2].clone(), &format!("{turned} - link{k}_spring.displacement"));
                } else {
                    self.integral(&ends[2].clone(), &format!("{own}.flow"), &quantity(angle, "rad"));
                }
            }
            before = own;
        }
        ends
    }

    /// The load at the end of the driveline.
    fn load(&mut self, [own, absolute, angle]: &[String; 3]) {
        let load = self.request.load.clone();
        let place = if load.reacts_on_block { own } else { absolute };
        let changes = self.changing.has("load_share");
        let law = match &load.torque {
            LoadLaw::None if changes => "load_torque*sign(f)".to_owned(),
            LoadLaw::None => return,
            LoadLaw::Constant(torque) => format!("{}*sign(f)", quantity(*torque, "N m")),
            LoadLaw::Viscous { torque, at } => format!("{}*f", quantity(torque / at, "N m s")),
            LoadLaw::Quadratic { torque, at } => {
                format!("{}*f*abs(f)", quantity(torque / (at * at), "N m s2"))
            }
            LoadLaw::Power { power, least_speed } => {
                let least = quantity(*least_speed, "rad/s");
                format!("{}/max(abs(f), {least})*sign(f)", quantity(*power, "W"))
            }
            LoadLaw::Table(points) => match points.as_slice() {
                [] if changes => "0 N m*sign(f)".to_owned(),
                [] => return,
                [[_, torque]] => format!("{}*sign(f)", quantity(*torque, "N m")),
                points => {
                    let Some(curve) = Curve::straight(points, false, [SPEED, TORQUE]) else { return };
                    self.graph.tables.push(("load_over_speed".into(), curve));
                    "table(load_over_speed, abs(f))*sign(f)".to_owned()
                }
            },
            LoadLaw::Map { period, curves } => {
                let Some(law) = self.load_map(*period, curves, angle) else { return };
                let share = if changes { "load_share*" } else { "" };
                let given = if changes { " + load_torque*sign(f)" } else { "" };
                self.element("load", "R", &[("effort", &format!("{share}({law}){given}"))]);
                self.bond(place, "load");
                return;
            }
            LoadLaw::Angle { period, points } => {
                let Some(curve) = over_angle(points, *period) else { return };
                self.graph.tables.push(("load_over_angle".into(), curve));
                let share = if changes { "-load_share*" } else { "-" };
                self.element(
                    "load",
                    "MSe",
                    &[("effort", &format!("{share}table(load_over_angle, {angle})"))],
                );
                self.bond("load", place);
                if changes {
                    self.element("load_given", "R", &[("effort", "load_torque*sign(f)")]);
                    self.bond(place, "load_given");
                }
                return;
            }
        };
        let law = match (&load.torque, changes) {
            (LoadLaw::None, _) | (_, false) => law,
            _ => format!("load_share*{law} + load_torque*sign(f)"),
        };
        self.element("load", "R", &[("effort", &law)]);
        self.bond(place, "load");
    }

    /// Torque over angle and speed: each curve weighted by how near its speed is.
    fn load_map(&mut self, period: f64, curves: &[LoadCurve], angle: &str) -> Option<String> {
        let mut terms = Vec::new();
        for (k, own) in curves.iter().enumerate() {
            let name = format!("load_over_angle{}", k + 1);
            self.graph.tables.push((name.as_str().into(), over_angle(&own.points, period)?));
            let neighbours = [k.checked_sub(1).and_then(|before| curves.get(before)), curves.get(k + 1)];
            let [before, after] = neighbours.map(|curve| curve.map(|curve| [curve.speed, 0.0]));
            let weight: Vec<[f64; 2]> = before.into_iter().chain([[own.speed, 1.0]]).chain(after).collect();
            let value = format!("table({name}, {angle})");
            if let [_] = weight.as_slice() {
                terms.push(value);
                continue;
            }
            let share = format!("load_at_speed{}", k + 1);
            self.graph
                .tables
                .push((share.as_str().into(), Curve::straight(&weight, false, [SPEED, Unit::NONE])?));
            terms.push(format!("table({share}, abs(f))*{value}"));
        }
        Some(terms.join(" + "))
    }
}

/// A torque that repeats after `period` [rad], straight between its points.
fn over_angle(points: &[[f64; 2]], period: f64) -> Option<Curve> {
    let first = points.first()?;
    let mut points = points.to_vec();
    points.push([first[0] + period, first[1]]);
    Curve::straight(&points, true, [Unit::NONE, TORQUE])
}
