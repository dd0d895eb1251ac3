//! An engine on its mounts under its own loads.

use lanchester_mechanism::{MountError, MountRequest, MountStudy, inertia_excitations, mount_study};
use lanchester_model::Engine;

/// Speeds of [`mounts`].
#[derive(Debug, Clone, PartialEq)]
pub enum MountSpeeds {
    /// So many from the lowest to the highest of the engine, both included; one if these are one.
    Range(usize),
    /// These [rad/s].
    List(Vec<f64>),
}

/// The block of `engine` on its mounts, shaken by its inertia loads of orders 1 to `max_order`.
///
/// # Errors
/// As [`mount_study`], and where a speed is not positive.
pub fn mounts(
    engine: &Engine,
    speeds: &MountSpeeds,
    max_order: u32,
    request: &MountRequest,
) -> Result<MountStudy, MountError> {
    let speeds = match speeds {
        MountSpeeds::List(list) => list.clone(),
        MountSpeeds::Range(count) => {
            let (lowest, highest) = (engine.speed.lowest, engine.speed.highest);
            let steps = if lowest < highest { (*count).max(2) - 1 } else { 0 };
            let at = |k: usize| lowest + (highest - lowest) * k as f64 / steps.max(1) as f64;
            (0..=steps).map(at).collect()
        }
    };
    mount_study(engine, &inertia_excitations(engine, &speeds, max_order)?, request)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example() -> Engine {
        let text = include_str!("../../../examples/in-line-4-mounts.toml");
        lanchester_model::read(text).engine.expect("the example has no mistakes")
    }

    #[test]
    fn the_range_of_the_file_has_both_ends() {
        let engine = example();
        let study = mounts(&engine, &MountSpeeds::Range(7), 4, &MountRequest::default()).expect("it is held");
        let speeds: Vec<f64> = study.response.speeds.iter().map(|s| s.speed).collect();
        assert_eq!(speeds.len(), 7);
        assert_eq!((speeds[0], speeds[6]), (engine.speed.lowest, engine.speed.highest));
        let one = Engine { speed: lanchester_model::SpeedRange { lowest: 300.0, highest: 300.0 }, ..engine };
        let study = mounts(&one, &MountSpeeds::Range(7), 4, &MountRequest::default()).expect("it is held");
        assert_eq!(study.response.speeds.len(), 1);
    }

    #[test]
    fn an_in_line_four_shakes_its_mounts_at_second_order() {
        let request = MountRequest { points: vec![[0.3, 0.0, 0.0]] };
        let study = mounts(&example(), &MountSpeeds::List(vec![400.0]), 4, &request).expect("it is held");
        let at = &study.response.speeds[0];
        let size = |order: f64, mount: usize| {
            let found = at.orders.iter().find(|o| o.order == order).expect("it is listed");
            lanchester_mechanism::vector_amplitude(&found.forces[mount])
        };
        assert!((0..3).all(|mount| size(1.0, mount) < 1e-6 * size(2.0, mount)));
        assert!((0..3).all(|mount| (size(2.0, mount) / at.peaks[mount].value - 1.0).abs() < 0.2));
        assert_eq!(study.points[0].displacement[0].len(), at.orders.len());
        // Far above all natural frequencies mounts isolate.
        let last = study.transmissibility.ratio.last().expect("there are frequencies");
        assert!(last.iter().all(|t| *t < 0.5), "{last:?}");
        assert!((study.transmissibility.ratio[0][0] - 1.0).abs() < 0.2);
    }
}
