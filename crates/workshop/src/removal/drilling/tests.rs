use super::*;
use lanchester_file::workshop::read_sheet;

fn sheet(planes: &str, displays: &str) -> Sheet {
    let text = format!("name = \"x\"\n{planes}\n{displays}");
    let reading = read_sheet(&text);
    reading.sheet.unwrap_or_else(|| panic!("{:?}\n{text}", reading.diagnostics))
}

fn plane(name: &str, z: f64, more: &str, drill: &str) -> String {
    format!(
        "[[plane]]\nname = \"{name}\"\nz = \"{z} mm\"\nradius = \"60 mm\"\n{more}\n\
         drill = {{ direction = \"radial\", diameters = [\"8 mm\", \"12 mm\"], max_depth = \"25 mm\", density = \"7.85 g/cm3\", {drill} }}\n"
    )
}

fn display(z: f64, amount: f64, angle: f64) -> String {
    format!("[[display]]\nz = \"{z} mm\"\nunbalance = \"{amount} g mm\"\nangle = \"{angle} deg\"\n")
}

fn removed(plane: &DrilledPlane) -> Complex64 {
    plane.holes.iter().map(|hole| Complex64::from_polar(hole.unbalance, hole.angle)).sum()
}

#[test]
fn one_hole_where_every_depth_and_angle_is_allowed() {
    let found = drilling(&sheet(&plane("only", 10.0, "", ""), &display(10.0, 500.0, 77.0))).unwrap();
    let plane = &found.planes[0];
    assert_eq!(plane.holes.len(), 1);
    assert!((plane.holes[0].angle.to_degrees() - 77.0).abs() < 1e-9);
    assert!(plane.left.norm() < 1e-15 && plane.complete && found.holds);
}

#[test]
fn two_nearest_holes_where_angles_are_given() {
    let found = drilling(&sheet(
        &plane("only", 10.0, "positions = 12", "land = \"3 mm\""),
        &display(10.0, 500.0, 77.0),
    ))
    .unwrap();
    let plane = &found.planes[0];
    assert_eq!(plane.holes.len(), 2);
    assert!((removed(plane) - plane.wanted).norm() < 1e-15);
    for hole in &plane.holes {
        let twelfth = hole.angle.to_degrees() / 30.0;
        assert!((twelfth - twelfth.round()).abs() < 1e-9);
        assert!(hole.tip <= 0.025 + 1e-12);
    }
}

/// Every pair of steps, tried one by one.
#[test]
fn steps_of_depth_leave_the_least_that_they_can() {
    let text =
        plane("only", 10.0, "angles = [\"60 deg\", \"100 deg\"]", "depth_step = \"1 mm\", most_holes = 2");
    let sheet = sheet(&text, &display(10.0, 700.0, 77.0));
    let found = drilling(&sheet).unwrap();
    let plane = &found.planes[0];
    let drill = sheet.planes[0].drill.as_ref().unwrap();
    let mut least = f64::INFINITY;
    let bits: Vec<_> =
        drill.diameters.iter().map(|d| super::super::hole::Bit::of(drill, 0.06, *d).unwrap()).collect();
    for one in &bits {
        for other in &bits {
            for i in 1..25 {
                for j in 1..25 {
                    let (first, second) = (
                        one.hole(60f64.to_radians(), 1e-3 * f64::from(i)),
                        other.hole(100f64.to_radians(), 1e-3 * f64::from(j)),
                    );
                    if first.tip <= 0.025 && second.tip <= 0.025 {
                        let sum = Complex64::from_polar(first.unbalance, first.angle)
                            + Complex64::from_polar(second.unbalance, second.angle);
                        least = least.min((plane.wanted - sum).norm());
                    }
                }
            }
        }
    }
    assert!((plane.left.norm() - least).abs() < 1e-15, "{} {least}", plane.left.norm());
    assert!(plane.left.norm() > 0.0 && plane.complete);
    for hole in &plane.holes {
        assert!((hole.depth * 1e3 - (hole.depth * 1e3).round()).abs() < 1e-9);
    }
}

