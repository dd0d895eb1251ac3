// Written by `cargo xtask generate` from the Rust types. Do not edit.
// SI units and radians; complex numbers are [re, im].

/** A crank angle at which a criterion stands at its peak and holds the optimum up. */
export type Active = {
  /** Which criterion. */
  criterion: Criterion;
  /**
   * Its share of the proof: the multipliers of a criterion add up to its weight in the stage (to the shadow price of the
   * limit for a limited one).
   */
  multiplier: number;
  /** Speed of crankshaft 1 [rad/s], where the criterion is judged at several: with gas. */
  speed?: number | null;
  /** Crank angle [rad]. */
  theta: number;
};

/** Quantities of an engine that other weights change. */
export type Affected = "force" | "couple" | "roll-moment" | "mount-force" | "main-load-rms" | "main-load-peak" | "bending-moment" | "counterweight-mass" | "counterweight-unbalance" | "shaft-unbalance" | "balance-rate";

/** Where in the engine a quantity is. */
export type AffectedPart = {
  kind: "engine";
} | {
  /** Its number, from 1. */
  crankshaft: number;
  kind: "crankshaft";
} | {
  /** Number of its crankshaft, from 1. */
  crankshaft: number;
  kind: "main";
  /** Its number from the free end, from 1. */
  main: number;
  /** Its plane [m], from the origin. */
  z: number;
} | {
  /** Number of its front main, from 1. */
  bay: number;
  /** Planes of its two mains [m], from the origin. */
  between: [number, number];
  /** Number of its crankshaft, from 1. */
  crankshaft: number;
  kind: "bay";
};

/** What is made small. */
export type Aim = "mass" | "swept-radius" | "inertia" | "thickness";

/** The best that can be done with the given devices. */
export type Answer = {
  /**
   * What decided among answers that the stages leave equal: of force and couple what no stage names, then the roll
   * moment if an inertia or the axis of a shaft is free (unless a stage asks for the least weights), then, if a weight on a
   * crankshaft is free, the root mean square of all main-bearing loads, the largest of them and the bending moment, each
   * without degrading the previous ones. Empty where nothing was left open. Among what is still equal the answer is the lightest.
   */
  among_equals: FoundStage[];
  /** Where orders had to vanish exactly: whether they do, and the proof. */
  cancellation: Cancellation | null;
  /**
   * Criteria before and after: force, couple, roll moment, root mean square of all main-bearing loads, the largest of them
   * and the bending moment always, then those that the task names. Empty where no answer was found.
   */
  effects: Effect[];
  /** Name of the engine. */
  engine: string;
  /** Where main-bearing loads with gas are judged: the speeds that decide [rad/s], and where the largest of them stands. */
  gas_speeds?: JudgedSpeeds | null;
  /** Every free inertia. */
  inertias: FoundInertia[];
  /** What each limit costs. */
  limits: FoundLimit[];
  /** How it was found. */
  method: Method;
  /** The same of forces at mounts with gas. */
  mount_gas_speeds?: JudgedSpeeds | null;
  /** Where forces of inertia at mounts with springs are judged: the speeds that decide [rad/s], and where the largest of them stands. */
  mount_speeds?: JudgedSpeeds | null;
  /** Whether there is an optimum, and if not, why. */
  outcome: Outcome;
  /** How far the search went, where it was one over choices. */
  settings: BalanceSettings;
  /** Where the free shafts stand. */
  shafts: FoundShaft[];
  /** Speed of crankshaft 1 at which loads are judged [rad/s]: the highest of the engine, where all of them are largest. */
  speed: number;
  /** What each stage reached, with its proof. */
  stages: FoundStage[];
  /** What was asked. */
  task: BalanceTask;
  /** [`ANSWER_VERSION`]. */
  version: number;
  /** Weights on webs whose largest amount is what fits there: the optimum is one within these bounds. */
  web_bounds?: WebBound[];
  /** Every free weight. Empty where there is no optimum. */
  weights: FoundWeight[];
};

/** A balance shaft of an arrangement. */
export type ArrangedShaft = {
  /** Radial load of each bearing [N]; it turns with the shaft at a constant amount. */
  bearing_loads: [number, number];
  /** Planes of its two bearings [m]. */
  bearing_planes: [number, number];
  /** Inertia of weights and shaft about its own axis [kg m^2]. */
  inertia: number;
  /** Weights in one plane or two. */
  layout: ShaftLayout;
  /** Name, as in the answer. */
  name: string;
  /** Speed over that of crankshaft 1, signed. */
  ratio: number;
  /** Mass of the bare shaft [kg]. */
  shaft_mass: number;
  /** Length of its longest weight along the axis [m]. */
  weight_length: number;
  /** Mass of its weights [kg]. */
  weight_mass: number;
  /** Outer radius of its weights [m]. */
  weight_sweep: number;
  /** Position of its axis [m]. */
  x: number;
  /** Position of its axis [m]. */
  y: number;
};

/** One arrangement with its weights, drive and price. */
export type Arrangement = {
  /** The weights, with the proof that these devices leave no less. */
  answer: Answer;
  /** Largest bending moment along any crankshaft as a free beam under what turns with it [N m]. */
  bending_moment: number;
  /** The narrowest place between the parts; `None` without shafts. Negative where no allowed position clears. */
  clearance: ArrangementClearance | null;
  /** Peak of the resultant couple about the origin that is left [N m]. */
  couple: number;
  /** Whether weights are added to the crank. */
  crank_weights: boolean;
  /** How the shafts are driven; `None` without shafts or without a place for them. */
  drive: DriveTrain | null;
  /** Peak of the resultant force that is left [N]. */
  force: number;
  /**
   * In short: "crank +2 -2", each number a balance shaft by its speed over that of the crank; "crank -1, lightest"
   * with the lightest weights that hold the limit; "nothing".
   */
  label: string;
  /** Whether its weights are the lightest that hold the limit; else they leave the smallest residual. */
  lightest: boolean;
  /** Largest load of inertia on any main bearing over the cycle, throw by throw [N]. */
  main_load: number;
  /** In words: "crank weights, second-order shafts with and against the crank". */
  name: string;
  /** Whether no other arrangement at this spacing beats it. */
  on_front: boolean;
  /** Whether it has a place and a drive, and holds the further limits. */
  possible: boolean;
  /** What it costs. */
  price: Price;
  /** Whether the residual is at or below the limit, within 1e-6 of it. */
  reaches_limit: boolean | null;
  /** Peak of the criterion that is left. Not a number for an arrangement that cannot hold the further limits. */
  residual: number;
  /** Peak of the roll moment that is left [N m], at the places of the shafts. */
  roll_moment: number;
  /** Its balance shafts. */
  shafts: ArrangedShaft[];
};

/** The narrowest place. */
export type ArrangementClearance = {
  /** Which parts, in words, with the crank angle for moving ones. */
  between: string;
  /** Distance between the two parts [m]; negative: they overlap. */
  distance: number;
};

/** Which arrangements are searched. */
export type ArrangementQuestion = {
  /** `gears` or `chain`. */
  drive: Drive | null;
  /** Limits as `--limit` takes them; one on what is minimised is what is good enough. */
  limits: string[];
  /** `force`, `couple` or `mount force`. */
  minimise: string | null;
  /** Most shafts, up to 4. */
  most_shafts: number | null;
  /** The engine file. */
  text: string;
};

/** All arrangements, by cylinder spacing. */
export type Arrangements = {
  /** Rules and sizes that were taken where the request gives none, in words. */
  assumptions: string[];
  /** What was judged. */
  criterion: Judged;
  /** Name of the engine. */
  engine: string;
  /** Value that is good enough, in the criterion's SI unit. */
  limit: number | null;
  /** Where that value comes from. */
  limit_source: string | null;
  /** Where nobody reaches the limit: the best that there is. */
  nearest: Nearest | null;
  /** One entry a spacing, in the order of the request. */
  spacings: SpacingArrangements[];
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** [`ARRANGEMENTS_VERSION`]. */
  version: number;
};

/** What an articulated rod changes. */
export type Articulation = {
  /** Number of the master's cylinder, from 1. */
  master: number;
  /** Slave reach [m]: the largest distance from the crankpin to the slave's piston pin over the cycle. */
  max_reach: number;
  /** The smallest such distance [m]. */
  min_reach: number;
  /** Stroke minus the master's stroke [m]. */
  stroke_difference: number;
  /** Angle of TDC minus the angle at which the crank points along the cylinder [rad]. */
  top_dead_centre_shift: number;
};

/** Something that is to happen on the way, in the words of the engine file. */
export type AskedEvent = {
  /** `misfire 3`, `fuel 0 %`, `load 120 N m`, `load none`, `clutch open` or `stop`. */
  what: string;
  /** A time, an angle, revolutions or a speed that is passed: `3 revolutions`, `speed falls to 900 rpm`. */
  when: string;
};

/** A criterion that must not fall below a value. */
export type AtLeast = {
  /** What. */
  criterion: DurabilityCriterion;
  /** Smallest value, in the criterion's SI unit. */
  least: number;
};

/** An engine at a speed. */
export type AtSpeed = {
  /** Speed of crankshaft 1 [rad/s]; the highest of the engine where it is left out. */
  speed: number | null;
  /** The engine file. */
  text: string;
};

/** A line in space. */
export type AxisLine = {
  /** Its direction, a unit vector. */
  direction: [number, number, number];
  /** A point of it [m]. */
  point: [number, number, number];
};

/** What was found. */
export type BalanceAnswer = {
  /** Loads with it. */
  after: Loads | null;
  /** As `lanchester balance --format json` prints it. */
  answer: Answer;
  /** Oil films and safeties before, at the optimum and after the search for them, in words; none where none is wanted. */
  durability: string | null;
  /** What it does to the engine. */
  effect: WeightEffect | null;
  /** The outcome in words. */
  headline: string;
  /** What drawn engines have of it, in words; none without `robust`. */
  robust: string | null;
  /** The engine file with what was found; none where nothing was. */
  text: string | null;
  /** Added shafts that may strike the crank or stand far out. */
  warnings: Warning[];
};

/** What may be changed, and what is wanted. */
export type BalanceQuestion = {
  /** Oil films and safeties that must not fall below a value, as `--at-least` takes them. */
  at_least: string[];
  /** Largest cost of all that is used, as `--budget` takes it. */
  budget: string | null;
  /** Orders that must vanish, as `--cancel` takes them. */
  cancel: string[];
  /** Whether all free weights on crankshafts have the same amount of their steps or lists, as `--equal-parts`. */
  equal_parts: boolean;
  /** Which weights are free. */
  free: Free;
  /** Gap at which a search over choices ends, as `--gap` takes it; none: 1e-8. */
  gap: string | null;
  /** What stages give up for those after them, as `--give-up` takes it. */
  give_up: string[];
  /** Least unbalance of every free weight on a crankshaft that is used, as `--min-unbalance` takes it. */
  least: string | null;
  /** Limits as `--limit` takes them. */
  limits: string[];
  /** Names of counterweights and shafts that stay as they are, with `free = "devices"`. */
  locked: string[];
  /** Most branch-and-bound nodes for one stage, as `--max-nodes` takes it; none: 2000. */
  max_nodes: number | null;
  /** Oil films and safeties that are to be large, as `--maximise` takes them. */
  maximise: string[];
  /** Criteria in their order, as `--minimise` takes them; none: force, then couple. */
  minimise: string[];
  /** Largest unbalance of every free weight on a crankshaft, as `--max-unbalance` takes it. */
  most: string | null;
  /** Engines drawn within the tolerances of the file, the worst of which is minimised, as `--robust` takes it. */
  robust: number | null;
  /** With `robust`: seed of the draws; none: 1. */
  robust_seed: number | null;
  /** Shafts that are added, as `--shaft` takes them: `-1 @ 0 mm, 100 mm @ -30 mm, 30 mm` is ratio @ x, y of the axis @ planes. */
  shafts: string[];
  /** Speeds at which forces at mounts with springs and loads with gas count, as `--speed` takes them; none: the range of the file. */
  speeds: string[];
  /** Step in which every free weight on a crankshaft is made, as `--weight-step` takes it. */
  step: string | null;
  /** The engine file. */
  text: string;
  /** Longest time of the search, as `--time-limit` takes it; none: no limit. */
  time_limit: string | null;
  /** With `robust`: minimise the mean of this share of the engines, the worst ones, as `--worst-share` takes it. */
  worst_share: string | null;
};

/**
 * How far a search over choices goes: places to be found, given and least amounts, devices that may be left out. A task that is
 * one convex programme is always solved to a gap of 1e-8.
 */
export type BalanceSettings = {
  /**
   * The search for a stage ends at this gap between the best value and its bound, relative to the larger of the value and a
   * millionth of the stage without the devices: 1e-8 to 0.5. Later stages may use up what it leaves.
   */
  gap: number;
  /** Most branch-and-bound nodes examined for one stage, 1 or more. */
  max_nodes: number;
  /** Longest time of the whole search [s], above 0; none: no limit. Kept by the caller's clock: see [`BalanceSettings::next`]. */
  time_limit: number | null;
};

/** Free weights, shafts and inertias, with what is to be minimised and what must hold. */
export type BalanceTask = {
  /**
   * Orders of loads that must vanish exactly, instead of stages and limits. Of all weights that do it those come first that the
   * default stages and what decides among equals put first.
   */
  cancel: Array<[Load, number]>;
  /** Films and safeties that must not fall below a value or are to be large, after the optimum of the stages. */
  durability?: DurabilityWish;
  /**
   * How far later stages may raise each stage above its least value, in the order of the stages (of the default ones where
   * none are named); a stage without an entry gives up nothing.
   */
  give_up: GiveUp[];
  /** Inertias that turn against a crankshaft. */
  inertias: FreeInertia[];
  /** What must hold. */
  limits: Limit[];
  /** Most of the optional weights, shafts and inertias that may be used at once. */
  most_optional: number | null;
  /** What each shaft costs if it is used, in the order of the shafts; a shaft without an entry costs nothing. */
  shaft_costs: number[];
  /** Balance shafts that may be fitted. */
  shafts: FreeShaft[];
  /** What loads at each of these speeds are multiplied by before the largest counts, in their order; a speed without an entry has 1. */
  speed_weights?: number[];
  /**
   * Speeds [rad/s] of crankshaft 1 at which forces at mounts with springs and loads with gas are judged, the largest of all counting;
   * empty: the whole range of the engine. All other loads are largest at the highest speed.
   */
  speeds: number[];
  /**
   * What is minimised: the first stage first, each next one without degrading the previous ones. Empty: force, then
   * couple. Among answers that all stages leave equal the one is chosen whose force and couple, as far as no stage
   * names them, and then roll moment are least; of those, where a weight on a crankshaft is free, the one with the least
   * root mean square of main-bearing loads, then the least largest one, then the least bending moment; of those the
   * lightest.
   */
  stages: Stage[];
  /** Weights that depend on one another. */
  ties: Tie[];
  /** Weights on the crankshafts and on these shafts. */
  weights: FreeWeight[];
};

/** What the stresses of the fillets tend to, with their error bands. */
export type BandsFound = {
  /**
   * Fillet by fillet, along z: the largest von Mises stress over the cycle [Pa]; `null` of a sharp corner, and where the meshes have the same elements
   * across the fillets.
   */
  bands: Array<Extrapolated | null>;
  /** The meshes, the coarse one first. */
  meshes: [BandsMesh, BandsMesh, BandsMesh];
  /** Why the meshes are as fine as they are, where nobody says it. */
  note: string | null;
};

/** One of the meshes. */
export type BandsMesh = {
  /** Elements across the 90 degrees of a fillet. */
  fillet_elements: number;
  nodes: number;
  /** Operations of its solution, which say how large its share of the study is. */
  operations: number;
  /** Edge of the elements away from fillets [m]. */
  size: number;
  unknowns: number;
};

/** The stress over the cycle, and how far its study has come. */
export type BandsQuestion = {
  /** Where the turn before ended; nothing for the first one. */
  so_far: SoFar | null;
  /** What is computed on each of the three meshes; its own mesh is the coarse one. */
  stress: StressQuestion;
};

/** A turn of the study: the first one says what it costs, each of the others solves a mesh. */
export type BandsTurn = {
  /** Share of the study that is done, 0 to 1. */
  done: number;
  /** What was found, with the last mesh. */
  found: BandsFound | null;
  /** Where the next turn goes on. */
  so_far: SoFar;
};

/** A crankshaft in one model. */
export type BeamLoads = {
  /** Load on every main bearing, rising; 0 where the model lets it carry nothing. */
  mains: MainLoad[];
  /** Largest load on any main bearing; its plane. */
  peak_main: Peak;
  /** Largest bending moment along the shaft and over the cycle. */
  peak_moment: Peak;
  /** Largest shear force along the shaft and over the cycle. */
  peak_shear: Peak;
  /**
   * Every plane with a load or a main bearing, rising from the free end to the flywheel. Between two of them the shear
   * force is constant and the bending moment runs straight, so that extremes along the shaft lie here.
   */
  stations: Station[];
};

/** A bearing of an engine and its film over the cycle. */
export type BearingFilm = {
  /** The bearing. */
  bearing: JournalBearing;
  /** Of a journal of a shaft that floats in its films: what film and contact carry at every instant [N], and the slope of its axis [rad]. */
  carried?: Carried[];
  /** Model of cavitation. */
  cavitation: Cavitation;
  /** Number of its crankshaft, from 1. */
  crankshaft: number;
  /** Whether that balance was found. */
  heat_balanced: boolean;
  /** Turns of the journal for one of crankshaft 1, below 0 against it. */
  journal_turns: number;
  /** Main or big end. */
  kind: BearingKind;
  /** Largest load [N]. */
  largest_load: number;
  /** Crank angle of the largest pressure [rad]. */
  largest_pressure_angle: number;
  /** Crank angle of the least film [rad]. */
  least_film_angle: number;
  /** Direction of the least film in the shell's frame [rad]: of a main that of the engine, of a big end from the rod's line towards the piston. */
  least_film_in_shell: number;
  /** Number of the main bearing on its crankshaft, or of the cylinder. */
  number: number;
  /** Orbit and film. */
  orbit: FilmOrbit;
  /** Largest and mean load over diameter times length [Pa]. */
  projected_pressure: [number, number];
  /** Composite roughness [m]. */
  roughness: number;
  /** Angle of the shell's frame at the instants of the orbit [rad]: of a big end the rod's line towards the piston. Empty: it does not turn. */
  shell_angle?: number[];
  /** Temperature of the film [K], where that of supply is known: the balance was repeated until it changed by 0.1 K. */
  temperature: number | null;
  /** Rise of temperature through the film [K]; `None` where no flow takes the heat away, as in full films, or the rise is more than 1000 K. */
  temperature_rise: number | null;
  /** Viscosity of the film [Pa s]. */
  viscosity: number;
};

/** Oil films of an engine at one speed. */
export type BearingFilms = {
  /** What the file does not say and was assumed, and what was left out. */
  assumptions: string[];
  /** Name of the engine. */
  engine: string;
  /** By bearing and model of cavitation. */
  films: BearingFilm[];
  /** Period of crankshaft 1 [rad]. */
  period: number;
  /** How each crankshaft that floats in its films ran, with its energy balance, by crankshaft and model of cavitation; none where journals have no mass. */
  shafts?: ShaftRun[];
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** [`BEARING_FILMS_VERSION`]. */
  version: number;
};

/** Which bearing of the engine. */
export type BearingKind = "main" | "crankpin";

/**
 * Loads of all bearings at one speed.
 *
 * No weight, no play, no friction, no oil film; rigid parts; main bearings throw by throw, as if the shaft were cut at each of them.
 */
export type BearingLoads = {
  /** Whether the weights on the crankshafts count. */
  counterweights: boolean;
  /** By cylinder. */
  cylinders: CylinderBearings[];
  /** Name of the engine. */
  engine: string;
  /** Main bearings: crankshaft 1 first, each from the free end on. */
  mains: MainBearing[];
  /** Which loads count. */
  part: BearingPart;
  /** Period [rad] of crankshaft 1. */
  period: number;
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** Crank angle [rad] of every trace, from 0, one period, end point excluded. */
  theta: number[];
  /** [`BEARINGS_VERSION`]. */
  version: number;
  /** Numbers of the crankshafts, from 1, of which no bearing is told because they have no throw. */
  without_mains: number[];
};

/** Which loads count. */
export type BearingPart = "all" | "gas" | "inertia";

/** Loads of the bearings, and without counterweights where the engine has some. */
export type BearingsAnswer = {
  /** Whether the weights on the crankshafts count. */
  counterweights: boolean;
  /** By cylinder. */
  cylinders: CylinderBearings[];
  /** Name of the engine. */
  engine: string;
  /** Main bearings: crankshaft 1 first, each from the free end on. */
  mains: MainBearing[];
  /** Which loads count. */
  part: BearingPart;
  /** Period [rad] of crankshaft 1. */
  period: number;
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** Crank angle [rad] of every trace, from 0, one period, end point excluded. */
  theta: number[];
  /** [`BEARINGS_VERSION`]. */
  version: number;
  without_counterweights: BearingLoads | null;
  /** Numbers of the crankshafts, from 1, of which no bearing is told because they have no throw. */
  without_mains: number[];
};

/** Bending moment along a crankshaft, before and after: straight between these planes. */
export type BendingAlong = {
  /** With the new weights. */
  after: Array<[number, number]>;
  /** Bending moment `M_x + i M_y` at `theta = 0` [N m]; it turns with the crankshaft. */
  before: Array<[number, number]>;
  /** Number of the crankshaft, from 1. */
  crankshaft: number;
  /** Planes [m], from the origin, rising. */
  z: number[];
};

