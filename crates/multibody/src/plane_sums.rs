//! Sums over pistons, rods and rotors, which move in planes across the crank axis: what the equations of motion need of them, each taken once.
//!
//! ```text
//! points at c = (x, y, z) with rates c', c'' by theta (z' = 0):
//! S = SUM m c    I = SUM m (|c|^2 E - c c^T)    G = SUM m c c'^T
//! SUM m a_0       = M (Omega x v) + Omega x (Omega x S + 2 w S') + w^2 S''
//! SUM m c x a_0   = S x (Omega x v) + Omega x (I Omega) + 2 w (Omega tr G - G^T Omega) + w^2 SUM m c x c''
//! SUM m c'.a_0    = S'.(Omega x v) + Omega.G Omega - |Omega|^2 tr G + w^2 SUM m c'.c''
//!
//! rods along u in the plane, n = z x u, inertia J across and A along, D = J - A, spin Omega + sigma' w z:
//! tensor          J E - D u u^T                                    (its part Omega x (I Omega) is in that of all)
//! moment besides  sigma' w ( J Omega x z - D ( n (u.Omega) + u (n.Omega) ) ) + sigma'' w^2 J z
//! torque          sigma' ( Omega x (tensor Omega) )_z + sigma' sigma'' w^2 J
//!
//! rotors about an axis A at the ratio r, by first moment S, product P and polar inertia J alone (mass and transverse inertia are the block's):
//! what is linear in the places of their masses is that of points at A + e(theta), of which the squares of e, and of A, are left out;
//! the moments of a rotor that differ across its axis are those of points about it whose squares of x and y cancel in sum;
//! J is a rod's that is the same in all directions of the plane and turns at r: sigma' = r, and its share across the axis is taken back
//! ```

use crate::place::{Place, cross, dot};
use crate::train::{Rotor, Train};
use nalgebra::{Matrix3, Vector3};
use num_complex::Complex64;

/// The sums.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PlaneSums {
    pub mass: f64,
    /// `SUM m c` across the axis with its derivatives, and `SUM m z`.
    first: [Complex64; 3],
    first_z: f64,
    /// `SUM m z c` with its derivatives, and `SUM m z^2`.
    product: [Complex64; 3],
    second_z: f64,
    /// `SUM m x^2`, `SUM m y^2`, `SUM m x y`.
    second: [f64; 3],
    /// `SUM m x x'`, `SUM m x y'`, `SUM m y x'`, `SUM m y y'`.
    rates: [f64; 4],
    /// `SUM m |c'|^2`, `SUM m c'.c''`, z component of `SUM m c x c''`.
    speed: f64,
    bend: f64,
    sweep: f64,
    /// `SUM J`, `SUM D u_x^2`, `SUM D u_y^2`, `SUM D u_x u_y`.
    rod: [f64; 4],
    /// `SUM sigma' J`, `SUM sigma'' J`, `SUM sigma'^2 J`, `SUM sigma' sigma'' J`.
    swing: [f64; 4],
    /// `SUM sigma' D u_x u_y`, `SUM sigma' D (u_x^2 - u_y^2)`.
    tilt: [f64; 2],
}

impl PlaneSums {
    /// Of all pistons and rods of `train`.
    pub fn new(train: &Train, places: &[Place]) -> PlaneSums {
        let mut sums = PlaneSums::default();
        for (place, cylinder) in places.iter().zip(&train.cylinders) {
            let shaft = train.rotors[cylinder.rotor].axis;
            let piston = [
                shaft + cylinder.axis * Complex64::new(place.travel[0], cylinder.offset),
                place.travel[1] * cylinder.axis,
                place.travel[2] * cylinder.axis,
            ];
            sums.add_point(cylinder.piston_mass, piston, cylinder.z);
            let rod = &cylinder.rod;
            let [at, rate, bend] = place.on_rod(rod.centre);
            sums.add_point(rod.mass, [shaft + at, rate, bend], cylinder.z);
            let square = (rod.inertia - rod.axial_inertia) / (rod.length * rod.length);
            let d = place.rod[0];
            let [xx, yy, xy] = [square * d.re * d.re, square * d.im * d.im, square * d.re * d.im];
            let [one, two] = place.swing;
            let swung = rod.inertia * one;
            sums.rod[0] += rod.inertia;
            sums.rod[1] += xx;
            sums.rod[2] += yy;
            sums.rod[3] += xy;
            sums.swing[0] += swung;
            sums.swing[1] += rod.inertia * two;
            sums.swing[2] += swung * one;
            sums.swing[3] += swung * two;
            sums.tilt[0] += one * xy;
            sums.tilt[1] += one * (xx - yy);
        }
        sums
    }

