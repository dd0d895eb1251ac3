//! One bay of a crankshaft: what lies between the middles of two neighbouring main journals.

use super::segment::{Bar, Segment, Stack, refuse};
use crate::FlexError;

/// Bars and webs of the bay of a pin; both journals end in a plane in the middle between their fillets.
///
/// # Errors
/// [`FlexError::Missing`] where there is no such pin; [`FlexError::Mesh`] where a main journal is missing at a side of it.
pub(super) fn bay(
    bars: &[Bar],
    segments: &[Segment],
    pin: usize,
) -> Result<(Vec<Bar>, Vec<Segment>), FlexError> {
    let name = format!("PIN_{pin}");
    let set = |segment: &Segment| match segment {
        Segment::Bar(bar) => Some(bars[*bar].set.as_str()),
        Segment::Stack(_) => None,
    };
    let is_main = |segment: &Segment| set(segment).is_some_and(|set| set.starts_with("MAIN_"));
    let Some(own) = segments.iter().position(|segment| set(segment) == Some(name.as_str())) else {
        return Err(FlexError::Missing {
            what: "crankpin",
            name: pin.to_string(),
            hint: "numbers count from 1",
        });
    };
    let before = segments[..own].iter().rposition(is_main);
    let after = segments[own..].iter().position(is_main).map(|place| own + place);
    let (Some(first), Some(last)) = (before, after) else {
        let message = "has no main journal at one of its sides, where a submodel would be cut";
        return Err(refuse(
            &format!("pin {pin}"),
            message,
            "solve the whole crankshaft with more elements across its fillets",
        ));
    };
    let mut kept: Vec<Bar> = Vec::new();
    let mut number = vec![None; bars.len()];
    for segment in &segments[first..=last] {
        if let Segment::Bar(bar) = segment {
            number[*bar] = Some(kept.len());
            kept.push(bars[*bar].clone());
        }
    }
    let middle = |bar: &Bar| (bar.faces[0] + bar.fillets[0] + bar.faces[1] - bar.fillets[1]) / 2.0;
    let ends = kept.len() - 1;
    for (bar, end) in [(0, 0), (ends, 1)] {
        let cut = middle(&kept[bar]);
        (kept[bar].faces[end], kept[bar].fillets[end], kept[bar].has_web[end]) = (cut, 0.0, false);
    }
    let own = segments[first..=last].iter().map(|segment| match segment {
        Segment::Bar(bar) => Segment::Bar(number[*bar].unwrap_or_default()),
        Segment::Stack(stack) => {
            let bars = stack.bars.map(|bar| bar.and_then(|bar| number[bar]));
            Segment::Stack(Stack { bars, ..stack.clone() })
        }
    });
    Ok((kept, own.collect()))
}
