//! The film of a tilted journal: against the film on a grid of cells and the table, and its derivatives.

use lanchester_film::{
    Cavitation, FilmError, FilmGrid, FilmProblem, FilmSolver, FilmTable, JournalBearing, JournalMotion,
    TiltedMotion, contact_force, tilted_contact, tilted_impedance,
};

/// Places and rates of an end that reach from the middle of the bearing to a fiftieth of the clearance.
fn motions() -> Vec<TiltedMotion> {
    let of = |x, t, v, w| TiltedMotion { eccentricity: x, tilt: t, closing: v, closing_by_tilt: w };
    vec![
        of([0.5, 0.0], [0.0, 0.3], [0.0, -0.5], [0.3, 0.0]),
        of([0.2, -0.6], [0.15, -0.2], [0.4, 0.3], [0.1, -0.2]),
        of([0.0, 0.0], [0.4, 0.0], [0.1, 0.0], [0.0, 0.3]),
        of([0.7, 0.1], [0.2, 0.02], [0.3, 0.6], [-0.1, 0.2]),
    ]
}

/// The same on a grid of cells over the whole length; the journal turns, so that it closes by tilt.
fn on_cells(slenderness: f64, x: [f64; 2], t: [f64; 2], rate: [f64; 2], entrainment: f64) -> [f64; 4] {
    let bearing = JournalBearing { radius: 1.0, length: 2.0 * slenderness, clearance: 1e-3 };
    let c = bearing.clearance;
    let problem = FilmProblem {
        bearing,
        viscosity: 1.0,
        motion: JournalMotion {
            eccentricity: x.map(|part| part * c),
            velocity: rate,
            entrainment,
            sliding: 0.0,
        },
        tilt: t.map(|part| part * c),
        cavitation: Cavitation::Gumbel,
        feeds: Vec::new(),
    };
    let grid = FilmGrid::uniform(240, 48, false, 0.0).expect("enough cells");
    let film = FilmSolver::new(grid).and_then(|mut solver| solver.solve(&problem)).expect("there is a film");
    let half = 0.5 * bearing.length;
    // The moment is z x Q L/2.
    let found = [film.force[0], film.force[1], film.moment[1] / half, -film.moment[0] / half];
    found.map(|part| part / bearing.force_scale(1.0))
}

#[test]
fn xcheck_tilted_films_are_those_on_cells() {
    // 240 x 48 cells are 0.1 to 0.4 % off themselves; six polynomials along the axis give the moment to 1.2 % where an end leaves a fiftieth of the clearance.
    for slenderness in [0.25, 0.5, 1.0] {
        for TiltedMotion { eccentricity: x, tilt: t, closing: rate, .. } in motions() {
            let (entrainment, c) = (200.0, 1e-3);
            let turned = |[a, b]: [f64; 2]| [entrainment * c * b, -entrainment * c * a];
            let motion = TiltedMotion {
                eccentricity: x,
                tilt: t,
                closing: [0, 1].map(|k| rate[k] + turned(x)[k]),
                closing_by_tilt: turned(t),
            };
            let ours = tilted_impedance(slenderness, &motion).unwrap().force;
            let cells = on_cells(slenderness, x, t, rate, entrainment);
            let size = |f: [f64; 4], k: usize| f[k].hypot(f[k + 1]);
            let off: [f64; 4] = std::array::from_fn(|k| ours[k] - cells[k]);
            assert!(size(off, 0) < 6e-3 * size(cells, 0), "{slenderness} {motion:?}: {ours:?} {cells:?}");
            let moment = 1.5e-2 * size(cells, 2) + 1e-3 * size(cells, 0);
            assert!(size(off, 2) < moment, "{slenderness} {motion:?}: {ours:?} {cells:?}");
        }
    }
}

