//! From the short form of the crankshaft to its elements along z.

use crate::crank::body::CrankBody;
use crate::crank::details::{CrankDetails, CrankEnd, EndStep};
use crate::crank::elements::{CrankElement, CrankElementForm, Disc, RoundBar};
use crate::crank::plain_web::{SharedWeb, TOUCH, pin};
use crate::engine_parts::{EngineParts, Throw};
use lanchester_shape::Point;

/// Why a crankshaft has no elements.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CrankElementsFault {
    /// A crankshaft that the engine does not have.
    #[error("the engine has {count} crankshaft(s), asked for number {}", .index + 1)]
    NoCrankshaft {
        /// Index that was asked for.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// The engine says nothing of journals, pins and webs.
    #[error("the engine has no [crank.body]")]
    NoBody,
    /// A crankshaft without throws.
    #[error("crankshaft {} has no throw", .index + 1)]
    NoThrow {
        /// Its index.
        index: usize,
    },
    /// A throw without places for its webs.
    #[error("throw {} needs `web_distance`", .throw + 1)]
    NoWebs {
        /// Its index.
        throw: usize,
    },
    /// Webs that leave no room for the crankpin.
    #[error("the webs of throw {} leave {length} m for the crankpin", .throw + 1)]
    NoPin {
        /// Index of the throw.
        throw: usize,
        /// Length that is left [m].
        length: f64,
    },
}

impl EngineParts {
    /// The elements of crankshaft `crankshaft` along z: nose, journals, webs, pins, flange; without counterweights.
    ///
    /// Pins fill what is between their two webs, journals what is between the webs of neighbouring throws, and the first and the last
    /// journal stand out by their own lengths. Where webs touch, no journal is between them, and none is counted. A web between two pins
    /// ([`SharedWeb`]) is two elements, half of it for each throw.
    ///
    /// # Errors
    /// [`CrankElementsFault`] where the engine does not say enough, or has no room for a pin.
    pub fn crank_elements(&self, crankshaft: usize) -> Result<Vec<CrankElement>, CrankElementsFault> {
        let count = self.crankshafts.len();
        if crankshaft >= count {
            return Err(CrankElementsFault::NoCrankshaft { index: crankshaft, count });
        }
        let body = self.crank_body.ok_or(CrankElementsFault::NoBody)?;
        let mut throws = Vec::new();
        let own = |(_, throw): &(usize, &Throw)| throw.crankshaft == crankshaft;
        for (index, throw) in self.throws.iter().enumerate().filter(own) {
            throws.push((index, throw, throw.webs.ok_or(CrankElementsFault::NoWebs { throw: index })?));
        }
        throws.sort_by(|a, b| (a.2[0] + a.2[1]).total_cmp(&(b.2[0] + b.2[1])));
        if throws.is_empty() {
            return Err(CrankElementsFault::NoThrow { index: crankshaft });
        }
        let uniform = CrankDetails::default();
        let details = self.crank_details.as_ref().unwrap_or(&uniform);
        let shared = self.shared_webs();
        let expansion = Expansion { parts: self, body, details, crankshaft, shared };
        expansion.elements(&throws)
    }
}

struct Expansion<'a> {
    parts: &'a EngineParts,
    body: CrankBody,
    details: &'a CrankDetails,
    crankshaft: usize,
    shared: Vec<SharedWeb>,
}

