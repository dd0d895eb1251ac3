//! `[crank.body]`, counterweights as parts, `[counterweight_design]` and `[clearance]`.

use lanchester_file::{EngineFile, Severity, expanded, json_schema, read, render};
use lanchester_model::{CounterweightForm, Engine};
use lanchester_task::{Objective, Range, Shoulder};
use proptest::prelude::*;
use std::f64::consts::PI;

const HEAD: &str = r#"name = "Twin"
speed = "3000 rpm"
[piston]
mass = "0.3 kg"
bore = "70 mm"
[rod]
length = "110 mm"
mass = "0.3 kg"
[layout]
type = "in-line"
cylinders = 2
spacing = "80 mm"
crank_angles = ["0 deg", "180 deg"]
[crank]
stroke = "60 mm"
web_distance = "36 mm"
"#;

const BODY: &str = r#"[crank.body]
density = "7.85 g/cm3"
journal_diameter = "48 mm"
journal_bore = "12 mm"
pin_diameter = "40 mm"
pin_bore = "16 mm"
web_thickness = "14 mm"
web_radius = "32 mm"
pin_end_radius = "32 mm"
end_journals = ["25 mm", "1.5 in"]
"#;

const FAMILY: &str = r#"[[counterweight]]
web = 1
unbalance = "0.0207 kg m"
[counterweight.shape]
thickness = "14 mm"
rectangle_height = "15 mm"
shoulder_angle = "35 deg"
arc_radius = "62 mm"
arc_angle = "110 deg"
"#;

/// The engine of a text, which must read back from its expanded form to the last bit.
fn engine(text: &str) -> Engine {
    file(text).engine
}

/// As [`engine`], with what is asked of it.
fn file(text: &str) -> EngineFile {
    let reading = read(text);
    let shown = render(&reading.diagnostics, "engine.toml", text, false);
    let file = reading.file.unwrap_or_else(|| panic!("{shown}\n{text}"));
    let printed = expanded(&file);
    let again = read(&printed);
    let shown = render(&again.diagnostics, "expanded.toml", &printed, false);
    assert_eq!(again.file.as_ref(), Some(&file), "{shown}\n{printed}");
    file
}

fn codes(text: &str) -> Vec<&'static str> {
    read(text).diagnostics.iter().map(|diagnostic| diagnostic.code).collect()
}

/// Equal but for rounding: sums of some ten terms of like size.
fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-13 * a.abs().max(b.abs()), "{a} {b}");
}

#[test]
fn the_body_gives_the_unbalance_of_every_throw() {
    let engine = engine(&format!("{HEAD}{BODY}"));
    let body = engine.crank_body.expect("a body");
    assert_eq!((body.density, body.end_journals), (7850.0, [0.025, 1.5 * 0.0254]));
    // Two equal discs make a slot: its centroid lies half a crank radius towards the pin.
    let (r, t, disc) = (0.03, 0.014, 0.032);
    let pin = PI / 4.0 * (0.04f64.powi(2) - 0.016f64.powi(2)) * (0.036 - t) * r;
    let web = t * (PI * disc * disc + 2.0 * disc * r) * r / 2.0;
    for throw in &engine.throws {
        near(throw.unbalance, 7850.0 * (pin + 2.0 * web));
    }
    // It is what the short form of the counterweights balances.
    let short = self::engine(&format!("{HEAD}{BODY}[counterweights]\nrotating_share = \"100 %\"\n"));
    near(short.counterweights[1].unbalance, short.rotating_unbalance(1));
}

#[test]
fn a_family_shape_is_its_part_without_the_disc() {
    let engine = engine(&format!("{HEAD}{BODY}{FAMILY}"));
    let weight = &engine.counterweights[0];
    let part = weight.part.as_ref().expect("a part");
    let CounterweightForm::Family(family) = part.form else { panic!("{:?}", part.form) };
    assert_eq!((family.web_radius, part.part.density()), (0.032, 7850.0));
    near(family.shoulder_angle(), 35f64.to_radians());
    let moment = family.closed_form().expect("shoulders stand out").first.x;
    near(weight.unbalance, 7850.0 * 0.014 * moment);
    assert_eq!(weight.z, engine.throws[0].webs.expect("webs")[0]);
    assert_eq!(weight.angle, PI);
    assert_eq!((part.web, part.wanted), (Some(0), Some(0.0207)));
}

