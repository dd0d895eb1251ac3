//! Tables of impedance against the films that they stand for.

use lanchester_film::{
    Cavitation, FilmGrid, FilmProblem, FilmSolver, FilmTable, JournalBearing, JournalMotion,
};

fn size(a: [f64; 2]) -> f64 {
    a[0].hypot(a[1])
}

#[test]
fn table_is_the_direct_film_within_half_a_percent_with_its_derivatives() {
    for cavitation in [Cavitation::Gumbel, Cavitation::Reynolds] {
        let slenderness = 0.4;
        let table = FilmTable::new(slenderness, cavitation).expect("a table");
        let bearing = JournalBearing::new(0.03, 0.06 * slenderness, 3e-5).expect("plausible");
        let mut worst: f64 = 0.0;
        for k in 0..60 {
            let ratio = 0.98 * (f64::from(k) + 0.5) / 60.0;
            let (turn, heading) = (2.4 * f64::from(k), 1.7 * f64::from(k));
            let at = [ratio * turn.cos(), ratio * turn.sin()];
            let v = [0.01 * heading.cos(), 0.01 * heading.sin()];
            let problem = FilmProblem {
                bearing,
                viscosity: 0.01,
                motion: JournalMotion {
                    eccentricity: at.map(|e| e * bearing.clearance),
                    velocity: v,
                    ..JournalMotion::default()
                },
                tilt: [0.0, 0.0],
                cavitation,
                feeds: Vec::new(),
            };
            let grid = FilmGrid::graded(120, 12, true, at).expect("a grid");
            let direct = FilmSolver::new(grid).expect("a solver").solve(&problem).expect("a film").force;
            let found = table.impedance(at, v).expect("inside");
            let ours = found.force.map(|f| f * bearing.force_scale(0.01));
            let error = size([ours[0] - direct[0], ours[1] - direct[1]]) / size(direct);
            worst = worst.max(error);
            assert!(error < 5e-3, "{cavitation:?} eps {ratio} heading {}: {error}", heading - turn);
            // Derivatives are those of the table itself.
            for j in 0..2 {
                let h = 1e-6;
                let moved = |amount: f64, of_v: bool| {
                    let (mut a, mut b) = (at, v);
                    if of_v {
                        b[j] += 0.01 * amount
                    } else {
                        a[j] += amount * (1.0 - ratio)
                    }
                    table.impedance(a, b).expect("inside").force
                };
                for i in 0..2 {
                    let by_v = (moved(h, true)[i] - moved(-h, true)[i]) / (0.02 * h);
                    let by_e = (moved(h, false)[i] - moved(-h, false)[i]) / (2.0 * h * (1.0 - ratio));
                    let scale_v = size(found.by_velocity[0]) + size(found.by_velocity[1]);
                    let scale_e = size(found.by_eccentricity[0]) + size(found.by_eccentricity[1]);
                    assert!(
                        (by_v - found.by_velocity[i][j]).abs() < 1e-5 * scale_v,
                        "{by_v} {:?}",
                        found.by_velocity
                    );
                    assert!(
                        (by_e - found.by_eccentricity[i][j]).abs() < 1e-4 * scale_e,
                        "{ratio}: {by_e} {:?}",
                        found.by_eccentricity
                    );
                }
            }
            // The mobility is its inverse.
            let back = table.velocity(at, found.force).expect("inside");
            let again = table.impedance(at, back).expect("inside").force;
            assert!(
                size([again[0] - found.force[0], again[1] - found.force[1]]) < 1e-9 * size(found.force),
                "{v:?} {back:?}"
            );
        }
        assert!(worst > 0.0);
    }
}
