//! Blocks on mounts: by hand and by random numbers.
use lanchester_model::{Block, Engine, FRAME_AXES, Mount, MountSpring, MovingParts};
use nalgebra::{Matrix3, Matrix6, Rotation3, Vector3};
use num_complex::Complex64;
use proptest::prelude::*;

pub type Complex6x6 = Matrix6<Complex64>;

/// A block with its centre at the origin and no products of inertia.
pub fn block(mass: f64, inertia: [f64; 3]) -> Block {
    Block {
        mass,
        centre: [0.0; 3],
        inertia,
        products: [0.0; 3],
        moving_parts: MovingParts::Included,
        gravity: [-1.0, 0.0, 0.0],
        driveline_torque: [0.0; 3],
    }
}

/// A mount that stands as the frame does, undamped.
pub fn mount(name: &str, [x, y, z]: [f64; 3], stiffness: [f64; 3]) -> Mount {
    Mount { name: name.to_owned(), x, y, z, spring: Some(MountSpring::along_frame(stiffness)) }
}

/// Four equal mounts in the plane x = 0, at (0, +-b, +-c).
pub fn table(b: f64, c: f64, stiffness: [f64; 3]) -> Vec<Mount> {
    [(-b, -c), (b, -c), (-b, c), (b, c)]
        .iter()
        .enumerate()
        .map(|(k, &(y, z))| mount(&format!("mount {}", k + 1), [0.0, y, z], stiffness))
        .collect()
}

/// Displacement of a point for the motion of `centre`, from the definition `u + phi x (p - centre)`.
pub fn reach(centre: [f64; 3], point: [f64; 3]) -> nalgebra::Matrix3x6<f64> {
    let r = Vector3::from(point) - Vector3::from(centre);
    nalgebra::Matrix3x6::from_fn(|i, j| {
        if j < 3 {
            return f64::from(u8::from(i == j));
        }
        let mut turn = Vector3::zeros();
        turn[j - 3] = 1.0;
        turn.cross(&r)[i]
    })
}

/// Mass, stiffness with loss, and damping matrix about the centre, summed anew from the numbers of the engine.
pub fn matrices(engine: &Engine) -> (Matrix6<f64>, Complex6x6, Matrix6<f64>) {
    let block = engine.block.as_ref().expect("the engine has a block");
    let mut mass = Matrix6::zeros();
    for i in 0..3 {
        mass[(i, i)] = block.mass;
        for j in 0..3 {
            mass[(3 + i, 3 + j)] = block.tensor()[i][j];
        }
    }
    let (mut stiffness, mut damping) = (Complex6x6::zeros(), Matrix6::zeros());
    for mount in &engine.mounts {
        let spring = mount.spring.as_ref().expect("every mount has a spring");
        let reach = reach(block.centre, [mount.x, mount.y, mount.z]);
        for k in 0..3 {
            let along = reach.transpose() * Vector3::from(spring.axes[k]);
            let energy = along * along.transpose();
            let complex = spring.stiffness[k] * Complex64::new(1.0, spring.loss_factor[k]);
            stiffness += energy.map(|e| e * complex);
            damping += energy * spring.damping[k];
        }
    }
    (mass, stiffness, damping)
}

/// Three unit vectors at right angles.
fn any_axes() -> impl Strategy<Value = [[f64; 3]; 3]> {
    prop_oneof![
        1 => Just(FRAME_AXES),
        3 => (-3.0..3.0, -1.5..1.5, -3.0..3.0).prop_map(|(a, b, c)| {
            let turn = Rotation3::from_euler_angles(a, b, c);
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| turn[(i, j)]))
        }),
    ]
}

fn any_mount() -> impl Strategy<Value = Mount> {
    let damping = prop_oneof![Just([0.0; 3]), [0.0..500.0, 0.0..500.0, 0.0..500.0]];
    let loss = [0.0..0.4, 0.0..0.4, 0.0..0.4];
    let place = [-0.3..0.3, -0.4..0.4, -0.5..0.5];
    let stiffness = [5e4..1e6, 5e4..1e6, 5e4..1e6];
    (any_axes(), place, stiffness, damping, loss, -500.0..500.0f64).prop_map(
        |(axes, [x, y, z], stiffness, damping, loss_factor, preload)| Mount {
            name: format!("{x:.3} {y:.3} {z:.3}"),
            x,
            y,
            z,
            spring: Some(MountSpring { axes, stiffness, damping, loss_factor, preload, table: Vec::new() }),
        },
    )
}

/// A body of six point masses, which has every product of inertia.
fn any_block() -> impl Strategy<Value = Block> {
    let point = ([-0.3..0.3, -0.3..0.3, -0.4..0.4], 5.0..40.0f64);
    let torque = [-300.0..300.0, -300.0..300.0, -300.0..300.0];
    (prop::collection::vec(point, 6), torque, 0.0..6.0f64).prop_map(|(points, driveline_torque, lean)| {
        let mass: f64 = points.iter().map(|p| p.1).sum();
        let centre = points.iter().map(|(p, m)| Vector3::from(*p) * *m).sum::<Vector3<f64>>() / mass;
        let second: Matrix3<f64> = points
            .iter()
            .map(|(p, m)| {
                let r = Vector3::from(*p) - centre;
                r * r.transpose() * *m
            })
            .sum();
        let trace = second.trace();
        Block {
            mass,
            centre: centre.into(),
            inertia: [0, 1, 2].map(|k| trace - second[(k, k)]),
            products: [second[(0, 1)], second[(1, 2)], second[(2, 0)]],
            moving_parts: MovingParts::Included,
            gravity: [-lean.cos(), lean.sin(), 0.0],
            driveline_torque,
        }
    })
}

/// `engine` with a random block on three to five random mounts.
pub fn any_mounted(engine: Engine) -> impl Strategy<Value = Engine> {
    (any_block(), prop::collection::vec(any_mount(), 3..6)).prop_map(move |(block, mut mounts)| {
        for (index, mount) in mounts.iter_mut().enumerate() {
            mount.name = format!("mount {}", index + 1);
        }
        engine
            .with(|parts| {
                parts.block = Some(block);
                parts.mounts = mounts;
            })
            .unwrap()
    })
}
