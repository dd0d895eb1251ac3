//! Criteria in words: how engine files, command lines and reports call them.

use crate::balance_task::{Criterion, Load};
use crate::main_load;
use lanchester_model::Engine;
use lanchester_model::Mount;
use lanchester_results::{Axis, Counted, LARGEST_ORDER, Output, Place, Quantity, Size, order_text};
use lanchester_units::BadQuantity;
use lanchester_units::nearest;
use lanchester_units::{Dimension, Refusal, one_of};

/// Loads that name no mount and no main bearing, as files and reports call them.
const LOADS: [(&str, Load); 11] = [
    ("force", Load::Force),
    ("force x", Load::ForceX),
    ("force y", Load::ForceY),
    ("couple", Load::Couple),
    ("couple x", Load::CoupleX),
    ("couple y", Load::CoupleY),
    ("roll moment", Load::RollMoment),
    ("mount force", Load::LargestMountForce),
    ("mount force with gas", Load::LargestMountForceWithGas),
    (main_load::NAME, Load::LargestMainLoad),
    ("bending moment", Load::BendingMoment),
];

/// Criteria that are no load.
const OTHERS: [(&str, Criterion); 3] = [
    ("added mass", Criterion::AddedMass),
    ("added unbalance", Criterion::AddedUnbalance),
    ("cost", Criterion::Cost),
];

/// What stands between a load and the number of its order.
const ORDER: &str = " order ";
/// What stands before the name of a mount.
const MOUNT: &str = "mount force ";
/// What stands behind the name of a mount where the gas counts too.
const WITH_GAS: &str = " with gas";
/// The criterion of this name: a load such as `force`, `couple y`, `roll moment`, `mount force` (the largest of all
/// mounts), `mount force front`, both with ` with gas` behind, `main-bearing load` (the largest of all main bearings), `main-bearing load 3`,
/// `bending moment`; one order of it, such as `force order 2` or `roll moment order 0.5`; `main-bearing load rms` (of
/// all main bearings and the cycle), `main-bearing load 3 rms`, `largest main-bearing load rms`, the same with `mean`; any of
/// these with the gas over the range of speeds, `main-bearing load with gas`; `added mass` or `added unbalance`.
///
/// # Errors
/// [`BadQuantity`] if there is no such criterion, or no such mount or main bearing.
pub fn criterion(text: &str, engine: &Engine) -> Result<Criterion, BadQuantity> {
    let found = named(text, Some(&engine.mounts)).map_err(BadQuantity::from)?;
    main_load::check(&found, engine).map_err(BadQuantity::from)?;
    Ok(found)
}

/// The name of the criterion, as [`criterion`] reads it. A mount that the engine does not have goes by its number.
pub fn criterion_name(criterion: &Criterion, engine: &Engine) -> String {
    name_among(criterion, &engine.mounts)
}

/// The SI unit of the criterion: `N`, `N m`, `kg` or `kg m`; of a cost `unit`, whatever the file counts in.
pub fn criterion_unit(criterion: &Criterion) -> &'static str {
    if *criterion == Criterion::Cost {
        return "unit";
    }
    match dimension(criterion) {
        Dimension::Force => "N",
        Dimension::Mass => "kg",
        Dimension::Unbalance => "kg m",
        _ => "N m",
    }
}

/// What the criterion measures.
pub fn dimension(criterion: &Criterion) -> Dimension {
    match criterion {
        Criterion::Peak(load) | Criterion::Order(load, _) => match load {
            Load::Force
            | Load::ForceX
            | Load::ForceY
            | Load::MountForce(_)
            | Load::LargestMountForce
            | Load::MountForceWithGas(_)
            | Load::LargestMountForceWithGas
            | Load::MainLoad(_)
            | Load::LargestMainLoad => Dimension::Force,
            Load::Couple | Load::CoupleX | Load::CoupleY | Load::RollMoment | Load::BendingMoment => {
                Dimension::Torque
            }
        },
        Criterion::MainRms(_) | Criterion::MainMean(_) | Criterion::MainsWithGas(..) => Dimension::Force,
        Criterion::AddedMass => Dimension::Mass,
        Criterion::AddedUnbalance => Dimension::Unbalance,
        Criterion::Cost => Dimension::Share,
    }
}

