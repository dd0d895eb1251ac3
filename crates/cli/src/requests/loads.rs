//! From the options of the command line to a request of the facade.

use crate::arguments::RequestArguments;
use crate::failure::Failure;
use lanchester::mechanism::{InternalRequest, Kinematics, LoadRequest, PeakMode};
use lanchester::task::option;

/// The request behind the options that `loads` and `report` share.
pub fn load_request(arguments: &RequestArguments) -> Result<LoadRequest, Failure> {
    let mut request = LoadRequest { max_order: arguments.orders, ..LoadRequest::default() };
    if let Some(speed) = &arguments.speed {
        request.speed = Some(option::speed(speed, "--speed").map_err(Failure::from)?);
    }
    if let Some(about) = &arguments.about {
        request.reference = point(about, "--about")?;
    }
    request.kinematics = series(&arguments.series)?;
    if let Some(grid) = arguments.grid {
        request.peaks = PeakMode::Grid(grid as usize);
    }
    Ok(request)
}

/// The request for shear and bending of the crankshafts behind the same options, with so many angles a revolution.
pub fn internal_request(arguments: &RequestArguments, samples: usize) -> Result<InternalRequest, Failure> {
    let request = load_request(arguments)?;
    Ok(InternalRequest {
        speed: request.speed,
        kinematics: request.kinematics,
        reciprocating_share: option::share(&arguments.bending_share, "--bending-share")
            .map_err(Failure::from)?,
        samples,
        ..InternalRequest::default()
    })
}

/// A point that an option gives as `x, y, z`.
pub fn point(text: &str, name: &str) -> Result<[f64; 3], Failure> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let [x, y, z] = parts[..] else {
        return Err(Failure::input(
            format_args!("{name} needs three coordinates x, y, z, got {}: `{text}`", parts.len()),
            format_args!("write it like {name} \"0 mm, 0 mm, 120 mm\""),
        ));
    };
    let coordinate = |text| option::length(text, name).map_err(Failure::from);
    Ok([coordinate(x)?, coordinate(y)?, coordinate(z)?])
}

/// Motion of the pistons as `--series` says it.
pub fn series(text: &str) -> Result<Kinematics, Failure> {
    let parts: Vec<&str> = text.split(':').collect();
    let number = |part: &str| part.parse::<u32>().ok();
    let kinematics = match parts[..] {
        ["exact"] => Some(Kinematics::Exact),
        ["orders", max] => number(max).map(Kinematics::Orders),
        ["power", max_order, max_power] => number(max_order)
            .zip(number(max_power))
            .map(|(max_order, max_power)| Kinematics::PowerSeries { max_order, max_power }),
        _ => None,
    };
    kinematics.ok_or_else(|| {
        Failure::input(
            format_args!("--series must be exact, orders:N or power:N:P, got `{text}`"),
            "power:4:5 is the series of most textbooks: orders 1, 2, 4 with powers of the rod ratio up to 5",
        )
    })
}
