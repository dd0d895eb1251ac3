//! A crankshaft along z: bars, which are journals and pins, and stacks of webs between them.

use super::ends::{Ends, is_end};
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
    /// Whether it is a step of the nose or the flange, whose bore is filled.
    pub is_end: bool,
}

/// Webs between two bars, or at an end of the crankshaft; steps of nose or flange that are thicker than the journal beside them.
#[derive(Clone)]
pub(super) struct Stack {
    pub name: String,
    pub faces: [f64; 2],
    pub bars: [Option<usize>; 2],
    pub is_web: bool,
}

pub(super) enum Segment {
    Bar(usize),
    Stack(Stack),
}

pub(super) fn refuse(place: &str, message: impl Into<String>, hint: &'static str) -> FlexError {
    FlexError::Mesh { place: place.to_owned(), message: message.into(), hint }
}

/// Bars and webs along z, with these steps of nose and flange; `why`: why others are left out.
pub(super) fn segments(
    elements: &[CrankElement],
    options: CrankMeshOptions,
    with: Ends,
    why: &str,
    left_out: &mut Vec<String>,
) -> Result<(Vec<Bar>, Vec<Segment>), FlexError> {
    let (mut bars, mut segments): (Vec<Bar>, Vec<Segment>) = (Vec::new(), Vec::new());
    let journals =
        || elements.iter().filter(|element| matches!(element.form, CrankElementForm::Journal { .. }));
    let diameter = |element: Option<&CrankElement>| element?.bar().map(|bar| bar.diameter);
    let ends = [diameter(journals().next()), diameter(journals().next_back())];
    let is_thick = |element: &CrankElement, end: usize| {
        diameter(Some(element)).zip(ends[end]).is_some_and(|(own, journal)| own > journal + TINY)
    };
    for element in elements {
        let set = match element.form {
            CrankElementForm::Journal { journal, .. } => format!("MAIN_{}", journal + 1),
            CrankElementForm::Pin { throw, .. } => format!("PIN_{}", throw + 1),
            _ if is_end(element) && !with.has(element) => {
                left_out.push(format!("{} ({why})", element.name()));
                continue;
            }
            CrankElementForm::Web { .. } => {
                push_stack(&mut segments, element, bars.len(), true);
                continue;
            }
            CrankElementForm::Nose { .. } | CrankElementForm::Flange { .. }
                if is_thick(
                    element,
                    usize::from(matches!(element.form, CrankElementForm::Flange { .. })),
                ) =>
            {
                left_out.extend(filled_bore(element));
                push_stack(&mut segments, element, bars.len(), false);
                continue;
            }
            CrankElementForm::Nose { step, .. } => format!("NOSE_{}", step + 1),
            CrankElementForm::Flange { step, .. } => format!("FLANGE_{}", step + 1),
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
        let is_end = is_end(element);
        if is_end {
            left_out.extend(filled_bore(element));
        }
        segments.push(Segment::Bar(bars.len()));
        bars.push(Bar {
            name: element.name(),
            set,
            centre: bar.centre,
            radius: bar.diameter / 2.0,
            bore: if is_end { 0.0 } else { bar.bore / 2.0 },
            faces: element.faces,
            fillets: bar.fillets.map(radius),
            has_web: bar.fillets.map(|fillet| fillet.is_some()),
            is_end,
        });
    }
    Ok((bars, segments))
}

/// Adds a web, or a thick step of an end, to the stack before it, or as a new one behind `bars` bars.
fn push_stack(segments: &mut Vec<Segment>, element: &CrankElement, bars: usize, is_web: bool) {
    match segments.last_mut() {
        Some(Segment::Stack(stack)) => stack.faces[1] = element.faces[1],
        _ => segments.push(Segment::Stack(Stack {
            name: element.name(),
            faces: element.faces,
            bars: [bars.checked_sub(1), None],
            is_web,
        })),
    }
}

/// Says that the bore of a step is filled.
fn filled_bore(element: &CrankElement) -> Option<String> {
    let bored = element.bar().is_some_and(|bar| bar.bore > 0.0);
    bored.then(|| format!("bore of {}", element.name()))
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
