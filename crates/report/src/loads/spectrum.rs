//! The two-sided order spectrum: what turns with the crank and what turns against it.

use crate::kit::figure::Figure;
use crate::kit::magnitude::Magnitude;
use crate::kit::plot::{Bar, BarPlot};
use lanchester_mechanism::Loads;
use lanchester_results::OrderLoads;

/// Force by order, against the crank to the left, with it to the right.
pub fn force_spectrum(loads: &Loads) -> Figure {
    let noise = Magnitude::of(loads).force_noise();
    let bars = two_sided(&loads.total.orders, |o| o.force_forward.norm(), |o| o.force_backward.norm());
    let plot = BarPlot { quantity: "Force amplitude", unit: "N", bars, noise, two_sided: true };
    Figure {
        id: "force-spectrum".to_owned(),
        title: "Force by order, forward and backward".to_owned(),
        caption: "Every shaking force is a sum of arrows that turn at a whole or fractional multiple of the crank's speed, \
                  with the crank (right) or against it (left). Weights on the crank can remove only order 1 with the crank; \
                  any other bar needs a shaft of that speed and sense."
            .to_owned(),
        panels: vec![plot.panel()],
        columns: 1,
    }
}

/// Couple by order, against the crank to the left, with it to the right.
pub fn couple_spectrum(loads: &Loads) -> Figure {
    let noise = Magnitude::of(loads).couple_noise();
    let bars = two_sided(&loads.total.orders, |o| o.couple_forward.norm(), |o| o.couple_backward.norm());
    let plot = BarPlot { quantity: "Couple amplitude", unit: "N m", bars, noise, two_sided: true };
    Figure {
        id: "couple-spectrum".to_owned(),
        title: "Couple by order, forward and backward".to_owned(),
        caption: "The rocking couple about the reference point, split in the same way. A couple needs weights in two planes."
            .to_owned(),
        panels: vec![plot.panel()],
        columns: 1,
    }
}

/// Roll moment by order; about the crank axis there is no sense of rotation.
pub fn roll_spectrum(loads: &Loads) -> Figure {
    let noise = Magnitude::of(loads).roll_noise();
    let bars = loads
        .total
        .orders
        .iter()
        .map(|o| Bar { at: o.order, value: o.roll_moment.norm() })
        .filter(|bar| bar.at > 0.0)
        .collect();
    let plot = BarPlot { quantity: "Roll moment M_z amplitude", unit: "N m", bars, noise, two_sided: false };
    Figure {
        id: "roll-spectrum".to_owned(),
        title: "Roll moment by order".to_owned(),
        caption: "The moment about the crank axis on the block. It has no sense of rotation; unbalanced weights on one \
                  shaft cannot remove it, a pair of shafts at unequal heights can change it."
            .to_owned(),
        panels: vec![plot.panel()],
        columns: 1,
    }
}

fn two_sided(
    orders: &[OrderLoads],
    forward: impl Fn(&OrderLoads) -> f64,
    backward: impl Fn(&OrderLoads) -> f64,
) -> Vec<Bar> {
    let mut bars = Vec::with_capacity(2 * orders.len());
    for order in orders {
        bars.push(Bar { at: order.order, value: forward(order) });
        if order.order > 0.0 {
            bars.push(Bar { at: -order.order, value: backward(order) });
        }
    }
    bars.sort_by(|a, b| a.at.total_cmp(&b.at));
    bars
}
