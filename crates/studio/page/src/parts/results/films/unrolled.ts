// The film of a bearing unrolled: its thickness over the crank angle and the angle in the shell.
//
//   h(theta, a) = c - e(theta) . n(a)
//
// e: journal centre in the frame of the shell, n: unit vector in the direction a, c: radial clearance. With e = |e| n(b) the film is thinner than a
// limit l where |a - b| < acos((c - l) / |e|).

import type { BearingFilm } from "../../../api/types";
import { inShell } from "./films";

const TURN = 2 * Math.PI;
/** Limits of the bands over the radial clearance: close together where the film is thin. */
const SHARES = [0.025, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1, 1.5];
/** Surfaces are apart where the film is thicker than so many times their composite roughness. */
export const APART = 3;
/** Places of the shell at which wear is looked for. */
const PLACES = 360;

export interface Unrolled {
  /** Journal centre at the instants of the orbit [m]. */
  along: readonly number[];
  across: readonly number[];
  /** Radial [m]. */
  clearance: number;
}

/** A stretch of the shell at every instant. */
export interface Strip {
  /** Its middle [rad], which goes on over the turn: it does not jump. */
  middle: number[];
  /** Half its length [rad]; 0: none, pi: all around. */
  half: number[];
}

/** Closed: from its first point on and back to it. */
export interface Outline {
  x: number[];
  y: number[];
}

export function unrolled(film: BearingFilm): Unrolled {
  return { ...inShell(film), clearance: film.bearing.clearance };
}

/** Thickness of the film [m] at an instant and an angle in the shell [rad]. */
export function thicknessAt({ along, across, clearance }: Unrolled, instant: number, angle: number): number {
  return clearance - (along[instant] ?? 0) * Math.cos(angle) - (across[instant] ?? 0) * Math.sin(angle);
}

/** From 0 to a turn. */
export function inTurn(angle: number): number {
  const rest = angle % TURN;
  return rest < 0 ? rest + TURN : rest;
}

/** Angle in the shell at which the film of an instant is thinnest [rad]. */
export function nearestAt({ along, across }: Unrolled, instant: number): number {
  return inTurn(Math.atan2(across[instant] ?? 0, along[instant] ?? 0));
}

/** The instant at a crank angle. */
export function instantAt({ along }: Unrolled, theta: number, period: number): number {
  const count = along.length;
  return ((Math.round((theta / period) * count) % count) + count) % count;
}

/** Where the film is thinner than a limit [m]. */
export function thinner(film: Unrolled, limit: number): Strip {
  const middle: number[] = [];
  let last = 0;
  for (let k = 0; k < film.along.length; k++) {
    const by = nearestAt(film, k) - last;
    last += by - TURN * Math.round(by / TURN);
    middle.push(last);
  }
  const half = film.along.map((along, k) => {
    const size = Math.hypot(along, film.across[k] ?? 0);
    if (size === 0) return limit > film.clearance ? Math.PI : 0;
    return Math.acos(Math.max(-1, Math.min(1, (film.clearance - limit) / size)));
  });
  return { middle, half };
}

/** Outlines of a strip over one period, as often as parts of it lie within a turn from 0 on. */
export function outlines({ middle, half }: Strip, period: number): Outline[] {
  const count = middle.length;
  const found: Outline[] = [];
  // The first instant stands at the end of the period too.
  const first = middle[0] ?? 0;
  const end = first + TURN * Math.round(((middle[count - 1] ?? 0) - first) / TURN);
  const at = (k: number) => (k < count ? (middle[k] ?? 0) : end);
  const wide = (k: number) => half[k % count] ?? 0;
  for (let from = 0; from < count;) {
    if (wide(from) === 0 && wide(from + 1) === 0) {
      from += 1;
      continue;
    }
    let to = from + 1;
    while (to < count && (wide(to) > 0 || wide(to + 1) > 0)) to += 1;
    const places = Array.from({ length: to - from + 1 }, (_, k) => from + k);
    const x = places.map((k) => (period * k) / count);
    const upper = places.map((k) => at(k) + wide(k));
    const lower = places.map((k) => at(k) - wide(k));
    const least = Math.floor(Math.min(...lower) / TURN);
    const most = Math.floor(Math.max(...upper) / TURN);
    for (let turn = least; turn <= most; turn++)
      found.push({
        x: [...x, ...x.toReversed()],
        y: [...upper, ...lower.toReversed()].map((angle) => angle - TURN * turn),
      });
    from = to;
  }
  return found;
}

/** Limits of ten bands of thickness, from 0 to twice the clearance, in the unit of `clearance`: two digits that count. */
export function bandLimits(clearance: number): number[] {
  const round = (value: number) => Number(value.toPrecision(2));
  const most = 2 * clearance;
  const step = 10 ** (Math.floor(Math.log10(most)) - 1);
  return [0, ...SHARES.map((share) => round(share * clearance)), round(Math.ceil(most / step - 1e-9) * step)];
}

export interface Wear {
  /** Share of the cycle during which the film is thinner somewhere. */
  share: number;
  /** Stretches of the shell where it is thinner at any time [rad]: from, to; one over 0 ends beyond a turn. */
  stretches: [number, number][];
}

/** Where and how long a film is thinner than a limit [m]. */
export function wear(film: Unrolled, limit: number): Wear {
  const { middle, half } = thinner(film, limit);
  const worn = new Array<boolean>(PLACES).fill(false);
  const step = TURN / PLACES;
  middle.forEach((angle, k) => {
    const own = half[k] ?? 0;
    if (own === 0) return;
    for (let place = Math.round((angle - own) / step); place <= Math.round((angle + own) / step); place++)
      worn[((place % PLACES) + PLACES) % PLACES] = true;
  });
  const share = half.filter((own) => own > 0).length / Math.max(1, half.length);
  if (worn.every(Boolean)) return { share, stretches: [[0, TURN]] };
  const stretches: [number, number][] = [];
  for (let place = 0; place < PLACES; place++) {
    if (!worn[place] || worn[(place + PLACES - 1) % PLACES]) continue;
    let length = 1;
    while (worn[(place + length) % PLACES]) length += 1;
    stretches.push([place * step, (place + length - 1) * step]);
  }
  return { share, stretches };
}

/** The nearest places over the crank angle; where they go over the turn the line breaks for one instant. */
export function nearestLine(film: Unrolled, period: number): { x: number[]; y: number[] } {
  const places = film.along.map((_, k) => nearestAt(film, k));
  return {
    x: places.map((_, k) => (period * k) / places.length),
    y: places.map((own, k) => (Math.abs(own - (places[k - 1] ?? own)) > Math.PI ? NaN : own)),
  };
}

/** From angle to angle of the shell in a table [deg]. */
const COLUMNS = 10;

/** The map as a table: a row an instant, a column every ten degrees of the shell; `scale` from m to `unit`. */
export function mapTable(film: Unrolled, period: number, scale: number, unit: string): string {
  const angles = Array.from({ length: 360 / COLUMNS }, (_, k) => COLUMNS * k);
  const rows = film.along.map((_, k) => [
    (period * k * 180) / (Math.PI * film.along.length),
    ...angles.map((angle) => scale * thicknessAt(film, k, (angle * Math.PI) / 180)),
  ]);
  const head = ["Crank angle [°]", ...angles.map((angle) => `${angle}° in the shell [${unit}]`)];
  return [head, ...rows].map((row) => row.join(",")).join("\r\n") + "\r\n";
}
