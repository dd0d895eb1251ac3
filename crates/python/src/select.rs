//! One value out of a serialisable result, found by its path; nothing else is converted.

use serde::ser::{self, Serialize};
use std::fmt;

/// One step of a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Step {
    /// A field.
    Key(String),
    /// An entry of a list, from 0.
    Index(usize),
}

/// The steps of `total.orders[1].force`; `None` where it is no path.
pub fn steps(path: &str) -> Option<Vec<Step>> {
    let mut steps = Vec::new();
    for part in path.split('.') {
        let (key, mut rest) = part.split_at(part.find('[').unwrap_or(part.len()));
        if key.is_empty() {
            return None;
        }
        steps.push(Step::Key(key.to_owned()));
        while let Some(inside) = rest.strip_prefix('[') {
            let (index, behind) = inside.split_once(']')?;
            steps.push(Step::Index(index.parse().ok()?));
            rest = behind;
        }
        if !rest.is_empty() {
            return None;
        }
    }
    Some(steps)
}

/// What is made of the value at the end of the path.
pub trait Leaf: Copy {
    /// What it becomes.
    type Ok;

    /// Makes it.
    ///
    /// # Errors
    /// Where that is not possible, in words.
    fn leaf<T: Serialize + ?Sized>(self, value: &T) -> Result<Self::Ok, String>;

    /// Makes it of what is in a variant, as JSON has it: `{variant: content}`.
    ///
    /// # Errors
    /// Where that is not possible, in words.
    fn content<T: Serialize + ?Sized>(self, value: &T, variant: &str) -> Result<Self::Ok, String>;
}

/// Walks down `path` and makes the leaf.
pub struct Select<'p, L> {
    /// The steps that remain.
    pub path: &'p [Step],
    /// What is made at its end.
    pub leaf: L,
}

/// Why there is no value.
#[derive(Debug)]
pub enum NoValue {
    /// In words.
    Words(String),
    /// All that is in this variant is asked for: whoever has the value makes it.
    Content(&'static str),
}

impl fmt::Display for NoValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoValue::Words(words) => f.write_str(words),
            NoValue::Content(variant) => write!(f, "no path leads into `{variant}`"),
        }
    }
}

impl std::error::Error for NoValue {}

impl ser::Error for NoValue {
    fn custom<T: fmt::Display>(message: T) -> NoValue {
        NoValue::Words(message.to_string())
    }
}

impl<'p, L: Leaf> Select<'p, L> {
    /// The value.
    ///
    /// # Errors
    /// [`NoValue`] where the path leads nowhere.
    pub fn of<T: Serialize + ?Sized>(self, value: &T) -> Result<L::Ok, NoValue> {
        let leaf = self.leaf;
        match self.path {
            [] => leaf.leaf(value).map_err(NoValue::Words),
            _ => value.serialize(self).or_else(|error| match error {
                NoValue::Content(variant) => leaf.content(value, variant).map_err(NoValue::Words),
                words @ NoValue::Words(_) => Err(words),
            }),
        }
    }

    fn nothing(self) -> Result<L::Ok, NoValue> {
        Err(NoValue::Words(match &self.path[0] {
            Step::Key(key) => format!("no `{key}` below a plain value"),
            Step::Index(index) => format!("no [{index}] below a plain value"),
        }))
    }

    /// The content of a variant, as JSON has it below its name.
    fn content(self, variant: &'static str) -> Result<Walk<'p, L>, NoValue> {
        match self.path {
            [Step::Key(key)] if key == variant => Err(NoValue::Content(variant)),
            [Step::Key(key), rest @ ..] if key == variant => Ok(Select { path: rest, ..self }.walk()),
            _ => Err(nowhere(&self.path[0], 0, &[variant.to_owned()])),
        }
    }

    fn walk(self) -> Walk<'p, L> {
        Walk { select: self, found: None, index: 0, key: None, names: Vec::new() }
    }
}

macro_rules! plain {
    ($($name:ident: $of:ty),*) => {
        $(fn $name(self, _: $of) -> Result<L::Ok, NoValue> { self.nothing() })*
    };
}

impl<'p, L: Leaf> ser::Serializer for Select<'p, L> {
    type Ok = L::Ok;
    type Error = NoValue;
    type SerializeSeq = Walk<'p, L>;
    type SerializeTuple = Walk<'p, L>;
    type SerializeTupleStruct = Walk<'p, L>;
    type SerializeTupleVariant = Walk<'p, L>;
    type SerializeMap = Walk<'p, L>;
    type SerializeStruct = Walk<'p, L>;
    type SerializeStructVariant = Walk<'p, L>;

    plain!(
        serialize_bool: bool, serialize_i8: i8, serialize_i16: i16, serialize_i32: i32, serialize_i64: i64, serialize_i128: i128, serialize_u8: u8,
        serialize_u16: u16, serialize_u32: u32, serialize_u64: u64, serialize_u128: u128, serialize_f32: f32, serialize_f64: f64, serialize_char: char,
        serialize_str: &str, serialize_bytes: &[u8], serialize_unit_struct: &'static str
    );

