//! Any serialisable result as Python values: numbers in lists become NumPy arrays, structures dictionaries.
//!
//! One pass over the result collects its numbers; NumPy looks at them where they then are, without a copy, and cannot change them: results stay what they are.

use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBytes, PyDict, PyList, PyTuple};
use serde::ser::{self, Serialize};
use std::fmt;

/// A value on its way to Python.
pub enum Converted {
    /// A number.
    Float(f64),
    /// Numbers in rows: the lengths of all dimensions, and the numbers in C order.
    Floats(Vec<usize>, Vec<f64>),
    /// Anything else.
    Object(Py<PyAny>),
}

impl Converted {
    /// As a Python object. Arrays are read-only: results do not change.
    ///
    /// # Errors
    /// Where Python has no memory left.
    pub fn object(self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        match self {
            Converted::Float(number) => number.into_py_any(py),
            Converted::Object(object) => Ok(object),
            Converted::Floats(shape, numbers) => Ok(array(py, shape, numbers)?.unbind()),
        }
    }
}

/// Numbers that NumPy looks at in place. An array holds the object that it was made from, and nothing changes the numbers.
#[pyclass(frozen, module = "lanchester._native")]
pub struct Numbers {
    shape: Vec<usize>,
    numbers: Vec<f64>,
}

#[pymethods]
impl Numbers {
    /// Where they are and how they lie there, by version 3 of NumPy's protocol: read-only doubles of this machine in C order.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let how = PyDict::new(py);
        how.set_item("version", 3)?;
        how.set_item("typestr", if cfg!(target_endian = "big") { ">f8" } else { "<f8" })?;
        how.set_item("shape", PyTuple::new(py, &self.shape)?)?;
        how.set_item("data", (self.numbers.as_ptr() as usize, true))?;
        Ok(how)
    }
}

/// Numbers as a NumPy array that looks at them where they are: read-only.
///
/// # Errors
/// Where NumPy is not installed, or there is no memory left.
pub fn array(py: Python<'_>, shape: Vec<usize>, numbers: Vec<f64>) -> PyResult<Bound<'_, PyAny>> {
    static AS_ARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    if numbers.is_empty() {
        return py.import("numpy")?.call_method1("empty", (shape,));
    }
    let as_array =
        AS_ARRAY.get_or_try_init(py, || Ok::<_, PyErr>(py.import("numpy")?.getattr("asarray")?.unbind()))?;
    as_array.bind(py).call1((Numbers { shape, numbers },))
}

/// The numbers of an array, a list or anything else that NumPy makes an array of one dimension of.
///
/// # Errors
/// Where they are none.
pub fn numbers(values: &Bound<'_, PyAny>) -> PyResult<Option<Vec<f64>>> {
    let numpy = values.py().import("numpy")?;
    let array = numpy.call_method1("ascontiguousarray", (values, "=f8"))?;
    if array.getattr("ndim")?.extract::<usize>()? != 1 {
        return Ok(None);
    }
    let bytes = array.call_method0("tobytes")?;
    let bytes = bytes.cast::<PyBytes>()?.as_bytes();
    let number = |bytes: &[u8]| <[u8; 8]>::try_from(bytes).map_or(f64::NAN, f64::from_ne_bytes);
    Ok(Some(bytes.chunks_exact(8).map(number).collect()))
}

/// Why a value cannot be converted.
#[derive(Debug)]
pub struct ConvertError(pub PyErr);

impl fmt::Display for ConvertError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

impl std::error::Error for ConvertError {}

impl ser::Error for ConvertError {
    fn custom<T: fmt::Display>(message: T) -> ConvertError {
        ConvertError(pyo3::exceptions::PyValueError::new_err(message.to_string()))
    }
}

impl From<PyErr> for ConvertError {
    fn from(error: PyErr) -> ConvertError {
        ConvertError(error)
    }
}

type Outcome = Result<Converted, ConvertError>;

/// Converts with the interpreter at hand.
#[derive(Clone, Copy)]
pub struct ToPython<'py> {
    /// The interpreter.
    pub py: Python<'py>,
}

impl ToPython<'_> {
    fn wrap(self, value: impl for<'p> IntoPyObjectExt<'p>) -> Outcome {
        Ok(Converted::Object(value.into_py_any(self.py)?))
    }

    /// `{variant: value}`, as JSON has a variant with content.
    fn tagged(self, variant: &str, value: Converted) -> Outcome {
        let tagged = PyDict::new(self.py);
        tagged.set_item(variant, value.object(self.py)?)?;
        Ok(Converted::Object(tagged.into_any().unbind()))
    }
}

