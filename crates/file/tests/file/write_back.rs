//! Weights that were found, written back into the text of the engine file.

use crate::support::written::{
    DRESSES, PARTS, SHAPE, as_part, check, comments, dressed, engine, family, good_files, near, other_lines,
    plate, same_weight, template,
};
use lanchester_file::{WriteBackError, write_back};
use lanchester_model::{
    BalanceShaft, Counterweight, Engine, EngineParts, Ratio, ShaftWeight, ShaftWeightPart,
};
use lanchester_shape::{CounterweightShape, Insert, Point, ShaftWeightShape};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

#[test]
fn the_comparison_sees_small_differences() {
    let weight =
        Counterweight { name: "n".into(), crankshaft: 0, z: 0.1, unbalance: 0.02, angle: 1.0, part: None };
    for other in [
        Counterweight { z: 0.1 + 1e-11, ..weight.clone() },
        Counterweight { unbalance: 0.02 * (1.0 + 1e-10), ..weight.clone() },
        Counterweight { angle: 1.0 + 1e-10, ..weight.clone() },
        Counterweight { name: "m".into(), ..weight.clone() },
    ] {
        assert!(!same_weight(&weight, &other), "{other:?}");
    }
    assert!(same_weight(&weight, &Counterweight { angle: 1.0 - TAU, ..weight.clone() }));
    assert_ne!(comments("a # b"), comments("a"));
    assert_ne!(other_lines("[rod]\na = 1"), other_lines("[rod]\na = 2"));
}

#[test]
fn what_is_not_changed_is_not_touched() {
    for (name, file) in good_files() {
        for dress in 0..DRESSES {
            let text = dressed(file, dress);
            assert_eq!(write_back(&text, &engine(&text)).as_ref(), Ok(&text), "{name} {dress}");
        }
    }
}

#[test]
fn every_template_takes_other_weights_and_shafts() {
    for (name, file) in good_files() {
        for dress in 0..DRESSES {
            let text = dressed(file, dress);
            let mut fitted = parts(&text);
            for (k, weight) in fitted.counterweights.iter_mut().enumerate() {
                weight.unbalance *= 1.1 + 0.01 * k as f64;
                weight.angle += 0.3;
                weight.part = None;
            }
            for weight in fitted.shafts.iter_mut().flat_map(|shaft| &mut shaft.weights) {
                weight.unbalance *= PI;
                weight.phase -= 0.1;
                weight.part = None;
            }
            fitted.counterweights.push(Counterweight {
                name: "flywheel".into(),
                crankshaft: fitted.crankshafts.len() - 1,
                z: 0.123,
                unbalance: 1.0 / 3000.0,
                angle: -1.0,
                part: None,
            });
            let weights =
                vec![ShaftWeight::new(-0.05, 0.0123456789012, 2.0), ShaftWeight::new(0.05, 0.01, 0.0)];
            let ratio = Ratio::new(-1, 2).expect("no 0");
            fitted.shafts.push(BalanceShaft {
                name: "new".into(),
                ratio,
                x: 0.1,
                y: -0.2,
                weights,
                inertia: None,
            });
            if let Err(problem) = check(&text, &made(&fitted)) {
                panic!("{name} in dress {dress}: {problem}");
            }
            // And none at all.
            (fitted.counterweights, fitted.shafts) = (Vec::new(), Vec::new());
            if let Err(problem) = check(&text, &made(&fitted)) {
                panic!("{name} in dress {dress}, bare: {problem}");
            }
        }
    }
}

/// The parts of the engine of a text, to be changed.
fn parts(text: &str) -> EngineParts {
    engine(text).into_parts()
}

fn made(parts: &EngineParts) -> Engine {
    Engine::new(parts.clone()).unwrap()
}

const HEAD: &str = r#"name = "Twin"
speed = "3000 rpm"
crank = { stroke = "60 mm", web_distance = "30 mm" }
piston.mass = "0.3 kg"
rod = { length = "110 mm", mass = "0.3 kg" }
layout = { type = "in-line", cylinders = 2, spacing = "80 mm", crank_angles = ["0 deg", "180 deg"] }
"#;

/// The file with its weights changed, behind the head.
fn rewritten(tail: &str, change: impl Fn(&mut EngineParts)) -> String {
    let text = format!("{HEAD}{tail}");
    let fitted = engine(&text).with(change).unwrap();
    match check(&text, &fitted) {
        Ok(new) => new.strip_prefix(HEAD).unwrap_or_else(|| panic!("{new}")).to_string(),
        Err(problem) => panic!("{problem}"),
    }
}

