//! A crankshaft along z: bars, which are journals and pins, and stacks of webs between them.

use super::options::CrankMeshOptions;
use crate::FlexError;
use lanchester_model::{CrankElement, CrankElementForm};
use lanchester_shape::Point;

/// Points closer than this are at one place [m].
pub(super) const TINY: f64 = 1e-7;

#[derive(Clone)]
pub(super) struct Bar {
    pub name: String,
    pub set: String,
    pub centre: Point,
    pub radius: f64,
    pub bore: f64,
    pub faces: [f64; 2],
    pub fillets: [f64; 2],
    pub has_web: [bool; 2],
}

/// Webs between two bars, or at an end of the crankshaft.
#[derive(Clone)]
pub(super) struct Stack {
    pub name: String,
    pub faces: [f64; 2],
    pub bars: [Option<usize>; 2],
}

pub(super) enum Segment {
    Bar(usize),
    Stack(Stack),
}

pub(super) fn refuse(place: &str, message: impl Into<String>, hint: &'static str) -> FlexError {
    FlexError::Mesh { place: place.to_owned(), message: message.into(), hint }
}

pub(super) fn segments(
    elements: &[CrankElement],
    options: CrankMeshOptions,
    left_out: &mut Vec<String>,
) -> Result<(Vec<Bar>, Vec<Segment>), FlexError> {
    let (mut bars, mut segments): (Vec<Bar>, Vec<Segment>) = (Vec::new(), Vec::new());
    for element in elements {
        let set = match element.form {
            CrankElementForm::Journal { journal, .. } => format!("MAIN_{}", journal + 1),
            CrankElementForm::Pin { throw, .. } => format!("PIN_{}", throw + 1),
            CrankElementForm::Nose { .. } | CrankElementForm::Flange { .. } => {
                left_out.push(format!("{} (beyond the end journals)", element.name()));
                continue;
            }
            CrankElementForm::Web { .. } => {
                let before = bars.len().checked_sub(1);
                match segments.last_mut() {
                    Some(Segment::Stack(stack)) => stack.faces[1] = element.faces[1],
                    _ => segments.push(Segment::Stack(Stack {
                        name: element.name(),
                        faces: element.faces,
                        bars: [before, None],
                    })),
                }
                continue;
            }
        };
        let Some(bar) = element.bar() else { continue };
        if let Some(Segment::Stack(stack)) = segments.last_mut() {
            stack.bars[1] = Some(bars.len());
        }
        let radius = |fillet: Option<lanchester_model::Fillet>| {
            if options.fillets { fillet.and_then(|fillet| fillet.radius).unwrap_or(0.0) } else { 0.0 }
        };
        if bar.fillets.iter().flatten().any(|fillet| fillet.recess > 0.0) {
            left_out.push(format!("recess of the fillets of {}", element.name()));
        }
        if let CrankElementForm::Pin { oil_hole: Some(_), .. } = element.form {
            left_out.push(format!("oil hole of {}", element.name()));
        }
        segments.push(Segment::Bar(bars.len()));
        bars.push(Bar {
            name: element.name(),
            set,
            centre: bar.centre,
            radius: bar.diameter / 2.0,
            bore: bar.bore / 2.0,
            faces: element.faces,
            fillets: bar.fillets.map(radius),
            has_web: bar.fillets.map(|fillet| fillet.is_some()),
        });
    }
    Ok((bars, segments))
}

pub(super) fn check_fillets(bars: &[Bar], segments: &[Segment]) -> Result<(), FlexError> {
    for bar in bars {
        let length = bar.faces[1] - bar.faces[0];
        if bar.fillets[0] + bar.fillets[1] > length * 0.98 {
            let message = format!(
                "fillets of {:.2} and {:.2} mm leave nothing of its {:.2} mm",
                1e3 * bar.fillets[0],
                1e3 * bar.fillets[1],
                1e3 * length
            );
            return Err(refuse(&bar.name, message, "smaller fillets, or a longer bar"));
        }
        let (fillet, wall) = (bar.fillets[0].max(bar.fillets[1]), bar.radius - bar.bore);
        if fillet > 0.9 * wall {
            let message = format!(
                "its fillet of {:.2} mm is more than 0.9 of its wall of {:.2} mm, by {:.2} mm",
                1e3 * fillet,
                1e3 * wall,
                1e3 * (fillet - 0.9 * wall)
            );
            return Err(refuse(&bar.name, message, "a smaller fillet, a larger diameter or a smaller bore"));
        }
    }
    for segment in segments {
        let Segment::Stack(stack) = segment else { continue };
        let radius = |end: usize| stack.bars[end].map_or(0.0, |bar| bars[bar].fillets[1 - end]);
        let thickness = stack.faces[1] - stack.faces[0];
        if radius(0) + radius(1) > 0.9 * thickness {
            let message = format!(
                "the fillets of {:.2} and {:.2} mm at its faces take more than 0.9 of its thickness of {:.2} mm, by {:.2} mm",
                1e3 * radius(0),
                1e3 * radius(1),
                1e3 * thickness,
                1e3 * (radius(0) + radius(1) - 0.9 * thickness)
            );
            return Err(refuse(&stack.name, message, "smaller fillets, or a thicker web"));
        }
    }
    Ok(())
}
