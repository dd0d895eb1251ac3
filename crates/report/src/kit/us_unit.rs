//! Units of the reports and what stands for them in the United States.

/// Newtons in a pound-force: the international pound times standard gravity (NIST SP 811, appendix B).
const POUND_FORCE: f64 = 0.453_592_37 * 9.806_65;
/// Kilograms in an ounce.
const OUNCE: f64 = 0.453_592_37 / 16.0;
/// Metres in an inch, and in a foot.
const INCH: f64 = 0.0254;
const FOOT: f64 = 0.3048;
/// Kilograms in a pound.
const POUND: f64 = 0.453_592_37;
/// Pascals in a pound-force per square inch.
const PSI: f64 = POUND_FORCE / (INCH * INCH);
/// Watts in a mechanical horsepower: 550 ft lbf/s.
const HORSEPOWER: f64 = 550.0 * FOOT * POUND_FORCE;

/// What a number is multiplied by and divided by, and the unit that it then has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Us {
    /// What the report's unit is in SI.
    si: f64,
    /// What the other unit is in SI.
    per: f64,
    /// Unit.
    pub unit: &'static str,
}

impl Us {
    /// A value in this unit, from one in that of the report.
    pub fn of(&self, value: f64) -> f64 {
        value * self.si / self.per
    }
}

/// The unit that stands for `unit` of a report; `None` where it stays: rpm, degrees, hertz, seconds, shares, kelvin.
pub(crate) fn us(unit: &str) -> Option<Us> {
    let (si, per, name) = match unit {
        "N" => (1.0, POUND_FORCE, "lbf"),
        "kN" => (1e3, POUND_FORCE, "lbf"),
        "MN" => (1e6, POUND_FORCE, "lbf"),
        "mN" => (1e-3, POUND_FORCE, "lbf"),
        "N m" => (1.0, POUND_FORCE * FOOT, "lbf ft"),
        "kN m" => (1e3, POUND_FORCE * FOOT, "lbf ft"),
        "MN m" => (1e6, POUND_FORCE * FOOT, "lbf ft"),
        "mN m" => (1e-3, POUND_FORCE * INCH, "lbf in"),
        "m" => (1.0, FOOT, "ft"),
        "mm" => (1e-3, INCH, "in"),
        "um" | "\u{b5}m" | "\u{3bc}m" => (1e-6, 1e-3 * INCH, "thou"),
        "mm2" | "mm\u{b2}" | "mm^2" => (1e-6, INCH * INCH, "in^2"),
        "mm3" | "mm\u{b3}" | "mm^3" => (1e-9, INCH * INCH * INCH, "in^3"),
        "cm3" | "cm\u{b3}" | "cm^3" => (1e-6, INCH * INCH * INCH, "in^3"),
        "kg" => (1.0, POUND, "lb"),
        "g" => (1e-3, OUNCE, "oz"),
        "mg" => (1e-6, OUNCE, "oz"),
        "mg/deg" => (1e-6, OUNCE, "oz/deg"),
        "g mm" => (1e-6, OUNCE * INCH, "oz in"),
        "kg mm" => (1e-3, OUNCE * INCH, "oz in"),
        "kg m" => (1.0, POUND * INCH, "lb in"),
        "kg mm m" => (1e-3, OUNCE * INCH * INCH, "oz in^2"),
        "kg mm2" | "kg mm\u{b2}" | "kg mm^2" => (1e-6, POUND * INCH * INCH, "lb in^2"),
        "kg cm2" | "kg cm\u{b2}" | "kg cm^2" => (1e-4, POUND * INCH * INCH, "lb in^2"),
        "g m2" | "g m\u{b2}" | "g m^2" => (1e-3, POUND * INCH * INCH, "lb in^2"),
        "kg m2" | "kg m\u{b2}" | "kg m^2" => (1.0, POUND * FOOT * FOOT, "lb ft^2"),
        "Pa" => (1.0, PSI, "psi"),
        "kPa" => (1e3, PSI, "psi"),
        "bar" => (1e5, PSI, "psi"),
        "MPa" => (1e6, 1e3 * PSI, "ksi"),
        "GPa" => (1e9, 1e3 * PSI, "ksi"),
        "J" => (1.0, FOOT * POUND_FORCE, "ft lbf"),
        "kJ" => (1e3, FOOT * POUND_FORCE, "ft lbf"),
        "J/deg" => (1.0, FOOT * POUND_FORCE, "ft lbf/deg"),
        "W" => (1.0, HORSEPOWER, "hp"),
        "kW" => (1e3, HORSEPOWER, "hp"),
        "m/s" => (1.0, FOOT, "ft/s"),
        "mm/s" => (1e-3, INCH, "in/s"),
        "m/s2" | "m/s\u{b2}" | "m/s^2" => (1.0, FOOT, "ft/s^2"),
        "N/mm" => (1e3, POUND_FORCE / INCH, "lbf/in"),
        "N/m" => (1.0, POUND_FORCE / INCH, "lbf/in"),
        "kN/mm" => (1e6, POUND_FORCE / INCH, "lbf/in"),
        "N m/rad" => (1.0, POUND_FORCE * FOOT, "lbf ft/rad"),
        "kN m/rad" => (1e3, POUND_FORCE * FOOT, "lbf ft/rad"),
        "N m/deg" => (1.0, POUND_FORCE * FOOT, "lbf ft/deg"),
        "N m s/rad" => (1.0, POUND_FORCE * FOOT, "lbf ft s/rad"),
        _ => return None,
    };
    Some(Us { si, per, unit: name })
}

