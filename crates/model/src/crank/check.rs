//! Whether the elements of a crankshaft fit together: bores, discs of webs, fillets, undercuts, places along the crank.

use crate::crank::details::CrankDetails;
use crate::crank::elements::{CrankElement, CrankElementForm, RoundBar};
use crate::crank::expansion::CrankElementsFault;
use crate::crank::material::CrankMaterial;
use crate::crank::plain_web::TOUCH;
use crate::engine_parts::EngineParts;
use crate::fault::{Fault, Part};
use crate::running::bearing_design::{BearingData, BearingDesign, Housing};
use std::collections::HashSet;
use std::f64::consts::TAU;

/// Lengths that exceed a limit by less than this part of it have it, to rounding.
const ROUNDING: f64 = 1e-9;

/// What webs of neighbouring throws must keep.
const OVERLAP: &str = "such that it does not overlap the web before it: at most";

/// A size of an element that does not fit the others. Lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrankFault {
    /// Which element.
    pub place: CrankPlace,
    /// Which of its sizes: the key of the file.
    pub key: &'static str,
    /// What it must be against the limit: "less than its diameter,".
    pub bound: &'static str,
    /// The limit [m].
    pub limit: f64,
    /// What it is [m].
    pub got: f64,
    /// What to do.
    pub remedy: &'static str,
}

impl CrankFault {
    /// Whether it is about a web that overlaps the one before it.
    pub fn is_overlap(&self) -> bool {
        self.bound == OVERLAP
    }
}

/// Which element of a crankshaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CrankPlace {
    /// A journal.
    Journal {
        /// Index of its crankshaft.
        crankshaft: usize,
        /// Its index along it.
        journal: usize,
    },
    /// The pin of a throw.
    Pin(usize),
    /// A web, counted through all throws.
    Web(usize),
    /// A step of nose or flange: its index in [`CrankDetails::ends`].
    End(usize),
}

impl CrankPlace {
    /// "journal 2", "pin 1", "web 3", "step 1 of nose and flange".
    pub fn name(self) -> String {
        match self {
            CrankPlace::Journal { crankshaft: 0, journal } => format!("journal {}", journal + 1),
            CrankPlace::Journal { crankshaft, journal } => {
                format!("journal {} of crankshaft {}", journal + 1, crankshaft + 1)
            }
            CrankPlace::Pin(throw) => format!("pin {}", throw + 1),
            CrankPlace::Web(web) => format!("web {}", web + 1),
            CrankPlace::End(step) => format!("step {} of nose and flange", step + 1),
        }
    }
}

/// Sizes of single elements that do not fit the others, of all crankshafts; none where the engine gives no [`CrankDetails`].
pub fn crank_faults(parts: &EngineParts) -> Vec<CrankFault> {
    let mut found = Vec::new();
    let Some(details) = &parts.crank_details else { return found };
    for (index, step) in details.ends.iter().enumerate() {
        bore(CrankPlace::End(index), step.bore, step.diameter, &mut found);
    }
    for crankshaft in 0..parts.crankshafts.len() {
        match parts.crank_elements(crankshaft) {
            Ok(elements) => of_elements(parts, crankshaft, &elements, &mut found),
            Err(CrankElementsFault::NoPin { throw, length }) => found.push(CrankFault {
                place: CrankPlace::Web(2 * throw),
                key: "position",
                bound: "such that a crankpin stays between the webs, whose length is more than",
                limit: 0.0,
                got: length,
                remedy: "set the webs farther apart, or make them thinner",
            }),
            // Told of the engine as a whole.
            Err(_) => {}
        }
    }
    // What all journals or pins share is one mistake.
    let mut seen = HashSet::new();
    found.retain(|fault| seen.insert((fault.place, fault.key)));
    found
}

fn bore(place: CrankPlace, bore: f64, diameter: f64, found: &mut Vec<CrankFault>) {
    if bore >= diameter {
        let remedy = "give a smaller bore or a larger diameter: both are diameters";
        found.push(CrankFault {
            place,
            key: "bore",
            bound: "less than its diameter,",
            limit: diameter,
            got: bore,
            remedy,
        });
    }
}

