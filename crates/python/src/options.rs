//! What is asked, as Python gives it: numbers in SI units or texts with units.

use crate::failure::Failure;
use lanchester::task::option;
use lanchester::units::{self, BadQuantity, Dimension};
use pyo3::PyClass;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyList, PyString, PyTuple};

/// The arguments of one question by name; one that is `None` is not given.
pub struct Options<'py> {
    given: Bound<'py, PyDict>,
}

/// A plane across a shaft.
pub struct PlaneGiven {
    /// Its name.
    pub name: String,
    /// Where along the shaft [m].
    pub z: f64,
    /// Where in it the weight is, from the axis [m].
    pub radius: Option<f64>,
}

/// How a text with a unit is read.
pub type Read = fn(&str, &str) -> Result<f64, BadQuantity>;

impl<'py> Options<'py> {
    /// The arguments of a call.
    pub fn new(given: Bound<'py, PyDict>) -> Options<'py> {
        Options { given }
    }

    fn get(&self, name: &str) -> Result<Option<Bound<'py, PyAny>>, Failure> {
        Ok(self.given.get_item(name)?.filter(|value| !value.is_none()))
    }

    /// Whether an argument says something: neither nothing, 0, False nor an empty list.
    pub fn is_given(&self, name: &str) -> bool {
        // An array has no truth value, and is one.
        self.get(name).ok().flatten().is_some_and(|value| value.is_truthy().unwrap_or(true))
    }

    /// A quantity: a number in SI units, or a text that `read` reads. `due` says what it is: "a speed".
    fn quantity(
        &self,
        name: &str,
        value: &Bound<'py, PyAny>,
        due: &str,
        unit: &str,
        read: Read,
    ) -> Result<f64, Failure> {
        if let Ok(text) = value.cast::<PyString>() {
            return Ok(read(&text.to_cow()?, name)?);
        }
        match number(value) {
            Some(number) if number.is_finite() => Ok(number),
            Some(number) => Err(Failure::option(
                format_args!("`{name}` needs a finite number [{unit}], got {number}"),
                format_args!("leave `{name}` out, or give {due}"),
            )),
            None => Err(Failure::option(
                format_args!(
                    "`{name}` needs {due} as a text with its unit or a number [{unit}], got {}",
                    kind(value)
                ),
                format_args!("write a text such as {name}=\"...\" with a unit, or a float in SI units"),
            )),
        }
    }

    fn of(&self, name: &str, due: &str, unit: &str, read: Read) -> Result<Option<f64>, Failure> {
        self.get(name)?.map(|value| self.quantity(name, &value, due, unit, read)).transpose()
    }

    /// A speed above 0 [rad/s].
    pub fn speed(&self, name: &str) -> Result<Option<f64>, Failure> {
        let speed = self.of(name, "a speed", "rad/s", option::speed)?;
        match speed {
            Some(speed) if speed <= 0.0 => Err(Failure::option(
                format_args!("`{name}` needs a speed above 0, got {speed} rad/s"),
                "leave it out for the highest speed of the engine",
            )),
            speed => Ok(speed),
        }
    }

    /// A speed that may be 0 [rad/s].
    pub fn start_speed(&self, name: &str) -> Result<Option<f64>, Failure> {
        match self.of(name, "a speed", "rad/s", option::start_speed)? {
            Some(speed) if speed < 0.0 => Err(Failure::option(
                format_args!("`{name}` needs a speed of 0 or more, got {speed} rad/s"),
                "`rotation = \"reverse\"` in the engine file turns the crank the other way",
            )),
            speed => Ok(speed),
        }
    }

    /// Speeds above 0 [rad/s]: a list, or one.
    pub fn speeds(&self, name: &str) -> Result<Vec<f64>, Failure> {
        let speeds = self.list_of(name, "a speed", "rad/s", option::speed)?;
        match speeds.iter().find(|speed| **speed <= 0.0) {
            Some(speed) => Err(Failure::option(
                format_args!("`{name}` needs speeds above 0, got {speed} rad/s"),
                "leave it out for the speeds of the engine",
            )),
            None => Ok(speeds),
        }
    }

