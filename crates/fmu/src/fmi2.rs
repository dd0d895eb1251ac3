//! FMI 2.0: the functions of a unit for co-simulation.
//!
//! Names, arguments and order are those of the standard's headers; what a unit of this kind cannot do answers with an error.
#![allow(unsafe_code)]
#![allow(non_snake_case, reason = "the standard's names")]

use crate::handle::{self, DISCARD, FATAL, Log, OK, c_text, list_mut, say, text, with};
use crate::instance::Instance;
use crate::phase::Phase;
use crate::unit::Stepped;
use std::ffi::{c_char, c_void};

/// `fmi2CallbackLogger`: environment, instance, status, category, format as of `printf`, values.
type Logger =
    Option<unsafe extern "C" fn(*mut c_void, *const c_char, i32, *const c_char, *const c_char, ...)>;

/// `fmi2CallbackFunctions`
#[repr(C)]
pub struct Callbacks {
    /// Takes messages.
    pub logger: Logger,
    /// Not used: memory is our own.
    pub allocate: *const c_void,
    /// Not used.
    pub free: *const c_void,
    /// Not used: steps are done when they return.
    pub step_finished: *const c_void,
    /// Handed back to the logger.
    pub environment: *mut c_void,
}

/// Name of the platform's types.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

/// Version of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

/// Whether events are told; what is wrong is told in any case.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    component: *mut c_void,
    on: i32,
    _count: usize,
    _categories: *const *const c_char,
) -> i32 {
    with(component, |instance| {
        instance.is_verbose = on != 0;
        Ok(())
    })
}

/// Makes an instance; null, with a message, where it cannot be.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    name: *const c_char,
    kind: i32,
    guid: *const c_char,
    resources: *const c_char,
    callbacks: *const Callbacks,
    _visible: i32,
    logging: i32,
) -> *mut c_void {
    // SAFETY: a string that is null or ends with a zero; callbacks that are null or what the standard says.
    let (own_name, callbacks) = unsafe { (text(name), callbacks.as_ref()) };
    let logger = callbacks.and_then(|own| own.logger);
    let environment = callbacks.map_or(std::ptr::null_mut(), |own| own.environment);
    let own_name = c_text(own_name.as_deref().unwrap_or("lanchester"));
    let log: Log = Box::new(move |status, message| {
        if let Some(logger) = logger {
            let category = match status {
                OK => c"logAll",
                DISCARD => c"logStatusDiscard",
                FATAL => c"logStatusFatal",
                _ => c"logStatusError",
            };
            let message = c_text(message);
            // SAFETY: the caller's logger, called as the standard says; the message is a value, no format.
            unsafe {
                logger(
                    environment,
                    own_name.as_ptr(),
                    status,
                    category.as_ptr(),
                    c"%s".as_ptr(),
                    message.as_ptr(),
                );
            }
        }
    });
    let kind = match kind {
        1 => Ok(()),
        _ => Err("the unit is one for co-simulation, not for model exchange".to_owned()),
    };
    // SAFETY: strings of the caller, which are null or end with a zero.
    unsafe { handle::made_from(guid, resources, kind, logging != 0, log) }
}

/// Frees an instance.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut c_void) {
    handle::free(component);
}

/// When the run starts; its end and tolerance say nothing to this unit.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    component: *mut c_void,
    _has_tolerance: i32,
    _tolerance: f64,
    start: f64,
    _has_stop: i32,
    _stop: f64,
) -> i32 {
    with(component, |instance| {
        instance.go(&[Phase::Made], Phase::Made)?;
        instance.start_at(start)
    })
}

/// Initialisation begins.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterInitializationMode(component: *mut c_void) -> i32 {
    with(component, |instance| instance.go(&[Phase::Made], Phase::Initialising))
}

/// Initialisation ends.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2ExitInitializationMode(component: *mut c_void) -> i32 {
    with(component, Instance::initialised)
}

/// The run ends.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Terminate(component: *mut c_void) -> i32 {
    with(component, |instance| instance.go(&[Phase::Running], Phase::Ended))
}

/// As when it was made.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Reset(component: *mut c_void) -> i32 {
    with(component, |instance| {
        instance.reset();
        Ok(())
    })
}

/// Numbers by their references.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut f64,
) -> i32 {
    // SAFETY: arrays of these lengths by the standard.
    unsafe { handle::get(component, (references, count), (values, count), Instance::number) }
}

/// Sets numbers.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const f64,
) -> i32 {
    // SAFETY: arrays of these lengths by the standard.
    unsafe { handle::set(component, (references, count), (values, count), Instance::set_number) }
}

