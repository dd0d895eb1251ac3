//! Gas in the cylinders and under the pistons.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::entry::{key, quantity};
use lanchester_units::Dimension::{
    Angle, Area, Energy, HeatCapacity, HeatTransfer, Length, Pressure, SpecificEnergy, SpecificHeat, Speed,
    Temperature, ThermalConductance,
};

/// Files of traces, one a speed.
const MOST_TRACES: usize = 64;

pub(super) static GAS: Table = Table {
    header: "[gas]",
    doc: "Gas in the cylinders: either measured traces, `[[gas.trace]]`, or a cycle to be computed, `[gas.cycle]`. Every cylinder needs its bore. Angles count \
          from the cylinder's own firing top dead centre in the sense of rotation.",
    keys: &[
        key(
            "compression_ratio",
            Kind::Number(Positive),
            Optional,
            "Largest over smallest volume of a cylinder. A cycle needs it; beside traces it gives the volumes of the p-V diagram.",
            "10.5",
        ),
        pressure(
            "ambient_pressure",
            "Pressure of the surroundings, from which gauge pressures count; default one atmosphere.",
            "\"1.01325 bar\"",
        ),
        key(
            "trace",
            Kind::Tables(&TRACE, MOST_TRACES),
            Optional,
            "Measured traces, one file a speed.",
            "[{ file = \"pressure.csv\" }]",
        ),
        key("cycle", Kind::Table(&CYCLE), Optional, "The cycle to be computed.", "{ type = \"otto\" }"),
        key(
            "intake",
            Kind::Table(&INTAKE),
            Optional,
            "Gas before the intake, and the way in.",
            "{ pressure = \"0.95 bar\" }",
        ),
        key(
            "exhaust",
            Kind::Table(&EXHAUST),
            Optional,
            "Gas behind the exhaust, and the way out.",
            "{ pressure = \"1.1 bar\" }",
        ),
        key("fuel", Kind::Table(&FUEL), Optional, "What burns.", "{ energy = \"1200 J\" }"),
        key(
            "heat_release",
            Kind::Table(&HEAT_RELEASE),
            Optional,
            "When it burns, in a single zone.",
            "{ start = \"-15 deg\", duration = \"50 deg\" }",
        ),
        key(
            "walls",
            Kind::Table(&WALLS),
            Optional,
            "Heat to the walls of a single zone; adiabatic without.",
            "{ model = \"woschni\" }",
        ),
        key(
            "crankcase",
            Kind::Table(&CRANKCASE),
            Optional,
            "Pressure under the pistons; default that of the surroundings.",
            "{ pressure = \"0.98 bar\" }",
        ),
    ],
};

const FILE: Key = key(
    "file",
    Kind::Text(200),
    Required,
    "Name of the CSV file, from the folder of the engine file. Its header names angle and pressures with their units: `theta [deg], p [bar]`; one pressure for all \
     cylinders, or one for each in their order.",
    "\"pressure-3000.csv\"",
);
const SPEED: Key = quantity(
    "speed",
    Speed,
    Positive,
    "Speed of crankshaft 1 at which it was measured; needed if there are several.",
    "\"3000 rpm\"",
);
const KIND: Key = key(
    "pressures",
    Kind::Choice(&["absolute", "gauge"]),
    Optional,
    "What the pressures count from; default absolute.",
    "\"gauge\"",
);
const TOP: Key = quantity(
    "top_dead_centre",
    Angle,
    Any,
    "Angle in the file of the firing top dead centre; default 0 deg.",
    "\"360 deg\"",
);
const COUNTED_FROM: Key = key(
    "counted_from",
    Kind::Choice(&["own firing", "cylinder 1"]),
    Optional,
    "Whose firing top dead centre the angles count from: that of each cylinder itself (default), or for all columns that of cylinder 1.",
    "\"cylinder 1\"",
);

static TRACE: Table = Table {
    header: "[[gas.trace]]",
    doc: "A file with measured pressures over one cycle, at one speed. Between two speeds pressures are interpolated; beyond them they are held.",
    keys: &[FILE, SPEED, KIND, TOP, COUNTED_FROM],
};

static CRANKCASE: Table = Table {
    header: "[gas.crankcase]",
    doc: "Pressure under the pistons: one value, or a file as in `[[gas.trace]]`.",
    keys: &[
        pressure("pressure", "Absolute pressure, the same at all angles.", "\"0.98 bar\""),
        Key { need: Optional, ..FILE },
        KIND,
        TOP,
        COUNTED_FROM,
    ],
};