fn of_elements(
    parts: &EngineParts,
    crankshaft: usize,
    elements: &[CrankElement],
    found: &mut Vec<CrankFault>,
) {
    let mut places = Vec::new();
    for element in elements {
        places.push(match element.form {
            CrankElementForm::Journal { journal, .. } => Some(CrankPlace::Journal { crankshaft, journal }),
            CrankElementForm::Pin { throw, .. } => Some(CrankPlace::Pin(throw)),
            CrankElementForm::Web { web, .. } => Some(CrankPlace::Web(web)),
            CrankElementForm::Nose { .. } | CrankElementForm::Flange { .. } => None,
        });
    }
    for (index, element) in elements.iter().enumerate() {
        let Some(place) = places[index] else { continue };
        let neighbours = [index.checked_sub(1).map(|before| &elements[before]), elements.get(index + 1)];
        match &element.form {
            CrankElementForm::Web { .. } => of_web(place, element, neighbours, found),
            CrankElementForm::Journal { bar, .. } => of_bar(place, element, bar, 0, neighbours, found),
            CrankElementForm::Pin { bar, oil_hole, throw } => {
                of_bar(place, element, bar, 1, neighbours, found);
                if let Some(hole) = oil_hole.filter(|hole| hole.diameter >= bar.diameter) {
                    found.push(CrankFault {
                        place,
                        key: "oil_hole",
                        bound: "less than the diameter of the pin,",
                        limit: bar.diameter,
                        got: hole.diameter,
                        remedy: "its diameter is that of the drilled hole",
                    });
                }
                let plane = parts.throws[*throw].z;
                if plane < element.faces[0] - TOUCH || plane > element.faces[1] + TOUCH {
                    found.push(CrankFault {
                        place: CrankPlace::Web(2 * throw + usize::from(plane > element.faces[1])),
                        key: "position",
                        bound: "on its own side of the plane of the throw, at",
                        limit: plane,
                        got: if plane > element.faces[1] { element.faces[1] } else { element.faces[0] },
                        remedy: "the front web stands before the plane of its throw, the rear one behind it",
                    });
                }
            }
            _ => {}
        }
    }
}

/// Webs of neighbouring throws must not overlap, and undercuts must leave something of a web.
fn of_web(
    place: CrankPlace,
    element: &CrankElement,
    neighbours: [Option<&CrankElement>; 2],
    found: &mut Vec<CrankFault>,
) {
    if let Some(before) = neighbours[0]
        && before.faces[1] > element.faces[0] + TOUCH
    {
        found.push(CrankFault {
            place,
            key: "thickness",
            bound: OVERLAP,
            limit: element.length() - (before.faces[1] - element.faces[0]),
            got: element.length(),
            remedy: "make the webs thinner, or set the throws farther apart",
        });
    }
    let undercut = |side: usize| {
        let bar = neighbours[side].and_then(CrankElement::bar)?;
        bar.fillets[1 - side].map(|fillet| fillet.recess)
    };
    let depth = undercut(0).unwrap_or(0.0) + undercut(1).unwrap_or(0.0);
    if depth > 0.0 && depth >= element.length() {
        found.push(CrankFault {
            place,
            key: "thickness",
            bound: "more than the undercuts of both its faces together,",
            limit: depth,
            got: element.length(),
            remedy: "make the undercuts shallower, or the web thicker",
        });
    }
}

/// A bar's bore, its fillets, and the discs of its webs; `disc` says which one of a web's is about it.
fn of_bar(
    place: CrankPlace,
    element: &CrankElement,
    bar: &RoundBar,
    disc: usize,
    neighbours: [Option<&CrankElement>; 2],
    found: &mut Vec<CrankFault>,
) {
    bore(place, bar.bore, bar.diameter, found);
    let radius_at = |side: usize| match neighbours[side]?.form {
        CrankElementForm::Web { discs, .. } => Some(discs[disc].radius),
        _ => None,
    };
    let least = [0, 1].into_iter().filter_map(radius_at).reduce(f64::min);
    if let Some(least) = least
        && bar.diameter > 2.0 * least * (1.0 + ROUNDING)
    {
        found.push(CrankFault {
            place,
            key: "diameter",
            bound: "at most that of its webs about it,",
            limit: 2.0 * least,
            got: bar.diameter,
            remedy: "diameters of journals and pins, but radii of webs, are given",
        });
        return;
    }
    let fillets = bar.fillets.into_iter().flatten();
    for fillet in fillets.clone() {
        let radius = fillet.radius.unwrap_or(0.0);
        if fillet.recess > radius * (1.0 + ROUNDING) {
            found.push(CrankFault {
                place,
                key: "recess",
                bound: "at most the radius of its fillet,",
                limit: radius,
                got: fillet.recess,
                remedy: "an undercut is no deeper than its fillet: give a larger fillet or a smaller recess",
            });
        }
        if let Some(room) = least.map(|least| least - bar.diameter / 2.0)
            && radius > room * (1.0 + ROUNDING)
        {
            found.push(CrankFault {
                place,
                key: "fillet",
                bound: "at most what the web's edge leaves beside it,",
                limit: room,
                got: radius,
                remedy: "give a smaller fillet, or a larger radius of the web",
            });
        }
    }
    let lengths: f64 = fillets.clone().map(|fillet| fillet.length()).sum();
    if lengths > element.length() * (1.0 + ROUNDING) {
        let count = fillets.clone().count().max(1) as f64;
        let recess = fillets.map(|fillet| fillet.recess).fold(0.0, f64::max);
        found.push(CrankFault {
            place,
            key: "fillet",
            bound: "such that the fillets of both ends do not meet: at most",
            limit: element.length() / count + recess,
            got: lengths / count + recess,
            remedy: "give a smaller fillet or an undercut",
        });
    }
}

