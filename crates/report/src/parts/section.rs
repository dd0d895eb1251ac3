//! The section of the report on the crankshaft as a real part.

use crate::kit::figure::Figure;
use crate::kit::section::Section;
use crate::kit::table::Table;
use crate::parts::counterweight_drawing::{DrawnCounterweight, counterweight_drawing};
use crate::parts::crankshaft_tables::{
    clearance_words, clearances_table, counterweight_parts_table, crank_body_words, crank_sections_table,
};
use crate::parts::shaft_weight_drawing::shaft_weight_drawings;
use crate::parts::shaft_weight_tables::{shaft_weight_parts_table, swept_overlap_words};
use lanchester_geometry::clearance::{Clearances, SweptOverlap};
use lanchester_geometry::crankshaft::CrankshaftBody;
use lanchester_geometry::{Outline, counterweight_properties, plain_web};
use lanchester_model::{CounterweightPart, Engine};

/// The crankshafts of an engine as parts.
#[derive(Debug, Clone, Copy)]
pub struct CrankshaftInput<'a> {
    /// The crankshafts as bodies; empty where the file has no `[crank.body]`.
    pub bodies: &'a [CrankshaftBody],
    /// Clearances; none where the file names nothing to stay clear of.
    pub clearances: Option<&'a Clearances>,
    /// Where swept circles of weights of balance shafts overlap.
    pub swept_overlaps: &'a [SweptOverlap],
}

/// Crankshafts and counterweights as parts, as a section of a report.
pub fn crankshaft_section(engine: &Engine, input: &CrankshaftInput<'_>) -> Section {
    let mut tables: Vec<Table> = counterweight_parts_table(engine).into_iter().collect();
    tables.extend(shaft_weight_parts_table(engine));
    tables.extend(input.clearances.map(|clearances| clearances_table(clearances, true)));
    tables.extend(input.bodies.iter().map(crank_sections_table));
    let mut figures = counterweight_drawings(engine);
    figures.extend(shaft_weight_drawings(engine));
    Section::new("parts", "Counterweights", "Crankshaft and counterweights as parts")
        .paragraphs(input.bodies.iter().map(crank_body_words))
        .paragraphs(input.clearances.map(clearance_words))
        .paragraphs(swept_overlap_words(input.swept_overlaps).lines().map(str::to_owned))
        .rows(figures)
        .tables(tables)
}

/// Weights whose drawings are the same.
struct Alike<'a> {
    names: Vec<&'a str>,
    part: &'a CounterweightPart,
    web: Option<Outline>,
}

/// The drawings of an engine's counterweights; those of one shape that stand alike on their webs once.
pub fn counterweight_drawings(engine: &Engine) -> Vec<Figure> {
    let mut groups: Vec<Alike> = Vec::new();
    for weight in &engine.counterweights {
        let Some(part) = weight.part.as_deref() else { continue };
        let web = plain_web(engine, part).ok().flatten();
        let alike = |known: &&mut Alike| {
            known.part.part == part.part && known.part.form == part.form && same(&known.web, &web)
        };
        match groups.iter_mut().find(alike) {
            Some(known) => known.names.push(&weight.name),
            None => groups.push(Alike { names: vec![&weight.name], part, web }),
        }
    }
    let draw = |Alike { names, part, web }: Alike<'_>| {
        let properties =
            counterweight_properties(engine, part).unwrap_or_else(|_| part.part.mass_properties());
        counterweight_drawing(&DrawnCounterweight {
            name: &names.join(", "),
            part,
            properties: &properties,
            web: web.as_ref(),
            crankcase: engine.envelope.and_then(|envelope| envelope.crankcase_radius),
        })
    };
    groups.into_iter().map(draw).collect()
}

/// Whether two plain webs lie alike but for rounding.
fn same(one: &Option<Outline>, other: &Option<Outline>) -> bool {
    match (one, other) {
        (None, None) => true,
        (Some(one), Some(other)) => {
            let (one, other) = (one.moments().first, other.moments().first);
            (one - other).norm() <= 1e-9 * one.norm()
        }
        _ => false,
    }
}
