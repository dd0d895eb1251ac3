#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
use lanchester_geometry::*;
pub fn paper() -> DesignTask {
    DesignTask {
        unbalance: 8.0e-3,
        least_balance: 1.0,
        most_balance: None,
        density: 8000.0,
        web_radius: Range::new(0.01, 0.02),
        rectangle_height: Range::new(0.02, 0.03),
        shoulder: Shoulder::Angle(Range::new(0.0, 1.46)),
        arc_radius: Range::new(0.05, 0.07),
        arc_angle: Range::new(0.79, 3.13),
        thickness: Range::new(0.005, 0.03),
        limits: DesignLimits::default(),
    }
}
#[test]
fn look() {
    let mut task = paper();
    for limit in [None, Some(0.07), Some(0.075), Some(0.08)] {
        task.limits.swept_radius = limit;
        for objective in [Objective::Mass, Objective::SweptRadius, Objective::Inertia, Objective::Thickness] {
            let start = std::time::Instant::now();
            let found = design(&task, objective).unwrap();
            let time = start.elapsed();
            match found {
                DesignOutcome::Found(o) => println!(
                    "{limit:?} {objective:?} {time:?} boxes {} proved {} value {} {:?}",
                    o.boxes, o.proved, o.value, o.design
                ),
                other => println!("{limit:?} {objective:?} {time:?} {other:?}"),
            }
        }
    }
}