    /// A length [m].
    pub fn length(&self, name: &str) -> Result<Option<f64>, Failure> {
        self.of(name, "a length", "m", option::length)
    }

    /// An angle [rad].
    pub fn angle(&self, name: &str) -> Result<Option<f64>, Failure> {
        self.of(name, "an angle", "rad", option::angle)
    }

    /// A mass [kg].
    pub fn mass(&self, name: &str) -> Result<Option<f64>, Failure> {
        self.of(name, "a mass", "kg", option::mass)
    }

    /// An inertia [kg m^2].
    pub fn inertia(&self, name: &str) -> Result<Option<f64>, Failure> {
        self.of(name, "an inertia", "kg m^2", option::inertia)
    }

    /// A torque [N m].
    pub fn torque(&self, name: &str) -> Result<Option<f64>, Failure> {
        self.of(name, "a torque", "N m", option::torque)
    }

    /// A pressure [Pa].
    pub fn pressure(&self, name: &str) -> Result<Option<f64>, Failure> {
        self.of(name, "a pressure", "Pa", option::pressure)
    }

    /// A time [s].
    pub fn time(&self, name: &str) -> Result<Option<f64>, Failure> {
        self.of(name, "a time", "s", option::time)
    }

    /// A stiffness above 0 [N/m].
    pub fn stiffness(&self, name: &str) -> Result<Option<f64>, Failure> {
        fn read(text: &str, option: &str) -> Result<f64, BadQuantity> {
            option::of_dimension(text, Dimension::Stiffness, units::Bound::Positive, option)
        }
        self.of(name, "a stiffness", "N/m", read)
    }

