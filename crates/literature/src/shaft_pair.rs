//! The pair of balance shafts of one order: one turns with the crank, one against it.

use crate::basis::Basis;
use crate::matrices::Matrix;
use crate::resultant::{OrderResultant, Resultant, Scale};
use lanchester_model::{BalanceShaft, EngineParts, Ratio, ShaftWeight};
use serde::Serialize;

/// A pair of shafts of one order, one with the crank and one against it, at the height of the crank axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftPair {
    /// `r_c1`, `r_c2`: distance of a weight's centre of gravity from its shaft's axis [m].
    pub radius: f64,
    /// `l_sh`: distance of the outer weights [m].
    pub length: f64,
    /// `L_sh,r`: y of the shaft that turns with the crank [m].
    pub forward_y: f64,
    /// `L_sh,cr`: y of the shaft that turns against it [m].
    pub backward_y: f64,
}

/// A shaft that was fitted, or the reason why none is needed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShaftOrder {
    /// What the pistons have of this order, with `c_2 = r/l`.
    pub pistons: OrderResultant,
    /// Whether the force (one weight a shaft) or the couple (two weights) is cancelled.
    pub basis: Basis,
    /// Mass of each weight on the shaft that turns with the crank [kg]; 0: no such shaft.
    pub forward_mass: f64,
    /// Mass of each weight on the shaft that turns against it [kg]; 0: no such shaft.
    pub backward_mass: f64,
}

impl ShaftPair {
    /// Adds the shafts that cancel `wanted`; one weight in the middle against a force, two at the ends against a couple.
    pub(crate) fn fit(
        &self,
        order: i32,
        wanted: OrderResultant,
        scale: &Scale,
        engine: &mut EngineParts,
        columns: (&mut Matrix, &mut Matrix),
    ) -> ShaftOrder {
        let force = [wanted.forward, wanted.backward].iter().any(|r| r.force.norm() > scale.force);
        let couple = [wanted.forward, wanted.backward].iter().any(|r| r.moment.norm() > scale.moment);
        let basis = match (force, couple) {
            (true, _) => Basis::Force,
            (false, true) => Basis::Couple,
            (false, false) => Basis::Nothing,
        };
        let mut add = |sense: i32, resultant: Resultant, y: f64, matrix: &mut Matrix| -> f64 {
            let half = 0.5 * self.length;
            let unbalances = match basis {
                Basis::Force => vec![(0.0, -resultant.force)],
                Basis::Couple => {
                    vec![(-half, resultant.moment / self.length), (half, -resultant.moment / self.length)]
                }
                _ => Vec::new(),
            };
            let largest = unbalances.iter().fold(0.0f64, |m, (_, u)| m.max(u.norm()));
            if largest <= scale.force.min(scale.moment / half) {
                return 0.0;
            }
            for &(z, unbalance) in &unbalances {
                matrix.push(unbalance.arg(), z);
            }
            engine.shafts.push(BalanceShaft {
                name: shaft_name(order, sense),
                ratio: Ratio::whole(sense * order).expect("invariant: an order is not 0"),
                x: 0.0,
                y,
                weights: unbalances
                    .into_iter()
                    .map(|(z, u)| ShaftWeight::new(z, u.norm(), u.arg()))
                    .collect(),
                inertia: None,
            });
            largest / self.radius
        };
        let forward_mass = add(1, wanted.forward, self.forward_y, columns.0);
        let backward_mass = add(-1, wanted.backward, self.backward_y, columns.1);
        ShaftOrder { pistons: wanted, basis, forward_mass, backward_mass }
    }
}

/// Name of a shaft by order and sense.
pub(crate) fn shaft_name(order: i32, sense: i32) -> String {
    let number = if order == 1 { "first" } else { "second" };
    format!("{number} order {} the crank", if sense > 0 { "with" } else { "against" })
}
