//! The surface of a mesh for viewers: triangles, colours, binary glTF, STL.

mod colour;
mod glb;
mod scale;
mod skin;
mod stl;

pub use colour::colour;
pub use glb::{Morph, glb};
pub use scale::shown_factor;
pub use skin::{Skin, skin};
pub use stl::stl;
