//! The block and its mounts in the engine file.

use lanchester_file::{expanded, read, render};
use lanchester_model::{Engine, FRAME_AXES, MovingParts};
use std::f64::consts::TAU;

const SINGLE: &str = r#"
name = "Single"
speed = "3000 rpm"
origin = "20 mm"

[layout]
type = "in-line"
cylinders = 1

[crank]
stroke = "60 mm"

[piston]
mass = "0.3 kg"

[rod]
length = "100 mm"
mass = "0.3 kg"
"#;

#[track_caller]
fn engine(tables: &str) -> Engine {
    let text = format!("{SINGLE}{tables}");
    let reading = read(&text);
    let rendered = render(&reading.diagnostics, "engine.toml", &text, false);
    assert!(reading.diagnostics.is_empty(), "{rendered}");
    let file = reading.file.expect("no engine");
    let general = expanded(&file);
    let again = read(&general);
    let rendered = render(&again.diagnostics, "expanded.toml", &general, false);
    assert_eq!(again.file.as_ref(), Some(&file), "{rendered}{general}");
    file.engine
}

#[test]
fn a_block_with_all_its_keys() {
    let engine = engine(
        r#"
        [block]
        mass = "80 kg"
        centre = ["50 mm", "-1.5 mm", "30 mm"]
        inertia = ["3.1 kg m2", "2.9 kg m2", "1.7 kg m2", "10000 kg mm2", "-0.02 kg m2", "0.3 kg m2"]
        moving_parts = "added"
        gravity = [-2, 0.7, 0]
        driveline_torque = "-45.5 N m"

        [[mount]]
        x = "0 mm"
        y = "0 mm"
        z = "0 mm"
        stiffness = "200 N/mm"
        "#,
    );
    let block = engine.block.clone().expect("it has a block");
    assert_eq!((block.mass, block.moving_parts), (80.0, MovingParts::Added));
    // z counts from the reference plane, which this file puts at 20 mm.
    assert_eq!(block.centre, [0.05, -0.0015, 0.03 - 0.02]);
    assert_eq!((block.inertia, block.products), ([3.1, 2.9, 1.7], [0.01, -0.02, 0.3]));
    assert!((block.gravity[0] + 2.0 / 2.0f64.hypot(0.7)).abs() < 1e-15);
    assert!((block.gravity.iter().map(|g| g * g).sum::<f64>() - 1.0).abs() < 1e-15);
    assert_eq!(block.driveline_torque, [0.0, 0.0, -45.5]);
}

#[test]
fn a_block_with_the_least() {
    let text = r#"block = { mass = "80 kg", centre = ["0 mm", "0 mm", "0 mm"], inertia = ["3 kg m2", "2 kg m2", "2 kg m2"] }"#;
    let reading = read(&format!("{text}{SINGLE}"));
    let block = reading.engine().expect("an engine").block.clone().expect("it has a block");
    assert_eq!(block.moving_parts, MovingParts::Included);
    assert_eq!((block.products, block.driveline_torque), ([0.0; 3], [0.0; 3]));
    assert_eq!(block.gravity, [-1.0, 0.0, 0.0]);
}

#[test]
fn mounts_yield_as_they_say() {
    let engine = engine(
        r#"
        [block]
        mass = "80 kg"
        centre = ["0 mm", "0 mm", "0 mm"]
        inertia = ["3 kg m2", "2 kg m2", "2 kg m2"]

        [[mount]]
        name = "left"
        x = "-50 mm"
        y = "-200 mm"
        z = "20 mm"
        stiffness = "0.2 kN/mm"
        loss_factor = "10 %"

        [[mount]]
        x = "-50 mm"
        y = "200 mm"
        z = "20 mm"
        direction = [1, 1, 0]
        second_direction = [-1, 1.01, 0]
        stiffness = ["200 N/mm", "80000 N/m", "50 lbf/in"]
        damping = ["150 N s/m", "0.1 N s/mm", "0 N s/m"]
        loss_factor = [0.1, 0.05, 0]
        preload = "-350 N"

        [[mount]]
        x = "0 mm"
        y = "0 mm"
        z = "300 mm"
        direction = [0.3, 0.4, -0.2]
        stiffness = ["0 N/mm", "90 N/mm", "90 N/mm"]
        table = [
            { frequency = "1 Hz", stiffness = ["0 N/mm", "100 N/mm", "100 N/mm"] },
            { frequency = "600 rpm", stiffness = "150 N/mm", loss_factor = [0.1, "20 %", 0.2] },
        ]
        "#,
    );
    let springs: Vec<_> = engine.mounts.iter().map(|m| m.spring.clone().expect("it has a spring")).collect();
    assert_eq!(engine.mounts[0].z, 0.0);
    assert_eq!((springs[0].axes, springs[0].stiffness), (FRAME_AXES, [2e5; 3]));
    assert_eq!(springs[0].loss_factor, [0.1; 3]);
    let diagonal = 0.5f64.sqrt();
    for (got, wanted) in
        springs[1].axes.iter().zip([[diagonal, diagonal, 0.0], [-diagonal, diagonal, 0.0], [0.0, 0.0, 1.0]])
    {
        assert!((0..3).all(|j| (got[j] - wanted[j]).abs() < 1e-15), "{got:?}");
    }
    assert_eq!(springs[1].stiffness[..2], [2e5, 8e4]);
    // A pound-force is 4.4482216152605 N, an inch 0.0254 m.
    assert!((springs[1].stiffness[2] / (50.0 * 4.448_221_615_260_5 / 0.0254) - 1.0).abs() < 1e-15);
    assert_eq!((springs[1].damping, springs[1].preload), ([150.0, 100.0, 0.0], -350.0));
    let table = &springs[2].table;
    assert_eq!((table[0].angular_frequency, table[1].angular_frequency), (TAU, 10.0 * TAU));
    assert_eq!((table[0].loss_factor, table[1].loss_factor), ([0.0; 3], [0.1, 0.2, 0.2]));
    let axes = springs[2].axes;
    for (i, a) in axes.iter().enumerate() {
        for (j, b) in axes.iter().enumerate() {
            let product: f64 = (0..3).map(|k| a[k] * b[k]).sum();
            assert!((product - f64::from(u8::from(i == j))).abs() < 1e-15, "{axes:?}");
        }
    }
}

#[test]
fn a_mount_may_have_a_place_only() {
    let engine = engine("[[mount]]\nx = \"0 mm\"\ny = \"0 mm\"\nz = \"-88 mm\"\n");
    assert_eq!(engine.mounts[0].spring, None);
}