#[test]
fn a_shape_within_the_web_is_what_stands_out_of_its_faces() {
    let small = |thickness: f64| {
        let shape = format!(
            "[[counterweight]]\nweb = 2\n[counterweight.shape]\nthickness = \"{thickness} mm\"\nweb_radius = \"15 mm\"\n\
             rectangle_height = \"6 mm\"\nshoulder_height = \"4 mm\"\narc_radius = \"22 mm\"\narc_angle = \"100 deg\"\n"
        );
        engine(&format!("{HEAD}{BODY}{shape}")).counterweights[0].clone()
    };
    assert_eq!((small(9.0).unbalance, small(14.0).unbalance), (0.0, 0.0));
    let thick = small(17.0);
    let part = thick.part.as_ref().expect("a part");
    let CounterweightForm::Family(family) = part.form else { panic!("{:?}", part.form) };
    let moment = family.closed_form().expect("shoulders stand out").first.x;
    assert!((thick.unbalance - 7850.0 * 0.003 * moment).abs() < 1e-12 * thick.unbalance);
}

/// Half widths across the line of both axes, in slices: what the shape has in common with the web is no part of it.
#[test]
fn what_lies_on_the_plain_web_is_the_webs() {
    for (angle, side) in [("180 deg", 1.0), ("0 deg", -1.0)] {
        let body = BODY.replace("pin_end_radius = \"32 mm\"", "pin_end_radius = \"41 mm\"");
        let shape =
            FAMILY.replace("14 mm", "12 mm").replace("web = 1", &format!("web = 1\nangle = \"{angle}\""));
        let engine = engine(&format!("{HEAD}{body}{shape}web_radius = \"27 mm\"\ndensity = \"7.2 g/cm3\"\n"));
        let weight = &engine.counterweights[0];
        let part = weight.part.as_ref().expect("a part");
        let CounterweightForm::Family(family) = part.form else { panic!("{:?}", part.form) };
        let (disc, end, throw) = (0.032, 0.041, 0.03);
        let circle = |x: f64, radius: f64| (radius * radius - x * x).max(0.0).sqrt();
        let web = |x: f64| {
            // Towards the pin the web grows.
            let (towards, sine) = (-x, (end - disc) / throw);
            let from = disc * -sine;
            let to = throw - end * sine;
            if towards >= from && towards <= to {
                (disc + sine * towards) / (1.0f64 - sine * sine).sqrt()
            } else if towards < from {
                circle(x, disc)
            } else {
                circle(towards - throw, end)
            }
        };
        let own = |x: f64| {
            let (h, y_s) = (family.rectangle_height, family.chord_distance());
            let disc = circle(x, family.web_radius);
            if x < 0.0 {
                disc
            } else if x <= h {
                family.web_radius
            } else if x <= y_s {
                family.web_radius + family.shoulder() * (x - h) / family.shoulder_height
            } else {
                circle(x - family.centre_distance(), family.arc_radius).max(disc)
            }
        };
        let steps = 400_000;
        let (low, high) = (-0.03, family.crown());
        let step = (high - low) / f64::from(steps);
        let moment: f64 = (0..steps)
            .map(|k| {
                let x = low + (f64::from(k) + 0.5) * step;
                2.0 * (own(x) - own(x).min(web(side * x))).max(0.0) * x * step
            })
            .sum();
        let unbalance = 7200.0 * 0.012 * moment;
        // Midpoint slices of a width that grows like a root at its ends: 1e-7.
        assert!(
            (weight.unbalance - unbalance).abs() < 1e-6 * unbalance,
            "{angle}: {} {unbalance}",
            weight.unbalance
        );
    }
}

