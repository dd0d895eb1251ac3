//! A value as sources print it.

/// What a quantity is: a number in SI units (degrees for angles), or Yes and No.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Value {
    Number(f64),
    Word(&'static str),
}

impl Value {
    pub fn number(self) -> Option<f64> {
        match self {
            Value::Number(number) => Some(number),
            Value::Word(_) => None,
        }
    }
}

/// Our value of a cell.
#[derive(Debug, Clone)]
pub(crate) struct Ours {
    pub value: Value,
    /// Whether it is an input, unchanged.
    pub is_input: bool,
}
