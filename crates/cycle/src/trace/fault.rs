//! What can be wrong with a file of pressures or of a torque.

use lanchester_results::CurveError;

/// Why a file of pressures is refused.
#[derive(Debug, Clone, PartialEq)]
pub struct TraceError {
    /// Name of the file.
    pub file: String,
    /// Line in it, from 1, where there is one.
    pub line: Option<u64>,
    /// What is wrong.
    pub fault: TraceFault,
}

impl std::fmt::Display for TraceError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}: {}: {}", self.file, self.fault.code(), self.fault),
            None => write!(f, "{}: {}: {}", self.file, self.fault.code(), self.fault),
        }
    }
}

impl std::error::Error for TraceError {}

/// What is wrong with a file of pressures. Angles are those of the file [deg].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TraceFault {
    /// No CSV.
    #[error(
        "cannot be read as CSV: {message}\nhint: write a header `theta [deg],p [bar]` and one line for each angle"
    )]
    Csv {
        /// What the reader says.
        message: String,
    },
    /// A heading without a unit, or with one that is neither of an angle nor of a pressure.
    #[error(
        "the column \"{column}\" names no unit of an angle or a pressure\nhint: head it like `theta [deg]` or `p [bar]`; units are deg and rad, bar, Pa, kPa, MPa and psi"
    )]
    Heading {
        /// Its heading.
        column: String,
    },
    /// Not one column of angles.
    #[error("one column of angles is needed, got {got}\nhint: head it `theta [deg]`")]
    Angles {
        /// How many there are.
        got: usize,
    },
    /// No column of pressures.
    #[error("no column of pressures\nhint: head it `p [bar]`")]
    NoPressure,
    /// A line with too many or too few values.
    #[error("{got} values where the header has {needed}{}", if *.has_commas { "\nhint: are these decimal commas? write a decimal point, or part columns by semicolons" } else { "\nhint: every line needs a value for each column" })]
    RowLength {
        /// How many there are.
        got: usize,
        /// How many there should be.
        needed: usize,
        /// Whether columns are parted by commas, so that decimal commas would explain it.
        has_commas: bool,
    },
    /// A decimal comma.
    #[error("decimal comma in \"{text}\" of the column \"{column}\"\nhint: write a decimal point: {}", .text.replace(',', "."))]
    DecimalComma {
        /// The value.
        text: String,
        /// Its column.
        column: String,
    },
    /// A value that is no number.
    #[error(
        "\"{text}\" in the column \"{column}\" is no number\nhint: write a plain decimal number; lines that begin with # are comments"
    )]
    Number {
        /// The value.
        text: String,
        /// Its column.
        column: String,
    },
    /// Too few samples to make a cycle.
    #[error(
        "{got} samples are too few for a cycle, which needs {needed}\nhint: sample every few degrees at least"
    )]
    TooFew {
        /// How many there are.
        got: usize,
        /// How many there should be.
        needed: usize,
    },
    /// All angles fall.
    #[error(
        "the angles fall from {from:.4} deg to {to:.4} deg: the wrong sense\nhint: angles count in the sense of rotation: sort the lines by rising angle if only their order is reversed, \
             or change the sign of the angles if they were counted backwards"
    )]
    Falling {
        /// The first angle.
        from: f64,
        /// The last angle.
        to: f64,
    },
    /// An angle that does not rise.
    #[error(
        "the angle {angle:.4} deg does not lie beyond {before:.4} deg, the one before it\nhint: sort the lines by angle, each angle once; a cycle that begins within it goes on beyond \
             its end, such as 719 deg, 720 deg, 721 deg"
    )]
    NotRising {
        /// The angle.
        angle: f64,
        /// The one before it.
        before: f64,
    },
    /// More than a cycle.
    #[error(
        "the angles span {span:.4} deg, more than the cycle of {cycle:.0} deg\nhint: average several cycles into one first; `strokes` in the engine file sets the length of the cycle"
    )]
    TooLong {
        /// What they span.
        span: f64,
        /// The cycle.
        cycle: f64,
    },
    /// A part of the cycle without samples.
    #[error("nothing between {from:.4} deg and {to:.4} deg, a gap of {:.4} deg in a cycle of {cycle:.0} deg\nhint: give the whole cycle, at most {most:.0} deg from sample to sample; `strokes` in the engine file sets the length of the cycle", .to - .from)]
    Gap {
        /// Where it begins.
        from: f64,
        /// Where it ends.
        to: f64,
        /// The cycle.
        cycle: f64,
        /// The widest step that is taken.
        most: f64,
    },
    /// The end does not meet the beginning.
    #[error("the column \"{column}\" does not close: its end and its beginning differ by {:.4} bar, {:.2} % of its range, where {:.0} % is spread over the cycle at most\nhint: drift of the amplifier? correct it, or cut the cycle where it is steady", .by / 1e5, 100.0 * .share, 100.0 * .most)]
    NotClosed {
        /// Its heading.
        column: String,
        /// By how much [Pa], with its sign.
        by: f64,
        /// By which share of the range.
        share: f64,
        /// Which share is mended.
        most: f64,
    },
    /// A pressure below that of a vacuum or nearly so.
    #[error("the column \"{column}\" falls to {:.4} bar {}\nhint: {}", .least / 1e5, if *.gauge { "gauge, which is below a vacuum" } else { "absolute, which no engine reaches" }, if *.gauge { "check the unit and the zero of the measurement" } else { "are these gauge pressures? add pressures = \"gauge\"; else check the unit and the zero of the measurement" })]
    TooLow {
        /// Its heading.
        column: String,
        /// Least pressure as the file counts it [Pa].
        least: f64,
        /// Whether the file is said to hold gauge pressures.
        gauge: bool,
    },
    /// A pressure that no engine reaches.
    #[error("the column \"{column}\" rises to {:.4} bar, more than the {:.0} bar that any engine reaches\nhint: check the unit in its heading", .peak / 1e5, .most / 1e5)]
    TooHigh {
        /// Its heading.
        column: String,
        /// Largest pressure [Pa].
        peak: f64,
        /// What is taken [Pa].
        most: f64,
    },
    /// The spline between the samples falls below a vacuum.
    #[error(
        "the column \"{column}\" is sampled too coarsely near {degrees:.4} deg: the smooth curve through its samples falls below a vacuum\nhint: sample more densely where the pressure changes fast"
    )]
    TooCoarse {
        /// Its heading.
        column: String,
        /// Where.
        degrees: f64,
    },
    /// The peak lies far from firing top dead centre.
    #[error("the peak of the column \"{column}\" lies {at:.1} deg after firing top dead centre, where it lies between {:.0} and {:.0} deg in any engine\nhint: {hint}", .between[0], .between[1])]
    PeakAngle {
        /// Its heading.
        column: String,
        /// Where, from -half to half a cycle.
        at: f64,
        /// Where it may lie.
        between: [f64; 2],
        /// What to do.
        hint: String,
    },
    /// The gas takes up much work.
    #[error("the column \"{column}\" takes up {:.1} J a cycle instead of giving work (mean effective pressure {:.2} bar): it runs backwards\nhint: angles count in the sense of rotation: change their sign", -.work, .mean_effective_pressure / 1e5)]
    Backwards {
        /// Its heading.
        column: String,
        /// Indicated work [J].
        work: f64,
        /// Indicated mean effective pressure [Pa].
        mean_effective_pressure: f64,
    },
    /// Neither one column nor one for each cylinder.
    #[error(
        "{got} columns of pressure for {cylinders} cylinders\nhint: give one for all cylinders, or one for each in their order"
    )]
    Columns {
        /// How many there are.
        got: usize,
        /// Cylinders of the engine.
        cylinders: usize,
    },
    /// A heading of a file of torque without a unit, or with one that is neither of an angle nor of a torque.
    #[error(
        "the column \"{column}\" names no unit of an angle or a torque\nhint: head it like `theta [deg]` or `torque [N m]`"
    )]
    TorqueHeading {
        /// Its heading.
        column: String,
    },
    /// Not one column of torque.
    #[error(
        "one column of torque is needed, got {got}\nhint: head it `torque [N m]`, and give every torque a file of its own"
    )]
    Torques {
        /// How many there are.
        got: usize,
    },
    /// The end of a torque does not meet its beginning.
    #[error("the torque does not close: its end and its beginning differ by {by:.4} N m, {:.2} % of its range\nhint: give one whole period, or its length as `period`", 100.0 * .share)]
    TorqueNotClosed {
        /// By how much [N m], with its sign.
        by: f64,
        /// By which share of the range.
        share: f64,
    },
    /// No curve.
    #[error(transparent)]
    Curve(#[from] CurveError),
}