#[test]
fn xcheck_a_journal_that_does_not_tilt_has_the_force_of_the_table() {
    // The table's films have 120 x 12 cells, which are up to 0.4 % off.
    let table = FilmTable::new(0.5, Cavitation::Gumbel).unwrap();
    for ratio in [0.0, 0.3, 0.6, 0.9, 0.98] {
        for closing in [[1.0, 0.0], [0.0, 1.0], [0.5, -0.5]] {
            let place = [0.6 * ratio, -0.8 * ratio];
            let wanted = table.impedance(place, closing).unwrap().force;
            let motion = TiltedMotion { eccentricity: place, closing, ..TiltedMotion::default() };
            let [x, y, a, b] = tilted_impedance(0.5, &motion).unwrap().force;
            let size = wanted[0].hypot(wanted[1]);
            // A journal that leaves presses opposite its least film, where the columns are wide.
            let leaves = closing[0] * place[0] + closing[1] * place[1] < 0.0;
            let bar = if leaves { 1.2e-2 } else { 5e-3 };
            assert!((x - wanted[0]).hypot(y - wanted[1]) < bar * size, "{ratio} {closing:?}");
            assert!(a.hypot(b) < 1e-12 * size, "{ratio} {closing:?}");
        }
    }
}

#[test]
fn derivatives_are_those_of_the_force() {
    let changed = |mut motion: TiltedMotion, k: usize, by: f64| {
        let part = match k / 2 {
            0 => &mut motion.eccentricity,
            1 => &mut motion.tilt,
            2 => &mut motion.closing,
            _ => &mut motion.closing_by_tilt,
        };
        part[k % 2] += by;
        motion
    };
    for motion in motions() {
        let film = tilted_impedance(0.5, &motion).unwrap();
        for k in 0..8 {
            let step = 1e-6;
            let at = |by: f64| tilted_impedance(0.5, &changed(motion, k, by)).unwrap().force;
            let (low, high) = (at(-step), at(step));
            let own = |row: usize| {
                if k < 4 { film.by_place[row][k] } else { film.by_velocity[row][k - 4] }
            };
            let largest = (0..4).map(|row| own(row).abs()).fold(0.0, f64::max);
            // The columns follow the journal, which derivatives by its place leave out.
            let bar = if k < 4 { 1e-2 } else { 1e-8 };
            for row in 0..4 {
                let slope = (high[row] - low[row]) / (2.0 * step);
                assert!(
                    (slope - own(row)).abs() < bar * largest,
                    "{motion:?} {k} {row}: {slope} {}",
                    own(row)
                );
            }
        }
    }
}

#[test]
fn contacts_of_tilted_journals_are_means_of_straight_ones() {
    let bearing = JournalBearing::new(0.0275, 0.025, 30e-6).unwrap();
    let (straight, _) = tilted_contact(&bearing, 1e-6, [0.0, 0.97], [0.0, 0.0]);
    let wanted = contact_force(&bearing, 1e-6, 0.97);
    assert!((straight[1] + wanted).abs() < 1e-9 * wanted && straight[3].abs() < 1e-9 * wanted);
    let (x, t) = ([0.3, 0.85], [0.02, 0.07]);
    let (force, slopes) = tilted_contact(&bearing, 1e-6, x, t);
    assert!(force[3] < 0.0, "it is set upright");
    for k in 0..4 {
        let step = 1e-6;
        let at = |by: f64| {
            let (mut x, mut t) = (x, t);
            if k < 2 {
                x[k] += by
            } else {
                t[k - 2] += by
            }
            tilted_contact(&bearing, 1e-6, x, t).0
        };
        let (low, high) = (at(-step), at(step));
        for row in 0..4 {
            let slope = (high[row] - low[row]) / (2.0 * step);
            assert!((slope - slopes[row][k]).abs() < 1e-5 * slopes[1][1].abs(), "{row} {k}");
        }
    }
}

#[test]
fn a_journal_that_reaches_the_shell_at_an_end_has_no_film() {
    let motion = TiltedMotion { eccentricity: [0.6, 0.0], tilt: [-0.4, 0.1], ..TiltedMotion::default() };
    assert!(matches!(tilted_impedance(0.5, &motion), Err(FilmError::Eccentricity { .. })));
}
