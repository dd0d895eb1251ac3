//! A rigid rotor on two elastic bearings, and what instruments of every convention show of it.
//!
//! Four degrees of freedom: centre and slopes in both directions, with gyroscopic coupling, damping and bearings that
//! are not round. Angles here are counted anticlockwise from +x as seen from the end from which the sheet is written.

use num_complex::Complex64;
use std::f64::consts::TAU;
use std::fmt::Write;

/// The rotor.
#[derive(Debug, Clone, Copy)]
pub struct RigidRotor {
    pub mass: f64,
    pub centre: f64,
    /// Inertia across the shaft and about it [kg m^2].
    pub across: f64,
    pub about: f64,
    /// Place of each bearing, its stiffness along x and y [N/m], damping [N s/m].
    pub bearings: [(f64, [f64; 2], f64); 2],
}

pub const ROTOR: RigidRotor = RigidRotor {
    mass: 12.0,
    centre: 0.17,
    across: 0.21,
    about: 0.04,
    bearings: [(0.0, [4.1e6, 2.7e6], 900.0), (0.4, [3.3e6, 5.2e6], 1400.0)],
};

/// Seen from the end: conventions of the sheet.
#[derive(Debug, Clone, Copy)]
pub struct Bench {
    pub marks_anticlockwise: bool,
    pub turns_anticlockwise: bool,
    pub lag: bool,
    pub keyphasor: f64,
    /// 0 displacement, 1 velocity, 2 acceleration.
    pub quantity: u8,
    pub detector: &'static str,
}

impl Bench {
    pub fn marks(&self) -> f64 {
        if self.marks_anticlockwise { 1.0 } else { -1.0 }
    }

    pub fn turns(&self) -> f64 {
        if self.turns_anticlockwise { 1.0 } else { -1.0 }
    }

    /// `[rotor]` and its planes and sensors.
    pub fn head(&self, planes: &[(&str, f64)], sensors: &[(&str, f64, f64)], more: &str) -> String {
        let word = |anticlockwise| if anticlockwise { "anticlockwise" } else { "clockwise" };
        let mut text = format!(
            "name = \"simulated\"\n[rotor]\nmarks = \"{}\"\nrotation = \"{}\"\nphase = \"{}\"\nkeyphasor = \"{} rad\"\n{more}\n",
            word(self.marks_anticlockwise),
            word(self.turns_anticlockwise),
            if self.lag { "lag" } else { "lead" },
            self.keyphasor,
        );
        for (name, z) in planes {
            let _ = write!(text, "[[plane]]\nname = \"{name}\"\nz = \"{z} m\"\nradius = \"60 mm\"\n");
        }
        for (name, angle, _) in sensors {
            let detector = self.detector;
            let _ = write!(
                text,
                "[[sensor]]\nname = \"{name}\"\nangle = \"{angle} rad\"\ndetector = \"{detector}\"\n"
            );
        }
        text
    }

    /// One `[[run]]` with these unbalances on the rotor (z, amount, angle on the rotor).
    pub fn run(
        &self,
        rotor: &RigidRotor,
        name: &str,
        rpm: f64,
        unbalances: &[(f64, f64, f64)],
        sensors: &[(&str, f64, f64)],
        weights: &str,
    ) -> String {
        let mut text = format!(
            "[[run]]\nname = \"{name}\"\nspeed = \"{rpm} rpm\"\nweights = [{weights}]\nreadings = [\n"
        );
        for (name, angle, z) in sensors {
            let (amplitude, phase) = self.reading(rotor, rpm * TAU / 60.0, unbalances, *angle, *z);
            let (key, unit) = [("displacement", "m"), ("velocity", "m/s"), ("acceleration", "m/s2")]
                [usize::from(self.quantity)];
            let _ = writeln!(
                text,
                "{{ sensor = \"{name}\", {key} = \"{amplitude:e} {unit}\", phase = \"{phase} rad\" }},"
            );
        }
        text + "]\n"
    }