/// The load of a criterion, if it is about one.
pub fn load(criterion: &Criterion) -> Option<Load> {
    match criterion {
        Criterion::Peak(load) | Criterion::Order(load, _) => Some(*load),
        Criterion::MainRms(_) | Criterion::MainMean(_) | Criterion::MainsWithGas(..) => {
            Some(Load::LargestMainLoad)
        }
        Criterion::AddedMass | Criterion::AddedUnbalance | Criterion::Cost => None,
    }
}

/// What stands beside a cost has no unit that could be read: it has a key and an option of its own.
pub fn cost_has_no_value(name: &str) -> Refusal {
    Refusal {
        code: "E0103",
        message: format!("`{name}` has no unit that could stand in a limit or a weighted sum"),
        label: "no quantity".into(),
        hint: "give the largest cost as the budget, such as budget = 40 in [balance]; or minimise the cost as a stage of its own".into(),
    }
}

/// What is asked of an order that must vanish.
pub const CANCEL_NEEDS: &str = "needs one order of a load on the engine's block";

/// The load and the order of a criterion that can be asked to vanish.
pub fn cancelled(criterion: &Criterion) -> Option<(Load, f64)> {
    match criterion {
        Criterion::Order(load, order) if !is_of_crank(*load) && !load.counts_gas() => Some((*load, *order)),
        _ => None,
    }
}

/// Whether a load acts within the crank train, not on the block.
fn is_of_crank(load: Load) -> bool {
    matches!(load, Load::BendingMoment | Load::MainLoad(_) | Load::LargestMainLoad)
}

/// What to write instead of `name`.
pub fn cancel_hint(name: &str) -> String {
    let is_load = LOADS.iter().any(|(known, load)| *known == name && !is_of_crank(*load));
    let name = if is_load || name.starts_with(MOUNT) { shown(name) } else { "force".into() };
    format!("name the order, such as \"{name}{ORDER}1\"")
}

/// As [`criterion_name`], for the mounts alone.
pub fn name_among(criterion: &Criterion, mounts: &[Mount]) -> String {
    let load_name = |load: &Load| match load {
        Load::MountForce(index) => mount_name(*index, mounts),
        Load::MountForceWithGas(index) => mount_name(*index, mounts) + WITH_GAS,
        Load::MainLoad(index) => main_load::load_name(*index),
        _ => LOADS.iter().find(|(_, known)| known == load).map_or("", |(name, _)| name).to_string(),
    };
    if let Some(name) = main_load::statistic_name(criterion) {
        return name;
    }
    match criterion {
        Criterion::Peak(load) => load_name(load),
        Criterion::Order(load, order) => format!("{}{ORDER}{}", load_name(load), order_text(*order)),
        other => OTHERS.iter().find(|(_, known)| known == other).map_or("", |(name, _)| name).to_string(),
    }
}

fn mount_name(index: usize, mounts: &[Mount]) -> String {
    match mounts.get(index) {
        Some(mount) => format!("{MOUNT}{}", mount.name),
        None => format!("{MOUNT}{}", index + 1),
    }
}

/// `2`, `0.5` or `1/2`, more than 0.
fn order(text: &str) -> Option<f64> {
    let number = |text: &str| {
        let plain = text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
        text.parse::<f64>().ok().filter(|_| plain)
    };
    let order = match text.split_once('/') {
        Some((numerator, denominator)) => number(numerator.trim())? / number(denominator.trim())?,
        None => number(text)?,
    };
    (order.is_finite() && order > 0.0 && order <= LARGEST_ORDER).then_some(order)
}

