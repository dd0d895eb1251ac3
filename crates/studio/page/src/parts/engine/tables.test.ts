import { describe, expect, it } from "vitest";
import type { Entry, TableInfo } from "../../api/types";
import { Tables, children, count, label, present } from "./tables";

const key = (name: string) => ({
  name,
  doc: "",
  wanted: "",
  kind: "quantity",
  dimension: null,
  choices: [],
  required: false,
  layouts: [],
  example: "",
});
const tables = new Tables([
  { path: "", doc: "", keys: [key("crank"), key("shaft")] },
  { path: "crank", doc: "", keys: [key("stroke"), key("body")] },
  { path: "crank.body", doc: "", keys: [key("density")] },
  { path: "shaft[]", doc: "", keys: [key("weights")] },
  { path: "shaft[].weights[]", doc: "", keys: [key("z")] },
] satisfies TableInfo[]);

const entries = ["crank.stroke", "crank.body.density", "shaft[0].weights[0].z", "shaft[1].weights[10].z"].map(
  (path): Entry => ({ path, value: "", start: 0, end: 0, line: 1 }),
);

describe("Tables", () => {
  it("finds keys within lists", () => {
    expect(tables.key("shaft[3].weights[12].z")?.name).toBe("z");
    expect(tables.key("crank.stroke")?.name).toBe("stroke");
    expect(tables.key("crank.strok")).toBeUndefined();
  });

  it("tells tables, lists and values", () => {
    expect(tables.shape("crank.body")).toBe("table");
    expect(tables.shape("shaft")).toBe("list");
    expect(tables.shape("shaft[0].weights")).toBe("list");
    expect(tables.shape("crank.stroke")).toBe("value");
  });
});

describe("what stands in the file", () => {
  it("by table and by list", () => {
    expect(children(entries, "")).toEqual(["crank", "shaft"]);
    expect(children(entries, "crank")).toEqual(["stroke", "body"]);
    expect(children(entries, "shaft[1]")).toEqual(["weights"]);
    expect(count(entries, "shaft")).toBe(2);
    expect(count(entries, "shaft[1].weights")).toBe(11);
    expect(count(entries, "mount")).toBe(0);
    expect(present(entries, "crank.body")).toBe(true);
    expect(present(entries, "crank.bod")).toBe(false);
  });
});

describe("label", () => {
  it("reads as words", () => {
    expect(label("big_end_mass")).toBe("Big end mass");
    expect(label("z")).toBe("z");
  });
});
