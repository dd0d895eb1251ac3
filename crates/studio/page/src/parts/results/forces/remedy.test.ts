import { describe, expect, it } from "vitest";
import type { EngineSummary, Finding } from "../../../api/types";
import { less, turnedBy } from "./phasors";
import { remedyOf } from "./remedy";

const bare = { counterweights: [], shafts: [] } as unknown as EngineSummary;
const weighted = {
  counterweights: [{ z: -0.09 }, { z: 0.08 }],
  shafts: [{ name: "balancer", y: 0.1 }],
} as unknown as EngineSummary;
const finding = (more: Partial<Finding>): Finding => ({
  amplitude: 1,
  order: 1,
  quantity: "couple",
  remedy: "balance-shaft",
  sense: "backward",
  text: "",
  ...more,
});

describe("remedies", () => {
  it("of a couple against the crank are a shaft with weights in two planes, where no other shaft is", () => {
    expect(remedyOf(finding({}), weighted)).toEqual({
      label: "Add shaft, against the crank, two planes",
      settings: {
        free: "none",
        locked: [],
        shafts: ["-1 @ 0 mm, -100 mm @ -90 mm, 90 mm"],
        minimise: ["couple order 1"],
      },
    });
  });

  it("of a force with the crank at twice its speed are a shaft in one plane", () => {
    const found = remedyOf(finding({ quantity: "force", order: 2, sense: "forward" }), bare);
    expect(found?.label).toBe("Add shaft at 2 × crank speed, with the crank");
    expect(found?.settings.shafts).toEqual(["2 @ 0 mm, 100 mm @ 0 mm"]);
  });

  it("on the crank leave shafts as they are", () => {
    const own = finding({ remedy: "crank-weights", sense: "forward" });
    expect(remedyOf(own, bare)?.settings).toMatchObject({ free: "throws", locked: [] });
    expect(remedyOf(own, weighted)?.settings).toEqual({
      free: "devices",
      locked: ["balancer"],
      shafts: [],
      minimise: ["couple order 1", "force order 1"],
    });
  });

  it("are none of a roll moment and of high orders", () => {
    expect(
      remedyOf(finding({ quantity: "roll-moment", remedy: "roll-device", sense: "none" }), bare),
    ).toBeUndefined();
    expect(remedyOf(finding({ remedy: "none-of-low-order", order: 4 }), bare)).toBeUndefined();
  });
});

describe("arrows of the stars", () => {
  it("turn from x towards y, and back", () => {
    const [re, im] = turnedBy(Math.PI / 2, [2, 0]);
    expect(re).toBeCloseTo(0, 12);
    expect(im).toBeCloseTo(2, 12);
    expect(turnedBy(-Math.PI / 2, [0, 3])[0]).toBeCloseTo(3, 12);
  });

  it("of the engine go without what is switched off", () => {
    expect(
      less(
        [5, -1],
        [
          [2, 1],
          [1, 1],
        ],
      ),
    ).toEqual([2, -3]);
    expect(less([5, -1], [])).toEqual([5, -1]);
  });
});
