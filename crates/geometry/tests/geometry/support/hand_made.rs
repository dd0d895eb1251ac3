//! Engines made by hand for clearances, with a slider-crank of their own, and distances in space by formulas of their own.

use lanchester_geometry::clearance::{Obstacle, RodBounds, RodMotion, RodPose};
use lanchester_geometry::{Contour, Edge, Outline, Part, Point};
use lanchester_model::{
    Counterweight, CounterweightForm, CounterweightPart, Crankshaft, Cylinder, Engine, EngineParts, Envelope,
    Liner, Ratio, Rod, RodEnvelope, RodJoint, RodMassRule, Rotation, Skirt, SpeedRange, Strokes, Throw,
};
use std::f64::consts::{PI, TAU};

/// Crank radius, rod length and bore of all engines here [m].
pub const RADIUS: f64 = 0.04;
pub const LENGTH: f64 = 0.14;
pub const BORE: f64 = 0.08;

/// A plain slider-crank straight from the formulas of the conventions.
#[derive(Debug, Clone, Copy)]
pub struct Slider {
    pub ratio: f64,
    pub pin: f64,
    pub axis: f64,
    pub offset: f64,
}

impl Slider {
    /// The motion of every cylinder of an engine with plain rods.
    pub fn all(engine: &Engine) -> Vec<Slider> {
        engine.cylinders.iter().map(|cylinder| Slider::of(engine, cylinder)).collect()
    }

    fn of(engine: &Engine, cylinder: &Cylinder) -> Slider {
        Slider {
            ratio: engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio.value(),
            pin: engine.pin_angle(cylinder.throw, 0.0),
            axis: cylinder.angle,
            offset: cylinder.net_offset(),
        }
    }

    /// `s = r cos phi + sqrt(l^2 - (r sin phi - e)^2)`.
    pub fn travel(&self, theta: f64) -> f64 {
        let phi = self.ratio * theta + self.pin - self.axis;
        let beside = RADIUS * phi.sin() - self.offset;
        RADIUS * phi.cos() + (LENGTH * LENGTH - beside * beside).sqrt()
    }
}

impl RodMotion for Slider {
    fn pose(&self, theta: f64) -> RodPose {
        let angle = self.ratio * theta + self.pin;
        let pin = Point::polar(RADIUS, angle);
        let along = Point::polar(1.0, self.axis);
        let piston = along * self.travel(theta) - along.right() * self.offset;
        let rod = piston - pin;
        let phi = angle - self.axis;
        let beside = RADIUS * phi.sin() - self.offset;
        let swing = self.ratio * RADIUS * phi.cos() / (LENGTH * LENGTH - beside * beside).sqrt();
        RodPose {
            lower_pin: pin,
            lower_pin_rate: -pin.right() * self.ratio,
            direction: rod.y.atan2(rod.x),
            direction_rate: -swing,
            travel: self.travel(theta),
            travel_rate: -self.ratio * RADIUS * phi.sin() - beside * swing,
        }
    }

    fn bounds(&self) -> RodBounds {
        let beside = RADIUS + self.offset.abs();
        let w = (LENGTH * LENGTH - beside * beside).sqrt();
        let k = RADIUS / w;
        let k1 = (RADIUS + beside * k * k) / w;
        let (n, n2) = (self.ratio.abs(), self.ratio * self.ratio);
        RodBounds {
            lower_pin: [RADIUS, n * RADIUS, n2 * RADIUS],
            direction: [n * k, n2 * k1],
            travel: [n * (RADIUS + beside * k), n2 * (RADIUS + RADIUS * k + beside * k1)],
        }
    }
}

pub fn cylinder(throw: usize, angle: f64, z: f64) -> Cylinder {
    Cylinder {
        throw,
        angle,
        z,
        offset: 0.0,
        pin_offset: 0.0,
        bore: Some(BORE),
        piston_mass: 0.5,
        rod: Rod {
            length: LENGTH,
            big_end_mass: 0.4,
            small_end_mass: 0.2,
            inertia: None,
            axial_inertia: 0.0,
            mass_rule: RodMassRule::WeighedEnds,
            joint: RodJoint::Crankpin,
        },
        firing_angle: None,
        chamber: None,
    }
}

