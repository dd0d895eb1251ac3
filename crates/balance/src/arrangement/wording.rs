//! What the search says in words.

use crate::arrangement::candidate::is_searched;
use crate::arrangement::request::{ArrangementRequest, DriveRule, MountPlaces, Positions};
use crate::arrangement::result::Clearance;
use lanchester_model::Engine;

/// What was assumed where the request leaves it open, and what is left out of the model.
pub(crate) fn assumptions(engine: &Engine, request: &ArrangementRequest) -> Vec<String> {
    let parts = &request.parts;
    let radius = engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
    let mut out = Vec::new();
    let mut size = |given: Option<f64>, text: &str, value: f64| {
        let origin = if given.is_some() { "as given" } else { "assumed" };
        out.push(format!("{text}: {:.1} mm ({origin})", 1e3 * given.unwrap_or(value)));
    };
    let big_end = parts.big_end_radius.unwrap_or(0.75 * radius);
    size(parts.big_end_radius, "outer radius of the big ends", 0.75 * radius);
    size(parts.crank_sweep, "radius that the crank sweeps", radius + big_end);
    size(parts.rod_width, "width of a rod across the crank", 0.5 * radius);
    size(parts.crank_journal_radius, "radius of the crankshaft beside its gears", 0.5 * radius);
    size(parts.crank_weight_radius, "centre of gravity of crank weights from the axis", radius);
    out.push(match parts.weight_sweep {
        Some(sweep) => format!("shaft weights are half discs of {:.1} mm radius", 1e3 * sweep),
        None => "shaft weights are half discs, as large as half the length over the cylinders (a third for two on one shaft) makes them, in whole mm".to_owned(),
    });
    if parts.bearing_planes.is_none() {
        out.push("each shaft has two bearings, 10 mm beyond its weights".to_owned());
    }
    if engine.cylinders.iter().any(|c| c.bore.is_none()) {
        out.push("cylinders without a bore are no obstacle to shafts".to_owned());
    }
    if let Positions::Ring { .. } = request.positions {
        out.push(
            "shafts stand on a ring just outside the crank sweep, farther out where rods need the room"
                .to_owned(),
        );
    }
    if let MountPlaces::Spacing(apart) = request.mounts {
        out.push(format!("two mounts on the crank axis, {:.1} mm apart, carry force and couple; the roll moment is listed beside", 1e3 * apart));
    }
    if request.drive == DriveRule::ChainOrBelt {
        out.push("a chain or belt drives each shaft that turns as its driver does".to_owned());
    }
    if !engine.shafts.is_empty() {
        out.push(format!("balance shafts of the file are taken out: {}", engine.shafts.len()));
    }
    let searched = engine.counterweights.iter().filter(|w| is_searched(&w.name)).count();
    if searched > 0 {
        out.push(format!("crank weights that an earlier search put into the file are taken out: {searched}"));
    }
    out.push("gears run in planes beyond the end of the crank and are solid discs".to_owned());
    out.push(
        "constant speed: weights ask for no mean torque; gravity is left out; the drive carries bearing friction and \
         mesh losses"
            .to_owned(),
    );
    out
}

/// "0.5 of the force of In-line four as it stands".
pub(crate) fn share_of(share: f64, criterion: &str, engine: &str) -> String {
    if share == 1.0 {
        format!("{criterion} of {engine} as it stands")
    } else {
        format!("{share} of the {criterion} of {engine} as it stands")
    }
}

/// An arrangement with the lightest weights that hold the limit.
pub(crate) fn lightest(name: &str) -> String {
    format!("{name}; lightest within the limit")
}

/// The same in short.
pub(crate) fn lightest_label(label: &str) -> String {
    format!("{label}, lightest")
}

/// Weights that ask for another place wherever they stand.
pub(crate) fn no_settled_place() -> Clearance {
    let between = "wherever the shafts stand, the limits ask for weights that do not fit there".to_owned();
    Clearance { distance: f64::NEG_INFINITY, between }
}

/// Why an arrangement was not examined.
pub(crate) fn enough(name: &str, smaller: &str) -> String {
    format!("{name}: {smaller} already leaves no more than all devices together")
}

/// How close the best comes.
pub(crate) fn nearest(
    request: &ArrangementRequest,
    name: &str,
    spacing: Option<f64>,
    residual: f64,
    limit: f64,
) -> String {
    let unit = request.criterion.unit();
    let at = spacing.map_or_else(String::new, |s| format!(" at {:.1} mm spacing", 1e3 * s));
    let ratio = residual / limit;
    let more = if ratio < 3.0 {
        format!("{:.1} % more", 100.0 * (ratio - 1.0))
    } else {
        format!("{ratio:.0} times as much")
    };
    let digits = if limit < 1.0 { 4 } else { 1 };
    format!(
        "nothing reaches {limit:.digits$} {unit}: the best, {name}{at}, leaves {residual:.digits$} {unit}, {more}"
    )
}
