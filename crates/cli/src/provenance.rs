//! What a report says about its own making.

use crate::files::Source;
use lanchester::mechanism::{LoadRequest, Loads, PeakMode};
use lanchester::report::Provenance;

/// Program, input and settings behind `loads`.
pub fn provenance(source: &Source, loads: &Loads, request: &LoadRequest) -> Provenance {
    let peaks = match request.peaks {
        PeakMode::Continuous => "true extremes over the continuous angle, to 1e-12 of their size".to_string(),
        PeakMode::Grid(angles) => format!("largest of {angles} angles a revolution"),
    };
    Provenance {
        program: format!("lanchester {} ({})", env!("CARGO_PKG_VERSION"), env!("LANCHESTER_COMMIT")),
        input: source.name.clone(),
        input_hash: format!("FNV-1a {:016x}", fnv1a(source.text.as_bytes())),
        settings: vec![
            ("motion".to_string(), loads.kinematics.clone()),
            ("orders listed".to_string(), format!("0 to {}", request.max_order)),
            ("angles of the curves".to_string(), format!("{} a revolution", request.samples)),
            ("peaks".to_string(), peaks),
        ],
    }
}

/// 64-bit FNV-1a: tells whether a report belongs to a file, no protection against intent.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_published_test_vectors_of_fnv1a() {
        assert_eq!(super::fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(super::fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }
}
