//! What must hold for any input: shared by the fuzz targets and by the test that replays the kept corpus.

use lanchester_mechanism::{LoadError, LoadRequest, LoadSet, loads as loads_of};
use lanchester_model::{Engine, expanded, read as read_text, render, templates};

/// Any bytes, read as an engine file: mistakes can be shown, and what is accepted survives its expanded form.
pub fn read(data: &[u8]) {
    accepted(&String::from_utf8_lossy(data));
}

/// A template with some of its lines changed: whatever is accepted has finite loads.
pub fn loads(data: &[u8]) {
    let text = changed_template(data);
    let Some(engine) = accepted(&text) else { return };
    // Few angles: the kernels are the same for each.
    let request = LoadRequest { samples: 24, ..LoadRequest::default() };
    let loads = match loads_of(&engine, &request) {
        Ok(loads) => loads,
        // A valid engine may still be too large for the range of numbers, or repeat too late.
        Err(LoadError::NotFinite { .. } | LoadError::PeriodTooLong { .. }) => return,
        Err(error) => panic!("the reader accepts what the loads refuse: {error}\n{text}"),
    };
    assert!(finite(&loads.total), "loads that are not finite of\n{text}");
    for part in &loads.parts {
        assert!(finite(&part.loads), "{:?} is not finite of\n{text}", part.part);
    }
}

/// Reads a file; what is refused has a reason that can be shown, what is accepted has an equal expanded form.
fn accepted(text: &str) -> Option<Engine> {
    let reading = read_text(text);
    let shown = render(&reading.diagnostics, "engine.toml", text, false);
    let Some(engine) = reading.engine else {
        assert!(!shown.is_empty(), "refused without a reason:\n{text}");
        return None;
    };
    let form = expanded(&engine);
    let again = read_text(&form);
    let mistakes = render(&again.diagnostics, "expanded.toml", &form, false);
    assert_eq!(
        again.engine.as_ref(),
        Some(&engine),
        "the expanded form reads differently\n{mistakes}\n{text}\n---\n{form}"
    );
    Some(engine)
}

fn finite(loads: &LoadSet) -> bool {
    let trace = &loads.trace;
    let curves = [
        &trace.force_x,
        &trace.force_y,
        &trace.couple_x,
        &trace.couple_y,
        &trace.roll_moment,
        &trace.shaft_torque,
    ];
    curves.iter().all(|curve| curve.iter().all(|value| value.is_finite()))
        && loads.orders.iter().all(|order| {
            order.force_forward.is_finite()
                && order.force_backward.is_finite()
                && order.couple_forward.is_finite()
                && order.couple_backward.is_finite()
                && order.roll_moment.is_finite()
                && order.shaft_torque.is_finite()
        })
        && [&loads.peaks.force, &loads.peaks.couple, &loads.peaks.roll_moment, &loads.peaks.shaft_torque]
            .iter()
            .all(|peak| peak.max.value.is_finite() && peak.min.value.is_finite())
}

const NUMBERS: [&str; 20] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "2",
    "3",
    "0.5",
    "1/2",
    "-2/3",
    "1e-300",
    "1e300",
    "-1e300",
    "1e-12",
    "1e9",
    "nan",
    "inf",
    "79,5",
    "360",
    "99999999999999999999",
    "0x10",
];
const UNITS: [&str; 12] = ["mm", "m", "in", "kg", "g", "deg", "rad", "rpm", "kg m", "%", "kg mm2", "furlong"];
const WORDS: [&str; 16] = [
    "in-line",
    "v",
    "boxer",
    "flat",
    "vr",
    "w",
    "radial",
    "shared",
    "split",
    "separate",
    "side-by-side",
    "fork-and-blade",
    "articulated",
    "webs",
    "alternating",
    "reverse",
];
const ADDITIONS: [&str; 6] = [
    "\n[counterweights]\nreciprocating_share = \"50 %\"\n",
    "\n[[counterweight]]\nthrow = 2\nmass = \"1 kg\"\nradius = \"40 mm\"\nangle = \"170 deg\"\n",
    "\n[[shaft]]\nratio = \"-3/2\"\ny = \"80 mm\"\nx = \"-20 mm\"\nweights = [{ z = \"10 mm\", unbalance = \"2 g m\" }]\n",
    "\n[[cylinder]]\nnumber = 2\noffset = \"11 mm\"\nrod = { mass = \"0.7 kg\", inertia = \"3000 kg mm2\" }\n",
    "\n[[mount]]\nx = \"1 in\"\ny = \"0 mm\"\nz = \"-88 mm\"\n",
    "\n[cylinders]\noffset = \"8 mm\"\n",
];

/// The first byte chooses the template; each further three bytes make one change: kind, line, argument.
fn changed_template(data: &[u8]) -> String {
    let all = templates();
    let first = data.first().copied().unwrap_or(0);
    let mut lines: Vec<String> =
        all[usize::from(first) % all.len()].text.lines().map(str::to_owned).collect();
    let mut additions = String::new();
    for change in data.get(1..).unwrap_or_default().chunks_exact(3).take(16) {
        let (kind, argument) = (change[0] % 8, usize::from(change[2]));
        let at = usize::from(change[1]) % lines.len().max(1);
        let Some(line) = lines.get(at).cloned() else { break };
        match kind {
            // Most changes keep the file plausible, so that the load path is reached.
            0..=2 => {
                lines[at] =
                    with_number(&line, |number| format!("{:.4}", number * (0.25 + argument as f64 / 128.0)))
            }
            3 => lines[at] = with_number(&line, |_| NUMBERS[argument % NUMBERS.len()].to_owned()),
            4 => lines[at] = with_word(&line, argument),
            5 => {
                lines.remove(at);
            }
            6 => lines.insert(at, line),
            _ => additions += ADDITIONS[argument % ADDITIONS.len()],
        }
    }
    lines.join("\n") + "\n" + &additions
}

/// The line with the first number behind its `=` replaced.
fn with_number(line: &str, change: impl Fn(f64) -> String) -> String {
    let Some(equals) = line.find('=') else { return line.to_owned() };
    let digit = |c: char| c.is_ascii_digit() || c == '.';
    let Some(start) = line[equals..].find(digit).map(|start| start + equals) else { return line.to_owned() };
    let end = line[start..].find(|c: char| !digit(c)).map_or(line.len(), |end| end + start);
    let number = line[start..end].parse().unwrap_or(1.0);
    format!("{}{}{}", &line[..start], change(number), &line[end..])
}

/// The line with its unit, or its first quoted word, replaced.
fn with_word(line: &str, argument: usize) -> String {
    let Some(open) = line.find('"') else { return line.to_owned() };
    let Some(close) = line[open + 1..].find('"').map(|close| close + open + 1) else {
        return line.to_owned();
    };
    let inner = &line[open + 1..close];
    let replaced = match inner.split_once(' ') {
        Some((number, _)) if number.starts_with(|c: char| c.is_ascii_digit() || c == '-') => {
            format!("{number} {}", UNITS[argument % UNITS.len()])
        }
        _ => WORDS[argument % WORDS.len()].to_owned(),
    };
    format!("{}{replaced}{}", &line[..open + 1], &line[close..])
}
