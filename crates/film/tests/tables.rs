//! Tables of impedance against the films that they stand for.

use lanchester_film::{
    Cavitation, FilmGrid, FilmProblem, FilmSolver, FilmTable, JournalBearing, JournalMotion,
};

use std::f64::consts::PI;

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

#[test]
fn inverted_table_of_a_short_bearing_is_the_mobility_of_booker() {
    // Booker's closed form for Ocvirk's half film, by e/c along the load and across it:
    // M = [(1 - x)^(5/2)/pi, -4 y (1 - x)^(3/2)/pi^2]/(L/D)^2,  e' = |F| (c/R)^2 c/(mu L D) M.
    let slenderness: f64 = 0.05;
    let table = FilmTable::new(slenderness, Cavitation::Gumbel).expect("a table");
    let booker = |[x, y]: [f64; 2]| {
        let along = (1.0 - x).powf(2.5) / PI;
        let across = -4.0 * y * (1.0 - x).powf(1.5) / (PI * PI);
        [along, across].map(|m| m / slenderness.powi(2))
    };
    // The film acts against a load along x. Its |F| = 12 mu (R/c)^3 L at |f| = 1, so that e' = 6 M.
    let ours = |at: [f64; 2]| {
        let v = table.velocity(at, [-1.0, 0.0]).expect("inside");
        v.map(|v| v / 6.0)
    };
    let mut worst: f64 = 0.0;
    for (radius, turn) in [0.0, 0.2, 0.5, 0.8, 0.9, 0.95]
        .into_iter()
        .flat_map(|radius: f64| [0.0f64, 45.0, 90.0, 135.0, 180.0].map(|turn| (radius, turn.to_radians())))
    {
        let at = [radius * turn.cos(), radius * turn.sin()];
        let (found, known) = (ours(at), booker(at));
        let error = size([found[0] - known[0], found[1] - known[1]]) / size(known);
        worst = worst.max(error);
    }
    // The closed form is itself a fit, exact in the middle.
    assert!(worst < 0.1, "{worst}");
    let centre = ours([0.0, 0.0]);
    assert!((centre[0] * PI * slenderness.powi(2) - 1.0).abs() < 0.02, "{centre:?}");
}
