//! From the tree of values to the engine: defaults, short forms, and everything that only the whole can tell.

mod arrangement;
mod balance;
mod bearing_design;
mod clearance;
mod crank;
mod cylinder;
mod design;
mod drafts;
mod firing;
mod gas;
mod gear;
mod geometry;
mod layers;
mod mount;
mod names;
mod part;
mod places;
mod reader;
mod running;
mod shaft;
pub(crate) mod simulation;
mod sizes;
mod tolerances;
mod torsion;
mod weights;

pub(crate) use firing::fired_after;
pub(crate) use reader::Reader;

use crate::document;
use crate::engine_file::EngineFile;
use crate::schema::FILE;
use drafts::Drafts;
use lanchester_diagnostic::{Diagnostic, Mistake, Mistakes};
use lanchester_model::{Crankshaft, Engine, EngineParts, Fault, Rotation, SpeedRange, Strokes};
use lanchester_task::Tasks;
use lanchester_units::Dimension;

/// What reading an engine file gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The engine and what is asked of it; `None` if and only if a diagnostic is an error.
    pub file: Option<EngineFile>,
    /// All mistakes and doubts, sorted by their place in the file.
    pub diagnostics: Vec<Diagnostic>,
}

impl Reading {
    /// A copy of the engine alone, without what is asked of it; `None` if a diagnostic is an error.
    pub fn engine(&self) -> Option<Engine> {
        self.file.as_ref().map(|file| file.engine.clone())
    }
}

/// Reads an engine file: TOML text, as the book's reference of the engine file describes it.
///
/// All mistakes are found at once. Nothing in the file is ignored: every key has an effect or a diagnostic. No text
/// makes this panic.
pub fn read(text: &str) -> Reading {
    read_with_origin(text).0
}

/// As [`read`], with the z of the reference plane in the file [m], if there is an engine.
pub(crate) fn read_with_origin(text: &str) -> (Reading, Option<f64>) {
    let mut mistakes = Mistakes::default();
    let document = document::parse(text, &FILE, &mut mistakes);
    let mut reader = Reader { root: &document.root, whole: document.whole, mistakes: &mut mistakes };
    let file = reader.engine_file();
    if !reader.mistakes.any_error() {
        reader.report_unused();
    }
    debug_assert!(file.is_some() || mistakes.any_error(), "a file without an engine has an error");
    let (file, origin) = file.filter(|_| !mistakes.any_error()).unzip();
    (Reading { file, diagnostics: mistakes.into_diagnostics(text) }, origin)
}

