//! Units: their dimension in SI and their factor.

use std::fmt::{self, Display, Formatter};

/// Exponents of m, kg, s, A, K in twelfths, so that roots stay whole numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Unit {
    twelfths: [i16; 5],
}

/// Named units: name, factor to SI, exponents of m, kg, s, A, K.
const NAMED: [(&str, f64, [i16; 5]); 67] = [
    ("N", 1.0, [1, 1, -2, 0, 0]),
    ("kN", 1e3, [1, 1, -2, 0, 0]),
    ("MN", 1e6, [1, 1, -2, 0, 0]),
    ("J", 1.0, [2, 1, -2, 0, 0]),
    ("kJ", 1e3, [2, 1, -2, 0, 0]),
    ("MJ", 1e6, [2, 1, -2, 0, 0]),
    ("W", 1.0, [2, 1, -3, 0, 0]),
    ("kW", 1e3, [2, 1, -3, 0, 0]),
    ("MW", 1e6, [2, 1, -3, 0, 0]),
    ("Pa", 1.0, [-1, 1, -2, 0, 0]),
    ("hPa", 1e2, [-1, 1, -2, 0, 0]),
    ("kPa", 1e3, [-1, 1, -2, 0, 0]),
    ("MPa", 1e6, [-1, 1, -2, 0, 0]),
    ("GPa", 1e9, [-1, 1, -2, 0, 0]),
    ("bar", 1e5, [-1, 1, -2, 0, 0]),
    ("mbar", 1e2, [-1, 1, -2, 0, 0]),
    ("V", 1.0, [2, 1, -3, -1, 0]),
    ("mV", 1e-3, [2, 1, -3, -1, 0]),
    ("kV", 1e3, [2, 1, -3, -1, 0]),
    ("C", 1.0, [0, 0, 1, 1, 0]),
    ("Wb", 1.0, [2, 1, -2, -1, 0]),
    ("Ohm", 1.0, [2, 1, -3, -2, 0]),
    ("mOhm", 1e-3, [2, 1, -3, -2, 0]),
    ("kOhm", 1e3, [2, 1, -3, -2, 0]),
    ("MOhm", 1e6, [2, 1, -3, -2, 0]),
    ("F", 1.0, [-2, -1, 4, 2, 0]),
    ("mF", 1e-3, [-2, -1, 4, 2, 0]),
    ("uF", 1e-6, [-2, -1, 4, 2, 0]),
    ("nF", 1e-9, [-2, -1, 4, 2, 0]),
    ("pF", 1e-12, [-2, -1, 4, 2, 0]),
    ("H", 1.0, [2, 1, -2, -2, 0]),
    ("mH", 1e-3, [2, 1, -2, -2, 0]),
    ("uH", 1e-6, [2, 1, -2, -2, 0]),
    ("m", 1.0, [1, 0, 0, 0, 0]),
    ("mm", 1e-3, [1, 0, 0, 0, 0]),
    ("um", 1e-6, [1, 0, 0, 0, 0]),
    ("cm", 1e-2, [1, 0, 0, 0, 0]),
    ("dm", 1e-1, [1, 0, 0, 0, 0]),
    ("km", 1e3, [1, 0, 0, 0, 0]),
    ("in", 0.0254, [1, 0, 0, 0, 0]),
    ("l", 1e-3, [3, 0, 0, 0, 0]),
    ("L", 1e-3, [3, 0, 0, 0, 0]),
    ("ml", 1e-6, [3, 0, 0, 0, 0]),
    ("kg", 1.0, [0, 1, 0, 0, 0]),
    ("g", 1e-3, [0, 1, 0, 0, 0]),
    ("mg", 1e-6, [0, 1, 0, 0, 0]),
    ("t", 1e3, [0, 1, 0, 0, 0]),
    ("lb", 0.45359237, [0, 1, 0, 0, 0]),
    ("lbf", 4.4482216152605, [1, 1, -2, 0, 0]),
    ("psi", 6894.757293168361, [-1, 1, -2, 0, 0]),
    ("s", 1.0, [0, 0, 1, 0, 0]),
    ("ms", 1e-3, [0, 0, 1, 0, 0]),
    ("us", 1e-6, [0, 0, 1, 0, 0]),
    ("min", 60.0, [0, 0, 1, 0, 0]),
    ("h", 3600.0, [0, 0, 1, 0, 0]),
    ("Hz", 1.0, [0, 0, -1, 0, 0]),
    ("kHz", 1e3, [0, 0, -1, 0, 0]),
    ("rpm", std::f64::consts::PI / 30.0, [0, 0, -1, 0, 0]),
    ("rad", 1.0, [0, 0, 0, 0, 0]),
    ("deg", std::f64::consts::PI / 180.0, [0, 0, 0, 0, 0]),
    ("rev", std::f64::consts::TAU, [0, 0, 0, 0, 0]),
    ("%", 0.01, [0, 0, 0, 0, 0]),
    ("A", 1.0, [0, 0, 0, 1, 0]),
    ("mA", 1e-3, [0, 0, 0, 1, 0]),
    ("kA", 1e3, [0, 0, 0, 1, 0]),
    ("K", 1.0, [0, 0, 0, 0, 1]),
    ("kW_h", 3.6e6, [2, 1, -2, 0, 0]),
];

