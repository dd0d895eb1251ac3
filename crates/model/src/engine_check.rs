//! What every engine has to keep: finite numbers of the right sign, places that exist, linkages that turn, names of their own.

use crate::crank::body::Envelope;
use crate::engine_parts::{BalanceShaft, Counterweight, Crankshaft, Cylinder, EngineParts, RodJoint, Throw};
use crate::fault::{Fault, Part, unique};
use crate::gear::Gear;
use crate::linkage::{CLEARANCE, MARGIN, largest_reach};
use crate::ratio::Ratio;
use crate::running::block::Block;
use crate::running::gas_check::{of_friction, of_gas};
use crate::running::mount::Mount;

/// All faults of the parts.
pub(crate) fn faults(parts: &EngineParts) -> Vec<Fault> {
    let mut found = Vec::new();
    let faults = &mut found;
    let EngineParts { crankshafts, throws, cylinders, counterweights, shafts, mounts, .. } = parts;
    let range = parts.speed;
    let part = &mut Part { faults, name: &|| "speed".into() };
    part.positive("lowest [rad/s]", range.lowest);
    part.positive("highest [rad/s]", range.highest);
    if range.lowest > range.highest {
        part.add("highest [rad/s]", format!("at least {}", range.lowest), range.highest, "exchange them");
    }
    for (index, crankshaft) in crankshafts.iter().enumerate() {
        of_crankshaft(crankshaft, index, &mut Part { faults, name: &|| format!("crankshafts[{index}]") });
    }
    for (index, throw) in throws.iter().enumerate() {
        of_throw(throw, crankshafts, &mut Part { faults, name: &|| format!("throws[{index}]") });
    }
    for index in 0..cylinders.len() {
        of_cylinder(parts, index, faults);
    }
    for (index, weight) in counterweights.iter().enumerate() {
        of_counterweight(weight, parts, &mut Part { faults, name: &|| format!("counterweights[{index}]") });
    }
    for (index, shaft) in shafts.iter().enumerate() {
        of_shaft(shaft, index, faults);
    }
    for (index, mount) in mounts.iter().enumerate() {
        of_mount(mount, &mut Part { faults, name: &|| format!("mounts[{index}]") });
    }
    if let Some(block) = &parts.block {
        of_block(block, &mut Part { faults, name: &|| "block".into() });
    }
    of_sizes(parts, faults);
    if let Some(design) = &parts.torsion {
        crate::running::torsion_check::of_torsion(design, parts.throws.len(), faults);
    }
    crate::crank::check::check(parts, faults);
    unique("crankshafts", crankshafts.iter().map(|crankshaft| crankshaft.name.as_str()), faults);
    unique("counterweights", counterweights.iter().map(|weight| weight.name.as_str()), faults);
    for (index, gear) in parts.gears.iter().enumerate() {
        of_gear(gear, &mut Part { faults, name: &|| format!("gears[{index}]") });
    }
    unique("shafts", shafts.iter().map(|shaft| shaft.name.as_str()), faults);
    unique("gears", parts.gears.iter().map(|gear| gear.name.as_str()), faults);
    unique("mounts", mounts.iter().map(|mount| mount.name.as_str()), faults);
    found
}

fn of_crankshaft(crankshaft: &Crankshaft, index: usize, part: &mut Part<'_>) {
    part.finite("phase [rad]", crankshaft.phase);
    part.finite("x [m]", crankshaft.x);
    part.finite("y [m]", crankshaft.y);
    if index == 0 && crankshaft.ratio != Ratio::ONE {
        let remedy = "all speeds count from it: give the others theirs against it";
        part.add("ratio", "1 for the first crankshaft", crankshaft.ratio, remedy);
    }
    if let Some(mains) = &crankshaft.mains {
        mains.iter().for_each(|z| part.finite("mains [m]", *z));
        if mains.len() < 2 {
            part.add("mains", "two or more", mains.len(), "give one at each end");
        }
        if mains.windows(2).any(|pair| pair[0] >= pair[1]) {
            part.add("mains [m]", "rising from the free end to the flywheel", "others", "put them in order");
        }
    }
}