    /// Stiffnesses [N/m] along x and y: one for all, or a list with an entry for each, a stiffness or a pair of x and y; 0 does not hold.
    pub fn stiffness_pairs(&self, name: &str) -> Result<Vec<[f64; 2]>, Failure> {
        fn read(text: &str, option: &str) -> Result<f64, BadQuantity> {
            option::of_dimension(text, Dimension::Stiffness, units::Bound::NotNegative, option)
        }
        let one = |value: &Bound<'py, PyAny>| self.quantity(name, value, "a stiffness", "N/m", read);
        let pair = |value: &Bound<'py, PyAny>| {
            let is_pair = value.is_instance_of::<PyTuple>() || value.is_instance_of::<PyList>();
            match if is_pair { iterated(value, name)? } else { vec![value.clone()] }.as_slice() {
                [both] => one(both).map(|both| [both; 2]),
                [x, y] => Ok([one(x)?, one(y)?]),
                parts => Err(Failure::option(
                    format_args!(
                        "an entry of `{name}` needs one stiffness, or two along x and y, got {}",
                        parts.len()
                    ),
                    format_args!("write {name}=[\"500 kN/mm\", (\"500 kN/mm\", \"300 kN/mm\")]"),
                )),
            }
        };
        let found: Vec<[f64; 2]> = self.entries(name)?.iter().map(pair).collect::<Result<_, _>>()?;
        match found.iter().flatten().find(|own| **own < 0.0) {
            Some(got) => Err(Failure::option(
                format_args!("`{name}` needs stiffnesses of 0 or more, got {got}"),
                "0 leaves a journal free",
            )),
            None => Ok(found),
        }
    }

    /// Forces on pins: index of the throw, radial and tangential force [N] each, the second of which may be left out.
    pub fn pin_forces(&self, name: &str) -> Result<Vec<(usize, f64, f64)>, Failure> {
        fn read(text: &str, option: &str) -> Result<f64, BadQuantity> {
            option::of_dimension(text, Dimension::Force, units::Bound::Any, option)
        }
        let Some(value) = self.get(name)? else { return Ok(Vec::new()) };
        let force = |value: &Bound<'py, PyAny>| self.quantity(name, value, "a force", "N", read);
        iterated(&value, name)?
            .iter()
            .map(|entry| match iterated(entry, name)?.as_slice() {
                [pin, radial] => Ok((whole(pin, name, 0, 10_000)? as usize, force(radial)?, 0.0)),
                [pin, radial, tangential] => {
                    Ok((whole(pin, name, 0, 10_000)? as usize, force(radial)?, force(tangential)?))
                }
                parts => Err(Failure::option(
                    format_args!("an entry of `{name}` needs a throw and its forces, got {} values", parts.len()),
                    format_args!("write {name}=[(0, \"-65 kN\", \"10.7 kN\")]: index of the throw, radial and tangential force"),
                )),
            })
            .collect()
    }

    /// An unbalance [kg m].
    pub fn unbalance(&self, name: &str) -> Result<Option<f64>, Failure> {
        self.of(name, "an unbalance", "kg m", option::unbalance)
    }

    /// A share [1], which a text may give as `"50 %"`.
    pub fn share(&self, name: &str) -> Result<Option<f64>, Failure> {
        self.of(name, "a share", "1", option::share)
    }

    /// Lengths [m]: a list, or one.
    pub fn lengths(&self, name: &str) -> Result<Vec<f64>, Failure> {
        self.list_of(name, "a length", "m", option::length)
    }

    /// Angles [rad]: a list, or one.
    pub fn angles(&self, name: &str) -> Result<Vec<f64>, Failure> {
        self.list_of(name, "an angle", "rad", option::angle)
    }

    /// Torques [N m]: a list, or one.
    pub fn torques(&self, name: &str) -> Result<Vec<f64>, Failure> {
        self.list_of(name, "a torque", "N m", option::torque)
    }

    /// Masses [kg]: a list, or one.
    pub fn masses(&self, name: &str) -> Result<Vec<f64>, Failure> {
        self.list_of(name, "a mass", "kg", option::mass)
    }

    /// Planes by name: each its place along the shaft [m], or that and a radius [m].
    pub fn planes(&self, name: &str) -> Result<Option<Vec<PlaneGiven>>, Failure> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        let planes = value.cast::<PyDict>().map_err(|_| {
            Failure::option(
                format_args!("`{name}` needs a dictionary of planes by name, got {}", kind(&value)),
                format_args!("write {name}={{\"front\": \"-180 mm\", \"rear\": \"200 mm\"}}"),
            )
        })?;
        let length = |value: &Bound<'py, PyAny>| self.quantity(name, value, "a length", "m", option::length);
        let mut found = Vec::new();
        for (plane, at) in planes {
            let is_pair = at.is_instance_of::<PyTuple>() || at.is_instance_of::<PyList>();
            let (z, radius) = match if is_pair { iterated(&at, name)? } else { vec![at] }.as_slice() {
                [z] => (length(z)?, None),
                [z, radius] => (length(z)?, Some(length(radius)?)),
                parts => {
                    return Err(Failure::option(
                        format_args!(
                            "a plane of `{name}` needs z, or z and radius, got {} values",
                            parts.len()
                        ),
                        format_args!("write {name}={{\"damper\": (\"-290 mm\", \"70 mm\"), ...}}"),
                    ));
                }
            };
            found.push(PlaneGiven { name: text(&plane, name)?, z, radius });
        }
        Ok(Some(found))
    }

    /// An object of the native module.
    pub fn object<T: PyClass>(&self, name: &str, due: &str) -> Result<Option<Bound<'py, T>>, Failure> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        match value.cast::<T>() {
            Ok(found) => Ok(Some(found.clone())),
            Err(_) => Err(Failure::option(
                format_args!("`{name}` needs {due}, got {}", kind(&value)),
                format_args!("leave `{name}` out, or give {due}"),
            )),
        }
    }

    fn list_of(&self, name: &str, due: &str, unit: &str, read: Read) -> Result<Vec<f64>, Failure> {
        let mut values = Vec::new();
        for value in self.entries(name)? {
            match value.cast::<PyString>() {
                // A list or a range in one text, as the command line takes it.
                Ok(text) => {
                    let text = text.to_cow()?;
                    values.extend(lanchester::value_list(&text, name, |one| read(one, name))?);
                }
                Err(_) => values.push(self.quantity(name, &value, due, unit, read)?),
            }
        }
        Ok(values)
    }

    /// A point [m]: x, y and z.
    pub fn point(&self, name: &str) -> Result<Option<[f64; 3]>, Failure> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        self.point_of(name, &value).map(Some)
    }

    /// Points [m].
    pub fn points(&self, name: &str) -> Result<Vec<[f64; 3]>, Failure> {
        let Some(value) = self.get(name)? else { return Ok(Vec::new()) };
        iterated(&value, name)?.iter().map(|point| self.point_of(name, point)).collect()
    }

    fn point_of(&self, name: &str, value: &Bound<'py, PyAny>) -> Result<[f64; 3], Failure> {
        let parts = iterated(value, name)?;
        let read: Vec<f64> = parts
            .iter()
            .map(|part| self.quantity(name, part, "a length", "m", option::length))
            .collect::<Result<_, _>>()?;
        <[f64; 3]>::try_from(read).map_err(|read| {
            Failure::option(
                format_args!("`{name}` needs three coordinates x, y, z, got {}", read.len()),
                format_args!("write it like {name}=(0.0, 0.0, 0.12) in metres"),
            )
        })
    }

    /// A number without a unit.
    pub fn number(&self, name: &str) -> Result<Option<f64>, Failure> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        match number(&value) {
            Some(number) if number.is_finite() => Ok(Some(number)),
            got => Err(Failure::option(
                format_args!("`{name}` needs a finite number, got {}", number_or_kind(got, &value)),
                format_args!("leave `{name}` out for its usual value"),
            )),
        }
    }

    /// Numbers without a unit: a list, or one; a text may hold a list or a range.
    pub fn numbers(&self, name: &str) -> Result<Vec<f64>, Failure> {
        let wrong = |got: String| {
            Failure::option(
                format_args!("`{name}` needs finite numbers, got {got}"),
                format_args!("leave `{name}` out for its usual value"),
            )
        };
        let finite = |number: Option<f64>| number.filter(|number| number.is_finite());
        let mut values = Vec::new();
        for value in self.entries(name)? {
            match value.cast::<PyString>() {
                Ok(text) => values.extend(lanchester::value_list(&text.to_cow()?, name, |one| {
                    finite(one.parse().ok()).ok_or_else(|| wrong(format!("\"{one}\"")))
                })?),
                Err(_) => {
                    let got = number(&value);
                    values.push(finite(got).ok_or_else(|| wrong(number_or_kind(got, &value)))?);
                }
            }
        }
        Ok(values)
    }

    /// A whole number within bounds.
    pub fn whole(&self, name: &str, least: u64, most: u64) -> Result<Option<u64>, Failure> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        whole(&value, name, least, most).map(Some)
    }

    /// Whole numbers within bounds: a list, or one.
    pub fn wholes(&self, name: &str, least: u64, most: u64) -> Result<Vec<u64>, Failure> {
        self.entries(name)?.iter().map(|value| whole(value, name, least, most)).collect()
    }

    /// True or false.
    pub fn flag(&self, name: &str) -> Result<Option<bool>, Failure> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        match value.cast::<PyBool>() {
            Ok(flag) => Ok(Some(flag.is_true())),
            Err(_) => Err(Failure::option(
                format_args!("`{name}` needs True or False, got {}", kind(&value)),
                format_args!("write {name}=True"),
            )),
        }
    }

    /// A text.
    pub fn text(&self, name: &str) -> Result<Option<String>, Failure> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        text(&value, name).map(Some)
    }

    /// Texts: a list, or one.
    pub fn texts(&self, name: &str) -> Result<Vec<String>, Failure> {
        self.entries(name)?.iter().map(|value| text(value, name)).collect()
    }

    /// One of a few words.
    pub fn word<T: Copy>(&self, name: &str, words: &[(&str, T)]) -> Result<Option<T>, Failure> {
        let Some(given) = self.text(name)? else { return Ok(None) };
        one_of(&given, name, words).map(Some)
    }

    /// A list of some of a few words.
    pub fn words<T: Copy>(&self, name: &str, words: &[(&str, T)]) -> Result<Vec<T>, Failure> {
        self.texts(name)?.iter().map(|given| one_of(given, name, words)).collect()
    }

    /// The entries of a list or an array; a value alone is a list of one.
    fn entries(&self, name: &str) -> Result<Vec<Bound<'py, PyAny>>, Failure> {
        let Some(value) = self.get(name)? else { return Ok(Vec::new()) };
        let alone = value.is_instance_of::<PyString>() || number(&value).is_some();
        if alone { Ok(vec![value]) } else { iterated(&value, name) }
    }
}

