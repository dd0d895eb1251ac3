//! Between C and Rust: pointers that are checked, strings, panics that go no further.
//!
//! # Why this is unsafe, and what makes it safe
//! The standards hand over raw pointers. An instance or a saved state is used only if its address is in the list of those that live, so that
//! a null pointer, a stranger's or one that was freed is an error and no crash; arrays and strings are read only where their pointer is not
//! null, for the length that the caller states, which is the one thing that must be trusted. The standards forbid that two
//! threads use one instance at a time.
#![allow(unsafe_code)]

use crate::instance::{Instance, State};
use crate::phase::Phase;
use std::any::TypeId;
use std::collections::HashMap;
use std::ffi::{CStr, CString, c_char, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Status of both standards: all is well.
pub const OK: i32 = 0;
/// The step ended before its end (FMI 2.0).
pub const DISCARD: i32 = 2;
/// The call was refused; time and state are as before.
pub const ERROR: i32 = 3;
/// The instance is of no more use.
pub const FATAL: i32 = 4;

/// How a message leaves: category and text.
pub type Log = Box<dyn Fn(i32, &str)>;

/// What a handle points at.
pub struct Component {
    /// The instance.
    pub instance: Instance,
    /// Where its messages go.
    pub log: Log,
}

/// Addresses of what was handed out and not taken back, with what stands there.
static LIVE: Mutex<Option<HashMap<usize, TypeId>>> = Mutex::new(None);

fn live() -> MutexGuard<'static, Option<HashMap<usize, TypeId>>> {
    LIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether a `T` that was handed out stands there.
fn is_live<T: 'static>(pointer: *mut c_void) -> bool {
    live().as_ref().is_some_and(|known| known.get(&(pointer as usize)) == Some(&TypeId::of::<T>()))
}

/// Hands something out.
fn hand_out<T: 'static>(own: T) -> *mut c_void {
    let pointer = Box::into_raw(Box::new(own)).cast::<c_void>();
    live().get_or_insert_default().insert(pointer as usize, TypeId::of::<T>());
    pointer
}

/// Takes a `T` back; `None` where none stands there, or was taken back before.
fn take_back<T: 'static>(pointer: *mut c_void) -> Option<Box<T>> {
    if !is_live::<T>(pointer) {
        return None;
    }
    live().as_mut().and_then(|known| known.remove(&(pointer as usize)))?;
    // SAFETY: the address is that of a `Box<T>` that was handed out and is taken back for the first time.
    Some(unsafe { Box::from_raw(pointer.cast::<T>()) })
}

/// Makes an instance; null, with a message, where it cannot be.
fn made(make: impl FnOnce() -> Result<Instance, String>, log: Log) -> *mut c_void {
    match catch_unwind(AssertUnwindSafe(make)) {
        Ok(Ok(instance)) => hand_out(Component { instance, log }),
        Ok(Err(message)) => {
            log(ERROR, &message);
            std::ptr::null_mut()
        }
        Err(_) => {
            log(FATAL, "the instance cannot be made: Lanchester failed within");
            std::ptr::null_mut()
        }
    }
}

/// Calls with an instance; the status of the outcome.
pub fn with(component: *mut c_void, call: impl FnOnce(&mut Instance) -> Result<(), String>) -> i32 {
    if !is_live::<Component>(component) {
        return ERROR;
    }
    // SAFETY: the address lives, it was handed out as a component, and no other thread uses it.
    let component = unsafe { &mut *component.cast::<Component>() };
    if component.instance.phase() == Phase::Broken {
        (component.log)(ERROR, "the instance is broken by an earlier failure and can only be freed");
        return ERROR;
    }
    match catch_unwind(AssertUnwindSafe(|| call(&mut component.instance))) {
        Ok(Ok(())) => OK,
        Ok(Err(message)) => {
            (component.log)(ERROR, &message);
            ERROR
        }
        Err(_) => {
            component.instance.break_off();
            (component.log)(FATAL, "Lanchester failed within; the instance can only be freed");
            FATAL
        }
    }
}

