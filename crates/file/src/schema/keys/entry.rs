//! A key of a table, in short, and the counts above which a file is refused.

use super::super::Need::Optional;
use super::super::{Bound, Key, Kind, Need};
use lanchester_units::Dimension;

/// Counts above which a file is refused, so that nothing explodes.
pub(super) const MOST_CYLINDERS: i64 = 64;
pub(super) const MOST_THROWS: i64 = 64;
pub(super) const MOST_CRANKSHAFTS: i64 = 8;
pub(super) const MOST_WEIGHTS: usize = 256;
pub(super) const MOST_SHAFTS: usize = 64;
pub(super) const MOST_MOUNTS: usize = 64;

pub(crate) const fn key(
    name: &'static str,
    kind: Kind,
    need: Need,
    doc: &'static str,
    example: &'static str,
) -> Key {
    Key { name, kind, need, doc, example, layouts: &[] }
}

pub(crate) const fn quantity(
    name: &'static str,
    dimension: Dimension,
    bound: Bound,
    doc: &'static str,
    example: &'static str,
) -> Key {
    key(name, Kind::Quantity(dimension, bound), Optional, doc, example)
}

pub(super) const fn for_layouts(layouts: &'static [&'static str], key: Key) -> Key {
    Key { layouts, ..key }
}
