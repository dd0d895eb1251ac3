//! What a bearing with a film is called.

use lanchester_film::{BearingFilm, BearingKind};

/// "main 2", "main 2 of crankshaft 2", "big end 3".
pub(crate) fn bearing_name(film: &BearingFilm) -> String {
    match (film.kind, film.crankshaft) {
        (BearingKind::Main, 1) => format!("main {}", film.number),
        (BearingKind::Main, crankshaft) => format!("main {} of crankshaft {crankshaft}", film.number),
        (BearingKind::Crankpin, _) => format!("big end {}", film.number),
    }
}
