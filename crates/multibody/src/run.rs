//! A run: pieces between events, each over the crank angle while the crank turns fast enough, over time otherwise.
//!
//! Over the angle the kinks of the pressures lie at known places, and steps end there. Over time they are located, as is every halt of the crank.

pub(crate) mod audit;
mod block_loads;
pub(crate) mod check;
pub(crate) mod equilibrium;
pub(crate) mod extremes;
pub(crate) mod kept;
pub(crate) mod kinks;
pub(crate) mod looking;
mod occasions;
mod profile;
pub(crate) mod result;
pub(crate) mod runner;
mod sampling;
mod watch;

use crate::error::MultibodyError;
use crate::gas_pressure::GasPressure;
use crate::mount_place::MountPlace;
use crate::powered::{Conditions, History, Layout, Powered, Torques, counted, governor_now};
use crate::run::audit::Auditor;
use crate::run::check::{check, check_length};
use crate::run::kinks::kinks;
use crate::run::looking::Looker;
use crate::run::profile::sampling_speed;
use crate::run::result::{Cost, RUN_VERSION, Run, RunOutcome, RunState, Samples};
use crate::run::runner::{ANY_TIME, Runner};
use crate::simulation::{
    BlockMotion, BlockStart, Drive, Duration, FAST, Simulation, When, load_torque, straight,
};
use crate::train::Train;
use kept::{Kept, Place};
use lanchester_numerics::{Dop853, Outcome, SampleGrid, Settings, Step};
use std::cell::RefCell;
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::rc::Rc;
use watch::{Mark, Piece, Watch};

/// Revolutions of one piece over the angle, which bounds the list of kinks.
const PIECE: f64 = 32.0 * TAU;

/// Revolutions of one piece over the angle, and steps over the dead time, with a governor that has one.
const WITH_DELAY: [f64; 2] = [2.0 * TAU, 0.9];

/// Share of the way to the end of a call by which its last step may be longer than that way, and the least length of such a step [rad].
const BEYOND: f64 = 1.1;
const SHORTEST: f64 = 1e-6;

/// Most samples of a piece for which room is made beforehand.
const MOST_RESERVED: usize = 16_384;

/// Most pieces of a run: events, halts and kinks at low speed.
const MOST_PIECES: usize = 1_000_000;

/// Where a periodic motion starts.
#[derive(Clone, Copy)]
pub(crate) struct Returning<'a> {
    /// The components of the state that return.
    pub state: &'a [f64],
    /// What a governor with a dead time wanted before.
    pub past: Option<&'a History>,
    /// Whether steps end at the bends of the pressures too.
    pub at_bends: bool,
}

impl Train {
    /// Runs the engine under `gas`.
    ///
    /// # Errors
    /// [`MultibodyError`] where a number is impossible, an inertia is missing that the run needs, or the block cannot move.
    pub fn run(&self, simulation: &Simulation, gas: Option<&dyn GasPressure>) -> Result<Run, MultibodyError> {
        self.run_from(simulation, gas, None, &|_| true)
    }

    /// The same; after every step `watch` sees how far the run is, and `false` ends it with the samples so far.
    ///
    /// # Errors
    /// As [`Train::run`].
    pub fn run_watched(
        &self,
        simulation: &Simulation,
        gas: Option<&dyn GasPressure>,
        watch: &dyn Fn(RunState) -> bool,
    ) -> Result<Run, MultibodyError> {
        self.run_from(simulation, gas, None, watch)
    }