/** A mount whose table ends before the excitation does: beyond it the end's values are used. */
export type BeyondTable = {
  /** Lowest and highest angular frequency of the excitation [rad/s]. */
  excitation: [number, number];
  /** Index of the mount. */
  mount: number;
  /** Angular frequencies of the table's ends [rad/s]. */
  table: [number, number];
};

/** A big end within the crankcase. */
export type BigEndClearance = {
  /** Its clearance; `on_body` is on the big end. */
  clearance: Clearance;
  /** Cylinder of the rod, from 1. */
  cylinder: number;
  /** Largest distance of the big end from the axis of the crankshaft [m]. */
  swept_radius: number;
};

/** How the block of an engine's graph moves. */
export type BlockOf = "fixed" | "plane" | "space";

/** The bobweight of one pin. */
export type Bobweight = {
  /** The bobweight [kg]. */
  mass: number;
  /** Oil [kg]. */
  oil: number;
  /** Name of the pin. */
  pin: string;
  /** Reciprocating mass of all rods [kg]. */
  reciprocating: number;
  /** Rods on the pin. */
  rods: number;
  /** Rotating mass of the rods [kg], without the oil. */
  rotating: number;
  /** Number of its throw in the engine file. */
  throw: number | null;
};

/** The engine with the weighed parts, its crank balanced in different ways. */
export type BobweightComparison = {
  /** Proved alike: none that reach that peak force have a smaller peak couple [N m]. */
  couple_bound: number;
  /** Proved for the optimum: no weights at the ends of the crank have a smaller peak force [N] than this. */
  force_bound: number;
  /** Speed [rad/s]. */
  speed: number;
  /** The ways; the last is the optimum. */
  ways: ComparedBalance[];
};

/** The clearances of a counterweight with its web, or of a web without counterweight. */
export type BodyClearances = {
  /** Whether it has chamfers, which count as not cut: every distance is a lower bound then. */
  chamfers_ignored: boolean;
  /**
   * Its clearance to every obstacle that is there, but those that lie farther away along the crank than another one
   * of their kind is at its nearest.
   */
  clearances: Clearance[];
  /** Index of its crankshaft. */
  crankshaft: number;
  /** Its first and its last plane [m]. */
  faces: [number, number];
  /** Name of the counterweight, or "web 3". */
  name: string;
  /** Swept radius [m]. */
  swept_radius: number;
};

/** What friction leaves. */
export type Brake = {
  /** Brake mean effective pressure [Pa]: what is left of the mean effective pressure of both sides of the pistons. */
  bmep: number;
  /** Brake over indicated torque [1]. */
  efficiency: number;
  /** Friction mean effective pressure [Pa]. */
  fmep: number;
  /** Brake power [W]. */
  power: number;
  /** Brake torque at crankshaft 1 [N m]. */
  torque: number;
};

/** Data of a Campbell diagram. */
export type Campbell = {
  /** Critical speeds within the range, by falling modal torque. */
  criticals: Critical[];
  /** Natural frequency of each mode at each speed [rad/s]; only pendulums make it depend on the speed. */
  frequencies: number[][];
  /** Orders drawn. */
  orders: number[];
  /** Speeds [rad/s]. */
  speeds: number[];
};

/** Exact cancellation: what had to vanish, and the proof that no lighter weights do it or that none can. */
export type Cancellation = {
  /** Every order of the task, in its order. */
  orders: CancelledOrder[];
  /** What was found, with its proof. */
  verdict: CancellationVerdict;
};

/** Whether the orders can vanish together. */
export type CancellationVerdict = {
  /** Whether the total is a mass. */
  is_mass: boolean;
  kind: "vanish";
  /** That of the lightest weights that do it; the same where nothing but the weights decides. */
  least: number;
  /** No weights that make the orders vanish have a total below `lightest.value`. */
  lightest: Functional;
  /** Total unbalance of the answer [kg m], or mass [kg] where every weight has a radius. */
  total: number;
} | {
  kind: "cannot-vanish";
  /** At least one, each for orders that hang together through the devices. */
  obstructions: Obstruction[];
};

/** An order that had to vanish. */
export type CancelledOrder = {
  /** One order of a load. */
  criterion: Criterion;
  /** The least that these devices leave of it where nothing else is asked for [N or N m]; 0 where it can vanish alone. */
  least_alone: number;
  /** Its peak with the answer [N or N m]: from the loads of the engine with the weights fitted, computed anew. */
  left: number;
  /** Its peak without the free devices [N or N m]. */
  without: number;
};

/** How an output stands to a limit. */
export type Capability = {
  /** Samples beyond the limit. */
  beyond: number;
  /** `(limit - mean) / (3 standard deviations)`: for a normal distribution. */
  cpk: number;
  /** `(limit - median) / (99.865 % percentile - median)`: for any distribution (ISO 22514-2). */
  cpk_by_percentiles: number;
  /** The limit. */
  limit: number;
};

/** A journal of a floating shaft at an instant. */
export type Carried = {
  /** Force of the journal on its bearing [N]. */
  load: [number, number];
  /** Slope of its axis along x and y [rad]. */
  slope: [number, number];
};

/** Amounts of which a free weight has one, or none at all. */
export type Catalogue = {
  steps: number;
} | {
  amounts: number[];
};

/** A hole of a catalogue. */
export type CatalogueHole = {
  /** Depth from the surface to the end of the full diameter [m]. */
  depth: number;
  /** Diameter of the drill [m]. */
  diameter: number;
  /** Density of the slug that fills it [kg/m^3]; none: it stays empty. */
  slug_density: number | null;
  /** Depth from the surface that the tip of the drill reaches [m]. */
  tip: number;
  /** Unbalance that the hole removes, or that the slug in it adds beyond what was drilled away [kg m]. */
  unbalance: number;
};

/** Model of cavitation. */
export type Cavitation = "full" | "gumbel" | "reynolds" | "mass-conserving";

/** The chamber that pistons share. */
export type ChamberMotion = {
  /** Crank angle at its bottom dead centre, where its volume is largest [rad], in the first turn. */
  bottom_dead_centre: number;
  /** Numbers of its cylinders, from 1, rising. */
  cylinders: number[];
  /** What the pistons leave free below their own top dead centres where its volume is least [m^3]; 0 where they are all there at once. */
  least: number;
  /** Largest less smallest volume [m^3]; without bores the same of the travels [m]. */
  swept: number;
  /** Crank angle of crankshaft 1 at its top dead centre, where its volume is least [rad], in the first turn of its crankshafts. */
  top_dead_centre: number;
};

/** A chamfer of a part's edge. */
export type Chamfer = {
  /** Angle of its surface against the face [rad], between 0 and a quarter turn: 45 degrees is as deep as wide. */
  angle: number;
  /** Its surface. */
  cut: Cut;
  /** Face that it is on. */
  face: Face;
};

/** What became of a quantity. */
export type Change = "better" | "unchanged" | "worse";

/** A counterweight that is a part. */
export type CheckedCounterweight = {
  /** Its index in [`Engine::counterweights`]. */
  index: number;
  /** Whether it is within a hundredth of what it should be. */
  is_met: boolean;
  /** Its mass beyond the plain web [kg]: what it adds to the crankshaft. */
  mass: number;
  /** Its name. */
  name: string;
  /** Mass of the part as it is exported, with what of the web it covers [kg]. */
  part_mass: number;
  /** Its polar inertia about the crank axis beyond the plain web [kg m^2]. */
  polar_inertia: number;
  /** Swept radius [m]. */
  swept_radius: number;
  /** Thickness [m]. */
  thickness: number;
  /** The unbalance that it has on its web [kg m]. */
  unbalance: number;
  /** The unbalance that it should have [kg m], if the file says so. */
  wanted: number | null;
};

/** A weight of a balance shaft that is a part. */
export type CheckedShaftWeight = {
  /** Its faces along z [m], from the origin. */
  faces: [number, number];
  /** Whether it is within a hundredth of what it should be. */
  is_met: boolean;
  /** Its mass without the shaft within it [kg]. */
  mass: number;
  /** Its name. */
  name: string;
  /** Its moment of inertia about the axis of its shaft, without the shaft [kg m^2]. */
  polar_inertia: number;
  /** Its radius, which is the swept one [m]. */
  radius: number;
  /** Index of its shaft in [`Engine::shafts`]. */
  shaft: number;
  /** Diameter of the shaft within it [m]. */
  shaft_diameter: number;
  /** The unbalance that it has [kg m]. */
  unbalance: number;
  /** The unbalance that it should have [kg m], if the file says so. */
  wanted: number | null;
};

/** One of the arrangements of a search. */
export type ChosenArrangement = {
  /** Its number among all that were examined, from 1. */
  choice: number;
  /** What was searched. */
  search: ArrangementQuestion;
};

/** A design of a front. */
export type ChosenDesign = {
  /** Its number, from 1. */
  choice: number;
  /** The front that it stands on. */
  front: FrontQuestion;
};

/** One layout of a search. */
export type ChosenLayout = {
  /** Number of its case. */
  case: number;
  /** What was searched. */
  search: LayoutQuestion;
};

/** The smallest distance of a counterweight or web from an obstacle over all angles. */
export type Clearance = {
  /** Proved bound: it is nowhere smaller than this [m]. */
  bound: number;
  /** Smallest distance in space [m], zero where they overlap. */
  distance: number;
  /** Whether they stay clear of each other by what is wanted, proved. */
  is_kept: boolean;
  /** The obstacle. */
  obstacle: Obstacle;
  /** The point on the counterweight or web then (at `theta` zero where it is the same at all angles): x, y, z [m]. */
  on_body: [number, number, number];
  /** The point on the obstacle then [m]. */
  on_obstacle: [number, number, number];
  /** How they overlap, if they do. */
  overlap: Overlap | null;
  /**
   * Angle of crankshaft 1 [rad] at which it is that small (where they overlap: deepest); none where it is the same at
   * all angles.
   */
  theta: number | null;
};

/** All clearances of an engine's crankshafts. */
export type Clearances = {
  /** Big ends against the crankcase. */
  big_ends: BigEndClearance[];
  /** Counterweights in the engine's order, then the webs that carry none. */
  bodies: BodyClearances[];
  /** Whether nothing overlaps and all stay clear by what is wanted, proved. */
  is_kept: boolean;
  /** The clearance that is wanted to everything [m]. */
  least: number | null;
  /** The smallest of all; the sides of big ends count only where they overlap. */
  smallest: Smallest | null;
  /** [`CLEARANCE_VERSION`]. */
  version: number;
};

/** Engines side by side. */
export type CompareQuestion = {
  /** The engines in the order of the answer. */
  engines: NamedEngine[];
  /** In what they are made equal; as they are where it is left out. */
  equal: EqualIn | null;
  /** What a similar engine keeps; the speed where it is left out. */
  hold: Hold | null;
  /** Mean piston speed of all engines [m/s], in the place of the speed. */
  piston_speed: number | null;
  /** Place of the one with which the others are compared, from 0. */
  reference: number;
  /** Speed of crankshaft 1 of all engines [rad/s]; the highest of each where it is left out. */
  speed: number | null;
};

/** One engine of a comparison, in the size in which it is compared. */
export type Compared = {
  /** Mass of the counterweights and shaft weights that are parts [kg]; `None` where one of them is a number only. */
  added_mass: number | null;
  /**
   * Least and largest balance rate of any bay: share of the rotating unbalance between two main bearings that the counterweights
   * there answer [1].
   */
  balance_rate: [number, number] | null;
  /** Largest bending moment along any crankshaft as a free beam under what turns with it [N m]. */
  bending_moment: number | null;
  /** Unbalance of all counterweights [kg m]. */
  counterweights: number;
  /** Largest resultant couple about the reference point [N m]. */
  couple: number;
  /** What most of the couple is. */
  couple_leading: Leading | null;
  /** The same of any big-end bearing [m]. */
  crankpin_film: Measured;
  /** Displacement [m^3], where all bores are known. */
  displacement: number | null;
  /** Its name. */
  engine: string;
  /** Smallest safety of any fillet by finite elements [1], where it is asked for. */
  fillet_safety?: Measured | null;
  /** Largest departure of a firing interval from the even one, over it, where firing is known. */
  firing_unevenness: number | null;
  /** Largest resultant force of the moving masses on the block [N]. */
  force: number;
  /** What most of the force is. */
  force_leading: Leading | null;
  /** Smallest oil film of any main bearing over the cycle [m], the smaller of that at the lowest speed and at the speed of the comparison. */
  main_film: Measured;
  /** Largest load of inertia on any main bearing over the cycle, throw by throw [N]; `None` for crankshafts without throws. */
  main_load: number | null;
  /**
   * Largest force at any of its mounts [N]: of inertia and, where it is known, of gas, over the range of speeds on mounts with
   * springs; of inertia alone, at the speed, on mounts without, which share what they can carry. `None` without mounts.
   */
  mount_force: number | null;
  /** Largest roll moment of the moving masses, either way [N m]. */
  roll_moment: number;
  /** Smallest safety of any fillet or oil bore by the formulas after UR M53 [1], at these speeds. */
  rule_safety: Measured;
  /** Unbalance of all weights of balance shafts [kg m]. */
  shaft_weights: number;
  /** Number of balance shafts. */
  shafts: number;
  /** Its size over that of its file. */
  similar: Similar;
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** Torque of gas and inertia, where the gas is known. */
  torque: ComparedTorque | null;
  /** What it got in place of its own counterweights and shafts, in words. */
  with: string | null;
};

/** Peaks over the cycle at the highest speed of the engine. */
export type ComparedBalance = {
  /** Largest resultant couple [N m]. */
  couple: number;
  /** Largest resultant force [N]. */
  force: number;
  /** How the crank is balanced. */
  how: string;
};

/** Torque of gas and inertia at the speed of the comparison, and the flywheel for the lowest speed. */
export type ComparedTorque = {
  /** Largest excess energy [J]. */
  excess: number;
  /** Excess energy over the work of one period: how uneven the torque is, whatever its size. */
  excess_share: number;
  /** Flywheel that the true speed needs for it [kg m^2], of variable inertia; `None` where none keeps it. */
  flywheel: number | null;
  /** Inertia by the formula for the fluctuation of the comparison at the lowest speed [kg m^2]. */
  inertia: number;
  /** Smallest torque [N m]. */
  least: number;
  /** Mean torque at crankshaft 1 [N m]. */
  mean: number;
  /** Largest torque [N m]. */
  most: number;
  /** Net indicated power [W]. */
  power: number;
};

/** Engines side by side. */
export type Comparison = {
  /** The engines in the order of the request. */
  engines: Compared[];
  /** In what they were made equal. */
  equal: Equal;
  /** Fluctuation of the speed that the flywheels keep at the lowest speed [1]. */
  fluctuation: number;
  /** What they kept while they were. */
  held: Held;
  /** Their order by every criterion that all of them have. */
  rankings: Ranking[];
  /** The engine with which the others are compared, by its place. */
  reference: number;
  /** Share of its loads, devices and flywheel that the others are compared with [1]. */
  share: number;
  /** [`COMPARISON_VERSION`]. */
  version: number;
  /** What the user should know. */
  warnings: string[];
};

/** An engine file with typical values in the place of what was missing. */
export type Completed = {
  /** Sections that were added, in the order of the file. */
  added: TypicalSection[];
  /** The kind of engine that they were taken for. */
  kind: EngineKind;
  /** Sections that this engine cannot have, and why. */
  left_out: LeftOut[];
  /** The text of the file with them. */
  text: string;
};

/** One quantity before and after. */
export type Consequence = {
  /** With the new ones. */
  after: number;
  /** With the weights that the engine had, in the unit of the quantity; what is rounding is 0. */
  before: number;
  /** What became of it. */
  change: Change;
  /** Where. */
  part: AffectedPart;
  /** Which. */
  quantity: Affected;
};

/** What other weights do to an engine. */
export type Consequences = {
  /** Names of counterweights that were not there before. */
  added: string[];
  /** Bending moment along every crankshaft with throws. */
  bending: BendingAlong[];
  /** Number of counterweights before and after. */
  counterweights: [number, number];
  /** Names of counterweights that are there no more, or have no unbalance any more. */
  dropped: string[];
  /** Every quantity, in the order of [`Affected`]; within one from the free end on. */
  rows: Consequence[];
  /** Speed of crankshaft 1 [rad/s]: the highest of the engine. */
  speed: number;
  /** [`CONSEQUENCES_VERSION`]. */
  version: number;
};

/** A closed line that runs anticlockwise and does not cross or touch itself. */
export type Contour = Edge[];

/** What one tolerance adds to the scatter. */
export type Contribution = {
  /** Its standard error: what other samples of the same number would change, about. */
  error: number;
  /**
   * First-order index: share of the output's variance that would vanish if the deviations of this tolerance, one at a
   * time, were known. Shares sum to 1 less what only several together do.
   */
  share: number;
  /** Place of the tolerance in the request, from 0. */
  tolerance: number;
};

/** What a weight costs if it is used, in whatever unit the file counts: nothing where it is not. */
export type Cost = {
  /** Whatever its amount. */
  fixed: number;
  /** For every unit of its amount [1/(kg m)]. */
  per_amount: number;
};

/** Crankshafts, counterweights, weights of balance shafts and clearances of an engine. */
export type CounterweightCheck = {
  /** Clearances; none where the file names nothing to stay clear of. */
  clearances?: Clearances | null;
  /** Counterweights that are parts. */
  counterweights: CheckedCounterweight[];
  /** The crankshafts as bodies; empty where the file has no `[crank.body]`. */
  crankshafts: CrankshaftBody[];
  /** Name of the engine. */
  engine: string;
  /** Whether every counterweight and weight of a shaft has its unbalance and every clearance is kept. */
  is_kept: boolean;
  /** Weights of balance shafts that are parts. */
  shaft_weights: CheckedShaftWeight[];
  /**
   * Where swept circles of weights of balance shafts overlap those of another shaft or of a crankshaft in one plane: whether anything
   * meets depends on the phases.
   */
  swept_overlaps: SweptOverlap[];
  /** [`COUNTERWEIGHT_CHECK_VERSION`]. */
  version: number;
};

/** The shapes found for counterweights of an engine. */
export type CounterweightDesigns = {
  /** Name of the engine. */
  engine: string;
  /** Shapes among which they were found. */
  task: ShapeTask;
  /** [`COUNTERWEIGHT_DESIGNS_VERSION`]. */
  version: number;
  /** The weights, in the order of the engine. */
  weights: DesignedCounterweight[];
};

/** The trade between two objectives for weights of one duty. */
export type CounterweightFront = {
  /** With a room: how far all of them may reach in each direction. */
  envelope?: RadialEnvelope | null;
  /** The designs, each as what it adds to the crankshaft beyond the web as it is. */
  front: Front;
  /** The smallest swept radius that keeps the wanted clearance of one of them whatever the shape; none where there is nothing to stay clear of. */
  room?: SweptRoom | null;
  /** Indices of the weights in [`Engine::counterweights`]. */
  weights: number[];
};

/** A counterweight of the family around the disc of its web. */
export type CounterweightShape = {
  /** Included angle `alpha` of the arc [rad], less than a full turn. */
  arc_angle: number;
  /** Radius `R` of the arc [m]. */
  arc_radius: number;
  /** Height `h` of the rectangle, from the crank axis [m]. */
  rectangle_height: number;
  /** Height `H` of the trapezoid [m]. */
  shoulder_height: number;
  /** Radius `r` of the web's disc, and half width of the rectangle [m]. */
  web_radius: number;
};

/**
 * Unbalance of something that turns with the crankshaft, as a force and as a couple.
 *
 * ```text
 * U = INTEGRAL (x, y) dm      V = INTEGRAL z (x, y) dm        (book, eq. 22.50)
 * [kg m]                      [kg m^2], about the origin of the engine
 * ```
 * At the angular speed `w` it pulls with `w^2 U`, and with the couple `w^2 V` of the forces at their places along z.
 */
export type CrankUnbalance = {
  /** Its moment `V` along the crank [kg m^2]. */
  couple: Point;
  /** Static unbalance `U` [kg m]. */
  unbalance: Point;
};

/** A crankshaft as a body. Frame: [`crate::crankshaft`]. */
export type CrankshaftBody = {
  /**
   * What pieces have in common, which a sum over pieces that stand alone would count twice (eq. 22.52). Of an engine that was read
   * from a file the part that a counterweight of the family shares with its own web is out of its weight already.
   */
  counted_twice: CrankUnbalance;
  /**
   * Mass, centre and inertia of all pieces, without point weights: about the origin of the engine on the crank axis
   * and about the centre of mass, products of inertia with their minus sign.
   */
  mass: MassProperties;
  /** Name of the crankshaft. */
  name: string;
  /** Weights given by number only. */
  point_weights: PointWeight[];
  /** Moment of inertia about the crank axis [kg m^2], without point weights. */
  polar_inertia: number;
  /** Its pieces along z. */
  sections: CrankshaftSection[];
  /** The same by throw, in the order of the file, and last what belongs to none. */
  throws: ThrowShare[];
  /** Unbalance of all pieces and point weights. */
  unbalance: CrankUnbalance;
};

/** One crankshaft in both models. */
export type CrankshaftMoments = {
  /** Its number, from 1. */
  crankshaft: number;
  /** As a free beam: what its loads do not hold in balance is carried by the end mains. */
  free_beam: BeamLoads;
  /** Every throw held by its own two mains. */
  throw_by_throw: BeamLoads;
};