#[test]
fn more_than_the_holes_can_take_is_told() {
    let found =
        drilling(&sheet(&plane("only", 10.0, "", "land = \"4 mm\""), &display(10.0, 9000.0, 77.0))).unwrap();
    let plane = &found.planes[0];
    assert!(!found.holds && !plane.kept);
    assert_eq!(plane.holes.len(), 3);
    // Nothing is better than all three at the bottom, as near to the direction as the walls let them.
    assert!(plane.holes.iter().all(|hole| (hole.tip - 0.025).abs() < 1e-12 && hole.diameter == 0.012));
    assert!(plane.left.norm() < plane.wanted.norm());
}

#[test]
fn the_grade_decides_how_many_holes() {
    let rotor = "[rotor]\nmass = \"20 kg\"\nspeed = \"6000 rpm\"\ngrade = \"G 40\"\ncentre = \"200 mm\"\nsupports = [\"0 mm\", \"400 mm\"]\n";
    let planes = |grade: &str| {
        rotor.replace("G 40", grade)
            + &plane("front", 50.0, "positions = 8", "depth_step = \"0.5 mm\"")
            + &plane("rear", 350.0, "positions = 8", "depth_step = \"0.5 mm\"")
    };
    let shown = display(50.0, 900.0, 20.0) + &display(350.0, 700.0, 190.0);
    let coarse = drilling(&sheet(&planes("G 40"), &shown)).unwrap();
    let fine = drilling(&sheet(&planes("G 2.5"), &shown)).unwrap();
    assert!(coarse.holds && fine.holds);
    let count = |found: &Drilling| found.planes.iter().map(|plane| plane.holes.len()).sum::<usize>();
    assert!(count(&coarse) < count(&fine), "{} {}", count(&coarse), count(&fine));
    assert_eq!(fine.correction.grade_now.as_ref().unwrap().kept, Some(false));
    let after = fine.grade_after.as_ref().unwrap();
    assert_eq!(after.kept, Some(true));
    for (graded, drilled) in after.planes.iter().zip(&fine.planes) {
        assert!((graded.measured.unwrap() - drilled.left).norm() < 1e-15);
    }
}

/// Neighbours of 30 degrees stand 31.06 mm apart on a radius of 60 mm.
#[test]
fn holes_keep_their_spacing() {
    let holes = |spacing: &str| {
        let text = plane("only", 10.0, "positions = 12", &format!("spacing = \"{spacing}\", most_holes = 2"));
        let found = drilling(&sheet(&text, &display(10.0, 500.0, 77.0))).unwrap();
        let mut angles: Vec<f64> =
            found.planes[0].holes.iter().map(|hole| hole.angle.to_degrees().round()).collect();
        angles.sort_by(f64::total_cmp);
        (angles, found.planes[0].left.norm())
    };
    let (near, nothing) = holes("31 mm");
    assert_eq!(near, [60.0, 90.0]);
    let (far, left) = holes("31.1 mm");
    assert!(far.windows(2).all(|pair| pair[1] - pair[0] > 30.5), "{far:?}");
    assert!(nothing < 1e-15 && left >= nothing);
}

/// Two 12 mm holes 30 degrees apart keep a wall of 8 mm down to 60 - (8 + 6 + 6 cos 30)/sin 30 = 21.61 mm: what 25 mm would
/// break through is drilled less deep, not given up.
#[test]
fn holes_whose_walls_would_be_thin_are_drilled_less_deep() {
    let text = plane("only", 10.0, "angles = [\"60 deg\", \"90 deg\"]", "land = \"8 mm\", most_holes = 2")
        .replace("[\"8 mm\", \"12 mm\"]", "[\"12 mm\"]");
    let found = drilling(&sheet(&text, &display(10.0, 5000.0, 75.0))).unwrap();
    let plane = &found.planes[0];
    let deepest = 60.0 - (14.0 + 6.0 * 30f64.to_radians().cos()) / 0.5;
    assert_eq!(plane.holes.len(), 2);
    for hole in &plane.holes {
        // Depths are tried in steps of a twenty-fourth of what may be drilled.
        assert!(1e3 * hole.depth <= deepest && 1e3 * hole.depth > deepest - 1.0, "{}", hole.depth);
    }
    let one = plane.holes[0].unbalance;
    assert!((removed(plane).norm() - 2.0 * one * 15f64.to_radians().cos()).abs() < 0.05 * one);
}