/// Every code that a [`TraceFault`] may have, and what it says.
///
/// A code keeps its meaning for good; one that is no longer used is not given to anything else.
pub fn trace_codes() -> &'static [(&'static str, &'static str)] {
    CODES
}

static CODES: &[(&str, &str)] = &[
    ("E1601", "no CSV"),
    ("E1602", "a column without a unit of an angle or a pressure"),
    ("E1603", "not one column of angles"),
    ("E1604", "no column of pressures"),
    ("E1605", "a line with too many or too few values"),
    ("E1606", "a decimal comma"),
    ("E1607", "a value that is no number"),
    ("E1608", "too few samples"),
    ("E1609", "angles that fall: the wrong sense"),
    ("E1610", "an angle that does not lie beyond the one before it"),
    ("E1611", "more than a cycle"),
    ("E1612", "a gap"),
    ("E1613", "an end that does not meet the beginning"),
    ("E1614", "a pressure below any engine's: gauge taken for absolute?"),
    ("E1615", "a pressure above any engine's"),
    ("E1616", "samples too far apart for the pressure between them"),
    ("E1617", "a peak far from firing top dead centre"),
    ("E1618", "a cycle that takes up work: it runs backwards"),
    ("E1619", "neither one column for all cylinders nor one for each"),
    ("E1620", "pressures or torques that are no curve"),
    ("E1621", "a column of a file of torque without a unit of an angle or a torque"),
    ("E1622", "not one column of torque"),
    ("E1623", "a torque whose end does not meet its beginning"),
];

