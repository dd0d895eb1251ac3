//! Dry friction that sticks: a law with `sign(g)` where both sides lead back to g = 0.
//!
//! ```text
//! g' = dg/dt + sum dg/dx x'(s) = 0        -1 < s < 1
//! ```
//! | symbol | name                                                          |
//! |--------|---------------------------------------------------------------|
//! | g      | what the sign is taken of: the speed of a contact             |
//! | s      | value of the sign by which g stays 0: the share of the largest friction |
//!
//! Several that stick at a time are solved together; where they share one motion, each takes a share (least squares). What needs more than its
//! friction gives way: s comes to 1 or -1. A.F. Filippov, *Differential Equations with Discontinuous Righthand Sides*, 1988, section 4.

use crate::expression::{Pool, Var};
use crate::run::held::Switches;
use crate::run::tape::Tape;

/// The slope of a function: by which state (`None`: the time), and its place on the tape.
pub(crate) type Slope = (Option<usize>, usize);

/// The functions that can stick, with their slopes.
#[derive(Debug, Clone)]
pub(crate) struct Sticking {
    /// Of each: its condition and its slopes.
    candidates: Vec<(usize, Vec<Slope>)>,
    pub(crate) slopes: Tape,
    /// Values of the slopes at the last place.
    pub(crate) values: Vec<f64>,
}

impl Sticking {
    /// Of the conditions whose signs laws take; functions that hang on unknowns of loops have no slope here, and cannot stick.
    pub(crate) fn new(pool: &mut Pool, input: &impl Fn(Var) -> u32, switches: &mut Switches) -> Sticking {
        let (mut candidates, mut outputs) = (Vec::new(), Vec::new());
        for condition in switches.signs.iter().copied() {
            let function = switches.functions[condition as usize];
            let variables = pool.variables(&[function]);
            if variables.iter().any(|var| !matches!(var, Var::State(_) | Var::Time)) {
                continue;
            }
            let slopes = variables.into_iter().map(|var| {
                outputs.push(pool.derivative(function, var, &mut Default::default()));
                let state = if let Var::State(state) = var { Some(state as usize) } else { None };
                (state, outputs.len() - 1)
            });
            candidates.push((condition as usize, slopes.collect()));
        }
        let slopes = Tape::new(pool, &outputs, input, switches);
        Sticking { candidates, slopes, values: vec![0.0; outputs.len()] }
    }

    /// Slopes of the function of a condition; `None` where it cannot stick.
    pub(crate) fn slopes_of(&self, condition: usize) -> Option<&[Slope]> {
        let found = self.candidates.iter().find(|(own, _)| *own == condition);
        found.map(|(_, slopes)| slopes.as_slice())
    }
}
