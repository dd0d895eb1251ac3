//! The workshop by a sheet: bobweights, slugs, corrections, holes, grades.

use crate::answer::{Data, ShownAlone};
use crate::failure::Failure;
use crate::native_sheet::ReadSheet;
use lanchester::report::workshop::{
    bobweight_tables, bobweight_text, correction_tables, correction_text, drilling_tables, drilling_text,
    grade_tables, grade_text, internal_tables, internal_text, vibration_figure,
};
use lanchester::workshop::{
    BobweightAnswer, Correction, Drilling, Grade, InternalBalance, bobweight_answer, correction, drilling,
    grade, internal_balance,
};
use schemars::{JsonSchema, Schema, SchemaGenerator};

/// A question about a workshop sheet.
pub struct SheetQuestion {
    /// Its name.
    pub name: &'static str,
    /// Computes its answer.
    pub run: fn(&ReadSheet) -> Result<Data, Failure>,
    /// The type of its answer.
    pub schema: fn(&mut SchemaGenerator) -> Schema,
}

impl SheetQuestion {
    const fn of<T: JsonSchema>(
        name: &'static str,
        run: fn(&ReadSheet) -> Result<Data, Failure>,
    ) -> SheetQuestion {
        SheetQuestion { name, run, schema: SchemaGenerator::subschema_for::<T> }
    }
}

pub(super) const QUESTIONS: [SheetQuestion; 5] = [
    SheetQuestion::of::<BobweightAnswer>("sheet_bobweight", |own| {
        let engine = own.engine()?;
        let found = bobweight_answer(&own.sheet, engine.as_ref()).map_err(Failure::refused)?;
        let shown = ShownAlone { text: bobweight_text, tables: bobweight_tables, figures: Vec::new() };
        Ok(Data::alone(found, shown))
    }),
    SheetQuestion::of::<InternalBalance>("sheet_internal", |own| {
        let found = internal_balance(&own.sheet).map_err(Failure::refused)?;
        let shown = ShownAlone { text: internal_text, tables: internal_tables, figures: Vec::new() };
        Ok(Data::alone(found, shown))
    }),
    SheetQuestion::of::<Correction>("sheet_correct", |own| {
        let found = correction(&own.sheet).map_err(Failure::refused)?;
        let figures = vibration_figure(&own.sheet, &found).into_iter().collect();
        Ok(Data::alone(found, ShownAlone { text: correction_text, tables: correction_tables, figures }))
    }),
    SheetQuestion::of::<Drilling>("sheet_drill", |own| {
        let found = drilling(&own.sheet).map_err(Failure::refused)?;
        let shown = ShownAlone { text: drilling_text, tables: drilling_tables, figures: Vec::new() };
        Ok(Data::alone(found, shown))
    }),
    SheetQuestion::of::<Grade>("sheet_grade", |own| {
        let found = grade(&own.sheet).map_err(Failure::refused)?;
        let shown = ShownAlone { text: grade_text, tables: grade_tables, figures: Vec::new() };
        Ok(Data::alone(found, shown))
    }),
];
