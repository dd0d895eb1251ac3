//! Kinds of engine: the ratios that differ between them.

use lanchester_model::{Engine, GasProcess, GasSource, RodJoint, Strokes};
use serde::{Deserialize, Serialize};

/// What an engine is built for, as far as its proportions tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum EngineKind {
    /// Petrol engine of a motorcycle or another small fast machine.
    MotorcyclePetrol,
    /// Petrol engine of a car.
    CarPetrol,
    /// Turbocharged Diesel engine of a car.
    CarDiesel,
    /// Turbocharged Diesel engine of a truck or a machine.
    TruckDiesel,
    /// Medium-speed Diesel engine of a ship or a power station.
    StationaryDiesel,
    /// Petrol engine of an aeroplane.
    AircraftPetrol,
}

/// Ratios and values of a kind. All are usual practice, not from a source.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ratios {
    pub(super) bore_over_stroke: f64,
    pub(super) pin_over_bore: f64,
    pub(super) journal_over_bore: f64,
    pub(super) compression_ratio: f64,
    /// Pressure before the intake [Pa].
    pub(super) intake: f64,
    /// Highest pressure [Pa].
    pub(super) peak: f64,
    /// Energy of the fuel of one cycle over the swept volume [J/m3].
    pub(super) energy: f64,
    /// Mass of engine and gearbox [kg]: so much, and so much a litre.
    pub(super) mass: [f64; 2],
    /// The flywheel, as a multiple of that of a car.
    pub(super) flywheel: f64,
    /// Bounce of the block on its mounts [Hz].
    pub(super) bounce: f64,
    /// Viscosity of the oil in the bearings [Pa s].
    pub(super) viscosity: f64,
    /// Chen and Flynn's constant [Pa].
    pub(super) friction: f64,
    pub(super) material: &'static str,
}

impl EngineKind {
    /// All kinds.
    pub const ALL: [EngineKind; 6] = [
        EngineKind::MotorcyclePetrol,
        EngineKind::CarPetrol,
        EngineKind::CarDiesel,
        EngineKind::TruckDiesel,
        EngineKind::StationaryDiesel,
        EngineKind::AircraftPetrol,
    ];

