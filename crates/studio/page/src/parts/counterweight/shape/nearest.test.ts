import { describe, expect, it } from "vitest";
import type { NearestLimit, SweptRoom } from "../../../api/types";
import { eased, easedWords } from "./nearest";

const written = (file: Record<string, unknown>) => (path: string) => file[path];
const limit = (name: NearestLimit["limit"], asked: number, nearest: number): NearestLimit => ({
  limit: name,
  asked,
  nearest,
});
const room = (kind: "crankcase" | "piston"): SweptRoom => ({
  least: 0.0015,
  limit: kind === "crankcase" ? { kind } : { kind, cylinder: 1 },
  radius: 0.077,
  theta: null,
});

describe("a limit that gives way", () => {
  it("keeps the unit that was typed and is rounded to the side that can be met", () => {
    const file = { "counterweight_design.limits.mass": "900 g" };
    expect(eased(limit("mass", 0.9, 1.23411), written(file), null)).toEqual({
      path: "counterweight_design.limits.mass",
      value: "1235 g",
    });
  });

  it("is the most of a range", () => {
    const file = { "counterweight_design.thickness": ["20 mm", "23 mm"] };
    const edit = eased(limit("thickness", 0.023, 0.0530266), written(file), null);
    expect(edit?.value).toEqual(["20 mm", "53.03 mm"]);
    expect(edit && easedWords(edit)).toBe("20 mm to 53.03 mm");
  });

  it("is the least balance, whether the file has one or not", () => {
    const nearest = limit("balance", 1, 0.43374);
    expect(eased(nearest, written({}), null)).toEqual({
      path: "counterweight_design.balance",
      value: "43.3 %",
    });
    const file = { "counterweight_design.balance": ["98 %", "102 %"] };
    expect(eased(nearest, written(file), null)?.value).toEqual(["43.3 %", "102 %"]);
  });

  it("is a wider crankcase, but no other piston", () => {
    const nearest = limit("swept-radius", 0.077, 0.0952304);
    expect(eased(nearest, written({}), room("crankcase"))).toEqual({
      path: "clearance.crankcase_radius",
      value: "96.74 mm",
    });
    expect(eased(nearest, written({}), room("piston"))).toBeUndefined();
  });

  it("is left to the user where the file does not hold it as a quantity", () => {
    expect(eased(limit("inertia", 0.01, 0.02), written({}), null)).toBeUndefined();
  });
});
