//! Why parts make no valid engine.

use serde::Serialize;
use std::collections::HashMap;
use std::fmt;

/// Something about the parts that no engine has: which number, what it must be and what it is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fault {
    /// Which part, as it is written in code, counted from 0: `cylinders[2].rod`.
    pub part: String,
    /// Which of its numbers: `length [m]`.
    pub quantity: &'static str,
    /// What it must be.
    pub needed: String,
    /// What it is.
    pub got: String,
    /// What to do.
    pub remedy: &'static str,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Fault { part, quantity, needed, got, remedy } = self;
        write!(f, "{part}: {quantity} must be {needed}, got {got}\nhint: {remedy}")
    }
}

impl std::error::Error for Fault {}

impl Fault {
    /// The first of several, for an error that has room for one.
    ///
    /// # Panics
    /// Where there is none: [`crate::Engine::new`] never refuses parts without a fault.
    pub fn first_of(mut faults: Vec<Fault>) -> Fault {
        faults.swap_remove(0)
    }
}

/// The faults of one part as they are found.
pub(crate) struct Part<'a> {
    pub faults: &'a mut Vec<Fault>,
    /// Its name, made only where it is needed.
    pub name: &'a dyn Fn() -> String,
}

impl Part<'_> {
    pub fn add(
        &mut self,
        quantity: &'static str,
        needed: impl Into<String>,
        got: impl ToString,
        remedy: &'static str,
    ) {
        let (part, needed, got) = ((self.name)(), needed.into(), got.to_string());
        self.faults.push(Fault { part, quantity, needed, got, remedy });
    }

    fn within(&mut self, quantity: &'static str, value: f64, is_right: bool, needed: &'static str) {
        if !is_right || !value.is_finite() {
            self.add(quantity, needed, value, "give the number in the unit named");
        }
    }

    /// Any number.
    pub fn finite(&mut self, quantity: &'static str, value: f64) {
        self.within(quantity, value, true, "a finite number");
    }

    /// 0 or more.
    pub fn not_negative(&mut self, quantity: &'static str, value: f64) {
        self.within(quantity, value, value >= 0.0, "0 or more");
    }

    /// More than 0.
    pub fn positive(&mut self, quantity: &'static str, value: f64) {
        self.within(quantity, value, value > 0.0, "more than 0");
    }

    /// The place of something in a list; whether it is there.
    pub fn index(&mut self, quantity: &'static str, index: usize, count: usize) -> bool {
        if index >= count {
            let needed = if count == 0 { "one of none".into() } else { format!("from 0 to {}", count - 1) };
            self.add(quantity, needed, index, "add the part that is meant, or name another");
        }
        index < count
    }
}

/// Refuses names that two parts of a kind have: people and files tell them apart by it.
pub(crate) fn unique<'a>(kind: &'static str, names: impl Iterator<Item = &'a str>, faults: &mut Vec<Fault>) {
    let mut known: HashMap<&str, usize> = HashMap::new();
    for (index, name) in names.enumerate() {
        if let Some(first) = known.get(name) {
            faults.push(Fault {
                part: format!("{kind}[{index}]"),
                quantity: "name",
                needed: format!("another than that of {kind}[{first}]"),
                got: format!("\"{name}\""),
                remedy: "give each its own name",
            });
        } else {
            known.insert(name, index);
        }
    }
}