/// The criterion of this name; `None` for `mounts` says that nobody knows them: any name then stands for the first.
///
/// What other studies call the same, `peak force` or `force of order 2`, is understood too ([`lanchester_results::Output`]).
pub fn named(text: &str, mounts: Option<&[Mount]>) -> Result<Criterion, Refusal> {
    own_name(text, mounts).or_else(|refusal| {
        let output = text.parse::<Output>().ok();
        output.and_then(|output| of_output(&output, mounts)).ok_or(refusal)
    })
}

/// The criterion that an output of the common vocabulary is, if balancing can judge by it.
fn of_output(output: &Output, mounts: Option<&[Mount]>) -> Option<Criterion> {
    let with_gas = match output.counted {
        Counted::Usual => false,
        Counted::All => true,
        Counted::Inertia | Counted::Gas => return None,
    };
    if output.sense.is_some() {
        return None;
    }
    let whole = output.place == Place::Any;
    let load = match (output.quantity, output.axis, with_gas) {
        (Quantity::Force, None, false) => Load::Force,
        (Quantity::Force, Some(Axis::X), false) => Load::ForceX,
        (Quantity::Force, Some(Axis::Y), false) => Load::ForceY,
        (Quantity::Couple, None, false) => Load::Couple,
        (Quantity::Couple, Some(Axis::X), false) => Load::CoupleX,
        (Quantity::Couple, Some(Axis::Y), false) => Load::CoupleY,
        (Quantity::RollMoment, _, false) => Load::RollMoment,
        (Quantity::BendingMoment, _, false) if whole => Load::BendingMoment,
        (Quantity::MountForce, _, with_gas) => {
            let one = match &output.place {
                Place::Named(name) => Some(mount_index(name, mounts?)?),
                Place::Number(_) => return None,
                Place::Any | Place::Largest => None,
            };
            match (one, with_gas, mounts) {
                (None, _, Some([])) => return None,
                (None, false, _) => Load::LargestMountForce,
                (None, true, _) => Load::LargestMountForceWithGas,
                (Some(index), false, _) => Load::MountForce(index),
                (Some(index), true, _) => Load::MountForceWithGas(index),
            }
        }
        (Quantity::MainBearingLoad, ..) => return main_load::of_output(output, with_gas),
        (Quantity::AddedMass, ..) => return Some(Criterion::AddedMass),
        (Quantity::AddedUnbalance, ..) => return Some(Criterion::AddedUnbalance),
        (Quantity::Cost, ..) => return Some(Criterion::Cost),
        _ => return None,
    };
    match output.size {
        Size::Peak => Some(Criterion::Peak(load)),
        Size::Order(order) => Some(Criterion::Order(load, order)),
        Size::Mean | Size::Rms => None,
    }
}

/// As [`named`], in the words of balancing alone.
fn own_name(text: &str, mounts: Option<&[Mount]>) -> Result<Criterion, Refusal> {
    let text = text.trim();
    let plain = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some((_, other)) = OTHERS.iter().find(|(name, _)| *name == plain) {
        return Ok(*other);
    }
    let simple = |name: &str| LOADS.iter().find(|(known, _)| *known == name).map(|(_, load)| *load);
    let with_gas = |name: &str| mount_index(name.strip_suffix(WITH_GAS)?, mounts?);
    let of_mains = |name: &str| if name.contains(ORDER) { None } else { main_load::named(name) };
    let found = if let Some(load) = simple(&plain) {
        Criterion::Peak(load)
    } else if let Some(found) = of_mains(&plain) {
        found?
    } else if let Some(index) = text.strip_prefix(MOUNT).and_then(|name| mount_index(name, mounts?)) {
        Criterion::Peak(Load::MountForce(index))
    } else if let Some(index) = text.strip_prefix(MOUNT).and_then(with_gas) {
        Criterion::Peak(Load::MountForceWithGas(index))
    } else if let Some((before, number)) = text.rsplit_once(ORDER) {
        let Some(order) = order(number.trim()) else { return Err(bad_order(text, number)) };
        let before = before.trim();
        let single = before.split_whitespace().collect::<Vec<_>>().join(" ");
        let load = match (simple(&single), main_load::named(&single)) {
            (Some(load), _) => load,
            (None, Some(found)) => match found? {
                Criterion::Peak(load) => load,
                _ => return Err(unknown(text)),
            },
            (None, None) => at_mount(before, text, mounts)?,
        };
        Criterion::Order(load, order)
    } else {
        Criterion::Peak(at_mount(text, text, mounts)?)
    };
    match (load(&found), mounts) {
        (Some(Load::LargestMountForce | Load::LargestMountForceWithGas), Some([])) => Err(no_mounts(text)),
        _ => Ok(found),
    }
}

