import { describe, expect, it } from "vitest";
import type { FileEntry, KeyTable, PlacedDiagnostic, Reading } from "../../../api/types";
import { Tables, children, count, label, missed, present, split, subject } from "./tables";

const key = (name: string) => ({
  name,
  doc: "",
  wanted: "",
  kind: "quantity",
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
] satisfies KeyTable[]);

const entries = ["crank.stroke", "crank.body.density", "shaft[0].weights[0].z", "shaft[1].weights[10].z"].map(
  (path): FileEntry => ({ path, value: "", span: { start: 0, end: 0 } }),
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

describe("split", () => {
  it("keeps quoted names whole", () => {
    expect(split("crank.body.density")).toEqual({ parent: "crank.body", name: "density" });
    expect(split("name")).toEqual({ parent: "", name: "name" });
    expect(split('balance.limits."force order 0.5"')).toEqual({
      parent: "balance.limits",
      name: '"force order 0.5"',
    });
  });
});

describe("subject", () => {
  const text = 'name = "x"\n[rod]\nmass = "1 kg"\n[[shaft]]\nx = "0 mm"\n[[shaft]]\ny = "0 mm"\n';
  const at = (path: string, value: string, from = 0): FileEntry => {
    const start = text.indexOf(value, from);
    return { path, value, span: { start, end: start + value.length } };
  };
  const second = text.lastIndexOf("[[shaft]]");
  const reading = {
    text,
    entries: [
      at("name", '"x"'),
      at("rod.mass", '"1 kg"'),
      at("shaft[0].x", '"0 mm"'),
      at("shaft[1].y", '"0 mm"', second),
    ],
  } as unknown as Reading;
  const about = (path: string | null, start: number) =>
    subject(reading, { path, span: { start, end: start } } as unknown as PlacedDiagnostic);

  it("is the value at its place, or the key on the same line", () => {
    expect(about("rod.mass", text.indexOf('"1 kg"'))).toBe("rod.mass");
    expect(about("rod.mass", text.indexOf("mass"))).toBe("rod.mass");
  });

  it("is the table whose header it stands at, and not the first key in it", () => {
    expect(about("rod.mass", text.indexOf("[rod]"))).toBe("rod");
    expect(about("shaft[1].y", second)).toBe("shaft[1]");
  });

  it("is nothing where only the file as a whole is meant", () => {
    expect(about(null, 3)).toBeNull();
  });
});

describe("missed", () => {
  it("is the key that a table lacks", () => {
    expect(missed("`damping` is missing in [damper]")).toBe("damping");
    expect(missed("`ratio` is missing in [[shaft]]")).toBe("ratio");
    expect(missed("the flank is missing in [counterweight_design]")).toBeUndefined();
  });
});
