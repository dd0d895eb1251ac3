//! Centrifugal pendulum absorbers.
//!
//! N masses m, each on a length l about a pivot at the radius R of a station. With phi the angle of the station, psi that of the pendulum about its pivot,
//!
//! ```text
//! 2 T = N m ((R + l) phi' + l psi')^2,    2 V = N m R l W^2 psi^2                                                                (50.11)
//! ```
//! for small swings at the mean speed W. With the angle `chi = psi + phi (R + l)/l` this is an inertia N m l^2 at the ratio (R + l)/l, on a spring
//! N m R l W^2: a branch like any other, its stiffness growing with the square of the speed. Its order is sqrt(R/l): a torque of that order meets an
//! infinite inertia. Large swings lower the order on circular paths: beyond the linear theory.

use crate::chain::{Chain, Shaft, ShaftKind, Station, StationKind};
use crate::error::TorsionError;

/// Equal pendulums on one station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pendulum {
    /// Index of the station that carries them.
    pub station: usize,
    /// Mass of one [kg].
    pub mass: f64,
    /// Distance of the pivot from the axis [m].
    pub pivot_radius: f64,
    /// Distance of the centre of mass from the pivot [m]: of a bifilar one the difference of the diameters of hole and roller.
    pub length: f64,
    /// How many.
    pub number: usize,
    /// Viscous damping of the swing of one against its carrier [N m s/rad].
    pub damping: f64,
}

impl Pendulum {
    /// Order to which they are tuned.
    pub fn order(&self) -> f64 {
        (self.pivot_radius / self.length).sqrt()
    }

    /// Swing over the angle of the carrier, and inertia that it feels [kg m^2], at an order, without damping.
    ///
    /// ```text
    /// psi/phi = n^2 (R + l)/(R - n^2 l),    J(n) = N m (R + l)^2 / (1 - n^2 l/R)                                               (50.12)
    /// ```
    pub fn response(&self, order: f64) -> [f64; 2] {
        let (r, l, square) = (self.pivot_radius, self.length, order * order);
        let mass = self.mass * self.number as f64;
        [square * (r + l) / (r - square * l), mass * (r + l).powi(2) / (1.0 - square * l / r)]
    }

    /// The chain with them.
    ///
    /// # Errors
    /// As [`Chain::new`]; a length or radius that is not above 0.
    pub fn on(&self, chain: &Chain) -> Result<Chain, TorsionError> {
        for (quantity, value) in [
            ("mass of a pendulum [kg]", self.mass),
            ("pivot radius of a pendulum [m]", self.pivot_radius),
            ("length of a pendulum [m]", self.length),
            ("number of pendulums", self.number as f64),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(TorsionError::Number { quantity, needed: "more than 0", got: value });
            }
        }
        if self.station >= chain.stations().len() {
            let needed = format!("from 0 to {}", chain.stations().len() - 1);
            return Err(TorsionError::Count { what: "station of a pendulum", needed, got: self.station });
        }
        let (r, l) = (self.pivot_radius, self.length);
        let many = self.number as f64;
        chain.with(|stations, shafts| {
            let carrier = &stations[self.station];
            let (ratio, own) = (carrier.ratio, carrier.ratio * (r + l) / l);
            let name = format!("pendulum of {}", carrier.name);
            let last = stations.len();
            stations.push(Station {
                name: name.clone(),
                kind: StationKind::Pendulum,
                inertia: many * self.mass * l * l,
                damping: 0.0,
                ratio: own,
            });
            shafts.push(Shaft {
                kind: ShaftKind::Pendulum,
                spin_stiffness: many * self.mass * r * l * ratio * ratio,
                damping: many * self.damping,
                ratio: own,
                ..Shaft::new(name, last, self.station, 0.0)
            });
        })
    }
}