#[test]
fn values_keep_their_unit_spelling_quotes_and_comments() {
    let tail = "
[[counterweight]]   # the first
  name   = 'front'  # its name
  web = 1
  unbalance=\"500 g mm\"# was measured
  angle = '170.0deg'

# between
[[counterweight]]
z = \"1.5 in\"
mass = \"0.4 kg\" # from the drawing
radius = \"50 mm\"
";
    let new = rewritten(tail, |engine| {
        engine.counterweights[0].unbalance = 0.00075;
        engine.counterweights[0].angle += 5_f64.to_radians();
        engine.counterweights[1].unbalance = 0.03;
        engine.counterweights[1].z = 0.0508;
        engine.counterweights[1].angle = PI;
    });
    let wanted = tail
        .replace("500 g mm", "750 g mm")
        .replace("170.0deg", "175deg")
        .replace("0.4 kg", "0.6 kg")
        .replace("1.5 in", "2 in")
        .replace("# from the drawing\n", "# from the drawing\nangle = \"180deg\"\n");
    assert_eq!(new, wanted);
}

#[test]
fn the_short_form_gives_way_to_what_it_made() {
    let tail = "
[counterweights]  # half of it
rotating_share = \"100 %\"
# and of the pistons
reciprocating_share = \"50 %\"  # by custom

[[mount]]
x = \"0 mm\"
y = \"0 mm\"
z = \"0 mm\"
";
    let new = rewritten(tail, |engine| {
        engine.counterweights[0].unbalance = 0.025;
        engine.counterweights[1].unbalance = 0.02;
        engine.counterweights[1].angle = 0.5_f64.to_radians();
    });
    let wanted = "
# half of it
# and of the pistons
# by custom
[[counterweight]]
throw = 1
unbalance = \"0.025 kg m\"

[[counterweight]]
throw = 2
unbalance = \"0.02 kg m\"
angle = \"180.5 deg\"

[[mount]]
x = \"0 mm\"
y = \"0 mm\"
z = \"0 mm\"
";
    assert_eq!(new, wanted);
    // In one line, and in dotted keys.
    for short in [
        "counterweights = { rotating_share = \"100 %\" }  # short\n",
        "counterweights.rotating_share = \"100 %\"  # short\ncounterweights.at = \"webs\"\n",
    ] {
        let new =
            rewritten(&format!("{short}[[mount]]\nx = \"0 mm\"\ny = \"0 mm\"\nz = \"0 mm\"\n"), |engine| {
                engine.counterweights[0].unbalance *= 2.0;
            });
        assert!(new.starts_with("# short\n[[mount]]") && !new.contains("share"), "{new}");
    }
}

#[test]
fn the_short_form_stays_if_nothing_that_it_makes_changes() {
    let tail = "[counterweights]\nrotating_share = \"100 %\"\n[[counterweight]]\nz = \"60 mm\"\nunbalance = \"1 g cm\"\n";
    let new = rewritten(tail, |engine| engine.counterweights[2].unbalance = 5e-5);
    assert_eq!(new, tail.replace("1 g cm", "5 g cm"));
}

#[test]
fn unnamed_entries_keep_the_names_that_they_had() {
    let one = |z: &str| format!("[[counterweight]]\nz = \"{z}\"\nunbalance = \"1 g cm\"\n\n");
    let tail = format!(
        "[[shaft]]\nratio = 1\nweights = []\n[[shaft]] # second\nratio = -1\nweights = []\n{}{}",
        one("1 mm"),
        one("2 mm")
    );
    let new = rewritten(&tail, |engine| {
        engine.counterweights.remove(0);
        engine.shafts.remove(0);
    });
    assert_eq!(
        new,
        "[[shaft]] # second\nratio = -1\nname = \"shaft 2\"\nweights = []\n\n\
         [[counterweight]]\nz = \"2 mm\"\nname = \"weight 2\"\nunbalance = \"1 g cm\"\n\n"
    );
}

