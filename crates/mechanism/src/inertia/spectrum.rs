//! Loads by order of plain rods in their exact motion: the kernel that runs over eight pistons at a time.
//!
//! The same equations as in [`crate::orders`] and [`crate::series`], in the phase of `x = phi - pi/2` in which the root's
//! coefficients are real; the series themselves are part of the kernel, nothing of the motion is prepared:
//!
//! ```text
//! a_n = n^2 ( W_n + i r/2 [n = 1] ) w_0^n                w_0 = e^{i (phi_0 - pi/2)}
//! T_n = -i n rate ( m W^2 (s'^2)_n + J W^2 (beta'^2)_n ) w_0^n
//! M_n = -T_n + 2 R a_n - n r J W^2 (V_{n-1} - V_{n+1}) w_0^n        V_n: coefficients of 1/W
//! ```

use crate::inertia::order_axis::OrderAxis;
use crate::inertia::orders::{Harmonic, empty};
use crate::train::drive::{Drive, Linkage};
use crate::train::linkage::Slider;
use crate::train::mechanism::{Mechanism, Piston};
use crate::train::series::RootFactors;
use lanchester_model::Ratio;
use lanchester_numerics::{ComplexLanes, Kernel, LANES, Lanes, Vectors, dispatch};
use lanchester_results::OrderLoads;
use num_complex::Complex64;

/// Most coefficients that the kernel's buffer holds; longer series take the scalar way.
const LONGEST: usize = 64;

/// Coefficients that the short buffers hold: of the factors `g`, `h`, and of the roots.
const USUAL: [usize; 2] = [24, 12];

/// Factors of the recurrences of `g` and `h` ([`crate::series`]) at step k, divided by `k + 1`.
struct Recurrence {
    first: [f64; LONGEST],
    second: [f64; LONGEST],
}

const ROOT: Recurrence = recurrence(true);
const INVERSE_ROOT: Recurrence = recurrence(false);

const fn recurrence(root: bool) -> Recurrence {
    let mut table = Recurrence { first: [0.0; LONGEST], second: [0.0; LONGEST] };
    let mut k = 0;
    while k < LONGEST {
        let at = k as f64;
        table.first[k] = if root { 0.5 - at } else { -0.5 - at } / (at + 1.0);
        table.second[k] = if root { at - 2.0 } else { at } / (at + 1.0);
        k += 1;
    }
    table
}

/// A piston with its rod and the terms that its series need.
type Member<'a> = (&'a Piston, &'a Slider, usize);

/// Up to eight pistons of one speed ratio.
#[derive(Debug, Clone, PartialEq)]
struct Batch {
    ratio: Ratio,
    /// Place of harmonic n among the orders.
    places: Vec<usize>,
    /// Terms of each sum.
    terms: usize,
    /// Whether any rod has more or less inertia than its two masses.
    has_inertia: bool,
    radius: Lanes,
    length: Lanes,
    offset: Lanes,
    /// `e^{i (phi_0 - pi/2)}`.
    phase: ComplexLanes,
    /// Each piston's factors of `Re a_n` and `Im a_n` in the eight sums of force and couple.
    masses: Vec<[Lanes; 2]>,
    /// `2 R`.
    roll: Lanes,
    /// `-rate m W^2`, `-rate J W^2`, `J W^2`.
    power: Lanes,
    spin_power: Lanes,
    spin: Lanes,
}

/// A mechanism prepared for its loads by order.
#[derive(Debug, Clone, PartialEq)]
pub struct OrderPlan {
    /// Orders with all that is constant: rotors, and pistons whose coefficients took a quadrature.
    constant: Vec<OrderLoads>,
    batches: Vec<Batch>,
}

