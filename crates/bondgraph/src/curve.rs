//! Tables as curves: cubics between places that rise.

use crate::unit::Unit;
use serde::Serialize;

/// Jump of a value or of a slope over one unit of the argument, as a share of the curve's range, that counts as a kink.
const KINK: f64 = 1e-6;

/// A function given by points: cubics in pieces, repeated where it has a period, otherwise constant beyond its ends.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Curve {
    /// Start of every piece, rising, and the end of the last.
    places: Vec<f64>,
    /// Coefficients of rising powers of the distance from the start of the piece.
    pieces: Vec<[f64; 4]>,
    /// Length after which it repeats: that from the first start to the last end.
    periodic: bool,
    /// Places among `places` where value or slope jumps.
    kinks: Vec<f64>,
    /// Units of argument and value.
    #[serde(skip)]
    units: [Unit; 2],
}

/// Pieces beside a guess that are looked at first.
const NEAR: usize = 4;

impl Curve {
    /// A curve of cubics: `start, [c_0, c_1, c_2, c_3]` of each piece, whose value is `SUM c_k (x - start)^k`, and the end of the last.
    ///
    /// None where there is no piece, the starts do not rise or a number is not finite.
    pub fn cubics(pieces: &[(f64, [f64; 4])], end: f64, periodic: bool, units: [Unit; 2]) -> Option<Curve> {
        let mut places: Vec<f64> = pieces.iter().map(|(start, _)| *start).collect();
        places.push(end);
        let rises = places.windows(2).all(|pair| pair[0] < pair[1]);
        let finite = pieces.iter().all(|(_, c)| c.iter().all(|c| c.is_finite()));
        if pieces.is_empty() || !rises || !finite || !end.is_finite() || !places[0].is_finite() {
            return None;
        }
        let pieces: Vec<[f64; 4]> = pieces.iter().map(|(_, coefficients)| *coefficients).collect();
        let mut curve = Curve { places, pieces, periodic, kinks: Vec::new(), units };
        curve.kinks = curve.find_kinks();
        Some(curve)
    }

