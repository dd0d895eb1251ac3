import { expect, test } from "vitest";
import type { DeviceSummary, FileEntry, ScenePart } from "../api/types";
import { keyOf } from "./path";

const part = (own: Partial<ScenePart>): ScenePart => ({
  name: "piston 3",
  kind: "piston",
  path: "piston.mass",
  cylinder: 3,
  weight: null,
  mesh: 0,
  motion: { kind: "fixed", x: 0, y: 0, z: 0, angle: 0 },
  ...own,
});
const entries = (all: Record<string, unknown>): FileEntry[] =>
  Object.entries(all).map(([path, value]) => ({ path, value, span: { start: 0, end: 0 } }));
const weight = (path: string | null): DeviceSummary => ({
  name: "web 1",
  path,
  unbalance: 1,
  angle: 0,
  direction: 0,
  from_throw: 1,
  z: 0,
  has_part: false,
});

test("a piston is that of all cylinders, or of its own number", () => {
  expect(keyOf(part({}), entries({ "piston.mass": "1 kg" }), [])).toBe("piston.mass");
  const own = entries({ "cylinder[0].number": 3, "cylinder[0].piston.mass": "2 kg" });
  expect(keyOf(part({}), own, [])).toBe("cylinder[0].piston.mass");
  expect(keyOf(part({ cylinder: 2 }), own, [])).toBe("piston.mass");
  const general = entries({ "cylinder[2].piston.mass": "2 kg" });
  expect(keyOf(part({}), general, [])).toBe("cylinder[2].piston.mass");
});

test("a weight is its own entry, or the share that it comes from", () => {
  const one = part({ kind: "counterweight", path: "counterweight", cylinder: null, weight: 0 });
  expect(keyOf(one, entries({}), [weight("counterweight[0]")])).toBe("counterweight[0].unbalance");
  const shaped = entries({ "counterweight[0].shape.type": "family" });
  expect(keyOf(one, shaped, [weight("counterweight[0]")])).toBe("counterweight[0].shape");
  const shares = entries({ "counterweights.rotating_share": "50 %" });
  expect(keyOf(one, shares, [weight(null)])).toBe("counterweights.rotating_share");
});
