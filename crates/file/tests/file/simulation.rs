//! What the file says of a run in time.

use lanchester_file::{EngineFile, expanded, read};
use lanchester_model::{Action, BlockKind, LoadLaw, ReactsOn, RunLength, SimulationInput, SpeedKind, When};
use std::f64::consts::{PI, TAU};

const SINGLE: &str = r#"
name = "Single"
speed = "3000 rpm"

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

fn file(more: &str) -> EngineFile {
    let text = format!("{SINGLE}\n{more}");
    let reading = read(&text);
    let shown = lanchester_file::render(&reading.diagnostics, "single.toml", &text, false);
    reading.file.unwrap_or_else(|| panic!("{shown}"))
}

fn codes(more: &str) -> Vec<&'static str> {
    let reading = read(&format!("{SINGLE}\n{more}"));
    assert!(reading.file.is_none(), "{more}");
    reading.diagnostics.iter().map(|d| d.code).collect()
}

const EVERYTHING: &str = r#"
[simulation]
start = { speed = "800 rpm", angle = "30 deg", block = "as drawn" }
duration = "2.5 s"
block = "fixed"
gravity = "1.62 m/s2"
gas = "off"
step = "0.5 deg"
tolerance = 1e-10
tolerances = { speed = "1e-6 rad/s", velocity = "0.5 mm/s", energy = "1e-3 J" }
crankshaft = "body"
point = [{ name = "head", x = "350 mm", z = "-20 mm" }]
mesh = [{ shaft = "shaft 1", pressure_angle = "20 deg", z = "-60 mm" }]
guidance = "piston"
main_stiffness = ["1000 kN/mm", "800 kN/mm"]
torque = [{ order = 0, cos = "60 N m" }, { order = "1/2", sin = "150 N m" }]

[[simulation.event]]
when = "3 revolutions"
do = "misfire 1"

[[simulation.event]]
when = "1.25 s"
do = "fuel 30 %"

[[simulation.event]]
when = "speed falls to 900 rpm"
do = "load 120 N m"

[[simulation.event]]
when = "speed rises to 1200 rpm"
do = "clutch open"

[[simulation.event]]
when = "7200 deg"
do = "stop"

[load]
type = "quadratic"
torque = "95 N m"
at = "2000 rpm"
reacts_on = "block"

[starter]
stall_torque = "12 N m"
free_speed = "6000 rpm"
ratio = 10
until = "350 rpm"

[[driveline]]
inertia = "0.9 kg m2"
stiffness = "1200 N m/rad"
damping = "3 N m s/rad"

[[driveline]]
inertia = "0.3 kg m2"
stiffness = "0.8 kN m/rad"
ratio = -0.5

[friction]
piston_damping = "20 N s/m"

[[shaft]]
ratio = -1
inertia = "0.0008 kg m2"
weights = [{ z = "0 mm", unbalance = "0.001 kg m" }]
"#;

/// Every value arrives in SI units, with the meaning that the reference gives it.
#[test]
fn every_key_of_a_run_arrives() {
    let EngineFile { engine, tasks } = file(EVERYTHING);
    let input = tasks.simulation.as_deref().expect("the file has a run");
    assert_eq!(input.start_speed, Some(800.0 * (PI / 30.0)));
    assert_eq!((input.duration, input.block), (Some(RunLength::Time(2.5)), Some(BlockKind::Fixed)));
    assert_eq!((input.gravity, input.gas, input.tolerance), (Some(1.62), Some(false), Some(1e-10)));
    assert_eq!(input.tolerances.speed, Some(1e-6));
    assert_eq!((input.tolerances.velocity, input.tolerances.energy), (Some(5e-4), Some(1e-3)));
    assert_eq!((input.tolerances.angle, input.crank_as_body), (None, Some(true)));
    assert_eq!((input.points[0].name.as_str(), input.points[0].at), ("head", [0.35, 0.0, -0.02]));
    assert_eq!((input.meshes[0].shaft.as_str(), input.meshes[0].z), ("shaft 1", -0.06));
    assert_eq!(input.main_stiffness, [1e9, 8e8]);
    assert_eq!(input.torque[1].order, 0.5);
    let events: Vec<(When, Action)> =
        input.events.iter().map(|event| (event.when, event.action.clone())).collect();
    assert_eq!(events[0], (When::Angle(3.0 * TAU), Action::Misfire(0)));
    assert_eq!(events[1], (When::Time(1.25), Action::Fuel(0.3)));
    assert_eq!(events[2], (When::SpeedFalls(900.0 * (PI / 30.0)), Action::Load(LoadLaw::Constant(120.0))));
    assert_eq!(events[3], (When::SpeedRises(1200.0 * (PI / 30.0)), Action::ClutchOpen));
    assert_eq!(events[4], (When::Angle(7200.0 * (PI / 180.0)), Action::Stop));
    let load = input.load.as_ref().expect("a load");
    assert_eq!(load.law, LoadLaw::Quadratic { torque: 95.0, at: 2000.0 * (PI / 30.0) });
    assert_eq!(load.reacts_on, ReactsOn::Block);
    assert_eq!(
        input.starter.map(|s| (s.stall_torque, s.ratio, s.reacts_on)),
        Some((12.0, 10.0, ReactsOn::Block))
    );
    assert_eq!(input.driveline.iter().map(|link| link.ratio).collect::<Vec<_>>(), [1.0, -0.5]);
    assert_eq!((input.driveline[1].stiffness, input.piston_damping), (800.0, Some(20.0)));
    assert_eq!(engine.shafts[0].inertia, Some(0.0008));
}

