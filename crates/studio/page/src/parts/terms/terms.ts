// Terms of the page: what each means, and where the book says more.

export interface Term {
  name: string;
  /** Other words that lead to it. */
  also?: string;
  words: string;
  /** Page of the book and heading on it. */
  book: string;
}

export const TERMS: Term[] = [
  {
    name: "shaking force",
    also: "peak force unbalanced inertia",
    words: "What the moving parts exert on the block, by their inertia.",
    book: "theory/loads#force-and-couple",
  },
  {
    name: "couple",
    also: "peak couple rocking yaw pitch moment",
    words:
      "Moment of the shaking forces about the reference point: about x it yaws the engine, about y it pitches it.",
    book: "theory/loads#force-and-couple",
  },
  {
    name: "roll moment",
    also: "torque reaction rolling",
    words: "Moment on the block about the axis of the crankshaft.",
    book: "theory/loads#roll-moment",
  },
  {
    name: "order",
    also: "primary secondary half order harmonic",
    words: "Cycles per revolution of the crankshaft: order 1 is primary, order 2 is secondary.",
    book: "theory/orders",
  },
  {
    name: "with and against the crank",
    also: "forward backward two-sided spectrum",
    words:
      "Each order of a load in the plane across the crank consists of a vector that turns with the crank and one that turns against it.",
    book: "theory/spectrum",
  },
  {
    name: "ellipse of an order",
    also: "hodograph path arrows",
    words:
      "The tip of the load of one order runs along an ellipse; its semi-axes are sum and difference of the two turning vectors.",
    book: "theory/spectrum#one-order-is-an-ellipse",
  },
  {
    name: "star diagram",
    also: "stars of the cylinders cancel",
    words: "The loads of the cylinders as arrows head to tail: where the star closes, the order cancels.",
    book: "theory/spectrum#star-diagrams",
  },
  {
    name: "firing order",
    also: "firing interval even firing",
    words: "Cylinders in the sequence in which they fire, from cylinder 1.",
    book: "theory/firing",
  },
  {
    name: "cylinder spacing",
    also: "bore pitch distance of cylinders plane z arm of a couple",
    words: "Distance of neighbouring cylinders along the crank: the arms of all couples grow with it.",
    book: "theory/conventions#frame",
  },
  {
    name: "bank angle",
    also: "V angle",
    words: "Angle between the banks of a V.",
    book: "theory/conventions#glossary",
  },
  {
    name: "offset",
    also: "cylinder offset piston-pin offset net offset desaxe",
    words: "Distance of the line of the piston pin from the axis of the crankshaft.",
    book: "theory/conventions#the-cylinders-own-frame",
  },
  {
    name: "crank radius",
    also: "r half the stroke",
    words: "Half the nominal stroke: axis of the crankshaft to axis of the crankpin.",
    book: "theory/conventions#glossary",
  },
  {
    name: "throw",
    also: "crank throw",
    words: "A crankpin with its two webs; each pin of a split pair is a throw of its own.",
    book: "theory/conventions#glossary",
  },
  {
    name: "web",
    also: "crank web cheek arm",
    words: "Arm between a main journal and a crankpin: webs 1 and 2 belong to throw 1.",
    book: "theory/conventions#glossary",
  },
  {
    name: "crankpin",
    also: "crank pin big-end journal",
    words: "The journal that the rod's big end runs on.",
    book: "theory/conventions#glossary",
  },
  {
    name: "rod length",
    also: "connecting rod length conrod l",
    words: "Length of the connecting rod between its eye centres.",
    book: "theory/conventions#glossary",
  },
  {
    name: "crank-to-rod ratio",
    also: "rod ratio lambda λ r/l l/r",
    words:
      "Crank radius over rod length (lambda). Rod ratio can also mean half its inverse: rod length over stroke.",
    book: "theory/conventions#glossary",
  },
  {
    name: "big and small end",
    also: "big end, small end rod eye",
    words: "The rod's eye at the crankpin, and that at the piston pin.",
    book: "theory/conventions#glossary",
  },
  {
    name: "piston pin",
    also: "wrist pin gudgeon pin",
    words: "Pin that joins the piston with the small end of its rod.",
    book: "theory/conventions#glossary",
  },
  {
    name: "split angle",
    also: "split pin offset pins",
    words: "From the crankpin of bank 1 to that of bank 2 of a split pair.",
    book: "theory/conventions#glossary",
  },
  {
    name: "dead centre",
    also: "top dead centre bottom dead centre, TDC BDC",
    words: "Where the piston is farthest from the crankshaft (top) or nearest to it (bottom).",
    book: "theory/conventions#glossary",
  },
  {
    name: "residual inertia",
    also: "rod moment of inertia correction",
    words: "What two end masses have too much of the rod's moment of inertia.",
    book: "theory/conventions#glossary",
  },
  {
    name: "shaft torque",
    also: "inertia torque",
    words: "Torque that is delivered at crankshaft 1.",
    book: "theory/conventions#glossary",
  },
  {
    name: "master and articulated rod",
    also: "master rod, articulated rod link rod slave rod radial",
    words: "Rod on the crankpin that carries knuckle pins, and a rod on a knuckle pin.",
    book: "theory/conventions#glossary",
  },
  {
    name: "knuckle pin",
    also: "articulated rod",
    words: "Pin on the master rod that carries an articulated rod.",
    book: "theory/conventions#glossary",
  },
  {
    name: "reciprocating mass",
    also: "piston pin rings small end",
    words: "Piston with pin and rings, and the rod's small-end mass.",
    book: "theory/rods#two-masses",
  },
  {
    name: "rotating mass",
    also: "big end",
    words: "The rod's big-end mass, and the throw's own unbalance over the crank radius.",
    book: "theory/rods#two-masses",
  },
  {
    name: "unbalance",
    also: "counterweight amount",
    words: "Mass times the distance of its centre from the axis of rotation.",
    book: "theory/conventions#glossary",
  },
  {
    name: "counterweight",
    also: "crank weight shape web",
    words:
      "Weight on a web against the loads that turn with the crank; its best shape has the least mass or inertia for the unbalance that is wanted.",
    book: "theory/counterweight#the-best-counterweight",
  },
  {
    name: "balance shaft",
    also: "balance shafts Lanchester balancer silent shaft counter-rotating",
    words: "Shaft with unbalance, geared to the crankshaft: it removes a load that turns at its ratio.",
    book: "theory/cancellation#what-must-vanish",
  },
  {
    name: "balance rate",
    also: "balancing rate bay",
    words: "Share of the moment within the crankshaft, bay by bay, that its counterweights take.",
    book: "theory/internal-moments#balance-rate-bay-by-bay",
  },
  {
    name: "bending moment",
    also: "inside the crankshaft shear force",
    words: "What the crankshaft carries within itself between its main bearings.",
    book: "theory/internal-moments#loads-and-signs",
  },
  {
    name: "optimum and proof",
    also: "lower bound gap dual certificate",
    words:
      "The value reached, and a bound below which nothing goes: where both are one, the optimum is proved.",
    book: "theory/optimum#the-proof",
  },
  {
    name: "shadow price",
    also: "price of a limit",
    words: "How much the optimum changes with a limit that is active.",
    book: "theory/optimum#shadow-prices",
  },
  {
    name: "arrangement",
    also: "which arrangement Pareto front layouts",
    words: "A set of crank weights and balance shafts with its drive and place, at its proved optimum.",
    book: "theory/branch-and-bound",
  },
  {
    name: "side thrust",
    also: "piston slap wall",
    words: "Force of the piston on the wall of its cylinder.",
    book: "theory/bearings#forces-of-one-piston",
  },
  {
    name: "main bearing load",
    also: "journal bearings",
    words: "What a main bearing carries over the cycle.",
    book: "theory/bearings#main-bearings",
  },
  {
    name: "oil film",
    also: "oil films journal bearing thinnest film viscosity eccentricity",
    words:
      "The oil between journal and bearing that carries the load; its thinnest place over the cycle decides wear.",
    book: "theory/films",
  },
  {
    name: "cavitation",
    also: "film pressure",
    words: "Oil bears no tension: where the film opens it breaks up.",
    book: "theory/films#cavitation",
  },
  {
    name: "speed fluctuation",
    also: "cyclic irregularity ripple",
    words: "How far the speed departs from its mean within a cycle, as a share of the mean.",
    book: "theory/flywheel#cyclic-speed-fluctuation",
  },
  {
    name: "energy fluctuation",
    also: "excess energy flywheel",
    words: "Largest less smallest surplus of work within a cycle: what the flywheel has to take.",
    book: "theory/flywheel#energy",
  },
  {
    name: "flywheel inertia",
    also: "mean inertia of the train",
    words: "Moment of inertia that keeps the speed even.",
    book: "theory/flywheel#inertia",
  },
  {
    name: "pressure over the cycle",
    also: "gas trace IMEP indicated",
    words: "Pressure in each cylinder: from a cycle that is computed, or from a measured trace.",
    book: "theory/pressure#curves",
  },
  {
    name: "rigid-body modes",
    also: "block natural mode coupling",
    words: "Free oscillations of the block, as one rigid body, on its mounts.",
    book: "theory/mounts#natural-motions",
  },
  {
    name: "force transmissibility",
    also: "transmitted mount force isolation",
    words: "Force at the frame over the force on the block, by frequency.",
    book: "theory/mounts#shaken",
  },
  {
    name: "damping ratio",
    also: "loss factor",
    words: "Damping over the critical one: above 1 a mode does not oscillate.",
    book: "theory/mounts#natural-motions",
  },
  {
    name: "torsional vibration",
    also: "twist campbell critical speed",
    words:
      "The crankshaft twists under the torques of its cylinders: worst where an order meets a natural frequency.",
    book: "theory/torsion#forced-vibration",
  },
  {
    name: "critical speed",
    also: "resonance Campbell diagram",
    words: "Speed at which an order excites a natural frequency.",
    book: "theory/torsion#free-vibration",
  },
  {
    name: "torsional damper",
    also: "ring rubber viscous pendulum",
    words: "A ring at the free end that takes energy out of the twist.",
    book: "theory/torsion#dampers",
  },
  {
    name: "von Mises stress",
    also: "equivalent stress yield safety",
    words: "The one number of a state of stress that is compared with the yield strength.",
    book: "theory/flexible#elements",
  },
  {
    name: "principal stress",
    also: "largest tension compression",
    words: "Largest normal stress over all directions; tension is positive.",
    book: "theory/strength#fatigue-at-a-point",
  },
  {
    name: "error band",
    also: "convergence Richardson jump between elements mesh",
    words: "How far off a stress may be: from three meshes, and from the jump between the elements of one.",
    book: "theory/flexible#convergence",
  },
  {
    name: "fillet",
    also: "stress concentration radius",
    words: "Rounded corner between journal or pin and web, where the stress of a crankshaft is highest.",
    book: "theory/strength#stress-concentration",
  },
  {
    name: "natural mode of the crankshaft",
    also: "natural frequency bending torsion",
    words: "A shape in which the free crankshaft oscillates by itself.",
    book: "theory/flexible#modes",
  },
  {
    name: "production scatter",
    also: "tolerance histogram capability",
    words: "What the tolerances of the parts do to the loads of a production.",
    book: "theory/scatter#what-is-told",
  },
  {
    name: "sensitivity",
    also: "what matters most tornado derivative",
    words: "How much a result changes with a number of the engine.",
    book: "theory/sensitivity#exact-derivatives",
  },
  {
    name: "balance quality grade",
    also: "G ISO 21940 permissible unbalance",
    words: "Permissible speed of the mass centre of a rotor [mm/s]; from it comes the residual unbalance.",
    book: "theory/balance-grade",
  },
  {
    name: "bobweight",
    also: "dummy weight balancing machine",
    words: "Ring on a crankpin of a V that stands for the rods while the crankshaft is balanced.",
    book: "theory/bobweight#what-the-crank-can-balance",
  },
  {
    name: "published method",
    also: "balance factor matrix method half rule",
    words: "Rules of the literature, as their sources mean them, beside the optimum of the same devices.",
    book: "theory/published-methods",
  },
  {
    name: "bond graph",
    also: "causality junction state",
    words: "A drawing of how power flows between the parts of a system, from which its equations follow.",
    book: "theory/bond-graphs#causality",
  },
  {
    name: "run in time",
    also: "simulate multibody reactions periodic motion",
    words: "The crank train as rigid bodies, at the speed that its torques make.",
    book: "theory/multibody#periodic-motion",
  },
];

