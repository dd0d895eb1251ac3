"""Types of all results: a class for every structure, with its fields, units and meanings.

Written by `cargo xtask python --write` from the Rust types. Do not edit. SI units and radians; complex numbers are rows of real and imaginary part.
"""

# ruff: noqa

from __future__ import annotations

from typing import Any, Literal

from ._record import FloatArray, Matrices, Record, Records, Result, Variant, an_array, every, one, optionally, record, row

__all__ = [
    "Active",
    "AffectedPart",
    "Answer",
    "ArrangedShaft",
    "Arrangement",
    "ArrangementClearance",
    "Arrangements",
    "Articulation",
    "Assignment",
    "AtLeast",
    "Audit",
    "AxisLine",
    "Balance",
    "BalanceSettings",
    "BalanceTask",
    "BankPair",
    "BeamLoads",
    "BearingCycle",
    "BearingFilm",
    "BearingFilms",
    "BearingLoads",
    "Bearings",
    "Bending",
    "BendingAlong",
    "BeyondTable",
    "BigEndClearance",
    "Bobweight",
    "BobweightAnswer",
    "BobweightComparison",
    "BodyClearances",
    "BodyState",
    "BondEnergy",
    "BondGraph",
    "BoreSheet",
    "Bounds",
    "Brake",
    "Broken",
    "Campbell",
    "Cancellation",
    "CancellationVerdict",
    "CancelledOrder",
    "Capability",
    "Carried",
    "CarriedWeight",
    "Catalogue",
    "CatalogueHole",
    "Chain",
    "ChainEnergy",
    "ChamberMotion",
    "CheckedCounterweight",
    "CheckedShaftWeight",
    "ChoiceCount",
    "Clearance",
    "Clearances",
    "CommonFactor",
    "Compared",
    "ComparedBalance",
    "ComparedTorque",
    "Comparison",
    "ConditionCheck",
    "Consequence",
    "Consequences",
    "ContactReport",
    "Contribution",
    "ConvergedNumber",
    "Convergence",
    "ConvergenceMesh",
    "Correction",
    "Cost",
    "Cost2",
    "CounterweightCheck",
    "CounterweightDesigns",
    "CounterweightPattern",
    "CounterweightShape",
    "Counts",
    "CrankBody",
    "CrankCase",
    "CrankChain",
    "CrankCycle",
    "CrankFatigue",
    "CrankLoad",
    "CrankMesh",
    "CrankMeshOptions",
    "CrankModes",
    "CrankRule",
    "CrankSheet",
    "CrankUnbalance",
    "CrankWithBobweights",
    "CrankshaftBody",
    "CrankshaftMoments",
    "CrankshaftSection",
    "Criterion",
    "Critical",
    "CriticalPlane",
    "CrossCheck",
    "CrossRow",
    "Curve",
    "CycleOptions",
    "CycleOutcome",
    "CycleResult",
    "CycleRun",
    "CycleTrace",
    "CylinderBearings",
    "CylinderExtremes",
    "CylinderLoads",
    "CylinderMotion",
    "CylinderParts",
    "CylinderReactions",
    "CylinderStrokes",
    "CylinderTorque",
    "DampedMode",
    "DampedMode2",
    "DamperSweep",
    "Design",
    "DesignLimits",
    "DesignOutcome",
    "DesignSettings",
    "DesignedCounterweight",
    "Deviation",
    "Diagnosis",
    "Distribution",
    "DistributionNormal",
    "DrillCatalogue",
    "DrilledPlane",
    "Drilling",
    "DriveLink",
    "DriveTrain",
    "DrivelineBody",
    "DurabilityCriterion",
    "DurabilityWish",
    "Durable",
    "DurableEnd",
    "DurableLimit",
    "DurableRow",
    "DurableStage",
    "Effect",
    "Effect2",
    "ElementEnergy",
    "ElementWeb",
    "EnergyBalance",
    "EnergyLedger",
    "EnergyVariation",
    "Evolution",
    "Evolved",
    "ExchangeResult",
    "Exploration",
    "ExternalBalance",
    "Extrapolated",
    "Extreme",
    "Extremes",
    "Factor",
    "FactorAnswer",
    "FactorChoice",
    "FactorEffect",
    "FactorGiven",
    "FactorPart",
    "FactorValues",
    "FatigueAtSpeed",
    "FatigueFactors",
    "FatigueMeasure",
    "FilletCycle",
    "FilletFatigue",
    "FilletPlace",
    "FilletSheet",
    "FilmEnergy",
    "FilmOrbit",
    "Finding",
    "Findley",
    "Firing",
    "FiringChart",
    "FiringStar",
    "FirstOrder",
    "FlywheelNeed",
    "Followed",
    "FoundInertia",
    "FoundLayout",
    "FoundLimit",
    "FoundShaft",
    "FoundStage",
    "FoundWeight",
    "FreeInertia",
    "FreeShaft",
    "FreeSpeed",
    "FreeWeight",
    "Functional",
    "FunctionalTerm",
    "Gear",
    "GearSeat",
    "GiveUp",
    "GivenEngine",
    "Grade",
    "GradedBearing",
    "GradedPlane",
    "GraphAudit",
    "GraphEvent",
    "GraphPeriodicMotion",
    "GraphRun",
    "Happened",
    "Hole",
    "HolzerRow",
    "HolzerTable",
    "IncompleteInertia",
    "Index",
    "Indicated",
    "IndicatedWork",
    "InertiaSum",
    "Inertias",
    "Infeasible",
    "Influence",
    "IntegrationOutcome",
    "IntegrationOutcomeEvent",
    "IntegrationOutcomeNotFinite",
    "IntegrationOutcomeStepTooSmall",
    "IntegrationOutcomeStiff",
    "IntegrationOutcomeTooManyEvaluations",
    "InternalBalance",
    "InternalMoments",
    "InternalPlane",
    "InvalidCount",
    "JournalBearing",
    "JournalInFilm",
    "JudgedBy",
    "JudgedCase",
    "JudgedSpeeds",
    "Layout",
    "LayoutOrders",
    "Leading",
    "LeastFilm",
    "Limit",
    "LimitVerdict",
    "Load",
    "LoadSet",
    "Loads",
    "MainBearing",
    "MainLoad",
    "MainRules",
    "Mains",
    "MassProperties",
    "Material",
    "Measured",
    "MeshOrigins",
    "MeshQuality",
    "MeshedThrow",
    "Method",
    "Mode",
    "Mode2",
    "ModeCount",
    "ModeSolution",
    "MotionTrace",
    "MountAtRest",
    "MountMode",
    "MountModes",
    "MountResponse",
    "MountStatics",
    "MountStudy",
    "MountedBody",
    "Nearest",
    "NearestLimit",
    "NextStep",
    "NominalBore",
    "NominalWeb",
    "Objective",
    "ObjectiveCouple",
    "ObjectiveCoupleSense",
    "ObjectiveFiringHarmonic",
    "ObjectiveForce",
    "ObjectiveForceSense",
    "ObjectiveInertiaTorque",
    "ObjectiveRollMoment",
    "Obstacle",
    "Obstruction",
    "Occasion",
    "OilFactors",
    "Optimum",
    "OrderLoads",
    "OrderResponse",
    "OrderStar",
    "Outcome",
    "Output",
    "OutputCouple",
    "OutputCoupleSense",
    "OutputForce",
    "OutputForceSense",
    "OutputScatter",
    "OutputSensitivity",
    "Overlap",
    "PartLoads",
    "Peak",
    "Peak2",
    "PeakStress",
    "Peaks",
    "PendulumSweep",
    "Percentile",
    "PeriodHeat",
    "PeriodSummary",
    "PeriodicResult",
    "Phase",
    "PinForces",
    "PinLoad",
    "PinLoad2",
    "PinParts",
    "Place",
    "Placement",
    "PlaneCorrection",
    "PlaneUnbalance",
    "Point",
    "PointFatigue",
    "PointMotion",
    "PointMotion2",
    "PointWeight",
    "PowerCurve",
    "Price",
    "PrimaryEllipse",
    "QuasiStatic",
    "RadialEnvelope",
    "RadiusAndMass",
    "Range",
    "RangeBreach",
    "Ranking",
    "RankingPlace",
    "Reactions",
    "ReducedCrank",
    "ReducedModel",
    "Remark",
    "Removes",
    "RemovesBoth",
    "RemovesCouple",
    "RemovesForce",
    "Residual",
    "RippleOutcome",
    "RobustAnswer",
    "RobustLimit",
    "RobustMeasure",
    "RobustStage",
    "RotatingBody",
    "RotatingKind",
    "RotorEffects",
    "RotorExtremes",
    "RotorReactions",
    "RuleFactors",
    "Run",
    "Run2",
    "RunEntry",
    "RunExtremes",
    "RunFindings",
    "RunOutcome",
    "Samples",
    "Scatter",
    "ScatterStudy",
    "Seat",
    "SectionRatios",
    "Sensitivity",
    "SensorEntry",
    "SensorPrediction",
    "Series",
    "SeriesStatistics",
    "Shaft",
    "ShaftDesign",
    "ShaftLayout",
    "ShaftRun",
    "ShaftSection",
    "ShaftSet",
    "ShaftSweep",
    "ShapeTask",
    "SharedWithWeb",
    "Shoulder",
    "ShownVibration",
    "Similar",
    "SimulatedOrder",
    "SimulationResult",
    "Size",
    "Slope",
    "Slug",
    "SlugPlan",
    "Smallest",
    "Sobol",
    "SolveReport",
    "Sourced",
    "SpacingArrangements",
    "SpeedResponse",
    "SpeedRipple",
    "SpeedSheet",
    "Stage",
    "StageGiveUp",
    "Stall",
    "StaticStress",
    "Station",
    "Station2",
    "StationKind",
    "StationSweep",
    "Statistics",
    "StiffnessCentre",
    "StoppedEngine",
    "StressCase",
    "StressMaterial",
    "StressSubmodel",
    "StrokeSpan",
    "SubmodelFillet",
    "SurfacePeak",
    "Sweep",
    "SweptOverlap",
    "SweptRoom",
    "Target",
    "ThrowFactor",
    "ThrowInertia",
    "ThrowMasses",
    "ThrowMesh",
    "ThrowParts",
    "ThrowShare",
    "ThrowSheet",
    "Tie",
    "Tightened",
    "TimeAmplitudes",
    "TimeCheck",
    "Tolerance",
    "Tolerances",
    "Torque",
    "TorqueAtSpeed",
    "TorqueHarmonic",
    "TorqueReport",
    "TorsionLimit",
    "TorsionResult",
    "Trace",
    "TrainInertia",
    "Transmissibility",
    "TuneAim",
    "TunePoint",
    "TunedDamper",
    "TurningInertia",
    "Unmeasured",
    "VariedInput",
    "VariedQuantity",
    "WebBound",
    "WebPlace",
    "WebSection",
    "WebSheet",
    "WeightAsPart",
    "WorstCase",
    "Wrench",
]


class Active(Record):
    """A crank angle at which a criterion stands at its peak and holds the optimum up."""

    __slots__ = ()
    _FIELDS = ("criterion", "multiplier", "speed", "theta",)

    @property
    def criterion(self) -> Criterion:
        """Which criterion."""
        return self._of("criterion", Criterion)  # type: ignore[no-any-return]

    @property
    def multiplier(self) -> float:
        """Its share of the proof: the multipliers of a criterion add up to its weight in the stage (to the shadow price of the
        limit for a limited one).
        """
        return self._get("multiplier")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float | None:
        """Speed of crankshaft 1 [rad/s], where the criterion is judged at several: with gas."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def theta(self) -> float:
        """Crank angle [rad]."""
        return self._get("theta")  # type: ignore[no-any-return]


class AffectedPart(Record):
    """Where in the engine a quantity is."""

    __slots__ = ()
    _FIELDS = ("kind", "crankshaft", "main", "z", "bay", "between",)

    @property
    def kind(self) -> Literal['engine', 'crankshaft', 'main', 'bay']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def crankshaft(self) -> int | None:
        """Number of its crankshaft, from 1."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def main(self) -> int | None:
        """Its number from the free end, from 1."""
        return self._get("main")  # type: ignore[no-any-return]

    @property
    def z(self) -> float | None:
        """Its plane [m], from the origin."""
        return self._get("z")  # type: ignore[no-any-return]

    @property
    def bay(self) -> int | None:
        """Number of its front main, from 1."""
        return self._get("bay")  # type: ignore[no-any-return]

    @property
    def between(self) -> FloatArray:
        """Planes of its two mains [m], from the origin."""
        return self._array("between")  # type: ignore[no-any-return]


class Answer(Record):
    """The best that can be done with the given devices."""

    __slots__ = ()
    _FIELDS = ("among_equals", "cancellation", "effects", "engine", "gas_speeds", "inertias", "limits", "method", "mount_gas_speeds", "mount_speeds", "outcome", "settings", "shafts", "speed", "stages", "task", "version", "web_bounds", "weights",)

    @property
    def among_equals(self) -> Records[FoundStage]:
        """What decided among answers that the stages leave equal: of force and couple what no stage names, then the roll
        moment if an inertia or the axis of a shaft is free (unless a stage asks for the least weights), then, if a weight on a
        crankshaft is free, the root mean square of all main-bearing loads, the largest of them and the bending moment, each
        without degrading the previous ones. Empty where nothing was left open. Among what is still equal the answer is the lightest.
        """
        return self._all("among_equals", FoundStage)

    @property
    def cancellation(self) -> Cancellation | None:
        """Where orders had to vanish exactly: whether they do, and the proof."""
        return self._of("cancellation", Cancellation)  # type: ignore[no-any-return]

    @property
    def effects(self) -> Records[Effect]:
        """Criteria before and after: force, couple, roll moment, root mean square of all main-bearing loads, the largest of them
        and the bending moment always, then those that the task names. Empty where no answer was found.
        """
        return self._all("effects", Effect)

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def gas_speeds(self) -> JudgedSpeeds | None:
        """Where main-bearing loads with gas are judged: the speeds that decide [rad/s], and where the largest of them stands."""
        return self._of("gas_speeds", JudgedSpeeds)  # type: ignore[no-any-return]

    @property
    def inertias(self) -> Records[FoundInertia]:
        """Every free inertia."""
        return self._all("inertias", FoundInertia)

    @property
    def limits(self) -> Records[FoundLimit]:
        """What each limit costs."""
        return self._all("limits", FoundLimit)

    @property
    def method(self) -> Method:
        """How it was found."""
        return self._of("method", Method)  # type: ignore[no-any-return]

    @property
    def mount_gas_speeds(self) -> JudgedSpeeds | None:
        """The same of forces at mounts with gas."""
        return self._of("mount_gas_speeds", JudgedSpeeds)  # type: ignore[no-any-return]

    @property
    def mount_speeds(self) -> JudgedSpeeds | None:
        """Where forces of inertia at mounts with springs are judged: the speeds that decide [rad/s], and where the largest of them stands."""
        return self._of("mount_speeds", JudgedSpeeds)  # type: ignore[no-any-return]

    @property
    def outcome(self) -> Outcome:
        """Whether there is an optimum, and if not, why."""
        return self._of("outcome", Outcome)  # type: ignore[no-any-return]

    @property
    def settings(self) -> BalanceSettings:
        """How far the search went, where it was one over choices."""
        return self._of("settings", BalanceSettings)  # type: ignore[no-any-return]

    @property
    def shafts(self) -> Records[FoundShaft]:
        """Where the free shafts stand."""
        return self._all("shafts", FoundShaft)

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 at which loads are judged [rad/s]: the highest of the engine, where all of them are largest."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def stages(self) -> Records[FoundStage]:
        """What each stage reached, with its proof."""
        return self._all("stages", FoundStage)

    @property
    def task(self) -> BalanceTask:
        """What was asked."""
        return self._of("task", BalanceTask)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def web_bounds(self) -> Records[WebBound]:
        """Weights on webs whose largest amount is what fits there: the optimum is one within these bounds."""
        return self._all("web_bounds", WebBound)

    @property
    def weights(self) -> Records[FoundWeight]:
        """Every free weight. Empty where there is no optimum."""
        return self._all("weights", FoundWeight)


class ArrangedShaft(Record):
    """A balance shaft of an arrangement."""

    __slots__ = ()
    _FIELDS = ("bearing_loads", "bearing_planes", "inertia", "layout", "name", "ratio", "shaft_mass", "weight_length", "weight_mass", "weight_sweep", "x", "y",)

    @property
    def bearing_loads(self) -> FloatArray:
        """Radial load of each bearing [N]; it turns with the shaft at a constant amount."""
        return self._array("bearing_loads")  # type: ignore[no-any-return]

    @property
    def bearing_planes(self) -> FloatArray:
        """Planes of its two bearings [m]."""
        return self._array("bearing_planes")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> float:
        """Inertia of weights and shaft about its own axis [kg m^2]."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def layout(self) -> ShaftLayout:
        """Weights in one plane or two."""
        return self._of("layout", ShaftLayout)  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name, as in the answer."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> int:
        """Speed over that of crankshaft 1, signed."""
        return self._get("ratio")  # type: ignore[no-any-return]

    @property
    def shaft_mass(self) -> float:
        """Mass of the bare shaft [kg]."""
        return self._get("shaft_mass")  # type: ignore[no-any-return]

    @property
    def weight_length(self) -> float:
        """Length of its longest weight along the axis [m]."""
        return self._get("weight_length")  # type: ignore[no-any-return]

    @property
    def weight_mass(self) -> float:
        """Mass of its weights [kg]."""
        return self._get("weight_mass")  # type: ignore[no-any-return]

    @property
    def weight_sweep(self) -> float:
        """Outer radius of its weights [m]."""
        return self._get("weight_sweep")  # type: ignore[no-any-return]

    @property
    def x(self) -> float:
        """Position of its axis [m]."""
        return self._get("x")  # type: ignore[no-any-return]

    @property
    def y(self) -> float:
        """Position of its axis [m]."""
        return self._get("y")  # type: ignore[no-any-return]


class Arrangement(Record):
    """One arrangement with its weights, drive and price."""

    __slots__ = ()
    _FIELDS = ("answer", "bending_moment", "clearance", "couple", "crank_weights", "drive", "force", "label", "lightest", "main_load", "name", "on_front", "possible", "price", "reaches_limit", "residual", "roll_moment", "shafts",)

    @property
    def answer(self) -> Answer:
        """The weights, with the proof that these devices leave no less."""
        return self._of("answer", Answer)  # type: ignore[no-any-return]

    @property
    def bending_moment(self) -> float:
        """Largest bending moment along any crankshaft as a free beam under what turns with it [N m]."""
        return self._get("bending_moment")  # type: ignore[no-any-return]

    @property
    def clearance(self) -> ArrangementClearance | None:
        """The narrowest place between the parts; `None` without shafts. Negative where no allowed position clears."""
        return self._of("clearance", ArrangementClearance)  # type: ignore[no-any-return]

    @property
    def couple(self) -> float:
        """Peak of the resultant couple about the origin that is left [N m]."""
        return self._get("couple")  # type: ignore[no-any-return]

    @property
    def crank_weights(self) -> bool:
        """Whether weights are added to the crank."""
        return self._get("crank_weights")  # type: ignore[no-any-return]

    @property
    def drive(self) -> DriveTrain | None:
        """How the shafts are driven; `None` without shafts or without a place for them."""
        return self._of("drive", DriveTrain)  # type: ignore[no-any-return]

    @property
    def force(self) -> float:
        """Peak of the resultant force that is left [N]."""
        return self._get("force")  # type: ignore[no-any-return]

    @property
    def label(self) -> str:
        """In short: "crank +2 -2", each number a balance shaft by its speed over that of the crank; "crank -1, lightest"
        with the lightest weights that hold the limit; "nothing".
        """
        return self._get("label")  # type: ignore[no-any-return]

    @property
    def lightest(self) -> bool:
        """Whether its weights are the lightest that hold the limit; else they leave the smallest residual."""
        return self._get("lightest")  # type: ignore[no-any-return]

    @property
    def main_load(self) -> float:
        """Largest load of inertia on any main bearing over the cycle, throw by throw [N]."""
        return self._get("main_load")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """In words: "crank weights, second-order shafts with and against the crank"."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def on_front(self) -> bool:
        """Whether no other arrangement at this spacing beats it."""
        return self._get("on_front")  # type: ignore[no-any-return]

    @property
    def possible(self) -> bool:
        """Whether it has a place and a drive, and holds the further limits."""
        return self._get("possible")  # type: ignore[no-any-return]

    @property
    def price(self) -> Price:
        """What it costs."""
        return self._of("price", Price)  # type: ignore[no-any-return]

    @property
    def reaches_limit(self) -> bool | None:
        """Whether the residual is at or below the limit, within 1e-6 of it."""
        return self._get("reaches_limit")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """Peak of the criterion that is left. Not a number for an arrangement that cannot hold the further limits."""
        return self._get("residual")  # type: ignore[no-any-return]

    @property
    def roll_moment(self) -> float:
        """Peak of the roll moment that is left [N m], at the places of the shafts."""
        return self._get("roll_moment")  # type: ignore[no-any-return]

    @property
    def shafts(self) -> Records[ArrangedShaft]:
        """Its balance shafts."""
        return self._all("shafts", ArrangedShaft)


class ArrangementClearance(Record):
    """The narrowest place."""

    __slots__ = ()
    _FIELDS = ("between", "distance",)

    @property
    def between(self) -> str:
        """Which parts, in words, with the crank angle for moving ones."""
        return self._get("between")  # type: ignore[no-any-return]

    @property
    def distance(self) -> float:
        """Distance between the two parts [m]; negative: they overlap."""
        return self._get("distance")  # type: ignore[no-any-return]


class Arrangements(Result):
    """All arrangements, by cylinder spacing."""

    __slots__ = ()
    _FIELDS = ("assumptions", "criterion", "engine", "limit", "limit_source", "nearest", "spacings", "speed", "version",)

    @property
    def assumptions(self) -> list[str]:
        """Rules and sizes that were taken where the request gives none, in words."""
        return self._list("assumptions")  # type: ignore[no-any-return]

    @property
    def criterion(self) -> Literal['force', 'couple', 'mount-force']:
        """What was judged."""
        return self._get("criterion")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def limit(self) -> float | None:
        """Value that is good enough, in the criterion's SI unit."""
        return self._get("limit")  # type: ignore[no-any-return]

    @property
    def limit_source(self) -> str | None:
        """Where that value comes from."""
        return self._get("limit_source")  # type: ignore[no-any-return]

    @property
    def nearest(self) -> Nearest | None:
        """Where nobody reaches the limit: the best that there is."""
        return self._of("nearest", Nearest)  # type: ignore[no-any-return]

    @property
    def spacings(self) -> Records[SpacingArrangements]:
        """One entry a spacing, in the order of the request."""
        return self._all("spacings", SpacingArrangements)

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class Articulation(Record):
    """What an articulated rod changes."""

    __slots__ = ()
    _FIELDS = ("master", "max_reach", "min_reach", "stroke_difference", "top_dead_centre_shift",)

    @property
    def master(self) -> int:
        """Number of the master's cylinder, from 1."""
        return self._get("master")  # type: ignore[no-any-return]

    @property
    def max_reach(self) -> float:
        """Slave reach [m]: the largest distance from the crankpin to the slave's piston pin over the cycle."""
        return self._get("max_reach")  # type: ignore[no-any-return]

    @property
    def min_reach(self) -> float:
        """The smallest such distance [m]."""
        return self._get("min_reach")  # type: ignore[no-any-return]

    @property
    def stroke_difference(self) -> float:
        """Stroke minus the master's stroke [m]."""
        return self._get("stroke_difference")  # type: ignore[no-any-return]

    @property
    def top_dead_centre_shift(self) -> float:
        """Angle of TDC minus the angle at which the crank points along the cylinder [rad]."""
        return self._get("top_dead_centre_shift")  # type: ignore[no-any-return]


class Assignment(Result):
    """Where the parts go."""

    __slots__ = ()
    _FIELDS = ("as_numbered", "bound", "couple", "force", "pistons", "proved", "residual", "rods",)

    @property
    def as_numbered(self) -> float:
        """The residual with the parts as they were numbered [N]."""
        return self._get("as_numbered")  # type: ignore[no-any-return]

    @property
    def bound(self) -> float:
        """No assignment leaves less than this [N]: equal to `residual` where `proved`."""
        return self._get("bound")  # type: ignore[no-any-return]

    @property
    def couple(self) -> float:
        """Largest resultant of the first-order couple [N m]."""
        return self._get("couple")  # type: ignore[no-any-return]

    @property
    def force(self) -> float:
        """Largest resultant of the first-order force [N]."""
        return self._get("force")  # type: ignore[no-any-return]

    @property
    def pistons(self) -> list[int]:
        """Number of the piston (from 1) of each cylinder."""
        return self._list("pistons")  # type: ignore[no-any-return]

    @property
    def proved(self) -> bool:
        """Whether all assignments are known to leave no less."""
        return self._get("proved")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """Root of the sum of squares of first-order force, forward and backward, and of couple over the lever [N]."""
        return self._get("residual")  # type: ignore[no-any-return]

    @property
    def rods(self) -> list[int]:
        """Number of the rod (from 1) of each cylinder."""
        return self._list("rods")  # type: ignore[no-any-return]


class AtLeast(Record):
    """A criterion that must not fall below a value."""

    __slots__ = ()
    _FIELDS = ("criterion", "least",)

    @property
    def criterion(self) -> DurabilityCriterion:
        """What."""
        return self._of("criterion", DurabilityCriterion)  # type: ignore[no-any-return]

    @property
    def least(self) -> float:
        """Smallest value, in the criterion's SI unit."""
        return self._get("least")  # type: ignore[no-any-return]


class Audit(Record):
    """What must be zero but for the errors of the steps."""

    __slots__ = ()
    _FIELDS = ("angular_momentum", "energy", "linear_momentum", "loops", "quaternion",)

    @property
    def angular_momentum(self) -> float | None:
        """Largest change of angular momentum in space over its largest part, where nothing outside acts."""
        return self._get("angular_momentum")  # type: ignore[no-any-return]

    @property
    def energy(self) -> float:
        """Largest of energy stored less works, over all samples, over the throughput."""
        return self._get("energy")  # type: ignore[no-any-return]

    @property
    def linear_momentum(self) -> float | None:
        """Largest change of linear momentum in space over its largest part, where nothing outside acts."""
        return self._get("linear_momentum")  # type: ignore[no-any-return]

    @property
    def loops(self) -> float:
        """Largest departure of any loop from its rod length [m]."""
        return self._get("loops")  # type: ignore[no-any-return]

    @property
    def quaternion(self) -> float:
        """Largest departure of the quaternion's size from 1."""
        return self._get("quaternion")  # type: ignore[no-any-return]


class AxisLine(Record):
    """A line in space."""

    __slots__ = ()
    _FIELDS = ("direction", "point",)

    @property
    def direction(self) -> FloatArray:
        """Its direction, a unit vector."""
        return self._array("direction")  # type: ignore[no-any-return]

    @property
    def point(self) -> FloatArray:
        """A point of it [m]."""
        return self._array("point")  # type: ignore[no-any-return]


class Balance(Result):
    """The best weights with their proof, as parts, and what they do to the engine."""

    __slots__ = ()
    _FIELDS = ("among_equals", "as_parts", "cancellation", "consequences", "durability", "effects", "engine", "gas_speeds", "inertias", "limits", "method", "mount_gas_speeds", "mount_speeds", "outcome", "settings", "shafts", "speed", "stages", "task", "version", "warnings", "web_bounds", "weights",)

    @property
    def among_equals(self) -> Records[FoundStage]:
        """What decided among answers that the stages leave equal: of force and couple what no stage names, then the roll
        moment if an inertia or the axis of a shaft is free (unless a stage asks for the least weights), then, if a weight on a
        crankshaft is free, the root mean square of all main-bearing loads, the largest of them and the bending moment, each
        without degrading the previous ones. Empty where nothing was left open. Among what is still equal the answer is the lightest.
        """
        return self._all("among_equals", FoundStage)

    @property
    def as_parts(self) -> Records[WeightAsPart]:
        """What the weights are as parts, where the file says among which shapes they are searched."""
        return self._all("as_parts", WeightAsPart)

    @property
    def cancellation(self) -> Cancellation | None:
        """Where orders had to vanish exactly: whether they do, and the proof."""
        return self._of("cancellation", Cancellation)  # type: ignore[no-any-return]

    @property
    def consequences(self) -> Consequences | None:
        """What the weights do to block, bearings and bending, before and after."""
        return self._of("consequences", Consequences)  # type: ignore[no-any-return]

    @property
    def durability(self) -> Durable | None:
        """Oil films and safeties before, at the optimum and after the search for them, where some are wanted."""
        return self._of("durability", Durable)  # type: ignore[no-any-return]

    @property
    def effects(self) -> Records[Effect]:
        """Criteria before and after: force, couple, roll moment, root mean square of all main-bearing loads, the largest of them
        and the bending moment always, then those that the task names. Empty where no answer was found.
        """
        return self._all("effects", Effect)

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def gas_speeds(self) -> JudgedSpeeds | None:
        """Where main-bearing loads with gas are judged: the speeds that decide [rad/s], and where the largest of them stands."""
        return self._of("gas_speeds", JudgedSpeeds)  # type: ignore[no-any-return]

    @property
    def inertias(self) -> Records[FoundInertia]:
        """Every free inertia."""
        return self._all("inertias", FoundInertia)

    @property
    def limits(self) -> Records[FoundLimit]:
        """What each limit costs."""
        return self._all("limits", FoundLimit)

    @property
    def method(self) -> Method:
        """How it was found."""
        return self._of("method", Method)  # type: ignore[no-any-return]

    @property
    def mount_gas_speeds(self) -> JudgedSpeeds | None:
        """The same of forces at mounts with gas."""
        return self._of("mount_gas_speeds", JudgedSpeeds)  # type: ignore[no-any-return]

    @property
    def mount_speeds(self) -> JudgedSpeeds | None:
        """Where forces of inertia at mounts with springs are judged: the speeds that decide [rad/s], and where the largest of them stands."""
        return self._of("mount_speeds", JudgedSpeeds)  # type: ignore[no-any-return]

    @property
    def outcome(self) -> Outcome:
        """Whether there is an optimum, and if not, why."""
        return self._of("outcome", Outcome)  # type: ignore[no-any-return]

    @property
    def settings(self) -> BalanceSettings:
        """How far the search went, where it was one over choices."""
        return self._of("settings", BalanceSettings)  # type: ignore[no-any-return]

    @property
    def shafts(self) -> Records[FoundShaft]:
        """Where the free shafts stand."""
        return self._all("shafts", FoundShaft)

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 at which loads are judged [rad/s]: the highest of the engine, where all of them are largest."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def stages(self) -> Records[FoundStage]:
        """What each stage reached, with its proof."""
        return self._all("stages", FoundStage)

    @property
    def task(self) -> BalanceTask:
        """What was asked."""
        return self._of("task", BalanceTask)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def warnings(self) -> list[str]:
        """What the user should know."""
        return self._list("warnings")  # type: ignore[no-any-return]

    @property
    def web_bounds(self) -> Records[WebBound]:
        """Weights on webs whose largest amount is what fits there: the optimum is one within these bounds."""
        return self._all("web_bounds", WebBound)

    @property
    def weights(self) -> Records[FoundWeight]:
        """Every free weight. Empty where there is no optimum."""
        return self._all("weights", FoundWeight)


class BalanceSettings(Record):
    """How far a search over choices goes: places to be found, given and least amounts, devices that may be left out. A task that is
    one convex programme is always solved to a gap of 1e-8.
    """

    __slots__ = ()
    _FIELDS = ("gap", "max_nodes", "time_limit",)

    @property
    def gap(self) -> float:
        """The search for a stage ends at this gap between the best value and its bound, relative to the larger of the value and a
        millionth of the stage without the devices: 1e-8 to 0.5. Later stages may use up what it leaves.
        """
        return self._get("gap")  # type: ignore[no-any-return]

    @property
    def max_nodes(self) -> int:
        """Most branch-and-bound nodes examined for one stage, 1 or more."""
        return self._get("max_nodes")  # type: ignore[no-any-return]

    @property
    def time_limit(self) -> float | None:
        """Longest time of the whole search [s], above 0; none: no limit. Kept by the caller's clock: see `next`."""
        return self._get("time_limit")  # type: ignore[no-any-return]


class BalanceTask(Record):
    """Free weights, shafts and inertias, with what is to be minimised and what must hold."""

    __slots__ = ()
    _FIELDS = ("cancel", "durability", "give_up", "inertias", "limits", "most_optional", "shaft_costs", "shafts", "speed_weights", "speeds", "stages", "ties", "weights",)

    @property
    def cancel(self) -> list[tuple[Load, float]]:
        """Orders of loads that must vanish exactly, instead of stages and limits. Of all weights that do it those come first that the
        default stages and what decides among equals put first.
        """
        return self._as("cancel", every(row(Load, one)), [])  # type: ignore[no-any-return]

    @property
    def durability(self) -> DurabilityWish | None:
        """Films and safeties that must not fall below a value or are to be large, after the optimum of the stages."""
        return self._of("durability", DurabilityWish)  # type: ignore[no-any-return]

    @property
    def give_up(self) -> Records[GiveUp]:
        """How far later stages may raise each stage above its least value, in the order of the stages (of the default ones where
        none are named); a stage without an entry gives up nothing.
        """
        return self._all("give_up", GiveUp)

    @property
    def inertias(self) -> Records[FreeInertia]:
        """Inertias that turn against a crankshaft."""
        return self._all("inertias", FreeInertia)

    @property
    def limits(self) -> Records[Limit]:
        """What must hold."""
        return self._all("limits", Limit)

    @property
    def most_optional(self) -> int | None:
        """Most of the optional weights, shafts and inertias that may be used at once."""
        return self._get("most_optional")  # type: ignore[no-any-return]

    @property
    def shaft_costs(self) -> FloatArray:
        """What each shaft costs if it is used, in the order of the shafts; a shaft without an entry costs nothing."""
        return self._array("shaft_costs")  # type: ignore[no-any-return]

    @property
    def shafts(self) -> Records[FreeShaft]:
        """Balance shafts that may be fitted."""
        return self._all("shafts", FreeShaft)

    @property
    def speed_weights(self) -> FloatArray:
        """What loads at each of these speeds are multiplied by before the largest counts, in their order; a speed without an entry has 1."""
        return self._array("speed_weights")  # type: ignore[no-any-return]

    @property
    def speeds(self) -> FloatArray:
        """Speeds [rad/s] of crankshaft 1 at which forces at mounts with springs and loads with gas are judged, the largest of all counting;
        empty: the whole range of the engine. All other loads are largest at the highest speed.
        """
        return self._array("speeds")  # type: ignore[no-any-return]

    @property
    def stages(self) -> Records[Stage]:
        """What is minimised: the first stage first, each next one without degrading the previous ones. Empty: force, then
        couple. Among answers that all stages leave equal the one is chosen whose force and couple, as far as no stage
        names them, and then roll moment are least; of those, where a weight on a crankshaft is free, the one with the least
        root mean square of main-bearing loads, then the least largest one, then the least bending moment; of those the
        lightest.
        """
        return self._all("stages", Stage)

    @property
    def ties(self) -> Records[Tie]:
        """Weights that depend on one another."""
        return self._all("ties", Tie)

    @property
    def weights(self) -> Records[FreeWeight]:
        """Weights on the crankshafts and on these shafts."""
        return self._all("weights", FreeWeight)


class BankPair(Record):
    """How two banks stand."""

    __slots__ = ()
    _FIELDS = ("bank_angle", "split_angle", "stagger",)

    @property
    def bank_angle(self) -> float:
        """Angle between them [rad]."""
        return self._get("bank_angle")  # type: ignore[no-any-return]

    @property
    def split_angle(self) -> float:
        """How far the pin of bank 2 stands ahead of that of bank 1 [rad]; 0: shared pins."""
        return self._get("split_angle")  # type: ignore[no-any-return]

    @property
    def stagger(self) -> float:
        """How far bank 2 stands behind bank 1 along the crank [m]."""
        return self._get("stagger")  # type: ignore[no-any-return]


class BeamLoads(Record):
    """A crankshaft in one model."""

    __slots__ = ()
    _FIELDS = ("mains", "peak_main", "peak_moment", "peak_shear", "stations",)

    @property
    def mains(self) -> Records[MainLoad]:
        """Load on every main bearing, rising; 0 where the model lets it carry nothing."""
        return self._all("mains", MainLoad)

    @property
    def peak_main(self) -> Peak:
        """Largest load on any main bearing; its plane."""
        return self._of("peak_main", Peak)  # type: ignore[no-any-return]

    @property
    def peak_moment(self) -> Peak:
        """Largest bending moment along the shaft and over the cycle."""
        return self._of("peak_moment", Peak)  # type: ignore[no-any-return]

    @property
    def peak_shear(self) -> Peak:
        """Largest shear force along the shaft and over the cycle."""
        return self._of("peak_shear", Peak)  # type: ignore[no-any-return]

    @property
    def stations(self) -> Records[Station]:
        """Every plane with a load or a main bearing, rising from the free end to the flywheel. Between two of them the shear
        force is constant and the bending moment runs straight, so that extremes along the shaft lie here.
        """
        return self._all("stations", Station)


class BearingCycle(Record):
    """A bearing over the cycle."""

    __slots__ = ()
    _FIELDS = ("clearance", "film", "kind", "largest_eccentricity", "largest_load", "largest_load_angle", "law", "load", "mean_load", "number", "orbit", "z",)

    @property
    def clearance(self) -> float | None:
        """Radial clearance [m], where it has one."""
        return self._get("clearance")  # type: ignore[no-any-return]

    @property
    def film(self) -> LeastFilm | None:
        """The film where it is thinnest; of oil films alone."""
        return self._of("film", LeastFilm)  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['main', 'crankpin']:
        """Main or big end."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def largest_eccentricity(self) -> float:
        """Largest distance of the centres [m]."""
        return self._get("largest_eccentricity")  # type: ignore[no-any-return]

    @property
    def largest_load(self) -> float:
        """Largest load over the recorded cycles [N]."""
        return self._get("largest_load")  # type: ignore[no-any-return]

    @property
    def largest_load_angle(self) -> float:
        """Crank angle there [rad]."""
        return self._get("largest_load_angle")  # type: ignore[no-any-return]

    @property
    def law(self) -> str:
        """Its law, with its numbers, in words."""
        return self._get("law")  # type: ignore[no-any-return]

    @property
    def load(self) -> FloatArray:
        """Load at every instant of the last cycle: journal or pin on the bearing, `x` and `y` of the block [N]."""
        return self._array("load")  # type: ignore[no-any-return]

    @property
    def mean_load(self) -> float:
        """Mean size of the load [N]."""
        return self._get("mean_load")  # type: ignore[no-any-return]

    @property
    def number(self) -> int:
        """Number of the main bearing on its crankshaft, or of the cylinder."""
        return self._get("number")  # type: ignore[no-any-return]

    @property
    def orbit(self) -> FloatArray:
        """Centre of journal or pin from that of the bearing at every instant of the recorded cycles [m], in the block's frame; of a big end in that of its rod, `x`
        towards the piston.
        """
        return self._array("orbit")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its plane [m]."""
        return self._get("z")  # type: ignore[no-any-return]


class BearingFilm(Record):
    """A bearing of an engine and its film over the cycle."""

    __slots__ = ()
    _FIELDS = ("bearing", "carried", "cavitation", "crankshaft", "heat_balanced", "journal_turns", "kind", "largest_load", "largest_pressure_angle", "least_film_angle", "least_film_in_shell", "number", "orbit", "projected_pressure", "roughness", "shell_angle", "temperature", "temperature_rise", "viscosity",)

    @property
    def bearing(self) -> JournalBearing:
        """The bearing."""
        return self._of("bearing", JournalBearing)  # type: ignore[no-any-return]

    @property
    def carried(self) -> Records[Carried]:
        """Of a journal of a shaft that floats in its films: what film and contact carry at every instant [N], and the slope of its axis [rad]."""
        return self._all("carried", Carried)

    @property
    def cavitation(self) -> Literal['full', 'gumbel', 'reynolds', 'mass-conserving']:
        """Model of cavitation."""
        return self._get("cavitation")  # type: ignore[no-any-return]

    @property
    def crankshaft(self) -> int:
        """Number of its crankshaft, from 1."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def heat_balanced(self) -> bool:
        """Whether that balance was found."""
        return self._get("heat_balanced")  # type: ignore[no-any-return]

    @property
    def journal_turns(self) -> float:
        """Turns of the journal for one of crankshaft 1, below 0 against it."""
        return self._get("journal_turns")  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['main', 'crankpin']:
        """Main or big end."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def largest_load(self) -> float:
        """Largest load [N]."""
        return self._get("largest_load")  # type: ignore[no-any-return]

    @property
    def largest_pressure_angle(self) -> float:
        """Crank angle of the largest pressure [rad]."""
        return self._get("largest_pressure_angle")  # type: ignore[no-any-return]

    @property
    def least_film_angle(self) -> float:
        """Crank angle of the least film [rad]."""
        return self._get("least_film_angle")  # type: ignore[no-any-return]

    @property
    def least_film_in_shell(self) -> float:
        """Direction of the least film in the shell's frame [rad]: of a main that of the engine, of a big end from the rod's line towards the piston."""
        return self._get("least_film_in_shell")  # type: ignore[no-any-return]

    @property
    def number(self) -> int:
        """Number of the main bearing on its crankshaft, or of the cylinder."""
        return self._get("number")  # type: ignore[no-any-return]

    @property
    def orbit(self) -> FilmOrbit:
        """Orbit and film."""
        return self._of("orbit", FilmOrbit)  # type: ignore[no-any-return]

    @property
    def projected_pressure(self) -> FloatArray:
        """Largest and mean load over diameter times length [Pa]."""
        return self._array("projected_pressure")  # type: ignore[no-any-return]

    @property
    def roughness(self) -> float:
        """Composite roughness [m]."""
        return self._get("roughness")  # type: ignore[no-any-return]

    @property
    def shell_angle(self) -> FloatArray:
        """Angle of the shell's frame at the instants of the orbit [rad]: of a big end the rod's line towards the piston. Empty: it does not turn."""
        return self._array("shell_angle")  # type: ignore[no-any-return]

    @property
    def temperature(self) -> float | None:
        """Temperature of the film [K], where that of supply is known: the balance was repeated until it changed by 0.1 K."""
        return self._get("temperature")  # type: ignore[no-any-return]

    @property
    def temperature_rise(self) -> float | None:
        """Rise of temperature through the film [K]; `None` where no flow takes the heat away, as in full films, or the rise is more than 1000 K."""
        return self._get("temperature_rise")  # type: ignore[no-any-return]

    @property
    def viscosity(self) -> float:
        """Viscosity of the film [Pa s]."""
        return self._get("viscosity")  # type: ignore[no-any-return]


class BearingFilms(Result):
    """Oil films of an engine at one speed."""

    __slots__ = ()
    _FIELDS = ("assumptions", "engine", "films", "period", "shafts", "speed", "version",)

    @property
    def assumptions(self) -> list[str]:
        """What the file does not say and was assumed, and what was left out."""
        return self._list("assumptions")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def films(self) -> Records[BearingFilm]:
        """By bearing and model of cavitation."""
        return self._all("films", BearingFilm)

    @property
    def period(self) -> float:
        """Period of crankshaft 1 [rad]."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def shafts(self) -> Records[ShaftRun]:
        """How each crankshaft that floats in its films ran, with its energy balance, by crankshaft and model of cavitation; none where journals have no mass."""
        return self._all("shafts", ShaftRun)

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class BearingLoads(Record):
    """Loads of all bearings at one speed.

    No weight, no play, no friction, no oil film; rigid parts; main bearings throw by throw, as if the shaft were cut at each of them.
    """

    __slots__ = ()
    _FIELDS = ("counterweights", "cylinders", "engine", "mains", "part", "period", "speed", "theta", "version", "without_mains",)

    @property
    def counterweights(self) -> bool:
        """Whether the weights on the crankshafts count."""
        return self._get("counterweights")  # type: ignore[no-any-return]

    @property
    def cylinders(self) -> Records[CylinderBearings]:
        """By cylinder."""
        return self._all("cylinders", CylinderBearings)

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def mains(self) -> Records[MainBearing]:
        """Main bearings: crankshaft 1 first, each from the free end on."""
        return self._all("mains", MainBearing)

    @property
    def part(self) -> Literal['all', 'gas', 'inertia']:
        """Which loads count."""
        return self._get("part")  # type: ignore[no-any-return]

    @property
    def period(self) -> float:
        """Period [rad] of crankshaft 1."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle [rad] of every trace, from 0, one period, end point excluded."""
        return self._array("theta")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def without_mains(self) -> list[int]:
        """Numbers of the crankshafts, from 1, of which no bearing is told because they have no throw."""
        return self._list("without_mains")  # type: ignore[no-any-return]


class Bearings(Result):
    """Loads of the bearings with counterweights, and without where the engine has some."""

    __slots__ = ()
    _FIELDS = ("counterweights", "cylinders", "engine", "mains", "part", "period", "speed", "theta", "version", "without_counterweights", "without_mains",)

    @property
    def counterweights(self) -> bool:
        """Whether the weights on the crankshafts count."""
        return self._get("counterweights")  # type: ignore[no-any-return]

    @property
    def cylinders(self) -> Records[CylinderBearings]:
        """By cylinder."""
        return self._all("cylinders", CylinderBearings)

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def mains(self) -> Records[MainBearing]:
        """Main bearings: crankshaft 1 first, each from the free end on."""
        return self._all("mains", MainBearing)

    @property
    def part(self) -> Literal['all', 'gas', 'inertia']:
        """Which loads count."""
        return self._get("part")  # type: ignore[no-any-return]

    @property
    def period(self) -> float:
        """Period [rad] of crankshaft 1."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle [rad] of every trace, from 0, one period, end point excluded."""
        return self._array("theta")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def without_counterweights(self) -> BearingLoads | None:
        """The same without counterweights."""
        return self._of("without_counterweights", BearingLoads)  # type: ignore[no-any-return]

    @property
    def without_mains(self) -> list[int]:
        """Numbers of the crankshafts, from 1, of which no bearing is told because they have no throw."""
        return self._list("without_mains")  # type: ignore[no-any-return]


class Bending(Result):
    """Shear forces and bending moments inside the crankshafts, and what the main bearings carry of them."""

    __slots__ = ()
    _FIELDS = ("cases",)

    @property
    def cases(self) -> Records[InternalMoments]:
        """With the counterweights of the engine and without, as far as they differ."""
        return self._all("cases", InternalMoments)


class BendingAlong(Record):
    """Bending moment along a crankshaft, before and after: straight between these planes."""

    __slots__ = ()
    _FIELDS = ("after", "before", "crankshaft", "z",)

    @property
    def after(self) -> FloatArray:
        """With the new weights."""
        return self._array("after")  # type: ignore[no-any-return]

    @property
    def before(self) -> FloatArray:
        """Bending moment `M_x + i M_y` at `theta = 0` [N m]; it turns with the crankshaft."""
        return self._array("before")  # type: ignore[no-any-return]

    @property
    def crankshaft(self) -> int:
        """Number of the crankshaft, from 1."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def z(self) -> FloatArray:
        """Planes [m], from the origin, rising."""
        return self._array("z")  # type: ignore[no-any-return]


class BeyondTable(Record):
    """A mount whose table ends before the excitation does: beyond it the end's values are used."""

    __slots__ = ()
    _FIELDS = ("excitation", "mount", "table",)

    @property
    def excitation(self) -> FloatArray:
        """Lowest and highest angular frequency of the excitation [rad/s]."""
        return self._array("excitation")  # type: ignore[no-any-return]

    @property
    def mount(self) -> int:
        """Index of the mount."""
        return self._get("mount")  # type: ignore[no-any-return]

    @property
    def table(self) -> FloatArray:
        """Angular frequencies of the table's ends [rad/s]."""
        return self._array("table")  # type: ignore[no-any-return]


class BigEndClearance(Record):
    """A big end within the crankcase."""

    __slots__ = ()
    _FIELDS = ("clearance", "cylinder", "swept_radius",)

    @property
    def clearance(self) -> Clearance:
        """Its clearance; `on_body` is on the big end."""
        return self._of("clearance", Clearance)  # type: ignore[no-any-return]

    @property
    def cylinder(self) -> int:
        """Cylinder of the rod, from 1."""
        return self._get("cylinder")  # type: ignore[no-any-return]

    @property
    def swept_radius(self) -> float:
        """Largest distance of the big end from the axis of the crankshaft [m]."""
        return self._get("swept_radius")  # type: ignore[no-any-return]


class Bobweight(Record):
    """The bobweight of one pin."""

    __slots__ = ()
    _FIELDS = ("mass", "oil", "pin", "reciprocating", "rods", "rotating", "throw",)

    @property
    def mass(self) -> float:
        """The bobweight [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def oil(self) -> float:
        """Oil [kg]."""
        return self._get("oil")  # type: ignore[no-any-return]

    @property
    def pin(self) -> str:
        """Name of the pin."""
        return self._get("pin")  # type: ignore[no-any-return]

    @property
    def reciprocating(self) -> float:
        """Reciprocating mass of all rods [kg]."""
        return self._get("reciprocating")  # type: ignore[no-any-return]

    @property
    def rods(self) -> int:
        """Rods on the pin."""
        return self._get("rods")  # type: ignore[no-any-return]

    @property
    def rotating(self) -> float:
        """Rotating mass of the rods [kg], without the oil."""
        return self._get("rotating")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int | None:
        """Number of its throw in the engine file."""
        return self._get("throw")  # type: ignore[no-any-return]


class BobweightAnswer(Result):
    """A bobweight sheet worked out."""

    __slots__ = ()
    _FIELDS = ("bobweights", "choices", "comparison", "engine", "judged_by", "name", "pins", "reciprocating_share", "rotating_share", "share_given", "version",)

    @property
    def bobweights(self) -> Records[Bobweight]:
        """The bobweights, pin by pin."""
        return self._all("bobweights", Bobweight)

    @property
    def choices(self) -> Records[FactorChoice]:
        """Shares worth looking at, the sheet's first."""
        return self._all("choices", FactorChoice)

    @property
    def comparison(self) -> BobweightComparison | None:
        """Comparison with the optimum, where the sheet names an engine."""
        return self._of("comparison", BobweightComparison)  # type: ignore[no-any-return]

    @property
    def engine(self) -> str | None:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def judged_by(self) -> str | None:
        """What the choices are judged by; `None` where nothing is known of the layout, or no share makes a difference."""
        return self._get("judged_by")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name of the sheet."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def pins(self) -> Records[PinParts]:
        """The weighed parts of every pin."""
        return self._all("pins", PinParts)

    @property
    def reciprocating_share(self) -> float:
        """Share of the reciprocating masses."""
        return self._get("reciprocating_share")  # type: ignore[no-any-return]

    @property
    def rotating_share(self) -> float:
        """Share of the rotating masses."""
        return self._get("rotating_share")  # type: ignore[no-any-return]

    @property
    def share_given(self) -> bool:
        """Whether the sheet gives that share, or it was derived."""
        return self._get("share_given")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class BobweightComparison(Record):
    """The engine with the weighed parts, its crank balanced in different ways."""

    __slots__ = ()
    _FIELDS = ("couple_bound", "force_bound", "speed", "ways",)

    @property
    def couple_bound(self) -> float:
        """Proved alike: none that reach that peak force have a smaller peak couple [N m]."""
        return self._get("couple_bound")  # type: ignore[no-any-return]

    @property
    def force_bound(self) -> float:
        """Proved for the optimum: no weights at the ends of the crank have a smaller peak force [N] than this."""
        return self._get("force_bound")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def ways(self) -> Records[ComparedBalance]:
        """The ways; the last is the optimum."""
        return self._all("ways", ComparedBalance)


class BodyClearances(Record):
    """The clearances of a counterweight with its web, or of a web without counterweight."""

    __slots__ = ()
    _FIELDS = ("chamfers_ignored", "clearances", "crankshaft", "faces", "name", "swept_radius",)

    @property
    def chamfers_ignored(self) -> bool:
        """Whether it has chamfers, which count as not cut: every distance is a lower bound then."""
        return self._get("chamfers_ignored")  # type: ignore[no-any-return]

    @property
    def clearances(self) -> Records[Clearance]:
        """Its clearance to every obstacle that is there, but those that lie farther away along the crank than another one
        of their kind is at its nearest.
        """
        return self._all("clearances", Clearance)

    @property
    def crankshaft(self) -> int:
        """Index of its crankshaft."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def faces(self) -> FloatArray:
        """Its first and its last plane [m]."""
        return self._array("faces")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name of the counterweight, or "web 3"."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def swept_radius(self) -> float:
        """Swept radius [m]."""
        return self._get("swept_radius")  # type: ignore[no-any-return]


class BodyState(Record):
    """What unbalance does to the crankshaft as a body."""

    __slots__ = ()
    _FIELDS = ("body", "couple", "kind", "offset", "quasi_static", "tilt", "tilt_direction",)

    @property
    def body(self) -> CrankBody:
        """What is known of the body."""
        return self._of("body", CrankBody)  # type: ignore[no-any-return]

    @property
    def couple(self) -> FloatArray:
        """Couple unbalance about the mass centre [kg m^2]."""
        return self._array("couple")  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['balanced', 'static', 'couple', 'quasi-static', 'dynamic']:
        """Its kind."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def offset(self) -> FloatArray:
        """Offset of the mass centre [m], in the frame of the crankshaft."""
        return self._array("offset")  # type: ignore[no-any-return]

    @property
    def quasi_static(self) -> QuasiStatic | None:
        """The nearest single unbalance; `None` without static unbalance."""
        return self._of("quasi_static", QuasiStatic)  # type: ignore[no-any-return]

    @property
    def tilt(self) -> float:
        """Tilt of the principal axis that is nearest the shaft [rad]."""
        return self._get("tilt")  # type: ignore[no-any-return]

    @property
    def tilt_direction(self) -> float:
        """Direction to which its flywheel end leans [rad], in the frame of the crankshaft."""
        return self._get("tilt_direction")  # type: ignore[no-any-return]


class BondEnergy(Record):
    """Energy through one bond."""

    __slots__ = ()
    _FIELDS = ("bond", "energy",)

    @property
    def bond(self) -> str:
        """The bond."""
        return self._get("bond")  # type: ignore[no-any-return]

    @property
    def energy(self) -> float:
        """Its energy [J]."""
        return self._get("energy")  # type: ignore[no-any-return]


class BondGraph(Result):
    """The bond graph of an engine: its file, its causality and its equations."""

    __slots__ = ()
    _FIELDS = ("causality", "drawing", "engine", "equations", "graph", "latex", "modelica", "notes", "run",)

    @property
    def causality(self) -> str:
        """The causality, step by step, in words."""
        return self._get("causality")  # type: ignore[no-any-return]

    @property
    def drawing(self) -> str:
        """The drawing of the graph with its causality, as SVG."""
        return self._get("drawing")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def equations(self) -> str:
        """The equations as text."""
        return self._get("equations")  # type: ignore[no-any-return]

    @property
    def graph(self) -> str:
        """The graph file."""
        return self._get("graph")  # type: ignore[no-any-return]

    @property
    def latex(self) -> str:
        """The equations as a LaTeX document."""
        return self._get("latex")  # type: ignore[no-any-return]

    @property
    def modelica(self) -> str:
        """The graph as a model of Modelica."""
        return self._get("modelica")  # type: ignore[no-any-return]

    @property
    def notes(self) -> list[str]:
        """What the engine file does not say and was assumed."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def run(self) -> GraphRun | None:
        """A run of the graph, where one is asked for."""
        return self._of("run", GraphRun)  # type: ignore[no-any-return]


class BoreSheet(Record):
    """An oil bore: from nominal stress to safety."""

    __slots__ = ()
    _FIELDS = ("angle", "breach", "diameter", "factors", "nominal", "stress",)

    @property
    def angle(self) -> float:
        """Its direction from that of the throw [rad]."""
        return self._get("angle")  # type: ignore[no-any-return]

    @property
    def breach(self) -> RangeBreach | None:
        """Where it is too large for the formulas: no factors, no safety."""
        return self._of("breach", RangeBreach)  # type: ignore[no-any-return]

    @property
    def diameter(self) -> float:
        """Its diameter [m]."""
        return self._get("diameter")  # type: ignore[no-any-return]

    @property
    def factors(self) -> OilFactors | None:
        """Stress concentration factors."""
        return self._of("factors", OilFactors)  # type: ignore[no-any-return]

    @property
    def nominal(self) -> NominalBore:
        """Loads and nominal stresses."""
        return self._of("nominal", NominalBore)  # type: ignore[no-any-return]

    @property
    def stress(self) -> FilletSheet | None:
        """Stresses and safety."""
        return self._of("stress", FilletSheet)  # type: ignore[no-any-return]


class Bounds(Record):
    """Largest and smallest value of a run."""

    __slots__ = ()
    _FIELDS = ("least", "most",)

    @property
    def least(self) -> Peak2:
        """Smallest."""
        return self._of("least", Peak2)  # type: ignore[no-any-return]

    @property
    def most(self) -> Peak2:
        """Largest."""
        return self._of("most", Peak2)  # type: ignore[no-any-return]


class Brake(Record):
    """What friction leaves."""

    __slots__ = ()
    _FIELDS = ("bmep", "efficiency", "fmep", "power", "torque",)

    @property
    def bmep(self) -> float:
        """Brake mean effective pressure [Pa]: what is left of the mean effective pressure of both sides of the pistons."""
        return self._get("bmep")  # type: ignore[no-any-return]

    @property
    def efficiency(self) -> float:
        """Brake over indicated torque [1]."""
        return self._get("efficiency")  # type: ignore[no-any-return]

    @property
    def fmep(self) -> float:
        """Friction mean effective pressure [Pa]."""
        return self._get("fmep")  # type: ignore[no-any-return]

    @property
    def power(self) -> float:
        """Brake power [W]."""
        return self._get("power")  # type: ignore[no-any-return]

    @property
    def torque(self) -> float:
        """Brake torque at crankshaft 1 [N m]."""
        return self._get("torque")  # type: ignore[no-any-return]


class Broken(Record):
    """Cases that broke one constraint."""

    __slots__ = ()
    _FIELDS = ("cases", "constraint",)

    @property
    def cases(self) -> int:
        """Cases for which it was the first that they broke. Constraints on sizes that many cases share are judged first,
        then those on the crank, then those on the firing; within these in the order of the request.
        """
        return self._get("cases")  # type: ignore[no-any-return]

    @property
    def constraint(self) -> str:
        """The constraint in words, as in the request."""
        return self._get("constraint")  # type: ignore[no-any-return]


class Campbell(Record):
    """Data of a Campbell diagram."""

    __slots__ = ()
    _FIELDS = ("criticals", "frequencies", "orders", "speeds",)

    @property
    def criticals(self) -> Records[Critical]:
        """Critical speeds within the range, by falling modal torque."""
        return self._all("criticals", Critical)

    @property
    def frequencies(self) -> list[FloatArray]:
        """Natural frequency of each mode at each speed [rad/s]; only pendulums make it depend on the speed."""
        return self._rows("frequencies")  # type: ignore[no-any-return]

    @property
    def orders(self) -> FloatArray:
        """Orders drawn."""
        return self._array("orders")  # type: ignore[no-any-return]

    @property
    def speeds(self) -> FloatArray:
        """Speeds [rad/s]."""
        return self._array("speeds")  # type: ignore[no-any-return]


class Cancellation(Record):
    """Exact cancellation: what had to vanish, and the proof that no lighter weights do it or that none can."""

    __slots__ = ()
    _FIELDS = ("orders", "verdict",)

    @property
    def orders(self) -> Records[CancelledOrder]:
        """Every order of the task, in its order."""
        return self._all("orders", CancelledOrder)

    @property
    def verdict(self) -> CancellationVerdict:
        """What was found, with its proof."""
        return self._of("verdict", CancellationVerdict)  # type: ignore[no-any-return]


class CancellationVerdict(Record):
    """Whether the orders can vanish together."""

    __slots__ = ()
    _FIELDS = ("is_mass", "kind", "least", "lightest", "total", "obstructions",)

    @property
    def is_mass(self) -> bool | None:
        """Whether the total is a mass."""
        return self._get("is_mass")  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['vanish', 'cannot-vanish']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def least(self) -> float | None:
        """That of the lightest weights that do it; the same where nothing but the weights decides."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def lightest(self) -> Functional | None:
        """No weights that make the orders vanish have a total below `lightest.value`."""
        return self._of("lightest", Functional)  # type: ignore[no-any-return]

    @property
    def total(self) -> float | None:
        """Total unbalance of the answer [kg m], or mass [kg] where every weight has a radius."""
        return self._get("total")  # type: ignore[no-any-return]

    @property
    def obstructions(self) -> Records[Obstruction]:
        """At least one, each for orders that hang together through the devices."""
        return self._all("obstructions", Obstruction)


class CancelledOrder(Record):
    """An order that had to vanish."""

    __slots__ = ()
    _FIELDS = ("criterion", "least_alone", "left", "without",)

    @property
    def criterion(self) -> Criterion:
        """One order of a load."""
        return self._of("criterion", Criterion)  # type: ignore[no-any-return]

    @property
    def least_alone(self) -> float:
        """The least that these devices leave of it where nothing else is asked for [N or N m]; 0 where it can vanish alone."""
        return self._get("least_alone")  # type: ignore[no-any-return]

    @property
    def left(self) -> float:
        """Its peak with the answer [N or N m]: from the loads of the engine with the weights fitted, computed anew."""
        return self._get("left")  # type: ignore[no-any-return]

    @property
    def without(self) -> float:
        """Its peak without the free devices [N or N m]."""
        return self._get("without")  # type: ignore[no-any-return]


class Capability(Record):
    """How an output stands to a limit."""

    __slots__ = ()
    _FIELDS = ("beyond", "cpk", "cpk_by_percentiles", "limit",)

    @property
    def beyond(self) -> int:
        """Samples beyond the limit."""
        return self._get("beyond")  # type: ignore[no-any-return]

    @property
    def cpk(self) -> float:
        """`(limit - mean) / (3 standard deviations)`: for a normal distribution."""
        return self._get("cpk")  # type: ignore[no-any-return]

    @property
    def cpk_by_percentiles(self) -> float:
        """`(limit - median) / (99.865 % percentile - median)`: for any distribution (ISO 22514-2)."""
        return self._get("cpk_by_percentiles")  # type: ignore[no-any-return]

    @property
    def limit(self) -> float:
        """The limit."""
        return self._get("limit")  # type: ignore[no-any-return]


class Carried(Record):
    """A journal of a floating shaft at an instant."""

    __slots__ = ()
    _FIELDS = ("load", "slope",)

    @property
    def load(self) -> FloatArray:
        """Force of the journal on its bearing [N]."""
        return self._array("load")  # type: ignore[no-any-return]

    @property
    def slope(self) -> FloatArray:
        """Slope of its axis along x and y [rad]."""
        return self._array("slope")  # type: ignore[no-any-return]


class CarriedWeight(Record):
    """A weight without elements of its own."""

    __slots__ = ()
    _FIELDS = ("name", "place", "unbalance", "z",)

    @property
    def name(self) -> str:
        """Its name: "web 1"."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def place(self) -> str:
        """What carries it: "web 1", "webs 1 and 2", "end face FLYWHEEL"."""
        return self._get("place")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> FloatArray:
        """Mass times place [kg m], in the frame of the mesh."""
        return self._array("unbalance")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its plane [m]."""
        return self._get("z")  # type: ignore[no-any-return]


class Catalogue(Variant):
    """Amounts of which a free weight has one, or none at all."""

    __slots__ = ()
    _FIELDS = ("kind", "steps", "amounts",)

    @property
    def kind(self) -> Literal['steps', 'amounts']:
        """Which of the variants it is."""
        return self._kind()  # type: ignore[no-any-return]

    @property
    def steps(self) -> float | None:
        """Whole multiples of this [kg m]."""
        return self._get("steps")  # type: ignore[no-any-return]

    @property
    def amounts(self) -> FloatArray:
        """These [kg m], rising, all above 0."""
        return self._array("amounts")  # type: ignore[no-any-return]


class CatalogueHole(Record):
    """A hole of a catalogue."""

    __slots__ = ()
    _FIELDS = ("depth", "diameter", "slug_density", "tip", "unbalance",)

    @property
    def depth(self) -> float:
        """Depth from the surface to the end of the full diameter [m]."""
        return self._get("depth")  # type: ignore[no-any-return]

    @property
    def diameter(self) -> float:
        """Diameter of the drill [m]."""
        return self._get("diameter")  # type: ignore[no-any-return]

    @property
    def slug_density(self) -> float | None:
        """Density of the slug that fills it [kg/m^3]; none: it stays empty."""
        return self._get("slug_density")  # type: ignore[no-any-return]

    @property
    def tip(self) -> float:
        """Depth from the surface that the tip of the drill reaches [m]."""
        return self._get("tip")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> float:
        """Unbalance that the hole removes, or that the slug in it adds beyond what was drilled away [kg m]."""
        return self._get("unbalance")  # type: ignore[no-any-return]


class Chain(Record):
    """A chain that is known to be valid: a tree of two or more stations, each with an inertia."""

    __slots__ = ()
    _FIELDS = ("shafts", "stations",)

    @property
    def shafts(self) -> Records[Shaft]:
        """Not described."""
        return self._all("shafts", Shaft)

    @property
    def stations(self) -> Records[Station2]:
        """Not described."""
        return self._all("stations", Station2)


class ChainEnergy(Record):
    """Work and energy over a period [J]."""

    __slots__ = ()
    _FIELDS = ("change", "damping", "gas", "load", "masses", "missing", "turnover",)

    @property
    def change(self) -> float:
        """Change of kinetic and elastic energy."""
        return self._get("change")  # type: ignore[no-any-return]

    @property
    def damping(self) -> float:
        """Lost in the dampers."""
        return self._get("damping")  # type: ignore[no-any-return]

    @property
    def gas(self) -> float:
        """Work of the gas."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def load(self) -> float:
        """Taken by the load."""
        return self._get("load")  # type: ignore[no-any-return]

    @property
    def masses(self) -> float:
        """Work of the torque that stands for varying inertia; 0 where inertia varies."""
        return self._get("masses")  # type: ignore[no-any-return]

    @property
    def missing(self) -> float:
        """What is missing: gas + masses - load - damping - change."""
        return self._get("missing")  # type: ignore[no-any-return]

    @property
    def turnover(self) -> float:
        """Sum of the sizes of all powers over time, by which `missing` is judged."""
        return self._get("turnover")  # type: ignore[no-any-return]


class ChamberMotion(Record):
    """The chamber that pistons share."""

    __slots__ = ()
    _FIELDS = ("bottom_dead_centre", "cylinders", "least", "swept", "top_dead_centre",)

    @property
    def bottom_dead_centre(self) -> float:
        """Crank angle at its bottom dead centre, where its volume is largest [rad], in the first turn."""
        return self._get("bottom_dead_centre")  # type: ignore[no-any-return]

    @property
    def cylinders(self) -> list[int]:
        """Numbers of its cylinders, from 1, rising."""
        return self._list("cylinders")  # type: ignore[no-any-return]

    @property
    def least(self) -> float:
        """What the pistons leave free below their own top dead centres where its volume is least [m^3]; 0 where they are all there at once."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def swept(self) -> float:
        """Largest less smallest volume [m^3]; without bores the same of the travels [m]."""
        return self._get("swept")  # type: ignore[no-any-return]

    @property
    def top_dead_centre(self) -> float:
        """Crank angle of crankshaft 1 at its top dead centre, where its volume is least [rad], in the first turn of its crankshafts."""
        return self._get("top_dead_centre")  # type: ignore[no-any-return]


class CheckedCounterweight(Record):
    """A counterweight that is a part."""

    __slots__ = ()
    _FIELDS = ("index", "is_met", "mass", "name", "part_mass", "polar_inertia", "swept_radius", "thickness", "unbalance", "wanted",)

    @property
    def index(self) -> int:
        """Its index in `counterweights`."""
        return self._get("index")  # type: ignore[no-any-return]

    @property
    def is_met(self) -> bool:
        """Whether it is within a hundredth of what it should be."""
        return self._get("is_met")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Its mass beyond the plain web [kg]: what it adds to the crankshaft."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def part_mass(self) -> float:
        """Mass of the part as it is exported, with what of the web it covers [kg]."""
        return self._get("part_mass")  # type: ignore[no-any-return]

    @property
    def polar_inertia(self) -> float:
        """Its polar inertia about the crank axis beyond the plain web [kg m^2]."""
        return self._get("polar_inertia")  # type: ignore[no-any-return]

    @property
    def swept_radius(self) -> float:
        """Swept radius [m]."""
        return self._get("swept_radius")  # type: ignore[no-any-return]

    @property
    def thickness(self) -> float:
        """Thickness [m]."""
        return self._get("thickness")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> float:
        """The unbalance that it has on its web [kg m]."""
        return self._get("unbalance")  # type: ignore[no-any-return]

    @property
    def wanted(self) -> float | None:
        """The unbalance that it should have [kg m], if the file says so."""
        return self._get("wanted")  # type: ignore[no-any-return]


class CheckedShaftWeight(Record):
    """A weight of a balance shaft that is a part."""

    __slots__ = ()
    _FIELDS = ("faces", "is_met", "mass", "name", "polar_inertia", "radius", "shaft", "shaft_diameter", "unbalance", "wanted",)

    @property
    def faces(self) -> FloatArray:
        """Its faces along z [m], from the origin."""
        return self._array("faces")  # type: ignore[no-any-return]

    @property
    def is_met(self) -> bool:
        """Whether it is within a hundredth of what it should be."""
        return self._get("is_met")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Its mass without the shaft within it [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def polar_inertia(self) -> float:
        """Its moment of inertia about the axis of its shaft, without the shaft [kg m^2]."""
        return self._get("polar_inertia")  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Its radius, which is the swept one [m]."""
        return self._get("radius")  # type: ignore[no-any-return]

    @property
    def shaft(self) -> int:
        """Index of its shaft in `shafts`."""
        return self._get("shaft")  # type: ignore[no-any-return]

    @property
    def shaft_diameter(self) -> float:
        """Diameter of the shaft within it [m]."""
        return self._get("shaft_diameter")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> float:
        """The unbalance that it has [kg m]."""
        return self._get("unbalance")  # type: ignore[no-any-return]

    @property
    def wanted(self) -> float | None:
        """The unbalance that it should have [kg m], if the file says so."""
        return self._get("wanted")  # type: ignore[no-any-return]


class ChoiceCount(Record):
    """A choice and how many values it has."""

    __slots__ = ()
    _FIELDS = ("choice", "values",)

    @property
    def choice(self) -> Literal['spacing', 'bank-angle', 'split-angle', 'stagger', 'rod-ratio', 'counterweights', 'shafts', 'throw-angles', 'firing']:
        """The choice."""
        return self._get("choice")  # type: ignore[no-any-return]

    @property
    def values(self) -> int:
        """Its values: of throw angles all cranks, of firing all ways of firing."""
        return self._get("values")  # type: ignore[no-any-return]


class Clearance(Record):
    """The smallest distance of a counterweight or web from an obstacle over all angles."""

    __slots__ = ()
    _FIELDS = ("bound", "distance", "is_kept", "obstacle", "on_body", "on_obstacle", "overlap", "theta",)

    @property
    def bound(self) -> float:
        """Proved bound: it is nowhere smaller than this [m]."""
        return self._get("bound")  # type: ignore[no-any-return]

    @property
    def distance(self) -> float:
        """Smallest distance in space [m], zero where they overlap."""
        return self._get("distance")  # type: ignore[no-any-return]

    @property
    def is_kept(self) -> bool:
        """Whether they stay clear of each other by what is wanted, proved."""
        return self._get("is_kept")  # type: ignore[no-any-return]

    @property
    def obstacle(self) -> Obstacle:
        """The obstacle."""
        return self._of("obstacle", Obstacle)  # type: ignore[no-any-return]

    @property
    def on_body(self) -> FloatArray:
        """The point on the counterweight or web then (at `theta` zero where it is the same at all angles): x, y, z [m]."""
        return self._array("on_body")  # type: ignore[no-any-return]

    @property
    def on_obstacle(self) -> FloatArray:
        """The point on the obstacle then [m]."""
        return self._array("on_obstacle")  # type: ignore[no-any-return]

    @property
    def overlap(self) -> Overlap | None:
        """How they overlap, if they do."""
        return self._of("overlap", Overlap)  # type: ignore[no-any-return]

    @property
    def theta(self) -> float | None:
        """Angle of crankshaft 1 [rad] at which it is that small (where they overlap: deepest); none where it is the same at
        all angles.
        """
        return self._get("theta")  # type: ignore[no-any-return]


class Clearances(Record):
    """All clearances of an engine's crankshafts."""

    __slots__ = ()
    _FIELDS = ("big_ends", "bodies", "is_kept", "least", "smallest", "version",)

    @property
    def big_ends(self) -> Records[BigEndClearance]:
        """Big ends against the crankcase."""
        return self._all("big_ends", BigEndClearance)

    @property
    def bodies(self) -> Records[BodyClearances]:
        """Counterweights in the engine's order, then the webs that carry none."""
        return self._all("bodies", BodyClearances)

    @property
    def is_kept(self) -> bool:
        """Whether nothing overlaps and all stay clear by what is wanted, proved."""
        return self._get("is_kept")  # type: ignore[no-any-return]

    @property
    def least(self) -> float | None:
        """The clearance that is wanted to everything [m]."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def smallest(self) -> Smallest | None:
        """The smallest of all; the sides of big ends count only where they overlap."""
        return self._of("smallest", Smallest)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class CommonFactor(Record):
    """What one factor for all throws of a crankshaft does."""

    __slots__ = ()
    _FIELDS = ("couple", "force",)

    @property
    def couple(self) -> FactorEffect:
        """To the couple about the origin [kg m^2], as `SUM z F` (the couple itself is `i` times it)."""
        return self._of("couple", FactorEffect)  # type: ignore[no-any-return]

    @property
    def force(self) -> FactorEffect:
        """To the force of the whole crankshaft [kg m]."""
        return self._of("force", FactorEffect)  # type: ignore[no-any-return]


class Compared(Record):
    """One engine of a comparison, in the size in which it is compared."""

    __slots__ = ()
    _FIELDS = ("added_mass", "balance_rate", "bending_moment", "counterweights", "couple", "couple_leading", "crankpin_film", "displacement", "engine", "fillet_safety", "firing_unevenness", "force", "force_leading", "main_film", "main_load", "mount_force", "roll_moment", "rule_safety", "shaft_weights", "shafts", "similar", "speed", "torque", "with_",)

    @property
    def added_mass(self) -> float | None:
        """Mass of the counterweights and shaft weights that are parts [kg]; `None` where one of them is a number only."""
        return self._get("added_mass")  # type: ignore[no-any-return]

    @property
    def balance_rate(self) -> FloatArray | None:
        """Least and largest balance rate of any bay: share of the rotating unbalance between two main bearings that the counterweights
        there answer [1].
        """
        return self._array("balance_rate")  # type: ignore[no-any-return]

    @property
    def bending_moment(self) -> float | None:
        """Largest bending moment along any crankshaft as a free beam under what turns with it [N m]."""
        return self._get("bending_moment")  # type: ignore[no-any-return]

    @property
    def counterweights(self) -> float:
        """Unbalance of all counterweights [kg m]."""
        return self._get("counterweights")  # type: ignore[no-any-return]

    @property
    def couple(self) -> float:
        """Largest resultant couple about the reference point [N m]."""
        return self._get("couple")  # type: ignore[no-any-return]

    @property
    def couple_leading(self) -> Leading | None:
        """What most of the couple is."""
        return self._of("couple_leading", Leading)  # type: ignore[no-any-return]

    @property
    def crankpin_film(self) -> Measured:
        """The same of any big-end bearing [m]."""
        return self._of("crankpin_film", Measured)  # type: ignore[no-any-return]

    @property
    def displacement(self) -> float | None:
        """Displacement [m^3], where all bores are known."""
        return self._get("displacement")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Its name."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def fillet_safety(self) -> Measured | None:
        """Smallest safety of any fillet by finite elements [1], where it is asked for."""
        return self._of("fillet_safety", Measured)  # type: ignore[no-any-return]

    @property
    def firing_unevenness(self) -> float | None:
        """Largest departure of a firing interval from the even one, over it, where firing is known."""
        return self._get("firing_unevenness")  # type: ignore[no-any-return]

    @property
    def force(self) -> float:
        """Largest resultant force of the moving masses on the block [N]."""
        return self._get("force")  # type: ignore[no-any-return]

    @property
    def force_leading(self) -> Leading | None:
        """What most of the force is."""
        return self._of("force_leading", Leading)  # type: ignore[no-any-return]

    @property
    def main_film(self) -> Measured:
        """Smallest oil film of any main bearing over the cycle [m], the smaller of that at the lowest speed and at the speed of the comparison."""
        return self._of("main_film", Measured)  # type: ignore[no-any-return]

    @property
    def main_load(self) -> float | None:
        """Largest load of inertia on any main bearing over the cycle, throw by throw [N]; `None` for crankshafts without throws."""
        return self._get("main_load")  # type: ignore[no-any-return]

    @property
    def mount_force(self) -> float | None:
        """Largest force at any of its mounts [N]: of inertia and, where it is known, of gas, over the range of speeds on mounts with
        springs; of inertia alone, at the speed, on mounts without, which share what they can carry. `None` without mounts.
        """
        return self._get("mount_force")  # type: ignore[no-any-return]

    @property
    def roll_moment(self) -> float:
        """Largest roll moment of the moving masses, either way [N m]."""
        return self._get("roll_moment")  # type: ignore[no-any-return]

    @property
    def rule_safety(self) -> Measured:
        """Smallest safety of any fillet or oil bore by the formulas after UR M53 [1], at these speeds."""
        return self._of("rule_safety", Measured)  # type: ignore[no-any-return]

    @property
    def shaft_weights(self) -> float:
        """Unbalance of all weights of balance shafts [kg m]."""
        return self._get("shaft_weights")  # type: ignore[no-any-return]

    @property
    def shafts(self) -> int:
        """Number of balance shafts."""
        return self._get("shafts")  # type: ignore[no-any-return]

    @property
    def similar(self) -> Similar:
        """Its size over that of its file."""
        return self._of("similar", Similar)  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def torque(self) -> ComparedTorque | None:
        """Torque of gas and inertia, where the gas is known."""
        return self._of("torque", ComparedTorque)  # type: ignore[no-any-return]

    @property
    def with_(self) -> str | None:
        """What it got in place of its own counterweights and shafts, in words."""
        return self._get("with")  # type: ignore[no-any-return]


class ComparedBalance(Record):
    """Peaks over the cycle at the highest speed of the engine."""

    __slots__ = ()
    _FIELDS = ("couple", "force", "how",)

    @property
    def couple(self) -> float:
        """Largest resultant couple [N m]."""
        return self._get("couple")  # type: ignore[no-any-return]

    @property
    def force(self) -> float:
        """Largest resultant force [N]."""
        return self._get("force")  # type: ignore[no-any-return]

    @property
    def how(self) -> str:
        """How the crank is balanced."""
        return self._get("how")  # type: ignore[no-any-return]


class ComparedTorque(Record):
    """Torque of gas and inertia at the speed of the comparison, and the flywheel for the lowest speed."""

    __slots__ = ()
    _FIELDS = ("excess", "excess_share", "flywheel", "inertia", "least", "mean", "most", "power",)

    @property
    def excess(self) -> float:
        """Largest excess energy [J]."""
        return self._get("excess")  # type: ignore[no-any-return]

    @property
    def excess_share(self) -> float:
        """Excess energy over the work of one period: how uneven the torque is, whatever its size."""
        return self._get("excess_share")  # type: ignore[no-any-return]

    @property
    def flywheel(self) -> float | None:
        """Flywheel that the true speed needs for it [kg m^2], of variable inertia; `None` where none keeps it."""
        return self._get("flywheel")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> float:
        """Inertia by the formula for the fluctuation of the comparison at the lowest speed [kg m^2]."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def least(self) -> float:
        """Smallest torque [N m]."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def mean(self) -> float:
        """Mean torque at crankshaft 1 [N m]."""
        return self._get("mean")  # type: ignore[no-any-return]

    @property
    def most(self) -> float:
        """Largest torque [N m]."""
        return self._get("most")  # type: ignore[no-any-return]

    @property
    def power(self) -> float:
        """Net indicated power [W]."""
        return self._get("power")  # type: ignore[no-any-return]


class Comparison(Result):
    """Engines side by side."""

    __slots__ = ()
    _FIELDS = ("engines", "equal", "fluctuation", "held", "rankings", "reference", "share", "version", "warnings",)

    @property
    def engines(self) -> Records[Compared]:
        """The engines in the order of the request."""
        return self._all("engines", Compared)

    @property
    def equal(self) -> Literal['as-they-are', 'displacement', 'power']:
        """In what they were made equal."""
        return self._get("equal")  # type: ignore[no-any-return]

    @property
    def fluctuation(self) -> float:
        """Fluctuation of the speed that the flywheels keep at the lowest speed [1]."""
        return self._get("fluctuation")  # type: ignore[no-any-return]

    @property
    def held(self) -> Literal['speed', 'piston-speed']:
        """What they kept while they were."""
        return self._get("held")  # type: ignore[no-any-return]

    @property
    def rankings(self) -> Records[Ranking]:
        """Their order by every criterion that all of them have."""
        return self._all("rankings", Ranking)

    @property
    def reference(self) -> int:
        """The engine with which the others are compared, by its place."""
        return self._get("reference")  # type: ignore[no-any-return]

    @property
    def share(self) -> float:
        """Share of its loads, devices and flywheel that the others are compared with [1]."""
        return self._get("share")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def warnings(self) -> list[str]:
        """What the user should know."""
        return self._list("warnings")  # type: ignore[no-any-return]


class ConditionCheck(Record):
    """One condition."""

    __slots__ = ()
    _FIELDS = ("condition", "not_applicable", "rows",)

    @property
    def condition(self) -> Literal['like-for-like', 'free-speed', 'moving-block', 'all-free', 'flexible-crank']:
        """Which."""
        return self._get("condition")  # type: ignore[no-any-return]

    @property
    def not_applicable(self) -> str | None:
        """Why it does not apply to this engine; `None`: it does."""
        return self._get("not_applicable")  # type: ignore[no-any-return]

    @property
    def rows(self) -> Records[CrossRow]:
        """Its rows."""
        return self._all("rows", CrossRow)


class Consequence(Record):
    """One quantity before and after."""

    __slots__ = ()
    _FIELDS = ("after", "before", "change", "part", "quantity",)

    @property
    def after(self) -> float:
        """With the new ones."""
        return self._get("after")  # type: ignore[no-any-return]

    @property
    def before(self) -> float:
        """With the weights that the engine had, in the unit of the quantity; what is rounding is 0."""
        return self._get("before")  # type: ignore[no-any-return]

    @property
    def change(self) -> Literal['better', 'unchanged', 'worse']:
        """What became of it."""
        return self._get("change")  # type: ignore[no-any-return]

    @property
    def part(self) -> AffectedPart:
        """Where."""
        return self._of("part", AffectedPart)  # type: ignore[no-any-return]

    @property
    def quantity(self) -> Literal['force', 'couple', 'roll-moment', 'mount-force', 'main-load-rms', 'main-load-peak', 'bending-moment', 'counterweight-mass', 'counterweight-unbalance', 'shaft-unbalance', 'balance-rate']:
        """Which."""
        return self._get("quantity")  # type: ignore[no-any-return]


class Consequences(Record):
    """What other weights do to an engine."""

    __slots__ = ()
    _FIELDS = ("added", "bending", "counterweights", "dropped", "rows", "speed", "version",)

    @property
    def added(self) -> list[str]:
        """Names of counterweights that were not there before."""
        return self._list("added")  # type: ignore[no-any-return]

    @property
    def bending(self) -> Records[BendingAlong]:
        """Bending moment along every crankshaft with throws."""
        return self._all("bending", BendingAlong)

    @property
    def counterweights(self) -> list[int]:
        """Number of counterweights before and after."""
        return self._list("counterweights")  # type: ignore[no-any-return]

    @property
    def dropped(self) -> list[str]:
        """Names of counterweights that are there no more, or have no unbalance any more."""
        return self._list("dropped")  # type: ignore[no-any-return]

    @property
    def rows(self) -> Records[Consequence]:
        """Every quantity, in the order of `Affected`; within one from the free end on."""
        return self._all("rows", Consequence)

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]: the highest of the engine."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class ContactReport(Record):
    """How rings and bars touch."""

    __slots__ = ()
    _FIELDS = ("closed", "largest_pressure", "penetration", "steps",)

    @property
    def closed(self) -> float:
        """Share of the area of all rings that touches."""
        return self._get("closed")  # type: ignore[no-any-return]

    @property
    def largest_pressure(self) -> float:
        """Largest contact pressure [Pa]."""
        return self._get("largest_pressure")  # type: ignore[no-any-return]

    @property
    def penetration(self) -> float:
        """How far the stiff layer that stands for the contact gives way there [m]."""
        return self._get("penetration")  # type: ignore[no-any-return]

    @property
    def steps(self) -> int:
        """Steps until no point changed between open and closed, each with a factor of its own."""
        return self._get("steps")  # type: ignore[no-any-return]


class Contribution(Record):
    """What one tolerance adds to the scatter."""

    __slots__ = ()
    _FIELDS = ("error", "share", "tolerance",)

    @property
    def error(self) -> float:
        """Its standard error: what other samples of the same number would change, about."""
        return self._get("error")  # type: ignore[no-any-return]

    @property
    def share(self) -> float:
        """First-order index: share of the output's variance that would vanish if the deviations of this tolerance, one at a
        time, were known. Shares sum to 1 less what only several together do.
        """
        return self._get("share")  # type: ignore[no-any-return]

    @property
    def tolerance(self) -> int:
        """Place of the tolerance in the request, from 0."""
        return self._get("tolerance")  # type: ignore[no-any-return]


class ConvergedNumber(Record):
    """A number on three meshes."""

    __slots__ = ()
    _FIELDS = ("found", "name", "scale", "unit",)

    @property
    def found(self) -> Extrapolated:
        """Values in SI units, extrapolated."""
        return self._of("found", Extrapolated)  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """What it is."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def scale(self) -> float:
        """SI units in one of the tables."""
        return self._get("scale")  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """Its unit in the tables."""
        return self._get("unit")  # type: ignore[no-any-return]


class Convergence(Record):
    """A convergence study."""

    __slots__ = ()
    _FIELDS = ("meshes", "note", "numbers",)

    @property
    def meshes(self) -> Records[ConvergenceMesh]:
        """The meshes, the coarse one first."""
        return self._all("meshes", ConvergenceMesh)

    @property
    def note(self) -> str | None:
        """Why the meshes are as fine as they are, where nobody says it."""
        return self._get("note")  # type: ignore[no-any-return]

    @property
    def numbers(self) -> Records[ConvergedNumber]:
        """The numbers."""
        return self._all("numbers", ConvergedNumber)


class ConvergenceMesh(Record):
    """A mesh of a convergence study."""

    __slots__ = ()
    _FIELDS = ("fillet_elements", "nodes", "size", "unknowns",)

    @property
    def fillet_elements(self) -> int:
        """Elements across the 90 degrees of a fillet."""
        return self._get("fillet_elements")  # type: ignore[no-any-return]

    @property
    def nodes(self) -> int:
        """Nodes."""
        return self._get("nodes")  # type: ignore[no-any-return]

    @property
    def size(self) -> float:
        """Edge of the elements away from fillets [m]."""
        return self._get("size")  # type: ignore[no-any-return]

    @property
    def unknowns(self) -> int:
        """Unknowns."""
        return self._get("unknowns")  # type: ignore[no-any-return]


class Correction(Result):
    """What to do about the unbalance of a rotor."""

    __slots__ = ()
    _FIELDS = ("grade_after", "grade_now", "holds", "name", "next", "planes", "remarks", "runs", "version",)

    @property
    def grade_after(self) -> Grade | None:
        """The same with the corrections made as told."""
        return self._of("grade_after", Grade)  # type: ignore[no-any-return]

    @property
    def grade_now(self) -> Grade | None:
        """The balance quality grade as the rotor is now, where mass, service speed, grade and the places of the planes
        are given.
        """
        return self._of("grade_now", Grade)  # type: ignore[no-any-return]

    @property
    def holds(self) -> bool | None:
        """Whether every limit that the sheet states holds now; `None` where none is stated or nothing measured."""
        return self._get("holds")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name of the sheet."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def next(self) -> NextStep:
        """What to do next."""
        return self._of("next", NextStep)  # type: ignore[no-any-return]

    @property
    def planes(self) -> Records[PlaneCorrection]:
        """What to add or remove, plane by plane. Empty before any trial weight."""
        return self._all("planes", PlaneCorrection)

    @property
    def remarks(self) -> Records[Remark]:
        """Doubts."""
        return self._all("remarks", Remark)

    @property
    def runs(self) -> RunFindings | None:
        """What the runs say; `None` for a correction from a display."""
        return self._of("runs", RunFindings)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class Cost(Record):
    """What a weight costs if it is used, in whatever unit the file counts: nothing where it is not."""

    __slots__ = ()
    _FIELDS = ("fixed", "per_amount",)

    @property
    def fixed(self) -> float:
        """Whatever its amount."""
        return self._get("fixed")  # type: ignore[no-any-return]

    @property
    def per_amount(self) -> float:
        """For every unit of its amount [1/(kg m)]."""
        return self._get("per_amount")  # type: ignore[no-any-return]


class Cost2(Record):
    """Cost of a run."""

    __slots__ = ()
    _FIELDS = ("evaluations", "rejected", "steps",)

    @property
    def evaluations(self) -> int:
        """Evaluations of the equations of motion."""
        return self._get("evaluations")  # type: ignore[no-any-return]

    @property
    def rejected(self) -> int:
        """Rejected steps."""
        return self._get("rejected")  # type: ignore[no-any-return]

    @property
    def steps(self) -> int:
        """Of the integrator."""
        return self._get("steps")  # type: ignore[no-any-return]


class CounterweightCheck(Result):
    """Crankshafts, counterweights, weights of balance shafts and clearances of an engine."""

    __slots__ = ()
    _FIELDS = ("clearances", "counterweights", "crankshafts", "engine", "is_kept", "shaft_weights", "swept_overlaps", "version",)

    @property
    def clearances(self) -> Clearances | None:
        """Clearances; none where the file names nothing to stay clear of."""
        return self._of("clearances", Clearances)  # type: ignore[no-any-return]

    @property
    def counterweights(self) -> Records[CheckedCounterweight]:
        """Counterweights that are parts."""
        return self._all("counterweights", CheckedCounterweight)

    @property
    def crankshafts(self) -> Records[CrankshaftBody]:
        """The crankshafts as bodies; empty where the file has no `[crank.body]`."""
        return self._all("crankshafts", CrankshaftBody)

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def is_kept(self) -> bool:
        """Whether every counterweight and weight of a shaft has its unbalance and every clearance is kept."""
        return self._get("is_kept")  # type: ignore[no-any-return]

    @property
    def shaft_weights(self) -> Records[CheckedShaftWeight]:
        """Weights of balance shafts that are parts."""
        return self._all("shaft_weights", CheckedShaftWeight)

    @property
    def swept_overlaps(self) -> Records[SweptOverlap]:
        """Where swept circles of weights of balance shafts overlap those of another shaft or of a crankshaft in one plane: whether anything
        meets depends on the phases.
        """
        return self._all("swept_overlaps", SweptOverlap)

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class CounterweightDesigns(Result):
    """The shapes found for counterweights of an engine."""

    __slots__ = ()
    _FIELDS = ("engine", "task", "version", "weights",)

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def task(self) -> ShapeTask:
        """Shapes among which they were found."""
        return self._of("task", ShapeTask)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def weights(self) -> Records[DesignedCounterweight]:
        """The weights, in the order of the engine."""
        return self._all("weights", DesignedCounterweight)


class CounterweightPattern(Record):
    """Weights on the crank webs, by what they answer.

    The weight of a web stands opposite the throws of its group and has half of `rotating` times the rotating unbalance
    (crank and big ends) and `reciprocating` times the reciprocating mass times crank radius of the group: 1 and 0 on all
    webs balance each throw in itself, 0.5 and 0 half of it, 1 and 0.5 are a balance factor of 50 %.
    """

    __slots__ = ()
    _FIELDS = ("name", "reciprocating", "rotating", "webs",)

    @property
    def name(self) -> str:
        """What the user calls it."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def reciprocating(self) -> float:
        """Share of the reciprocating mass."""
        return self._get("reciprocating")  # type: ignore[no-any-return]

    @property
    def rotating(self) -> float:
        """Share of the rotating unbalance."""
        return self._get("rotating")  # type: ignore[no-any-return]

    @property
    def webs(self) -> list[bool] | None:
        """Whether each web has its weight, from the free end, two webs a group; `None`: all have."""
        return self._get("webs")  # type: ignore[no-any-return]


class CounterweightShape(Record):
    """A counterweight of the family around the disc of its web."""

    __slots__ = ()
    _FIELDS = ("arc_angle", "arc_radius", "rectangle_height", "shoulder_height", "web_radius",)

    @property
    def arc_angle(self) -> float:
        """Included angle `alpha` of the arc [rad], less than a full turn."""
        return self._get("arc_angle")  # type: ignore[no-any-return]

    @property
    def arc_radius(self) -> float:
        """Radius `R` of the arc [m]."""
        return self._get("arc_radius")  # type: ignore[no-any-return]

    @property
    def rectangle_height(self) -> float:
        """Height `h` of the rectangle, from the crank axis [m]."""
        return self._get("rectangle_height")  # type: ignore[no-any-return]

    @property
    def shoulder_height(self) -> float:
        """Height `H` of the trapezoid [m]."""
        return self._get("shoulder_height")  # type: ignore[no-any-return]

    @property
    def web_radius(self) -> float:
        """Radius `r` of the web's disc, and half width of the rectangle [m]."""
        return self._get("web_radius")  # type: ignore[no-any-return]


class Counts(Record):
    """What became of the cases looked at: `cases` is the sum of all the others."""

    __slots__ = ()
    _FIELDS = ("broken", "cases", "duplicates", "invalid", "judged",)

    @property
    def broken(self) -> Records[Broken]:
        """By constraint, in the order of the request."""
        return self._all("broken", Broken)

    @property
    def cases(self) -> int:
        """Cases looked at."""
        return self._get("cases")  # type: ignore[no-any-return]

    @property
    def duplicates(self) -> int:
        """Equivalent to a case of lower number by symmetry."""
        return self._get("duplicates")  # type: ignore[no-any-return]

    @property
    def invalid(self) -> Records[InvalidCount]:
        """No engine, by the first reason that holds; counted before duplicates are."""
        return self._all("invalid", InvalidCount)

    @property
    def judged(self) -> int:
        """Judged by the objectives."""
        return self._get("judged")  # type: ignore[no-any-return]


class CrankBody(Record):
    """What is known of the crankshaft as a body, bobweights on."""

    __slots__ = ()
    _FIELDS = ("mass", "mass_centre", "polar_inertia", "transverse_inertia",)

    @property
    def mass(self) -> float:
        """Mass with bobweights [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def mass_centre(self) -> float:
        """Place of its mass centre along the crank [m], from the origin."""
        return self._get("mass_centre")  # type: ignore[no-any-return]

    @property
    def polar_inertia(self) -> float:
        """Inertia about the crank axis [kg m^2]."""
        return self._get("polar_inertia")  # type: ignore[no-any-return]

    @property
    def transverse_inertia(self) -> float:
        """Inertia about a transverse axis through the mass centre [kg m^2]."""
        return self._get("transverse_inertia")  # type: ignore[no-any-return]


class CrankCase(Record):
    """A solved case of a crankshaft."""

    __slots__ = ()
    _FIELDS = ("contact", "displaced_at", "films", "largest_displacement", "peaks", "surfaces", "webs",)

    @property
    def contact(self) -> ContactReport | None:
        """With rings: how they touch."""
        return self._of("contact", ContactReport)  # type: ignore[no-any-return]

    @property
    def displaced_at(self) -> FloatArray:
        """Where it is [m]."""
        return self._array("displaced_at")  # type: ignore[no-any-return]

    @property
    def films(self) -> Records[JournalInFilm]:
        """In oil films: how each main bearing's journal rests."""
        return self._all("films", JournalInFilm)

    @property
    def largest_displacement(self) -> float:
        """Largest displacement [m]."""
        return self._get("largest_displacement")  # type: ignore[no-any-return]

    @property
    def peaks(self) -> Records[SurfacePeak]:
        """Peaks of all fillets, along z."""
        return self._all("peaks", SurfacePeak)

    @property
    def surfaces(self) -> Records[SurfacePeak]:
        """Peaks of the surfaces of pins and journals, loaded ones too; away from sharp corners."""
        return self._all("surfaces", SurfacePeak)

    @property
    def webs(self) -> Records[SurfacePeak]:
        """Peaks of webs: within each the largest stress away from fillets and sharp corners."""
        return self._all("webs", SurfacePeak)


class CrankChain(Record):
    """A chain with where its numbers come from."""

    __slots__ = ()
    _FIELDS = ("chain", "ker_wilson", "notes", "parts", "throws",)

    @property
    def chain(self) -> Chain:
        """The chain."""
        return self._of("chain", Chain)  # type: ignore[no-any-return]

    @property
    def ker_wilson(self) -> list[float | None]:
        """For each shaft its stiffness by Ker Wilson's lengths [N m/rad], where the crankshaft has sizes."""
        return self._list("ker_wilson")  # type: ignore[no-any-return]

    @property
    def notes(self) -> list[str]:
        """What the file does not say and was assumed, and what was left out."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def parts(self) -> Records[ThrowParts]:
        """Inertia of each throw by its parts."""
        return self._all("parts", ThrowParts)

    @property
    def throws(self) -> list[int]:
        """Station of each throw."""
        return self._list("throws")  # type: ignore[no-any-return]


class CrankCycle(Result):
    """A crankshaft over the cycle by several laws of its bearings, side by side.

    The crankshaft linear, elastic, in natural modes and static shapes; rods and pistons rigid; block at rest; all motion in planes across the crank.
    """

    __slots__ = ()
    _FIELDS = ("coordinates", "fatigue", "frequencies", "gas", "motion", "notes", "options", "period", "ringing", "rules", "runs", "sheet", "speed", "stress_nodes", "version",)

    @property
    def coordinates(self) -> int:
        """Coordinates of the crankshaft."""
        return self._get("coordinates")  # type: ignore[no-any-return]

    @property
    def fatigue(self) -> FatigueMeasure | None:
        """What judges fatigue; `None` where the file gives no strength."""
        return self._of("fatigue", FatigueMeasure)  # type: ignore[no-any-return]

    @property
    def frequencies(self) -> FloatArray:
        """Free natural frequencies of the modes that were kept [Hz]."""
        return self._array("frequencies")  # type: ignore[no-any-return]

    @property
    def gas(self) -> str | None:
        """Where the pressures come from, in words; `None`: no gas acts."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def motion(self) -> Literal['constant', 'free']:
        """How the flywheel turns."""
        return self._get("motion")  # type: ignore[no-any-return]

    @property
    def notes(self) -> list[str]:
        """What was assumed and left out."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def options(self) -> CycleOptions:
        """How the runs were made."""
        return self._of("options", CycleOptions)  # type: ignore[no-any-return]

    @property
    def period(self) -> float:
        """Period of crankshaft 1 [rad]."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def ringing(self) -> str | None:
        """What keeps the largest values from being those of an engine, where something does."""
        return self._get("ringing")  # type: ignore[no-any-return]

    @property
    def rules(self) -> MainRules | None:
        """Main bearings of a rigid crankshaft by three rules; `None`: not comparable, a note says why."""
        return self._of("rules", MainRules)  # type: ignore[no-any-return]

    @property
    def runs(self) -> Records[CycleRun]:
        """One a law and kind of crankshaft."""
        return self._all("runs", CycleRun)

    @property
    def sheet(self) -> CrankSheet:
        """What was meshed."""
        return self._of("sheet", CrankSheet)  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Mean speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def stress_nodes(self) -> int:
        """Nodes of fillets at which stress is known."""
        return self._get("stress_nodes")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class CrankFatigue(Result):
    """Safety against fatigue of every fillet of a crankshaft.

    Linear, elastic; loads of the closed form at constant speed, superposed from unit loads; Findley's criterion.
    """

    __slots__ = ()
    _FIELDS = ("bending_limit", "factors", "findley", "gas", "instants", "notes", "sheet", "solve", "speeds", "support", "torsion_limit", "version",)

    @property
    def bending_limit(self) -> Sourced:
        """Fatigue limit in alternating bending [Pa]."""
        return self._of("bending_limit", Sourced)  # type: ignore[no-any-return]

    @property
    def factors(self) -> FatigueFactors:
        """Factors on the limits."""
        return self._of("factors", FatigueFactors)  # type: ignore[no-any-return]

    @property
    def findley(self) -> Findley:
        """The criterion with these limits and factors."""
        return self._of("findley", Findley)  # type: ignore[no-any-return]

    @property
    def gas(self) -> str | None:
        """Where the pressures come from, in words; `None`: no gas acts."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def instants(self) -> int:
        """Instants of a revolution."""
        return self._get("instants")  # type: ignore[no-any-return]

    @property
    def notes(self) -> list[str]:
        """What was assumed and left out."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def sheet(self) -> CrankSheet:
        """What was meshed."""
        return self._of("sheet", CrankSheet)  # type: ignore[no-any-return]

    @property
    def solve(self) -> SolveReport:
        """How the equations were solved."""
        return self._of("solve", SolveReport)  # type: ignore[no-any-return]

    @property
    def speeds(self) -> Records[FatigueAtSpeed]:
        """At each speed."""
        return self._all("speeds", FatigueAtSpeed)

    @property
    def support(self) -> str:
        """What holds it, in words."""
        return self._get("support")  # type: ignore[no-any-return]

    @property
    def torsion_limit(self) -> Sourced:
        """Fatigue limit in alternating torsion [Pa]."""
        return self._of("torsion_limit", Sourced)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class CrankLoad(Record):
    """What loads a crankshaft."""

    __slots__ = ()
    _FIELDS = ("acceleration", "pins", "pressure", "speed", "turn",)

    @property
    def acceleration(self) -> float:
        """Rate of that speed [rad/s^2], whose field of tangential inertia loads the body."""
        return self._get("acceleration")  # type: ignore[no-any-return]

    @property
    def pins(self) -> Records[PinLoad2]:
        """Forces on its pins."""
        return self._all("pins", PinLoad2)

    @property
    def pressure(self) -> Literal['cosine', 'uniform', 'film']:
        """How they are spread."""
        return self._get("pressure")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed about its axis [rad/s], whose centrifugal field loads the body."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def turn(self) -> float:
        """Angle from the block's x axis to that of the frame of the crankshaft, positive from x to y [rad]: springs that differ across directions keep
        to the block.
        """
        return self._get("turn")  # type: ignore[no-any-return]


class CrankMesh(Record):
    """The mesh of a crankshaft. Sets: `MAIN_1` .. and `PIN_1` .. (the bearing surfaces between the fillets), `NOSE_1` .. and `FLANGE_1` .. (the round surfaces of
    their steps), `FREE_END`, `FLYWHEEL` (the end faces).
    """

    __slots__ = ()
    _FIELDS = ("body_mass", "corners", "left_out", "quality", "webs", "weights",)

    @property
    def body_mass(self) -> float:
        """Mass of the body that is meshed, without fillets; of a bay that of the whole crankshaft [kg]."""
        return self._get("body_mass")  # type: ignore[no-any-return]

    @property
    def corners(self) -> Records[FilletPlace]:
        """Its corners, along z."""
        return self._all("corners", FilletPlace)

    @property
    def left_out(self) -> list[str]:
        """What of the crankshaft is not meshed, or not as it is."""
        return self._list("left_out")  # type: ignore[no-any-return]

    @property
    def quality(self) -> MeshQuality:
        """Its quality."""
        return self._of("quality", MeshQuality)  # type: ignore[no-any-return]

    @property
    def webs(self) -> Records[WebPlace]:
        """Its webs, along z."""
        return self._all("webs", WebPlace)

    @property
    def weights(self) -> Records[CarriedWeight]:
        """Counterweights without a shape: their centrifugal forces load the mesh, their masses are not in it."""
        return self._all("weights", CarriedWeight)


class CrankMeshOptions(Record):
    """How fine a crankshaft is meshed."""

    __slots__ = ()
    _FIELDS = ("fillet_elements", "fillets", "size",)

    @property
    def fillet_elements(self) -> int:
        """Elements across the 90 degrees of a fillet: an even number, at least 2."""
        return self._get("fillet_elements")  # type: ignore[no-any-return]

    @property
    def fillets(self) -> bool:
        """Whether fillets are meshed; without them their corners are sharp, which is enough for stiffness."""
        return self._get("fillets")  # type: ignore[no-any-return]

    @property
    def size(self) -> float:
        """Edge of the elements away from fillets [m]."""
        return self._get("size")  # type: ignore[no-any-return]


class CrankModes(Result):
    """Natural modes of a crankshaft at rest."""

    __slots__ = ()
    _FIELDS = ("convergence", "modes", "sheet", "support", "version",)

    @property
    def convergence(self) -> Convergence | None:
        """With three meshes: what the frequencies tend to; the modes are those of the finest."""
        return self._of("convergence", Convergence)  # type: ignore[no-any-return]

    @property
    def modes(self) -> ModeSolution:
        """The modes; their shapes are not serialised."""
        return self._of("modes", ModeSolution)  # type: ignore[no-any-return]

    @property
    def sheet(self) -> CrankSheet:
        """What was meshed."""
        return self._of("sheet", CrankSheet)  # type: ignore[no-any-return]

    @property
    def support(self) -> str:
        """What holds it, in words."""
        return self._get("support")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class CrankRule(Result):
    """Strength of a crankshaft by formulas after UR M53.

    Each throw on two supports, alternating stresses alone, torque of a rigid crankshaft with that of torsional vibration as given.
    """

    __slots__ = ()
    _FIELDS = ("acceptable", "by_elements", "crankshaft", "engine", "forging", "gas", "notes", "rule", "speeds", "tensile_strength", "version",)

    @property
    def acceptable(self) -> float:
        """Least safety that the rule accepts [1]."""
        return self._get("acceptable")  # type: ignore[no-any-return]

    @property
    def by_elements(self) -> Records[ThrowMesh]:
        """Meshes of the throws, where their factors by finite elements stand beside those of the formulas."""
        return self._all("by_elements", ThrowMesh)

    @property
    def crankshaft(self) -> int:
        """Number of the crankshaft, from 1."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def forging(self) -> Sourced:
        """Factor K of the way of forging [1]."""
        return self._of("forging", Sourced)  # type: ignore[no-any-return]

    @property
    def gas(self) -> str | None:
        """Where the pressures come from, in words; `None`: no gas acts."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def notes(self) -> list[str]:
        """What was assumed and left out."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def rule(self) -> str:
        """Which formulas, and how far they are trusted."""
        return self._get("rule")  # type: ignore[no-any-return]

    @property
    def speeds(self) -> Records[SpeedSheet]:
        """The sheet at each speed."""
        return self._all("speeds", SpeedSheet)

    @property
    def tensile_strength(self) -> Sourced:
        """Tensile strength [Pa]."""
        return self._of("tensile_strength", Sourced)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class CrankSheet(Record):
    """A meshed crankshaft."""

    __slots__ = ()
    _FIELDS = ("crank", "crankshaft", "engine", "exact_mass", "fillet_mass", "material", "options", "origins", "own_file",)

    @property
    def crank(self) -> CrankMesh:
        """The mesh: its quality, its corners, what is not meshed; the nodes themselves are not serialised."""
        return self._of("crank", CrankMesh)  # type: ignore[no-any-return]

    @property
    def crankshaft(self) -> int:
        """Number of the crankshaft, from 1."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def exact_mass(self) -> float:
        """Mass of the exact body without fillets, of what is meshed; of a mesh from a file that of the body with nose and flange, 0 where the engine file has no body [kg]."""
        return self._get("exact_mass")  # type: ignore[no-any-return]

    @property
    def fillet_mass(self) -> float:
        """Volume that fillets add, by Pappus's rule, times the density [kg]."""
        return self._get("fillet_mass")  # type: ignore[no-any-return]

    @property
    def material(self) -> StressMaterial:
        """Its material."""
        return self._of("material", StressMaterial)  # type: ignore[no-any-return]

    @property
    def options(self) -> CrankMeshOptions:
        """How fine it is meshed; says nothing of a mesh from a file."""
        return self._of("options", CrankMeshOptions)  # type: ignore[no-any-return]

    @property
    def origins(self) -> MeshOrigins:
        """Who says so."""
        return self._of("origins", MeshOrigins)  # type: ignore[no-any-return]

    @property
    def own_file(self) -> str | None:
        """The file that its mesh comes from; none where it is meshed from its body."""
        return self._get("own_file")  # type: ignore[no-any-return]


class CrankUnbalance(Record):
    """Unbalance of something that turns with the crankshaft, as a force and as a couple.

    ```text
    U = INTEGRAL (x, y) dm      V = INTEGRAL z (x, y) dm        (book, eq. 22.50)
    [kg m]                      [kg m^2], about the origin of the engine
    ```
    At the angular speed `w` it pulls with `w^2 U`, and with the couple `w^2 V` of the forces at their places along z.
    """

    __slots__ = ()
    _FIELDS = ("couple", "unbalance",)

    @property
    def couple(self) -> Point:
        """Its moment `V` along the crank [kg m^2]."""
        return self._of("couple", Point)  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> Point:
        """Static unbalance `U` [kg m]."""
        return self._of("unbalance", Point)  # type: ignore[no-any-return]


class CrankWithBobweights(Result):
    """Unbalance of one crankshaft with bobweights."""

    __slots__ = ()
    _FIELDS = ("body", "counterweights", "couple_unbalance", "crankshaft", "engine", "planes", "rotation", "static_unbalance", "throws", "version",)

    @property
    def body(self) -> BodyState | None:
        """As a body, where that is known."""
        return self._of("body", BodyState)  # type: ignore[no-any-return]

    @property
    def counterweights(self) -> Records[PlaneUnbalance]:
        """Counterweights of the file."""
        return self._all("counterweights", PlaneUnbalance)

    @property
    def couple_unbalance(self) -> FloatArray:
        """Couple unbalance about the origin [kg m^2]."""
        return self._array("couple_unbalance")  # type: ignore[no-any-return]

    @property
    def crankshaft(self) -> str:
        """Name of the crankshaft."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def planes(self) -> Records[PlaneUnbalance]:
        """Dynamic unbalance: as two, in the planes asked for."""
        return self._all("planes", PlaneUnbalance)

    @property
    def rotation(self) -> Literal['clockwise', 'reverse']:
        """Sense of rotation, for pictures."""
        return self._get("rotation")  # type: ignore[no-any-return]

    @property
    def static_unbalance(self) -> FloatArray:
        """Static unbalance [kg m]."""
        return self._array("static_unbalance")  # type: ignore[no-any-return]

    @property
    def throws(self) -> Records[PlaneUnbalance]:
        """Throws and bobweights."""
        return self._all("throws", PlaneUnbalance)

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class CrankshaftBody(Record):
    """A crankshaft as a body. Frame: `crankshaft`."""

    __slots__ = ()
    _FIELDS = ("counted_twice", "mass", "name", "point_weights", "polar_inertia", "sections", "throws", "unbalance",)

    @property
    def counted_twice(self) -> CrankUnbalance:
        """What pieces have in common, which a sum over pieces that stand alone would count twice (eq. 22.52). Of an engine that was read
        from a file the part that a counterweight of the family shares with its own web is out of its weight already.
        """
        return self._of("counted_twice", CrankUnbalance)  # type: ignore[no-any-return]

    @property
    def mass(self) -> MassProperties:
        """Mass, centre and inertia of all pieces, without point weights: about the origin of the engine on the crank axis
        and about the centre of mass, products of inertia with their minus sign.
        """
        return self._of("mass", MassProperties)  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name of the crankshaft."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def point_weights(self) -> Records[PointWeight]:
        """Weights given by number only."""
        return self._all("point_weights", PointWeight)

    @property
    def polar_inertia(self) -> float:
        """Moment of inertia about the crank axis [kg m^2], without point weights."""
        return self._get("polar_inertia")  # type: ignore[no-any-return]

    @property
    def sections(self) -> Records[CrankshaftSection]:
        """Its pieces along z."""
        return self._all("sections", CrankshaftSection)

    @property
    def throws(self) -> Records[ThrowShare]:
        """The same by throw, in the order of the file, and last what belongs to none."""
        return self._all("throws", ThrowShare)

    @property
    def unbalance(self) -> CrankUnbalance:
        """Unbalance of all pieces and point weights."""
        return self._of("unbalance", CrankUnbalance)  # type: ignore[no-any-return]


class CrankshaftMoments(Record):
    """One crankshaft in both models."""

    __slots__ = ()
    _FIELDS = ("crankshaft", "free_beam", "throw_by_throw",)

    @property
    def crankshaft(self) -> int:
        """Its number, from 1."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def free_beam(self) -> BeamLoads:
        """As a free beam: what its loads do not hold in balance is carried by the end mains."""
        return self._of("free_beam", BeamLoads)  # type: ignore[no-any-return]

    @property
    def throw_by_throw(self) -> BeamLoads:
        """Every throw held by its own two mains."""
        return self._of("throw_by_throw", BeamLoads)  # type: ignore[no-any-return]


class CrankshaftSection(Record):
    """A piece of the crankshaft: a journal, a pin, a web or a counterweight."""

    __slots__ = ()
    _FIELDS = ("couple", "from_", "kind", "mass", "name", "polar_inertia", "throw", "to", "unbalance",)

    @property
    def couple(self) -> Point:
        """Its moment `V` along the crank [kg m^2]."""
        return self._of("couple", Point)  # type: ignore[no-any-return]

    @property
    def from_(self) -> float:
        """Where it begins [m]."""
        return self._get("from")  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['journal', 'pin', 'web', 'counterweight']:
        """What it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Its mass [kg]: of a counterweight what it has beside journals, pins, webs and the counterweights before it."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """"journal 1", "pin 1", "web 1", or the name of the counterweight."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def polar_inertia(self) -> float:
        """Moment of inertia about the crank axis [kg m^2]."""
        return self._get("polar_inertia")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int | None:
        """Index of the throw that it belongs to; none for journals and weights beside the webs."""
        return self._get("throw")  # type: ignore[no-any-return]

    @property
    def to(self) -> float:
        """Where it ends [m]."""
        return self._get("to")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> Point:
        """Static unbalance `U` [kg m]."""
        return self._of("unbalance", Point)  # type: ignore[no-any-return]


class Criterion(Variant):
    """What is judged."""

    __slots__ = ()
    _FIELDS = ("kind", "peak", "order", "main_rms", "main_mean", "mains_with_gas",)

    @property
    def kind(self) -> Literal['peak', 'order', 'main-rms', 'main-mean', 'mains-with-gas', 'added-mass', 'added-unbalance', 'cost']:
        """Which of the variants it is.
        `added-mass`: Mass of all free weights [kg]: every one needs its radius.
        `added-unbalance`: Sum of the amounts of all free weights [kg m].
        `cost`: Cost of all free weights and shafts that are used (`Cost`, `shaft_costs`), in the unit of the file.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def peak(self) -> Load | None:
        """Peak of a load over the continuous cycle, at the highest speed of the engine."""
        return self._of("peak", Load)  # type: ignore[no-any-return]

    @property
    def order(self) -> tuple[Load, float] | None:
        """Peak of one order of a load (both senses together)."""
        return self._as("order", row(Load, one), None)  # type: ignore[no-any-return]

    @property
    def main_rms(self) -> Mains | None:
        """Root mean square of main-bearing loads of inertia over the continuous cycle [N], at the highest speed."""
        return self._of("main-rms", Mains)  # type: ignore[no-any-return]

    @property
    def main_mean(self) -> Mains | None:
        """Mean of the amount of main-bearing loads of inertia over equal angles of the cycle [N], at the highest speed."""
        return self._of("main-mean", Mains)  # type: ignore[no-any-return]

    @property
    def mains_with_gas(self) -> tuple[Literal['rms', 'mean', 'peak'], Mains] | None:
        """Main-bearing loads of inertia and gas [N], the largest over the range of speeds, or over the speeds of the task."""
        return self._as("mains-with-gas", row(one, Mains), None)  # type: ignore[no-any-return]


class Critical(Record):
    """A speed at which an order meets a natural frequency."""

    __slots__ = ()
    _FIELDS = ("frequency", "modal_torque", "mode", "order", "speed", "work",)

    @property
    def frequency(self) -> float:
        """Natural frequency there [rad/s]."""
        return self._get("frequency")  # type: ignore[no-any-return]

    @property
    def modal_torque(self) -> float:
        """Torque of this order in the mode, in true phase: `|SUM T_k phi|` [N m]."""
        return self._get("modal_torque")  # type: ignore[no-any-return]

    @property
    def mode(self) -> int:
        """Number of the mode, from 1."""
        return self._get("mode")  # type: ignore[no-any-return]

    @property
    def order(self) -> float:
        """The order."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of the reference [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def work(self) -> float:
        """Work of a cycle of vibration at 1 rad of the largest station: `pi` times the modal torque [J]."""
        return self._get("work")  # type: ignore[no-any-return]


class CriticalPlane(Record):
    """A plane with what acts on it over the cycle."""

    __slots__ = ()
    _FIELDS = ("instant", "normal", "normal_stress", "shear", "value",)

    @property
    def instant(self) -> int:
        """Index of the instant of that normal stress."""
        return self._get("instant")  # type: ignore[no-any-return]

    @property
    def normal(self) -> FloatArray:
        """Its normal."""
        return self._array("normal")  # type: ignore[no-any-return]

    @property
    def normal_stress(self) -> float:
        """Largest normal stress [Pa], tension positive."""
        return self._get("normal_stress")  # type: ignore[no-any-return]

    @property
    def shear(self) -> float:
        """Amplitude of the shear stress tau_a [Pa]."""
        return self._get("shear")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """tau_a + k sigma_n [Pa]."""
        return self._get("value")  # type: ignore[no-any-return]


class CrossCheck(Result):
    """Comparison of two independent computations of the same engine."""

    __slots__ = ()
    _FIELDS = ("conditions", "engine", "gas", "notes", "speed", "version",)

    @property
    def conditions(self) -> Records[ConditionCheck]:
        """Conditions, in order."""
        return self._all("conditions", ConditionCheck)

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def gas(self) -> str | None:
        """Where the pressures come from, in words; `None`: inertia alone."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def notes(self) -> list[str]:
        """What of the file acts in some conditions alone."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class CrossRow(Record):
    """One quantity."""

    __slots__ = ()
    _FIELDS = ("bar", "bond_graph", "closed_form", "difference", "multibody", "order", "quantity", "reason", "scale", "unit", "verdict",)

    @property
    def bar(self) -> float | None:
        """Largest share of `scale` that the difference may be; `None`: no bar."""
        return self._get("bar")  # type: ignore[no-any-return]

    @property
    def bond_graph(self) -> float | None:
        """Largest value of the bond graph over the run; `None`: the closed form is compared."""
        return self._get("bond_graph")  # type: ignore[no-any-return]

    @property
    def closed_form(self) -> float | None:
        """Largest value of the closed form over the cycle, or amplitude of the order; `None`: the bond graph is compared."""
        return self._get("closed_form")  # type: ignore[no-any-return]

    @property
    def difference(self) -> float:
        """Largest difference."""
        return self._get("difference")  # type: ignore[no-any-return]

    @property
    def multibody(self) -> float:
        """The same of the multibody simulation; under condition E of the flexible crankshaft."""
        return self._get("multibody")  # type: ignore[no-any-return]

    @property
    def order(self) -> float | None:
        """Order; `None`: over the whole cycle."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def quantity(self) -> str:
        """What is compared."""
        return self._get("quantity")  # type: ignore[no-any-return]

    @property
    def reason(self) -> str | None:
        """Why they differ, where they must."""
        return self._get("reason")  # type: ignore[no-any-return]

    @property
    def scale(self) -> float:
        """What it is held against: the largest amplitude of its kind, at least a thousandth of what single parts exert."""
        return self._get("scale")  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """Its unit."""
        return self._get("unit")  # type: ignore[no-any-return]

    @property
    def verdict(self) -> Literal['agrees', 'differs-as-it-must', 'disagrees']:
        """Verdict."""
        return self._get("verdict")  # type: ignore[no-any-return]


class Curve(Record):
    """An angle over speed [rad]."""

    __slots__ = ()
    _FIELDS = ("by_order", "sum", "total",)

    @property
    def by_order(self) -> list[FloatArray]:
        """Amplitude of each order at each speed [rad]."""
        return self._rows("by_order")  # type: ignore[no-any-return]

    @property
    def sum(self) -> FloatArray:
        """Sum of the amplitudes of all orders, whatever their phases [rad]."""
        return self._array("sum")  # type: ignore[no-any-return]

    @property
    def total(self) -> FloatArray:
        """Amplitude of all orders in true phase at each speed [rad]."""
        return self._array("total")  # type: ignore[no-any-return]


class CycleOptions(Record):
    """How a train is run."""

    __slots__ = ()
    _FIELDS = ("most_cycles", "orbit_change", "samples", "stress_change", "tolerance",)

    @property
    def most_cycles(self) -> int:
        """Most cycles."""
        return self._get("most_cycles")  # type: ignore[no-any-return]

    @property
    def orbit_change(self) -> float:
        """Change of the orbits from cycle to cycle over the clearance that counts as none."""
        return self._get("orbit_change")  # type: ignore[no-any-return]

    @property
    def samples(self) -> int:
        """Instants of a period, a multiple of 8."""
        return self._get("samples")  # type: ignore[no-any-return]

    @property
    def stress_change(self) -> float:
        """Change of loads and deformation over their largest that counts as none."""
        return self._get("stress_change")  # type: ignore[no-any-return]

    @property
    def tolerance(self) -> float:
        """Tolerance of a step: of eccentricities over the clearance, of deformations over those under the largest force."""
        return self._get("tolerance")  # type: ignore[no-any-return]


class CycleOutcome(Record):
    """How the cycles ended."""

    __slots__ = ()
    _FIELDS = ("kind", "theta",)

    @property
    def kind(self) -> Literal['periodic', 'not_periodic', 'broken', 'stopped']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def theta(self) -> float | None:
        """Angle of crankshaft 1 [rad], from the first cycle on."""
        return self._get("theta")  # type: ignore[no-any-return]


class CycleResult(Record):
    """What a computed cycle gives in one chamber."""

    __slots__ = ()
    _FIELDS = ("cylinders", "exchange", "exchange_work", "gross_work", "heat", "indicated_efficiency", "mean_effective_pressure", "peak_pressure", "peak_pressure_angle", "peak_temperature", "peak_temperature_angle", "process", "thermal_efficiency", "trace", "trapped_mass", "version", "work",)

    @property
    def cylinders(self) -> list[int]:
        """Numbers of the cylinders that have it, from 1."""
        return self._list("cylinders")  # type: ignore[no-any-return]

    @property
    def exchange(self) -> ExchangeResult | None:
        """Gas exchange, walls and the integration, where the gas is exchanged over the angle (single zone)."""
        return self._of("exchange", ExchangeResult)  # type: ignore[no-any-return]

    @property
    def exchange_work(self) -> float:
        """Work of the gas exchange [J], negative where it costs."""
        return self._get("exchange_work")  # type: ignore[no-any-return]

    @property
    def gross_work(self) -> float:
        """Work of compression and expansion [J]."""
        return self._get("gross_work")  # type: ignore[no-any-return]

    @property
    def heat(self) -> float:
        """Heat released [J]."""
        return self._get("heat")  # type: ignore[no-any-return]

    @property
    def indicated_efficiency(self) -> float | None:
        """Net indicated work over the energy of the fuel, what does not burn included (indicated efficiency, fuel conversion efficiency)."""
        return self._get("indicated_efficiency")  # type: ignore[no-any-return]

    @property
    def mean_effective_pressure(self) -> float:
        """Net indicated mean effective pressure [Pa]."""
        return self._get("mean_effective_pressure")  # type: ignore[no-any-return]

    @property
    def peak_pressure(self) -> float:
        """Largest pressure [Pa]."""
        return self._get("peak_pressure")  # type: ignore[no-any-return]

    @property
    def peak_pressure_angle(self) -> float:
        """Its angle after firing top dead centre [rad]."""
        return self._get("peak_pressure_angle")  # type: ignore[no-any-return]

    @property
    def peak_temperature(self) -> float:
        """Highest temperature [K]."""
        return self._get("peak_temperature")  # type: ignore[no-any-return]

    @property
    def peak_temperature_angle(self) -> float:
        """Its angle after firing top dead centre [rad]."""
        return self._get("peak_temperature_angle")  # type: ignore[no-any-return]

    @property
    def process(self) -> str:
        """Which process: "Otto cycle", "single zone" and so on."""
        return self._get("process")  # type: ignore[no-any-return]

    @property
    def thermal_efficiency(self) -> float | None:
        """Net indicated work over the heat released (indicated thermal efficiency); `None` where it is motored."""
        return self._get("thermal_efficiency")  # type: ignore[no-any-return]

    @property
    def trace(self) -> CycleTrace:
        """Over the angle."""
        return self._of("trace", CycleTrace)  # type: ignore[no-any-return]

    @property
    def trapped_mass(self) -> float:
        """Mass trapped [kg]."""
        return self._get("trapped_mass")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def work(self) -> float:
        """Net indicated work of a cycle [J]."""
        return self._get("work")  # type: ignore[no-any-return]


class CycleRun(Record):
    """One law over the cycle."""

    __slots__ = ()
    _FIELDS = ("bearings", "crank", "cycles", "energy", "energy_error", "fatigue", "fillets", "free_speed", "iterations", "law", "orbit_change", "outcome", "recorded", "rejected", "speed", "steps", "stress_change", "theta", "torque",)

    @property
    def bearings(self) -> Records[BearingCycle]:
        """Main bearings, then big ends."""
        return self._all("bearings", BearingCycle)

    @property
    def crank(self) -> Literal['flexible', 'rigid']:
        """Whether the crankshaft yields."""
        return self._get("crank")  # type: ignore[no-any-return]

    @property
    def cycles(self) -> int:
        """Cycles that were run."""
        return self._get("cycles")  # type: ignore[no-any-return]

    @property
    def energy(self) -> EnergyBalance:
        """Energies of the recorded cycle; of several the one with the largest error."""
        return self._of("energy", EnergyBalance)  # type: ignore[no-any-return]

    @property
    def energy_error(self) -> float:
        """Missing energy over the turnover."""
        return self._get("energy_error")  # type: ignore[no-any-return]

    @property
    def fatigue(self) -> Records[FilletFatigue]:
        """Safety of the same fillets against fatigue over the recorded cycles. Empty where no strength is known."""
        return self._all("fatigue", FilletFatigue)

    @property
    def fillets(self) -> Records[FilletCycle]:
        """Fillets along z; of several recorded cycles peaks and curves are those of the envelope. Empty: a rigid crankshaft, or only sharp corners."""
        return self._all("fillets", FilletCycle)

    @property
    def free_speed(self) -> FreeSpeed | None:
        """For a free speed: the load, and the change of the speed over the last cycle; `None` before there is one."""
        return self._of("free_speed", FreeSpeed)  # type: ignore[no-any-return]

    @property
    def iterations(self) -> int:
        """Newton iterations."""
        return self._get("iterations")  # type: ignore[no-any-return]

    @property
    def law(self) -> Literal['rigid', 'contact', 'bushing', 'film', 'file']:
        """The law."""
        return self._get("law")  # type: ignore[no-any-return]

    @property
    def orbit_change(self) -> float | None:
        """Change of the orbits in the last cycle over the clearance; `None` before two cycles."""
        return self._get("orbit_change")  # type: ignore[no-any-return]

    @property
    def outcome(self) -> CycleOutcome:
        """How the cycles ended."""
        return self._of("outcome", CycleOutcome)  # type: ignore[no-any-return]

    @property
    def recorded(self) -> int:
        """Cycles behind the peaks and envelopes below: one where they repeat, five where they do not."""
        return self._get("recorded")  # type: ignore[no-any-return]

    @property
    def rejected(self) -> int:
        """Steps that were tried again shorter."""
        return self._get("rejected")  # type: ignore[no-any-return]

    @property
    def speed(self) -> FloatArray:
        """Speed of crankshaft 1 there [rad/s]."""
        return self._array("speed")  # type: ignore[no-any-return]

    @property
    def steps(self) -> int:
        """Steps of all cycles."""
        return self._get("steps")  # type: ignore[no-any-return]

    @property
    def stress_change(self) -> float | None:
        """Change of loads and deformation in the last cycle over their largest."""
        return self._get("stress_change")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle of crankshaft 1 at every instant of the last recorded cycle [rad]."""
        return self._array("theta")  # type: ignore[no-any-return]

    @property
    def torque(self) -> FloatArray:
        """Torque of the flywheel on the crankshaft there [N m], of its own sense."""
        return self._array("torque")  # type: ignore[no-any-return]


class CycleTrace(Record):
    """A cycle over the angle since firing top dead centre, equally spaced from 0 to a cycle, end point excluded. Lists are empty where the cycle does not
    know the quantity: an ideal one knows pressure and volume.
    """

    __slots__ = ()
    _FIELDS = ("angle", "exhaust", "heat_release", "intake", "mass", "pressure", "temperature", "volume", "wall_heat",)

    @property
    def angle(self) -> FloatArray:
        """Angle of the own crankshaft since firing top dead centre [rad]."""
        return self._array("angle")  # type: ignore[no-any-return]

    @property
    def exhaust(self) -> FloatArray:
        """Mass out through the exhaust [kg/rad], negative: back."""
        return self._array("exhaust")  # type: ignore[no-any-return]

    @property
    def heat_release(self) -> FloatArray:
        """Heat released [J/rad]."""
        return self._array("heat_release")  # type: ignore[no-any-return]

    @property
    def intake(self) -> FloatArray:
        """Mass in through the intake [kg/rad], negative: back."""
        return self._array("intake")  # type: ignore[no-any-return]

    @property
    def mass(self) -> FloatArray:
        """Mass [kg]."""
        return self._array("mass")  # type: ignore[no-any-return]

    @property
    def pressure(self) -> FloatArray:
        """Absolute pressure [Pa]."""
        return self._array("pressure")  # type: ignore[no-any-return]

    @property
    def temperature(self) -> FloatArray:
        """Temperature [K]."""
        return self._array("temperature")  # type: ignore[no-any-return]

    @property
    def volume(self) -> FloatArray:
        """Volume of the chamber [m^3]."""
        return self._array("volume")  # type: ignore[no-any-return]

    @property
    def wall_heat(self) -> FloatArray:
        """Heat to the walls [J/rad]."""
        return self._array("wall_heat")  # type: ignore[no-any-return]


class CylinderBearings(Record):
    """Piston, pins and rod of one cylinder."""

    __slots__ = ()
    _FIELDS = ("cylinder", "largest_thrust", "lower_pin", "piston_pin", "radial", "rod_frame", "side_thrust", "tangential",)

    @property
    def cylinder(self) -> int:
        """Its number, from 1."""
        return self._get("cylinder")  # type: ignore[no-any-return]

    @property
    def largest_thrust(self) -> Extreme:
        """Largest of its sizes over the continuous angle; `value` keeps the sign."""
        return self._of("largest_thrust", Extreme)  # type: ignore[no-any-return]

    @property
    def lower_pin(self) -> PinLoad:
        """Rod on its lower pin, `x + i y` of the block's frame [N]: the crankpin, with all that a master's articulated rods bring, or
        the knuckle pin of an articulated rod. The big-end masses count.
        """
        return self._of("lower_pin", PinLoad)  # type: ignore[no-any-return]

    @property
    def piston_pin(self) -> PinLoad:
        """Rod on the piston pin, `u + i v` of the cylinder frame [N]."""
        return self._of("piston_pin", PinLoad)  # type: ignore[no-any-return]

    @property
    def radial(self) -> FloatArray:
        """The same on the crankpin along the throw, positive away from the crank axis [N]; empty for an articulated rod."""
        return self._array("radial")  # type: ignore[no-any-return]

    @property
    def rod_frame(self) -> FloatArray:
        """The lower pin on the rod's bearing in the rod's frame, real part along the rod towards the piston [N]."""
        return self._array("rod_frame")  # type: ignore[no-any-return]

    @property
    def side_thrust(self) -> FloatArray:
        """Side thrust: piston on the cylinder wall along `v` [N]."""
        return self._array("side_thrust")  # type: ignore[no-any-return]

    @property
    def tangential(self) -> FloatArray:
        """And across it, positive where it drives the crankshaft [N]: torque over crank radius. Empty for an articulated rod."""
        return self._array("tangential")  # type: ignore[no-any-return]


class CylinderExtremes(Record):
    """Of what is carried at one cylinder."""

    __slots__ = ()
    _FIELDS = ("across_throw", "along_throw", "lower_pin", "piston_pin", "side_thrust",)

    @property
    def across_throw(self) -> Bounds:
        """The same across the throw, positive where it drives [N]."""
        return self._of("across_throw", Bounds)  # type: ignore[no-any-return]

    @property
    def along_throw(self) -> Bounds:
        """Force of the rod on the crankpin along its throw, outwards positive [N]; 0 for a knuckle pin."""
        return self._of("along_throw", Bounds)  # type: ignore[no-any-return]

    @property
    def lower_pin(self) -> Peak2:
        """Force in the lower pin [N]."""
        return self._of("lower_pin", Peak2)  # type: ignore[no-any-return]

    @property
    def piston_pin(self) -> Peak2:
        """Force in the piston pin [N]."""
        return self._of("piston_pin", Peak2)  # type: ignore[no-any-return]

    @property
    def side_thrust(self) -> Peak2:
        """Amount of the side thrust [N]."""
        return self._of("side_thrust", Peak2)  # type: ignore[no-any-return]


class CylinderLoads(Record):
    """Loads of one cylinder."""

    __slots__ = ()
    _FIELDS = ("cylinder", "loads",)

    @property
    def cylinder(self) -> int:
        """Cylinder number, from 1."""
        return self._get("cylinder")  # type: ignore[no-any-return]

    @property
    def loads(self) -> LoadSet:
        """Its loads."""
        return self._of("loads", LoadSet)  # type: ignore[no-any-return]


class CylinderMotion(Record):
    """Motion of one cylinder, over the continuous angle."""

    __slots__ = ()
    _FIELDS = ("articulation", "bottom_dead_centre", "chamber", "cylinder", "firing_angle", "max_acceleration", "max_deceleration", "max_rod_angle", "max_speed", "residual_inertia", "stroke", "top", "top_dead_centre", "trace",)

    @property
    def articulation(self) -> Articulation | None:
        """For an articulated rod: largest swing of the knuckle pin's line off the cylinder axis, and how its stroke and
        dead centres depart from those of a plain rod of the master's kind.
        """
        return self._of("articulation", Articulation)  # type: ignore[no-any-return]

    @property
    def bottom_dead_centre(self) -> float:
        """`theta` of its bottom dead centre [rad]."""
        return self._get("bottom_dead_centre")  # type: ignore[no-any-return]

    @property
    def chamber(self) -> ChamberMotion | None:
        """The chamber that its piston shares with others: its firing angle is that of this chamber."""
        return self._of("chamber", ChamberMotion)  # type: ignore[no-any-return]

    @property
    def cylinder(self) -> int:
        """Cylinder number, from 1."""
        return self._get("cylinder")  # type: ignore[no-any-return]

    @property
    def firing_angle(self) -> float | None:
        """Firing angle: its top dead centre, or that of the chamber that it shares, in the first working cycle of its own crankshaft
        [rad of crankshaft 1], where the file gives a firing.
        """
        return self._get("firing_angle")  # type: ignore[no-any-return]

    @property
    def max_acceleration(self) -> float:
        """Largest piston acceleration away from the crankshaft [m/s^2] (at or near bottom dead centre)."""
        return self._get("max_acceleration")  # type: ignore[no-any-return]

    @property
    def max_deceleration(self) -> float:
        """Largest piston acceleration towards the crankshaft [m/s^2], as a positive number (at or near top dead centre)."""
        return self._get("max_deceleration")  # type: ignore[no-any-return]

    @property
    def max_rod_angle(self) -> float:
        """Largest angle of the rod from the cylinder axis [rad]."""
        return self._get("max_rod_angle")  # type: ignore[no-any-return]

    @property
    def max_speed(self) -> float:
        """Largest piston speed [m/s] at the speed of the loads."""
        return self._get("max_speed")  # type: ignore[no-any-return]

    @property
    def residual_inertia(self) -> float:
        """Residual inertia `m_A a^2 + m_B b^2 - I` of its rod [kg m^2]; 0 for a two-mass rod."""
        return self._get("residual_inertia")  # type: ignore[no-any-return]

    @property
    def stroke(self) -> float:
        """Stroke [m]."""
        return self._get("stroke")  # type: ignore[no-any-return]

    @property
    def top(self) -> float:
        """Distance of the piston pin from the crankshaft's axis along the cylinder at top dead centre [m]."""
        return self._get("top")  # type: ignore[no-any-return]

    @property
    def top_dead_centre(self) -> float:
        """`theta` of its top dead centre [rad], in [0, 2 pi / |ratio|)."""
        return self._get("top_dead_centre")  # type: ignore[no-any-return]

    @property
    def trace(self) -> MotionTrace:
        """Its motion over the period of the loads."""
        return self._of("trace", MotionTrace)  # type: ignore[no-any-return]


class CylinderParts(Record):
    """The weighed parts of one cylinder [kg]."""

    __slots__ = ()
    _FIELDS = ("bearing", "big_end", "locks", "piston", "piston_pin", "rings", "small_end",)

    @property
    def bearing(self) -> float:
        """Both shells of the big-end bearing, if they were not weighed with the big end."""
        return self._get("bearing")  # type: ignore[no-any-return]

    @property
    def big_end(self) -> float:
        """Big end of the rod."""
        return self._get("big_end")  # type: ignore[no-any-return]

    @property
    def locks(self) -> float:
        """All locks or clips of the piston pin."""
        return self._get("locks")  # type: ignore[no-any-return]

    @property
    def piston(self) -> float:
        """Piston alone."""
        return self._get("piston")  # type: ignore[no-any-return]

    @property
    def piston_pin(self) -> float:
        """Piston pin."""
        return self._get("piston_pin")  # type: ignore[no-any-return]

    @property
    def rings(self) -> float:
        """All rings of the piston."""
        return self._get("rings")  # type: ignore[no-any-return]

    @property
    def small_end(self) -> float:
        """Small end of the rod."""
        return self._get("small_end")  # type: ignore[no-any-return]


class CylinderReactions(Record):
    """Loads of piston, pins and wall of one cylinder."""

    __slots__ = ()
    _FIELDS = ("lower_pin", "piston_pin", "rod_frame", "side_thrust", "throw_frame", "travel", "wall",)

    @property
    def lower_pin(self) -> Wrench:
        """Rod on its lower pin (crankpin, or knuckle pin), about that pin."""
        return self._of("lower_pin", Wrench)  # type: ignore[no-any-return]

    @property
    def piston_pin(self) -> Wrench:
        """Rod on the piston pin, about the piston pin."""
        return self._of("piston_pin", Wrench)  # type: ignore[no-any-return]

    @property
    def rod_frame(self) -> FloatArray:
        """Force on the lower pin along the rod towards the piston, and a quarter turn on, as the pin bears on the rod [N]."""
        return self._array("rod_frame")  # type: ignore[no-any-return]

    @property
    def side_thrust(self) -> float:
        """Side thrust: its force along `v` of the cylinder [N]."""
        return self._get("side_thrust")  # type: ignore[no-any-return]

    @property
    def throw_frame(self) -> FloatArray:
        """Force on the crankpin along its throw, and across it where it drives the crankshaft [N]; 0 for a knuckle pin."""
        return self._array("throw_frame")  # type: ignore[no-any-return]

    @property
    def travel(self) -> FloatArray:
        """Travel of the piston pin along the cylinder axis relative to the block: position [m], speed [m/s], acceleration [m/s^2]."""
        return self._array("travel")  # type: ignore[no-any-return]

    @property
    def wall(self) -> Wrench:
        """Piston on the cylinder wall, about the piston pin."""
        return self._of("wall", Wrench)  # type: ignore[no-any-return]


class CylinderStrokes(Record):
    """Strokes of one cylinder."""

    __slots__ = ()
    _FIELDS = ("cylinder", "strokes",)

    @property
    def cylinder(self) -> int:
        """Cylinder number, from 1."""
        return self._get("cylinder")  # type: ignore[no-any-return]

    @property
    def strokes(self) -> Records[StrokeSpan]:
        """From dead centre to dead centre, rising, over one period; the first starts at or after `theta = 0`, the last may
        end beyond the period.
        """
        return self._all("strokes", StrokeSpan)


class CylinderTorque(Record):
    """One cylinder."""

    __slots__ = ()
    _FIELDS = ("clearance", "crankcase", "cylinder", "firing_angle", "gas", "inertia", "peak_pressure", "pressure", "volume", "work",)

    @property
    def clearance(self) -> float | None:
        """Clearance volume [m^3], of the compression ratio of the engine's gas; `None` where the file gives none."""
        return self._get("clearance")  # type: ignore[no-any-return]

    @property
    def crankcase(self) -> FloatArray:
        """Absolute pressure under the piston over the period [Pa]."""
        return self._array("crankcase")  # type: ignore[no-any-return]

    @property
    def cylinder(self) -> int:
        """Its number, from 1."""
        return self._get("cylinder")  # type: ignore[no-any-return]

    @property
    def firing_angle(self) -> float:
        """Crank angle at which it fires [rad]: its top dead centre."""
        return self._get("firing_angle")  # type: ignore[no-any-return]

    @property
    def gas(self) -> FloatArray:
        """Gas torque over the period [N m]."""
        return self._array("gas")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> FloatArray:
        """Inertia torque over the period [N m]."""
        return self._array("inertia")  # type: ignore[no-any-return]

    @property
    def peak_pressure(self) -> Extreme:
        """Highest cylinder pressure [Pa] and the angle after firing [rad] at which it stands, from -half to half a working cycle."""
        return self._of("peak_pressure", Extreme)  # type: ignore[no-any-return]

    @property
    def pressure(self) -> FloatArray:
        """Absolute pressure in the cylinder over the period [Pa]."""
        return self._array("pressure")  # type: ignore[no-any-return]

    @property
    def volume(self) -> FloatArray:
        """Volume that the piston has left free below its top dead centre [m^3]: with `pressure` the p-V diagram, without the
        clearance volume.
        """
        return self._array("volume")  # type: ignore[no-any-return]

    @property
    def work(self) -> IndicatedWork:
        """Work in one working cycle."""
        return self._of("work", IndicatedWork)  # type: ignore[no-any-return]


class DampedMode(Record):
    """One damped mode: the motion `Re( shape e^{root t} )`."""

    __slots__ = ()
    _FIELDS = ("damping_ratio", "root", "shape",)

    @property
    def damping_ratio(self) -> float:
        """Damping ratio `-Re(root) / |root|`; 1 where it does not oscillate."""
        return self._get("damping_ratio")  # type: ignore[no-any-return]

    @property
    def root(self) -> FloatArray:
        """Root [1/s]: real part the rate of growth (negative), imaginary part the angular frequency [rad/s]."""
        return self._array("root")  # type: ignore[no-any-return]

    @property
    def shape(self) -> FloatArray:
        """Shape at the centre; its largest component in the mass norm is real."""
        return self._array("shape")  # type: ignore[no-any-return]


class DampedMode2(Record):
    """A mode of the damped chain: `phi(t) = Re(shape e^(s t))`."""

    __slots__ = ()
    _FIELDS = ("damping_ratio", "decay", "frequency", "shape",)

    @property
    def damping_ratio(self) -> float:
        """Share of critical damping: decay over the modulus of s."""
        return self._get("damping_ratio")  # type: ignore[no-any-return]

    @property
    def decay(self) -> float:
        """Rate of decay [1/s]."""
        return self._get("decay")  # type: ignore[no-any-return]

    @property
    def frequency(self) -> float:
        """Damped angular frequency [rad/s]; 0 for motion that creeps back."""
        return self._get("frequency")  # type: ignore[no-any-return]

    @property
    def shape(self) -> FloatArray:
        """Angles of the stations at their own speeds, the largest 1."""
        return self._array("shape")  # type: ignore[no-any-return]


class DamperSweep(Record):
    """A damper over speed."""

    __slots__ = ()
    _FIELDS = ("by_order", "power", "ring", "shaft",)

    @property
    def by_order(self) -> list[FloatArray]:
        """The same by order [rad]."""
        return self._rows("by_order")  # type: ignore[no-any-return]

    @property
    def power(self) -> FloatArray:
        """Heat [W] at each speed."""
        return self._array("power")  # type: ignore[no-any-return]

    @property
    def ring(self) -> FloatArray:
        """Amplitude of the ring against the hub in true phase [rad]."""
        return self._array("ring")  # type: ignore[no-any-return]

    @property
    def shaft(self) -> int:
        """Index of its shaft."""
        return self._get("shaft")  # type: ignore[no-any-return]


class Design(Record):
    """A complete counterweight, beyond the disc of its web; on an engine's web beyond the web as it is."""

    __slots__ = ()
    _FIELDS = ("balance", "centre", "half_width", "inertia", "mass", "shape", "shoulder", "shoulder_angle", "swept_radius", "thickness", "unbalance",)

    @property
    def balance(self) -> float:
        """Unbalance over full balance."""
        return self._get("balance")  # type: ignore[no-any-return]

    @property
    def centre(self) -> float:
        """Distance of its centre of mass from the crank axis [m]."""
        return self._get("centre")  # type: ignore[no-any-return]

    @property
    def half_width(self) -> float:
        """Half of its largest width [m]."""
        return self._get("half_width")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> float:
        """Polar inertia about the crank axis, without the web [kg m^2]."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Its mass, without the web [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def shape(self) -> CounterweightShape:
        """Its shape."""
        return self._of("shape", CounterweightShape)  # type: ignore[no-any-return]

    @property
    def shoulder(self) -> float:
        """What each shoulder stands out, `l_c` [m]."""
        return self._get("shoulder")  # type: ignore[no-any-return]

    @property
    def shoulder_angle(self) -> float:
        """Angle of the flank against the chord, `delta` [rad]."""
        return self._get("shoulder_angle")  # type: ignore[no-any-return]

    @property
    def swept_radius(self) -> float:
        """Farthest point of web and counterweight from the crank axis [m]."""
        return self._get("swept_radius")  # type: ignore[no-any-return]

    @property
    def thickness(self) -> float:
        """Its thickness [m]."""
        return self._get("thickness")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> float:
        """Its unbalance [kg m]."""
        return self._get("unbalance")  # type: ignore[no-any-return]


class DesignLimits(Record):
    """Limits on what follows from the dimensions. `None`: no limit."""

    __slots__ = ()
    _FIELDS = ("half_width", "inertia", "mass", "shoulder_angle", "shoulder_height", "swept_radius",)

    @property
    def half_width(self) -> float | None:
        """Largest half width of the counterweight, across its axis [m]."""
        return self._get("half_width")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> float | None:
        """Largest polar inertia of the counterweight about the crank axis [kg m^2]."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float | None:
        """Largest mass [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def shoulder_angle(self) -> Range | None:
        """Least and largest shoulder angle `delta` [rad]."""
        return self._of("shoulder_angle", Range)  # type: ignore[no-any-return]

    @property
    def shoulder_height(self) -> Range | None:
        """Least and largest trapezoid height `H` [m]."""
        return self._of("shoulder_height", Range)  # type: ignore[no-any-return]

    @property
    def swept_radius(self) -> float | None:
        """Largest swept radius of web and counterweight [m]."""
        return self._get("swept_radius")  # type: ignore[no-any-return]


class DesignOutcome(Variant):
    """How the search ended."""

    __slots__ = ()
    _FIELDS = ("kind", "found", "infeasible",)

    @property
    def kind(self) -> Literal['found', 'infeasible']:
        """Which of the variants it is."""
        return self._kind()  # type: ignore[no-any-return]

    @property
    def found(self) -> Optimum | None:
        """A design that meets everything."""
        return self._of("found", Optimum)  # type: ignore[no-any-return]

    @property
    def infeasible(self) -> Infeasible | None:
        """No shape of the ranges meets all limits."""
        return self._of("infeasible", Infeasible)  # type: ignore[no-any-return]


class DesignSettings(Record):
    """How far the proof of a best shape goes: branch and bound over boxes of shapes.

    A wider gap ends it earlier, more boxes let a search that stopped go on.
    """

    __slots__ = ()
    _FIELDS = ("gap", "max_boxes",)

    @property
    def gap(self) -> float:
        """No shape is better than the one found by more than this share of what is made small: 1e-6 to 0.5."""
        return self._get("gap")  # type: ignore[no-any-return]

    @property
    def max_boxes(self) -> int:
        """Most boxes examined for one optimum, 1 or more; where they do not do, the result says that it is not proved."""
        return self._get("max_boxes")  # type: ignore[no-any-return]


class DesignedCounterweight(Record):
    """A weight and the shape that was found for it."""

    __slots__ = ()
    _FIELDS = ("duty", "envelope", "evolution", "index", "name", "outcome", "part_mass", "room", "shared", "without_room",)

    @property
    def duty(self) -> float:
        """The unbalance that is full balance [kg m]."""
        return self._get("duty")  # type: ignore[no-any-return]

    @property
    def envelope(self) -> RadialEnvelope | None:
        """With a room: how far the shape may reach in each direction, by everything that moves past its web over the cycle."""
        return self._of("envelope", RadialEnvelope)  # type: ignore[no-any-return]

    @property
    def evolution(self) -> Evolution | None:
        """What the evolutionary search found, if it was asked for."""
        return self._of("evolution", Evolution)  # type: ignore[no-any-return]

    @property
    def index(self) -> int:
        """Its index in `counterweights`."""
        return self._get("index")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def outcome(self) -> DesignOutcome:
        """What was found: mass, unbalance and inertia are what the counterweight adds to the crankshaft beyond the web as it is. The proof is about
        all shapes that share as much with the flank of the web.
        """
        return self._of("outcome", DesignOutcome)  # type: ignore[no-any-return]

    @property
    def part_mass(self) -> float | None:
        """Mass of the part as it is exported, the disc of its web included [kg]; none where no shape was found."""
        return self._get("part_mass")  # type: ignore[no-any-return]

    @property
    def room(self) -> SweptRoom | None:
        """The swept radius that keeps the wanted clearance whatever the shape; none where the best shape of all keeps the clearance, or there is
        nothing to stay clear of.
        """
        return self._of("room", SweptRoom)  # type: ignore[no-any-return]

    @property
    def shared(self) -> SharedWithWeb:
        """What of its outline beyond the web's disc lies within the web as it is and counts as the web's: a design's mass, unbalance and inertia
        are without it.
        """
        return self._of("shared", SharedWithWeb)  # type: ignore[no-any-return]

    @property
    def without_room(self) -> float | None:
        """With a room: what is made small, of the best shape without it [SI]. No shape that keeps the clearance has less."""
        return self._get("without_room")  # type: ignore[no-any-return]


class Deviation(Record):
    """A deviation that is drawn."""

    __slots__ = ()
    _FIELDS = ("part", "tolerance",)

    @property
    def part(self) -> int | None:
        """Index of the part; `None` for all parts together."""
        return self._get("part")  # type: ignore[no-any-return]

    @property
    def tolerance(self) -> int:
        """Place of its tolerance in the list, from 0."""
        return self._get("tolerance")  # type: ignore[no-any-return]


class Diagnosis(Record):
    """What is left to do about the loads, read off the two-sided spectrum."""

    __slots__ = ()
    _FIELDS = ("findings", "roll", "summary",)

    @property
    def findings(self) -> Records[Finding]:
        """One finding a load that matters, in the order of the summary: both senses of a force or couple together, roll moments last."""
        return self._all("findings", Finding)

    @property
    def roll(self) -> str:
        """The roll moment in a line of its own; empty where none matters."""
        return self._get("roll")  # type: ignore[no-any-return]

    @property
    def summary(self) -> str:
        """The forces and couples in one or two sentences."""
        return self._get("summary")  # type: ignore[no-any-return]


class Distribution(Variant):
    """How a quantity is distributed within its tolerance; its mean is the nominal value."""

    __slots__ = ()
    _FIELDS = ("kind", "normal",)

    @property
    def kind(self) -> Literal['normal', 'uniform']:
        """Which of the variants it is.
        `uniform`: Anywhere with the same probability.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def normal(self) -> DistributionNormal | None:
        """Normal, cut off at the tolerance, which is so many standard deviations (of the uncut distribution)."""
        return self._of("normal", DistributionNormal)  # type: ignore[no-any-return]


class DistributionNormal(Record):
    """Normal, cut off at the tolerance, which is so many standard deviations (of the uncut distribution)."""

    __slots__ = ()
    _FIELDS = ("sigmas",)

    @property
    def sigmas(self) -> float:
        """Half width of the tolerance over the standard deviation; 3 where nothing else is known."""
        return self._get("sigmas")  # type: ignore[no-any-return]


class DrillCatalogue(Record):
    """Holes of which a free weight is one: it is what the hole removes, opposite to it, or what a slug in it adds."""

    __slots__ = ()
    _FIELDS = ("density", "depth_step", "diameters", "direction", "max_depth", "point", "radius", "slug_density", "surface",)

    @property
    def density(self) -> float:
        """Density of what is drilled [kg/m^3]."""
        return self._get("density")  # type: ignore[no-any-return]

    @property
    def depth_step(self) -> float:
        """Depths to the end of the full diameter are multiples of this [m]."""
        return self._get("depth_step")  # type: ignore[no-any-return]

    @property
    def diameters(self) -> FloatArray:
        """Diameters of the drills [m], rising."""
        return self._array("diameters")  # type: ignore[no-any-return]

    @property
    def direction(self) -> Literal['radial', 'axial']:
        """Along which line holes are drilled."""
        return self._get("direction")  # type: ignore[no-any-return]

    @property
    def max_depth(self) -> float:
        """Depth from the surface that the tip of the drill may reach [m]."""
        return self._get("max_depth")  # type: ignore[no-any-return]

    @property
    def point(self) -> float:
        """Angle of the drill point [rad]; pi is a flat bottom."""
        return self._get("point")  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Radius of the drilled surface (radial), or of the circle of holes (axial) [m]."""
        return self._get("radius")  # type: ignore[no-any-return]

    @property
    def slug_density(self) -> float | None:
        """Density of the slugs that fill the holes [kg/m^3]; none: the holes stay empty."""
        return self._get("slug_density")  # type: ignore[no-any-return]

    @property
    def surface(self) -> Literal['round', 'flat']:
        """Shape of the surface where a radial hole begins; an axial hole begins on a flat face."""
        return self._get("surface")  # type: ignore[no-any-return]


class DrilledPlane(Record):
    """Holes of one plane."""

    __slots__ = ()
    _FIELDS = ("complete", "holes", "kept", "left", "plane", "tolerance", "wanted",)

    @property
    def complete(self) -> bool:
        """Whether every set of holes was looked at; if not, a better one may exist."""
        return self._get("complete")  # type: ignore[no-any-return]

    @property
    def holes(self) -> Records[Hole]:
        """The holes, by angle."""
        return self._all("holes", Hole)

    @property
    def kept(self) -> bool:
        """Whether no more than that is left."""
        return self._get("kept")  # type: ignore[no-any-return]

    @property
    def left(self) -> FloatArray:
        """What they leave to remove [kg m]."""
        return self._array("left")  # type: ignore[no-any-return]

    @property
    def plane(self) -> str:
        """Name of the plane."""
        return self._get("plane")  # type: ignore[no-any-return]

    @property
    def tolerance(self) -> float:
        """What may be left [kg m]: the plane's share of the grade; without one, what a step of depth makes."""
        return self._get("tolerance")  # type: ignore[no-any-return]

    @property
    def wanted(self) -> FloatArray:
        """Unbalance to remove [kg m]: its argument is the angle on the rotor."""
        return self._array("wanted")  # type: ignore[no-any-return]


class Drilling(Result):
    """Holes for the correction of a sheet."""

    __slots__ = ()
    _FIELDS = ("correction", "grade_after", "holds", "name", "planes", "version",)

    @property
    def correction(self) -> Correction:
        """The correction that the holes are for."""
        return self._of("correction", Correction)  # type: ignore[no-any-return]

    @property
    def grade_after(self) -> Grade | None:
        """The balance quality grade with these holes, and with the weights of the other planes as told."""
        return self._of("grade_after", Grade)  # type: ignore[no-any-return]

    @property
    def holds(self) -> bool:
        """Whether the grade is kept with these holes; without a grade, whether every plane comes as near to what is wanted as
        its steps of depth allow.
        """
        return self._get("holds")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name of the sheet."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def planes(self) -> Records[DrilledPlane]:
        """Holes of every plane that is drilled."""
        return self._all("planes", DrilledPlane)

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class DriveLink(Record):
    """Two gears that mesh, or two sprockets that a chain or belt joins."""

    __slots__ = ()
    _FIELDS = ("chain", "driven", "driver",)

    @property
    def chain(self) -> bool:
        """Whether a chain or belt joins them."""
        return self._get("chain")  # type: ignore[no-any-return]

    @property
    def driven(self) -> int:
        """Index of the driven gear."""
        return self._get("driven")  # type: ignore[no-any-return]

    @property
    def driver(self) -> int:
        """Index of the driving gear."""
        return self._get("driver")  # type: ignore[no-any-return]


class DriveTrain(Record):
    """Gears (and chains or belts) between crank and shafts."""

    __slots__ = ()
    _FIELDS = ("gears", "links", "planes",)

    @property
    def gears(self) -> Records[Gear]:
        """Every gear, idlers too."""
        return self._all("gears", Gear)

    @property
    def links(self) -> Records[DriveLink]:
        """Every mesh, chain or belt."""
        return self._all("links", DriveLink)

    @property
    def planes(self) -> int:
        """Gear planes beyond the end of the crank."""
        return self._get("planes")  # type: ignore[no-any-return]


class DrivelineBody(Record):
    """An inertia of the driveline."""

    __slots__ = ()
    _FIELDS = ("inertia", "ratio",)

    @property
    def inertia(self) -> Sourced:
        """Moment of inertia about its axis [kg m^2]."""
        return self._of("inertia", Sourced)  # type: ignore[no-any-return]

    @property
    def ratio(self) -> float:
        """Speed over that of crankshaft 1 where no spring twists."""
        return self._get("ratio")  # type: ignore[no-any-return]


class DurabilityCriterion(Variant):
    """A number of which more is better: the smallest over the cycle, the parts and the speeds that count."""

    __slots__ = ()
    _FIELDS = ("kind", "main_film", "crankpin_film", "rule_safety",)

    @property
    def kind(self) -> Literal['least-film', 'main-film', 'crankpin-film', 'rule-safety', 'fillet-safety']:
        """Which of the variants it is.
        `least-film`: Smallest oil film of all main and big-end bearings [m].
        `fillet-safety`: Smallest safety against fatigue of the fillets of crankshaft 1 by finite elements [1].
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def main_film(self) -> int | None:
        """Smallest oil film of one main bearing, by index as in `main_bearings`, or of all [m]."""
        return self._get("main-film")  # type: ignore[no-any-return]

    @property
    def crankpin_film(self) -> int | None:
        """Smallest oil film of the big-end bearing of one cylinder, by index, or of all [m]."""
        return self._get("crankpin-film")  # type: ignore[no-any-return]

    @property
    def rule_safety(self) -> int | None:
        """Smallest safety by the formulas after IACS UR M53 of one throw, by index, or of all [1]. Forces of pistons and rods count, what turns with the
        crankshaft does not: counterweights do not change it.
        """
        return self._get("rule-safety")  # type: ignore[no-any-return]


class DurabilityWish(Record):
    """Films and safeties that balancing is to care for."""

    __slots__ = ()
    _FIELDS = ("at_least", "maximise",)

    @property
    def at_least(self) -> Records[AtLeast]:
        """What must hold."""
        return self._all("at_least", AtLeast)

    @property
    def maximise(self) -> Records[DurabilityCriterion]:
        """What is to be large, in order of priority."""
        return self._all("maximise", DurabilityCriterion)


class Durable(Record):
    """Films and safeties of an engine with the weights of an optimum, and with those that a local search made of them."""

    __slots__ = ()
    _FIELDS = ("effects", "end", "evaluations", "limits", "rows", "stages", "version", "weights",)

    @property
    def effects(self) -> Records[Effect]:
        """Criteria before and after with the moved weights, as `effects` has them at the optimum; empty where none was moved."""
        return self._all("effects", Effect)

    @property
    def end(self) -> DurableEnd:
        """How the search ended."""
        return self._of("end", DurableEnd)  # type: ignore[no-any-return]

    @property
    def evaluations(self) -> int:
        """Engines whose films and safeties were computed for the search."""
        return self._get("evaluations")  # type: ignore[no-any-return]

    @property
    def limits(self) -> Records[DurableLimit]:
        """What must hold."""
        return self._all("limits", DurableLimit)

    @property
    def rows(self) -> Records[DurableRow]:
        """Film of every main bearing, least film of the big ends, safety after UR M53, and what else is wanted."""
        return self._all("rows", DurableRow)

    @property
    def stages(self) -> Records[DurableStage]:
        """The stages with the moved weights; empty where none was moved."""
        return self._all("stages", DurableStage)

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def weights(self) -> Records[FoundWeight]:
        """The weights, moved or as the optimum has them."""
        return self._all("weights", FoundWeight)


class DurableEnd(Record):
    """How a local search ended. Whatever it found: a global optimum is not claimed."""

    __slots__ = ()
    _FIELDS = ("kind", "cause", "reason", "remedy",)

    @property
    def kind(self) -> Literal['not-asked', 'not-needed', 'moved', 'nothing-better', 'stopped', 'no-weights', 'not-measured']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def cause(self) -> Literal['max-nodes', 'time-limit', 'cancelled', 'rounding'] | None:
        """Why."""
        return self._get("cause")  # type: ignore[no-any-return]

    @property
    def reason(self) -> str | None:
        """What is missing or cannot be computed."""
        return self._get("reason")  # type: ignore[no-any-return]

    @property
    def remedy(self) -> str | None:
        """What would give it."""
        return self._get("remedy")  # type: ignore[no-any-return]


class DurableLimit(Record):
    """A film or safety that must not fall below a value."""

    __slots__ = ()
    _FIELDS = ("criterion", "is_met", "least", "name", "unit", "value",)

    @property
    def criterion(self) -> DurabilityCriterion:
        """Which."""
        return self._of("criterion", DurabilityCriterion)  # type: ignore[no-any-return]

    @property
    def is_met(self) -> bool | None:
        """Whether it holds; `None` where it is not known."""
        return self._get("is_met")  # type: ignore[no-any-return]

    @property
    def least(self) -> float:
        """The smallest value allowed."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name for tables."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """Its SI unit; empty for a plain number."""
        return self._get("unit")  # type: ignore[no-any-return]

    @property
    def value(self) -> float | None:
        """What was reached; `None` where it is not known."""
        return self._get("value")  # type: ignore[no-any-return]


class DurableRow(Record):
    """A film or safety before, at the optimum and after."""

    __slots__ = ()
    _FIELDS = ("after", "before", "criterion", "name", "optimum", "unit",)

    @property
    def after(self) -> Measured:
        """With those of the search."""
        return self._of("after", Measured)  # type: ignore[no-any-return]

    @property
    def before(self) -> Measured:
        """With the weights that the engine had."""
        return self._of("before", Measured)  # type: ignore[no-any-return]

    @property
    def criterion(self) -> DurabilityCriterion:
        """Which."""
        return self._of("criterion", DurabilityCriterion)  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name for tables."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def optimum(self) -> Measured:
        """With those of the proved optimum."""
        return self._of("optimum", Measured)  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """Its SI unit; empty for a plain number."""
        return self._get("unit")  # type: ignore[no-any-return]


class DurableStage(Record):
    """A stage of the balancing with moved weights."""

    __slots__ = ()
    _FIELDS = ("allowed", "optimum", "unit", "value",)

    @property
    def allowed(self) -> float:
        """How far it may be raised."""
        return self._get("allowed")  # type: ignore[no-any-return]

    @property
    def optimum(self) -> float:
        """At the proved optimum."""
        return self._get("optimum")  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """SI unit, or `1` for a weighted sum."""
        return self._get("unit")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """With the moved weights."""
        return self._get("value")  # type: ignore[no-any-return]


class Effect(Record):
    """A criterion before and after."""

    __slots__ = ()
    _FIELDS = ("after", "before", "criterion", "without",)

    @property
    def after(self) -> float:
        """With the answer [SI unit]."""
        return self._get("after")  # type: ignore[no-any-return]

    @property
    def before(self) -> float:
        """As the engine file stands [SI unit]."""
        return self._get("before")  # type: ignore[no-any-return]

    @property
    def criterion(self) -> Criterion:
        """Which."""
        return self._of("criterion", Criterion)  # type: ignore[no-any-return]

    @property
    def without(self) -> float:
        """Without the free weights (those that they replace left out) [SI unit]."""
        return self._get("without")  # type: ignore[no-any-return]


class Effect2(Record):
    """An output with an input at one end of its range and at the other."""

    __slots__ = ()
    _FIELDS = ("above", "below", "slope",)

    @property
    def above(self) -> float | None:
        """Output with the input at its upper end."""
        return self._get("above")  # type: ignore[no-any-return]

    @property
    def below(self) -> float | None:
        """Output with the input at its lower end; `None` if no engine is there."""
        return self._get("below")  # type: ignore[no-any-return]

    @property
    def slope(self) -> Slope:
        """Derivative at the nominal engine."""
        return self._of("slope", Slope)  # type: ignore[no-any-return]


class ElementEnergy(Record):
    """Energy of one element."""

    __slots__ = ()
    _FIELDS = ("element", "error", "held", "kind", "taken", "taken_by_events",)

    @property
    def element(self) -> str:
        """The element."""
        return self._get("element")  # type: ignore[no-any-return]

    @property
    def error(self) -> float | None:
        """What it took in less what it holds more and what events took, against the throughput."""
        return self._get("error")  # type: ignore[no-any-return]

    @property
    def held(self) -> float | None:
        """Change of what it holds by its law [J], where that gives an energy; also of a store that follows others."""
        return self._get("held")  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['Se', 'Sf', 'R', 'C', 'I', 'IC', 'Gas', 'TF', 'GY', 'Zero', 'One']:
        """Its kind."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def taken(self) -> float:
        """What it took in [J]."""
        return self._get("taken")  # type: ignore[no-any-return]

    @property
    def taken_by_events(self) -> float | None:
        """What events took out of it by setting what it holds [J]; absent where none did."""
        return self._get("taken_by_events")  # type: ignore[no-any-return]


class ElementWeb(Record):
    """A web by finite elements."""

    __slots__ = ()
    _FIELDS = ("factors", "journal_fillet", "pin_fillet",)

    @property
    def factors(self) -> FactorValues:
        """Its factors."""
        return self._of("factors", FactorValues)  # type: ignore[no-any-return]

    @property
    def journal_fillet(self) -> FilletSheet:
        """The journal's fillet."""
        return self._of("journal_fillet", FilletSheet)  # type: ignore[no-any-return]

    @property
    def pin_fillet(self) -> FilletSheet:
        """The pin's fillet."""
        return self._of("pin_fillet", FilletSheet)  # type: ignore[no-any-return]


class EnergyBalance(Record):
    """Work and energy over the recorded cycle [J]."""

    __slots__ = ()
    _FIELDS = ("bearings", "change", "damping", "drive", "gas", "missing", "turnover",)

    @property
    def bearings(self) -> float:
        """Taken by the bearings, their springs' energy included."""
        return self._get("bearings")  # type: ignore[no-any-return]

    @property
    def change(self) -> float:
        """Change of kinetic and elastic energy."""
        return self._get("change")  # type: ignore[no-any-return]

    @property
    def damping(self) -> float:
        """Lost in the material's damping."""
        return self._get("damping")  # type: ignore[no-any-return]

    @property
    def drive(self) -> float:
        """Work of the flywheel on the crankshaft."""
        return self._get("drive")  # type: ignore[no-any-return]

    @property
    def gas(self) -> float:
        """Work of the gas."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def missing(self) -> float:
        """What is missing: gas + drive - damping - bearings - change."""
        return self._get("missing")  # type: ignore[no-any-return]

    @property
    def turnover(self) -> float:
        """Sum of the sizes of all powers over time, by which `missing` is judged."""
        return self._get("turnover")  # type: ignore[no-any-return]


class EnergyLedger(Record):
    """Energies at both ends and works between [J]."""

    __slots__ = ()
    _FIELDS = ("clutch", "driveline", "driveline_damping", "friction", "gas", "gravity", "kinetic", "load", "mount_damping", "mounts", "outside", "piston_friction", "starter", "throughput",)

    @property
    def clutch(self) -> float:
        """What the first spring of the driveline loses as the clutch opens (negative): nothing holds its twist any more, and it comes to rest by itself."""
        return self._get("clutch")  # type: ignore[no-any-return]

    @property
    def driveline(self) -> FloatArray:
        """Of the driveline's springs."""
        return self._array("driveline")  # type: ignore[no-any-return]

    @property
    def driveline_damping(self) -> float:
        """Work of the driveline's dampers."""
        return self._get("driveline_damping")  # type: ignore[no-any-return]

    @property
    def friction(self) -> float:
        """Work of dry friction."""
        return self._get("friction")  # type: ignore[no-any-return]

    @property
    def gas(self) -> float:
        """Work of the gas on the pistons."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def gravity(self) -> FloatArray:
        """Of gravity."""
        return self._array("gravity")  # type: ignore[no-any-return]

    @property
    def kinetic(self) -> FloatArray:
        """Kinetic energy at the start and at the end."""
        return self._array("kinetic")  # type: ignore[no-any-return]

    @property
    def load(self) -> float:
        """Work of the load (negative where it takes)."""
        return self._get("load")  # type: ignore[no-any-return]

    @property
    def mount_damping(self) -> float:
        """Work of the mounts' dampers."""
        return self._get("mount_damping")  # type: ignore[no-any-return]

    @property
    def mounts(self) -> FloatArray:
        """Of the mounts' springs."""
        return self._array("mounts")  # type: ignore[no-any-return]

    @property
    def outside(self) -> float:
        """Work of other torques from the ground and of the drive of an imposed speed."""
        return self._get("outside")  # type: ignore[no-any-return]

    @property
    def piston_friction(self) -> float:
        """Work of the friction of the pistons."""
        return self._get("piston_friction")  # type: ignore[no-any-return]

    @property
    def starter(self) -> float:
        """Work of the starter."""
        return self._get("starter")  # type: ignore[no-any-return]

    @property
    def throughput(self) -> float:
        """Sum of the amounts of all works and of the largest energies stored."""
        return self._get("throughput")  # type: ignore[no-any-return]


class EnergyVariation(Record):
    """Accumulated energy of a torque over its period."""

    __slots__ = ()
    _FIELDS = ("absolute", "excess", "highest", "lowest", "mean", "own_period",)

    @property
    def absolute(self) -> float:
        """Integral of `|T - T_mean|` over the own period [J], eq. (25.3), as the twin thesis counts it."""
        return self._get("absolute")  # type: ignore[no-any-return]

    @property
    def excess(self) -> float:
        """Largest excess energy [J], eq. (25.2)."""
        return self._get("excess")  # type: ignore[no-any-return]

    @property
    def highest(self) -> float:
        """Crank angle [rad] at which the accumulated energy is highest: there the crank turns fastest."""
        return self._get("highest")  # type: ignore[no-any-return]

    @property
    def lowest(self) -> float:
        """Crank angle [rad] at which it is lowest."""
        return self._get("lowest")  # type: ignore[no-any-return]

    @property
    def mean(self) -> float:
        """Mean torque [N m]."""
        return self._get("mean")  # type: ignore[no-any-return]

    @property
    def own_period(self) -> float:
        """Own period of the torque [rad]: the shortest after which it repeats."""
        return self._get("own_period")  # type: ignore[no-any-return]


class Evolution(Record):
    """What an evolutionary search came to."""

    __slots__ = ()
    _FIELDS = ("best", "evaluations", "feasible", "objective", "proved", "seed", "version",)

    @property
    def best(self) -> Evolved | None:
        """The best design that it met within all limits; none if it met none, which does not show that there is none."""
        return self._of("best", Evolved)  # type: ignore[no-any-return]

    @property
    def evaluations(self) -> int:
        """Designs that it looked at."""
        return self._get("evaluations")  # type: ignore[no-any-return]

    @property
    def feasible(self) -> int:
        """How many of them met all limits."""
        return self._get("feasible")  # type: ignore[no-any-return]

    @property
    def objective(self) -> Literal['mass', 'swept-radius', 'inertia', 'thickness']:
        """What was made small."""
        return self._get("objective")  # type: ignore[no-any-return]

    @property
    def proved(self) -> bool:
        """Whether it is proved that no design is better: never, since such a search knows no bound."""
        return self._get("proved")  # type: ignore[no-any-return]

    @property
    def seed(self) -> int:
        """Seed of its random numbers: the same seed gives the same design."""
        return self._get("seed")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class Evolved(Record):
    """The best design of an evolutionary search."""

    __slots__ = ()
    _FIELDS = ("design", "found_after", "value",)

    @property
    def design(self) -> Design:
        """The design."""
        return self._of("design", Design)  # type: ignore[no-any-return]

    @property
    def found_after(self) -> int:
        """After how many designs it was found."""
        return self._get("found_after")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """Its value of the objective [SI]."""
        return self._get("value")  # type: ignore[no-any-return]


class ExchangeResult(Record):
    """Gas exchange, heat to the walls and the check of the integration."""

    __slots__ = ()
    _FIELDS = ("body_temperature", "closing_angle", "converged", "cycles", "energy_residual", "energy_residual_share", "fresh_mass", "mass_residual", "mass_residual_share", "residual_share", "trapped_temperature", "trapping_efficiency", "volumetric_efficiency", "wall_heat", "wall_heat_share",)

    @property
    def body_temperature(self) -> float | None:
        """Temperature of the body that takes it [K]; `None` where the walls have temperatures that are given."""
        return self._get("body_temperature")  # type: ignore[no-any-return]

    @property
    def closing_angle(self) -> float:
        """Angle at which it closes [rad], negative: before firing."""
        return self._get("closing_angle")  # type: ignore[no-any-return]

    @property
    def converged(self) -> bool:
        """Whether the last cycle repeats the one before it."""
        return self._get("converged")  # type: ignore[no-any-return]

    @property
    def cycles(self) -> int:
        """Cycles run."""
        return self._get("cycles")  # type: ignore[no-any-return]

    @property
    def energy_residual(self) -> float:
        """Energy that is missing from the balance of the last cycle [J]."""
        return self._get("energy_residual")  # type: ignore[no-any-return]

    @property
    def energy_residual_share(self) -> float:
        """The same over the largest of what passes."""
        return self._get("energy_residual_share")  # type: ignore[no-any-return]

    @property
    def fresh_mass(self) -> float:
        """Fresh mass trapped [kg]."""
        return self._get("fresh_mass")  # type: ignore[no-any-return]

    @property
    def mass_residual(self) -> float:
        """Mass that is missing from the balance of the last cycle [kg]."""
        return self._get("mass_residual")  # type: ignore[no-any-return]

    @property
    def mass_residual_share(self) -> float:
        """The same over the trapped mass."""
        return self._get("mass_residual_share")  # type: ignore[no-any-return]

    @property
    def residual_share(self) -> float:
        """Share of the trapped mass that is residual gas."""
        return self._get("residual_share")  # type: ignore[no-any-return]

    @property
    def trapped_temperature(self) -> float:
        """Temperature when the cylinder closes [K]."""
        return self._get("trapped_temperature")  # type: ignore[no-any-return]

    @property
    def trapping_efficiency(self) -> float:
        """Fresh mass trapped over fresh mass taken in."""
        return self._get("trapping_efficiency")  # type: ignore[no-any-return]

    @property
    def volumetric_efficiency(self) -> float:
        """Fresh mass taken in over that of the displaced volume at the state before the intake; for two strokes the delivery ratio."""
        return self._get("volumetric_efficiency")  # type: ignore[no-any-return]

    @property
    def wall_heat(self) -> float:
        """Heat to the walls in a cycle [J]."""
        return self._get("wall_heat")  # type: ignore[no-any-return]

    @property
    def wall_heat_share(self) -> float | None:
        """The same over the heat released; `None` where it is motored."""
        return self._get("wall_heat_share")  # type: ignore[no-any-return]


class Exploration(Result):
    """Pareto-optimal layouts, and what became of all others."""

    __slots__ = ()
    _FIELDS = ("at_least", "choices", "constraints", "counts", "cylinders", "done", "durability", "engine", "front", "given", "notes", "objectives", "ranking", "sample", "size", "speed", "version",)

    @property
    def at_least(self) -> list[str]:
        """What the layouts found hold of them, in words: a limit that was judged for layouts alone that no other covers."""
        return self._list("at_least")  # type: ignore[no-any-return]

    @property
    def choices(self) -> Records[ChoiceCount]:
        """Choices with more than one value: the product of their counts is the size."""
        return self._all("choices", ChoiceCount)

    @property
    def constraints(self) -> list[str]:
        """What they must hold, in words."""
        return self._list("constraints")  # type: ignore[no-any-return]

    @property
    def counts(self) -> Counts:
        """What became of the cases."""
        return self._of("counts", Counts)  # type: ignore[no-any-return]

    @property
    def cylinders(self) -> int:
        """Cylinders of each layout."""
        return self._get("cylinders")  # type: ignore[no-any-return]

    @property
    def done(self) -> Records[Run]:
        """What has been looked at: the whole space, or the part that was asked for."""
        return self._all("done", Run)

    @property
    def durability(self) -> Records[DurabilityCriterion]:
        """Films and safeties that are told of the layouts found."""
        return self._all("durability", DurabilityCriterion)

    @property
    def engine(self) -> str:
        """Name of the engine from whose parts the layouts are made."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def front(self) -> Records[FoundLayout]:
        """Pareto-optimal layouts, by the first objective."""
        return self._all("front", FoundLayout)

    @property
    def given(self) -> GivenEngine | None:
        """Where the engine of the file stands, with its own weights and shafts."""
        return self._of("given", GivenEngine)  # type: ignore[no-any-return]

    @property
    def notes(self) -> list[str]:
        """What the user should know of the space."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def objectives(self) -> Records[JudgedBy]:
        """What the layouts are judged by."""
        return self._all("objectives", JudgedBy)

    @property
    def ranking(self) -> Records[FoundLayout]:
        """The first kinds of layout by the objectives in their order."""
        return self._all("ranking", FoundLayout)

    @property
    def sample(self) -> Records[JudgedCase]:
        """Some of the judged cases, evenly from all of them: what the front is the edge of."""
        return self._all("sample", JudgedCase)

    @property
    def size(self) -> int:
        """Cases of the space."""
        return self._get("size")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed at which they are judged [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class ExternalBalance(Result):
    """Weights that flywheel and damper must carry."""

    __slots__ = ()
    _FIELDS = ("couple_unbalance", "crankshaft", "engine", "kept_share", "masses", "static_unbalance", "version", "weights",)

    @property
    def couple_unbalance(self) -> FloatArray:
        """Couple unbalance about the origin [kg m^2]."""
        return self._array("couple_unbalance")  # type: ignore[no-any-return]

    @property
    def crankshaft(self) -> str:
        """Name of the crankshaft."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def kept_share(self) -> float:
        """Share of every counterweight inside that stays."""
        return self._get("kept_share")  # type: ignore[no-any-return]

    @property
    def masses(self) -> list[RadiusAndMass | None]:
        """Distance of each weight's centre of gravity from the axis [m], and its mass [kg] there, where the distance is given."""
        return self._as("masses", every(optionally(RadiusAndMass)), [])  # type: ignore[no-any-return]

    @property
    def static_unbalance(self) -> FloatArray:
        """Static unbalance of the crank with its bobweights, without weights outside [kg m]."""
        return self._array("static_unbalance")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def weights(self) -> Records[PlaneUnbalance]:
        """The weights outside that bring both to 0."""
        return self._all("weights", PlaneUnbalance)


class Extrapolated(Record):
    """A number computed on three meshes, extrapolated to elements of size zero.

    ```text
    f(h) = f* + C h^p      (f1 - f2)/(f2 - f3) = (h1^p - h2^p)/(h2^p - h3^p)      f* = f3 + (f3 - f2)/((h2/h3)^p - 1)
    band = 1.25 |f* - f3|                                                                                     (book, eq. 43.15)
    ```
    Where no such order from 0.5 to 6 exists, because the numbers go to and fro or do not come closer, the value is that of the finest mesh
    and the band three times the largest difference.
    """

    __slots__ = ()
    _FIELDS = ("band", "order", "value", "values",)

    @property
    def band(self) -> float:
        """Half width of the band about it."""
        return self._get("band")  # type: ignore[no-any-return]

    @property
    def order(self) -> float | None:
        """Order that the three show; none where they show none."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """What they tend to."""
        return self._get("value")  # type: ignore[no-any-return]

    @property
    def values(self) -> FloatArray:
        """Value on the coarse, the middle and the fine mesh."""
        return self._array("values")  # type: ignore[no-any-return]


class Extreme(Record):
    """An extreme and where it is."""

    __slots__ = ()
    _FIELDS = ("theta", "value",)

    @property
    def theta(self) -> float:
        """Crank angle [rad] of the first place that attains it, in one period."""
        return self._get("theta")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """Value [N] or [N m]."""
        return self._get("value")  # type: ignore[no-any-return]


class Extremes(Record):
    """Largest and smallest value of one quantity over the period."""

    __slots__ = ()
    _FIELDS = ("max", "min",)

    @property
    def max(self) -> Extreme:
        """Largest value."""
        return self._of("max", Extreme)  # type: ignore[no-any-return]

    @property
    def min(self) -> Extreme:
        """Smallest value."""
        return self._of("min", Extreme)  # type: ignore[no-any-return]


class Factor(Record):
    """A stress concentration factor with what it is the product of."""

    __slots__ = ()
    _FIELDS = ("parts", "value",)

    @property
    def parts(self) -> Records[FactorPart]:
        """Its parts; their product is the factor."""
        return self._all("parts", FactorPart)

    @property
    def value(self) -> float:
        """The factor [1]."""
        return self._get("value")  # type: ignore[no-any-return]


class FactorAnswer(Result):
    """Balance factors of an engine."""

    __slots__ = ()
    _FIELDS = ("crankshafts", "elsewhere", "engine", "given", "ratios", "rotation", "speed", "throws", "version",)

    @property
    def crankshafts(self) -> Records[CommonFactor]:
        """What one factor for all throws does, for every crankshaft: over the square of its own speed."""
        return self._all("crankshafts", CommonFactor)

    @property
    def elsewhere(self) -> list[str]:
        """Names of counterweights that belong to no throw."""
        return self._list("elsewhere")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def given(self) -> FactorGiven:
        """What was given."""
        return self._of("given", FactorGiven)  # type: ignore[no-any-return]

    @property
    def ratios(self) -> FloatArray:
        """Speed ratio of every throw's crankshaft."""
        return self._array("ratios")  # type: ignore[no-any-return]

    @property
    def rotation(self) -> Literal['clockwise', 'reverse']:
        """Sense of rotation, for pictures."""
        return self._get("rotation")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s] at which forces are shown."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def throws(self) -> Records[ThrowFactor]:
        """Factors of every throw, with the speed of its crankshaft over that of crankshaft 1."""
        return self._all("throws", ThrowFactor)

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class FactorChoice(Record):
    """A share of the reciprocating masses and what it leaves of the first order."""

    __slots__ = ()
    _FIELDS = ("backward", "forward", "share", "why",)

    @property
    def backward(self) -> float:
        """Part that turns against it, alike."""
        return self._get("backward")  # type: ignore[no-any-return]

    @property
    def forward(self) -> float:
        """Part that turns with the crank, over that which the reciprocating masses have on all pins."""
        return self._get("forward")  # type: ignore[no-any-return]

    @property
    def share(self) -> float:
        """The share."""
        return self._get("share")  # type: ignore[no-any-return]

    @property
    def why(self) -> str:
        """Why it is looked at."""
        return self._get("why")  # type: ignore[no-any-return]


class FactorEffect(Record):
    """What a common factor does to the first order of a force [kg m] or couple [kg m^2], over `w^2`."""

    __slots__ = ()
    _FIELDS = ("backward", "forward", "per_share", "size",)

    @property
    def backward(self) -> FloatArray:
        """`B`: backward part, which no factor changes."""
        return self._array("backward")  # type: ignore[no-any-return]

    @property
    def forward(self) -> FloatArray:
        """`A`: forward part at the factor 0."""
        return self._array("forward")  # type: ignore[no-any-return]

    @property
    def per_share(self) -> FloatArray:
        """`G`: what the factor 1 takes from it."""
        return self._array("per_share")  # type: ignore[no-any-return]

    @property
    def size(self) -> float:
        """Sum of the amounts behind these sums: what is far below it is rounding."""
        return self._get("size")  # type: ignore[no-any-return]


class FactorGiven(Record):
    """What is known of the counterweight."""

    __slots__ = ()
    _FIELDS = ("kind", "value",)

    @property
    def kind(self) -> Literal['as-built', 'reciprocating-share', 'wet-reciprocating-share', 'total-share', 'bobweight', 'bobweight-share', 'counterweight', 'axis-ratio', 'least-peak']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def value(self) -> float | None:
        """Not described."""
        return self._get("value")  # type: ignore[no-any-return]


class FactorPart(Record):
    """A part of a factor."""

    __slots__ = ()
    _FIELDS = ("name", "value",)

    @property
    def name(self) -> str:
        """"f(s,w)"; "constant"."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """Its value [1]."""
        return self._get("value")  # type: ignore[no-any-return]


class FactorValues(Record):
    """Values of the factors of the two fillets of a web [1]."""

    __slots__ = ()
    _FIELDS = ("alpha_b", "alpha_t", "beta_b", "beta_q", "beta_t",)

    @property
    def alpha_b(self) -> float:
        """Pin fillet, bending."""
        return self._get("alpha_b")  # type: ignore[no-any-return]

    @property
    def alpha_t(self) -> float:
        """Pin fillet, torsion."""
        return self._get("alpha_t")  # type: ignore[no-any-return]

    @property
    def beta_b(self) -> float:
        """Journal fillet, bending."""
        return self._get("beta_b")  # type: ignore[no-any-return]

    @property
    def beta_q(self) -> float:
        """Journal fillet, radial force."""
        return self._get("beta_q")  # type: ignore[no-any-return]

    @property
    def beta_t(self) -> float:
        """Journal fillet, torsion."""
        return self._get("beta_t")  # type: ignore[no-any-return]


class FatigueAtSpeed(Record):
    """All fillets at one speed."""

    __slots__ = ()
    _FIELDS = ("fillets", "speed",)

    @property
    def fillets(self) -> Records[FilletFatigue]:
        """Along z."""
        return self._all("fillets", FilletFatigue)

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]


class FatigueFactors(Record):
    """What lowers the fatigue limits of polished specimens [1]; 1 leaves them."""

    __slots__ = ()
    _FIELDS = ("gradient", "size", "surface",)

    @property
    def gradient(self) -> float:
        """Gradient of the stress; above 1 where it supports."""
        return self._get("gradient")  # type: ignore[no-any-return]

    @property
    def size(self) -> float:
        """Size of the body."""
        return self._get("size")  # type: ignore[no-any-return]

    @property
    def surface(self) -> float:
        """Finish of the surface."""
        return self._get("surface")  # type: ignore[no-any-return]


class FatigueMeasure(Record):
    """Findley's criterion for a material, with what it was made of."""

    __slots__ = ()
    _FIELDS = ("bending_limit", "factors", "findley", "torsion_limit",)

    @property
    def bending_limit(self) -> Sourced:
        """Fatigue limit in alternating bending [Pa]."""
        return self._of("bending_limit", Sourced)  # type: ignore[no-any-return]

    @property
    def factors(self) -> FatigueFactors:
        """Factors on the limits."""
        return self._of("factors", FatigueFactors)  # type: ignore[no-any-return]

    @property
    def findley(self) -> Findley:
        """The criterion with these limits and factors."""
        return self._of("findley", Findley)  # type: ignore[no-any-return]

    @property
    def torsion_limit(self) -> Sourced:
        """Fatigue limit in alternating torsion [Pa]."""
        return self._of("torsion_limit", Sourced)  # type: ignore[no-any-return]


class FilletCycle(Record):
    """The largest stress of a fillet over the cycle."""

    __slots__ = ()
    _FIELDS = ("angle", "at", "instant", "name", "over_cycle", "peak", "principal", "radius",)

    @property
    def angle(self) -> float:
        """Angle about the bar's middle [rad]."""
        return self._get("angle")  # type: ignore[no-any-return]

    @property
    def at(self) -> FloatArray:
        """Place [m], in the frame of the crankshaft."""
        return self._array("at")  # type: ignore[no-any-return]

    @property
    def instant(self) -> int:
        """Index of the instant."""
        return self._get("instant")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """"pin 1 at web 2"."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def over_cycle(self) -> FloatArray:
        """Largest von Mises stress of the fillet at every instant [Pa]."""
        return self._array("over_cycle")  # type: ignore[no-any-return]

    @property
    def peak(self) -> float:
        """Largest von Mises stress over cycle and fillet [Pa]."""
        return self._get("peak")  # type: ignore[no-any-return]

    @property
    def principal(self) -> float:
        """Principal stress of the largest size there and then [Pa], tension positive."""
        return self._get("principal")  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Radius [m]."""
        return self._get("radius")  # type: ignore[no-any-return]


class FilletFatigue(Record):
    """The node of a fillet where Findley's value is largest."""

    __slots__ = ()
    _FIELDS = ("angle", "at", "critical_angle", "name", "point", "radius", "static_safety", "von_mises",)

    @property
    def angle(self) -> float:
        """Its angle about the bar's middle, from the x axis of the crankshaft's frame [rad]."""
        return self._get("angle")  # type: ignore[no-any-return]

    @property
    def at(self) -> FloatArray:
        """Place of the node [m]."""
        return self._array("at")  # type: ignore[no-any-return]

    @property
    def critical_angle(self) -> float:
        """Crank angle at which the normal stress on the worst plane is largest [rad]."""
        return self._get("critical_angle")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """"pin 1 at web 2"."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def point(self) -> PointFatigue:
        """Worst plane and safeties."""
        return self._of("point", PointFatigue)  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Its radius [m]."""
        return self._get("radius")  # type: ignore[no-any-return]

    @property
    def static_safety(self) -> float | None:
        """Yield strength over it, where the strength is known [1]."""
        return self._get("static_safety")  # type: ignore[no-any-return]

    @property
    def von_mises(self) -> float:
        """Largest von Mises stress of the fillet over the cycle [Pa]."""
        return self._get("von_mises")  # type: ignore[no-any-return]


class FilletPlace(Record):
    """A corner between a bar and a web."""

    __slots__ = ()
    _FIELDS = ("bar", "centre", "name", "nodes", "radius",)

    @property
    def bar(self) -> float:
        """Radius of the bar [m]."""
        return self._get("bar")  # type: ignore[no-any-return]

    @property
    def centre(self) -> Point:
        """Middle of the bar, in the frame of the crankshaft [m]."""
        return self._of("centre", Point)  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """"pin 1 at web 2"."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def nodes(self) -> list[int]:
        """Nodes on the surface of the fillet; none of a sharp corner."""
        return self._list("nodes")  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Radius [m]; 0 of a sharp corner, whose stress is no number."""
        return self._get("radius")  # type: ignore[no-any-return]


class FilletSheet(Record):
    """A fillet: from factors to safety."""

    __slots__ = ()
    _FIELDS = ("bending", "equivalent", "safety", "strength", "torsion",)

    @property
    def bending(self) -> float:
        """Alternating bending stress, with the additional one [Pa]."""
        return self._get("bending")  # type: ignore[no-any-return]

    @property
    def equivalent(self) -> float:
        """Alternating equivalent stress [Pa]."""
        return self._get("equivalent")  # type: ignore[no-any-return]

    @property
    def safety(self) -> float:
        """Safety Q [1]."""
        return self._get("safety")  # type: ignore[no-any-return]

    @property
    def strength(self) -> float:
        """Fatigue strength [Pa]."""
        return self._get("strength")  # type: ignore[no-any-return]

    @property
    def torsion(self) -> float:
        """Alternating torsional stress [Pa]."""
        return self._get("torsion")  # type: ignore[no-any-return]


class FilmEnergy(Record):
    """Work and energy of a shaft over the last period [J]."""

    __slots__ = ()
    _FIELDS = ("change", "contact", "films", "loads", "missing", "turning", "turnover",)

    @property
    def change(self) -> float:
        """Change of kinetic energy."""
        return self._get("change")  # type: ignore[no-any-return]

    @property
    def contact(self) -> float:
        """Taken by contact of the roughness, which is elastic."""
        return self._get("contact")  # type: ignore[no-any-return]

    @property
    def films(self) -> float:
        """Lost in the films by the flow that their pressure drives."""
        return self._get("films")  # type: ignore[no-any-return]

    @property
    def loads(self) -> float:
        """Work of the loads on the shaft."""
        return self._get("loads")  # type: ignore[no-any-return]

    @property
    def missing(self) -> float:
        """What is missing: loads + turning - films - contact - change."""
        return self._get("missing")  # type: ignore[no-any-return]

    @property
    def turning(self) -> float:
        """Work that turning journals and shells do on the films' pressure."""
        return self._get("turning")  # type: ignore[no-any-return]

    @property
    def turnover(self) -> float:
        """Sum of the sizes of all powers over time, by which `missing` is judged."""
        return self._get("turnover")  # type: ignore[no-any-return]


class FilmOrbit(Record):
    """The orbit over one period, and what the film does on it."""

    __slots__ = ()
    _FIELDS = ("change", "contact_share", "contact_time", "eccentricity", "feed_flow", "friction_power", "friction_power_of_pressure_part", "largest_pressure", "largest_pressure_at", "least_edge_film", "least_film", "least_film_angle", "least_film_at", "outcome", "periods", "side_flow", "steps", "table_error",)

    @property
    def change(self) -> float:
        """Largest change from the last period but one, over the clearance."""
        return self._get("change")  # type: ignore[no-any-return]

    @property
    def contact_share(self) -> float:
        """Largest share of the load that contact takes."""
        return self._get("contact_share")  # type: ignore[no-any-return]

    @property
    def contact_time(self) -> float:
        """Share of the period with contact of the roughness."""
        return self._get("contact_time")  # type: ignore[no-any-return]

    @property
    def eccentricity(self) -> FloatArray:
        """Journal centre at every instant of the load [m]."""
        return self._array("eccentricity")  # type: ignore[no-any-return]

    @property
    def feed_flow(self) -> float:
        """Oil that grooves and holes give, mean [m3/s]; 0 where the film has none."""
        return self._get("feed_flow")  # type: ignore[no-any-return]

    @property
    def friction_power(self) -> float:
        """Friction power, mean over the period [W]: torques and motion of the journal, contact left out."""
        return self._get("friction_power")  # type: ignore[no-any-return]

    @property
    def friction_power_of_pressure_part(self) -> float:
        """The same with shear only where there is pressure [W]: the bound from below, of a shell that is empty elsewhere."""
        return self._get("friction_power_of_pressure_part")  # type: ignore[no-any-return]

    @property
    def largest_pressure(self) -> float:
        """Largest film pressure [Pa] and its instant over the period."""
        return self._get("largest_pressure")  # type: ignore[no-any-return]

    @property
    def largest_pressure_at(self) -> float:
        """Instant of the largest pressure, over the period."""
        return self._get("largest_pressure_at")  # type: ignore[no-any-return]

    @property
    def least_edge_film(self) -> float | None:
        """Least film at an end of the bearing [m], where the journal's axis is tilted; below 0 where that end would touch. `None`: parallel axes."""
        return self._get("least_edge_film")  # type: ignore[no-any-return]

    @property
    def least_film(self) -> float:
        """Least film [m]."""
        return self._get("least_film")  # type: ignore[no-any-return]

    @property
    def least_film_angle(self) -> float:
        """Direction of the least film [rad]."""
        return self._get("least_film_angle")  # type: ignore[no-any-return]

    @property
    def least_film_at(self) -> float:
        """Instant of the least film, over the period."""
        return self._get("least_film_at")  # type: ignore[no-any-return]

    @property
    def outcome(self) -> Literal['periodic', 'not_periodic', 'overloaded']:
        """How it ended."""
        return self._get("outcome")  # type: ignore[no-any-return]

    @property
    def periods(self) -> int:
        """Periods integrated."""
        return self._get("periods")  # type: ignore[no-any-return]

    @property
    def side_flow(self) -> float:
        """Oil that leaves at the ends, mean [m3/s]."""
        return self._get("side_flow")  # type: ignore[no-any-return]

    @property
    def steps(self) -> int:
        """Steps of the integrator."""
        return self._get("steps")  # type: ignore[no-any-return]

    @property
    def table_error(self) -> float:
        """Largest difference of the table's force from that of the film solved directly, over the load; 0 where every film of the orbit is solved directly."""
        return self._get("table_error")  # type: ignore[no-any-return]


class Finding(Record):
    """One load of the spectrum, with its remedy."""

    __slots__ = ()
    _FIELDS = ("amplitude", "order", "quantity", "remedy", "sense", "text",)

    @property
    def amplitude(self) -> float:
        """Amplitude [N] or [N m]."""
        return self._get("amplitude")  # type: ignore[no-any-return]

    @property
    def order(self) -> float:
        """Order."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def quantity(self) -> Literal['force', 'couple', 'roll-moment']:
        """Force, couple or roll moment."""
        return self._get("quantity")  # type: ignore[no-any-return]

    @property
    def remedy(self) -> Literal['crank-weights', 'balance-shaft', 'none-of-low-order', 'roll-device']:
        """What can remove it."""
        return self._get("remedy")  # type: ignore[no-any-return]

    @property
    def sense(self) -> Literal['forward', 'backward', 'none']:
        """Sense."""
        return self._get("sense")  # type: ignore[no-any-return]

    @property
    def text(self) -> str:
        """The finding as a sentence with numbers and units."""
        return self._get("text")  # type: ignore[no-any-return]


class Findley(Record):
    """Findley's criterion for a material."""

    __slots__ = ()
    _FIELDS = ("allowed", "weight",)

    @property
    def allowed(self) -> float:
        """Allowed value of tau_a + k sigma_n [Pa]."""
        return self._get("allowed")  # type: ignore[no-any-return]

    @property
    def weight(self) -> float:
        """Weight k of the normal stress [1]."""
        return self._get("weight")  # type: ignore[no-any-return]


class Firing(Record):
    """One firing."""

    __slots__ = ()
    _FIELDS = ("cylinder", "interval", "theta", "throw_angle",)

    @property
    def cylinder(self) -> int:
        """Cylinder number, from 1."""
        return self._get("cylinder")  # type: ignore[no-any-return]

    @property
    def interval(self) -> float:
        """Angle [rad] to the next firing; 0 where the next cylinder fires together with this one."""
        return self._get("interval")  # type: ignore[no-any-return]

    @property
    def theta(self) -> float:
        """Crank angle [rad] in the period."""
        return self._get("theta")  # type: ignore[no-any-return]

    @property
    def throw_angle(self) -> float:
        """Direction in which its crankpin stands on its crankshaft [rad], from throw 1."""
        return self._get("throw_angle")  # type: ignore[no-any-return]


class FiringChart(Record):
    """Firing of an engine over one period."""

    __slots__ = ()
    _FIELDS = ("cylinders", "even_interval", "firings", "period", "stars", "strokes", "unevenness",)

    @property
    def cylinders(self) -> Records[CylinderStrokes]:
        """Strokes of every cylinder over the period."""
        return self._all("cylinders", CylinderStrokes)

    @property
    def even_interval(self) -> float:
        """Interval of even firing [rad]: period over number of firings."""
        return self._get("even_interval")  # type: ignore[no-any-return]

    @property
    def firings(self) -> Records[Firing]:
        """Firings in their sequence, from the first at or after `theta = 0`; cylinders that fire together stand by number. A chamber that pistons
        share fires once, under the number of its first cylinder.
        """
        return self._all("firings", Firing)

    @property
    def period(self) -> float:
        """Period [rad] of crankshaft 1: a whole number of working cycles of every crankshaft."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def stars(self) -> Records[FiringStar]:
        """Size of the sum of unit vectors `e^{i n theta_f}` over all firings, over their number, for the orders `n` = 1/2, 1, 3/2 ..
        (two-stroke: 1, 2, ..): 1 where all cylinders add up (major orders), 0 where they cancel.
        """
        return self._all("stars", FiringStar)

    @property
    def strokes(self) -> Literal['two', 'four']:
        """Strokes in a working cycle."""
        return self._get("strokes")  # type: ignore[no-any-return]

    @property
    def unevenness(self) -> float:
        """Largest departure of an interval from the even one, over the even one: 0 is even, 1 is two cylinders firing
        together or an interval of twice the even length.
        """
        return self._get("unevenness")  # type: ignore[no-any-return]


class FiringStar(Record):
    """How far equal cylinders add up in one order."""

    __slots__ = ()
    _FIELDS = ("order", "share",)

    @property
    def order(self) -> float:
        """Order."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def share(self) -> float:
        """From 0 to 1."""
        return self._get("share")  # type: ignore[no-any-return]


class FirstOrder(Record):
    """First order of the pistons of one cylinder, over the square of its crankshaft's speed."""

    __slots__ = ()
    _FIELDS = ("backward", "cylinder", "forward", "z",)

    @property
    def backward(self) -> FloatArray:
        """Part that turns against it [kg m]: the force is `backward e^{-i psi}`, psi the angle of the throw."""
        return self._array("backward")  # type: ignore[no-any-return]

    @property
    def cylinder(self) -> int:
        """Index of the cylinder."""
        return self._get("cylinder")  # type: ignore[no-any-return]

    @property
    def forward(self) -> FloatArray:
        """Part that turns with the crank, in the frame of the throw [kg m]."""
        return self._array("forward")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Plane of the cylinder [m]."""
        return self._get("z")  # type: ignore[no-any-return]


class FlywheelNeed(Record):
    """A flywheel for a wanted fluctuation."""

    __slots__ = ()
    _FIELDS = ("by_formula", "crankshaft_known", "fluctuation", "flywheel", "flywheel_by_formula", "speed", "train",)

    @property
    def by_formula(self) -> float:
        """Inertia of everything by the formula `J = dE / (C_s w^2)` [kg m^2], book, eq. 25.4."""
        return self._get("by_formula")  # type: ignore[no-any-return]

    @property
    def crankshaft_known(self) -> bool:
        """Whether the inertia of the crankshafts is known; if not, `train` leaves it out and the flywheels include it."""
        return self._get("crankshaft_known")  # type: ignore[no-any-return]

    @property
    def fluctuation(self) -> float:
        """Wanted fluctuation `C_s = (w_max - w_min) / w_mean` [1]."""
        return self._get("fluctuation")  # type: ignore[no-any-return]

    @property
    def flywheel(self) -> float | None:
        """Flywheel with which the true speed, of variable inertia, just keeps the fluctuation [kg m^2]; 0 where none is needed,
        `None` where none up to half a million times the formula's keeps it.
        """
        return self._get("flywheel")  # type: ignore[no-any-return]

    @property
    def flywheel_by_formula(self) -> float:
        """Flywheel by the formula [kg m^2]: what is left, not below zero."""
        return self._get("flywheel_by_formula")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Mean speed at which it is kept [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def train(self) -> float:
        """Mean inertia that the train has without its flywheel [kg m^2]."""
        return self._get("train")  # type: ignore[no-any-return]


class Followed(Record):
    """How far a motion was followed."""

    __slots__ = ()
    _FIELDS = ("came_to_rest", "periods", "speeds", "time",)

    @property
    def came_to_rest(self) -> bool:
        """Whether the crank came to rest in the period behind them."""
        return self._get("came_to_rest")  # type: ignore[no-any-return]

    @property
    def periods(self) -> int:
        """Whole periods."""
        return self._get("periods")  # type: ignore[no-any-return]

    @property
    def speeds(self) -> FloatArray:
        """Speed of crankshaft 1 [rad/s] at the start, one period before the end, and at the end."""
        return self._array("speeds")  # type: ignore[no-any-return]

    @property
    def time(self) -> float:
        """Their time [s]."""
        return self._get("time")  # type: ignore[no-any-return]


class FoundInertia(Record):
    """A free inertia of the answer."""

    __slots__ = ()
    _FIELDS = ("inertia", "name", "roll_share",)

    @property
    def inertia(self) -> float:
        """Its inertia [kg m^2]; 0 if it is not used."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name in the task."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def roll_share(self) -> float:
        """The share of the crank train's roll moment that is left with it."""
        return self._get("roll_share")  # type: ignore[no-any-return]


class FoundLayout(Record):
    """A layout that was found."""

    __slots__ = ()
    _FIELDS = ("alike", "durability", "firing_order", "layout", "number", "orders", "unevenness", "values",)

    @property
    def alike(self) -> int:
        """Cases with equal objectives, this one included."""
        return self._get("alike")  # type: ignore[no-any-return]

    @property
    def durability(self) -> Records[Measured]:
        """Films and safeties, in the order of `durability`; empty where they were not asked for."""
        return self._all("durability", Measured)

    @property
    def firing_order(self) -> list[int] | None:
        """Cylinders by firing; `None` where firing is left out."""
        return self._get("firing_order")  # type: ignore[no-any-return]

    @property
    def layout(self) -> Layout:
        """The layout."""
        return self._of("layout", Layout)  # type: ignore[no-any-return]

    @property
    def number(self) -> int:
        """Its number in the list, from 1."""
        return self._get("number")  # type: ignore[no-any-return]

    @property
    def orders(self) -> LayoutOrders:
        """All its loads of orders 1 and 2."""
        return self._of("orders", LayoutOrders)  # type: ignore[no-any-return]

    @property
    def unevenness(self) -> float | None:
        """Largest difference of a firing interval from the even one [rad]; `None` where firing is left out."""
        return self._get("unevenness")  # type: ignore[no-any-return]

    @property
    def values(self) -> FloatArray:
        """Its objectives in the order of the request, in SI units."""
        return self._array("values")  # type: ignore[no-any-return]


class FoundLimit(Record):
    """A limit of the answer."""

    __slots__ = ()
    _FIELDS = ("criterion", "most", "price", "price_unit", "side", "stage", "unit", "value", "what",)

    @property
    def criterion(self) -> Criterion | None:
        """Its criterion, if it is one."""
        return self._of("criterion", Criterion)  # type: ignore[no-any-return]

    @property
    def most(self) -> float:
        """The limit, in SI units."""
        return self._get("most")  # type: ignore[no-any-return]

    @property
    def price(self) -> float:
        """Shadow price: how much the first stage that this limit holds up would fall if the limit were relaxed by one SI unit: a
        largest value made larger, a least one smaller, e.g. N per kg m; 0 for a limit that is not active. Of a given amount it is
        that of a smaller one, negative where a larger one helps. Of a choice that was searched for it is the price with that
        choice kept: devices used, places, directions of given and least amounts.
        """
        return self._get("price")  # type: ignore[no-any-return]

    @property
    def price_unit(self) -> str:
        """Unit of the price, such as `N per kg m`; `1 per N m` for a weighted sum; empty for a limit that is not active."""
        return self._get("price_unit")  # type: ignore[no-any-return]

    @property
    def side(self) -> Literal['at-most', 'at-least', 'given']:
        """On which side of its value it lies."""
        return self._get("side")  # type: ignore[no-any-return]

    @property
    def stage(self) -> int | None:
        """The stage that the price belongs to, by index."""
        return self._get("stage")  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """SI unit of the limit and of what was reached."""
        return self._get("unit")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """What was reached."""
        return self._get("value")  # type: ignore[no-any-return]

    @property
    def what(self) -> str:
        """What is limited: a criterion, the largest, least or given amount of a weight, the largest inertia."""
        return self._get("what")  # type: ignore[no-any-return]


class FoundShaft(Record):
    """A free shaft of the answer."""

    __slots__ = ()
    _FIELDS = ("name", "used", "x", "y",)

    @property
    def name(self) -> str:
        """Its name in the task."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def used(self) -> bool:
        """Whether it is used."""
        return self._get("used")  # type: ignore[no-any-return]

    @property
    def x(self) -> float:
        """Position of its axis [m]."""
        return self._get("x")  # type: ignore[no-any-return]

    @property
    def y(self) -> float:
        """Position of its axis [m]."""
        return self._get("y")  # type: ignore[no-any-return]


class FoundStage(Record):
    """What a stage reached, and the proof that nothing better exists."""

    __slots__ = ()
    _FIELDS = ("active", "gap", "give_up", "lower_bound", "term_weights", "terms", "unit", "value", "without_give_up",)

    @property
    def active(self) -> Records[Active]:
        """The parts of the cycle that hold the optimum up; none where the stage vanishes."""
        return self._all("active", Active)

    @property
    def gap(self) -> float:
        """`value - lower_bound`, without what later stages took of what this one gives up."""
        return self._get("gap")  # type: ignore[no-any-return]

    @property
    def give_up(self) -> StageGiveUp | None:
        """What it gives up for later stages, if anything."""
        return self._of("give_up", StageGiveUp)  # type: ignore[no-any-return]

    @property
    def lower_bound(self) -> float:
        """No choice of these devices that holds the limits goes below this."""
        return self._get("lower_bound")  # type: ignore[no-any-return]

    @property
    def term_weights(self) -> FloatArray:
        """Weight of each term: 1 for a criterion that is minimised alone."""
        return self._array("term_weights")  # type: ignore[no-any-return]

    @property
    def terms(self) -> list[tuple[Criterion, float]]:
        """Each term's criterion and true value."""
        return self._as("terms", every(row(Criterion, one)), [])  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """SI unit of the value: that of the criterion, or `1` for a weighted sum, whose terms are shares of given values."""
        return self._get("unit")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """The sum of weight times criterion, its true value over the continuous cycle."""
        return self._get("value")  # type: ignore[no-any-return]

    @property
    def without_give_up(self) -> float | None:
        """The value of this stage if no earlier one gave up anything, where one does: the difference is what that gains."""
        return self._get("without_give_up")  # type: ignore[no-any-return]


class FoundWeight(Record):
    """A free weight of the answer."""

    __slots__ = ()
    _FIELDS = ("hole", "mass", "name", "unbalance", "used", "z",)

    @property
    def hole(self) -> CatalogueHole | None:
        """The hole that it is, where the task gives drills: opposite to its direction if it stays empty."""
        return self._of("hole", CatalogueHole)  # type: ignore[no-any-return]

    @property
    def mass(self) -> float | None:
        """Its mass [kg], where the task gives its radius."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name in the task."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> FloatArray:
        """Its unbalance [kg m]: modulus = amount, argument = direction at `theta = 0` in the engine's frame."""
        return self._array("unbalance")  # type: ignore[no-any-return]

    @property
    def used(self) -> bool:
        """Whether it is used."""
        return self._get("used")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its plane [m]."""
        return self._get("z")  # type: ignore[no-any-return]


class FreeInertia(Record):
    """An inertia geared to turn against crankshaft 1 (Heron flywheel, geared alternator): with the crank train free to
    follow its torque it takes part of the roll moment.
    """

    __slots__ = ()
    _FIELDS = ("crank_inertia", "most", "name", "optional", "ratio",)

    @property
    def crank_inertia(self) -> float:
        """Inertia of everything that turns with crankshaft 1 [kg m^2], flywheel included."""
        return self._get("crank_inertia")  # type: ignore[no-any-return]

    @property
    def most(self) -> float | None:
        """Largest inertia [kg m^2]."""
        return self._get("most")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name for tables."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def optional(self) -> bool:
        """Whether it may be left out."""
        return self._get("optional")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> float:
        """Its speed over that of crankshaft 1, as a positive number: it turns the other way."""
        return self._get("ratio")  # type: ignore[no-any-return]


class FreeShaft(Record):
    """A balance shaft that may be fitted."""

    __slots__ = ()
    _FIELDS = ("name", "optional", "ratio", "x", "y",)

    @property
    def name(self) -> str:
        """Name for tables and for the engine file."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def optional(self) -> bool:
        """Whether it may be left out."""
        return self._get("optional")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> str:
        """Speed over that of crankshaft 1, signed."""
        return self._get("ratio")  # type: ignore[no-any-return]

    @property
    def x(self) -> Place:
        """Position of its axis [m]."""
        return self._of("x", Place)  # type: ignore[no-any-return]

    @property
    def y(self) -> Place:
        """Position of its axis [m]."""
        return self._of("y", Place)  # type: ignore[no-any-return]


class FreeSpeed(Record):
    """How a free flywheel turns."""

    __slots__ = ()
    _FIELDS = ("change", "load",)

    @property
    def change(self) -> float:
        """Change of the speed over the last cycle over its swing."""
        return self._get("change")  # type: ignore[no-any-return]

    @property
    def load(self) -> float:
        """Constant torque of the load on the flywheel [N m], positive in the sense of crankshaft 1: an engine that drives has a negative one."""
        return self._get("load")  # type: ignore[no-any-return]


class FreeWeight(Record):
    """An unbalance that is to be found: `U = amount e^{i phase}` at `theta = 0`, in the engine's frame."""

    __slots__ = ()
    _FIELDS = ("catalogue", "cost", "drill", "equal_parts", "fits", "least", "most", "name", "optional", "phase", "radius", "seat", "z",)

    @property
    def catalogue(self) -> Catalogue | None:
        """Amounts that can be made, within `least` and `most`; none: every amount."""
        return self._of("catalogue", Catalogue)  # type: ignore[no-any-return]

    @property
    def cost(self) -> Cost:
        """What it costs if it is used."""
        return self._of("cost", Cost)  # type: ignore[no-any-return]

    @property
    def drill(self) -> DrillCatalogue | None:
        """The holes whose unbalances are its catalogue, if it is one of them."""
        return self._of("drill", DrillCatalogue)  # type: ignore[no-any-return]

    @property
    def equal_parts(self) -> str | None:
        """Name of the parts that it is one of: used weights with the same name have the same amount of their catalogue."""
        return self._get("equal_parts")  # type: ignore[no-any-return]

    @property
    def fits(self) -> bool | None:
        """Whether its largest amount is what fits on its web, by shapes and clearance."""
        return self._get("fits")  # type: ignore[no-any-return]

    @property
    def least(self) -> float:
        """Least amount [kg m], 0 or more. An optional weight is either left out or has at least this."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def most(self) -> float | None:
        """Largest amount [kg m]; equal to `least` for a given amount."""
        return self._get("most")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name for tables and for the engine file."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def optional(self) -> bool:
        """Whether it may be left out."""
        return self._get("optional")  # type: ignore[no-any-return]

    @property
    def phase(self) -> Phase:
        """Direction at `theta = 0` in the engine's frame (crankshaft phase included)."""
        return self._of("phase", Phase)  # type: ignore[no-any-return]

    @property
    def radius(self) -> float | None:
        """Distance of its centre of gravity from the axis it turns about [m]: its mass is amount over radius."""
        return self._get("radius")  # type: ignore[no-any-return]

    @property
    def seat(self) -> Seat:
        """What it sits on."""
        return self._of("seat", Seat)  # type: ignore[no-any-return]

    @property
    def z(self) -> Place:
        """Plane [m], from the origin."""
        return self._of("z", Place)  # type: ignore[no-any-return]


class Functional(Record):
    """A linear functional of the orders, `SUM over terms of Re( conj(factor) * -amount )`: what it says of every choice of
    the devices.

    With `a_k(U)` what the devices add to the orders, the orders vanish where `a_k(U) = -amount_k`. Let `y` be the
    factors. A weight of amount 1 changes `SUM Re( conj(y_k) a_k )` by no more than its pull `|(A^H y)_i|`. So

    ```text
    SUM of cost_i |U_i|  >=  Re( y^H b ) - SUM of charges      if no pull passes the weight's cost by more than its charge pays for
    ```
    With costs of 1 (of 1 / radius for masses) this bounds the total; with costs of 0 a value above 0 proves that no `U`
    makes the orders vanish.
    """

    __slots__ = ()
    _FIELDS = ("charges", "largest_pull", "terms", "value",)

    @property
    def charges(self) -> list[tuple[str, float]]:
        """What weights with a largest amount, and inertias, can do against it at most: name and amount, in the unit of the
        value.
        """
        return self._as("charges", every(row(one, one)), [])  # type: ignore[no-any-return]

    @property
    def largest_pull(self) -> float:
        """Largest pull of a weight without a largest amount: over its cost (at most 1) where the total is bounded; over the
        most that factors of the same size could pull (0 to rounding) for an obstruction.
        """
        return self._get("largest_pull")  # type: ignore[no-any-return]

    @property
    def terms(self) -> Records[FunctionalTerm]:
        """Its terms."""
        return self._all("terms", FunctionalTerm)

    @property
    def value(self) -> float:
        """Sum of the terms less the charges [kg m or kg; 1 for an obstruction]."""
        return self._get("value")  # type: ignore[no-any-return]


class FunctionalTerm(Record):
    """One part of one order in a functional."""

    __slots__ = ()
    _FIELDS = ("amount", "criterion", "factor", "sense",)

    @property
    def amount(self) -> FloatArray:
        """The part without the free devices [N or N m]."""
        return self._array("amount")  # type: ignore[no-any-return]

    @property
    def criterion(self) -> Criterion:
        """One order of a load."""
        return self._of("criterion", Criterion)  # type: ignore[no-any-return]

    @property
    def factor(self) -> FloatArray:
        """`y`: value of the functional per N or N m."""
        return self._array("factor")  # type: ignore[no-any-return]

    @property
    def sense(self) -> Literal['forward', 'backward', 'alternating']:
        """Which part of it."""
        return self._get("sense")  # type: ignore[no-any-return]


class Gear(Record):
    """A gear or sprocket."""

    __slots__ = ()
    _FIELDS = ("pitch_diameter", "plane", "ratio", "seat", "x", "y",)

    @property
    def pitch_diameter(self) -> float:
        """Pitch diameter [m]."""
        return self._get("pitch_diameter")  # type: ignore[no-any-return]

    @property
    def plane(self) -> int:
        """Gear plane, from 1 at the end of the crank outwards."""
        return self._get("plane")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> float:
        """Speed over that of crankshaft 1, signed."""
        return self._get("ratio")  # type: ignore[no-any-return]

    @property
    def seat(self) -> GearSeat:
        """What it sits on."""
        return self._of("seat", GearSeat)  # type: ignore[no-any-return]

    @property
    def x(self) -> float:
        """Position of its axis [m]."""
        return self._get("x")  # type: ignore[no-any-return]

    @property
    def y(self) -> float:
        """Position of its axis [m]."""
        return self._get("y")  # type: ignore[no-any-return]


class GearSeat(Variant):
    """What a gear sits on."""

    __slots__ = ()
    _FIELDS = ("kind", "shaft",)

    @property
    def kind(self) -> Literal['crank', 'shaft', 'idler']:
        """Which of the variants it is.
        `crank`: Crankshaft 1.
        `idler`: Its own stud.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def shaft(self) -> int | None:
        """A balance shaft, by index."""
        return self._get("shaft")  # type: ignore[no-any-return]


class GiveUp(Variant):
    """How far later stages may raise a stage above its least value."""

    __slots__ = ()
    _FIELDS = ("kind", "share", "amount",)

    @property
    def kind(self) -> Literal['nothing', 'share', 'amount']:
        """Which of the variants it is.
        `nothing`: Not at all.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def share(self) -> float | None:
        """By this share of the least value: 0.01 is 1 %."""
        return self._get("share")  # type: ignore[no-any-return]

    @property
    def amount(self) -> float | None:
        """By this much, in the SI unit of the stage's criterion."""
        return self._get("amount")  # type: ignore[no-any-return]


class GivenEngine(Record):
    """Where an engine stands in a search."""

    __slots__ = ()
    _FIELDS = ("beaten_by", "broken", "case", "equals", "outside", "values",)

    @property
    def beaten_by(self) -> list[int]:
        """Numbers of the layouts of the front that beat it; none where an objective is not known."""
        return self._list("beaten_by")  # type: ignore[no-any-return]

    @property
    def broken(self) -> list[str]:
        """Constraints that it breaks, in words."""
        return self._list("broken")  # type: ignore[no-any-return]

    @property
    def case(self) -> int | None:
        """Its case, weights and shafts apart; `None` where it is not in the space."""
        return self._get("case")  # type: ignore[no-any-return]

    @property
    def equals(self) -> int | None:
        """Number of the layout of the front that has its objectives."""
        return self._get("equals")  # type: ignore[no-any-return]

    @property
    def outside(self) -> str | None:
        """Why it is not in the space, in words."""
        return self._get("outside")  # type: ignore[no-any-return]

    @property
    def values(self) -> list[float | None]:
        """Its objectives as it is; `None` where it does not tell."""
        return self._list("values")  # type: ignore[no-any-return]


class Grade(Result):
    """What a balance quality grade allows."""

    __slots__ = ()
    _FIELDS = ("bearings", "eccentricity", "grade", "kept", "mass", "name", "permissible", "planes", "resultant", "speed", "version",)

    @property
    def bearings(self) -> Records[GradedBearing]:
        """The share of each bearing; empty where supports or centre of mass are not given."""
        return self._all("bearings", GradedBearing)

    @property
    def eccentricity(self) -> float:
        """Permissible residual specific unbalance, the eccentricity of the centre of mass [m]."""
        return self._get("eccentricity")  # type: ignore[no-any-return]

    @property
    def grade(self) -> float:
        """Permissible speed of the centre of mass [m/s]."""
        return self._get("grade")  # type: ignore[no-any-return]

    @property
    def kept(self) -> bool | None:
        """Whether the measured unbalance keeps the grade: at both bearings where they are known. Where they are not, a resultant beyond
        U_per does not, one within it does if it is measured in one plane; several planes may have a couple that only bearings can judge.
        `None` where nothing is measured, or that couple is not judged.
        """
        return self._get("kept")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Mass of the rotor [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name of the sheet."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def permissible(self) -> float:
        """Permissible residual unbalance of the whole rotor, U_per [kg m]."""
        return self._get("permissible")  # type: ignore[no-any-return]

    @property
    def planes(self) -> Records[GradedPlane]:
        """The share of each correction plane whose place is given; empty without bearings."""
        return self._all("planes", GradedPlane)

    @property
    def resultant(self) -> FloatArray | None:
        """Resultant of the measured unbalances [kg m]; `None` where none are measured."""
        return self._array("resultant")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Service speed [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class GradedBearing(Record):
    """What a bearing may carry."""

    __slots__ = ()
    _FIELDS = ("kept", "measured", "permissible", "z",)

    @property
    def kept(self) -> bool | None:
        """Whether it is kept."""
        return self._get("kept")  # type: ignore[no-any-return]

    @property
    def measured(self) -> FloatArray | None:
        """The measured unbalances moved to both bearings: this bearing's part [kg m]."""
        return self._array("measured")  # type: ignore[no-any-return]

    @property
    def permissible(self) -> float:
        """Permissible residual unbalance in its plane [kg m]."""
        return self._get("permissible")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Where along the shaft, z [m]."""
        return self._get("z")  # type: ignore[no-any-return]


class GradedPlane(Record):
    """What may be left in a correction plane."""

    __slots__ = ()
    _FIELDS = ("kept", "measured", "name", "permissible", "z",)

    @property
    def kept(self) -> bool | None:
        """Whether it is kept. Keeping all is enough, though more than is needed, for the bearings to keep theirs."""
        return self._get("kept")  # type: ignore[no-any-return]

    @property
    def measured(self) -> FloatArray | None:
        """The measured unbalances moved to the planes: this plane's part [kg m]. Only where there are one or two planes."""
        return self._array("measured")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name of the plane."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def permissible(self) -> float:
        """With no more than this in every plane, at whatever angles, no bearing exceeds its share [kg m]."""
        return self._get("permissible")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Where along the shaft, z [m]."""
        return self._get("z")  # type: ignore[no-any-return]


class GraphAudit(Record):
    """Where the energy went."""

    __slots__ = ()
    _FIELDS = ("bonds", "elements", "measured_at", "residuals", "throughput", "whole",)

    @property
    def bonds(self) -> Records[BondEnergy]:
        """Energy through each bond, along its half arrow [J]."""
        return self._all("bonds", BondEnergy)

    @property
    def elements(self) -> Records[ElementEnergy]:
        """Energy that each one-port took in [J]; of sources negative what they gave."""
        return self._all("elements", ElementEnergy)

    @property
    def measured_at(self) -> str:
        """That bond."""
        return self._get("measured_at")  # type: ignore[no-any-return]

    @property
    def residuals(self) -> Records[Residual]:
        """Largest difference of powers at each junction and two-port over all samples, against the largest power there."""
        return self._all("residuals", Residual)

    @property
    def throughput(self) -> float:
        """What the errors are measured by [J]: energy that passed through the bond which carried the most, to and fro between the samples."""
        return self._get("throughput")  # type: ignore[no-any-return]

    @property
    def whole(self) -> float:
        """Sum of what all one-ports took in, against the throughput: the error of the whole."""
        return self._get("whole")  # type: ignore[no-any-return]


class GraphEvent(Record):
    """A condition that switched."""

    __slots__ = ()
    _FIELDS = ("condition", "expression", "on", "time",)

    @property
    def condition(self) -> int:
        """Which condition, by its place among those of the graph."""
        return self._get("condition")  # type: ignore[no-any-return]

    @property
    def expression(self) -> str:
        """That condition as the graph writes it: `pipe.effort > 0`; of dry friction that sticks `crank.flow sticks`."""
        return self._get("expression")  # type: ignore[no-any-return]

    @property
    def on(self) -> bool:
        """Whether it became true."""
        return self._get("on")  # type: ignore[no-any-return]

    @property
    def time(self) -> float:
        """When [s]."""
        return self._get("time")  # type: ignore[no-any-return]


class GraphPeriodicMotion(Record):
    """The periodic motion, or what was found instead."""

    __slots__ = ()
    _FIELDS = ("instead", "iterations", "multipliers", "outcome", "period", "residual",)

    @property
    def instead(self) -> str | None:
        """What happened where no periodic motion was found."""
        return self._get("instead")  # type: ignore[no-any-return]

    @property
    def iterations(self) -> int:
        """Newton's iterations."""
        return self._get("iterations")  # type: ignore[no-any-return]

    @property
    def multipliers(self) -> FloatArray:
        """Multipliers by falling size: real and imaginary part."""
        return self._array("multipliers")  # type: ignore[no-any-return]

    @property
    def outcome(self) -> Literal['stable', 'neutral', 'unstable', 'not-found']:
        """How Newton ended."""
        return self._get("outcome")  # type: ignore[no-any-return]

    @property
    def period(self) -> float:
        """Length of the period [s]; of the last trial where none closes."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """Largest change over one period, over the size of its state."""
        return self._get("residual")  # type: ignore[no-any-return]


class GraphRun(Record):
    """A simulation: what was computed, what happened, what it cost."""

    __slots__ = ()
    _FIELDS = ("audit", "complete", "ended", "evaluations_needed", "events", "graph", "methods", "operations", "periodic", "series", "statistics", "stiff_from", "time", "tolerance", "version",)

    @property
    def audit(self) -> GraphAudit | None:
        """Energy through every bond."""
        return self._of("audit", GraphAudit)  # type: ignore[no-any-return]

    @property
    def complete(self) -> bool:
        """Whether the whole duration was covered; otherwise the samples so far are good."""
        return self._get("complete")  # type: ignore[no-any-return]

    @property
    def ended(self) -> str:
        """Why it ended, in words."""
        return self._get("ended")  # type: ignore[no-any-return]

    @property
    def evaluations_needed(self) -> float | None:
        """Evaluations that the whole duration would need, as far as the run came: where it ended for their number."""
        return self._get("evaluations_needed")  # type: ignore[no-any-return]

    @property
    def events(self) -> Records[GraphEvent]:
        """Switches of conditions."""
        return self._all("events", GraphEvent)

    @property
    def graph(self) -> str:
        """Name of the graph."""
        return self._get("graph")  # type: ignore[no-any-return]

    @property
    def methods(self) -> list[Literal['explicit', 'implicit']]:
        """Methods that ran, in their order."""
        return self._list("methods")  # type: ignore[no-any-return]

    @property
    def operations(self) -> int:
        """Operations of one evaluation."""
        return self._get("operations")  # type: ignore[no-any-return]

    @property
    def periodic(self) -> GraphPeriodicMotion | None:
        """The periodic motion that was looked for."""
        return self._of("periodic", GraphPeriodicMotion)  # type: ignore[no-any-return]

    @property
    def series(self) -> Records[Series]:
        """States, then effort, flow and power of every bond, then what each junction shares, then signals, at the samples."""
        return self._all("series", Series)

    @property
    def statistics(self) -> Statistics:
        """Cost, of all methods together."""
        return self._of("statistics", Statistics)  # type: ignore[no-any-return]

    @property
    def stiff_from(self) -> float | None:
        """Time at which stiffness made the method implicit [s]."""
        return self._get("stiff_from")  # type: ignore[no-any-return]

    @property
    def time(self) -> FloatArray:
        """Times of the samples [s]."""
        return self._array("time")  # type: ignore[no-any-return]

    @property
    def tolerance(self) -> float:
        """Relative tolerance."""
        return self._get("tolerance")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class Happened(Record):
    """Something that happened."""

    __slots__ = ()
    _FIELDS = ("speed", "theta", "time", "what",)

    @property
    def speed(self) -> float:
        """At which speed [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def theta(self) -> float:
        """At which crank angle [rad]."""
        return self._get("theta")  # type: ignore[no-any-return]

    @property
    def time(self) -> float:
        """When [s]."""
        return self._get("time")  # type: ignore[no-any-return]

    @property
    def what(self) -> Occasion:
        """What."""
        return self._of("what", Occasion)  # type: ignore[no-any-return]


class Hole(Record):
    """A hole to drill."""

    __slots__ = ()
    _FIELDS = ("angle", "depth", "diameter", "mass", "tip", "unbalance",)

    @property
    def angle(self) -> float:
        """Angle on the rotor [rad], within [0, 2 pi)."""
        return self._get("angle")  # type: ignore[no-any-return]

    @property
    def depth(self) -> float:
        """Depth from the surface to the end of the full diameter [m]."""
        return self._get("depth")  # type: ignore[no-any-return]

    @property
    def diameter(self) -> float:
        """Diameter of the drill [m]."""
        return self._get("diameter")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Mass removed [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def tip(self) -> float:
        """Depth from the surface that the tip of the drill reaches [m]."""
        return self._get("tip")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> float:
        """Unbalance removed, at its angle [kg m]."""
        return self._get("unbalance")  # type: ignore[no-any-return]


class HolzerRow(Record):
    """One line of Holzer's table: a station and the shaft towards the root of the tree."""

    __slots__ = ()
    _FIELDS = ("angle", "inertia", "inertia_torque", "inertia_torque_rate", "shaft_torque", "station", "stiffness", "twist",)

    @property
    def angle(self) -> float:
        """Referred angle [rad]."""
        return self._get("angle")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> float:
        """Inertia at the reference [kg m^2]."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def inertia_torque(self) -> float:
        """Inertia torque `J w^2 phi` [N m]."""
        return self._get("inertia_torque")  # type: ignore[no-any-return]

    @property
    def inertia_torque_rate(self) -> float:
        """`J w^2` [N m/rad]."""
        return self._get("inertia_torque_rate")  # type: ignore[no-any-return]

    @property
    def shaft_torque(self) -> float:
        """Torque in the shaft behind it: the sum of all inertia torques before it [N m]."""
        return self._get("shaft_torque")  # type: ignore[no-any-return]

    @property
    def station(self) -> int:
        """Index of the station."""
        return self._get("station")  # type: ignore[no-any-return]

    @property
    def stiffness(self) -> float | None:
        """Stiffness of that shaft at the reference [N m/rad]; `None` at the last station."""
        return self._get("stiffness")  # type: ignore[no-any-return]

    @property
    def twist(self) -> float:
        """Its referred twist [rad]."""
        return self._get("twist")  # type: ignore[no-any-return]


class HolzerTable(Record):
    """Holzer's table at one frequency."""

    __slots__ = ()
    _FIELDS = ("frequency", "relative_residual", "residual", "rows",)

    @property
    def frequency(self) -> float:
        """Angular frequency [rad/s]."""
        return self._get("frequency")  # type: ignore[no-any-return]

    @property
    def relative_residual(self) -> float:
        """The same over the sum of the sizes of all inertia torques."""
        return self._get("relative_residual")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """Torque that is left at the last station [N m]: 0 at a natural frequency."""
        return self._get("residual")  # type: ignore[no-any-return]

    @property
    def rows(self) -> Records[HolzerRow]:
        """Lines, every station before that towards which its shaft leads."""
        return self._all("rows", HolzerRow)


class IncompleteInertia(Record):
    """A speed that is not known for want of an inertia."""

    __slots__ = ()
    _FIELDS = ("fix", "keys", "mean_speed", "missing", "reason", "version",)

    @property
    def fix(self) -> str:
        """What fixes it."""
        return self._get("fix")  # type: ignore[no-any-return]

    @property
    def keys(self) -> list[str]:
        """Keys of the engine file that give it."""
        return self._list("keys")  # type: ignore[no-any-return]

    @property
    def mean_speed(self) -> float:
        """Mean speed asked for [rad/s]."""
        return self._get("mean_speed")  # type: ignore[no-any-return]

    @property
    def missing(self) -> list[Literal['flywheel', 'crankshaft']]:
        """What is not known."""
        return self._list("missing")  # type: ignore[no-any-return]

    @property
    def reason(self) -> str:
        """Why, in words."""
        return self._get("reason")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class Index(Record):
    """Indices of one output by one input, with their standard errors."""

    __slots__ = ()
    _FIELDS = ("first", "first_error", "total", "total_error",)

    @property
    def first(self) -> float:
        """Share of the variance that would vanish if this input alone were known (Saltelli et al. 2010)."""
        return self._get("first")  # type: ignore[no-any-return]

    @property
    def first_error(self) -> float:
        """Its standard error."""
        return self._get("first_error")  # type: ignore[no-any-return]

    @property
    def total(self) -> float:
        """Share of the variance that would be left if all other inputs were known (Jansen 1999)."""
        return self._get("total")  # type: ignore[no-any-return]

    @property
    def total_error(self) -> float:
        """Its standard error."""
        return self._get("total_error")  # type: ignore[no-any-return]


class Indicated(Record):
    """Indicated numbers: from the pressures alone, net (the whole working cycle, pumping included), without friction."""

    __slots__ = ()
    _FIELDS = ("crankcase_mep", "displacement", "imep", "mean_piston_speed", "peak_pressure", "power", "torque", "torque_per_mep",)

    @property
    def crankcase_mep(self) -> float:
        """Mean effective pressure of what is under the pistons [Pa], positive where it takes work from the crank."""
        return self._get("crankcase_mep")  # type: ignore[no-any-return]

    @property
    def displacement(self) -> float:
        """Swept volume of all cylinders [m^3], of their true strokes."""
        return self._get("displacement")  # type: ignore[no-any-return]

    @property
    def imep(self) -> float:
        """Mean effective pressure of the gas in the cylinders, net [Pa]: their work over the swept volume."""
        return self._get("imep")  # type: ignore[no-any-return]

    @property
    def mean_piston_speed(self) -> float:
        """Mean piston speed of the fastest cylinder [m/s]: two strokes a revolution."""
        return self._get("mean_piston_speed")  # type: ignore[no-any-return]

    @property
    def peak_pressure(self) -> float:
        """Highest cylinder pressure of all cylinders [Pa], absolute."""
        return self._get("peak_pressure")  # type: ignore[no-any-return]

    @property
    def power(self) -> float:
        """Power [W]: mean torque times speed."""
        return self._get("power")  # type: ignore[no-any-return]

    @property
    def torque(self) -> float:
        """Mean torque at crankshaft 1 [N m]."""
        return self._get("torque")  # type: ignore[no-any-return]

    @property
    def torque_per_mep(self) -> float:
        """Torque a unit of mean effective pressure [m^3]: swept volumes over the angles of their cycles, at crankshaft 1."""
        return self._get("torque_per_mep")  # type: ignore[no-any-return]


class IndicatedWork(Record):
    """Work of one cylinder in one working cycle [J], by routes that share no quadrature."""

    __slots__ = ()
    _FIELDS = ("by_rods", "by_torque", "by_volume", "crankcase", "cylinder", "gross", "swept",)

    @property
    def by_rods(self) -> float:
        """Of the force that the rods pass to the crankpin, through side thrust and rod, with the exact lever."""
        return self._get("by_rods")  # type: ignore[no-any-return]

    @property
    def by_torque(self) -> float:
        """Of the torque, over the crank angle."""
        return self._get("by_torque")  # type: ignore[no-any-return]

    @property
    def by_volume(self) -> float:
        """Of the pressures over the volume: from their orders and those of the travel."""
        return self._get("by_volume")  # type: ignore[no-any-return]

    @property
    def crankcase(self) -> float:
        """What is under the piston, negative where it takes work from the crank."""
        return self._get("crankcase")  # type: ignore[no-any-return]

    @property
    def cylinder(self) -> float:
        """Of the gas in the cylinder alone; net."""
        return self._get("cylinder")  # type: ignore[no-any-return]

    @property
    def gross(self) -> float:
        """That between the bottom dead centres around firing: compression and power; gross."""
        return self._get("gross")  # type: ignore[no-any-return]

    @property
    def swept(self) -> float:
        """Swept volume [m^3]."""
        return self._get("swept")  # type: ignore[no-any-return]


class InertiaSum(Record):
    """Inertia of several bodies as seen at crankshaft 1."""

    __slots__ = ()
    _FIELDS = ("known", "missing", "origin",)

    @property
    def known(self) -> float:
        """Of all that is known [kg m^2]."""
        return self._get("known")  # type: ignore[no-any-return]

    @property
    def missing(self) -> list[tuple[str, str]]:
        """Names of the bodies whose inertia is not known, with the key that would give each."""
        return self._as("missing", every(row(one, one)), [])  # type: ignore[no-any-return]

    @property
    def origin(self) -> Literal['given', 'from-shape', 'typical', 'assumed'] | None:
        """Where it comes from: the least certain of its parts; `None` where nothing is known."""
        return self._get("origin")  # type: ignore[no-any-return]


class Inertias(Result):
    """What turns with an engine."""

    __slots__ = ()
    _FIELDS = ("bodies", "driveline", "sum", "throws", "version",)

    @property
    def bodies(self) -> Records[RotatingBody]:
        """All that turns at a fixed ratio to crankshaft 1."""
        return self._all("bodies", RotatingBody)

    @property
    def driveline(self) -> Records[DrivelineBody]:
        """What is behind the flywheel on springs, in order; not in the sum."""
        return self._all("driveline", DrivelineBody)

    @property
    def sum(self) -> InertiaSum:
        """All bodies as seen at crankshaft 1."""
        return self._of("sum", InertiaSum)  # type: ignore[no-any-return]

    @property
    def throws(self) -> Records[ThrowInertia]:
        """Of crankshafts that are bodies what belongs to each throw: pin, webs and counterweights on them; part of the crankshaft's own number."""
        return self._all("throws", ThrowInertia)

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class Infeasible(Record):
    """Why there is no design."""

    __slots__ = ()
    _FIELDS = ("nearest", "proved",)

    @property
    def nearest(self) -> Records[NearestLimit]:
        """For each limit the nearest value that can be met while all others hold; none is listed that cannot help alone."""
        return self._all("nearest", NearestLimit)

    @property
    def proved(self) -> bool:
        """Whether every box was refuted; otherwise a design may have been overlooked."""
        return self._get("proved")  # type: ignore[no-any-return]


class Influence(Record):
    """Effect of a weight in one plane on one sensor at one speed."""

    __slots__ = ()
    _FIELDS = ("deviation", "plane", "quantity", "response", "sensor", "shown", "speed",)

    @property
    def deviation(self) -> float | None:
        """Its standard deviation [same unit]; `None` where the runs leave no freedom."""
        return self._get("deviation")  # type: ignore[no-any-return]

    @property
    def plane(self) -> str:
        """Name of the plane."""
        return self._get("plane")  # type: ignore[no-any-return]

    @property
    def quantity(self) -> Literal['displacement', 'velocity', 'acceleration']:
        """Quantity in which the sensor is read."""
        return self._get("quantity")  # type: ignore[no-any-return]

    @property
    def response(self) -> FloatArray:
        """Peak velocity per unbalance [m/s per kg m]; its argument is the angle by which the peak of the velocity leads the
        passing of the heavy spot at the sensor, whatever the conventions of the sheet.
        """
        return self._array("response")  # type: ignore[no-any-return]

    @property
    def sensor(self) -> str:
        """Name of the sensor."""
        return self._get("sensor")  # type: ignore[no-any-return]

    @property
    def shown(self) -> float:
        """Amplitude per unbalance as the sensor's detector gives it [m, m/s or m/s^2 per kg m]."""
        return self._get("shown")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]


class IntegrationOutcome(Variant):
    """How a run ended. `t` and `y` of the run hold the last good state in every case."""

    __slots__ = ()
    _FIELDS = ("kind", "event", "too_many_evaluations", "step_too_small", "not_finite", "stiff",)

    @property
    def kind(self) -> Literal['reached', 'event', 'stopped', 'too_many_evaluations', 'step_too_small', 'not_finite', 'stiff', 'singular']:
        """Which of the variants it is.
        `reached`: The end was reached.
        `stopped`: The observer asked to stop.
        `singular`: Newton's iteration has no regular matrix, however short the step: the mass matrix and the Jacobian are singular together.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def event(self) -> IntegrationOutcomeEvent | None:
        """An event function changed its sign; the state is the one just behind it."""
        return self._of("event", IntegrationOutcomeEvent)  # type: ignore[no-any-return]

    @property
    def too_many_evaluations(self) -> IntegrationOutcomeTooManyEvaluations | None:
        """As many evaluations as are allowed."""
        return self._of("too_many_evaluations", IntegrationOutcomeTooManyEvaluations)  # type: ignore[no-any-return]

    @property
    def step_too_small(self) -> IntegrationOutcomeStepTooSmall | None:
        """The error cannot be met by any step that the machine can tell from zero: a singularity or a jump."""
        return self._of("step_too_small", IntegrationOutcomeStepTooSmall)  # type: ignore[no-any-return]

    @property
    def not_finite(self) -> IntegrationOutcomeNotFinite | None:
        """A derivative is no finite number, however short the step."""
        return self._of("not_finite", IntegrationOutcomeNotFinite)  # type: ignore[no-any-return]

    @property
    def stiff(self) -> IntegrationOutcomeStiff | None:
        """The problem is stiff: steps are bounded by stability, not by accuracy. Only where the settings ask for the test."""
        return self._of("stiff", IntegrationOutcomeStiff)  # type: ignore[no-any-return]


class IntegrationOutcomeEvent(Record):
    """An event function changed its sign; the state is the one just behind it."""

    __slots__ = ()
    _FIELDS = ("index", "rising",)

    @property
    def index(self) -> int:
        """Which event function."""
        return self._get("index")  # type: ignore[no-any-return]

    @property
    def rising(self) -> bool:
        """Whether it became positive."""
        return self._get("rising")  # type: ignore[no-any-return]


class IntegrationOutcomeNotFinite(Record):
    """A derivative is no finite number, however short the step."""

    __slots__ = ()
    _FIELDS = ("component",)

    @property
    def component(self) -> int:
        """The first such component."""
        return self._get("component")  # type: ignore[no-any-return]


class IntegrationOutcomeStepTooSmall(Record):
    """The error cannot be met by any step that the machine can tell from zero: a singularity or a jump."""

    __slots__ = ()
    _FIELDS = ("step",)

    @property
    def step(self) -> float:
        """The step that was tried last."""
        return self._get("step")  # type: ignore[no-any-return]


class IntegrationOutcomeStiff(Record):
    """The problem is stiff: steps are bounded by stability, not by accuracy. Only where the settings ask for the test."""

    __slots__ = ()
    _FIELDS = ("step_times_rate",)

    @property
    def step_times_rate(self) -> float:
        """Step times measured spectral radius."""
        return self._get("step_times_rate")  # type: ignore[no-any-return]


class IntegrationOutcomeTooManyEvaluations(Record):
    """As many evaluations as are allowed."""

    __slots__ = ()
    _FIELDS = ("limit",)

    @property
    def limit(self) -> int:
        """The limit."""
        return self._get("limit")  # type: ignore[no-any-return]


class InternalBalance(Result):
    """Weights outside moved inside."""

    __slots__ = ()
    _FIELDS = ("couple_left", "externals", "name", "planes", "reached", "static_left", "version",)

    @property
    def couple_left(self) -> FloatArray:
        """Couple unbalance about z = 0 that is left [kg m^2]."""
        return self._array("couple_left")  # type: ignore[no-any-return]

    @property
    def externals(self) -> Records[PlaneUnbalance]:
        """Weights that come off."""
        return self._all("externals", PlaneUnbalance)

    @property
    def name(self) -> str:
        """Name of the sheet."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def planes(self) -> Records[InternalPlane]:
        """The counterweights."""
        return self._all("planes", InternalPlane)

    @property
    def reached(self) -> bool:
        """Whether both have room for all that they need."""
        return self._get("reached")  # type: ignore[no-any-return]

    @property
    def static_left(self) -> FloatArray:
        """Static unbalance that is left where they have not [kg m]."""
        return self._array("static_left")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class InternalMoments(Record):
    """Shear forces and bending moments of all crankshafts at one speed."""

    __slots__ = ()
    _FIELDS = ("counterweights", "crankshafts", "period", "reciprocating_share", "speed", "theta", "version",)

    @property
    def counterweights(self) -> bool:
        """Whether the weights on the crankshafts count."""
        return self._get("counterweights")  # type: ignore[no-any-return]

    @property
    def crankshafts(self) -> Records[CrankshaftMoments]:
        """By crankshaft; one without throws is left out."""
        return self._all("crankshafts", CrankshaftMoments)

    @property
    def period(self) -> float:
        """Period [rad] of crankshaft 1."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def reciprocating_share(self) -> float:
        """Share of the reciprocating forces that counts."""
        return self._get("reciprocating_share")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle of crankshaft 1 [rad] of every trace, from 0, one period, end point excluded."""
        return self._array("theta")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class InternalPlane(Record):
    """One counterweight that takes slugs."""

    __slots__ = ()
    _FIELDS = ("name", "plan", "z",)

    @property
    def name(self) -> str:
        """Name of its plane."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def plan(self) -> SlugPlan:
        """The slugs."""
        return self._of("plan", SlugPlan)  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its plane [m]."""
        return self._get("z")  # type: ignore[no-any-return]


class InvalidCount(Record):
    """Cases of invalid geometry for one reason."""

    __slots__ = ()
    _FIELDS = ("cases", "reason",)

    @property
    def cases(self) -> int:
        """Cases."""
        return self._get("cases")  # type: ignore[no-any-return]

    @property
    def reason(self) -> Literal['rod-too-short', 'webs-overlap', 'bores-overlap']:
        """The reason."""
        return self._get("reason")  # type: ignore[no-any-return]


class JournalBearing(Record):
    """A plain cylindrical bearing."""

    __slots__ = ()
    _FIELDS = ("clearance", "length", "radius",)

    @property
    def clearance(self) -> float:
        """Radial clearance [m]: half the difference of the diameters."""
        return self._get("clearance")  # type: ignore[no-any-return]

    @property
    def length(self) -> float:
        """Length of the bearing along the axis [m]."""
        return self._get("length")  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Radius of the journal [m]."""
        return self._get("radius")  # type: ignore[no-any-return]


class JournalInFilm(Record):
    """A journal in its oil film, at rest."""

    __slots__ = ()
    _FIELDS = ("bearing", "contact_share", "eccentricity", "eccentricity_ratio", "force", "largest_pressure", "least_edge_film", "least_film", "shell",)

    @property
    def bearing(self) -> str:
        """Its bearing: "main bearing 2"."""
        return self._get("bearing")  # type: ignore[no-any-return]

    @property
    def contact_share(self) -> float:
        """Share of the force that touching roughness carries."""
        return self._get("contact_share")  # type: ignore[no-any-return]

    @property
    def eccentricity(self) -> FloatArray:
        """Journal's centre from that of its shell, in the same frame [m]."""
        return self._array("eccentricity")  # type: ignore[no-any-return]

    @property
    def eccentricity_ratio(self) -> float:
        """Its length over the radial clearance."""
        return self._get("eccentricity_ratio")  # type: ignore[no-any-return]

    @property
    def force(self) -> FloatArray:
        """Force of the film on the journal, in the frame of the crankshaft [N]."""
        return self._array("force")  # type: ignore[no-any-return]

    @property
    def largest_pressure(self) -> float:
        """Largest pressure of the film [Pa]."""
        return self._get("largest_pressure")  # type: ignore[no-any-return]

    @property
    def least_edge_film(self) -> float:
        """Least film at an end of the bearing by the slope of the journal there [m]: below 0 it touches. The film itself is that of parallel axes."""
        return self._get("least_edge_film")  # type: ignore[no-any-return]

    @property
    def least_film(self) -> float:
        """Least film at the middle of the bearing [m]."""
        return self._get("least_film")  # type: ignore[no-any-return]

    @property
    def shell(self) -> FloatArray:
        """Shell's centre from its place without load, by the stiffness of the housing [m]."""
        return self._array("shell")  # type: ignore[no-any-return]


class JudgedBy(Record):
    """An objective with its name and unit."""

    __slots__ = ()
    _FIELDS = ("name", "objective", "unit",)

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def objective(self) -> Objective:
        """The objective."""
        return self._of("objective", Objective)  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """Its unit, empty for a plain number."""
        return self._get("unit")  # type: ignore[no-any-return]


class JudgedCase(Record):
    """A judged case with its objectives."""

    __slots__ = ()
    _FIELDS = ("case", "values",)

    @property
    def case(self) -> int:
        """Its number in the space."""
        return self._get("case")  # type: ignore[no-any-return]

    @property
    def values(self) -> FloatArray:
        """Its objectives in the order of the request, in SI units."""
        return self._array("values")  # type: ignore[no-any-return]


class JudgedSpeeds(Record):
    """Speeds at which loads were judged that a higher speed need not raise: forces at mounts with springs, loads with gas."""

    __slots__ = ()
    _FIELDS = ("excess", "judged", "range", "weights", "worst",)

    @property
    def excess(self) -> float:
        """By how much a speed between passes the value, at most, as a share of it: what the search over the range left."""
        return self._get("excess")  # type: ignore[no-any-return]

    @property
    def judged(self) -> FloatArray:
        """Speeds of crankshaft 1 [rad/s] that hold the proof: over a range the ends, the resonances, some between and the worst of every round."""
        return self._array("judged")  # type: ignore[no-any-return]

    @property
    def range(self) -> bool:
        """Whether the whole range of the engine counts."""
        return self._get("range")  # type: ignore[no-any-return]

    @property
    def weights(self) -> FloatArray:
        """What loads at each of them are multiplied by before the largest counts; empty where nothing is."""
        return self._array("weights")  # type: ignore[no-any-return]

    @property
    def worst(self) -> float:
        """Speed [rad/s] at which the first of these criteria, times the weight of its speed, is largest with what was found."""
        return self._get("worst")  # type: ignore[no-any-return]


class Layout(Record):
    """A layout: one case of a space."""

    __slots__ = ()
    _FIELDS = ("banks", "case", "counterweights", "cylinders", "firing_angles", "rod_ratio", "shafts", "spacing", "throw_angles",)

    @property
    def banks(self) -> BankPair | None:
        """The two banks; `None` in line, and where cylinders stay where they are."""
        return self._of("banks", BankPair)  # type: ignore[no-any-return]

    @property
    def case(self) -> int:
        """Number of the case."""
        return self._get("case")  # type: ignore[no-any-return]

    @property
    def counterweights(self) -> CounterweightPattern:
        """Weights on the webs."""
        return self._of("counterweights", CounterweightPattern)  # type: ignore[no-any-return]

    @property
    def cylinders(self) -> int:
        """Cylinders: of two banks those of bank 1 first."""
        return self._get("cylinders")  # type: ignore[no-any-return]

    @property
    def firing_angles(self) -> FloatArray | None:
        """Crank angle [rad] in the cycle at which each cylinder fires, by its number; `None` where firing is left out."""
        return self._array("firing_angles")  # type: ignore[no-any-return]

    @property
    def rod_ratio(self) -> float:
        """Crank radius over rod length; the mean where rods stay what they are."""
        return self._get("rod_ratio")  # type: ignore[no-any-return]

    @property
    def shafts(self) -> ShaftSet:
        """Balance shafts."""
        return self._of("shafts", ShaftSet)  # type: ignore[no-any-return]

    @property
    def spacing(self) -> float:
        """Distance of neighbouring groups [m]; the mean where cylinders stay where they are."""
        return self._get("spacing")  # type: ignore[no-any-return]

    @property
    def throw_angles(self) -> FloatArray:
        """Angle of each group's throw (of split pins: of bank 1's) from the first [rad]."""
        return self._array("throw_angles")  # type: ignore[no-any-return]


class LayoutOrders(Record):
    """First- and second-order loads of a layout; index 0 is order 1, index 1 is order 2.

    As in `lanchester_results::OrderLoads`: force and couple are coefficients of `e^{i n theta}` (index 0, forward) and
    `e^{-i n theta}` (index 1, backward); the modulus of roll moment and torque is their amplitude.
    """

    __slots__ = ()
    _FIELDS = ("couple", "force", "roll_moment", "shaft_torque",)

    @property
    def couple(self) -> FloatArray:
        """Couple about the middle of the crankshaft [N m], by order and sense."""
        return self._array("couple")  # type: ignore[no-any-return]

    @property
    def force(self) -> FloatArray:
        """Force on the block [N], by order and sense."""
        return self._array("force")  # type: ignore[no-any-return]

    @property
    def roll_moment(self) -> FloatArray:
        """Roll moment by inertia [N m], by order."""
        return self._array("roll_moment")  # type: ignore[no-any-return]

    @property
    def shaft_torque(self) -> FloatArray:
        """Inertia torque at the crankshaft [N m], by order."""
        return self._array("shaft_torque")  # type: ignore[no-any-return]


class Leading(Record):
    """The order that most of a load is."""

    __slots__ = ()
    _FIELDS = ("forward", "order", "size",)

    @property
    def forward(self) -> float:
        """Share of it that turns with the crank, from 0 to 1."""
        return self._get("forward")  # type: ignore[no-any-return]

    @property
    def order(self) -> float:
        """Order."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def size(self) -> float:
        """Largest resultant of this order alone, in the unit of the load."""
        return self._get("size")  # type: ignore[no-any-return]


class LeastFilm(Record):
    """An oil film where it is thinnest over the cycle."""

    __slots__ = ()
    _FIELDS = ("at_ends", "below_roughness", "is_tilted", "largest_pressure", "quasi_static", "theta", "thickness", "viscosity",)

    @property
    def at_ends(self) -> float:
        """Least thickness at the ends of the bearing, with the slope of the journal [m]; below 0 the slope is more than a law allows that knows of no tilt, and one that knows of it lets the
        surfaces touch.
        """
        return self._get("at_ends")  # type: ignore[no-any-return]

    @property
    def below_roughness(self) -> float:
        """Share of the cycle in which the film is below three times the roughness [1]."""
        return self._get("below_roughness")  # type: ignore[no-any-return]

    @property
    def is_tilted(self) -> bool:
        """Whether the law knows of tilt."""
        return self._get("is_tilted")  # type: ignore[no-any-return]

    @property
    def largest_pressure(self) -> FloatArray | None:
        """Largest pressure [Pa] and its crank angle [rad]."""
        return self._array("largest_pressure")  # type: ignore[no-any-return]

    @property
    def quasi_static(self) -> float | None:
        """Least film of the rigid crankshaft, throw by throw, quasi-static [m]."""
        return self._get("quasi_static")  # type: ignore[no-any-return]

    @property
    def theta(self) -> float:
        """Crank angle there [rad]."""
        return self._get("theta")  # type: ignore[no-any-return]

    @property
    def thickness(self) -> float:
        """Thickness in the middle of the bearing; of a law that knows of tilt at its ends [m]."""
        return self._get("thickness")  # type: ignore[no-any-return]

    @property
    def viscosity(self) -> float:
        """Viscosity [Pa s]."""
        return self._get("viscosity")  # type: ignore[no-any-return]


class Limit(Record):
    """A criterion that must not pass a value."""

    __slots__ = ()
    _FIELDS = ("criterion", "most",)

    @property
    def criterion(self) -> Criterion:
        """What."""
        return self._of("criterion", Criterion)  # type: ignore[no-any-return]

    @property
    def most(self) -> float:
        """Largest value, in the criterion's SI unit."""
        return self._get("most")  # type: ignore[no-any-return]


class LimitVerdict(Record):
    """A limit, and whether the production keeps it."""

    __slots__ = ()
    _FIELDS = ("beyond", "cpk", "cpk_by_percentiles", "is_met", "limit", "output",)

    @property
    def beyond(self) -> int:
        """Samples beyond the limit."""
        return self._get("beyond")  # type: ignore[no-any-return]

    @property
    def cpk(self) -> float:
        """`(limit - mean) / (3 standard deviations)`: for a normal distribution."""
        return self._get("cpk")  # type: ignore[no-any-return]

    @property
    def cpk_by_percentiles(self) -> float:
        """`(limit - median) / (99.865 % percentile - median)`: for any distribution (ISO 22514-2)."""
        return self._get("cpk_by_percentiles")  # type: ignore[no-any-return]

    @property
    def is_met(self) -> bool:
        """Whether the capability by percentiles is the wanted one; without any scatter whether the engine keeps the limit."""
        return self._get("is_met")  # type: ignore[no-any-return]

    @property
    def limit(self) -> float:
        """The limit."""
        return self._get("limit")  # type: ignore[no-any-return]

    @property
    def output(self) -> Output:
        """On what."""
        return self._of("output", Output)  # type: ignore[no-any-return]


class Load(Variant):
    """A load over the cycle whose largest amount is judged; about the origin."""

    __slots__ = ()
    _FIELDS = ("kind", "mount_force", "mount_force_with_gas", "main_load",)

    @property
    def kind(self) -> Literal['force', 'force-x', 'force-y', 'couple', 'couple-x', 'couple-y', 'roll-moment', 'mount-force', 'largest-mount-force', 'mount-force-with-gas', 'largest-mount-force-with-gas', 'main-load', 'largest-main-load', 'bending-moment']:
        """Which of the variants it is.
        `force`: Resultant force `|F_x + i F_y|` [N].
        `force-x`: Force along x [N].
        `force-y`: Force along y [N].
        `couple`: Resultant couple `|M_x + i M_y|` [N m].
        `couple-x`: Couple about x [N m].
        `couple-y`: Couple about y [N m].
        `roll-moment`: Roll moment [N m].
        `largest-mount-force`: Largest force at any mount [N].
        `largest-mount-force-with-gas`: Largest such force at any mount [N].
        `largest-main-load`: Largest inertia load of any main bearing [N].
        `bending-moment`: Largest bending moment along crankshaft 1 [N m].
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def mount_force(self) -> int | None:
        """Force at one mount [N], by index."""
        return self._get("mount-force")  # type: ignore[no-any-return]

    @property
    def mount_force_with_gas(self) -> int | None:
        """Force at one mount [N], by index, of inertia and of the torque of the gas about its mean: on springs, over the range of
        speeds or at the speeds of the task.
        """
        return self._get("mount-force-with-gas")  # type: ignore[no-any-return]

    @property
    def main_load(self) -> int | None:
        """Inertia load of one main bearing [N], by index: those of crankshaft 1 first, each from the free end on
        (`main_bearings`). Every throw is held by the two main bearings beside it.
        """
        return self._get("main-load")  # type: ignore[no-any-return]


class LoadSet(Record):
    """Loads of the whole engine, of one kind of part, or of one cylinder."""

    __slots__ = ()
    _FIELDS = ("orders", "peaks", "trace",)

    @property
    def orders(self) -> Records[OrderLoads]:
        """By order, rising: all whole orders asked for, also the vanishing ones, and the fractions that geared crankshafts
        and shafts bring.
        """
        return self._all("orders", OrderLoads)

    @property
    def peaks(self) -> Peaks:
        """Extremes over the continuous angle (or over the grid, where one was asked for)."""
        return self._of("peaks", Peaks)  # type: ignore[no-any-return]

    @property
    def trace(self) -> Trace:
        """Over one period."""
        return self._of("trace", Trace)  # type: ignore[no-any-return]


class Loads(Result):
    """Loads with what they do inside the crankshafts."""

    __slots__ = ()
    _FIELDS = ("cylinders", "diagnosis", "engine", "internal", "kinematics", "motion", "parts", "period", "reference", "speed", "total", "version",)

    @property
    def cylinders(self) -> Records[CylinderLoads]:
        """By cylinder: its piston, rod and (shared among the rods of the throw) its share of the crank throw."""
        return self._all("cylinders", CylinderLoads)

    @property
    def diagnosis(self) -> Diagnosis:
        """What the spectrum means, in words."""
        return self._of("diagnosis", Diagnosis)  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def internal(self) -> Records[InternalMoments]:
        """Shear forces and bending moments inside the crankshafts: the case asked for, then those to compare it with. Computed when they
        are looked at.
        """
        return self._all("internal", InternalMoments)

    @property
    def kinematics(self) -> str:
        """Which motion was used: exact, or a truncated series."""
        return self._get("kinematics")  # type: ignore[no-any-return]

    @property
    def motion(self) -> Records[CylinderMotion]:
        """Motion of every cylinder."""
        return self._all("motion", CylinderMotion)

    @property
    def parts(self) -> Records[PartLoads]:
        """By kind of part, only the kinds that the engine has."""
        return self._all("parts", PartLoads)

    @property
    def period(self) -> float:
        """Period of the loads [rad] of crankshaft 1: 2 pi times a whole number."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def reference(self) -> FloatArray:
        """Point that couples and roll moment are about [m]: x, y, z in the frame."""
        return self._array("reference")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def total(self) -> LoadSet:
        """The whole engine."""
        return self._of("total", LoadSet)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class MainBearing(Record):
    """A main bearing."""

    __slots__ = ()
    _FIELDS = ("crankshaft", "journal_frame", "load", "main", "z",)

    @property
    def crankshaft(self) -> int:
        """Number of its crankshaft, from 1."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def journal_frame(self) -> FloatArray:
        """Bearing on the journal in the journal's frame: real part along throw 1 of its crankshaft, imaginary part a quarter turn on in
        the sense of increasing angles [N].
        """
        return self._array("journal_frame")  # type: ignore[no-any-return]

    @property
    def load(self) -> PinLoad:
        """Journal on the bearing, `x + i y` of the block's frame [N]."""
        return self._of("load", PinLoad)  # type: ignore[no-any-return]

    @property
    def main(self) -> int:
        """Its number on that crankshaft, from 1."""
        return self._get("main")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its plane [m], from the origin."""
        return self._get("z")  # type: ignore[no-any-return]


class MainLoad(Record):
    """A main bearing."""

    __slots__ = ()
    _FIELDS = ("largest", "load", "main", "z",)

    @property
    def largest(self) -> Extreme:
        """Largest load over the cycle [N]."""
        return self._of("largest", Extreme)  # type: ignore[no-any-return]

    @property
    def load(self) -> FloatArray:
        """Load of the shaft on the bearing `N_x + i N_y` [N] over the cycle."""
        return self._array("load")  # type: ignore[no-any-return]

    @property
    def main(self) -> int:
        """Its number from the free end, from 1."""
        return self._get("main")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its plane [m], from the origin."""
        return self._get("z")  # type: ignore[no-any-return]


class MainRules(Record):
    """Loads of the main bearings of the same crankshaft, rigid, at constant speed, by the rules of the simulation."""

    __slots__ = ()
    _FIELDS = ("loads", "names", "theta",)

    @property
    def loads(self) -> list[list[FloatArray]]:
        """By main bearing, then by rule: load of the journal on the bearing, `x` and `y` of the block [N], at every angle."""
        return self._as("loads", every(every(an_array)), [])  # type: ignore[no-any-return]

    @property
    def names(self) -> list[str]:
        """Names of the rules."""
        return self._list("names")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angles [rad]."""
        return self._array("theta")  # type: ignore[no-any-return]


class Mains(Variant):
    """Which main bearings count."""

    __slots__ = ()
    _FIELDS = ("kind", "one",)

    @property
    def kind(self) -> Literal['all', 'largest', 'one']:
        """Which of the variants it is.
        `all`: All of them together: the statistic is taken over bearings and cycle.
        `largest`: The one with the largest.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def one(self) -> int | None:
        """One, by index as in `MainLoad`."""
        return self._get("one")  # type: ignore[no-any-return]


class MassProperties(Record):
    """Mass properties of a solid."""

    __slots__ = ()
    _FIELDS = ("centre", "inertia_about_axis", "inertia_about_centre", "mass", "unbalance",)

    @property
    def centre(self) -> FloatArray:
        """Centre of mass [m]: in the plane as `Point`, and along the crank axis."""
        return self._array("centre")  # type: ignore[no-any-return]

    @property
    def inertia_about_axis(self) -> FloatArray:
        """Inertia tensor about the point of the crank axis at z = 0 [kg m^2]; the products stand with their minus sign."""
        return self._array("inertia_about_axis")  # type: ignore[no-any-return]

    @property
    def inertia_about_centre(self) -> FloatArray:
        """Inertia tensor about the centre of mass, along the same axes [kg m^2]."""
        return self._array("inertia_about_centre")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> Point:
        """Unbalance: mass times distance of its centre from the crank axis, as a vector [kg m]."""
        return self._of("unbalance", Point)  # type: ignore[no-any-return]


class Material(Record):
    """A linear elastic, isotropic material."""

    __slots__ = ()
    _FIELDS = ("density", "name", "poisson_ratio", "youngs_modulus",)

    @property
    def density(self) -> float:
        """Density [kg/m^3]."""
        return self._get("density")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def poisson_ratio(self) -> float:
        """Poisson's ratio."""
        return self._get("poisson_ratio")  # type: ignore[no-any-return]

    @property
    def youngs_modulus(self) -> float:
        """Young's modulus [Pa]."""
        return self._get("youngs_modulus")  # type: ignore[no-any-return]


class Measured(Record):
    """A criterion of an engine."""

    __slots__ = ()
    _FIELDS = ("kind", "left_out", "place", "speed", "value", "reason", "remedy",)

    @property
    def kind(self) -> Literal['known', 'unknown']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def left_out(self) -> str | None:
        """What it leaves out, and why; empty: nothing that others count."""
        return self._get("left_out")  # type: ignore[no-any-return]

    @property
    def place(self) -> str | None:
        """Which part has it: "main bearing 3", "pin 2 at web 3"."""
        return self._get("place")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float | None:
        """At which speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def value(self) -> float | None:
        """In the unit of the criterion."""
        return self._get("value")  # type: ignore[no-any-return]

    @property
    def reason(self) -> str | None:
        """What is missing or cannot be computed."""
        return self._get("reason")  # type: ignore[no-any-return]

    @property
    def remedy(self) -> str | None:
        """What would give it."""
        return self._get("remedy")  # type: ignore[no-any-return]


class MeshOrigins(Record):
    """Who says how fine a mesh is; a study of convergence refines it on."""

    __slots__ = ()
    _FIELDS = ("fillet_elements", "size",)

    @property
    def fillet_elements(self) -> Literal['usual', 'fitted', 'file', 'asked', 'asked-before-file']:
        """Of the elements across a fillet."""
        return self._get("fillet_elements")  # type: ignore[no-any-return]

    @property
    def size(self) -> Literal['usual', 'fitted', 'file', 'asked', 'asked-before-file']:
        """Of the size of the elements."""
        return self._get("size")  # type: ignore[no-any-return]


class MeshQuality(Record):
    """What a mesh is like."""

    __slots__ = ()
    _FIELDS = ("centre", "elements", "inertia", "largest_aspect", "least_angle", "least_jacobian", "mass", "nodes", "volume", "worst_element", "worst_place",)

    @property
    def centre(self) -> FloatArray:
        """Centre of mass [m]."""
        return self._array("centre")  # type: ignore[no-any-return]

    @property
    def elements(self) -> list[int]:
        """Elements: tetrahedra, wedges, hexahedra."""
        return self._list("elements")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> FloatArray:
        """Moments of inertia xx, yy, zz and products xy, yz, zx about the origin, `INT x y dm` with plus sign [kg m^2]."""
        return self._array("inertia")  # type: ignore[no-any-return]

    @property
    def largest_aspect(self) -> float:
        """Longest edge over the shortest one of the most stretched element."""
        return self._get("largest_aspect")  # type: ignore[no-any-return]

    @property
    def least_angle(self) -> float:
        """Smallest angle between two edges of a face at a corner [rad]."""
        return self._get("least_angle")  # type: ignore[no-any-return]

    @property
    def least_jacobian(self) -> float:
        """Smallest determinant of the Jacobian over its mean in the element, at nodes and integration points."""
        return self._get("least_jacobian")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def nodes(self) -> int:
        """Nodes."""
        return self._get("nodes")  # type: ignore[no-any-return]

    @property
    def volume(self) -> float:
        """Volume [m^3]."""
        return self._get("volume")  # type: ignore[no-any-return]

    @property
    def worst_element(self) -> int:
        """Number of that element, from 1."""
        return self._get("worst_element")  # type: ignore[no-any-return]

    @property
    def worst_place(self) -> FloatArray:
        """Its middle [m]."""
        return self._array("worst_place")  # type: ignore[no-any-return]


class MeshedThrow(Record):
    """Torsional stiffness of a throw by finite elements, between the middles of its journals."""

    __slots__ = ()
    _FIELDS = ("free", "held", "is_held", "throw",)

    @property
    def free(self) -> float:
        """With journals that may move aside [N m/rad]."""
        return self._get("free")  # type: ignore[no-any-return]

    @property
    def held(self) -> float:
        """With journals whose middles stay on the axis [N m/rad]."""
        return self._get("held")  # type: ignore[no-any-return]

    @property
    def is_held(self) -> bool:
        """Whether the chain has that of held journals."""
        return self._get("is_held")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int:
        """Number of the throw, from 1."""
        return self._get("throw")  # type: ignore[no-any-return]


class Method(Record):
    """How an optimum was found."""

    __slots__ = ()
    _FIELDS = ("kind", "solves", "nodes",)

    @property
    def kind(self) -> Literal['convex', 'branch-and-bound']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def solves(self) -> int:
        """Cone programmes solved."""
        return self._get("solves")  # type: ignore[no-any-return]

    @property
    def nodes(self) -> int | None:
        """Branch-and-bound nodes examined."""
        return self._get("nodes")  # type: ignore[no-any-return]


class Mode(Record):
    """A natural mode."""

    __slots__ = ()
    _FIELDS = ("frequency", "kind", "residual", "shape", "shares",)

    @property
    def frequency(self) -> float:
        """Natural frequency [Hz]."""
        return self._get("frequency")  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['rigid', 'bending-x', 'bending-y', 'torsion', 'axial', 'mixed']:
        """What mainly moves."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """`|K x - l M x|/|K x|`; of a rigid motion, whose `K x` is rounding, over `s |M x|`. No more than 1e-8, or than what rounding leaves: thin
        elements have a `K` of large numbers that cancel.
        """
        return self._get("residual")  # type: ignore[no-any-return]

    @property
    def shape(self) -> FloatArray:
        """Displacements of the nodes, of modal mass 1 kg."""
        return self._array("shape")  # type: ignore[no-any-return]

    @property
    def shares(self) -> FloatArray:
        """Shares of the kinetic energy: slices that move along x or tilt with it, the same along y, turning about z, moving along z; the rest deforms slices."""
        return self._array("shares")  # type: ignore[no-any-return]


class Mode2(Record):
    """A natural mode of the undamped chain."""

    __slots__ = ()
    _FIELDS = ("frequency", "inertia", "nodes", "shape",)

    @property
    def frequency(self) -> float:
        """Natural angular frequency [rad/s]."""
        return self._get("frequency")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> float:
        """Moment of inertia in this mode, of the shape as it stands [kg m^2]."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def nodes(self) -> int:
        """Nodes: changes of sign of the referred angle along the shafts."""
        return self._get("nodes")  # type: ignore[no-any-return]

    @property
    def shape(self) -> FloatArray:
        """Angles of the stations at their own speeds, the largest 1."""
        return self._array("shape")  # type: ignore[no-any-return]


class ModeCount(Record):
    """How many modes a body has, by the signs of a factor of `K - s M` (Sylvester's law of inertia)."""

    __slots__ = ()
    _FIELDS = ("below", "counted", "found",)

    @property
    def below(self) -> float:
        """Below this frequency [Hz]: in a gap between modes, above the highest one where there is one."""
        return self._get("below")  # type: ignore[no-any-return]

    @property
    def counted(self) -> int | None:
        """Modes there, rigid motions included; `None` where rounding leaves the count in doubt."""
        return self._get("counted")  # type: ignore[no-any-return]

    @property
    def found(self) -> int:
        """Modes found there, rigid motions included."""
        return self._get("found")  # type: ignore[no-any-return]


class ModeSolution(Record):
    """Modes of a mesh."""

    __slots__ = ()
    _FIELDS = ("basis", "coarse_mass", "count", "factor_entries", "factor_operations", "modes", "shift", "unknowns",)

    @property
    def basis(self) -> int:
        """Vectors of the Lanczos basis."""
        return self._get("basis")  # type: ignore[no-any-return]

    @property
    def coarse_mass(self) -> bool:
        """Whether the mass is that of CalculiX, integrated with the rule of the stiffness."""
        return self._get("coarse_mass")  # type: ignore[no-any-return]

    @property
    def count(self) -> ModeCount | None:
        """With modes counted: how many there are."""
        return self._of("count", ModeCount)  # type: ignore[no-any-return]

    @property
    def factor_entries(self) -> int:
        """Entries of the factor."""
        return self._get("factor_entries")  # type: ignore[no-any-return]

    @property
    def factor_operations(self) -> float:
        """Floating-point operations of the factor."""
        return self._get("factor_operations")  # type: ignore[no-any-return]

    @property
    def modes(self) -> Records[Mode]:
        """Modes, the lowest first."""
        return self._all("modes", Mode)

    @property
    def shift(self) -> float:
        """The shift `s` [1/s^2]."""
        return self._get("shift")  # type: ignore[no-any-return]

    @property
    def unknowns(self) -> int:
        """Unknowns."""
        return self._get("unknowns")  # type: ignore[no-any-return]


class MotionTrace(Record):
    """Motion of a piston and its rod over the crank angle, at the angles of the loads' `Trace`."""

    __slots__ = ()
    _FIELDS = ("acceleration", "position", "rod_angle", "theta", "velocity",)

    @property
    def acceleration(self) -> FloatArray:
        """Acceleration of the piston away from the crankshaft [m/s^2], of the kinematics asked for."""
        return self._array("acceleration")  # type: ignore[no-any-return]

    @property
    def position(self) -> FloatArray:
        """Distance `s` of the piston pin from the crankshaft's axis along the cylinder [m], always exact."""
        return self._array("position")  # type: ignore[no-any-return]

    @property
    def rod_angle(self) -> FloatArray:
        """Angle `beta` of the rod from the cylinder axis [rad], positive where its big end stands towards +v; always
        exact.
        """
        return self._array("rod_angle")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle of crankshaft 1 [rad], from 0, one period of the loads, end point excluded."""
        return self._array("theta")  # type: ignore[no-any-return]

    @property
    def velocity(self) -> FloatArray:
        """Velocity of the piston away from the crankshaft [m/s], of the kinematics asked for."""
        return self._array("velocity")  # type: ignore[no-any-return]


class MountAtRest(Record):
    """One mount at rest. Forces are those of the block on the mount."""

    __slots__ = ()
    _FIELDS = ("deflection", "force", "gravity", "name", "own_deflection", "own_force", "preload", "torque",)

    @property
    def deflection(self) -> FloatArray:
        """Deflection [m]."""
        return self._array("deflection")  # type: ignore[no-any-return]

    @property
    def force(self) -> FloatArray:
        """Force [N]: the sum of the three shares."""
        return self._array("force")  # type: ignore[no-any-return]

    @property
    def gravity(self) -> FloatArray:
        """Share of gravity [N]."""
        return self._array("gravity")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def own_deflection(self) -> FloatArray:
        """Deflection along the mount's own three directions [m]."""
        return self._array("own_deflection")  # type: ignore[no-any-return]

    @property
    def own_force(self) -> FloatArray:
        """The force along the mount's own three directions [N]."""
        return self._array("own_force")  # type: ignore[no-any-return]

    @property
    def preload(self) -> FloatArray:
        """Share of the preloads of all mounts [N]."""
        return self._array("preload")  # type: ignore[no-any-return]

    @property
    def torque(self) -> FloatArray:
        """Share of the driveline's torque [N]."""
        return self._array("torque")  # type: ignore[no-any-return]


class MountMode(Record):
    """One undamped mode."""

    __slots__ = ()
    _FIELDS = ("angular_frequency", "coupling", "energy", "main", "mount_energy", "shape",)

    @property
    def angular_frequency(self) -> float:
        """Natural angular frequency [rad/s]. With a table of stiffness over frequency it is the one at which the stiffness is
        that of the table there.
        """
        return self._get("angular_frequency")  # type: ignore[no-any-return]

    @property
    def coupling(self) -> float:
        """What is not in that coordinate: 1 minus its share."""
        return self._get("coupling")  # type: ignore[no-any-return]

    @property
    def energy(self) -> FloatArray:
        """Share of the kinetic energy in each coordinate; they add up to 1. One can be negative where a product of inertia
        couples two rotations.
        """
        return self._array("energy")  # type: ignore[no-any-return]

    @property
    def main(self) -> int:
        """Coordinate with the largest share, an index into `COORDINATES`."""
        return self._get("main")  # type: ignore[no-any-return]

    @property
    def mount_energy(self) -> FloatArray:
        """Share of the elastic energy in each mount; they add up to 1."""
        return self._array("mount_energy")  # type: ignore[no-any-return]

    @property
    def shape(self) -> FloatArray:
        """Shape: displacement of the centre [m] and rotation [rad], with `shape^T M shape = 1 kg m^2`; its largest energy
        share moves in the positive sense.
        """
        return self._array("shape")  # type: ignore[no-any-return]


class MountModes(Record):
    """Rigid-body modes of the block."""

    __slots__ = ()
    _FIELDS = ("damped", "modes", "stiffness_centre", "torque_roll_axis",)

    @property
    def damped(self) -> Records[DampedMode]:
        """Damped modes, rising by `|root|`. More than six where some are overdamped."""
        return self._all("damped", DampedMode)

    @property
    def modes(self) -> Records[MountMode]:
        """Undamped modes, rising."""
        return self._all("modes", MountMode)

    @property
    def stiffness_centre(self) -> StiffnessCentre:
        """Centre of stiffness of the mounts at rest."""
        return self._of("stiffness_centre", StiffnessCentre)  # type: ignore[no-any-return]

    @property
    def torque_roll_axis(self) -> AxisLine:
        """Line about which the free block turns under a torque about z: the torque-roll axis."""
        return self._of("torque_roll_axis", AxisLine)  # type: ignore[no-any-return]


class MountResponse(Record):
    """Forces at the mounts and motion of the block against speed, by order."""

    __slots__ = ()
    _FIELDS = ("beyond_table", "centre", "mounts", "speeds", "version",)

    @property
    def beyond_table(self) -> Records[BeyondTable]:
        """Mounts whose table of stiffness does not reach all frequencies of the excitation."""
        return self._all("beyond_table", BeyondTable)

    @property
    def centre(self) -> FloatArray:
        """The block's centre [m]."""
        return self._array("centre")  # type: ignore[no-any-return]

    @property
    def mounts(self) -> list[str]:
        """Names of the mounts."""
        return self._list("mounts")  # type: ignore[no-any-return]

    @property
    def speeds(self) -> Records[SpeedResponse]:
        """One entry a speed, as they were asked for."""
        return self._all("speeds", SpeedResponse)

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class MountStatics(Record):
    """The block at rest under gravity and mean torque."""

    __slots__ = ()
    _FIELDS = ("motion", "mounts",)

    @property
    def motion(self) -> FloatArray:
        """Displacement of the centre [m] and rotation [rad] from the position of the file."""
        return self._array("motion")  # type: ignore[no-any-return]

    @property
    def mounts(self) -> Records[MountAtRest]:
        """One entry a mount."""
        return self._all("mounts", MountAtRest)


class MountStudy(Result):
    """All that is told of an engine on its mounts."""

    __slots__ = ()
    _FIELDS = ("at_rest", "body", "engine", "excitation", "modes", "points", "response", "rotor_effects", "rotors", "transmissibility", "version", "warnings",)

    @property
    def at_rest(self) -> MountStatics:
        """At rest."""
        return self._of("at_rest", MountStatics)  # type: ignore[no-any-return]

    @property
    def body(self) -> MountedBody:
        """The body that moves."""
        return self._of("body", MountedBody)  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def excitation(self) -> str:
        """What shakes it, in words."""
        return self._get("excitation")  # type: ignore[no-any-return]

    @property
    def modes(self) -> MountModes:
        """Natural motions."""
        return self._of("modes", MountModes)  # type: ignore[no-any-return]

    @property
    def points(self) -> Records[PointMotion]:
        """Motion of the points asked for, against speed, by order."""
        return self._all("points", PointMotion)

    @property
    def response(self) -> MountResponse:
        """Against speed, by order."""
        return self._of("response", MountResponse)  # type: ignore[no-any-return]

    @property
    def rotor_effects(self) -> RotorEffects:
        """What of them acts on the motion."""
        return self._of("rotor_effects", RotorEffects)  # type: ignore[no-any-return]

    @property
    def rotors(self) -> float:
        """Angular momentum of all rotors whose inertia is known over the speed of crankshaft 1 [kg m^2]."""
        return self._get("rotors")  # type: ignore[no-any-return]

    @property
    def transmissibility(self) -> Transmissibility:
        """What all mounts together pass on, against frequency."""
        return self._of("transmissibility", Transmissibility)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def warnings(self) -> list[str]:
        """What the user should know of that."""
        return self._list("warnings")  # type: ignore[no-any-return]


class MountedBody(Record):
    """The body that moves: the file's block, with pistons and rods where they are to be added."""

    __slots__ = ()
    _FIELDS = ("added_mass", "centre", "inertia", "mass",)

    @property
    def added_mass(self) -> float:
        """Of it pistons and rods that were added [kg]."""
        return self._get("added_mass")  # type: ignore[no-any-return]

    @property
    def centre(self) -> FloatArray:
        """Centre of mass [m]."""
        return self._array("centre")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> FloatArray:
        """Inertia tensor about the centre [kg m^2]."""
        return self._array("inertia")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]


class Nearest(Record):
    """The best where nobody reaches the limit."""

    __slots__ = ()
    _FIELDS = ("arrangement", "reason", "residual", "spacing",)

    @property
    def arrangement(self) -> int:
        """Index of the arrangement there."""
        return self._get("arrangement")  # type: ignore[no-any-return]

    @property
    def reason(self) -> str:
        """How close it comes, in words."""
        return self._get("reason")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """What it leaves, in the criterion's SI unit."""
        return self._get("residual")  # type: ignore[no-any-return]

    @property
    def spacing(self) -> int:
        """Index of its spacing."""
        return self._get("spacing")  # type: ignore[no-any-return]


class NearestLimit(Record):
    """A limit that would have to give way, with the value at which a design exists."""

    __slots__ = ()
    _FIELDS = ("asked", "limit", "nearest",)

    @property
    def asked(self) -> float:
        """Its value in the task [SI]."""
        return self._get("asked")  # type: ignore[no-any-return]

    @property
    def limit(self) -> Literal['mass', 'swept-radius', 'inertia', 'thickness', 'half-width', 'balance']:
        """Which limit."""
        return self._get("limit")  # type: ignore[no-any-return]

    @property
    def nearest(self) -> float:
        """The nearest that can be met [SI]."""
        return self._get("nearest")  # type: ignore[no-any-return]


class NextStep(Record):
    """What to do next."""

    __slots__ = ()
    _FIELDS = ("kind", "planes",)

    @property
    def kind(self) -> Literal['try', 'settle', 'correct', 'finished']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def planes(self) -> list[str]:
        """Names of the planes."""
        return self._list("planes")  # type: ignore[no-any-return]


class NominalBore(Record):
    """Alternating loads and nominal stresses of the pin at its oil bore."""

    __slots__ = ()
    _FIELDS = ("modulus", "moment", "sigma", "tau",)

    @property
    def modulus(self) -> float:
        """Section modulus of the bored pin [m^3]."""
        return self._get("modulus")  # type: ignore[no-any-return]

    @property
    def moment(self) -> float:
        """Bending moment in the plane of the bore's mouth, in the middle of the pin [N m]."""
        return self._get("moment")  # type: ignore[no-any-return]

    @property
    def sigma(self) -> float:
        """Nominal bending stress [Pa]."""
        return self._get("sigma")  # type: ignore[no-any-return]

    @property
    def tau(self) -> float:
        """Nominal torsional stress [Pa]."""
        return self._get("tau")  # type: ignore[no-any-return]


class NominalWeb(Record):
    """Alternating loads and nominal stresses of a web with its pin and journal."""

    __slots__ = ()
    _FIELDS = ("area", "journal_tau", "journal_torque", "modulus", "moment", "pin_tau", "pin_torque", "shear", "sigma_b", "sigma_q",)

    @property
    def area(self) -> float:
        """Its cross section, B W [m^2]."""
        return self._get("area")  # type: ignore[no-any-return]

    @property
    def journal_tau(self) -> float:
        """Nominal torsional stress of the journal [Pa]."""
        return self._get("journal_tau")  # type: ignore[no-any-return]

    @property
    def journal_torque(self) -> float:
        """Torque in the journal, with that of torsional vibration [N m]."""
        return self._get("journal_torque")  # type: ignore[no-any-return]

    @property
    def modulus(self) -> float:
        """Section modulus of the web, B W^2/6 [m^3]."""
        return self._get("modulus")  # type: ignore[no-any-return]

    @property
    def moment(self) -> float:
        """Bending moment of the radial force in the middle of the web [N m]."""
        return self._get("moment")  # type: ignore[no-any-return]

    @property
    def pin_tau(self) -> float:
        """Nominal torsional stress of the pin [Pa]."""
        return self._get("pin_tau")  # type: ignore[no-any-return]

    @property
    def pin_torque(self) -> float:
        """Torque in the pin: the larger one of its two sides, with that of torsional vibration [N m]."""
        return self._get("pin_torque")  # type: ignore[no-any-return]

    @property
    def shear(self) -> float:
        """Radial force in the web [N]."""
        return self._get("shear")  # type: ignore[no-any-return]

    @property
    def sigma_b(self) -> float:
        """Nominal bending stress of the web [Pa]."""
        return self._get("sigma_b")  # type: ignore[no-any-return]

    @property
    def sigma_q(self) -> float:
        """Nominal stress of the radial force [Pa]."""
        return self._get("sigma_q")  # type: ignore[no-any-return]


class Objective(Variant):
    """A number of which less is better. Loads are those on the block without gas, at the speed of the parts; the residual
    of the layout's own counterweights and balance shafts.
    """

    __slots__ = ()
    _FIELDS = ("kind", "force", "couple", "force_sense", "couple_sense", "roll_moment", "inertia_torque", "firing_harmonic",)

    @property
    def kind(self) -> Literal['force', 'couple', 'force-sense', 'couple-sense', 'roll-moment', 'inertia-torque', 'bending-moment', 'main-load', 'firing-unevenness', 'firing-harmonic', 'neighbour-firings', 'length', 'height', 'counterweight-unbalance', 'shafts']:
        """Which of the variants it is.
        `bending-moment`: Largest bending moment along the crank by the parts that turn with it, as a free beam on its end mains [N m].
        `main-load`: Largest load on a main bearing by the parts that turn with the crank, each throw held by its own two mains [N].
        `firing-unevenness`: Largest difference of a firing interval from the even one [rad].
        `neighbour-firings`: Successive firings of cylinders that stand side by side in one bank.
        `length`: Length [m]: distance of the outermost cylinder axes and the ends.
        `height`: Height [m]: crank radius and rod length.
        `counterweight-unbalance`: Counterweights on the webs, sum of their unbalances [kg m].
        `shafts`: Number of balance shafts.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def force(self) -> ObjectiveForce | None:
        """Largest resultant of the force of an order [N]: major half axis of its ellipse."""
        return self._of("force", ObjectiveForce)  # type: ignore[no-any-return]

    @property
    def couple(self) -> ObjectiveCouple | None:
        """Largest resultant of the couple of an order about the middle of the crankshaft [N m]."""
        return self._of("couple", ObjectiveCouple)  # type: ignore[no-any-return]

    @property
    def force_sense(self) -> ObjectiveForceSense | None:
        """Part of the force of an order that turns in one sense [N]."""
        return self._of("force-sense", ObjectiveForceSense)  # type: ignore[no-any-return]

    @property
    def couple_sense(self) -> ObjectiveCoupleSense | None:
        """Part of the couple of an order that turns in one sense [N m]."""
        return self._of("couple-sense", ObjectiveCoupleSense)  # type: ignore[no-any-return]

    @property
    def roll_moment(self) -> ObjectiveRollMoment | None:
        """Amplitude of the roll moment of an order by inertia [N m]."""
        return self._of("roll-moment", ObjectiveRollMoment)  # type: ignore[no-any-return]

    @property
    def inertia_torque(self) -> ObjectiveInertiaTorque | None:
        """Amplitude of the inertia torque of an order [N m]."""
        return self._of("inertia-torque", ObjectiveInertiaTorque)  # type: ignore[no-any-return]

    @property
    def firing_harmonic(self) -> ObjectiveFiringHarmonic | None:
        """Harmonic of the firing pulses, over that of pulses that all come together: `|SUM e^{i h angle / 2}| / cylinders`,
        the factor by which it takes the gas torque's harmonic of one cylinder to that of the engine.
        """
        return self._of("firing-harmonic", ObjectiveFiringHarmonic)  # type: ignore[no-any-return]


class ObjectiveCouple(Record):
    """Largest resultant of the couple of an order about the middle of the crankshaft [N m]."""

    __slots__ = ()
    _FIELDS = ("order",)

    @property
    def order(self) -> int:
        """Order: 1 or 2."""
        return self._get("order")  # type: ignore[no-any-return]


class ObjectiveCoupleSense(Record):
    """Part of the couple of an order that turns in one sense [N m]."""

    __slots__ = ()
    _FIELDS = ("order", "sense",)

    @property
    def order(self) -> int:
        """Order: 1 or 2."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def sense(self) -> Literal['forward', 'backward']:
        """Sense."""
        return self._get("sense")  # type: ignore[no-any-return]


class ObjectiveFiringHarmonic(Record):
    """Harmonic of the firing pulses, over that of pulses that all come together: `|SUM e^{i h angle / 2}| / cylinders`,
    the factor by which it takes the gas torque's harmonic of one cylinder to that of the engine.
    """

    __slots__ = ()
    _FIELDS = ("half_orders",)

    @property
    def half_orders(self) -> int:
        """Order in half cycles per revolution: 1 is order 0.5."""
        return self._get("half_orders")  # type: ignore[no-any-return]


class ObjectiveForce(Record):
    """Largest resultant of the force of an order [N]: major half axis of its ellipse."""

    __slots__ = ()
    _FIELDS = ("order",)

    @property
    def order(self) -> int:
        """Order: 1 or 2."""
        return self._get("order")  # type: ignore[no-any-return]


class ObjectiveForceSense(Record):
    """Part of the force of an order that turns in one sense [N]."""

    __slots__ = ()
    _FIELDS = ("order", "sense",)

    @property
    def order(self) -> int:
        """Order: 1 or 2."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def sense(self) -> Literal['forward', 'backward']:
        """Sense."""
        return self._get("sense")  # type: ignore[no-any-return]


class ObjectiveInertiaTorque(Record):
    """Amplitude of the inertia torque of an order [N m]."""

    __slots__ = ()
    _FIELDS = ("order",)

    @property
    def order(self) -> int:
        """Order: 1 or 2."""
        return self._get("order")  # type: ignore[no-any-return]


class ObjectiveRollMoment(Record):
    """Amplitude of the roll moment of an order by inertia [N m]."""

    __slots__ = ()
    _FIELDS = ("order",)

    @property
    def order(self) -> int:
        """Order: 1 or 2."""
        return self._get("order")  # type: ignore[no-any-return]


class Obstacle(Record):
    """What a counterweight or web must stay clear of. Cylinders count from 1."""

    __slots__ = ()
    _FIELDS = ("kind", "cylinder",)

    @property
    def kind(self) -> Literal['crankcase', 'piston', 'liner', 'rod', 'big-end-side']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def cylinder(self) -> int | None:
        """Its cylinder."""
        return self._get("cylinder")  # type: ignore[no-any-return]


class Obstruction(Record):
    """Why orders cannot vanish."""

    __slots__ = ()
    _FIELDS = ("functional", "reason",)

    @property
    def functional(self) -> Functional:
        """The proof: this functional is 1 with or without the devices, and would be 0 or less if the orders vanished."""
        return self._of("functional", Functional)  # type: ignore[no-any-return]

    @property
    def reason(self) -> str:
        """In words, with numbers and units."""
        return self._get("reason")  # type: ignore[no-any-return]


class Occasion(Record):
    """What may happen."""

    __slots__ = ()
    _FIELDS = ("index", "kind",)

    @property
    def index(self) -> int | None:
        """Place in the list."""
        return self._get("index")  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['event', 'starter-off', 'reversed', 'held', 'released']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]


class OilFactors(Record):
    """Factors of an oil bore [1]."""

    __slots__ = ()
    _FIELDS = ("gamma_b", "gamma_t",)

    @property
    def gamma_b(self) -> float:
        """Bending."""
        return self._get("gamma_b")  # type: ignore[no-any-return]

    @property
    def gamma_t(self) -> float:
        """Torsion."""
        return self._get("gamma_t")  # type: ignore[no-any-return]


class Optimum(Record):
    """The best design and its proof."""

    __slots__ = ()
    _FIELDS = ("bound", "boxes", "design", "objective", "proved", "value", "version",)

    @property
    def bound(self) -> float:
        """What no design can get below, rounding apart [SI]; zero where the proof was stopped before its end."""
        return self._get("bound")  # type: ignore[no-any-return]

    @property
    def boxes(self) -> int:
        """Boxes of the search."""
        return self._get("boxes")  # type: ignore[no-any-return]

    @property
    def design(self) -> Design:
        """The design."""
        return self._of("design", Design)  # type: ignore[no-any-return]

    @property
    def objective(self) -> Literal['mass', 'swept-radius', 'inertia', 'thickness']:
        """What was made small."""
        return self._get("objective")  # type: ignore[no-any-return]

    @property
    def proved(self) -> bool:
        """Whether every box of the search was refuted."""
        return self._get("proved")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """Its value of the objective [SI]."""
        return self._get("value")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class OrderLoads(Record):
    """One order of the loads.

    `F_x + i F_y = SUM over orders ( force_forward e^{i n theta} + force_backward e^{-i n theta} )`, the couple
    `M_x + i M_y` alike; order 0 has its whole mean in `*_forward`. Roll moment and torque are
    `Re( SUM roll_moment e^{i n theta} )`: their modulus is the amplitude.
    """

    __slots__ = ()
    _FIELDS = ("couple_backward", "couple_forward", "force_backward", "force_forward", "order", "roll_moment", "shaft_torque",)

    @property
    def couple_backward(self) -> FloatArray:
        """Part of the couple that turns against the crank [N m]."""
        return self._array("couple_backward")  # type: ignore[no-any-return]

    @property
    def couple_forward(self) -> FloatArray:
        """Part of the couple that turns with the crank [N m]."""
        return self._array("couple_forward")  # type: ignore[no-any-return]

    @property
    def force_backward(self) -> FloatArray:
        """Part of the force that turns against the crank [N]."""
        return self._array("force_backward")  # type: ignore[no-any-return]

    @property
    def force_forward(self) -> FloatArray:
        """Part of the force that turns with the crank [N]."""
        return self._array("force_forward")  # type: ignore[no-any-return]

    @property
    def order(self) -> float:
        """Order: cycles per revolution of crankshaft 1, not negative; fractions come from geared crankshafts."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def roll_moment(self) -> FloatArray:
        """Roll moment [N m], modulus = amplitude."""
        return self._array("roll_moment")  # type: ignore[no-any-return]

    @property
    def shaft_torque(self) -> FloatArray:
        """Shaft torque [N m], modulus = amplitude."""
        return self._array("shaft_torque")  # type: ignore[no-any-return]


class OrderResponse(Record):
    """Response to one order at one speed."""

    __slots__ = ()
    _FIELDS = ("forces", "load", "motion", "order", "stiff_forces", "transmitted",)

    @property
    def forces(self) -> FloatArray:
        """Force of the block on each mount [N]."""
        return self._array("forces")  # type: ignore[no-any-return]

    @property
    def load(self) -> FloatArray:
        """Load on the block: force [N] and moment about its centre [N m]."""
        return self._array("load")  # type: ignore[no-any-return]

    @property
    def motion(self) -> FloatArray:
        """Displacement of the centre [m] and rotation [rad]."""
        return self._array("motion")  # type: ignore[no-any-return]

    @property
    def order(self) -> float:
        """Order."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def stiff_forces(self) -> FloatArray:
        """The same if the mounts were stiff, in the proportions of their static stiffness: the load shared as at rest [N]."""
        return self._array("stiff_forces")  # type: ignore[no-any-return]

    @property
    def transmitted(self) -> FloatArray:
        """All mounts together: force [N] and moment about the block's centre [N m]."""
        return self._array("transmitted")  # type: ignore[no-any-return]


class OrderStar(Record):
    """Star of an order: equal torques of all cylinders, in the phases of their firings, times the amplitudes of a mode at their throws."""

    __slots__ = ()
    _FIELDS = ("order", "rigid_sum", "sums", "vectors",)

    @property
    def order(self) -> float:
        """The order."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def rigid_sum(self) -> float:
        """Length of the sum of the vectors as they are: what a rigid crankshaft feels."""
        return self._get("rigid_sum")  # type: ignore[no-any-return]

    @property
    def sums(self) -> FloatArray:
        """For each mode the length of the sum of the vectors times the amplitudes at their throws, the largest throw's 1."""
        return self._array("sums")  # type: ignore[no-any-return]

    @property
    def vectors(self) -> FloatArray:
        """One vector for each cylinder, of length 1: real part along cylinder 1."""
        return self._array("vectors")  # type: ignore[no-any-return]


class Outcome(Record):
    """Whether there is an optimum."""

    __slots__ = ()
    _FIELDS = ("kind", "closest", "reason", "relaxation", "cause",)

    @property
    def kind(self) -> Literal['optimal', 'infeasible', 'cannot-vanish', 'stopped']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def closest(self) -> FloatArray:
        """The smallest value that each limited criterion can reach if the other limits are dropped, in the order of
        the task's limits.
        """
        return self._array("closest")  # type: ignore[no-any-return]

    @property
    def reason(self) -> str | None:
        """Why, in words."""
        return self._get("reason")  # type: ignore[no-any-return]

    @property
    def relaxation(self) -> float | None:
        """How far every limit must be relaxed together, as a factor of it, until they can just be reached; above 1."""
        return self._get("relaxation")  # type: ignore[no-any-return]

    @property
    def cause(self) -> Literal['max-nodes', 'time-limit', 'cancelled', 'rounding'] | None:
        """Why."""
        return self._get("cause")  # type: ignore[no-any-return]


class Output(Variant):
    """A residual load whose scatter is asked for: a size, 0 being best."""

    __slots__ = ()
    _FIELDS = ("kind", "force", "couple", "force_sense", "couple_sense",)

    @property
    def kind(self) -> Literal['force', 'couple', 'force-sense', 'couple-sense', 'peak-force', 'peak-couple']:
        """Which of the variants it is.
        `peak-force`: Largest resultant force of all orders, over the continuous crank angle [N].
        `peak-couple`: Largest resultant couple of all orders, over the continuous crank angle [N m].
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def force(self) -> OutputForce | None:
        """Largest resultant of the force of order 1 or 2 [N]."""
        return self._of("force", OutputForce)  # type: ignore[no-any-return]

    @property
    def couple(self) -> OutputCouple | None:
        """Largest resultant of the couple of order 1 or 2 about the origin [N m]."""
        return self._of("couple", OutputCouple)  # type: ignore[no-any-return]

    @property
    def force_sense(self) -> OutputForceSense | None:
        """Part of the force of order 1 or 2 that turns in one sense [N]."""
        return self._of("force-sense", OutputForceSense)  # type: ignore[no-any-return]

    @property
    def couple_sense(self) -> OutputCoupleSense | None:
        """Part of the couple of order 1 or 2 that turns in one sense [N m]."""
        return self._of("couple-sense", OutputCoupleSense)  # type: ignore[no-any-return]


class OutputCouple(Record):
    """Largest resultant of the couple of order 1 or 2 about the origin [N m]."""

    __slots__ = ()
    _FIELDS = ("order",)

    @property
    def order(self) -> int:
        """Order."""
        return self._get("order")  # type: ignore[no-any-return]


class OutputCoupleSense(Record):
    """Part of the couple of order 1 or 2 that turns in one sense [N m]."""

    __slots__ = ()
    _FIELDS = ("order", "sense",)

    @property
    def order(self) -> int:
        """Order."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def sense(self) -> Literal['forward', 'backward']:
        """Sense."""
        return self._get("sense")  # type: ignore[no-any-return]


class OutputForce(Record):
    """Largest resultant of the force of order 1 or 2 [N]."""

    __slots__ = ()
    _FIELDS = ("order",)

    @property
    def order(self) -> int:
        """Order."""
        return self._get("order")  # type: ignore[no-any-return]


class OutputForceSense(Record):
    """Part of the force of order 1 or 2 that turns in one sense [N]."""

    __slots__ = ()
    _FIELDS = ("order", "sense",)

    @property
    def order(self) -> int:
        """Order."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def sense(self) -> Literal['forward', 'backward']:
        """Sense."""
        return self._get("sense")  # type: ignore[no-any-return]


class OutputScatter(Record):
    """Scatter of one output."""

    __slots__ = ()
    _FIELDS = ("capabilities", "contributions", "deviation", "least", "mean", "most", "most_sample", "nominal", "output", "percentile_error", "percentiles",)

    @property
    def capabilities(self) -> Records[Capability]:
        """Against its limits, in the order of the request."""
        return self._all("capabilities", Capability)

    @property
    def contributions(self) -> Records[Contribution]:
        """Which tolerance the scatter comes from, in the order of the request."""
        return self._all("contributions", Contribution)

    @property
    def deviation(self) -> float:
        """Standard deviation."""
        return self._get("deviation")  # type: ignore[no-any-return]

    @property
    def least(self) -> float:
        """Smallest of the samples."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def mean(self) -> float:
        """Mean."""
        return self._get("mean")  # type: ignore[no-any-return]

    @property
    def most(self) -> float:
        """Largest of the samples."""
        return self._get("most")  # type: ignore[no-any-return]

    @property
    def most_sample(self) -> int:
        """Number of the sample that has it, from 0."""
        return self._get("most_sample")  # type: ignore[no-any-return]

    @property
    def nominal(self) -> float:
        """Of the nominal engine."""
        return self._get("nominal")  # type: ignore[no-any-return]

    @property
    def output(self) -> Output:
        """Which."""
        return self._of("output", Output)  # type: ignore[no-any-return]

    @property
    def percentile_error(self) -> float:
        """Largest relative error of the percentiles: 0 where all samples were kept."""
        return self._get("percentile_error")  # type: ignore[no-any-return]

    @property
    def percentiles(self) -> Records[Percentile]:
        """Percentiles in the order of the request."""
        return self._all("percentiles", Percentile)


class OutputSensitivity(Record):
    """Sensitivities of one output."""

    __slots__ = ()
    _FIELDS = ("effects", "name", "nominal", "part", "size", "target", "unit",)

    @property
    def effects(self) -> Records[Effect2]:
        """By input."""
        return self._all("effects", Effect2)

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def nominal(self) -> float:
        """Of the nominal engine."""
        return self._get("nominal")  # type: ignore[no-any-return]

    @property
    def part(self) -> Literal['all', 'gas', 'inertia']:
        """Which loads count; force, couple and roll moment are those of inertia."""
        return self._get("part")  # type: ignore[no-any-return]

    @property
    def size(self) -> Size:
        """Which number of it."""
        return self._of("size", Size)  # type: ignore[no-any-return]

    @property
    def target(self) -> Target:
        """Of what."""
        return self._of("target", Target)  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """Its unit."""
        return self._get("unit")  # type: ignore[no-any-return]


class Overlap(Record):
    """Two bodies that overlap."""

    __slots__ = ()
    _FIELDS = ("along", "angles", "depth", "depth_bound",)

    @property
    def along(self) -> Literal['cylinder', 'crank', 'radius']:
        """In which direction."""
        return self._get("along")  # type: ignore[no-any-return]

    @property
    def angles(self) -> FloatArray:
        """Ranges of the angle of crankshaft 1 [rad] at which they do, first and last; one that runs over the end of the period
        ends beyond it.
        """
        return self._array("angles")  # type: ignore[no-any-return]

    @property
    def depth(self) -> float:
        """How deep [m]."""
        return self._get("depth")  # type: ignore[no-any-return]

    @property
    def depth_bound(self) -> float:
        """It is nowhere deeper than this [m]."""
        return self._get("depth_bound")  # type: ignore[no-any-return]


class PartLoads(Record):
    """Loads of one kind of part."""

    __slots__ = ()
    _FIELDS = ("loads", "part",)

    @property
    def loads(self) -> LoadSet:
        """Its loads."""
        return self._of("loads", LoadSet)  # type: ignore[no-any-return]

    @property
    def part(self) -> Literal['rotating', 'reciprocating', 'rod-inertia', 'counterweights', 'shafts']:
        """Which."""
        return self._get("part")  # type: ignore[no-any-return]


class Peak(Record):
    """An extreme along the shaft and over the cycle."""

    __slots__ = ()
    _FIELDS = ("theta", "value", "z",)

    @property
    def theta(self) -> float:
        """Crank angle [rad] in one period; 0 where it is the same at every angle."""
        return self._get("theta")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """Value [N] or [N m]."""
        return self._get("value")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its plane [m], from the origin; a shear force acts just behind it. The first that attains it."""
        return self._get("z")  # type: ignore[no-any-return]


class Peak2(Record):
    """A value of a run, and where it stands."""

    __slots__ = ()
    _FIELDS = ("theta", "time", "value",)

    @property
    def theta(self) -> float:
        """Crank angle of crankshaft 1 since the angle 0 [rad]."""
        return self._get("theta")  # type: ignore[no-any-return]

    @property
    def time(self) -> float:
        """Time [s]."""
        return self._get("time")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """Value."""
        return self._get("value")  # type: ignore[no-any-return]


class PeakStress(Record):
    """The largest stress of a surface."""

    __slots__ = ()
    _FIELDS = ("angle", "at", "jump", "principal", "von_mises",)

    @property
    def angle(self) -> float:
        """Angle about the bar's middle, from the x axis of the crankshaft's frame [rad]."""
        return self._get("angle")  # type: ignore[no-any-return]

    @property
    def at(self) -> FloatArray:
        """Place [m]."""
        return self._array("at")  # type: ignore[no-any-return]

    @property
    def jump(self) -> float:
        """Largest jump of the stress between elements over the stress, at the nodes of the same surface of all elements that meet there: a sign of
        the error.
        """
        return self._get("jump")  # type: ignore[no-any-return]

    @property
    def principal(self) -> float:
        """Principal stress of the largest size there [Pa], tension positive."""
        return self._get("principal")  # type: ignore[no-any-return]

    @property
    def von_mises(self) -> float:
        """Largest von Mises stress [Pa]."""
        return self._get("von_mises")  # type: ignore[no-any-return]


class Peaks(Record):
    """Extremes of every quantity of a `LoadSet`."""

    __slots__ = ()
    _FIELDS = ("couple", "couple_x", "couple_y", "force", "force_x", "force_y", "roll_moment", "shaft_torque",)

    @property
    def couple(self) -> Extremes:
        """Resultant couple `|M_x + i M_y|`."""
        return self._of("couple", Extremes)  # type: ignore[no-any-return]

    @property
    def couple_x(self) -> Extremes:
        """Couple about x."""
        return self._of("couple_x", Extremes)  # type: ignore[no-any-return]

    @property
    def couple_y(self) -> Extremes:
        """Couple about y."""
        return self._of("couple_y", Extremes)  # type: ignore[no-any-return]

    @property
    def force(self) -> Extremes:
        """Resultant force `|F_x + i F_y|`."""
        return self._of("force", Extremes)  # type: ignore[no-any-return]

    @property
    def force_x(self) -> Extremes:
        """Force along x."""
        return self._of("force_x", Extremes)  # type: ignore[no-any-return]

    @property
    def force_y(self) -> Extremes:
        """Force along y."""
        return self._of("force_y", Extremes)  # type: ignore[no-any-return]

    @property
    def roll_moment(self) -> Extremes:
        """Roll moment."""
        return self._of("roll_moment", Extremes)  # type: ignore[no-any-return]

    @property
    def shaft_torque(self) -> Extremes:
        """Shaft torque."""
        return self._of("shaft_torque", Extremes)  # type: ignore[no-any-return]


class PendulumSweep(Record):
    """A pendulum absorber over speed."""

    __slots__ = ()
    _FIELDS = ("shaft", "swing",)

    @property
    def shaft(self) -> int:
        """Index of its shaft."""
        return self._get("shaft")  # type: ignore[no-any-return]

    @property
    def swing(self) -> FloatArray:
        """Amplitude of its swing against the radius in true phase [rad]; large ones are beyond the linear theory."""
        return self._array("swing")  # type: ignore[no-any-return]


class Percentile(Record):
    """A percentile."""

    __slots__ = ()
    _FIELDS = ("share", "value",)

    @property
    def share(self) -> float:
        """Share of the samples, from 0 to 1."""
        return self._get("share")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """What this share does not exceed."""
        return self._get("value")  # type: ignore[no-any-return]


class PeriodHeat(Record):
    """Heat of the computed cycles of all cylinders in one period, at its mean speed [J]."""

    __slots__ = ()
    _FIELDS = ("exhaust", "fuel", "indicated", "speed", "unburned", "walls",)

    @property
    def exhaust(self) -> float:
        """What the exhaust carries away, less what the intake brings."""
        return self._get("exhaust")  # type: ignore[no-any-return]

    @property
    def fuel(self) -> float:
        """Energy of the fuel."""
        return self._get("fuel")  # type: ignore[no-any-return]

    @property
    def indicated(self) -> float:
        """Work on the pistons in cycles at this speed: that of the run differs by what its speed varies."""
        return self._get("indicated")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Mean speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def unburned(self) -> float:
        """What of it does not burn."""
        return self._get("unburned")  # type: ignore[no-any-return]

    @property
    def walls(self) -> float:
        """Heat to the walls."""
        return self._get("walls")  # type: ignore[no-any-return]


class PeriodSummary(Record):
    """The last whole period of a run, or all of it where there is none."""

    __slots__ = ()
    _FIELDS = ("extremes", "is_whole", "orders", "statistics", "time",)

    @property
    def extremes(self) -> RunExtremes:
        """Largest and smallest values."""
        return self._of("extremes", RunExtremes)  # type: ignore[no-any-return]

    @property
    def is_whole(self) -> bool:
        """Whether it is a whole period: the crank turns through one at least."""
        return self._get("is_whole")  # type: ignore[no-any-return]

    @property
    def orders(self) -> Records[SimulatedOrder]:
        """By order at the crank angle itself; empty where the samples are not equally spaced in the angle."""
        return self._all("orders", SimulatedOrder)

    @property
    def statistics(self) -> Records[SeriesStatistics]:
        """Mean over time and standard deviation of what has a course."""
        return self._all("statistics", SeriesStatistics)

    @property
    def time(self) -> FloatArray:
        """Its start and end [s]."""
        return self._array("time")  # type: ignore[no-any-return]


class PeriodicResult(Record):
    """How the search for a periodic motion ended."""

    __slots__ = ()
    _FIELDS = ("followed", "iterations", "multipliers", "outcome", "residual",)

    @property
    def followed(self) -> Followed | None:
        """How far the motion was followed from the start, where Newton did not find it from there."""
        return self._of("followed", Followed)  # type: ignore[no-any-return]

    @property
    def iterations(self) -> int:
        """Newton's iterations."""
        return self._get("iterations")  # type: ignore[no-any-return]

    @property
    def multipliers(self) -> FloatArray:
        """Multipliers by falling size: real and imaginary part; empty where there are none to tell."""
        return self._array("multipliers")  # type: ignore[no-any-return]

    @property
    def outcome(self) -> Literal['stable', 'neutral', 'unstable', 'not-found', 'cancelled']:
        """Outcome."""
        return self._get("outcome")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """Largest change over one period, over the size of its kind of state."""
        return self._get("residual")  # type: ignore[no-any-return]


class Phase(Variant):
    """Direction of a free weight at `theta = 0`."""

    __slots__ = ()
    _FIELDS = ("kind", "line", "direction",)

    @property
    def kind(self) -> Literal['free', 'line', 'direction']:
        """Which of the variants it is.
        `free`: To be found.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def line(self) -> float | None:
        """Along this direction [rad] or opposite to it, whichever is better."""
        return self._get("line")  # type: ignore[no-any-return]

    @property
    def direction(self) -> float | None:
        """Along this direction [rad]."""
        return self._get("direction")  # type: ignore[no-any-return]


class PinForces(Record):
    """Force on a pin."""

    __slots__ = ()
    _FIELDS = ("pin", "radial", "tangential",)

    @property
    def pin(self) -> int:
        """Number of the pin, from 1."""
        return self._get("pin")  # type: ignore[no-any-return]

    @property
    def radial(self) -> float:
        """Along the throw, positive away from the crank axis [N]."""
        return self._get("radial")  # type: ignore[no-any-return]

    @property
    def tangential(self) -> float:
        """Across it, positive where it drives the crankshaft [N]."""
        return self._get("tangential")  # type: ignore[no-any-return]


class PinLoad(Record):
    """A load over the cycle."""

    __slots__ = ()
    _FIELDS = ("load", "mean", "peak",)

    @property
    def load(self) -> FloatArray:
        """At every angle [N]."""
        return self._array("load")  # type: ignore[no-any-return]

    @property
    def mean(self) -> float:
        """Mean size over the continuous angle [N]."""
        return self._get("mean")  # type: ignore[no-any-return]

    @property
    def peak(self) -> Extreme:
        """Largest size and its angle, over the continuous angle."""
        return self._of("peak", Extreme)  # type: ignore[no-any-return]


class PinLoad2(Record):
    """A force on a crankpin, in the frame of the crankshaft."""

    __slots__ = ()
    _FIELDS = ("force", "pin",)

    @property
    def force(self) -> FloatArray:
        """Force on the pin [N]."""
        return self._array("force")  # type: ignore[no-any-return]

    @property
    def pin(self) -> int:
        """Number of the pin, from 1."""
        return self._get("pin")  # type: ignore[no-any-return]


class PinParts(Record):
    """One crankpin of a sheet."""

    __slots__ = ()
    _FIELDS = ("cylinders", "name", "oil", "throw",)

    @property
    def cylinders(self) -> Records[CylinderParts]:
        """The parts of every rod on it."""
        return self._all("cylinders", CylinderParts)

    @property
    def name(self) -> str:
        """What it is called."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def oil(self) -> float:
        """Oil that turns with the pin [kg]."""
        return self._get("oil")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int | None:
        """Number of its throw in the engine file, from 1, where the sheet names one."""
        return self._get("throw")  # type: ignore[no-any-return]


class Place(Variant):
    """A coordinate that is given or to be found."""

    __slots__ = ()
    _FIELDS = ("kind", "at", "between",)

    @property
    def kind(self) -> Literal['at', 'between']:
        """Which of the variants it is."""
        return self._kind()  # type: ignore[no-any-return]

    @property
    def at(self) -> float | None:
        """Given [m]."""
        return self._get("at")  # type: ignore[no-any-return]

    @property
    def between(self) -> FloatArray:
        """Anywhere from the first to the second [m], `first < second`."""
        return self._array("between")  # type: ignore[no-any-return]


class Placement(Record):
    """A weight to add or remove at an allowed angle."""

    __slots__ = ()
    _FIELDS = ("angle", "mass", "unbalance",)

    @property
    def angle(self) -> float:
        """Angle on the rotor [rad], within [0, 2 pi)."""
        return self._get("angle")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float | None:
        """Mass at the radius of the plane [kg], where that is given."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> float:
        """Mass times radius [kg m]."""
        return self._get("unbalance")  # type: ignore[no-any-return]


class PlaneCorrection(Record):
    """What to add or remove in one plane."""

    __slots__ = ()
    _FIELDS = ("action", "left", "placements", "plane", "unbalance",)

    @property
    def action(self) -> Literal['add', 'remove']:
        """Whether weight is added or removed."""
        return self._get("action")  # type: ignore[no-any-return]

    @property
    def left(self) -> FloatArray:
        """What these leave undone, as an unbalance to put on [kg m]."""
        return self._array("left")  # type: ignore[no-any-return]

    @property
    def placements(self) -> Records[Placement]:
        """What to do at which allowed angles."""
        return self._all("placements", Placement)

    @property
    def plane(self) -> str:
        """Name of the plane."""
        return self._get("plane")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> FloatArray:
        """Unbalance to put on [kg m]: its argument is the angle on the rotor at which weight would be added."""
        return self._array("unbalance")  # type: ignore[no-any-return]


class PlaneUnbalance(Record):
    """An unbalance in a plane."""

    __slots__ = ()
    _FIELDS = ("name", "unbalance", "z",)

    @property
    def name(self) -> str:
        """Name of the plane or of what brings the unbalance."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> FloatArray:
        """Unbalance in the frame of the crankshaft [kg m]."""
        return self._array("unbalance")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Plane [m], from the origin."""
        return self._get("z")  # type: ignore[no-any-return]


class Point(Record):
    """A point of the plane across the crank, or a vector in it [m].

    The origin is the crank axis; a part's own `x` points along its unbalance (a counterweight: away from its
    crankpin), `y` a quarter turn further in the sense in which the crank turns.
    """

    __slots__ = ()
    _FIELDS = ("x", "y",)

    @property
    def x(self) -> float:
        """Along the part's axis [m]."""
        return self._get("x")  # type: ignore[no-any-return]

    @property
    def y(self) -> float:
        """A quarter turn from it [m]."""
        return self._get("y")  # type: ignore[no-any-return]


class PointFatigue(Record):
    """Safety at a point."""

    __slots__ = ()
    _FIELDS = ("plane", "safety_of_all", "safety_of_amplitude",)

    @property
    def plane(self) -> CriticalPlane:
        """The worst plane under the stress as it is."""
        return self._of("plane", CriticalPlane)  # type: ignore[no-any-return]

    @property
    def safety_of_all(self) -> float | None:
        """How many times larger all stress may become [1]; `None`: nothing here can fail by fatigue."""
        return self._get("safety_of_all")  # type: ignore[no-any-return]

    @property
    def safety_of_amplitude(self) -> float | None:
        """How many times larger the difference from the mean over the cycle may become while the mean stays [1]; 0 where the mean alone is too much, `None` where
        nothing varies.
        """
        return self._get("safety_of_amplitude")  # type: ignore[no-any-return]


class PointMotion(Record):
    """Motion of a point of the block."""

    __slots__ = ()
    _FIELDS = ("displacement", "point",)

    @property
    def displacement(self) -> list[FloatArray]:
        """Displacement [m] at each speed, for each order of the response."""
        return self._rows("displacement")  # type: ignore[no-any-return]

    @property
    def point(self) -> FloatArray:
        """The point [m]."""
        return self._array("point")  # type: ignore[no-any-return]


class PointMotion2(Record):
    """Motion of a point of the block."""

    __slots__ = ()
    _FIELDS = ("at", "displacement", "name",)

    @property
    def at(self) -> FloatArray:
        """Where it is with the block as drawn [m]."""
        return self._array("at")  # type: ignore[no-any-return]

    @property
    def displacement(self) -> FloatArray:
        """Its displacement from there at every sample [m], axes of the frame; empty with a fixed block."""
        return self._array("displacement")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]


class PointWeight(Record):
    """A weight of the crankshaft that the file gives by its unbalance alone, such as one of the flywheel. It has no mass here."""

    __slots__ = ()
    _FIELDS = ("couple", "name", "unbalance", "z",)

    @property
    def couple(self) -> Point:
        """Its moment `V` along the crank [kg m^2]."""
        return self._of("couple", Point)  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> Point:
        """Static unbalance `U` [kg m]."""
        return self._of("unbalance", Point)  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its plane [m]."""
        return self._get("z")  # type: ignore[no-any-return]


class PowerCurve(Record):
    """Power over speed as a cubic through the origin."""

    __slots__ = ()
    _FIELDS = ("coefficients", "misfit", "peak", "points",)

    @property
    def coefficients(self) -> FloatArray:
        """`a`, `b`, `c` of `P = a w + b w^2 + c w^3` [W s, W s^2, W s^3] with the speed in rad/s."""
        return self._array("coefficients")  # type: ignore[no-any-return]

    @property
    def misfit(self) -> float:
        """Largest departure of a point from the curve [W]."""
        return self._get("misfit")  # type: ignore[no-any-return]

    @property
    def peak(self) -> FloatArray:
        """Speed [rad/s] and power [W] of the largest power between 0 and the highest point's speed."""
        return self._array("peak")  # type: ignore[no-any-return]

    @property
    def points(self) -> FloatArray:
        """Points that it fits: speed [rad/s] and power [W]."""
        return self._array("points")  # type: ignore[no-any-return]


class Price(Record):
    """What an arrangement costs."""

    __slots__ = ()
    _FIELDS = ("bearing_load", "bearings", "chains", "drive_mass", "drive_power", "drive_torque", "idlers", "inertia", "meshes", "shafts", "unbalance", "weight_mass", "weights",)

    @property
    def bearing_load(self) -> float:
        """Largest load of a shaft bearing [N]."""
        return self._get("bearing_load")  # type: ignore[no-any-return]

    @property
    def bearings(self) -> int:
        """Bearings of shafts and idlers."""
        return self._get("bearings")  # type: ignore[no-any-return]

    @property
    def chains(self) -> int:
        """Chains or belts."""
        return self._get("chains")  # type: ignore[no-any-return]

    @property
    def drive_mass(self) -> float:
        """Mass of bare shafts, gears and idlers [kg]."""
        return self._get("drive_mass")  # type: ignore[no-any-return]

    @property
    def drive_power(self) -> float:
        """Power that the crank gives to turn the shafts [W]: bearing friction and mesh losses."""
        return self._get("drive_power")  # type: ignore[no-any-return]

    @property
    def drive_torque(self) -> float:
        """Largest torque in a mesh or chain, at the driven gear [N m]."""
        return self._get("drive_torque")  # type: ignore[no-any-return]

    @property
    def idlers(self) -> int:
        """Idlers."""
        return self._get("idlers")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> float:
        """Inertia of everything added, at the crank [kg m^2]: each part times its ratio squared."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def meshes(self) -> int:
        """Gear meshes."""
        return self._get("meshes")  # type: ignore[no-any-return]

    @property
    def shafts(self) -> int:
        """Balance shafts."""
        return self._get("shafts")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> float:
        """Unbalance added, all weights together [kg m]."""
        return self._get("unbalance")  # type: ignore[no-any-return]

    @property
    def weight_mass(self) -> float:
        """Mass of all weights [kg]."""
        return self._get("weight_mass")  # type: ignore[no-any-return]

    @property
    def weights(self) -> int:
        """Weights, on crank and shafts."""
        return self._get("weights")  # type: ignore[no-any-return]


class PrimaryEllipse(Record):
    """A first-order force over the square of the speed, as an ellipse."""

    __slots__ = ()
    _FIELDS = ("backward", "forward", "major", "minor", "sense", "tilt",)

    @property
    def backward(self) -> FloatArray:
        """Part that turns against the crank [kg m]."""
        return self._array("backward")  # type: ignore[no-any-return]

    @property
    def forward(self) -> FloatArray:
        """Part that turns with the crank [kg m], in the frame of the throw."""
        return self._array("forward")  # type: ignore[no-any-return]

    @property
    def major(self) -> float:
        """Semi-major axis [kg m]: times `w^2` the peak of the force [N]."""
        return self._get("major")  # type: ignore[no-any-return]

    @property
    def minor(self) -> float:
        """Shorter half axis [kg m]."""
        return self._get("minor")  # type: ignore[no-any-return]

    @property
    def sense(self) -> Literal['with', 'against', 'line', 'none']:
        """Which way it is run through."""
        return self._get("sense")  # type: ignore[no-any-return]

    @property
    def tilt(self) -> float:
        """Direction of the longer axis in the engine's frame [rad], in (-pi/2, pi/2]; 0 for a circle."""
        return self._get("tilt")  # type: ignore[no-any-return]


class QuasiStatic(Record):
    """A single unbalance that stands for all, but for a couple across it."""

    __slots__ = ()
    _FIELDS = ("rest", "z",)

    @property
    def rest(self) -> float:
        """The couple that is left [kg m^2]: perpendicular to the static unbalance."""
        return self._get("rest")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its plane [m], from the origin."""
        return self._get("z")  # type: ignore[no-any-return]


class RadialEnvelope(Record):
    """How far a counterweight may reach in each direction, between two planes."""

    __slots__ = ()
    _FIELDS = ("directions", "least", "limit", "radii",)

    @property
    def directions(self) -> FloatArray:
        """Directions from that of the counterweight [rad], from 0 to a quarter turn: to either side."""
        return self._array("directions")  # type: ignore[no-any-return]

    @property
    def least(self) -> float:
        """The wanted clearance that it keeps [m]."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def limit(self) -> Obstacle | None:
        """What is first in the way; none where nothing is within reach."""
        return self._of("limit", Obstacle)  # type: ignore[no-any-return]

    @property
    def radii(self) -> FloatArray:
        """Largest radius in each of them [m], on the nearer of both sides. Between two of them it runs along a circle."""
        return self._array("radii")  # type: ignore[no-any-return]


class RadiusAndMass(Record):
    """A weight by its mass at a radius: their product is its unbalance."""

    __slots__ = ()
    _FIELDS = ("mass", "radius",)

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Distance of the centre of gravity from the axis [m]."""
        return self._get("radius")  # type: ignore[no-any-return]


class Range(Record):
    """Least and most of a dimension; equal where it is fixed."""

    __slots__ = ()
    _FIELDS = ("least", "most",)

    @property
    def least(self) -> float:
        """Least value."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def most(self) -> float:
        """Largest value."""
        return self._get("most")  # type: ignore[no-any-return]


class RangeBreach(Record):
    """A ratio outside the range in which the formulas hold."""

    __slots__ = ()
    _FIELDS = ("range", "ratio", "value",)

    @property
    def range(self) -> FloatArray:
        """Where the formulas hold."""
        return self._array("range")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> str:
        """Which one: "b = B/D"."""
        return self._get("ratio")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """Its value."""
        return self._get("value")  # type: ignore[no-any-return]


class Ranking(Record):
    """The engines by one criterion, best first."""

    __slots__ = ()
    _FIELDS = ("criterion", "places",)

    @property
    def criterion(self) -> Literal['force', 'couple', 'roll-moment', 'mount-force', 'firing-unevenness', 'torque-unevenness', 'flywheel', 'added-unbalance', 'shafts', 'main-film', 'crankpin-film', 'rule-safety', 'fillet-safety']:
        """By what."""
        return self._get("criterion")  # type: ignore[no-any-return]

    @property
    def places(self) -> Records[RankingPlace]:
        """The engines in their order."""
        return self._all("places", RankingPlace)


class RankingPlace(Record):
    """An engine in a ranking."""

    __slots__ = ()
    _FIELDS = ("engine", "rank", "value",)

    @property
    def engine(self) -> int:
        """Its place in the comparison."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def rank(self) -> int:
        """Rank, from 1; engines that cannot be told apart share it."""
        return self._get("rank")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """What it has, in the unit of the criterion."""
        return self._get("value")  # type: ignore[no-any-return]


class Reactions(Record):
    """Loads of all joints at one instant."""

    __slots__ = ()
    _FIELDS = ("cylinders", "on_block", "rotors", "shaft_torque",)

    @property
    def cylinders(self) -> Records[CylinderReactions]:
        """By cylinder."""
        return self._all("cylinders", CylinderReactions)

    @property
    def on_block(self) -> Wrench:
        """All that pistons, rods and rotors do to the block, with gas on the heads and gears, about the origin. What acts from outside
        on crankshaft 1 without passing the block is in it, as the reaction to the torque that leaves.
        """
        return self._of("on_block", Wrench)  # type: ignore[no-any-return]

    @property
    def rotors(self) -> Records[RotorReactions]:
        """Crankshafts, then balance shafts."""
        return self._all("rotors", RotorReactions)

    @property
    def shaft_torque(self) -> float:
        """Torque that the crank train delivers at crankshaft 1 [N m]: to load, starter, friction and driveline."""
        return self._get("shaft_torque")  # type: ignore[no-any-return]


class ReducedCrank(Result):
    """A reduced model with its checks."""

    __slots__ = ()
    _FIELDS = ("frequencies", "mass_error", "model", "of_mesh", "residual", "sheet", "version",)

    @property
    def frequencies(self) -> FloatArray:
        """Free natural frequencies of the model beyond the rigid motions, and with a third of its fixed-interface modes left out [Hz]."""
        return self._array("frequencies")  # type: ignore[no-any-return]

    @property
    def mass_error(self) -> float:
        """Mass of a rigid translation of the model, over that of the mesh, less one."""
        return self._get("mass_error")  # type: ignore[no-any-return]

    @property
    def model(self) -> ReducedModel:
        """The model."""
        return self._of("model", ReducedModel)  # type: ignore[no-any-return]

    @property
    def of_mesh(self) -> FloatArray:
        """The first free natural frequencies of the mesh itself [Hz]: bearing surfaces that stay rigid make the model stiffer than that."""
        return self._array("of_mesh")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """Largest force that a constraint mode leaves on the free nodes, over its largest force."""
        return self._get("residual")  # type: ignore[no-any-return]

    @property
    def sheet(self) -> CrankSheet:
        """What was meshed."""
        return self._of("sheet", CrankSheet)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class ReducedModel(Matrices):
    """Matrices of a crankshaft in the coordinates of reference points and fixed-interface modes, row by row.

    Coordinates: of each reference point displacements along x, y, z [m] and rotations about them [rad]; then those of the modes, of modal mass
    1 kg. In a frame that turns about z with `W`:

    ```text
    m q'' + 2 W g q' + (k - W^2 n + W' g) q = W^2 f_c - W' f_e + f
    ```
    """

    __slots__ = ()
    _FIELDS = ("centrifugal", "centrifugal_load", "euler_load", "frequencies", "gyroscopic", "mass", "points", "stiffness",)
    _SQUARE = ("centrifugal", "gyroscopic", "mass", "stiffness")

    @property
    def centrifugal(self) -> FloatArray:
        """`n = B^T S^T M S B`."""
        return self._square("centrifugal")  # type: ignore[no-any-return]

    @property
    def centrifugal_load(self) -> FloatArray:
        """`f_c = B^T M (x, y, 0)`: load of a unit of speed squared."""
        return self._array("centrifugal_load")  # type: ignore[no-any-return]

    @property
    def euler_load(self) -> FloatArray:
        """`f_e = B^T M (-y, x, 0)`: load of a unit of angular acceleration, with its sign changed."""
        return self._array("euler_load")  # type: ignore[no-any-return]

    @property
    def frequencies(self) -> FloatArray:
        """Natural frequencies with all reference points fixed [Hz]."""
        return self._array("frequencies")  # type: ignore[no-any-return]

    @property
    def gyroscopic(self) -> FloatArray:
        """`g = B^T M S B`, skew, `S u = e_z x u`."""
        return self._square("gyroscopic")  # type: ignore[no-any-return]

    @property
    def mass(self) -> FloatArray:
        """Mass `m`."""
        return self._square("mass")  # type: ignore[no-any-return]

    @property
    def points(self) -> list[tuple[str, FloatArray]]:
        """Name and place [m] of each reference point."""
        return self._as("points", every(row(one, an_array)), [])  # type: ignore[no-any-return]

    @property
    def stiffness(self) -> FloatArray:
        """Stiffness `k`."""
        return self._square("stiffness")  # type: ignore[no-any-return]


class Remark(Record):
    """A doubt about the data, with what to do."""

    __slots__ = ()
    _FIELDS = ("hint", "kind", "message",)

    @property
    def hint(self) -> str:
        """What to do."""
        return self._get("hint")  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['weak-trial', 'contradiction', 'ill-conditioned', 'untried']:
        """Which doubt."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def message(self) -> str:
        """What is doubtful, with numbers."""
        return self._get("message")  # type: ignore[no-any-return]


class Removes(Variant):
    """What the weights of a shaft remove, and the planes in which they stand [m], from the middle of the crankshaft."""

    __slots__ = ()
    _FIELDS = ("kind", "force", "couple", "both",)

    @property
    def kind(self) -> Literal['force', 'couple', 'both']:
        """Which of the variants it is."""
        return self._kind()  # type: ignore[no-any-return]

    @property
    def force(self) -> RemovesForce | None:
        """The force, by one weight."""
        return self._of("force", RemovesForce)  # type: ignore[no-any-return]

    @property
    def couple(self) -> RemovesCouple | None:
        """The couple, by two opposed weights."""
        return self._of("couple", RemovesCouple)  # type: ignore[no-any-return]

    @property
    def both(self) -> RemovesBoth | None:
        """Force and couple, by two weights."""
        return self._of("both", RemovesBoth)  # type: ignore[no-any-return]


class RemovesBoth(Record):
    """Force and couple, by two weights."""

    __slots__ = ()
    _FIELDS = ("z",)

    @property
    def z(self) -> FloatArray:
        """Planes of the weights [m]."""
        return self._array("z")  # type: ignore[no-any-return]


class RemovesCouple(Record):
    """The couple, by two opposed weights."""

    __slots__ = ()
    _FIELDS = ("z",)

    @property
    def z(self) -> FloatArray:
        """Planes of the weights [m]."""
        return self._array("z")  # type: ignore[no-any-return]


class RemovesForce(Record):
    """The force, by one weight."""

    __slots__ = ()
    _FIELDS = ("z",)

    @property
    def z(self) -> float:
        """Plane of the weight [m]."""
        return self._get("z")  # type: ignore[no-any-return]


class Residual(Record):
    """Error of one junction or two-port."""

    __slots__ = ()
    _FIELDS = ("element", "error",)

    @property
    def element(self) -> str:
        """The element."""
        return self._get("element")  # type: ignore[no-any-return]

    @property
    def error(self) -> float:
        """Largest sum of powers against the largest power."""
        return self._get("error")  # type: ignore[no-any-return]


class RippleOutcome(Record):
    """The speed within the cycle, or why there is none."""

    __slots__ = ()
    _FIELDS = ("acceleration", "excess", "extremes", "fluctuation", "inertia", "load", "mean_speed", "period", "simple_fluctuation", "speed", "theta", "version", "outcome", "fix", "keys", "missing", "reason", "flywheel", "key", "limit",)

    @property
    def acceleration(self) -> float | None:
        """Largest size of the angular acceleration [rad/s^2], among the samples."""
        return self._get("acceleration")  # type: ignore[no-any-return]

    @property
    def excess(self) -> float | None:
        """Largest excess energy at constant speed [J], gas and inertia."""
        return self._get("excess")  # type: ignore[no-any-return]

    @property
    def extremes(self) -> Extremes | None:
        """Its extremes over the continuous angle."""
        return self._of("extremes", Extremes)  # type: ignore[no-any-return]

    @property
    def fluctuation(self) -> float | None:
        """Fluctuation `(w_max - w_min) / w_mean` [1]."""
        return self._get("fluctuation")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> TrainInertia | None:
        """The inertia that it turns."""
        return self._of("inertia", TrainInertia)  # type: ignore[no-any-return]

    @property
    def load(self) -> float | None:
        """Mean torque of the load [N m]: that of the gas and of the torque over the angle that the file gives."""
        return self._get("load")  # type: ignore[no-any-return]

    @property
    def mean_speed(self) -> float:
        """Mean speed asked for [rad/s]."""
        return self._get("mean_speed")  # type: ignore[no-any-return]

    @property
    def period(self) -> float | None:
        """Period [rad] of crankshaft 1."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def simple_fluctuation(self) -> float | None:
        """Fluctuation by the formula of eq. (25.4): largest excess energy at constant speed over `J w^2`, with the mean inertia."""
        return self._get("simple_fluctuation")  # type: ignore[no-any-return]

    @property
    def speed(self) -> FloatArray:
        """Speed [rad/s]."""
        return self._array("speed")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle [rad], from 0, one period, end point excluded."""
        return self._array("theta")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def outcome(self) -> Literal['periodic', 'incomplete-inertia', 'stops']:
        """Which of the variants it is."""
        return self._get("outcome")  # type: ignore[no-any-return]

    @property
    def fix(self) -> str | None:
        """What fixes it."""
        return self._get("fix")  # type: ignore[no-any-return]

    @property
    def keys(self) -> list[str]:
        """Keys of the engine file that give it."""
        return self._list("keys")  # type: ignore[no-any-return]

    @property
    def missing(self) -> list[Literal['flywheel', 'crankshaft']]:
        """What is not known."""
        return self._list("missing")  # type: ignore[no-any-return]

    @property
    def reason(self) -> str | None:
        """Why, in words."""
        return self._get("reason")  # type: ignore[no-any-return]

    @property
    def flywheel(self) -> float | None:
        """Flywheel inertia with which the lowest speed stays just above the limit [kg m^2]; `None` where none does."""
        return self._get("flywheel")  # type: ignore[no-any-return]

    @property
    def key(self) -> str | None:
        """Key of the engine file that gives it."""
        return self._get("key")  # type: ignore[no-any-return]

    @property
    def limit(self) -> float | None:
        """Lowest speed over the mean below which an engine counts as stopped [1]: `STOPPED`."""
        return self._get("limit")  # type: ignore[no-any-return]


class RobustAnswer(Result):
    """The best weights for sampled engines."""

    __slots__ = ()
    _FIELDS = ("answer", "averaged", "criterion", "later", "least", "limits", "lower_bound", "measure", "nominal", "ordinary", "ordinary_nominal", "samples", "second_samples", "second_value", "seed", "solves", "standard_error", "unit", "value", "version",)

    @property
    def answer(self) -> Answer:
        """The devices, and what they do to the engine as it is meant."""
        return self._of("answer", Answer)  # type: ignore[no-any-return]

    @property
    def averaged(self) -> int:
        """How many of them, the largest, are averaged."""
        return self._get("averaged")  # type: ignore[no-any-return]

    @property
    def criterion(self) -> Criterion:
        """What is judged of every sample."""
        return self._of("criterion", Criterion)  # type: ignore[no-any-return]

    @property
    def later(self) -> Records[RobustStage]:
        """Stages behind the first, minimised on the engine as it is meant."""
        return self._all("later", RobustStage)

    @property
    def least(self) -> float:
        """The measure before stages behind the first took what it gives up."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def limits(self) -> Records[RobustLimit]:
        """The limits, which hold for the engine as it is meant."""
        return self._all("limits", RobustLimit)

    @property
    def lower_bound(self) -> float:
        """No weights that hold the limits bring the measure of these samples below this."""
        return self._get("lower_bound")  # type: ignore[no-any-return]

    @property
    def measure(self) -> RobustMeasure:
        """What of the samples is minimised."""
        return self._of("measure", RobustMeasure)  # type: ignore[no-any-return]

    @property
    def nominal(self) -> float:
        """The criterion of the engine as it is meant, with these weights."""
        return self._get("nominal")  # type: ignore[no-any-return]

    @property
    def ordinary(self) -> float:
        """The measure of the first samples with the weights that are best for the engine as it is meant."""
        return self._get("ordinary")  # type: ignore[no-any-return]

    @property
    def ordinary_nominal(self) -> float:
        """The same with the weights that are best for it."""
        return self._get("ordinary_nominal")  # type: ignore[no-any-return]

    @property
    def samples(self) -> int:
        """Samples, and how many of them, the largest, are averaged."""
        return self._get("samples")  # type: ignore[no-any-return]

    @property
    def second_samples(self) -> int:
        """Samples of the second set."""
        return self._get("second_samples")  # type: ignore[no-any-return]

    @property
    def second_value(self) -> float | None:
        """The measure of an independent second set of samples, if there is one: free of having been optimised for."""
        return self._get("second_value")  # type: ignore[no-any-return]

    @property
    def seed(self) -> int:
        """Seed of samples and resampling."""
        return self._get("seed")  # type: ignore[no-any-return]

    @property
    def solves(self) -> int:
        """Cone programmes solved."""
        return self._get("solves")  # type: ignore[no-any-return]

    @property
    def standard_error(self) -> float:
        """Standard error of the value by resampling the samples (bootstrap); of the worst it tells little."""
        return self._get("standard_error")  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """Its SI unit."""
        return self._get("unit")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """The measure of the samples."""
        return self._get("value")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class RobustLimit(Record):
    """A limit, which holds for the engine as it is meant."""

    __slots__ = ()
    _FIELDS = ("beyond", "criterion", "most", "nominal", "worst",)

    @property
    def beyond(self) -> int | None:
        """How many samples pass the limit, for peaks of loads."""
        return self._get("beyond")  # type: ignore[no-any-return]

    @property
    def criterion(self) -> Criterion:
        """What is limited."""
        return self._of("criterion", Criterion)  # type: ignore[no-any-return]

    @property
    def most(self) -> float:
        """Its largest value."""
        return self._get("most")  # type: ignore[no-any-return]

    @property
    def nominal(self) -> float:
        """What the engine as it is meant has."""
        return self._get("nominal")  # type: ignore[no-any-return]

    @property
    def worst(self) -> float | None:
        """The largest of the samples, for peaks of loads."""
        return self._get("worst")  # type: ignore[no-any-return]


class RobustMeasure(Variant):
    """What of the samples is minimised."""

    __slots__ = ()
    _FIELDS = ("kind", "mean_of_worst",)

    @property
    def kind(self) -> Literal['worst', 'mean-of-worst']:
        """Which of the variants it is.
        `worst`: The largest.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def mean_of_worst(self) -> float | None:
        """The mean of this share of them, the largest ones: at least one sample."""
        return self._get("mean-of-worst")  # type: ignore[no-any-return]


class RobustStage(Record):
    """A stage behind the first."""

    __slots__ = ()
    _FIELDS = ("criteria", "lower_bound", "value",)

    @property
    def criteria(self) -> Records[Criterion]:
        """Its criteria."""
        return self._all("criteria", Criterion)

    @property
    def lower_bound(self) -> float:
        """No weights that keep the stages before it and the limits go below this."""
        return self._get("lower_bound")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """Its value on the engine as it is meant, weighted as the task says."""
        return self._get("value")  # type: ignore[no-any-return]


class RotatingBody(Record):
    """A body that turns at a fixed ratio to crankshaft 1."""

    __slots__ = ()
    _FIELDS = ("centre", "inertia", "key", "kind", "mass", "name", "ratio",)

    @property
    def centre(self) -> FloatArray | None:
        """Centre of mass [m] from the origin, x and y in the directions of the crankshaft at angle zero, where it is known."""
        return self._array("centre")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> Sourced | None:
        """Polar moment of inertia about its own axis [kg m^2], where it is known."""
        return self._of("inertia", Sourced)  # type: ignore[no-any-return]

    @property
    def key(self) -> str:
        """Key of the engine file that gives the inertia."""
        return self._get("key")  # type: ignore[no-any-return]

    @property
    def kind(self) -> RotatingKind:
        """What it is."""
        return self._of("kind", RotatingKind)  # type: ignore[no-any-return]

    @property
    def mass(self) -> Sourced | None:
        """Mass [kg], where it is known."""
        return self._of("mass", Sourced)  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> float:
        """Speed over that of crankshaft 1, signed."""
        return self._get("ratio")  # type: ignore[no-any-return]


class RotatingKind(Variant):
    """What a rotating body is."""

    __slots__ = ()
    _FIELDS = ("kind", "crankshaft", "shaft", "gear",)

    @property
    def kind(self) -> Literal['crankshaft', 'flywheel', 'shaft', 'gear']:
        """Which of the variants it is.
        `flywheel`: The flywheel and all that turns rigidly with crankshaft 1.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def crankshaft(self) -> int | None:
        """The crankshaft with this index, with its counterweights, without rods."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def shaft(self) -> int | None:
        """The balance shaft with this index."""
        return self._get("shaft")  # type: ignore[no-any-return]

    @property
    def gear(self) -> int | None:
        """The gear with this index."""
        return self._get("gear")  # type: ignore[no-any-return]


class RotorEffects(Record):
    """What of the rotors acts on the motion of the block."""

    __slots__ = ()
    _FIELDS = ("couple", "roll",)

    @property
    def couple(self) -> bool:
        """Their gyroscopic couple."""
        return self._get("couple")  # type: ignore[no-any-return]

    @property
    def roll(self) -> bool:
        """Their polar inertia does not follow the roll."""
        return self._get("roll")  # type: ignore[no-any-return]


class RotorExtremes(Record):
    """Of what is carried at one crankshaft or balance shaft."""

    __slots__ = ()
    _FIELDS = ("bearing_force", "bearing_moment", "gear_force", "gear_torque", "mains",)

    @property
    def bearing_force(self) -> Peak2:
        """Force on all bearings together [N]."""
        return self._of("bearing_force", Peak2)  # type: ignore[no-any-return]

    @property
    def bearing_moment(self) -> Peak2:
        """Moment on all bearings together across the axis, about the axis in the plane of the origin [N m]."""
        return self._of("bearing_moment", Peak2)  # type: ignore[no-any-return]

    @property
    def gear_force(self) -> Peak2:
        """Force of its teeth [N]."""
        return self._of("gear_force", Peak2)  # type: ignore[no-any-return]

    @property
    def gear_torque(self) -> Bounds:
        """Torque of gear or chain [N m]."""
        return self._of("gear_torque", Bounds)  # type: ignore[no-any-return]

    @property
    def mains(self) -> list[Records[Peak2]]:
        """Force on every main bearing [N], by rule (`ALL`), then by main."""
        return self._as("mains", every(record(Peak2)), [])  # type: ignore[no-any-return]


class RotorReactions(Record):
    """Loads of one crankshaft or balance shaft."""

    __slots__ = ()
    _FIELDS = ("bearings", "gear_force", "gear_torque", "mains",)

    @property
    def bearings(self) -> Wrench:
        """Shaft on its bearings, about its axis in the plane of the origin; no moment about the axis."""
        return self._of("bearings", Wrench)  # type: ignore[no-any-return]

    @property
    def gear_force(self) -> FloatArray:
        """Force of its teeth on it at the pitch point, along the line of action, where the pressure angle is given, else 0 [N]; for crankshaft 1 the sum of all. The
        bearings carry it.
        """
        return self._array("gear_force")  # type: ignore[no-any-return]

    @property
    def gear_torque(self) -> float:
        """Torque of its gear or chain on it [N m]; for crankshaft 1 that of all gears together."""
        return self._get("gear_torque")  # type: ignore[no-any-return]

    @property
    def mains(self) -> list[FloatArray]:
        """Journals on the main bearings by rule (`ALL`), then by main: `x`, `y` [N]; empty without two mains."""
        return self._rows("mains")  # type: ignore[no-any-return]


class RuleFactors(Record):
    """Factors of the two fillets of a web [1]."""

    __slots__ = ()
    _FIELDS = ("alpha_b", "alpha_t", "beta_b", "beta_q", "beta_t",)

    @property
    def alpha_b(self) -> Factor:
        """Pin fillet, bending."""
        return self._of("alpha_b", Factor)  # type: ignore[no-any-return]

    @property
    def alpha_t(self) -> Factor:
        """Pin fillet, torsion."""
        return self._of("alpha_t", Factor)  # type: ignore[no-any-return]

    @property
    def beta_b(self) -> Factor:
        """Journal fillet, bending."""
        return self._of("beta_b", Factor)  # type: ignore[no-any-return]

    @property
    def beta_q(self) -> Factor:
        """Journal fillet, radial force."""
        return self._of("beta_q", Factor)  # type: ignore[no-any-return]

    @property
    def beta_t(self) -> Factor:
        """Journal fillet, torsion."""
        return self._of("beta_t", Factor)  # type: ignore[no-any-return]


class Run(Record):
    """A stretch of cases, end excluded."""

    __slots__ = ()
    _FIELDS = ("from_", "to",)

    @property
    def from_(self) -> int:
        """First case."""
        return self._get("from")  # type: ignore[no-any-return]

    @property
    def to(self) -> int:
        """One more than the last case."""
        return self._get("to")  # type: ignore[no-any-return]


class Run2(Record):
    """A run with its samples."""

    __slots__ = ()
    _FIELDS = ("audit", "cost", "end", "energy", "engine", "events", "extremes", "last_period", "last_period_extremes", "outcome", "samples", "stall", "tolerances", "version",)

    @property
    def audit(self) -> Audit:
        """What must be zero."""
        return self._of("audit", Audit)  # type: ignore[no-any-return]

    @property
    def cost(self) -> Cost2:
        """What it cost."""
        return self._of("cost", Cost2)  # type: ignore[no-any-return]

    @property
    def end(self) -> FloatArray:
        """Time [s], crank angle [rad] and speed [rad/s] at its end."""
        return self._array("end")  # type: ignore[no-any-return]

    @property
    def energy(self) -> EnergyLedger:
        """Works and energies."""
        return self._of("energy", EnergyLedger)  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def events(self) -> Records[Happened]:
        """What happened on the way."""
        return self._all("events", Happened)

    @property
    def extremes(self) -> RunExtremes:
        """Largest and smallest values over the whole run."""
        return self._of("extremes", RunExtremes)  # type: ignore[no-any-return]

    @property
    def last_period(self) -> EnergyLedger | None:
        """The same over its last period, where the crank turns forward through a whole one and samples mark both its ends."""
        return self._of("last_period", EnergyLedger)  # type: ignore[no-any-return]

    @property
    def last_period_extremes(self) -> RunExtremes | None:
        """The same over its last period, where the crank turns forward through a whole one."""
        return self._of("last_period_extremes", RunExtremes)  # type: ignore[no-any-return]

    @property
    def outcome(self) -> RunOutcome:
        """How it ended."""
        return self._of("outcome", RunOutcome)  # type: ignore[no-any-return]

    @property
    def samples(self) -> Samples:
        """Samples."""
        return self._of("samples", Samples)  # type: ignore[no-any-return]

    @property
    def stall(self) -> Stall | None:
        """Where a starter that never let go could not turn the crank on."""
        return self._of("stall", Stall)  # type: ignore[no-any-return]

    @property
    def tolerances(self) -> Tolerances:
        """Tolerances of its steps by kind of state."""
        return self._of("tolerances", Tolerances)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class RunEntry(Record):
    """A run of the log."""

    __slots__ = ()
    _FIELDS = ("name", "sensors", "speed", "weights",)

    @property
    def name(self) -> str:
        """Name of the run."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def sensors(self) -> Records[SensorEntry]:
        """Its sensors."""
        return self._all("sensors", SensorEntry)

    @property
    def speed(self) -> float:
        """Speed [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def weights(self) -> list[tuple[str, FloatArray]]:
        """What was on the rotor beyond its first state: name of the plane, unbalance on the rotor's circle [kg m]."""
        return self._as("weights", every(row(one, an_array)), [])  # type: ignore[no-any-return]


class RunExtremes(Record):
    """Largest and smallest values over a run, or over its last period."""

    __slots__ = ()
    _FIELDS = ("cylinders", "driveline", "mounts", "position", "rotors", "shaft_torque", "speed", "turn",)

    @property
    def cylinders(self) -> Records[CylinderExtremes]:
        """By cylinder, where reactions were asked for."""
        return self._all("cylinders", CylinderExtremes)

    @property
    def driveline(self) -> Records[Bounds]:
        """Torque of every spring of the driveline with its damper, on the inertia behind it [N m]."""
        return self._all("driveline", Bounds)

    @property
    def mounts(self) -> Records[Peak2]:
        """Force of every mount [N]."""
        return self._all("mounts", Peak2)

    @property
    def position(self) -> Records[Bounds]:
        """Place of the block's origin along x, y and z [m]; empty with a fixed block."""
        return self._all("position", Bounds)

    @property
    def rotors(self) -> Records[RotorExtremes]:
        """Crankshafts, then balance shafts, where reactions were asked for."""
        return self._all("rotors", RotorExtremes)

    @property
    def shaft_torque(self) -> Bounds | None:
        """Torque that the crank train delivers at crankshaft 1 [N m], where reactions were asked for."""
        return self._of("shaft_torque", Bounds)  # type: ignore[no-any-return]

    @property
    def speed(self) -> Bounds:
        """Speed of crankshaft 1 relative to the block [rad/s]."""
        return self._of("speed", Bounds)  # type: ignore[no-any-return]

    @property
    def turn(self) -> Records[Bounds]:
        """Turn of the block about x, y and z [rad]; empty with a fixed block."""
        return self._all("turn", Bounds)


class RunFindings(Record):
    """What measured runs say."""

    __slots__ = ()
    _FIELDS = ("condition", "influence", "log", "sensors",)

    @property
    def condition(self) -> float | None:
        """Condition of the influence coefficients, with the planes' effects at equal size; 1 is best."""
        return self._get("condition")  # type: ignore[no-any-return]

    @property
    def influence(self) -> Records[Influence]:
        """Effect of each plane on each sensor at each speed."""
        return self._all("influence", Influence)

    @property
    def log(self) -> Records[RunEntry]:
        """Every run, with what the runs before it predicted."""
        return self._all("log", RunEntry)

    @property
    def sensors(self) -> Records[SensorPrediction]:
        """Every sensor at every speed: as the rotor is now, and as predicted with the correction."""
        return self._all("sensors", SensorPrediction)


class RunOutcome(Record):
    """How a run ended."""

    __slots__ = ()
    _FIELDS = ("kind", "held_by", "theta", "torque", "quantity", "reason",)

    @property
    def kind(self) -> Literal['complete', 'stopped', 'at-rest', 'cancelled', 'too-many-evaluations', 'failed']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def held_by(self) -> float | None:
        """Torque by which friction and load can hold it [N m]."""
        return self._get("held_by")  # type: ignore[no-any-return]

    @property
    def theta(self) -> float | None:
        """Crank angle [rad] of the last good state."""
        return self._get("theta")  # type: ignore[no-any-return]

    @property
    def torque(self) -> float | None:
        """Torque that gas, weight and starter still give there [N m]."""
        return self._get("torque")  # type: ignore[no-any-return]

    @property
    def quantity(self) -> str | None:
        """Which quantity of the state became no number, where one did."""
        return self._get("quantity")  # type: ignore[no-any-return]

    @property
    def reason(self) -> IntegrationOutcome | None:
        """What the integrator says."""
        return self._of("reason", IntegrationOutcome)  # type: ignore[no-any-return]


class Samples(Record):
    """One vector a quantity, one value a sample."""

    __slots__ = ()
    _FIELDS = ("acceleration", "driveline", "driveline_springs", "driveline_torque", "friction_torque", "gas_torque", "governor", "load_torque", "mounts", "orientation", "outside_torque", "piston_friction_torque", "position", "reactions", "speed", "spin", "starter_torque", "theta", "time", "velocity",)

    @property
    def acceleration(self) -> FloatArray:
        """The rate of that [rad/s^2]."""
        return self._array("acceleration")  # type: ignore[no-any-return]

    @property
    def driveline(self) -> list[FloatArray]:
        """Angle [rad] and speed [rad/s] of the inertias of the driveline."""
        return self._rows("driveline")  # type: ignore[no-any-return]

    @property
    def driveline_springs(self) -> list[FloatArray]:
        """Twist [rad] of the springs before them, and their torque with their dampers on the inertia behind each [N m]; 0 of an open clutch."""
        return self._rows("driveline_springs")  # type: ignore[no-any-return]

    @property
    def driveline_torque(self) -> FloatArray:
        """Torque of the driveline on crankshaft 1 [N m]."""
        return self._array("driveline_torque")  # type: ignore[no-any-return]

    @property
    def friction_torque(self) -> FloatArray:
        """Torque of dry friction on crankshaft 1 [N m]."""
        return self._array("friction_torque")  # type: ignore[no-any-return]

    @property
    def gas_torque(self) -> FloatArray:
        """Torque of the gas on crankshaft 1 [N m]."""
        return self._array("gas_torque")  # type: ignore[no-any-return]

    @property
    def governor(self) -> FloatArray:
        """Factor of the governor on the fired part of the gas, from 0 to 1; empty without one."""
        return self._array("governor")  # type: ignore[no-any-return]

    @property
    def load_torque(self) -> FloatArray:
        """Torque of the load on the shaft that it sits on [N m]."""
        return self._array("load_torque")  # type: ignore[no-any-return]

    @property
    def mounts(self) -> list[FloatArray]:
        """Force of the block on every mount [N], axes of the frame."""
        return self._rows("mounts")  # type: ignore[no-any-return]

    @property
    def orientation(self) -> FloatArray:
        """Turn of the block: unit quaternion `(w, x, y, z)`."""
        return self._array("orientation")  # type: ignore[no-any-return]

    @property
    def outside_torque(self) -> FloatArray:
        """Torque from the ground on crankshaft 1 besides: over the angle, and of an imposed speed's drive [N m]."""
        return self._array("outside_torque")  # type: ignore[no-any-return]

    @property
    def piston_friction_torque(self) -> FloatArray:
        """Torque of the friction of the pistons on crankshaft 1 [N m]."""
        return self._array("piston_friction_torque")  # type: ignore[no-any-return]

    @property
    def position(self) -> FloatArray:
        """Where the block's origin is [m], axes of the frame; empty with a fixed block, as all of the block."""
        return self._array("position")  # type: ignore[no-any-return]

    @property
    def reactions(self) -> Records[Reactions]:
        """All reactions, where they were asked for."""
        return self._all("reactions", Reactions)

    @property
    def speed(self) -> FloatArray:
        """Its rate [rad/s]."""
        return self._array("speed")  # type: ignore[no-any-return]

    @property
    def spin(self) -> FloatArray:
        """Its angular velocity [rad/s], block axes."""
        return self._array("spin")  # type: ignore[no-any-return]

    @property
    def starter_torque(self) -> FloatArray:
        """Torque of the starter on crankshaft 1 [N m]."""
        return self._array("starter_torque")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle of crankshaft 1 relative to the block [rad]."""
        return self._array("theta")  # type: ignore[no-any-return]

    @property
    def time(self) -> FloatArray:
        """Time [s]."""
        return self._array("time")  # type: ignore[no-any-return]

    @property
    def velocity(self) -> FloatArray:
        """Velocity of its origin [m/s], block axes."""
        return self._array("velocity")  # type: ignore[no-any-return]


class Scatter(Record):
    """Scatter of all outputs."""

    __slots__ = ()
    _FIELDS = ("outputs", "samples", "seed", "variables", "version",)

    @property
    def outputs(self) -> Records[OutputScatter]:
        """By output, in the order of the request."""
        return self._all("outputs", OutputScatter)

    @property
    def samples(self) -> int:
        """Samples drawn."""
        return self._get("samples")  # type: ignore[no-any-return]

    @property
    def seed(self) -> int:
        """Seed."""
        return self._get("seed")  # type: ignore[no-any-return]

    @property
    def variables(self) -> int:
        """Deviations drawn for each sample."""
        return self._get("variables")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class ScatterStudy(Result):
    """Scatter of an engine by the tolerances of its file."""

    __slots__ = ()
    _FIELDS = ("capability", "deviations", "engine", "limits", "scatter", "speed", "tightened", "tolerances", "version", "worst_cases",)

    @property
    def capability(self) -> float:
        """Capability that is wanted."""
        return self._get("capability")  # type: ignore[no-any-return]

    @property
    def deviations(self) -> Records[Deviation]:
        """Deviations drawn for each sample, in the order of those of the worst cases."""
        return self._all("deviations", Deviation)

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def limits(self) -> Records[LimitVerdict]:
        """The limits."""
        return self._all("limits", LimitVerdict)

    @property
    def scatter(self) -> Scatter:
        """The samples: percentiles of 0 to 100 % in steps of half a percent, then those of `TOLD_SHARES`."""
        return self._of("scatter", Scatter)  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of the crankshaft [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def tightened(self) -> Records[Tightened]:
        """What halving each tolerance alone would do, with the same draws."""
        return self._all("tightened", Tightened)

    @property
    def tolerances(self) -> Records[Tolerance]:
        """Its tolerances."""
        return self._all("tolerances", Tolerance)

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def worst_cases(self) -> Records[WorstCase]:
        """The worst case of each output."""
        return self._all("worst_cases", WorstCase)


class Seat(Variant):
    """What a free weight sits on."""

    __slots__ = ()
    _FIELDS = ("kind", "crankshaft", "shaft",)

    @property
    def kind(self) -> Literal['crankshaft', 'shaft']:
        """Which of the variants it is."""
        return self._kind()  # type: ignore[no-any-return]

    @property
    def crankshaft(self) -> int | None:
        """A crankshaft of the engine (its web, flywheel or pulley), by index."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def shaft(self) -> int | None:
        """A shaft of `shafts`, by index."""
        return self._get("shaft")  # type: ignore[no-any-return]


class SectionRatios(Record):
    """Sizes over the pin's diameter D [1]."""

    __slots__ = ()
    _FIELDS = ("b", "d_journal", "d_oil", "d_pin", "r_journal", "r_pin", "s", "t_journal", "t_pin", "w",)

    @property
    def b(self) -> float:
        """Width of the web, B/D."""
        return self._get("b")  # type: ignore[no-any-return]

    @property
    def d_journal(self) -> float:
        """Bore of the journal, D_BG/D."""
        return self._get("d_journal")  # type: ignore[no-any-return]

    @property
    def d_oil(self) -> float | None:
        """Oil bore, D_O/D."""
        return self._get("d_oil")  # type: ignore[no-any-return]

    @property
    def d_pin(self) -> float:
        """Bore of the pin, D_BH/D."""
        return self._get("d_pin")  # type: ignore[no-any-return]

    @property
    def r_journal(self) -> float:
        """Fillet of the journal, R_G/D."""
        return self._get("r_journal")  # type: ignore[no-any-return]

    @property
    def r_pin(self) -> float:
        """Fillet of the pin, R_H/D."""
        return self._get("r_pin")  # type: ignore[no-any-return]

    @property
    def s(self) -> float:
        """Overlap of pin and journal, ((D + D_G)/2 - E)/D."""
        return self._get("s")  # type: ignore[no-any-return]

    @property
    def t_journal(self) -> float:
        """Undercut of the journal's fillet, T_G/D."""
        return self._get("t_journal")  # type: ignore[no-any-return]

    @property
    def t_pin(self) -> float:
        """Undercut of the pin's fillet, T_H/D."""
        return self._get("t_pin")  # type: ignore[no-any-return]

    @property
    def w(self) -> float:
        """Thickness of the web, W/D."""
        return self._get("w")  # type: ignore[no-any-return]


class Sensitivity(Result):
    """Sensitivities of an engine."""

    __slots__ = ()
    _FIELDS = ("counterweights", "engine", "inputs", "outputs", "sobol", "speed", "version", "weights",)

    @property
    def counterweights(self) -> int:
        """How many counterweights there are."""
        return self._get("counterweights")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def inputs(self) -> Records[VariedInput]:
        """What varies."""
        return self._all("inputs", VariedInput)

    @property
    def outputs(self) -> Records[OutputSensitivity]:
        """By output."""
        return self._all("outputs", OutputSensitivity)

    @property
    def sobol(self) -> Sobol | None:
        """Shares of the variance over all ranges at once."""
        return self._of("sobol", Sobol)  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def weights(self) -> Literal['fixed', 'follow']:
        """What the counterweights do while throws and masses vary."""
        return self._get("weights")  # type: ignore[no-any-return]


class SensorEntry(Record):
    """A sensor in a run of the log."""

    __slots__ = ()
    _FIELDS = ("measured", "missed", "predicted", "sensor",)

    @property
    def measured(self) -> ShownVibration:
        """As measured."""
        return self._of("measured", ShownVibration)  # type: ignore[no-any-return]

    @property
    def missed(self) -> float | None:
        """Measured less predicted: amplitude of the difference as the sensor's detector gives it."""
        return self._get("missed")  # type: ignore[no-any-return]

    @property
    def predicted(self) -> ShownVibration | None:
        """As the runs before predict it; `None` where they do not tell the effect of every weight on the rotor."""
        return self._of("predicted", ShownVibration)  # type: ignore[no-any-return]

    @property
    def sensor(self) -> str:
        """Name of the sensor."""
        return self._get("sensor")  # type: ignore[no-any-return]


class SensorPrediction(Record):
    """A sensor at one speed."""

    __slots__ = ()
    _FIELDS = ("after", "limit", "now", "scatter", "sensor", "speed",)

    @property
    def after(self) -> ShownVibration | None:
        """With the corrections made as told."""
        return self._of("after", ShownVibration)  # type: ignore[no-any-return]

    @property
    def limit(self) -> float | None:
        """Largest amplitude accepted, as the sensor's detector gives it."""
        return self._get("limit")  # type: ignore[no-any-return]

    @property
    def now(self) -> ShownVibration:
        """As the rotor is now: as measured, or as fitted where the last run's weights were taken off again."""
        return self._of("now", ShownVibration)  # type: ignore[no-any-return]

    @property
    def scatter(self) -> float | None:
        """Standard deviation of one reading as the sensor's detector gives it, from what the fit leaves over; `None` where
        the runs leave no freedom.
        """
        return self._get("scatter")  # type: ignore[no-any-return]

    @property
    def sensor(self) -> str:
        """Name of the sensor."""
        return self._get("sensor")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]


class Series(Record):
    """One quantity over the samples of a run."""

    __slots__ = ()
    _FIELDS = ("name", "unit", "values",)

    @property
    def name(self) -> str:
        """Its name: `crank.momentum`."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """Its unit."""
        return self._get("unit")  # type: ignore[no-any-return]

    @property
    def values(self) -> FloatArray:
        """Its values."""
        return self._array("values")  # type: ignore[no-any-return]


class SeriesStatistics(Record):
    """Mean and deviation of one course over time."""

    __slots__ = ()
    _FIELDS = ("deviation", "mean", "name", "unit",)

    @property
    def deviation(self) -> float:
        """Root of the mean square of what departs from it."""
        return self._get("deviation")  # type: ignore[no-any-return]

    @property
    def mean(self) -> float:
        """Mean over time."""
        return self._get("mean")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """What it is."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def unit(self) -> str:
        """Its unit."""
        return self._get("unit")  # type: ignore[no-any-return]


class Shaft(Record):
    """What joins two stations."""

    __slots__ = ()
    _FIELDS = ("damping", "from_", "kind", "loss_factor", "name", "ratio", "section", "spin_stiffness", "stiffness", "to",)

    @property
    def damping(self) -> float:
        """Viscous damping of its twist [N m s/rad]."""
        return self._get("damping")  # type: ignore[no-any-return]

    @property
    def from_(self) -> int:
        """Index of the station at its front end."""
        return self._get("from")  # type: ignore[no-any-return]

    @property
    def kind(self) -> Literal['shaft', 'damper', 'pendulum', 'coupling']:
        """What it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def loss_factor(self) -> float:
        """Loss factor of its stiffness [1]."""
        return self._get("loss_factor")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> float:
        """Its speed over that of the reference."""
        return self._get("ratio")  # type: ignore[no-any-return]

    @property
    def section(self) -> ShaftSection | None:
        """Section in which its stress is told, where it is a shaft of known size."""
        return self._of("section", ShaftSection)  # type: ignore[no-any-return]

    @property
    def spin_stiffness(self) -> float:
        """Stiffness over the square of the reference speed, of a pendulum in the centrifugal field [N m s^2/rad^3]."""
        return self._get("spin_stiffness")  # type: ignore[no-any-return]

    @property
    def stiffness(self) -> float:
        """Stiffness at its own speed [N m/rad]."""
        return self._get("stiffness")  # type: ignore[no-any-return]

    @property
    def to(self) -> int:
        """Index of the station at its rear end."""
        return self._get("to")  # type: ignore[no-any-return]


class ShaftDesign(Record):
    """A balance shaft whose weights follow from the engine that it serves."""

    __slots__ = ()
    _FIELDS = ("order", "removes", "sense", "x", "y",)

    @property
    def order(self) -> int:
        """Speed over that of the crank: 1 or 2."""
        return self._get("order")  # type: ignore[no-any-return]

    @property
    def removes(self) -> Removes:
        """What its weights remove."""
        return self._of("removes", Removes)  # type: ignore[no-any-return]

    @property
    def sense(self) -> Literal['forward', 'backward']:
        """With the crank or against it."""
        return self._get("sense")  # type: ignore[no-any-return]

    @property
    def x(self) -> float:
        """Position of its axis [m]."""
        return self._get("x")  # type: ignore[no-any-return]

    @property
    def y(self) -> float:
        """Position of its axis [m]."""
        return self._get("y")  # type: ignore[no-any-return]


class ShaftLayout(Record):
    """The weights of a balance shaft."""

    __slots__ = ()
    _FIELDS = ("kind", "z",)

    @property
    def kind(self) -> Literal['single', 'double', 'two-planes']:
        """Which of the variants it is."""
        return self._get("kind")  # type: ignore[no-any-return]

    @property
    def z(self) -> FloatArray:
        """Planes [m]."""
        return self._array("z")  # type: ignore[no-any-return]


class ShaftRun(Record):
    """How a shaft that floats in its films ran."""

    __slots__ = ()
    _FIELDS = ("cavitation", "change", "crankshaft", "energy", "energy_error", "outcome", "periods", "steps",)

    @property
    def cavitation(self) -> Literal['full', 'gumbel', 'reynolds', 'mass-conserving']:
        """Model of cavitation."""
        return self._get("cavitation")  # type: ignore[no-any-return]

    @property
    def change(self) -> float:
        """Largest change of an orbit from the last period but one, over the clearance."""
        return self._get("change")  # type: ignore[no-any-return]

    @property
    def crankshaft(self) -> int:
        """Number of the crankshaft, from 1."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def energy(self) -> FilmEnergy | None:
        """Energies of the last period; `None` where it ended early."""
        return self._of("energy", FilmEnergy)  # type: ignore[no-any-return]

    @property
    def energy_error(self) -> float | None:
        """Missing energy over the turnover."""
        return self._get("energy_error")  # type: ignore[no-any-return]

    @property
    def outcome(self) -> Literal['periodic', 'not_periodic', 'overloaded']:
        """How the orbits ended."""
        return self._get("outcome")  # type: ignore[no-any-return]

    @property
    def periods(self) -> int:
        """Periods that were run."""
        return self._get("periods")  # type: ignore[no-any-return]

    @property
    def steps(self) -> int:
        """Steps of all periods."""
        return self._get("steps")  # type: ignore[no-any-return]


class ShaftSection(Record):
    """A round section."""

    __slots__ = ()
    _FIELDS = ("bore", "diameter",)

    @property
    def bore(self) -> float:
        """Diameter of the bore [m]."""
        return self._get("bore")  # type: ignore[no-any-return]

    @property
    def diameter(self) -> float:
        """Outer diameter [m]."""
        return self._get("diameter")  # type: ignore[no-any-return]


class ShaftSet(Record):
    """Balance shafts that a layout may have; an empty set is none."""

    __slots__ = ()
    _FIELDS = ("name", "shafts",)

    @property
    def name(self) -> str:
        """What the user calls it."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def shafts(self) -> Records[ShaftDesign]:
        """Its shafts."""
        return self._all("shafts", ShaftDesign)


class ShaftSweep(Record):
    """A shaft over speed."""

    __slots__ = ()
    _FIELDS = ("by_order", "largest", "loss", "mean", "shaft", "stress_rate", "sum", "total",)

    @property
    def by_order(self) -> list[FloatArray]:
        """Amplitude of the torque of each order at each speed [N m]."""
        return self._rows("by_order")  # type: ignore[no-any-return]

    @property
    def largest(self) -> FloatArray:
        """Largest absolute torque, the mean included [N m]."""
        return self._array("largest")  # type: ignore[no-any-return]

    @property
    def loss(self) -> FloatArray:
        """Power lost in it [W]."""
        return self._array("loss")  # type: ignore[no-any-return]

    @property
    def mean(self) -> FloatArray:
        """Mean torque [N m], all of it taken at the end of the chain."""
        return self._array("mean")  # type: ignore[no-any-return]

    @property
    def shaft(self) -> int:
        """Index of the shaft."""
        return self._get("shaft")  # type: ignore[no-any-return]

    @property
    def stress_rate(self) -> float | None:
        """Shear stress over torque at the surface of its section [1/m^3]; `None` where its section is not known."""
        return self._get("stress_rate")  # type: ignore[no-any-return]

    @property
    def sum(self) -> FloatArray:
        """Sum of the amplitudes of all orders, whatever their phases [N m]."""
        return self._array("sum")  # type: ignore[no-any-return]

    @property
    def total(self) -> FloatArray:
        """Amplitude of the torque of all orders in true phase [N m]."""
        return self._array("total")  # type: ignore[no-any-return]


class ShapeTask(Record):
    """Shapes among which a counterweight is to be found. Its duty, the unbalance, is that of the weight."""

    __slots__ = ()
    _FIELDS = ("arc_angle", "arc_radius", "density", "least_balance", "limits", "minimise", "most_balance", "rectangle_height", "settings", "shoulder", "thickness", "web_radius",)

    @property
    def arc_angle(self) -> Range:
        """Included angle `alpha` of the arc [rad]."""
        return self._of("arc_angle", Range)  # type: ignore[no-any-return]

    @property
    def arc_radius(self) -> Range:
        """Radius `R` of the arc [m]."""
        return self._of("arc_radius", Range)  # type: ignore[no-any-return]

    @property
    def density(self) -> float:
        """Density [kg/m^3]."""
        return self._get("density")  # type: ignore[no-any-return]

    @property
    def least_balance(self) -> float:
        """Least unbalance as a part of the duty: 1 for full balance."""
        return self._get("least_balance")  # type: ignore[no-any-return]

    @property
    def limits(self) -> DesignLimits:
        """Limits."""
        return self._of("limits", DesignLimits)  # type: ignore[no-any-return]

    @property
    def minimise(self) -> Literal['mass', 'swept-radius', 'inertia', 'thickness']:
        """What is made as small as possible."""
        return self._get("minimise")  # type: ignore[no-any-return]

    @property
    def most_balance(self) -> float | None:
        """Largest unbalance as a part of it, if there is one."""
        return self._get("most_balance")  # type: ignore[no-any-return]

    @property
    def rectangle_height(self) -> Range:
        """Height `h` of the rectangle [m]."""
        return self._of("rectangle_height", Range)  # type: ignore[no-any-return]

    @property
    def settings(self) -> DesignSettings:
        """How far the proof goes."""
        return self._of("settings", DesignSettings)  # type: ignore[no-any-return]

    @property
    def shoulder(self) -> Shoulder:
        """The flank."""
        return self._of("shoulder", Shoulder)  # type: ignore[no-any-return]

    @property
    def thickness(self) -> Range:
        """Thickness [m]."""
        return self._of("thickness", Range)  # type: ignore[no-any-return]

    @property
    def web_radius(self) -> Range:
        """Radius `r` of the web's disc [m]."""
        return self._of("web_radius", Range)  # type: ignore[no-any-return]


class SharedWithWeb(Record):
    """What a shape shares with its plain web beyond the web's disc: it is the web's."""

    __slots__ = ()
    _FIELDS = ("inertia", "mass", "unbalance",)

    @property
    def inertia(self) -> float:
        """Polar inertia about the crank axis [kg m^2]."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> float:
        """Unbalance [kg m]."""
        return self._get("unbalance")  # type: ignore[no-any-return]


class Shoulder(Variant):
    """How the flank between rectangle and arc is given."""

    __slots__ = ()
    _FIELDS = ("kind", "angle", "height",)

    @property
    def kind(self) -> Literal['Angle', 'Height']:
        """Which of the variants it is."""
        return self._kind()  # type: ignore[no-any-return]

    @property
    def angle(self) -> Range | None:
        """By the angle `delta` between chord and flank [rad], from 0 (a flat step) to less than a quarter turn. The height follows."""
        return self._of("Angle", Range)  # type: ignore[no-any-return]

    @property
    def height(self) -> Range | None:
        """By the height `H` of the trapezoid [m]. The angle follows."""
        return self._of("Height", Range)  # type: ignore[no-any-return]


class ShownVibration(Record):
    """A vibration as the instrument shows it, and as a vector to be drawn."""

    __slots__ = ()
    _FIELDS = ("amplitude", "phase", "quantity",)

    @property
    def amplitude(self) -> float:
        """Amplitude as the sensor's detector gives it [m, m/s or m/s^2]."""
        return self._get("amplitude")  # type: ignore[no-any-return]

    @property
    def phase(self) -> float:
        """Phase in the convention of the sheet [rad], within [0, 2 pi)."""
        return self._get("phase")  # type: ignore[no-any-return]

    @property
    def quantity(self) -> Literal['displacement', 'velocity', 'acceleration']:
        """What the sensor measures."""
        return self._get("quantity")  # type: ignore[no-any-return]


class Similar(Record):
    """A similar engine: what its size and its speed are, over those of the original."""

    __slots__ = ()
    _FIELDS = ("length", "speed",)

    @property
    def length(self) -> float:
        """Lengths, over those of the original."""
        return self._get("length")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of the crankshaft, over that of the original."""
        return self._get("speed")  # type: ignore[no-any-return]


class SimulatedOrder(Record):
    """One order of the last period: what the crank train does to the block and at its shaft, and how speed and block follow."""

    __slots__ = ()
    _FIELDS = ("loads", "motion", "speed",)

    @property
    def loads(self) -> OrderLoads:
        """Loads on the block and torque at crankshaft 1."""
        return self._of("loads", OrderLoads)  # type: ignore[no-any-return]

    @property
    def motion(self) -> FloatArray:
        """Parts of the motion of the block's origin across the crank axis that turn with the crank and against it [m]; 0 with a fixed block."""
        return self._array("motion")  # type: ignore[no-any-return]

    @property
    def speed(self) -> FloatArray:
        """Speed of crankshaft 1 [rad/s]."""
        return self._array("speed")  # type: ignore[no-any-return]


class SimulationResult(Result):
    """A simulated run with what its reader must know."""

    __slots__ = ()
    _FIELDS = ("actions", "engine", "gas", "gears", "heat", "main_rule", "mains", "mounts", "notes", "period", "periodic", "points", "revolutions", "run", "version",)

    @property
    def actions(self) -> list[str]:
        """What each event of the run does, in words."""
        return self._list("actions")  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def gas(self) -> str | None:
        """Where the pressures come from, in words; `None`: no gas."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def gears(self) -> list[str]:
        """Names of what turns besides crankshaft 1, in the order of the rotors of the reactions."""
        return self._list("gears")  # type: ignore[no-any-return]

    @property
    def heat(self) -> PeriodHeat | None:
        """Heat of the last period, where the pressures are those of a computed cycle and every cylinder has all its fuel."""
        return self._of("heat", PeriodHeat)  # type: ignore[no-any-return]

    @property
    def main_rule(self) -> Literal['cut', 'springs', 'beam']:
        """The rule of main bearings that tables of one rule and pictures show."""
        return self._get("main_rule")  # type: ignore[no-any-return]

    @property
    def mains(self) -> list[FloatArray]:
        """Planes of the main bearings [m], by crankshaft."""
        return self._rows("mains")  # type: ignore[no-any-return]

    @property
    def mounts(self) -> list[str]:
        """Names of the mounts."""
        return self._list("mounts")  # type: ignore[no-any-return]

    @property
    def notes(self) -> list[str]:
        """What was chosen where nothing was said, and what the file gives but the run does not use."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def period(self) -> PeriodSummary:
        """The last period in numbers."""
        return self._of("period", PeriodSummary)  # type: ignore[no-any-return]

    @property
    def periodic(self) -> PeriodicResult | None:
        """How the search for a periodic motion ended, where one was asked for."""
        return self._of("periodic", PeriodicResult)  # type: ignore[no-any-return]

    @property
    def points(self) -> Records[PointMotion2]:
        """Motion of the points of the block that were asked for."""
        return self._all("points", PointMotion2)

    @property
    def revolutions(self) -> int:
        """Revolutions after which all shafts and cylinders stand as before."""
        return self._get("revolutions")  # type: ignore[no-any-return]

    @property
    def run(self) -> Run2:
        """The run."""
        return self._of("run", Run2)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class Size(Variant):
    """Which number of a load over the cycle."""

    __slots__ = ()
    _FIELDS = ("kind", "order",)

    @property
    def kind(self) -> Literal['peak', 'mean', 'order']:
        """Which of the variants it is.
        `peak`: Largest size over the continuous angle; of what has no angle the size itself.
        `mean`: Mean: of a torque with its sign, of forces the mean of their size.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def order(self) -> float | None:
        """Size of one order [cycles per revolution of crankshaft 1]: the largest resultant of that order over the cycle."""
        return self._get("order")  # type: ignore[no-any-return]


class Slope(Record):
    """Derivative of an output by an input, in SI units.

    A size that is zero grows whichever way the input goes, and of two equal peaks one may grow while the other falls: there the derivatives
    on both sides differ. Infinite (`null` in JSON) where the output leaps: a peak between jumps of several pressures at one angle, which part
    when the input goes however little.
    """

    __slots__ = ()
    _FIELDS = ("down", "up",)

    @property
    def down(self) -> float:
        """For a smaller input."""
        return self._get("down")  # type: ignore[no-any-return]

    @property
    def up(self) -> float:
        """For a larger input."""
        return self._get("up")  # type: ignore[no-any-return]


class Slug(Record):
    """Slugs that may be set into one counterweight."""

    __slots__ = ()
    _FIELDS = ("crank_density", "density", "diameter", "land", "longest", "radius", "rim", "sector",)

    @property
    def crank_density(self) -> float:
        """Density of the crank [kg/m^3]."""
        return self._get("crank_density")  # type: ignore[no-any-return]

    @property
    def density(self) -> float:
        """Its density [kg/m^3]."""
        return self._get("density")  # type: ignore[no-any-return]

    @property
    def diameter(self) -> float:
        """Diameter [m]."""
        return self._get("diameter")  # type: ignore[no-any-return]

    @property
    def land(self) -> float:
        """Least metal between two holes and between a hole and the rim [m]."""
        return self._get("land")  # type: ignore[no-any-return]

    @property
    def longest(self) -> float:
        """Longest length [m]: the counterweight's thickness, or as far as it may be drilled."""
        return self._get("longest")  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Distance of its axis from the crank axis [m]."""
        return self._get("radius")  # type: ignore[no-any-return]

    @property
    def rim(self) -> float:
        """Outer radius of the counterweight [m]."""
        return self._get("rim")  # type: ignore[no-any-return]

    @property
    def sector(self) -> float:
        """Angle between the outermost slug axes that the counterweight has room for [rad]."""
        return self._get("sector")  # type: ignore[no-any-return]


class SlugPlan(Record):
    """Slugs for one counterweight."""

    __slots__ = ()
    _FIELDS = ("added_mass", "directions", "gain_of_one", "gained", "length", "reached", "slug", "wanted",)

    @property
    def added_mass(self) -> float:
        """Mass that the counterweight gains [kg]."""
        return self._get("added_mass")  # type: ignore[no-any-return]

    @property
    def directions(self) -> FloatArray:
        """Direction of every slug, in the frame of the crankshaft [rad]."""
        return self._array("directions")  # type: ignore[no-any-return]

    @property
    def gain_of_one(self) -> float:
        """Most that one slug gains, along its own direction [kg m]."""
        return self._get("gain_of_one")  # type: ignore[no-any-return]

    @property
    def gained(self) -> FloatArray:
        """Unbalance gained [kg m]."""
        return self._array("gained")  # type: ignore[no-any-return]

    @property
    def length(self) -> float:
        """Length of every slug [m]."""
        return self._get("length")  # type: ignore[no-any-return]

    @property
    def reached(self) -> bool:
        """Whether the counterweight has room for all that is wanted."""
        return self._get("reached")  # type: ignore[no-any-return]

    @property
    def slug(self) -> Slug:
        """What the slugs are cut from."""
        return self._of("slug", Slug)  # type: ignore[no-any-return]

    @property
    def wanted(self) -> FloatArray:
        """Unbalance that is wanted, in the frame of the crankshaft [kg m]."""
        return self._array("wanted")  # type: ignore[no-any-return]


class Smallest(Record):
    """The smallest clearance of all."""

    __slots__ = ()
    _FIELDS = ("body", "clearance",)

    @property
    def body(self) -> str:
        """Name of the counterweight or web, or "big end 2"."""
        return self._get("body")  # type: ignore[no-any-return]

    @property
    def clearance(self) -> Clearance:
        """The clearance."""
        return self._of("clearance", Clearance)  # type: ignore[no-any-return]


class Sobol(Record):
    """Variance-based sensitivities."""

    __slots__ = ()
    _FIELDS = ("impossible", "indices", "samples", "seed", "spreads",)

    @property
    def impossible(self) -> int:
        """Draws left out since one of their engines cannot turn, or has a mass below nothing."""
        return self._get("impossible")  # type: ignore[no-any-return]

    @property
    def indices(self) -> list[Records[Index]]:
        """By output, then by input. Zero where the output does not vary."""
        return self._as("indices", every(record(Index)), [])  # type: ignore[no-any-return]

    @property
    def samples(self) -> int:
        """Draws of each of the two tables; the engine is computed `inputs + 2` times for each."""
        return self._get("samples")  # type: ignore[no-any-return]

    @property
    def seed(self) -> int:
        """Seed of the draws."""
        return self._get("seed")  # type: ignore[no-any-return]

    @property
    def spreads(self) -> FloatArray:
        """By output: mean and standard deviation over the ranges."""
        return self._array("spreads")  # type: ignore[no-any-return]


class SolveReport(Record):
    """How a system was solved."""

    __slots__ = ()
    _FIELDS = ("bytes", "factor_entries", "factor_operations", "iterations", "nonzeros", "precision", "residual", "unknowns",)

    @property
    def bytes(self) -> int:
        """Bytes of matrix and factor."""
        return self._get("bytes")  # type: ignore[no-any-return]

    @property
    def factor_entries(self) -> int:
        """Entries of the factor."""
        return self._get("factor_entries")  # type: ignore[no-any-return]

    @property
    def factor_operations(self) -> float:
        """Floating-point operations of the factor."""
        return self._get("factor_operations")  # type: ignore[no-any-return]

    @property
    def iterations(self) -> int:
        """Largest number of iterations of a load case."""
        return self._get("iterations")  # type: ignore[no-any-return]

    @property
    def nonzeros(self) -> int:
        """Entries of the lower triangle of the matrix."""
        return self._get("nonzeros")  # type: ignore[no-any-return]

    @property
    def precision(self) -> Literal['single', 'double']:
        """Precision of the factor."""
        return self._get("precision")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """Largest `|K u - f|/|f|` of a load case."""
        return self._get("residual")  # type: ignore[no-any-return]

    @property
    def unknowns(self) -> int:
        """Unknowns."""
        return self._get("unknowns")  # type: ignore[no-any-return]


class Sourced(Record):
    """A number with its origin."""

    __slots__ = ()
    _FIELDS = ("origin", "value",)

    @property
    def origin(self) -> Literal['given', 'from-shape', 'typical', 'assumed']:
        """Where it comes from."""
        return self._get("origin")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """The number, in SI units."""
        return self._get("value")  # type: ignore[no-any-return]


class SpacingArrangements(Record):
    """The arrangements at one cylinder spacing."""

    __slots__ = ()
    _FIELDS = ("arrangements", "baseline", "front", "left_out", "scale", "simplest", "spacing",)

    @property
    def arrangements(self) -> Records[Arrangement]:
        """All that were examined, by rising number of shafts."""
        return self._all("arrangements", Arrangement)

    @property
    def baseline(self) -> float:
        """The criterion with nothing added (balance shafts of the engine file taken out)."""
        return self._get("baseline")  # type: ignore[no-any-return]

    @property
    def front(self) -> list[int]:
        """Indices of those that no other beats, by falling residual."""
        return self._list("front")  # type: ignore[no-any-return]

    @property
    def left_out(self) -> list[str]:
        """What was not examined, and why."""
        return self._list("left_out")  # type: ignore[no-any-return]

    @property
    def scale(self) -> float:
        """Every z of throws, cylinders and counterweights over that of the engine file."""
        return self._get("scale")  # type: ignore[no-any-return]

    @property
    def simplest(self) -> int | None:
        """Index of the simplest that reaches the limit and has a place: fewest shafts, meshes, then mass."""
        return self._get("simplest")  # type: ignore[no-any-return]

    @property
    def spacing(self) -> float | None:
        """Cylinder spacing [m]; `None` where the engine has all its throws and cylinders in one plane."""
        return self._get("spacing")  # type: ignore[no-any-return]


class SpeedResponse(Record):
    """Response at one speed."""

    __slots__ = ()
    _FIELDS = ("orders", "peaks", "speed",)

    @property
    def orders(self) -> Records[OrderResponse]:
        """One entry an order that turns, as in the excitation; order 0 is left out."""
        return self._all("orders", OrderResponse)

    @property
    def peaks(self) -> Records[Extreme]:
        """Largest resultant force at each mount over the cycle [N], and the crank angle."""
        return self._all("peaks", Extreme)

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]


class SpeedRipple(Record):
    """Speed over the period, at one mean speed.

    Without gas the load is 0 and the energy stays: the inertia of pistons and rods alone makes the speed swing.
    """

    __slots__ = ()
    _FIELDS = ("acceleration", "excess", "extremes", "fluctuation", "inertia", "load", "mean_speed", "period", "simple_fluctuation", "speed", "theta", "version",)

    @property
    def acceleration(self) -> float:
        """Largest size of the angular acceleration [rad/s^2], among the samples."""
        return self._get("acceleration")  # type: ignore[no-any-return]

    @property
    def excess(self) -> float:
        """Largest excess energy at constant speed [J], gas and inertia."""
        return self._get("excess")  # type: ignore[no-any-return]

    @property
    def extremes(self) -> Extremes:
        """Its extremes over the continuous angle."""
        return self._of("extremes", Extremes)  # type: ignore[no-any-return]

    @property
    def fluctuation(self) -> float:
        """Fluctuation `(w_max - w_min) / w_mean` [1]."""
        return self._get("fluctuation")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> TrainInertia:
        """The inertia that it turns."""
        return self._of("inertia", TrainInertia)  # type: ignore[no-any-return]

    @property
    def load(self) -> float:
        """Mean torque of the load [N m]: that of the gas and of the torque over the angle that the file gives."""
        return self._get("load")  # type: ignore[no-any-return]

    @property
    def mean_speed(self) -> float:
        """Mean speed [rad/s]: angle over time."""
        return self._get("mean_speed")  # type: ignore[no-any-return]

    @property
    def period(self) -> float:
        """Period [rad] of crankshaft 1."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def simple_fluctuation(self) -> float:
        """Fluctuation by the formula of eq. (25.4): largest excess energy at constant speed over `J w^2`, with the mean inertia."""
        return self._get("simple_fluctuation")  # type: ignore[no-any-return]

    @property
    def speed(self) -> FloatArray:
        """Speed [rad/s]."""
        return self._array("speed")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle [rad], from 0, one period, end point excluded."""
        return self._array("theta")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class SpeedSheet(Record):
    """The sheet at one speed."""

    __slots__ = ()
    _FIELDS = ("speed", "throws",)

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def throws(self) -> Records[ThrowSheet]:
        """Throw by throw, from the free end on."""
        return self._all("throws", ThrowSheet)


class Stage(Record):
    """Criteria that are minimised together: the sum of weight times criterion."""

    __slots__ = ()
    _FIELDS = ("terms",)

    @property
    def terms(self) -> list[tuple[float, Criterion]]:
        """Positive weights and criteria."""
        return self._as("terms", every(row(one, Criterion)), [])  # type: ignore[no-any-return]


class StageGiveUp(Record):
    """What a stage gives up for later ones."""

    __slots__ = ()
    _FIELDS = ("least", "most", "used",)

    @property
    def least(self) -> float:
        """The least value that the stage reached by itself, in its unit; its proof is about this one."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def most(self) -> float:
        """The value that later stages had to keep, in its unit."""
        return self._get("most")  # type: ignore[no-any-return]

    @property
    def used(self) -> float:
        """How far they raised it, in its unit."""
        return self._get("used")  # type: ignore[no-any-return]


class Stall(Record):
    """Where a starter could not turn the crank on: the farthest place at which it came to a halt. All torques are those on crankshaft 1."""

    __slots__ = ()
    _FIELDS = ("held_by", "missing", "others", "ratio", "starter", "theta", "time",)

    @property
    def held_by(self) -> float:
        """Torque by which friction and load hold it [N m]."""
        return self._get("held_by")  # type: ignore[no-any-return]

    @property
    def missing(self) -> float:
        """What is missing to turn on from there [N m]."""
        return self._get("missing")  # type: ignore[no-any-return]

    @property
    def others(self) -> float:
        """Torque of gas, weight and driveline there [N m]; negative where they hold the crank back."""
        return self._get("others")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> float:
        """Turns of the starter for one of the crank."""
        return self._get("ratio")  # type: ignore[no-any-return]

    @property
    def starter(self) -> float:
        """Torque of the starter [N m]."""
        return self._get("starter")  # type: ignore[no-any-return]

    @property
    def theta(self) -> float:
        """Crank angle [rad]."""
        return self._get("theta")  # type: ignore[no-any-return]

    @property
    def time(self) -> float:
        """Time [s]."""
        return self._get("time")  # type: ignore[no-any-return]


class StaticStress(Result):
    """Static stress of a crankshaft under several loads.

    Linear, elastic, small displacements; loads as pressure over 180 degrees of the pins; constant speed.
    """

    __slots__ = ()
    _FIELDS = ("cases", "convergence", "gas", "notes", "sheet", "solve", "submodel", "support", "version",)

    @property
    def cases(self) -> Records[StressCase]:
        """The load cases."""
        return self._all("cases", StressCase)

    @property
    def convergence(self) -> Convergence | None:
        """With three meshes: what the numbers tend to; the cases are those of the finest."""
        return self._of("convergence", Convergence)  # type: ignore[no-any-return]

    @property
    def gas(self) -> str | None:
        """Where the pressures come from, in words; `None`: no gas acts."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def notes(self) -> list[str]:
        """What was assumed and left out."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def sheet(self) -> CrankSheet:
        """What was meshed."""
        return self._of("sheet", CrankSheet)  # type: ignore[no-any-return]

    @property
    def solve(self) -> SolveReport:
        """How the equations were solved."""
        return self._of("solve", SolveReport)  # type: ignore[no-any-return]

    @property
    def submodel(self) -> StressSubmodel | None:
        """One bay again, on a finer mesh."""
        return self._of("submodel", StressSubmodel)  # type: ignore[no-any-return]

    @property
    def support(self) -> str:
        """What holds it, in words."""
        return self._get("support")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class Station(Record):
    """A plane along the shaft."""

    __slots__ = ()
    _FIELDS = ("largest_moment", "largest_shear", "moment", "shear", "z",)

    @property
    def largest_moment(self) -> Extreme:
        """Largest `|M|` at the plane over the cycle [N m]."""
        return self._of("largest_moment", Extreme)  # type: ignore[no-any-return]

    @property
    def largest_shear(self) -> Extreme:
        """Largest `|Q|` just behind the plane over the cycle [N]."""
        return self._of("largest_shear", Extreme)  # type: ignore[no-any-return]

    @property
    def moment(self) -> FloatArray:
        """Bending moment `M_x + i M_y` [N m] of what lies before the plane on what lies behind it."""
        return self._array("moment")  # type: ignore[no-any-return]

    @property
    def shear(self) -> FloatArray:
        """Shear force `Q_x + i Q_y` just behind the plane [N], that of what lies before on what lies behind; just before the
        plane it is that of the station before, and 0 before the first.
        """
        return self._array("shear")  # type: ignore[no-any-return]

    @property
    def z(self) -> float:
        """Its place [m], from the origin."""
        return self._get("z")  # type: ignore[no-any-return]


class Station2(Record):
    """An inertia of the chain."""

    __slots__ = ()
    _FIELDS = ("damping", "inertia", "kind", "name", "ratio",)

    @property
    def damping(self) -> float:
        """Damping against the ground, at its own speed [N m s/rad]."""
        return self._get("damping")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> float:
        """Moment of inertia about its own axis [kg m^2]."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def kind(self) -> StationKind:
        """What it is."""
        return self._of("kind", StationKind)  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> float:
        """Its speed over that of the reference (crankshaft 1)."""
        return self._get("ratio")  # type: ignore[no-any-return]


class StationKind(Variant):
    """What a station is."""

    __slots__ = ()
    _FIELDS = ("kind", "throw",)

    @property
    def kind(self) -> Literal['ring', 'nose', 'throw', 'flywheel', 'driven', 'pendulum', 'other']:
        """Which of the variants it is.
        `ring`: The seismic ring of a damper.
        `nose`: The free end: hub of the damper, pulley.
        `flywheel`: The flywheel, or the primary side of a dual-mass flywheel.
        `driven`: Behind the flywheel, or a branch.
        `pendulum`: A pendulum absorber.
        `other`: Anything else.
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def throw(self) -> int | None:
        """The throw with this index."""
        return self._get("throw")  # type: ignore[no-any-return]


class StationSweep(Record):
    """Angle of a station over speed."""

    __slots__ = ()
    _FIELDS = ("by_order", "station",)

    @property
    def by_order(self) -> list[FloatArray]:
        """Amplitude of each order at each speed, at its own speed [rad]."""
        return self._rows("by_order")  # type: ignore[no-any-return]

    @property
    def station(self) -> int:
        """Index of the station."""
        return self._get("station")  # type: ignore[no-any-return]


class Statistics(Record):
    """What runs have cost so far."""

    __slots__ = ()
    _FIELDS = ("evaluations", "events", "factorisations", "iterations", "jacobians", "rejected", "steps",)

    @property
    def evaluations(self) -> int:
        """Evaluations of `f`, those for differences included."""
        return self._get("evaluations")  # type: ignore[no-any-return]

    @property
    def events(self) -> int:
        """Located events."""
        return self._get("events")  # type: ignore[no-any-return]

    @property
    def factorisations(self) -> int:
        """Factorisations of Newton's matrices."""
        return self._get("factorisations")  # type: ignore[no-any-return]

    @property
    def iterations(self) -> int:
        """Newton iterations."""
        return self._get("iterations")  # type: ignore[no-any-return]

    @property
    def jacobians(self) -> int:
        """Jacobians."""
        return self._get("jacobians")  # type: ignore[no-any-return]

    @property
    def rejected(self) -> int:
        """Rejected steps."""
        return self._get("rejected")  # type: ignore[no-any-return]

    @property
    def steps(self) -> int:
        """Accepted steps."""
        return self._get("steps")  # type: ignore[no-any-return]


class StiffnessCentre(Record):
    """Centre of stiffness: where the coupling of translation and rotation is symmetric."""

    __slots__ = ()
    _FIELDS = ("coupling", "directions", "point", "stiffness",)

    @property
    def coupling(self) -> float:
        """Residual coupling there, relative: the largest element of the coupling over the geometric mean of the largest stiffness
        of translation and of rotation. Where it vanishes, a force through this point does not turn the block: the point is
        the elastic centre.
        """
        return self._get("coupling")  # type: ignore[no-any-return]

    @property
    def directions(self) -> FloatArray:
        """Those directions, unit vectors."""
        return self._array("directions")  # type: ignore[no-any-return]

    @property
    def point(self) -> FloatArray:
        """The point [m]."""
        return self._array("point")  # type: ignore[no-any-return]

    @property
    def stiffness(self) -> FloatArray:
        """Stiffness along the principal directions [N/m], rising."""
        return self._array("stiffness")  # type: ignore[no-any-return]


class StoppedEngine(Record):
    """An engine without energy enough for its cycle."""

    __slots__ = ()
    _FIELDS = ("fix", "flywheel", "key", "limit", "mean_speed", "reason", "version",)

    @property
    def fix(self) -> str:
        """What fixes it."""
        return self._get("fix")  # type: ignore[no-any-return]

    @property
    def flywheel(self) -> float | None:
        """Flywheel inertia with which the lowest speed stays just above the limit [kg m^2]; `None` where none does."""
        return self._get("flywheel")  # type: ignore[no-any-return]

    @property
    def key(self) -> str:
        """Key of the engine file that gives it."""
        return self._get("key")  # type: ignore[no-any-return]

    @property
    def limit(self) -> float:
        """Lowest speed over the mean below which an engine counts as stopped [1]: `STOPPED`."""
        return self._get("limit")  # type: ignore[no-any-return]

    @property
    def mean_speed(self) -> float:
        """Mean speed asked for [rad/s]."""
        return self._get("mean_speed")  # type: ignore[no-any-return]

    @property
    def reason(self) -> str:
        """Why, in words."""
        return self._get("reason")  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class StressCase(Record):
    """One load case."""

    __slots__ = ()
    _FIELDS = ("energy", "forces", "load", "loading", "name", "reaction", "result", "speed", "theta",)

    @property
    def energy(self) -> float:
        """Elastic energy of crankshaft and supports [J]."""
        return self._get("energy")  # type: ignore[no-any-return]

    @property
    def forces(self) -> Records[PinForces]:
        """Forces on the pins."""
        return self._all("forces", PinForces)

    @property
    def load(self) -> FloatArray:
        """Sum of all loads, in the frame that turns with the crankshaft [N]."""
        return self._array("load")  # type: ignore[no-any-return]

    @property
    def loading(self) -> CrankLoad:
        """What loads the crankshaft, in the frame that turns with it."""
        return self._of("loading", CrankLoad)  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def reaction(self) -> FloatArray:
        """Sum of what the supports exert on it [N]."""
        return self._array("reaction")  # type: ignore[no-any-return]

    @property
    def result(self) -> CrankCase:
        """Displacements and peaks; the fields themselves are not serialised."""
        return self._of("result", CrankCase)  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def theta(self) -> float | None:
        """Crank angle [rad]; `None`: forces were given."""
        return self._get("theta")  # type: ignore[no-any-return]


class StressMaterial(Record):
    """Elastic constants with their origin, and the yield strength where the file gives one."""

    __slots__ = ()
    _FIELDS = ("elastic", "origin", "yield_strength",)

    @property
    def elastic(self) -> Material:
        """Elastic constants and density."""
        return self._of("elastic", Material)  # type: ignore[no-any-return]

    @property
    def origin(self) -> Literal['given', 'from-shape', 'typical', 'assumed']:
        """Where Young's modulus comes from."""
        return self._get("origin")  # type: ignore[no-any-return]

    @property
    def yield_strength(self) -> Sourced | None:
        """Yield strength [Pa]."""
        return self._of("yield_strength", Sourced)  # type: ignore[no-any-return]


class StressSubmodel(Record):
    """What lies between the middles of two main journals, meshed again with more elements across its fillets and solved with the displacements of the
    whole crankshaft on its cuts.
    """

    __slots__ = ()
    _FIELDS = ("cut_difference", "cuts", "fillet_elements", "fillets", "quality", "size", "solve", "throw",)

    @property
    def cut_difference(self) -> float:
        """Largest difference of the von Mises stress between both meshes on the cuts, over the largest stress of a fillet of the bay, of all cases."""
        return self._get("cut_difference")  # type: ignore[no-any-return]

    @property
    def cuts(self) -> FloatArray:
        """Where both cuts lie along z [m]."""
        return self._array("cuts")  # type: ignore[no-any-return]

    @property
    def fillet_elements(self) -> int:
        """Elements across the 90 degrees of a fillet."""
        return self._get("fillet_elements")  # type: ignore[no-any-return]

    @property
    def fillets(self) -> Records[SubmodelFillet]:
        """Its fillets, along z."""
        return self._all("fillets", SubmodelFillet)

    @property
    def quality(self) -> MeshQuality:
        """The quality of its mesh."""
        return self._of("quality", MeshQuality)  # type: ignore[no-any-return]

    @property
    def size(self) -> float:
        """Edge of the elements away from fillets [m]."""
        return self._get("size")  # type: ignore[no-any-return]

    @property
    def solve(self) -> SolveReport:
        """How its equations were solved."""
        return self._of("solve", SolveReport)  # type: ignore[no-any-return]

    @property
    def throw(self) -> int:
        """Number of the throw whose bay it is, from 1."""
        return self._get("throw")  # type: ignore[no-any-return]


class StrokeSpan(Record):
    """What a piston does between two dead centres."""

    __slots__ = ()
    _FIELDS = ("from_", "stroke", "to",)

    @property
    def from_(self) -> float:
        """Crank angle [rad] at its start."""
        return self._get("from")  # type: ignore[no-any-return]

    @property
    def stroke(self) -> Literal['power', 'exhaust', 'intake', 'compression']:
        """Which stroke."""
        return self._get("stroke")  # type: ignore[no-any-return]

    @property
    def to(self) -> float:
        """Crank angle [rad] at its end."""
        return self._get("to")  # type: ignore[no-any-return]


class SubmodelFillet(Record):
    """A fillet of a submodel."""

    __slots__ = ()
    _FIELDS = ("case", "name", "radius", "stress", "whole",)

    @property
    def case(self) -> int:
        """Place of the case in which it is, from 0."""
        return self._get("case")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """"pin 2 at web 3"."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Radius [m]."""
        return self._get("radius")  # type: ignore[no-any-return]

    @property
    def stress(self) -> PeakStress:
        """Largest stress on the finer mesh, over all cases."""
        return self._of("stress", PeakStress)  # type: ignore[no-any-return]

    @property
    def whole(self) -> PeakStress:
        """Largest stress on the mesh of the whole crankshaft, over all cases."""
        return self._of("whole", PeakStress)  # type: ignore[no-any-return]


class SurfacePeak(Record):
    """The largest stress of a fillet, or of the surface of a pin or journal between its fillets."""

    __slots__ = ()
    _FIELDS = ("name", "stress",)

    @property
    def name(self) -> str:
        """"pin 1 at web 2"; "PIN_1"."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def stress(self) -> PeakStress | None:
        """Its stress; none of a sharp corner, where it would grow with every refinement."""
        return self._of("stress", PeakStress)  # type: ignore[no-any-return]


class Sweep(Record):
    """Forced vibration over speed. Amplitudes are half of largest less least value; those by order are moduli."""

    __slots__ = ()
    _FIELDS = ("balance", "damper", "nose", "orders", "pendulums", "shafts", "speeds", "stations", "twist",)

    @property
    def balance(self) -> float:
        """Largest difference of the power put in and the power lost, over the power put in."""
        return self._get("balance")  # type: ignore[no-any-return]

    @property
    def damper(self) -> DamperSweep | None:
        """The damper, where there is one."""
        return self._of("damper", DamperSweep)  # type: ignore[no-any-return]

    @property
    def nose(self) -> Curve:
        """Nose alone."""
        return self._of("nose", Curve)  # type: ignore[no-any-return]

    @property
    def orders(self) -> FloatArray:
        """Orders, per revolution of the reference."""
        return self._array("orders")  # type: ignore[no-any-return]

    @property
    def pendulums(self) -> Records[PendulumSweep]:
        """Pendulums."""
        return self._all("pendulums", PendulumSweep)

    @property
    def shafts(self) -> Records[ShaftSweep]:
        """Every shaft."""
        return self._all("shafts", ShaftSweep)

    @property
    def speeds(self) -> FloatArray:
        """Speeds of the reference [rad/s]."""
        return self._array("speeds")  # type: ignore[no-any-return]

    @property
    def stations(self) -> Records[StationSweep]:
        """Angles of the stations by order."""
        return self._all("stations", StationSweep)

    @property
    def twist(self) -> Curve:
        """Nose against flywheel, as seen at the reference."""
        return self._of("twist", Curve)  # type: ignore[no-any-return]


class SweptOverlap(Record):
    """Two swept circles that overlap in a plane across the crank: whether what turns in them meets depends on their phases."""

    __slots__ = ()
    _FIELDS = ("depth", "from_", "other", "to", "weight",)

    @property
    def depth(self) -> float:
        """Sum of both swept radii less the distance of the axes [m]."""
        return self._get("depth")  # type: ignore[no-any-return]

    @property
    def from_(self) -> float:
        """First plane of the overlap [m], from the origin."""
        return self._get("from")  # type: ignore[no-any-return]

    @property
    def other(self) -> str:
        """What it overlaps: another weight, a counterweight, a web, a crankpin or a big end."""
        return self._get("other")  # type: ignore[no-any-return]

    @property
    def to(self) -> float:
        """Last plane of the overlap [m], from the origin."""
        return self._get("to")  # type: ignore[no-any-return]

    @property
    def weight(self) -> str:
        """Name of the weight of a balance shaft."""
        return self._get("weight")  # type: ignore[no-any-return]


class SweptRoom(Record):
    """The largest swept radius that keeps the wanted clearance whatever the shape."""

    __slots__ = ()
    _FIELDS = ("least", "limit", "radius", "theta",)

    @property
    def least(self) -> float:
        """The clearance that it keeps [m]."""
        return self._get("least")  # type: ignore[no-any-return]

    @property
    def limit(self) -> Obstacle:
        """What limits it."""
        return self._of("limit", Obstacle)  # type: ignore[no-any-return]

    @property
    def radius(self) -> float:
        """Largest swept radius [m]; zero where there is no room at all."""
        return self._get("radius")  # type: ignore[no-any-return]

    @property
    def theta(self) -> float | None:
        """Angle of crankshaft 1 [rad] at which it does, for a piston."""
        return self._get("theta")  # type: ignore[no-any-return]


class Target(Variant):
    """A load or a result of loads."""

    __slots__ = ()
    _FIELDS = ("kind", "main_bearing", "crankpin", "piston_pin", "side_thrust", "mount_force", "bending_moment",)

    @property
    def kind(self) -> Literal['force', 'couple', 'roll-moment', 'torque', 'excess-energy', 'speed-fluctuation', 'main-bearing', 'crankpin', 'piston-pin', 'side-thrust', 'mount-force', 'bending-moment']:
        """Which of the variants it is.
        `force`: Resultant inertia force on the block [N].
        `couple`: Resultant inertia couple on the block about the origin [N m].
        `roll-moment`: Roll moment of inertia [N m].
        `torque`: Torque at crankshaft 1 [N m].
        `excess-energy`: Largest excess energy of that torque at constant speed [J] (book, eq. 25.2).
        `speed-fluctuation`: Fluctuation of the speed, `(w_max - w_min)/w_mean` [1], under a load that takes the mean torque (book, eq. 25.7).
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def main_bearing(self) -> int | None:
        """Force of the journal on a main bearing [N], by index: those of crankshaft 1 first, each from the free end on; `None`: the
        largest of all.
        """
        return self._get("main-bearing")  # type: ignore[no-any-return]

    @property
    def crankpin(self) -> int | None:
        """Force of a rod on its lower pin [N], by cylinder: the crankpin, or the knuckle pin of an articulated rod."""
        return self._get("crankpin")  # type: ignore[no-any-return]

    @property
    def piston_pin(self) -> int | None:
        """Force of a rod on its piston pin [N], by cylinder."""
        return self._get("piston-pin")  # type: ignore[no-any-return]

    @property
    def side_thrust(self) -> int | None:
        """Force of a piston on its cylinder wall [N], by cylinder."""
        return self._get("side-thrust")  # type: ignore[no-any-return]

    @property
    def mount_force(self) -> int | None:
        """Force of the block on a mount [N], of orders up to 8."""
        return self._get("mount-force")  # type: ignore[no-any-return]

    @property
    def bending_moment(self) -> int | None:
        """Largest bending moment along a crankshaft under all that turns with it, as a free beam [N m], by index."""
        return self._get("bending-moment")  # type: ignore[no-any-return]


class ThrowFactor(Record):
    """Balance factors of one throw."""

    __slots__ = ()
    _FIELDS = ("across", "along", "bobweight", "bobweight_share", "counterweight", "cylinders", "ellipse", "least_peak_share", "masses", "oil", "opposite", "reciprocating_share", "throw", "total_share", "wet_reciprocating_share",)

    @property
    def across(self) -> float:
        """Residual amplitude across it [kg m]."""
        return self._get("across")  # type: ignore[no-any-return]

    @property
    def along(self) -> float:
        """Residual amplitude along the cylinders' axis [kg m]."""
        return self._get("along")  # type: ignore[no-any-return]

    @property
    def bobweight(self) -> float:
        """Bobweight [kg]."""
        return self._get("bobweight")  # type: ignore[no-any-return]

    @property
    def bobweight_share(self) -> float | None:
        """Bobweight over all masses at the pin."""
        return self._get("bobweight_share")  # type: ignore[no-any-return]

    @property
    def counterweight(self) -> FloatArray:
        """Counterweight in the frame of the throw [kg m]."""
        return self._array("counterweight")  # type: ignore[no-any-return]

    @property
    def cylinders(self) -> list[int]:
        """Numbers of its cylinders, from 1."""
        return self._list("cylinders")  # type: ignore[no-any-return]

    @property
    def ellipse(self) -> PrimaryEllipse:
        """The residual first-order force of the running engine, oil included."""
        return self._of("ellipse", PrimaryEllipse)  # type: ignore[no-any-return]

    @property
    def least_peak_share(self) -> float | None:
        """The share of the reciprocating mass with the smallest peak of the first-order force."""
        return self._get("least_peak_share")  # type: ignore[no-any-return]

    @property
    def masses(self) -> ThrowMasses:
        """Its masses."""
        return self._of("masses", ThrowMasses)  # type: ignore[no-any-return]

    @property
    def oil(self) -> float:
        """Oil [kg] at the crank radius."""
        return self._get("oil")  # type: ignore[no-any-return]

    @property
    def opposite(self) -> float:
        """Its part opposite the throw [kg m]."""
        return self._get("opposite")  # type: ignore[no-any-return]

    @property
    def reciprocating_share(self) -> float | None:
        """Share of the reciprocating mass; `None` where nothing reciprocates."""
        return self._get("reciprocating_share")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int:
        """Number of the throw, from 1."""
        return self._get("throw")  # type: ignore[no-any-return]

    @property
    def total_share(self) -> float | None:
        """Counterweight over rotating and reciprocating unbalance."""
        return self._get("total_share")  # type: ignore[no-any-return]

    @property
    def wet_reciprocating_share(self) -> float | None:
        """Share of the reciprocating mass with the oil counted as rotating."""
        return self._get("wet_reciprocating_share")  # type: ignore[no-any-return]


class ThrowInertia(Record):
    """Share of a throw in the inertia of its crankshaft."""

    __slots__ = ()
    _FIELDS = ("crankshaft", "inertia", "mass", "throw",)

    @property
    def crankshaft(self) -> int:
        """Index of its crankshaft."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> float:
        """Moment of inertia about the axis of its crankshaft [kg m^2]."""
        return self._get("inertia")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int:
        """Index of the throw."""
        return self._get("throw")  # type: ignore[no-any-return]


class ThrowMasses(Record):
    """The masses of one throw."""

    __slots__ = ()
    _FIELDS = ("axis", "big_ends", "counterweight", "crank", "pistons", "radius", "reciprocating", "throw",)

    @property
    def axis(self) -> float:
        """Direction of the cylinders [rad]: of their sum, or of the first where they cancel; 0 without cylinders."""
        return self._get("axis")  # type: ignore[no-any-return]

    @property
    def big_ends(self) -> float:
        """Big ends on the pin [kg]."""
        return self._get("big_ends")  # type: ignore[no-any-return]

    @property
    def counterweight(self) -> FloatArray:
        """Counterweights in the throw's own plane and in the planes of its webs, in the frame of the throw [kg m]."""
        return self._array("counterweight")  # type: ignore[no-any-return]

    @property
    def crank(self) -> float:
        """Unbalance of the crank itself along the throw [kg m]."""
        return self._get("crank")  # type: ignore[no-any-return]

    @property
    def pistons(self) -> Records[FirstOrder]:
        """First order of every piston on the throw."""
        return self._all("pistons", FirstOrder)

    @property
    def radius(self) -> float:
        """Crank radius [m]."""
        return self._get("radius")  # type: ignore[no-any-return]

    @property
    def reciprocating(self) -> float:
        """Reciprocating masses: pistons and small ends [kg]."""
        return self._get("reciprocating")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int:
        """Index of the throw."""
        return self._get("throw")  # type: ignore[no-any-return]


class ThrowMesh(Record):
    """The mesh of a throw between the middles of its main journals."""

    __slots__ = ()
    _FIELDS = ("fillet_elements", "jump", "least_jacobian", "nodes", "residual", "size", "throw",)

    @property
    def fillet_elements(self) -> int:
        """Elements across the 90 degrees of a fillet."""
        return self._get("fillet_elements")  # type: ignore[no-any-return]

    @property
    def jump(self) -> float:
        """Largest jump of the stress between elements over the stress, where fillets are loaded most: a sign of the error [1]."""
        return self._get("jump")  # type: ignore[no-any-return]

    @property
    def least_jacobian(self) -> float:
        """Least scaled Jacobian of an element [1]."""
        return self._get("least_jacobian")  # type: ignore[no-any-return]

    @property
    def nodes(self) -> int:
        """Its nodes."""
        return self._get("nodes")  # type: ignore[no-any-return]

    @property
    def residual(self) -> float:
        """Largest residual of the equations [1]."""
        return self._get("residual")  # type: ignore[no-any-return]

    @property
    def size(self) -> float:
        """Size of its elements away from fillets [m]."""
        return self._get("size")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int:
        """Number of the throw, from 1."""
        return self._get("throw")  # type: ignore[no-any-return]


class ThrowParts(Record):
    """Inertia of a throw about the axis of its crankshaft."""

    __slots__ = ()
    _FIELDS = ("crank", "fluctuation", "throw", "train",)

    @property
    def crank(self) -> float:
        """Part of the crankshaft [kg m^2]."""
        return self._get("crank")  # type: ignore[no-any-return]

    @property
    def fluctuation(self) -> float:
        """Amplitude of the inertia of rods and pistons over the cycle, half of largest less least [kg m^2]."""
        return self._get("fluctuation")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int:
        """Index of the throw."""
        return self._get("throw")  # type: ignore[no-any-return]

    @property
    def train(self) -> float:
        """Rods and pistons, mean over the cycle [kg m^2]."""
        return self._get("train")  # type: ignore[no-any-return]


class ThrowShare(Record):
    """What belongs to one throw, or to none: journals, and weights beside the webs."""

    __slots__ = ()
    _FIELDS = ("couple", "mass", "polar_inertia", "throw", "unbalance",)

    @property
    def couple(self) -> Point:
        """Its moment `V` along the crank [kg m^2]."""
        return self._of("couple", Point)  # type: ignore[no-any-return]

    @property
    def mass(self) -> float:
        """Mass of pin, webs and counterweights on them [kg]."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def polar_inertia(self) -> float:
        """Moment of inertia about the crank axis [kg m^2]."""
        return self._get("polar_inertia")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int | None:
        """Index of the throw."""
        return self._get("throw")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> Point:
        """Static unbalance `U` [kg m]."""
        return self._of("unbalance", Point)  # type: ignore[no-any-return]


class ThrowSheet(Record):
    """A throw."""

    __slots__ = ()
    _FIELDS = ("bore", "mains", "radial", "tangential", "throw", "torques", "vibration", "webs",)

    @property
    def bore(self) -> BoreSheet | None:
        """Oil bore of its pin, if it has one."""
        return self._of("bore", BoreSheet)  # type: ignore[no-any-return]

    @property
    def mains(self) -> FloatArray:
        """Planes of its main bearings [m]."""
        return self._array("mains")  # type: ignore[no-any-return]

    @property
    def radial(self) -> float:
        """Alternating radial force on its pin [N]."""
        return self._get("radial")  # type: ignore[no-any-return]

    @property
    def tangential(self) -> float:
        """Alternating tangential force on its pin [N]."""
        return self._get("tangential")  # type: ignore[no-any-return]

    @property
    def throw(self) -> int:
        """Its number, from 1."""
        return self._get("throw")  # type: ignore[no-any-return]

    @property
    def torques(self) -> FloatArray:
        """Alternating torque in its journals in front and behind, of a rigid crankshaft at constant speed [N m]."""
        return self._array("torques")  # type: ignore[no-any-return]

    @property
    def vibration(self) -> float:
        """Amplitude of the torque of torsional vibration, added to them [N m]."""
        return self._get("vibration")  # type: ignore[no-any-return]

    @property
    def webs(self) -> Records[WebSheet]:
        """Its webs."""
        return self._all("webs", WebSheet)


class Tie(Record):
    """`U_second = factor * U_first`, or `factor * conj(U_first)` if mirrored (in the plane of x and z).

    A leader follows nobody. In an engine that was read the follower's own direction is free, its least amount 0, its
    largest that which the leader's allows, and it is not optional: the leader's choices are its own.
    """

    __slots__ = ()
    _FIELDS = ("factor", "first", "mirrored", "second",)

    @property
    def factor(self) -> float:
        """1: equal, -1: opposed."""
        return self._get("factor")  # type: ignore[no-any-return]

    @property
    def first(self) -> int:
        """Index of the leading weight."""
        return self._get("first")  # type: ignore[no-any-return]

    @property
    def mirrored(self) -> bool:
        """Whether the phase is mirrored."""
        return self._get("mirrored")  # type: ignore[no-any-return]

    @property
    def second(self) -> int:
        """Index of the weight that follows it."""
        return self._get("second")  # type: ignore[no-any-return]


class Tightened(Record):
    """What halving one tolerance would do."""

    __slots__ = ()
    _FIELDS = ("gains", "tolerance",)

    @property
    def gains(self) -> FloatArray:
        """Share by which the value that 99.73 % of the engines do not exceed becomes smaller, by output."""
        return self._array("gains")  # type: ignore[no-any-return]

    @property
    def tolerance(self) -> int:
        """Place of the tolerance in the list, from 0."""
        return self._get("tolerance")  # type: ignore[no-any-return]


class TimeAmplitudes(Record):
    """Amplitudes of torques and twist."""

    __slots__ = ()
    _FIELDS = ("energy", "energy_error", "torques", "twist",)

    @property
    def energy(self) -> ChainEnergy | None:
        """In time: work and energy over the period."""
        return self._of("energy", ChainEnergy)  # type: ignore[no-any-return]

    @property
    def energy_error(self) -> float | None:
        """In time: missing energy over the turnover."""
        return self._get("energy_error")  # type: ignore[no-any-return]

    @property
    def torques(self) -> FloatArray:
        """Torque of each shaft [N m]."""
        return self._array("torques")  # type: ignore[no-any-return]

    @property
    def twist(self) -> float:
        """Twist between nose and flywheel [rad]."""
        return self._get("twist")  # type: ignore[no-any-return]


class TimeCheck(Record):
    """Periodic motion in the time domain beside the sum of orders, at one speed. Loss factors count as viscous dampers of the same loss at one frequency, in all three."""

    __slots__ = ()
    _FIELDS = ("evaluations", "frequency", "linear", "orders", "speed", "varying",)

    @property
    def evaluations(self) -> int:
        """Evaluations of the equations of motion."""
        return self._get("evaluations")  # type: ignore[no-any-return]

    @property
    def frequency(self) -> float:
        """Angular frequency at which loss factors and viscous dampers are equal [rad/s]."""
        return self._get("frequency")  # type: ignore[no-any-return]

    @property
    def linear(self) -> TimeAmplitudes:
        """Amplitudes of the same linear equations in the time domain."""
        return self._of("linear", TimeAmplitudes)  # type: ignore[no-any-return]

    @property
    def orders(self) -> TimeAmplitudes:
        """Amplitudes by the sum of orders."""
        return self._of("orders", TimeAmplitudes)  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def varying(self) -> TimeAmplitudes:
        """Amplitudes with the inertia as it varies over the angle, torques over the true angle of each throw."""
        return self._of("varying", TimeAmplitudes)  # type: ignore[no-any-return]


class Tolerance(Record):
    """A tolerance: one entry of the engine file's `[tolerances]`."""

    __slots__ = ()
    _FIELDS = ("distribution", "extent", "half_width", "quantity",)

    @property
    def distribution(self) -> Distribution:
        """How it is distributed."""
        return self._of("distribution", Distribution)  # type: ignore[no-any-return]

    @property
    def extent(self) -> Literal['per-part', 'common']:
        """For which parts together."""
        return self._get("extent")  # type: ignore[no-any-return]

    @property
    def half_width(self) -> float:
        """The nominal value may be missed by this either way, in the quantity's SI unit."""
        return self._get("half_width")  # type: ignore[no-any-return]

    @property
    def quantity(self) -> Literal['piston-mass', 'big-end-mass', 'small-end-mass', 'rod-centre', 'rod-length', 'crank-radius', 'throw-angle', 'throw-unbalance', 'offset', 'cylinder-plane', 'cylinder-angle', 'counterweight-unbalance', 'counterweight-angle', 'shaft-unbalance', 'shaft-phase']:
        """What varies."""
        return self._get("quantity")  # type: ignore[no-any-return]


class Tolerances(Record):
    """Tolerances of a run's steps. The error of each component is measured against its absolute tolerance and `relative` times its size; the root
    mean square of all stays below a half of 1 over the root of their number, so that no component has more error than its tolerance.
    """

    __slots__ = ()
    _FIELDS = ("angle", "displacement", "energy", "relative", "speed", "spin", "turn", "velocity",)

    @property
    def angle(self) -> float:
        """Of the angles of crank and driveline [rad]."""
        return self._get("angle")  # type: ignore[no-any-return]

    @property
    def displacement(self) -> float:
        """Of the place of the block and of the dashpots of its mounts [m]."""
        return self._get("displacement")  # type: ignore[no-any-return]

    @property
    def energy(self) -> float:
        """Of works [J]."""
        return self._get("energy")  # type: ignore[no-any-return]

    @property
    def relative(self) -> float:
        """Relative, of every component."""
        return self._get("relative")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Of their speeds [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def spin(self) -> float:
        """Of its angular velocity [rad/s]."""
        return self._get("spin")  # type: ignore[no-any-return]

    @property
    def turn(self) -> float:
        """Of the turn of the block [rad]."""
        return self._get("turn")  # type: ignore[no-any-return]

    @property
    def velocity(self) -> float:
        """Of its velocity [m/s]."""
        return self._get("velocity")  # type: ignore[no-any-return]


class Torque(Record):
    """Torque of an engine at one speed: gas, inertia, and both together.

    All torques are at crankshaft 1, positive in the sense of rotation, without friction: net indicated.
    """

    __slots__ = ()
    _FIELDS = ("cylinders", "energy", "engine", "firing", "gas", "gas_energy", "gas_extremes", "harmonics", "indicated", "inertia", "inertia_extremes", "lever", "orders", "period", "speed", "theta", "total_extremes", "version", "with_gas",)

    @property
    def cylinders(self) -> Records[CylinderTorque]:
        """By cylinder."""
        return self._all("cylinders", CylinderTorque)

    @property
    def energy(self) -> EnergyVariation:
        """Energy that both together store and give back, per period."""
        return self._of("energy", EnergyVariation)  # type: ignore[no-any-return]

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def firing(self) -> FiringChart:
        """When they fire."""
        return self._of("firing", FiringChart)  # type: ignore[no-any-return]

    @property
    def gas(self) -> FloatArray:
        """Gas torque [N m]."""
        return self._array("gas")  # type: ignore[no-any-return]

    @property
    def gas_energy(self) -> EnergyVariation:
        """Energy that gas alone stores and gives back."""
        return self._of("gas_energy", EnergyVariation)  # type: ignore[no-any-return]

    @property
    def gas_extremes(self) -> Extremes:
        """Extremes of the gas torque over the continuous angle."""
        return self._of("gas_extremes", Extremes)  # type: ignore[no-any-return]

    @property
    def harmonics(self) -> Records[TorqueHarmonic]:
        """Torque by order, split: the orders of `orders`."""
        return self._all("harmonics", TorqueHarmonic)

    @property
    def indicated(self) -> Indicated:
        """The engine in numbers."""
        return self._of("indicated", Indicated)  # type: ignore[no-any-return]

    @property
    def inertia(self) -> FloatArray:
        """Inertia torque at constant speed [N m]."""
        return self._array("inertia")  # type: ignore[no-any-return]

    @property
    def inertia_extremes(self) -> Extremes:
        """Extremes of the inertia torque."""
        return self._of("inertia_extremes", Extremes)  # type: ignore[no-any-return]

    @property
    def lever(self) -> Literal['exact', 'sine']:
        """Lever of gas and inertia."""
        return self._get("lever")  # type: ignore[no-any-return]

    @property
    def orders(self) -> Records[OrderLoads]:
        """Loads by order, gas and inertia together: order 0 (the means), the whole orders, and the fractions that working cycles and
        gears bring. Of gas they have roll moment and shaft torque alone.
        """
        return self._all("orders", OrderLoads)

    @property
    def period(self) -> float:
        """Period [rad] of crankshaft 1: whole revolutions and whole working cycles."""
        return self._get("period")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle [rad] of every trace, from 0, one period, end point excluded."""
        return self._array("theta")  # type: ignore[no-any-return]

    @property
    def total_extremes(self) -> Extremes:
        """Extremes of both together."""
        return self._of("total_extremes", Extremes)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def with_gas(self) -> bool:
        """Whether there is gas. Without it its torques and works are 0, and pressures and volumes are left out."""
        return self._get("with_gas")  # type: ignore[no-any-return]


class TorqueAtSpeed(Record):
    """Torque, work and energy at one of several speeds."""

    __slots__ = ()
    _FIELDS = ("energy", "extremes", "indicated", "speed",)

    @property
    def energy(self) -> EnergyVariation:
        """Energy that both together store and give back."""
        return self._of("energy", EnergyVariation)  # type: ignore[no-any-return]

    @property
    def extremes(self) -> Extremes:
        """Extremes of gas and inertia together [N m]."""
        return self._of("extremes", Extremes)  # type: ignore[no-any-return]

    @property
    def indicated(self) -> Indicated:
        """Mean torque, power and pressures, net indicated."""
        return self._of("indicated", Indicated)  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]


class TorqueHarmonic(Record):
    """One order of the torque, modulus = amplitude; order 0 is the mean."""

    __slots__ = ()
    _FIELDS = ("gas", "inertia", "order",)

    @property
    def gas(self) -> FloatArray:
        """Gas [N m]."""
        return self._array("gas")  # type: ignore[no-any-return]

    @property
    def inertia(self) -> FloatArray:
        """Inertia [N m]."""
        return self._array("inertia")  # type: ignore[no-any-return]

    @property
    def order(self) -> float:
        """Cycles per revolution of crankshaft 1."""
        return self._get("order")  # type: ignore[no-any-return]


class TorqueReport(Result):
    """Torque at one speed, and what follows from it."""

    __slots__ = ()
    _FIELDS = ("brake", "cycles", "flywheel", "is_driven_besides", "power", "ripples", "source", "speeds", "torque", "version", "warnings",)

    @property
    def brake(self) -> Brake | None:
        """What friction leaves, where it is known."""
        return self._of("brake", Brake)  # type: ignore[no-any-return]

    @property
    def cycles(self) -> Records[CycleResult]:
        """The cycles behind the pressures, where they are computed."""
        return self._all("cycles", CycleResult)

    @property
    def flywheel(self) -> FlywheelNeed | None:
        """The flywheel for the fluctuation asked for, at that speed of the file's flywheel that needs most; without these at the lowest
        speed of the engine.
        """
        return self._of("flywheel", FlywheelNeed)  # type: ignore[no-any-return]

    @property
    def is_driven_besides(self) -> bool:
        """Whether torques over the angle of the file act besides: in `ripples` and `flywheel`, not in `torque`, `speeds` and `power`."""
        return self._get("is_driven_besides")  # type: ignore[no-any-return]

    @property
    def power(self) -> PowerCurve | None:
        """Power over speed, at the brake where friction is known, else net indicated."""
        return self._of("power", PowerCurve)  # type: ignore[no-any-return]

    @property
    def ripples(self) -> Records[RippleOutcome]:
        """Speed within the cycle at the speeds of the file's flywheel; without these at the lowest speed of the engine and at that of `torque`:
        periodic, or why not.
        """
        return self._all("ripples", RippleOutcome)

    @property
    def source(self) -> str:
        """Where the pressures come from, in words."""
        return self._get("source")  # type: ignore[no-any-return]

    @property
    def speeds(self) -> Records[TorqueAtSpeed]:
        """Torque and energy at the speeds asked for."""
        return self._all("speeds", TorqueAtSpeed)

    @property
    def torque(self) -> Torque:
        """Torque, work, orders, energy, firing."""
        return self._of("torque", Torque)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]

    @property
    def warnings(self) -> list[str]:
        """What the user should know."""
        return self._list("warnings")  # type: ignore[no-any-return]


class TorsionLimit(Record):
    """A limit, and what is reached."""

    __slots__ = ()
    _FIELDS = ("allowed", "found", "is_known", "quantity", "speed",)

    @property
    def allowed(self) -> float:
        """Allowed amplitude [rad] or [Pa]."""
        return self._get("allowed")  # type: ignore[no-any-return]

    @property
    def found(self) -> float:
        """Largest amplitude over speed [rad] or [Pa]."""
        return self._get("found")  # type: ignore[no-any-return]

    @property
    def is_known(self) -> bool:
        """Whether what is found can be trusted: not where pendulums swing beyond the linear theory."""
        return self._get("is_known")  # type: ignore[no-any-return]

    @property
    def quantity(self) -> Literal['twist', 'stress']:
        """What is limited."""
        return self._get("quantity")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of crankshaft 1 at which it is found [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]


class TorsionResult(Result):
    """Torsional vibration of an engine over its speed range.

    Linear, about a mean speed that does not change: mean inertia of the moving masses, their torque at constant speed beside that of the gas. Amplitudes
    are half of largest less least value, those by order moduli.
    """

    __slots__ = ()
    _FIELDS = ("campbell", "crank", "damped", "engine", "gas", "holzer", "limits", "meshed", "modes", "notes", "stars", "sweep", "time", "tuned", "version",)

    @property
    def campbell(self) -> Campbell:
        """Orders and natural frequencies over speed, with the speeds at which they meet."""
        return self._of("campbell", Campbell)  # type: ignore[no-any-return]

    @property
    def crank(self) -> CrankChain:
        """The chain, and where its numbers come from."""
        return self._of("crank", CrankChain)  # type: ignore[no-any-return]

    @property
    def damped(self) -> Records[DampedMode2]:
        """Damped modes at the highest speed."""
        return self._all("damped", DampedMode2)

    @property
    def engine(self) -> str:
        """Name of the engine."""
        return self._get("engine")  # type: ignore[no-any-return]

    @property
    def gas(self) -> str | None:
        """Where the pressures come from, in words; `None`: no gas acts."""
        return self._get("gas")  # type: ignore[no-any-return]

    @property
    def holzer(self) -> Records[HolzerTable]:
        """Holzer's table at each of the first natural frequencies."""
        return self._all("holzer", HolzerTable)

    @property
    def limits(self) -> Records[TorsionLimit]:
        """Limits of the file."""
        return self._all("limits", TorsionLimit)

    @property
    def meshed(self) -> Records[MeshedThrow]:
        """Stiffness of throws by finite elements, where it was asked for."""
        return self._all("meshed", MeshedThrow)

    @property
    def modes(self) -> Records[Mode2]:
        """Undamped modes; of pendulums at the highest speed."""
        return self._all("modes", Mode2)

    @property
    def notes(self) -> list[str]:
        """What was assumed and left out."""
        return self._list("notes")  # type: ignore[no-any-return]

    @property
    def stars(self) -> Records[OrderStar]:
        """Star of each order; empty where the file gives no firing."""
        return self._all("stars", OrderStar)

    @property
    def sweep(self) -> Sweep:
        """Forced vibration over speed."""
        return self._of("sweep", Sweep)  # type: ignore[no-any-return]

    @property
    def time(self) -> TimeCheck | None:
        """The check in the time domain, where it was asked for."""
        return self._of("time", TimeCheck)  # type: ignore[no-any-return]

    @property
    def tuned(self) -> TunedDamper | None:
        """The best setting of the damper, where it was asked for."""
        return self._of("tuned", TunedDamper)  # type: ignore[no-any-return]

    @property
    def version(self) -> int:
        """Version of this structure."""
        return self._get("version")  # type: ignore[no-any-return]


class Trace(Record):
    """Components over one period, at equally spaced crank angles; one vector a component so that it plots as it is."""

    __slots__ = ()
    _FIELDS = ("couple_x", "couple_y", "force_x", "force_y", "roll_moment", "shaft_torque", "theta",)

    @property
    def couple_x(self) -> FloatArray:
        """Couple about x [N m]."""
        return self._array("couple_x")  # type: ignore[no-any-return]

    @property
    def couple_y(self) -> FloatArray:
        """Couple about y [N m]."""
        return self._array("couple_y")  # type: ignore[no-any-return]

    @property
    def force_x(self) -> FloatArray:
        """Force along x [N]."""
        return self._array("force_x")  # type: ignore[no-any-return]

    @property
    def force_y(self) -> FloatArray:
        """Force along y [N]."""
        return self._array("force_y")  # type: ignore[no-any-return]

    @property
    def roll_moment(self) -> FloatArray:
        """Roll moment about z [N m]."""
        return self._array("roll_moment")  # type: ignore[no-any-return]

    @property
    def shaft_torque(self) -> FloatArray:
        """Shaft torque [N m]."""
        return self._array("shaft_torque")  # type: ignore[no-any-return]

    @property
    def theta(self) -> FloatArray:
        """Crank angle of crankshaft 1 [rad], from 0, one period, end point excluded."""
        return self._array("theta")  # type: ignore[no-any-return]


class TrainInertia(Record):
    """Inertia of the crank train seen at crankshaft 1 [kg m^2]."""

    __slots__ = ()
    _FIELDS = ("big_ends", "extremes", "geared", "given", "mean", "reciprocating_mean", "total",)

    @property
    def big_ends(self) -> float:
        """Big ends of the rods at their crankpins."""
        return self._get("big_ends")  # type: ignore[no-any-return]

    @property
    def extremes(self) -> Extremes:
        """Its extremes over the samples."""
        return self._of("extremes", Extremes)  # type: ignore[no-any-return]

    @property
    def geared(self) -> float:
        """Balance shafts and gears whose inertia is known, each times its speed ratio squared."""
        return self._get("geared")  # type: ignore[no-any-return]

    @property
    def given(self) -> TurningInertia:
        """Flywheel and crankshafts as given."""
        return self._of("given", TurningInertia)  # type: ignore[no-any-return]

    @property
    def mean(self) -> float:
        """Mean of all of it."""
        return self._get("mean")  # type: ignore[no-any-return]

    @property
    def reciprocating_mean(self) -> float:
        """Mean over the cycle of pistons, small ends and what the rods' swing adds."""
        return self._get("reciprocating_mean")  # type: ignore[no-any-return]

    @property
    def total(self) -> FloatArray:
        """All of it over the period of the torque, at `theta`."""
        return self._array("total")  # type: ignore[no-any-return]


class Transmissibility(Record):
    """Force transmissibility against frequency."""

    __slots__ = ()
    _FIELDS = ("angular_frequency", "ratio",)

    @property
    def angular_frequency(self) -> FloatArray:
        """Angular frequencies [rad/s], rising in equal ratios."""
        return self._array("angular_frequency")  # type: ignore[no-any-return]

    @property
    def ratio(self) -> FloatArray:
        """For a unit load in each coordinate at the block's centre: the force transmitted in the same coordinate."""
        return self._array("ratio")  # type: ignore[no-any-return]


class TuneAim(Variant):
    """What the damper is to keep small, all orders in true phase."""

    __slots__ = ()
    _FIELDS = ("kind", "torque",)

    @property
    def kind(self) -> Literal['twist', 'torque', 'stress']:
        """Which of the variants it is.
        `twist`: Twist between nose and flywheel [rad].
        `stress`: Largest shear stress of all shafts whose sections are known [Pa].
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def torque(self) -> int | None:
        """Torque in the shaft with this index [N m]."""
        return self._get("torque")  # type: ignore[no-any-return]


class TunePoint(Record):
    """A point of the curve."""

    __slots__ = ()
    _FIELDS = ("peak", "value",)

    @property
    def peak(self) -> float:
        """Peak over the speed range, in the unit of the aim."""
        return self._get("peak")  # type: ignore[no-any-return]

    @property
    def value(self) -> float:
        """Damping [N m s/rad], or stiffness [N m/rad] where that alone is free."""
        return self._get("value")  # type: ignore[no-any-return]


class TunedDamper(Record):
    """The best setting, with the curve that proves it."""

    __slots__ = ()
    _FIELDS = ("aim", "curve", "damping", "free", "given", "is_at_end", "locked", "loss_factor", "minima", "peak", "speed", "stiffness",)

    @property
    def aim(self) -> TuneAim:
        """What is small."""
        return self._of("aim", TuneAim)  # type: ignore[no-any-return]

    @property
    def curve(self) -> Records[TunePoint]:
        """The free number and the peak that it gives (the best stiffness for each damping where both are free), rising."""
        return self._all("curve", TunePoint)

    @property
    def damping(self) -> float:
        """Best viscous damping [N m s/rad]."""
        return self._get("damping")  # type: ignore[no-any-return]

    @property
    def free(self) -> Literal['damping', 'stiffness', 'both']:
        """What was free."""
        return self._get("free")  # type: ignore[no-any-return]

    @property
    def given(self) -> float:
        """Peak with the damper as given."""
        return self._get("given")  # type: ignore[no-any-return]

    @property
    def is_at_end(self) -> bool:
        """Whether the best lies at an end of the range: a wider range would give less."""
        return self._get("is_at_end")  # type: ignore[no-any-return]

    @property
    def locked(self) -> float:
        """Peak with the ring locked to its hub."""
        return self._get("locked")  # type: ignore[no-any-return]

    @property
    def loss_factor(self) -> float:
        """Loss factor of the stiffness, as given."""
        return self._get("loss_factor")  # type: ignore[no-any-return]

    @property
    def minima(self) -> int:
        """Number of local minima on the curve: 1 where the best one is proved by the curve's points alone."""
        return self._get("minima")  # type: ignore[no-any-return]

    @property
    def peak(self) -> float:
        """Peak over the speed range at the best setting, in the unit of the aim."""
        return self._get("peak")  # type: ignore[no-any-return]

    @property
    def speed(self) -> float:
        """Speed of that peak [rad/s]."""
        return self._get("speed")  # type: ignore[no-any-return]

    @property
    def stiffness(self) -> float:
        """Best stiffness [N m/rad]."""
        return self._get("stiffness")  # type: ignore[no-any-return]


class TurningInertia(Record):
    """What turns, beside what pistons and rods bring."""

    __slots__ = ()
    _FIELDS = ("crankshaft", "flywheel",)

    @property
    def crankshaft(self) -> float:
        """All crankshafts with their counterweights, as seen at crankshaft 1 [kg m^2]; without the rods."""
        return self._get("crankshaft")  # type: ignore[no-any-return]

    @property
    def flywheel(self) -> float:
        """Flywheel with clutch, and whatever turns rigidly with crankshaft 1 [kg m^2]."""
        return self._get("flywheel")  # type: ignore[no-any-return]


class Unmeasured(Record):
    """Why a criterion has no number."""

    __slots__ = ()
    _FIELDS = ("reason", "remedy",)

    @property
    def reason(self) -> str:
        """What is missing or cannot be computed."""
        return self._get("reason")  # type: ignore[no-any-return]

    @property
    def remedy(self) -> str:
        """What would give it."""
        return self._get("remedy")  # type: ignore[no-any-return]


class VariedInput(Record):
    """An input, and how far it goes."""

    __slots__ = ()
    _FIELDS = ("half_width", "nominal", "part", "quantity",)

    @property
    def half_width(self) -> float:
        """How far it goes either way, in its SI unit."""
        return self._get("half_width")  # type: ignore[no-any-return]

    @property
    def nominal(self) -> float | None:
        """Its nominal value, where all of its parts have the same, in its SI unit."""
        return self._get("nominal")  # type: ignore[no-any-return]

    @property
    def part(self) -> int | None:
        """Index of the part; `None` for all parts together."""
        return self._get("part")  # type: ignore[no-any-return]

    @property
    def quantity(self) -> VariedQuantity:
        """Which quantity."""
        return self._of("quantity", VariedQuantity)  # type: ignore[no-any-return]


class VariedQuantity(Variant):
    """A number of the engine."""

    __slots__ = ()
    _FIELDS = ("kind", "part", "block_centre", "block_inertia", "block_product", "mount_place", "mount_turn", "mount_stiffness_along",)

    @property
    def kind(self) -> Literal['speed', 'spacing', 'part', 'rod-inertia', 'pin-offset', 'throw-plane', 'counterweight-plane', 'shaft-weight-plane', 'crankshaft-x', 'crankshaft-y', 'crankshaft-phase', 'knuckle-radius', 'knuckle-angle', 'main-plane', 'shaft-x', 'shaft-y', 'bore', 'gas-pressure', 'crankcase-pressure', 'pressure-delay', 'flywheel-inertia', 'crankshaft-inertia', 'block-mass', 'block-centre', 'block-inertia', 'block-product', 'mount-place', 'mount-turn', 'mount-stiffness', 'mount-stiffness-along', 'mount-loss-factor', 'mount-damping']:
        """Which of the variants it is.
        `speed`: Speed of crankshaft 1 [rad/s]. The pressures over the angle stay.
        `spacing`: Distance of the cylinders along the crank [m]: planes of throws, main bearings, cylinders and counterweights stretch about the
        origin, balance shafts stay.
        `rod-inertia`: Moment of inertia of a rod about its own centre of gravity [kg m^2], where the file gives it.
        `pin-offset`: Offset of the piston pin in its piston [m].
        `throw-plane`: Plane of a throw's own unbalance [m].
        `counterweight-plane`: Plane of a counterweight [m].
        `shaft-weight-plane`: Plane of a weight on a balance shaft [m].
        `crankshaft-x`: Place of the axis of a crankshaft along x [m]; its cylinders move with it.
        `crankshaft-y`: Place of the axis of a crankshaft along y [m]; its cylinders move with it.
        `crankshaft-phase`: Angle at which a crankshaft is geared to the first [rad].
        `knuckle-radius`: Distance of the knuckle pin of an articulated rod from the big end of its master rod [m].
        `knuckle-angle`: Angle of a knuckle pin from its master rod [rad].
        `main-plane`: Plane of a main bearing [m].
        `shaft-x`: Place of a balance shaft along x [m].
        `shaft-y`: Place of a balance shaft along y [m].
        `bore`: Bore of a cylinder [m].
        `gas-pressure`: Factor on the absolute pressure in a cylinder [1]; what is under the piston stays.
        `crankcase-pressure`: Factor on the absolute pressure under a piston [1].
        `pressure-delay`: Angle of its crankshaft by which the pressures of a cylinder come later [rad]: an ignition that is late, or a top dead centre
        that was measured at a wrong angle.
        `flywheel-inertia`: Moment of inertia of the flywheel [kg m^2].
        `crankshaft-inertia`: Moment of inertia of the crankshafts, as seen at crankshaft 1 [kg m^2].
        `block-mass`: Mass of the block [kg].
        `mount-stiffness`: Factor on the stiffness of a mount in all its directions, its table included [1]; loss factors stay.
        `mount-loss-factor`: Factor on the loss factors of a mount, its table included [1].
        `mount-damping`: Factor on the viscous damping of a mount [1].
        """
        return self._kind()  # type: ignore[no-any-return]

    @property
    def part(self) -> Literal['piston-mass', 'big-end-mass', 'small-end-mass', 'rod-centre', 'rod-length', 'crank-radius', 'throw-angle', 'throw-unbalance', 'offset', 'cylinder-plane', 'cylinder-angle', 'counterweight-unbalance', 'counterweight-angle', 'shaft-unbalance', 'shaft-phase'] | None:
        """What production varies too."""
        return self._get("part")  # type: ignore[no-any-return]

    @property
    def block_centre(self) -> Literal['x', 'y', 'z'] | None:
        """Place of the block's centre of mass [m]."""
        return self._get("block-centre")  # type: ignore[no-any-return]

    @property
    def block_inertia(self) -> Literal['x', 'y', 'z'] | None:
        """Moment of inertia of the block about its centre [kg m^2]."""
        return self._get("block-inertia")  # type: ignore[no-any-return]

    @property
    def block_product(self) -> Literal['x', 'y', 'z'] | None:
        """Product of inertia of the block: that of an axis and the next, xy, yz, zx [kg m^2]."""
        return self._get("block-product")  # type: ignore[no-any-return]

    @property
    def mount_place(self) -> Literal['x', 'y', 'z'] | None:
        """Place of a mount [m]."""
        return self._get("mount-place")  # type: ignore[no-any-return]

    @property
    def mount_turn(self) -> Literal['x', 'y', 'z'] | None:
        """Angle by which a mount with all its directions is turned about an axis of the frame [rad]."""
        return self._get("mount-turn")  # type: ignore[no-any-return]

    @property
    def mount_stiffness_along(self) -> Literal['first', 'second', 'third'] | None:
        """The same in one of its directions."""
        return self._get("mount-stiffness-along")  # type: ignore[no-any-return]


class WebBound(Record):
    """What fits on a web."""

    __slots__ = ()
    _FIELDS = ("bound", "by", "name", "web",)

    @property
    def bound(self) -> float:
        """The largest unbalance that it can have there [kg m]."""
        return self._get("bound")  # type: ignore[no-any-return]

    @property
    def by(self) -> str:
        """What bounds it: the ranges of its shapes, or what is in the way."""
        return self._get("by")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Name of the weight."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def web(self) -> int:
        """The web, counted from 1 through all throws."""
        return self._get("web")  # type: ignore[no-any-return]


class WebPlace(Record):
    """A web, away from its fillets."""

    __slots__ = ()
    _FIELDS = ("name",)

    @property
    def name(self) -> str:
        """"web 2"."""
        return self._get("name")  # type: ignore[no-any-return]


class WebSection(Record):
    """Sizes of a web with its pin and journal [m]."""

    __slots__ = ()
    _FIELDS = ("crank_radius", "journal_bore", "journal_diameter", "journal_fillet", "journal_recess", "oil_bore", "pin_bore", "pin_diameter", "pin_fillet", "pin_recess", "web_thickness", "web_width",)

    @property
    def crank_radius(self) -> float:
        """Crank radius, E."""
        return self._get("crank_radius")  # type: ignore[no-any-return]

    @property
    def journal_bore(self) -> float:
        """Diameter of its bore, D_BG; 0 for none."""
        return self._get("journal_bore")  # type: ignore[no-any-return]

    @property
    def journal_diameter(self) -> float:
        """Diameter of the journal, D_G."""
        return self._get("journal_diameter")  # type: ignore[no-any-return]

    @property
    def journal_fillet(self) -> float:
        """Radius of the journal's fillet, R_G."""
        return self._get("journal_fillet")  # type: ignore[no-any-return]

    @property
    def journal_recess(self) -> float:
        """Depth of its undercut, T_G."""
        return self._get("journal_recess")  # type: ignore[no-any-return]

    @property
    def oil_bore(self) -> float | None:
        """Diameter of the oil bore in the pin, D_O; `None`: there is none."""
        return self._get("oil_bore")  # type: ignore[no-any-return]

    @property
    def pin_bore(self) -> float:
        """Diameter of its bore, D_BH; 0 for none."""
        return self._get("pin_bore")  # type: ignore[no-any-return]

    @property
    def pin_diameter(self) -> float:
        """Diameter of the pin, D."""
        return self._get("pin_diameter")  # type: ignore[no-any-return]

    @property
    def pin_fillet(self) -> float:
        """Radius of the pin's fillet, R_H."""
        return self._get("pin_fillet")  # type: ignore[no-any-return]

    @property
    def pin_recess(self) -> float:
        """Depth of its undercut, T_H."""
        return self._get("pin_recess")  # type: ignore[no-any-return]

    @property
    def web_thickness(self) -> float:
        """Thickness of the web along the crank, W."""
        return self._get("web_thickness")  # type: ignore[no-any-return]

    @property
    def web_width(self) -> float:
        """Width of the web across its throw in the middle of the overlap, B."""
        return self._get("web_width")  # type: ignore[no-any-return]


class WebSheet(Record):
    """A web with its two fillets."""

    __slots__ = ()
    _FIELDS = ("breaches", "by_elements", "factors", "journal", "journal_fillet", "nominal", "pin_fillet", "ratios", "section", "web",)

    @property
    def breaches(self) -> Records[RangeBreach]:
        """Ratios outside the range of the formulas; where there is one, there are no factors and no safety."""
        return self._all("breaches", RangeBreach)

    @property
    def by_elements(self) -> ElementWeb | None:
        """Both by finite elements, where they were asked for."""
        return self._of("by_elements", ElementWeb)  # type: ignore[no-any-return]

    @property
    def factors(self) -> RuleFactors | None:
        """Stress concentration factors."""
        return self._of("factors", RuleFactors)  # type: ignore[no-any-return]

    @property
    def journal(self) -> int:
        """Number of the journal at it, from 1."""
        return self._get("journal")  # type: ignore[no-any-return]

    @property
    def journal_fillet(self) -> FilletSheet | None:
        """The journal's fillet."""
        return self._of("journal_fillet", FilletSheet)  # type: ignore[no-any-return]

    @property
    def nominal(self) -> NominalWeb:
        """Loads and nominal stresses."""
        return self._of("nominal", NominalWeb)  # type: ignore[no-any-return]

    @property
    def pin_fillet(self) -> FilletSheet | None:
        """The pin's fillet."""
        return self._of("pin_fillet", FilletSheet)  # type: ignore[no-any-return]

    @property
    def ratios(self) -> SectionRatios:
        """Their ratios."""
        return self._of("ratios", SectionRatios)  # type: ignore[no-any-return]

    @property
    def section(self) -> WebSection:
        """Sizes."""
        return self._of("section", WebSection)  # type: ignore[no-any-return]

    @property
    def web(self) -> int:
        """Its number along the crankshaft, from 1."""
        return self._get("web")  # type: ignore[no-any-return]


class WeightAsPart(Record):
    """A found weight as a part."""

    __slots__ = ()
    _FIELDS = ("at_radius", "mass", "name", "unbalance",)

    @property
    def at_radius(self) -> float | None:
        """What it weighs with its centre at the radius that the task gives [kg], where it gives one."""
        return self._get("at_radius")  # type: ignore[no-any-return]

    @property
    def mass(self) -> float | None:
        """What the best shape weighs [kg], a counterweight beyond its web as it is; none where no shape of the ranges has the unbalance."""
        return self._get("mass")  # type: ignore[no-any-return]

    @property
    def name(self) -> str:
        """Its name."""
        return self._get("name")  # type: ignore[no-any-return]

    @property
    def unbalance(self) -> float:
        """Its unbalance [kg m]."""
        return self._get("unbalance")  # type: ignore[no-any-return]


class WorstCase(Record):
    """The worst case of one output."""

    __slots__ = ()
    _FIELDS = ("attained", "bound", "deviations", "nominal", "output",)

    @property
    def attained(self) -> float:
        """What the deviations of `deviations` reach: a corner of the tolerances of which no single deviation can be
        turned to its other end with gain. The worst case lies between this and `bound`.
        """
        return self._get("attained")  # type: ignore[no-any-return]

    @property
    def bound(self) -> float:
        """A loose upper bound: no engine within the tolerances exceeds this. It is the nominal value and all that every part may be off, in whatever
        direction, so that it is far from `attained` where the parts cannot all push one way.
        """
        return self._get("bound")  # type: ignore[no-any-return]

    @property
    def deviations(self) -> FloatArray:
        """Deviation of every variable, tolerance by tolerance and part by part, in SI units."""
        return self._array("deviations")  # type: ignore[no-any-return]

    @property
    def nominal(self) -> float:
        """Of the nominal engine."""
        return self._get("nominal")  # type: ignore[no-any-return]

    @property
    def output(self) -> Output:
        """Which."""
        return self._of("output", Output)  # type: ignore[no-any-return]


class Wrench(Record):
    """A force and a moment, block axes."""

    __slots__ = ()
    _FIELDS = ("force", "moment",)

    @property
    def force(self) -> FloatArray:
        """Force [N]."""
        return self._array("force")  # type: ignore[no-any-return]

    @property
    def moment(self) -> FloatArray:
        """Moment about the point that the field's text names [N m]."""
        return self._array("moment")  # type: ignore[no-any-return]
