//! The plain webs of a crankshaft that is a body: each beside its own crankpin, or one between the pins of two throws.

use crate::crank::body::CrankBody;
use crate::crank::details::CrankDetails;
use crate::engine_parts::{EngineParts, Throw};
use lanchester_shape::{GeometryError, Outline, Point};
use std::f64::consts::PI;

/// Planes closer than this [m] are one.
pub const TOUCH: f64 = 1e-9;

/// A web without counterweights, in the frame of its crankshaft at angle zero.
#[derive(Debug, Clone, PartialEq)]
pub struct PlainWeb {
    /// Its outline, about the crank axis.
    pub outline: Outline,
    /// Its faces along the crank [m], from the origin.
    pub faces: [f64; 2],
}

/// One web between the pins of two throws next to each other, as a crankshaft with split pins has it (the flying web) or a boxer.
///
/// The web distances say so: the rear web of the front throw reaches the plane of the front web of the rear throw, or lies beyond it.
/// It fills what is between the two pins, and counts as the rear web of the one throw and the front web of the other,
/// half of it each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SharedWeb {
    /// Index of the throw before it.
    pub front: usize,
    /// Index of the throw behind it.
    pub rear: usize,
}

impl SharedWeb {
    /// All of a crankshaft's or of several, along z; throws without a web distance share none.
    pub fn all(throws: &[Throw]) -> Vec<SharedWeb> {
        let mut rising: Vec<usize> = (0..throws.len()).filter(|&k| throws[k].webs.is_some()).collect();
        rising.sort_by(|&a, &b| {
            throws[a].crankshaft.cmp(&throws[b].crankshaft).then(throws[a].z.total_cmp(&throws[b].z))
        });
        let meet = |[front, rear]: [usize; 2]| {
            let ([_, end], [start, _]) = (throws[front].webs?, throws[rear].webs?);
            (throws[front].crankshaft == throws[rear].crankshaft && end >= start - TOUCH)
                .then_some(SharedWeb { front, rear })
        };
        rising.windows(2).filter_map(|pair| meet([pair[0], pair[1]])).collect()
    }

    /// The one that counts as web `web`, counted through all throws.
    pub fn of(throws: &[Throw], web: usize) -> Option<SharedWeb> {
        SharedWeb::all(throws).into_iter().find(|shared| shared.webs().contains(&web))
    }

    /// The two webs that it counts as, counted through all throws.
    pub fn webs(self) -> [usize; 2] {
        [2 * self.front + 1, 2 * self.rear]
    }

    /// Where the pin before it ends and the one behind it begins [m]; nothing is between pins that touch.
    fn faces(self, throws: &[Throw], body: &CrankBody, details: &CrankDetails) -> Option<[f64; 2]> {
        let ([_, end], [start, _]) = (throws[self.front].webs?, throws[self.rear].webs?);
        let [front, rear] = self.webs().map(|web| details.at_web(body, web).web_thickness);
        let faces = [end - front / 2.0, start + rear / 2.0];
        (faces[1] - faces[0] > TOUCH).then_some(faces)
    }

    fn outline(self, throws: &[Throw], body: &CrankBody) -> Result<Outline, GeometryError> {
        let [front, rear] = [self.front, self.rear].map(|index| pin(&throws[index]));
        body.shared_web(front, rear)
    }
}

/// Where the pin of a throw stands at angle zero of its crankshaft.
pub fn pin(throw: &Throw) -> Point {
    Point::polar(throw.radius, throw.angle)
}

impl EngineParts {
    /// Webs between the pins of two throws, crankshaft by crankshaft along z.
    pub fn shared_webs(&self) -> Vec<SharedWeb> {
        SharedWeb::all(&self.throws)
    }

    /// Sizes of the crank's body at web `web`, counted through all throws: the uniform ones or its own.
    pub fn body_at_web(&self, web: usize) -> Option<CrankBody> {
        let body = self.crank_body.as_ref()?;
        Some(self.crank_details.as_ref().map_or(*body, |details| details.at_web(body, web)))
    }

    /// Faces of web `web` along the crank [m], with the engine's [`SharedWeb`]s; `None` where the engine says nothing of its webs, or where
    /// two pins touch without a web.
    pub(crate) fn web_faces(&self, shared: &[SharedWeb], web: usize) -> Option<[f64; 2]> {
        let body = self.body_at_web(web)?;
        let planes = self.throws.get(web / 2)?.webs?;
        let Some(shared) = shared.iter().find(|shared| shared.webs().contains(&web)) else {
            let (plane, half) = (planes[web % 2], body.web_thickness / 2.0);
            return Some([plane - half, plane + half]);
        };
        let uniform = CrankDetails::default();
        let details = self.crank_details.as_ref().unwrap_or(&uniform);
        let [from, to] = shared.faces(&self.throws, self.crank_body.as_ref()?, details)?;
        let middle = (from + to) / 2.0;
        Some(if web % 2 == 1 { [from, middle] } else { [middle, to] })
    }