fn of_throw(throw: &Throw, crankshafts: &[Crankshaft], part: &mut Part<'_>) {
    part.index("crankshaft", throw.crankshaft, crankshafts.len());
    part.finite("angle [rad]", throw.angle);
    part.finite("z [m]", throw.z);
    part.positive("radius [m]", throw.radius);
    part.finite("unbalance [kg m]", throw.unbalance);
    part.finite("unbalance_offset [m]", throw.unbalance_offset);
    throw.webs.iter().flatten().for_each(|z| part.finite("webs [m]", *z));
    if let Some([front, rear]) = throw.webs
        && front > rear
    {
        part.add("webs [m]", "front then rear", format!("{front} and {rear}"), "exchange them");
    }
}

fn of_cylinder(parts: &EngineParts, index: usize, faults: &mut Vec<Fault>) {
    let cylinder = &parts.cylinders[index];
    let part = &mut Part { faults, name: &|| format!("cylinders[{index}]") };
    let has_throw = part.index("throw", cylinder.throw, parts.throws.len());
    part.finite("angle [rad]", cylinder.angle);
    part.finite("z [m]", cylinder.z);
    part.finite("offset [m]", cylinder.offset);
    part.finite("pin_offset [m]", cylinder.pin_offset);
    cylinder.bore.iter().for_each(|bore| part.positive("bore [m]", *bore));
    part.not_negative("piston_mass [kg]", cylinder.piston_mass);
    cylinder.firing_angle.iter().for_each(|angle| part.finite("firing_angle [rad]", *angle));
    if let Some(first) = cylinder.chamber
        && !(first < index && parts.cylinders[first].chamber.is_none())
    {
        part.add(
            "chamber",
            "the first piston of a chamber, before this one",
            first,
            "name the first of them",
        );
    }
    let rod = &cylinder.rod;
    let part = &mut Part { faults, name: &|| format!("cylinders[{index}].rod") };
    part.positive("length [m]", rod.length);
    part.not_negative("big_end_mass [kg]", rod.big_end_mass);
    part.not_negative("small_end_mass [kg]", rod.small_end_mass);
    part.not_negative("axial_inertia [kg m^2]", rod.axial_inertia);
    rod.inertia.iter().for_each(|inertia| part.not_negative("inertia [kg m^2]", *inertia));
    if has_throw {
        turns(parts, cylinder, part);
    }
}

/// Whether the crank can turn with this rod.
fn turns(parts: &EngineParts, cylinder: &Cylinder, part: &mut Part<'_>) {
    let (rod, throw) = (&cylinder.rod, &parts.throws[cylinder.throw]);
    let too_short = "a rod's length is measured between its eyes";
    let RodJoint::Articulated { master, knuckle_radius, knuckle_angle } = rod.joint else {
        let limit = throw.radius + cylinder.net_offset().abs();
        if rod.length.is_finite() && rod.length <= limit * (1.0 + CLEARANCE) {
            let needed = format!("more than {limit}, crank radius and offset");
            part.add("length [m]", needed, rod.length, too_short);
        }
        return;
    };
    part.positive("knuckle_radius [m]", knuckle_radius);
    part.finite("knuckle_angle [rad]", knuckle_angle);
    if !part.index("master", master, parts.cylinders.len()) {
        return;
    }
    let master = &parts.cylinders[master];
    if matches!(master.rod.joint, RodJoint::Articulated { .. }) || master.throw != cylinder.throw {
        let remedy = "name the cylinder whose rod carries the knuckle pin";
        part.add("master", "a cylinder of the same throw with a rod on the crankpin", "another", remedy);
    } else if throw.radius + knuckle_radius + cylinder.net_offset().abs() < rod.length * (1.0 - MARGIN) {
        // Longer than any place of the knuckle pin needs.
    } else if let Some(reach) = largest_reach(throw, master, cylinder)
        && reach >= rod.length * (1.0 - MARGIN)
    {
        let needed = format!("more than {reach}, what it has to bridge");
        part.add("length [m]", needed, rod.length, too_short);
    }
}