pub fn throw(crankshaft: usize, angle: f64, z: f64) -> Throw {
    Throw {
        crankshaft,
        angle,
        z,
        radius: RADIUS,
        unbalance: 0.0,
        unbalance_offset: 0.0,
        webs: Some([z - 0.02, z + 0.02]),
    }
}

pub fn crankshaft(ratio: (i32, u32), x: f64, y: f64) -> Crankshaft {
    let ratio = Ratio::new(ratio.0, ratio.1).unwrap();
    Crankshaft { name: format!("at {x} {y}"), ratio, phase: 0.0, x, y, mains: None }
}

/// A counterweight against the first throw, from `faces[0]` to `faces[1]`, on web `web`.
pub fn counterweight(outline: Outline, faces: [f64; 2], web: Option<usize>) -> Counterweight {
    let part = Part::new(outline, faces[1] - faces[0], 7850.0).unwrap();
    let z = 0.5 * (faces[0] + faces[1]);
    let form = CounterweightForm::Counterweight;
    Counterweight {
        name: "counterweight".to_string(),
        crankshaft: 0,
        z,
        unbalance: 0.0,
        angle: PI,
        part: Some(Box::new(CounterweightPart { form, part, web, z, angle: PI, wanted: None })),
    }
}

/// One crankshaft, one throw along +x, these cylinders on it, nothing to stay clear of yet.
pub fn engine(cylinders: Vec<Cylinder>, counterweights: Vec<Counterweight>) -> Engine {
    Engine::new(parts(cylinders, counterweights)).unwrap()
}

/// As [`engine`], to be changed.
pub fn parts(cylinders: Vec<Cylinder>, counterweights: Vec<Counterweight>) -> EngineParts {
    EngineParts {
        name: "made by hand".to_string(),
        strokes: Strokes::Four,
        rotation: Rotation::Clockwise,
        speed: SpeedRange { lowest: 100.0, highest: 100.0 },
        crankshafts: vec![crankshaft((1, 1), 0.0, 0.0)],
        throws: vec![throw(0, 0.0, 0.0)],
        cylinders,
        counterweights,
        envelope: Some(Envelope::default()),
        ..EngineParts::default()
    }
}

/// A sector of a disc about the crank axis, `half` an angle to both sides of x.
pub fn sector(radius: f64, half: f64) -> Outline {
    let arc = Edge::arc(Point::ORIGIN, radius, -half, 2.0 * half);
    let edges = [Edge::line(Point::ORIGIN, arc.from), arc, Edge::line(arc.to, Point::ORIGIN)];
    Contour::from_edges(&edges, 1e-9).unwrap().into()
}

pub fn skirt(length: f64, width: Option<f64>) -> Option<Skirt> {
    Some(Skirt { length, width })
}

pub fn liner(end: f64, wall: f64) -> Option<Liner> {
    Some(Liner { end, wall })
}

pub fn rod_envelope() -> Option<RodEnvelope> {
    Some(RodEnvelope {
        big_end_radius: 0.03,
        big_end_width: 0.02,
        shank_width: 0.025,
        shank_thickness: 0.014,
    })
}