/// Adds the faults of elements, material and bearings.
pub(crate) fn check(parts: &EngineParts, faults: &mut Vec<Fault>) {
    if let Some(details) = &parts.crank_details {
        let before = faults.len();
        of_details(details, parts, faults);
        // Whether the elements fit together can be told only of numbers that are right.
        if faults.len() == before {
            faults.extend(crank_faults(parts).into_iter().map(|fault| Fault {
                part: fault.place.name(),
                quantity: fault.key,
                needed: format!("{} {}", fault.bound, fault.limit),
                got: fault.got.to_string(),
                remedy: fault.remedy,
            }));
        }
    }
    if let Some(material) = &parts.crank_material {
        of_material(material, &mut Part { faults, name: &|| "crank_material".into() });
    }
    if let Some(design) = &parts.bearing_design {
        of_bearings(design, parts, faults);
    }
}

fn of_details(details: &CrankDetails, parts: &EngineParts, faults: &mut Vec<Fault>) {
    let part = &mut Part { faults, name: &|| "crank_details".into() };
    if parts.crank_body.is_none() {
        part.add(
            "crank_body",
            "given",
            "none",
            "give the uniform body: its sizes hold where a detail says nothing",
        );
    }
    for fillet in [details.pin_fillet, details.journal_fillet] {
        fillet.radius.iter().for_each(|radius| part.not_negative("fillet [m]", *radius));
        part.not_negative("recess [m]", fillet.recess);
    }
    let sizes = |part: &mut Part<'_>, diameter: Option<f64>, others: [Option<f64>; 3]| {
        diameter.iter().for_each(|diameter| part.positive("diameter [m]", *diameter));
        for (quantity, value) in ["bore [m]", "fillet [m]", "recess [m]"].into_iter().zip(others) {
            value.iter().for_each(|value| part.not_negative(quantity, *value));
        }
    };
    let hole = |part: &mut Part<'_>, hole: Option<crate::OilHole>| {
        if let Some(hole) = hole {
            part.positive("oil_hole diameter [m]", hole.diameter);
            part.finite("oil_hole angle [rad]", hole.angle);
        }
    };
    hole(part, details.oil_hole);
    let mut known = HashSet::new();
    for (index, own) in details.journals.iter().enumerate() {
        let part = &mut Part { faults, name: &|| format!("crank_details.journals[{index}]") };
        if part.index("crankshaft", own.crankshaft, parts.crankshafts.len())
            && let Ok(elements) = parts.crank_elements(own.crankshaft)
        {
            let count =
                elements.iter().filter(|e| matches!(e.form, CrankElementForm::Journal { .. })).count();
            part.index("journal", own.journal, count);
        }
        once(part, known.insert(CrankPlace::Journal { crankshaft: own.crankshaft, journal: own.journal }));
        sizes(part, own.diameter, [own.bore, own.fillet, own.recess]);
    }
    for (index, own) in details.pins.iter().enumerate() {
        let part = &mut Part { faults, name: &|| format!("crank_details.pins[{index}]") };
        part.index("throw", own.throw, parts.throws.len());
        once(part, known.insert(CrankPlace::Pin(own.throw)));
        sizes(part, own.diameter, [own.bore, own.fillet, own.recess]);
        hole(part, own.oil_hole);
    }
    for (index, own) in details.webs.iter().enumerate() {
        let part = &mut Part { faults, name: &|| format!("crank_details.webs[{index}]") };
        part.index("web", own.web, 2 * parts.throws.len());
        once(part, known.insert(CrankPlace::Web(own.web)));
        own.thickness.iter().for_each(|value| part.positive("thickness [m]", *value));
        own.radius.iter().for_each(|value| part.positive("radius [m]", *value));
        own.pin_end_radius.iter().for_each(|value| part.positive("pin_end_radius [m]", *value));
    }
    for (index, step) in details.ends.iter().enumerate() {
        let part = &mut Part { faults, name: &|| format!("crank_details.ends[{index}]") };
        part.index("crankshaft", step.crankshaft, parts.crankshafts.len());
        part.positive("length [m]", step.length);
        part.positive("diameter [m]", step.diameter);
        part.not_negative("bore [m]", step.bore);
    }
}

