import { describe, expect, it } from "vitest";
import type { Dimensions } from "../../../api/types";
import { corners, dragged, handle, stepped, type Key } from "./outline";

const shape: Dimensions = {
  web_radius: 0.046,
  rectangle_height: 0.02,
  shoulder_height: 0.01,
  arc_radius: 0.09,
  arc_angle: (150 * Math.PI) / 180,
  thickness: 0.026,
};
const KEYS = Object.keys(shape) as Key[];

describe("the outline", () => {
  it("has its arc on the chord", () => {
    const { half, chord, centre, top } = corners(shape);
    expect(chord).toBeCloseTo(0.03, 12);
    expect(Math.hypot(half, chord - centre)).toBeCloseTo(shape.arc_radius, 12);
    expect(top - centre).toBeCloseTo(shape.arc_radius, 12);
  });

  it("stays as it is when a handle is dragged to where it is", () => {
    for (const key of KEYS) expect(dragged(shape, key, handle(shape, key))[key]).toBeCloseTo(shape[key], 5);
  });

  it("puts the handle under the pointer", () => {
    const up = (key: Key, by: number) => {
      const at = handle(shape, key);
      const to = { x: at.x, y: at.y + by };
      return { to, at: handle(dragged(shape, key, to), key) };
    };
    for (const key of ["arc_radius", "rectangle_height", "shoulder_height"] as const) {
      const { to, at } = up(key, 0.004);
      expect(at.y).toBeCloseTo(to.y, 4);
    }
  });

  it("has no negative heights and no turned arc", () => {
    expect(dragged(shape, "rectangle_height", { x: 0, y: -1 }).rectangle_height).toBe(0);
    expect(dragged(shape, "arc_angle", { x: 0, y: 9 }).arc_angle).toBeCloseTo(Math.PI / 18, 3);
    expect(stepped(shape, "shoulder_height", -1000).shoulder_height).toBe(0);
  });
});
