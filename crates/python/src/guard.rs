//! Computing without the interpreter's lock: no panic crosses, Ctrl-C is heard.

use crate::failure::Failure;
use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// Between two looks for Ctrl-C.
const PATIENCE: Duration = Duration::from_millis(50);

/// Computes without the lock. A panic becomes [`Failure::Internal`].
pub fn unlocked<T: Send>(
    py: Python<'_>,
    compute: impl FnOnce() -> Result<T, Failure> + Send,
) -> Result<T, Failure> {
    py.detach(|| caught(compute))
}

/// Computes on a thread of its own while this one waits for the answer or for Ctrl-C, upon which nobody waits for the answer any
/// more: searches and runs, which look at their [`Watch`], stop; what does not look goes on to its end and is thrown away.
pub fn waited_for<T: Send + 'static>(
    py: Python<'_>,
    compute: impl FnOnce(&Watch) -> Result<T, Failure> + Send + 'static,
) -> Result<T, Failure> {
    let (send, receive) = channel();
    // Only this thread looks, but while it does not hold the lock.
    let receive = Mutex::new(receive);
    let watch = Watch::default();
    let own = watch.clone();
    let spawned = std::thread::Builder::new().name("lanchester".into()).spawn(move || {
        // Nobody may wait any more.
        let _ = send.send(caught(|| compute(&own)));
    });
    spawned.map_err(|error| Failure::Internal(format!("no thread can be started: {error}")))?;
    loop {
        let look = || receive.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(PATIENCE);
        match py.detach(look) {
            Ok(answer) => return answer,
            Err(RecvTimeoutError::Timeout) => {
                if let Err(interrupt) = py.check_signals() {
                    watch.stop();
                    return Err(Failure::Interrupted(interrupt));
                }
            }
            Err(RecvTimeoutError::Disconnected) => {
                return Err(Failure::Internal("the computation ended without an answer".into()));
            }
        }
    }
}

/// Runs it; a panic becomes [`Failure::Internal`].
pub fn caught<T>(compute: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    catch_unwind(AssertUnwindSafe(compute)).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        Err(Failure::Internal(text.unwrap_or_else(|| "a panic without words".into())))
    })
}

/// Whether somebody still waits for a computation.
#[derive(Debug, Clone, Default)]
pub struct Watch(Arc<AtomicBool>);

impl Watch {
    /// Whether the computation goes on.
    pub fn goes_on(&self) -> bool {
        !self.0.load(Ordering::Relaxed)
    }

    fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}
