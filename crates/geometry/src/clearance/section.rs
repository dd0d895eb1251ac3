//! Distance from an edge of a plate, parallel to the crank axis, to a piston, liner or rod.
//!
//! A plate between two planes is made of segments along z, one above each point `y` of its outline. The distance of the
//! whole plate from a body is the least distance of such a segment, so that it is a function `f(y)` of the plane, which has
//! a closed form for every body here. In a frame that moves with the body:
//!
//! ```text
//! piston   f = hypot( max(-x, 0), d(y) )      x along the cylinder axis from the lower edge, y beside the axis
//! liner    likewise                           d: distance of the segment {y} x [z1, z2] from disc or ring    (22.61)
//! rod      f = hypot( gap along z, distance in the plane from disc or rectangle )                            (22.62)
//! ```
//! Every `f` grows by no more than the way gone in the plane. All are convex, but that of the liner seen from inside the
//! tube, which bends down by no more than `1/zeta_far` (a ring of chords).

use lanchester_shape::Point;

/// Distance at a point of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Level {
    /// Distance [m], zero within.
    pub distance: f64,
    /// Its gradient, or a subgradient where it has a kink.
    pub gradient: Point,
}

/// A body as seen from a plate: everything about its extent along z, and its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Section {
    /// A piston: disc of `radius` cut off at `cut` before and behind its axis.
    Piston {
        /// Faces of the plate from the cylinder axis along z [m].
        slab: [f64; 2],
        /// Half the bore [m].
        radius: f64,
        /// Half the width along z, at most the radius [m].
        cut: f64,
    },
    /// A liner: ring between two radii.
    Liner {
        /// Faces of the plate from the cylinder axis along z [m].
        slab: [f64; 2],
        /// Half the bore [m].
        inner: f64,
        /// Half the bore and the wall [m].
        outer: f64,
    },
    /// A disc about the origin of its frame.
    Disc {
        /// Faces of plate and disc along z [m].
        faces: [[f64; 2]; 2],
        /// Radius [m].
        radius: f64,
    },
    /// A bar from the origin of its frame along x.
    Bar {
        /// Faces of plate and bar along z [m].
        faces: [[f64; 2]; 2],
        /// Length [m].
        length: f64,
        /// Half the width in the plane [m].
        half_width: f64,
    },
}

/// Of an interval, what is nearest to zero.
fn near([from, to]: [f64; 2]) -> f64 {
    0.0f64.clamp(from, to)
}

/// Of an interval, what is farthest from zero.
fn far([from, to]: [f64; 2]) -> f64 {
    if from.abs() > to.abs() { from } else { to }
}

/// Gap between two intervals, negative by what they overlap at most.
fn gap([first, second]: [[f64; 2]; 2]) -> f64 {
    (second[0] - first[1]).max(first[0] - second[1])
}

/// Half the chord of a circle at a distance from its middle.
fn half_chord(radius: f64, at: f64) -> f64 {
    ((radius - at) * (radius + at)).max(0.0).sqrt()
}

/// Distance and derivative by `y` of the point `(y, zeta)` from the disc of a piston, `zeta >= 0`.
fn beside_disc(y: f64, zeta: f64, radius: f64, cut: f64) -> (f64, f64) {
    let distance = y.hypot(zeta);
    if distance <= radius && zeta <= cut {
        return (0.0, 0.0);
    }
    // The round surface answers where the foot on it lies within the cut.
    if zeta * radius <= cut * distance {
        return (distance - radius, y / distance);
    }
    let edge = half_chord(radius, cut);
    if y.abs() <= edge {
        return (zeta - cut, 0.0);
    }
    let (across, along) = (y.abs() - edge, zeta - cut);
    let distance = across.hypot(along);
    (distance, y.signum() * across / distance)
}

/// Distance and derivative by `y` of the segment from a ring.
fn beside_ring(y: f64, slab: [f64; 2], inner: f64, outer: f64) -> (f64, f64) {
    let (least, most) = (y.hypot(near(slab)), y.hypot(far(slab)));
    if least > outer {
        (least - outer, y / least)
    } else if most < inner {
        (inner - most, if most > 0.0 { -y / most } else { 0.0 })
    } else {
        (0.0, 0.0)
    }
}

/// `hypot` of two distances with the gradients of both.
fn joined(first: (f64, Point), second: (f64, Point)) -> Level {
    let distance = first.0.hypot(second.0);
    if distance == 0.0 {
        return Level { distance, gradient: Point::ORIGIN };
    }
    Level { distance, gradient: (first.1 * first.0 + second.1 * second.0) * (1.0 / distance) }
}

impl Section {
    /// Distance at a point of the body's frame.
    pub fn level(&self, at: Point) -> Level {
        let below = ((-at.x).max(0.0), Point::new(if at.x < 0.0 { -1.0 } else { 0.0 }, 0.0));
        match *self {
            Section::Piston { slab, radius, cut } => {
                let (beside, rate) = beside_disc(at.y, near(slab).abs(), radius, cut);
                joined(below, (beside, Point::new(0.0, rate)))
            }
            Section::Liner { slab, inner, outer } => {
                let (beside, rate) = beside_ring(at.y, slab, inner, outer);
                joined(below, (beside, Point::new(0.0, rate)))
            }
            Section::Disc { faces, radius } => {
                let distance = at.norm();
                let plane = match distance > radius {
                    true => (distance - radius, at * (1.0 / distance)),
                    false => (0.0, Point::ORIGIN),
                };
                joined((gap(faces).max(0.0), Point::ORIGIN), plane)
            }
            Section::Bar { faces, length, half_width } => {
                let away = at - Point::new(at.x.clamp(0.0, length), at.y.clamp(-half_width, half_width));
                let distance = away.norm();
                let plane = match distance > 0.0 {
                    true => (distance, away * (1.0 / distance)),
                    false => (0.0, Point::ORIGIN),
                };
                joined((gap(faces).max(0.0), Point::ORIGIN), plane)
            }
        }
    }

