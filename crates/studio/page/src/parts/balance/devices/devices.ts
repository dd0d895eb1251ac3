// Counterweights and shaft weights as they stand in the file, and the edits that change them.

import type { DeviceSummary, Edit, EngineSummary } from "../../../api/types";

/** What is written in the file at a path. */
export type Written = (path: string) => unknown;

/** A quantity as it was typed: its number and the rest. */
export function parted(typed: unknown): { number: number; unit: string } | undefined {
  if (typeof typed !== "string") return undefined;
  const match = /^\s*([-+]?[\d_]*\.?\d*(?:e[-+]?\d+)?)\s*(.*?)\s*$/i.exec(typed);
  const number = Number(match?.[1]?.replaceAll("_", "") || NaN);
  return match && Number.isFinite(number) ? { number, unit: match[2] ?? "" } : undefined;
}

/** So many digits that count, as short as they can be written. */
export function plain(value: number, significant = 5): string {
  return String(Number(value.toPrecision(significant)));
}

/** An amount that was typed, with its SI value: the unit of the next amount. */
export interface Base {
  key: "unbalance" | "mass";
  typed: string;
  si: number;
}

/** What the amount of a device is written as; `undefined` where nothing can be scaled. */
export function baseOf(device: DeviceSummary, written: Written): Base | undefined {
  if (device.path === null || device.unbalance <= 0) return undefined;
  for (const key of ["unbalance", "mass"] as const) {
    const typed = written(`${device.path}.${key}`);
    const parts = parted(typed);
    if (parts && parts.number > 0) return { key, typed: typed as string, si: device.unbalance };
  }
  return undefined;
}

/** Sets the amount [kg m]; the unit that was typed stays, or else it is `unit`, of which one is `unitSi`. */
export function amountEdit(
  device: DeviceSummary,
  amount: number,
  base: Base | undefined,
  unit: string,
  unitSi: number,
): Edit | undefined {
  if (device.path === null) return undefined;
  const parts = base && parted(base.typed);
  if (base && parts) {
    const value = `${plain((parts.number * amount) / base.si)} ${parts.unit}`;
    return { path: `${device.path}.${base.key}`, value };
  }
  return { path: `${device.path}.unbalance`, value: `${plain(amount / unitSi)} ${unit}` };
}

/** Key that holds the direction of a device. */
export function directionKey(device: DeviceSummary): "angle" | "phase" {
  return device.path?.startsWith("shaft") ? "phase" : "angle";
}

/** An angle [rad] in whole tenths of a degree, from 0 to less than 360. */
export function degrees(angle: number): number {
  const tenths = Math.round((angle * 1800) / Math.PI) % 3600;
  return (tenths < 0 ? tenths + 3600 : tenths) / 10;
}

/** Direction of a device as the file counts it [degrees]: what was typed, where that is in degrees. */
export function direction(device: DeviceSummary, written: Written): number {
  const parts = parted(written(`${device.path}.${directionKey(device)}`));
  return parts?.unit === "deg" ? degrees((parts.number * Math.PI) / 180) : degrees(device.direction);
}

/** From where the file counts the direction of a device, in words, and as short as a slider has room for. */
export function counted(device: DeviceSummary): { words: string; short: string } {
  if (device.from_throw !== null) return { words: "from the throw", short: "from throw" };
  return device.path?.startsWith("shaft")
    ? { words: "from x at crank angle 0", short: "from x" }
    : { words: "from the zero of the crankshaft", short: "from zero" };
}

/** A direction at crank angle 0 [rad], counted as the file counts that of the device with `name`. */
export function directionOf(
  name: string,
  absolute: number,
  devices: readonly DeviceSummary[],
): { degrees: number; from: string } | undefined {
  const device = devices.find((one) => one.name === name);
  if (!device) return undefined;
  return { degrees: degrees(absolute - device.angle + device.direction), from: counted(device).short };
}

export function directionEdit(device: DeviceSummary, degree: number): Edit | undefined {
  if (device.path === null) return undefined;
  return { path: `${device.path}.${directionKey(device)}`, value: `${plain(degree)} deg` };
}

/** Where a device stands, in words: "web 3", "throw 2". */
export function seat(device: DeviceSummary, written: Written): string {
  if (device.path === null) return device.name;
  for (const key of ["web", "throw"]) {
    const number = written(`${device.path}.${key}`);
    if (number !== undefined) return `${key} ${String(number)}`;
  }
  return "";
}

/** Farthest weight from the middle [m]: the planes of a shaft that fights a couple. */
export function reach(engine: EngineSummary): number {
  return Math.max(0.04, ...engine.counterweights.map((device) => Math.abs(device.z)));
}

/** Every weight of an engine. */
export function devicesOf(engine: EngineSummary | null | undefined): DeviceSummary[] {
  return engine ? [...engine.counterweights, ...engine.shafts.flatMap((shaft) => shaft.weights)] : [];
}

/** Weights of the short form as entries of their own: opposite their throws as there, at the same places and as heavy. */
export function apart(engine: EngineSummary): Edit[] {
  const edits: Edit[] = [{ path: "counterweights", value: null }];
  const own = engine.counterweights.filter((device) => device.path !== null).length;
  const short = engine.counterweights.filter((device) => device.path === null);
  short.forEach((device, index) => {
    const place = /^(web|throw) (\d+)$/.exec(device.name);
    if (!place) return;
    const value = {
      [place[1] as string]: Number(place[2]),
      unbalance: `${plain(device.unbalance * 1e6, 9)} g mm`,
      angle: "180 deg",
    };
    edits.push({ path: `counterweight[${own + index}]`, value });
  });
  return edits;
}

/** A scale that holds an amount [kg m] with room above it: 1, 2 or 5 times a power of ten. */
export function roof(amount: number): number {
  if (!(amount > 0)) return 0.01;
  const power = 10 ** Math.floor(Math.log10(amount));
  const step = [1, 2, 5, 10].find((one) => one * power >= amount * 1.0001) ?? 10;
  return step * power;
}
