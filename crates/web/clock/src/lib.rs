//! Time within a browser, as the page tells it; elsewhere that of the system.

pub use std::time::Duration;
use std::ops::Sub;

/// A moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Instant(Duration);

impl Instant {
    /// This moment.
    pub fn now() -> Instant {
        Instant(since_start())
    }

    /// Time since this moment.
    pub fn elapsed(&self) -> Duration {
        self.duration_since_or_zero(Instant::now())
    }

    fn duration_since_or_zero(self, now: Instant) -> Duration {
        now.0.saturating_sub(self.0)
    }
}

impl Sub for Instant {
    type Output = Duration;

    fn sub(self, earlier: Instant) -> Duration {
        earlier.duration_since_or_zero(self)
    }
}

/// Time since the page was loaded.
#[cfg(target_arch = "wasm32")]
pub fn since_start() -> Duration {
    #[link(wasm_import_module = "page")]
    unsafe extern "C" {
        /// Milliseconds since the page was loaded.
        safe fn now() -> f64;
    }
    Duration::try_from_secs_f64(1e-3 * now()).unwrap_or_default()
}

/// Time since the first call.
#[cfg(not(target_arch = "wasm32"))]
pub fn since_start() -> Duration {
    static START: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
    START.elapsed()
}
