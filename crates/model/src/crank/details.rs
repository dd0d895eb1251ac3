//! What the file says of single elements of the crankshaft, beside the uniform form: `[[crank.body.journal]]`, `[[crank.body.pin]]`,
//! `[[crank.body.web]]`, `[[crank.body.nose]]`, `[[crank.body.flange]]`, and fillets and oil holes of all.

use crate::crank::body::CrankBody;
use crate::crank::elements::{Fillet, OilHole};
use serde::Serialize;

/// Elements that differ from the uniform body, and what the uniform body has beyond its masses. Lengths in m.
///
/// Where a web stands is in [`crate::Throw::webs`]: the planes of the middles of both webs, whatever their thickness.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct CrankDetails {
    /// Fillets at both ends of every pin.
    pub pin_fillet: Fillet,
    /// Fillets of every journal, where it meets a web.
    pub journal_fillet: Fillet,
    /// Oil hole of every pin.
    pub oil_hole: Option<OilHole>,
    /// Journals that differ.
    pub journals: Vec<JournalDetail>,
    /// Pins that differ.
    pub pins: Vec<PinDetail>,
    /// Webs that differ.
    pub webs: Vec<WebDetail>,
    /// Steps before the first journal and behind the last one.
    pub ends: Vec<EndStep>,
}

/// A journal that differs; `None`: as all.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct JournalDetail {
    /// Index of its crankshaft.
    pub crankshaft: usize,
    /// Its index along the crankshaft, from the free end.
    pub journal: usize,
    /// Diameter [m].
    pub diameter: Option<f64>,
    /// Diameter of its bore [m].
    pub bore: Option<f64>,
    /// Radius of its fillets [m].
    pub fillet: Option<f64>,
    /// Depth of their undercut [m].
    pub recess: Option<f64>,
}

/// A crankpin that differs; `None`: as all.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct PinDetail {
    /// Index of its throw.
    pub throw: usize,
    /// Diameter [m].
    pub diameter: Option<f64>,
    /// Diameter of its bore [m].
    pub bore: Option<f64>,
    /// Radius of its fillets [m].
    pub fillet: Option<f64>,
    /// Depth of their undercut [m].
    pub recess: Option<f64>,
    /// Its oil hole.
    pub oil_hole: Option<OilHole>,
}

/// A web that differs; `None`: as all.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct WebDetail {
    /// Its index through all throws: `2 throw` in front of the pin, `2 throw + 1` behind it.
    pub web: usize,
    /// Thickness along the crank [m].
    pub thickness: Option<f64>,
    /// Radius of its disc about the crank axis [m].
    pub radius: Option<f64>,
    /// Radius of its round end about the crankpin [m].
    pub pin_end_radius: Option<f64>,
}

/// A round step of the nose or the flange.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct EndStep {
    /// Index of its crankshaft.
    pub crankshaft: usize,
    /// Whether it stands before the first journal or behind the last one.
    pub end: CrankEnd,
    /// Length along the crank [m].
    pub length: f64,
    /// Diameter [m].
    pub diameter: f64,
    /// Diameter of a bore along its middle [m]; 0 for none.
    pub bore: f64,
}

/// An end of a crankshaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CrankEnd {
    /// The free end.
    Nose,
    /// The end of the flywheel.
    Flange,
}

impl CrankDetails {
    /// Sizes at web `web`: the uniform ones, or its own.
    pub fn at_web(&self, body: &CrankBody, web: usize) -> CrankBody {
        let Some(own) = self.webs.iter().find(|own| own.web == web) else { return *body };
        CrankBody {
            web_thickness: own.thickness.unwrap_or(body.web_thickness),
            web_radius: own.radius.unwrap_or(body.web_radius),
            pin_end_radius: own.pin_end_radius.unwrap_or(body.pin_end_radius),
            ..*body
        }
    }

    /// Sizes at the pin of throw `throw`: the uniform ones, or its own.
    pub fn at_pin(&self, body: &CrankBody, throw: usize) -> CrankBody {
        let Some(own) = self.pins.iter().find(|own| own.throw == throw) else { return *body };
        CrankBody {
            pin_diameter: own.diameter.unwrap_or(body.pin_diameter),
            pin_bore: own.bore.unwrap_or(body.pin_bore),
            ..*body
        }
    }

    /// Sizes at journal `journal` of a crankshaft: the uniform ones, or its own.
    pub fn at_journal(&self, body: &CrankBody, crankshaft: usize, journal: usize) -> CrankBody {
        let Some(own) = self.own_journal(crankshaft, journal) else { return *body };
        CrankBody {
            journal_diameter: own.diameter.unwrap_or(body.journal_diameter),
            journal_bore: own.bore.unwrap_or(body.journal_bore),
            ..*body
        }
    }

    /// Fillet at the ends of the pin of throw `throw`.
    pub fn fillet_of_pin(&self, throw: usize) -> Fillet {
        let own = self.pins.iter().find(|own| own.throw == throw);
        own.map_or(self.pin_fillet, |own| changed(self.pin_fillet, own.fillet, own.recess))
    }

    /// Fillet at the ends of journal `journal` of a crankshaft.
    pub fn fillet_of_journal(&self, crankshaft: usize, journal: usize) -> Fillet {
        let own = self.own_journal(crankshaft, journal);
        own.map_or(self.journal_fillet, |own| changed(self.journal_fillet, own.fillet, own.recess))
    }

    /// Oil hole of the pin of throw `throw`.
    pub fn oil_hole_of(&self, throw: usize) -> Option<OilHole> {
        let own = self.pins.iter().find(|own| own.throw == throw);
        own.and_then(|own| own.oil_hole).or(self.oil_hole)
    }

    /// Steps at one end of a crankshaft, along z.
    pub fn steps(&self, crankshaft: usize, end: CrankEnd) -> impl DoubleEndedIterator<Item = &EndStep> {
        self.ends.iter().filter(move |step| step.crankshaft == crankshaft && step.end == end)
    }

    fn own_journal(&self, crankshaft: usize, journal: usize) -> Option<&JournalDetail> {
        self.journals.iter().find(|own| own.crankshaft == crankshaft && own.journal == journal)
    }
}

fn changed(all: Fillet, radius: Option<f64>, recess: Option<f64>) -> Fillet {
    Fillet { radius: radius.or(all.radius), recess: recess.unwrap_or(all.recess) }
}