/** A piece of the crankshaft: a journal, a pin, a web or a counterweight. */
export type CrankshaftSection = {
  /** Its moment `V` along the crank [kg m^2]. */
  couple: Point;
  /** Where it begins [m]. */
  from: number;
  /** What it is. */
  kind: SectionKind;
  /** Its mass [kg]: of a counterweight what it has beside journals, pins, webs and the counterweights before it. */
  mass: number;
  /** "journal 1", "pin 1", "web 1", or the name of the counterweight. */
  name: string;
  /** Moment of inertia about the crank axis [kg m^2]. */
  polar_inertia: number;
  /** Index of the throw that it belongs to; none for journals and weights beside the webs. */
  throw: number | null;
  /** Where it ends [m]. */
  to: number;
  /** Static unbalance `U` [kg m]. */
  unbalance: Point;
};

/** What is judged. */
export type Criterion = {
  peak: Load;
} | {
  order: [Load, number];
} | {
  "main-rms": Mains;
} | {
  "main-mean": Mains;
} | {
  "mains-with-gas": [Statistic, Mains];
} | "added-mass" | "added-unbalance" | "cost";

/** A speed at which an order meets a natural frequency. */
export type Critical = {
  /** Natural frequency there [rad/s]. */
  frequency: number;
  /** Torque of this order in the mode, in true phase: `|SUM T_k phi|` [N m]. */
  modal_torque: number;
  /** Number of the mode, from 1. */
  mode: number;
  /** The order. */
  order: number;
  /** Speed of the reference [rad/s]. */
  speed: number;
  /** Work of a cycle of vibration at 1 rad of the largest station: `pi` times the modal torque [J]. */
  work: number;
};

/** An angle over speed [rad]. */
export type Curve = {
  /** Amplitude of each order at each speed [rad]. */
  by_order: number[][];
  /** Sum of the amplitudes of all orders, whatever their phases [rad]. */
  sum: number[];
  /** Amplitude of all orders in true phase at each speed [rad]. */
  total: number[];
};

/** Whose curves over the crank angle are in the answer. */
export type Curves = "all" | "whole";

/** How a chamfer is made. */
export type Cut = {
  Turned: {
    /** Radius on the face [m]. */
    radius: number;
  };
} | {
  Milled: {
    /** Direction, from `x` towards `y`, in which it gets deeper [rad]. */
    direction: number;
    /** Distance of the line on the face from the crank axis, along that direction [m]. */
    distance: number;
  };
};

/** What a computed cycle gives in one chamber. */
export type CycleResult = {
  /** Numbers of the cylinders that have it, from 1. */
  cylinders: number[];
  /** Gas exchange, walls and the integration, where the gas is exchanged over the angle (single zone). */
  exchange: ExchangeResult | null;
  /** Work of the gas exchange [J], negative where it costs. */
  exchange_work: number;
  /** Work of compression and expansion [J]. */
  gross_work: number;
  /** Heat released [J]. */
  heat: number;
  /** Net indicated work over the energy of the fuel, what does not burn included (indicated efficiency, fuel conversion efficiency). */
  indicated_efficiency: number | null;
  /** Net indicated mean effective pressure [Pa]. */
  mean_effective_pressure: number;
  /** Largest pressure [Pa]. */
  peak_pressure: number;
  /** Its angle after firing top dead centre [rad]. */
  peak_pressure_angle: number;
  /** Highest temperature [K]. */
  peak_temperature: number;
  /** Its angle after firing top dead centre [rad]. */
  peak_temperature_angle: number;
  /** Which process: "Otto cycle", "single zone" and so on. */
  process: string;
  /** Net indicated work over the heat released (indicated thermal efficiency); `None` where it is motored. */
  thermal_efficiency: number | null;
  /** Over the angle. */
  trace: CycleTrace;
  /** Mass trapped [kg]. */
  trapped_mass: number;
  /** [`CYCLE_RESULT_VERSION`]. */
  version: number;
  /** Net indicated work of a cycle [J]. */
  work: number;
};

/**
 * A cycle over the angle since firing top dead centre, equally spaced from 0 to a cycle, end point excluded. Lists are empty where the cycle does not
 * know the quantity: an ideal one knows pressure and volume.
 */
export type CycleTrace = {
  /** Angle of the own crankshaft since firing top dead centre [rad]. */
  angle: number[];
  /** Mass out through the exhaust [kg/rad], negative: back. */
  exhaust: number[];
  /** Heat released [J/rad]. */
  heat_release: number[];
  /** Mass in through the intake [kg/rad], negative: back. */
  intake: number[];
  /** Mass [kg]. */
  mass: number[];
  /** Absolute pressure [Pa]. */
  pressure: number[];
  /** Temperature [K]. */
  temperature: number[];
  /** Volume of the chamber [m^3]. */
  volume: number[];
  /** Heat to the walls [J/rad]. */
  wall_heat: number[];
};

/** Piston, pins and rod of one cylinder. */
export type CylinderBearings = {
  /** Its number, from 1. */
  cylinder: number;
  /** Largest of its sizes over the continuous angle; `value` keeps the sign. */
  largest_thrust: Extreme;
  /**
   * Rod on its lower pin, `x + i y` of the block's frame [N]: the crankpin, with all that a master's articulated rods bring, or
   * the knuckle pin of an articulated rod. The big-end masses count.
   */
  lower_pin: PinLoad;
  /** Rod on the piston pin, `u + i v` of the cylinder frame [N]. */
  piston_pin: PinLoad;
  /** The same on the crankpin along the throw, positive away from the crank axis [N]; empty for an articulated rod. */
  radial: number[];
  /** The lower pin on the rod's bearing in the rod's frame, real part along the rod towards the piston [N]. */
  rod_frame: Array<[number, number]>;
  /** Side thrust: piston on the cylinder wall along `v` [N]. */
  side_thrust: number[];
  /** And across it, positive where it drives the crankshaft [N]: torque over crank radius. Empty for an articulated rod. */
  tangential: number[];
};

/** Loads of one cylinder. */
export type CylinderLoads = {
  /** Cylinder number, from 1. */
  cylinder: number;
  /** Its loads. */
  loads: LoadSet;
};

/** Motion of one cylinder, over the continuous angle. */
export type CylinderMotion = {
  /**
   * For an articulated rod: largest swing of the knuckle pin's line off the cylinder axis, and how its stroke and
   * dead centres depart from those of a plain rod of the master's kind.
   */
  articulation: Articulation | null;
  /** `theta` of its bottom dead centre [rad]. */
  bottom_dead_centre: number;
  /** The chamber that its piston shares with others: its firing angle is that of this chamber. */
  chamber?: ChamberMotion | null;
  /** Cylinder number, from 1. */
  cylinder: number;
  /**
   * Firing angle: its top dead centre, or that of the chamber that it shares, in the first working cycle of its own crankshaft
   * [rad of crankshaft 1], where the file gives a firing.
   */
  firing_angle: number | null;
  /** Largest piston acceleration away from the crankshaft [m/s^2] (at or near bottom dead centre). */
  max_acceleration: number;
  /** Largest piston acceleration towards the crankshaft [m/s^2], as a positive number (at or near top dead centre). */
  max_deceleration: number;
  /** Largest angle of the rod from the cylinder axis [rad]. */
  max_rod_angle: number;
  /** Largest piston speed [m/s] at the speed of the loads. */
  max_speed: number;
  /** Residual inertia `m_A a^2 + m_B b^2 - I` of its rod [kg m^2]; 0 for a two-mass rod. */
  residual_inertia: number;
  /** Stroke [m]. */
  stroke: number;
  /** Distance of the piston pin from the crankshaft's axis along the cylinder at top dead centre [m]. */
  top: number;
  /** `theta` of its top dead centre [rad], in [0, 2 pi / |ratio|). */
  top_dead_centre: number;
  /** Its motion over the period of the loads. */
  trace: MotionTrace;
};

/** Strokes of one cylinder. */
export type CylinderStrokes = {
  /** Cylinder number, from 1. */
  cylinder: number;
  /**
   * From dead centre to dead centre, rising, over one period; the first starts at or after `theta = 0`, the last may
   * end beyond the period.
   */
  strokes: StrokeSpan[];
};

/** One cylinder. */
export type CylinderTorque = {
  /** Clearance volume [m^3], of the compression ratio of the engine's gas; `None` where the file gives none. */
  clearance: number | null;
  /** Absolute pressure under the piston over the period [Pa]. */
  crankcase: number[];
  /** Its number, from 1. */
  cylinder: number;
  /** Crank angle at which it fires [rad]: its top dead centre. */
  firing_angle: number;
  /** Gas torque over the period [N m]. */
  gas: number[];
  /** Inertia torque over the period [N m]. */
  inertia: number[];
  /** Highest cylinder pressure [Pa] and the angle after firing [rad] at which it stands, from -half to half a working cycle. */
  peak_pressure: Extreme;
  /** Absolute pressure in the cylinder over the period [Pa]. */
  pressure: number[];
  /**
   * Volume that the piston has left free below its top dead centre [m^3]: with `pressure` the p-V diagram, without the
   * clearance volume.
   */
  volume: number[];
  /** Work in one working cycle. */
  work: IndicatedWork;
};

/** One damped mode: the motion `Re( shape e^{root t} )`. */
export type DampedMode = {
  /** Damping ratio `-Re(root) / |root|`; 1 where it does not oscillate. */
  damping_ratio: number;
  /** Root [1/s]: real part the rate of growth (negative), imaginary part the angular frequency [rad/s]. */
  root: [number, number];
  /** Shape at the centre; its largest component in the mass norm is real. */
  shape: [[number, number], [number, number], [number, number], [number, number], [number, number], [number, number]];
};

/** A damper over speed. */
export type DamperAnswer = {
  /** Heat [W] at each speed. */
  power: number[];
  /** Amplitude of the ring against the hub [rad]. */
  ring: number[];
  /** The damper that these numbers are of. */
  used: TorsionDamper;
};

/** A kind of damper. */
export type DamperKind = "viscous" | "rubber";

/** Direction in which the depth of an overlap is measured. */
export type DepthAlong = "cylinder" | "crank" | "radius";

/** A complete counterweight, beyond the disc of its web; on an engine's web beyond the web as it is. */
export type Design = {
  /** Unbalance over full balance. */
  balance: number;
  /** Distance of its centre of mass from the crank axis [m]. */
  centre: number;
  /** Half of its largest width [m]. */
  half_width: number;
  /** Polar inertia about the crank axis, without the web [kg m^2]. */
  inertia: number;
  /** Its mass, without the web [kg]. */
  mass: number;
  /** Its shape. */
  shape: CounterweightShape;
  /** What each shoulder stands out, `l_c` [m]. */
  shoulder: number;
  /** Angle of the flank against the chord, `delta` [rad]. */
  shoulder_angle: number;
  /** Farthest point of web and counterweight from the crank axis [m]. */
  swept_radius: number;
  /** Its thickness [m]. */
  thickness: number;
  /** Its unbalance [kg m]. */
  unbalance: number;
};

/** A limit of a task. */
export type DesignLimit = "mass" | "swept-radius" | "inertia" | "thickness" | "half-width" | "balance";

/** Limits on what follows from the dimensions. `None`: no limit. */
export type DesignLimits = {
  /** Largest half width of the counterweight, across its axis [m]. */
  half_width: number | null;
  /** Largest polar inertia of the counterweight about the crank axis [kg m^2]. */
  inertia: number | null;
  /** Largest mass [kg]. */
  mass: number | null;
  /** Least and largest shoulder angle `delta` [rad]. */
  shoulder_angle: Range | null;
  /** Least and largest trapezoid height `H` [m]. */
  shoulder_height: Range | null;
  /** Largest swept radius of web and counterweight [m]. */
  swept_radius: number | null;
};

/** How the search ended. */
export type DesignOutcome = {
  found: Optimum;
} | {
  infeasible: Infeasible;
};

/** Which weights get the best shape. */
export type DesignQuestion = {
  /** What is made small; as the file says where it is left out. */
  minimise: Aim | null;
  /** The engine file. */
  text: string;
  /** Names of the weights; none: all on webs. */
  weights: string[];
};

/**
 * How far the proof of a best shape goes: branch and bound over boxes of shapes.
 *
 * A wider gap ends it earlier, more boxes let a search that stopped go on.
 */
export type DesignSettings = {
  /** No shape is better than the one found by more than this share of what is made small: 1e-6 to 0.5. */
  gap: number;
  /** Most boxes examined for one optimum, 1 or more; where they do not do, the result says that it is not proved. */
  max_boxes: number;
};

/** The best shapes. */
export type Designed = {
  /** As `lanchester counterweight design --format json` prints it. */
  designs: CounterweightDesigns;
  /** The engine file with the shapes; none where there is none. */
  text: string | null;
};

/** A weight and the shape that was found for it. */
export type DesignedCounterweight = {
  /** The unbalance that is full balance [kg m]. */
  duty: number;
  /** With a room: how far the shape may reach in each direction, by everything that moves past its web over the cycle. */
  envelope?: RadialEnvelope | null;
  /** What the evolutionary search found, if it was asked for. */
  evolution?: Evolution | null;
  /** Its index in [`Engine::counterweights`]. */
  index: number;
  /** Its name. */
  name: string;
  /**
   * What was found: mass, unbalance and inertia are what the counterweight adds to the crankshaft beyond the web as it is. The proof is about
   * all shapes that share as much with the flank of the web.
   */
  outcome: DesignOutcome;
  /** Mass of the part as it is exported, the disc of its web included [kg]; none where no shape was found. */
  part_mass?: number | null;
  /**
   * The swept radius that keeps the wanted clearance whatever the shape; none where the best shape of all keeps the clearance, or there is
   * nothing to stay clear of.
   */
  room?: SweptRoom | null;
  /**
   * What of its outline beyond the web's disc lies within the web as it is and counts as the web's: a design's mass, unbalance and inertia
   * are without it.
   */
  shared: SharedWithWeb;
  /** With a room: what is made small, of the best shape without it [SI]. No shape that keeps the clearance has less. */
  without_room?: number | null;
};

/** A deviation that is drawn. */
export type Deviation = {
  /** Index of the part; `None` for all parts together. */
  part: number | null;
  /** Place of its tolerance in the list, from 0. */
  tolerance: number;
};

/** A weight. */
export type DeviceSummary = {
  /** Direction at theta = 0 [rad]: of a counterweight in the frame of its crankshaft, of a shaft's weight in the engine's. */
  angle: number;
  /** Its direction as the file counts it [rad]: from its throw, or from the zero of its crankshaft or shaft. */
  direction: number;
  /** The throw from which the file counts its direction, from 1. */
  from_throw: number | null;
  /** Whether it is a part with a shape. */
  has_part: boolean;
  name: string;
  /** Its entry in the file: `counterweight[0]`; none where the short form makes it. */
  path: string | null;
  /** Unbalance [kg m]. */
  unbalance: number;
  /** Plane [m]. */
  z: number;
};

/** What is left to do about the loads, read off the two-sided spectrum. */
export type Diagnosis = {
  /** One finding a load that matters, in the order of the summary: both senses of a force or couple together, roll moments last. */
  findings: Finding[];
  /** The roll moment in a line of its own; empty where none matters. */
  roll: string;
  /** The forces and couples in one or two sentences. */
  summary: string;
};

/** Something about the file that its author should know. */
export type Diagnostic = {
  /** Stable code such as `E0103`; the book lists them. */
  code: string;
  /** Column of the place in characters, from 1. */
  column: number;
  /** What to do. */
  hint: string | null;
  /** What stands at the place, a few words; may be empty. */
  label: string;
  /** Line of the place, from 1. */
  line: number;
  /** What was needed and what was got. */
  message: string;
  /** Other places that matter. */
  related: Related[];
  /** Error or warning. */
  severity: Severity;
  /** Place in the text, in bytes. */
  span: Range_of_uint;
};

/** Least and largest value of each dimension, of the file's `[counterweight_design]`. */
export type DimensionRanges = {
  arc_angle: [number, number];
  arc_radius: [number, number];
  rectangle_height: [number, number];
  /** Where the file gives the height, not the angle, of the shoulder. */
  shoulder_height: [number, number] | null;
  thickness: [number, number];
  web_radius: [number, number];
};

/** Dimensions of a shape of the family [m], [rad]. */
export type Dimensions = {
  /** Included angle of the arc [rad]. */
  arc_angle: number;
  /** Radius of the arc [m]. */
  arc_radius: number;
  /** Height of the rectangle, from the crank axis [m]. */
  rectangle_height: number;
  /** Height of the trapezoid [m]. */
  shoulder_height: number;
  /** Thickness along the crank [m]. */
  thickness: number;
  /** Radius of the web's disc, and half width of the rectangle [m]. */
  web_radius: number;
};

/** How a quantity is distributed within its tolerance; its mean is the nominal value. */
export type Distribution = {
  normal: {
    /** Half width of the tolerance over the standard deviation; 3 where nothing else is known. */
    sigmas: number;
  };
} | "uniform";

/** Holes of which a free weight is one: it is what the hole removes, opposite to it, or what a slug in it adds. */
export type DrillCatalogue = {
  /** Density of what is drilled [kg/m^3]. */
  density: number;
  /** Depths to the end of the full diameter are multiples of this [m]. */
  depth_step: number;
  /** Diameters of the drills [m], rising. */
  diameters: number[];
  /** Along which line holes are drilled. */
  direction: DrillDirection;
  /** Depth from the surface that the tip of the drill may reach [m]. */
  max_depth: number;
  /** Angle of the drill point [rad]; pi is a flat bottom. */
  point: number;
  /** Radius of the drilled surface (radial), or of the circle of holes (axial) [m]. */
  radius: number;
  /** Density of the slugs that fill the holes [kg/m^3]; none: the holes stay empty. */
  slug_density: number | null;
  /** Shape of the surface where a radial hole begins; an axial hole begins on a flat face. */
  surface: DrilledSurface;
};

/** Along which line a hole is drilled. */
export type DrillDirection = "radial" | "axial";

/** Surface where a radial hole begins. */
export type DrilledSurface = "round" | "flat";

export type Drive = "gears" | "chain";

/** Two gears that mesh, or two sprockets that a chain or belt joins. */
export type DriveLink = {
  /** Whether a chain or belt joins them. */
  chain: boolean;
  /** Index of the driven gear. */
  driven: number;
  /** Index of the driving gear. */
  driver: number;
};

/** Gears (and chains or belts) between crank and shafts. */
export type DriveTrain = {
  /** Every gear, idlers too. */
  gears: Gear[];
  /** Every mesh, chain or belt. */
  links: DriveLink[];
  /** Gear planes beyond the end of the crank. */
  planes: number;
};

/** A number of which more is better: the smallest over the cycle, the parts and the speeds that count. */
export type DurabilityCriterion = "least-film" | {
  "main-film": number | null;
} | {
  "crankpin-film": number | null;
} | {
  "rule-safety": number | null;
} | "fillet-safety";

/** Films and safeties that balancing is to care for. */
export type DurabilityWish = {
  /** What must hold. */
  at_least: AtLeast[];
  /** What is to be large, in order of priority. */
  maximise: DurabilityCriterion[];
};

/**
 * A line or an arc.
 *
 * The bulge is that of DXF: the tangent of a quarter of the included angle, positive where the arc runs anticlockwise from
 * `from` to `to`, zero for a line, one for a half circle.
 *
 * ```text
 * bulge = tan(angle/4)    radius = w (1 + bulge^2)/(2 |bulge|)    height over the chord = w |bulge|    w = half the chord
 * ```
 */
export type Edge = {
  /** Tangent of a quarter of the included angle. */
  bulge: number;
  /** Where it begins [m]. */
  from: Point;
  /** Where it ends [m]. */
  to: Point;
};

/** A change of one key. */
export type Edit = {
  /**
   * Keys and indices down to the value: `crank.stroke`, `counterweight[0].unbalance`. The index behind the last entry of a
   * list adds one; tables on the way that are not there come to be.
   */
  path: string;
  /**
   * The new value; `null` takes the key, the table or the entry of a list out. The keys of an object are set one by one,
   * those that it does not name stay.
   */
  value: unknown;
};

/** A text, and what is to be changed in it first. */
export type EditedText = {
  /** Keys that change, one after the other. */
  edits: Edit[];
  /** The engine file. */
  text: string;
};

/** A criterion before and after. */
export type Effect = {
  /** With the answer [SI unit]. */
  after: number;
  /** As the engine file stands [SI unit]. */
  before: number;
  /** Which. */
  criterion: Criterion;
  /** Without the free weights (those that they replace left out) [SI unit]. */
  without: number;
};

export type Encloses = "counterweight" | "web";

/** A work, or a change of what is stored. */
export type EnergyPart = {
  /** [J]. */
  energy: number;
  name: string;
};

/** Accumulated energy of a torque over its period. */
export type EnergyVariation = {
  /** Integral of `|T - T_mean|` over the own period [J], eq. (25.3), as the twin thesis counts it. */
  absolute: number;
  /** Largest excess energy [J], eq. (25.2). */
  excess: number;
  /** Crank angle [rad] at which the accumulated energy is highest: there the crank turns fastest. */
  highest: number;
  /** Crank angle [rad] at which it is lowest. */
  lowest: number;
  /** Mean torque [N m]. */
  mean: number;
  /** Own period of the torque [rad]: the shortest after which it repeats. */
  own_period: number;
};

