//! Springs and dampers where a store would follow: what the user says, drawn and listed like any element.
//!
//! ```text
//! before   car > piston            after   car > piston_pad > piston        0: one force, velocities differ
//!                                          piston_pad > piston_slip        1: piston_pad_spring (C), piston_pad_damper (R)
//! ```

use crate::description::{Description, Entry, Text};
use crate::mistake::Mistakes;

/// Puts a pad before every store that `relax` names.
pub(crate) fn relax(description: &mut Description, mistakes: &mut Mistakes) {
    for entry in std::mem::take(&mut description.relax) {
        let name = entry.name.text.clone();
        let is_inertia = description.elements.iter().any(|element| {
            element.name.text == name
                && element.get("kind").is_some_and(|kind| kind.text == "I")
                && element.get("energy").is_none()
                && element.get("coenergy").is_none()
        });
        let ends = |bond: &Text| -> Option<[String; 2]> {
            let (from, to) = bond.text.split_once('>')?;
            Some([from.trim().to_owned(), to.trim().to_owned()])
        };
        let bond = description.bonds.iter().position(|bond| ends(bond).is_some_and(|ends| ends[1] == name));
        let (true, Some(bond)) = (is_inertia, bond) else {
            let message = format!("`{name}` is no inertia of one port that a spring could be put before");
            let hint = "name an I with a bond, as `equations` lists it among the stores that follow";
            mistakes.push("E1706", &entry.name.span, message, hint);
            continue;
        };
        for (key, _) in &entry.keys {
            if !["stiffness", "damping"].contains(&key.text.as_str()) {
                let message = format!("relax has no `{}`", key.text);
                mistakes.push("E1702", &key.span, message, "it has stiffness and damping");
            }
        }
        let Some(stiffness) = entry.get("stiffness").cloned() else {
            let message = format!("the pad before `{name}` has no stiffness");
            mistakes.push("E1709", &entry.name.span, message, "give it one, for example \"1e8 N/m\"");
            continue;
        };
        let span = entry.name.span.clone();
        let text = |text: String| Text { text, span: span.clone() };
        let mut add = |suffix: &str, keys: &[(&str, Text)]| {
            let keys = keys.iter().map(|(key, value)| ((*key).into(), value.clone())).collect();
            description.elements.push(Entry { name: text(format!("{name}_{suffix}")), keys });
        };
        let kind = |kind: &str| ("kind", Text::from(kind));
        add("pad", &[kind("0")]);
        add("slip", &[kind("1")]);
        add("pad_spring", &[kind("C"), ("stiffness", stiffness)]);
        let mut bonds = vec![
            format!("{name}_pad > {name}"),
            format!("{name}_pad > {name}_slip"),
            format!("{name}_slip > {name}_pad_spring"),
        ];
        if let Some(damping) = entry.get("damping").cloned() {
            add("pad_damper", &[kind("R"), ("resistance", damping)]);
            bonds.push(format!("{name}_slip > {name}_pad_damper"));
        }
        let from = ends(&description.bonds[bond]).map_or(String::new(), |[from, _]| from);
        description.bonds[bond].text = format!("{from} > {name}_pad");
        description.bonds.extend(bonds.into_iter().map(text));
    }
}
