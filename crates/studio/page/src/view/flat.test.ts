import { expect, test } from "vitest";
import type { Scene } from "../api/types";
import { FlatScene, bounds, hull } from "./flat";

test("the hull leaves out what is within and on its edges", () => {
  const square: [number, number][] = [
    [0, 0],
    [2, 0],
    [1, 0],
    [2, 2],
    [0, 2],
    [1, 1],
  ];
  expect(hull(square)).toEqual([
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
  ]);
});

test("a pin goes round, and mirrored engines go the other way", () => {
  const scene: Scene = {
    mirrored: false,
    period: 2 * Math.PI,
    steps: 4,
    meshes: [
      {
        positions: [1, 0, 0, 1.2, 0, 0, 1, 0.1, 0.5],
        normals: [0, 0, 1, 0, 0, 1, 0, 0, 1],
        indices: [0, 1, 2],
      },
    ],
    parts: [
      {
        name: "pin 1",
        kind: "crankpin",
        path: null,
        cylinder: null,
        weight: null,
        mesh: 0,
        motion: { kind: "turn", x: 0, y: 0, z: 0, angle: 0, ratio: 1 },
      },
    ],
  };
  const of = (mirrored: boolean) => {
    const [left, bottom, width, height] = bounds(
      new FlatScene({ ...scene, mirrored }).outlines(Math.PI / 2, "front", new Set()),
    );
    return [left, bottom, width, height].map((value) => Math.round(value * 1e9) / 1e9 + 0);
  };
  expect(of(false)).toEqual([1, -0.1, 0.2, 0.1]);
  expect(of(true)).toEqual([-1.2, -0.1, 0.2, 0.1]);
  expect(new FlatScene(scene).outlines(0, "side", new Set(["pin"]))).toEqual([]);
});
