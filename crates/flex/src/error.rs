//! Why something of the flexible crankshaft cannot be computed.

/// What was needed, what was got, and what fixes it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FlexError {
    /// A material that is not elastic.
    #[error("material {material}: {quantity} must be {needed}, got {got}")]
    Material {
        /// Its name.
        material: String,
        /// Which number.
        quantity: &'static str,
        /// What it must be.
        needed: &'static str,
        /// What it is.
        got: f64,
    },
    /// A mesh that names a node, material or set that it does not have.
    #[error("{what} {name} is needed, the mesh has none\nhint: {hint}")]
    Missing {
        /// What kind of thing.
        what: &'static str,
        /// Its name or number.
        name: String,
        /// What fixes it.
        hint: &'static str,
    },
    /// A node that belongs to no element.
    #[error("node {node} belongs to no element\nhint: remove it, or the element that used it is missing")]
    FreeNode {
        /// Its number, from 1.
        node: usize,
    },
    /// An element turned inside out or folded.
    #[error(
        "element {element} at ({:.3}, {:.3}, {:.3}) mm is inverted: its smallest scaled Jacobian is {jacobian:.3}, needed above {needed}\nhint: check the order of its nodes, or refine the mesh there",
        1e3 * .at[0], 1e3 * .at[1], 1e3 * .at[2]
    )]
    Inverted {
        /// Its number, from 1.
        element: usize,
        /// Its middle [m].
        at: [f64; 3],
        /// Smallest determinant of the Jacobian over the mean one.
        jacobian: f64,
        /// Least that is accepted.
        needed: f64,
    },
    /// A crankshaft of which no mesh of good shape was found with these elements across its fillets; with others there can be one.
    #[error(
        "no mesh of good shape was found at ({:.2}, {:.2}) mm, seen along the crank: {message}\nhint: another number of elements across the fillets, or another diameter, fillet or crank radius there",
        1e3 * .at[0], 1e3 * .at[1]
    )]
    Crowded {
        /// Where it is, across the crank [m].
        at: [f64; 2],
        /// What was found there.
        message: String,
    },
    /// A body that can still move as a whole, or in parts.
    #[error(
        "the supports leave a motion free: {motion}\nhint: add a support that holds it, or ask for inertia relief"
    )]
    FreeMotion {
        /// Which motion.
        motion: String,
    },
    /// A bay of a crankshaft that cannot be cut out of it.
    #[error(
        "no submodel: {what}\nhint: support the crankshaft on its journals, by springs, or at its ends, on a mesh of its body"
    )]
    Cut {
        /// What stands against it.
        what: &'static str,
    },
    /// Rings or films where solutions would have to be added up.
    #[error(
        "rings and oil films hold the crankshaft differently under every load: this needs a support that is linear\nhint: support it on its journals, by springs, or at its ends"
    )]
    Nonlinear,
    /// A film that cannot be.
    #[error("{bearing}: {error}")]
    Film {
        /// Which bearing.
        bearing: String,
        /// Why.
        error: lanchester_film::FilmError,
    },
    /// A film without thickness under a load that stays.
    #[error(
        "{bearing}: under this load, if it stays, the oil film is thinner than {:.3} um, the least of its table\nhint: a higher speed, thicker oil or less clearance; within the cycle \
         a film that is squeezed carries more: ask for the crank train over the cycle",
        1e6 * .needed
    )]
    Overloaded {
        /// Which bearing.
        bearing: String,
        /// What is left [m].
        least_film: f64,
        /// Thinnest known film [m].
        needed: f64,
    },
    /// A matrix without a Cholesky factor.
    #[error(
        "the stiffness matrix is not positive definite at unknown {unknown}\nhint: a support leaves a motion free, or an element is badly shaped"
    )]
    NotDefinite {
        /// The unknown at which the factor broke off, in the order of elimination.
        unknown: usize,
    },
    /// A factor above the memory that may be used.
    #[error(
        "the factor needs {}, more than the {} allowed ({unknowns} unknowns, {entries} entries)\nhint: a coarser mesh, or allow more memory",
        bytes_words(*.needed), bytes_words(*.allowed)
    )]
    Memory {
        /// Unknowns.
        unknowns: usize,
        /// Entries of the factor.
        entries: usize,
        /// Bytes needed.
        needed: u64,
        /// Bytes allowed.
        allowed: u64,
    },
    /// A factor with more entries than can be numbered.
    #[error(
        "the factor of {unknowns} unknowns has more entries than can be numbered, {}\nhint: larger elements, or fewer across the fillets",
        u32::MAX
    )]
    TooLarge {
        /// Unknowns.
        unknowns: usize,
    },
    /// An iteration that came to no end.
    #[error(
        "{what} did not converge in {iterations} iterations: residual {residual:.1e}, needed {needed:.1e}\nhint: {hint}"
    )]
    NoConvergence {
        /// Which iteration.
        what: &'static str,
        /// How many.
        iterations: usize,
        /// What was reached.
        residual: f64,
        /// What was needed.
        needed: f64,
        /// What fixes it.
        hint: &'static str,
    },
    /// A number outside its accepted range.
    #[error("{quantity} must be {needed}, got {got}\nhint: {hint}")]
    Number {
        /// Which number.
        quantity: String,
        /// What it must be.
        needed: String,
        /// What it is.
        got: f64,
        /// What fixes it.
        hint: &'static str,
    },
    /// A line of a deck that cannot be read.
    #[error("line {line}: {message}")]
    Deck {
        /// Its number, from 1.
        line: usize,
        /// What is wrong, and what fixes it.
        message: String,
    },
    /// A mesh from elsewhere that does not fit the engine.
    #[error(
        "the mesh does not fit the engine: {}\nhint: the axis of the crankshaft is along z from the free end to the flywheel, throw 1 along x, z counts from the reference plane, lengths are in mm; \
         node sets PIN_1 and so on, MAIN_1 and so on and FLYWHEEL hold all nodes of the surfaces that they name",
        .faults.join("; ")
    )]
    OwnMesh {
        /// All that does not fit.
        faults: Vec<String>,
    },
    /// A file that is not what it should be.
    #[error("the {what} cannot be read: {message}\nhint: write it anew")]
    File {
        /// What kind of file.
        what: &'static str,
        /// What is wrong.
        message: String,
    },
    /// A crankshaft that is no body.
    #[error(transparent)]
    Crankshaft(#[from] lanchester_geometry::crankshaft::CrankshaftError),
    /// A crankshaft whose shape the mesher does not cover.
    #[error("{place}: {message}\nhint: {hint}")]
    Mesh {
        /// Which web, journal or pin.
        place: String,
        /// What is wrong.
        message: String,
        /// What fixes it.
        hint: &'static str,
    },
}

/// "1.25 GiB", "640 MiB", "1 MiB", "12 KiB": three significant digits.
pub fn bytes_words(bytes: u64) -> String {
    let size = bytes as f64;
    let (value, unit) = match bytes {
        0x4000_0000.. => (size / 1_073_741_824.0, "GiB"),
        0x10_0000.. => (size / 1_048_576.0, "MiB"),
        0x400.. => (size / 1024.0, "KiB"),
        _ => return format!("{bytes} bytes"),
    };
    let decimals = if value < 9.995 { 2 } else { usize::from(value < 99.95) };
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    format!("{text} {unit}")
}

#[cfg(test)]
mod tests {
    use super::bytes_words;

    #[test]
    fn sizes_have_three_digits() {
        let sizes = [1 << 20, 791_000_000, 8 << 30, 1_340_000_000, 12 << 10, 5, 150 << 30];
        let words = sizes.map(bytes_words);
        assert_eq!(words, ["1 MiB", "754 MiB", "8 GiB", "1.25 GiB", "12 KiB", "5 bytes", "150 GiB"]);
    }
}