/// The unit that is converted and with which `text` begins, up to the end of a word, with its length in bytes; none where
/// there is none. A unit of two words may have any space between them.
pub(crate) fn leading(text: &str) -> Option<(usize, Us)> {
    let is_part = |letter: char| {
        letter.is_alphanumeric() || matches!(letter, '/' | '^' | '\u{b2}' | '\u{b3}' | '\u{b5}')
    };
    let mut ends: Vec<usize> = Vec::new();
    let mut from = 0;
    // A unit has at most three words: `N m s/rad`.
    for _ in 0..3 {
        let length = text[from..].find(|letter| !is_part(letter)).unwrap_or(text.len() - from);
        if length == 0 {
            break;
        }
        ends.push(from + length);
        let Some(space) = text[from + length..].chars().next().filter(|letter| letter.is_whitespace()) else {
            break;
        };
        from += length + space.len_utf8();
    }
    let spaced = |end: usize| text[..end].split(char::is_whitespace).collect::<Vec<_>>().join(" ");
    ends.into_iter().rev().find_map(|end| Some((end, us(&spaced(end))?)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_those_of_nist_sp_811() {
        for (unit, factor, name) in [
            ("N", 0.224_808_9, "lbf"),
            ("N m", 0.737_562_1, "lbf ft"),
            ("kW", 1.341_022, "hp"),
            ("bar", 14.503_77, "psi"),
            ("MPa", 0.145_037_7, "ksi"),
            ("mm", 0.039_370_08, "in"),
            ("J", 0.737_562_1, "ft lbf"),
            ("g mm", 0.001_388_739, "oz in"),
            ("kg m2", 23.730_36, "lb ft^2"),
            ("cm^3", 0.061_023_74, "in^3"),
        ] {
            let found = us(unit).unwrap();
            assert!((found.of(1.0) / factor - 1.0).abs() < 1e-6, "{unit}: {}", found.of(1.0));
            assert_eq!(found.unit, name);
        }
        assert_eq!(us("rpm"), None);
        assert_eq!(us("Hz"), None);
    }

    #[test]
    fn the_longest_unit_counts_and_none_is_cut() {
        let unit = |text: &'static str| leading(text).map(|(length, _)| &text[..length]);
        assert_eq!(unit("N m, then"), Some("N m"));
        assert_eq!(unit("N of second order"), Some("N"));
        assert_eq!(unit("kg m\u{b2} about x"), Some("kg m\u{b2}"));
        assert_eq!(unit("N/mm along"), Some("N/mm"));
        assert_eq!(unit("mm."), Some("mm"));
        assert_eq!(unit("most"), None);
        assert_eq!(unit("m more"), Some("m"));
        assert_eq!(unit("N\nm)"), Some("N\nm"), "a line may end in it");
        assert_eq!(unit("N/mm\u{b3}"), None, "no factor is known for it");
    }
}
