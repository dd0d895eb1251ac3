import { describe, expect, it } from "vitest";
import type { KeyTable, TemplateInfo } from "../../api/types";
import { entries, find } from "./find";
import { holds } from "./words";

const template = (name: string, title: string) => ({ name, title, text: "" }) as TemplateInfo;
const tables = [
  {
    path: "layout",
    doc: "",
    keys: [{ name: "spacing", doc: "Distance of neighbouring cylinders of a bank." }],
  },
  { path: "cylinder[]", doc: "", keys: [{ name: "offset", doc: "" }] },
] as unknown as KeyTable[];
const all = entries(
  [
    template("in-line-3-shaft", "in-line three with a balance shaft"),
    template("in-line-4-two-shafts", "in-line four with two second-order shafts"),
    template("v8-crossplane", "V8, 90 degrees, crossplane"),
  ],
  tables,
);
const names = (wanted: string) => find(all, wanted).map(({ name }) => name);

describe("the search", () => {
  it("finds balance shafts as a term, in engines and where they are set", () => {
    expect(names("balance shafts")).toEqual(
      expect.arrayContaining([
        "Balance shaft",
        "in-line three with a balance shaft",
        "Balance",
        "Explore layouts",
      ]),
    );
    expect(names("balance shafts")[0]).toBe("Balance shaft");
  });
  it("finds the spacing of cylinders as a term and as a number of the file", () => {
    expect(names("cylinder spacing")).toEqual(expect.arrayContaining(["Cylinder spacing", "layout.spacing"]));
    expect(names("spacing")).toContain("layout.spacing");
  });
  it("finds oil films among the results and terms", () => {
    expect(names("oil films")).toEqual(expect.arrayContaining(["Oil films", "Oil film"]));
    expect(names("OIL-FILM")).toContain("Oil films");
  });
  it("needs every word, and finds nothing for none", () => {
    expect(names("crossplane boxer")).toEqual([]);
    expect(names("crossplane")).toEqual(["V8, 90 degrees, crossplane"]);
    expect(names("  ")).toEqual([]);
  });
  it("of the gallery finds one of what is asked for in the plural", () => {
    expect(holds("in-line three with a balance shaft", "balance shafts")).toBe(true);
    expect(holds("V6, 60 degrees", "v6 crosses")).toBe(false);
  });
  it("has no entries of lists: they have no field of their own", () => {
    expect(all.some(({ name }) => name.includes("[]"))).toBe(false);
  });
});
