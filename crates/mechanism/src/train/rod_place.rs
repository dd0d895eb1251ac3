//! Where the rod and the piston of a cylinder stand, as geometry: pins, direction, travel, and how fast they go.

use crate::inertia::request::LoadError;
use crate::train::drive::{Drive, Linkage};
use crate::train::linkage::Stroke;
use crate::train::mechanism::{linkage, master_of};
use lanchester_model::Engine;
use num_complex::Complex64;

/// Rod and piston of one cylinder at one angle of crankshaft 1, exact; rates per radian of that angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RodPlace {
    /// Lower pin of the rod (crankpin, or knuckle pin of an articulated rod) as x + i y from the axis of the cylinder's
    /// crankshaft [m], and its rate [m/rad].
    pub lower_pin: [Complex64; 2],
    /// Direction from the lower pin to the piston pin, from +x towards +y [rad], and its rate.
    pub direction: [f64; 2],
    /// Travel `s` of the piston pin along the cylinder axis [m], and its rate [m/rad].
    pub travel: [f64; 2],
}

/// Upper bounds over all angles of what [`RodPlace`] holds, per radian of crankshaft 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RodReach {
    /// Distance of the lower pin from the crankshaft's axis, size of its first two derivatives [m].
    pub lower_pin: [f64; 3],
    /// Size of the first two derivatives of the direction.
    pub direction: [f64; 2],
    /// Size of the first two derivatives of the travel [m].
    pub travel: [f64; 2],
}

/// The linkage of one cylinder, checked: it turns.
#[derive(Debug, Clone, PartialEq)]
pub struct RodLinkage {
    drive: Drive,
    linkage: Linkage,
    /// Speed ratio of the crankshaft, signed.
    ratio: f64,
    /// Angle of the crankpin from the (master's) cylinder axis at `theta = 0` [rad].
    phase: f64,
    /// Axis of the (master's) cylinder [rad].
    axis: f64,
    /// Axis of the cylinder [rad].
    own_axis: f64,
}

impl RodLinkage {
    /// That of the cylinder with this index.
    ///
    /// # Errors
    /// [`LoadError`] where the linkage does not turn.
    pub fn new(engine: &Engine, cylinder: usize) -> Result<RodLinkage, LoadError> {
        let linkage = linkage(engine, cylinder)?;
        let own = &engine.cylinders[cylinder];
        let axis = engine.cylinders[master_of(own).unwrap_or(cylinder)].angle;
        Ok(RodLinkage {
            drive: Drive::Exact(linkage),
            linkage,
            ratio: engine.crankshafts[engine.throws[own.throw].crankshaft].ratio.value(),
            phase: engine.pin_angle(own.throw, 0.0) - axis,
            axis,
            own_axis: own.angle,
        })
    }

    /// Where rod and piston stand at the angle `theta` of crankshaft 1 [rad].
    pub fn at(&self, theta: f64) -> RodPlace {
        let phi = self.ratio * theta + self.phase;
        let motion = self.drive.motion(phi);
        let pin = match (&self.linkage, motion.knuckle) {
            (Linkage::Plain(slider), _) => {
                let pin = Complex64::from_polar(slider.radius, phi);
                [pin, pin * Complex64::I]
            }
            (Linkage::Articulated(_), Some(knuckle)) => [knuckle.knuckle[0], knuckle.knuckle[1]],
            (Linkage::Articulated(articulated), None) => {
                let knuckle = articulated.knuckle(Complex64::cis(phi)).knuckle;
                [knuckle[0], knuckle[1]]
            }
        };
        let turn = Complex64::cis(self.axis);
        let Stroke { travel, swing, .. } = motion.stroke;
        RodPlace {
            lower_pin: [pin[0] * turn, pin[1] * turn * self.ratio],
            direction: [self.own_axis - motion.stroke.rod_angle(), -swing[0] * self.ratio],
            travel: [travel[0], travel[1] * self.ratio],
        }
    }

    /// How far and fast they go, at most.
    ///
    /// ```text
    /// k' <= |K'|/W      k'' <= (|K''| + Q k'^2)/W      s' <= |K'| + Q k'      s'' <= |K''| + |K'| k' + Q k''
    /// ```
    /// with the lower pin `K`, the largest `|q|` of the linkage `Q` and `W^2 = l^2 - Q^2`: the derivatives of
    /// the motion, term by term.
    pub fn reach(&self) -> RodReach {
        let (pin, beside, length) = match &self.linkage {
            Linkage::Plain(slider) => {
                let r = slider.radius;
                ([r; 3], r + slider.offset.abs(), slider.length)
            }
            Linkage::Articulated(articulated) => {
                let (r, k) = (articulated.master.radius, articulated.knuckle.norm());
                let along = (Complex64::ONE - articulated.knuckle).norm();
                let master = articulated.master;
                let of_master = slide_reach(r, r, r + master.offset.abs(), master.length);
                let pin = [
                    r + k * master.length,
                    along * r + k * of_master.travel[0],
                    along * r + k * of_master.travel[1],
                ];
                // A little more than the largest that was found, which is exact to rounding.
                let beside = articulated.largest_sine() * (1.0 + 1e-9) * articulated.length;
                (pin, beside.min(articulated.length * (1.0 - 1e-12)), articulated.length)
            }
        };
        let slide = slide_reach(pin[1], pin[2], beside, length);
        let [one, two] = [self.ratio.abs(), self.ratio * self.ratio];
        RodReach {
            lower_pin: [pin[0], one * pin[1], two * pin[2]],
            direction: [one * slide.swing[0], two * slide.swing[1]],
            travel: [one * slide.travel[0], two * slide.travel[1]],
        }
    }
}

