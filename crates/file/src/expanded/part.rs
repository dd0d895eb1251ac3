//! `[crank.body]`, counterweights as parts, `[counterweight_design]` and `[clearance]`.

use super::text::{File, quantity, turn_between};
use lanchester_model::angle;
use lanchester_model::{Counterweight, Engine};
use lanchester_model::{CounterweightForm, CounterweightPart};
use lanchester_shape::{Chamfer, Contour, Cut, Face, Insert};
use lanchester_task::{Objective, Range, Shoulder, Tasks};
use lanchester_units::{Dimension, text_that};
use std::f64::consts::PI;

impl File {
    pub(super) fn crank_body(&mut self, engine: &Engine) {
        let Some(body) = &engine.crank_body else { return };
        self.header("[crank.body]", "");
        self.entry("density", &quantity(body.density, Dimension::Density));
        for (key, value) in [
            ("journal_diameter", body.journal_diameter),
            ("journal_bore", body.journal_bore),
            ("pin_diameter", body.pin_diameter),
            ("pin_bore", body.pin_bore),
            ("web_thickness", body.web_thickness),
            ("web_radius", body.web_radius),
            ("pin_end_radius", body.pin_end_radius),
        ] {
            self.entry_unless_zero(key, value, Dimension::Length);
        }
        let ends = body.end_journals.map(|length| quantity(length, Dimension::Length));
        self.entry("end_journals", &format!("[{}]", ends.join(", ")));
        self.crank_details(engine);
    }

    /// Place, wanted unbalance, direction and shape of a weight that is a part.
    pub(super) fn part(&mut self, weight: &Counterweight, part: &CounterweightPart, engine: &Engine) {
        if let Some(web) = part.web {
            self.entry("web", &(web + 1).to_string());
        } else {
            if weight.crankshaft > 0 {
                self.entry("crankshaft", &(weight.crankshaft + 1).to_string());
            }
            self.entry("z", &quantity(part.z, Dimension::Length));
        }
        if let Some(wanted) = part.wanted {
            self.entry("unbalance", &quantity(wanted, Dimension::Unbalance));
        }
        match part.web.and_then(|web| engine.throws.get(web / 2)) {
            None => self.entry("angle", &quantity(part.angle, Dimension::Angle)),
            Some(throw) => {
                if angle::direction(throw.angle + PI) != part.angle {
                    self.entry("angle", &turn_between(throw.angle, part.angle));
                }
            }
        }
        self.header("[counterweight.shape]", "");
        for (key, value) in shape_entries(part, &quantity, "\n") {
            self.entry(key, &value);
        }
    }

    pub(super) fn shape_task(&mut self, tasks: &Tasks) {
        let Some(task) = &tasks.shape_task else { return };
        self.header("[counterweight_design]", "");
        let word = match task.minimise {
            Objective::Mass => "mass",
            Objective::SweptRadius => "swept radius",
            Objective::Inertia => "inertia",
            Objective::Thickness => "thickness",
        };
        self.entry("minimise", &format!("\"{word}\""));
        let least = quantity(task.least_balance, Dimension::Share);
        let balance = match task.most_balance {
            Some(most) => format!("[{least}, {}]", quantity(most, Dimension::Share)),
            None => least,
        };
        self.entry("balance", &balance);
        self.entry("density", &quantity(task.density, Dimension::Density));
        let (shoulder, shoulder_range, dimension) = match task.shoulder {
            Shoulder::Angle(range) => ("shoulder_angle", range, Dimension::Angle),
            Shoulder::Height(range) => ("shoulder_height", range, Dimension::Length),
        };
        for (key, range, dimension) in [
            ("web_radius", task.web_radius, Dimension::Length),
            ("rectangle_height", task.rectangle_height, Dimension::Length),
            (shoulder, shoulder_range, dimension),
            ("arc_radius", task.arc_radius, Dimension::Length),
            ("arc_angle", task.arc_angle, Dimension::Angle),
            ("thickness", task.thickness, Dimension::Length),
        ] {
            self.entry(key, &range_text(range, dimension));
        }
        let limits = &task.limits;
        let single = [
            ("mass", limits.mass, Dimension::Mass),
            ("swept_radius", limits.swept_radius, Dimension::Length),
            ("inertia", limits.inertia, Dimension::Inertia),
            ("half_width", limits.half_width, Dimension::Length),
        ];
        let ranges = [
            ("shoulder_angle", limits.shoulder_angle, Dimension::Angle),
            ("shoulder_height", limits.shoulder_height, Dimension::Length),
        ];
        let single =
            single.map(|(key, value, dimension)| (key, value.map(|value| quantity(value, dimension))));
        let ranges =
            ranges.map(|(key, range, dimension)| (key, range.map(|range| range_text(range, dimension))));
        let entries: Vec<String> = single
            .into_iter()
            .chain(ranges)
            .filter_map(|(key, value)| value.map(|value| format!("{key} = {value}")))
            .collect();
        if !entries.is_empty() {
            self.entry("limits", &format!("{{ {} }}", entries.join(", ")));
        }
    }

