//! What turns: counterweights and webs as plates on their crankshaft.

use crate::clearance::error::ClearanceError;
use lanchester_model::{CounterweightForm, Engine, Ratio};
use lanchester_shape::{Edge, Outline, Point};

/// An edge of at most half a turn with what bounds its points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    /// The edge, in the directions of the crankshaft at angle zero, from its axis.
    pub edge: Edge,
    /// Its length [m].
    pub length: f64,
    /// Its included angle [rad].
    pub turn: f64,
    /// Largest distance of its points from the axis [m].
    pub reach: f64,
}

impl Piece {
    fn of(edge: Edge) -> Piece {
        let (length, turn) = (edge.length(), 4.0 * edge.bulge.abs().atan());
        Piece { edge, length, turn, reach: edge.farthest(Point::ORIGIN).0 }
    }
}

/// A plate between two planes.
#[derive(Debug, Clone)]
pub(super) struct Plate {
    /// Its faces along z [m].
    pub faces: [f64; 2],
    /// All edges of its outline.
    pub pieces: Vec<Piece>,
    /// The outline; none for the crank axis itself.
    pub outline: Option<Outline>,
}

impl Plate {
    /// A plate with this outline, whose `x` stands at `angle` on the crankshaft.
    fn new(outline: &Outline, angle: f64, faces: [f64; 2]) -> Plate {
        let outline = outline.turned(angle);
        let edges = outline.contours().flat_map(|contour| contour.edges());
        let pieces = edges.flat_map(|edge| match edge.bulge.abs() > 1.0 {
            true => edge.halves().map(Piece::of).to_vec(),
            false => vec![Piece::of(*edge)],
        });
        Plate { faces, pieces: pieces.collect(), outline: Some(outline) }
    }

    /// The stretch of the crank axis between two planes.
    pub fn axis(faces: [f64; 2]) -> Plate {
        Plate::point(Point::ORIGIN, faces)
    }

    /// A stretch along the crank between two planes, that turns with the crankshaft.
    pub fn point(point: Point, faces: [f64; 2]) -> Plate {
        let edge = Edge::line(point, point);
        let piece = Piece { edge, length: 0.0, turn: 0.0, reach: point.norm() };
        Plate { faces, pieces: vec![piece], outline: None }
    }

    /// Farthest point from the axis.
    pub fn farthest(&self) -> Point {
        self.outline.as_ref().map_or(Point::ORIGIN, Outline::farthest_point)
    }
}

/// A crankshaft's axis and how it turns.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spindle {
    /// Its axis [m].
    pub axis: Point,
    /// Its speed over that of crankshaft 1.
    pub ratio: Ratio,
    /// Its angle where that of crankshaft 1 is zero [rad].
    pub phase: f64,
}

impl Spindle {
    pub fn of(engine: &Engine, crankshaft: usize) -> Spindle {
        let shaft = &engine.crankshafts[crankshaft];
        Spindle { axis: Point::new(shaft.x, shaft.y), ratio: shaft.ratio, phase: shaft.phase }
    }

    /// Its angle [rad].
    pub fn angle(&self, theta: f64) -> f64 {
        self.ratio.value() * theta + self.phase
    }
}

/// A counterweight with its web, or a web alone.
#[derive(Debug, Clone)]
pub(super) struct TurningBody {
    /// Its name: that of the counterweight, or "web 3".
    pub name: String,
    /// Index of its crankshaft.
    pub crankshaft: usize,
    /// Index of the throw whose web it is or sits on.
    pub throw: Option<usize>,
    /// What it is made of.
    pub plates: Vec<Plate>,
    /// Whether it has chamfers.
    pub has_chamfers: bool,
}

impl TurningBody {
    /// Swept radius [m], and the plate and point that have it.
    pub fn farthest(&self) -> (f64, &Plate, Point) {
        let all = self.plates.iter().map(|plate| (plate.farthest().norm(), plate, plate.farthest()));
        all.reduce(|best, next| if next.0 > best.0 { next } else { best }).expect("invariant: it has a plate")
    }

    /// First and last plane [m].
    pub fn faces(&self) -> [f64; 2] {
        self.plates.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], plate| {
            [from.min(plate.faces[0]), to.max(plate.faces[1])]
        })
    }

    /// All of an engine: its counterweights with a shape in their order, then the webs that carry none.
    pub fn all(engine: &Engine) -> Result<Vec<TurningBody>, ClearanceError> {
        let mut bodies = Vec::new();
        let mut is_taken = vec![false; 2 * engine.throws.len()];
        for weight in &engine.counterweights {
            let Some(part) = &weight.part else { continue };
            let [front, rear] = part.part.faces();
            let faces = [part.z + front, part.z + rear];
            let mut plates = vec![Plate::new(part.part.outline(), part.angle, faces)];
            // The web itself goes with the first counterweight that it carries.
            let web = part.web.filter(|web| *web < is_taken.len());
            if let Some(web) = web
                && !is_taken[web]
            {
                is_taken[web] = true;
                if part.form != CounterweightForm::Web {
                    plates.extend(plain_web(engine, web)?);
                }
            }
            bodies.push(TurningBody {
                name: weight.name.clone(),
                crankshaft: weight.crankshaft,
                throw: web.map(|web| web / 2),
                plates,
                has_chamfers: !part.part.chamfers().is_empty(),
            });
        }
        for web in (0..is_taken.len()).filter(|web| !is_taken[*web]) {
            if let Some(plate) = plain_web(engine, web)? {
                bodies.push(TurningBody {
                    name: format!("web {}", web + 1),
                    crankshaft: engine.throws[web / 2].crankshaft,
                    throw: Some(web / 2),
                    plates: vec![plate],
                    has_chamfers: false,
                });
            }
        }
        Ok(bodies)
    }
}

/// The plain web `web`, counted through all throws, where the engine says what its webs are like and where.
fn plain_web(engine: &Engine, web: usize) -> Result<Option<Plate>, ClearanceError> {
    let plain = engine.plain_web(web).map_err(|source| ClearanceError::Web { web: web + 1, source })?;
    Ok(plain.map(|web| Plate::new(&web.outline, 0.0, web.faces)))
}
