//! Pages and figures of engines at the edge of what can be drawn.

use super::*;
use crate::sample;
use crate::{engine_section, loads_sections, motion_section, peaks_in_short};
use lanchester_file::templates;
use lanchester_mechanism::{LoadRequest, Loads};
use lanchester_model::{BalanceShaft, Engine, Mount, Ratio, ShaftWeight};
use lanchester_results::OrderLoads;
use num_complex::Complex64;

/// Checks that a text is well-formed XML: tags nest, attributes are quoted and unique, entities are known.
fn well_formed(xml: &str) -> Result<(), String> {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = xml;
    while let Some(at) = rest.find('<') {
        entities(&rest[..at])?;
        let tag = &rest[at + 1..];
        let end = tag.find('>').ok_or("a tag without an end")?;
        let (inside, after) = (&tag[..end], &tag[end + 1..]);
        rest = after;
        if let Some(name) = inside.strip_prefix('/') {
            let expected = open.pop().ok_or_else(|| format!("</{name}> closes nothing"))?;
            if expected != name {
                return Err(format!("</{name}> where </{expected}> is due"));
            }
            continue;
        }
        let (body, closed) = inside.strip_suffix('/').map_or((inside, false), |b| (b, true));
        let name = body.split_whitespace().next().ok_or("a tag without a name")?;
        attributes(&body[name.len()..])?;
        if name == "style" {
            let close = rest.find("</style>").ok_or("a style without an end")?;
            rest = &rest[close + "</style>".len()..];
        } else if !closed {
            open.push(name);
        }
    }
    entities(rest)?;
    if open.is_empty() { Ok(()) } else { Err(format!("open at the end: {open:?}")) }
}

fn attributes(text: &str) -> Result<(), String> {
    let mut rest = text.trim_start();
    let mut names: Vec<&str> = Vec::new();
    while !rest.is_empty() {
        let (name, value) = rest.split_once("=\"").ok_or_else(|| format!("no quoted value in {rest:?}"))?;
        if names.contains(&name) || name.contains(char::is_whitespace) {
            return Err(format!("attribute {name:?} twice or malformed"));
        }
        names.push(name);
        let (value, after) = value.split_once('"').ok_or("an attribute without an end")?;
        entities(value)?;
        if value.contains('<') {
            return Err("< in an attribute".to_owned());
        }
        rest = after.trim_start();
    }
    Ok(())
}

fn entities(text: &str) -> Result<(), String> {
    for piece in text.split('&').skip(1) {
        let name = piece.split(';').next().unwrap_or_default();
        if !matches!(name, "amp" | "lt" | "gt" | "quot" | "#39") {
            return Err(format!("unknown entity &{name}"));
        }
    }
    Ok(())
}

#[test]
fn the_checker_finds_what_is_not_well_formed() {
    assert!(well_formed("<a b=\"c\"><d/>x &amp; y</a>").is_ok());
    for bad in
        ["<a><b></a></b>", "<a>", "</a>", "<a b=c/>", "<a b=\"1\" b=\"2\"/>", "<a>&nbsp;</a>", "<a b=\"<\"/>"]
    {
        assert!(well_formed(bad).is_err(), "{bad}");
    }
}

fn page(engine: &Engine, loads: &Loads, warnings: &[String]) -> String {
    let provenance = Provenance {
        program: "lanchester 0.1.0".to_owned(),
        input: "engine.toml".to_owned(),
        input_hash: "0".to_owned(),
        settings: vec![("motion".to_owned(), "exact".to_owned())],
    };
    let key_numbers = peaks_in_short(loads);
    let head = ReportHead {
        engine,
        speed: loads.speed,
        provenance: &provenance,
        warnings,
        key_numbers: &key_numbers,
    };
    report(&head, &sections(engine, loads))
}

/// What every report tells.
fn sections(engine: &Engine, loads: &Loads) -> Vec<Section> {
    let mut sections = loads_sections(engine, loads);
    sections.extend([motion_section(loads), engine_section(engine)]);
    sections
}

/// Everything that holds for every page and every figure.
fn check(engine: &Engine, loads: &Loads) -> Vec<Figure> {
    let name = &engine.name;
    let html = page(engine, loads, &[]);
    assert!(html.len() < 1_500_000, "{name}: {} bytes", html.len());
    for word in ["NaN", "inf ", ">inf", "-0<", "\u{2212}0<", "http:", "https:", "<script", "@import", "url("]
    {
        assert!(!html.contains(word), "{name}: {word} in the page");
    }
    let figures = figures(engine, &sections(engine, loads));
    let mut ids: Vec<&str> = figures.iter().map(|f| f.id.as_str()).collect();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), figures.len(), "{name}: two figures of one name");
    for figure in &figures {
        let svg = figure.svg();
        well_formed(&svg).unwrap_or_else(|e| panic!("{name}, {}: {e}", figure.id));
        assert!(!svg.contains("NaN") && !svg.contains("inf\""), "{name}, {}", figure.id);
        assert!(svg.contains("<title") && svg.contains("<desc") && svg.contains("prefers-color-scheme"));
    }
    figures
}

fn check_with_sample_loads(engine: &Engine) -> Vec<Figure> {
    check(engine, &sample::loads(engine))
}

#[test]
fn every_layout_of_the_gallery_has_a_page() {
    for template in templates() {
        let reading = lanchester_file::read(template.text);
        let engine = reading.engine().unwrap();
        let loads = lanchester_mechanism::loads(&engine, &LoadRequest::default()).unwrap();
        check(&engine, &loads);
    }
}