impl Unit {
    /// The unit of a pure number, and of an angle.
    pub const NONE: Unit = Unit { twelfths: [0; 5] };
    /// Second.
    pub const SECOND: Unit = Unit { twelfths: [0, 0, 12, 0, 0] };
    /// Joule.
    pub const JOULE: Unit = Unit::of([2, 1, -2, 0, 0]);

    /// From whole exponents of m, kg, s, A, K.
    pub const fn of(exponents: [i16; 5]) -> Unit {
        let mut twelfths = [0; 5];
        let mut i = 0;
        while i < 5 {
            twelfths[i] = 12 * exponents[i];
            i += 1;
        }
        Unit { twelfths }
    }

    /// A unit of SI by its text: `N m`, `rad/s`, `1/s`.
    pub fn of_text(text: &str) -> Option<Unit> {
        if text.trim() == "1" {
            return Some(Unit::NONE);
        }
        let padded = format!(" {}", text.trim());
        let (length, factor, unit) = leading_unit(&padded)?;
        (length == padded.len() && factor == 1.0).then_some(unit)
    }

    /// Text of the unit in powers of the base units, which [`Unit::of_text`] reads.
    pub fn base_text(self) -> String {
        let names = ["m", "kg", "s", "A", "K"];
        let powers = |sign: i16| -> Vec<String> {
            let of = self.twelfths.iter().zip(names).filter(|(twelfths, _)| **twelfths * sign > 0);
            of.map(|(twelfths, name)| match twelfths.abs() / 12 {
                1 => name.to_owned(),
                power => format!("{name}{power}"),
            })
            .collect()
        };
        let (above, below) = (powers(1), powers(-1));
        let below = below.join("/");
        match (above.is_empty(), below.is_empty()) {
            (true, true) => "1".to_owned(),
            (false, true) => above.join(" "),
            (true, false) => format!("1/{below}"),
            (false, false) => format!("{}/{below}", above.join(" ")),
        }
    }

    /// Factor to SI and unit of a name; the error is the nearest known name.
    pub(crate) fn named(name: &str) -> Option<(f64, Unit)> {
        NAMED.iter().find(|(known, ..)| *known == name).map(|(_, factor, of)| (*factor, Unit::of(*of)))
    }

    /// Product.
    #[must_use]
    pub fn times(self, other: Unit) -> Unit {
        self.combined(other, 1)
    }

    /// Quotient.
    #[must_use]
    pub fn over(self, other: Unit) -> Unit {
        self.combined(other, -1)
    }

    fn combined(self, other: Unit, sign: i16) -> Unit {
        let mut twelfths = self.twelfths;
        for (mine, its) in twelfths.iter_mut().zip(other.twelfths) {
            *mine = mine.saturating_add(its.saturating_mul(sign));
        }
        Unit { twelfths }
    }

    /// Power; none where the exponents would be no twelfths.
    pub fn power(self, exponent: f64) -> Option<Unit> {
        let mut twelfths = [0i16; 5];
        for (new, old) in twelfths.iter_mut().zip(self.twelfths) {
            let value = f64::from(old) * exponent;
            if (value - value.round()).abs() > 1e-9 || value.abs() > 12_000.0 {
                return None;
            }
            *new = value.round() as i16;
        }
        Some(Unit { twelfths })
    }
}