/** The graph of an engine as a graph file. */
export type EngineGraphAnswer = {
  /** What was assumed. */
  notes: string[];
  /** The graph file. */
  text: string;
};

/** An engine whose graph is wanted. */
export type EngineGraphQuestion = {
  /** How the block moves; default: in space on its mounts where the file gives them with viscous damping. */
  block: BlockOf | null;
  /** Whether the joints are springs and dampers instead of ideal. */
  compliant: boolean;
  /** Whether the gas is states with valves and heat release; otherwise as the file says. */
  gas_states: boolean;
  /** Whether the speed is imposed; otherwise as the file says. */
  imposed: boolean;
  /** The engine file. */
  text: string;
  /** Whether the balance shafts are left out. */
  without_shafts: boolean;
};

/** What an engine is built for, as far as its proportions tell. */
export type EngineKind = "motorcycle-petrol" | "car-petrol" | "car-diesel" | "truck-diesel" | "stationary-diesel" | "aircraft-petrol";

/** The engine in short. */
export type EngineSummary = {
  counterweights: DeviceSummary[];
  cylinders: number;
  /** Swept volume [m^3]; 0 where a bore is not known. */
  displacement: number;
  has_balance: boolean;
  has_bearings: boolean;
  has_crank_body: boolean;
  has_envelope: boolean;
  has_gas: boolean;
  has_mounts: boolean;
  has_shape_task: boolean;
  /** Highest speed [rad/s]. */
  highest_speed: number;
  /** The word of the file's layout; empty for an engine in its general form. */
  layout: string;
  /** Lowest speed [rad/s]. */
  lowest_speed: number;
  name: string;
  /** Angle of crankshaft 1 after which the firing repeats [rad]. */
  period: number;
  /** Where a run in time starts. */
  run_start: RunStarts;
  shafts: ShaftSummary[];
  strokes: number;
};

/** A text. */
export type EngineText = {
  /** The engine file. */
  text: string;
};

/** In what engines are made equal before they are compared. */
export type Equal = "as-they-are" | "displacement" | "power";

export type EqualIn = "displacement" | "power";

/** One equation. */
export type EquationLine = {
  mathml: string;
  /** Whose law it is. */
  of: string;
  unit: string;
};

/** Equations under one title. */
export type EquationList = {
  /** Each as MathML, with its unit. */
  lines: EquationLine[];
  title: string;
};

/** What an evolutionary search came to. */
export type Evolution = {
  /** The best design that it met within all limits; none if it met none, which does not show that there is none. */
  best: Evolved | null;
  /** Designs that it looked at. */
  evaluations: number;
  /** How many of them met all limits. */
  feasible: number;
  /** What was made small. */
  objective: Objective;
  /** Whether it is proved that no design is better: never, since such a search knows no bound. */
  proved: boolean;
  /** Seed of its random numbers: the same seed gives the same design. */
  seed: number;
  /** [`DESIGN_VERSION`]. */
  version: number;
};

/** The best design of an evolutionary search. */
export type Evolved = {
  /** The design. */
  design: Design;
  /** After how many designs it was found. */
  found_after: number;
  /** Its value of the objective [SI]. */
  value: number;
};

/** Gas exchange, heat to the walls and the check of the integration. */
export type ExchangeResult = {
  /** Temperature of the body that takes it [K]; `None` where the walls have temperatures that are given. */
  body_temperature: number | null;
  /** Angle at which it closes [rad], negative: before firing. */
  closing_angle: number;
  /** Whether the last cycle repeats the one before it. */
  converged: boolean;
  /** Cycles run. */
  cycles: number;
  /** Energy that is missing from the balance of the last cycle [J]. */
  energy_residual: number;
  /** The same over the largest of what passes. */
  energy_residual_share: number;
  /** Fresh mass trapped [kg]. */
  fresh_mass: number;
  /** Mass that is missing from the balance of the last cycle [kg]. */
  mass_residual: number;
  /** The same over the trapped mass. */
  mass_residual_share: number;
  /** Share of the trapped mass that is residual gas. */
  residual_share: number;
  /** Temperature when the cylinder closes [K]. */
  trapped_temperature: number;
  /** Fresh mass trapped over fresh mass taken in. */
  trapping_efficiency: number;
  /** Fresh mass taken in over that of the displaced volume at the state before the intake; for two strokes the delivery ratio. */
  volumetric_efficiency: number;
  /** Heat to the walls in a cycle [J]. */
  wall_heat: number;
  /** The same over the heat released; `None` where it is motored. */
  wall_heat_share: number | null;
};

/** What is exported. */
export type ExportQuestion = {
  /** The kind of file. */
  format: Format;
  /** The engine file. */
  text: string;
  /** Name of one counterweight; without it the first crankshaft with the balance shafts around it. */
  weight: string | null;
};

/** For which parts a deviation is one. */
export type Extent = "per-part" | "common";

/**
 * A number computed on three meshes, extrapolated to elements of size zero.
 *
 * ```text
 * f(h) = f* + C h^p      (f1 - f2)/(f2 - f3) = (h1^p - h2^p)/(h2^p - h3^p)      f* = f3 + (f3 - f2)/((h2/h3)^p - 1)
 * band = 1.25 |f* - f3|                                                                                     (book, eq. 43.15)
 * ```
 * Where no such order from 0.5 to 6 exists, because the numbers go to and fro or do not come closer, the value is that of the finest mesh
 * and the band three times the largest difference.
 */
export type Extrapolated = {
  /** Half width of the band about it. */
  band: number;
  /** Order that the three show; none where they show none. */
  order: number | null;
  /** What they tend to. */
  value: number;
  /** Value on the coarse, the middle and the fine mesh. */
  values: [number, number, number];
};

/** An extreme and where it is. */
export type Extreme = {
  /** Crank angle [rad] of the first place that attains it, in one period. */
  theta: number;
  /** Value [N] or [N m]. */
  value: number;
};

/** Largest and smallest value of one quantity over the period. */
export type Extremes = {
  /** Largest value. */
  max: Extreme;
  /** Smallest value. */
  min: Extreme;
};

/** Which face of a part. */
export type Face = "Front" | "Rear";

/** A figure of the report. */
export type FigureSvg = {
  caption: string;
  /** Name for files. */
  id: string;
  /** A file of its own. */
  svg: string;
  title: string;
};

/** A value of the file and where it stands. */
export type FileEntry = {
  /** Keys and indices down to it: `crank.stroke`, `cylinder[1].piston.mass`. */
  path: string;
  /** Its place in the text, in bytes. */
  span: Range_of_uint;
  /** The value as it is written, units and all. */
  value: unknown;
};

/** An engine file as it stands in the folder. */
export type FileState = {
  /** Its name in the folder. */
  name: string;
  /** Tells one text from another. */
  revision: string;
  /** Its text. */
  text: string;
};

/** A fillet over the cycle. */
export type FilletAnswer = {
  /** Largest von Mises stress at each crank angle [Pa]; empty of a sharp corner, whose stress is no number. */
  curve: number[];
  name: string;
  /** Radius [m]; 0 of a sharp corner. */
  radius: number;
  /** The largest, solved directly. */
  stress: PeakStress | null;
  /** Crank angle of the largest [rad]. */
  theta: number | null;
};

/** Work and energy of a shaft over the last period [J]. */
export type FilmEnergy = {
  /** Change of kinetic energy. */
  change: number;
  /** Taken by contact of the roughness, which is elastic. */
  contact: number;
  /** Lost in the films by the flow that their pressure drives. */
  films: number;
  /** Work of the loads on the shaft. */
  loads: number;
  /** What is missing: loads + turning - films - contact - change. */
  missing: number;
  /** Work that turning journals and shells do on the films' pressure. */
  turning: number;
  /** Sum of the sizes of all powers over time, by which `missing` is judged. */
  turnover: number;
};

/** The orbit over one period, and what the film does on it. */
export type FilmOrbit = {
  /** Largest change from the last period but one, over the clearance. */
  change: number;
  /** Largest share of the load that contact takes. */
  contact_share: number;
  /** Share of the period with contact of the roughness. */
  contact_time: number;
  /** Journal centre at every instant of the load [m]. */
  eccentricity: Array<[number, number]>;
  /** Oil that grooves and holes give, mean [m3/s]; 0 where the film has none. */
  feed_flow: number;
  /** Friction power, mean over the period [W]: torques and motion of the journal, contact left out. */
  friction_power: number;
  /** The same with shear only where there is pressure [W]: the bound from below, of a shell that is empty elsewhere. */
  friction_power_of_pressure_part: number;
  /** Largest film pressure [Pa] and its instant over the period. */
  largest_pressure: number;
  /** Instant of the largest pressure, over the period. */
  largest_pressure_at: number;
  /** Least film at an end of the bearing [m], where the journal's axis is tilted; below 0 where that end would touch. `None`: parallel axes. */
  least_edge_film?: number | null;
  /** Least film [m]. */
  least_film: number;
  /** Direction of the least film [rad]. */
  least_film_angle: number;
  /** Instant of the least film, over the period. */
  least_film_at: number;
  /** How it ended. */
  outcome: OrbitOutcome;
  /** Periods integrated. */
  periods: number;
  /** Oil that leaves at the ends, mean [m3/s]. */
  side_flow: number;
  /** Steps of the integrator. */
  steps: number;
  /** Largest difference of the table's force from that of the film solved directly, over the load; 0 where every film of the orbit is solved directly. */
  table_error: number;
};

/** An engine at a speed, and which models of cavitation its films have. */
export type FilmsQuestion = {
  /** Whether bearings with grooves have films with them, solved at every instant: some seconds each. Tables without grooves where it is left out. */
  grooves: boolean;
  /** Models of cavitation side by side; that of the file, else Guembel's, where it is left out. */
  models: Cavitation[];
  /** Speed of crankshaft 1 [rad/s]; the highest of the engine where it is left out. */
  speed: number | null;
  /** The engine file. */
  text: string;
};

/** One load of the spectrum, with its remedy. */
export type Finding = {
  /** Amplitude [N] or [N m]. */
  amplitude: number;
  /** Order. */
  order: number;
  /** Force, couple or roll moment. */
  quantity: Quantity;
  /** What can remove it. */
  remedy: Remedy;
  /** Sense. */
  sense: Sense;
  /** The finding as a sentence with numbers and units. */
  text: string;
};

/** One firing. */
export type Firing = {
  /** Cylinder number, from 1. */
  cylinder: number;
  /** Angle [rad] to the next firing; 0 where the next cylinder fires together with this one. */
  interval: number;
  /** Crank angle [rad] in the period. */
  theta: number;
  /** Direction in which its crankpin stands on its crankshaft [rad], from throw 1. */
  throw_angle: number;
};

/** Firing of an engine over one period. */
export type FiringChart = {
  /** Strokes of every cylinder over the period. */
  cylinders: CylinderStrokes[];
  /** Interval of even firing [rad]: period over number of firings. */
  even_interval: number;
  /**
   * Firings in their sequence, from the first at or after `theta = 0`; cylinders that fire together stand by number. A chamber that pistons
   * share fires once, under the number of its first cylinder.
   */
  firings: Firing[];
  /** Period [rad] of crankshaft 1: a whole number of working cycles of every crankshaft. */
  period: number;
  /**
   * Size of the sum of unit vectors `e^{i n theta_f}` over all firings, over their number, for the orders `n` = 1/2, 1, 3/2 ..
   * (two-stroke: 1, 2, ..): 1 where all cylinders add up (major orders), 0 where they cancel.
   */
  stars: FiringStar[];
  /** Strokes in a working cycle. */
  strokes: Strokes;
  /**
   * Largest departure of an interval from the even one, over the even one: 0 is even, 1 is two cylinders firing
   * together or an interval of twice the even length.
   */
  unevenness: number;
};

/** How far equal cylinders add up in one order. */
export type FiringStar = {
  /** Order. */
  order: number;
  /** From 0 to 1. */
  share: number;
};

/** A flywheel for a wanted fluctuation. */
export type FlywheelNeed = {
  /** Inertia of everything by the formula `J = dE / (C_s w^2)` [kg m^2], book, eq. 25.4. */
  by_formula: number;
  /** Whether the inertia of the crankshafts is known; if not, `train` leaves it out and the flywheels include it. */
  crankshaft_known: boolean;
  /** Wanted fluctuation `C_s = (w_max - w_min) / w_mean` [1]. */
  fluctuation: number;
  /**
   * Flywheel with which the true speed, of variable inertia, just keeps the fluctuation [kg m^2]; 0 where none is needed,
   * `None` where none up to half a million times the formula's keeps it.
   */
  flywheel: number | null;
  /** Flywheel by the formula [kg m^2]: what is left, not below zero. */
  flywheel_by_formula: number;
  /** Mean speed at which it is kept [rad/s]. */
  speed: number;
  /** Mean inertia that the train has without its flywheel [kg m^2]. */
  train: number;
};

export type Format = "step" | "stl" | "glb" | "dxf" | "svg";

/** How a file stands on the disk, other than whoever saves it believes. */
export type Found = "changed" | "removed" | "exists";

/** A free inertia of the answer. */
export type FoundInertia = {
  /** Its inertia [kg m^2]; 0 if it is not used. */
  inertia: number;
  /** Its name in the task. */
  name: string;
  /** The share of the crank train's roll moment that is left with it. */
  roll_share: number;
};

/** Layouts of a space that no other one beats in all objectives. */
export type FoundLayouts = {
  /** Layouts of the front that are better than the engine in some objective, and in none worse. */
  beaten_by: number[];
  /** Why nothing is on the front. */
  empty: string | null;
  /** Layout of the front with the objectives of the engine. */
  equals: number | null;
  /** The front by its first objective, up to 2000 of them. */
  front: LayoutRow[];
  /** What the layouts are judged by. */
  objectives: LayoutObjective[];
  /** Layouts on the front. */
  on_front: number;
  /** Objectives of the engine of the file; `null` where it does not tell. */
  own: Array<number | null>;
  /** Objectives of some of the judged layouts, evenly from all of them, in SI units. */
  sample: number[][];
  /** Space, what became of its cases, and notes, in words. */
  words: string;
};

/** A limit of the answer. */
export type FoundLimit = {
  /** Its criterion, if it is one. */
  criterion: Criterion | null;
  /** The limit, in SI units. */
  most: number;
  /**
   * Shadow price: how much the first stage that this limit holds up would fall if the limit were relaxed by one SI unit: a
   * largest value made larger, a least one smaller, e.g. N per kg m; 0 for a limit that is not active. Of a given amount it is
   * that of a smaller one, negative where a larger one helps. Of a choice that was searched for it is the price with that
   * choice kept: devices used, places, directions of given and least amounts.
   */
  price: number;
  /** Unit of the price, such as `N per kg m`; `1 per N m` for a weighted sum; empty for a limit that is not active. */
  price_unit: string;
  /** On which side of its value it lies. */
  side: LimitSide;
  /** The stage that the price belongs to, by index. */
  stage: number | null;
  /** SI unit of the limit and of what was reached. */
  unit: string;
  /** What was reached. */
  value: number;
  /** What is limited: a criterion, the largest, least or given amount of a weight, the largest inertia. */
  what: string;
};

/** A free shaft of the answer. */
export type FoundShaft = {
  /** Its name in the task. */
  name: string;
  /** Whether it is used. */
  used: boolean;
  /** Position of its axis [m]. */
  x: number;
  /** Position of its axis [m]. */
  y: number;
};

/** What a stage reached, and the proof that nothing better exists. */
export type FoundStage = {
  /** The parts of the cycle that hold the optimum up; none where the stage vanishes. */
  active: Active[];
  /** `value - lower_bound`, without what later stages took of what this one gives up. */
  gap: number;
  /** What it gives up for later stages, if anything. */
  give_up?: StageGiveUp | null;
  /** No choice of these devices that holds the limits goes below this. */
  lower_bound: number;
  /** Weight of each term: 1 for a criterion that is minimised alone. */
  term_weights: number[];
  /** Each term's criterion and true value. */
  terms: Array<[Criterion, number]>;
  /** SI unit of the value: that of the criterion, or `1` for a weighted sum, whose terms are shares of given values. */
  unit: string;
  /** The sum of weight times criterion, its true value over the continuous cycle. */
  value: number;
  /** The value of this stage if no earlier one gave up anything, where one does: the difference is what that gains. */
  without_give_up?: number | null;
};

/** A free weight of the answer. */
export type FoundWeight = {
  /** The hole that it is, where the task gives drills: opposite to its direction if it stays empty. */
  hole?: CatalogueHole | null;
  /** Its mass [kg], where the task gives its radius. */
  mass: number | null;
  /** Its name in the task. */
  name: string;
  /** Its unbalance [kg m]: modulus = amount, argument = direction at `theta = 0` in the engine's frame. */
  unbalance: [number, number];
  /** Whether it is used. */
  used: boolean;
  /** Its plane [m]. */
  z: number;
};

/** Which weights are free. */
export type Free = "devices" | "balance" | "file" | "throws" | "webs" | "none";

/**
 * An inertia geared to turn against crankshaft 1 (Heron flywheel, geared alternator): with the crank train free to
 * follow its torque it takes part of the roll moment.
 */
export type FreeInertia = {
  /** Inertia of everything that turns with crankshaft 1 [kg m^2], flywheel included. */
  crank_inertia: number;
  /** Largest inertia [kg m^2]. */
  most: number | null;
  /** Name for tables. */
  name: string;
  /** Whether it may be left out. */
  optional: boolean;
  /** Its speed over that of crankshaft 1, as a positive number: it turns the other way. */
  ratio: number;
};

/** A balance shaft that may be fitted. */
export type FreeShaft = {
  /** Name for tables and for the engine file. */
  name: string;
  /** Whether it may be left out. */
  optional: boolean;
  /** Speed over that of crankshaft 1, signed. */
  ratio: Ratio;
  /** Position of its axis [m]. */
  x: Place;
  /** Position of its axis [m]. */
  y: Place;
};

/** An unbalance that is to be found: `U = amount e^{i phase}` at `theta = 0`, in the engine's frame. */
export type FreeWeight = {
  /** Amounts that can be made, within `least` and `most`; none: every amount. */
  catalogue: Catalogue | null;
  /** What it costs if it is used. */
  cost: Cost;
  /** The holes whose unbalances are its catalogue, if it is one of them. */
  drill?: DrillCatalogue | null;
  /** Name of the parts that it is one of: used weights with the same name have the same amount of their catalogue. */
  equal_parts: string | null;
  /** Whether its largest amount is what fits on its web, by shapes and clearance. */
  fits?: boolean;
  /** Least amount [kg m], 0 or more. An optional weight is either left out or has at least this. */
  least: number;
  /** Largest amount [kg m]; equal to `least` for a given amount. */
  most: number | null;
  /** Name for tables and for the engine file. */
  name: string;
  /** Whether it may be left out. */
  optional: boolean;
  /** Direction at `theta = 0` in the engine's frame (crankshaft phase included). */
  phase: Phase;
  /** Distance of its centre of gravity from the axis it turns about [m]: its mass is amount over radius. */
  radius: number | null;
  /** What it sits on. */
  seat: Seat;
  /** Plane [m], from the origin. */
  z: Place;
};

/** The front between two objectives, from the least of the first to the least of the second. */
export type Front = {
  /** Boxes of all searches. */
  boxes: number;
  /** The designs; empty where no shape meets all limits. */
  designs: Design[];
  /** The two objectives. */
  objectives: [Objective, Objective];
  /**
   * Whether for every design it is proved that the first objective cannot be less by more than
   * the gap of the settings, where the second is no larger.
   */
  proved: boolean;
  /** [`DESIGN_VERSION`]. */
  version: number;
};

/** The trade between two aims. */
export type FrontQuestion = {
  /** What it is traded for. */
  against: Aim;
  /** How many designs, 2 to 200. */
  count: number;
  /** What is made small; as the file says where it is left out. */
  minimise: Aim | null;
  /** The engine file. */
  text: string;
  /** Name of the weight; without one all, if they have one duty. */
  weight: string | null;
};

/**
 * A linear functional of the orders, `SUM over terms of Re( conj(factor) * -amount )`: what it says of every choice of
 * the devices.
 *
 * With `a_k(U)` what the devices add to the orders, the orders vanish where `a_k(U) = -amount_k`. Let `y` be the
 * factors. A weight of amount 1 changes `SUM Re( conj(y_k) a_k )` by no more than its pull `|(A^H y)_i|`. So
 *
 * ```text
 * SUM of cost_i |U_i|  >=  Re( y^H b ) - SUM of charges      if no pull passes the weight's cost by more than its charge pays for
 * ```
 * With costs of 1 (of 1 / radius for masses) this bounds the total; with costs of 0 a value above 0 proves that no `U`
 * makes the orders vanish.
 */
export type Functional = {
  /**
   * What weights with a largest amount, and inertias, can do against it at most: name and amount, in the unit of the
   * value.
   */
  charges: Array<[string, number]>;
  /**
   * Largest pull of a weight without a largest amount: over its cost (at most 1) where the total is bounded; over the
   * most that factors of the same size could pull (0 to rounding) for an obstruction.
   */
  largest_pull: number;
  /** Its terms. */
  terms: FunctionalTerm[];
  /** Sum of the terms less the charges [kg m or kg; 1 for an obstruction]. */
  value: number;
};

/** One part of one order in a functional. */
export type FunctionalTerm = {
  /** The part without the free devices [N or N m]. */
  amount: [number, number];
  /** One order of a load. */
  criterion: Criterion;
  /** `y`: value of the functional per N or N m. */
  factor: [number, number];
  /** Which part of it. */
  sense: OrderSense;
};