impl Mechanism {
    /// Prepares the loads by order. Rotors are summed, and articulated rods and truncated motions have their
    /// coefficients computed here: these depend on the geometry alone.
    pub fn order_plan(&self) -> OrderPlan {
        let mut constant: Vec<OrderLoads> = self.axis.orders().map(empty).collect();
        for rotor in self.rotors.iter().filter(|r| self.axis.highest(r.ratio) >= 1) {
            rotor.harmonic().add_to(&mut constant[self.axis.place(rotor.ratio, 1)], rotor.ratio);
        }
        let mut groups: Vec<(Ratio, Vec<Member<'_>>)> = Vec::new();
        for piston in &self.pistons {
            let highest = self.axis.highest(piston.ratio);
            if let Drive::Exact(Linkage::Plain(slider)) = &piston.drive
                && RootFactors::of(slider).terms() + highest + 2 <= LONGEST
            {
                let entry = (piston, slider, RootFactors::of(slider).terms());
                match groups.iter_mut().find(|g| g.0 == piston.ratio && g.1.len() < LANES) {
                    Some((_, group)) => group.push(entry),
                    None => groups.push((piston.ratio, vec![entry])),
                }
                continue;
            }
            for (n, harmonic) in piston.harmonics(highest).iter().enumerate().skip(1) {
                harmonic.add_to(&mut constant[self.axis.place(piston.ratio, n)], piston.ratio);
            }
        }
        let batches = groups.iter().map(|(ratio, group)| Batch::of(*ratio, group, &self.axis)).collect();
        OrderPlan { constant, batches }
    }

    /// Loads by order, rising, from 0 to the highest order asked for.
    pub fn orders(&self) -> Vec<OrderLoads> {
        let mut orders = Vec::new();
        self.order_plan().orders_into(&mut orders);
        orders
    }
}

impl OrderPlan {
    /// Writes the loads by order; allocates only where `orders` is too small.
    pub fn orders_into(&self, orders: &mut Vec<OrderLoads>) {
        orders.clone_from(&self.constant);
        dispatch(OrderKernel { plan: self, orders });
    }

