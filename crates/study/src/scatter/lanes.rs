//! Eight samples at a time, in plain code that compilers turn into vector instructions.

/// Samples in a [`Lanes`].
pub(crate) const WIDTH: usize = 8;

/// One number of eight samples.
pub(crate) type Lanes = [f64; WIDTH];

/// All zero.
pub(crate) const ZERO: Lanes = [0.0; WIDTH];

/// `f` of every lane.
#[inline(always)]
pub(crate) fn map(f: impl Fn(usize) -> f64) -> Lanes {
    let mut out = ZERO;
    for i in 0..WIDTH {
        out[i] = f(i);
    }
    out
}

/// Complex numbers of eight samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ComplexLanes {
    pub re: Lanes,
    pub im: Lanes,
}

impl ComplexLanes {
    pub const ZERO: ComplexLanes = ComplexLanes { re: ZERO, im: ZERO };

    /// Product.
    #[inline(always)]
    pub fn times(&self, other: &ComplexLanes) -> ComplexLanes {
        ComplexLanes {
            re: map(|i| self.re[i] * other.re[i] - self.im[i] * other.im[i]),
            im: map(|i| self.re[i] * other.im[i] + self.im[i] * other.re[i]),
        }
    }

    /// Product with the conjugate of `other`.
    #[inline(always)]
    pub fn times_conj(&self, other: &ComplexLanes) -> ComplexLanes {
        ComplexLanes {
            re: map(|i| self.re[i] * other.re[i] + self.im[i] * other.im[i]),
            im: map(|i| self.im[i] * other.re[i] - self.re[i] * other.im[i]),
        }
    }

    /// `e^{i (angle + deviation)}`, `angle` given as its cosine and sine.
    #[inline(always)]
    pub fn turned(cos: f64, sin: f64, deviation: &Lanes) -> ComplexLanes {
        // The series errs by less than 1e-16 up to here.
        const SMALL: f64 = 0.02;
        if deviation.iter().all(|d| d.abs() < SMALL) {
            let c = map(|i| {
                let square = deviation[i] * deviation[i];
                1.0 - square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0)))
            });
            let s = map(|i| {
                let square = deviation[i] * deviation[i];
                deviation[i] * (1.0 - square * (1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0))))
            });
            return ComplexLanes {
                re: map(|i| cos * c[i] - sin * s[i]),
                im: map(|i| sin * c[i] + cos * s[i]),
            };
        }
        ComplexLanes {
            re: map(|i| cos * deviation[i].cos() - sin * deviation[i].sin()),
            im: map(|i| sin * deviation[i].cos() + cos * deviation[i].sin()),
        }
    }
}
