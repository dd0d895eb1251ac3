import { describe, expect, it } from "vitest";
import type { DeviceSummary } from "../../api/types";
import {
  bodyEdits,
  bodyStart,
  clearanceStart,
  halvedOntoWebs,
  shapesStart,
  websOf,
  type Sizes,
} from "./start";

const four: Sizes = {
  bore: 0.0825,
  stroke: 0.0928,
  bottom: 0.0976,
  webDistance: 0.044,
  narrowest: 0.044,
  rods: 1,
};
const web = (number: number, z: number) => ({ name: `web ${number}`, z }) as DeviceSummary;
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
    expect(bodyEdits(four, [])).toHaveLength(1);
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
    expect(halvedOntoWebs([weight(0)], written(file))).toEqual([
      { path: "counterweight[0].web", value: 5 },
      { path: "counterweight[0].throw", value: null },
      { path: "counterweight[0].unbalance", value: "0.022302904645 kg m" },
      { path: "counterweight[0].name", value: null },
      { path: "counterweight[1]", value: { web: 6, unbalance: "0.022302904645 kg m", angle: "210 deg" } },
    ]);
  });

  it("are left alone where one stands elsewhere", () => {
    const file = { "counterweight[0].z": "0 mm", "counterweight[0].unbalance": "1 kg mm" };
    expect(halvedOntoWebs([weight(0)], written(file))).toBeUndefined();
    expect(halvedOntoWebs([], written({}))).toBeUndefined();
  });
});

describe("distances of webs", () => {
  it("come from weights on neighbouring webs", () => {
    const found = websOf([web(1, -0.066), web(2, -0.022), web(3, 0.01), web(4, 0.054)]);
    expect(found?.distance).toBeCloseTo(0.044, 12);
    expect(found?.narrowest).toBeCloseTo(0.032, 12);
  });

  it("are not known from weights elsewhere", () => {
    expect(websOf([web(2, 0), { name: "flywheel", z: 0.1 } as DeviceSummary])).toBeUndefined();
  });
});
