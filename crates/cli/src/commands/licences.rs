//! `lanchester licences`: notices of third parties.

use crate::failure::{DONE, Failure};
use crate::files::print;
use lanchester_studio::THIRD_PARTY;

pub fn run() -> Result<u8, Failure> {
    print(THIRD_PARTY)?;
    Ok(DONE)
}