    /// The same from a periodic motion.
    pub(crate) fn run_from(
        &self,
        simulation: &Simulation,
        gas: Option<&dyn GasPressure>,
        returning: Option<Returning<'_>>,
        watch: &dyn Fn(RunState) -> bool,
    ) -> Result<Run, MultibodyError> {
        let mut runner = Runner::new(self, simulation, gas)?;
        runner.watch = watch;
        if let Some(from) = returning {
            if from.at_bends {
                runner.end_steps_at_bends();
            }
            runner.rewind(from.state, from.past);
        }
        let mut auditor = Auditor::new(&mut runner);
        let mut looker = Looker::new(runner.period);
        let mut samples = Samples::default();
        let mut kept = Kept::new(runner.state.len());
        kept.push(runner.time).copy_from_slice(&runner.state);
        let look =
            &mut |powered: &Powered<'_>, theta: f64, state: &[f64]| auditor.look(powered, theta, state);
        runner.take(&kept, &mut samples, Some(&mut looker), &mut *look);
        let outcome = runner.go(|runner, kept| {
            runner.take(kept, &mut samples, Some(&mut looker), &mut *look);
        });
        let (extremes, last_period_extremes) = looker.close(&samples);
        let (audit, energy, last_period) = auditor.close(&mut runner);
        let tolerances = simulation.tolerances_at(simulation.start_speed.abs().max(1.0), runner.scale);
        Ok(Run {
            version: RUN_VERSION,
            engine: self.name.clone(),
            outcome,
            end: [runner.time, runner.state[0], runner.state[1]],
            samples,
            events: runner.happened,
            energy,
            last_period,
            extremes,
            last_period_extremes,
            stall: runner.stall.filter(|_| runner.powered.conditions.starter),
            audit,
            cost: runner.cost,
            tolerances,
        })
    }
}

