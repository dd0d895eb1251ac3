//! The bobweight sheet: the mass that stands for rods and pistons on each crankpin while the crank is balanced.
//!
//! ```text
//! m_bob = q SUM ( big end + bearing ) + q oil  +  f SUM ( small end + piston + pin + rings + locks )
//! ```
//! | symbol | name                                        | unit |
//! |--------|---------------------------------------------|------|
//! | q      | share of the rotating masses, usually 100 % | 1    |
//! | f      | share of the reciprocating masses           | 1    |
//!
//! The sums run over the rods on the pin. Which `f` is right is not a matter of taste: see [`crate::FactorEffect`].

use crate::error::WorkshopError;
use lanchester_task::workshop::{BobweightSheet, CylinderParts, PinParts};
use serde::Serialize;

/// The bobweight of one pin.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Bobweight {
    /// Name of the pin.
    pub pin: String,
    /// Number of its throw in the engine file.
    pub throw: Option<usize>,
    /// Rods on the pin.
    pub rods: usize,
    /// Rotating mass of the rods [kg], without the oil.
    pub rotating: f64,
    /// Oil [kg].
    pub oil: f64,
    /// Reciprocating mass of all rods [kg].
    pub reciprocating: f64,
    /// The bobweight [kg].
    pub mass: f64,
}

/// The bobweight of every pin, with the share `reciprocating_share` of the reciprocating masses (the sheet's own, or
/// the one that it was left open for).
///
/// # Errors
/// [`WorkshopError`] for a mass or share that is not finite or is negative, a pin without rods, or a bobweight of 0.
pub fn bobweights(sheet: &BobweightSheet, reciprocating_share: f64) -> Result<Vec<Bobweight>, WorkshopError> {
    share("share of the rotating masses", sheet.rotating_share)?;
    share("share of the reciprocating masses", reciprocating_share)?;
    sheet.pins.iter().map(|pin| bobweight([sheet.rotating_share, reciprocating_share], pin)).collect()
}

fn share(quantity: &'static str, got: f64) -> Result<(), WorkshopError> {
    if (0.0..=2.0).contains(&got) {
        return Ok(());
    }
    Err(WorkshopError::Number {
        quantity,
        part: "the sheet".into(),
        needed: "from 0 to 2".into(),
        got,
        hint: "a share is written \"50 %\" or 0.5",
    })
}

fn bobweight(shares: [f64; 2], pin: &PinParts) -> Result<Bobweight, WorkshopError> {
    let oil = [("oil", pin.oil)];
    let masses = pin.cylinders.iter().flat_map(CylinderParts::list).chain(oil);
    for (what, got) in masses {
        if !(got >= 0.0 && got.is_finite()) {
            return Err(WorkshopError::Number {
                quantity: "mass [kg]",
                part: format!("{what} of {}", pin.name),
                needed: "finite and not negative".into(),
                got,
                hint: "weigh it again",
            });
        }
    }
    let rotating: f64 = pin.cylinders.iter().map(CylinderParts::rotating).sum();
    let reciprocating: f64 = pin.cylinders.iter().map(CylinderParts::reciprocating).sum();
    let mass = shares[0] * (rotating + pin.oil) + shares[1] * reciprocating;
    if mass <= 0.0 {
        return Err(WorkshopError::Impossible {
            what: format!(
                "{} needs at least one rod with a mass, got {} rods",
                pin.name,
                pin.cylinders.len()
            ),
            hint: "give the weighed parts of every rod on the pin",
        });
    }
    Ok(Bobweight {
        pin: pin.name.clone(),
        throw: pin.throw,
        rods: pin.cylinders.len(),
        rotating,
        oil: pin.oil,
        reciprocating,
        mass,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sheet(parts: CylinderParts, rods: usize, oil: f64) -> BobweightSheet {
        let pin = PinParts { name: "pin 1".into(), throw: None, oil, cylinders: vec![parts; rods] };
        BobweightSheet {
            rotating_share: 1.0,
            reciprocating_share: None,
            bank_angle: None,
            split_angle: 0.0,
            pins: vec![pin],
        }
    }

    const PARTS: CylinderParts = CylinderParts {
        big_end: 0.4596,
        bearing: 0.0474,
        small_end: 0.1624,
        piston: 0.5839,
        piston_pin: 0.1736,
        rings: 0.0695,
        locks: 0.0048,
    };

    /// By hand: 2 (459.6 + 47.4) + 4 = 1018.0 g rotating; 162.4 + 583.9 + 173.6 + 69.5 + 4.8 = 994.2 g a cylinder,
    /// half of two of them 994.2 g; together 2012.2 g.
    #[test]
    fn v8_pin_by_hand() {
        let bob = bobweights(&sheet(PARTS, 2, 0.004), 0.5).unwrap().remove(0);
        assert!((bob.rotating - 1.014).abs() < 1e-15);
        assert!((bob.reciprocating - 1.9884).abs() < 1e-15);
        assert!((bob.mass - 2.0122).abs() < 1e-15, "{}", bob.mass);
    }

    /// FordMuscle (J. Mikelonis), "Rotating Assembly", April 2008, table "Rotating Weight - Ford 400 Build": big end
    /// 621.5 g, bearing 45 g, 666.5 g together, times two rods 1333 g; piston and pin weigh 639.5 g. Rings and small
    /// end are invented (60 and 195 g): half of 2 * 894.5 g comes on top.
    #[test]
    fn lit_fordmuscle_2008_rotating_weight() {
        let parts = CylinderParts {
            big_end: 0.6215,
            bearing: 0.045,
            piston: 0.6395,
            rings: 0.060,
            small_end: 0.195,
            ..CylinderParts::default()
        };
        let bob = bobweights(&sheet(parts, 2, 0.0), 0.5).unwrap().remove(0);
        assert!((parts.rotating() - 0.6665).abs() < 1e-15);
        // Printed in whole grams.
        assert!((bob.rotating - 1.333).abs() < 1e-12);
        assert!((bob.mass - (1.333 + 0.8945)).abs() < 1e-12);
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let refused = |sheet: &BobweightSheet| bobweights(sheet, 0.5).unwrap_err().to_string();
        let percent = bobweights(&sheet(PARTS, 1, 0.0), 50.0).unwrap_err().to_string();
        assert!(percent.contains("from 0 to 2, got 50"));
        let bad = sheet(CylinderParts { rings: -0.001, ..PARTS }, 1, 0.0);
        assert!(refused(&bad).starts_with("mass [kg] of rings of pin 1 must be finite and not negative"));
        assert!(refused(&sheet(PARTS, 0, 0.0)).contains("got 0 rods"));
    }

    proptest! {
        /// Two rods with half the parts each are one rod with all of them.
        #[test]
        fn prop_parts_add_up(big in 0.1f64..1.0, piston in 0.1f64..1.0, f in 0.0f64..1.0) {
            let parts = CylinderParts { big_end: big, piston, ..PARTS };
            let half = CylinderParts {
                big_end: big / 2.0, bearing: PARTS.bearing / 2.0, small_end: PARTS.small_end / 2.0,
                piston: piston / 2.0, piston_pin: PARTS.piston_pin / 2.0, rings: PARTS.rings / 2.0,
                locks: PARTS.locks / 2.0,
            };
            let (one, two) = (sheet(parts, 1, 0.002), sheet(half, 2, 0.002));
            let (one, two) = (bobweights(&one, f).unwrap(), bobweights(&two, f).unwrap());
            prop_assert!((one[0].mass - two[0].mass).abs() < 1e-14);
        }
    }
}