/// The expanded form reads back to the last bit.
#[test]
fn a_run_reads_back_from_its_expanded_form() {
    let imposed = "[simulation]\nspeed = \"imposed\"\nimposed_against = \"ground\"\nduration = \"periodic\"\ngravity = \"off\"\n\
                   imposed = [{ at = \"0 s\", speed = \"800 rpm\" }, { at = \"0.7 s\", speed = \"3000 rpm\" }]\n";
    let angle = "[load]\ntype = \"table\"\nperiod = \"180 deg\"\ntable = [{ angle = \"10 deg\", torque = \"-5 N m\" }, { angle = \"100 deg\", torque = \"7 N m\" }]\n";
    let speed = "[load]\ntype = \"table\"\ntable = [{ speed = \"0 rpm\", torque = \"5 N m\" }, { speed = \"1000 rpm\", torque = \"7 N m\" }]\n";
    let power = "[load]\ntype = \"power\"\npower = \"3 kW\"\nleast_speed = \"300 rpm\"\n[simulation]\nduration = \"7 revolutions\"\n";
    let map = "[load]\ntype = \"table\"\nperiod = \"360 deg\"\ntable = [{ speed = \"500 rpm\", angle = \"0 deg\", torque = \"5 N m\" }, \
               { speed = \"500 rpm\", angle = \"100 deg\", torque = \"-7 N m\" }, { speed = \"900 rpm\", angle = \"30 deg\", torque = \"8 N m\" }]\n";
    let law = file(map).tasks.simulation.and_then(|input| input.load).map(|load| load.law);
    let Some(LoadLaw::Map { period, curves }) = &law else { panic!("{law:?}") };
    assert_eq!((*period, curves.len(), curves[0].points.len(), curves[1].points[0][1]), (TAU, 2, 2, 8.0));
    for more in [EVERYTHING, imposed, angle, speed, map, power, "[simulation]\n", "[load]\ntype = \"none\"\n"]
    {
        let first = file(more);
        let text = expanded(&first);
        let again = read(&text).file.unwrap_or_else(|| panic!("{text}"));
        assert_eq!(first.tasks.simulation, again.tasks.simulation, "{text}");
        assert_eq!(first.engine.shafts, again.engine.shafts, "{text}");
    }
    assert_eq!(file("").tasks.simulation, None);
    let empty = file("[simulation]\n").tasks.simulation;
    assert_eq!(empty.as_deref(), Some(&SimulationInput::default()));
    let kind = file(imposed).tasks.simulation.and_then(|input| input.speed);
    assert_eq!(kind, Some(SpeedKind::Imposed));
}

