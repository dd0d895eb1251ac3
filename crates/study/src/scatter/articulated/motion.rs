//! Motion of an articulated rod's piston, for numbers, intervals, and either with derivatives.
//!
//! ```text
//! frame of the master's cylinder: u along its axis, v = i u; phi = angle of the crank from u
//! master:   C + i S = r e^{i phi}      q = S - e_m      W = sqrt(l_m^2 - q^2)
//! knuckle:  K = C + i S + (g / l_m) e^{i psi} (W - i q)
//! rod:      P + i (Q + e) = K e^{i tau}                 U = sqrt(l^2 - Q^2)      s = P + U
//! ```
//! | symbol        | name                                                              | unit |
//! |---------------|-------------------------------------------------------------------|------|
//! | r             | crank radius                                                      | m    |
//! | l_m, e_m      | length and net offset of the master                               | m    |
//! | g, psi        | knuckle radius, knuckle angle from the master rod                 | m, rad |
//! | tau           | axis of the master's cylinder, from that of the rod's own         | rad  |
//! | l, e          | length and net offset of the articulated rod                      | m    |
//! | s             | piston pin from the crank's axis along its own cylinder           | m    |
//!
//! Derivatives are by phi (book, eq. 7.1 to 7.4).

use lanchester_numerics::Field;

/// Number of lengths and angles that the motion depends on and that may be off.
pub(crate) const VARIED: usize = 6;

/// Where a knuckle pin sits in the master rod: it is part of it, whatever the rod's length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct KnucklePin {
    /// Distance from the crankpin [m].
    pub radius: f64,
    /// Direction from the master rod [rad].
    pub angle: f64,
}

/// Lengths and angle of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dimensions<T> {
    pub radius: T,
    pub master_length: T,
    pub master_offset: T,
    /// `tau`.
    pub turn: T,
    pub length: T,
    pub offset: T,
}

impl<T: Copy> Dimensions<T> {
    /// From all of them in the order of the fields.
    pub fn from_array(all: [T; VARIED]) -> Dimensions<T> {
        let [radius, master_length, master_offset, turn, length, offset] = all;
        Dimensions { radius, master_length, master_offset, turn, length, offset }
    }
}

/// The big end of the rod from the line of its piston pin.
struct BigEnd<T> {
    /// Second derivative of its way along the cylinder.
    along: T,
    /// Its distance `Q` beside the line, and two derivatives.
    beside: [T; 3],
}

impl<T: Field> Dimensions<T> {
    /// The big end at `phi`.
    fn big_end(&self, pin: &KnucklePin, phi: T) -> BigEnd<T> {
        let r = self.radius;
        let [sin, cos] = phi.sin_cos();
        let (s, c) = (r * sin, r * cos);
        let q = s - self.master_offset;
        let w = (self.master_length.square() - q.square()).root();
        let swing = c * w.inverse();
        let w1 = -(q * swing);
        let w2 = -(c * swing) - q * (q * swing.square() - s) * w.inverse();
        let [sin, cos] = (phi + self.turn).sin_cos();
        let arm = self.master_length.inverse().times(pin.radius);
        let [arm_sin, arm_cos] = (self.turn + T::of(pin.angle)).sin_cos();
        let (gs, gc) = (arm * arm_sin, arm * arm_cos);
        BigEnd {
            along: gc * w2 - gs * s - r * cos,
            beside: [
                r * sin + gs * w - gc * q - self.offset,
                r * cos + gs * w1 - gc * c,
                gs * w2 + gc * s - r * sin,
            ],
        }
    }

    /// `U^2` at `phi` [m^2]: above 0 where the rod reaches from its knuckle pin to its piston pin.
    pub fn reach_square(&self, pin: &KnucklePin, phi: T) -> T {
        self.length.square() - self.big_end(pin, phi).beside[0].square()
    }

    /// `-s''` at `phi` [m]: force of the piston along its cylinder by mass and square of the crank's speed.
    pub fn force(&self, pin: &KnucklePin, phi: T) -> T {
        let BigEnd { along, beside: [q, q1, q2] } = self.big_end(pin, phi);
        let inverse = (self.length.square() - q.square()).root().inverse();
        let swing = q1 * inverse;
        q1 * swing + q * (q2 + q * swing.square()) * inverse - along
    }
}
