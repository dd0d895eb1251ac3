import { expect, it } from "vitest";
import { sharpEdges } from "./edges";

it("finds the edge of a roof, and none within a flat side", () => {
  // A roof of two squares along y, each of two triangles.
  const nodes = new Float32Array([0, 0, 0, 1, 0, 1, 2, 0, 0, 0, 1, 0, 1, 1, 1, 2, 1, 0]);
  const triangles = new Uint32Array([0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4]);
  expect([...sharpEdges({ nodes, triangles })].sort()).toEqual([1, 4]);
});