fn of_counterweight(weight: &Counterweight, parts: &EngineParts, part: &mut Part<'_>) {
    part.index("crankshaft", weight.crankshaft, parts.crankshafts.len());
    part.finite("z [m]", weight.z);
    part.not_negative("unbalance [kg m]", weight.unbalance);
    part.finite("angle [rad]", weight.angle);
    if let Some(web) = weight.part.as_ref().and_then(|part| part.web) {
        part.index("part.web", web, 2 * parts.throws.len());
    }
}

fn of_shaft(shaft: &BalanceShaft, index: usize, faults: &mut Vec<Fault>) {
    let part = &mut Part { faults, name: &|| format!("shafts[{index}]") };
    part.finite("x [m]", shaft.x);
    part.finite("y [m]", shaft.y);
    shaft.inertia.iter().for_each(|inertia| part.not_negative("inertia [kg m^2]", *inertia));
    for (number, weight) in shaft.weights.iter().enumerate() {
        let part = &mut Part { faults, name: &|| format!("shafts[{index}].weights[{number}]") };
        part.finite("z [m]", weight.z);
        part.not_negative("unbalance [kg m]", weight.unbalance);
        part.finite("phase [rad]", weight.phase);
    }
}

fn of_gear(gear: &Gear, part: &mut Part<'_>) {
    part.finite("x [m]", gear.x);
    part.finite("y [m]", gear.y);
    gear.inertia.iter().for_each(|inertia| part.not_negative("inertia [kg m^2]", *inertia));
    let Some(disc) = gear.disc else { return };
    part.positive("diameter [m]", disc.diameter);
    part.positive("width [m]", disc.width);
    part.positive("density [kg/m^3]", disc.density);
    part.not_negative("bore [m]", disc.bore);
    if disc.bore >= disc.diameter {
        part.add(
            "bore [m]",
            format!("less than the diameter {}", disc.diameter),
            disc.bore,
            "give a smaller bore",
        );
    }
    if gear.inertia.is_some() {
        part.add("inertia [kg m^2]", "from one source", "a number and a shape", "leave out one of them");
    }
}

fn of_mount(mount: &Mount, part: &mut Part<'_>) {
    [mount.x, mount.y, mount.z].iter().for_each(|place| part.finite("place [m]", *place));
    let Some(spring) = &mount.spring else { return };
    spring.axes.iter().flatten().for_each(|axis| part.finite("spring.axes", *axis));
    spring.stiffness.iter().for_each(|one| part.not_negative("spring.stiffness [N/m]", *one));
    spring.damping.iter().for_each(|one| part.not_negative("spring.damping [N s/m]", *one));
    spring.loss_factor.iter().for_each(|one| part.not_negative("spring.loss_factor", *one));
    part.finite("spring.preload [N]", spring.preload);
    for point in &spring.table {
        part.not_negative("spring.table.angular_frequency [rad/s]", point.angular_frequency);
        point.stiffness.iter().for_each(|one| part.not_negative("spring.table.stiffness [N/m]", *one));
        point.loss_factor.iter().for_each(|one| part.not_negative("spring.table.loss_factor", *one));
    }
    if spring.table.windows(2).any(|pair| pair[0].angular_frequency >= pair[1].angular_frequency) {
        part.add("spring.table", "rising in frequency", "another order", "put its points in order");
    }
}

fn of_block(block: &Block, part: &mut Part<'_>) {
    part.positive("mass [kg]", block.mass);
    block.centre.iter().for_each(|place| part.finite("centre [m]", *place));
    block.gravity.iter().for_each(|one| part.finite("gravity", *one));
    block.driveline_torque.iter().for_each(|one| part.finite("driveline_torque", *one));
    if let Some(fault) = block.inertia_fault() {
        let remedy = "moments and products count about the centre of mass, along the axes of the frame";
        part.add("inertia [kg m^2]", "that of some body", format!("{fault:?}"), remedy);
    }
}