/** A gear or sprocket. */
export type Gear = {
  /** Pitch diameter [m]. */
  pitch_diameter: number;
  /** Gear plane, from 1 at the end of the crank outwards. */
  plane: number;
  /** Speed over that of crankshaft 1, signed. */
  ratio: number;
  /** What it sits on. */
  seat: GearSeat;
  /** Position of its axis [m]. */
  x: number;
  /** Position of its axis [m]. */
  y: number;
};

/** What a gear sits on. */
export type GearSeat = "crank" | {
  shaft: number;
} | "idler";

/** How far later stages may raise a stage above its least value. */
export type GiveUp = "nothing" | {
  share: number;
} | {
  amount: number;
};

/** A graph, looked at. */
export type GraphAnswer = {
  bonds: GraphBond[];
  /** The causality, step by step, in words. */
  causality: string;
  /** Whether it reached its end. */
  complete: boolean;
  elements: GraphElement[];
  /** How the run ended. */
  ended: string;
  /** Equations by what they belong to. */
  equations: EquationList[];
  name: string;
  /** Why there are no poles. */
  not_linear: string | null;
  /** Poles of a linear graph. */
  poles: GraphPole[];
  /** Size of the drawing [px]. */
  size: [number, number];
  /** Tiles of an engine's graph; none of any other. */
  tiles: GraphTile[];
  /** Samples of a run [s]. */
  time: number[];
  /** From each source to what stores give, of a linear graph. */
  transfer: GraphTransfer[];
};

/** A bond in its place, with what it carries. */
export type GraphBond = {
  /** End of the barb at its head [px]. */
  barb: [number, number];
  /** At the samples. */
  effort: number[];
  /** At the samples. */
  flow: number[];
  follows: boolean;
  free: boolean;
  /** Where it leads, if that is in another tile. */
  leads_to: GraphEnd | null;
  /** Its ends along the half arrow [px]. */
  line: [[number, number], [number, number]];
  name: string;
  /** At the samples [W]. */
  power: number[];
  /** Ends of the causal stroke [px]. */
  stroke: [[number, number], [number, number]];
  /** Units of effort and flow. */
  units: [string, string];
};

/** An element in its place. */
export type GraphElement = {
  /** Its middle [px]. */
  at: [number, number];
  /** Whether it is a store that follows others. */
  follows: boolean;
  kind: string;
  /** Middle and base line of the letters of its kind [px]. */
  kind_at: [number, number];
  /** Its name, and its value where a number or a short expression says its law. */
  labels: GraphLabel[];
  name: string;
};

/** What a bond to another tile leads to. */
export type GraphEnd = {
  /** Where its name stands [px]. */
  at: [number, number];
  name: string;
};

/** A graph file. */
export type GraphExample = {
  name: string;
  text: string;
};

/** Words beside an element. */
export type GraphLabel = {
  anchor: LabelAnchor;
  /** Their base line, at the side that `anchor` names [px]. */
  at: [number, number];
  /** Whether they are the value; else the name. */
  is_value: boolean;
  text: string;
};

/** A pole of a linear graph. */
export type GraphPole = {
  /** Damping ratio. */
  damping: number;
  /** Natural frequency [Hz]. */
  hertz: number;
  /** Imaginary part [rad/s]. */
  imaginary: number;
  /** Real part [1/s]. */
  real: number;
};

/** A graph to look at. */
export type GraphQuestion = {
  /** Texts of the graphs that it uses and of the files of its tables, by the names that it has for them. */
  parts: Record<string, string>;
  /** The graph file. */
  text: string;
};

/** A tile of an engine's graph: block and crank, a cylinder, a rotor, a mount. */
export type GraphTile = {
  /** Its upper left corner [px]. */
  corner: [number, number];
  size: [number, number];
  title: string;
};

/** A transfer function. */
export type GraphTransfer = {
  input: string;
  /** A fraction in powers of s, as MathML. */
  mathml: string;
  output: string;
};

/** What a similar engine keeps of the original. */
export type Held = "speed" | "piston-speed";

export type Hold = "speed" | "piston-speed";

/** A drawing whose outline a weight gets. */
export type ImportQuestion = {
  /** Density with its unit; that of the present shape or of the crankshaft where it is left out. */
  density: string | null;
  /** The drawing: SVG, or DXF as text. */
  drawing: string;
  /** What the outline encloses. */
  encloses: Encloses;
  /** Layers that are left out. */
  leave_out: string[];
  /** Name of the drawing's file: its ending tells the form, DXF or SVG. */
  name: string;
  /** The engine file. */
  text: string;
  /** Thickness with its unit; that of the present shape or of the webs where it is left out. */
  thickness: string | null;
  /** Unit of the drawing, where it does not say it: mm, cm, m, in. */
  unit: string | null;
  /** Name of the weight. */
  weight: string;
};

/** The outline of a drawing. */
export type Imported = {
  /** As `lanchester counterweight import --format json` prints it. */
  found: ImportedOutline;
  /** The engine file with the outline. */
  text: string;
};

/** An outline that was read, and what it makes of its counterweight. */
export type ImportedOutline = {
  /** What of the drawing was left out, and why. */
  left_out: string[];
  /** Its part. */
  part: Part2;
  /** Mass, unbalance and inertia. */
  properties: MassProperties;
  /** Name of the counterweight. */
  weight: string;
};

/** A text to be completed. */
export type Incomplete = {
  /** Kind of engine that the values are taken for; none: what its numbers say. */
  kind: EngineKind | null;
  /** Sections that are wanted; all that are missing where none is named. */
  sections: TypicalSection[];
  /** The engine file. */
  text: string;
};

/** A speed that is not known for want of an inertia. */
export type IncompleteInertia = {
  /** What fixes it. */
  fix: string;
  /** Keys of the engine file that give it. */
  keys: string[];
  /** Mean speed asked for [rad/s]. */
  mean_speed: number;
  /** What is not known. */
  missing: MissingInertia[];
  /** Why, in words. */
  reason: string;
  /** [`FLYWHEEL_VERSION`]. */
  version: number;
};

/** Indicated numbers: from the pressures alone, net (the whole working cycle, pumping included), without friction. */
export type Indicated = {
  /** Mean effective pressure of what is under the pistons [Pa], positive where it takes work from the crank. */
  crankcase_mep: number;
  /** Swept volume of all cylinders [m^3], of their true strokes. */
  displacement: number;
  /** Mean effective pressure of the gas in the cylinders, net [Pa]: their work over the swept volume. */
  imep: number;
  /** Mean piston speed of the fastest cylinder [m/s]: two strokes a revolution. */
  mean_piston_speed: number;
  /** Highest cylinder pressure of all cylinders [Pa], absolute. */
  peak_pressure: number;
  /** Power [W]: mean torque times speed. */
  power: number;
  /** Mean torque at crankshaft 1 [N m]. */
  torque: number;
  /** Torque a unit of mean effective pressure [m^3]: swept volumes over the angles of their cycles, at crankshaft 1. */
  torque_per_mep: number;
};

/** Work of one cylinder in one working cycle [J], by routes that share no quadrature. */
export type IndicatedWork = {
  /** Of the force that the rods pass to the crankpin, through side thrust and rod, with the exact lever. */
  by_rods: number;
  /** Of the torque, over the crank angle. */
  by_torque: number;
  /** Of the pressures over the volume: from their orders and those of the travel. */
  by_volume: number;
  /** What is under the piston, negative where it takes work from the crank. */
  crankcase: number;
  /** Of the gas in the cylinder alone; net. */
  cylinder: number;
  /** That between the bottom dead centres around firing: compression and power; gross. */
  gross: number;
  /** Swept volume [m^3]. */
  swept: number;
};

/** Why there is no design. */
export type Infeasible = {
  /** For each limit the nearest value that can be met while all others hold; none is listed that cannot help alone. */
  nearest: NearestLimit[];
  /** Whether every box was refuted; otherwise a design may have been overlooked. */
  proved: boolean;
};

/**
 * A bore along the crank axis that is filled with another material: a heavy-metal slug, or a hole where the density is 0.
 *
 * It makes its own bore: the outline has no hole there.
 */
export type Insert = {
  /** Centre of the bore [m]. */
  centre: Point;
  /** Density of what is in it [kg/m^3]; 0 for a hole. */
  density: number;
  /** Where it begins, from the front face [m]. */
  from: number;
  /** Radius of the bore [m]. */
  radius: number;
  /** Where it ends, from the front face [m]. */
  to: number;
};

/** Shear forces and bending moments of all crankshafts at one speed. */
export type InternalMoments = {
  /** Whether the weights on the crankshafts count. */
  counterweights: boolean;
  /** By crankshaft; one without throws is left out. */
  crankshafts: CrankshaftMoments[];
  /** Period [rad] of crankshaft 1. */
  period: number;
  /** Share of the reciprocating forces that counts. */
  reciprocating_share: number;
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** Crank angle of crankshaft 1 [rad] of every trace, from 0, one period, end point excluded. */
  theta: number[];
  /** [`INTERNAL_VERSION`]. */
  version: number;
};

/** A plain cylindrical bearing. */
export type JournalBearing = {
  /** Radial clearance [m]: half the difference of the diameters. */
  clearance: number;
  /** Length of the bearing along the axis [m]. */
  length: number;
  /** Radius of the journal [m]. */
  radius: number;
};

/** What is judged. */
export type Judged = "force" | "couple" | "mount-force";

/** Speeds at which loads were judged that a higher speed need not raise: forces at mounts with springs, loads with gas. */
export type JudgedSpeeds = {
  /** By how much a speed between passes the value, at most, as a share of it: what the search over the range left. */
  excess: number;
  /** Speeds of crankshaft 1 [rad/s] that hold the proof: over a range the ends, the resonances, some between and the worst of every round. */
  judged: number[];
  /** Whether the whole range of the engine counts. */
  range: boolean;
  /** What loads at each of them are multiplied by before the largest counts; empty where nothing is. */
  weights?: number[];
  /** Speed [rad/s] at which the first of these criteria, times the weight of its speed, is largest with what was found. */
  worst: number;
};

/** A key of the engine file. */
export type KeyInfo = {
  /** The words or numbers that may stand; empty for any. */
  choices: string[];
  /** One or two sentences. */
  doc: string;
  /** A value as it stands in a file. */
  example: string;
  /**
   * `text`, `flag`, `whole`, `number`, `choice`, `quantity`, `share`, `ratio`, `list`, `table` or `tables`; `quantities` where one
   * quantity or several may stand.
   */
  kind: string;
  /** Layout types for which it means something; empty for all. */
  layouts: string[];
  /** Its name. */
  name: string;
  /** Whether it must be given. */
  required: boolean;
  /** What is due, for messages: "a length with its unit". */
  wanted: string;
};

/** A table of the engine file. */
export type KeyTable = {
  /** What it describes. */
  doc: string;
  /** Its keys. */
  keys: KeyInfo[];
  /** Where it stands: `crank`, `gas.cycle`, `cylinder[]` for the entries of a list; empty for the file itself. */
  path: string;
};

/** Which side of words stands at their place. */
export type LabelAnchor = "start" | "middle" | "end";

/** The largest value of an objective. */
export type LayoutLimit = {
  /** The largest value, in SI units. */
  most: number;
  /** Its name, as `--minimise` takes it. */
  objective: string;
};

/** An objective of a search. */
export type LayoutObjective = {
  /** Its name. */
  name: string;
  /** Its SI unit, empty for a plain number. */
  unit: string;
};

/** Which layouts, and what they are judged by. What is left out is as in the file. */
export type LayoutQuestion = {
  /** Angles between two banks [rad]. */
  bank_angles: number[] | null;
  /** Weights on the webs; those of the file where there are none. */
  counterweights: WebWeights[];
  /** Number of cylinders. */
  cylinders: number | null;
  /** Only layouts that fire evenly. */
  even_firing: boolean;
  /** One bank, whatever the engine has. */
  in_line: boolean;
  /** Largest values of objectives. */
  limits: LayoutLimit[];
  /** Objectives by their names, as `--minimise` takes them; the usual ones where there are none. */
  minimise: string[];
  /** Speed of the crankshaft [rad/s]; the highest of the engine where it is left out. */
  speed: number | null;
  /** How far the pin of bank 2 stands ahead of that of bank 1 [rad]. */
  split_angles: number[] | null;
  /** The engine file. */
  text: string;
  /** Equal parts of a turn at which throws may stand; usually 12, or as many as even firing needs. */
  throw_parts: number | null;
  /** Leave the firing orders out. */
  without_firing: boolean;
};

/** A layout of the front. */
export type LayoutRow = {
  /** Cases with equal objectives, this one included. */
  alike: number;
  /** Number of its case. */
  case: number;
  /** Weights on the webs. */
  counterweights: string;
  /** Cylinders as they fire; `null` where firing is left out. */
  firing_order: number[] | null;
  /** Cylinders and banks in words. */
  name: string;
  /** Its number on the front, from 1. */
  number: number;
  /** Angle of each throw from the first [rad]. */
  throws: number[];
  /** Objectives in SI units; what is rounding of the masses' loads is 0. */
  values: number[];
};

/** A search, and how far it has come. */
export type LayoutTurn = {
  /** What is searched. */
  search: LayoutQuestion;
  /** Where the turn before ended; nothing for the first one. */
  so_far: SoFar | null;
};

/** The order that most of a load is. */
export type Leading = {
  /** Share of it that turns with the crank, from 0 to 1. */
  forward: number;
  /** Order. */
  order: number;
  /** Largest resultant of this order alone, in the unit of the load. */
  size: number;
};

/** A section that was not added. */
export type LeftOut = {
  /** Which. */
  section: TypicalSection;
  /** Why. */
  why: string;
};

/** Lever with which the force along the cylinder axis turns the crank. */
export type Lever = "exact" | "sine";

/** A criterion that must not pass a value. */
export type Limit = {
  /** What. */
  criterion: Criterion;
  /** Largest value, in the criterion's SI unit. */
  most: number;
};

/** On which side of its value a limit lies. */
export type LimitSide = "at-most" | "at-least" | "given";

/** A limit, and whether the production keeps it. */
export type LimitVerdict = {
  /** Samples beyond the limit. */
  beyond: number;
  /** `(limit - mean) / (3 standard deviations)`: for a normal distribution. */
  cpk: number;
  /** `(limit - median) / (99.865 % percentile - median)`: for any distribution (ISO 22514-2). */
  cpk_by_percentiles: number;
  /** Whether the capability by percentiles is the wanted one; without any scatter whether the engine keeps the limit. */
  is_met: boolean;
  /** The limit. */
  limit: number;
  /** On what. */
  output: Output;
};

/** What a limit is about. */
export type LimitedQuantity = "twist" | "stress";

/** A load over the cycle whose largest amount is judged; about the origin. */
export type Load = "force" | "force-x" | "force-y" | "couple" | "couple-x" | "couple-y" | "roll-moment" | {
  "mount-force": number;
} | "largest-mount-force" | {
  "mount-force-with-gas": number;
} | "largest-mount-force-with-gas" | {
  "main-load": number;
} | "largest-main-load" | "bending-moment";

/** Loads of the whole engine, of one kind of part, or of one cylinder. */
export type LoadSet = {
  /**
   * By order, rising: all whole orders asked for, also the vanishing ones, and the fractions that geared crankshafts
   * and shafts bring.
   */
  orders: OrderLoads[];
  /** Extremes over the continuous angle (or over the grid, where one was asked for). */
  peaks: Peaks;
  /** Over one period. */
  trace: Trace;
};

/** Loads of an engine at one speed. */
export type Loads = {
  /** By cylinder: its piston, rod and (shared among the rods of the throw) its share of the crank throw. */
  cylinders: CylinderLoads[];
  /** What the spectrum means, in words. */
  diagnosis: Diagnosis;
  /** Name of the engine. */
  engine: string;
  /** Which motion was used: exact, or a truncated series. */
  kinematics: string;
  /** Motion of every cylinder. */
  motion: CylinderMotion[];
  /** By kind of part, only the kinds that the engine has. */
  parts: PartLoads[];
  /** Period of the loads [rad] of crankshaft 1: 2 pi times a whole number. */
  period: number;
  /** Point that couples and roll moment are about [m]: x, y, z in the frame. */
  reference: [number, number, number];
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** The whole engine. */
  total: LoadSet;
  /** [`RESULT_VERSION`]. */
  version: number;
};

/** An engine at a speed, and which curves are wanted. */
export type LoadsQuestion = {
  /** Whose curves over the crank angle are in the answer; all of them where it is left out. */
  curves: Curves;
  /** Angles of the curves in a revolution; as many as `lanchester loads` has where it is left out. */
  samples: number | null;
  /** Speed of crankshaft 1 [rad/s]; the highest of the engine where it is left out. */
  speed: number | null;
  /** The engine file. */
  text: string;
};

/** A main bearing. */
export type MainBearing = {
  /** Number of its crankshaft, from 1. */
  crankshaft: number;
  /**
   * Bearing on the journal in the journal's frame: real part along throw 1 of its crankshaft, imaginary part a quarter turn on in
   * the sense of increasing angles [N].
   */
  journal_frame: Array<[number, number]>;
  /** Journal on the bearing, `x + i y` of the block's frame [N]. */
  load: PinLoad;
  /** Its number on that crankshaft, from 1. */
  main: number;
  /** Its plane [m], from the origin. */
  z: number;
};

/** A main bearing. */
export type MainLoad = {
  /** Largest load over the cycle [N]. */
  largest: Extreme;
  /** Load of the shaft on the bearing `N_x + i N_y` [N] over the cycle. */
  load: Array<[number, number]>;
  /** Its number from the free end, from 1. */
  main: number;
  /** Its plane [m], from the origin. */
  z: number;
};

/** Which main bearings count. */
export type Mains = "all" | "largest" | {
  one: number;
};

/** Mass properties of a solid. */
export type MassProperties = {
  /** Centre of mass [m]: in the plane as [`Point`], and along the crank axis. */
  centre: [number, number, number];
  /** Inertia tensor about the point of the crank axis at z = 0 [kg m^2]; the products stand with their minus sign. */
  inertia_about_axis: [[number, number, number], [number, number, number], [number, number, number]];
  /** Inertia tensor about the centre of mass, along the same axes [kg m^2]. */
  inertia_about_centre: [[number, number, number], [number, number, number], [number, number, number]];
  /** Mass [kg]. */
  mass: number;
  /** Unbalance: mass times distance of its centre from the crank axis, as a vector [kg m]. */
  unbalance: Point;
};

/** A criterion of an engine. */
export type Measured = {
  kind: "known";
  /** What it leaves out, and why; empty: nothing that others count. */
  left_out?: string;
  /** Which part has it: "main bearing 3", "pin 2 at web 3". */
  place: string;
  /** At which speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** In the unit of the criterion. */
  value: number;
} | Unmeasured & {
  kind: "unknown";
};

/** How an optimum was found. */
export type Method = {
  kind: "convex";
  /** Cone programmes solved until the angles were refined. */
  solves: number;
} | {
  kind: "branch-and-bound";
  /** Branch-and-bound nodes examined. */
  nodes: number;
  /** Cone programmes solved. */
  solves: number;
};

/** A published method. */
export type MethodKind = {
  of: "matrix";
} | {
  of: "half";
} | {
  of: "share";
} | {
  of: "sweep";
} | {
  /** Its number in the thesis. */
  number: number;
  of: "arrangement";
} | {
  of: "arrangements";
};

/** Largest load over the cycle at the highest speed, force [N] or couple [N m]. */
export type MethodLoad = {
  /** With the sizes of the method. */
  method: number;
  /** With the proved optimum of the same devices: force first, then couple; of the sweep the load that it sweeps for. */
  optimum: number | null;
};

/** What a method leaves. */
export type MethodLoads = {
  /** Couple [N m]. */
  couple: MethodLoad;
  /** Force [N]. */
  force: MethodLoad;
};

/** A published method for an engine. */
export type MethodResult = {
  /** Which. */
  kind: MethodKind;
  /** What it leaves. */
  left: MethodLoads | null;
  /** Its name. */
  name: string;
  /** Why it cannot be used for this engine. */
  refused: string | null;
  /** Where it was published. */
  source: string;
};

/** An inertia that is not known. */
export type MissingInertia = "flywheel" | "crankshaft";

/** A natural mode of the undamped chain. */
export type Mode = {
  /** Natural angular frequency [rad/s]. */
  frequency: number;
  /** Moment of inertia in this mode, of the shape as it stands [kg m^2]. */
  inertia: number;
  /** Nodes: changes of sign of the referred angle along the shafts. */
  nodes: number;
  /** Angles of the stations at their own speeds, the largest 1. */
  shape: number[];
};

/** A natural mode. */
export type ModeAnswer = {
  /** A round factor by which it becomes visible. */
  factor: number;
  /** [Hz]. */
  frequency: number;
  kind: ModeKind;
  /** `|K x - l M x|/|K x|`. */
  residual: number;
  /** Displacement x, y, z, of modal mass 1 kg. */
  shape: PackedField;
  /** Shares of the kinetic energy: in the plane of throw 1, across it, turning, along the axis. */
  shares: [number, number, number, number];
};

/** What mainly moves in a mode. */
export type ModeKind = "rigid" | "bending-x" | "bending-y" | "torsion" | "axial" | "mixed";