/// Booleans by their references.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBoolean(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut i32,
) -> i32 {
    // SAFETY: arrays of these lengths by the standard.
    unsafe {
        handle::get(component, (references, count), (values, count), |instance, reference| {
            instance.flag(reference).map(i32::from)
        })
    }
}

/// Sets Booleans.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const i32,
) -> i32 {
    // SAFETY: arrays of these lengths by the standard.
    unsafe {
        handle::set(component, (references, count), (values, count), |instance, reference, value| {
            instance.set_flag(reference, value != 0)
        })
    }
}

/// Goes on by a step with the inputs held; "discard" where an event of the engine file stops the run within it.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(component: *mut c_void, now: f64, step: f64, _no_return: i32) -> i32 {
    let mut stepped = Stepped::default();
    let status = with(component, |instance| {
        instance.go(&[Phase::Running], Phase::Running)?;
        stepped = instance.step(now, step)?;
        Ok(())
    });
    stepped.happened.iter().for_each(|own| say(component, OK, own));
    match stepped.stopped {
        Some(_) => {
            say(component, DISCARD, "an event of the engine file stopped the run");
            DISCARD
        }
        None => status,
    }
}

/// Time up to which steps succeeded; other questions have no answer.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(component: *mut c_void, kind: i32, value: *mut f64) -> i32 {
    with(component, |instance| {
        // SAFETY: one number by the standard.
        let place = unsafe { list_mut(value, 1)? };
        if kind != 2 {
            return Err("the time of the last step is all that is known".to_owned());
        }
        place[0] = instance.time();
        Ok(())
    })
}

/// Whether the run has stopped for good; other questions have no answer.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBooleanStatus(component: *mut c_void, kind: i32, value: *mut i32) -> i32 {
    with(component, |instance| {
        // SAFETY: one Boolean by the standard.
        let place = unsafe { list_mut(value, 1)? };
        if kind != 3 {
            return Err("whether the run has stopped is all that is known".to_owned());
        }
        place[0] = i32::from(instance.has_stopped());
        Ok(())
    })
}

/// Saves the state.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(component: *mut c_void, state: *mut *mut c_void) -> i32 {
    // SAFETY: a place for a handle by the standard.
    unsafe { handle::save(component, state) }
}

/// Brings a saved state back.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetFMUstate(component: *mut c_void, state: *mut c_void) -> i32 {
    handle::restore(component, state)
}

/// Frees a saved state.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(component: *mut c_void, state: *mut *mut c_void) -> i32 {
    // SAFETY: a place for a handle by the standard.
    unsafe { handle::forget(component, state) }
}

/// What a unit of this kind does not have. The instance is its first argument; others are passed by the caller and left alone.
macro_rules! without {
    ($($name:ident: $what:literal),* $(,)?) => {$(
        #[doc = concat!("Refused: ", $what, ".")]
        ///
        /// # Safety
        /// As the standard has it.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(component: *mut c_void) -> i32 {
            with(component, |_| Err(concat!(stringify!($name), ": ", $what).to_owned()))
        }
    )*};
}

without! {
    fmi2SerializedFMUstateSize: "states cannot be written as bytes",
    fmi2SerializeFMUstate: "states cannot be written as bytes",
    fmi2DeSerializeFMUstate: "states cannot be read from bytes",
    fmi2GetDirectionalDerivative: "there are no derivatives by variables",
    fmi2SetRealInputDerivatives: "inputs are held over a step",
    fmi2GetRealOutputDerivatives: "there are no derivatives of outputs",
    fmi2CancelStep: "a step is done when it returns",
    fmi2GetStatus: "a step is done when it returns",
    fmi2GetIntegerStatus: "there is no such status",
    fmi2GetStringStatus: "there is no such status",
}

/// Values of a type that no variable has: none may be asked for.
macro_rules! no_variables {
    ($($name:ident: $what:literal),* $(,)?) => {$(
        #[doc = concat!("No variable is ", $what, ": none may be asked for.")]
        ///
        /// # Safety
        /// As the standard has it.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut c_void,
            _references: *const u32,
            count: usize,
            _values: *const c_void,
        ) -> i32 {
            with(component, |_| match count {
                0 => Ok(()),
                _ => Err(concat!("no variable is ", $what).to_owned()),
            })
        }
    )*};
}

no_variables! {
    fmi2GetInteger: "an integer",
    fmi2SetInteger: "an integer",
    fmi2GetString: "a text",
    fmi2SetString: "a text",
}
