//! An engine among the layouts of a search: where it stands, and a layout made an engine of its own.

use crate::layouts::own::OwnLayout;
use lanchester_mechanism::{
    BeamModel, InternalRequest, LoadError, LoadRequest, TorqueError, firing_chart, internal_moments, motion,
    total_loads,
};
use lanchester_model::{CrankcasePressure, Engine, EngineParts, Gas, GasSource};
use lanchester_results::OrderLoads;
use lanchester_study::explore::{
    Arrangement, Banks, Constraint, ExploreAnswer, ExploreError, Explorer, GivenEngine, Layout, Objective,
    Sense,
};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Why an engine cannot be set beside the layouts of a search, or a layout is no engine.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LayoutSearchError {
    /// Its loads cannot be computed.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// Its firing cannot be told.
    #[error(transparent)]
    Firing(#[from] TorqueError),
    /// The search is refused.
    #[error(transparent)]
    Explore(#[from] ExploreError),
}

/// The engine of the file with its own weights and shafts, set beside the front of `answer`.
///
/// # Errors
/// [`LayoutSearchError`] where its loads cannot be computed.
pub fn given_engine(
    engine: &Engine,
    explorer: &Explorer,
    answer: &ExploreAnswer,
) -> Result<GivenEngine, LayoutSearchError> {
    let request = explorer.request();
    let own = OwnLayout::of(engine);
    let measured = Measured::of(engine, explorer, own.as_ref().ok())?;
    let values: Vec<Option<f64>> = request.objectives.iter().map(|&o| measured.value(o)).collect();
    let broken = request.constraints.iter().filter(|constraint| measured.breaks(**constraint));
    let broken = broken.map(|constraint| constraint.name()).collect();
    let known: Option<Vec<f64>> = values.iter().copied().collect();
    let (mut beaten_by, mut equals) = (Vec::new(), None);
    if let Some(known) = known {
        let steps = explorer.steps(&known);
        for found in &answer.front {
            let other = explorer.steps(&found.values);
            if other == steps {
                equals = Some(found.number);
            } else if other.iter().zip(&steps).all(|(a, b)| a <= b) {
                beaten_by.push(found.number);
            }
        }
    }
    let case = match request.space.arrangement() {
        Some(arrangement) => kept_case(engine, explorer, arrangement)?,
        None => own.and_then(|own| case(engine, explorer, &own)),
    };
    let (case, outside) = match case {
        Ok(case) => (Some(case), None),
        Err(reason) => (None, Some(reason)),
    };
    Ok(GivenEngine { values, broken, beaten_by, equals, case, outside })
}

/// What an engine has of the objectives.
struct Measured<'a> {
    engine: &'a Engine,
    explorer: &'a Explorer,
    own: Option<&'a OwnLayout>,
    orders: [Option<OrderLoads>; 2],
    bending: f64,
    main: f64,
    /// Firing angles [rad] and cylinders, in their sequence, and the largest departure from the even interval [rad].
    firing: Option<(Vec<(f64, usize)>, f64)>,
}

impl<'a> Measured<'a> {
    fn of(
        engine: &'a Engine,
        explorer: &'a Explorer,
        own: Option<&'a OwnLayout>,
    ) -> Result<Measured<'a>, LayoutSearchError> {
        let speed = Some(explorer.request().space.parts.speed);
        let loads =
            total_loads(engine, &LoadRequest { speed, max_order: 2, samples: 1, ..LoadRequest::default() })?;
        let order = |n: f64| loads.orders.iter().find(|order| (order.order - n).abs() < 1e-9).copied();
        let inside =
            internal_moments(engine, &InternalRequest { speed, samples: 8, ..InternalRequest::default() })?;
        let most = |of: &dyn Fn(&lanchester_mechanism::CrankshaftMoments) -> f64| {
            inside.crankshafts.iter().map(of).fold(0.0, f64::max)
        };
        let fires = engine.cylinders.iter().all(|cylinder| cylinder.firing_angle.is_some());
        let firing = match fires {
            false => None,
            true => {
                let chart = firing_chart(engine)?;
                let firings = chart.firings.iter().map(|f| (f.theta, f.cylinder - 1)).collect();
                Some((firings, chart.unevenness * chart.even_interval))
            }
        };
        Ok(Measured {
            engine,
            explorer,
            own,
            orders: [order(1.0), order(2.0)],
            bending: most(&|crank| crank.of(BeamModel::FreeBeam).peak_moment.value),
            main: most(&|crank| crank.of(BeamModel::ThrowByThrow).peak_main.value),
            firing,
        })
    }

    fn order(&self, order: u32) -> Option<&OrderLoads> {
        self.orders.get(order.checked_sub(1)? as usize)?.as_ref()
    }

    fn value(&self, objective: Objective) -> Option<f64> {
        let (engine, parts) = (self.engine, &self.explorer.request().space.parts);
        match objective {
            Objective::Force { order } => self.order(order).map(OrderLoads::force_peak),
            Objective::Couple { order } => self.order(order).map(OrderLoads::couple_peak),
            Objective::ForceSense { order, sense } => self.order(order).map(|loads| match sense {
                Sense::Forward => loads.force_forward.norm(),
                Sense::Backward => loads.force_backward.norm(),
            }),
            Objective::CoupleSense { order, sense } => self.order(order).map(|loads| match sense {
                Sense::Forward => loads.couple_forward.norm(),
                Sense::Backward => loads.couple_backward.norm(),
            }),
            Objective::RollMoment { order } => self.order(order).map(|loads| loads.roll_moment.norm()),
            Objective::InertiaTorque { order } => self.order(order).map(|loads| loads.shaft_torque.norm()),
            Objective::BendingMoment => Some(self.bending),
            Objective::MainLoad => Some(self.main),
            Objective::FiringUnevenness => self.firing.as_ref().map(|(_, unevenness)| *unevenness),
            Objective::FiringHarmonic { half_orders } => self.firing.as_ref().map(|(firings, _)| {
                let factor = 0.5 * f64::from(half_orders);
                let sum: Complex64 = firings.iter().map(|(theta, _)| Complex64::cis(factor * theta)).sum();
                sum.norm() / firings.len() as f64
            }),
            Objective::NeighbourFirings => self.neighbours(),
            Objective::Length => {
                let planes = engine.cylinders.iter().map(|cylinder| cylinder.z);
                let (low, high) = planes
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
                Some(high - low + parts.end_length)
            }
            Objective::Height => {
                let heights = engine.cylinders.iter().map(|c| c.rod.length + engine.throws[c.throw].radius);
                Some(heights.fold(0.0, f64::max))
            }
            Objective::CounterweightUnbalance => {
                Some(engine.counterweights.iter().map(|weight| weight.unbalance).sum())
            }
            Objective::Shafts => Some(engine.shafts.len() as f64),
        }
    }

    /// Successive firings of cylinders that stand side by side in one bank.
    fn neighbours(&self) -> Option<f64> {
        if let Some(arrangement) = self.explorer.request().space.arrangement() {
            let (pairs, (firings, _)) = (arrangement.neighbours(), self.firing.as_ref()?);
            let count = firings.len();
            let side_by_side = |a: usize, b: usize| pairs.contains(&[a, b]) || pairs.contains(&[b, a]);
            let ends = if count > 2 { count } else { count.saturating_sub(1) };
            let follow = |k: &usize| side_by_side(firings[*k].1, firings[(k + 1) % count].1);
            return Some((0..ends).filter(follow).count() as f64);
        }
        let (own, (firings, _)) = (self.own?, self.firing.as_ref()?);
        let place = |cylinder: usize| own.cylinders.iter().position(|other| *other == cylinder);
        let places = firings.iter().map(|(_, cylinder)| place(*cylinder)).collect::<Option<Vec<_>>>()?;
        let (count, groups) = (places.len(), own.groups());
        let side_by_side = |a: usize, b: usize| a / groups == b / groups && a.abs_diff(b) == 1;
        let pairs = if count > 2 { count } else { count.saturating_sub(1) };
        Some((0..pairs).filter(|&k| side_by_side(places[k], places[(k + 1) % count])).count() as f64)
    }

    fn breaks(&self, constraint: Constraint) -> bool {
        let parts = &self.explorer.request().space.parts;
        match constraint {
            Constraint::EvenFiring { tolerance } => {
                self.firing.as_ref().is_none_or(|(_, unevenness)| *unevenness > tolerance + 1e-9)
            }
            Constraint::AtMost { objective, limit } => {
                // Rounding of what is computed in another way is no breach.
                self.value(objective).is_none_or(|value| value > limit + 1e-9 * limit.abs())
            }
            Constraint::BearingRoom { least } => self.own.is_none_or(|own| {
                own.groups() > 1 && own.spacing - parts.web_distance - parts.web_thickness < least - 1e-12
            }),
            Constraint::PinOverlap { least } => {
                let pair = self.own.and_then(|own| own.banks).filter(|pair| pair.split_angle.abs() > 1e-9);
                pair.is_some_and(|pair| {
                    let apart = 2.0 * parts.crank_radius * (0.5 * pair.split_angle).sin().abs();
                    parts.pin_diameter - apart < least - 1e-12
                })
            }
        }
    }
}