#[test]
fn a_shape_that_misses_its_unbalance_is_told() {
    let text = |unbalance: f64| format!("{HEAD}{BODY}{}", FAMILY.replace("0.0207", &unbalance.to_string()));
    let unbalance = engine(&text(1.0)).counterweights[0].unbalance;
    assert_eq!(codes(&text(unbalance * 1.0095)), Vec::<&str>::new());
    assert_eq!(codes(&text(unbalance * 0.9905)), Vec::<&str>::new());
    assert_eq!(codes(&text(unbalance * 1.0105)), ["W0901"]);
    assert_eq!(codes(&text(unbalance * 0.9895)), ["W0901"]);
}

#[test]
fn an_outline_of_its_own_has_its_own_direction() {
    // A block beside the axis of the weight, on a plane of its own.
    let text = format!(
        "{HEAD}[[counterweight]]\nz = \"10 mm\"\nangle = \"30 deg\"\n[counterweight.shape]\nthickness = \"20 mm\"\n\
         density = \"0.25 lb/in3\"\noutline = [\n{{ x = \"30 mm\", y = \"20 mm\" }},\n{{ x = \"50 mm\", y = \"20 mm\" }},\n\
         {{ x = \"50 mm\", y = \"40 mm\" }},\n{{ x = \"30 mm\", y = \"40 mm\" }},\n]\n"
    );
    let weight = &engine(&text).counterweights[0];
    let density = 0.25 * 0.453_592_37 / 0.0254f64.powi(3);
    near(weight.unbalance, density * 0.02 * 0.02 * 0.02 * 0.05);
    near(weight.angle, 30f64.to_radians() + 0.03f64.atan2(0.04));
    assert_eq!(weight.z, 0.01);
}

#[test]
fn openings_inserts_and_chamfers_count() {
    let square = "outline = [{ x = \"-40 mm\", y = \"-40 mm\" }, { x = \"40 mm\", y = \"-40 mm\" }, \
                  { x = \"40 mm\", y = \"40 mm\" }, { x = \"-40 mm\", y = \"40 mm\" }]\n";
    let text = format!(
        "{HEAD}[[counterweight]]\nthrow = 2\n[counterweight.shape]\nthickness = \"20 mm\"\ndensity = \"7850 kg/m3\"\n{square}\
         openings = [{{ corners = [{{ x = \"-20 mm\", y = \"0 mm\", bulge = 1 }}, {{ x = \"-10 mm\", y = \"0 mm\", bulge = 1.0 }}] }}]\n\
         inserts = [{{ x = \"20 mm\", y = \"0 mm\", radius = \"6 mm\", density = \"18 kg/dm3\", face = \"rear\", depth = \"5 mm\" }}]\n\
         chamfers = [{{ face = \"front\", angle = \"45 deg\", distance = \"30 mm\", direction = \"180 deg\" }}]\n"
    );
    let engine = engine(&text);
    let weight = &engine.counterweights[0];
    let (opening, insert) = (PI * 0.005f64.powi(2) * 0.02 * 0.015, PI * 0.006f64.powi(2) * 0.005 * 0.02);
    // The chamfer is a prism: a right triangle of 10 mm, its centroid two thirds out and one third deep.
    let prism = 0.01 * 0.01 / 2.0 * 0.08;
    let arm = -(0.03 + 0.02 / 3.0);
    let unbalance = 7850.0 * (opening - prism * arm) + (18000.0 - 7850.0) * insert;
    // INTEGRAL x z over its cut, x = -(30 mm + s), z from the face at -10 mm to -10 mm + s, s up to 10 mm.
    let s = 0.01f64;
    let cut =
        -0.03 * (-0.01 * s.powi(2) / 2.0 + s.powi(3) / 6.0) - (-0.01 * s.powi(3) / 3.0 + s.powi(4) / 8.0);
    let lever = (18000.0 - 7850.0) * insert * 0.0075 - 7850.0 * cut * 0.08;
    near(weight.unbalance, unbalance);
    let plane = weight.z - engine.throws[1].z;
    assert!((plane - lever / unbalance).abs() < 1e-15, "{plane} {}", lever / unbalance);
}