static CYCLE: Table = Table {
    header: "[gas.cycle]",
    doc: "The cycle to be computed. Ideal cycles take pressures, temperature and heat from `[gas.intake]`, `[gas.exhaust]` and `[gas.fuel]`; a single zone needs the timing of \
          intake and exhaust too, and `[gas.heat_release]` unless it is motored.",
    keys: &[
        key(
            "type",
            Kind::Choice(&["otto", "diesel", "seiliger", "sealed", "single-zone"]),
            Required,
            "Otto: heat at constant volume. Diesel: heat at constant pressure. Seiliger: both, in this order. Sealed: a closed cylinder without valves and heat, in which p V^n stays the same in every revolution. Single-zone: filling and emptying through the valves, heat release by \
             Wiebe functions, heat to the walls.",
            "\"single-zone\"",
        ),
        key(
            "heat_capacity_ratio",
            Kind::Number(Positive),
            Optional,
            "Ratio of the specific heats, and n of a closed cylinder; default 1.4, for a single zone 1.32.",
            "1.32",
        ),
        quantity(
            "gas_constant",
            SpecificHeat,
            Positive,
            "Gas constant; default 287.05 J/kg/K.",
            "\"287.05 J/kg/K\"",
        ),
        pressure(
            "peak_pressure",
            "Otto: in place of the heat. Seiliger: constant volume up to this pressure, the rest of the heat at constant pressure.",
            "\"70 bar\"",
        ),
        key(
            "constant_volume_share",
            Kind::Share,
            Optional,
            "Seiliger: share of the heat at constant volume, in place of the peak pressure.",
            "\"40 %\"",
        ),
        pressure(
            "pressure",
            "Sealed: absolute pressure at bottom dead centre; default that of the surroundings.",
            "\"1 bar\"",
        ),
        quantity(
            "temperature",
            Temperature,
            Positive,
            "Sealed: temperature at bottom dead centre; default 25 degC.",
            "\"25 degC\"",
        ),
    ],
};

const OPENS: Key = quantity("opens", Angle, Any, "Angle at which it begins to open.", "\"345 deg\"");
const CLOSES: Key = quantity(
    "closes",
    Angle,
    Any,
    "Angle at which it is closed; not given for ports, which the piston closes.",
    "\"590 deg\"",
);
const LIFT: Key = quantity(
    "lift",
    Length,
    Positive,
    "Largest lift of the valves; the lift goes with the square of a sine over the angle.",
    "\"9 mm\"",
);
const DIAMETER: Key = quantity("diameter", Length, Positive, "Diameter of the valve seats.", "\"34 mm\"");
const NUMBER: Key =
    key("number", Kind::Whole(1, 8), Optional, "How many valves a cylinder has; default 1.", "2");
const AREA: Key = quantity(
    "area",
    Area,
    Positive,
    "Largest area in place of lift and diameter; without `closes` the area of ports of constant width that the piston uncovers, at bottom dead centre.",
    "\"900 mm2\"",
);
const DISCHARGE: Key = key(
    "discharge_coefficient",
    Kind::Number(Positive),
    Optional,
    "Share of the area through which the flow passes; default 0.7.",
    "0.7",
);
const PISTON_CLEARANCE: Key = quantity(
    "piston_clearance",
    Length,
    Positive,
    "Distance of the closed valve from the piston at top dead centre, along the cylinder axis, in its pocket: whether they meet is checked.",
    "\"6 mm\"",
);

static INTAKE: Table = Table {
    header: "[gas.intake]",
    doc: "Gas before the intake valves or ports; for a single zone also when they are open and how far. Their angles count from the firing top dead centre, so that a four-stroke engine takes in from \
          about 345 deg to 590 deg.",
    keys: &[
        pressure("pressure", "Absolute pressure; default that of the surroundings.", "\"0.95 bar\""),
        quantity("temperature", Temperature, Positive, "Temperature; default 25 degC.", "\"40 degC\""),
        OPENS,
        CLOSES,
        LIFT,
        DIAMETER,
        NUMBER,
        AREA,
        DISCHARGE,
        PISTON_CLEARANCE,
    ],
};

static EXHAUST: Table = Table {
    header: "[gas.exhaust]",
    doc: "Gas behind the exhaust valves or ports, and for a single zone when they are open and how far: in a four-stroke engine from about 130 deg to 375 deg.",
    keys: &[
        pressure("pressure", "Absolute pressure; default that of the surroundings.", "\"1.1 bar\""),
        quantity(
            "temperature",
            Temperature,
            Positive,
            "Temperature of what flows back, in a single zone; default 800 K.",
            "\"900 K\"",
        ),
        OPENS,
        CLOSES,
        LIFT,
        DIAMETER,
        NUMBER,
        AREA,
        DISCHARGE,
        PISTON_CLEARANCE,
    ],
};

static FUEL: Table = Table {
    header: "[gas.fuel]",
    doc: "Chemical energy in one cylinder and cycle: itself, or by the fresh air that the cylinder holds. The mass of the fuel is left out.",
    keys: &[
        quantity("energy", Energy, Positive, "The energy itself.", "\"1200 J\""),
        key(
            "equivalence_ratio",
            Kind::Number(Positive),
            Optional,
            "Fuel over air, divided by that of complete combustion, in place of the energy; above 1 the air decides what burns.",
            "1.0",
        ),
        key(
            "air_fuel_ratio",
            Kind::Number(Positive),
            Optional,
            "Air over fuel of complete combustion, by mass; default 14.6.",
            "14.6",
        ),
        quantity(
            "heating_value",
            SpecificEnergy,
            Positive,
            "Lower heating value; default 42.7 MJ/kg.",
            "\"42.7 MJ/kg\"",
        ),
        key(
            "efficiency",
            Kind::Share,
            Optional,
            "Share of the energy that is released; default 100 %.",
            "\"97 %\"",
        ),
    ],
};