    /// The plain web `web`, counted through all throws: 0 is the front web of throw 1, 1 its rear one. Of a [`SharedWeb`] it is the half
    /// that belongs to its throw. `None` where the engine says nothing of its webs, or where two pins touch without a web.
    ///
    /// # Errors
    /// As [`CrankBody::web`].
    pub fn plain_web(&self, web: usize) -> Result<Option<PlainWeb>, GeometryError> {
        let shared = self.shared_webs();
        let (Some(body), Some(faces)) = (self.body_at_web(web), self.web_faces(&shared, web)) else {
            return Ok(None);
        };
        let throw = &self.throws[web / 2];
        let outline = match shared.iter().find(|shared| shared.webs().contains(&web)) {
            None => body.web(throw.radius)?.turned(throw.angle + PI),
            Some(shared) => shared.outline(&self.throws, &body)?,
        };
        Ok(Some(PlainWeb { outline, faces }))
    }
}

/// Unbalance of the crank itself along a throw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThrowUnbalance {
    /// How large [kg m].
    pub unbalance: f64,
    /// How far behind the plane of the throw it acts [m].
    pub offset: f64,
}

/// Unbalances of all throws of a body: of each the pin, its own plain webs, and half of the webs that it shares.
///
/// ```text
/// U   = rho (pi/4 (d^2 - b^2) L r - SUM over own webs of t INTEGRAL x dA + SUM over shared webs of (s/2) A r)
/// z_U = SUM of the same times their planes, over U                                      (book, eqs. 22.71, 22.72)
/// ```
/// `L` length of the pin (web distance less web thickness where both webs are alike), `t` thickness of a web, `s` and `A` thickness and area
/// of a shared web, whose centre lies in the middle between both pins: half of it at each pin is the same.
///
/// # Errors
/// As [`CrankBody::web`].
pub fn throw_unbalances(
    body: &CrankBody,
    details: &CrankDetails,
    throws: &[Throw],
) -> Result<Vec<ThrowUnbalance>, GeometryError> {
    let shared = SharedWeb::all(throws);
    let of = |(index, throw): (usize, &Throw)| {
        let Some(planes) = throw.webs else { return Ok(ThrowUnbalance { unbalance: 0.0, offset: 0.0 }) };
        let sizes = details.at_pin(body, index);
        let webs = [2 * index, 2 * index + 1].map(|web| details.at_web(body, web));
        let section = PI / 4.0 * (sizes.pin_diameter.powi(2) - sizes.pin_bore.powi(2));
        let thickness = (webs[0].web_thickness + webs[1].web_thickness) / 2.0;
        let mut unbalance = section * (planes[1] - planes[0] - thickness) * throw.radius;
        let is_off = ((planes[0] + planes[1]) / 2.0 - throw.z).abs() > TOUCH;
        let has_own_webs = is_off || details.webs.iter().any(|own| own.web / 2 == index);
        // Without webs of its own the pin stands in the plane of the throw, whatever rounding says.
        let mut couple = if has_own_webs {
            let [front, rear] =
                [planes[0] + webs[0].web_thickness / 2.0, planes[1] - webs[1].web_thickness / 2.0];
            unbalance * ((front + rear) / 2.0 - throw.z)
        } else {
            0.0
        };
        for (side, plane) in planes.into_iter().enumerate() {
            let is_this = |shared: &&SharedWeb| shared.webs().contains(&(2 * index + side));
            let web = &webs[side];
            let (own, plane) = match shared.iter().find(is_this) {
                None => (-web.web_thickness * web.web(throw.radius)?.moments().first.x, plane),
                Some(shared) => match shared.faces(throws, body, details) {
                    None => continue,
                    Some([from, to]) => {
                        let area = shared.outline(throws, web)?.moments().area;
                        ((to - from) / 2.0 * area * throw.radius, (from + to) / 2.0)
                    }
                },
            };
            unbalance += own;
            couple += own * (plane - throw.z);
        }
        let is_even =
            !has_own_webs && shared.iter().all(|shared| shared.front != index && shared.rear != index);
        let offset = if is_even { 0.0 } else { couple / unbalance };
        Ok(ThrowUnbalance { unbalance: body.density * unbalance, offset })
    };
    throws.iter().enumerate().map(of).collect()
}