#[test]
fn blind_inserts_of_both_faces_beside_each_other_are_no_single_weight() {
    let text = |y: &str| {
        format!(
            "{HEAD}{BODY}{FAMILY}inserts = [\n\
             {{ x = \"45 mm\", y = \"12 mm\", radius = \"5 mm\", face = \"front\", depth = \"4 mm\" }},\n\
             {{ x = \"45 mm\", y = \"{y}\", radius = \"5 mm\", face = \"rear\", depth = \"4 mm\" }},\n]\n"
        )
    };
    assert!(codes(&text("-12 mm")).contains(&"E0902"));
    assert!(!codes(&text("12 mm")).contains(&"E0902"));
}

/// The plain web as an outline of its own: two half circles and two lines.
const PLAIN: &str = "[[counterweight]]\nweb = 3\n[counterweight.shape]\nthickness = \"14 mm\"\nencloses = \"web\"\noutline = [\n\
    { x = \"0 mm\", y = \"-32 mm\", bulge = 1 },\n{ x = \"0 mm\", y = \"32 mm\" },\n\
    { x = \"-30 mm\", y = \"32 mm\", bulge = 1 },\n{ x = \"-30 mm\", y = \"-32 mm\" },\n]\n";

#[test]
fn a_whole_web_weighs_what_it_has_more_than_a_plain_one() {
    let bare = engine(&format!("{HEAD}{BODY}"));
    let plain = engine(&format!("{HEAD}{BODY}{PLAIN}"));
    assert_eq!(plain.throws, bare.throws);
    assert_eq!(plain.counterweights[0].unbalance, 0.0);
    // Twice as thick: one plain web more, on the side of the pin.
    let thick = engine(&format!("{HEAD}{BODY}{}", PLAIN.replace("14 mm", "28 mm")));
    let web = 0.014 * (PI * 0.032 * 0.032 + 2.0 * 0.032 * 0.03) * 0.015;
    near(thick.counterweights[0].unbalance, 7850.0 * web);
    near(thick.counterweights[0].angle, thick.throws[1].angle);
    // A heavy one on the other throw, turned away from it.
    let turned = PLAIN.replace("web = 3", "web = 2\nangle = \"90 deg\"");
    let turned = &engine(&format!("{HEAD}{BODY}{turned}")).counterweights[0];
    near(turned.unbalance, 2f64.sqrt() * 7850.0 * web);
    near(turned.angle, 225f64.to_radians());
}

#[test]
fn the_design_task_has_its_defaults() {
    let section = "[counterweight_design]\nrectangle_height = [\"0 mm\", \"30 mm\"]\nshoulder_angle = \"40 deg\"\n\
                   arc_radius = [\"45 mm\", \"70 mm\"]\narc_angle = [\"60 deg\", \"180 deg\"]\nthickness = \"14 mm\"\n";
    let task = file(&format!("{HEAD}{BODY}{section}")).tasks.shape_task.expect("a task");
    assert_eq!((task.minimise, task.least_balance, task.most_balance), (Objective::Mass, 1.0, None));
    assert_eq!((task.density, task.web_radius), (7850.0, Range::fixed(0.032)));
    assert_eq!(task.rectangle_height, Range::new(0.0, 0.03));
    assert!(matches!(task.shoulder, Shoulder::Angle(range) if range.least == range.most));
    let own = "minimise = \"swept radius\"\nbalance = [0.98, \"102 %\"]\ndensity = \"7200 kg/m3\"\nweb_radius = [\"30 mm\", \"34 mm\"]\n\
               limits = { mass = \"0.5 kg\", half_width = \"60 mm\", shoulder_angle = [\"10 deg\", \"80 deg\"] }\n";
    let task = file(&format!("{HEAD}{BODY}{section}{own}")).tasks.shape_task.expect("a task");
    assert_eq!(
        (task.minimise, task.least_balance, task.most_balance),
        (Objective::SweptRadius, 0.98, Some(1.02))
    );
    assert_eq!((task.density, task.web_radius), (7200.0, Range::new(0.03, 0.034)));
    assert_eq!(
        (task.limits.mass, task.limits.half_width, task.limits.inertia),
        (Some(0.5), Some(0.06), None)
    );
    assert_eq!(task.limits.shoulder_angle.map(|range| range.least), Some(10f64.to_radians()));
}

