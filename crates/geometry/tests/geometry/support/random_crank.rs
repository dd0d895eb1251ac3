//! Random crankshafts with counterweights as parts, and what the engine's throws and weights say of their balance.

use lanchester_geometry::{CounterweightShape, Insert, Part, Point};
use lanchester_model::*;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_6, PI};

/// A body whose webs lie within the reach of their disc on the side away from the pin.
pub fn any_body() -> impl Strategy<Value = CrankBody> {
    let ends = prop_oneof![Just([0.0, 0.0]), [0.01..0.05f64, 0.01..0.05f64]];
    (0.02..0.03f64, 0.4..1.0f64, 0.3..0.95f64, 0.012..0.025f64, prop_oneof![Just(0.0), 0.1..0.9f64], ends)
        .prop_map(|(web_radius, end, journal, web_thickness, bore, end_journals)| {
            let pin_end_radius = end * web_radius;
            let (journal_diameter, pin_diameter) =
                (2.0 * journal * web_radius, 1.8 * journal * pin_end_radius);
            CrankBody {
                density: 7850.0,
                journal_diameter,
                journal_bore: bore * journal_diameter,
                pin_diameter,
                pin_bore: bore * pin_diameter,
                web_thickness,
                web_radius,
                pin_end_radius,
                end_journals,
            }
        })
}

/// What a counterweight is like beside the web on which it sits.
#[derive(Debug, Clone)]
pub struct Wish {
    pub heights: [f64; 2],
    pub arc: [f64; 2],
    /// Its thickness over that of the web, its place along z and its turn.
    pub thickness: f64,
    pub shift: f64,
    pub turn: f64,
    pub density: f64,
    pub has_insert: bool,
    pub form: u8,
}

/// Counterweights in the plane of their web, of its thickness and opposite the pin.
pub fn plain_wish() -> impl Strategy<Value = Wish> {
    ([0.0..0.03f64, 0.0..0.03f64], [0.03..0.07f64, 0.8..3.1f64], any::<bool>(), 0u8..2).prop_map(
        |(heights, arc, has_insert, form)| Wish {
            heights,
            arc,
            thickness: 1.0,
            shift: 0.0,
            turn: 0.0,
            density: 7850.0,
            has_insert,
            form,
        },
    )
}

/// Counterweights of any kind.
pub fn any_wish() -> impl Strategy<Value = Wish> {
    let thickness = prop_oneof![Just(1.0), 0.3..1.8f64];
    let shift = prop_oneof![Just(0.0), -0.01..0.01f64];
    let turn = prop_oneof![Just(0.0), Just(FRAC_PI_6), -PI..PI];
    let density = prop_oneof![Just(7850.0), Just(17_500.0)];
    (plain_wish(), thickness, shift, turn, density, 0u8..4).prop_map(
        |(wish, thickness, shift, turn, density, form)| Wish {
            thickness,
            shift,
            turn,
            density,
            form,
            ..wish
        },
    )
}

/// An engine with one crankshaft that has these throws (angle and radius) and, web by web, these counterweights.
pub fn engine(body: CrankBody, throws: &[(f64, f64)], gap: f64, wishes: &[Option<Wish>]) -> Engine {
    let distance = 2.5 * body.web_thickness;
    let spacing = distance + body.web_thickness + gap;
    let mut engine = empty();
    for (number, (angle, radius)) in throws.iter().enumerate() {
        let z = (number as f64 - 0.5 * (throws.len() - 1) as f64) * spacing;
        let pin =
            PI / 4.0 * (body.pin_diameter.powi(2) - body.pin_bore.powi(2)) * (distance - body.web_thickness);
        let web = body.web(*radius).unwrap().moments().first.x * body.web_thickness;
        engine = engine
            .with(|engine| {
                engine.throws.push(Throw {
                    crankshaft: 0,
                    angle: *angle,
                    z,
                    radius: *radius,
                    unbalance: body.density * (pin * radius - 2.0 * web),
                    unbalance_offset: 0.0,
                    webs: Some([z - distance / 2.0, z + distance / 2.0]),
                });
            })
            .unwrap();
    }
    for (web, wish) in wishes.iter().enumerate().filter(|(web, _)| *web < 2 * throws.len()) {
        let Some(wish) = wish else { continue };
        let throw = &engine.throws[web / 2];
        let plane = throw.webs.unwrap()[web % 2];
        engine = engine
            .with(|engine| {
                engine.counterweights.push(counterweight(&body, throw, web, plane, wish));
            })
            .unwrap();
    }
    engine = engine
        .with(|engine| {
            engine.crank_body = Some(body);
        })
        .unwrap();
    engine
}