/// The case that the engine is, weights and shafts apart.
fn case(engine: &Engine, explorer: &Explorer, own: &OwnLayout) -> Result<u128, String> {
    let space = &explorer.request().space;
    if space.cylinders != engine.cylinders.len() {
        return Err(format!("it has {} cylinders", engine.cylinders.len()));
    }
    let near = |list: &[f64], value: f64| list.iter().copied().find(|other| (other - value).abs() < 1e-7);
    let or = |found: Option<f64>, what: &str| {
        found.ok_or_else(|| format!("its {what} is not among those searched"))
    };
    let banks = match (&space.banks, own.banks) {
        (Banks::InLine, None) => None,
        (Banks::Two { bank_angles, split_angles, staggers }, Some(pair)) => {
            Some(lanchester_study::explore::BankPair {
                bank_angle: or(near(bank_angles, pair.bank_angle), "bank angle")?,
                split_angle: or(near(split_angles, pair.split_angle), "angle between the pins of a pair")?,
                stagger: or(near(staggers, pair.stagger), "stagger of the banks")?,
            })
        }
        (Banks::InLine, Some(_)) => return Err("it has two banks".to_owned()),
        (Banks::Two { .. }, None) => return Err("it has one bank".to_owned()),
        (Banks::AsGiven(_), _) => return Err("its cylinders stay where they are".to_owned()),
    };
    let spacing = match own.groups() {
        1 => space.spacings[0],
        _ => or(near(&space.spacings, own.spacing), "spacing")?,
    };
    let throw = &engine.throws[engine.cylinders[0].throw];
    let ratio = throw.radius / engine.cylinders[0].rod.length;
    let firing: Option<Vec<f64>> =
        own.cylinders.iter().map(|&cylinder| engine.cylinders[cylinder].firing_angle).collect();
    let firing = match (space.firing, firing) {
        (false, _) => None,
        (true, None) => return Err("its file gives no firing".to_owned()),
        (true, Some(angles)) => Some(angles),
    };
    let mut layout = Layout {
        case: 0,
        cylinders: space.cylinders,
        spacing,
        banks,
        rod_ratio: or(near(&space.rod_ratios, ratio), "rod ratio")?,
        counterweights: space.counterweights[0].clone(),
        shafts: space.shafts[0].clone(),
        throw_angles: own.throw_angles.clone(),
        firing_angles: None,
        arrangement: None,
    };
    layout.firing_angles = firing.map(|angles| {
        // Counted as a case counts them: from its own top dead centre of cylinder 1, in the first revolution.
        let cycle = TAU * f64::from(engine.strokes.revolutions());
        let first = layout.bank_axes()[0].rem_euclid(TAU);
        angles.iter().map(|angle| (first + angle - angles[0]).rem_euclid(cycle)).collect()
    });
    explorer.case_of(&layout).ok_or_else(|| "an angle of its throws is not among those searched".to_owned())
}