fn once(part: &mut Part<'_>, is_new: bool) {
    if !is_new {
        part.add("place", "that of no other of its kind", "one that is there already", "join the two");
    }
}

fn of_material(material: &CrankMaterial, part: &mut Part<'_>) {
    let positive = [
        ("youngs_modulus [Pa]", material.youngs_modulus),
        ("tensile_strength [Pa]", material.tensile_strength),
        ("yield_strength [Pa]", material.yield_strength),
        ("fatigue_bending [Pa]", material.fatigue_bending),
        ("fatigue_torsion [Pa]", material.fatigue_torsion),
    ];
    for (quantity, value) in positive {
        value.iter().for_each(|value| part.positive(quantity, *value));
    }
    for (quantity, value) in
        [("loss_factor", material.loss_factor), ("damping_ratio", material.damping_ratio)]
    {
        value.iter().for_each(|value| part.not_negative(quantity, *value));
    }
    if let Some(ratio) = material.poisson_ratio
        && !(0.0..0.5).contains(&ratio)
    {
        part.add("poisson_ratio", "from 0 to below 0.5", ratio, "of steel it is 0.3");
    }
    if let (Some(tensile), Some(limit)) = (material.tensile_strength, material.yield_strength)
        && limit > tensile
    {
        part.add(
            "yield_strength [Pa]",
            format!("at most the tensile strength {tensile}"),
            limit,
            "exchange the two",
        );
    }
}

fn of_bearings(design: &BearingDesign, parts: &EngineParts, faults: &mut Vec<Fault>) {
    let mains = parts.main_bearings().len();
    let all =
        [("bearings.main".to_owned(), &design.main), ("bearings.crankpin".to_owned(), &design.crankpin)];
    let each = |name: &'static str, list: &'_ [(usize, BearingData)]| -> Vec<(String, BearingData)> {
        list.iter().map(|(index, data)| (format!("bearings.{name}[{index}]"), data.clone())).collect()
    };
    let own = [each("main", &design.main_each), each("crankpin", &design.crankpin_each)].concat();
    for (name, data) in all.into_iter().chain(own.iter().map(|(name, data)| (name.clone(), data))) {
        of_bearing(data, &mut Part { faults, name: &|| name.clone() });
    }
    for (list, count, what) in [
        (&design.main_each, mains, "main_each"),
        (&design.crankpin_each, parts.cylinders.len(), "crankpin_each"),
    ] {
        let part = &mut Part { faults, name: &|| format!("bearing_design.{what}") };
        let mut known = HashSet::new();
        for (index, _) in list {
            part.index("number", *index, count);
            once(part, known.insert(index));
        }
    }
    let part = &mut Part { faults, name: &|| "bearings.film".into() };
    let oil = &design.oil;
    for (quantity, value) in [
        ("viscosity [Pa s]", oil.viscosity),
        ("temperature [K]", oil.temperature),
        ("density [kg/m^3]", oil.density),
    ] {
        value.iter().for_each(|value| part.positive(quantity, *value));
    }
    for (quantity, value) in [("supply_pressure [Pa]", oil.supply_pressure), ("roughness [m]", oil.roughness)]
    {
        value.iter().for_each(|value| part.not_negative(quantity, *value));
    }
}

fn of_bearing(data: &BearingData, part: &mut Part<'_>) {
    for (quantity, value) in [
        ("width [m]", data.width),
        ("diametral_clearance [m]", data.diametral_clearance),
        ("stiffness [N/m]", data.stiffness),
    ] {
        value.iter().for_each(|value| part.positive(quantity, *value));
    }
    data.damping.iter().for_each(|value| part.not_negative("damping [N s/m]", *value));
    if let Some(Housing::Stiffness(stiffness)) = data.housing {
        part.positive("housing_stiffness [N/m]", stiffness);
    }
    for groove in data.grooves.iter().flatten() {
        part.finite("grooves.from [rad]", groove.from);
        part.positive("grooves.width [m]", groove.width);
        let length = groove.to - groove.from;
        if !(length > 0.0 && length <= TAU * (1.0 + ROUNDING)) {
            part.add(
                "grooves.to [rad]",
                "after `from`, at most a turn on",
                groove.to,
                "give both ends in one sense",
            );
        }
        if let Some(width) = data.width.filter(|width| groove.width >= *width) {
            part.add(
                "grooves.width [m]",
                format!("less than the bearing's {width}"),
                groove.width,
                "give a narrower groove",
            );
        }
    }
}
