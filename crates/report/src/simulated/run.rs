//! A simulated run as text and CSV: speed, block, mounts, bearings, energy, events, cost.

use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::table::{Cell, Table};
use crate::simulated::columns::{table, words};
use crate::simulated::energy::energy_table;
use crate::simulated::extremes::extremes_table;
use crate::simulated::moving::{driveline_table, gears_table, points_table};
use crate::simulated::orders::{joints_table, orders_table};
use crate::simulated::result::{PeriodicResult, SimulationResult, occasion_words};
use lanchester_multibody::{
    Bounds, Followed, MainRule, Occasion, Outcome, PeriodicOutcome, Run, RunOutcome, Stall,
};
use std::f64::consts::TAU;

fn outcome_words(outcome: &RunOutcome) -> String {
    let degrees = |theta: f64| number::short(theta.to_degrees(), 6);
    match outcome {
        RunOutcome::Complete => "complete".into(),
        RunOutcome::Stopped => "stopped by an event".into(),
        RunOutcome::AtRest { theta, torque, held_by } => format!(
            "the crank comes to rest at {} deg, where {} N m are left against {} N m of friction and load",
            degrees(*theta),
            number::short(*torque, 4),
            number::short(*held_by, 4)
        ),
        RunOutcome::Cancelled => "incomplete: cancelled, the samples so far are shown".into(),
        RunOutcome::TooManyEvaluations => "incomplete: as many evaluations as are allowed were used".into(),
        RunOutcome::Failed { reason, theta, quantity } => {
            let what = match (quantity, reason) {
                (Some(quantity), _) => format!("the {quantity} becomes no finite number"),
                (None, Outcome::StepTooSmall { .. }) => "no step is short enough for the tolerance".into(),
                (None, _) => "the equations of motion have no solution".into(),
            };
            format!("incomplete: {what} behind {} deg; the samples up to there are good", degrees(*theta))
        }
    }
}

/// How the run ended, what was chosen for it, and what its audits say: a paragraph each.
pub fn simulation_words(result: &SimulationResult) -> Vec<String> {
    let run = &result.run;
    let [time, theta, speed] = run.end;
    let mut all = vec![format!(
        "Run: {}. It ends after {} s at {} revolutions and {} rpm.",
        outcome_words(&run.outcome),
        number::short(time, 5),
        number::short(theta / TAU, 6),
        number::short(number::rpm(speed), 6)
    )];
    match &run.stall {
        Some(stall) => all.push(stall_words(stall)),
        None => all.extend(stalled_words(run)),
    }
    all.extend(result.periodic.as_ref().map(periodic_words));
    all.extend(result.notes.iter().cloned());
    all
}

/// Change over a period that the search seeks.
const CLOSED: f64 = 1e-10;

/// How the search for a periodic motion ended.
pub(crate) fn periodic_words(periodic: &PeriodicResult) -> String {
    let after = |followed: &Followed| {
        format!("{} periods ({} s) after the start", followed.periods, number::short(followed.time, 4))
    };
    let found = match periodic.outcome {
        PeriodicOutcome::Stable => "stable",
        PeriodicOutcome::Neutral => "neutral, because the load does not depend on the speed",
        PeriodicOutcome::Unstable => "unstable",
        PeriodicOutcome::Cancelled => {
            "cancelled: a period of the best trial so far is shown, which need not close"
        }
        PeriodicOutcome::NotFound => return no_periodic_words(periodic.followed.as_ref()),
    };
    let mut words = format!("Periodic motion: {found}");
    words += &periodic
        .followed
        .as_ref()
        .map_or_else(String::new, |followed| format!(", found {}", after(followed)));
    if let Some([re, im]) = periodic.multipliers.first() {
        words += &format!("; largest multiplier {:.6}", re.hypot(*im));
    }
    let short = match periodic.residual < CLOSED {
        true => String::new(),
        false => format!(", short of the {CLOSED:.0e} that is sought: what the errors of the steps leave"),
    };
    words
        + &format!(
            "; it closes to {:.1e} of each kind of state{short}, {} iterations.",
            periodic.residual, periodic.iterations
        )
}

/// What became of the engine where no periodic motion was found.
fn no_periodic_words(followed: Option<&Followed>) -> String {
    let Some(followed) = followed else {
        return "Periodic motion: not found; one period from the start is shown.".to_owned();
    };
    let [first, before, last] = followed.speeds;
    let rpm = |speed: f64| number::short(number::rpm(speed), 5);
    let step = last - before;
    if followed.came_to_rest {
        return format!(
            "Periodic motion: none found. From the start at {} rpm the engine comes to rest after {}: that run is shown.",
            rpm(first),
            match followed.periods {
                0 => "less than a period".to_owned(),
                1 => "one whole period".to_owned(),
                periods => format!("{periods} whole periods"),
            }
        );
    }
    let trend = match step.abs() > 1e-6 * last.abs() {
        true if step > 0.0 => format!("still rises by {} rpm a period", rpm(step)),
        true => format!("still falls by {} rpm a period", rpm(-step)),
        false => "no longer changes, but other parts of the motion do".to_owned(),
    };
    format!(
        "Periodic motion: none found. From the start at {} rpm the speed comes to {} rpm in {} periods, {} s, and {trend}: the next period is shown.",
        rpm(first),
        rpm(last),
        followed.periods,
        number::short(followed.time, 4)
    )
}