macro_rules! whole {
    ($($name:ident: $of:ty),*) => {
        $(fn $name(self, value: $of) -> Outcome { self.wrap(value) })*
    };
}

impl<'py> ser::Serializer for ToPython<'py> {
    type Ok = Converted;
    type Error = ConvertError;
    type SerializeSeq = Rows<'py>;
    type SerializeTuple = Rows<'py>;
    type SerializeTupleStruct = Rows<'py>;
    type SerializeTupleVariant = Rows<'py>;
    type SerializeMap = Keys<'py>;
    type SerializeStruct = Keys<'py>;
    type SerializeStructVariant = Keys<'py>;

    whole!(
        serialize_bool: bool, serialize_i8: i8, serialize_i16: i16, serialize_i32: i32, serialize_i64: i64, serialize_i128: i128,
        serialize_u8: u8, serialize_u16: u16, serialize_u32: u32, serialize_u64: u64, serialize_u128: u128, serialize_char: char
    );

    fn serialize_f32(self, value: f32) -> Outcome {
        Ok(Converted::Float(f64::from(value)))
    }

    fn serialize_f64(self, value: f64) -> Outcome {
        Ok(Converted::Float(value))
    }

    fn serialize_str(self, value: &str) -> Outcome {
        Ok(Converted::Object(value.into_py_any(self.py)?))
    }

    fn serialize_bytes(self, value: &[u8]) -> Outcome {
        Ok(Converted::Object(value.into_py_any(self.py)?))
    }

    fn serialize_none(self) -> Outcome {
        Ok(Converted::Object(self.py.None()))
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Outcome {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Outcome {
        self.serialize_none()
    }

    fn serialize_unit_struct(self, _: &'static str) -> Outcome {
        self.serialize_none()
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, variant: &'static str) -> Outcome {
        self.serialize_str(variant)
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(self, _: &'static str, value: &T) -> Outcome {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Outcome {
        self.tagged(variant, value.serialize(self)?)
    }

    fn serialize_seq(self, length: Option<usize>) -> Result<Rows<'py>, ConvertError> {
        Ok(Rows { to: self, variant: None, length: length.unwrap_or(0), of: None })
    }

    fn serialize_tuple(self, length: usize) -> Result<Rows<'py>, ConvertError> {
        self.serialize_seq(Some(length))
    }

    fn serialize_tuple_struct(self, _: &'static str, length: usize) -> Result<Rows<'py>, ConvertError> {
        self.serialize_seq(Some(length))
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        length: usize,
    ) -> Result<Rows<'py>, ConvertError> {
        Ok(Rows { variant: Some(variant), ..self.serialize_seq(Some(length))? })
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Keys<'py>, ConvertError> {
        Ok(Keys { to: self, variant: None, keys: PyDict::new(self.py), key: None })
    }

    fn serialize_struct(self, _: &'static str, length: usize) -> Result<Keys<'py>, ConvertError> {
        self.serialize_map(Some(length))
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        length: usize,
    ) -> Result<Keys<'py>, ConvertError> {
        Ok(Keys { variant: Some(variant), ..self.serialize_map(Some(length))? })
    }
}

/// A list on its way.
pub struct Rows<'py> {
    to: ToPython<'py>,
    variant: Option<&'static str>,
    length: usize,
    of: Option<Entries<'py>>,
}

/// Entries so far.
enum Entries<'py> {
    /// Numbers.
    Floats(Vec<f64>),
    /// Rows of numbers, all of one shape.
    Arrays { shape: Vec<usize>, rows: usize, numbers: Vec<f64> },
    /// A mixture.
    Objects(Bound<'py, PyList>),
}