/// The case that an engine is whose cylinders stay where they are, weights and shafts apart.
fn kept_case(
    engine: &Engine,
    explorer: &Explorer,
    arrangement: &Arrangement,
) -> Result<Result<u128, String>, LayoutSearchError> {
    let space = &explorer.request().space;
    let mut layout = explorer.layout(0)?;
    layout.throw_angles.clone_from(&arrangement.throw_angles);
    layout.firing_angles = match space.firing {
        false => None,
        true => {
            // Firings at the dead centres next to those of the file.
            let motion = motion(engine, &LoadRequest { samples: 1, ..LoadRequest::default() })?;
            let Some(angles) = motion.iter().map(|m| m.firing_angle).collect::<Option<Vec<f64>>>() else {
                return Ok(Err("its file gives no firing".to_owned()));
            };
            let cycle = TAU * f64::from(engine.strokes.revolutions());
            let first = layout.first_firing();
            Some(angles.iter().map(|angle| (first + angle - angles[0]).rem_euclid(cycle)).collect())
        }
    };
    let outside = || "an angle of its throws is not among those searched".to_owned();
    Ok(explorer.case_of(&layout).ok_or_else(outside))
}

/// A case as an engine of its own, with the name, speeds, sense of rotation, friction and flywheel of `engine`, and its gas
/// where that is computed. What belongs to the old block and crank (mounts, parts, tasks) is left out.
///
/// # Errors
/// [`LayoutSearchError`] beyond the space, or where its loads cannot be computed.
pub fn adopted_layout(engine: &Engine, explorer: &Explorer, case: u128) -> Result<Engine, LayoutSearchError> {
    let parts = &explorer.request().space.parts;
    let layout = explorer.layout(case)?;
    let of = format!("made of the parts of {}: case {case} of {} layouts", engine.name, explorer.size());
    let change = |adopted: &mut EngineParts| {
        adopted.name = layout_name(&layout);
        adopted.note = Some(of);
        adopted.rotation = engine.rotation;
        adopted.speed = engine.speed;
        adopted.friction = engine.friction;
        adopted.flywheel = engine.flywheel.clone();
        adopted.gas = engine.gas.as_ref().filter(|gas| holds_for_any_layout(gas)).cloned();
        if !layout.has_split_pins() {
            for throw in adopted.throws.iter_mut().filter(|throw| throw.webs.is_none()) {
                throw.webs = Some([-0.5, 0.5].map(|side| throw.z + side * parts.web_distance));
            }
        }
        if engine.cylinders.iter().any(|cylinder| cylinder.bore.is_none()) {
            adopted.cylinders.iter_mut().for_each(|cylinder| cylinder.bore = None);
        }
    };
    let adopted = layout.engine(parts)?.with(change);
    Ok(adopted.expect("invariant: the web distance of a space of layouts is positive"))
}

/// Measured pressures belong to the cylinders of their engine.
pub(crate) fn holds_for_any_layout(gas: &Gas) -> bool {
    matches!((&gas.source, &gas.crankcase), (GasSource::Cycle(_), CrankcasePressure::Constant { .. }))
}

/// "V6, 90 deg, pins 30 deg apart".
pub fn layout_name(layout: &Layout) -> String {
    let degrees = |angle: f64| (1e6 * angle.to_degrees()).round() / 1e6;
    if let Some(arrangement) = &layout.arrangement {
        let throws: Vec<String> =
            layout.throw_angles.iter().map(|angle| degrees(*angle).to_string()).collect();
        return format!("{}, throws {} deg", arrangement.name, throws.join(" "));
    }
    match layout.banks {
        None => format!("in-line {}", layout.cylinders),
        Some(pair) => {
            let split = if layout.has_split_pins() {
                format!(", pins {} deg apart", degrees(pair.split_angle))
            } else {
                String::new()
            };
            format!("V{}, {} deg{split}", layout.cylinders, degrees(pair.bank_angle))
        }
    }
}
