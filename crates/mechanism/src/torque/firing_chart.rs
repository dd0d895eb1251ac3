//! When the cylinders fire, how evenly, and which stroke each of them is in.

use crate::inertia::result::CylinderMotion;
use crate::torque::gas_train::{GasTrain, firing_angle};
use crate::torque::request::TorqueError;
use crate::train::mechanism::firing_period;
use crate::{LoadRequest, motion};
use lanchester_model::{Engine, Strokes};
use lanchester_numerics::within_period;
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::TAU;

/// Dead centres closer than this [rad] are one.
const SAME: f64 = 1e-6;

/// Firing of an engine over one period.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FiringChart {
    /// Strokes in a working cycle.
    pub strokes: Strokes,
    /// Period [rad] of crankshaft 1: a whole number of working cycles of every crankshaft.
    pub period: f64,
    /// Firings in their sequence, from the first at or after `theta = 0`; cylinders that fire together stand by number. A chamber that pistons
    /// share fires once, under the number of its first cylinder.
    pub firings: Vec<Firing>,
    /// Interval of even firing [rad]: period over number of firings.
    pub even_interval: f64,
    /// Largest departure of an interval from the even one, over the even one: 0 is even, 1 is two cylinders firing
    /// together or an interval of twice the even length.
    pub unevenness: f64,
    /// Size of the sum of unit vectors `e^{i n theta_f}` over all firings, over their number, for the orders `n` = 1/2, 1, 3/2 ..
    /// (two-stroke: 1, 2, ..): 1 where all cylinders add up (major orders), 0 where they cancel.
    pub stars: Vec<FiringStar>,
    /// Strokes of every cylinder over the period.
    pub cylinders: Vec<CylinderStrokes>,
}

/// One firing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Firing {
    /// Cylinder number, from 1.
    pub cylinder: usize,
    /// Crank angle [rad] in the period.
    pub theta: f64,
    /// Angle [rad] to the next firing; 0 where the next cylinder fires together with this one.
    pub interval: f64,
    /// Direction in which its crankpin stands on its crankshaft [rad], from throw 1.
    pub throw_angle: f64,
}

/// How far equal cylinders add up in one order.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FiringStar {
    /// Order.
    pub order: f64,
    /// From 0 to 1.
    pub share: f64,
}

/// Strokes of one cylinder.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CylinderStrokes {
    /// Cylinder number, from 1.
    pub cylinder: usize,
    /// From dead centre to dead centre, rising, over one period; the first starts at or after `theta = 0`, the last may
    /// end beyond the period.
    pub strokes: Vec<StrokeSpan>,
}

/// What a piston does between two dead centres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StrokeSpan {
    /// Which stroke.
    pub stroke: StrokeKind,
    /// Crank angle [rad] at its start.
    pub from: f64,
    /// Crank angle [rad] at its end.
    pub to: f64,
}

/// A stroke of the working cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StrokeKind {
    /// After firing, towards the crank.
    Power,
    /// Four-stroke: away from the crank.
    Exhaust,
    /// Four-stroke: towards the crank.
    Intake,
    /// Away from the crank, up to firing.
    Compression,
}

impl StrokeKind {
    /// Its letter in charts.
    pub fn letter(self) -> char {
        match self {
            StrokeKind::Power => 'P',
            StrokeKind::Exhaust => 'E',
            StrokeKind::Intake => 'I',
            StrokeKind::Compression => 'C',
        }
    }

    /// Name for tables and legends.
    pub fn name(self) -> &'static str {
        match self {
            StrokeKind::Power => "power",
            StrokeKind::Exhaust => "exhaust",
            StrokeKind::Intake => "intake",
            StrokeKind::Compression => "compression",
        }
    }
}

impl CylinderStrokes {
    /// The stroke at `theta` [rad], in `period`.
    pub fn at(&self, theta: f64, period: f64) -> Option<StrokeKind> {
        let inside = |span: &&StrokeSpan| (theta - span.from).rem_euclid(period) < span.to - span.from;
        self.strokes.iter().find(inside).map(|span| span.stroke)
    }
}

impl FiringChart {
    /// Crank angles [rad] at which any piston changes its stroke, rising, in one period: the rows of a stroke table.
    pub fn changes(&self) -> Vec<f64> {
        let starts =
            self.cylinders.iter().flat_map(|c| &c.strokes).map(|span| span.from.rem_euclid(self.period));
        let mut changes: Vec<f64> = starts.collect();
        changes.sort_by(f64::total_cmp);
        changes.dedup_by(|next, kept| *next - *kept <= SAME);
        changes
    }

    /// Cylinders by their first firing: the firing order.
    pub fn order(&self) -> Vec<usize> {
        let mut order = Vec::new();
        for firing in &self.firings {
            if !order.contains(&firing.cylinder) {
                order.push(firing.cylinder);
            }
        }
        order
    }
}

