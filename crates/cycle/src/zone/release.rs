//! Heat release by Wiebe functions.

use lanchester_model::HeatRelease;

/// One Wiebe function, scaled to be complete at its end.
///
/// ```text
/// x(psi) = (1 - exp(-a y^(m + 1)))/(1 - exp(-a)),   y = (psi - start)/duration,   a = -ln(1 - completeness)     (28.14)
/// ```
/// Source: [Wiebe1970]; the scaling is ours.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wiebe {
    pub(crate) start: f64,
    pub(crate) end: f64,
    share: f64,
    exponent: f64,
    a: f64,
    scale: f64,
}

impl Wiebe {
    pub(crate) fn new(stage: &HeatRelease) -> Wiebe {
        Wiebe {
            start: stage.start,
            end: stage.start + stage.duration,
            share: stage.share,
            exponent: stage.exponent,
            a: -(-stage.completeness).ln_1p(),
            scale: stage.completeness.recip(),
        }
    }

    /// Share of the whole heat released per radian, within its limits.
    pub(crate) fn rate(&self, psi: f64) -> f64 {
        let duration = self.end - self.start;
        let y = ((psi - self.start) / duration).clamp(0.0, 1.0);
        let power = y.powf(self.exponent);
        self.share * self.scale * self.a * (self.exponent + 1.0) / duration
            * power
            * (-self.a * power * y).exp()
    }
}
