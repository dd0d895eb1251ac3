//! Crankshafts as bodies: against the engine's throws and counterweights, against their solids, and through STEP.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::support::random_crank;

use crate::support::random_crank::{any_body, any_wish, engine, engine_balance, plain_wish};
use crate::support::step_reader::StepFile;
use lanchester_file::{expanded, read, render};
use lanchester_geometry::crankshaft::{CrankshaftBody, CrankshaftError, SectionKind, crankshaft};
use lanchester_geometry::export::{RESOLUTION, StepHeader, glb, solids, step, stl};
use lanchester_geometry::{Contour, GeometryError, Insert, MassMoments, Outline, Part, Point};
use lanchester_model::*;
use proptest::prelude::*;
use std::f64::consts::PI;

/// Mass times reach, and that times half the length: what unbalance and couple are measured by.
fn amounts(body: &CrankshaftBody) -> [f64; 2] {
    let reach = body.outlines().map(|(_, outline, _)| outline.swept_radius()).fold(0.0, f64::max);
    let length = body.sections.iter().flat_map(|s| [s.from.abs(), s.to.abs()]).fold(0.0, f64::max);
    [body.mass.mass * reach, body.mass.mass * reach * length]
}

fn moments_of_the_solids(body: &CrankshaftBody) -> MassMoments {
    let own =
        body.parts.iter().map(|placed| placed.part.moments().turned(placed.turn).moved([0.0, 0.0, placed.z]));
    own.fold(MassMoments::default(), |sum, next| sum + next)
}

