//! Columns and rows.

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Whole numbers.
    Whole,
    /// Real numbers.
    Real,
    /// Words.
    Text,
}

/// Head of a column; the unit stands at the end of the name: `length_mm`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Letters, digits and underscores.
    pub name: String,
    /// What it holds.
    pub kind: Kind,
}

impl Column {
    /// A column of whole numbers.
    pub fn whole(name: impl Into<String>) -> Column {
        Column { name: name.into(), kind: Kind::Whole }
    }

    /// A column of real numbers.
    pub fn real(name: impl Into<String>) -> Column {
        Column { name: name.into(), kind: Kind::Real }
    }

    /// A column of words.
    pub fn text(name: impl Into<String>) -> Column {
        Column { name: name.into(), kind: Kind::Text }
    }
}

/// The values of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Whole numbers.
    Whole(Vec<i64>),
    /// Real numbers.
    Real(Vec<f64>),
    /// Words.
    Text(Vec<String>),
}

impl Values {
    /// None yet, of this kind.
    pub fn empty(kind: Kind) -> Values {
        match kind {
            Kind::Whole => Values::Whole(Vec::new()),
            Kind::Real => Values::Real(Vec::new()),
            Kind::Text => Values::Text(Vec::new()),
        }
    }

    /// Their kind.
    pub fn kind(&self) -> Kind {
        match self {
            Values::Whole(_) => Kind::Whole,
            Values::Real(_) => Kind::Real,
            Values::Text(_) => Kind::Text,
        }
    }

    /// How many.
    pub fn len(&self) -> usize {
        match self {
            Values::Whole(values) => values.len(),
            Values::Real(values) => values.len(),
            Values::Text(values) => values.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Puts values of the same kind behind its own.
    fn append(&mut self, other: Values) {
        match (self, other) {
            (Values::Whole(own), Values::Whole(mut other)) => own.append(&mut other),
            (Values::Real(own), Values::Real(mut other)) => own.append(&mut other),
            (Values::Text(own), Values::Text(mut other)) => own.append(&mut other),
            _ => unreachable!("invariant: rows of one table have the kinds of its columns"),
        }
    }

    /// Keeps the first `count` values and gives the others.
    fn split_off(&mut self, count: usize) -> Values {
        match self {
            Values::Whole(values) => Values::Whole(values.split_off(count)),
            Values::Real(values) => Values::Real(values.split_off(count)),
            Values::Text(values) => Values::Text(values.split_off(count)),
        }
    }
}

/// Rows of a table, column by column.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Rows {
    columns: Vec<Values>,
}

impl Rows {
    /// No row yet.
    pub fn empty(columns: &[Column]) -> Rows {
        Rows { columns: columns.iter().map(|column| Values::empty(column.kind)).collect() }
    }

    /// Rows of whole columns.
    ///
    /// # Panics
    /// Where the columns differ in length.
    pub fn of(columns: Vec<Values>) -> Rows {
        let equal = columns.windows(2).all(|pair| pair[0].len() == pair[1].len());
        assert!(equal, "the columns of a table have one length");
        Rows { columns }
    }

    /// The columns.
    pub fn columns(&self) -> &[Values] {
        &self.columns
    }

    /// How many rows.
    pub fn len(&self) -> usize {
        self.columns.first().map_or(0, Values::len)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether they are rows of these columns.
    pub fn fit(&self, columns: &[Column]) -> bool {
        self.columns.len() == columns.len()
            && self.columns.iter().zip(columns).all(|(values, column)| values.kind() == column.kind)
    }

    /// Puts rows of the same table behind its own.
    pub fn append(&mut self, other: Rows) {
        debug_assert_eq!(self.columns.len(), other.columns.len(), "rows of one table");
        for (own, other) in self.columns.iter_mut().zip(other.columns) {
            own.append(other);
        }
    }

    /// Keeps the first `count` rows and gives the others.
    pub fn split_off(&mut self, count: usize) -> Rows {
        Rows { columns: self.columns.iter_mut().map(|values| values.split_off(count)).collect() }
    }
}
