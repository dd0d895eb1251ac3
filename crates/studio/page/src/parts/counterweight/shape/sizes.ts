// Sizes of an engine that its crankshaft follows from, out of the general form of its file.

import type { Shape, Throw } from "../../engine/sketch/geometry";

/** What the engine tells of itself [m]. */
export interface Sizes {
  bore: number;
  stroke: number;
  /** From the crank axis to the piston pin at bottom dead centre. */
  bottom: number;
  /** Between the middles of a throw's two webs. */
  webDistance: number;
  /** The smallest distance of the middles of any two neighbouring webs. */
  narrowest: number;
  /** Rods on a crankpin; articulated ones hang on their master. */
  rods: number;
  /** From the crankpin to the farthest knuckle pin; 0 without articulated rods. */
  knuckle: number;
  /** Webs that stand between two journals or at an end, counted through all throws from 1: they carry weights. */
  free: readonly number[];
}

/** Webs nearer to those of the next throw than this part of the bore become one web between both pins. */
const NEAR = 0.12;

/** `undefined` where no bore is known. */
export function sizesOf(shape: Shape): Sizes | undefined {
  const bore = Math.max(...shape.cylinders.map((cylinder) => cylinder.bore));
  if (!(bore > 0)) return undefined;
  const stroke = 2 * Math.max(...shape.throws.map((one) => one.radius));
  const bottoms = shape.cylinders.map((cylinder) => {
    const { radius = 0 } = shape.throws[cylinder.throw] ?? {};
    return Math.sqrt(Math.max(0, (cylinder.rod - radius) ** 2 - cylinder.offset ** 2));
  });
  const masters = shape.cylinders.filter((cylinder) => cylinder.knuckle === 0);
  const rods = shape.throws.map((_, at) => masters.filter((cylinder) => cylinder.throw === at).length);
  return {
    bore,
    stroke,
    bottom: Math.min(...bottoms),
    ...webs(shape, bore),
    rods: Math.max(1, ...rods),
    knuckle: Math.max(...shape.cylinders.map((cylinder) => cylinder.knuckle)),
  };
}

/** Pairs of throws that follow each other on one crankshaft, with the distance of their planes. */
function pairs(throws: readonly Throw[]): { front: number; rear: number; apart: number }[] {
  const sorted = throws
    .map((one, at) => ({ at, ...one }))
    .sort((a, b) => a.crankshaft - b.crankshaft || a.z - b.z);
  return sorted.slice(1).flatMap((rear, before) => {
    const front = sorted[before];
    if (!front || front.crankshaft !== rear.crankshaft) return [];
    return [{ front: front.at, rear: rear.at, apart: rear.z - front.z }];
  });
}

/** The web distance of the file, or one that leaves one web between pins where there is no room for two. */
function webs(shape: Shape, bore: number): Pick<Sizes, "webDistance" | "narrowest" | "free"> {
  const beside = pairs(shape.throws);
  const written = Math.min(...shape.throws.map((one) => one.web));
  const nearest = Math.min(...beside.map((pair) => pair.apart));
  const wanted = written > 0 ? written : Math.min(0.5 * bore, 0.5 * nearest);
  const crowded = nearest - wanted < NEAR * bore;
  const webDistance = crowded ? nearest : wanted;
  const gaps = beside.map((pair) => pair.apart - webDistance).filter((gap) => gap > 0);
  const shared = beside
    .filter((pair) => pair.apart <= webDistance)
    .flatMap((pair) => [2 * pair.front + 2, 2 * pair.rear + 1]);
  const all = shape.throws.flatMap((_, at) => [2 * at + 1, 2 * at + 2]);
  return {
    webDistance,
    narrowest: Math.min(webDistance, ...gaps),
    free: all.filter((web) => !shared.includes(web)),
  };
}