impl<'py> Rows<'py> {
    fn push<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), ConvertError> {
        let next = value.serialize(self.to)?;
        match (&mut self.of, next) {
            (Some(Entries::Floats(numbers)), Converted::Float(number)) => numbers.push(number),
            (Some(Entries::Arrays { shape, rows, numbers }), Converted::Floats(own_shape, own))
                if *shape == own_shape =>
            {
                numbers.extend_from_slice(&own);
                *rows += 1;
            }
            (None, Converted::Float(number)) => {
                let mut numbers = Vec::with_capacity(self.length);
                numbers.push(number);
                self.of = Some(Entries::Floats(numbers));
            }
            (None, Converted::Floats(shape, own)) => {
                let mut numbers = Vec::with_capacity(self.length * own.len());
                numbers.extend_from_slice(&own);
                self.of = Some(Entries::Arrays { shape, rows: 1, numbers });
            }
            (_, next) => {
                let next = next.object(self.to.py)?;
                self.objects()?.append(next)?;
            }
        }
        Ok(())
    }

    /// The entries so far as a list.
    fn objects(&mut self) -> Result<&Bound<'py, PyList>, ConvertError> {
        let py = self.to.py;
        let list = match self.of.take() {
            Some(Entries::Objects(list)) => list,
            None => PyList::empty(py),
            Some(Entries::Floats(numbers)) => PyList::new(py, numbers)?,
            Some(Entries::Arrays { shape, rows, numbers }) => {
                let list = PyList::empty(py);
                for row in numbers.chunks(numbers.len().checked_div(rows).unwrap_or(0).max(1)) {
                    list.append(Converted::Floats(shape.clone(), row.to_vec()).object(py)?)?;
                }
                list
            }
        };
        match self.of.insert(Entries::Objects(list)) {
            Entries::Objects(list) => Ok(list),
            _ => unreachable!("invariant: a list has just been put there"),
        }
    }

    fn finish(self) -> Outcome {
        let py = self.to.py;
        let found = match self.of {
            None => Converted::Object(PyList::empty(py).into_any().unbind()),
            Some(Entries::Floats(numbers)) => Converted::Floats(vec![numbers.len()], numbers),
            Some(Entries::Arrays { shape, rows, numbers }) => {
                Converted::Floats([vec![rows], shape].concat(), numbers)
            }
            Some(Entries::Objects(list)) => Converted::Object(list.into_any().unbind()),
        };
        match self.variant {
            None => Ok(found),
            Some(variant) => self.to.tagged(variant, found),
        }
    }
}

impl ser::SerializeSeq for Rows<'_> {
    type Ok = Converted;
    type Error = ConvertError;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), ConvertError> {
        self.push(value)
    }

    fn end(self) -> Outcome {
        self.finish()
    }
}

impl ser::SerializeTuple for Rows<'_> {
    type Ok = Converted;
    type Error = ConvertError;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), ConvertError> {
        self.push(value)
    }

    fn end(self) -> Outcome {
        self.finish()
    }
}

impl ser::SerializeTupleStruct for Rows<'_> {
    type Ok = Converted;
    type Error = ConvertError;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), ConvertError> {
        self.push(value)
    }

    fn end(self) -> Outcome {
        self.finish()
    }
}

impl ser::SerializeTupleVariant for Rows<'_> {
    type Ok = Converted;
    type Error = ConvertError;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), ConvertError> {
        self.push(value)
    }

    fn end(self) -> Outcome {
        self.finish()
    }
}

/// A structure on its way.
pub struct Keys<'py> {
    to: ToPython<'py>,
    variant: Option<&'static str>,
    keys: Bound<'py, PyDict>,
    key: Option<Py<PyAny>>,
}

impl Keys<'_> {
    fn set<T: Serialize + ?Sized>(
        &mut self,
        key: impl for<'p> IntoPyObjectExt<'p>,
        value: &T,
    ) -> Result<(), ConvertError> {
        let key = key.into_py_any(self.to.py)?;
        let value = value.serialize(self.to)?.object(self.to.py)?;
        Ok(self.keys.set_item(key, value)?)
    }

    fn finish(self) -> Outcome {
        let found = Converted::Object(self.keys.into_any().unbind());
        match self.variant {
            None => Ok(found),
            Some(variant) => self.to.tagged(variant, found),
        }
    }
}

impl ser::SerializeMap for Keys<'_> {
    type Ok = Converted;
    type Error = ConvertError;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), ConvertError> {
        self.key = Some(key.serialize(self.to)?.object(self.to.py)?);
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), ConvertError> {
        match self.key.take() {
            Some(key) => self.set(key, value),
            None => Err(ser::Error::custom("a value before its key")),
        }
    }

    fn end(self) -> Outcome {
        self.finish()
    }
}

impl ser::SerializeStruct for Keys<'_> {
    type Ok = Converted;
    type Error = ConvertError;

    fn serialize_field<T: Serialize + ?Sized>(
        &mut self,
        name: &'static str,
        value: &T,
    ) -> Result<(), ConvertError> {
        self.set(name, value)
    }

    fn end(self) -> Outcome {
        self.finish()
    }
}

impl ser::SerializeStructVariant for Keys<'_> {
    type Ok = Converted;
    type Error = ConvertError;

    fn serialize_field<T: Serialize + ?Sized>(
        &mut self,
        name: &'static str,
        value: &T,
    ) -> Result<(), ConvertError> {
        self.set(name, value)
    }

    fn end(self) -> Outcome {
        self.finish()
    }
}
