//! The best setting of a damper, found on the curve of the peak over the speed range.

use crate::chain::Chain;
use crate::error::TorsionError;
use crate::excitation::Excitation;
use crate::forced::Forced;
use lanchester_numerics::golden_section;
use num_complex::Complex64;
use serde::Serialize;

/// What the damper is to keep small, all orders in true phase.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TuneAim {
    /// Twist between nose and flywheel [rad].
    Twist,
    /// Torque in the shaft with this index [N m].
    Torque(usize),
    /// Largest shear stress of all shafts whose sections are known [Pa].
    Stress,
}

/// What of the damper is free.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TuneFree {
    /// Its viscous damping.
    Damping,
    /// Its stiffness, at the loss factor or damping that it has.
    Stiffness,
    /// Both.
    Both,
}

/// What to tune.
#[derive(Debug, Clone, PartialEq)]
pub struct TuneRequest {
    /// What is to be small.
    pub aim: TuneAim,
    /// What is free.
    pub free: TuneFree,
    /// Speeds among which the peak is sought, rising [rad/s]; between them it is refined.
    pub speeds: Vec<f64>,
    /// Range of the damping [N m s/rad]; `None`: from 1/100 to 10 times the ring's inertia times the natural frequency in which it swings most.
    pub damping: Option<[f64; 2]>,
    /// Range of the stiffness [N m/rad]; `None`: from 1/100 to 10 times the ring's inertia times the natural frequency in which it swings most squared.
    pub stiffness: Option<[f64; 2]>,
    /// Points of the curve.
    pub points: usize,
}

/// The best setting, with the curve that proves it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TunedDamper {
    /// What is small.
    pub aim: TuneAim,
    /// What was free.
    pub free: TuneFree,
    /// Best viscous damping [N m s/rad].
    pub damping: f64,
    /// Best stiffness [N m/rad].
    pub stiffness: f64,
    /// Loss factor of the stiffness, as given.
    pub loss_factor: f64,
    /// Peak over the speed range at the best setting, in the unit of the aim.
    pub peak: f64,
    /// Speed of that peak [rad/s].
    pub speed: f64,
    /// Peak with the damper as given.
    pub given: f64,
    /// Peak with the ring locked to its hub.
    pub locked: f64,
    /// The free number and the peak that it gives (the best stiffness for each damping where both are free), rising.
    pub curve: Vec<TunePoint>,
    /// Number of local minima on the curve: 1 where the best one is proved by the curve's points alone.
    pub minima: usize,
    /// Whether the best lies at an end of the range: a wider range would give less.
    pub is_at_end: bool,
}

/// A point of the curve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TunePoint {
    /// Damping [N m s/rad], or stiffness [N m/rad] where that alone is free.
    pub value: f64,
    /// Peak over the speed range, in the unit of the aim.
    pub peak: f64,
}

/// Steps of the refinement of a setting: the place to the square root of rounding.
const SETTING_STEPS: usize = 44;
/// Points and steps of the inner search where two numbers are free.
const INNER_POINTS: usize = 17;
const INNER_STEPS: usize = 22;
/// Steps of the refinement of a peak between two speeds.
const PEAK_STEPS: usize = 60;
/// Peaks that are refined.
const PEAKS: usize = 3;

/// The peak over the speed range: its value and speed.
///
/// # Errors
/// As [`crate::sweep`].
pub fn peak_over_speed(
    chain: &Chain,
    excitation: &Excitation,
    speeds: &[f64],
    aim: TuneAim,
) -> Result<(f64, f64), TorsionError> {
    let mut forced = Forced::new(chain, excitation)?;
    let mut orders = vec![Complex64::default(); excitation.count];
    let mut at = |speed: f64| {
        forced.solve(speed);
        value(&mut forced, aim, &mut orders)
    };
    let values: Vec<f64> = speeds.iter().map(|speed| at(*speed)).collect();
    let many = values.len();
    let is_top =
        |i: usize| (i == 0 || values[i] >= values[i - 1]) && (i + 1 == many || values[i] > values[i + 1]);
    let mut tops: Vec<usize> = (0..many).filter(|i| is_top(*i)).collect();
    tops.sort_by(|i, j| values[*j].total_cmp(&values[*i]));
    let mut best = (f64::NEG_INFINITY, f64::NAN);
    for &top in tops.iter().take(PEAKS) {
        let (from, to) = (speeds[top.saturating_sub(1)], speeds[(top + 1).min(many - 1)]);
        let found =
            golden_section(from, to, PEAK_STEPS, |speed| Ok::<f64, ()>(at(speed))).unwrap_or((f64::NAN, 0.0));
        for (speed, value) in [found, (speeds[top], values[top])] {
            if value > best.0 {
                best = (value, speed);
            }
        }
    }
    if many == 0 {
        return Err(TorsionError::Count { what: "speeds", needed: "1 or more".into(), got: 0 });
    }
    Ok(best)
}