fn counterweight(body: &CrankBody, throw: &Throw, web: usize, plane: f64, wish: &Wish) -> Counterweight {
    let shape = CounterweightShape {
        web_radius: body.web_radius,
        rectangle_height: wish.heights[0],
        shoulder_height: wish.heights[1],
        arc_radius: wish.arc[0],
        arc_angle: wish.arc[1],
    };
    let family = lanchester_geometry::Outline::from(shape.outline());
    let (form, outline) = match wish.form {
        1 => (CounterweightForm::Web, body.web(throw.radius).unwrap().union(&family).unwrap()),
        2 => (CounterweightForm::Counterweight, family),
        _ => (CounterweightForm::Family(shape), family),
    };
    let turn = if wish.form == 1 { 0.0 } else { wish.turn };
    let mut part = Part::new(outline, wish.thickness * body.web_thickness, wish.density).unwrap();
    if wish.has_insert {
        let thickness = part.thickness();
        let centre = Point::new(0.5 * (body.web_radius + shape.crown()), 0.0);
        let insert = Insert { centre, radius: 0.003, from: 0.0, to: thickness, density: 18_000.0 };
        part = part.clone().with_insert(insert).unwrap_or(part);
    }
    let (angle, z) = (throw.angle + PI + turn, plane + wish.shift);
    let mut unbalance = part.moments().unbalance();
    if form == CounterweightForm::Web {
        let plain = body.web(throw.radius).unwrap().moments().first * (body.density * body.web_thickness);
        unbalance = unbalance - plain;
    }
    Counterweight {
        name: format!("weight {}", web + 1),
        crankshaft: 0,
        // A whole web beside the plane of the plain one is no single weight: the tests give it its plane.
        z,
        unbalance: unbalance.norm(),
        angle: angle + unbalance.y.atan2(unbalance.x),
        part: Some(Box::new(CounterweightPart { form, part, web: Some(web), z, angle, wanted: None })),
    }
}

/// Unbalance and its moment along z, by the engine's throws and counterweights.
pub fn engine_balance(engine: &Engine) -> [Point; 2] {
    let throws = engine
        .throws
        .iter()
        .map(|throw| (throw.unbalance_plane(), Point::polar(throw.unbalance, throw.angle)));
    let weights = engine.counterweights.iter().map(|w| (w.z, Point::polar(w.unbalance, w.angle)));
    let all: Vec<(f64, Point)> = throws.chain(weights).collect();
    let sum = all.iter().fold(Point::ORIGIN, |sum, (_, unbalance)| sum + *unbalance);
    let moment = all.iter().fold(Point::ORIGIN, |sum, (z, unbalance)| sum + *unbalance * *z);
    [sum, moment]
}

fn empty() -> Engine {
    Engine::new(EngineParts {
        name: "sample".to_owned(),
        note: None,
        strokes: Strokes::Four,
        rotation: Rotation::Clockwise,
        speed: SpeedRange { lowest: 400.0, highest: 400.0 },
        crankshafts: vec![Crankshaft {
            name: "crankshaft".to_owned(),
            ratio: Ratio::ONE,
            phase: 0.0,
            x: 0.0,
            y: 0.0,
            mains: None,
        }],
        throws: Vec::new(),
        cylinders: Vec::new(),
        counterweights: Vec::new(),
        shafts: Vec::new(),
        mounts: Vec::new(),
        block: None,
        crank_body: None,
        envelope: None,
        gas: None,
        friction: None,
        flywheel: None,
        bearings: None,
    })
    .unwrap()
}
