//! The block on its mounts as plain text and as CSV.

use crate::kit::number::{self, phase_degrees};
use crate::kit::paragraph::push_wrapped;
use crate::kit::table::{csv_number, push_csv_line};
use crate::mounts::tables::{mount_axes_words, mount_tables, mounted_body_words};
use lanchester_mechanism::{MountStudy, vector_amplitude};
use std::f64::consts::TAU;

/// What a reader must know of a study beside its tables: points, tables of mounts that end too soon.
pub fn mount_remarks(study: &MountStudy) -> Vec<String> {
    let mut remarks: Vec<String> = Vec::new();
    for (number, motion) in study.points.iter().enumerate() {
        let [x, y, z] = motion.point.map(|p| number::short(1e3 * p, 4));
        remarks.push(format!("Point {} is x = {x}, y = {y}, z = {z} mm.", number + 1));
    }
    for beyond in &study.response.beyond_table {
        let [from, to] = beyond.table.map(|w| number::trimmed(w / TAU, 4));
        let [low, high] = beyond.excitation.map(|w| number::trimmed(w / TAU, 4));
        remarks.push(format!(
            "The table of mount {} goes from {from} to {to} Hz, the excitation from {low} to {high} Hz: beyond its ends the \
             table's last values are used.",
            study.response.mounts[beyond.mount]
        ));
    }
    remarks
}

/// All tables as aligned plain text.
pub fn mounts_text(study: &MountStudy) -> String {
    let mut out = format!("{} on its mounts, shaken by {}\n\n", study.engine, study.excitation);
    push_wrapped(&mut out, "", &mounted_body_words(study));
    push_wrapped(&mut out, "", &mount_axes_words(study));
    for table in mount_tables(study) {
        out.push('\n');
        out.push_str(&table.text());
    }
    let remarks = mount_remarks(study);
    if !remarks.is_empty() {
        out.push('\n');
    }
    for remark in remarks {
        push_wrapped(&mut out, "", &remark);
    }
    out
}

/// Force at every mount by speed and order: amplitude, components with their phases, and the amplitude if the mounts were stiff.
pub fn mount_forces_csv(study: &MountStudy) -> String {
    let mut out = String::new();
    let mut head =
        vec!["speed [rpm]".to_owned(), "order".to_owned(), "frequency [Hz]".to_owned(), "mount".to_owned()];
    head.push("force [N]".to_owned());
    for axis in ["x", "y", "z"] {
        head.push(format!("force_{axis} [N]"));
        head.push(format!("force_{axis}_phase [deg]"));
    }
    head.push("force_if_stiff [N]".to_owned());
    push_csv_line(&mut out, head);
    for at in &study.response.speeds {
        for order in &at.orders {
            let forces = order.forces.iter().zip(&order.stiff_forces);
            for (name, (force, stiff)) in study.response.mounts.iter().zip(forces) {
                let mut line = vec![csv_number(number::rpm(at.speed)), csv_number(order.order)];
                line.push(csv_number(order.order * at.speed / TAU));
                line.push(name.clone());
                line.push(csv_number(vector_amplitude(force)));
                for component in force {
                    line.push(csv_number(component.norm()));
                    line.push(csv_number(phase_degrees(component.arg())));
                }
                line.push(csv_number(vector_amplitude(stiff)));
                push_csv_line(&mut out, line);
            }
        }
    }
    out
}

/// Motion of the block's centre and of the points asked for, by speed and order.
pub fn mount_motion_csv(study: &MountStudy) -> String {
    let mut out = String::new();
    let mut head = vec!["speed [rpm]".to_owned(), "order".to_owned(), "of".to_owned()];
    for (name, unit) in
        [("x", "m"), ("y", "m"), ("z", "m"), ("about_x", "rad"), ("about_y", "rad"), ("about_z", "rad")]
    {
        head.push(format!("{name} [{unit}]"));
        head.push(format!("{name}_phase [deg]"));
    }
    push_csv_line(&mut out, head);
    for (place, at) in study.response.speeds.iter().enumerate() {
        for (index, order) in at.orders.iter().enumerate() {
            let start = [csv_number(number::rpm(at.speed)), csv_number(order.order)];
            let points = study.points.iter().enumerate();
            let points =
                points.map(|(k, p)| (format!("point {}", k + 1), p.displacement[place][index].to_vec()));
            for (name, motion) in std::iter::once(("centre".to_owned(), order.motion.to_vec())).chain(points)
            {
                let mut line = start.to_vec();
                line.push(name);
                for k in 0..6 {
                    let value = motion.get(k);
                    line.push(value.map_or(String::new(), |v| csv_number(v.norm())));
                    line.push(value.map_or(String::new(), |v| csv_number(phase_degrees(v.arg()))));
                }
                push_csv_line(&mut out, line);
            }
        }
    }
    out
}

/// Frequencies, shapes and energy shares of the undamped modes.
pub fn mount_modes_csv(study: &MountStudy) -> String {
    let mut out = String::new();
    let names = ["x", "y", "z", "about_x", "about_y", "about_z"];
    let mut head = vec!["mode".to_owned(), "frequency [Hz]".to_owned()];
    head.extend(names.iter().map(|name| format!("shape_{name}")));
    head.extend(names.iter().map(|name| format!("energy_{name}")));
    push_csv_line(&mut out, head);
    for (index, mode) in study.modes.modes.iter().enumerate() {
        let mut line = vec![(index + 1).to_string(), csv_number(mode.angular_frequency / TAU)];
        line.extend(mode.shape.iter().chain(&mode.energy).map(|&v| csv_number(v)));
        push_csv_line(&mut out, line);
    }
    out
}
