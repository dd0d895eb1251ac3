import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { describe, expect, it } from "vitest";
import type { TemplateInfo } from "../../api/types";
import { entries, find } from "./find";
import { usualNames } from "./gallery";
import { holds } from "./words";

/** Names and titles as the program has them. */
const GALLERY = [
  ...readFileSync(resolve("../../file/src/template.rs"), "utf8").matchAll(/^ {4}"([\w-]+)": "([^"]+)",$/gm),
].map(([, name = "", title = ""]) => ({ name, title, text: "" }) as TemplateInfo);

const found = (wanted: string) =>
  GALLERY.filter(({ name, title }) => holds(`${title} ${name} ${usualNames(name)}`, wanted)).map(
    ({ name }) => name,
  );

describe("the gallery", () => {
  it("has usual names for every engine", () => {
    expect(GALLERY.length).toBeGreaterThan(40);
    for (const { name } of GALLERY) expect(usualNames(name), name).toMatch(/\w+ \w+/);
  });

  it.each([
    ["inline four", "in-line-4"],
    ["straight six", "in-line-6"],
    ["I4", "in-line-4"],
    ["inline 6", "in-line-6"],
    ["parallel twin", "twin-270"],
    ["V-8", "v8-crossplane"],
    ["v eight", "v8-flat-plane"],
    ["V-twin", "v2-90"],
    ["flat six", "boxer-6"],
    ["flat twin", "boxer-2"],
    ["H4", "boxer-4"],
    ["Harley", "v2-45"],
    ["Porsche", "boxer-6"],
    ["Ducati", "v2-90"],
    ["Subaru", "boxer-4"],
    ["diesel", "in-line-6"],
    ["motorcycle", "single"],
    ["motorbikes", "v2-45"],
    ["truck", "in-line-6"],
    ["aircraft", "radial-9"],
    ["airplane", "boxer-4"],
    ["two cylinders", "twin-180"],
    ["triple", "in-line-3"],
  ])("finds %s", (wanted, name) => {
    expect(found(wanted)).toContain(name);
  });

  it("is not found whole by any of them", () => {
    for (const wanted of ["inline", "flat six", "Harley", "diesel", "motorcycle", "aircraft", "car"])
      expect(found(wanted).length, wanted).toBeLessThan(GALLERY.length * 0.8);
    expect(found("Harley")).toEqual(["v2-45"]);
    expect(found("straight six")).toEqual(["in-line-6"]);
    expect(found("I4")).toEqual(["in-line-4", "in-line-4-lanchester", "in-line-4-crossplane"]);
    expect(found("flat six")).toEqual(["boxer-6"]);
  });
});

describe("the search of the studio", () => {
  const all = entries(GALLERY, []);
  const names = (wanted: string) => find(all, wanted).map(({ name }) => name);

  it("finds engines by them too", () => {
    expect(names("Ducati")).toEqual(["V-twin, 90 degrees, shared pin"]);
  });

  it("finds every term of the glossary, and the ratio of crank and rod by both of its names", () => {
    const glossary =
      readFileSync(resolve("../../../docs/src/theory/conventions.md"), "utf8").split("## Glossary")[1] ?? "";
    const rows = [...glossary.matchAll(/^\| ([^|]+) \|/gm)].map(([, term = ""]) => term).slice(2);
    expect(rows.length).toBeGreaterThan(25);
    const terms = entries([], []);
    for (const term of rows.flatMap((row) => row.split(", ")))
      expect(
        find(terms, term).map(({ name }) => name),
        term,
      ).not.toEqual([]);
    for (const wanted of ["rod ratio", "lambda", "crank-to-rod ratio"])
      expect(names(wanted)[0], wanted).toBe("Crank-to-rod ratio");
    expect(names("wrist pin")[0]).toBe("Piston pin");
    expect(names("TDC")[0]).toBe("Dead centre");
  });
});