#[test]
fn clearances_are_read() {
    let section = "[clearance]\nleast = \"1 mm\"\ncrankcase_radius = \"95 mm\"\nskirt_length = \"30 mm\"\nskirt_width = \"45 mm\"\n\
                   liner_end = \"70 mm\"\nliner_wall = \"3 mm\"\nbig_end_radius = \"34 mm\"\nbig_end_width = \"20 mm\"\n\
                   shank_width = \"20 mm\"\nshank_thickness = \"12 mm\"\n";
    let envelope = engine(&format!("{HEAD}{section}")).envelope.expect("an envelope");
    assert_eq!((envelope.least, envelope.crankcase_radius), (Some(0.001), Some(0.095)));
    assert_eq!(envelope.skirt.map(|skirt| (skirt.length, skirt.width)), Some((0.03, Some(0.045))));
    assert_eq!(envelope.liner.map(|liner| (liner.end, liner.wall)), Some((0.07, 0.003)));
    assert_eq!(envelope.rod.map(|rod| (rod.big_end_radius, rod.shank_thickness)), Some((0.034, 0.012)));
}

/// Corners of a star about a point: never crossing, anticlockwise.
fn outline() -> impl Strategy<Value = String> {
    let corner = (0.02_f64..0.05, -0.1_f64..0.3);
    (prop::collection::vec(corner, 5..12), -0.02_f64..0.04, -0.02_f64..0.02).prop_map(|(corners, x, y)| {
        let count = corners.len() as f64;
        let corners: Vec<String> = corners
            .iter()
            .enumerate()
            .map(|(k, (radius, bulge))| {
                let angle = 2.0 * PI * k as f64 / count;
                let (x, y) = (x + radius * angle.cos(), y + radius * angle.sin());
                format!("{{ x = \"{x} m\", y = \"{} in\", bulge = {:?} }}", y / 0.0254, bulge * 0.2)
            })
            .collect();
        format!("outline = [{}]\n", corners.join(", "))
    })
}

fn family() -> impl Strategy<Value = String> {
    (0.02_f64..0.05, 0.0_f64..0.03, prop_oneof![
        (0.0_f64..0.03).prop_map(|height| format!("shoulder_height = \"{height} m\"")),
        (0.0_f64..80.0).prop_map(|angle| format!("shoulder_angle = \"{angle} deg\"")),
    ], 0.05_f64..0.09, 70.0_f64..280.0)
        .prop_map(|(radius, height, flank, arc, angle)| {
            format!(
                "web_radius = \"{radius} m\"\nrectangle_height = \"{height} m\"\n{flank}\narc_radius = \"{arc} m\"\narc_angle = \"{angle} deg\"\n"
            )
        })
}