/** Natural modes on the surface of a crankshaft. */
export type ModesAnswer = {
  modes: ModeAnswer[];
  /** Mesh and material, in words. */
  notes: string[];
  /** What holds it, in words. */
  support: string;
  surface: SurfaceShape;
  unknowns: number;
};

/** Motion of a piston and its rod over the crank angle, at the angles of the loads' [`Trace`]. */
export type MotionTrace = {
  /** Acceleration of the piston away from the crankshaft [m/s^2], of the kinematics asked for. */
  acceleration: number[];
  /** Distance `s` of the piston pin from the crankshaft's axis along the cylinder [m], always exact. */
  position: number[];
  /**
   * Angle `beta` of the rod from the cylinder axis [rad], positive where its big end stands towards +v; always
   * exact.
   */
  rod_angle: number[];
  /** Crank angle of crankshaft 1 [rad], from 0, one period of the loads, end point excluded. */
  theta: number[];
  /** Velocity of the piston away from the crankshaft [m/s], of the kinematics asked for. */
  velocity: number[];
};

/** One mount at rest. Forces are those of the block on the mount. */
export type MountAtRest = {
  /** Deflection [m]. */
  deflection: [number, number, number];
  /** Force [N]: the sum of the three shares. */
  force: [number, number, number];
  /** Share of gravity [N]. */
  gravity: [number, number, number];
  /** Name. */
  name: string;
  /** Deflection along the mount's own three directions [m]. */
  own_deflection: [number, number, number];
  /** The force along the mount's own three directions [N]. */
  own_force: [number, number, number];
  /** Share of the preloads of all mounts [N]. */
  preload: [number, number, number];
  /** Share of the driveline's torque [N]. */
  torque: [number, number, number];
};

/** One undamped mode. */
export type MountMode = {
  /**
   * Natural angular frequency [rad/s]. With a table of stiffness over frequency it is the one at which the stiffness is
   * that of the table there.
   */
  angular_frequency: number;
  /** What is not in that coordinate: 1 minus its share. */
  coupling: number;
  /**
   * Share of the kinetic energy in each coordinate; they add up to 1. One can be negative where a product of inertia
   * couples two rotations.
   */
  energy: [number, number, number, number, number, number];
  /** Coordinate with the largest share, an index into [`COORDINATES`]. */
  main: number;
  /** Share of the elastic energy in each mount; they add up to 1. */
  mount_energy: number[];
  /**
   * Shape: displacement of the centre [m] and rotation [rad], with `shape^T M shape = 1 kg m^2`; its largest energy
   * share moves in the positive sense.
   */
  shape: [number, number, number, number, number, number];
};

/** Rigid-body modes of the block. */
export type MountModes = {
  /** Damped modes, rising by `|root|`. More than six where some are overdamped. */
  damped: DampedMode[];
  /** Undamped modes, rising. */
  modes: MountMode[];
  /** Centre of stiffness of the mounts at rest. */
  stiffness_centre: StiffnessCentre;
  /** Line about which the free block turns under a torque about z: the torque-roll axis. */
  torque_roll_axis: AxisLine;
};

/** Forces at the mounts and motion of the block against speed, by order. */
export type MountResponse = {
  /** Mounts whose table of stiffness does not reach all frequencies of the excitation. */
  beyond_table: BeyondTable[];
  /** The block's centre [m]. */
  centre: [number, number, number];
  /** Names of the mounts. */
  mounts: string[];
  /** One entry a speed, as they were asked for. */
  speeds: SpeedResponse[];
  /** [`MOUNT_RESULT_VERSION`]. */
  version: number;
};

/** The block at rest under gravity and mean torque. */
export type MountStatics = {
  /** Displacement of the centre [m] and rotation [rad] from the position of the file. */
  motion: [number, number, number, number, number, number];
  /** One entry a mount. */
  mounts: MountAtRest[];
};

/** All that is told of an engine on its mounts. */
export type MountStudy = {
  /** At rest. */
  at_rest: MountStatics;
  /** The body that moves. */
  body: MountedBody;
  /** Name of the engine. */
  engine: string;
  /** What shakes it, in words. */
  excitation: string;
  /** Natural motions. */
  modes: MountModes;
  /** Motion of the points asked for, against speed, by order. */
  points: PointMotion[];
  /** Against speed, by order. */
  response: MountResponse;
  /** What of them acts on the motion. */
  rotor_effects: RotorEffects;
  /** Angular momentum of all rotors whose inertia is known over the speed of crankshaft 1 [kg m^2]. */
  rotors: number;
  /** What all mounts together pass on, against frequency. */
  transmissibility: Transmissibility;
  /** [`MOUNT_RESULT_VERSION`]. */
  version: number;
  /** What the user should know of that. */
  warnings: string[];
};

/** An engine on its mounts. */
export type Mounted = {
  /** Speeds over the range of the engine. */
  steps: number | null;
  /** The engine file. */
  text: string;
};

/** The body that moves: the file's block, with pistons and rods where they are to be added. */
export type MountedBody = {
  /** Of it pistons and rods that were added [kg]. */
  added_mass: number;
  /** Centre of mass [m]. */
  centre: [number, number, number];
  /** Inertia tensor about the centre [kg m^2]. */
  inertia: [[number, number, number], [number, number, number], [number, number, number]];
  /** Mass [kg]. */
  mass: number;
};

/** A curve with its name. */
export type NamedCurve = {
  name: string;
  values: number[];
};

/** An engine under a name of its own. */
export type NamedEngine = {
  /** What it is called in the answer. */
  name: string;
  /** The engine file. */
  text: string;
};

/** The best where nobody reaches the limit. */
export type Nearest = {
  /** Index of the arrangement there. */
  arrangement: number;
  /** How close it comes, in words. */
  reason: string;
  /** What it leaves, in the criterion's SI unit. */
  residual: number;
  /** Index of its spacing. */
  spacing: number;
};

/** A limit that would have to give way, with the value at which a design exists. */
export type NearestLimit = {
  /** Its value in the task [SI]. */
  asked: number;
  /** Which limit. */
  limit: DesignLimit;
  /** The nearest that can be met [SI]. */
  nearest: number;
};

/** A text as an answer. */
export type NewText = {
  /** The engine file. */
  text: string;
};

/** What is made as small as possible. */
export type Objective = "mass" | "swept-radius" | "inertia" | "thickness";

/** What a counterweight or web must stay clear of. Cylinders count from 1. */
export type Obstacle = {
  kind: "crankcase";
} | {
  /** Its cylinder. */
  cylinder: number;
  kind: "piston";
} | {
  /** Its cylinder. */
  cylinder: number;
  kind: "liner";
} | {
  /** Its cylinder. */
  cylinder: number;
  kind: "rod";
} | {
  /** Its cylinder. */
  cylinder: number;
  kind: "big-end-side";
};

/** Why orders cannot vanish. */
export type Obstruction = {
  /** The proof: this functional is 1 with or without the devices, and would be 0 or less if the orders vanished. */
  functional: Functional;
  /** In words, with numbers and units. */
  reason: string;
};

/** Which file is opened. */
export type OpenFile = {
  /** Its name in the folder. */
  name: string;
};

/** The best design and its proof. */
export type Optimum = {
  /** What no design can get below, rounding apart [SI]; zero where the proof was stopped before its end. */
  bound: number;
  /** Boxes of the search. */
  boxes: number;
  /** The design. */
  design: Design;
  /** What was made small. */
  objective: Objective;
  /** Whether every box of the search was refuted. */
  proved: boolean;
  /** Its value of the objective [SI]. */
  value: number;
  /** [`DESIGN_VERSION`]. */
  version: number;
};

/** How an orbit ended. */
export type OrbitOutcome = "periodic" | "not_periodic" | "overloaded";

/**
 * One order of the loads.
 *
 * `F_x + i F_y = SUM over orders ( force_forward e^{i n theta} + force_backward e^{-i n theta} )`, the couple
 * `M_x + i M_y` alike; order 0 has its whole mean in `*_forward`. Roll moment and torque are
 * `Re( SUM roll_moment e^{i n theta} )`: their modulus is the amplitude.
 */
export type OrderLoads = {
  /** Part of the couple that turns against the crank [N m]. */
  couple_backward: [number, number];
  /** Part of the couple that turns with the crank [N m]. */
  couple_forward: [number, number];
  /** Part of the force that turns against the crank [N]. */
  force_backward: [number, number];
  /** Part of the force that turns with the crank [N]. */
  force_forward: [number, number];
  /** Order: cycles per revolution of crankshaft 1, not negative; fractions come from geared crankshafts. */
  order: number;
  /** Roll moment [N m], modulus = amplitude. */
  roll_moment: [number, number];
  /** Shaft torque [N m], modulus = amplitude. */
  shaft_torque: [number, number];
};

/** Response to one order at one speed. */
export type OrderResponse = {
  /** Force of the block on each mount [N]. */
  forces: Array<[[number, number], [number, number], [number, number]]>;
  /** Load on the block: force [N] and moment about its centre [N m]. */
  load: [[number, number], [number, number], [number, number], [number, number], [number, number], [number, number]];
  /** Displacement of the centre [m] and rotation [rad]. */
  motion: [[number, number], [number, number], [number, number], [number, number], [number, number], [number, number]];
  /** Order. */
  order: number;
  /** The same if the mounts were stiff, in the proportions of their static stiffness: the load shared as at rest [N]. */
  stiff_forces: Array<[[number, number], [number, number], [number, number]]>;
  /** All mounts together: force [N] and moment about the block's centre [N m]. */
  transmitted: [[number, number], [number, number], [number, number], [number, number], [number, number], [number, number]];
};

/** A part of one order of a load. */
export type OrderSense = "forward" | "backward" | "alternating";

/** Whether there is an optimum. */
export type Outcome = {
  kind: "optimal";
} | {
  /**
   * The smallest value that each limited criterion can reach if the other limits are dropped, in the order of
   * the task's limits.
   */
  closest: number[];
  kind: "infeasible";
  /** The reason in words, with numbers and units. */
  reason: string;
  /** How far every limit must be relaxed together, as a factor of it, until they can just be reached; above 1. */
  relaxation: number;
} | {
  kind: "cannot-vanish";
  /** The reason in words, with numbers and units. */
  reason: string;
} | {
  /** Why. */
  cause: StopCause;
  kind: "stopped";
  /** Why, in words. */
  reason: string;
};

/** An outer contour and the holes within it, none of which touches another. */
export type Outline = {
  holes: Contour[];
  outer: Contour;
};

/** A residual load whose scatter is asked for: a size, 0 being best. */
export type Output = {
  force: {
    /** Order. */
    order: number;
  };
} | {
  couple: {
    /** Order. */
    order: number;
  };
} | {
  "force-sense": {
    /** Order. */
    order: number;
    /** Sense. */
    sense: Sense2;
  };
} | {
  "couple-sense": {
    /** Order. */
    order: number;
    /** Sense. */
    sense: Sense2;
  };
} | "peak-force" | "peak-couple";

/** An output over all ranges. */
export type OutputRange = {
  /** With each input at its lower and at its upper end, in the order of the inputs; `null` if no engine is there. */
  ends: Array<[number | null, number | null]>;
  /** Which. */
  name: string;
  /** Of the nominal engine, in that unit. */
  nominal: number;
  /** Its SI unit. */
  unit: string;
};

/** Scatter of one output. */
export type OutputScatter = {
  /** Against its limits, in the order of the request. */
  capabilities: Capability[];
  /** Which tolerance the scatter comes from, in the order of the request. */
  contributions: Contribution[];
  /** Standard deviation. */
  deviation: number;
  /** Smallest of the samples. */
  least: number;
  /** Mean. */
  mean: number;
  /** Largest of the samples. */
  most: number;
  /** Number of the sample that has it, from 0. */
  most_sample: number;
  /** Of the nominal engine. */
  nominal: number;
  /** Which. */
  output: Output;
  /** Largest relative error of the percentiles: 0 where all samples were kept. */
  percentile_error: number;
  /** Percentiles in the order of the request. */
  percentiles: Percentile[];
};

/** Two bodies that overlap. */
export type Overlap = {
  /** In which direction. */
  along: DepthAlong;
  /**
   * Ranges of the angle of crankshaft 1 [rad] at which they do, first and last; one that runs over the end of the period
   * ends beyond it.
   */
  angles: Array<[number, number]>;
  /** How deep [m]. */
  depth: number;
  /** It is nowhere deeper than this [m]. */
  depth_bound: number;
};

/** Values at all nodes of a surface, component after component: signed 16-bit numbers, each times the scale of its component. */
export type PackedField = {
  scales: number[];
  values: string;
};

/** Which moving parts a load comes from. */
export type Part = "rotating" | "reciprocating" | "rod-inertia" | "counterweights" | "shafts";

/** A flat part on the crankshaft. */
export type Part2 = {
  chamfers: Chamfer[];
  density: number;
  front: number;
  inserts: Insert[];
  outline: Outline;
  thickness: number;
};

/** Loads of one kind of part. */
export type PartLoads = {
  /** Its loads. */
  loads: LoadSet;
  /** Which. */
  part: Part;
};

/** An extreme along the shaft and over the cycle. */
export type Peak = {
  /** Crank angle [rad] in one period; 0 where it is the same at every angle. */
  theta: number;
  /** Value [N] or [N m]. */
  value: number;
  /** Its plane [m], from the origin; a shear force acts just behind it. The first that attains it. */
  z: number;
};

/** The largest stress of a surface. */
export type PeakStress = {
  /** Angle about the bar's middle, from the x axis of the crankshaft's frame [rad]. */
  angle: number;
  /** Place [m]. */
  at: [number, number, number];
  /**
   * Largest jump of the stress between elements over the stress, at the nodes of the same surface of all elements that meet there: a sign of
   * the error.
   */
  jump: number;
  /** Principal stress of the largest size there [Pa], tension positive. */
  principal: number;
  /** Largest von Mises stress [Pa]. */
  von_mises: number;
};

/** Extremes of every quantity of a [`LoadSet`]. */
export type Peaks = {
  /** Resultant couple `|M_x + i M_y|`. */
  couple: Extremes;
  /** Couple about x. */
  couple_x: Extremes;
  /** Couple about y. */
  couple_y: Extremes;
  /** Resultant force `|F_x + i F_y|`. */
  force: Extremes;
  /** Force along x. */
  force_x: Extremes;
  /** Force along y. */
  force_y: Extremes;
  /** Roll moment. */
  roll_moment: Extremes;
  /** Shaft torque. */
  shaft_torque: Extremes;
};

/** A percentile. */
export type Percentile = {
  /** Share of the samples, from 0 to 1. */
  share: number;
  /** What this share does not exceed. */
  value: number;
};

/** Direction of a free weight at `theta = 0`. */
export type Phase = "free" | {
  line: number;
} | {
  direction: number;
};

/** A load over the cycle. */
export type PinLoad = {
  /** At every angle [N]. */
  load: Array<[number, number]>;
  /** Mean size over the continuous angle [N]. */
  mean: number;
  /** Largest size and its angle, over the continuous angle. */
  peak: Extreme;
};

/** A coordinate that is given or to be found. */
export type Place = {
  at: number;
} | {
  between: [number, number];
};

/** A diagnostic and the key that it is about. */
export type PlacedDiagnostic = {
  /** Stable code such as `E0103`; the book lists them. */
  code: string;
  /** Column of the place in characters, from 1. */
  column: number;
  /** What to do. */
  hint: string | null;
  /** What stands at the place, a few words; may be empty. */
  label: string;
  /** Line of the place, from 1. */
  line: number;
  /** What was needed and what was got. */
  message: string;
  /** Path of the value at its place, if there is one. */
  path: string | null;
  /** Other places that matter. */
  related: Related[];
  /** Error or warning. */
  severity: Severity;
  /** Place in the text, in bytes. */
  span: Range_of_uint;
};

/**
 * A point of the plane across the crank, or a vector in it [m].
 *
 * The origin is the crank axis; a part's own `x` points along its unbalance (a counterweight: away from its
 * crankpin), `y` a quarter turn further in the sense in which the crank turns.
 */
export type Point = {
  /** Along the part's axis [m]. */
  x: number;
  /** A quarter turn from it [m]. */
  y: number;
};

/** Motion of a point of the block. */
export type PointMotion = {
  /** Displacement [m] at each speed, for each order of the response. */
  displacement: Array<Array<[[number, number], [number, number], [number, number]]>>;
  /** The point [m]. */
  point: [number, number, number];
};

/** The path of a point of the block. */
export type PointPath = {
  /** Displacement from where it is with the block as drawn [m]: x, y and z. */
  displacement: Array<[number, number, number]>;
  name: string;
};

/** A weight of the crankshaft that the file gives by its unbalance alone, such as one of the flywheel. It has no mass here. */
export type PointWeight = {
  /** Its moment `V` along the crank [kg m^2]. */
  couple: Point;
  /** Its name. */
  name: string;
  /** Static unbalance `U` [kg m]. */
  unbalance: Point;
  /** Its plane [m]. */
  z: number;
};

/** Power over speed as a cubic through the origin. */
export type PowerCurve = {
  /** `a`, `b`, `c` of `P = a w + b w^2 + c w^3` [W s, W s^2, W s^3] with the speed in rad/s. */
  coefficients: [number, number, number];
  /** Largest departure of a point from the curve [W]. */
  misfit: number;
  /** Speed [rad/s] and power [W] of the largest power between 0 and the highest point's speed. */
  peak: [number, number];
  /** Points that it fits: speed [rad/s] and power [W]. */
  points: Array<[number, number]>;
};

/** How many digits a factor carries. */
export type Precision = "single" | "double";

/** What an arrangement costs. */
export type Price = {
  /** Largest load of a shaft bearing [N]. */
  bearing_load: number;
  /** Bearings of shafts and idlers. */
  bearings: number;
  /** Chains or belts. */
  chains: number;
  /** Mass of bare shafts, gears and idlers [kg]. */
  drive_mass: number;
  /** Power that the crank gives to turn the shafts [W]: bearing friction and mesh losses. */
  drive_power: number;
  /** Largest torque in a mesh or chain, at the driven gear [N m]. */
  drive_torque: number;
  /** Idlers. */
  idlers: number;
  /** Inertia of everything added, at the crank [kg m^2]: each part times its ratio squared. */
  inertia: number;
  /** Gear meshes. */
  meshes: number;
  /** Balance shafts. */
  shafts: number;
  /** Unbalance added, all weights together [kg m]. */
  unbalance: number;
  /** Mass of all weights [kg]. */
  weight_mass: number;
  /** Weights, on crank and shafts. */
  weights: number;
};

/** What a command prints. */
export type PrintedPart = {
  /** Whether it is the answer, or the reason. */
  answered: boolean;
  /** The command. */
  command: string;
  /** Its text, or why there is none. */
  text: string;
};

/** Why there is no answer: what was needed, what was got, and what to do. */
export type Problem = {
  /** The mistakes of the engine file, where they are the reason; places in UTF-16 units. */
  diagnostics: Diagnostic[];
  /** How a file stands that was to be written over. */
  found: Found | null;
  /** What to do. */
  hint: string | null;
  /** What was needed and what was got. */
  message: string;
};

/** What published methods leave of the loads of an engine, at its highest speed. */
export type PublishedAnswer = {
  /** The methods. */
  methods: MethodResult[];
  /** The engine as it is. */
  own: MethodLoads;
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
};

/** Whether a finding is about the force, the couple or the roll moment. */
export type Quantity = "force" | "couple" | "roll-moment";

/** How far a counterweight may reach in each direction, between two planes. */
export type RadialEnvelope = {
  /** Directions from that of the counterweight [rad], from 0 to a quarter turn: to either side. */
  directions: number[];
  /** The wanted clearance that it keeps [m]. */
  least: number;
  /** What is first in the way; none where nothing is within reach. */
  limit: Obstacle | null;
  /** Largest radius in each of them [m], on the nearer of both sides. Between two of them it runs along a circle. */
  radii: number[];
};

/** Least and most of a dimension; equal where it is fixed. */
export type Range = {
  /** Least value. */
  least: number;
  /** Largest value. */
  most: number;
};

export type Range_of_uint = {
  end: number;
  start: number;
};

/** The engines by one criterion, best first. */
export type Ranking = {
  /** By what. */
  criterion: RankingCriterion;
  /** The engines in their order. */
  places: RankingPlace[];
};

/** What engines are compared by: less is better, but of films and safeties. */
export type RankingCriterion = "force" | "couple" | "roll-moment" | "mount-force" | "firing-unevenness" | "torque-unevenness" | "flywheel" | "added-unbalance" | "shafts" | "main-film" | "crankpin-film" | "rule-safety" | "fillet-safety";

/** An engine in a ranking. */
export type RankingPlace = {
  /** Its place in the comparison. */
  engine: number;
  /** Rank, from 1; engines that cannot be told apart share it. */
  rank: number;
  /** What it has, in the unit of the criterion. */
  value: number;
};

/** A whole number, or a fraction such as `1/2`. */
export type Ratio = string;

/** What stands in an engine file. All places are in UTF-16 units, as the page counts them. */
export type Reading = {
  /** Mistakes and warnings. */
  diagnostics: PlacedDiagnostic[];
  /** The engine, if there is one. */
  engine: EngineSummary | null;
  /** Every value of the file with its place. */
  entries: FileEntry[];
  /** The text with its changes. */
  text: string;
};

/** A second place that a diagnostic is about. */
export type Related = {
  /** What stands there. */
  label: string;
  /** Place in the text, in bytes. */
  span: Range_of_uint;
};

