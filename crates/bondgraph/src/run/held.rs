//! What is held between two events: on which side each condition is, which laws of dry friction stick, and between which kinks each curve is read.

use crate::curve::Curve;
use crate::expression::{Id, Pool};
use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

/// The conditions and the arguments of curves within expressions, as they are found while tapes are compiled.
#[derive(Debug, Clone, Default)]
pub(crate) struct Switches {
    /// Functions of conditions: on where positive.
    pub(crate) functions: Vec<Id>,
    /// Those whose `sign` a law takes, rising.
    pub(crate) signs: BTreeSet<u32>,
    /// Curves with their arguments.
    pub(crate) slots: Vec<(u32, Id)>,
    places: HashMap<Id, u32>,
    slot_places: HashMap<(u32, Id), u32>,
}

impl Switches {
    pub(crate) fn of(&mut self, id: Id) -> u32 {
        let next = self.functions.len() as u32;
        let functions = &mut self.functions;
        *self.places.entry(id).or_insert_with(|| {
            functions.push(id);
            next
        })
    }

    /// The place of a condition whose sign is taken.
    pub(crate) fn of_sign(&mut self, id: Id) -> u32 {
        let place = self.of(id);
        self.signs.insert(place);
        place
    }

    pub(crate) fn slot(&mut self, curve: u32, argument: Id) -> u32 {
        let next = self.slots.len() as u32;
        let slots = &mut self.slots;
        *self.slot_places.entry((curve, argument)).or_insert_with(|| {
            slots.push((curve, argument));
            next
        })
    }

    /// Functions, then arguments of curves.
    pub(crate) fn all(&self) -> Vec<Id> {
        self.functions.iter().copied().chain(self.slots.iter().map(|(_, argument)| *argument)).collect()
    }
}

/// The window of one curve.
#[derive(Debug, Clone)]
struct Slot {
    curve: Arc<Curve>,
    window: [f64; 2],
    /// Signs of the two event functions: each turns over with its event, so that the integrator's view of the sign stays right.
    signs: [f64; 2],
}

/// The state of conditions and curves.
#[derive(Debug, Clone, Default)]
pub(crate) struct Held {
    pub(crate) on: Vec<bool>,
    /// The sign of each condition's function: 1 or -1 but for those that stick, between -1 and 1 there.
    pub(crate) signs: Vec<f64>,
    /// Conditions whose function stays 0 because both sides lead back to it.
    pub(crate) stuck: Vec<usize>,
    /// What each function had when it last gave way: from there its next change of sign counts.
    shifts: Vec<f64>,
    slots: Vec<Slot>,
}

impl Held {
    pub(crate) fn new(switches: &Switches, pool: &Pool) -> Held {
        let everywhere = [f64::NEG_INFINITY, f64::INFINITY];
        let slot = |(curve, _): &(u32, Id)| Slot {
            curve: Arc::clone(&pool.curves[*curve as usize].1),
            window: everywhere,
            signs: [1.0; 2],
        };
        let count = switches.functions.len();
        Held {
            on: vec![false; count],
            signs: vec![-1.0; count],
            stuck: Vec::new(),
            shifts: vec![0.0; count],
            slots: switches.slots.iter().map(slot).collect(),
        }
    }

    /// Value of a curve or its derivative.
    pub(crate) fn curve(&self, slot: u32, x: f64, derivative: u8) -> f64 {
        let slot = &self.slots[slot as usize];
        slot.curve.within(x, slot.window, derivative)
    }

    /// Conditions and arguments of curves.
    pub(crate) fn quantities(&self) -> usize {
        self.on.len() + self.slots.len()
    }

    /// Number of event functions: one a condition, two a curve.
    pub(crate) fn events(&self) -> usize {
        self.on.len() + 2 * self.slots.len()
    }

    /// Event functions from the values of conditions and arguments.
    pub(crate) fn event_functions(&self, quantities: &[f64], values: &mut [f64]) {
        let count = self.on.len();
        for (value, (function, shift)) in values.iter_mut().zip(quantities[..count].iter().zip(&self.shifts))
        {
            *value = function - shift;
        }
        // What sticks gives way where its sign comes to 1 or -1.
        for index in &self.stuck {
            values[*index] = 1.0 - self.signs[*index] * self.signs[*index];
        }
        for (index, slot) in self.slots.iter().enumerate() {
            let x = quantities[count + index];
            let [low, high] = slot.window;
            // A hair below the lower kink, so that an event at the upper one leaves no doubt about it.
            let hair = 1e-9 * (high - low);
            let distances = if hair.is_finite() { [x - low + hair, high - x] } else { [x - low, high - x] };
            for (side, distance) in distances.into_iter().enumerate() {
                let distance = if distance.is_infinite() { 1.0 } else { distance };
                values[count + 2 * index + side] = slot.signs[side] * distance;
            }
        }
    }

    /// Whether an event is that of a condition.
    pub(crate) fn is_condition(&self, event: usize) -> bool {
        event < self.on.len()
    }

    /// What follows from an event.
    pub(crate) fn happen(&mut self, event: usize, rising: bool) {
        match event.checked_sub(self.on.len()) {
            None => self.turn(event, rising),
            Some(rest) => {
                let slot = &mut self.slots[rest / 2];
                slot.window = slot.curve.neighbour(slot.window, rest % 2 == 1);
                slot.signs[rest % 2] *= -1.0;
            }
        }
    }

    /// Puts a condition on one side.
    pub(crate) fn turn(&mut self, condition: usize, on: bool) {
        self.on[condition] = on;
        self.signs[condition] = if on { 1.0 } else { -1.0 };
        self.shifts[condition] = 0.0;
    }

    /// Lets a condition stick.
    pub(crate) fn stick(&mut self, condition: usize) {
        self.stuck.push(condition);
        self.signs[condition] = 0.0;
    }

    /// Lets a condition that stuck go to the side of its sign; `function` is what its function has there.
    pub(crate) fn give_way(&mut self, condition: usize, function: f64) {
        self.stuck.retain(|own| *own != condition);
        self.turn(condition, self.signs[condition] > 0.0);
        self.shifts[condition] = function;
    }

    /// Takes conditions and windows as they are at these values; forgets what happened before.
    pub(crate) fn settle(&mut self, quantities: &[f64]) {
        let count = self.on.len();
        self.stuck.clear();
        for (index, value) in quantities[..count].iter().enumerate() {
            self.turn(index, *value > 0.0);
        }
        for (slot, x) in self.slots.iter_mut().zip(&quantities[count..]) {
            slot.window = slot.curve.window(*x);
            slot.signs = [1.0; 2];
        }
    }
}