const START: Key = key(
    "start",
    Kind::Quantity(Angle, Any),
    Required,
    "Angle at which it begins, negative before top dead centre.",
    "\"-15 deg\"",
);
const DURATION: Key =
    key("duration", Kind::Quantity(Angle, Positive), Required, "Angle over which it lasts.", "\"50 deg\"");
const EXPONENT: Key =
    key("exponent", Kind::Number(NotNegative), Optional, "Exponent m of the Wiebe function; default 2.", "2");
const COMPLETENESS: Key = key(
    "completeness",
    Kind::Share,
    Optional,
    "Share that the Wiebe function would have released at its end, 1 - exp(-a), before it is scaled to be complete; default 99.9 %.",
    "\"99.9 %\"",
);

static HEAT_RELEASE: Table = Table {
    header: "[gas.heat_release]",
    doc: "When the heat is released in a single zone: a Wiebe function, or two.",
    keys: &[
        START,
        DURATION,
        EXPONENT,
        COMPLETENESS,
        key(
            "second",
            Kind::Table(&SECOND),
            Optional,
            "A second Wiebe function.",
            "{ share = \"30 %\", start = \"5 deg\", duration = \"60 deg\" }",
        ),
    ],
};

static SECOND: Table = Table {
    header: "[gas.heat_release.second]",
    doc: "The second Wiebe function.",
    keys: &[
        key("share", Kind::Share, Required, "Share of the heat that it releases.", "\"30 %\""),
        START,
        DURATION,
        EXPONENT,
        COMPLETENESS,
    ],
};

static WALLS: Table = Table {
    header: "[gas.walls]",
    doc: "Heat to the walls of a single zone.",
    keys: &[
        key(
            "model",
            Kind::Choice(&["woschni", "hohenberg", "constant", "table", "conductance"]),
            Optional,
            "Whose heat transfer coefficient, or given: the same at every angle, or a table over the angle; or a conductance to one body, which gives heat to the surroundings; default Woschni's.",
            "\"hohenberg\"",
        ),
        quantity(
            "coefficient",
            HeatTransfer,
            Positive,
            "`constant`: heat transfer coefficient.",
            "\"600 W/m2/K\"",
        ),
        key(
            "angles",
            Kind::Quantities(Angle, Any),
            Optional,
            "`table`: angles from the firing top dead centre, rising, within one cycle.",
            "[\"-180 deg\", \"0 deg\", \"60 deg\"]",
        ),
        key(
            "coefficients",
            Kind::Quantities(HeatTransfer, Positive),
            Optional,
            "`table`: heat transfer coefficients at these angles, straight between them.",
            "[\"150 W/m2/K\", \"900 W/m2/K\", \"1400 W/m2/K\"]",
        ),
        quantity(
            "conductance",
            ThermalConductance,
            Positive,
            "`conductance`: from the gas of one cylinder to the body of the engine.",
            "\"1 W/K\"",
        ),
        quantity(
            "body_capacity",
            HeatCapacity,
            Positive,
            "`conductance`: heat capacity of the body, which all cylinders share.",
            "\"36.8 kJ/K\"",
        ),
        quantity(
            "body_to_ambient",
            ThermalConductance,
            Positive,
            "`conductance`: from the body to the surroundings.",
            "\"25 W/K\"",
        ),
        quantity(
            "body_temperature",
            Temperature,
            Positive,
            "`conductance`: temperature of the body, at the start of a run with gas as states; default the one at which it settles at the speed in question.",
            "\"380 K\"",
        ),
        quantity(
            "ambient_temperature",
            Temperature,
            Positive,
            "`conductance`: temperature of the surroundings; default that of the intake.",
            "\"300 K\"",
        ),
        key(
            "factor",
            Kind::Number(Positive),
            Optional,
            "Factor on the coefficient, or on the conductance from the gas; default 1.",
            "1.1",
        ),
        quantity(
            "temperature",
            Temperature,
            Positive,
            "Temperature of all walls; default 450 K.",
            "\"450 K\"",
        ),
        quantity(
            "piston_temperature",
            Temperature,
            Positive,
            "Temperature of the piston's crown; default that of all walls.",
            "\"520 K\"",
        ),
        quantity(
            "head_temperature",
            Temperature,
            Positive,
            "Temperature of the head; default that of all walls.",
            "\"480 K\"",
        ),
        quantity(
            "liner_temperature",
            Temperature,
            Positive,
            "Temperature of the liner; default that of all walls.",
            "\"400 K\"",
        ),
        key(
            "piston_area",
            Kind::Number(Positive),
            Optional,
            "Area of the crown over that of the bore; default 1.",
            "1.05",
        ),
        key(
            "head_area",
            Kind::Number(Positive),
            Optional,
            "Area of the head over that of the bore; default 1.1.",
            "1.1",
        ),
    ],
};

const fn pressure(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    quantity(name, Pressure, Positive, doc, example)
}
