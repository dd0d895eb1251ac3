//! Words that the commands on counterweights share.

use lanchester::geometry::clearance::{RadialEnvelope, SweptRoom};
use lanchester::report::obstacle_name;

/// Names of weights in a list: "web 1, web 2".
pub(super) fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}

/// What the wanted clearance leaves: the envelope over the cycle, and the circle that keeps clear whatever the shape.
pub(super) fn room_words(room: Option<&SweptRoom>, envelope: Option<&RadialEnvelope>) -> Option<String> {
    let (Some(envelope), Some(limit)) = (envelope, envelope.and_then(|envelope| envelope.limit)) else {
        return None;
    };
    let [least, most] =
        [envelope.smallest(), envelope.largest()].map(|radius| format!("{:.2} mm", 1e3 * radius));
    let radii = if least == most { least } else { format!("{least} to {most}, depending on the direction,") };
    // Where the circle bounds the shape, it is told once.
    let round =
        room.filter(|room| !(envelope.is_round() && envelope.smallest() == room.radius)).map(|room| {
            let limit = obstacle_name(room.limit);
            format!("; {:.2} mm whatever the shape, by {limit}", 1e3 * room.radius)
        });
    Some(format!(
        "over the cycle a radius of {radii} keeps {:.2} mm of clearance, bounded first by {}{}.",
        1e3 * envelope.least,
        obstacle_name(limit),
        round.unwrap_or_default()
    ))
}
