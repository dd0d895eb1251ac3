//! The search over arrangements: its front as tables, the residual against what it costs, and the drives drawn.

mod figure;
mod sketch;
mod tables;

pub use figure::arrangement_figure;
pub use sketch::drive_sketches;
pub use tables::{arrangement_parts, arrangements_text, front_table, narrowest_place};

use lanchester_balance::SpacingArrangements;

/// Heading of one spacing: " at 88 mm spacing", or nothing where there is only one.
fn at_spacing(spacing: &SpacingArrangements, alone: bool) -> String {
    match spacing.spacing {
        Some(s) if !alone => format!(" at {} mm spacing", crate::kit::number::trimmed(1e3 * s, 4)),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;
    use lanchester_balance::{ArrangementRequest, Arrangements, PartSizes, Target, arrangements};

    fn found() -> Arrangements {
        let target = Target::Limit { most: 6000.0 };
        let request = ArrangementRequest { target, ..ArrangementRequest::default() };
        arrangements(&sample::twin(), &request).expect("the request has a meaning")
    }

    #[test]
    fn the_front_table_has_a_row_for_each_and_marks_the_simplest() {
        let found = found();
        let at = &found.spacings[0];
        let front = front_table(&found, at, false);
        assert_eq!(front.rows.len(), at.front.len());
        assert_eq!(front_table(&found, at, true).rows.len(), at.arrangements.len());
        let text = arrangements_text(&found, false);
        assert_eq!(text.matches("(simplest)").count(), 1, "{text}");
        assert!(text.contains("narrowest place: ") && text.contains("Drive: "), "{text}");
        let csv = front.csv();
        assert!(csv.starts_with("no.,arrangement,force [N],of limit [%]"), "{csv}");
    }

    #[test]
    fn every_front_arrangement_with_a_drive_is_drawn() {
        let found = found();
        let at = &found.spacings[0];
        let sketches = drive_sketches(&sample::twin(), &PartSizes::default(), &found, at, &at.front);
        let driven = at.front.iter().filter(|k| at.arrangements[**k].drive.is_some()).count();
        assert!(driven > 0 && sketches.panels.len() == driven);
        let svg = arrangement_figure(&found).svg();
        assert!(!svg.contains("NaN") && svg.contains("good enough below"));
    }
}