fn value(forced: &mut Forced<'_>, aim: TuneAim, orders: &mut Vec<Complex64>) -> f64 {
    let half = |[top, bottom]: [f64; 2]| 0.5 * (top - bottom);
    let n = forced.impedance.size();
    match aim {
        TuneAim::Twist => {
            orders.clear();
            orders.extend(forced.between(forced.chain.nose(), forced.chain.flywheel()));
            half(forced.synthesis.extremes(orders.iter().copied()))
        }
        TuneAim::Torque(shaft) => {
            let at = (1..n).find(|at| forced.impedance.shaft[*at] == shaft).unwrap_or(1);
            orders.clear();
            orders.extend(forced.own_torque(at));
            half(forced.synthesis.extremes(orders.iter().copied()))
        }
        TuneAim::Stress => {
            let mut largest: f64 = 0.0;
            for at in 1..n {
                if let Some(section) = forced.chain.shafts()[forced.impedance.shaft[at]].section {
                    orders.clear();
                    orders.extend(forced.own_torque(at));
                    largest = largest
                        .max(half(forced.synthesis.extremes(orders.iter().copied())) / section.modulus());
                }
            }
            largest
        }
    }
}

/// The best setting of the chain's damper.
///
/// The peak over the speed range is computed at points of the whole range of the setting, evenly spaced on a logarithmic scale; the least of them is
/// refined between its neighbours. The curve is part of the answer.
///
/// # Errors
/// [`TorsionError::NoDamper`], an aim that the chain does not have, a range without points.
pub fn tune(
    chain: &Chain,
    excitation: &Excitation,
    request: &TuneRequest,
) -> Result<TunedDamper, TorsionError> {
    let shaft = chain.damper().ok_or(TorsionError::NoDamper)?;
    match request.aim {
        TuneAim::Torque(index) if index >= chain.shafts().len() => {
            return Err(TorsionError::Count {
                what: "shaft of the aim",
                needed: format!("from 0 to {}", chain.shafts().len() - 1),
                got: index,
            });
        }
        TuneAim::Stress if chain.shafts().iter().all(|shaft| shaft.section.is_none()) => {
            return Err(TorsionError::Count {
                what: "shafts of known section",
                needed: "1 or more".into(),
                got: 0,
            });
        }
        _ => {}
    }
    if request.points < 3 {
        return Err(TorsionError::Count {
            what: "points of the curve",
            needed: "3 or more".into(),
            got: request.points,
        });
    }
    let own = &chain.shafts()[shaft];
    let is_ring = |station: usize| chain.stations()[station].kind == crate::chain::StationKind::Ring;
    let ring = if is_ring(own.to) { own.to } else { own.from };
    let inertia = chain.stations()[ring].inertia;
    let locked = locked(chain, shaft, ring)?;
    // The mode in which the ring has the largest share: of one mass on a spring the only one, of an engine that of the crankshaft, not of the driveline.
    let hub = if ring == own.to { own.from } else { own.to };
    let share = |mode: &crate::modes::Mode| {
        let is_together = (mode.shape[ring] - mode.shape[hub]).abs() < 0.01 * mode.shape[ring].abs();
        // The mode of ring against hub is that of the lock.
        if is_together { inertia * mode.shape[ring].powi(2) / mode.inertia } else { 0.0 }
    };
    let all = crate::modes::modes(&locked, 0.0)?;
    let own_mode = all.iter().max_by(|a, b| share(a).total_cmp(&share(b)));
    let frequency = own_mode.map_or(1.0, |mode| mode.frequency);
    let range = |given: Option<[f64; 2]>, middle: f64| given.unwrap_or([0.01 * middle, 10.0 * middle]);
    let dampings = range(request.damping, inertia * frequency);
    let stiffnesses = range(request.stiffness, inertia * frequency * frequency);
    for [low, high] in [dampings, stiffnesses] {
        if !(low > 0.0 && high > low && high.is_finite()) {
            return Err(TorsionError::Number {
                quantity: "range of the damper",
                needed: "above 0 and rising",
                got: low,
            });
        }
    }
    let peak_of = |damping: f64, stiffness: f64| -> Result<(f64, f64), TorsionError> {
        let set = chain.with(|_, shafts| {
            (shafts[shaft].damping, shafts[shaft].stiffness) = (damping, stiffness);
        })?;
        peak_over_speed(&set, excitation, &request.speeds, request.aim)
    };
    // Of one free number: least over points of a logarithmic scale, then refined.
    type Best = (f64, f64, Vec<TunePoint>);
    let least = |[low, high]: [f64; 2],
                 points: usize,
                 steps: usize,
                 of: &dyn Fn(f64) -> Result<f64, TorsionError>|
     -> Result<Best, TorsionError> {
        let place = |i: usize| low * (high / low).powf(i as f64 / (points - 1) as f64);
        let mut curve = Vec::with_capacity(points);
        for i in 0..points {
            curve.push(TunePoint { value: place(i), peak: of(place(i))? });
        }
        let best = (0..points).fold(0, |best, i| if curve[i].peak < curve[best].peak { i } else { best });
        let (from, to) = (curve[best.saturating_sub(1)].value, curve[(best + 1).min(points - 1)].value);
        let (value, negative) = golden_section(from.ln(), to.ln(), steps, |x| of(x.exp()).map(|peak| -peak))?;
        let found = if -negative < curve[best].peak {
            (value.exp(), -negative)
        } else {
            (curve[best].value, curve[best].peak)
        };
        Ok((found.0, found.1, curve))
    };
    let (damping, stiffness, (peak, speed), curve) = match request.free {
        TuneFree::Damping => {
            let of = |c: f64| peak_of(c, own.stiffness).map(|found| found.0);
            let (c, _, curve) = least(dampings, request.points, SETTING_STEPS, &of)?;
            (c, own.stiffness, peak_of(c, own.stiffness)?, curve)
        }
        TuneFree::Stiffness => {
            let of = |k: f64| peak_of(own.damping, k).map(|found| found.0);
            let (k, _, curve) = least(stiffnesses, request.points, SETTING_STEPS, &of)?;
            (own.damping, k, peak_of(own.damping, k)?, curve)
        }
        TuneFree::Both => {
            let inner = |c: f64| -> Result<(f64, f64), TorsionError> {
                let (k, peak, _) =
                    least(stiffnesses, INNER_POINTS, INNER_STEPS, &|k| peak_of(c, k).map(|found| found.0))?;
                Ok((k, peak))
            };
            let (c, _, curve) =
                least(dampings, request.points, INNER_STEPS, &|c| inner(c).map(|found| found.1))?;
            let k = inner(c)?.0;
            (c, k, peak_of(c, k)?, curve)
        }
    };
    let many = curve.len();
    let is_least = |i: &usize| {
        let below = |j: usize| curve[*i].peak < curve[j].peak;
        (*i == 0 || below(*i - 1)) && (*i + 1 == many || below(*i + 1))
    };
    let minima = (0..many).filter(is_least).count();
    let value = if request.free == TuneFree::Stiffness { stiffness } else { damping };
    let is_at_end = value < curve[0].value * 1.001 || value > curve[many - 1].value * 0.999;
    Ok(TunedDamper {
        aim: request.aim,
        free: request.free,
        damping,
        stiffness,
        loss_factor: own.loss_factor,
        peak,
        speed,
        given: peak_of(own.damping, own.stiffness)?.0,
        locked: peak_over_speed(&locked, excitation, &request.speeds, request.aim)?.0,
        curve,
        minima,
        is_at_end,
    })
}

/// The chain with its ring locked to the hub by a spring so stiff that it plays no part.
fn locked(chain: &Chain, shaft: usize, ring: usize) -> Result<Chain, TorsionError> {
    let stiffest =
        (0..chain.shafts().len()).map(|index| chain.referred_stiffness(index, 0.0)).fold(0.0, f64::max);
    let square = chain.shafts()[shaft].ratio.powi(2);
    let inertia = chain.stations()[ring].inertia;
    // Stiff in itself, and stiff for its ring beside the stiffest part of the rest.
    let least = (0..chain.stations().len()).map(|i| chain.referred_inertia(i)).fold(f64::INFINITY, f64::min);
    let rigid = stiffest / square * 1e4 * (inertia / least).max(1.0);
    chain.with(|_, shafts| {
        (shafts[shaft].stiffness, shafts[shaft].damping, shafts[shaft].loss_factor) = (rigid, 0.0, 0.0);
    })
}