impl<'a> Runner<'a> {
    pub fn new(
        train: &'a Train,
        simulation: &'a Simulation,
        gas: Option<&'a dyn GasPressure>,
    ) -> Result<Runner<'a>, MultibodyError> {
        check(train, simulation, gas.is_some())?;
        check_length(train, simulation)?;
        let mut runner = Runner::unstarted(train, simulation, gas, false);
        runner.start();
        Ok(runner)
    }

    /// What was checked, at crank angle and time 0; `is_stepped`: it goes on from call to call.
    pub fn unstarted(
        train: &'a Train,
        simulation: &'a Simulation,
        gas: Option<&'a dyn GasPressure>,
        is_stepped: bool,
    ) -> Runner<'a> {
        let layout = Layout {
            counted: counted(train, simulation, gas.is_some(), is_stepped),
            links: simulation.driveline.len(),
            moving: simulation.block != BlockMotion::Fixed,
            governed: simulation.governor.is_some(),
            lagged: simulation.governor.is_some_and(|governor| governor.lag > 0.0),
            branches: match simulation.block {
                BlockMotion::Mounts => train.mounts.iter().map(MountPlace::branches).sum(),
                _ => 0,
            },
        };
        let period = TAU * f64::from(train.revolutions);
        Runner {
            powered: Powered {
                train,
                gas,
                simulation,
                layout,
                conditions: Conditions {
                    fired: vec![1.0; train.cylinders.len()],
                    misfires: vec![false; train.cylinders.len()],
                    load: simulation.load.law.clone(),
                    demand: 0.0,
                    fuel: 1.0,
                    // One that would let go below the speed of the start is gone.
                    starter: simulation.starter.is_some_and(|starter| simulation.start_speed < starter.until),
                    clutch_open: false,
                    clutch_work: 0.0,
                    sense: 1.0,
                    held: false,
                    window: [0.0; 2],
                    times: [0.0; 2],
                    delayed: ANY_TIME,
                },
                places: Vec::new(),
                forces: Vec::new(),
                torques: Torques::default(),
                equations: None,
                holding: 0.0,
                history: simulation
                    .governor
                    .filter(|governor| governor.delay > 0.0)
                    .map(|governor| Rc::new(RefCell::new(History::new(governor.start, governor.delay)))),
            },
            time: 0.0,
            state: vec![0.0; layout.dimension()],
            kinks: kinks(train, gas, simulation, period, false),
            period,
            pending: vec![true; simulation.events.len()],
            until: simulation.duration,
            is_stepped,
            step: None,
            cost: Cost::default(),
            happened: Vec::new(),
            stall: None,
            scale: 1.0,
            watch: &|_| true,
        }
    }

    /// From now on steps end wherever a derivative of the pressures jumps; whether that is more than before.
    pub fn end_steps_at_bends(&mut self) -> bool {
        let before = self.kinks.len();
        let Powered { train, gas, simulation, .. } = self.powered;
        self.kinks = kinks(train, gas, simulation, self.period, true);
        self.kinks.len() > before
    }

    /// Sets the state of the start.
    pub fn start(&mut self) {
        let simulation = self.powered.simulation;
        let layout = self.powered.layout;
        self.state[0] = simulation.start_angle;
        self.state[1] = self.powered.imposed(0.0).map_or(simulation.start_speed, |([speed, _], _)| speed);
        let (mut angle, mut speed) = (self.state[0], self.state[1]);
        // The springs of the driveline carry the load from the start.
        for (index, link) in simulation.driveline.iter().enumerate() {
            (angle, speed) = (link.ratio * angle, link.ratio * speed);
            let behind: f64 = simulation.driveline[index + 1..].iter().map(|link| link.ratio).product();
            let load = load_torque(&simulation.load.law, speed * behind, angle * behind);
            let torque = behind * (load + self.powered.conditions.demand);
            angle -= if link.stiffness > 0.0 { torque / link.stiffness } else { 0.0 };
            self.state[layout.link(index)] = angle;
            self.state[layout.link(index) + 1] = speed;
        }
        if layout.governed {
            let start = simulation.governor.map_or(0.0, |governor| governor.start);
            self.state[layout.governor()..layout.relaxing()].fill(start);
        }
        if layout.moving {
            let at = layout.pose();
            self.state[at + 3] = 1.0;
            match simulation.block_start {
                BlockStart::AsDrawn => {}
                BlockStart::Equilibrium => equilibrium::place(self),
                BlockStart::Moving { velocity, spin } => {
                    self.state[at + 7..at + 10].copy_from_slice(&velocity);
                    self.state[at + 10..at + 13].copy_from_slice(&spin);
                }
            }
        }
        let theta = self.state[0];
        let state = self.state.clone();
        let speeds = simulation.start_speed.abs().max(state[1].abs()).max(1.0);
        let inertia = 2.0 * self.powered.energy(theta, &state)[0] / state[1].powi(2).max(1e-300);
        let inertia = if state[1] == 0.0 { 1.0 } else { inertia };
        self.scale = (0.5 * inertia * speeds * speeds).max(1e-6);
        if state[1] == 0.0 && matches!(simulation.drive, Drive::Free) {
            self.halt(false);
        } else {
            self.powered.conditions.sense = if state[1] < 0.0 { -1.0 } else { 1.0 };
        }
    }

    /// Kinks next to `theta`, the one at it counting as behind it where `forwards`.
    fn window(&self, theta: f64, forwards: bool) -> [f64; 2] {
        if self.kinks.is_empty() {
            return [0.0; 2];
        }
        let turns = (theta / self.period).floor();
        let at = |k: isize| {
            let count = self.kinks.len() as isize;
            self.period * (turns + k.div_euclid(count) as f64) + self.kinks[k.rem_euclid(count) as usize]
        };
        let own = theta - turns * self.period;
        let slack = if forwards { 1e-11 } else { -1e-11 };
        let after = self.kinks.partition_point(|kink| *kink <= own + slack) as isize;
        [at(after - 1), at(after)]
    }

    /// Runs to the end, showing what is kept after each piece.
    pub fn go(&mut self, mut show: impl FnMut(&mut Runner<'a>, &Kept)) -> RunOutcome {
        let mut kept = Kept::new(self.state.len());
        if let Some(end) = self.happen(None) {
            return end;
        }
        for _ in 0..MOST_PIECES {
            if self.rests_for_good() {
                return self.at_rest();
            }
            let (outcome, watch) = self.piece(&mut kept);
            show(self, &kept);
            kept.clear();
            match outcome {
                Outcome::Reached => {
                    if let Some(end) = self.ended() {
                        return end;
                    }
                }
                Outcome::Event { .. } => {
                    if let Some(end) = watch.and_then(|watch| self.answer(watch)) {
                        return end;
                    }
                }
                Outcome::TooManyEvaluations { .. } => return RunOutcome::TooManyEvaluations,
                Outcome::Stopped => return RunOutcome::Cancelled,
                reason => {
                    let quantity = match reason {
                        Outcome::NotFinite { component } => Some(self.powered.layout.name(component)),
                        _ => None,
                    };
                    return RunOutcome::Failed { reason, theta: self.state[0], quantity };
                }
            }
        }
        RunOutcome::TooManyEvaluations
    }

    fn ended(&mut self) -> Option<RunOutcome> {
        let over = match self.until {
            Duration::Revolutions(turns) => {
                self.state[0] >= self.powered.simulation.start_angle + TAU * turns * (1.0 - 1e-15)
            }
            Duration::Time(time) => self.time >= time * (1.0 - 1e-15),
        };
        over.then_some(RunOutcome::Complete)
    }

    /// Whether friction holds the crank in a block that stands still, and nothing more will come.
    fn rests_for_good(&self) -> bool {
        let conditions = &self.powered.conditions;
        conditions.held
            && !self.is_stepped
            && (!self.powered.layout.moving || matches!(self.until, Duration::Revolutions(_)))
    }

    fn at_rest(&self) -> RunOutcome {
        let torque = -self.powered.holding;
        RunOutcome::AtRest { theta: self.state[0], torque, held_by: self.powered.dry_torque() }
    }

    /// One piece; the watch that ended it.
    fn piece(&mut self, kept: &mut Kept) -> (Outcome, Option<Watch>) {
        let simulation = self.powered.simulation;
        let layout = self.powered.layout;
        // A profile has its knots in time.
        let profile = match &simulation.drive {
            Drive::Imposed { profile, .. } if profile.len() > 1 => &profile[..],
            _ => &[],
        };
        let profile_speeds = self.powered.conditions.times.map(|time| straight(profile, time));
        let over_angle = self.state[1] >= FAST[0] && !self.powered.conditions.held && profile.is_empty();
        let mut watches = Vec::new();
        let from = if over_angle { self.state[0] } else { self.time };
        let mut end = f64::INFINITY;
        let mut stops = Vec::new();
        let until = match self.until {
            Duration::Revolutions(turns) => [simulation.start_angle + TAU * turns, f64::INFINITY],
            Duration::Time(time) => [f64::INFINITY, time],
        };
        if over_angle {
            end = end.min(until[0]).min(from + PIECE);
            if until[1].is_finite() {
                watches.push(Watch::Time(until[1], Mark::Knot));
            }
            watches.push(Watch::Speed(FAST[0], false, Mark::Mode));
            stops = self.kinks_between(from, end);
        } else {
            end = end.min(until[1]);
            if until[0].is_finite() {
                watches.push(Watch::Angle(until[0], Mark::Knot));
                // A crank that swings about a place never gets there: a bound in time, far beyond what FAST allows.
                end = end.min(self.time + 1e4);
            }
            if self.powered.conditions.held {
                watches.push(Watch::Grip);
            } else {
                if profile.is_empty() {
                    watches.push(Watch::Speed(FAST[1], true, Mark::Mode));
                }
                if matches!(simulation.drive, Drive::Free) {
                    watches.push(Watch::Speed(0.0, self.powered.conditions.sense < 0.0, Mark::Halt));
                }
                let window = self.window(self.state[0], self.powered.conditions.sense > 0.0);
                self.powered.conditions.window = window;
                if window[1] > window[0] {
                    watches.extend(window.map(|kink| Watch::Angle(kink, Mark::Kink)));
                }
            }
        }
        let delay = match (&simulation.governor, &self.powered.history) {
            (Some(governor), Some(history)) => {
                let mut history = history.borrow_mut();
                history.forget_before(self.time);
                let window = history.window(self.time);
                self.powered.conditions.delayed = window;
                // The dead time brings back what jumped.
                match over_angle {
                    true if window[1].is_finite() => {
                        watches.push(Watch::Time(window[1] + governor.delay, Mark::Knot));
                    }
                    true => {}
                    false => end = end.min(window[1] + governor.delay),
                }
                if over_angle {
                    end = end.min(from + WITH_DELAY[0]);
                }
                Some(governor.delay)
            }
            _ => None,
        };
        if let (Some(starter), true) = (&simulation.starter, self.powered.conditions.starter) {
            watches.push(Watch::Speed(starter.until, true, Mark::Starter));
        }
        stops.extend(profile.iter().map(|point| point[0]).filter(|time| *time > self.time));
        for (index, event) in simulation.events.iter().enumerate().filter(|(index, _)| self.pending[*index]) {
            watches.push(match event.when {
                When::Time(time) => Watch::Time(time, Mark::Event(index)),
                When::Angle(angle) => Watch::Angle(simulation.start_angle + angle, Mark::Event(index)),
                When::SpeedRises(speed) => Watch::Speed(speed, true, Mark::Event(index)),
                When::SpeedFalls(speed) => Watch::Speed(speed, false, Mark::Event(index)),
            });
        }
        // The integrator's norm is the root mean square over all components: few of them have the error.
        let share = 0.5 / (layout.dimension() as f64).sqrt();
        let mut settings = Settings::uniform(layout.dimension(), share * simulation.tolerance);
        let speed = simulation.start_speed.abs().max(self.state[1].abs()).max(1.0);
        let kinds = simulation.tolerances_at(speed, self.scale);
        let mut set =
            |range: std::ops::Range<usize>, amount: f64| settings.absolute[range].fill(share * amount);
        set(0..1, if over_angle { kinds.angle / speed } else { kinds.angle });
        set(1..2, kinds.speed);
        for index in 0..layout.links {
            let at = layout.link(index);
            set(at..at + 1, kinds.angle);
            set(at + 1..at + 2, kinds.speed);
        }
        if layout.moving {
            let at = layout.pose();
            set(at..at + 3, kinds.displacement);
            set(at + 3..at + 7, 0.5 * kinds.turn);
            set(at + 7..at + 10, kinds.velocity);
            set(at + 10..at + 13, kinds.spin);
            set(layout.relaxing()..layout.works(), kinds.displacement);
        }
        set(layout.works()..layout.dimension(), kinds.energy);
        settings.first_step = self.step.map(|(was_over_angle, size)| match (was_over_angle, over_angle) {
            (true, false) => size / self.state[1].max(1.0),
            (false, true) => size * self.state[1],
            _ => size,
        });
        // Where something may jump both sides are looked at.
        let is_looking = simulation.reactions && !self.is_stepped;
        let jumps = if is_looking { stops.clone() } else { Vec::new() };
        if is_looking {
            kept.push_as(Place::Behind, self.time).copy_from_slice(&self.state);
        }
        settings.stops = stops;
        settings.most_evaluations = simulation.most_evaluations.saturating_sub(self.cost.evaluations);
        // Over the angle a longer step would pass over what happens within a stroke.
        settings.longest_step = if over_angle { 0.5 } else { f64::INFINITY };
        if let Some(delay) = delay {
            let span = WITH_DELAY[1] * delay * if over_angle { self.state[1] } else { 1.0 };
            settings.longest_step = settings.longest_step.min(span);
        }
        if over_angle && self.is_stepped && until[1].is_finite() {
            // The last step goes little beyond the end, which is found on its interpolant.
            let left = BEYOND * self.state[1] * (until[1] - self.time);
            settings.longest_step = settings.longest_step.min(left.max(SHORTEST));
        }
        if over_angle {
            // Twice a revolution or more the steps shorten towards a dead centre, and the estimate of their error passes through zero: measured on singles and
            // V6, fixed and on mounts, this rejects the fewest.
            (settings.safety, settings.largest_growth) = (0.85, 1.5);
        }
        settings.event_tolerance = 1e-13 * if over_angle { 1.0 } else { 0.1 };
        // Over time the samples are a step apart where the crank turns fastest in this piece, and closer elsewhere.
        let grid = match self.is_stepped {
            true => f64::INFINITY,
            false => simulation.step / if over_angle { 1.0 } else { sampling_speed(profile_speeds) },
        };
        let looks = if is_looking { simulation.looks.max(1) } else { 1 };
        let fine = grid / looks as f64;
        let origin = if over_angle { simulation.start_angle } else { 0.0 };
        // The commands of a governor with a dead time are kept at every step.
        settings.dense = delay.is_some() || !self.is_stepped;
        settings.samples =
            (delay.is_none() && settings.dense).then_some(SampleGrid { origin, spacing: fine });
        let mut integrator = Dop853::new(settings);
        if over_angle {
            kept.reserve((((end - from) / fine) as usize + 2).min(MOST_RESERVED));
        }

        let mut y = self.state.clone();
        let mut x = from;
        if over_angle {
            y[0] = self.time;
        }
        let watch = self.watch;
        let history = self.powered.history.clone().zip(simulation.governor);
        let delayed = self.powered.conditions.delayed;
        let mut room = vec![0.0; layout.dimension()];
        let mut system = Piece { powered: &mut self.powered, over_angle, watches };
        let outcome = integrator.run(&mut system, &mut x, &mut y, end, |step: &Step| {
            if let Some((history, governor)) = &history {
                let places = History::places().map(|share| match share {
                    1.0 => step.to,
                    share => step.from + share * (step.to - step.from),
                });
                let mut history = history.borrow_mut();
                let (mut times, mut commands) = (places, places);
                for (k, at) in places.into_iter().enumerate() {
                    step.at(at, &mut room);
                    times[k] = if over_angle { room[0] } else { at };
                    commands[k] =
                        governor_now(governor, layout, Some(&history), delayed, (times[k], &room)).command;
                }
                history.push(times, commands);
            }
            let mut index = ((step.from - origin) / fine * (1.0 + 1e-14)).floor() + 1.0;
            loop {
                let whole = index / looks as f64;
                let is_sample = looks == 1 || whole == whole.floor();
                let at = origin + if is_sample { whole * grid } else { index * fine };
                // The end of the run is a sample though rounding may put it beyond.
                let at = if at > step.to && at < step.to + 1e-9 * grid { step.to } else { at };
                if at > step.to {
                    let next = jumps.partition_point(|jump| *jump < step.to - 1e-9);
                    if jumps.get(next).is_some_and(|jump| *jump <= step.to + 1e-9) {
                        keep_both_sides(kept, step, over_angle);
                    }
                    let (time, theta) = match over_angle {
                        true => (step.end[0], step.to),
                        false => (step.to, step.end[0]),
                    };
                    let goes_on = watch(RunState { time, theta, speed: step.end[1] });
                    return if goes_on { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
                }
                let state = kept.push_as(if is_sample { Place::Sample } else { Place::Look }, at);
                step.at(at, state);
                if over_angle {
                    let time = std::mem::replace(&mut state[0], at);
                    kept.is_at(time);
                }
                index += 1.0;
            }
        });
        let watches = system.watches;
        self.cost.add(integrator.statistics());
        self.step =
            integrator.proposed_step().filter(|_| self.is_stepped).map(|size| (over_angle, size.abs()));
        if over_angle {
            self.time = y[0];
            y[0] = x;
        } else {
            self.time = x;
        }
        self.state = y;
        self.straighten();
        // Where the piece ends something may jump.
        if is_looking && kept.last_time().is_some_and(|last| last < self.time) && self.is_finite() {
            kept.push_as(Place::Look, self.time).copy_from_slice(&self.state);
        }
        let watch = match outcome {
            Outcome::Event { index, rising } => watches.get(index).copied().map(|watch| match watch {
                // A crossing in the other sense is no event of this watch.
                Watch::Speed(speed, wanted, Mark::Event(event)) if wanted != rising => {
                    Watch::Speed(speed, wanted, Mark::Event(event)).passed_over()
                }
                other => other,
            }),
            _ => None,
        };
        (outcome, watch)
    }

    fn is_finite(&self) -> bool {
        self.time.is_finite() && self.state.iter().all(|value| value.is_finite())
    }

    /// The quaternion back to size 1: its error is that of the steps.
    fn straighten(&mut self) {
        if self.powered.layout.moving {
            let at = self.powered.layout.pose() + 3;
            let size = self.state[at..at + 4].iter().map(|q| q * q).sum::<f64>().sqrt();
            self.state[at..at + 4].iter_mut().for_each(|q| *q /= size);
        }
    }

    fn kinks_between(&self, from: f64, to: f64) -> Vec<f64> {
        let turns = ((from / self.period).floor() as i64)..=((to / self.period).ceil() as i64);
        let all = turns.flat_map(|turn| self.kinks.iter().map(move |kink| kink + self.period * turn as f64));
        all.filter(|kink| *kink > from + 1e-11 && *kink < to).collect()
    }
}

/// Keeps the end of a step for both sides of what jumps there.
fn keep_both_sides(kept: &mut Kept, step: &Step, over_angle: bool) {
    let time = if over_angle { step.end[0] } else { step.to };
    let is_there = kept.last_time().is_some_and(|last| last >= time);
    for place in [Place::Look, Place::Behind].into_iter().skip(usize::from(is_there)) {
        let state = kept.push_as(place, time);
        state.copy_from_slice(step.end);
        if over_angle {
            state[0] = step.to;
        }
    }
}