    /// Adds a rotor whose crankshaft 1 stands at `theta`; `turn`: `e^{i theta}`, for rotors at its speed.
    pub fn add_rotor(&mut self, rotor: &Rotor, theta: f64, turn: Complex64) {
        let ratio = rotor.ratio;
        let turn = if ratio == 1.0 { turn } else { Complex64::cis(ratio * theta) };
        let [s, p] = [rotor.first_moment * turn, rotor.product * turn];
        let rates = [Complex64::ONE, Complex64::new(0.0, ratio), Complex64::new(-ratio * ratio, 0.0)];
        for (k, rate) in rates.into_iter().enumerate() {
            self.first[k] += s * rate;
            self.product[k] += p * rate;
        }
        let (a, s1) = (rotor.axis, s * rates[1]);
        self.second[0] += 2.0 * a.re * s.re;
        self.second[1] += 2.0 * a.im * s.im;
        self.second[2] += a.re * s.im + a.im * s.re;
        self.rates[0] += a.re * s1.re;
        self.rates[1] += a.re * s1.im;
        self.rates[2] += a.im * s1.re;
        self.rates[3] += a.im * s1.im;
        self.sweep += cross(a, s * rates[2]);
        if rotor.unequal != Complex64::ZERO {
            // Points about the axis whose sum of x^2 + y^2 is in the polar inertia.
            let half = 0.5 * rotor.unequal * turn * turn;
            self.second[0] += half.re;
            self.second[1] -= half.re;
            self.second[2] += half.im;
            self.rates[0] -= ratio * half.im;
            self.rates[1] += ratio * half.re;
            self.rates[2] += ratio * half.re;
            self.rates[3] += ratio * half.im;
        }
        for own in &mut self.rod[..3] {
            *own += rotor.inertia;
        }
        self.swing[0] += ratio * rotor.inertia;
        self.swing[2] += ratio * ratio * rotor.inertia;
    }

    fn add_point(&mut self, mass: f64, [c, c1, c2]: [Complex64; 3], z: f64) {
        self.mass += mass;
        let moments = [mass * c, mass * c1, mass * c2];
        for k in 0..3 {
            self.first[k] += moments[k];
            self.product[k] += z * moments[k];
        }
        self.first_z += mass * z;
        self.second_z += mass * z * z;
        let m = moments[0];
        self.second[0] += m.re * c.re;
        self.second[1] += m.im * c.im;
        self.second[2] += m.re * c.im;
        self.rates[0] += m.re * c1.re;
        self.rates[1] += m.re * c1.im;
        self.rates[2] += m.im * c1.re;
        self.rates[3] += m.im * c1.im;
        self.speed += dot(moments[1], c1);
        self.bend += dot(moments[1], c2);
        self.sweep += cross(m, c2);
    }

    /// `SUM m c`.
    pub fn first_moment(&self) -> Vector3<f64> {
        Vector3::new(self.first[0].re, self.first[0].im, self.first_z)
    }

    /// Inertia tensor about the origin, rods with their own.
    pub fn inertia(&self) -> Matrix3<f64> {
        let [xx, yy, xy] = self.second;
        let [own, along_x, along_y, along_xy] = self.rod;
        let mixed = -xy - along_xy;
        let (xz, yz) = (-self.product[0].re, -self.product[0].im);
        Matrix3::new(
            yy + self.second_z + own - along_x,
            mixed,
            xz,
            mixed,
            xx + self.second_z + own - along_y,
            yz,
            xz,
            yz,
            xx + yy + own,
        )
    }

    /// `SUM m c'` and the angular momentum about the origin at unit speed of the crank.
    pub fn columns(&self) -> [Vector3<f64>; 2] {
        let [first, product] = [self.first[1], self.product[1]];
        let about_z = self.rates[1] - self.rates[2] + self.swing[0];
        [Vector3::new(first.re, first.im, 0.0), Vector3::new(-product.im, product.re, about_z)]
    }

    /// Inertia seen at the crank.
    pub fn crank(&self) -> f64 {
        self.speed + self.swing[2]
    }

    /// Half the derivative of that by theta.
    pub fn crank_bias(&self) -> f64 {
        self.bend + self.swing[3]
    }

    /// Bias: force, moment about the origin, torque on the crank. `turning = Omega x v`; `mass`, `first` and `inertia` are of everything that
    /// moves, the block included.
    pub fn bias(
        &self,
        (mass, first, inertia): (f64, &Vector3<f64>, &Matrix3<f64>),
        omega: &Vector3<f64>,
        w: f64,
        turning: &Vector3<f64>,
    ) -> (Vector3<f64>, Vector3<f64>, f64) {
        let [drift, _] = self.columns();
        let bent = Vector3::new(self.first[2].re, self.first[2].im, 0.0);
        let force = mass * turning + omega.cross(&(omega.cross(first) + 2.0 * w * drift)) + w * w * bent;
        let [xx, xy, yx, yy] = self.rates;
        let product = self.product[1];
        // G^T Omega: its rows are those of the rates.
        let turned = Vector3::new(
            xx * omega.x + yx * omega.y + product.re * omega.z,
            xy * omega.x + yy * omega.y + product.im * omega.z,
            0.0,
        );
        let trace = xx + yy;
        let swept = Vector3::new(-self.product[2].im, self.product[2].re, self.sweep + self.swing[1]);
        let [tilt, stretch] = self.tilt;
        // n u^T + u n^T of every rod, with n = (-u_y, u_x).
        let rocked = Vector3::new(
            -2.0 * tilt * omega.x + stretch * omega.y,
            stretch * omega.x + 2.0 * tilt * omega.y,
            0.0,
        );
        let moment = first.cross(turning)
            + omega.cross(&(inertia * omega))
            + 2.0 * w * (trace * omega - turned)
            + w * w * swept
            + w * (self.swing[0] * Vector3::new(omega.y, -omega.x, 0.0) - rocked);
        let across = omega.x * omega.x - omega.y * omega.y;
        let torque = drift.dot(turning) + omega.dot(&turned) - omega.norm_squared() * trace
            + w * w * self.crank_bias()
            - (tilt * across - stretch * omega.x * omega.y);
        (force, moment, torque)
    }
}