/** What can remove a load. */
export type Remedy = "crank-weights" | "balance-shaft" | "none-of-low-order" | "roll-device";

/** A report. */
export type ReportQuestion = {
  /** Its name, for the report. */
  name: string;
  /** The engine file. */
  text: string;
};

/** The speed within the cycle, or why there is none. */
export type RippleOutcome = SpeedRipple & {
  outcome: "periodic";
} | IncompleteInertia & {
  outcome: "incomplete-inertia";
} | StoppedEngine & {
  outcome: "stops";
};

/** What of the rotors acts on the motion of the block. */
export type RotorEffects = {
  /** Their gyroscopic couple. */
  couple: boolean;
  /** Their polar inertia does not follow the roll. */
  roll: boolean;
};

/** An extreme of the run. */
export type RunExtreme = {
  /** Over the last period. */
  last_period: number;
  /** What. */
  quantity: string;
  /** At which crank angle [rad]. */
  theta: number;
  /** When [s]. */
  time: number;
  /** Its unit, SI. */
  unit: string;
  /** Over the whole run. */
  value: number;
};

/** Where a run starts: speed of crankshaft 1 [rad/s] and crank angle [rad]. */
export type RunStart = {
  /** Crank angle [rad]. */
  angle: number;
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
};

/** Where a run in time starts, by the drive that it is asked for. */
export type RunStarts = {
  /** At free speed. */
  free: RunStart;
  /** With the drive of the file. */
  given: RunStart;
  /** At imposed speed. */
  imposed: RunStart;
};

/** What is saved. */
export type SaveFile = {
  /** The name in the folder. */
  name: string;
  /** The revision that may be written over; `null` for a new file. */
  revision: string | null;
  /** The whole text. */
  text: string;
};

/** Scatter of all outputs. */
export type Scatter = {
  /** By output, in the order of the request. */
  outputs: OutputScatter[];
  /** Samples drawn. */
  samples: number;
  /** Seed. */
  seed: number;
  /** Deviations drawn for each sample. */
  variables: number;
  /** [`SCATTER_VERSION`]. */
  version: number;
};

/** Production scatter of an engine. */
export type ScatterFound = {
  /** Names of the outputs, in their order, and their SI units. */
  outputs: ScatterOutput[];
  /** As `lanchester scatter --format json` prints it. */
  study: ScatterStudy;
  /** What to tighten first, output by output. */
  tighten: string[];
  /** Tolerances in words, in their order. */
  tolerances: string[];
};

/** An output of the scatter. */
export type ScatterOutput = {
  /** Its name. */
  name: string;
  /** Its SI unit. */
  unit: string;
};

/** An engine with tolerances, and what is drawn. */
export type ScatterQuestion = {
  /** Capability with which a limit is met; 1.33 where it is left out. */
  capability: number | null;
  /** Limits as `--limit` takes them. */
  limits: string[];
  /** Leave the peaks over all orders out, which is faster. */
  orders_only: boolean;
  /** Engines that are drawn. */
  samples: number;
  /** Seed of the draws. */
  seed: number;
  /** Where the turn before ended; nothing for the first one. */
  so_far: SoFar | null;
  /** Speed of the crankshaft [rad/s]; the highest of the engine where it is left out. */
  speed: number | null;
  /** The engine file. */
  text: string;
};

/** Scatter of an engine by the tolerances of its file. */
export type ScatterStudy = {
  /** Capability that is wanted. */
  capability: number;
  /** Deviations drawn for each sample, in the order of those of the worst cases. */
  deviations: Deviation[];
  /** Name of the engine. */
  engine: string;
  /** The limits. */
  limits: LimitVerdict[];
  /** The samples: percentiles of 0 to 100 % in steps of half a percent, then those of [`TOLD_SHARES`]. */
  scatter: Scatter;
  /** Speed of the crankshaft [rad/s]. */
  speed: number;
  /** What halving each tolerance alone would do, with the same draws. */
  tightened: Tightened[];
  /** Its tolerances. */
  tolerances: Tolerance[];
  /** [`SCATTER_STUDY_VERSION`]. */
  version: number;
  /** The worst case of each output. */
  worst_cases: WorstCase[];
};

/** A turn of the draws, with the answer where it was the last one. */
export type ScatterTurn = {
  /** Share of the study that is done, 0 to 1. */
  done: number;
  /** What was found. */
  found: ScatterFound | null;
  /** Where the next turn goes on. */
  so_far: SoFar;
};

/** The solids of an engine and how they move. */
export type Scene = {
  /** Shapes, each of one part or of several. */
  meshes: SceneMesh[];
  /** Whether +y is to the left for who looks from the free end with x up: an engine that turns the other way is the mirror image of its numbers. */
  mirrored: boolean;
  /** What is seen. */
  parts: ScenePart[];
  /** Angle of crankshaft 1 after which everything repeats, firing too [rad]. */
  period: number;
  /** Poses of a part that slides or swings, evenly over its own period. */
  steps: number;
};

/** What a part of the scene is. */
export type SceneKind = "journal" | "crankpin" | "web" | "counterweight" | "rod" | "piston" | "shaft" | "shaft-weight" | "bore";

/** A closed surface of triangles in the frame of its parts. */
export type SceneMesh = {
  /** Numbers of the three points of each triangle, anticlockwise as seen from outside. */
  indices: number[];
  /** Normal of the surface at each point, outwards, of length 1 to three decimals. */
  normals: number[];
  /** x, y, z of each point [m], to the micrometre. */
  positions: number[];
};

/** How the frame of a part moves in the frame of the engine: a place, and a turn about z. Angles count from +x towards +y. */
export type SceneMotion = {
  /** Its turn [rad]. */
  angle: number;
  kind: "fixed";
  /** Place [m]. */
  x: number;
  /** Place [m]. */
  y: number;
  /** Place [m]. */
  z: number;
} | {
  /** Its turn at `theta = 0` [rad]. */
  angle: number;
  kind: "turn";
  /** Speed over that of crankshaft 1, signed. */
  ratio: number;
  /** Axis [m]. */
  x: number;
  /** Axis [m]. */
  y: number;
  /** Place along the axis [m]. */
  z: number;
} | {
  /** Direction in which it slides, and its turn [rad]. */
  angle: number;
  kind: "slide";
  /** Angle of crankshaft 1 after which it repeats [rad]. */
  period: number;
  /** Travel at [`Scene::steps`] even steps of the period, the first at `theta = 0` [m]. */
  travel: number[];
  /** Place at no travel [m]. */
  x: number;
  /** Place at no travel [m]. */
  y: number;
  /** Place [m]. */
  z: number;
} | {
  /** Its turns [rad]. */
  angle: number[];
  kind: "swing";
  /** Angle of crankshaft 1 after which it repeats [rad]. */
  period: number;
  /** Places at [`Scene::steps`] even steps of the period, the first at `theta = 0` [m]. */
  x: number[];
  /** Places [m]. */
  y: number[];
  /** Place along the crank [m]. */
  z: number;
};

/** A part of the scene. */
export type ScenePart = {
  /** Number of the cylinder to which it belongs, from 1. */
  cylinder: number | null;
  /** What it is. */
  kind: SceneKind;
  /** Index of its shape. */
  mesh: number;
  /** How the frame of its shape moves. */
  motion: SceneMotion;
  /** Name, such as "piston 3". It says "symbolic" where the size stands for an unbalance and not for a shape. */
  name: string;
  /** The key of the engine file that says most of it, as the short form of the file has it: "piston.mass". */
  path: string | null;
  /** Index of the engine's counterweight that it is. */
  weight: number | null;
};

/** How large a search is. */
export type SearchSize = {
  /** Cases. */
  cases: number;
  /** What varies, and in how many values. */
  choices: VariedChoice[];
  /** What it is judged by, by name. */
  minimise: string[];
  /** What was assumed. */
  notes: string[];
  /** How long the search takes [s], from a small part of it. */
  seconds: number;
};

/** A turn of a search, with the answer where it was the last one. */
export type SearchTurn = {
  /** Share of the study that is done, 0 to 1. */
  done: number;
  /** What was found in the whole space. */
  found: FoundLayouts | null;
  /** Where the next turn goes on. */
  so_far: SoFar;
};

/** What a free weight sits on. */
export type Seat = {
  crankshaft: number;
} | {
  shaft: number;
};

/** What a piece of a crankshaft is. */
export type SectionKind = "journal" | "pin" | "web" | "counterweight";

/** Which way a load turns. */
export type Sense = "forward" | "backward" | "none";

/** Which way a load turns. */
export type Sense2 = "forward" | "backward";

/** Loads with each number of the engine at either end of a range. */
export type SensitivityAnswer = {
  /** What varies. */
  inputs: VariedNumber[];
  /** What is looked at. */
  outputs: OutputRange[];
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** What the user should know of the gas. */
  warnings: string[];
};

/** An engine at a speed, and what is looked at. */
export type SensitivityQuestion = {
  /** Whether every part varies by itself, or all parts of a kind together. */
  each: boolean;
  /** Outputs as `lanchester sensitivity --output` takes them; peaks of force, couple and roll moment where there are none. */
  outputs: string[];
  /** Speed of crankshaft 1 [rad/s]; the highest of the engine where it is left out. */
  speed: number | null;
  /** The engine file. */
  text: string;
  /** Whether counterweights follow the masses of their throws, or stay as they are. */
  weights_follow: boolean;
};

/** The start of a session. */
export type Session = {
  /** The file that was opened or saved last. */
  file: FileState | null;
  /** Engine files in it. */
  files: string[];
  /** The folder of the files. */
  folder: string;
  /** Name, version and commit of the program. */
  program: string;
  /** Every table and key of the engine file. */
  tables: KeyTable[];
  /** The gallery. */
  templates: TemplateInfo[];
};

/** Whether a file with this diagnostic can be used. */
export type Severity = "error" | "warning";

/** The weights of a balance shaft. */
export type ShaftLayout = {
  kind: "single";
  /** Plane [m]. */
  z: number;
} | {
  kind: "double";
  /** Planes [m]. */
  z: [number, number];
} | {
  kind: "two-planes";
  /** Planes [m]. */
  z: [number, number];
};

/** How a shaft that floats in its films ran. */
export type ShaftRun = {
  /** Model of cavitation. */
  cavitation: Cavitation;
  /** Largest change of an orbit from the last period but one, over the clearance. */
  change: number;
  /** Number of the crankshaft, from 1. */
  crankshaft: number;
  /** Energies of the last period; `None` where it ended early. */
  energy: FilmEnergy | null;
  /** Missing energy over the turnover. */
  energy_error: number | null;
  /** How the orbits ended. */
  outcome: OrbitOutcome;
  /** Periods that were run. */
  periods: number;
  /** Steps of all periods. */
  steps: number;
};

/** A balance shaft. */
export type ShaftSummary = {
  name: string;
  /** Its entry in the file. */
  path: string | null;
  /** Speed over that of crankshaft 1, signed. */
  ratio: number;
  weights: DeviceSummary[];
  /** Position of its axis [m]. */
  x: number;
  /** Position of its axis [m]. */
  y: number;
};

/** A shape as a part, SI units. */
export type ShapePreview = {
  /** Its bounds: least x and y, largest x and y [m]. */
  bounds: [number, number, number, number];
  /** All clearances of the crankshaft with this shape; none where the file names nothing to stay clear of, or nobody asked. */
  clearances: Clearances | null;
  dimensions: Dimensions;
  /** Whether the file has a shape for this weight, or the question gave one; otherwise it is one to start from. */
  drawn: boolean;
  /** Half the chord of the arc [m]. */
  half_width: number;
  /** Whether the part is a shape of the family whose dimensions these are; an outline of the user's own has none. */
  has_dimensions: boolean;
  /** Of what it has beyond its plain web, about the crank axis [kg m^2]. */
  inertia: number;
  /** What it has beyond its plain web [kg]. */
  mass: number;
  /** The outline with the disc of its web as the path of an SVG: metres, y up towards the weight. */
  outline: string;
  /** The plain web in the same frame. */
  plain_web: string | null;
  ranges: DimensionRanges | null;
  /** Angle of the flank [rad]. */
  shoulder_angle: number;
  /** Farthest point from the crank axis [m]. */
  swept_radius: number;
  /** The engine file with this shape. */
  text: string;
  /** What it adds to the unbalance of the crankshaft [kg m]. */
  unbalance: number;
  /** What the weight should be [kg m]. */
  wanted_unbalance: number | null;
  /** Thickness of the plain web [m]. */
  web_thickness: number | null;
};

/** A shape to look at. */
export type ShapeQuestion = {
  /** Whether clearances are told too: they take longer than all the rest. */
  clearances: boolean;
  /** The dimensions; `null`: those of the file, or some to start from. */
  dimensions: Dimensions | null;
  /** The engine file. */
  text: string;
  /** Name of the counterweight. */
  weight: string;
};

/** Shapes among which a counterweight is to be found. Its duty, the unbalance, is that of the weight. */
export type ShapeTask = {
  /** Included angle `alpha` of the arc [rad]. */
  arc_angle: Range;
  /** Radius `R` of the arc [m]. */
  arc_radius: Range;
  /** Density [kg/m^3]. */
  density: number;
  /** Least unbalance as a part of the duty: 1 for full balance. */
  least_balance: number;
  /** Limits. */
  limits: DesignLimits;
  /** What is made as small as possible. */
  minimise: Objective;
  /** Largest unbalance as a part of it, if there is one. */
  most_balance: number | null;
  /** Height `h` of the rectangle [m]. */
  rectangle_height: Range;
  /** How far the proof goes. */
  settings: DesignSettings;
  /** The flank. */
  shoulder: Shoulder;
  /** Thickness [m]. */
  thickness: Range;
  /** Radius `r` of the web's disc [m]. */
  web_radius: Range;
};

/** What a shape shares with its plain web beyond the web's disc: it is the web's. */
export type SharedWithWeb = {
  /** Polar inertia about the crank axis [kg m^2]. */
  inertia: number;
  /** Mass [kg]. */
  mass: number;
  /** Unbalance [kg m]. */
  unbalance: number;
};

/** Bobweights of a sheet. */
export type SheetBobweights = {
  /** The engine with these parts, its crank balanced in different ways. */
  comparison: BobweightComparison | null;
  /** Whether the sheet gives it; else it leaves the smallest first order. */
  given: boolean;
  /** What a derived share leaves least of; none where none was derived. */
  judged_by: string | null;
  /** Pin by pin. */
  pins: Bobweight[];
  /** Share of the reciprocating masses. */
  share: number;
};

/** How the flank between rectangle and arc is given. */
export type Shoulder = {
  Angle: Range;
} | {
  Height: Range;
};

/** A similar engine: what its size and its speed are, over those of the original. */
export type Similar = {
  /** Lengths, over those of the original. */
  length: number;
  /** Speed of the crankshaft, over that of the original. */
  speed: number;
};

/** A run to be made. What is left out is as the file says, else as `lanchester simulate` has it. */
export type SimulateQuestion = {
  /** Crank angle at the start [rad]. */
  angle: number | null;
  /** What happens on the way, besides what the file says. */
  events: AskedEvent[];
  /** Whether the gas of the file acts. */
  gas: boolean | null;
  /** Whether weight acts. */
  gravity: boolean | null;
  /** Whether a drive keeps the speed. */
  imposed: boolean | null;
  /** Torque of a constant load with its unit, or `none`, as `--load` takes it. */
  load: string | null;
  /** Numbers of cylinders that fire no more after the first revolution. */
  misfire: number[];
  /** Whether the block moves on its mounts. */
  on_mounts: boolean | null;
  /** Whether the periodic motion is searched instead. */
  periodic: boolean;
  /** Points of the block whose motion is asked for besides those of the file, with the block as drawn [m]. */
  points: Array<[number, number, number]>;
  /** Revolutions that it lasts. */
  revolutions: number | null;
  /** Speed of crankshaft 1 at the start [rad/s]. */
  speed: number | null;
  /** The engine file. */
  text: string;
};

/** Something that happened on the way. */
export type SimulatedEvent = {
  /** At which speed [rad/s]. */
  speed: number;
  /** At which crank angle [rad]. */
  theta: number;
  /** When [s]. */
  time: number;
  /** What, in words. */
  what: string;
};

/** A run. Every curve has one value a sample. */
export type SimulationAnswer = {
  /** Whether it ran to its end. */
  complete: boolean;
  /** Speeds of the inertias of the driveline [rad/s]. */
  driveline_speeds: NamedCurve[];
  /** Their torques with their dampers on the inertia behind each [N m]. */
  driveline_torques: NamedCurve[];
  /** Twists of the springs of the driveline [rad]; empty without one. */
  driveline_twists: NamedCurve[];
  /** What put energy in, positive, and what took or stores it, negative [J]. */
  energy: EnergyPart[];
  /** Largest error of the energy over its throughput. */
  energy_error: number;
  /** What happened on the way. */
  events: SimulatedEvent[];
  /** Largest and smallest values of the whole run, beside those of the last period. */
  extremes: RunExtreme[];
  /** Force of the teeth on every driven shaft whose pressure angle the file gives [N], its size. */
  gear_forces: NamedCurve[];
  /** Torque of gear or chain on every driven shaft [N m]. */
  gear_torques: NamedCurve[];
  /** Force of the journals on every main bearing [N], its size, by the rule of the file. */
  mains: NamedCurve[];
  /** Force of the block on every mount [N], its size. */
  mounts: NamedCurve[];
  /** Turn of the block: unit quaternion w, x, y, z; empty with a fixed block. */
  orientation: Array<[number, number, number, number]>;
  /** The same over the last period, from the fuel on where a cycle computes the pressures; empty without a whole one. */
  period_energy: EnergyPart[];
  /** First sample of the last period. */
  period_start: number;
  /** Paths of the points that were asked for; empty with a fixed block. */
  points: PointPath[];
  /** Where the block's origin is [m]: x, y and z; empty with a fixed block. */
  position: Array<[number, number, number]>;
  /** Side thrust of every cylinder [N]. */
  side_thrust: NamedCurve[];
  /** Its rate [rad/s]. */
  speed: number[];
  /** Highest, lowest and mean speed in the last period [rad/s]. */
  speeds: [number, number, number];
  /** Crank angle of crankshaft 1 relative to the block [rad]. */
  theta: number[];
  /** Time [s]. */
  time: number[];
  /** Torques that act somewhere in the run [N m]. */
  torques: NamedCurve[];
  /** How it ended, what was chosen for it, and what it does not use. */
  words: string[];
};

/** The smallest clearance of all. */
export type Smallest = {
  /** Name of the counterweight or web, or "big end 2". */
  body: string;
  /** The clearance. */
  clearance: Clearance;
};

/** How far a study has come; whoever asks hands it back unchanged. */
export type SoFar = {
  /** Blocks that are done. */
  blocks: number;
  /** What is kept of them. */
  kept: string;
};

/** How a system was solved. */
export type SolveReport = {
  /** Bytes of matrix and factor. */
  bytes: number;
  /** Entries of the factor. */
  factor_entries: number;
  /** Floating-point operations of the factor. */
  factor_operations: number;
  /** Largest number of iterations of a load case. */
  iterations: number;
  /** Entries of the lower triangle of the matrix. */
  nonzeros: number;
  /** Precision of the factor. */
  precision: Precision;
  /** Largest `|K u - f|/|f|` of a load case. */
  residual: number;
  /** Unknowns. */
  unknowns: number;
};

/** The arrangements at one cylinder spacing. */
export type SpacingArrangements = {
  /** All that were examined, by rising number of shafts. */
  arrangements: Arrangement[];
  /** The criterion with nothing added (balance shafts of the engine file taken out). */
  baseline: number;
  /** Indices of those that no other beats, by falling residual. */
  front: number[];
  /** What was not examined, and why. */
  left_out: string[];
  /** Every z of throws, cylinders and counterweights over that of the engine file. */
  scale: number;
  /** Index of the simplest that reaches the limit and has a place: fewest shafts, meshes, then mass. */
  simplest: number | null;
  /** Cylinder spacing [m]; `None` where the engine has all its throws and cylinders in one plane. */
  spacing: number | null;
};

/** Response at one speed. */
export type SpeedResponse = {
  /** One entry an order that turns, as in the excitation; order 0 is left out. */
  orders: OrderResponse[];
  /** Largest resultant force at each mount over the cycle [N], and the crank angle. */
  peaks: Extreme[];
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
};

/**
 * Speed over the period, at one mean speed.
 *
 * Without gas the load is 0 and the energy stays: the inertia of pistons and rods alone makes the speed swing.
 */
export type SpeedRipple = {
  /** Largest size of the angular acceleration [rad/s^2], among the samples. */
  acceleration: number;
  /** Largest excess energy at constant speed [J], gas and inertia. */
  excess: number;
  /** Its extremes over the continuous angle. */
  extremes: Extremes;
  /** Fluctuation `(w_max - w_min) / w_mean` [1]. */
  fluctuation: number;
  /** The inertia that it turns. */
  inertia: TrainInertia;
  /** Mean torque of the load [N m]: that of the gas and of the torque over the angle that the file gives. */
  load: number;
  /** Mean speed [rad/s]: angle over time. */
  mean_speed: number;
  /** Period [rad] of crankshaft 1. */
  period: number;
  /** Fluctuation by the formula of eq. (25.4): largest excess energy at constant speed over `J w^2`, with the mean inertia. */
  simple_fluctuation: number;
  /** Speed [rad/s]. */
  speed: number[];
  /** Crank angle [rad], from 0, one period, end point excluded. */
  theta: number[];
  /** [`FLYWHEEL_VERSION`]. */
  version: number;
};

