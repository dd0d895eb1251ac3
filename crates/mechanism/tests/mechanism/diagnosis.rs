//! What the spectrum means, in words.
use crate::support::{in_line, vee};
use lanchester_mechanism::{LoadRequest, Quantity, Remedy, Sense, loads};

#[test]
fn in_line_four_needs_two_shafts_at_twice_crank_speed() {
    let diagnosis = loads(&in_line(&[0.0, 180.0, 180.0, 0.0]), &LoadRequest::default()).unwrap().diagnosis;
    assert_eq!(
        diagnosis.summary,
        "In-line four at 2864.8 rpm: 3.48 kN of second order, half turning with the crank, half against: two shafts at \
         twice crank speed, one each way, remove it; the first-order force and couples of first and second order are \
         balanced."
    );
    for sense in [Sense::Forward, Sense::Backward] {
        let finding = diagnosis
            .findings
            .iter()
            .find(|f| f.quantity == Quantity::Force && f.order == 2.0 && f.sense == sense)
            .unwrap();
        assert_eq!(finding.remedy, Remedy::BalanceShaft);
        assert!(
            finding.text.starts_with("1.74 kN of second-order force at 2864.8 rpm turns "),
            "{}",
            finding.text
        );
    }
    assert!(diagnosis.findings.iter().all(|f| f.order != 1.0), "first order is balanced");
}

#[test]
fn ninety_degree_twin_needs_crank_weights() {
    let diagnosis = loads(&vee(90.0, &[0.0]), &LoadRequest::default()).unwrap().diagnosis;
    let first: Vec<_> =
        diagnosis.findings.iter().filter(|f| f.order == 1.0 && f.quantity == Quantity::Force).collect();
    assert_eq!(first.len(), 1);
    assert_eq!((first[0].sense, first[0].remedy), (Sense::Forward, Remedy::CrankWeights));
}

#[test]
fn fourth_order_has_no_low_order_remedy() {
    let diagnosis = loads(&vee(90.0, &[0.0, 90.0, 270.0, 180.0]), &LoadRequest::default()).unwrap().diagnosis;
    let fourth = diagnosis.findings.iter().find(|f| f.order == 4.0 && f.quantity == Quantity::Force).unwrap();
    assert_eq!(fourth.remedy, Remedy::NoneOfLowOrder);
    assert!(diagnosis.findings.iter().any(|f| f.remedy == Remedy::RollDevice));
}