fn assert_sums(body: &CrankshaftBody) {
    let mass: f64 = body.sections.iter().map(|section| section.mass).sum();
    let inertia: f64 = body.sections.iter().map(|section| section.polar_inertia).sum();
    assert!((mass - body.mass.mass).abs() < 1e-13 * mass);
    assert!((inertia - body.polar_inertia).abs() < 1e-13 * inertia);
    let mass: f64 = body.throws.iter().map(|throw| throw.mass).sum();
    assert!((mass - body.mass.mass).abs() < 1e-13 * mass);
    let couple = body.throws.iter().fold(Point::ORIGIN, |sum, throw| sum + throw.unbalance.couple);
    let points = body.point_weights.iter().fold(Point::ORIGIN, |sum, weight| sum + weight.unbalance.couple);
    assert!((couple + points - body.unbalance.couple).norm() < 1e-13 * amounts(body)[1]);
    assert!(body.sections.windows(2).all(|pair| pair[0].from + pair[0].to <= pair[1].from + pair[1].to));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn prop_weights_that_share_the_disc_balance_as_the_engine_says(
        body in any_body(),
        throws in prop::collection::vec((-PI..PI, 0.03..0.05f64), 1..5),
        gap in prop_oneof![Just(0.0), 0.01..0.05f64],
        wishes in prop::collection::vec(prop::option::of(plain_wish()), 8),
        flywheel in (0.0..0.02f64, -PI..PI),
    ) {
        let mut engine = engine(body, &throws, gap, &wishes);
        engine = engine.with(|engine| { engine.counterweights.push(Counterweight {
            name: "flywheel".to_owned(),
            crankshaft: 0,
            z: 0.3,
            unbalance: flywheel.0,
            angle: flywheel.1,
            part: None,
        }); }).unwrap();
        let crank = crankshaft(&engine, 0).unwrap();
        let ([unbalance, couple], [u, v]) = (engine_balance(&engine), amounts(&crank));
        prop_assert!((crank.unbalance.unbalance - unbalance).norm() < 1e-12 * u);
        prop_assert!((crank.unbalance.couple - couple).norm() < 1e-12 * v);
        prop_assert!(crank.counted_twice.unbalance.norm() < 1e-12 * u);
        prop_assert_eq!(crank.point_weights.len(), 1);
        assert_sums(&crank);
        // One solid for each web with its counterweight, journal and pin.
        let journals = crank.sections.iter().filter(|s| s.kind == SectionKind::Journal).count();
        prop_assert_eq!(crank.parts.len(), journals + 3 * throws.len());
        let solids = moments_of_the_solids(&crank).properties();
        prop_assert!((solids.mass - crank.mass.mass).abs() < 1e-12 * solids.mass);
        let scale = crank.mass.inertia_about_axis[0][0] + crank.polar_inertia;
        for (row, other) in solids.inertia_about_axis.iter().zip(crank.mass.inertia_about_axis) {
            prop_assert!((0..3).all(|k| (row[k] - other[k]).abs() < 1e-12 * scale));
        }
    }

    #[test]
    fn prop_what_weights_of_any_kind_share_is_told(
        body in any_body(),
        throws in prop::collection::vec((-PI..PI, 0.03..0.05f64), 1..4),
        gap in prop_oneof![Just(0.0), 0.01..0.05f64],
        wishes in prop::collection::vec(prop::option::of(any_wish()), 6),
    ) {
        // A whole web stands for the plain one in its plane, of its thickness.
        let wishes: Vec<_> = wishes.into_iter().map(|wish| wish.map(|mut wish| {
            if wish.form == 1 {
                (wish.shift, wish.thickness) = (0.0, 1.0);
            }
            wish
        })).collect();
        let engine = engine(body, &throws, gap, &wishes);
        let crank = match crankshaft(&engine, 0) {
            Err(CrankshaftError::Shape { source: GeometryError::InsertOutside { what: "overlaps another insert", .. }, .. }) => {
                prop_assert!(inserts_overlap(&engine), "refused, though no two inserts meet");
                return Ok(());
            }
            other => other.unwrap(),
        };
        prop_assert!(!inserts_overlap(&engine), "two inserts in one place");
        let ([unbalance, couple], [u, v]) = (engine_balance(&engine), amounts(&crank));
        let twice = crank.counted_twice;
        prop_assert!((crank.unbalance.unbalance + twice.unbalance - unbalance).norm() < 1e-12 * u);
        prop_assert!((crank.unbalance.couple + twice.couple - couple).norm() < 1e-12 * v);
        assert_sums(&crank);
        if engine.counterweights.iter().flat_map(|w| &w.part).all(|p| p.part.density() == body.density) {
            // Of one material: solids beside each other, that hold everything once.
            let solids = moments_of_the_solids(&crank).properties();
            prop_assert!((solids.mass - crank.mass.mass).abs() < 1e-12 * solids.mass);
            prop_assert!((solids.unbalance - crank.mass.unbalance).norm() < 1e-12 * u);
        }
    }

    #[test]
    fn prop_webs_between_two_pins_balance_as_the_engine_says(
        angles in prop::collection::vec(-180..180i32, 2..6),
        radii in prop::collection::vec(28..45i32, 5),
        shares in prop::collection::vec((any::<bool>(), 2..14i32), 4),
        numbers in (0..20i32, 4..20i32, 32..40i32),
    ) {
        let text = with_shared_webs(&angles, &radii, &shares, numbers);
        let reading = read(&text);
        let engine = reading.engine().unwrap_or_else(|| panic!("{}", render(&reading.diagnostics, "file", &text, false)));
        let shared = shares.iter().take(angles.len() - 1).filter(|(is_shared, _)| *is_shared).count();
        prop_assert_eq!(engine.shared_webs().len(), shared);
        let crank = crankshaft(&engine, 0).unwrap();
        let ([unbalance, couple], [u, v]) = (engine_balance(&engine), amounts(&crank));
        prop_assert!(crank.counted_twice.unbalance.norm() < 1e-12 * u);
        prop_assert!((crank.unbalance.unbalance - unbalance).norm() < 1e-12 * u);
        prop_assert!((crank.unbalance.couple - couple).norm() < 1e-12 * v);
        let again = read(&expanded(&engine.clone().into())).engine();
        prop_assert_eq!(again.as_ref(), Some(&engine));
        assert_sums(&crank);
        // Of each shared web both halves, a journal beside every other web.
        let sections = |kind| crank.sections.iter().filter(|section| section.kind == kind).count();
        prop_assert_eq!(sections(SectionKind::Web), 2 * angles.len());
        prop_assert_eq!(sections(SectionKind::Journal), angles.len() + 1 - shared);
        let faces: Vec<[f64; 2]> = crank.sections.iter().map(|section| [section.from, section.to]).collect();
        prop_assert!(faces.windows(2).all(|pair| (pair[0][1] - pair[1][0]).abs() < 1e-9), "gap or overlap");
        let exported = solids(&crank.parts).unwrap();
        let read = StepFile::parse(&step(&exported, &StepHeader::default())).solids(1e3 * RESOLUTION);
        let volume: f64 = read.iter().map(|solid| solid.volume * 1e-9).sum();
        prop_assert!((volume * 7850.0 / crank.mass.mass - 1.0).abs() < 1e-6);
    }

    #[test]
    fn prop_step_of_a_crankshaft_has_its_volume_and_centre(
        body in any_body(),
        throws in prop::collection::vec((-PI..PI, 0.03..0.05f64), 1..4),
        wishes in prop::collection::vec(prop::option::of(any_wish()), 6),
    ) {
        let one_material = |mut wish: random_crank::Wish| {
            (wish.density, wish.has_insert) = (body.density, false);
            wish
        };
        let wishes: Vec<_> = wishes.into_iter().map(|wish| wish.map(one_material)).collect();
        let crank = crankshaft(&engine(body, &throws, 0.03, &wishes), 0).unwrap();
        let exported = solids(&crank.parts).unwrap();
        let read = StepFile::parse(&step(&exported, &StepHeader::default())).solids(1e3 * RESOLUTION);
        prop_assert_eq!(read.len(), crank.parts.len());
        let volume: f64 = read.iter().map(|solid| solid.volume * 1e-9).sum();
        prop_assert!((volume * body.density / crank.mass.mass - 1.0).abs() < 1e-6);
        for k in 0..3 {
            let centre = read.iter().map(|solid| solid.volume * 1e-9 * solid.centroid[k] * 1e-3).sum::<f64>() / volume;
            prop_assert!((centre - crank.mass.centre[k]).abs() < 1e-6 * 0.1, "{} {}", centre, crank.mass.centre[k]);
        }
    }
}

