import { describe, expect, it } from "vitest";
import type { DeviceSummary, EngineSummary } from "../../../api/types";
import {
  amountEdit,
  apart,
  baseOf,
  counted,
  degrees,
  direction,
  directionEdit,
  directionOf,
  parted,
  roof,
  seat,
} from "./devices";

const weight: DeviceSummary = {
  name: "web 1",
  path: "counterweight[0]",
  unbalance: 0.08876,
  angle: 2.617993877991494,
  direction: 2.617993877991494,
  from_throw: 1,
  z: -0.127,
  has_part: false,
};
const shaft: DeviceSummary = {
  ...weight,
  from_throw: null,
  name: "left 1",
  path: "shaft[0].weights[1]",
  unbalance: 0,
};

describe("quantities as typed", () => {
  it("are parted into number and unit", () => {
    expect(parted("88.76 kg mm")).toEqual({ number: 88.76, unit: "kg mm" });
    expect(parted("1.5e-3kg m")).toEqual({ number: 1.5e-3, unit: "kg m" });
    expect(parted("-81.8 deg")).toEqual({ number: -81.8, unit: "deg" });
    expect(parted("heavy")).toBeUndefined();
    expect(parted(3)).toBeUndefined();
  });
});

describe("amounts", () => {
  it("keep the unit that was typed", () => {
    const base = baseOf(weight, (path) =>
      path === "counterweight[0].unbalance" ? "88.76 kg mm" : undefined,
    );
    expect(amountEdit(weight, 0.04438, base, "g mm", 1e-6)).toEqual({
      path: "counterweight[0].unbalance",
      value: "44.38 kg mm",
    });
  });

  it("of mass and radius change the mass", () => {
    const written: Record<string, string> = {
      "counterweight[0].mass": "1.5 kg",
      "counterweight[0].radius": "61 mm",
    };
    const base = baseOf(weight, (path) => written[path]);
    expect(amountEdit(weight, 0.04438, base, "g mm", 1e-6)?.value).toBe("0.75 kg");
  });

  it("of nothing are written in the unit that is shown", () => {
    expect(baseOf(shaft, () => "0 kg m")).toBeUndefined();
    expect(amountEdit(shaft, 0.0123, undefined, "g mm", 1e-6)?.value).toBe("12300 g mm");
  });

  it("have a scale with room above", () => {
    expect(roof(0.08876)).toBeCloseTo(0.1, 12);
    expect(roof(0.1)).toBeCloseTo(0.2, 12);
    expect(roof(0)).toBe(0.01);
  });
});

describe("directions", () => {
  it("lie in one turn", () => {
    expect(degrees(-Math.PI / 2)).toBe(270);
    expect(degrees(2 * Math.PI)).toBe(0);
    expect(degrees(2.617993877991494)).toBe(150);
  });

  it("are those that were typed, where they are typed in degrees", () => {
    expect(direction(weight, () => "-30 deg")).toBe(330);
    expect(direction(weight, () => "0.5 rad")).toBe(150);
    expect(direction(weight, () => undefined)).toBe(150);
  });

  it("count from the throw, also where nothing is typed", () => {
    // Opposite its throw, which stands at 240 degrees.
    const third = { ...weight, name: "throw 3", angle: Math.PI / 3, direction: Math.PI, from_throw: 3 };
    expect(direction(third, () => undefined)).toBe(180);
    expect(counted(third).words).toBe("from the throw");
    expect(directionOf("throw 3", Math.PI / 3 + 0.01, [weight, third])).toEqual({
      degrees: 180.6,
      from: "from throw",
    });
    expect(directionOf("throw 4", 0, [third])).toBeUndefined();
    expect(counted(shaft).short).toBe("from x");
    expect(counted({ ...weight, from_throw: null }).short).toBe("from zero");
  });

  it("go into the key of the device", () => {
    expect(directionEdit(weight, 151.5)).toEqual({ path: "counterweight[0].angle", value: "151.5 deg" });
    expect(directionEdit(shaft, 0)?.path).toBe("shaft[0].weights[1].phase");
  });
});

describe("the short form", () => {
  it("comes apart into entries on the same webs", () => {
    const short = { ...weight, path: null, name: "web 3", unbalance: 0.023002666666666668, angle: 0 };
    const engine = { counterweights: [short] } as unknown as EngineSummary;
    expect(apart(engine)).toEqual([
      { path: "counterweights", value: null },
      { path: "counterweight[0]", value: { web: 3, unbalance: "23002.6667 g mm", angle: "180 deg" } },
    ]);
  });

  it("tells where entries stand", () => {
    expect(seat(weight, (path) => (path === "counterweight[0].web" ? 1 : undefined))).toBe("web 1");
    expect(seat(weight, () => undefined)).toBe("");
  });
});
