//! The gallery: engine files of real layouts to start from.

use lanchester_units::nearest;

/// A ready engine file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Template {
    /// Short name, lower case with hyphens: "v8-crossplane".
    pub name: &'static str,
    /// What it is, in a few words, for a list.
    pub title: &'static str,
    /// The engine file with its comments.
    pub text: &'static str,
}

/// All templates, from one cylinder to many.
pub fn templates() -> &'static [Template] {
    &TEMPLATES
}

/// The template of this name.
pub fn template(name: &str) -> Option<&'static Template> {
    TEMPLATES.iter().find(|template| template.name == name)
}

/// The template whose name a misspelled one was probably meant to be.
pub fn nearest_template(name: &str) -> Option<&'static Template> {
    nearest(name, TEMPLATES.iter().map(|template| template.name)).and_then(template)
}

macro_rules! gallery {
    ($($name:literal: $title:literal,)*) => {
        [$(Template { name: $name, title: $title, text: include_str!(concat!("../templates/", $name, ".toml")) },)*]
    };
}

static TEMPLATES: [Template; 42] = gallery! {
    "single": "single, four-stroke, crank counterweight of 50 %",
    "single-two-shafts": "single with two first-order balance shafts",
    "twin-360": "parallel twin, pins in line, even firing",
    "twin-180": "parallel twin, pins 180 degrees apart",
    "twin-270": "parallel twin, pins 90 degrees apart, with a balance shaft",
    "boxer-2": "boxer twin",
    "v2-45": "V-twin, 45 degrees, fork-and-blade rods",
    "v2-60-split": "V-twin, 60 degrees, split pins 60 degrees apart",
    "v2-90": "V-twin, 90 degrees, shared pin",
    "in-line-2-two-stroke": "in-line two, two-stroke, pins 180 degrees apart",
    "in-line-3": "in-line three",
    "in-line-3-shaft": "in-line three with a balance shaft",
    "in-line-3-two-stroke": "in-line three, two-stroke",
    "in-line-4": "in-line four, flat crank",
    "in-line-4-lanchester": "in-line four with two second-order shafts",
    "in-line-4-crossplane": "in-line four, crossplane crank, with a balance shaft",
    "in-line-5": "in-line five",
    "in-line-6": "in-line six",
    "in-line-8": "straight eight, 2-4-2 crank",
    "boxer-4": "boxer four",
    "boxer-6": "boxer six",
    "flat-12": "flat twelve, 180-degree V with shared pins",
    "v4-90": "V4, 90 degrees, pins 180 degrees apart",
    "v6-60": "V6, 60 degrees, even firing on pins split by 60 degrees",
    "v6-90": "V6, 90 degrees, even firing on pins split by 30 degrees",
    "v6-90-odd": "V6, 90 degrees, odd firing on shared pins",
    "v6-120": "V6, 120 degrees, shared pins",
    "vr6-15": "VR6, 15 degrees, offset cylinders",
    "v8-crossplane": "V8, 90 degrees, crossplane",
    "v8-flat-plane": "V8, 90 degrees, flat-plane",
    "v10-72": "V10, 72 degrees",
    "v10-90": "V10, 90 degrees, shared pins, firing at 90 and 54 degrees",
    "v12-60": "V12, 60 degrees",
    "v16-45": "V16, 45 degrees",
    "w12-broad-arrow": "W12, three banks 60 degrees apart",
    "radial-3": "radial three, master and two articulated rods",
    "radial-5": "radial five, master and four articulated rods",
    "radial-7": "radial seven, master and six articulated rods",
    "radial-9": "radial nine, master and eight articulated rods",
    "radial-14": "two-row radial, fourteen cylinders",
    "square-4": "square four, two geared counter-turning cranks",
    "opposed-piston-3": "opposed-piston two-stroke, three cylinders, two geared cranks",
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_found() {
        for (place, one) in TEMPLATES.iter().enumerate() {
            assert_eq!(template(one.name), Some(one));
            assert!(one.name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'));
            assert!(TEMPLATES[..place].iter().all(|other| other.text != one.text));
        }
        assert_eq!(template("v7-13"), None);
    }

    #[test]
    fn every_template_reads_without_a_complaint() {
        let mut complaints = String::new();
        for template in templates() {
            let reading = crate::read(template.text);
            if reading.file.is_none() || !reading.diagnostics.is_empty() {
                complaints += &crate::render(&reading.diagnostics, template.name, template.text, false);
            }
        }
        assert!(complaints.is_empty(), "{complaints}");
    }

    #[test]
    fn every_template_says_where_its_numbers_come_from() {
        for template in templates() {
            assert!(template.text.starts_with("# "), "{}", template.name);
            assert!(template.text.contains("# Provenance: "), "{}", template.name);
            assert!(template.text.contains("\nnote = "), "{}", template.name);
        }
    }
}
