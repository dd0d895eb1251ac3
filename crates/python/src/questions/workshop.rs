//! The workshop: balance factors.

use crate::answer::{Data, Shown};
use crate::failure::Failure;
use crate::options::Options;
use crate::question::{How, Question, Run};
use lanchester::report::workshop::{factor_tables, factor_text, primary_ellipse_figure};
use lanchester::workshop::{FactorAnswer, FactorRequest, factor_answer};

pub(super) const QUESTIONS: [Question; 1] =
    [Question::of::<FactorAnswer>("balance_factor", How::Short, read_factor)];

fn read_factor(options: &Options<'_>) -> Result<Run, Failure> {
    let (oil, angle) = (options.mass("oil")?.unwrap_or(0.0), options.angle("angle")?);
    Ok(Box::new(move |engines, _| {
        let own = &engines[0];
        let request = FactorRequest { oil, angle, ..FactorRequest::default() };
        let found = factor_answer(own.engine(), &request).map_err(Failure::refused)?;
        Ok(Data::new(
            found,
            own,
            Shown {
                text: |found, _| factor_text(found),
                tables: |found, _| factor_tables(found),
                figures: |found, _| primary_ellipse_figure(found).into_iter().collect(),
                ..Shown::default()
            },
        ))
    }))
}
