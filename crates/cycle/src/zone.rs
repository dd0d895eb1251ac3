//! Single-zone filling and emptying: one gas of one pressure and temperature in the cylinder, valves to two reservoirs, heat release and walls.
//!
//! Book, eqs. 28.9 to 28.18. The reservoirs are endless: what flows back into one is lost in it. The mass of the fuel is left out. Kinks (valves that
//! open and close, heat that begins and ends) lie at the ends of integration intervals.

mod flow;
mod opening;
mod period;
mod release;
mod result;
mod state;
mod walls;

pub use flow::mass_flow;
pub use opening::{PistonGap, piston_gap};
pub use period::{ZoneSettings, single_zone};
pub use result::{Balance, SinceClosing, ZoneCycle, ZoneOutcome};
pub use state::{Contents, ThroughFlow, fill};
