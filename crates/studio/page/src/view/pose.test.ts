import { expect, test } from "vitest";
import type { SceneMotion } from "../api/types";
import { phase, pose } from "./pose";

const at = (motion: SceneMotion, theta: number) => pose(motion, theta, { x: 0, y: 0, z: 0, angle: 0 });

test("a share of a period, also of negative angles", () => {
  expect(phase(3, 2)).toBeCloseTo(0.5);
  expect(phase(-0.5, 2)).toBeCloseTo(0.75);
  expect(phase(-1e-20, 2)).toBe(0);
});

test("what turns goes with its ratio", () => {
  const motion: SceneMotion = { kind: "turn", x: 1, y: 2, z: 3, angle: 0.5, ratio: -2 };
  expect(at(motion, 0.25)).toEqual({ x: 1, y: 2, z: 3, angle: 0 });
});

test("what slides goes along its own axis, and from the last step to the first", () => {
  const motion: SceneMotion = {
    kind: "slide",
    x: 0,
    y: 0.1,
    z: 0.2,
    angle: Math.PI / 2,
    period: 4,
    travel: [1, 2, 3, 2],
  };
  const places = [0, 0.5, 2, 3.5, 4, 7.5].map((theta) => at(motion, theta).y);
  const wanted = [1.1, 1.6, 3.1, 1.6, 1.1, 1.6];
  places.forEach((place, index) => expect(place).toBeCloseTo(wanted[index]!, 12));
});

test("what swings has its places and its turns", () => {
  const motion: SceneMotion = {
    kind: "swing",
    x: [0, 1],
    y: [2, 4],
    z: 5,
    angle: [0.1, 0.3],
    period: 2,
  };
  const middle = at(motion, 0.5);
  expect([middle.x, middle.y, middle.z]).toEqual([0.5, 3, 5]);
  expect(middle.angle).toBeCloseTo(0.2);
});
