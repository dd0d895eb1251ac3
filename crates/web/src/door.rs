//! The functions that the page calls, by their names in the module.
//!
//! ```text
//! room(n)        address of n bytes, where the page writes the next text
//! head()         that text is the head of a question, like `POST /api/loads`
//! ask()          that text is the body: answers, and returns the status
//! length()       length of the reply: its media type, a line feed, and its bytes
//! reply()        address of the reply
//! ```
//!
//! # What is unsafe here
//!
//! Exported names are, for two libraries could export the same one. Nothing else: addresses are handed out, and what the page does with its
//! view of the memory stays within the module, whose memory is walled in by the browser.
#![allow(unsafe_code)]

use crate::module::Module;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

static MODULE: LazyLock<Module> = LazyLock::new(Module::default);
static DESK: Mutex<Desk> = Mutex::new(Desk { room: Vec::new(), head: String::new(), reply: Vec::new() });

/// Texts on their way.
struct Desk {
    room: Vec<u8>,
    head: String,
    reply: Vec<u8>,
}

fn desk() -> MutexGuard<'static, Desk> {
    DESK.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Room for a text of so many bytes; its address.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    let mut desk = desk();
    desk.room = vec![0; length];
    desk.room.as_mut_ptr()
}

/// What stands in the room is the head of a question.
#[unsafe(no_mangle)]
pub extern "C" fn head() {
    let mut desk = desk();
    desk.head = String::from_utf8_lossy(&std::mem::take(&mut desk.room)).into_owned();
}

/// What stands in the room is the body of the question; its answer is there afterwards. Returns its status.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> u32 {
    let (head, body) = {
        let mut desk = desk();
        (std::mem::take(&mut desk.head), std::mem::take(&mut desk.room))
    };
    let reply = MODULE.answer(&head, &body);
    let mut desk = desk();
    desk.reply = [reply.kind.as_bytes(), b"\n", &reply.bytes].concat();
    u32::from(reply.status)
}

/// Length of the reply in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn length() -> usize {
    desk().reply.len()
}

/// Address of the reply.
#[unsafe(no_mangle)]
pub extern "C" fn reply() -> *const u8 {
    desk().reply.as_ptr()
}

/// No random number comes from the system: searches draw from seeds.
#[cfg(all(target_arch = "wasm32", target_os = "unknown"))]
mod no_random_numbers {
    fn none(_: &mut [u8]) -> Result<(), getrandom_seeded::Error> {
        Err(getrandom_seeded::Error::UNSUPPORTED)
    }
    getrandom_seeded::register_custom_getrandom!(none);
}
