//! Computing without the interpreter's lock: no panic crosses, Ctrl-C is heard, and a forked process has threads of its own.

use crate::failure::Failure;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::Duration;

/// Between two looks for Ctrl-C.
const PATIENCE: Duration = Duration::from_millis(50);

/// Computes without the lock. A panic becomes [`Failure::Internal`].
pub fn unlocked<T: Send>(
    py: Python<'_>,
    compute: impl FnOnce() -> Result<T, Failure> + Send,
) -> Result<T, Failure> {
    py.detach(|| caught(|| in_own_process(compute)))
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
        let _ = send.send(caught(|| in_own_process(|| compute(&own))));
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

/// The process that imported this module.
static FIRST_PROCESS: OnceLock<u32> = OnceLock::new();

/// The threads of a process that was forked from it.
static FORKED_POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Remembers which process imports the module.
pub fn imported() {
    FIRST_PROCESS.get_or_init(std::process::id);
}

/// Computes with threads that are there: a child made by a fork has none of its parent's, and would wait for them without end.
fn in_own_process<T: Send>(compute: impl FnOnce() -> Result<T, Failure> + Send) -> Result<T, Failure> {
    let own = std::process::id();
    if *FIRST_PROCESS.get_or_init(std::process::id) == own {
        return compute();
    }
    let pool = {
        let mut forked = FORKED_POOL.lock().unwrap_or_else(PoisonError::into_inner);
        match forked.as_ref().filter(|(process, _)| *process == own) {
            Some((_, pool)) => pool.clone(),
            None => {
                let made = ThreadPoolBuilder::new().build().map_err(|error| {
                    Failure::Internal(format!("a forked process can start no threads of its own: {error}"))
                })?;
                let pool = Arc::new(made);
                // The pool of the process before: its threads are not here, and its end would wait for them.
                std::mem::forget(forked.replace((own, pool.clone())));
                pool
            }
        }
    };
    pool.install(compute)
}

/// Runs it; a panic becomes [`Failure::Internal`].
pub fn caught<T>(compute: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    catch_unwind(AssertUnwindSafe(compute)).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        Err(Failure::Internal(text.unwrap_or_else(|| "a panic without words".into())))
    })
}

/// Flags that no computation looks at any more.
static FREE_FLAGS: Mutex<Vec<&'static AtomicBool>> = Mutex::new(Vec::new());

/// A flag that lives as long as the process, back among the free ones when nobody looks at it.
#[derive(Debug)]
struct Flag(&'static AtomicBool);

impl Default for Flag {
    fn default() -> Flag {
        let free = FREE_FLAGS.lock().unwrap_or_else(PoisonError::into_inner).pop();
        Flag(free.unwrap_or_else(|| Box::leak(Box::default())))
    }
}

impl Drop for Flag {
    fn drop(&mut self) {
        self.0.store(false, Ordering::Relaxed);
        FREE_FLAGS.lock().unwrap_or_else(PoisonError::into_inner).push(self.0);
    }
}

/// Whether somebody still waits for a computation.
#[derive(Debug, Clone, Default)]
pub struct Watch(Arc<OnceLock<Flag>>);

impl Watch {
    /// Whether the computation goes on.
    pub fn goes_on(&self) -> bool {
        !self.0.get().is_some_and(|flag| flag.0.load(Ordering::Relaxed))
    }

    /// What is set once the computation is to end, for what looks at it alone. It is nobody's any more once all watches of the computation are gone.
    pub fn flag(&self) -> &'static AtomicBool {
        self.0.get_or_init(Flag::default).0
    }

    fn stop(&self) {
        self.flag().store(true, Ordering::Relaxed);
    }
}
