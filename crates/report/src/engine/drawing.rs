//! The engine drawn in both views, for a file of its own.

use crate::engine::front_view::front_view;
use crate::engine::side_view::side_view;
use crate::kit::figure::Figure;
use lanchester_model::Engine;

/// Front view (from the free end towards the flywheel) and side view of the engine.
pub fn drawing(engine: &Engine) -> Figure {
    let (front, side) = (front_view(engine), side_view(engine));
    Figure {
        id: "engine".into(),
        title: engine.name.clone(),
        caption: format!("{} {}", front.caption, side.caption),
        panels: front.panels.into_iter().chain(side.panels).collect(),
        columns: 2,
    }
}
