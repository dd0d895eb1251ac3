//! The gallery of layouts, held against values that share no code with it.
//!
//! `validation/layouts/derive.py` derives every template a second time: the layout from the textbook, the loads from
//! point masses on a solved linkage. `validation/layouts/textbook.json` has what textbooks print of free forces and
//! couples. No Python is needed here.

mod compare;
mod evidence;
mod textbook;

use compare::{firing_mismatches, mismatches};
use evidence::Evidence;
use lanchester_mechanism::{LoadRequest, Loads, loads};
use lanchester_model::{Engine, EngineParts};

fn engine(template: &str) -> Engine {
    let text = lanchester_file::template(template).expect("a template of the list").text;
    let reading = lanchester_file::read(text);
    assert!(reading.diagnostics.is_empty(), "{template}: {:?}", reading.diagnostics);
    reading.engine().expect("a file without a mistake has an engine")
}

fn exact(engine: &Engine) -> Loads {
    loads(engine, &LoadRequest { max_order: 8, ..LoadRequest::default() }).expect("a valid engine has loads")
}

/// Every template with its evidence and its loads.
fn gallery() -> Vec<(Evidence, Engine, Loads)> {
    let all = lanchester_file::templates().iter().map(|template| {
        let evidence = evidence::read(template.name).unwrap_or_else(|missing| panic!("{missing}"));
        let engine = engine(template.name);
        let loads = exact(&engine);
        (evidence, engine, loads)
    });
    all.collect()
}

#[test]
fn gallery_has_at_least_24_layouts_each_with_evidence_and_no_evidence_without_a_layout() {
    let templates: std::collections::BTreeSet<String> =
        lanchester_file::templates().iter().map(|t| t.name.to_string()).collect();
    assert!(templates.len() >= 24, "{} templates", templates.len());
    assert_eq!(templates, evidence::names());
    for (evidence, _, _) in gallery() {
        assert!(templates.contains(&evidence.template));
        assert_eq!(evidence.script, "validation/layouts/derive.py");
        assert!(!evidence.layout.is_empty() && !evidence.numpy.is_empty() && !evidence.date.is_empty());
    }
}

#[test]
fn ext_derive_orders_peaks_and_dead_centres_of_every_template() {
    let found: Vec<String> = gallery().iter().flat_map(|(e, _, loads)| mismatches(e, loads)).collect();
    assert!(found.is_empty(), "{} differences:\n{}", found.len(), found.join("\n"));
}

/// What no template has: piston-pin and cylinder offset, rod inertia on articulated rods, a shaft at half speed.
#[test]
fn ext_derive_offsets_rod_inertia_articulation_and_half_speed_at_once() {
    let folder = evidence::folder().join("extra");
    let text = std::fs::read_to_string(folder.join("everything-at-once.toml")).expect("the file is there");
    let evidence = evidence::read("extra/everything-at-once").unwrap_or_else(|missing| panic!("{missing}"));
    let engine = lanchester_file::read(&text).engine().expect("the file has no mistake");
    assert_eq!(evidence.period_revolutions, 2);
    let found = mismatches(&evidence, &exact(&engine));
    assert!(found.is_empty(), "{}", found.join("\n"));

    // Each of them is felt: without it the comparison fails.
    let without: [fn(&mut EngineParts); 5] = [
        |e| e.cylinders[0].pin_offset = 0.0,
        |e| e.cylinders[1].offset = 0.0,
        |e| e.cylinders[0].rod.inertia = None,
        |e| e.cylinders[2].rod.inertia = None,
        |e| e.shafts[0].x = 0.0,
    ];
    for (which, take) in without.into_iter().enumerate() {
        let changed = engine.with(take).expect("it is an engine");
        assert!(
            !mismatches(&evidence, &exact(&changed)).is_empty(),
            "taking away number {which} is not noticed"
        );
    }
}

#[test]
fn ext_derive_every_template_fires_as_its_layout_claims() {
    let found: Vec<String> =
        gallery().iter().flat_map(|(e, engine, loads)| firing_mismatches(e, engine, loads)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// The comparison is worth something only if it fails when it should.
#[test]
fn comparison_fails_where_a_value_is_off_by_a_millionth() {
    for (evidence, _, loads) in gallery() {
        let largest = |list: &[evidence::Coefficient]| {
            let norms = list.iter().enumerate().map(|(k, c)| (c.value().norm(), k));
            norms.max_by(|a, b| a.0.total_cmp(&b.0)).expect("orders -8 to 8")
        };
        let picks: [fn(&mut Evidence) -> &mut Vec<evidence::Coefficient>; 4] =
            [|e| &mut e.force, |e| &mut e.couple, |e| &mut e.roll_moment, |e| &mut e.shaft_torque];
        let scale = [
            evidence.uncancelled.force,
            evidence.uncancelled.couple,
            evidence.uncancelled.moment,
            evidence.uncancelled.moment,
        ];
        let mut seen = 0;
        for (pick, scale) in picks.into_iter().zip(scale) {
            let mut perturbed = evidence.clone();
            let list = pick(&mut perturbed);
            let (norm, index) = largest(list);
            // What a layout cancels altogether has no largest order to perturb.
            if norm <= 1e-6 * scale {
                continue;
            }
            list[index].scale(1.0 + 1e-6);
            assert!(
                !mismatches(&perturbed, &loads).is_empty(),
                "{} accepts a wrong value",
                evidence.template
            );
            seen += 1;
        }
        assert!(seen >= 1, "{}: nothing could be perturbed", evidence.template);

        let mut perturbed = evidence.clone();
        perturbed.peaks.shaft_torque.max *= 1.0 + 1e-6;
        assert!(!mismatches(&perturbed, &loads).is_empty(), "{} accepts a wrong peak", evidence.template);
        let mut perturbed = evidence.clone();
        perturbed.cylinders[0].top_dead_centre += 2e-6;
        assert!(!mismatches(&perturbed, &loads).is_empty(), "{} accepts a wrong TDC", evidence.template);
    }
}

#[test]
fn comparison_fails_where_two_throws_are_swapped() {
    let mut swapped = 0;
    for (evidence, mut engine, _) in gallery() {
        let first = engine.throws[0].angle;
        let Some(other) = engine.throws.iter().position(|t| ((t.angle - first) / 2.0).sin().abs() > 1e-6)
        else {
            continue;
        };
        engine = engine
            .with(|engine| {
                engine.throws[0].angle = engine.throws[other].angle;

                engine.throws[other].angle = first;
            })
            .unwrap();
        assert!(
            !mismatches(&evidence, &exact(&engine)).is_empty(),
            "{}: throws 1 and {} swapped, and nothing noticed",
            evidence.template,
            other + 1
        );
        swapped += 1;
    }
    assert!(swapped >= 15, "only {swapped} templates have two unlike throws");
}

#[test]
fn comparison_fails_where_two_cylinders_fire_in_the_other_order() {
    for (evidence, mut engine, loads) in gallery() {
        let Some(claimed) = &evidence.firing else { continue };
        let [.., a, b] = claimed.as_slice() else { continue };
        if a.angle_deg == b.angle_deg {
            continue;
        }
        let (a, b) = (a.cylinder - 1, b.cylinder - 1);
        let keep = engine.cylinders[a].firing_angle;
        engine = engine
            .with(|engine| {
                engine.cylinders[a].firing_angle = engine.cylinders[b].firing_angle;

                engine.cylinders[b].firing_angle = keep;
            })
            .unwrap();
        assert!(!firing_mismatches(&evidence, &engine, &loads).is_empty(), "{}", evidence.template);
    }
}