prop_compose! {
    /// A weight with a shape.
    fn shape()(
        outline in prop_oneof![
            (outline(), any::<bool>()).prop_map(|(text, web)| (text, web)),
            family().prop_map(|text| (text, false)),
        ],
        place in 0..3,
        z in -0.1_f64..0.1,
        angle in prop::option::of(-400.0_f64..400.0),
        wanted in prop::option::of(0.0_f64..0.05),
        thickness in 0.005_f64..0.03,
        density in prop::option::of(1100.0_f64..22000.0),
        bore in prop::option::weighted(0.3, (-0.005_f64..0.005, 0.001_f64..0.004, any::<bool>(), prop::option::weighted(0.3, 0.1_f64..1.0))),
        chamfer in prop::option::weighted(0.2, (0.03_f64..0.06, 10.0_f64..30.0, prop::option::of(-200.0_f64..200.0))),
    ) -> String {
        let (outline, is_web) = outline;
        let place = match place {
            _ if is_web => "web = 2".to_string(),
            0 => "web = 3".to_string(),
            1 => "throw = 2".to_string(),
            _ => format!("z = \"{z} m\""),
        };
        let encloses = if is_web { "encloses = \"web\"\n" } else { "" };
        let angle = angle.map_or(String::new(), |angle| format!("angle = \"{angle} deg\"\n"));
        let wanted = wanted.map_or(String::new(), |wanted| format!("unbalance = \"{wanted} kg m\"\n"));
        let density = density.map_or(String::new(), |density| format!("density = \"{density} kg/m3\"\n"));
        let inserts = bore.map_or(String::new(), |(x, radius, filled, depth)| {
            let density = if filled { "density = \"17.5 g/cm3\", " } else { "" };
            let depth = depth.map_or(String::new(), |part| {
                format!(", face = \"rear\", depth = \"{} mm\"", thickness * part * 1e3)
            });
            format!("inserts = [{{ x = \"{x} m\", y = \"1 mm\", {density}radius = \"{radius} m\"{depth} }}]\n")
        });
        let chamfers = chamfer.map_or(String::new(), |(from, angle, direction)| {
            let cut = match direction {
                Some(direction) => format!("distance = \"{from} m\", direction = \"{direction} deg\""),
                None => format!("radius = \"{from} m\""),
            };
            format!("chamfers = [{{ face = \"front\", angle = \"{angle} deg\", {cut} }}]\n")
        });
        format!(
            "[[counterweight]]\n{place}\n{angle}{wanted}[counterweight.shape]\nthickness = \"{thickness} m\"\n\
             {density}{encloses}{outline}{inserts}{chamfers}"
        )
    }
}

fn body() -> impl Strategy<Value = String> {
    (1500.0_f64..20000.0, 1.0_f64..0.9e2, 26.0_f64..40.0, 26.0_f64..40.0, 6.0_f64..20.0, 0.0_f64..20.0)
        .prop_map(|(density, end, disc, pin, thickness, bore)| {
            format!(
                "[crank.body]\ndensity = \"{density} kg/m3\"\njournal_diameter = \"50 mm\"\npin_diameter = \"40 mm\"\n\
                 pin_bore = \"{bore} mm\"\nweb_thickness = \"{thickness} mm\"\nweb_radius = \"{disc} mm\"\n\
                 pin_end_radius = \"{pin} mm\"\nend_journals = \"{end} mm\"\n"
            )
        })
}

proptest! {
    /// Whatever is read is read again from its expanded form, to the last bit, and fits the schema.
    #[test]
    fn prop_parts_read_back_to_the_last_bit(
        body in body(), shapes in prop::collection::vec(shape(), 1..4), radius in 20.0_f64..40.0, angle in -180.0_f64..180.0,
    ) {
        let head = HEAD.replace("\"60 mm\"", &format!("\"{} mm\"", 2.0 * radius)).replace("180 deg", &format!("{angle} deg"));
        let text = format!("{head}{body}{}", shapes.concat());
        let reading = read(&text);
        let shown = render(&reading.diagnostics, "engine.toml", &text, false);
        // Bores, chamfers and couples that cannot be are refused with good reason; nothing else is.
        let unknown = reading.diagnostics.iter().find(|d| d.severity == Severity::Error && !["E0901", "E0902"].contains(&d.code));
        prop_assert!(unknown.is_none(), "{shown}\n{text}");
        let Some(file) = reading.file else { return Ok(()) };
        let printed = expanded(&file);
        let again = read(&printed);
        let shown = render(&again.diagnostics, "expanded.toml", &printed, false);
        prop_assert_eq!(again.file.as_ref(), Some(&file), "{}\n{}\n{}", shown, printed, text);
        prop_assert_eq!(expanded(&file), printed);
        for weight in &file.engine.counterweights {
            prop_assert!(weight.unbalance >= 0.0 && weight.z.is_finite());
        }
    }
}

#[test]
fn the_schema_knows_them() {
    let schema = json_schema();
    let shape = &schema["properties"]["counterweight"]["items"]["properties"]["shape"];
    assert_eq!(shape["properties"]["outline"]["maxItems"], 2000);
    assert_eq!(schema["properties"]["crank"]["properties"]["body"]["required"][0], "density");
}