export const term = (name: string): Term | undefined => TERMS.find((one) => one.name === name);

/** Terms that the titles of plots are about, the first that fits. */
const TITLES: [RegExp, string][] = [
  [/by order/i, "order"],
  [/hodograph|^orbits? /i, "ellipse of an order"],
  [/^force on the block/i, "shaking force"],
  [/^couple on the block/i, "couple"],
  [/^roll moment/i, "roll moment"],
  [/^bending moment|^shear force/i, "bending moment"],
  [/^main bearings?\b/i, "main bearing load"],
  [/side thrust/i, "side thrust"],
  [/film/i, "oil film"],
  [/^pressure|indicator/i, "pressure over the cycle"],
  [/^speed over the cycle/i, "speed fluctuation"],
  [/transmissib|^transmitted/i, "force transmissibility"],
  [/campbell/i, "critical speed"],
  [/twist|vibratory/i, "torsional vibration"],
  [/stress/i, "von Mises stress"],
];

export function ofTitle(title: string): string | undefined {
  return TITLES.find(([words]) => words.test(title))?.[1];
}

/** Terms of keys of the engine file. */
const KEYS: Record<string, string> = {
  spacing: "cylinder spacing",
  bank_angle: "bank angle",
  offset: "offset",
  pin_offset: "offset",
  order: "firing order",
  unbalance: "unbalance",
  rotating_share: "rotating mass",
  big_end_mass: "rotating mass",
  small_end_mass: "reciprocating mass",
  ratio: "balance shaft",
  loss_factor: "damping ratio",
  fillet: "fillet",
  grade: "balance quality grade",
  viscosity: "oil film",
};

/** The term of a key: of its name, of its table, of what it is about. */
export function ofKey(path: string): string | undefined {
  const name = path.split(".").at(-1) ?? "";
  if (/^shaft\b/.test(path)) return "balance shaft";
  if (/^counterweight\b/.test(path)) return "counterweight";
  if (/^flywheel\b/.test(path)) return "flywheel inertia";
  if (/^mount\b/.test(path)) return name === "loss_factor" ? "damping ratio" : "rigid-body modes";
  if (/^gas\b/.test(path)) return "pressure over the cycle";
  if (/^torsion\b/.test(path)) return "torsional vibration";
  if (/^tolerances\b/.test(path)) return "production scatter";
  if (path === "piston.mass") return "reciprocating mass";
  return KEYS[name];
}
