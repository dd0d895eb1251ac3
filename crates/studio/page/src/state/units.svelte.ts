// Units in which results are shown. Values are SI and radians everywhere; what a user typed stays as typed.

export const SYSTEMS = ["SI", "mm-g", "US"] as const;
export type System = (typeof SYSTEMS)[number];

export type Measure =
  | "length"
  | "vibration"
  | "area"
  | "volume"
  | "mass"
  // Of the whole engine.
  | "body-mass"
  | "force"
  | "moment"
  | "unbalance"
  | "inertia"
  | "angular-damping"
  | "angular-stiffness"
  | "speed"
  | "angle"
  | "rotation"
  | "velocity"
  | "acceleration"
  | "pressure"
  | "stress"
  | "energy"
  | "power"
  | "density"
  | "frequency"
  | "share"
  | "none";

interface Unit {
  name: string;
  /** SI value of one of it. */
  si: number;
}

const INCH = 0.0254;
const POUND = 0.45359237;
const POUND_FORCE = POUND * 9.80665;

const DEGREE: Unit = { name: "°", si: Math.PI / 180 };
const RPM: Unit = { name: "rpm", si: Math.PI / 30 };
const MICROMETRE: Unit = { name: "µm", si: 1e-6 };
const COMMON = {
  speed: RPM,
  angle: DEGREE,
  // Small angles, told with digits that count.
  rotation: DEGREE,
  frequency: { name: "Hz", si: 1 },
  share: { name: "%", si: 0.01 },
  none: { name: "", si: 1 },
};

const UNITS: Record<System, Record<Measure, Unit>> = {
  SI: {
    ...COMMON,
    length: { name: "m", si: 1 },
    vibration: MICROMETRE,
    area: { name: "m²", si: 1 },
    volume: { name: "m³", si: 1 },
    mass: { name: "kg", si: 1 },
    "body-mass": { name: "kg", si: 1 },
    force: { name: "N", si: 1 },
    moment: { name: "N m", si: 1 },
    unbalance: { name: "kg m", si: 1 },
    inertia: { name: "kg m²", si: 1 },
    "angular-damping": { name: "N m s/rad", si: 1 },
    "angular-stiffness": { name: "N m/rad", si: 1 },
    velocity: { name: "m/s", si: 1 },
    acceleration: { name: "m/s²", si: 1 },
    pressure: { name: "bar", si: 1e5 },
    stress: { name: "MPa", si: 1e6 },
    energy: { name: "J", si: 1 },
    power: { name: "kW", si: 1e3 },
    density: { name: "kg/m³", si: 1 },
  },
  "mm-g": {
    ...COMMON,
    length: { name: "mm", si: 1e-3 },
    vibration: MICROMETRE,
    area: { name: "mm²", si: 1e-6 },
    volume: { name: "cm³", si: 1e-6 },
    mass: { name: "g", si: 1e-3 },
    "body-mass": { name: "kg", si: 1 },
    force: { name: "N", si: 1 },
    moment: { name: "N m", si: 1 },
    unbalance: { name: "g mm", si: 1e-6 },
    inertia: { name: "g m²", si: 1e-3 },
    "angular-damping": { name: "N m s/rad", si: 1 },
    "angular-stiffness": { name: "kN m/rad", si: 1e3 },
    velocity: { name: "m/s", si: 1 },
    acceleration: { name: "m/s²", si: 1 },
    pressure: { name: "bar", si: 1e5 },
    stress: { name: "MPa", si: 1e6 },
    energy: { name: "J", si: 1 },
    power: { name: "kW", si: 1e3 },
    density: { name: "kg/m³", si: 1 },
  },
  US: {
    ...COMMON,
    length: { name: "in", si: INCH },
    vibration: { name: "mil", si: INCH / 1000 },
    area: { name: "in²", si: INCH * INCH },
    volume: { name: "in³", si: INCH ** 3 },
    mass: { name: "lb", si: POUND },
    "body-mass": { name: "lb", si: POUND },
    force: { name: "lbf", si: POUND_FORCE },
    moment: { name: "lbf ft", si: POUND_FORCE * 12 * INCH },
    unbalance: { name: "oz in", si: (POUND / 16) * INCH },
    inertia: { name: "lb in²", si: POUND * INCH * INCH },
    "angular-damping": { name: "lbf ft s/rad", si: POUND_FORCE * 12 * INCH },
    "angular-stiffness": { name: "lbf ft/rad", si: POUND_FORCE * 12 * INCH },
    velocity: { name: "ft/s", si: 12 * INCH },
    acceleration: { name: "ft/s²", si: 12 * INCH },
    pressure: { name: "psi", si: POUND_FORCE / (INCH * INCH) },
    stress: { name: "ksi", si: (1000 * POUND_FORCE) / (INCH * INCH) },
    energy: { name: "ft lbf", si: POUND_FORCE * 12 * INCH },
    power: { name: "hp", si: 550 * POUND_FORCE * 12 * INCH },
    density: { name: "lb/in³", si: POUND / INCH ** 3 },
  },
};

class Units {
  system = $state<System>(kept());
  set(system: System) {
    this.system = system;
    localStorage.setItem("lanchester-units", system);
  }
}

function kept(): System {
  const system = localStorage.getItem("lanchester-units");
  return SYSTEMS.find((known) => known === system) ?? "mm-g";
}

export const units = new Units();

export function unit(measure: Measure): string {
  return UNITS[units.system][measure].name;
}

/** An SI value in the unit that is shown. */
export function shown(value: number, measure: Measure): number {
  return value / UNITS[units.system][measure].si;
}

export function toSi(value: number, measure: Measure): number {
  return value * UNITS[units.system][measure].si;
}

/** Narrow spaces between thousands, from ten thousand on, as in the program's tables. */
export const spaced = (text: string): string =>
  text.replace(/^-?\d{5,}/, (whole) => whole.replace(/\B(?=(\d{3})+$)/g, "\u202f"));

/**
 * So many digits that count, with a true minus sign and thousands apart, without an exponent as long as the number stays readable:
 * for people alone.
 */
export function digits(value: number, significant = 4): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.floor(Math.log10(Math.abs(value)));
  const plain =
    size >= 6 || size < -4
      ? value.toExponential(significant - 1).replace("e+", "e")
      : spaced(value.toFixed(Math.max(0, Math.min(8, significant - 1 - size))));
  return plain.replaceAll("-", "−");
}

/** An SI value with its unit, as text. */
export function quantity(value: number, measure: Measure, significant = 4): string {
  const name = unit(measure);
  return digits(shown(value, measure), significant) + (name ? (name === "°" ? "°" : ` ${name}`) : "");
}

/** A whole number of things, with thousands apart as in all other numbers. */
export const counted = (count: number): string => spaced(String(Math.round(count)));

/** An SI value with its unit, as text, with the decimals that steps of `step` [SI] tell apart. */
export function stepped(value: number, measure: Measure, step: number): string {
  const decimals = Math.max(0, Math.min(8, Math.ceil(-Math.log10(shown(step, measure)) - 1e-9)));
  return `${spaced(shown(value, measure).toFixed(decimals)).replace("-", "−")} ${unit(measure)}`.trimEnd();
}
