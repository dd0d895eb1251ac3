//! Tables of the sheet: results first, then every number between sizes and safety.

use super::rule::{CrankRule, SpeedSheet, ThrowMesh};
use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, csv_number, numbers, push_csv_line, words};
use lanchester_strength::{Factor, FactorValues, FilletSheet, RuleFactors, ThrowSheet, WebSheet};

/// A place with what the sheet says of it.
struct Place {
    name: String,
    torque: f64,
    /// By the formulas.
    stress: Option<FilletSheet>,
    /// By finite elements.
    by_elements: Option<FilletSheet>,
}

impl Place {
    /// What counts: the formulas, and finite elements outside their range.
    fn judged(&self) -> Option<FilletSheet> {
        self.stress.or(self.by_elements)
    }
}

fn places(throw: &ThrowSheet) -> Vec<Place> {
    let mut places = Vec::new();
    for web in &throw.webs {
        places.push(Place {
            name: format!("pin {} at web {}", throw.throw, web.web),
            torque: web.nominal.pin_torque,
            stress: web.pin_fillet,
            by_elements: web.by_elements.map(|own| own.pin_fillet),
        });
        places.push(Place {
            name: format!("journal {} at web {}", web.journal, web.web),
            torque: web.nominal.journal_torque,
            stress: web.journal_fillet,
            by_elements: web.by_elements.map(|own| own.journal_fillet),
        });
    }
    if let Some(bore) = &throw.bore {
        let torque = throw.webs[0].nominal.pin_torque;
        let name = format!("oil bore of pin {}", throw.throw);
        places.push(Place { name, torque, stress: bore.stress, by_elements: None });
    }
    places
}

impl CrankRule {
    /// All tables: safety, safety over speed, and the numbers of the decisive speed.
    pub(crate) fn tables(&self) -> Vec<Table> {
        let Some(sheet) = self.decisive() else { return Vec::new() };
        let webs: Vec<&WebSheet> = sheet.throws.iter().flat_map(|throw| &throw.webs).collect();
        let mut tables = vec![self.safety_table(sheet)];
        if self.speeds.len() > 1 {
            tables.push(self.speeds_table());
        }
        tables.extend([throws_table(sheet), nominal_table(&webs), sizes_table(&webs), ratios_table(&webs)]);
        tables.push(factors_table(&webs));
        if !self.by_elements.is_empty() {
            tables.extend([element_factors_table(&webs), self.meshes_table()]);
        }
        tables.extend(FACTORS.iter().filter_map(|part| parts_table(&webs, *part)));
        tables.extend(bores_table(sheet));
        tables
    }

    fn safety_table(&self, sheet: &SpeedSheet) -> Table {
        let all: Vec<Place> = sheet.throws.iter().flat_map(places).collect();
        let stress = |of: fn(&FilletSheet) -> f64, digits| {
            all.iter().map(move |place| {
                place.stress.as_ref().map_or(Cell::Empty, |own| Cell::number(of(own), digits))
            })
        };
        let column = |head: &str, unit, of: fn(&FilletSheet) -> f64, digits| {
            (Column::numbers(head, unit), stress(of, digits).collect::<Vec<_>>())
        };
        let verdict = |place: &Place| match place.judged() {
            None => "not judged".to_owned(),
            Some(own) if own.safety < self.acceptable => "below the rule".to_owned(),
            Some(_) if place.by_elements.is_some_and(|own| own.safety < self.acceptable) => {
                "below the rule by elements".to_owned()
            }
            Some(_) => String::new(),
        };
        let mut columns = vec![
            words("place", all.iter().map(|place| place.name.clone())),
            column("bending", "MPa", |own| 1e-6 * own.bending, 4),
            column("torsion", "MPa", |own| 1e-6 * own.torsion, 4),
            column("equivalent", "MPa", |own| 1e-6 * own.equivalent, 4),
            column("strength", "MPa", |own| 1e-6 * own.strength, 5),
            column("Q", "1", |own| own.safety, 3),
        ];
        if !self.by_elements.is_empty() {
            let safety = all
                .iter()
                .map(|place| place.by_elements.map_or(Cell::Empty, |own| Cell::number(own.safety, 3)));
            columns.push((Column::numbers("Q by elements", "1"), safety.collect()));
        }
        columns.push(words("verdict", all.iter().map(verdict)));
        Table::of_columns(
            "strength-safety",
            format!("Safety at {} rpm", number::terminal(number::rpm(sheet.speed), 0)),
            format!(
                "Alternating stresses with their concentration; bending with the additional {} MPa, but at oil bores. Q = strength over equivalent stress, {} is \
                 wanted.",
                number::trimmed(1e-6 * lanchester_strength::ADDITIONAL, 3),
                number::trimmed(self.acceptable, 4)
            ),
            columns,
        )
    }

