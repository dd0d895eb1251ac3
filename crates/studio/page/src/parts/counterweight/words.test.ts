import { describe, expect, it } from "vitest";
import { objective, obstacleName, verdict } from "./words";

describe("clearances", () => {
  it("are kept, just kept, too close or gone", () => {
    expect(verdict(0.004, 0.0015, true).mark).toBe("good");
    expect(verdict(0.0015, 0.0015, true)).toEqual({ mark: "warn", words: "just kept" });
    expect(verdict(0.001, 0.0015, false)).toEqual({ mark: "bad", words: "too close" });
    expect(verdict(-0.001, 0.0015, false).words).toBe("touches");
  });

  it("name what is in the way", () => {
    expect(obstacleName({ kind: "crankcase" })).toBe("crankcase");
    expect(obstacleName({ kind: "piston", cylinder: 2 })).toBe("piston 2");
  });
});

describe("objectives", () => {
  it("are read in both spellings", () => {
    expect(objective("swept-radius")).toBe("swept radius");
    expect(objective("inertia")).toBe("inertia");
  });
});