/// Whether inserts of two counterweights want the same place.
fn inserts_overlap(engine: &Engine) -> bool {
    let inserts: Vec<(Point, f64, [f64; 2])> = engine
        .counterweights
        .iter()
        .filter_map(|weight| weight.part.as_deref())
        .flat_map(|placed| {
            let front = placed.z - 0.5 * placed.part.thickness();
            let at = move |insert: &Insert| {
                (insert.centre.turned(placed.angle), insert.radius, [front + insert.from, front + insert.to])
            };
            placed.part.inserts().iter().map(at)
        })
        .collect();
    inserts.iter().enumerate().any(|(index, (centre, radius, [from, to]))| {
        inserts[..index].iter().any(|(other, other_radius, [other_from, other_to])| {
            // Plates that touch share nothing but rounding.
            (*centre - *other).norm() < radius + other_radius
                && from.max(*other_from) + 1e-12 < to.min(*other_to)
        })
    })
}

/// An engine whose neighbouring throws share a web of so many millimetres, or have a journal between them.
fn with_shared_webs(
    angles: &[i32],
    radii: &[i32],
    shares: &[(bool, i32)],
    (bore, journal, end): (i32, i32, i32),
) -> String {
    const WEB: i32 = 15;
    const DISTANCE: i32 = 40;
    let mut z = 0;
    let mut text = format!(
        "name = \"x\"\nspeed = \"3000 rpm\"\n[piston]\nmass = \"0.4 kg\"\n[rod]\nlength = \"150 mm\"\nmass = \"0.5 kg\"\n\
         [crank]\nweb_distance = \"{DISTANCE} mm\"\n[crank.body]\ndensity = \"7850 kg/m3\"\njournal_diameter = \"50 mm\"\n\
         pin_diameter = \"44 mm\"\npin_bore = \"{bore} mm\"\nweb_thickness = \"{WEB} mm\"\nweb_radius = \"36 mm\"\n\
         pin_end_radius = \"{end} mm\"\nend_journals = \"20 mm\"\n"
    );
    for (index, angle) in angles.iter().enumerate() {
        let turn = angle - angles[0];
        text +=
            &format!("[[throw]]\nangle = \"{turn} deg\"\nradius = \"{} mm\"\nz = \"{z} mm\"\n", radii[index]);
        text += &format!("[[cylinder]]\nthrow = {}\nangle = \"0 deg\"\n", index + 1);
        if let Some((is_shared, web)) = shares.get(index) {
            z += if *is_shared { DISTANCE - WEB + web } else { DISTANCE + WEB + journal };
        }
    }
    text
}