impl Expansion<'_> {
    fn elements(
        &self,
        throws: &[(usize, &Throw, [f64; 2])],
    ) -> Result<Vec<CrankElement>, CrankElementsFault> {
        let thickness = |web: usize| self.details.at_web(&self.body, web).web_thickness;
        let mut elements = Vec::new();
        let mut journals = 0;
        let mut front = throws[0].2[0] - thickness(2 * throws[0].0) / 2.0 - self.body.end_journals[0];
        self.nose(front, &mut elements);
        for (number, (index, throw, planes)) in throws.iter().enumerate() {
            let faces = [planes[0] + thickness(2 * index) / 2.0, planes[1] - thickness(2 * index + 1) / 2.0];
            self.journal(
                &mut journals,
                [front, planes[0] - thickness(2 * index) / 2.0],
                [number > 0, true],
                &mut elements,
            );
            front = planes[1] + thickness(2 * index + 1) / 2.0;
            let length = faces[1] - faces[0];
            if length.is_nan() || length <= 0.0 {
                return Err(CrankElementsFault::NoPin { throw: *index, length });
            }
            self.web(2 * index, &mut elements);
            elements.push(self.pin(*index, throw, faces));
            self.web(2 * index + 1, &mut elements);
        }
        let end = front + self.body.end_journals[1];
        self.journal(&mut journals, [front, end], [true, false], &mut elements);
        self.flange(end, &mut elements);
        Ok(elements)
    }

    fn nose(&self, end: f64, elements: &mut Vec<CrankElement>) {
        let steps: Vec<&EndStep> = self.details.steps(self.crankshaft, CrankEnd::Nose).collect();
        let mut from = end - steps.iter().map(|step| step.length).sum::<f64>();
        for (index, step) in steps.iter().enumerate() {
            // The last step ends where the journal begins, to the last bit.
            let to = if index + 1 == steps.len() { end } else { from + step.length };
            let form = CrankElementForm::Nose { step: index, bar: end_bar(step) };
            elements.push(CrankElement { faces: [from, to], density: self.body.density, form });
            from = to;
        }
    }

    fn flange(&self, end: f64, elements: &mut Vec<CrankElement>) {
        let mut from = end;
        for (index, step) in self.details.steps(self.crankshaft, CrankEnd::Flange).enumerate() {
            let faces = [from, from + step.length];
            let form = CrankElementForm::Flange { step: index, bar: end_bar(step) };
            elements.push(CrankElement { faces, density: self.body.density, form });
            from = faces[1];
        }
    }

    /// The journal between two faces, if there is room for one; `at_web` says at which of its faces a web is.
    fn journal(
        &self,
        count: &mut usize,
        faces: [f64; 2],
        at_web: [bool; 2],
        elements: &mut Vec<CrankElement>,
    ) {
        if faces[1] - faces[0] <= TOUCH {
            return;
        }
        let journal = *count;
        *count += 1;
        let sizes = self.details.at_journal(&self.body, self.crankshaft, journal);
        let fillet = self.details.fillet_of_journal(self.crankshaft, journal);
        let bar = RoundBar {
            centre: Point::ORIGIN,
            diameter: sizes.journal_diameter,
            bore: sizes.journal_bore,
            fillets: at_web.map(|is_there| is_there.then_some(fillet)),
        };
        let form = CrankElementForm::Journal { journal, bar };
        elements.push(CrankElement { faces, density: self.body.density, form });
    }

    fn pin(&self, index: usize, throw: &Throw, faces: [f64; 2]) -> CrankElement {
        let sizes = self.details.at_pin(&self.body, index);
        let fillet = self.details.fillet_of_pin(index);
        let fillets = [2 * index, 2 * index + 1].map(|web| self.web_faces(web).map(|_| fillet));
        let bar =
            RoundBar { centre: pin(throw), diameter: sizes.pin_diameter, bore: sizes.pin_bore, fillets };
        let form = CrankElementForm::Pin { throw: index, bar, oil_hole: self.details.oil_hole_of(index) };
        CrankElement { faces, density: self.body.density, form }
    }

    fn web_faces(&self, web: usize) -> Option<[f64; 2]> {
        self.parts.web_faces(&self.shared, web)
    }

    fn web(&self, web: usize, elements: &mut Vec<CrankElement>) {
        let Some(faces) = self.web_faces(web) else { return };
        let sizes = self.details.at_web(&self.body, web);
        let throw = &self.parts.throws[web / 2];
        let form = match self.shared.iter().find(|shared| shared.webs().contains(&web)) {
            None => CrankElementForm::Web {
                web,
                shared_with: None,
                discs: [
                    Disc { centre: Point::ORIGIN, radius: sizes.web_radius },
                    Disc { centre: pin(throw), radius: sizes.pin_end_radius },
                ],
            },
            Some(shared) => {
                let webs = shared.webs();
                let disc = |throw: usize| Disc {
                    centre: pin(&self.parts.throws[throw]),
                    radius: sizes.pin_end_radius,
                };
                CrankElementForm::Web {
                    web,
                    shared_with: Some(if webs[0] == web { webs[1] } else { webs[0] }),
                    discs: [disc(shared.front), disc(shared.rear)],
                }
            }
        };
        elements.push(CrankElement { faces, density: self.body.density, form });
    }
}

fn end_bar(step: &EndStep) -> RoundBar {
    RoundBar { centre: Point::ORIGIN, diameter: step.diameter, bore: step.bore, fillets: [None; 2] }
}
