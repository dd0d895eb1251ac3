import { describe, expect, it } from "vitest";
import type { SimulationAnswer } from "../../api/types";
import { TRUNK, bands, outline } from "./energyFlow";
import {
  acting,
  blockAt,
  departure,
  eventRules,
  extremeMeasure,
  fluctuation,
  inertias,
  ledger,
  orbits,
  overPeriod,
  sampleAt,
  thetaAt,
  turn,
} from "./simulated";

const run: SimulationAnswer = {
  words: [],
  complete: true,
  speeds: [102, 98, 100],
  period_start: 2,
  time: [0, 0.1, 0.2, 0.3],
  theta: [0, 10, 20, 30],
  speed: [100, 100, 98, 102],
  torques: [],
  position: [
    [5, 0, 0],
    [0, 0, 0],
    [1, 2, 0],
    [3, 4, 0],
  ],
  orientation: [
    [1, 0, 0, 0],
    [1, 0.001, 0, 0],
    [-1, 0.001, 0, 0],
    [1, 0, 0, 0.002],
  ],
  mounts: [],
  mains: [],
  side_thrust: [],
  points: [
    {
      name: "carburettor",
      displacement: [
        [9, 9, 9],
        [9, 9, 9],
        [0.001, 0.002, 0],
        [0.003, 0.006, 0],
      ],
    },
  ],
  gear_torques: [],
  gear_forces: [],
  driveline_twists: [],
  driveline_torques: [{ name: "1", values: [1, 2, 3, 4] }],
  driveline_speeds: [],
  extremes: [],
  energy: [
    { name: "gas", energy: 100 },
    { name: "load", energy: -70 },
    { name: "kinetic energy", energy: -30 },
  ],
  energy_error: 1e-12,
  period_energy: [],
  events: [],
};

describe("a simulated run", () => {
  it("names the driveline by its inertias and shows extremes in the unit of their kind", () => {
    expect(inertias(run.driveline_torques)).toEqual([{ name: "inertia 1", values: [1, 2, 3, 4] }]);
    expect(["rad/s", "m", "rad", "N", "N m", "1"].map(extremeMeasure)).toEqual([
      "speed",
      "vibration",
      "rotation",
      "force",
      "moment",
      "none",
    ]);
  });

  it("draws the orbit of a point about its mean in the last period, y to the right", () => {
    const [orbit, ...rest] = orbits(run);
    expect(rest).toEqual([]);
    expect(orbit?.name).toBe("carburettor");
    expect(orbit?.x).toEqual([expect.closeTo(-0.002, 12), expect.closeTo(0.002, 12)]);
    expect(orbit?.y).toEqual([expect.closeTo(-0.001, 12), expect.closeTo(0.001, 12)]);
    expect(orbit?.along).toEqual([20, 30]);
  });

  it("has its last period from its start", () => {
    const [curve] = overPeriod(run, [{ name: "speed", values: run.speed }]);
    expect(curve?.x).toEqual([0, 10]);
    expect(curve?.y).toEqual([98, 102]);
  });

  it("shows what acts in its last period", () => {
    const curve = (name: string, values: number[]) => ({ name, values });
    const curves = [curve("gas", [0, 0, 1, 2]), curve("starter", [9, 9, 0, 0])];
    expect(acting(run, curves).map((one) => one.name)).toEqual(["gas"]);
    expect(acting(run, curves.slice(1))).toHaveLength(1);
  });

  it("names events that are close to one another on one line", () => {
    const event = (what: string, time: number) => ({ what, time, theta: 0, speed: 0 });
    const events = [event("fuel 100 %", 0.1), event("the starter lets go", 0.11), event("load 40 N m", 0.2)];
    expect(eventRules({ ...run, events })).toEqual([
      { x: 0.1, name: "fuel 100 %, the starter lets go" },
      { x: 0.2, name: "load 40 N m" },
    ]);
  });

  it("departs from the mean place of the last period", () => {
    expect(departure(run, 0)).toEqual([3, -2, -1, 1]);
    expect(departure(run, 1).slice(2)).toEqual([-1, 1]);
  });

  it("turns the same way whichever sign its quaternion has", () => {
    expect(turn(run, 0)).toEqual([0, 0.002, -0.002, 0]);
    expect(turn(run, 2)[3]).toBe(0.004);
  });

  it("finds the sample at a time", () => {
    expect([-1, 0, 0.15, 0.2, 9].map((time) => sampleAt(run, time))).toEqual([0, 0, 1, 2, 3]);
  });

  it("is played on straight lines between its samples", () => {
    expect(thetaAt(run, 0.15)).toBeCloseTo(15);
    expect(thetaAt(run, 5)).toBe(30);
    const still = { ...run, position: [], orientation: [] };
    expect(blockAt(still, 0.1, 10)).toBeNull();
  });

  it("draws the block's departure so many times as large, and turns it by a unit quaternion", () => {
    const drawn = blockAt(run, 0.2, 10);
    expect(drawn?.place).toEqual([-10, -10, 0]);
    const [x, , z, w] = drawn?.turn ?? [];
    // From its mean of -0.001 and 0.002 rad: -0.001 about x, -0.002 about z, ten times.
    expect(x).toBeCloseTo(-0.005, 6);
    expect(z).toBeCloseTo(-0.01, 6);
    expect(Math.hypot(...(drawn?.turn ?? []))).toBeCloseTo(1, 12);
    expect(w).toBeLessThan(1);
  });

  it("has two equal sides of its ledger", () => {
    const { from, to } = ledger(run.energy);
    const sum = (side: typeof from) => side.reduce((all, part) => all + part.energy, 0);
    expect(to.map((part) => part.name)).toEqual(["load", "kinetic energy"]);
    expect(sum(from)).toBe(sum(to));
    // Rounding is no entry.
    expect(ledger([...run.energy, { name: "gravity", energy: -3.5e-15 }])).toEqual({ from, to });
    expect(fluctuation(run.speeds)).toBeCloseTo(0.04);
  });

  it("draws its energy as bands in proportion, both sides as tall as the trunk", () => {
    const flow = bands(run.energy);
    for (const side of [flow?.left ?? [], flow?.right ?? []]) {
      expect(side.length).toBeGreaterThan(0);
      expect(side.reduce((all, band) => all + band.wide, 0)).toBeCloseTo(TRUNK);
      const [first] = side;
      expect(first?.inner).toBeCloseTo(((flow?.height ?? 0) - TRUNK) / 2);
    }
    const [load, kinetic] = flow?.right ?? [];
    expect((load?.wide ?? 0) / (kinetic?.wide ?? 1)).toBeCloseTo(
      (load?.energy ?? 0) / (kinetic?.energy ?? 1),
    );
    expect(outline({ name: "", energy: 1, outer: 0, inner: 10, wide: 5 }, 0, 20)).toBe(
      "M0,0 C10,0 10,10 20,10 V15 C10,15 10,5 0,5 Z",
    );
    expect(bands([])).toBeNull();
  });
});