/// Firing intervals, strokes and stars of `engine`.
///
/// # Errors
/// [`TorqueError`] where the file gives no firing, or a linkage does not turn.
pub fn firing_chart(engine: &Engine) -> Result<FiringChart, TorqueError> {
    let motion = motion(engine, &LoadRequest { samples: 1, ..LoadRequest::default() })?;
    chart(engine, &motion, TAU * f64::from(firing_period(engine)?))
}

/// The chart of an engine that fires nowhere.
pub(crate) fn no_firing(engine: &Engine, period: f64) -> FiringChart {
    FiringChart {
        strokes: engine.strokes,
        period,
        firings: Vec::new(),
        even_interval: 0.0,
        unevenness: 0.0,
        stars: Vec::new(),
        cylinders: Vec::new(),
    }
}

pub(crate) fn chart_of(engine: &Engine, gas: &GasTrain) -> Result<FiringChart, TorqueError> {
    chart(engine, &gas.motion, gas.period())
}

fn chart(engine: &Engine, motion: &[CylinderMotion], period: f64) -> Result<FiringChart, TorqueError> {
    let mut firings = Vec::new();
    let mut cylinders = Vec::new();
    let strokes = f64::from(engine.strokes.revolutions());
    for (index, motion) in motion.iter().enumerate() {
        let first = firing_angle(engine, motion)?;
        let throw = &engine.throws[engine.cylinders[index].throw];
        let turn = TAU / engine.crankshafts[throw.crankshaft].ratio.value().abs();
        let count = (period / (turn * strokes)).round() as usize;
        let mut own: Vec<f64> =
            (0..count).map(|k| within_period(first + turn * strokes * k as f64, period, SAME)).collect();
        own.sort_by(f64::total_cmp);
        // Of a chamber that pistons share the strokes are those of its volume.
        let [top, bottom] = match &motion.chamber {
            Some(chamber) => [chamber.top_dead_centre, chamber.bottom_dead_centre],
            None => [motion.top_dead_centre, motion.bottom_dead_centre],
        };
        let down = (bottom - top).rem_euclid(turn);
        let mut spans: Vec<StrokeSpan> =
            own.iter().flat_map(|theta| spans(engine.strokes, *theta, turn, down)).collect();
        for span in &mut spans {
            let shift = within_period(span.from, period, SAME) - span.from;
            (span.from, span.to) = (span.from + shift, span.to + shift);
        }
        spans.sort_by(|a, b| a.from.total_cmp(&b.from));
        cylinders.push(CylinderStrokes { cylinder: index + 1, strokes: spans });
        // A chamber fires once, under the number of its first cylinder.
        if engine.cylinders[index].chamber.is_none() {
            firings.extend(own.into_iter().map(|theta| (theta, index + 1, throw.angle)));
        }
    }
    firings.sort_by(|a, b| if (a.0 - b.0).abs() <= SAME { a.1.cmp(&b.1) } else { a.0.total_cmp(&b.0) });
    let count = firings.len();
    let interval = |k: usize| {
        let next = firings[(k + 1) % count].0 + if k + 1 == count { period } else { 0.0 };
        let interval: f64 = next - firings[k].0;
        if interval.abs() <= SAME { 0.0 } else { interval }
    };
    let firings: Vec<Firing> = firings
        .iter()
        .enumerate()
        .map(|(k, &(theta, cylinder, throw_angle))| Firing {
            cylinder,
            theta,
            interval: interval(k),
            throw_angle,
        })
        .collect();
    let even_interval = period / count as f64;
    let most = firings.iter().map(|f| (f.interval - even_interval).abs()).fold(0.0, f64::max);
    let unevenness = if most <= SAME { 0.0 } else { most / even_interval };
    let stars = (1..=16).map(|n| star(&firings, f64::from(n) / strokes)).collect();
    Ok(FiringChart { strokes: engine.strokes, period, firings, even_interval, unevenness, stars, cylinders })
}

/// Strokes of one working cycle that fires at `firing`, whose crank turns once in `turn` and reaches bottom dead centre
/// `down` after the top one.
fn spans(strokes: Strokes, firing: f64, turn: f64, down: f64) -> Vec<StrokeSpan> {
    use StrokeKind::{Compression, Exhaust, Intake, Power};
    let span = |stroke, from, to| StrokeSpan { stroke, from: firing + from, to: firing + to };
    match strokes {
        Strokes::Two => vec![span(Power, 0.0, down), span(Compression, down, turn)],
        Strokes::Four => vec![
            span(Power, 0.0, down),
            span(Exhaust, down, turn),
            span(Intake, turn, turn + down),
            span(Compression, turn + down, 2.0 * turn),
        ],
    }
}

fn star(firings: &[Firing], order: f64) -> FiringStar {
    let sum: Complex64 = firings.iter().map(|f| Complex64::cis(order * f.theta)).sum();
    FiringStar { order, share: sum.norm() / firings.len() as f64 }
}