    fn meshes_table(&self) -> Table {
        let meshes = &self.by_elements;
        let column = |head: &str, unit, digits, of: fn(&ThrowMesh) -> f64| {
            numbers(head, unit, meshes.iter().map(of), digits)
        };
        Table::of_columns(
            "strength-meshes",
            "Meshes of the throws",
            "From the middle of one main journal to that of the next, end faces rigid. Jump: difference of the stress between elements over the stress where fillets are loaded \
             most, a sign of the error.",
            vec![
                words("throw", meshes.iter().map(|mesh| mesh.throw.to_string())),
                column("nodes", "1", 6, |mesh| mesh.nodes as f64),
                column("size", "mm", 3, |mesh| 1e3 * mesh.size),
                column("across a fillet", "1", 2, |mesh| mesh.fillet_elements as f64),
                column("least Jacobian", "1", 2, |mesh| mesh.least_jacobian),
                column("jump", "%", 2, |mesh| 100.0 * mesh.jump),
            ],
        )
    }

    fn speeds_table(&self) -> Table {
        let least = |sheet: &SpeedSheet| sheet.least();
        Table::of_columns(
            "strength-speeds",
            "Least safety by speed",
            "",
            vec![
                numbers("speed", "1/min", self.speeds.iter().map(|sheet| number::rpm(sheet.speed)), 5),
                (
                    Column::numbers("Q", "1"),
                    self.speeds
                        .iter()
                        .map(|sheet| least(sheet).map_or(Cell::Empty, |own| Cell::number(own.1, 3)))
                        .collect(),
                ),
                words("at", self.speeds.iter().map(|sheet| least(sheet).map_or(String::new(), |own| own.0))),
            ],
        )
    }
}

fn throws_table(sheet: &SpeedSheet) -> Table {
    let throws = &sheet.throws;
    let column = |head: &str, unit, digits, of: fn(&ThrowSheet) -> f64| {
        numbers(head, unit, throws.iter().map(of), digits)
    };
    Table::of_columns(
        "strength-throws",
        "Alternating loads of throws",
        "Half the difference of largest and smallest value over the cycle; torque of the rigid crankshaft.",
        vec![
            words("throw", throws.iter().map(|throw| throw.throw.to_string())),
            column("front main", "mm", 5, |throw| 1e3 * throw.mains[0]),
            column("rear main", "mm", 5, |throw| 1e3 * throw.mains[1]),
            column("radial", "kN", 5, |throw| 1e-3 * throw.radial),
            column("tangential", "kN", 5, |throw| 1e-3 * throw.tangential),
            column("torque in front", "N m", 5, |throw| throw.torques[0]),
            column("torque behind", "N m", 5, |throw| throw.torques[1]),
            column("torsional vibration", "N m", 4, |throw| throw.vibration),
        ],
    )
}

type WebValue = (&'static str, &'static str, i32, fn(&WebSheet) -> f64);

fn web_table(id: &'static str, title: &str, note: &str, webs: &[&WebSheet], values: &[WebValue]) -> Table {
    let mut columns = vec![words("web", webs.iter().map(|web| web.web.to_string()))];
    for (head, unit, digits, of) in values {
        columns.push(numbers(head, unit, webs.iter().map(|web| of(web)), *digits));
    }
    Table::of_columns(id, title, note, columns)
}

fn nominal_table(webs: &[&WebSheet]) -> Table {
    web_table(
        "strength-nominal",
        "Nominal alternating stresses",
        "Moment and force in the middle of the web, over B W^2/6 and B W; torque with torsional vibration over the polar section modulus.",
        webs,
        &[
            ("moment", "N m", 5, |web| web.nominal.moment),
            ("force", "kN", 5, |web| 1e-3 * web.nominal.shear),
            ("pin torque", "N m", 5, |web| web.nominal.pin_torque),
            ("journal torque", "N m", 5, |web| web.nominal.journal_torque),
            ("modulus", "mm3", 5, |web| 1e9 * web.nominal.modulus),
            ("area", "mm2", 5, |web| 1e6 * web.nominal.area),
            ("sigma_B", "MPa", 4, |web| 1e-6 * web.nominal.sigma_b),
            ("sigma_Q", "MPa", 4, |web| 1e-6 * web.nominal.sigma_q),
            ("tau pin", "MPa", 4, |web| 1e-6 * web.nominal.pin_tau),
            ("tau journal", "MPa", 4, |web| 1e-6 * web.nominal.journal_tau),
        ],
    )
}

