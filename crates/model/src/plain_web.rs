//! The plain webs of a crankshaft that is a body: each beside its own crankpin, or one between the pins of two throws.

use crate::crank_body::CrankBody;
use crate::engine::{EngineParts, Throw};
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
    fn faces(self, throws: &[Throw], body: &CrankBody) -> Option<[f64; 2]> {
        let ([_, end], [start, _]) = (throws[self.front].webs?, throws[self.rear].webs?);
        let faces = [end - body.web_thickness / 2.0, start + body.web_thickness / 2.0];
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

    /// The plain web `web`, counted through all throws: 0 is the front web of throw 1, 1 its rear one. Of a [`SharedWeb`] it is the half
    /// that belongs to its throw. `None` where the engine says nothing of its webs, or where two pins touch without a web.
    ///
    /// # Errors
    /// As [`CrankBody::web`].
    pub fn plain_web(&self, web: usize) -> Result<Option<PlainWeb>, GeometryError> {
        let (Some(body), Some(throw)) = (&self.crank_body, self.throws.get(web / 2)) else { return Ok(None) };
        let Some(planes) = throw.webs else { return Ok(None) };
        let Some(shared) = SharedWeb::of(&self.throws, web) else {
            let (plane, half) = (planes[web % 2], body.web_thickness / 2.0);
            let outline = body.web(throw.radius)?.turned(throw.angle + PI);
            return Ok(Some(PlainWeb { outline, faces: [plane - half, plane + half] }));
        };
        let Some([from, to]) = shared.faces(&self.throws, body) else { return Ok(None) };
        let middle = (from + to) / 2.0;
        let faces = if web % 2 == 1 { [from, middle] } else { [middle, to] };
        Ok(Some(PlainWeb { outline: shared.outline(&self.throws, body)?, faces }))
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
/// U   = rho (pi/4 (d^2 - b^2) (D - t) r - SUM over own webs of t INTEGRAL x dA + SUM over shared webs of (s/2) A r)
/// z_U = SUM of the same times their planes, over U                                      (book, eqs. 22.71, 22.72)
/// ```
/// `D` web distance, `t` web thickness, `s` and `A` thickness and area of a shared web, whose centre lies in the middle between both pins: half of it at
/// each pin is the same.
///
/// # Errors
/// As [`CrankBody::web`].
pub fn throw_unbalances(body: &CrankBody, throws: &[Throw]) -> Result<Vec<ThrowUnbalance>, GeometryError> {
    let section = PI / 4.0 * (body.pin_diameter.powi(2) - body.pin_bore.powi(2));
    let shared = SharedWeb::all(throws);
    let of = |(index, throw): (usize, &Throw)| {
        let Some(planes) = throw.webs else { return Ok(ThrowUnbalance { unbalance: 0.0, offset: 0.0 }) };
        let pin_length = planes[1] - planes[0] - body.web_thickness;
        let mut unbalance = section * pin_length * throw.radius;
        let mut couple = 0.0;
        for (side, plane) in planes.into_iter().enumerate() {
            let is_this = |shared: &&SharedWeb| shared.webs().contains(&(2 * index + side));
            let (own, plane) = match shared.iter().find(is_this) {
                None => (-body.web_thickness * body.web(throw.radius)?.moments().first.x, plane),
                Some(shared) => match shared.faces(throws, body) {
                    None => continue,
                    Some([from, to]) => {
                        let area = shared.outline(throws, body)?.moments().area;
                        ((to - from) / 2.0 * area * throw.radius, (from + to) / 2.0)
                    }
                },
            };
            unbalance += own;
            couple += own * (plane - throw.z);
        }
        let is_even = shared.iter().all(|shared| shared.front != index && shared.rear != index);
        let offset = if is_even { 0.0 } else { couple / unbalance };
        Ok(ThrowUnbalance { unbalance: body.density * unbalance, offset })
    };
    throws.iter().enumerate().map(of).collect()
}