#[test]
fn lists_in_brackets_stay_lists_in_brackets() {
    let weight = |name: &str, web: usize| Counterweight {
        name: name.into(),
        crankshaft: 0,
        z: 0.04 * if web < 3 { -1.0 } else { 1.0 } + 0.015 * if web % 2 == 1 { -1.0 } else { 1.0 },
        unbalance: 0.002,
        angle: if web < 3 { PI } else { 0.0 },
        part: None,
    };
    let tail = "counterweight = [
    { web = 1, unbalance = \"1 g cm\" }, # one
    { web = 2, unbalance = \"1 g cm\", angle = \"10 deg\" } # two
] # all
shaft = [{ ratio = 2, y = \"1 cm\", weights = [{ z = \"0 mm\", mass = \"1 g\", radius = \"0 mm\" }] }]
";
    let new = rewritten(tail, |engine| {
        engine.counterweights[0].angle += 0.5_f64.to_radians();
        engine.counterweights.push(weight("web 3", 3));
        engine.shafts[0].weights[0].unbalance = 0.01;
        engine.shafts[0].weights.push(ShaftWeight::new(0.01, 0.02, PI));
        engine.shafts.push(BalanceShaft {
            name: "other".into(),
            ratio: Ratio::whole(-2).expect("no 0"),
            x: 0.0,
            y: -0.01,
            weights: vec![ShaftWeight::new(0.01, 0.02, PI); 2],
            inertia: None,
        });
    });
    let wanted = "counterweight = [
    { web = 1, unbalance = \"1 g cm\", angle = \"180.5 deg\" }, # one
    { web = 2, unbalance = \"1 g cm\", angle = \"10 deg\" }, # two
    { web = 3, unbalance = \"200 g cm\" },
] # all
shaft = [{ ratio = 2, y = \"1 cm\", weights = [{ z = \"0 mm\", unbalance = \"1000 g cm\" }, { z = \"10 mm\", unbalance = \"2000 g cm\", phase = \"180 deg\" }] }, { name = \"other\", ratio = -2, x = \"0 mm\", y = \"-1 cm\", weights = [{ z = \"10 mm\", unbalance = \"2000 g cm\", phase = \"180 deg\" }, { z = \"10 mm\", unbalance = \"2000 g cm\", phase = \"180 deg\" }] }]
";
    assert_eq!(new, wanted);
    let new = rewritten(tail, |engine| {
        engine.counterweights.pop();
        engine.shafts[0].weights.clear();
    });
    assert!(new.contains("# one\n    # two\n] # all") && new.contains("weights = [] }]"), "{new}");
    let new = rewritten(tail, |engine| drop(engine.counterweights.remove(0)));
    assert!(new.contains("[\n    # one\n    { web = 2"), "{new}");
}

#[test]
fn weights_of_shafts_with_headers_of_their_own() {
    let tail = "[[shaft]]
name = \"a\"
ratio = -1
  [[shaft.weights]] # first
  z = \"0 mm\"
  unbalance = \"1 oz in\"
  [[shaft.weights]]
  z = \"1 in\"
  unbalance = \"1 oz in\" # of the second
# parted
[[mount]]
x = \"0 mm\"
y = \"0 mm\"
z = \"0 mm\"
[[shaft]]
name = \"b\"
ratio = 1
weights = [
    # none yet
]";
    let ounce_inch = 0.453_592_37 / 16.0 * 0.0254;
    let new = rewritten(tail, |engine| {
        engine.shafts[0].weights[1].unbalance = 2.0 * ounce_inch;
        engine.shafts[0].weights.push(ShaftWeight::new(0.0254, 3.0 * ounce_inch, 0.0));
        engine.shafts[1].weights.push(ShaftWeight::new(0.0, ounce_inch, 0.0));
    });
    assert!(
        new.contains("unbalance = \"2 oz in\" # of the second\n\n[[shaft.weights]]\nz = \"25.4 mm\""),
        "{new}"
    );
    assert!(new.contains("unbalance = \"3 oz in\""), "{new}");
    let new = rewritten(tail, |engine| engine.shafts[0].weights.truncate(1));
    assert!(new.contains("  # of the second\n# parted"), "{new}");
    let new = rewritten(tail, |engine| drop(engine.shafts.remove(0)));
    assert!(
        new.starts_with("# first\n# of the second\n# parted\n[[mount]]")
            || new.contains("# of the second\n# parted\n[[mount]]"),
        "{new}"
    );
}

#[test]
fn a_weight_moves_to_another_plane_or_crankshaft() {
    let tail = "[[counterweight]]\nweb = 1 # on a web\nunbalance = \"1 g cm\"\n";
    let new = rewritten(tail, |engine| {
        engine.counterweights[0].z = 0.1;
        engine.counterweights[0].angle = 10_f64.to_radians();
    });
    assert_eq!(
        new,
        "[[counterweight]]\nz = \"100 mm\" # on a web\nname = \"web 1\"\nunbalance = \"1 g cm\"\nangle = \"10 deg\"\n"
    );
    let text = template("opposed-piston-3");
    let mut fitted = parts(text);
    fitted.counterweights.push(Counterweight {
        name: "over there".into(),
        crankshaft: 1,
        z: 0.3,
        unbalance: 0.01,
        angle: 1.0,
        part: None,
    });
    let new = check(text, &made(&fitted)).unwrap_or_else(|problem| panic!("{problem}"));
    let mut fitted = parts(&new);
    fitted.counterweights.last_mut().expect("it is there").crankshaft = 0;
    let back = check(&new, &made(&fitted)).unwrap_or_else(|problem| panic!("{problem}"));
    assert!(
        new.contains("crankshaft = 2\nz = \"300 mm\"") && back.contains("crankshaft = 1\nz = \"300 mm\"")
    );
}

#[test]
fn what_cannot_be_written_is_refused() {
    assert!(matches!(write_back("name = 3", &engine(template("twin-360"))), Err(WriteBackError::File(_))));
    let text = template("twin-360");
    let weight =
        Counterweight { name: "n".into(), crankshaft: 0, z: 0.0, unbalance: 1.0, angle: 0.0, part: None };
    let numbered = |k: usize| Counterweight { name: format!("n {k}"), ..weight.clone() };
    let many = engine(text).with(|parts| parts.counterweights = (0..300).map(numbered).collect()).unwrap();
    assert!(matches!(write_back(text, &many), Err(WriteBackError::Weights { .. })));
    // Amounts beyond those of a file, and two of one name, are refused already.
    for unbalance in [-1.0, f64::NAN] {
        let weight = Counterweight { unbalance, ..weight.clone() };
        assert!(engine(text).with(|parts| parts.counterweights = vec![weight]).is_err());
    }
    let twins = vec![weight.clone(); 2];
    assert!(engine(text).with(|parts| parts.counterweights = twins).is_err());
}

#[test]
fn a_found_shape_is_written_beside_the_wanted_unbalance() {
    let tail = "
[[counterweight]]   # the first
web = 1
unbalance = \"9 kg mm\"  # wanted
angle = \"170 deg\"

[[counterweight]]
web = 4
mass = \"0.2 kg\" # weighed
radius = \"40 mm\"
";
    let new = rewritten(tail, |engine| {
        for (k, thickness) in [(0, 0.0123), (1, 0.01 / 3.0)] {
            let weight = &engine.counterweights[k];
            let found =
                as_part(&made(engine), weight, family(SHAPE, thickness, 7850.0), Some(weight.unbalance));
            engine.counterweights[k] = found.expect("a weight");
        }
    });
    let shape = |thickness: &str| {
        format!(
            "shape = {{ thickness = \"{thickness} mm\", density = \"7850 kg/m3\", web_radius = \"25 mm\", rectangle_height = \"12 mm\", \
             shoulder_height = \"8 mm\", arc_radius = \"50 mm\", arc_angle = \"114.591559026 deg\" }}"
        )
    };
    let wanted =
        tail.replace("angle = \"170 deg\"\n", &format!("angle = \"170 deg\"\n{}\n", shape("12.3"))).replace(
            "mass = \"0.2 kg\" # weighed\nradius = \"40 mm\"\n",
            &format!("unbalance = \"8 kg mm\" # weighed\n{}\n", shape("3.3333333333")),
        );
    assert_eq!(new, wanted);
}

#[test]
fn a_shape_gives_way_to_another_unbalance() {
    let tail = "
[[counterweight]]
web = 1  # front
unbalance = \"9 kg mm\"  # wanted
[counterweight.shape]  # found
thickness = \"12 mm\"
density = \"7850 kg/m3\"
# a block
outline = [
    { x = \"20 mm\", y = \"-30 mm\" },  # lower
    { x = \"50 mm\", y = \"-30 mm\" },
    { x = \"50 mm\", y = \"30 mm\" },
    { x = \"20 mm\", y = \"30 mm\" },
]

[[counterweight]]
web = 4
shape = { thickness = \"12 mm\", density = \"7850 kg/m3\", outline = [{ x = \"20 mm\", y = \"-30 mm\" }, { x = \"50 mm\", y = \"-30 mm\" }, { x = \"40 mm\", y = \"30 mm\" }] } # plate
";
    let new = rewritten(tail, |engine| {
        for weight in &mut engine.counterweights {
            // The part stays where it is not taken out: the number counts.
            (weight.unbalance, weight.z, weight.angle) = (0.004, engine_plane(weight), PI);
        }
        engine.counterweights[1].part = None;
        engine.counterweights[0].part = None;
    });
    let wanted = "
[[counterweight]]
web = 1  # front
unbalance = \"4 kg mm\"  # wanted
# found
# a block
# lower

[[counterweight]]
web = 4
unbalance = \"4 kg mm\"
angle = \"0 deg\"
# plate
";
    assert_eq!(new, wanted);
}

/// Middle of the part of a weight.
fn engine_plane(weight: &Counterweight) -> f64 {
    weight.part.as_ref().map_or(weight.z, |part| part.z)
}

#[test]
fn the_shape_of_a_shafts_weight_comes_changes_and_goes() {
    let tail = "
[[shaft]]
ratio = -1
weights = [
    { z = \"0 mm\", unbalance = \"40 g cm\", phase = \"180 deg\" },  # by the optimum
    { z = \"30 mm\", mass = \"0.2 kg\", radius = \"20 mm\" },
]
[[shaft]]
name = \"rear\"
ratio = 2
[[shaft.weights]]
z = \"5 mm\"
unbalance = \"1 kg mm\" # wanted
[shaft.weights.shape] # found
shaft_diameter = \"20 mm\"
radius = \"30 mm\" # room
length = \"20 mm\"
density = \"7850 kg/m3\"
";
    let part = |radius: f64, length: f64, wanted: f64| ShaftWeightPart {
        shape: ShaftWeightShape { shaft_radius: 0.01, radius, chord: 0.002 },
        length,
        density: 7850.0,
        wanted: Some(wanted),
    };
    let put = |weight: &mut ShaftWeight, part: ShaftWeightPart| {
        (weight.unbalance, weight.part) = (part.unbalance(), Some(part));
    };
    let found = rewritten(tail, |engine| {
        put(&mut engine.shafts[0].weights[0], part(0.03, 0.01 / 3.0, 0.0004));
        put(&mut engine.shafts[0].weights[1], part(0.025, 0.0125, 0.004));
        put(&mut engine.shafts[1].weights[0], part(0.02, 0.02, 0.001));
    });
    let shape = |radius: u32, length: &str| {
        format!(
            "shape = {{ shaft_diameter = \"20 mm\", radius = \"{radius} mm\", chord = \"2 mm\", length = \"{length} mm\", \
             density = \"7850 kg/m3\" }}"
        )
    };
    let wanted = format!(
        "
[[shaft]]
ratio = -1
weights = [
    {{ z = \"0 mm\", unbalance = \"40 g cm\", phase = \"180 deg\", {} }},  # by the optimum
    {{ z = \"30 mm\", unbalance = \"400 g cm\", {} }},
]
[[shaft]]
name = \"rear\"
ratio = 2
[[shaft.weights]]
z = \"5 mm\"
unbalance = \"1 kg mm\" # wanted
{}
# found
# room
",
        shape(30, "3.3333333333"),
        shape(25, "12.5"),
        shape(20, "20")
    );
    assert_eq!(found, wanted);
    // Another amount takes the shape out again.
    let bare = rewritten(tail, |engine| {
        engine.shafts[1].weights[0] = ShaftWeight::new(0.005, 0.002, 0.0);
    });
    assert!(
        bare.contains("unbalance = \"2 kg mm\" # wanted\n# found\n# room\n") && !bare.contains("shape"),
        "{bare}"
    );
    // The number that the part has leaves it alone, and a new weight brings its shape along.
    let more = rewritten(tail, |engine| {
        engine.shafts[1].weights[0].part = None;
        let mut new = ShaftWeight::new(0.1, 0.0, 1.0);
        put(&mut new, part(0.02, 0.02, 0.001));
        engine.shafts[1].weights.push(new);
    });
    assert!(more.contains("shape] # found") && more.contains(&shape(20, "20")), "{more}");
}

#[test]
fn a_part_whose_amount_was_changed_is_a_number() {
    let mut fitted = parts(PARTS);
    fitted.counterweights[0].unbalance *= 1.05;
    let new = write_back(PARTS, &made(&fitted)).expect("it can be written");
    let read = engine(&new);
    assert!(read.counterweights[0].part.is_none() && read.counterweights[1].part.is_some());
    assert!(near(read.counterweights[0].unbalance, fitted.counterweights[0].unbalance, 0.0));
}

#[test]
fn the_number_that_a_part_has_leaves_it_alone() {
    let mut fitted = parts(PARTS);
    fitted.counterweights.iter_mut().for_each(|weight| weight.part = None);
    assert_eq!(write_back(PARTS, &made(&fitted)).as_deref(), Ok(PARTS));
}

#[test]
fn a_shape_without_words_is_refused() {
    let mut fitted = parts(PARTS);
    let (form, part) = family(SHAPE, 0.015, 7850.0);
    let buried =
        Insert { centre: Point::new(0.03, 0.0), radius: 0.004, from: 0.004, to: 0.011, density: 0.0 };
    let part = part.with_insert(buried).expect("an insert");
    let weight = fitted.counterweights[4].clone();
    fitted.counterweights[4] = as_part(&made(&fitted), &weight, (form, part), None).expect("a weight");
    assert!(matches!(write_back(PARTS, &made(&fitted)), Err(WriteBackError::Shape { .. })));
}

fn weight() -> impl Strategy<Value = (f64, f64, f64)> {
    (-0.3_f64..0.3, prop_oneof![Just(0.0), 1e-9_f64..0.1], -10.0_f64..10.0)
}

proptest! {
    #[test]
    fn prop_any_weights_are_written(
        file in prop::sample::select(good_files()),
        dress in 0..DRESSES,
        new in prop::collection::vec((weight(), any::<bool>()), 0..4),
        shafts in prop::collection::vec((prop::collection::vec(weight(), 0..3), -0.2_f64..0.2), 0..3),
        fate in prop::collection::vec((0..7, weight()), 0..40),
        sizes in (0.02_f64..0.04, 0.0_f64..0.02, 0.045_f64..0.07, 1.4_f64..3.0, 0.004_f64..0.02),
    ) {
        let text = dressed(file.1, dress);
        let mut fitted = parts(&text);
        let mut fates = fate.into_iter();
        let whole = made(&fitted);
        let (web_radius, height, arc_radius, arc_angle, thickness) = sizes;
        fitted.counterweights.retain_mut(|weight| {
            let Some((fate, (z, unbalance, angle))) = fates.next() else { return true };
            let shape = CounterweightShape {
                web_radius, rectangle_height: height, shoulder_height: height / 3.0, arc_radius, arc_angle,
            };
            let found = match fate {
                5 => as_part(&whole, weight, family(shape, thickness, 7200.0), Some(unbalance)),
                6 => as_part(&whole, weight, plate(web_radius, z.max(0.0), thickness), None),
                _ => None,
            };
            if let Some(found) = found {
                *weight = found;
                return true;
            }
            if fate < 4 {
                weight.part = None;
            }
            match fate {
                0 => return false,
                1 => (weight.unbalance, weight.angle) = (unbalance, angle),
                2 => weight.z = z,
                3 => weight.unbalance = unbalance,
                _ => {}
            }
            true
        });
        for (k, ((z, unbalance, angle), on_web)) in new.into_iter().enumerate() {
            let web = fitted.throws[0].webs.filter(|_| on_web);
            let (z, name) = web.map_or((z, format!("at {k}")), |webs| (webs[1], format!("cheek {k}")));
            fitted.counterweights.push(Counterweight { name, crankshaft: 0, z, unbalance, angle, part: None });
        }
        for (k, (weights, x)) in shafts.into_iter().enumerate() {
            let weights: Vec<ShaftWeight> = weights
                .into_iter()
                .enumerate()
                .map(|(number, (z, unbalance, phase))| {
                    if number > 0 {
                        return ShaftWeight::new(z, unbalance, phase);
                    }
                    let shape = ShaftWeightShape { shaft_radius: height + 0.001, radius: arc_radius, chord: -height };
                    let part =
                        ShaftWeightPart { shape, length: thickness, density: 7200.0, wanted: Some(unbalance) };
                    ShaftWeight { z, unbalance: part.unbalance(), phase, part: Some(part) }
                })
                .collect();
            match fitted.shafts.get_mut(k) {
                Some(shaft) => (shaft.weights, shaft.x) = (weights, x),
                None => {
                    let ratio = Ratio::whole(-2).expect("no 0");
                    fitted.shafts.push(BalanceShaft { name: format!("new {k}"), ratio, x, y: 0.1, weights, inertia: None });
                }
            }
        }
        let done = check(&text, &made(&fitted));
        prop_assert!(done.is_ok(), "{}", done.unwrap_err());
    }
}
