//! FMI 3.0: the functions of a unit for co-simulation.
//!
//! Names, arguments and order are those of the standard's headers; what a unit of this kind cannot do answers with an error.
#![allow(unsafe_code)]
#![allow(non_snake_case, reason = "the standard's names")]

use crate::handle::{self, FATAL, Log, OK, c_text, list_mut, say, with};
use crate::instance::Instance;
use crate::phase::Phase;
use std::ffi::{c_char, c_void};

/// `fmi3LogMessageCallback`: environment, status, category, message.
type Logger = Option<unsafe extern "C" fn(*mut c_void, i32, *const c_char, *const c_char)>;

/// Version of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// Whether events are told; what is wrong is told in any case.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    component: *mut c_void,
    on: u8,
    _count: usize,
    _categories: *const *const c_char,
) -> i32 {
    with(component, |instance| {
        instance.is_verbose = on != 0;
        Ok(())
    })
}

/// A logger of the caller.
fn log_to(logger: Logger, environment: *mut c_void) -> Log {
    Box::new(move |status, message| {
        if let Some(logger) = logger {
            let category = match status {
                OK => c"logAll",
                FATAL => c"logStatusFatal",
                _ => c"logStatusError",
            };
            let message = c_text(message);
            // SAFETY: the caller's logger, called as the standard says.
            unsafe { logger(environment, status, category.as_ptr(), message.as_ptr()) };
        }
    })
}

/// Makes an instance; null, with a message, where it cannot be.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    _visible: u8,
    logging: u8,
    _event_mode: u8,
    _early_return: u8,
    _intermediate: *const u32,
    _intermediate_count: usize,
    environment: *mut c_void,
    logger: Logger,
    _intermediate_update: *const c_void,
) -> *mut c_void {
    // SAFETY: strings of the caller, which are null or end with a zero.
    unsafe { handle::made_from(token, resources, Ok(()), logging != 0, log_to(logger, environment)) }
}

/// Refused: the unit is one for co-simulation.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: u8,
    _logging: u8,
    environment: *mut c_void,
    logger: Logger,
) -> *mut c_void {
    let refused = Err("the unit is one for co-simulation, not for model exchange".to_owned());
    // SAFETY: no string is read.
    unsafe {
        handle::made_from(std::ptr::null(), std::ptr::null(), refused, false, log_to(logger, environment))
    }
}

/// Refused: the unit is one for co-simulation.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateScheduledExecution(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: u8,
    _logging: u8,
    environment: *mut c_void,
    logger: Logger,
    _clock_update: *const c_void,
    _lock: *const c_void,
    _unlock: *const c_void,
) -> *mut c_void {
    let refused = Err("the unit is one for co-simulation, not for scheduled execution".to_owned());
    // SAFETY: no string is read.
    unsafe {
        handle::made_from(std::ptr::null(), std::ptr::null(), refused, false, log_to(logger, environment))
    }
}

/// Frees an instance.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(component: *mut c_void) {
    handle::free(component);
}

/// Initialisation begins, at a time; end and tolerance say nothing to this unit.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    component: *mut c_void,
    _has_tolerance: u8,
    _tolerance: f64,
    start: f64,
    _has_stop: u8,
    _stop: f64,
) -> i32 {
    with(component, |instance| {
        instance.go(&[Phase::Made], Phase::Initialising)?;
        instance.start_at(start)
    })
}

/// Initialisation ends.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ExitInitializationMode(component: *mut c_void) -> i32 {
    with(component, Instance::initialised)
}

/// The run ends.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Terminate(component: *mut c_void) -> i32 {
    with(component, |instance| instance.go(&[Phase::Running], Phase::Ended))
}

/// As when it was made.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Reset(component: *mut c_void) -> i32 {
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
pub unsafe extern "C" fn fmi3GetFloat64(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut f64,
    value_count: usize,
) -> i32 {
    // SAFETY: arrays of these lengths by the standard.
    unsafe { handle::get(component, (references, count), (values, value_count), Instance::number) }
}

/// Sets numbers.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFloat64(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const f64,
    value_count: usize,
) -> i32 {
    // SAFETY: arrays of these lengths by the standard.
    unsafe { handle::set(component, (references, count), (values, value_count), Instance::set_number) }
}

/// Booleans by their references.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetBoolean(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut u8,
    value_count: usize,
) -> i32 {
    // SAFETY: arrays of these lengths by the standard.
    unsafe {
        handle::get(component, (references, count), (values, value_count), |instance, reference| {
            instance.flag(reference).map(u8::from)
        })
    }
}

/// Sets Booleans.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetBoolean(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const u8,
    value_count: usize,
) -> i32 {
    // SAFETY: arrays of these lengths by the standard.
    unsafe {
        handle::set(component, (references, count), (values, value_count), |instance, reference, value| {
            instance.set_flag(reference, value != 0)
        })
    }
}