    /// Its words with their article: "a car petrol engine".
    pub(super) fn engine(self) -> &'static str {
        match self {
            EngineKind::MotorcyclePetrol => "a motorcycle petrol engine",
            EngineKind::CarPetrol => "a car petrol engine",
            EngineKind::CarDiesel => "a car Diesel engine",
            EngineKind::TruckDiesel => "a truck Diesel engine",
            EngineKind::StationaryDiesel => "a stationary Diesel engine",
            EngineKind::AircraftPetrol => "an aircraft petrol engine",
        }
    }

    /// Its word: "car-petrol".
    pub fn word(self) -> &'static str {
        match self {
            EngineKind::MotorcyclePetrol => "motorcycle-petrol",
            EngineKind::CarPetrol => "car-petrol",
            EngineKind::CarDiesel => "car-diesel",
            EngineKind::TruckDiesel => "truck-diesel",
            EngineKind::StationaryDiesel => "stationary-diesel",
            EngineKind::AircraftPetrol => "aircraft-petrol",
        }
    }

    /// The kind of this word.
    pub fn of_word(word: &str) -> Option<EngineKind> {
        EngineKind::ALL.into_iter().find(|kind| kind.word() == word)
    }

    /// What the numbers of an engine say of its kind, the first that holds:
    ///
    /// 1. pistons that share a chamber, or a Diesel cycle or a compression ratio of 14 or more in `[gas]`: a Diesel. Stroke of 180 mm or
    ///    more: `stationary-diesel`; 100 mm or more: `truck-diesel`; less: `car-diesel`;
    /// 2. three rods or more on one crankpin (radial and W engines), at most 4000 rpm: `aircraft-petrol`;
    /// 3. stroke of 180 mm or more: `stationary-diesel`; at most 3000 rpm and a stroke of 100 mm or more: `truck-diesel`;
    /// 4. four cylinders at most and 7500 rpm or more, or two cylinders at most, or two strokes: `motorcycle-petrol`;
    /// 5. all others: `car-petrol`.
    pub fn of(engine: &Engine) -> EngineKind {
        let stroke = 2.0 * engine.throws.iter().fold(0.0_f64, |most, throw| most.max(throw.radius));
        let rpm = engine.speed.highest * 30.0 / std::f64::consts::PI;
        let diesel = match stroke {
            stroke if stroke >= 0.18 => EngineKind::StationaryDiesel,
            stroke if stroke >= 0.1 => EngineKind::TruckDiesel,
            _ => EngineKind::CarDiesel,
        };
        let says_diesel = engine.gas.as_ref().is_some_and(|gas| {
            gas.compression_ratio().is_some_and(|ratio| ratio >= 14.0) || burns_as_diesel(&gas.source)
        });
        let cylinders = engine.cylinders.len();
        let on_one_pin = (0..engine.throws.len())
            .map(|throw| engine.cylinders.iter().filter(|cylinder| cylinder.throw == throw).count())
            .max();
        let is_radial = on_one_pin.is_some_and(|rods| rods >= 3)
            || engine
                .cylinders
                .iter()
                .filter(|c| matches!(c.rod.joint, RodJoint::Articulated { .. }))
                .count()
                > cylinders / 2;
        if says_diesel || engine.cylinders.iter().any(|cylinder| cylinder.chamber.is_some()) {
            diesel
        } else if is_radial && rpm <= 4000.5 {
            EngineKind::AircraftPetrol
        } else if stroke >= 0.18 || (rpm <= 3000.5 && stroke >= 0.1) {
            diesel
        } else if (cylinders <= 4 && rpm >= 7499.5) || cylinders <= 2 || engine.strokes == Strokes::Two {
            EngineKind::MotorcyclePetrol
        } else {
            EngineKind::CarPetrol
        }
    }

    pub(super) fn ratios(self) -> Ratios {
        let car = Ratios {
            bore_over_stroke: 0.95,
            pin_over_bore: 0.56,
            journal_over_bore: 0.64,
            compression_ratio: 10.5,
            intake: 0.97e5,
            peak: 70e5,
            energy: 2.0e6,
            mass: [70.0, 50.0],
            flywheel: 1.0,
            bounce: 9.0,
            viscosity: 0.010,
            friction: 0.4e5,
            material: "38MnVS6 precipitation hardened",
        };
        const FORGED: &str = "42CrMo4 quenched and tempered";
        match self {
            EngineKind::CarPetrol => car,
            EngineKind::MotorcyclePetrol => Ratios {
                bore_over_stroke: 1.2,
                pin_over_bore: 0.46,
                journal_over_bore: 0.48,
                compression_ratio: 11.5,
                peak: 75e5,
                mass: [15.0, 55.0],
                flywheel: 1.1,
                bounce: 14.0,
                material: FORGED,
                ..car
            },
            EngineKind::CarDiesel => Ratios {
                bore_over_stroke: 0.9,
                pin_over_bore: 0.6,
                journal_over_bore: 0.68,
                compression_ratio: 16.0,
                intake: 2.0e5,
                peak: 160e5,
                energy: 3.0e6,
                mass: [80.0, 65.0],
                flywheel: 1.1,
                friction: 0.6e5,
                material: FORGED,
                ..car
            },
            EngineKind::TruckDiesel => Ratios {
                bore_over_stroke: 0.82,
                pin_over_bore: 0.66,
                journal_over_bore: 0.76,
                compression_ratio: 17.0,
                intake: 2.2e5,
                peak: 180e5,
                energy: 3.4e6,
                mass: [150.0, 85.0],
                flywheel: 1.2,
                bounce: 8.0,
                friction: 0.6e5,
                material: FORGED,
                ..car
            },
            EngineKind::StationaryDiesel => Ratios {
                bore_over_stroke: 0.75,
                pin_over_bore: 0.72,
                journal_over_bore: 0.8,
                compression_ratio: 15.0,
                intake: 3.0e5,
                peak: 180e5,
                energy: 4.0e6,
                mass: [200.0, 110.0],
                flywheel: 1.3,
                bounce: 6.0,
                viscosity: 0.020,
                friction: 0.6e5,
                material: FORGED,
            },
            EngineKind::AircraftPetrol => Ratios {
                bore_over_stroke: 0.95,
                pin_over_bore: 0.5,
                journal_over_bore: 0.52,
                compression_ratio: 6.5,
                intake: 1.1e5,
                peak: 55e5,
                mass: [30.0, 16.0],
                // Of the airscrew.
                flywheel: 4.0,
                bounce: 10.0,
                viscosity: 0.015,
                material: FORGED,
                ..car
            },
        }
    }
}

/// Whether the cycle of the file is one that petrol engines do not have.
fn burns_as_diesel(source: &GasSource) -> bool {
    matches!(source, GasSource::Cycle(cycle) if matches!(cycle.process, GasProcess::Diesel { .. }))
}

impl std::fmt::Display for EngineKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.word())
    }
}