    /// Depth of a point within the body in the plane, as the way in the plane that leads out of it at least [m]; negative
    /// or zero outside, and everywhere if plate and body lie apart along z.
    pub fn depth(&self, at: Point) -> f64 {
        match *self {
            Section::Piston { .. } | Section::Liner { .. } => at.x.min(-self.beside(at.y)),
            Section::Disc { faces, radius } if gap(faces) < 0.0 => radius - at.norm(),
            Section::Bar { faces, length, half_width } if gap(faces) < 0.0 => {
                at.x.min(length - at.x).min(half_width - at.y.abs())
            }
            Section::Disc { .. } | Section::Bar { .. } => f64::NEG_INFINITY,
        }
    }

    /// How far a line along the cylinder axis at `y` beside it is from touching piston or liner within the plate [m], negative
    /// where it does; infinite where no line does.
    pub fn beside(&self, y: f64) -> f64 {
        match *self {
            Section::Piston { slab, radius, cut } if near(slab).abs() < cut => {
                y.abs() - half_chord(radius, near(slab))
            }
            Section::Liner { slab, inner, outer } if near(slab).abs() < outer => {
                (half_chord(inner, far(slab)) - y.abs()).max(y.abs() - half_chord(outer, near(slab)))
            }
            _ => f64::INFINITY,
        }
    }

    /// The least that the distance can be anywhere [m]: what lies between plate and body along z.
    pub fn least(&self) -> f64 {
        match *self {
            Section::Piston { slab, cut, .. } => (near(slab).abs() - cut).max(0.0),
            Section::Liner { slab, outer, .. } => (near(slab).abs() - outer).max(0.0),
            Section::Disc { faces, .. } | Section::Bar { faces, .. } => gap(faces).max(0.0),
        }
    }

    /// By how much plate and body overlap along z [m]: the least way along z that clears them at all places. `None` for round
    /// bodies, which are cleared along their own axis.
    pub fn overlap_along_crank(&self) -> Option<f64> {
        match *self {
            Section::Piston { .. } | Section::Liner { .. } => None,
            Section::Disc { faces, .. } | Section::Bar { faces, .. } => Some((-gap(faces)).max(0.0)),
        }
    }

    /// Bound of what the distance bends down across the cylinder axis [1/m]; zero where it is convex.
    pub fn bend(&self) -> f64 {
        match *self {
            Section::Liner { slab, inner, .. } if far(slab).abs() < inner => far(slab).abs().recip(),
            _ => 0.0,
        }
    }

    /// Whether the body is bounded in the plane, so that an outline may hold all of it.
    pub fn is_bounded(&self) -> bool {
        matches!(self, Section::Disc { .. } | Section::Bar { .. })
    }

    /// The point of the body next to the segment at `at`, in its frame, and the places along z of both points: first that on
    /// the plate, then that on the body; of round bodies from the cylinder axis.
    pub fn nearest(&self, at: Point) -> (Point, [f64; 2]) {
        match *self {
            Section::Piston { slab, radius, cut } => {
                let zeta = near(slab);
                let distance = at.y.hypot(zeta);
                let edge = half_chord(radius, cut);
                let (y, foot) = if distance <= radius && zeta.abs() <= cut {
                    (at.y, zeta)
                } else if zeta.abs() * radius <= cut * distance {
                    (at.y * radius / distance, zeta * radius / distance)
                } else {
                    (at.y.clamp(-edge, edge), cut.copysign(zeta))
                };
                (Point::new(at.x.max(0.0), y), [zeta, foot])
            }
            Section::Liner { slab, inner, outer } => {
                let (least, most) = (at.y.hypot(near(slab)), at.y.hypot(far(slab)));
                let (zeta, scale) = if least > outer {
                    (near(slab), outer / least)
                } else if most < inner {
                    (far(slab), inner / most)
                } else if least >= inner {
                    (near(slab), 1.0)
                } else {
                    (half_chord(inner, at.y).copysign(far(slab)), 1.0)
                };
                (Point::new(at.x.max(0.0), at.y * scale), [zeta, zeta * scale])
            }
            Section::Disc { faces, radius } => {
                let distance = at.norm();
                let scale = if distance > radius { radius / distance } else { 1.0 };
                (at * scale, facing(faces))
            }
            Section::Bar { faces, length, half_width } => {
                (Point::new(at.x.clamp(0.0, length), at.y.clamp(-half_width, half_width)), facing(faces))
            }
        }
    }
}

/// Places along z of the nearest points of two plates; the middle of what they have in common where they overlap.
fn facing([first, second]: [[f64; 2]; 2]) -> [f64; 2] {
    if second[0] > first[1] {
        [first[1], second[0]]
    } else if first[0] > second[1] {
        [first[0], second[1]]
    } else {
        [0.5 * (first[0].max(second[0]) + first[1].min(second[1])); 2]
    }
}
