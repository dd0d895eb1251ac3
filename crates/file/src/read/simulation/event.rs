//! `[[simulation.event]]`: when something happens, and what.

use crate::document::Section;
use crate::read::reader::Reader;
use crate::read::simulation::revolutions;
use lanchester_diagnostic::Mistake;
use lanchester_model::{Action, Event, LoadLaw, When};
use lanchester_task::option;
use lanchester_units::{Bound, Dimension, Refusal, within};
use std::f64::consts::TAU;

/// What is wrong, and what to write instead.
type Refused = (String, String);

/// An event from the words that `when` and `do` of `[[simulation.event]]` take, for an engine with that many cylinders.
///
/// # Errors
/// What is wrong, and what to write instead.
pub fn event_from_words(when: &str, action: &str, cylinders: usize) -> Result<Event, (String, String)> {
    Ok(Event { when: when_of(when.trim())?, action: action_of(action.trim(), Some(cylinders))? })
}

impl<'a> Reader<'a> {
    pub(in crate::read) fn events(
        &mut self,
        section: &'a Section,
        cylinders: Option<usize>,
    ) -> Option<Vec<Event>> {
        let tables = section.tables("event").or(&[])?;
        let mut events = Vec::new();
        let mut is_good = true;
        for table in tables {
            let when = self.required(table, "when", table.text("when"));
            let action = self.required(table, "do", table.text("do"));
            let when = when.map(|text| when_of(text.trim()));
            let action = action.map(|text| action_of(text.trim(), cylinders));
            if let Some(Err((message, hint))) = &when {
                self.mistakes.push(Mistake::error("E1801", table.value_span("when"), message).hint(hint));
            }
            if let Some(Err((message, hint))) = &action {
                self.mistakes.push(Mistake::error("E1802", table.value_span("do"), message).hint(hint));
            }
            match (when, action) {
                (Some(Ok(when)), Some(Ok(action))) => events.push(Event { when, action }),
                _ => is_good = false,
            }
        }
        is_good.then_some(events)
    }
}

/// A quantity of 0 or more, or nothing.
fn amount(text: &str, dimension: Dimension, bound: Bound) -> Result<f64, Refusal> {
    lanchester_units::parse(text, dimension, "when")
        .and_then(|value| within(value, dimension, bound, "when", text, None))
}

/// `2 s`, `90 deg`, `3 revolutions`, `speed falls to 900 rpm`.
fn when_of(text: &str) -> Result<When, Refused> {
    let refused = || {
        (
            format!("\"{text}\" is no moment of a run"),
            "write a time, an angle, \"3 revolutions\", \"speed falls to 900 rpm\" or \"speed rises to 900 rpm\""
                .to_string(),
        )
    };
    let speed = |text: &str| amount(text, Dimension::Speed, Bound::Positive).map_err(|_| refused());
    if let Some(rest) = text.strip_prefix("speed falls to ") {
        return speed(rest).map(When::SpeedFalls);
    }
    if let Some(rest) = text.strip_prefix("speed rises to ") {
        return speed(rest).map(When::SpeedRises);
    }
    if let Some(turns) = revolutions(text) {
        return (turns >= 0.0).then_some(When::Angle(TAU * turns)).ok_or_else(refused);
    }
    let time = amount(text, Dimension::Time, Bound::NotNegative).map(When::Time);
    time.or_else(|_| amount(text, Dimension::Angle, Bound::NotNegative).map(When::Angle))
        .map_err(|_| refused())
}

/// `misfire 3`, `fuel 0 %`, `load 120 N m`, `clutch open`, `stop`.
fn action_of(text: &str, cylinders: Option<usize>) -> Result<Action, Refused> {
    let refused = || {
        (
            format!("\"{text}\" is nothing that can happen in a run"),
            "write \"misfire 3\", \"fuel 0 %\", \"load 120 N m\", \"load none\", \"clutch open\" or \"stop\""
                .to_string(),
        )
    };
    match text {
        "clutch open" => return Ok(Action::ClutchOpen),
        "stop" => return Ok(Action::Stop),
        "load none" => return Ok(Action::Load(LoadLaw::None)),
        _ => {}
    }
    let (word, rest) = text.split_once(' ').ok_or_else(refused)?;
    match word {
        "misfire" => {
            let number = rest.trim().parse::<usize>().map_err(|_| refused())?;
            let most = cylinders.unwrap_or(usize::MAX);
            if number == 0 || number > most {
                let message = format!("there is no cylinder {number} to misfire");
                return Err((message, format!("cylinders have numbers from 1 to {most}")));
            }
            Ok(Action::Misfire(number - 1))
        }
        "fuel" => {
            let share = option::share(rest.trim(), "fuel").map_err(|_| refused())?;
            (share <= 1.0).then_some(Action::Fuel(share)).ok_or_else(refused)
        }
        "load" => amount(rest.trim(), Dimension::Torque, Bound::NotNegative)
            .map(|torque| Action::Load(LoadLaw::Constant(torque)))
            .map_err(|_| refused()),
        _ => Err(refused()),
    }
}
