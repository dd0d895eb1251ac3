import { describe, expect, it } from "vitest";
import type { BearingFilm } from "../../../api/types";
import {
  bandLimits,
  instantAt,
  mapTable,
  nearestAt,
  nearestLine,
  outlines,
  thicknessAt,
  thinner,
  unrolled,
  wear,
} from "./unrolled";

const C = 30e-6;
const DEGREE = Math.PI / 180;
const PERIOD = 4 * Math.PI;

function film(eccentricity: [number, number][], shell_angle?: number[]): BearingFilm {
  return {
    kind: shell_angle ? "crankpin" : "main",
    bearing: { radius: 0.025, length: 0.02, clearance: C },
    shell_angle,
    orbit: { eccentricity },
  } as BearingFilm;
}

/** Half the clearance towards an angle [deg]. */
function halfway(degrees: number): [number, number] {
  return [0.5 * C * Math.cos(degrees * DEGREE), 0.5 * C * Math.sin(degrees * DEGREE)];
}

/** Whether a place is inside the outlines, by the rule of even crossings. */
function covers(of: ReturnType<typeof outlines>, x: number, y: number): boolean {
  return of.some((outline) => {
    let inside = false;
    outline.x.forEach((x1, i) => {
      const j = (i + 1) % outline.x.length;
      const [y1, x2, y2] = [outline.y[i]!, outline.x[j]!, outline.y[j]!];
      if (x1 > x !== x2 > x && y < y1 + ((x - x1) / (x2 - x1)) * (y2 - y1)) inside = !inside;
    });
    return inside;
  });
}

describe("a film unrolled", () => {
  it("is the clearance all around a concentric journal", () => {
    const map = unrolled(film([[0, 0]]));
    for (let angle = 0; angle < 360; angle += 30) expect(thicknessAt(map, 0, angle * DEGREE)).toBe(C);
  });

  it("is thin where the journal goes and thick opposite", () => {
    const map = unrolled(film([halfway(40)]));
    expect(thicknessAt(map, 0, 40 * DEGREE)).toBeCloseTo(0.5 * C, 12);
    expect(thicknessAt(map, 0, 220 * DEGREE)).toBeCloseTo(1.5 * C, 12);
    expect(thicknessAt(map, 0, 130 * DEGREE)).toBeCloseTo(C, 12);
    expect(nearestAt(map, 0)).toBeCloseTo(40 * DEGREE, 9);
    expect(nearestAt(unrolled(film([halfway(-40)])), 0)).toBeCloseTo(320 * DEGREE, 9);
  });

  it("turns with the shell of a big end", () => {
    const map = unrolled(film([halfway(100), halfway(100)], [0, 70 * DEGREE]));
    expect(nearestAt(map, 0)).toBeCloseTo(100 * DEGREE, 9);
    expect(nearestAt(map, 1)).toBeCloseTo(30 * DEGREE, 9);
    expect(thicknessAt(map, 1, 30 * DEGREE)).toBeCloseTo(0.5 * C, 12);
  });

  it("has its instants at the crank angles of the period", () => {
    const map = unrolled(film(Array.from({ length: 720 }, () => [0, 0])));
    expect(instantAt(map, 0, PERIOD)).toBe(0);
    expect(instantAt(map, 427 * DEGREE, PERIOD)).toBe(427);
    expect(instantAt(map, PERIOD, PERIOD)).toBe(0);
  });
});

describe("where a film is thinner than a limit", () => {
  it("is a stretch about the nearest place", () => {
    const { middle, half } = thinner(unrolled(film([halfway(40), halfway(350), halfway(20)])), 0.75 * C);
    expect(half[0]).toBeCloseTo(60 * DEGREE, 9);
    // The middle does not jump where it goes over the turn.
    expect(middle.map((angle) => Math.round(angle / DEGREE))).toEqual([40, -10, 20]);
  });

  it("is nowhere below the least film and everywhere above the most", () => {
    const map = unrolled(film([halfway(40), [0, 0]]));
    expect(thinner(map, 0.49 * C).half).toEqual([0, 0]);
    expect(thinner(map, 1.51 * C).half).toEqual([Math.PI, Math.PI]);
  });

  it("has outlines that hold just the thinner places", () => {
    // A journal that goes round twice a period and comes nearer once.
    const map = unrolled(
      film(
        Array.from({ length: 360 }, (_, k): [number, number] => {
          const size = C * (0.5 + 0.4 * Math.cos((k / 360) * 2 * Math.PI));
          return [size * Math.cos(2 * k * DEGREE), size * Math.sin(2 * k * DEGREE)];
        }),
      ),
    );
    for (const limit of [0.15 * C, 0.6 * C, 1.2 * C]) {
      const found = outlines(thinner(map, limit), PERIOD);
      for (let k = 3; k < 360; k += 11)
        for (let degrees = 1.5; degrees < 360; degrees += 7) {
          const own = thicknessAt(map, k, degrees * DEGREE);
          if (Math.abs(own - limit) < 0.02 * C) continue;
          const there = covers(found, (PERIOD * (k + 1e-6)) / 360, degrees * DEGREE);
          expect(there, `${k} ${degrees} ${limit}`).toBe(own < limit);
        }
    }
  });

  it("tells where the shell wears and for how long", () => {
    const map = unrolled(film([halfway(10), [0, 0], [0, 0], [0, 0]]));
    const { share, stretches } = wear(map, 0.75 * C);
    expect(share).toBe(0.25);
    // Over the turn: from 310 to 430 deg.
    expect(stretches).toHaveLength(1);
    expect(stretches[0]![0] / DEGREE).toBeCloseTo(310, 6);
    expect(stretches[0]![1] / DEGREE).toBeCloseTo(430, 6);
    expect(wear(map, 0.4 * C)).toEqual({ share: 0, stretches: [] });
    expect(wear(map, 3 * C)).toEqual({ share: 1, stretches: [[0, 2 * Math.PI]] });
  });
});

describe("the drawing of a film unrolled", () => {
  it("has ten bands up to twice the clearance with short numbers", () => {
    expect(bandLimits(30)).toEqual([0, 0.75, 1.5, 3, 6, 9, 15, 23, 30, 45, 60]);
    expect(bandLimits(1.181)).toEqual([0, 0.03, 0.059, 0.12, 0.24, 0.35, 0.59, 0.89, 1.2, 1.8, 2.4]);
    for (const clearance of [0.7, 12.3, 27.5, 49.9, 101])
      expect(bandLimits(clearance).at(-1)).toBeGreaterThanOrEqual(2 * clearance);
  });

  it("breaks the line of the nearest places at the turn", () => {
    const { x, y } = nearestLine(unrolled(film([halfway(350), halfway(10), halfway(30)])), PERIOD);
    expect(y.map((angle) => Math.round(angle / DEGREE))).toEqual([350, NaN, 30]);
    expect(x.map((angle) => Math.round(angle / DEGREE))).toEqual([0, 240, 480]);
  });

  it("is saved with a row an instant", () => {
    const lines = mapTable(unrolled(film([[0, 0], halfway(0)])), PERIOD, 1e6, "µm").split("\r\n");
    expect(lines[0]).toMatch(/^Crank angle \[°\],0° in the shell \[µm\],10° in/);
    expect(lines).toHaveLength(4);
    const [angle, first, ...rest] = lines[2]!.split(",").map(Number);
    expect(angle).toBeCloseTo(360, 9);
    expect(first).toBeCloseTo(15, 9);
    expect(rest).toHaveLength(35);
    expect(rest[17]).toBeCloseTo(45, 9);
  });
});