fn mount_index(name: &str, mounts: &[Mount]) -> Option<usize> {
    let mut of_name = mounts.iter().enumerate().filter(|(_, mount)| mount.name == name.trim());
    let (index, _) = of_name.next()?;
    of_name.next().is_none().then_some(index)
}

/// The load of `mount force NAME` or `mount force NAME with gas`: a mount of the whole name comes first.
fn at_mount(load: &str, text: &str, mounts: Option<&[Mount]>) -> Result<Load, Refusal> {
    let whole = || mount_index(load.strip_prefix(MOUNT)?, mounts?);
    match load.strip_suffix(WITH_GAS) {
        Some(of_inertia) if whole().is_none() => {
            Ok(Load::MountForceWithGas(mount(of_inertia, text, mounts)?))
        }
        _ => Ok(Load::MountForce(mount(load, text, mounts)?)),
    }
}

/// Index of the mount of `mount force NAME`.
fn mount(load: &str, text: &str, mounts: Option<&[Mount]>) -> Result<usize, Refusal> {
    let Some(name) = load.strip_prefix(MOUNT).map(str::trim) else { return Err(unknown(text)) };
    let Some(mounts) = mounts else { return Ok(0) };
    if let Some(index) = mount_index(name, mounts) {
        return Ok(index);
    }
    if mounts.is_empty() {
        return Err(no_mounts(text));
    }
    let names: Vec<String> = mounts.iter().map(|mount| format!("\"{}\"", shown(&mount.name))).collect();
    let (what, hint) = match mounts.iter().filter(|mount| mount.name == name).count() {
        0 => (
            "there is no mount",
            format!("there is {}", one_of(names.iter().map(String::as_str)).replace(" or ", " and ")),
        ),
        _ => ("more than one mount has the name", "give every mount its own name".to_string()),
    };
    Err(Refusal { code: "E0205", message: format!("{what} \"{}\"", shown(name)), label: String::new(), hint })
}

fn no_mounts(text: &str) -> Refusal {
    Refusal {
        code: "E0205",
        message: format!("\"{}\" needs engine mounts, and there are none", shown(text)),
        label: "no mount".into(),
        hint: "add [[mount]] with x, y and z".into(),
    }
}

fn bad_order(text: &str, number: &str) -> Refusal {
    Refusal {
        code: "E0108",
        message: format!(
            "the order in \"{}\" needs a number above 0 and up to {LARGEST_ORDER}, got \"{}\"",
            shown(text),
            shown(number.trim())
        ),
        label: "no order".into(),
        hint: "write it as \"force order 2\" or \"force order 0.5\"".into(),
    }
}

fn unknown(text: &str) -> Refusal {
    let names = || {
        let others = OTHERS.iter().map(|(name, _)| *name).chain(main_load::PROPOSED);
        LOADS.iter().map(|(name, _)| *name).chain(others)
    };
    let (load, number) = match text.rsplit_once(ORDER) {
        Some((load, number)) => (load, Some(number.trim())),
        None => (text, None),
    };
    let all: Vec<String> = names().map(|name| format!("\"{name}\"")).collect();
    let hint = match (nearest(load, names()), number) {
        (Some(near), Some(number)) => format!("did you mean \"{near}{ORDER}{}\"?", shown(number)),
        (Some(near), None) => format!("did you mean \"{near}\"?"),
        (None, _) => format!(
            "write {}; a load with \" order 2\" behind it for one order",
            one_of(all.iter().map(String::as_str))
        ),
    };
    Refusal {
        code: "E0109",
        message: format!("there is no criterion \"{}\"", shown(text)),
        label: "unknown criterion".into(),
        hint,
    }
}

