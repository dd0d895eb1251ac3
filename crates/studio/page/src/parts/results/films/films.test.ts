import { describe, expect, it } from "vitest";
import type { BearingFilm } from "../../../api/types";
import { inShell, nameOf, remark, thickness, thinnest } from "./films";

function film(more: Partial<BearingFilm> = {}, orbit: Partial<BearingFilm["orbit"]> = {}): BearingFilm {
  return {
    kind: "main",
    crankshaft: 1,
    number: 2,
    bearing: { radius: 0.025, length: 0.02, clearance: 25e-6 },
    roughness: 0,
    heat_balanced: true,
    orbit: {
      outcome: "periodic",
      contact_time: 0,
      least_film: 5e-6,
      eccentricity: [
        [20e-6, 0],
        [0, 20e-6],
      ],
      ...orbit,
    },
    ...more,
  } as BearingFilm;
}

describe("films", () => {
  it("have the names of their bearings", () => {
    expect(nameOf(film())).toBe("main 2");
    expect(nameOf(film({ crankshaft: 2 }))).toBe("main 2 of crankshaft 2");
    expect(nameOf(film({ kind: "crankpin" }))).toBe("big end 2");
  });

  it("turn with their shell", () => {
    const still = inShell(film({ shell_angle: [0, Math.PI / 2] }));
    expect(still.along[0]).toBeCloseTo(20e-6, 12);
    expect(still.along[1]).toBeCloseTo(20e-6, 12);
    expect(still.across[1]).toBeCloseTo(0, 12);
    expect(inShell(film()).across[1]).toBeCloseTo(20e-6, 12);
  });

  it("are what the clearance leaves", () => {
    expect(thickness(film())[0]).toBeCloseTo(5e-6, 12);
  });

  it("are judged by the thinnest", () => {
    const thin = film({ number: 3 }, { least_film: 1e-6 });
    expect(thinnest([film(), thin])).toBe(thin);
    expect(thinnest([])).toBeUndefined();
  });

  it("say what is wrong with them", () => {
    expect(remark(film())).toBe("");
    expect(remark(film({}, { outcome: "overloaded" }))).toContain("overloaded");
    expect(remark(film({ roughness: 6e-6 }))).toBe("below the roughness");
    expect(remark(film({ heat_balanced: false }))).toBe("no heat balance");
  });
});