/// Sizes of the crankshaft as a body, of bearings, flywheel and gas.
fn of_sizes(parts: &EngineParts, faults: &mut Vec<Fault>) {
    if let Some(body) = &parts.crank_body {
        let part = &mut Part { faults, name: &|| "crank_body".into() };
        part.positive("density [kg/m^3]", body.density);
        part.positive("journal_diameter [m]", body.journal_diameter);
        part.positive("pin_diameter [m]", body.pin_diameter);
        part.positive("web_thickness [m]", body.web_thickness);
        part.positive("web_radius [m]", body.web_radius);
        part.positive("pin_end_radius [m]", body.pin_end_radius);
        part.not_negative("journal_bore [m]", body.journal_bore);
        part.not_negative("pin_bore [m]", body.pin_bore);
        body.end_journals.iter().for_each(|length| part.not_negative("end_journals [m]", *length));
        for (quantity, bore, outside) in [
            ("journal_bore [m]", body.journal_bore, body.journal_diameter),
            ("pin_bore [m]", body.pin_bore, body.pin_diameter),
        ] {
            if bore >= outside {
                part.add(quantity, format!("less than the diameter {outside}"), bore, "give a smaller bore");
            }
        }
    }
    if let Some(bearings) = &parts.bearings {
        let part = &mut Part { faults, name: &|| "bearings".into() };
        for bearing in [bearings.piston_pin, bearings.crankpin, bearings.main].into_iter().flatten() {
            part.positive("width [m]", bearing.width);
            bearing.diameter.iter().for_each(|diameter| part.positive("diameter [m]", *diameter));
        }
    }
    if let Some(flywheel) = &parts.flywheel {
        let part = &mut Part { faults, name: &|| "flywheel".into() };
        for inertia in [flywheel.inertia, flywheel.crankshaft_inertia].iter().flatten() {
            part.not_negative("inertia [kg m^2]", *inertia);
        }
        for share in flywheel.fluctuation.iter().filter(|share| !(**share > 0.0 && **share < 2.0)) {
            let remedy = "it is highest less lowest speed over their mean: 0.02 for 2 %";
            part.add("fluctuation", "more than 0 and less than 2", share, remedy);
        }
        flywheel.speeds.iter().for_each(|speed| part.positive("speeds [rad/s]", *speed));
    }
    if let Some(gas) = &parts.gas {
        of_gas(gas, faults);
    }
    if let Some(friction) = &parts.friction {
        of_friction(friction, faults);
    }
    if let Some(envelope) = &parts.envelope {
        of_envelope(envelope, &mut Part { faults, name: &|| "envelope".into() });
    }
}

/// Sizes of what the crankshaft must stay clear of.
fn of_envelope(envelope: &Envelope, part: &mut Part<'_>) {
    envelope.least.iter().for_each(|own| part.not_negative("least [m]", *own));
    envelope.crankcase_radius.iter().for_each(|own| part.positive("crankcase_radius [m]", *own));
    if let Some(skirt) = &envelope.skirt {
        part.positive("length of the skirt [m]", skirt.length);
        skirt.width.iter().for_each(|own| part.positive("width of the skirt [m]", *own));
    }
    if let Some(liner) = &envelope.liner {
        part.positive("end of the liner [m]", liner.end);
        part.positive("wall of the liner [m]", liner.wall);
    }
    if let Some(rod) = &envelope.rod {
        part.positive("big_end_radius [m]", rod.big_end_radius);
        part.positive("big_end_width [m]", rod.big_end_width);
        part.positive("shank_width [m]", rod.shank_width);
        part.positive("shank_thickness [m]", rod.shank_thickness);
    }
}