impl<'a> Reader<'a> {
    /// The engine with what is asked of it, and the z of its reference plane in the file.
    fn engine_file(&mut self) -> Option<(EngineFile, f64)> {
        let root = self.root;
        // A file of version 1 is the only one there is: the kind of the key has checked it.
        let version = root.whole("version");
        let name = self.required(root, "name", root.text("name"));
        let note = root.text("note");
        let strokes = root.whole("strokes").or(4).map(|n| if n == 2 { Strokes::Two } else { Strokes::Four });
        let rotation = root
            .word("rotation")
            .or("clockwise")
            .map(|word| if word == "reverse" { Rotation::Reverse } else { Rotation::Clockwise });
        let speed = self.speed();
        let origin = root.number("origin");
        let firing = self.firing_section();

        let crankshafts = self.crankshafts();
        let mut drafts = self.throws_and_cylinders(strokes, crankshafts.as_deref(), firing);
        let shafts = self.shafts();
        let gears = self.gears();
        self.check_period(crankshafts.as_deref(), shafts.as_deref());
        let mounts = self.mounts();
        let block = self.block();
        let count = drafts.as_ref().map(|drafts| drafts.throws.len());
        let body_draft = self.body_draft(drafts.as_mut(), crankshafts.as_ref().map(Vec::len));
        let body = body_draft.uniform;
        let material = self.crank_material();
        let weights = self.weight_drafts(count, crankshafts.as_ref().map(Vec::len), &body_draft);
        let shape_task = self.shape_task(&body);
        let shaft_weight_task = self.shaft_weight_task();
        let envelope = self.clearance();
        let gas = self.gas(strokes);
        let friction = self.friction();
        let flywheel = self.flywheel(speed, &body);
        let bearings = self.bearings(&body);
        let bearing_design = self.bearing_design();
        let simulation = self.simulation(drafts.as_ref().map(|drafts| drafts.cylinders.len()));
        let torsion = self.torsion(count);
        let stress = self.stress_task(drafts.as_ref(), crankshafts.as_ref().map(Vec::len));
        let tolerances = self.tolerances();
        let balance = self.balance_draft(count, crankshafts.as_ref().map(Vec::len), mounts.as_deref());
        self.check_shares();
        if drafts.is_none() {
            self.check_order(firing);
        }
        let drafts = drafts?;
        self.check_counts(&drafts);
        self.check_places(&drafts, crankshafts.as_deref());
        self.check_mains(&drafts, crankshafts.as_deref());
        self.check_linkages(&drafts);
        self.check_body(&body_draft, &drafts);
        self.check_bores(&envelope, &drafts);
        self.check_gas(&drafts);
        self.check_bearings(&bearings, &body_draft, &drafts);
        self.check_sizes(&drafts);

        let middle = drafts.middle();
        let tops = self.tops(&drafts, crankshafts.as_deref());
        let firing_angles = self.firing_angles(firing, strokes, tops, drafts.cylinders.len());
        let chambers = self.chambers(&drafts, crankshafts.as_deref());
        let origin = origin.or(middle.unwrap_or(0.0));
        let (mut throws, cylinders): (Option<Vec<_>>, Option<Vec<_>>) = drafts.into_parts();
        if let (Some(throws), Some(origin)) = (&mut throws, origin) {
            for throw in throws {
                throw.move_by(-origin);
            }
        }
        let (mut throws, weighed): (Option<Vec<_>>, Vec<_>) = match throws {
            None => (None, Vec::new()),
            Some(throws) => {
                let (throws, weighed) = throws.into_iter().map(|draft| (draft.throw, draft.weighed)).unzip();
                (Some(throws), weighed)
            }
        };
        let agrees = match &mut throws {
            None => None,
            Some(throws) => self.weigh(throws, &weighed, &body_draft),
        };
        let counterweights = match (&throws, &cylinders, weights, origin) {
            (Some(throws), Some(cylinders), Some(weights), Some(origin)) => {
                self.counterweights(weights, throws, cylinders, &body_draft, origin)
            }
            _ => None,
        };
        if version.is_bad() || note.is_bad() || agrees.is_none() {
            return None;
        }
        let mut parts = EngineParts {
            name: name?,
            note: note.given(),
            strokes: strokes?,
            rotation: rotation?,
            speed: speed?,
            crankshafts: crankshafts?,
            throws: throws?,
            cylinders: cylinders?.into_iter().map(|draft| draft.cylinder).collect(),
            counterweights: counterweights?,
            shafts: shafts?,
            gears: gears?,
            mounts: mounts?,
            block: block?,
            crank_body: body?,
            crank_details: body_draft.into_details()?,
            crank_material: material?,
            envelope: envelope?,
            gas: gas?,
            friction: friction?,
            flywheel: flywheel?,
            bearings: bearings?,
            bearing_design: bearing_design?,
            torsion: torsion?,
        };
        let origin = origin?;
        for main in parts.crankshafts.iter_mut().filter_map(|c| c.mains.as_mut()).flatten() {
            *main -= origin;
        }
        for cylinder in &mut parts.cylinders {
            cylinder.z -= origin;
        }
        for weight in parts.shafts.iter_mut().flat_map(|shaft| &mut shaft.weights) {
            weight.z -= origin;
        }
        for mount in &mut parts.mounts {
            mount.z -= origin;
        }
        if let Some(block) = &mut parts.block {
            block.centre[2] -= origin;
        }
        for (cylinder, angle) in parts.cylinders.iter_mut().zip(firing_angles?) {
            cylinder.firing_angle = angle;
        }
        let chambers = chambers?;
        for (cylinder, chamber) in parts.cylinders.iter_mut().zip(&chambers) {
            cylinder.chamber = chamber.as_ref().map(|chamber| chamber.0);
        }
        self.check_elements(&parts);
        self.check_bearing_numbers(&parts);
        self.check_films(&parts);
        self.check_damping();
        let engine = self.valid(parts)?;
        self.check_chambers(&engine, &chambers)?;
        let tolerances = tolerances?;
        self.check_tolerances(&tolerances, &engine);
        let balance = self.balance_task(balance?, &engine, origin)?;
        let stress = stress?;
        self.check_stress(stress.as_ref(), &engine);
        let tasks = Tasks {
            shape_task: shape_task?,
            simulation: simulation?.map(Box::new),
            tolerances,
            shaft_weight_task: shaft_weight_task?,
            balance,
            stress,
        };
        Some((EngineFile { engine, tasks }, origin))
    }