/// Distance in space of a point from an obstacle, by formulas of its own: projections in the obstacle's own three axes,
/// round sections by a search along z.
pub fn distance_in_space(engine: &Engine, obstacle: Obstacle, theta: f64, at: [f64; 3]) -> f64 {
    let number = match obstacle {
        Obstacle::Piston { cylinder }
        | Obstacle::Liner { cylinder }
        | Obstacle::Rod { cylinder }
        | Obstacle::BigEndSide { cylinder } => cylinder,
        Obstacle::Crankcase => {
            let axis = &engine.crankshafts[0];
            return engine.envelope.unwrap().crankcase_radius.unwrap()
                - (at[0] - axis.x).hypot(at[1] - axis.y);
        }
    };
    let cylinder = &engine.cylinders[number - 1];
    let pin_throw = &engine.throws[cylinder.throw];
    let shaft = &engine.crankshafts[pin_throw.crankshaft];
    let slider = Slider::of(engine, cylinder);
    let (sin, cos) = cylinder.angle.sin_cos();
    let (x, y, z) = (at[0] - shaft.x, at[1] - shaft.y, at[2] - cylinder.z);
    let (along, beside) = (x * cos + y * sin, -x * sin + y * cos - cylinder.offset);
    let envelope = engine.envelope.unwrap();
    match obstacle {
        Obstacle::Piston { .. } => {
            let skirt = envelope.skirt.unwrap();
            let edge = slider.travel(theta) - skirt.length;
            let half = skirt.width.map_or(BORE / 2.0, |width| (width / 2.0).min(BORE / 2.0));
            (edge - along).max(0.0).hypot(from_disc(beside, z, half))
        }
        Obstacle::Liner { .. } => {
            let liner = envelope.liner.unwrap();
            let (rho, inner) = (beside.hypot(z), BORE / 2.0);
            let across = (inner - rho).max(rho - inner - liner.wall).max(0.0);
            (liner.end - along).max(0.0).hypot(across)
        }
        Obstacle::Rod { .. } | Obstacle::BigEndSide { .. } => {
            let rod = envelope.rod.unwrap();
            let angle = engine.pin_angle(cylinder.throw, theta);
            let (px, py) = (x - RADIUS * angle.cos(), y - RADIUS * angle.sin());
            let disc = (px.hypot(py) - rod.big_end_radius)
                .max(0.0)
                .hypot((z.abs() - rod.big_end_width / 2.0).max(0.0));
            if matches!(obstacle, Obstacle::BigEndSide { .. }) {
                return disc;
            }
            let travel = slider.travel(theta);
            let tip = [travel * cos - slider.offset * sin, travel * sin + slider.offset * cos];
            let (c, s) = ((tip[0] - RADIUS * angle.cos()) / LENGTH, (tip[1] - RADIUS * angle.sin()) / LENGTH);
            let (t, v) = (px * c + py * s, -px * s + py * c);
            let bar = (-t).max(t - LENGTH).max(0.0).hypot((v.abs() - rod.shank_width / 2.0).max(0.0));
            disc.min(bar.hypot((z.abs() - rod.shank_thickness / 2.0).max(0.0)))
        }
        Obstacle::Crankcase => f64::NAN,
    }
}

/// Distance from the disc of the bore cut off at `half`, by ternary search over the place along z of the foot.
fn from_disc(beside: f64, z: f64, half: f64) -> f64 {
    let radius = BORE / 2.0;
    let to = |foot: f64| {
        let reach = (radius * radius - foot * foot).max(0.0).sqrt();
        (z - foot).hypot((beside.abs() - reach).max(0.0))
    };
    let (mut from, mut end) = (-half, half);
    for _ in 0..50 {
        let (a, b) = (from + (end - from) / 3.0, end - (end - from) / 3.0);
        if to(a) <= to(b) { end = b } else { from = a }
    }
    to(0.5 * (from + end))
}

/// The smallest distance of a counterweight from an obstacle over a grid of angles of `period`, of points of its outline, of
/// smaller copies of it (its outline is a star about the axis) and of places along z.
pub fn sampled(engine: &Engine, obstacle: Obstacle, period: f64, angles: usize) -> f64 {
    let part = engine.counterweights[0].part.as_ref().unwrap();
    let shaft = &engine.crankshafts[0];
    let [front, rear] = part.part.faces().map(|z| z + part.z);
    let mut points = Vec::new();
    for edge in part.part.outline().contours().flat_map(|contour| contour.edges()) {
        let halves = if edge.bulge.abs() > 1.0 { edge.halves().to_vec() } else { vec![*edge] };
        for half in halves {
            points.extend((0..8).map(|at| half.at(f64::from(at) / 8.0).0));
        }
    }
    let inner: Vec<Point> =
        [0.3, 0.7].iter().flat_map(|f| points.iter().step_by(3).map(move |p| *p * *f)).collect();
    points.extend(inner);
    let planes: Vec<f64> = (0..=2).map(|at| front + (rear - front) * f64::from(at) / 2.0).collect();
    let mut least = f64::INFINITY;
    for at in 0..angles {
        let theta = period * at as f64 / angles as f64;
        let turn = theta + part.angle;
        for point in &points {
            let placed = point.turned(turn);
            for z in &planes {
                let place = [placed.x + shaft.x, placed.y + shaft.y, *z];
                least = least.min(distance_in_space(engine, obstacle, theta, place));
            }
        }
    }
    least
}

/// A turn.
pub const TURN: f64 = TAU;