/** Criteria that are minimised together: the sum of weight times criterion. */
export type Stage = {
  /** Positive weights and criteria. */
  terms: Array<[number, Criterion]>;
};

/** What a stage gives up for later ones. */
export type StageGiveUp = {
  /** The least value that the stage reached by itself, in its unit; its proof is about this one. */
  least: number;
  /** The value that later stages had to keep, in its unit. */
  most: number;
  /** How far they raised it, in its unit. */
  used: number;
};

/** A plane along the shaft. */
export type Station = {
  /** Largest `|M|` at the plane over the cycle [N m]. */
  largest_moment: Extreme;
  /** Largest `|Q|` just behind the plane over the cycle [N]. */
  largest_shear: Extreme;
  /** Bending moment `M_x + i M_y` [N m] of what lies before the plane on what lies behind it. */
  moment: Array<[number, number]>;
  /**
   * Shear force `Q_x + i Q_y` just behind the plane [N], that of what lies before on what lies behind; just before the
   * plane it is that of the station before, and 0 before the first.
   */
  shear: Array<[number, number]>;
  /** Its place [m], from the origin. */
  z: number;
};

/** What counts of a load over the cycle. */
export type Statistic = "rms" | "mean" | "peak";

/** Centre of stiffness: where the coupling of translation and rotation is symmetric. */
export type StiffnessCentre = {
  /**
   * Residual coupling there, relative: the largest element of the coupling over the geometric mean of the largest stiffness
   * of translation and of rotation. Where it vanishes, a force through this point does not turn the block: the point is
   * the elastic centre.
   */
  coupling: number;
  /** Those directions, unit vectors. */
  directions: [[number, number, number], [number, number, number], [number, number, number]];
  /** The point [m]. */
  point: [number, number, number];
  /** Stiffness along the principal directions [N/m], rising. */
  stiffness: [number, number, number];
};

/** Why a search ended before its gap was closed. */
export type StopCause = "max-nodes" | "time-limit" | "cancelled" | "rounding";

/** An engine without energy enough for its cycle. */
export type StoppedEngine = {
  /** What fixes it. */
  fix: string;
  /** Flywheel inertia with which the lowest speed stays just above the limit [kg m^2]; `None` where none does. */
  flywheel: number | null;
  /** Key of the engine file that gives it. */
  key: string;
  /** Lowest speed over the mean below which an engine counts as stopped [1]: [`STOPPED`]. */
  limit: number;
  /** Mean speed asked for [rad/s]. */
  mean_speed: number;
  /** Why, in words. */
  reason: string;
  /** [`FLYWHEEL_VERSION`]. */
  version: number;
};

/** Stress of the surface of a crankshaft over the cycle. Displacement and stress at a crank angle are the sum of all fields, each with its weight there. */
export type StressAnswer = {
  /** Largest displacement there [m]. */
  displacement: number;
  /** Elastic energy there [J]. */
  energy: number;
  /** A round factor by which displacements become visible. */
  factor: number;
  /** Displacement x, y, z [m] and stress xx, yy, zz, xy, yz, zx [Pa] under unit loads. */
  fields: PackedField[];
  /** For each node of the surface the number of its fillet from 1, or 0: unsigned 16-bit numbers. */
  fillet_of: string;
  fillets: FilletAnswer[];
  /** Where the pressures come from, in words; `null` where no gas acts. */
  gas: string | null;
  /** Mesh, material, loads, superposition, in words. */
  notes: string[];
  solve: SolveReport;
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** What holds it, in words. */
  support: string;
  surface: SurfaceShape;
  /** Crank angles over the cycle [rad]. */
  theta: number[];
  /** By crank angle the weight of each field. */
  weights: number[][];
  /** Crank angle at which a fillet is stressed most of all [rad]. */
  worst_theta: number;
  /** Yield strength [Pa], where the material has one. */
  yield_strength: number | null;
};

/** What an answer will cost. */
export type StressPlan = {
  /** Bytes of matrix and factor. */
  bytes: number;
  /** Load cases. */
  cases: number;
  nodes: number;
  /** Some time that it takes here [s]. */
  seconds: number;
  unknowns: number;
};

/** A crankshaft, how fine it is meshed, what holds it, and its speed. */
export type StressQuestion = {
  /** Number of the crankshaft, from 1; none: 1. */
  crankshaft: number | null;
  /** Elements across the 90 degrees of a fillet, as `--fillet-elements`. */
  fillet_elements: number | null;
  /** Whether the gas of the file is left out. */
  inertia_only: boolean;
  /** Size of the elements away from fillets [m], as `--size`; none: that of the file, else 8 mm. */
  size: number | null;
  /** Speed of crankshaft 1 [rad/s]; none: the highest of the engine. */
  speed: number | null;
  /** With springs: stiffness at each journal in both directions [N/m]. */
  stiffness: number | null;
  /** What holds it; none: its journals, for modes nothing. */
  support: Support | null;
  /** The engine file. */
  text: string;
};

/** A stroke of the working cycle. */
export type StrokeKind = "power" | "exhaust" | "intake" | "compression";

/** What a piston does between two dead centres. */
export type StrokeSpan = {
  /** Crank angle [rad] at its start. */
  from: number;
  /** Which stroke. */
  stroke: StrokeKind;
  /** Crank angle [rad] at its end. */
  to: number;
};

/** Strokes in a working cycle. */
export type Strokes = "two" | "four";

/** Supports whose solutions can be added up. */
export type Support = "clamped-ends" | "journals" | "springs" | "free";

/** A surface of triangles, in the frame of the crankshaft. */
export type SurfaceShape = {
  /** x, y, z of each node [m]: 32-bit floats. */
  nodes: string;
  /** Three nodes of each triangle, seen from outside against the clock: unsigned 32-bit numbers. */
  triangles: string;
};

/** Two swept circles that overlap in a plane across the crank: whether what turns in them meets depends on their phases. */
export type SweptOverlap = {
  /** Sum of both swept radii less the distance of the axes [m]. */
  depth: number;
  /** First plane of the overlap [m], from the origin. */
  from: number;
  /** What it overlaps: another weight, a counterweight, a web, a crankpin or a big end. */
  other: string;
  /** Last plane of the overlap [m], from the origin. */
  to: number;
  /** Name of the weight of a balance shaft. */
  weight: string;
};

/** The largest swept radius that keeps the wanted clearance whatever the shape. */
export type SweptRoom = {
  /** The clearance that it keeps [m]. */
  least: number;
  /** What limits it. */
  limit: Obstacle;
  /** Largest swept radius [m]; zero where there is no room at all. */
  radius: number;
  /** Angle of crankshaft 1 [rad] at which it does, for a piston. */
  theta: number | null;
};

/** An engine of the gallery. */
export type TemplateInfo = {
  name: string;
  /** The engine file. */
  text: string;
  /** What it is. */
  title: string;
};

/** What belongs to one throw, or to none: journals, and weights beside the webs. */
export type ThrowShare = {
  /** Its moment `V` along the crank [kg m^2]. */
  couple: Point;
  /** Mass of pin, webs and counterweights on them [kg]. */
  mass: number;
  /** Moment of inertia about the crank axis [kg m^2]. */
  polar_inertia: number;
  /** Index of the throw. */
  throw: number | null;
  /** Static unbalance `U` [kg m]. */
  unbalance: Point;
};

/**
 * `U_second = factor * U_first`, or `factor * conj(U_first)` if mirrored (in the plane of x and z).
 *
 * A leader follows nobody. In an engine that was read the follower's own direction is free, its least amount 0, its
 * largest that which the leader's allows, and it is not optional: the leader's choices are its own.
 */
export type Tie = {
  /** 1: equal, -1: opposed. */
  factor: number;
  /** Index of the leading weight. */
  first: number;
  /** Whether the phase is mirrored. */
  mirrored: boolean;
  /** Index of the weight that follows it. */
  second: number;
};

/** What halving one tolerance would do. */
export type Tightened = {
  /** Share by which the value that 99.73 % of the engines do not exceed becomes smaller, by output. */
  gains: number[];
  /** Place of the tolerance in the list, from 0. */
  tolerance: number;
};

/** A tolerance: one entry of the engine file's `[tolerances]`. */
export type Tolerance = {
  /** How it is distributed. */
  distribution: Distribution;
  /** For which parts together. */
  extent: Extent;
  /** The nominal value may be missed by this either way, in the quantity's SI unit. */
  half_width: number;
  /** What varies. */
  quantity: Varied;
};

/**
 * Torque of an engine at one speed: gas, inertia, and both together.
 *
 * All torques are at crankshaft 1, positive in the sense of rotation, without friction: net indicated.
 */
export type Torque = {
  /** By cylinder. */
  cylinders: CylinderTorque[];
  /** Energy that both together store and give back, per period. */
  energy: EnergyVariation;
  /** Name of the engine. */
  engine: string;
  /** When they fire. */
  firing: FiringChart;
  /** Gas torque [N m]. */
  gas: number[];
  /** Energy that gas alone stores and gives back. */
  gas_energy: EnergyVariation;
  /** Extremes of the gas torque over the continuous angle. */
  gas_extremes: Extremes;
  /** Torque by order, split: the orders of `orders`. */
  harmonics: TorqueHarmonic[];
  /** The engine in numbers. */
  indicated: Indicated;
  /** Inertia torque at constant speed [N m]. */
  inertia: number[];
  /** Extremes of the inertia torque. */
  inertia_extremes: Extremes;
  /** Lever of gas and inertia. */
  lever: Lever;
  /**
   * Loads by order, gas and inertia together: order 0 (the means), the whole orders, and the fractions that working cycles and
   * gears bring. Of gas they have roll moment and shaft torque alone.
   */
  orders: OrderLoads[];
  /** Period [rad] of crankshaft 1: whole revolutions and whole working cycles. */
  period: number;
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
  /** Crank angle [rad] of every trace, from 0, one period, end point excluded. */
  theta: number[];
  /** Extremes of both together. */
  total_extremes: Extremes;
  /** [`TORQUE_VERSION`]. */
  version: number;
  /** Whether there is gas. Without it its torques and works are 0, and pressures and volumes are left out. */
  with_gas: boolean;
};

/** Torque, work and energy at one of several speeds. */
export type TorqueAtSpeed = {
  /** Energy that both together store and give back. */
  energy: EnergyVariation;
  /** Extremes of gas and inertia together [N m]. */
  extremes: Extremes;
  /** Mean torque, power and pressures, net indicated. */
  indicated: Indicated;
  /** Speed of crankshaft 1 [rad/s]. */
  speed: number;
};

/** One order of the torque, modulus = amplitude; order 0 is the mean. */
export type TorqueHarmonic = {
  /** Gas [N m]. */
  gas: [number, number];
  /** Inertia [N m]. */
  inertia: [number, number];
  /** Cycles per revolution of crankshaft 1. */
  order: number;
};

/** Torque at one speed, and what follows from it. */
export type TorqueReport = {
  /** What friction leaves, where it is known. */
  brake: Brake | null;
  /** The cycles behind the pressures, where they are computed. */
  cycles: CycleResult[];
  /**
   * The flywheel for the fluctuation asked for, at that speed of the file's flywheel that needs most; without these at the lowest
   * speed of the engine.
   */
  flywheel: FlywheelNeed | null;
  /** Whether torques over the angle of the file act besides: in `ripples` and `flywheel`, not in `torque`, `speeds` and `power`. */
  is_driven_besides: boolean;
  /** Power over speed, at the brake where friction is known, else net indicated. */
  power: PowerCurve | null;
  /**
   * Speed within the cycle at the speeds of the file's flywheel; without these at the lowest speed of the engine and at that of `torque`:
   * periodic, or why not.
   */
  ripples: RippleOutcome[];
  /** Where the pressures come from, in words. */
  source: string;
  /** Torque and energy at the speeds asked for. */
  speeds: TorqueAtSpeed[];
  /** Torque, work, orders, energy, firing. */
  torque: Torque;
  /** [`TORQUE_REPORT_VERSION`]. */
  version: number;
  /** What the user should know. */
  warnings: string[];
};

/** Torsional vibration of an engine over its speeds: amplitudes, half of largest less least value. */
export type TorsionAnswer = {
  /** Orders and natural frequencies over speed, with the speeds at which they meet. */
  campbell: Campbell;
  /** The damper, where there is one. */
  damper: DamperAnswer | null;
  /** Where the pressures come from, in words; `null` where no gas acts. */
  gas: string | null;
  /** Limits of the file. */
  limits: TorsionLimit[];
  /** Undamped natural modes. */
  modes: Mode[];
  /** What was assumed and left out. */
  notes: string[];
  /** Orders, per revolution of crankshaft 1. */
  orders: number[];
  /** Speeds of crankshaft 1 [rad/s]. */
  speeds: number[];
  /** Names of the stations along the chain. */
  stations: string[];
  /** Largest nominal shear stress of all shafts at each speed [Pa]; empty where no section is known. */
  stress: number[];
  /** The best setting of the damper, where it was asked for. */
  tuned: TunedDamper | null;
  /** Twist between nose and flywheel [rad]. */
  twist: Curve;
  /** Place among them of the lowest in which the crankshaft twists; `null` where it twists in none of them. */
  twisting: number | null;
};

/** A damper at the free end: a ring on a hub. */
export type TorsionDamper = {
  /** Viscous damping between ring and hub [N m s/rad]. */
  damping: number;
  /** Moment of inertia of hub and housing [kg m^2]. */
  hub_inertia: number;
  /** Of which kind. */
  kind: DamperKind;
  /** Loss factor of that stiffness [1]. */
  loss_factor: number;
  /** Moment of inertia of the seismic ring [kg m^2]. */
  ring_inertia: number;
  /** Stiffness between ring and hub [N m/rad]; 0: none. */
  stiffness: number;
};

/** A limit, and what is reached. */
export type TorsionLimit = {
  /** Allowed amplitude [rad] or [Pa]. */
  allowed: number;
  /** Largest amplitude over speed [rad] or [Pa]. */
  found: number;
  /** Whether what is found can be trusted: not where pendulums swing beyond the linear theory. */
  is_known: boolean;
  /** What is limited. */
  quantity: LimitedQuantity;
  /** Speed of crankshaft 1 at which it is found [rad/s]. */
  speed: number;
};

/** An engine, and numbers of its damper in the place of those of the file. */
export type TorsionQuestion = {
  /** Viscous damping between ring and hub [N m s/rad]. */
  damping: number | null;
  /** Moment of inertia of the damper's ring [kg m^2]. */
  ring_inertia: number | null;
  /** Stiffness between ring and hub [N m/rad]. */
  stiffness: number | null;
  /** The engine file. */
  text: string;
  /** Whether the best setting of the damper is sought: damping of a viscous one, stiffness of rubber. */
  tune: boolean;
};

/** Components over one period, at equally spaced crank angles; one vector a component so that it plots as it is. */
export type Trace = {
  /** Couple about x [N m]. */
  couple_x: number[];
  /** Couple about y [N m]. */
  couple_y: number[];
  /** Force along x [N]. */
  force_x: number[];
  /** Force along y [N]. */
  force_y: number[];
  /** Roll moment about z [N m]. */
  roll_moment: number[];
  /** Shaft torque [N m]. */
  shaft_torque: number[];
  /** Crank angle of crankshaft 1 [rad], from 0, one period, end point excluded. */
  theta: number[];
};

/** Inertia of the crank train seen at crankshaft 1 [kg m^2]. */
export type TrainInertia = {
  /** Big ends of the rods at their crankpins. */
  big_ends: number;
  /** Its extremes over the samples. */
  extremes: Extremes;
  /** Balance shafts and gears whose inertia is known, each times its speed ratio squared. */
  geared: number;
  /** Flywheel and crankshafts as given. */
  given: TurningInertia;
  /** Mean of all of it. */
  mean: number;
  /** Mean over the cycle of pistons, small ends and what the rods' swing adds. */
  reciprocating_mean: number;
  /** All of it over the period of the torque, at `theta`. */
  total: number[];
};

/** Force transmissibility against frequency. */
export type Transmissibility = {
  /** Angular frequencies [rad/s], rising in equal ratios. */
  angular_frequency: number[];
  /** For a unit load in each coordinate at the block's centre: the force transmitted in the same coordinate. */
  ratio: Array<[number, number, number, number, number, number]>;
};

/** What the damper is to keep small, all orders in true phase. */
export type TuneAim = "twist" | {
  torque: number;
} | "stress";

/** What of the damper is free. */
export type TuneFree = "damping" | "stiffness" | "both";

/** A point of the curve. */
export type TunePoint = {
  /** Peak over the speed range, in the unit of the aim. */
  peak: number;
  /** Damping [N m s/rad], or stiffness [N m/rad] where that alone is free. */
  value: number;
};

/** The best setting, with the curve that proves it. */
export type TunedDamper = {
  /** What is small. */
  aim: TuneAim;
  /** The free number and the peak that it gives (the best stiffness for each damping where both are free), rising. */
  curve: TunePoint[];
  /** Best viscous damping [N m s/rad]. */
  damping: number;
  /** What was free. */
  free: TuneFree;
  /** Peak with the damper as given. */
  given: number;
  /** Whether the best lies at an end of the range: a wider range would give less. */
  is_at_end: boolean;
  /** Peak with the ring locked to its hub. */
  locked: number;
  /** Loss factor of the stiffness, as given. */
  loss_factor: number;
  /** Number of local minima on the curve: 1 where the best one is proved by the curve's points alone. */
  minima: number;
  /** Peak over the speed range at the best setting, in the unit of the aim. */
  peak: number;
  /** Speed of that peak [rad/s]. */
  speed: number;
  /** Best stiffness [N m/rad]. */
  stiffness: number;
};

/** What turns, beside what pistons and rods bring. */
export type TurningInertia = {
  /** All crankshafts with their counterweights, as seen at crankshaft 1 [kg m^2]; without the rods. */
  crankshaft: number;
  /** Flywheel with clutch, and whatever turns rigidly with crankshaft 1 [kg m^2]. */
  flywheel: number;
};

/** One engine with two sets of weights. */
export type TwoTexts = {
  /** The engine file as it was. */
  before: string;
  /** The engine file now. */
  text: string;
};

/** A section of the engine file, or a key without which a section says nothing, for which there are typical values. */
export type TypicalSection = "piston.bore" | "crank.web_distance" | "counterweights.at" | "crank.body" | "crank.material" | "gas" | "friction" | "flywheel" | "bearings" | "block" | "mount" | "tolerances" | "balance" | "counterweight_design" | "clearance" | "shaft_weight_design" | "torsion" | "damper" | "simulation";

/** Why a criterion has no number. */
export type Unmeasured = {
  /** What is missing or cannot be computed. */
  reason: string;
  /** What would give it. */
  remedy: string;
};

/** A quantity of the engine that varies. */
export type Varied = "piston-mass" | "big-end-mass" | "small-end-mass" | "rod-centre" | "rod-length" | "crank-radius" | "throw-angle" | "throw-unbalance" | "offset" | "cylinder-plane" | "cylinder-angle" | "counterweight-unbalance" | "counterweight-angle" | "shaft-unbalance" | "shaft-phase";

/** A choice of a search with more than one value. */
export type VariedChoice = {
  /** Its name. */
  name: string;
  /** Number of its values. */
  values: number;
};

/** A number of the engine that varies. */
export type VariedNumber = {
  /** What it is. */
  name: string;
  /** Its nominal value and how far it goes either way, in words with a unit. */
  range: string;
};

/** What is odd, though it can be computed. */
export type Warning = {
  /** What to do. */
  hint: string;
  message: string;
};

/** What fits on a web. */
export type WebBound = {
  /** The largest unbalance that it can have there [kg m]. */
  bound: number;
  /** What bounds it: the ranges of its shapes, or what is in the way. */
  by: string;
  /** Name of the weight. */
  name: string;
  /** The web, counted from 1 through all throws. */
  web: number;
};

/** Weights on the webs of a layout. */
export type WebWeights = "own" | "none" | "full" | "half";

/** What other weights do to an engine. */
export type WeightEffect = {
  /** Loads, bending, counterweights and balance rates, before and after. */
  consequences: Consequences;
  /** What gets worse and which counterweights are dropped, in words; may be empty. */
  words: string;
};

/** What a workshop sheet says of its crank. */
export type WorkshopAnswer = {
  /** Bobweights, where the sheet has weighed parts. */
  bobweights: SheetBobweights | null;
  /** What the commands of the workshop print, for all that the sheet has data for. */
  printed: PrintedPart[];
  /** Mistakes that leave an answer, in words. */
  warnings: string[];
};

/** A workshop sheet, and the engine that it is about. */
export type WorkshopQuestion = {
  /** The workshop sheet. */
  sheet: string;
  /** The engine file in the place of the one that the sheet names; none: the parts alone. */
  text: string | null;
};

/** The worst case of one output. */
export type WorstCase = {
  /**
   * What the deviations of `deviations` reach: a corner of the tolerances of which no single deviation can be
   * turned to its other end with gain. The worst case lies between this and `bound`.
   */
  attained: number;
  /**
   * A loose upper bound: no engine within the tolerances exceeds this. It is the nominal value and all that every part may be off, in whatever
   * direction, so that it is far from `attained` where the parts cannot all push one way.
   */
  bound: number;
  /** Deviation of every variable, tolerance by tolerance and part by part, in SI units. */
  deviations: number[];
  /** Of the nominal engine. */
  nominal: number;
  /** Which. */
  output: Output;
};
