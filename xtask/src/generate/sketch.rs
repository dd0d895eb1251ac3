//! Sketches of geometry and conventions for the theory pages, drawn from computed coordinates with the symbols of their pages.

mod bodies;
mod counterweight;
mod crank;
mod linkage;
mod loads;
mod shaft;
mod sheet;
mod workshop;

use sheet::Sketch;

/// All sketches.
pub fn all() -> Vec<Sketch> {
    [
        crank::sketches(),
        loads::sketches(),
        bodies::sketches(),
        shaft::sketches(),
        counterweight::sketches(),
        workshop::sketches(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_sketch_is_sound_and_within_its_sheet() {
        let sketches = all();
        let names: BTreeSet<&str> = sketches.iter().map(|sketch| sketch.name).collect();
        assert_eq!(names.len(), sketches.len());
        for sketch in sketches {
            let svg = sketch.svg();
            let document = roxmltree::Document::parse(&svg).expect(sketch.name);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{}", sketch.name);
            for text in document.descendants().filter(|node| node.has_tag_name("text")) {
                let place =
                    |name: &str| text.attribute(name).and_then(|v| v.parse().ok()).unwrap_or(f64::NAN);
                let (x, y): (f64, f64) = (place("x"), place("y"));
                let words: String =
                    text.descendants().filter(|node| node.is_text()).filter_map(|node| node.text()).collect();
                // Narrow letters: what does not fit with these does not fit with any.
                let width = 6.0 * words.chars().count() as f64;
                let left = match text.attribute("text-anchor") {
                    Some("start") => x,
                    Some("middle") => x - 0.5 * width,
                    _ => x - width,
                };
                let within = left >= 0.0 && left + width <= sketch.size.0 && y >= 12.0 && y <= sketch.size.1;
                assert!(within, "{}: \"{words}\" at {x}, {y}", sketch.name);
            }
        }
    }
}
