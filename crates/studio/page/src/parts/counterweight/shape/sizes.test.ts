import { describe, expect, it } from "vitest";
import type { Cylinder, Shape, Throw } from "../../engine/sketch/geometry";
import { sizesOf } from "./sizes";

const pin = (z: number, web: number): Throw => ({ crankshaft: 0, angle: 0, z, radius: 0.04, web });
const cylinder = (at: number, more: Partial<Cylinder> = {}): Cylinder => ({
  number: at + 1,
  throw: at,
  angle: 0,
  z: 0,
  offset: 0,
  bore: 0.08,
  rod: 0.15,
  knuckle: 0,
  ...more,
});
const engine = (throws: Throw[], cylinders: Cylinder[]): Shape => ({
  crankshafts: [],
  throws,
  cylinders,
  shafts: [],
  weights: [],
});

describe("sizes", () => {
  it("come from bore, throws and rods", () => {
    const found = sizesOf(engine([pin(-0.05, 0.04), pin(0.05, 0.04)], [cylinder(0), cylinder(1)]));
    expect(found).toMatchObject({ bore: 0.08, stroke: 0.08, webDistance: 0.04, rods: 1, free: [1, 2, 3, 4] });
    expect(found?.bottom).toBeCloseTo(0.11, 12);
    expect(found?.narrowest).toBeCloseTo(0.04, 12);
  });

  it("leave one web between pins that stand close", () => {
    const found = sizesOf(engine([pin(-0.015, 0.027), pin(0.015, 0.027)], [cylinder(0), cylinder(1)]));
    expect(found?.webDistance).toBeCloseTo(0.03, 12);
    expect(found?.narrowest).toBeCloseTo(0.03, 12);
    expect(found?.free).toEqual([1, 4]);
  });

  it("find a distance of webs where the file has none", () => {
    expect(sizesOf(engine([pin(0, 0)], [cylinder(0)]))?.webDistance).toBeCloseTo(0.04, 12);
  });

  it("count articulated rods with their master", () => {
    const hung = [1, 2].map((at) => cylinder(at, { throw: 0, knuckle: 0.03 }));
    expect(sizesOf(engine([pin(0, 0.06)], [cylinder(0), ...hung]))).toMatchObject({ rods: 1, knuckle: 0.03 });
  });

  it("are none without a bore", () => {
    expect(sizesOf(engine([pin(0, 0.04)], [cylinder(0, { bore: 0 })]))).toBeUndefined();
  });
});