/// Says something through the logger of an instance that lives.
pub fn say(component: *mut c_void, status: i32, message: &str) {
    if is_live::<Component>(component) {
        // SAFETY: the address lives, it was handed out as a component, and no other thread uses it.
        let component = unsafe { &*component.cast::<Component>() };
        (component.log)(status, message);
    }
}

/// Frees an instance; nothing happens to what is none.
pub fn free(component: *mut c_void) {
    drop(take_back::<Component>(component));
}

/// Saves the state of an instance into `place`: a new one where it holds null, else over the one that it holds.
///
/// # Safety
/// `place` is null or points at a handle.
pub unsafe fn save(component: *mut c_void, place: *mut *mut c_void) -> i32 {
    let mut saved = None;
    let status = with(component, |instance| {
        saved = Some(instance.saved());
        if place.is_null() { Err("there is no place for the state".to_owned()) } else { Ok(()) }
    });
    if let (OK, Some(state)) = (status, saved) {
        // SAFETY: the place is not null, by the call before.
        unsafe {
            drop(take_back::<State>(*place));
            *place = hand_out(state);
        }
    }
    status
}

/// Brings a saved state back.
pub fn restore(component: *mut c_void, saved: *mut c_void) -> i32 {
    let is_ours = is_live::<State>(saved);
    with(component, |instance| {
        if !is_ours {
            return Err("this is no saved state, or it was freed".to_owned());
        }
        // SAFETY: a state lives there.
        instance.restore(unsafe { &*saved.cast::<State>() })
    })
}

/// Frees a saved state and sets its handle to null.
///
/// # Safety
/// `place` is null or points at a handle of a state.
pub unsafe fn forget(component: *mut c_void, place: *mut *mut c_void) -> i32 {
    with(component, |_| {
        if !place.is_null() {
            // SAFETY: the place is not null.
            unsafe {
                drop(take_back::<State>(*place));
                *place = std::ptr::null_mut();
            }
        }
        Ok(())
    })
}

/// A C string as text; `None` where it is null or not UTF-8.
///
/// # Safety
/// It is null or ends with a zero.
pub unsafe fn text(pointer: *const c_char) -> Option<String> {
    // SAFETY: it is not null and ends with a zero.
    (!pointer.is_null())
        .then(|| unsafe { CStr::from_ptr(pointer) }.to_str().ok().map(str::to_owned))
        .flatten()
}

/// What is read, `count` of it.
///
/// # Safety
/// The pointer is null or holds as many.
unsafe fn list<'a, T>(pointer: *const T, count: usize) -> Result<&'a [T], String> {
    if count == 0 {
        return Ok(&[]);
    }
    if pointer.is_null() {
        return Err(format!("{count} values are announced, and their pointer is null"));
    }
    // SAFETY: not null, and as long as the caller says.
    Ok(unsafe { std::slice::from_raw_parts(pointer, count) })
}

/// What is written, `count` of it.
///
/// # Safety
/// The pointer is null or holds as many.
pub unsafe fn list_mut<'a, T>(pointer: *mut T, count: usize) -> Result<&'a mut [T], String> {
    if count == 0 {
        return Ok(&mut []);
    }
    if pointer.is_null() {
        return Err(format!("{count} values are asked for, and the pointer to their place is null"));
    }
    // SAFETY: not null, and as long as the caller says.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, count) })
}

/// As many references as values.
fn paired(references: usize, values: usize) -> Result<(), String> {
    if references == values {
        return Ok(());
    }
    Err(format!("every variable is one value: {references} references come with {values} values"))
}

