//! Elements of the crankshaft: those that differ as tables, all of them as a list in comments, and `[crank.material]`.

use super::text::{File, quantity, quoted};
use lanchester_model::{
    CrankElement, CrankElementForm, CrankEnd, Engine, Fillet, JournalDetail, OilHole, PinDetail,
};
use lanchester_units::{Dimension, readable};

impl File {
    /// Fillets and oil holes of all, then tables of single elements; part of `[crank.body]`.
    pub(super) fn crank_details(&mut self, engine: &Engine) {
        if let Some(details) = &engine.crank_details {
            for (kind, Fillet { radius, recess }) in
                [("pin", details.pin_fillet), ("journal", details.journal_fillet)]
            {
                self.length_if(&format!("{kind}_fillet"), radius);
                self.length_if(&format!("{kind}_recess"), Some(recess).filter(|recess| *recess != 0.0));
            }
            self.oil_hole(details.oil_hole);
        }
        self.crank_elements(engine);
        if let Some(details) = &engine.crank_details {
            for JournalDetail { crankshaft, journal, diameter, bore, fillet, recess } in &details.journals {
                self.element("journal", *journal);
                if *crankshaft > 0 {
                    self.entry("crankshaft", &(crankshaft + 1).to_string());
                }
                self.bar(*diameter, [*bore, *fillet, *recess]);
            }
            for PinDetail { throw, diameter, bore, fillet, recess, oil_hole } in &details.pins {
                self.element("pin", *throw);
                self.bar(*diameter, [*bore, *fillet, *recess]);
                self.oil_hole(*oil_hole);
            }
        }
        self.webs(engine);
        for (end, key) in [(CrankEnd::Nose, "nose"), (CrankEnd::Flange, "flange")] {
            let steps = engine.crank_details.iter().flat_map(|details| &details.ends);
            for step in steps.filter(|step| step.end == end) {
                self.header(&format!("[[crank.body.{key}]]"), "");
                if step.crankshaft > 0 {
                    self.entry("crankshaft", &(step.crankshaft + 1).to_string());
                }
                self.entry("length", &quantity(step.length, Dimension::Length));
                self.entry("diameter", &quantity(step.diameter, Dimension::Length));
                self.entry_unless_zero("bore", step.bore, Dimension::Length);
            }
        }
    }

    /// Webs with sizes of their own, or that do not stand at half the web distance, each with its place.
    fn webs(&mut self, engine: &Engine) {
        let shared: Vec<usize> = engine.shared_webs().into_iter().flat_map(|shared| shared.webs()).collect();
        for web in (0..2 * engine.throws.len()).filter(|web| !shared.contains(web)) {
            let throw = &engine.throws[web / 2];
            let Some(planes) = throw.webs else { continue };
            let own =
                engine.crank_details.iter().flat_map(|details| &details.webs).find(|own| own.web == web);
            if own.is_none() && super::web_distance(throw).is_some() {
                continue;
            }
            self.element("web", web);
            for (key, value) in [
                ("thickness", own.and_then(|own| own.thickness)),
                ("radius", own.and_then(|own| own.radius)),
                ("pin_end_radius", own.and_then(|own| own.pin_end_radius)),
                ("position", Some(planes[web % 2])),
            ] {
                self.length_if(key, value);
            }
        }
    }

    fn element(&mut self, kind: &str, index: usize) {
        self.header(&format!("[[crank.body.{kind}]]"), "");
        self.entry("numbers", &format!("[{}]", index + 1));
    }

    fn bar(&mut self, diameter: Option<f64>, others: [Option<f64>; 3]) {
        self.length_if("diameter", diameter);
        for (key, value) in ["bore", "fillet", "recess"].into_iter().zip(others) {
            self.length_if(key, value);
        }
    }

    fn oil_hole(&mut self, hole: Option<OilHole>) {
        let Some(hole) = hole else { return };
        let (diameter, angle) =
            (quantity(hole.diameter, Dimension::Length), quantity(hole.angle, Dimension::Angle));
        self.entry("oil_hole", &format!("{{ diameter = {diameter}, angle = {angle} }}"));
    }

    fn length_if(&mut self, key: &str, value: Option<f64>) {
        if let Some(value) = value {
            self.entry(key, &quantity(value, Dimension::Length));
        }
    }

    /// All elements of all crankshafts, as comments.
    fn crank_elements(&mut self, engine: &Engine) {
        for (index, crankshaft) in engine.crankshafts.iter().enumerate() {
            let Ok(elements) = engine.crank_elements(index) else { continue };
            let of =
                if engine.crankshafts.len() > 1 { format!(" of {}", crankshaft.name) } else { String::new() };
            self.comment(&format!("Elements{of} along z:"));
            elements.iter().for_each(|element| self.comment(&element_line(element)));
        }
    }

    pub(super) fn crank_material(&mut self, engine: &Engine) {
        let Some(material) = &engine.crank_material else { return };
        self.header("[crank.material]", "");
        if let Some(preset) = material.preset {
            self.entry("preset", &quoted(preset.name()));
        }
        for (key, value) in [
            ("youngs_modulus", material.youngs_modulus),
            ("tensile_strength", material.tensile_strength),
            ("yield_strength", material.yield_strength),
            ("fatigue_bending", material.fatigue_bending),
            ("fatigue_torsion", material.fatigue_torsion),
        ] {
            if let Some(value) = value {
                self.entry(key, &quantity(value, Dimension::Pressure));
            }
        }
        for (key, value) in [
            ("poisson_ratio", material.poisson_ratio),
            ("loss_factor", material.loss_factor),
            ("damping_ratio", material.damping_ratio),
        ] {
            if let Some(value) = value {
                self.entry(key, &format!("{value:?}"));
            }
        }
        if let Some(forging) = material.forging {
            self.entry("forging", &quoted(forging.word()));
        }
    }
}

/// `pin 1        -60 mm .. -40 mm   diameter 48 mm, bore 20 mm, fillets 3 mm`.
fn element_line(element: &CrankElement) -> String {
    let length = |value: f64| readable(value, Dimension::Length);
    let [from, to] = element.faces.map(length);
    let mut text = format!("  {:<10} {from} .. {to}: ", element.name());
    match &element.form {
        CrankElementForm::Web { discs, shared_with, .. } => {
            text += &format!("radii {} and {}", length(discs[0].radius), length(discs[1].radius));
            if let Some(other) = shared_with {
                text += &format!(", one with web {}", other + 1);
            }
        }
        CrankElementForm::Nose { bar, .. }
        | CrankElementForm::Journal { bar, .. }
        | CrankElementForm::Pin { bar, .. }
        | CrankElementForm::Flange { bar, .. } => {
            text += &format!("diameter {}", length(bar.diameter));
            if bar.bore > 0.0 {
                text += &format!(", bore {}", length(bar.bore));
            }
            let fillet = bar.fillets.into_iter().flatten().find(|fillet| fillet.radius.is_some());
            if let Some(Fillet { radius: Some(radius), recess }) = fillet {
                text += &format!(", fillets {}", length(radius));
                if recess > 0.0 {
                    text += &format!(" cut {} into the web", length(recess));
                }
            }
            if let CrankElementForm::Pin { oil_hole: Some(hole), .. } = element.form {
                text += &format!(", oil hole {}", length(hole.diameter));
            }
        }
    }
    text
}