/// Bounds of the first two derivatives of a sliding rod's angle and travel.
struct SlideReach {
    swing: [f64; 2],
    travel: [f64; 2],
}

/// From bounds of the lower pin's first two derivatives and of its largest distance beside the line of the piston pin.
fn slide_reach(first: f64, second: f64, beside: f64, length: f64) -> SlideReach {
    let inverse = ((length - beside) * (length + beside)).sqrt().recip();
    let k = first * inverse;
    let k1 = (second + beside * k * k) * inverse;
    SlideReach { swing: [k, k1], travel: [first + beside * k, second + first * k + beside * k1] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Plain, offset and articulated rods of the gallery.
    fn linkages() -> Vec<(String, RodLinkage, Engine)> {
        let names = ["in-line-4", "v2-90", "radial-9", "vr6-15", "square-4"];
        let all = lanchester_file::templates();
        let engines = all.iter().filter(|t| names.contains(&t.name)).map(|template| {
            (
                template.name,
                lanchester_file::read(template.text).engine().expect("the gallery has no mistakes"),
            )
        });
        let of_engine = |(name, engine): (&str, Engine)| {
            (0..engine.cylinders.len())
                .map(|c| (format!("{name} {c}"), RodLinkage::new(&engine, c).unwrap(), engine.clone()))
                .collect::<Vec<_>>()
        };
        engines.flat_map(of_engine).collect()
    }

    #[test]
    fn the_rod_joins_its_pins_and_nothing_leaves_its_bounds() {
        let all = linkages();
        assert!(all.len() >= 12, "{}", all.len());
        for (index, (name, linkage, engine)) in all.iter().enumerate() {
            let number = name.rsplit(' ').next().unwrap().parse::<usize>().unwrap();
            let cylinder = &engine.cylinders[number];
            let reach = linkage.reach();
            let step = 1e-3;
            for at in 0..97 {
                let theta = 0.01 + 0.0651 * f64::from(at);
                let [before, here, after] = [-step, 0.0, step].map(|by| linkage.at(theta + by));
                // Lower pin, rod length and direction lead to the piston pin on its line; lengths are near 0.1 m.
                let pin = here.lower_pin[0] + Complex64::from_polar(cylinder.rod.length, here.direction[0]);
                let along = Complex64::cis(cylinder.angle);
                let wanted = along * Complex64::new(here.travel[0], cylinder.net_offset());
                assert!((pin - wanted).norm() < 1e-12, "{name} {index}: {pin} {wanted}");
                let pin_rate = (after.lower_pin[0] - before.lower_pin[0]) / (2.0 * step);
                assert!((pin_rate - here.lower_pin[1]).norm() < 1e-6, "{name}: rate of the pin");
                let first = |f: fn(&RodPlace) -> f64| (f(&after) - f(&before)) / (2.0 * step);
                assert!((first(|p| p.direction[0]) - here.direction[1]).abs() < 1e-5, "{name}: direction");
                assert!((first(|p| p.travel[0]) - here.travel[1]).abs() < 1e-6, "{name}: travel");
                assert!(here.lower_pin[0].norm() <= reach.lower_pin[0] * (1.0 + 1e-12), "{name}");
                assert!(here.lower_pin[1].norm() <= reach.lower_pin[1] * (1.0 + 1e-12), "{name}");
                assert!(here.direction[1].abs() <= reach.direction[0] * (1.0 + 1e-12), "{name}");
                assert!(here.travel[1].abs() <= reach.travel[0] * (1.0 + 1e-12), "{name}");
                let second = |f: fn(&RodPlace) -> f64| (f(&after) - f(&before)) / (2.0 * step);
                assert!(second(|p| p.direction[1]).abs() <= reach.direction[1] * (1.0 + 1e-6), "{name}");
                assert!(second(|p| p.travel[1]).abs() <= reach.travel[1] * (1.0 + 1e-6), "{name}");
                let pin = (after.lower_pin[1] - before.lower_pin[1]).norm() / (2.0 * step);
                assert!(pin <= reach.lower_pin[2] * (1.0 + 1e-6), "{name}");
            }
        }
    }
}