fn plain_body() -> CrankBody {
    CrankBody {
        density: 7850.0,
        journal_diameter: 0.05,
        journal_bore: 0.0,
        pin_diameter: 0.04,
        pin_bore: 0.0,
        web_thickness: 0.02,
        web_radius: 0.04,
        pin_end_radius: 0.03,
        end_journals: [0.03, 0.05],
    }
}

fn with_part(mut engine: Engine, part: Part, web: Option<usize>, form: CounterweightForm) -> Engine {
    let z = web.map_or(0.5, |web| engine.throws[web / 2].webs.unwrap()[web % 2]);
    let unbalance = part.moments().unbalance();
    let part = Some(Box::new(CounterweightPart { form, part, web, z, angle: 0.0, wanted: None }));
    let (name, angle) = ("hub".to_owned(), unbalance.y.atan2(unbalance.x));
    engine = engine
        .with(|engine| {
            engine.counterweights.push(Counterweight {
                name,
                crankshaft: 0,
                z,
                unbalance: unbalance.norm(),
                angle,
                part,
            });
        })
        .unwrap();
    engine
}

#[test]
fn a_plain_crankshaft_is_the_sum_of_cylinders_and_hulls() {
    let body = plain_body();
    let crank = crankshaft(&engine(body, &[(0.5, 0.06)], 0.03, &[]), 0).unwrap();
    let web = body.web(0.06).unwrap().moments().area * 0.02;
    let round = PI * (0.025f64.powi(2) * 0.08 + 0.02f64.powi(2) * 0.03);
    let mass = 7850.0 * (2.0 * web + round);
    assert!((crank.mass.mass - mass).abs() < 1e-14 * mass);
    let names: Vec<&str> = crank.sections.iter().map(|section| section.name.as_str()).collect();
    assert_eq!(names, ["journal 1", "web 1", "pin 1", "web 2", "journal 2"]);
    assert_eq!(crank.sections[0].from, -0.065);
    assert!((crank.unbalance.unbalance.y.atan2(crank.unbalance.unbalance.x) - 0.5).abs() < 1e-12);
    // A throw at the origin, and ends that turn in themselves: no couple.
    assert!(crank.unbalance.couple.norm() < 1e-15);
}

#[test]
fn a_hub_thicker_than_its_web_counts_once() {
    // A disc like that of the web, three times as thick: beyond the web it replaces journal and stands around the pin.
    let body = CrankBody { pin_diameter: 0.03, ..plain_body() };
    let plain = engine(body, &[(0.0, 0.07)], 0.03, &[]);
    let disc: Outline = Contour::circle(Point::ORIGIN, 0.04).unwrap().into();
    let part = Part::new(disc.clone(), 0.03, 7850.0).unwrap();
    let crank =
        crankshaft(&with_part(plain.clone(), part, Some(0), CounterweightForm::Counterweight), 0).unwrap();
    let before = crankshaft(&plain, 0).unwrap();
    // 5 mm on each side: without the journal on the one, whole on the other, where the pin is 15 mm away from the disc.
    let added = 7850.0 * PI * (0.005 * (0.04f64.powi(2) - 0.025f64.powi(2)) + 0.005 * 0.04f64.powi(2));
    assert!((crank.mass.mass - before.mass.mass - added).abs() < 1e-13 * before.mass.mass);
    // It shares the disc with its web, which is balanced; a longer pin end, or a pin closer by, would not be.
    let scale = crank.mass.mass * 0.1;
    assert!(crank.counted_twice.unbalance.norm() < 1e-13 * scale);
    let close = engine(CrankBody { pin_diameter: 0.05, ..body }, &[(0.0, 0.05)], 0.03, &[]);
    let part = Part::new(disc.clone(), 0.03, 7850.0).unwrap();
    let crank = crankshaft(&with_part(close, part, Some(0), CounterweightForm::Counterweight), 0).unwrap();
    // The lens of hub and pin over 5 mm: both discs less their union.
    let pin: Outline = Contour::circle(Point::new(0.05, 0.0), 0.025).unwrap().into();
    let lens = disc.moments() + pin.moments() - disc.union(&pin).unwrap().moments();
    let twice = crank.counted_twice.unbalance;
    assert!((twice - lens.first * (7850.0 * 0.005)).norm() < 1e-13 * scale, "{twice:?}");
}