/// Goes on by a step with the inputs held; asks to end the run where an event of the engine file stops it within the step.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    component: *mut c_void,
    now: f64,
    step: f64,
    _never_back: u8,
    event_needed: *mut u8,
    terminate: *mut u8,
    early_return: *mut u8,
    last_time: *mut f64,
) -> i32 {
    let mut happened = Vec::new();
    let status = with(component, |instance| {
        instance.go(&[Phase::Running], Phase::Running)?;
        let stepped = instance.step(now, step)?;
        for (flag, is_set) in
            [(event_needed, false), (terminate, stepped.stopped.is_some()), (early_return, false)]
        {
            // SAFETY: null or the place of one Boolean by the standard.
            unsafe { list_mut(flag, usize::from(!flag.is_null()))? }.fill(u8::from(is_set));
        }
        // SAFETY: null or the place of one number by the standard.
        unsafe { list_mut(last_time, usize::from(!last_time.is_null()))? }.fill(instance.time());
        happened = stepped.happened;
        Ok(())
    });
    happened.iter().for_each(|own: &String| say(component, OK, own));
    status
}

/// Saves the state.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(component: *mut c_void, state: *mut *mut c_void) -> i32 {
    // SAFETY: a place for a handle by the standard.
    unsafe { handle::save(component, state) }
}

/// Brings a saved state back.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(component: *mut c_void, state: *mut c_void) -> i32 {
    handle::restore(component, state)
}

/// Frees a saved state.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(component: *mut c_void, state: *mut *mut c_void) -> i32 {
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
    fmi3EnterEventMode: "there are no events",
    fmi3EnterConfigurationMode: "there are no structural parameters",
    fmi3ExitConfigurationMode: "there are no structural parameters",
    fmi3EnterStepMode: "there are no events",
    fmi3GetNumberOfVariableDependencies: "dependencies stand in the description",
    fmi3GetVariableDependencies: "dependencies stand in the description",
    fmi3SerializedFMUStateSize: "states cannot be written as bytes",
    fmi3SerializeFMUState: "states cannot be written as bytes",
    fmi3DeserializeFMUState: "states cannot be read from bytes",
    fmi3GetDirectionalDerivative: "there are no derivatives by variables",
    fmi3GetAdjointDerivative: "there are no derivatives by variables",
    fmi3GetIntervalDecimal: "there are no clocks",
    fmi3GetIntervalFraction: "there are no clocks",
    fmi3GetShiftDecimal: "there are no clocks",
    fmi3GetShiftFraction: "there are no clocks",
    fmi3SetIntervalDecimal: "there are no clocks",
    fmi3SetIntervalFraction: "there are no clocks",
    fmi3SetShiftDecimal: "there are no clocks",
    fmi3SetShiftFraction: "there are no clocks",
    fmi3EvaluateDiscreteStates: "there are no discrete states",
    fmi3UpdateDiscreteStates: "there are no discrete states",
    fmi3EnterContinuousTimeMode: "the unit is one for co-simulation",
    fmi3CompletedIntegratorStep: "the unit is one for co-simulation",
    fmi3SetTime: "the unit is one for co-simulation",
    fmi3SetContinuousStates: "the unit is one for co-simulation",
    fmi3GetContinuousStateDerivatives: "the unit is one for co-simulation",
    fmi3GetEventIndicators: "the unit is one for co-simulation",
    fmi3GetContinuousStates: "the unit is one for co-simulation",
    fmi3GetNominalsOfContinuousStates: "the unit is one for co-simulation",
    fmi3GetNumberOfEventIndicators: "the unit is one for co-simulation",
    fmi3GetNumberOfContinuousStates: "the unit is one for co-simulation",
    fmi3GetOutputDerivatives: "there are no derivatives of outputs",
    fmi3ActivateModelPartition: "there are no clocks",
}

/// Values of a type that no variable has: none may be asked for.
macro_rules! no_variables {
    ($($get:ident $set:ident: $what:literal),* $(,)?) => {$(
        #[doc = concat!("No variable is ", $what, ": none may be asked for.")]
        ///
        /// # Safety
        /// As the standard has it.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(component: *mut c_void, _references: *const u32, count: usize) -> i32 {
            none_of(component, count, $what)
        }

        #[doc = concat!("No variable is ", $what, ": none may be set.")]
        ///
        /// # Safety
        /// As the standard has it.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set(component: *mut c_void, _references: *const u32, count: usize) -> i32 {
            none_of(component, count, $what)
        }
    )*};
}

fn none_of(component: *mut c_void, count: usize, what: &str) -> i32 {
    with(component, |_| if count == 0 { Ok(()) } else { Err(format!("no variable is {what}")) })
}

no_variables! {
    fmi3GetFloat32 fmi3SetFloat32: "a Float32",
    fmi3GetInt8 fmi3SetInt8: "an Int8",
    fmi3GetUInt8 fmi3SetUInt8: "a UInt8",
    fmi3GetInt16 fmi3SetInt16: "an Int16",
    fmi3GetUInt16 fmi3SetUInt16: "a UInt16",
    fmi3GetInt32 fmi3SetInt32: "an Int32",
    fmi3GetUInt32 fmi3SetUInt32: "a UInt32",
    fmi3GetInt64 fmi3SetInt64: "an Int64",
    fmi3GetUInt64 fmi3SetUInt64: "a UInt64",
    fmi3GetString fmi3SetString: "a String",
    fmi3GetBinary fmi3SetBinary: "a Binary",
    fmi3GetClock fmi3SetClock: "a Clock",
}
