//! Long calculations cut into blocks: a pure function each, joined in their order.
//!
//! What comes out depends on the study alone, not on threads, stops or parts: a block is a function of its number, blocks are joined
//! in rising order, and rows stand in the order of their blocks. Front ends loop over [`stretch`], write what it gives, show
//! progress, and stop where they like.

mod head;

pub use head::{Head, HeadError, Held, numbered};

use lanchester_table::{Column, Rows};
use rayon::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::error::Error;
use std::ops::Range;

/// A calculation over many cases, cut into blocks.
pub trait Study: Sync {
    /// What is kept of a stretch of blocks beside its rows: sums, counts, a front.
    type Kept: Send + Serialize + DeserializeOwned;

    /// Why a block fails.
    type Error: Error + Send + 'static;

    /// Number of blocks.
    fn blocks(&self) -> u64;

    /// Number of cases in a stretch of blocks.
    fn cases(&self, blocks: Range<u64>) -> u128;

    /// Columns of the rows.
    fn columns(&self) -> Vec<Column>;

    /// What is kept of no block.
    fn nothing(&self) -> Self::Kept;

    /// One block: what is kept of it, and its rows. A function of its number alone.
    ///
    /// # Errors
    /// Where the block cannot be computed.
    fn block(&self, number: u64) -> Result<(Self::Kept, Rows), Self::Error>;

    /// Joins what is kept of a stretch and of the next one. However stretches are cut, the whole must be the same.
    ///
    /// # Errors
    /// Where the two are not of this study, or the whole grows too large.
    fn join(&self, one: Self::Kept, next: Self::Kept) -> Result<Self::Kept, Self::Error>;

    /// The rows of the table where they are known at the end alone, from what is kept of all blocks; `None` where they are
    /// those of the blocks.
    ///
    /// # Errors
    /// Where what is kept is not of this study.
    fn last_rows(&self, kept: &Self::Kept) -> Result<Option<Rows>, Self::Error>;
}

/// What a stretch of blocks gives: computed on all threads of the current pool, joined in order.
///
/// # Errors
/// That of the first block that fails.
pub fn stretch<S: Study>(study: &S, blocks: Range<u64>) -> Result<(S::Kept, Rows), S::Error> {
    let found: Vec<_> = blocks.into_par_iter().map(|number| study.block(number)).collect();
    let mut kept = study.nothing();
    let mut rows = Rows::empty(&study.columns());
    for block in found {
        let (next, more) = block?;
        kept = study.join(kept, next)?;
        rows.append(more);
    }
    Ok((kept, rows))
}

/// The blocks of part `part` (from 1) of `parts`; all parts together are all blocks once. `None` for a part that there is not.
pub fn part(blocks: u64, part: u64, parts: u64) -> Option<Range<u64>> {
    let at = |k: u64| (u128::from(blocks) * u128::from(k) / u128::from(parts)) as u64;
    (1..=parts).contains(&part).then(|| at(part - 1)..at(part))
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_table::Values;
    use std::convert::Infallible;

    /// Cubes in blocks of ten, and what was joined, in its order.
    struct Cubes;

    impl Study for Cubes {
        type Kept = Vec<u64>;
        type Error = Infallible;

        fn blocks(&self) -> u64 {
            12
        }
        fn cases(&self, blocks: Range<u64>) -> u128 {
            10 * u128::from(blocks.end - blocks.start)
        }
        fn columns(&self) -> Vec<Column> {
            vec![Column::whole("cube")]
        }
        fn nothing(&self) -> Vec<u64> {
            Vec::new()
        }
        fn block(&self, number: u64) -> Result<(Vec<u64>, Rows), Infallible> {
            let cubes = (10 * number..10 * number + 10).map(|k| (k * k * k) as i64).collect();
            Ok((vec![number], Rows::of(vec![Values::Whole(cubes)])))
        }
        fn join(&self, one: Vec<u64>, next: Vec<u64>) -> Result<Vec<u64>, Infallible> {
            Ok([one, next].concat())
        }
        fn last_rows(&self, _: &Vec<u64>) -> Result<Option<Rows>, Infallible> {
            Ok(None)
        }
    }

    #[test]
    fn parts_cover_all_blocks_once() {
        for parts in [1, 2, 5, 12, 30] {
            let mut next = 0;
            for k in 1..=parts {
                let blocks = part(12, k, parts).expect("there is this part");
                assert_eq!(blocks.start, next);
                next = blocks.end;
            }
            assert_eq!(next, 12);
        }
        assert_eq!((part(12, 0, 3), part(12, 4, 3), part(12, 1, 0)), (None, None, None));
        assert_eq!(part(u64::MAX, 3, 3), Some(u64::MAX / 3 * 2..u64::MAX));
    }

    #[test]
    fn stretches_join_to_the_whole_in_order() {
        let (kept, rows) = stretch(&Cubes, 0..12).unwrap_or_else(|never| match never {});
        assert_eq!(kept, (0..12).collect::<Vec<_>>());
        let mut joined = Rows::empty(&Cubes.columns());
        for blocks in [0..5, 5..5, 5..12] {
            joined.append(stretch(&Cubes, blocks).unwrap_or_else(|never| match never {}).1);
        }
        assert_eq!(joined, rows);
    }
}
