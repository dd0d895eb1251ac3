//! Where the main bearings of a crankshaft stand.

use lanchester_file::{expanded, read};

/// Mains of the first crankshaft [mm], to the micrometre.
fn mains(crank: &str) -> Vec<f64> {
    let text = format!(
        "name = \"x\"\nspeed = \"3000 rpm\"\n[piston]\nmass = \"0.5 kg\"\n[rod]\nlength = \"150 mm\"\nmass = \
         \"0.6 kg\"\n{crank}"
    );
    let reading = read(&text);
    let file = reading.file.unwrap_or_else(|| panic!("{:?}", reading.diagnostics));
    assert_eq!(read(&expanded(&file)).file.as_ref(), Some(&file), "written out and read again");
    file.engine.main_planes(0).into_iter().map(|z| (1e6 * z).round() / 1e3).collect()
}

fn four(crank: &str) -> Vec<f64> {
    mains(&format!(
        "[firing]\norder = [1, 3, 4, 2]\n[layout]\ntype = \"in-line\"\ncylinders = 4\nspacing = \"90 mm\"\n\
         [crank]\nstroke = \"80 mm\"\n{crank}"
    ))
}

#[test]
fn a_main_stands_between_any_two_throws_and_at_the_ends() {
    assert_eq!(four(""), [-180.0, -90.0, 0.0, 90.0, 180.0]);
    assert_eq!(four("web_distance = \"45 mm\""), [-180.0, -90.0, 0.0, 90.0, 180.0]);
}

#[test]
fn the_file_may_place_them() {
    assert_eq!(four("main_positions = [\"-180 mm\", \"5 mm\", \"170 mm\"]"), [-180.0, 5.0, 170.0]);
}

#[test]
fn a_lone_throw_stands_between_two() {
    let single = "[layout]\ntype = \"in-line\"\ncylinders = 1\ncrank_angles = [\"0 deg\"]\n[crank]\nstroke = \"80 mm\"\n";
    assert_eq!(mains(single), [-50.0, 50.0]);
    assert_eq!(mains(&format!("{single}web_distance = \"36 mm\"")), [-36.0, 36.0]);
}

#[test]
fn split_pins_share_their_mains() {
    let six = "[layout]\ncrank_angles = [\"0 deg\", \"240 deg\", \"120 deg\"]\ntype = \"v\"\ncylinders = 6\nspacing = \"100 mm\"\n\
               bank_angle = \"60 deg\"\nbank_stagger = \"0 mm\"\npins = \"split\"\nsplit_angle = \"60 deg\"\n[crank]\nstroke = \"80 mm\"\n";
    assert_eq!(mains(six), [-150.0, -50.0, 50.0, 150.0]);
    let staggered = six.replace("stagger = \"0 mm\"", "stagger = \"20 mm\"");
    assert_eq!(mains(&staggered), [-150.0, -50.0, 50.0, 150.0]);
}

#[test]
fn a_boxer_has_a_main_in_a_pair_only_where_there_is_room() {
    let boxer = |stagger: &str, crank: &str| {
        mains(&format!(
            "[layout]\ntype = \"boxer\"\ncylinders = 4\nspacing = \"110 mm\"\n\
             bank_stagger = \"{stagger} mm\"\ncrank_angles = [\"0 deg\", \"180 deg\"]\n[crank]\nstroke = \"76 mm\"\n{crank}"
        ))
    };
    assert_eq!(boxer("40", ""), [-110.0, 0.0, 110.0]);
    assert_eq!(boxer("55", ""), [-110.0, -55.0, 0.0, 55.0, 110.0]);
    // Webs 26 mm apart leave room at 40 mm; webs as far apart as the pins are one web between them.
    assert_eq!(boxer("40", "web_distance = \"26 mm\""), [-95.0, -55.0, 0.0, 55.0, 95.0]);
    assert_eq!(boxer("40", "web_distance = \"28 mm\""), [-110.0, 0.0, 110.0]);
    assert_eq!(boxer("40", "web_distance = \"40 mm\""), [-110.0, 0.0, 110.0]);
}
