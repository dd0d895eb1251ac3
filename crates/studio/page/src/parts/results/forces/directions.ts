// Directions in the words of engine builders: x stands upright in the sketch, y across, z along the crank.

import type { Component } from "./curves";

interface Direction {
  /** Beside its curve. */
  name: string;
  /** Above a plot of its own. */
  title: string;
}

export const DIRECTIONS: Record<Component, Direction> = {
  force_x: { name: "vertical (x)", title: "Vertical force (x)" },
  force_y: { name: "lateral (y)", title: "Lateral force (y)" },
  couple_x: { name: "yaw (x)", title: "Yaw couple (about x)" },
  couple_y: { name: "pitch (y)", title: "Pitch couple (about y)" },
  roll_moment: { name: "roll (z)", title: "Roll moment (about z)" },
  shaft_torque: { name: "shaft torque", title: "Shaft torque of the masses" },
};

/** Axes of paths, as seen from the free end. */
export const ALONG = {
  force: { x: "vertical (x)", y: "lateral (y)" },
  couple: { x: "yaw (x)", y: "pitch (y)" },
} as const;

/** The six motions of the block's centre, in the order of answers. */
export const MOTIONS = [
  "vertical (x)",
  "lateral (y)",
  "along the crank (z)",
  "yaw (x)",
  "pitch (y)",
  "roll (z)",
] as const;
