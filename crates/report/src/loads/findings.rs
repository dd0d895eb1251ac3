//! The findings of the diagnosis, one line each.

use crate::kit::number;
use crate::kit::table::{Cell, Column, Table};
use lanchester_mechanism::{Finding, Loads, Quantity, Remedy, Sense};

/// What turns which way, how large, and what can remove it, in the order of the summary.
pub fn findings_table(loads: &Loads) -> Table {
    let findings = &loads.diagnosis.findings;
    let words = |of: fn(&Finding) -> String| findings.iter().map(|finding| Cell::Text(of(finding))).collect();
    Table::of_columns(
        "findings",
        "Load by load",
        "What is left, in the order of the sentence above, and what can remove it; the roll moment last.",
        vec![
            (Column::words("load"), words(load)),
            (Column::words("turning"), words(turning)),
            (Column::words("amplitude"), words(amplitude)),
            (Column::words("what can remove it"), words(remedy)),
        ],
    )
}

fn load(finding: &Finding) -> String {
    let noun = match finding.quantity {
        Quantity::Force => "force",
        Quantity::Couple => "couple",
        Quantity::RollMoment => "roll moment",
    };
    let order = number::order_word(finding.order);
    // An order in digits stands behind its noun.
    if order.starts_with("order") {
        format!("{noun} of {order}")
    } else {
        format!("{}-order {noun}", order.trim_end_matches(" order"))
    }
}

fn turning(finding: &Finding) -> String {
    match finding.sense {
        Sense::Forward => "with the crank",
        Sense::Backward => "against the crank",
        Sense::None => "about the axis",
    }
    .to_owned()
}

fn amplitude(finding: &Finding) -> String {
    let unit = if finding.quantity == Quantity::Force { "N" } else { "N m" };
    let (value, unit) = if finding.amplitude >= 1e3 {
        (finding.amplitude / 1e3, format!("k{unit}"))
    } else {
        (finding.amplitude, unit.to_owned())
    };
    format!("{} {unit}", number::short(value, 3))
}

fn remedy(finding: &Finding) -> String {
    let speed = match finding.order {
        1.0 => "at crank speed".to_owned(),
        2.0 => "at twice crank speed".to_owned(),
        order => format!("at {} × crank speed", number::order(order)),
    };
    let planes = if finding.quantity == Quantity::Couple { ", in two planes" } else { "" };
    match finding.remedy {
        Remedy::CrankWeights if finding.order == 1.0 && finding.sense == Sense::Forward => {
            format!("weights on the crankshaft{planes}")
        }
        Remedy::CrankWeights => format!("weights on the crankshaft that turns so{planes}"),
        Remedy::BalanceShaft => format!("a shaft {speed}, turning {}{planes}", turning(finding)),
        Remedy::NoneOfLowOrder => format!("no first- or second-order device; a shaft {speed}"),
        Remedy::RollDevice => format!("shafts {speed} at unequal heights, counter-rotating inertia"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn finding(quantity: Quantity, order: f64, sense: Sense, remedy: Remedy) -> Finding {
        Finding { quantity, order, sense, amplitude: 1234.0, remedy, text: String::new() }
    }

    #[test]
    fn a_finding_in_a_few_words() {
        let couple = finding(Quantity::Couple, 2.0, Sense::Backward, Remedy::BalanceShaft);
        assert_eq!(load(&couple), "second-order couple");
        assert_eq!(amplitude(&couple), "1.23 kN m");
        assert_eq!(remedy(&couple), "a shaft at twice crank speed, turning against the crank, in two planes");
        let half = finding(Quantity::Force, 0.5, Sense::Forward, Remedy::BalanceShaft);
        assert_eq!(load(&half), "force of order 0.5");
        assert_eq!(remedy(&half), "a shaft at 0.5 × crank speed, turning with the crank");
    }
}