    pub(super) fn clearance(&mut self, engine: &Engine) {
        let Some(envelope) = &engine.envelope else { return };
        self.header("[clearance]", "");
        let (skirt, liner, rod) = (envelope.skirt, envelope.liner, envelope.rod);
        for (key, value) in [
            ("least", envelope.least),
            ("crankcase_radius", envelope.crankcase_radius),
            ("skirt_length", skirt.map(|skirt| skirt.length)),
            ("skirt_width", skirt.and_then(|skirt| skirt.width)),
            ("liner_end", liner.map(|liner| liner.end)),
            ("liner_wall", liner.map(|liner| liner.wall)),
            ("big_end_radius", rod.map(|rod| rod.big_end_radius)),
            ("big_end_width", rod.map(|rod| rod.big_end_width)),
            ("shank_width", rod.map(|rod| rod.shank_width)),
            ("shank_thickness", rod.map(|rod| rod.shank_thickness)),
        ] {
            if let Some(value) = value {
                self.entry(key, &quantity(value, Dimension::Length));
            }
        }
    }
}

pub(super) fn range_text(range: Range, dimension: Dimension) -> String {
    if range.least == range.most {
        return quantity(range.least, dimension);
    }
    format!("[{}, {}]", quantity(range.least, dimension), quantity(range.most, dimension))
}

/// Keys and values of a shape; `text` writes a quantity. Lists of tables have a line for each, unless `line_end` is empty.
pub(crate) fn shape_entries(
    part: &CounterweightPart,
    text: &dyn Fn(f64, Dimension) -> String,
    line_end: &str,
) -> Vec<(&'static str, String)> {
    let plate = &part.part;
    let mut entries = vec![
        ("thickness", text(plate.thickness(), Dimension::Length)),
        ("density", text(plate.density(), Dimension::Density)),
    ];
    let lines = |tables: Vec<String>| {
        if line_end.is_empty() {
            return format!("[{}]", tables.join(", "));
        }
        let tables: String = tables.iter().map(|table| format!("    {table},{line_end}")).collect();
        format!("[{line_end}{tables}]")
    };
    let corners = |contour: &Contour| -> Vec<String> {
        contour
            .edges()
            .iter()
            .map(|edge| {
                let [x, y] = [edge.from.x, edge.from.y].map(|value| text(value, Dimension::Length));
                let bulge =
                    if edge.bulge == 0.0 { String::new() } else { format!(", bulge = {:?}", edge.bulge) };
                format!("{{ x = {x}, y = {y}{bulge} }}")
            })
            .collect()
    };
    if let CounterweightForm::Family(family) = part.form {
        entries.extend([
            ("web_radius", text(family.web_radius, Dimension::Length)),
            ("rectangle_height", text(family.rectangle_height, Dimension::Length)),
            ("shoulder_height", text(family.shoulder_height, Dimension::Length)),
            ("arc_radius", text(family.arc_radius, Dimension::Length)),
            ("arc_angle", text(family.arc_angle, Dimension::Angle)),
        ]);
    } else {
        entries.push(("outline", lines(corners(plate.outline().outer()))));
        if part.form == CounterweightForm::Web {
            entries.push(("encloses", "\"web\"".to_string()));
        }
        let holes = plate.outline().holes();
        if !holes.is_empty() {
            let tables = holes.iter().map(|hole| format!("{{ corners = [{}] }}", corners(hole).join(", ")));
            entries.push(("openings", lines(tables.collect())));
        }
    }
    if !plate.inserts().is_empty() {
        let tables = plate.inserts().iter().map(|insert| insert_table(insert, plate.thickness(), text));
        entries.push(("inserts", lines(tables.collect())));
    }
    if !plate.chamfers().is_empty() {
        let tables = plate.chamfers().iter().map(|chamfer| chamfer_table(chamfer, text));
        entries.push(("chamfers", lines(tables.collect())));
    }
    entries
}

fn face(face: Face) -> &'static str {
    match face {
        Face::Front => "front",
        Face::Rear => "rear",
    }
}

fn insert_table(insert: &Insert, thickness: f64, text: &dyn Fn(f64, Dimension) -> String) -> String {
    let length = |value: f64| text(value, Dimension::Length);
    let (x, y, radius) = (length(insert.centre.x), length(insert.centre.y), length(insert.radius));
    let density = match insert.density {
        0.0 => String::new(),
        density => format!(", density = {}", text(density, Dimension::Density)),
    };
    let depth = if insert.from == 0.0 && insert.to == thickness {
        String::new()
    } else if insert.to == thickness {
        let depth = text_that(thickness - insert.from, Dimension::Length, |d| thickness - d == insert.from);
        format!(", face = \"rear\", depth = \"{depth}\"")
    } else {
        format!(", face = \"front\", depth = {}", length(insert.to))
    };
    format!("{{ x = {x}, y = {y}, radius = {radius}{density}{depth} }}")
}

fn chamfer_table(chamfer: &Chamfer, text: &dyn Fn(f64, Dimension) -> String) -> String {
    let cut = match chamfer.cut {
        Cut::Turned { radius } => format!("radius = {}", text(radius, Dimension::Length)),
        Cut::Milled { direction, distance } => format!(
            "distance = {}, direction = {}",
            text(distance, Dimension::Length),
            text(direction, Dimension::Angle)
        ),
    };
    let angle = text(chamfer.angle, Dimension::Angle);
    format!("{{ face = \"{}\", angle = {angle}, {cut} }}", face(chamfer.face))
}
