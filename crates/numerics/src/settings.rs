//! Tolerances and limits of a run.

/// Tolerances and limits of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// Relative tolerance of each component.
    pub relative: Vec<f64>,
    /// Absolute tolerance of each component, in its unit.
    pub absolute: Vec<f64>,
    /// First step; chosen from the derivatives where absent.
    pub first_step: Option<f64>,
    /// Longest step.
    pub longest_step: f64,
    /// Share of the step whose error would be the tolerance that [`crate::Dop853`] takes next; a smaller one saves rejected steps.
    pub safety: f64,
    /// Largest step of [`crate::Dop853`] over the one before; a small one saves rejected steps where the estimate of the error passes through zero.
    pub largest_growth: f64,
    /// Places where a step must end: kinks of the system, in any order. Those outside the run are passed over.
    pub stops: Vec<f64>,
    /// Largest number of evaluations of `f`, over all runs of one integrator.
    pub most_evaluations: u64,
    /// Largest distance of a located event from its true place on the interpolant (of t, absolute).
    pub event_tolerance: f64,
    /// Whether [`crate::Dop853`] ends with [`crate::Outcome::Stiff`] where it measures stiffness.
    pub stiffness_test: bool,
    /// Whether steps carry an interpolant; needed for samples between steps and for events.
    pub dense: bool,
    /// Whether [`crate::Dop853`] looks for events on the cubic between the ends of a step first, and makes its interpolant only where an
    /// event function comes near to zero there.
    pub glance: bool,
    /// Where samples will be taken; [`crate::Dop853`] makes no interpolant for steps without any. `None`: anywhere.
    pub samples: Option<SampleGrid>,
}

/// Equally spaced places of samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleGrid {
    /// One of them.
    pub origin: f64,
    /// Their distance, above 0.
    pub spacing: f64,
}

impl SampleGrid {
    /// Whether one lies within a step, or so close to its ends that rounding decides.
    pub(crate) fn within(self, from: f64, to: f64) -> bool {
        let [low, high] = [from.min(to), from.max(to)].map(|place| (place - self.origin) / self.spacing);
        (low - 1e-6).ceil() <= high + 1e-6
    }
}

impl Settings {
    /// The same relative and absolute tolerance for each of `dimension` components, no other limit than ten million evaluations.
    pub fn uniform(dimension: usize, tolerance: f64) -> Settings {
        Settings {
            relative: vec![tolerance; dimension],
            absolute: vec![tolerance; dimension],
            first_step: None,
            longest_step: f64::INFINITY,
            safety: 0.9,
            largest_growth: 6.0,
            stops: Vec::new(),
            most_evaluations: 10_000_000,
            event_tolerance: 1e-12,
            stiffness_test: false,
            dense: true,
            glance: false,
            samples: None,
        }
    }

    /// Size against which an error of component `i` is measured.
    pub(crate) fn scale(&self, i: usize, size: f64) -> f64 {
        let relative = self.relative.get(i).copied().unwrap_or(1e-9).max(4.0 * f64::EPSILON);
        let absolute = self.absolute.get(i).copied().unwrap_or(1e-9);
        (absolute + relative * size).max(f64::MIN_POSITIVE.sqrt())
    }
}
