//! The engine at another cylinder spacing.

use lanchester_file::{read, template};

#[test]
fn spacing_is_that_of_throws_else_of_cylinders() {
    let engine = read(template("in-line-3").unwrap().text).engine().unwrap();
    let spacing = engine.spacing().unwrap();
    let wide = engine.stretched(1.5).unwrap();
    assert!((wide.spacing().unwrap() - 1.5 * spacing).abs() < 1e-12);
    assert!((wide.cylinders[0].z - 1.5 * engine.cylinders[0].z).abs() < 1e-12);
    let engine = engine.with(|parts| parts.throws.iter_mut().for_each(|t| t.z = 0.0)).unwrap();
    assert!((engine.spacing().unwrap() - spacing).abs() < 1e-12);
    assert_eq!(engine.stretched(0.0).unwrap().spacing(), None);
}