fn sizes_table(webs: &[&WebSheet]) -> Table {
    web_table(
        "strength-sizes",
        "Sizes",
        "As the rule names them; B in the middle of the overlap.",
        webs,
        &[
            ("D", "mm", 5, |web| 1e3 * web.section.pin_diameter),
            ("D_BH", "mm", 4, |web| 1e3 * web.section.pin_bore),
            ("R_H", "mm", 4, |web| 1e3 * web.section.pin_fillet),
            ("T_H", "mm", 3, |web| 1e3 * web.section.pin_recess),
            ("D_G", "mm", 5, |web| 1e3 * web.section.journal_diameter),
            ("D_BG", "mm", 4, |web| 1e3 * web.section.journal_bore),
            ("R_G", "mm", 4, |web| 1e3 * web.section.journal_fillet),
            ("T_G", "mm", 3, |web| 1e3 * web.section.journal_recess),
            ("E", "mm", 5, |web| 1e3 * web.section.crank_radius),
            ("W", "mm", 5, |web| 1e3 * web.section.web_thickness),
            ("B", "mm", 5, |web| 1e3 * web.section.web_width),
            ("S", "mm", 4, |web| 1e3 * web.section.overlap()),
        ],
    )
}

fn ratios_table(webs: &[&WebSheet]) -> Table {
    web_table(
        "strength-ratios",
        "Ratios to the pin's diameter",
        "The formulas hold for s 0 to 0.5, w 0.2 to 0.8, b 1.1 to 2.2, r 0.03 to 0.13, d_G and d_H up to 0.8, d_O up to 0.2.",
        webs,
        &[
            ("s", "1", 4, |web| web.ratios.s),
            ("w", "1", 4, |web| web.ratios.w),
            ("b", "1", 4, |web| web.ratios.b),
            ("r pin", "1", 4, |web| web.ratios.r_pin),
            ("r journal", "1", 4, |web| web.ratios.r_journal),
            ("d_H", "1", 4, |web| web.ratios.d_pin),
            ("d_G", "1", 4, |web| web.ratios.d_journal),
            ("t_H", "1", 4, |web| web.ratios.t_pin),
            ("t_G", "1", 4, |web| web.ratios.t_journal),
        ],
    )
}

/// A factor: its name in links, in words, and where it stands.
type NamedFactor = (&'static str, &'static str, fn(&RuleFactors) -> &Factor);

const FACTORS: [NamedFactor; 5] = [
    ("strength-alpha-b", "alpha_B", |own| &own.alpha_b),
    ("strength-alpha-t", "alpha_T", |own| &own.alpha_t),
    ("strength-beta-b", "beta_B", |own| &own.beta_b),
    ("strength-beta-q", "beta_Q", |own| &own.beta_q),
    ("strength-beta-t", "beta_T", |own| &own.beta_t),
];

fn factors_table(webs: &[&WebSheet]) -> Table {
    let mut columns = vec![words("web", webs.iter().map(|web| web.web.to_string()))];
    for (_, name, of) in FACTORS {
        let cell = |web: &&WebSheet| {
            web.factors.as_ref().map_or(Cell::Empty, |own| Cell::Number { value: of(own).value, decimals: 4 })
        };
        columns.push((Column::numbers(name, "1"), webs.iter().map(cell).collect()));
    }
    Table::of_columns(
        "strength-factors",
        "Stress concentration factors",
        "alpha at the pin's fillet, beta at the journal's; B bending, Q radial force, T torsion.",
        columns,
    )
}