#[test]
fn a_weight_beside_the_webs_and_parts_with_chamfers_stand_alone() {
    use lanchester_geometry::{Chamfer, Cut, Face};
    let plain = engine(plain_body(), &[(0.0, 0.06)], 0.03, &[]);
    let ring: Outline = Contour::circle(Point::new(0.01, 0.0), 0.06).unwrap().into();
    let chamfer = Chamfer { cut: Cut::Turned { radius: 0.06 }, angle: 0.5, face: Face::Front };
    let part = Part::new(ring, 0.01, 7850.0).unwrap().with_chamfer(chamfer).unwrap();
    let before = crankshaft(&plain, 0).unwrap();
    let engine = with_part(plain, part.clone(), None, CounterweightForm::Counterweight);
    let crank = crankshaft(&engine, 0).unwrap();
    assert_eq!(crank.parts.len(), before.parts.len() + 1);
    assert!((crank.mass.mass - before.mass.mass - part.moments().mass).abs() < 1e-13 * crank.mass.mass);
    let free = crank.throws.last().unwrap();
    assert_eq!(free.throw, None);
    // The chamfer is on one face only: the engine's single weight would stand a little behind the middle.
    assert!((crank.unbalance.unbalance - engine_balance(&engine)[0]).norm() < 1e-15);
    // Its chamfer is exported with it: a cone in the file of the whole.
    let exported = solids(&crank.parts).unwrap();
    assert_eq!(exported.len(), crank.parts.len());
    assert!(step(&exported, &StepHeader::default()).contains("CONICAL_SURFACE"));
}

#[test]
fn meshes_of_a_crankshaft_are_written() {
    let crank = crankshaft(&engine(plain_body(), &[(0.0, 0.06), (PI, 0.06)], 0.03, &[]), 0).unwrap();
    let exported = solids(&crank.parts).unwrap();
    assert_eq!(stl(&exported, 1e-4).unwrap().len() % 50, 84 % 50);
    assert_eq!(&glb(&exported, 1e-4).unwrap()[..4], b"glTF");
    let names: Vec<String> = exported.iter().map(|solid| solid.name().to_owned()).collect();
    assert_eq!(names[..4], ["journal 1", "web 1", "pin 1", "web 2"]);
}

#[test]
fn an_engine_without_a_body_is_told_what_the_file_needs() {
    let good = engine(plain_body(), &[(0.0, 0.06)], 0.03, &[]);
    let mut bare = good.clone();
    bare = bare
        .with(|bare| {
            bare.crank_body = None;
        })
        .unwrap();
    let error = crankshaft(&bare, 0).unwrap_err();
    assert_eq!(error, CrankshaftError::NoBody);
    assert!(error.to_string().contains("add [crank.body]"));
    assert_eq!(crankshaft(&good, 1).unwrap_err(), CrankshaftError::NoCrankshaft { index: 1, count: 1 });
    let mut without = good.clone();
    without = without
        .with(|without| {
            without.throws[0].webs = None;
        })
        .unwrap();
    assert_eq!(crankshaft(&without, 0).unwrap_err(), CrankshaftError::NoWebs { throw: 0 });
    let mut narrow = good.clone();
    narrow = narrow
        .with(|narrow| {
            narrow.throws[0].webs = Some([-0.01, 0.01]);
        })
        .unwrap();
    assert!(matches!(crankshaft(&narrow, 0), Err(CrankshaftError::NoPin { throw: 0, .. })));
    let bored = good.with(|parts| parts.crank_body = Some(CrankBody { journal_bore: 0.06, ..plain_body() }));
    assert!(bored.unwrap_err()[0].to_string().starts_with("crank_body: journal_bore [m] must be less than"));
}

