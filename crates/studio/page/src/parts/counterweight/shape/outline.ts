// Geometry of the drawing of a counterweight: where its handles are, and what dragging them means.
// Metres, origin on the crank axis, y up towards the weight.

import type { Dimensions } from "../../../api/types";

export type Key = keyof Dimensions;

export interface Point {
  x: number;
  y: number;
}

/** What follows from the dimensions. */
export interface Corners {
  /** Half width of the chord that the arc stands on. */
  half: number;
  /** Height of that chord. */
  chord: number;
  /** Height of the centre of the arc. */
  centre: number;
  /** Height of the top of the arc. */
  top: number;
}

export function corners(of: Dimensions): Corners {
  const chord = of.rectangle_height + of.shoulder_height;
  const centre = chord - of.arc_radius * Math.cos(of.arc_angle / 2);
  return { half: of.arc_radius * Math.sin(of.arc_angle / 2), chord, centre, top: centre + of.arc_radius };
}

const DIAGONAL = Math.SQRT1_2;
const LEAST_LENGTH = 1e-3;
const LEAST_ANGLE = Math.PI / 18;
const MOST_ANGLE = (340 * Math.PI) / 180;
const LEAST_RISE = 0.02;

/** Where the handle of a dimension is; that of the thickness is in the side view. */
export function handle(of: Dimensions, key: Key): Point {
  const { half, chord, top } = corners(of);
  switch (key) {
    case "web_radius":
      return { x: -of.web_radius * DIAGONAL, y: -of.web_radius * DIAGONAL };
    case "rectangle_height":
      return { x: 0, y: of.rectangle_height };
    case "shoulder_height":
      return { x: -half, y: chord };
    case "arc_angle":
      return { x: half, y: chord };
    case "arc_radius":
      return { x: 0, y: top };
    case "thickness":
      return { x: of.thickness, y: of.web_radius / 2 };
  }
}

/** The dimensions with one of them dragged to a point. */
export function dragged(of: Dimensions, key: Key, to: Point): Dimensions {
  return { ...of, [key]: value(of, key, to) };
}

function value(of: Dimensions, key: Key, to: Point): number {
  const { chord, centre } = corners(of);
  switch (key) {
    case "web_radius":
      return rounded(Math.max(LEAST_LENGTH, Math.hypot(to.x, to.y)));
    case "rectangle_height":
      return rounded(Math.max(0, to.y));
    case "shoulder_height":
      return rounded(Math.max(0, to.y - of.rectangle_height));
    case "arc_radius": {
      // The top rises by this much for each metre of radius; a flat arc would run away.
      const rise = Math.max(LEAST_RISE, 1 - Math.cos(of.arc_angle / 2));
      return rounded(Math.max(LEAST_LENGTH, (to.y - chord) / rise));
    }
    case "arc_angle": {
      const angle = 2 * Math.abs(Math.atan2(to.x, to.y - centre));
      const tenth = Math.PI / 1800;
      return Math.round(Math.min(MOST_ANGLE, Math.max(LEAST_ANGLE, angle)) / tenth) * tenth;
    }
    case "thickness":
      return rounded(Math.max(LEAST_LENGTH, to.x));
  }
}

/** One step of a dimension by the keyboard [m or rad]. */
export function step(key: Key): number {
  return key === "arc_angle" ? Math.PI / 180 : 0.5e-3;
}

/** The dimensions with one of them a number of steps larger. */
export function stepped(of: Dimensions, key: Key, steps: number): Dimensions {
  const least = key === "rectangle_height" || key === "shoulder_height" ? 0 : step(key);
  const most = key === "arc_angle" ? MOST_ANGLE : Infinity;
  return { ...of, [key]: Math.min(most, Math.max(least, of[key] + steps * step(key))) };
}

/** Whole hundredths of a millimetre. */
function rounded(length: number): number {
  return Math.round(length * 1e5) / 1e5;
}
