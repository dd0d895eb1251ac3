//! What the file says of the stress of its crankshafts.

use crate::support::written::file;
use lanchester_file::{expanded, read};
use lanchester_task::{CasePinForce, StressCaseLoad, StressSupport};

const TWIN: &str = r#"
name = "Twin"
speed = ["1000 rpm", "4000 rpm"]
[layout]
type = "in-line"
cylinders = 2
spacing = "90 mm"
crank_angles = ["0 deg", "180 deg"]
[crank]
stroke = "95.5 mm"
web_distance = "48 mm"
[crank.mesh]
size = "14 mm"
fillet_elements = 4
[crank.body]
density = "7850 kg/m3"
journal_diameter = "55 mm"
pin_diameter = "48 mm"
web_thickness = "20 mm"
web_radius = "40 mm"
pin_end_radius = "36 mm"
end_journals = "25 mm"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"

[[stress.case]]
name = "unit radial"
pin = 1
radial = "-65 kN"

[[stress.case]]
name = "both pins"
force = [{ pin = 1, radial = "-65 kN" }, { pin = 2, radial = "1 kN", tangential = "-2.5 kN" }]
angle = "7 deg"
speed = "3000 rpm"
support = "springs"
stiffness = ["500 N/um", { x = "400 N/um", y = "300 N/um" }, "0 N/m"]

[[stress.case]]
name = "Fired"
angle = "24 deg"
support = "rings"
ring_thickness = "5 mm"

[[stress.case]]
name = "at rest"
angle = "24 deg"
support = "film"
"#;

#[test]
fn cases_and_mesh_are_read_and_written_again() {
    let own = file(TWIN);
    let stress = own.tasks.stress.as_ref().unwrap();
    assert_eq!((stress.mesh.size, stress.mesh.fillet_elements), (Some(0.014), Some(4)));
    let names: Vec<&str> = stress.cases.iter().map(|case| case.name.as_str()).collect();
    assert_eq!(names, ["unit radial", "both pins", "Fired", "at rest"]);
    assert_eq!(stress.cases[0].support, StressSupport::Journals);
    let force = CasePinForce { throw: 0, radial: -65e3, tangential: 0.0 };
    assert_eq!(stress.cases[0].load, StressCaseLoad::Forces { forces: vec![force], angle: None });
    let StressSupport::Springs { stiffness } = &stress.cases[1].support else { panic!("{stress:?}") };
    assert_eq!(stiffness, &[[5e8; 2], [4e8, 3e8], [0.0; 2]]);
    assert_eq!(stress.cases[1].speed, Some(100.0 * std::f64::consts::PI));
    assert_eq!(stress.cases[2].support, StressSupport::Rings { thickness: Some(5e-3), modulus: None });
    assert_eq!(stress.cases[3].support, StressSupport::Film);
    // Capitals and blanks around a name do not count.
    assert_eq!(stress.case(" fired").map(|case| &case.name[..]), Some("Fired"));
    assert_eq!(stress.case("firing"), None);
    let text = expanded(&own);
    assert_eq!(file(&text), own, "{text}");
}

#[test]
fn a_mesh_of_its_own_is_named() {
    let own = file(&TWIN.replace("size = \"14 mm\"\nfillet_elements = 4", "file = \"crank.inp\""));
    assert_eq!(own.tasks.stress.as_ref().unwrap().mesh.file.as_deref(), Some("crank.inp"));
    assert_eq!(file(&expanded(&own)), own);
}

#[test]
fn forces_on_two_crankshafts_are_no_case() {
    let text = r#"
name = "Two crankshafts"
speed = "4000 rpm"
[[crankshaft]]
name = "one"
[[crankshaft]]
name = "two"
ratio = -1
x = "0 mm"
y = "200 mm"
[[throw]]
angle = "0 deg"
z = "0 mm"
radius = "40 mm"
[[throw]]
crankshaft = 2
angle = "0 deg"
z = "0 mm"
radius = "40 mm"
[[cylinder]]
number = 1
throw = 1
angle = "0 deg"
[[cylinder]]
number = 2
throw = 2
angle = "0 deg"
[piston]
mass = "0.5 kg"
[rod]
length = "150 mm"
mass = "0.6 kg"
[[stress.case]]
name = "both"
force = [{ pin = 2, radial = "1 kN" }, { pin = 1, radial = "1 kN" }]
[[stress.case]]
name = "second"
pin = 2
radial = "1 kN"
"#;
    let reading = read(text);
    let told: Vec<&str> = reading.diagnostics.iter().map(|one| one.code).collect();
    assert_eq!(told, ["E0205"], "{:?}", reading.diagnostics);
    let own = file(&text.replace(", { pin = 1, radial = \"1 kN\" }", ""));
    let stress = own.tasks.stress.unwrap();
    assert!(stress.cases.iter().all(|case| case.crankshaft == 1), "{stress:?}");
}