fn one_of<T: Copy>(given: &str, name: &str, words: &[(&str, T)]) -> Result<T, Failure> {
    words.iter().find(|(word, _)| *word == given).map(|(_, value)| *value).ok_or_else(|| {
        let known: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        Failure::option(
            format_args!("unknown value \"{given}\" for `{name}`"),
            format_args!("one of {}", known.join(", ")),
        )
    })
}

fn iterated<'py>(value: &Bound<'py, PyAny>, name: &str) -> Result<Vec<Bound<'py, PyAny>>, Failure> {
    let is_list = value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>();
    if !is_list && (value.is_instance_of::<PyString>() || value.is_instance_of::<PyDict>()) {
        return Err(Failure::option(
            format_args!("`{name}` needs a list, got {}", kind(value)),
            format_args!("write {name}=[...]"),
        ));
    }
    let entries = value.try_iter().map_err(|_| {
        Failure::option(
            format_args!("`{name}` needs a list, got {}", kind(value)),
            format_args!("write {name}=[...]"),
        )
    })?;
    Ok(entries.collect::<PyResult<_>>()?)
}

/// A number of Python or NumPy; no truth value and no text.
pub fn number(value: &Bound<'_, PyAny>) -> Option<f64> {
    if value.is_instance_of::<PyBool>() || value.is_instance_of::<PyString>() {
        return None;
    }
    value.extract::<f64>().ok()
}