#[test]
fn one_cylinder_and_eighteen() {
    check_with_sample_loads(&sample::engine(&[(0.0, 0.0)]));
    let many: Vec<(f64, f64)> = (0..18).map(|k| (40.0 * f64::from(k), 20.0 * f64::from(k))).collect();
    let figures = check_with_sample_loads(&sample::engine(&many));
    assert!(figures.iter().any(|f| f.id == "force-stars"));
}

#[test]
fn an_engine_without_any_load() {
    let mut engine = sample::engine(&[(0.0, 0.0), (180.0, 0.0)]).into_parts();
    for cylinder in &mut engine.cylinders {
        cylinder.piston_mass = 0.0;
        cylinder.rod.big_end_mass = 0.0;
        cylinder.rod.small_end_mass = 0.0;
        cylinder.bore = None;
        cylinder.firing_angle = None;
    }
    for throw in &mut engine.throws {
        throw.unbalance = 0.0;
    }
    engine.counterweights.clear();
    let figures = check_with_sample_loads(&Engine::new(engine).unwrap());
    let spectrum = figures.iter().find(|f| f.id == "force-spectrum").unwrap();
    assert!(spectrum.svg().contains("zero at every order"));
    assert!(
        !figures
            .iter()
            .any(|f| f.id.starts_with("story") || f.id.ends_with("stars") || f.id.contains("by-part"))
    );
}

#[test]
fn fractional_orders_stand_where_they_belong() {
    let mut engine = sample::engine(&[(0.0, 0.0), (0.0, 0.0)]).into_parts();
    engine.crankshafts.push(lanchester_model::Crankshaft {
        name: "half speed".to_owned(),
        ratio: Ratio::new(-1, 2).unwrap(),
        phase: 0.3,
        x: 0.0,
        y: 0.2,
        mains: None,
    });
    engine.throws[1].crankshaft = 1;
    let figures = check_with_sample_loads(&Engine::new(engine).unwrap());
    let spectrum = figures.iter().find(|f| f.id == "force-spectrum").unwrap();
    assert!(
        spectrum.panels[0].description.contains("order 0.5 with the crank"),
        "{}",
        spectrum.panels[0].description
    );
    assert!(spectrum.svg().contains(">\u{2212}0.5</text>"));
    assert!(figures.iter().any(|f| f.id == "story-order-0-5" || f.id == "story-order-1"));
}

#[test]
fn what_is_not_a_number_is_never_printed() {
    let engine = sample::twin();
    let mut loads = sample::loads(&engine);
    let bad = Complex64::new(f64::NAN, f64::INFINITY);
    let spoil = |order: &mut OrderLoads| {
        order.force_forward = bad;
        order.couple_backward = bad;
        order.roll_moment = bad;
        order.shaft_torque = bad;
    };
    loads.total.orders.iter_mut().for_each(spoil);
    loads.cylinders[0].loads.orders.iter_mut().for_each(spoil);
    loads.total.trace.force_x[3] = f64::NAN;
    loads.total.trace.couple_y.fill(f64::NAN);
    loads.total.peaks.force_x.max.value = f64::NAN;
    loads.total.peaks.force.max.theta = f64::INFINITY;
    loads.motion[0].stroke = f64::NAN;
    check(&engine, &loads);
    let text = crate::loads_text(&loads);
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    assert!(!crate::orders_csv(&loads).contains("NaN") && !crate::trace_csv(&loads).contains("NaN"));
}

#[test]
fn names_of_the_user_are_escaped_and_keep_their_underscores() {
    let mut engine = sample::twin().into_parts();
    engine.name = "R&D <b>\"my_engine\"</b>".to_owned();
    engine.note = Some("<script>alert('x')</script>".to_owned());
    engine.shafts[0].name = "shaft_a <left>".to_owned();
    engine.mounts[0].name = "m_1 & \u{1}".to_owned();
    let engine = Engine::new(engine).unwrap();
    let loads = sample::loads(&engine);
    check(&engine, &loads);
    let html = page(&engine, &loads, &["no <unit> in \"speed\"".to_owned()]);
    assert!(html.contains("my_engine") && html.contains("shaft_a"), "an underscore became an index");
    assert!(!html.contains("<b>\"my") && !html.contains("<left>") && !html.contains("<unit>"));
}

#[test]
fn a_reverse_engine_with_far_shafts_and_mounts_is_drawn_mirrored() {
    let mut engine = sample::twin().into_parts();
    engine.shafts.push(BalanceShaft {
        name: "second order".to_owned(),
        ratio: Ratio::whole(2).unwrap(),
        x: -0.3,
        y: -0.4,
        weights: vec![ShaftWeight::new(0.4, 0.0, 1.0)],
        inertia: None,
    });
    engine.mounts.push(Mount { name: "far".to_owned(), x: 1.0, y: 1.0, z: 2.0, spring: None });
    let engine = Engine::new(engine).unwrap();
    let straight = check_with_sample_loads(&engine);
    let engine = engine.with(|parts| parts.rotation = Rotation::Reverse).unwrap();
    let mirrored = check_with_sample_loads(&engine);
    let of = |figures: &[Figure], id: &str| figures.iter().find(|f| f.id == id).unwrap().svg();
    assert_ne!(of(&straight, "front-view"), of(&mirrored, "front-view"));
    assert_ne!(of(&straight, "force-hodograph"), of(&mirrored, "force-hodograph"));
    assert_eq!(of(&straight, "side-view"), of(&mirrored, "side-view"));
    assert_eq!(of(&straight, "force-x-by-part"), of(&mirrored, "force-x-by-part"));
}

#[test]
fn margins_of_sheets_hold_any_name() {
    assert_eq!(css_string(r#"a "b" \ </style> ü"#), r#""a \22 b\22  \5c  \3c /style> ü""#);
    assert_eq!(css_string("a\nb"), "\"a b\"");
}