/// A factor in words, and where it stands among those by finite elements.
type ElementFactor = (&'static str, fn(&FactorValues) -> f64);

const ELEMENT_FACTORS: [ElementFactor; 5] = [
    ("alpha_B", |own| own.alpha_b),
    ("alpha_T", |own| own.alpha_t),
    ("beta_B", |own| own.beta_b),
    ("beta_Q", |own| own.beta_q),
    ("beta_T", |own| own.beta_t),
];

/// Factors by finite elements, each with what it differs from that of the formulas.
fn element_factors_table(webs: &[&WebSheet]) -> Table {
    let mut columns = vec![words("web", webs.iter().map(|web| web.web.to_string()))];
    for (name, of) in ELEMENT_FACTORS {
        let value = |web: &WebSheet| web.by_elements.map(|own| of(&own.factors));
        let cells = webs
            .iter()
            .map(|web| value(web).map_or(Cell::Empty, |value| Cell::Number { value, decimals: 4 }));
        columns.push((Column::numbers(name, "1"), cells.collect()));
        let off = webs.iter().map(|web| {
            let both = value(web).zip(web.factors.as_ref().map(|own| of(&own.values())));
            both.map_or(Cell::Empty, |(value, rule)| Cell::Number {
                value: 100.0 * (value / rule - 1.0),
                decimals: 0,
            })
        });
        columns.push((Column::numbers("off", "%"), off.collect()));
    }
    Table::of_columns(
        "strength-element-factors",
        "Stress concentration factors by finite elements",
        "Largest stress of a fillet over the nominal one of the formulas, and what it differs from their factor.",
        columns,
    )
}

/// What a factor is the product of; `None` where no web has it.
fn parts_table(webs: &[&WebSheet], (id, name, of): NamedFactor) -> Option<Table> {
    let judged: Vec<(usize, &Factor)> =
        webs.iter().filter_map(|web| Some((web.web, of(web.factors.as_ref()?)))).collect();
    let (_, first) = judged.first()?;
    let mut columns = vec![words("web", judged.iter().map(|(web, _)| web.to_string()))];
    for (k, part) in first.parts.iter().enumerate() {
        let cells = judged.iter().map(|(_, own)| Cell::Number { value: own.parts[k].value, decimals: 4 });
        columns.push((Column::numbers(part.name, "1"), cells.collect()));
    }
    Some(Table::of_columns(id, format!("Parts of {name}"), "Their product is the factor.", columns))
}

fn bores_table(sheet: &SpeedSheet) -> Option<Table> {
    let bores: Vec<_> = sheet.throws.iter().filter_map(|own| Some((own, own.bore.as_ref()?))).collect();
    if bores.is_empty() {
        return None;
    }
    let values =
        |head: &str, unit, digits, of: &dyn Fn(&ThrowSheet, &lanchester_strength::BoreSheet) -> f64| {
            numbers(head, unit, bores.iter().map(|(throw, bore)| of(throw, bore)), digits)
        };
    let factor = |head: &str, of: fn(&lanchester_strength::OilFactors) -> f64| {
        let cell = |(_, bore): &(&ThrowSheet, &lanchester_strength::BoreSheet)| {
            bore.factors.as_ref().map_or(Cell::Empty, |own| Cell::Number { value: of(own), decimals: 4 })
        };
        (Column::numbers(head, "1"), bores.iter().map(cell).collect::<Vec<_>>())
    };
    Some(Table::of_columns(
        "strength-bores",
        "Oil bores",
        "Moment of the force in the direction of the bore's mouth, in the middle of the pin; angle from the throw.",
        vec![
            words("pin", bores.iter().map(|(throw, _)| throw.throw.to_string())),
            values("D_O", "mm", 4, &|_, bore| 1e3 * bore.diameter),
            values("angle", "deg", 4, &|_, bore| bore.angle.to_degrees()),
            values("moment", "N m", 5, &|_, bore| bore.nominal.moment),
            values("torque", "N m", 5, &|throw, _| throw.webs[0].nominal.pin_torque),
            values("sigma", "MPa", 4, &|_, bore| 1e-6 * bore.nominal.sigma),
            values("tau", "MPa", 4, &|_, bore| 1e-6 * bore.nominal.tau),
            values("d_O", "1", 4, &|throw, bore| bore.diameter / throw.webs[0].section.pin_diameter),
            factor("gamma_B", |own| own.gamma_b),
            factor("gamma_T", |own| own.gamma_t),
        ],
    ))
}

/// Every place at every speed as CSV, unrounded.
pub fn rule_csv(rule: &CrankRule) -> String {
    let mut out = String::new();
    let head = [
        "speed [rpm]",
        "throw",
        "place",
        "torque [N m]",
        "bending [MPa]",
        "torsion [MPa]",
        "equivalent [MPa]",
        "strength [MPa]",
        "safety",
        "safety by finite elements",
        "outside the range",
    ];
    push_csv_line(&mut out, head.map(str::to_owned));
    for sheet in &rule.speeds {
        for throw in &sheet.throws {
            for place in places(throw) {
                let stress = |of: fn(&FilletSheet) -> f64| {
                    place.stress.as_ref().map_or(String::new(), |own| csv_number(of(own)))
                };
                let outside: Vec<String> = throw
                    .breaches()
                    .filter(|(at, _)| place.name.ends_with(at.as_str()))
                    .map(|(_, breach)| breach.to_string())
                    .collect();
                let line = [
                    csv_number(number::rpm(sheet.speed)),
                    throw.throw.to_string(),
                    place.name.clone(),
                    csv_number(place.torque),
                    stress(|own| 1e-6 * own.bending),
                    stress(|own| 1e-6 * own.torsion),
                    stress(|own| 1e-6 * own.equivalent),
                    stress(|own| 1e-6 * own.strength),
                    stress(|own| own.safety),
                    place.by_elements.map_or(String::new(), |own| csv_number(own.safety)),
                    outside.join("; "),
                ];
                push_csv_line(&mut out, line);
            }
        }
    }
    out
}