impl TraceFault {
    /// Its code, one of [`trace_codes`].
    pub fn code(&self) -> &'static str {
        match self {
            TraceFault::Csv { .. } => "E1601",
            TraceFault::Heading { .. } => "E1602",
            TraceFault::Angles { .. } => "E1603",
            TraceFault::NoPressure => "E1604",
            TraceFault::RowLength { .. } => "E1605",
            TraceFault::DecimalComma { .. } => "E1606",
            TraceFault::Number { .. } => "E1607",
            TraceFault::TooFew { .. } => "E1608",
            TraceFault::Falling { .. } => "E1609",
            TraceFault::NotRising { .. } => "E1610",
            TraceFault::TooLong { .. } => "E1611",
            TraceFault::Gap { .. } => "E1612",
            TraceFault::NotClosed { .. } => "E1613",
            TraceFault::TooLow { .. } => "E1614",
            TraceFault::TooHigh { .. } => "E1615",
            TraceFault::TooCoarse { .. } => "E1616",
            TraceFault::PeakAngle { .. } => "E1617",
            TraceFault::Backwards { .. } => "E1618",
            TraceFault::Columns { .. } => "E1619",
            TraceFault::Curve(_) => "E1620",
            TraceFault::TorqueHeading { .. } => "E1621",
            TraceFault::Torques { .. } => "E1622",
            TraceFault::TorqueNotClosed { .. } => "E1623",
        }
    }
}