    /// The engine; what no other check has told of the parts is told without a place.
    fn valid(&mut self, parts: EngineParts) -> Option<Engine> {
        let told = self.mistakes.any_error();
        let faults = match Engine::new(parts) {
            Ok(engine) => return Some(engine),
            Err(faults) => faults,
        };
        for Fault { part, quantity, needed, got, remedy } in faults.into_iter().filter(|_| !told) {
            let message = format!("{part}: {quantity} must be {needed}, got {got}");
            self.mistakes.push(Mistake::error("E0108", 0..0, message).hint(remedy));
        }
        None
    }

    fn speed(&mut self) -> Option<SpeedRange> {
        let field = self.root.numbers("speed");
        let speeds = self.required(self.root, "speed", field)?;
        match speeds.as_slice() {
            [one] => Some(SpeedRange { lowest: one.value, highest: one.value }),
            [lowest, highest] if lowest.value <= highest.value => {
                Some(SpeedRange { lowest: lowest.value, highest: highest.value })
            }
            [lowest, highest] => {
                let [low, high] =
                    [lowest, highest].map(|speed| lanchester_units::readable(speed.value, Dimension::Speed));
                self.mistakes.push(
                    Mistake::error(
                        "E0301",
                        self.root.value_span("speed"),
                        format!("the speed range runs from {low} to {high}"),
                    )
                    .label("lowest speed first")
                    .hint("write the lowest speed first, then the highest; or one speed alone"),
                );
                None
            }
            other => {
                let got = other.len();
                self.mistakes.push(
                    Mistake::error(
                        "E0206",
                        self.root.value_span("speed"),
                        format!("`speed` needs one or two speeds, got {got}"),
                    )
                    .hint("write [\"800 rpm\", \"4000 rpm\"] for a range"),
                );
                None
            }
        }
    }

    /// A short form must not expand to more than the general form may hold.
    fn check_counts(&mut self, drafts: &Drafts<'a>) {
        let most = match self.root.limit("cylinder") {
            Some(most) if drafts.cylinders.len() > most => most,
            _ => return,
        };
        let span = drafts.cylinders.iter().flatten().next().map_or(0..0, |draft| draft.span.clone());
        let message = format!("the layout has {} cylinders, more than {most}", drafts.cylinders.len());
        self.mistakes.push(Mistake::error("E0004", span, message));
    }

    fn check_period(
        &mut self,
        crankshafts: Option<&[Crankshaft]>,
        shafts: Option<&[lanchester_model::BalanceShaft]>,
    ) {
        let (Some(crankshafts), Some(shafts)) = (crankshafts, shafts) else { return };
        let ratios = crankshafts.iter().map(|c| c.ratio).chain(shafts.iter().map(|s| s.ratio));
        let period = ratios.fold(1_u64, |period, ratio| {
            let own = u64::from(ratio.denominator());
            let divisor = u64::from(lanchester_model::greatest_common_divisor(
                u32::try_from(period % own).unwrap_or(0),
                ratio.denominator(),
            ));
            (period / divisor).saturating_mul(own)
        });
        if period > LONGEST_PERIOD {
            let span = match (self.root.has("shaft"), self.root.has("crankshaft")) {
                (true, _) => self.root.key_span("shaft"),
                _ => self.root.key_span("crankshaft"),
            };
            self.mistakes.push(
                Mistake::error(
                    "E0302",
                    span,
                    format!(
                        "the speed ratios repeat only after {period} revolutions, more than {LONGEST_PERIOD}"
                    ),
                )
                .hint("use ratios with common denominators"),
            );
        }
    }
}

/// Most revolutions of crankshaft 1 in a period of all shafts.
const LONGEST_PERIOD: u64 = 64;
