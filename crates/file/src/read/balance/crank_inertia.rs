//! The inertia of the crank train against which geared inertias turn: from `[flywheel]` and `[crank.body]`, or given and not against them.

use super::super::Reader;
use crate::document::Span;
use lanchester_diagnostic::Mistake;
use lanchester_model::Engine;
use lanchester_task::FreeInertia;
use lanchester_units::{Dimension, readable};

/// Share by which two numbers for one inertia may differ: files round them.
const SAME: f64 = 0.01;

/// A geared inertia before that of the crank train is known.
pub(in super::super) struct DraftInertia {
    /// It; the inertia of the crank train is not in it yet.
    pub(in super::super) inertia: FreeInertia,
    /// What `crank_inertia` says.
    pub(in super::super) given: Option<f64>,
    /// Where `crank_inertia` stands, or its table.
    pub(in super::super) span: Span,
}

impl Reader<'_> {
    /// The geared inertias with that of the crank train.
    pub(super) fn crank_inertias(
        &mut self,
        drafts: Vec<DraftInertia>,
        engine: &Engine,
    ) -> Option<Vec<FreeInertia>> {
        let known = engine.crank_inertia_range();
        let resolve = |draft: DraftInertia| {
            let crank_inertia = match (draft.given, known) {
                (Some(given), Some([least, most])) => {
                    self.contradicts(given, [least, most], &draft.span)?;
                    given
                }
                (Some(given), None) => given,
                (None, Some([least, most])) if most - least <= SAME * most && least > 0.0 => least,
                (None, _) => {
                    self.missing(
                        draft.span,
                        "the inertia of the crank train is not known".into(),
                        "add crank_inertia = \"0.2 kg m2\" here, or `inertia` and `crankshaft_inertia` to [flywheel]"
                            .into(),
                    );
                    return None;
                }
            };
            Some(FreeInertia { crank_inertia, ..draft.inertia })
        };
        let found: Vec<Option<FreeInertia>> = drafts.into_iter().map(resolve).collect();
        found.into_iter().collect()
    }

    /// Two numbers for one inertia that are not the same: `None`, with the mistake told.
    fn contradicts(&mut self, given: f64, [least, most]: [f64; 2], span: &Span) -> Option<()> {
        if given >= least * (1.0 - SAME) && given <= most * (1.0 + SAME) {
            return Some(());
        }
        let text = |value: f64| readable(value, Dimension::Inertia);
        let other = if most - least <= SAME * most {
            text(least)
        } else {
            format!("from {} to {}", text(least), text(most))
        };
        let flywheel = self.section("flywheel").0;
        let mut mistake = Mistake::error(
            "E0203",
            span.clone(),
            format!(
                "`crank_inertia` of {} contradicts the rest of the file, which gives {other}",
                text(given)
            ),
        )
        .label("second source");
        if let Some(flywheel) = flywheel {
            mistake = mistake.related(flywheel.span.clone(), "first source");
        }
        if let Some(crank) = self.section("crank").0.filter(|crank| crank.has("body")) {
            mistake = mistake.related(crank.key_span("body"), "with the crankshaft's shape");
        }
        self.mistakes.push(mistake.hint(
            "leave `crank_inertia` out: it follows from [flywheel] with the crankshaft's inertia or its shape",
        ));
        None
    }
}