    /// What the instrument shows: the times of pulse and peak are found, then their distance is counted.
    pub fn reading(
        &self,
        rotor: &RigidRotor,
        speed: f64,
        unbalances: &[(f64, f64, f64)],
        angle: f64,
        z: f64,
    ) -> (f64, f64) {
        // At t = 0 the rotor's zero points anywhere.
        let start = 0.7;
        let physical: Vec<(f64, f64, f64)> =
            unbalances.iter().map(|(z, u, a)| (*z, *u, start + self.marks() * a)).collect();
        let [x, y] = rotor.displacement(speed, self.turns(), &physical, z);
        let along = self.marks() * angle;
        let mut signal = along.cos() * x + along.sin() * y;
        for _ in 0..self.quantity {
            signal *= Complex64::new(0.0, speed);
        }
        let peak_time = -signal.arg() / speed;
        let pulse_time = self.turns() * (self.marks() * self.keyphasor - start) / speed;
        let lag = (speed * (peak_time - pulse_time)).rem_euclid(TAU);
        let amplitude = match self.detector {
            "peak" => signal.norm(),
            "peak-to-peak" => 2.0 * signal.norm(),
            // Root of the mean square of a sine.
            _ => signal.norm() * 0.5f64.sqrt(),
        };
        (amplitude, if self.lag { lag } else { (TAU - lag).rem_euclid(TAU) })
    }
}

impl RigidRotor {
    /// Displacement along x and y at z for unbalances (z, amount, direction at t = 0), as factors of `exp(i speed t)`.
    pub fn displacement(
        &self,
        speed: f64,
        turns: f64,
        unbalances: &[(f64, f64, f64)],
        z: f64,
    ) -> [Complex64; 2] {
        let i = Complex64::i();
        // Unknowns: x, slope of x, y, slope of y, at the centre of mass.
        let mut matrix = [[Complex64::default(); 4]; 4];
        let mut load = [Complex64::default(); 4];
        for (offset, axis) in [(0, 0), (2, 1)] {
            matrix[offset][offset] -= speed * speed * self.mass;
            matrix[offset + 1][offset + 1] -= speed * speed * self.across;
            for (place, stiffness, damping) in self.bearings {
                let (lever, k) = (place - self.centre, stiffness[axis] + i * speed * damping);
                matrix[offset][offset] += k;
                matrix[offset][offset + 1] += k * lever;
                matrix[offset + 1][offset] += k * lever;
                matrix[offset + 1][offset + 1] += k * lever * lever;
            }
        }
        let gyroscopic = i * speed * turns * speed * self.about;
        matrix[1][3] += gyroscopic;
        matrix[3][1] -= gyroscopic;
        for (place, amount, direction) in unbalances {
            let force = amount * speed * speed * Complex64::from_polar(1.0, turns * direction);
            let (along_x, along_y) = (force, -i * turns * force);
            let lever = place - self.centre;
            load[0] += along_x;
            load[1] += along_x * lever;
            load[2] += along_y;
            load[3] += along_y * lever;
        }
        let u = solve(matrix, load);
        let lever = z - self.centre;
        [u[0] + u[1] * lever, u[2] + u[3] * lever]
    }
}

/// Gaussian elimination with partial pivoting.
fn solve(mut a: [[Complex64; 4]; 4], mut b: [Complex64; 4]) -> [Complex64; 4] {
    for k in 0..4 {
        let pivot = (k..4).max_by(|p, q| a[*p][k].norm().total_cmp(&a[*q][k].norm())).expect("rows are left");
        a.swap(k, pivot);
        b.swap(k, pivot);
        for row in k + 1..4 {
            let factor = a[row][k] / a[k][k];
            for column in k..4 {
                let above = a[k][column];
                a[row][column] -= factor * above;
            }
            let above = b[k];
            b[row] -= factor * above;
        }
    }
    let mut x = [Complex64::default(); 4];
    for k in (0..4).rev() {
        let known: Complex64 = (k + 1..4).map(|column| a[k][column] * x[column]).sum();
        x[k] = (b[k] - known) / a[k][k];
    }
    x
}