/// Why the starter does not turn the engine over.
fn stall_words(stall: &Stall) -> String {
    let torque = |value: f64| number::short(value, 4);
    let others = match stall.others < 0.0 {
        true => format!("gas, weight and driveline take {} N m", torque(-stall.others)),
        false => format!("gas, weight and driveline give {} N m more", torque(stall.others)),
    };
    format!(
        "The starter is too weak: the crank stalls at {} deg after {} s. There it gives {} N m at the crankshaft, {others}, friction and load hold with up to {} N m: to turn on, {} N m are \
         missing at the crankshaft, {} N m at the starter.",
        number::short(stall.theta.to_degrees(), 6),
        number::short(stall.time, 4),
        torque(stall.starter),
        torque(stall.held_by),
        torque(stall.missing),
        torque(stall.missing / stall.ratio),
    )
}

/// Since when the crank stands at the end of a run that went on, and what friction and load hold there.
fn stalled_words(run: &Run) -> Option<String> {
    let samples = &run.samples;
    let last = run
        .events
        .iter()
        .rev()
        .find(|event| matches!(event.what, Occasion::Held | Occasion::Released | Occasion::Reversed))?;
    let stands = last.what == Occasion::Held && run.end[2] == 0.0;
    if !stands || matches!(run.outcome, RunOutcome::AtRest { .. }) {
        return None;
    }
    let series = [&samples.gas_torque, &samples.starter_torque, &samples.driveline_torque];
    let torque: f64 = series.into_iter().filter_map(|values| values.last()).sum();
    Some(format!(
        "The crank stands from {} s on, at {} deg: what gas, starter and driveline give there, {} N m, friction and load hold.",
        number::short(last.time, 5),
        number::short(last.theta.to_degrees(), 6),
        number::short(torque, 4)
    ))
}

/// What the run must keep, and what it cost.
pub(crate) fn audit_words(run: &Run) -> String {
    let audit = &run.audit;
    format!(
        "Audit: energy {:.1e} of its throughput, loops {:.1e} m, quaternion {:.1e}. Cost: {} steps, {} rejected, {} evaluations.",
        audit.energy, audit.loops, audit.quaternion, run.cost.steps, run.cost.rejected, run.cost.evaluations
    ) + &tolerance_words(run)
}

/// Tolerances by kind of state.
fn tolerance_words(run: &Run) -> String {
    let t = &run.tolerances;
    let block = match run.samples.position.is_empty() {
        true => String::new(),
        false => format!(
            ", {:.1e} m, {:.1e} rad, {:.1e} m/s and {:.1e} rad/s of the block",
            t.displacement, t.turn, t.velocity, t.spin
        ),
    };
    format!(
        " Tolerances: relative {:.1e}; absolute {:.1e} rad and {:.1e} rad/s of crank and driveline{block}, {:.1e} J.",
        t.relative, t.angle, t.speed, t.energy
    )
}

/// Everything as plain text.
pub fn simulation_text(result: &SimulationResult) -> String {
    let gas = result.gas.as_ref().map_or("no gas".to_owned(), |gas| format!("gas: {gas}"));
    let mut out = format!("{}, simulated as rigid bodies, {gas}\n\n", result.engine);
    for words in simulation_words(result) {
        push_wrapped(&mut out, "", &words);
    }
    for table in simulation_tables(result) {
        out.push('\n');
        out.push_str(&table.text());
    }
    out.push('\n');
    push_wrapped(&mut out, "", &audit_words(&result.run));
    out
}

/// Speed, block, mounts, mains, energy, events.
pub fn simulation_tables(result: &SimulationResult) -> Vec<Table> {
    let mut tables = vec![speed_table(result)];
    tables.extend(extremes_table(result));
    tables.extend(block_tables(result));
    tables.extend(points_table(result));
    tables.extend(orders_table(result));
    tables.extend(joints_table(result));
    tables.extend(gears_table(result));
    tables.extend(driveline_table(result));
    tables.extend(mains_table(result));
    tables.push(energy_table(result));
    if !result.run.events.is_empty() {
        tables.push(events_table(result));
    }
    tables
}