    /// Straight lines through points `[x, y]` whose x rise; none where there are fewer than two.
    pub fn straight(points: &[[f64; 2]], periodic: bool, units: [Unit; 2]) -> Option<Curve> {
        let pieces: Vec<(f64, [f64; 4])> = points
            .windows(2)
            .map(|pair| {
                let slope = (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]);
                (pair[0][0], [pair[0][1], slope, 0.0, 0.0])
            })
            .collect();
        Curve::cubics(&pieces, points.last()?[0], periodic, units)
    }

    /// Units of argument and value.
    pub fn units(&self) -> [Unit; 2] {
        self.units
    }

    /// Start of every piece with its coefficients, and the end of the last.
    pub fn pieces(&self) -> (Vec<(f64, [f64; 4])>, f64) {
        let starts = self.places.iter().copied().zip(self.pieces.iter().copied());
        (starts.collect(), self.places[self.pieces.len()])
    }

    /// Whether it repeats.
    pub fn is_periodic(&self) -> bool {
        self.periodic
    }

    fn period(&self) -> f64 {
        self.places[self.pieces.len()] - self.places[0]
    }

    /// Places where value or slope jumps; of a curve that ends also its ends, behind which it is constant.
    fn find_kinks(&self) -> Vec<f64> {
        let count = self.pieces.len();
        let end = |piece: usize| {
            let (h, [a, b, c, d]) = (self.places[piece + 1] - self.places[piece], self.pieces[piece]);
            [a + h * (b + h * (c + h * d)), b + h * (2.0 * c + 3.0 * h * d)]
        };
        let values = (0..count).flat_map(|piece| [self.pieces[piece][0], end(piece)[0]]);
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), value| (l.min(value), h.max(value)));
        let least = KINK * (high - low);
        let before = |piece: usize| match (piece, self.periodic) {
            (0, true) => end(count - 1),
            (0, false) => [self.pieces[0][0], 0.0],
            _ => end(piece - 1),
        };
        let differs = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() > least || (a[1] - b[1]).abs() > least;
        let mut kinks: Vec<f64> = (0..count)
            .filter(|piece| differs(before(*piece), [self.pieces[*piece][0], self.pieces[*piece][1]]))
            .map(|piece| self.places[piece])
            .collect();
        if !self.periodic && end(count - 1)[1].abs() > least {
            kinks.push(self.places[count]);
        }
        kinks
    }

    /// Its value, or that of a derivative.
    pub fn at(&self, x: f64, derivative: u8) -> f64 {
        self.within(x, [f64::NEG_INFINITY, f64::INFINITY], derivative)
    }

    /// The same by the piece that holds within a window, continued beyond it.
    pub(crate) fn within(&self, x: f64, window: [f64; 2], derivative: u8) -> f64 {
        let margin = 1e-9 * (window[1] - window[0]);
        let inside = if margin.is_finite() { x.clamp(window[0] + margin, window[1] - margin) } else { x };
        let shift = if self.periodic {
            self.period() * ((inside - self.places[0]) / self.period()).floor()
        } else {
            0.0
        };
        let (inside, x) = (inside - shift, x - shift);
        let count = self.pieces.len();
        if !self.periodic && (inside < self.places[0] || inside > self.places[count]) {
            let edge = if inside < self.places[0] { 0 } else { count - 1 };
            let h = if edge == 0 && inside < self.places[0] {
                0.0
            } else {
                self.places[count] - self.places[edge]
            };
            let [a, b, c, d] = self.pieces[edge];
            return if derivative == 0 { a + h * (b + h * (c + h * d)) } else { 0.0 };
        }
        let piece = self.piece(inside);
        let h = x - self.places[piece];
        let [a, b, c, d] = self.pieces[piece];
        match derivative {
            0 => a + h * (b + h * (c + h * d)),
            1 => b + h * (2.0 * c + 3.0 * h * d),
            2 => 2.0 * c + 6.0 * h * d,
            3 => 6.0 * d,
            _ => 0.0,
        }
    }

    /// The piece that holds a place between both ends: pieces are often of nearly one length.
    fn piece(&self, x: f64) -> usize {
        let count = self.pieces.len();
        let guess = ((x - self.places[0]) / self.period() * count as f64) as usize;
        let low = guess.saturating_sub(NEAR).min(count - 1);
        let high = (guess + NEAR).min(count);
        let near = low + self.places[low..high].partition_point(|place| *place <= x);
        if near > low && (near < high || high == count) {
            return near - 1;
        }
        self.places[..count].partition_point(|place| *place <= x).saturating_sub(1)
    }

    /// The window between two neighbouring kinks that begins at or before `x`.
    pub(crate) fn window(&self, x: f64) -> [f64; 2] {
        let Some(first) = self.kinks.first() else { return [f64::NEG_INFINITY, f64::INFINITY] };
        let count = self.kinks.len();
        if !self.periodic {
            let after = self.kinks.partition_point(|kink| *kink <= x);
            let low = after.checked_sub(1).map_or(f64::NEG_INFINITY, |before| self.kinks[before]);
            return [low, self.kinks.get(after).copied().unwrap_or(f64::INFINITY)];
        }
        let period = self.period();
        let turns = ((x - first) / period).floor();
        let own = x - turns * period;
        let after = self.kinks.partition_point(|kink| *kink <= own);
        let kink = |index: usize| self.kinks[index % count] + period * (turns + (index / count) as f64);
        match after {
            // Rounding may leave x a hair before the first kink of its turn.
            0 => [self.kinks[count - 1] + period * (turns - 1.0), kink(0)],
            _ => [kink(after - 1), kink(after)],
        }
    }

    /// The window behind the upper end of a window, or before the lower.
    pub(crate) fn neighbour(&self, window: [f64; 2], upwards: bool) -> [f64; 2] {
        let least = 1e-9
            * if self.periodic { self.period() } else { self.places[self.pieces.len()] - self.places[0] };
        if upwards { self.window(window[1] + least) } else { self.window(window[0] - least) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn saw() -> Curve {
        let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]];
        Curve::straight(&points, true, [Unit::NONE, Unit::NONE]).expect("rising points")
    }

    #[test]
    fn a_periodic_curve_repeats_and_knows_its_kinks() {
        let curve = saw();
        assert_eq!([curve.at(0.5, 0), curve.at(3.5, 0), curve.at(-1.0, 0)], [1.0, 1.0, 1.0]);
        assert_eq!([curve.at(0.5, 1), curve.at(2.0, 1), curve.at(2.0, 2)], [2.0, -1.0, 0.0]);
        assert_eq!(curve.window(0.5), [0.0, 1.0]);
        assert_eq!(curve.window(-0.5), [-2.0, 0.0]);
        assert_eq!(curve.neighbour([1.0, 3.0], true), [3.0, 4.0]);
        assert_eq!(curve.neighbour([0.0, 1.0], false), [-2.0, 0.0]);
    }

    #[test]
    fn a_window_continues_its_own_piece() {
        let curve = saw();
        assert_eq!(curve.within(1.25, [0.0, 1.0], 0), 2.5);
        assert_eq!(curve.within(-0.25, [0.0, 1.0], 0), -0.5);
    }

    #[test]
    fn a_curve_that_ends_is_constant_beyond() {
        let curve = Curve::straight(&[[0.0, 1.0], [1.0, 3.0]], false, [Unit::NONE, Unit::NONE]);
        let curve = curve.expect("two points");
        assert_eq!([curve.at(-1.0, 0), curve.at(0.5, 0), curve.at(2.0, 0)], [1.0, 2.0, 3.0]);
        assert_eq!([curve.at(-1.0, 1), curve.at(2.0, 1)], [0.0, 0.0]);
        assert_eq!(curve.window(0.5), [0.0, 1.0]);
        assert_eq!(curve.window(1.5), [1.0, f64::INFINITY]);
    }

    #[test]
    fn smooth_pieces_have_no_kink() {
        let halves = [(0.0, [0.0, 0.0, 1.0, 0.0]), (1.0, [1.0, 2.0, -1.0, 0.0])];
        let curve = Curve::cubics(&halves, 2.0, false, [Unit::NONE, Unit::NONE]).expect("two pieces");
        assert_eq!(curve.window(1.0), [f64::NEG_INFINITY, f64::INFINITY]);
        assert!(Curve::straight(&[[1.0, 0.0], [1.0, 1.0]], false, [Unit::NONE, Unit::NONE]).is_none());
    }
}