/// What nothing uses as the file stands, but an option or other data would, is told and kept.
#[test]
fn data_of_other_questions_are_accepted() {
    for (more, key) in [
        (
            "[simulation]\nimposed = [{ at = \"0 s\", speed = \"2000 rpm\" }, { at = \"1 s\", speed = \"3000 rpm\" }]\n",
            "imposed",
        ),
        ("[friction]\nfmep = \"1 bar\"\n", "friction"),
        ("[governor]\nspeed = \"900 rpm\"\ngain = \"0.1 1/rpm\"\n", "governor"),
    ] {
        let reading = read(&format!("{SINGLE}\n{more}"));
        assert!(reading.file.is_some(), "{more}: {:?}", reading.diagnostics);
        let told = |d: &&lanchester_file::Diagnostic| d.code == "W0204" && d.message.contains(key);
        assert_eq!(reading.diagnostics.iter().filter(told).count(), 1, "{more}: {:?}", reading.diagnostics);
    }
}

/// All mistakes at once, each with its code.
#[test]
fn mistakes_of_a_run_are_told() {
    for (more, expected) in [
        ("[simulation]\nduration = \"soon\"\n", "E1801"),
        ("[simulation]\nduration = \"-1 s\"\n", "E1801"),
        ("[simulation]\nduration = \"0 revolutions\"\n", "E1801"),
        ("[simulation]\ngravity = \"down\"\n", "E1801"),
        ("[simulation]\ntolerance = 1\n", "E0108"),
        ("[simulation]\nevent = [{ when = \"later\", do = \"stop\" }]\n", "E1801"),
        ("[simulation]\nevent = [{ when = \"1 s\", do = \"misfire 2\" }]\n", "E1802"),
        ("[simulation]\nevent = [{ when = \"1 s\", do = \"fuel 130 %\" }]\n", "E1802"),
        ("[simulation]\nevent = [{ when = \"1 s\" }]\n", "E0202"),
        ("[simulation]\npoint = [{ x = \"1 mm\" }]\n", "E0202"),
        ("[simulation]\npoint = [{ name = \"a\" }, { name = \"a\" }]\n", "E1803"),
        ("[simulation]\nmesh = [{ shaft = \"a\", pressure_angle = \"50 deg\", z = \"0 mm\" }]\n", "E0108"),
        ("[simulation]\nmesh = [{ shaft = \"a\", pressure_angle = \"20 deg\" }]\n", "E0202"),
        ("[simulation]\ntolerances = { speed = \"0 rad/s\" }\n", "E0108"),
        ("[simulation]\ntolerances = { mass = \"1 kg\" }\n", "E0201"),
        ("[simulation]\ntorque = [{ order = 1 }]\n", "E0202"),
        ("[load]\ntype = \"power\"\npower = \"3 kW\"\n", "E0202"),
        ("[load]\ntype = \"constant\"\ntorque = \"3 N m\"\nat = \"100 rpm\"\n", "E0204"),
        (
            "[load]\ntype = \"table\"\ntable = [{ speed = \"1 rpm\", torque = \"1 N m\" }, { angle = \"1 deg\", torque = \"1 N m\" }]\n",
            "E1803",
        ),
        (
            "[load]\ntype = \"table\"\ntable = [{ speed = \"1 rpm\", angle = \"0 deg\", torque = \"1 N m\" }, { angle = \"1 deg\", torque = \"1 N m\" }]\n",
            "E0202",
        ),
        (
            "[load]\ntype = \"table\"\ntable = [{ speed = \"2 rpm\", angle = \"9 deg\", torque = \"1 N m\" }, { speed = \"1 rpm\", angle = \"10 deg\", torque = \"1 N m\" }]\n",
            "E1803",
        ),
        (
            "[load]\ntype = \"table\"\ntable = [{ speed = \"2 rpm\", angle = \"9 deg\", torque = \"1 N m\" }, { speed = \"2 rpm\", angle = \"8 deg\", torque = \"1 N m\" }]\n",
            "E1803",
        ),
        (
            "[load]\ntype = \"table\"\ntable = [{ speed = \"2 rpm\", torque = \"1 N m\" }, { speed = \"1 rpm\", torque = \"1 N m\" }]\n",
            "E1803",
        ),
        (
            "[starter]\nstall_torque = \"1 N m\"\nfree_speed = \"1000 rpm\"\nratio = 10\nuntil = \"200 rpm\"\n",
            "E1803",
        ),
        ("[[driveline]]\ninertia = \"1 kg m2\"\nstiffness = \"1 N m/rad\"\nratio = 0\n", "E0110"),
        ("[[driveline]]\ninertia = \"1 kg m2\"\nstiffness = \"1 N/m\"\n", "E0103"),
    ] {
        assert!(codes(more).contains(&expected), "{more} gives {:?}", codes(more));
    }
}