impl Display for Unit {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        // A torque and an energy have one dimension: newton metre reads well for both.
        if *self == Unit::JOULE {
            return formatter.write_str("N m");
        }
        let plain = ["N", "W", "Pa", "V", "C", "Wb", "Ohm", "F", "H", "Hz"];
        let of = |name: &str| Unit::named(name).map(|(_, unit)| unit);
        if *self == Unit::NONE {
            return formatter.write_str("1");
        }
        if *self != Unit::of([0, 0, -1, 0, 0])
            && let Some(name) = plain.iter().find(|name| of(name) == Some(*self))
        {
            return formatter.write_str(name);
        }
        // Usual pairs of a named unit with another.
        for (first, second) in [("N", "s"), ("N", "m"), ("V", "s"), ("Pa", "s"), ("J", "s"), ("W", "s")] {
            if let (Some(a), Some(b)) = (of(first), of(second))
                && a.times(b) == *self
            {
                return write!(formatter, "{first} {second}");
            }
        }
        for (first, second) in [("N", "m"), ("W", "K"), ("J", "K"), ("Pa", "W"), ("m", "N")] {
            if let (Some(a), Some(b)) = (of(first), of(second))
                && a.over(b) == *self
            {
                return write!(formatter, "{first}/{second}");
            }
        }
        let [m, kg, s, ampere, kelvin] = self.twelfths;
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for (name, twelfths) in [("kg", kg), ("m", m), ("s", s), ("A", ampere), ("K", kelvin)] {
            let size = f64::from(twelfths.abs()) / 12.0;
            let text = if size == 1.0 { name.to_owned() } else { format!("{name}{size}") };
            match twelfths.signum() {
                1 => above.push(text),
                -1 => below.push(text),
                _ => {}
            }
        }
        let above = if above.is_empty() { "1".to_owned() } else { above.join(" ") };
        match below.len() {
            0 => formatter.write_str(&above),
            1 => write!(formatter, "{above}/{}", below[0]),
            _ => write!(formatter, "{above}/({})", below.join(" ")),
        }
    }
}

/// A time above zero with its unit, `"2 s"`, in seconds.
pub fn duration(text: &str) -> Option<f64> {
    let text = text.trim();
    let split = text.find(|c: char| !(c.is_ascii_digit() || c == '.' || c == 'e' || c == '-'))?;
    let (length, factor, unit) = leading_unit(&text[split..])?;
    let value = text[..split].parse::<f64>().ok()? * factor;
    (unit == Unit::SECOND && split + length == text.len() && value > 0.0 && value < 1e12).then_some(value)
}

/// The unit that stands at the start of a text behind a number: bytes read, factor, unit. Names stand apart by blanks, a
/// slash and an exponent touch their name.
pub(crate) fn leading_unit(text: &str) -> Option<(usize, f64, Unit)> {
    let mut at = text.len() - text.trim_start().len();
    let (mut factor, mut unit, mut read) = (1.0, Unit::NONE, None);
    let mut below = false;
    if text[at..].starts_with("1/") && at > 0 {
        at += 2;
        below = true;
    }
    loop {
        let rest = &text[at..];
        let length = rest
            .char_indices()
            .find(|(_, c)| !(c.is_ascii_alphabetic() || *c == '%'))
            .map_or(rest.len(), |(place, _)| place);
        let Some((its_factor, its_unit)) = Unit::named(&rest[..length]) else { break };
        let after = &rest[length..];
        let hat = usize::from(after.starts_with('^'));
        let digits = after[hat..].bytes().take_while(u8::is_ascii_digit).count();
        let exponent: f64 = if digits > 0 { after[hat..hat + digits].parse().ok()? } else { 1.0 };
        let used = if digits > 0 { hat + digits } else { 0 };
        let following = after[used..].chars().next();
        if exponent > 9.0 || following.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '(') {
            break;
        }
        let signed = if below { -exponent } else { exponent };
        factor *= its_factor.powf(signed);
        unit = unit.times(its_unit.power(signed)?);
        at += length + used;
        read = Some(at);
        let rest = &text[at..];
        if let Some(next) = rest.strip_prefix('/')
            && next.starts_with(|c: char| c.is_ascii_alphabetic())
        {
            at += 1;
            below = true;
        } else if rest.starts_with(' ') {
            at += rest.len() - rest.trim_start().len();
            below = false;
        } else {
            break;
        }
    }
    read.map(|read| (read, factor, unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read_as_far_as_they_go() {
        let read = |text| leading_unit(text).map(|(length, factor, unit)| (length, factor, unit.to_string()));
        assert_eq!(read(" N m"), Some((4, 1.0, "N m".into())));
        assert_eq!(read(" mm*x"), Some((3, 1e-3, "m".into())));
        assert_eq!(read(" kg m2 + 1"), Some((6, 1.0, "kg m2".into())));
        assert_eq!(read(" 1/rpm").map(|r| r.2), Some("s".into()));
        assert_eq!(read(" N s/m"), Some((6, 1.0, "kg/s".into())));
        assert_eq!(read("/l"), None);
        assert_eq!(read(" min(3, 4)"), None);
        assert_eq!(read(" theta"), None);
        for unit in [Unit::NONE, Unit::JOULE, Unit::of([-1, 1, -2, 0, 0]), Unit::of([0, 0, -1, 0, 0])] {
            assert_eq!(Unit::of_text(&unit.base_text()), Some(unit), "{}", unit.base_text());
        }
        assert_eq!(
            [Unit::of_text("Pa"), Unit::of_text("bar"), Unit::of_text("Pa x")].map(|u| u.is_some()),
            [true, false, false]
        );
        assert_eq!(Unit::JOULE.power(0.5).and_then(|root| root.power(2.0)), Some(Unit::JOULE));
    }
}
