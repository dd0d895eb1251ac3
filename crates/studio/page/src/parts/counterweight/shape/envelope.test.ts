import { describe, expect, it } from "vitest";
import type { Clearances, Obstacle, BodyClearances } from "../../../api/types";
import { ringsOf } from "./envelope";

type PartClearance = BodyClearances["clearances"][number];

function near(obstacle: Obstacle, distance: number, at: number): PartClearance {
  return {
    obstacle,
    distance,
    bound: distance,
    theta: 0,
    on_body: [0, 0, 0],
    on_obstacle: [at, 0, 0.1],
    overlap: null,
    is_kept: distance > 0.0015,
  };
}
const clearances: Clearances = {
  version: 1,
  least: 0.0015,
  bodies: [
    {
      name: "web 1",
      crankshaft: 0,
      faces: [-0.1, 0.1],
      swept_radius: 0.09,
      chamfers_ignored: false,
      clearances: [
        near({ kind: "crankcase" }, 0.01, 0.1),
        near({ kind: "piston", cylinder: 1 }, 0.001, 0.0925),
        near({ kind: "piston", cylinder: 2 }, 0.03, 0.12),
        near({ kind: "rod", cylinder: 1 }, 0.002, 0.05),
      ],
    },
  ],
  big_ends: [],
  smallest: null,
  is_kept: false,
} as Clearances;

describe("the envelope", () => {
  it("has the crankcase and the nearest piston", () => {
    expect(ringsOf(clearances, "web 1")).toEqual([
      { name: "crankcase", radius: expect.closeTo(0.1, 9) as number, wall: true, kept: true },
      { name: "piston 1", radius: 0.0925, wall: false, kept: false },
    ]);
  });

  it("is empty where nothing is told", () => {
    expect(ringsOf(undefined, "web 1")).toEqual([]);
    expect(ringsOf(clearances, "web 9")).toEqual([]);
  });
});