/// At most 60 characters, for messages.
fn shown(text: &str) -> String {
    text.chars().take(60).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mounts(names: &[&str]) -> Vec<Mount> {
        let at = |(z, name): (usize, &&str)| Mount {
            name: name.to_string(),
            x: 0.0,
            y: 0.0,
            z: z as f64,
            spring: None,
        };
        names.iter().enumerate().map(at).collect()
    }

    #[test]
    fn every_name_reads_back_as_its_criterion() {
        let mounts = mounts(&["front", "rear order 2", "x  y"]);
        let at_mounts = (0..3).flat_map(|index| [Load::MountForce(index), Load::MountForceWithGas(index)]);
        let loads = LOADS.iter().map(|(_, load)| *load).chain(at_mounts);
        for load in loads {
            let orders = [1.0, 2.0, 0.5, 1.5, 1.0 / 3.0, 3.7123];
            for found in
                orders.map(|order| Criterion::Order(load, order)).into_iter().chain([Criterion::Peak(load)])
            {
                let name = name_among(&found, &mounts);
                assert_eq!(named(&name, Some(&mounts)), Ok(found), "{name}");
            }
        }
        for (name, other) in OTHERS {
            assert_eq!(named(name, Some(&[])), Ok(other));
        }
    }

    #[test]
    fn names_as_people_write_them() {
        let front = mounts(&["front"]);
        let criterion = |text: &str, mounts: &[Mount]| named(text, Some(mounts));
        assert_eq!(criterion("force order 0.5", &[]), Ok(Criterion::Order(Load::Force, 0.5)));
        assert_eq!(criterion("roll  moment", &[]), Ok(Criterion::Peak(Load::RollMoment)));
        assert_eq!(
            criterion("mount force front order 3/2", &front),
            Ok(Criterion::Order(Load::MountForce(0), 1.5))
        );
        assert_eq!(name_among(&Criterion::Order(Load::CoupleY, 0.5), &[]), "couple y order 0.5");
        let gas = [
            ("mount force  with gas", Load::LargestMountForceWithGas),
            ("mount force front with gas", Load::MountForceWithGas(0)),
        ];
        for (text, load) in gas {
            assert_eq!(criterion(text, &front), Ok(Criterion::Peak(load)), "{text}");
            assert_eq!(
                criterion(&format!("{text} order 2"), &front),
                Ok(Criterion::Order(load, 2.0)),
                "{text}"
            );
        }
        // A mount may have any name.
        let odd = mounts(&["front", "front with gas"]);
        assert_eq!(criterion("mount force front with gas", &odd), Ok(Criterion::Peak(Load::MountForce(1))));
    }

    #[test]
    fn what_is_no_criterion() {
        let refused = |text: &str, mounts: &[Mount]| {
            let bad = named(text, Some(mounts)).expect_err(text);
            format!("{}; {}", bad.message, bad.hint)
        };
        assert!(refused("forse", &[]).contains("did you mean \"force\"?"));
        assert!(refused("copule order 2", &[]).contains("did you mean \"couple order 2\"?"));
        assert!(refused("mount force", &[]).contains("there are none"));
        assert!(refused("mount force with gas", &[]).contains("there are none"));
        assert!(refused("mount force back with gas", &mounts(&["front"])).contains("no mount \"back\""));
        assert!(refused("mount force with gs", &mounts(&["front"])).contains("no mount"));
        assert!(refused("mount force back", &mounts(&["front", "rear"])).contains("\"front\" and \"rear\""));
        assert!(refused("mount force a", &mounts(&["a", "a"])).contains("more than one"));
        for order in ["0", "-1", "1/0", "two", "nan", "1e3", ""] {
            assert!(refused(&format!("force order {order} "), &[]).contains("force"), "{order}");
        }
        assert!(refused(&"x".repeat(100_000), &[]).len() < 1000);
    }
}