#[test]
fn every_crankshaft_has_its_own_throws_and_weights() {
    let both = engine(plain_body(), &[(0.0, 0.06), (2.0, 0.05)], 0.03, &[]);
    let mut apart = both.clone();
    apart = apart
        .with(|apart| {
            apart.crankshafts.push(Crankshaft {
                name: "second".to_owned(),
                x: 0.2,
                ..apart.crankshafts[0].clone()
            });

            apart.throws[1].crankshaft = 1;
        })
        .unwrap();
    let weight = |crankshaft| Counterweight {
        name: "pulley".to_owned(),
        crankshaft,
        z: 0.1,
        unbalance: 0.01,
        angle: 1.0,
        part: None,
    };
    apart = apart
        .with(|apart| {
            apart.counterweights.push(weight(1));
        })
        .unwrap();
    let [first, second] = [0, 1].map(|index| crankshaft(&apart, index).unwrap());
    assert_eq!((first.sections.len(), second.name.as_str()), (5, "second"));
    assert_eq!(second.sections[1].name, "web 3");
    assert!(first.point_weights.is_empty());
    let expected = Point::polar(apart.throws[1].unbalance, 2.0) + Point::polar(0.01, 1.0);
    assert!((second.unbalance.unbalance - expected).norm() < 1e-14);
    // Together they have one journal in the middle, apart two ends each.
    let journal = 7850.0 * PI * 0.025f64.powi(2) * 0.08;
    let together = crankshaft(&both, 0).unwrap().mass.mass - 7850.0 * PI * 0.025f64.powi(2) * 0.03;
    assert!((first.mass.mass + second.mass.mass - journal - together).abs() < 1e-13 * together);
    apart = apart
        .with(|apart| {
            apart.throws[1].crankshaft = 0;
        })
        .unwrap();
    assert_eq!(crankshaft(&apart, 1).unwrap_err(), CrankshaftError::NoThrow { index: 1 });
}

const FILE: &str = r#"name = "Twin"
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
crank_angles = ["0 deg", "150 deg"]
[crank]
stroke = "60 mm"
web_distance = "36 mm"
[crank.body]
density = "7.85 g/cm3"
journal_diameter = "48 mm"
journal_bore = "12 mm"
pin_diameter = "40 mm"
pin_bore = "16 mm"
web_thickness = "14 mm"
web_radius = "32 mm"
pin_end_radius = "32 mm"
end_journals = ["25 mm", "1.5 in"]
[[counterweight]]
web = 1
[counterweight.shape]
thickness = "14 mm"
rectangle_height = "15 mm"
shoulder_angle = "35 deg"
arc_radius = "62 mm"
arc_angle = "110 deg"
[[counterweight]]
web = 4
[counterweight.shape]
thickness = "14 mm"
encloses = "web"
density = "7.85 g/cm3"
outline = [
  { x = "-65 mm", y = "-30 mm" },
  { x = "10 mm", y = "-40 mm" },
  { x = "60 mm", y = "-30 mm", bulge = 0.3 },
  { x = "60 mm", y = "35 mm" },
  { x = "-65 mm", y = "30 mm" },
]
[[counterweight]]
name = "flywheel"
z = "120 mm"
unbalance = "0.001 kg m"
angle = "20 deg"
"#;

#[test]
fn the_crankshaft_of_a_file_balances_as_its_loads_do() {
    let reading = read(FILE);
    let engine =
        reading.engine().unwrap_or_else(|| panic!("{}", render(&reading.diagnostics, "file", FILE, false)));
    let crank = crankshaft(&engine, 0).unwrap();
    let ([unbalance, couple], [u, v]) = (engine_balance(&engine), amounts(&crank));
    assert!(crank.counted_twice.unbalance.norm() < 1e-12 * u);
    assert!((crank.unbalance.unbalance - unbalance).norm() < 1e-12 * u);
    assert!((crank.unbalance.couple - couple).norm() < 1e-12 * v);
    assert_eq!(crank.parts.len(), 9);
    assert_eq!(crank.point_weights[0].name, "flywheel");
}