fn speed_table(result: &SimulationResult) -> Table {
    let [most, least, mean] = result.speeds();
    let rpm = |speed: f64| Cell::number(number::rpm(speed), 7);
    let mut columns = vec![words("mean", "rpm"), words("highest", "rpm"), words("lowest", "rpm")];
    if least > 0.0 && mean > 0.0 {
        columns.push(words("fluctuation", "%"));
        let row = vec![rpm(mean), rpm(most), rpm(least), Cell::number(100.0 * (most - least) / mean, 4)];
        return table("simulated-speed", "Speed in the last period", "", columns, vec![row]);
    }
    // Of a crank that stands or turns back the last period says nothing.
    let samples = &result.run.samples;
    let bounds = result.run.extremes.speed;
    let (most, least) = (bounds.most.value, bounds.least.value);
    let mean = match (&samples.theta[..], &samples.time[..]) {
        ([first, .., last], [from, .., to]) if to > from => (last - first) / (to - from),
        _ => mean,
    };
    let note = "The crank comes to rest or turns back: its last period has no mean speed.";
    table(
        "simulated-speed",
        "Speed over the run",
        note,
        columns,
        vec![vec![rpm(mean), rpm(most), rpm(least)]],
    )
}

/// The block and its mounts, where it moves.
fn block_tables(result: &SimulationResult) -> Vec<Table> {
    let run = &result.run;
    if run.samples.position.is_empty() {
        return Vec::new();
    }
    let extremes = &result.period.extremes;
    let row = |(axis, (place, turn)): (&str, (&Bounds, &Bounds))| {
        let [least, most] = [place.least.value, place.most.value].map(|value| 1e3 * value);
        vec![
            Cell::text(axis),
            Cell::number(least, 5),
            Cell::number(most, 5),
            Cell::number(most - least, 4),
            Cell::number(1e3 * (turn.most.value - turn.least.value), 4),
        ]
    };
    let columns = vec![
        words("axis", ""),
        words("least", "mm"),
        words("most", "mm"),
        words("orbit", "mm"),
        words("turn", "mrad"),
    ];
    let title = "Block in the last period: its origin, and its turn about each axis";
    let rows =
        ["x", "y", "z"].into_iter().zip(extremes.position.iter().zip(&extremes.turn)).map(row).collect();
    let mut tables = vec![table("simulated-block", title, "", columns, rows)];
    if !result.mounts.is_empty() {
        let whole = &run.extremes.mounts;
        let is_more = *whole != extremes.mounts;
        let rows =
            result.mounts.iter().zip(extremes.mounts.iter().zip(whole)).map(|(name, (last, whole))| {
                let mut row = vec![Cell::text(name), Cell::number(last.value, 5)];
                if is_more {
                    row.push(Cell::number(whole.value, 5));
                    row.push(Cell::number(whole.time, 5));
                }
                row
            });
        let mut columns = vec![words("mount", ""), words("last period", "N")];
        if is_more {
            columns.extend([words("whole run", "N"), words("at time", "s")]);
        }
        tables.push(table("simulated-mounts", "Mounts: largest force", "", columns, rows.collect()));
    }
    tables
}

fn mains_table(result: &SimulationResult) -> Option<Table> {
    let mains = result.mains();
    if result.run.samples.reactions.is_empty() || mains.is_empty() {
        return None;
    }
    let rows = mains.into_iter().map(|(shaft, main, z, loads)| {
        let [low, high] = [f64::min, f64::max].map(|pick| loads.into_iter().reduce(pick).unwrap_or(0.0));
        let mut row = vec![Cell::text(format!("{shaft}.{main}")), Cell::number(1e3 * z, 4)];
        row.extend(loads.map(|load| Cell::number(load, 5)));
        row.push(Cell::number(high - low, 3));
        row
    });
    let mut columns = vec![words("main", ""), words("z", "mm")];
    columns.extend(MainRule::ALL.map(|rule| words(rule.name(), "N")));
    columns.push(words("spread", "N"));
    let note = "Rigid bodies leave the loads of more than two bearings open: each rule is one answer, their spread is what is not known.";
    let title = "Main bearings: largest load in the last period by three rules";
    Some(table("simulated-mains", title, note, columns, rows.collect()))
}

/// The events.
fn events_table(result: &SimulationResult) -> Table {
    let run = &result.run;
    let rows = run.events.iter().map(|event| {
        vec![
            Cell::text(occasion_words(event.what, &result.actions)),
            Cell::number(event.time, 6),
            Cell::number(event.theta.to_degrees(), 7),
            Cell::number(number::rpm(event.speed), 5),
        ]
    });
    let columns =
        vec![words("event", ""), words("time", "s"), words("crank angle", "deg"), words("speed", "rpm")];
    table("simulated-events", "Events", "", columns, rows.collect())
}