fn whole(value: &Bound<'_, PyAny>, name: &str, least: u64, most: u64) -> Result<u64, Failure> {
    let is_flag = value.is_instance_of::<PyBool>();
    let read = value.extract::<u64>().ok().filter(|number| !is_flag && (least..=most).contains(number));
    read.ok_or_else(|| {
        let got = value.str().map_or_else(|_| kind(value), |text| text.to_string());
        Failure::option(
            format_args!("`{name}` needs a whole number from {least} to {most}, got {got}"),
            format_args!("leave `{name}` out for its usual value"),
        )
    })
}

fn text(value: &Bound<'_, PyAny>, name: &str) -> Result<String, Failure> {
    value.extract::<String>().map_err(|_| {
        Failure::option(
            format_args!("`{name}` needs a text, got {}", kind(value)),
            format_args!("write {name}=\"...\""),
        )
    })
}

/// The type of a value, for messages.
pub fn kind(value: &Bound<'_, PyAny>) -> String {
    value.get_type().name().map_or_else(|_| "something else".into(), |name| format!("`{name}`"))
}

/// A number that cannot be used, else the kind of a value that is none.
fn number_or_kind(number: Option<f64>, value: &Bound<'_, PyAny>) -> String {
    number.map_or_else(|| kind(value), |number| number.to_string())
}
