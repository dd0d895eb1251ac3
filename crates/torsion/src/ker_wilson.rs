//! Torsional stiffness of a crankshaft from the sizes of its elements, by Ker Wilson's equivalent length.
//!
//! ```text
//! L_e/D^4 = (L_j + 0.4 D_j)/(D_j^4 - d_j^4) + (L_p + 0.4 D_p)/(D_p^4 - d_p^4) + (r - 0.2 (D_j + D_p))/(L_w B^3),
//! k = pi G / (32 (L_e/D^4))                                                                                                    (50.14)
//! ```
//! for a throw between the middles of its journals. Here each element gives its own part, so that pieces between any two planes follow: a journal or pin
//! its length and 0.2 of its diameter for each end at a web, a web half of the last term.
//!
//! Source: Ker Wilson, "Practical Solution of Torsional Vibration Problems", vol. 1, 3rd ed. (1956). Within some 10 % of finite elements.

use crate::chain::ShaftSection;
use lanchester_model::{CrankElement, CrankElementForm, Disc, RoundBar};
use std::f64::consts::PI;

/// What an element adds to `L_e/D^4` [1/m^3]; webs know the sizes beside them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementFlexibility {
    /// Index in the list of elements.
    pub element: usize,
    /// Its part of `L_e/D^4` [1/m^3].
    pub value: f64,
    /// Whether the web's term came out negative and counts as 0: its pins overlap more than the formula knows.
    pub is_clipped: bool,
}

/// Parts of `L_e/D^4` of all elements of a crankshaft, in their order.
pub fn flexibilities(elements: &[CrankElement]) -> Vec<ElementFlexibility> {
    let is_web = |index: Option<usize>| {
        index
            .and_then(|index| elements.get(index))
            .is_some_and(|element| matches!(element.form, CrankElementForm::Web { .. }))
    };
    let beside = |index: usize, step: isize| -> Option<&RoundBar> {
        let mut at = index;
        // Past the other half of a shared web.
        loop {
            at = at.checked_add_signed(step)?;
            match elements.get(at)?.bar() {
                Some(bar) => return Some(bar),
                None => continue,
            }
        }
    };
    let of = |(index, element): (usize, &CrankElement)| {
        let (value, is_clipped) = match &element.form {
            CrankElementForm::Web { discs, .. } => {
                let diameters = [-1, 1].map(|step| beside(index, step).map_or(0.0, |bar| bar.diameter));
                web(element.length(), *discs, diameters)
            }
            _ => {
                let bar = element.bar().copied();
                let joints =
                    [index.checked_sub(1), Some(index + 1)].into_iter().filter(|at| is_web(*at)).count();
                (bar.map_or(0.0, |bar| round(element.length(), &bar, joints)), false)
            }
        };
        ElementFlexibility { element: index, value, is_clipped }
    };
    elements.iter().enumerate().map(of).collect()
}

fn round(length: f64, bar: &RoundBar, joints: usize) -> f64 {
    (length + 0.2 * joints as f64 * bar.diameter) / (bar.diameter.powi(4) - bar.bore.powi(4))
}

/// Half of the last term of (50.14): `r` is the distance of the middles of the two discs that the web joins.
fn web(thickness: f64, discs: [Disc; 2], diameters: [f64; 2]) -> (f64, bool) {
    let apart = (discs[1].centre - discs[0].centre).norm();
    let width = middle_width(discs, apart);
    let arm = apart - 0.2 * (diameters[0] + diameters[1]);
    (0.5 * arm.max(0.0) / (thickness * width.powi(3)), arm < 0.0)
}

/// Width of the hull of two discs midway between their middles.
fn middle_width(discs: [Disc; 2], apart: f64) -> f64 {
    let [one, two] = discs.map(|disc| disc.radius);
    let slope = if apart > 0.0 { ((one - two) / apart).clamp(-0.999, 0.999) } else { 0.0 };
    (one + two) / (1.0 - slope * slope).sqrt()
}

/// Stiffness of a piece [N m/rad] whose parts of `L_e/D^4` add up to `flexibility` [1/m^3], of a material of this shear modulus [Pa].
pub fn stiffness(flexibility: f64, shear_modulus: f64) -> f64 {
    PI * shear_modulus / (32.0 * flexibility)
}

/// The weakest in torsion of the journals and pins among these elements.
pub fn weakest<'a>(elements: impl Iterator<Item = &'a CrankElement>) -> Option<ShaftSection> {
    let sections = elements
        .filter_map(CrankElement::bar)
        .map(|bar| ShaftSection { diameter: bar.diameter, bore: bar.bore });
    sections.min_by(|a, b| a.modulus().total_cmp(&b.modulus()))
}
