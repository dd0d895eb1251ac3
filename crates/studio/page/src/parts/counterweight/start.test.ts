import { describe, expect, it } from "vitest";
import type { DeviceSummary } from "../../api/types";
import { bodyEdits, bodyStart, clearanceStart, onFreeWebs, ontoWebs, shapesStart } from "./start";
import type { Sizes } from "./shape/sizes";

const four: Sizes = {
  bore: 0.0825,
  stroke: 0.0928,
  bottom: 0.0976,
  webDistance: 0.044,
  narrowest: 0.044,
  rods: 1,
  knuckle: 0,
  free: [1, 2, 3, 4, 5, 6, 7, 8],
};
const number = (size: unknown) => Number(String(size).split(" ")[0]);

describe("sections to start from", () => {
  it("keep journal, pin and web within one another", () => {
    const body = bodyStart(four);
    expect(number(body.journal_diameter) / 2).toBeLessThan(number(body.web_radius));
    expect(number(body.pin_diameter) / 2).toBeLessThan(number(body.pin_end_radius));
    expect(number(body.web_thickness)).toBeLessThan(1e3 * four.narrowest);
    expect(shapesStart(four).thickness).toBe(body.web_thickness);
  });

  it("leave the big end room between the webs", () => {
    const width = number(clearanceStart(four).big_end_width);
    expect(width).toBeGreaterThan(4);
    expect(width).toBeLessThan(44 - number(bodyStart(four).web_thickness));
  });

  it("take the place of masses of the throw", () => {
    const entries = [
      { path: "crank.pin_mass", value: "0.4 kg", span: { start: 0, end: 0 }, line: 1, column: 1 },
    ];
    expect(bodyEdits(four, entries)[0]).toEqual({ path: "crank.pin_mass", value: null });
    const there = {
      path: "crank.web_distance",
      value: "44 mm",
      span: { start: 0, end: 0 },
      line: 1,
      column: 1,
    };
    expect(bodyEdits(four, [there])).toHaveLength(1);
    expect(bodyEdits(four, [])[0]).toEqual({ path: "crank.web_distance", value: "44 mm" });
  });
});

describe("weights at throws", () => {
  const weight = (index: number) =>
    ({ name: `throw ${index + 1}`, path: `counterweight[${index}]`, unbalance: 0.04 }) as DeviceSummary;
  const written = (file: Record<string, unknown>) => (path: string) => file[path];

  it("become two halves on the webs beside the pin", () => {
    const file = {
      "counterweight[0].throw": 3,
      "counterweight[0].unbalance": "0.04460580929 kg m",
      "counterweight[0].angle": "210 deg",
    };
    expect(ontoWebs([weight(0)], written(file), [5, 6])).toEqual([
      { path: "counterweight[0].web", value: 5 },
      { path: "counterweight[0].throw", value: null },
      { path: "counterweight[0].unbalance", value: "0.022302904645 kg m" },
      { path: "counterweight[0].name", value: null },
      { path: "counterweight[1]", value: { web: 6, unbalance: "0.022302904645 kg m", angle: "210 deg" } },
    ]);
  });

  it("are left alone where one stands elsewhere", () => {
    const file = { "counterweight[0].z": "0 mm", "counterweight[0].unbalance": "1 kg mm" };
    expect(ontoWebs([weight(0)], written(file), [])).toBeUndefined();
    expect(ontoWebs([], written({}), [])).toBeUndefined();
  });
});

describe("a web between two pins", () => {
  const short = (web: number) => ({ name: `web ${web}`, path: null, unbalance: 0.02 }) as DeviceSummary;

  it("has no weight: that of the throw stands on its other web alone", () => {
    const found = onFreeWebs([1, 2, 3, 4].map(short), [1, 4]);
    expect(found.map((weight) => [weight.name, weight.unbalance])).toEqual([
      ["web 1", 0.04],
      ["web 4", 0.04],
    ]);
    const file = { "counterweight[0].throw": 1, "counterweight[0].unbalance": "40 g mm" };
    const weight = { name: "throw 1", path: "counterweight[0]", unbalance: 4e-5 } as DeviceSummary;
    expect(ontoWebs([weight], (path) => (file as Record<string, unknown>)[path], [1, 4])).toEqual([
      { path: "counterweight[0].web", value: 1 },
      { path: "counterweight[0].throw", value: null },
      { path: "counterweight[0].unbalance", value: "40 g mm" },
      { path: "counterweight[0].name", value: null },
    ]);
  });

  it("has one where the throw has no other web", () => {
    expect(onFreeWebs([1, 2].map(short), []).map((weight) => weight.unbalance)).toEqual([0.02, 0.02]);
  });
});