/// Values of variables by their references.
///
/// # Safety
/// The pointers are null or hold as many as is said.
pub unsafe fn get<T>(
    component: *mut c_void,
    (references, count): (*const u32, usize),
    (values, value_count): (*mut T, usize),
    of: impl Fn(&mut Instance, u32) -> Result<T, String>,
) -> i32 {
    with(component, |instance| {
        // SAFETY: by the caller.
        let (references, values) = unsafe { (list(references, count)?, list_mut(values, value_count)?) };
        paired(count, value_count)?;
        for (value, reference) in values.iter_mut().zip(references) {
            *value = of(instance, *reference)?;
        }
        Ok(())
    })
}

/// Sets variables by their references.
///
/// # Safety
/// The pointers are null or hold as many as is said.
pub unsafe fn set<T: Copy>(
    component: *mut c_void,
    (references, count): (*const u32, usize),
    (values, value_count): (*const T, usize),
    set: impl Fn(&mut Instance, u32, T) -> Result<(), String>,
) -> i32 {
    with(component, |instance| {
        // SAFETY: by the caller.
        let (references, values) = unsafe { (list(references, count)?, list(values, value_count)?) };
        paired(count, value_count)?;
        references.iter().zip(values).try_for_each(|(reference, value)| set(instance, *reference, *value))
    })
}

/// Makes an instance from what a program hands over; null, with a message, where it cannot be.
///
/// # Safety
/// The strings are null or end with a zero.
pub unsafe fn made_from(
    token: *const c_char,
    resources: *const c_char,
    kind: Result<(), String>,
    is_verbose: bool,
    log: Log,
) -> *mut c_void {
    // SAFETY: by the caller.
    let (token, resources) = unsafe { (text(token), text(resources)) };
    let make = || {
        kind?;
        let needed = |what: Option<String>, name: &str| what.ok_or_else(|| format!("there is no {name}"));
        let folder = folder_of(&needed(resources, "folder of the resources")?)?;
        let mut instance = Instance::new(&folder, &needed(token, "token of the description")?)?;
        instance.is_verbose = is_verbose;
        Ok(instance)
    };
    made(make, log)
}

/// A text for C, which cannot hold zeros.
pub fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', " ")).unwrap_or_default()
}

/// The folder of a `file:` address, or of a plain path.
///
/// # Errors
/// For an address of another kind.
fn folder_of(address: &str) -> Result<PathBuf, String> {
    let Some(rest) = address.strip_prefix("file:") else {
        return match address.split_once("://") {
            Some((scheme, _)) => Err(format!("resources at `{scheme}:` cannot be read: they must be files")),
            None => Ok(PathBuf::from(address)),
        };
    };
    let path = match rest.strip_prefix("//") {
        // A host stands before the path: an empty one, or this machine.
        Some(rest) => rest.find('/').map_or("", |at| &rest[at..]),
        None => rest,
    };
    let decoded = decoded(path)?;
    // On Windows the path of `file:///C:/x` begins behind the slash.
    let is_drive = decoded.as_bytes().get(2) == Some(&b':') && cfg!(windows);
    Ok(PathBuf::from(if is_drive { &decoded[1..] } else { &decoded }))
}

/// `%20` and its like resolved.
fn decoded(path: &str) -> Result<String, String> {
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.as_bytes();
    while let Some((&first, more)) = rest.split_first() {
        let code = more.get(..2).filter(|_| first == b'%').and_then(|code| std::str::from_utf8(code).ok());
        match code.and_then(|code| u8::from_str_radix(code, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &more[2..];
            }
            None => {
                bytes.push(first);
                rest = more;
            }
        }
    }
    String::from_utf8(bytes).map_err(|_| format!("the address `{path}` is not UTF-8"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_of_folders_are_read_as_programs_write_them() {
        for (address, path) in [
            ("file:///tmp/a%20b/resources", "/tmp/a b/resources"),
            ("file://here/tmp/x", "/tmp/x"),
            ("file:/tmp/x", "/tmp/x"),
            ("/tmp/100%", "/tmp/100%"),
        ] {
            assert_eq!(folder_of(address), Ok(PathBuf::from(path)));
        }
        assert!(folder_of("https://example.org/x").is_err());
    }
}
