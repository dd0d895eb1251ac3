//! Damping of torsional vibration.

use super::running::crank_inertia;
use super::sizes::Sizes;
use super::words::{Block, quantity};
use super::{Found, From};
use std::f64::consts::PI;

/// Throws in a row from which on engines have a damper: the first twist of a shorter crankshaft lies above what excites it.
const LONG: usize = 4;
/// Inertia of the ring over that of the crankshaft.
const RING: f64 = 0.25;
/// Shear modulus of steel [Pa].
const SHEAR: f64 = 80e9;

impl From<'_> {
    pub(super) fn torsion(&self, sizes: &Sizes<'_>) -> Found {
        let engine = sizes.engine;
        if self.has("torsion") {
            return Found::There;
        }
        if engine.crank_body.is_none() {
            return Found::Not("without [crank.body] the stiffnesses of the crankshaft are not known".into());
        }
        // Damping of a throw against the ground goes with what shears oil: pin and piston of one cylinder.
        let damping = 2.4e3 * sizes.swept / engine.throws.len() as f64;
        let block = Block::new("[torsion]", "damping of a usual crankshaft without a damper.")
            .line(
                "damping",
                format!("{{ absolute = {}, loss_factor = 0.01 }}", quantity(damping, "N m s/rad", 1.0, 2)),
                "2.4 N m s/rad for each litre of a throw",
            )
            .line(
                "nose_inertia",
                quantity(0.08 * crank_inertia(sizes), "kg m2", 1.0, 2),
                "pulley and wheel of the timing drive: 0.08 of the crankshaft",
            );
        Found::Blocks(vec![block])
    }

    pub(super) fn damper(&self, sizes: &Sizes<'_>) -> Found {
        if self.has("damper") || self.has("pendulum") {
            return Found::There;
        }
        let engine = sizes.engine;
        if engine.crankshafts.len() > 1 {
            return Found::Not("there is no usual damper for geared crankshafts".into());
        }
        if engine.throws.len() < LONG {
            return Found::Not(format!("crankshafts with fewer than {LONG} throws seldom have one"));
        }
        let Some(frequency) = first_twist(sizes) else {
            return Found::Not("without [crank.body] the stiffness of the crankshaft is not known".into());
        };
        let ring = RING * crank_inertia(sizes);
        // Over the inertia of the first twist, half that of all throws: it turns as the sine of a quarter wave.
        let mu = ring / (0.5 * engine.throws.len() as f64 * throw_inertia(sizes));
        let damping = 2.0 * ring * frequency / (2.0 * (1.0 + mu) * (2.0 + mu)).sqrt();
        let block = Block::new(
            "[damper]",
            "what long crankshafts have at their free end, damped for the least peak of its first twist (Den Hartog).",
        )
        .line("type", "\"viscous\"", "a ring in oil")
        .line("ring_inertia", quantity(ring, "kg m2", 1.0, 2), "a quarter of the crankshaft")
        .line("hub_inertia", quantity(0.5 * ring, "kg m2", 1.0, 2), "half the ring")
        .line(
            "damping",
            quantity(damping, "N m s/rad", 1.0, 2),
            "the best for the first twist by these inertias and Ker Wilson's stiffness",
        );
        Found::Blocks(vec![block])
    }
}

/// Inertia of a throw with its share of rods and pistons [kg m2], about.
fn throw_inertia(sizes: &Sizes<'_>) -> f64 {
    let engine = sizes.engine;
    let moving = engine.cylinders.iter().filter_map(|own| {
        let radius = engine.throws.get(own.throw)?.radius;
        Some((own.rod.big_end_mass + 0.5 * own.reciprocating_mass()) * radius * radius)
    });
    (crank_inertia(sizes) + moving.sum::<f64>()) / engine.throws.len() as f64
}

/// First natural frequency of a row of equal throws whose flywheel stands still, without a damper [rad/s]: stiffness of a throw by Ker Wilson's lengths, as the
/// book has it (eq. 50.14).
fn first_twist(sizes: &Sizes<'_>) -> Option<f64> {
    let engine = sizes.engine;
    let body = engine.crank_body.as_ref()?;
    let count = engine.throws.len() as f64;
    let first = engine.throws.iter().map(|throw| throw.z).fold(f64::INFINITY, f64::min);
    let last = engine.throws.iter().map(|throw| throw.z).fold(f64::NEG_INFINITY, f64::max);
    let bay = (last - first) / (count - 1.0);
    let (journal, pin) = (body.journal_diameter, body.pin_diameter);
    let pin_length = (sizes.web_distance - body.web_thickness).max(0.0);
    let journal_length = (bay - pin_length - 2.0 * body.web_thickness).max(0.0);
    let bar = |length: f64, outer: f64, inner: f64| (length + 0.4 * outer) / (outer.powi(4) - inner.powi(4));
    let width = body.web_radius + body.pin_end_radius;
    let web = (sizes.radius - 0.2 * (journal + pin)).max(0.0) / (body.web_thickness * width.powi(3));
    let lengths = bar(journal_length, journal, body.journal_bore) + bar(pin_length, pin, body.pin_bore) + web;
    let stiffness = PI * SHEAR / 32.0 / lengths;
    let frequency = 2.0 * (stiffness / throw_inertia(sizes)).sqrt() * (0.5 * PI / (2.0 * count + 1.0)).sin();
    (frequency.is_finite() && frequency > 0.0).then_some(frequency)
}
