import { describe, expect, it } from "vitest";
import type { FileEntry } from "../../../api/types";
import { banks, directions, extent, lines, shape, si, turn } from "./geometry";
import type { Json } from "../text/written";

const entries = (values: Record<string, Json>): FileEntry[] =>
  Object.entries(values).map(([path, value]) => ({ path, value, span: { start: 0, end: 0 } }));

const twin = entries({
  "crankshaft[0].name": "crankshaft",
  "throw[0].angle": "0 deg",
  "throw[0].z": "-40 mm",
  "throw[0].radius": "45 mm",
  "throw[1].angle": "360 deg",
  "throw[1].z": "40 mm",
  "throw[1].radius": "45 mm",
  "throw[1].web_distance": "30 mm",
  "cylinder[0].number": 1,
  "cylinder[0].throw": 1,
  "cylinder[0].angle": "-30 deg",
  "cylinder[0].rod.length": "150 mm",
  "cylinder[1].number": 2,
  "cylinder[1].throw": 2,
  "cylinder[1].angle": "330 deg",
  "cylinder[1].z": "41 mm",
  "shaft[0].name": "left",
  "shaft[0].ratio": "-1/2",
});

describe("si", () => {
  it("reads what the program writes, and nothing else", () => {
    expect(si("41.4 mm")).toBeCloseTo(0.0414, 12);
    expect(si("180 deg")).toBeCloseTo(Math.PI, 12);
    expect(si("3.2 in")).toBeUndefined();
    expect(si("mm")).toBeUndefined();
  });
});

describe("shape", () => {
  it("has throws, cylinders in their planes, and shafts", () => {
    const got = shape(twin);
    expect(got?.throws[1]).toMatchObject({ z: 0.04, radius: 0.045, web: 0.03, crankshaft: 0 });
    expect(got?.cylinders.map((one) => one.z)).toEqual([-0.04, 0.041]);
    expect(got?.shafts).toEqual([{ name: "left", x: 0, y: 0, ratio: -0.5 }]);
  });

  it("is nothing without a crank", () => {
    expect(shape(entries({ name: "x" }))).toBeUndefined();
  });

  it("has one bank where angles differ by a turn", () => {
    const got = shape(twin);
    expect(got && banks(got).map((bank) => bank.cylinders.length)).toEqual([2]);
    expect(got && directions(got, 0).map((one) => one.numbers)).toEqual([[1, 2]]);
  });
});

describe("turn", () => {
  it("stays within half a turn", () => {
    expect(turn((3 * Math.PI) / 2)).toBeCloseTo(-Math.PI / 2, 12);
  });
});

describe("extent", () => {
  it("holds crank circles, cylinders and shafts", () => {
    const got = shape(twin);
    const box = got && extent({ ...got, shafts: [{ name: "far", x: -0.45, y: 0.09, ratio: 1 }] }, 0.045);
    expect(box?.x[0]).toBeCloseTo(-10.5, 9);
    expect(box?.x[1]).toBeCloseTo(2.5 * Math.cos(Math.PI / 6) + 0.75, 9);
    expect(box?.y).toEqual([expect.closeTo(-2, 9), expect.closeTo(2.5, 9)]);
  });
});

describe("lines", () => {
  it("of three numbers", () => {
    expect(lines([1, 2, 3, 4])).toEqual(["1 2 3", "4"]);
  });
});
