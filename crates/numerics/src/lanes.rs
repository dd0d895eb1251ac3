//! Eight numbers at a time, in plain code that compilers turn into vector instructions.

/// Numbers in a [`Lanes`]: one register of AVX-512, two of AVX2, four of SSE2 or NEON.
pub const LANES: usize = 8;

/// Eight numbers that go through the same arithmetic.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Lanes(pub [f64; LANES]);

impl Lanes {
    /// All zero.
    pub const ZERO: Lanes = Lanes([0.0; LANES]);

    /// The same number in all lanes.
    #[inline(always)]
    pub fn all(value: f64) -> Lanes {
        Lanes([value; LANES])
    }

    /// `f` of the number of every lane.
    #[inline(always)]
    pub fn each(f: impl Fn(usize) -> f64) -> Lanes {
        let mut out = [0.0; LANES];
        for i in 0..LANES {
            out[i] = f(i);
        }
        Lanes(out)
    }

    /// `f` of every lane.
    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Lanes {
        let mut out = [0.0; LANES];
        for i in 0..LANES {
            out[i] = f(self.0[i]);
        }
        Lanes(out)
    }

    /// `f` of every pair of lanes.
    #[inline(always)]
    pub fn zip(self, other: Lanes, f: impl Fn(f64, f64) -> f64) -> Lanes {
        let mut out = [0.0; LANES];
        for i in 0..LANES {
            out[i] = f(self.0[i], other.0[i]);
        }
        Lanes(out)
    }

    /// `self * factor + term`, in one rounding where the machine can (`FMA`), else in two.
    #[inline(always)]
    pub fn times_plus<const FMA: bool>(self, factor: Lanes, term: Lanes) -> Lanes {
        let mut out = [0.0; LANES];
        for i in 0..LANES {
            out[i] = if FMA {
                self.0[i].mul_add(factor.0[i], term.0[i])
            } else {
                self.0[i] * factor.0[i] + term.0[i]
            };
        }
        Lanes(out)
    }

    /// `term - self * factor`, rounded as [`Lanes::times_plus`].
    #[inline(always)]
    pub fn taken_from<const FMA: bool>(self, factor: Lanes, term: Lanes) -> Lanes {
        (-self).times_plus::<FMA>(factor, term)
    }

    /// `1 / sqrt` of every lane, each of the two operations correctly rounded.
    #[inline(always)]
    pub fn inverse_root(self) -> Lanes {
        self.map(|x| 1.0 / x.sqrt())
    }

    /// Sum of all lanes.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        let x = self.0;
        ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]))
    }
}

impl std::ops::Index<usize> for Lanes {
    type Output = f64;
    #[inline(always)]
    fn index(&self, lane: usize) -> &f64 {
        &self.0[lane]
    }
}

impl std::ops::IndexMut<usize> for Lanes {
    #[inline(always)]
    fn index_mut(&mut self, lane: usize) -> &mut f64 {
        &mut self.0[lane]
    }
}

impl std::ops::Add for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn add(self, other: Lanes) -> Lanes {
        self.zip(other, |a, b| a + b)
    }
}

impl std::ops::Sub for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn sub(self, other: Lanes) -> Lanes {
        self.zip(other, |a, b| a - b)
    }
}

impl std::ops::Mul for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn mul(self, other: Lanes) -> Lanes {
        self.zip(other, |a, b| a * b)
    }
}

impl std::ops::Neg for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn neg(self) -> Lanes {
        self.map(|a| -a)
    }
}

/// Complex numbers, eight at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComplexLanes {
    /// Real parts.
    pub re: Lanes,
    /// Imaginary parts.
    pub im: Lanes,
}

impl ComplexLanes {
    /// All zero.
    pub const ZERO: ComplexLanes = ComplexLanes { re: Lanes::ZERO, im: Lanes::ZERO };

    /// Product with the conjugate of `other`.
    #[inline(always)]
    pub fn times_conj<const FMA: bool>(self, other: ComplexLanes) -> ComplexLanes {
        ComplexLanes {
            re: self.im.times_plus::<FMA>(other.im, self.re * other.re),
            im: self.re.taken_from::<FMA>(other.im, self.im * other.re),
        }
    }

    /// Product.
    #[inline(always)]
    pub fn times<const FMA: bool>(self, other: ComplexLanes) -> ComplexLanes {
        ComplexLanes {
            re: self.im.taken_from::<FMA>(other.im, self.re * other.re),
            im: self.im.times_plus::<FMA>(other.re, self.re * other.im),
        }
    }
}
