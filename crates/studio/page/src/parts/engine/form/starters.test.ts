import { describe, expect, it } from "vitest";
import type { FileEntry, KeyTable } from "../../../api/types";
import { starter, tree } from "./starters";
import type { Json } from "../text/written";

const entries = (values: Record<string, Json>): FileEntry[] =>
  Object.entries(values).map(([path, value]) => ({ path, value, span: { start: 0, end: 0 } }));

const table = (path: string): KeyTable => ({
  path,
  doc: "",
  keys: [
    {
      name: "angle",
      doc: "",
      wanted: "an angle with its unit",
      kind: "quantity",
      choices: [],
      required: true,
      layouts: [],
      example: '"-60 deg"',
    },
  ],
});

describe("starter", () => {
  const shafts = entries({
    "shaft[0].name": "left",
    "shaft[0].ratio": -1,
    "shaft[0].weights[0].z": "0 mm",
    "shaft[0].weights[1].z": "10 mm",
    "shaft[0].weights[1].shape.radius": "20 mm",
  });

  it("reads a table with lists in it", () => {
    expect(tree(shafts, "shaft[0]")).toEqual({
      name: "left",
      ratio: -1,
      weights: [{ z: "0 mm" }, { z: "10 mm", shape: { radius: "20 mm" } }],
    });
  });

  it("copies the last entry without its name", () => {
    expect(starter(shafts, "shaft", table("shaft[]"))).not.toHaveProperty("name");
    expect(starter(shafts, "shaft[0].weights", table("shaft[].weights[]"))).toEqual({
      z: "10 mm",
      shape: { radius: "20 mm" },
    });
  });

  it("counts numbers on", () => {
    const cylinders = entries({ "cylinder[0].number": 2, "cylinder[0].bore": "80 mm" });
    expect(starter(cylinders, "cylinder", table("cylinder[]"))).toEqual({ number: 3, bore: "80 mm" });
  });

  it("begins with what is needed", () => {
    expect(starter([], "layout.banks", table("layout.banks[]"))).toEqual({ angle: "-60 deg" });
    expect(starter([], "counterweight", table("counterweight[]"))).toEqual({ throw: 1, unbalance: "0 kg m" });
  });
});