    fn serialize_none(self) -> Result<L::Ok, NoValue> {
        self.nothing()
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<L::Ok, NoValue> {
        self.of(value)
    }

    fn serialize_unit(self) -> Result<L::Ok, NoValue> {
        self.nothing()
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Result<L::Ok, NoValue> {
        self.nothing()
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<L::Ok, NoValue> {
        self.of(value)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<L::Ok, NoValue> {
        match self.path {
            [Step::Key(key), rest @ ..] if key == variant => Select { path: rest, leaf: self.leaf }.of(value),
            _ => Err(nowhere(&self.path[0], 0, &[variant.to_owned()])),
        }
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Walk<'p, L>, NoValue> {
        Ok(self.walk())
    }

    fn serialize_tuple(self, _: usize) -> Result<Walk<'p, L>, NoValue> {
        Ok(self.walk())
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Walk<'p, L>, NoValue> {
        Ok(self.walk())
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Walk<'p, L>, NoValue> {
        self.content(variant)
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Walk<'p, L>, NoValue> {
        Ok(self.walk())
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Walk<'p, L>, NoValue> {
        Ok(self.walk())
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Walk<'p, L>, NoValue> {
        self.content(variant)
    }
}

/// The entries of a list or a structure, of which one is looked for.
pub struct Walk<'p, L: Leaf> {
    select: Select<'p, L>,
    found: Option<L::Ok>,
    index: usize,
    key: Option<String>,
    names: Vec<String>,
}

impl<L: Leaf> Walk<'_, L> {
    fn below<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), NoValue> {
        let rest = Select { path: &self.select.path[1..], leaf: self.select.leaf };
        self.found = Some(rest.of(value)?);
        Ok(())
    }

    fn entry<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), NoValue> {
        if self.select.path[0] == Step::Index(self.index) {
            self.below(value)?;
        }
        self.index += 1;
        Ok(())
    }

    fn field<T: Serialize + ?Sized>(&mut self, name: &str, value: &T) -> Result<(), NoValue> {
        match &self.select.path[0] {
            Step::Key(key) if key == name => self.below(value),
            _ => {
                if self.found.is_none() {
                    self.names.push(name.to_owned());
                }
                Ok(())
            }
        }
    }

    fn finish(self) -> Result<L::Ok, NoValue> {
        let Walk { select, found, index, names, .. } = self;
        found.ok_or_else(|| nowhere(&select.path[0], index, &names))
    }
}

/// Why a step leads nowhere from a list of so many, or from a structure with these names.
fn nowhere(step: &Step, length: usize, names: &[String]) -> NoValue {
    NoValue::Words(match step {
        Step::Key(key) if names.is_empty() => {
            format!("`{key}` needs an index such as [0] before it: it is a list of {length}")
        }
        Step::Key(key) => format!("there is no `{key}`; there are {}", names.join(", ")),
        Step::Index(at) if names.is_empty() => format!("there is no [{at}] in a list of {length}"),
        Step::Index(at) => format!("[{at}] needs a list; there are {}", names.join(", ")),
    })
}

impl<L: Leaf> ser::SerializeSeq for Walk<'_, L> {
    type Ok = L::Ok;
    type Error = NoValue;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), NoValue> {
        self.entry(value)
    }

    fn end(self) -> Result<L::Ok, NoValue> {
        self.finish()
    }
}

impl<L: Leaf> ser::SerializeTuple for Walk<'_, L> {
    type Ok = L::Ok;
    type Error = NoValue;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), NoValue> {
        self.entry(value)
    }

    fn end(self) -> Result<L::Ok, NoValue> {
        self.finish()
    }
}

impl<L: Leaf> ser::SerializeTupleStruct for Walk<'_, L> {
    type Ok = L::Ok;
    type Error = NoValue;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), NoValue> {
        self.entry(value)
    }

    fn end(self) -> Result<L::Ok, NoValue> {
        self.finish()
    }
}

impl<L: Leaf> ser::SerializeTupleVariant for Walk<'_, L> {
    type Ok = L::Ok;
    type Error = NoValue;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), NoValue> {
        self.entry(value)
    }

    fn end(self) -> Result<L::Ok, NoValue> {
        self.finish()
    }
}

impl<L: Leaf> ser::SerializeMap for Walk<'_, L> {
    type Ok = L::Ok;
    type Error = NoValue;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), NoValue> {
        // Keys of maps are texts, or numbers that JSON writes as texts.
        let key = serde_json::to_value(key).map_err(|error| NoValue::Words(error.to_string()))?;
        self.key = Some(key.as_str().map_or_else(|| key.to_string(), str::to_owned));
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), NoValue> {
        let key = self.key.take().unwrap_or_default();
        self.field(&key, value)
    }

    fn end(self) -> Result<L::Ok, NoValue> {
        self.finish()
    }
}

impl<L: Leaf> ser::SerializeStruct for Walk<'_, L> {
    type Ok = L::Ok;
    type Error = NoValue;

    fn serialize_field<T: Serialize + ?Sized>(
        &mut self,
        name: &'static str,
        value: &T,
    ) -> Result<(), NoValue> {
        self.field(name, value)
    }

    fn end(self) -> Result<L::Ok, NoValue> {
        self.finish()
    }
}

impl<L: Leaf> ser::SerializeStructVariant for Walk<'_, L> {
    type Ok = L::Ok;
    type Error = NoValue;

    fn serialize_field<T: Serialize + ?Sized>(
        &mut self,
        name: &'static str,
        value: &T,
    ) -> Result<(), NoValue> {
        self.field(name, value)
    }

    fn end(self) -> Result<L::Ok, NoValue> {
        self.finish()
    }
}