    /// As [`OrderPlan::orders_into`], with the instructions that the program was compiled for alone.
    pub fn orders_into_portable(&self, orders: &mut Vec<OrderLoads>) {
        orders.clone_from(&self.constant);
        Vectors::Portable.run(OrderKernel { plan: self, orders });
    }
}

/// Factors of `Re a` and `Im a` in `G a`, `G conj(a)`, `H a`, `H conj(a)`, real and imaginary parts in turn.
fn both_senses(piston: &Piston) -> [Lanes; 2] {
    let (g, h) = (piston.force, piston.couple);
    [
        Lanes([g.re, g.im, g.re, g.im, h.re, h.im, h.re, h.im]),
        Lanes([-g.im, g.re, g.im, -g.re, -h.im, h.re, h.im, -h.re]),
    ]
}

impl Batch {
    fn of(ratio: Ratio, group: &[Member<'_>], axis: &OrderAxis) -> Batch {
        let rate = ratio.value();
        // Empty lanes repeat the first piston's geometry without its masses.
        let geometry = |get: fn(&Slider) -> f64| {
            Lanes(std::array::from_fn(|i| get(group.get(i).unwrap_or(&group[0]).1)))
        };
        let masses = |get: &dyn Fn(&Piston) -> f64| {
            Lanes(std::array::from_fn(|i| group.get(i).map_or(0.0, |g| get(g.0))))
        };
        let complex = |get: &dyn Fn(&Piston) -> Complex64| ComplexLanes {
            re: masses(&|p| get(p).re),
            im: masses(&|p| get(p).im),
        };
        Batch {
            ratio,
            places: (0..=axis.highest(ratio))
                .map(|n| if n == 0 { 0 } else { axis.place(ratio, n) })
                .collect(),
            terms: group.iter().map(|g| g.2).fold(0, usize::max),
            has_inertia: group.iter().any(|g| g.0.inertia != 0.0),
            radius: geometry(|s| s.radius),
            length: geometry(|s| s.length),
            offset: geometry(|s| s.offset),
            phase: complex(&|p| -Complex64::I * Complex64::cis(p.phase)),
            masses: group.iter().map(|(piston, ..)| both_senses(piston)).collect(),
            roll: masses(&|p| 2.0 * p.roll),
            power: masses(&|p| -rate * p.mass),
            spin_power: masses(&|p| -rate * p.inertia),
            spin: masses(&|p| p.inertia),
        }
    }

    /// Coefficients 0..=highest of a root, from those of its factor `g`.
    #[inline(always)]
    fn root<const FMA: bool, const N: usize>(
        &self,
        recurrence: &Recurrence,
        difference: Lanes,
        product: Lanes,
        scale: Lanes,
        out: &mut [Lanes],
    ) {
        let highest = out.len() - 1;
        let mut g = [Lanes::ZERO; N];
        g[0] = Lanes::all(1.0);
        g[1] = difference * Lanes::all(recurrence.first[0]);
        for k in 1..self.terms + highest {
            let fresh = difference * Lanes::all(recurrence.first[k]);
            let old = product * Lanes::all(recurrence.second[k]);
            g[k + 1] = fresh.times_plus::<FMA>(g[k], old * g[k - 1]);
        }
        for n in 0..=highest {
            let mut sum = Lanes::ZERO;
            // Smallest terms first.
            for k in (0..self.terms).rev() {
                sum = g[k].times_plus::<FMA>(g[k + n], sum);
            }
            out[n] = sum * scale;
        }
    }

    #[inline(always)]
    fn add_to<const FMA: bool, const N: usize, const M: usize>(&self, orders: &mut [OrderLoads]) {
        let highest = self.places.len() - 1;
        let (r, l, e) = (self.radius, self.length, self.offset);
        let root = |x: Lanes| x.map(f64::sqrt);
        let (above, below) = (l + e, l - e);
        let sigma = [root((above - r) * (above + r)), root((below - r) * (below + r))];
        let (d1, d2) = (above + sigma[0], below + sigma[1]);
        let product = d1 * d2;
        let inverse = product.map(|x| 1.0 / x);
        let shift = (Lanes::all(4.0) * l * e).zip(sigma[0] + sigma[1], |a, b| a / b);
        let difference = r * inverse * (e + e + shift);
        let rho = [r * d2 * inverse, r * d1 * inverse];
        let scale = root(product) * Lanes::all(0.5);
        let between = rho[0] * rho[1];

        let mut w = [Lanes::ZERO; M];
        self.root::<FMA, N>(&ROOT, difference, between, scale, &mut w[..highest + 2]);
        let mut v = [Lanes::ZERO; M];
        if self.has_inertia {
            let scale = Lanes::all(4.0) * scale * inverse;
            self.root::<FMA, N>(&INVERSE_ROOT, difference, between, scale, &mut v[..highest + 2]);
        }

        let half = Lanes::all(0.5);
        let swing_scale = l.map(|l| -0.5 / l);
        let (mut near, mut far) = (sigma[0] * swing_scale, sigma[1] * swing_scale);
        let mut phase = self.phase;
        for n in 1..=highest {
            let order = n as f64;
            let first = if n == 1 { half * r } else { Lanes::ZERO };
            let travel = ComplexLanes { re: w[n], im: first };
            let square = Lanes::all(order * order);
            let along = travel.times::<FMA>(phase);
            let (re, im) = (along.re * square, along.im * square);

            near = near * rho[0];
            far = -(far * rho[1]);
            let swing = near + far;
            let pin = if n == 2 { half * r * r } else { Lanes::ZERO };
            let slope = Lanes::all(order - 1.0) * w[n - 1];
            let cross = r * w[n + 1].times_plus::<FMA>(Lanes::all(order + 1.0), slope);
            let energy = ComplexLanes {
                re: self.power * (l * l).times_plus::<FMA>(swing, pin) + self.spin_power * swing,
                im: -(self.power * cross),
            };
            let energy = energy.times::<FMA>(phase);
            let by_order = Lanes::all(order);
            let (torque_re, torque_im) = (-(energy.im * by_order), energy.re * by_order);
            let mut roll = [self.roll * re - torque_re, self.roll * im - torque_im];
            if self.has_inertia {
                let spin = self.spin * by_order * r * (v[n - 1] - v[n + 1]);
                roll = [spin.taken_from::<FMA>(phase.re, roll[0]), spin.taken_from::<FMA>(phase.im, roll[1])];
            }
            // Through memory: else the compiler takes the lanes apart all the way up to the series.
            let rows = std::hint::black_box([re, im, roll[0], roll[1], torque_re, torque_im]);
            let mut senses = Lanes::ZERO;
            for (i, [by_re, by_im]) in self.masses.iter().enumerate() {
                let turned = by_im.times_plus::<FMA>(Lanes::all(rows[1].0[i]), senses);
                senses = by_re.times_plus::<FMA>(Lanes::all(rows[0].0[i]), turned);
            }
            let pair = |at: usize| Complex64::new(senses.0[at], senses.0[at + 1]);
            let harmonic = Harmonic {
                force: [pair(0), pair(2)],
                couple: [pair(4), pair(6)],
                roll: 0.5 * Complex64::new(rows[2].sum(), rows[3].sum()),
                torque: 0.5 * Complex64::new(rows[4].sum(), rows[5].sum()),
            };
            harmonic.add_to(&mut orders[self.places[n]], self.ratio);
            phase = phase.times::<FMA>(self.phase);
        }
    }
}

/// The kernel with its data.
struct OrderKernel<'a> {
    plan: &'a OrderPlan,
    orders: &'a mut Vec<OrderLoads>,
}

impl Kernel for OrderKernel<'_> {
    #[inline(always)]
    fn run<const FMA: bool>(self) {
        for batch in &self.plan.batches {
            let highest = batch.places.len() - 1;
            // Short buffers are cheaper to clear, and long enough for usual rods to order 8.
            if batch.terms + highest + 2 <= USUAL[0] && highest + 2 <= USUAL[1] {
                batch.add_to::<FMA, { USUAL[0] }, { USUAL[1] }>(self.orders);
            } else {
                batch.add_to::<FMA, LONGEST, LONGEST>(self.orders);
            }
        }
    }
}
