import { describe, expect, it } from "vitest";
import type { BearingFilm, BearingFilms } from "../../../api/types";
import { friction, leastFilms, overloads, roundSpeeds, thinnestOf } from "./overSpeed";

const RPM = Math.PI / 30;

function film(kind: BearingFilm["kind"], least_film: number, outcome = "periodic"): BearingFilm {
  return {
    kind,
    crankshaft: 1,
    number: 1,
    orbit: { least_film, outcome, friction_power: 100 },
  } as BearingFilm;
}

const answer = (speed: number, ...films: BearingFilm[]): BearingFilms =>
  ({ speed: speed * RPM, films }) as BearingFilms;

const answers = [
  answer(1000, film("main", 2e-6), film("crankpin", 1e-7, "overloaded")),
  answer(2000, film("main", 1e-6), film("crankpin", 3e-6)),
];

describe("speeds of a sweep", () => {
  const rpm = (lowest: number, highest: number) =>
    roundSpeeds(lowest * RPM, highest * RPM).map((speed) => Math.round((100 * speed) / RPM) / 100);

  it("are round between the ends of the range", () => {
    expect(rpm(800, 6500)).toEqual([
      800, 1200, 1600, 2000, 2400, 2800, 3200, 3600, 4000, 4400, 4800, 5200, 5600, 6000, 6500,
    ]);
    expect(rpm(600, 600)).toEqual([600]);
  });

  it("are some 12 to 20, rising, for any range", () => {
    for (const [low, high] of [
      [600, 650],
      [70, 110],
      [1000, 18000],
      [650, 6500],
      [0.5, 3],
    ] as const) {
      const found = rpm(low, high);
      expect(found.length, `${low} ${high}`).toBeGreaterThanOrEqual(11);
      expect(found.length).toBeLessThanOrEqual(20);
      expect([found[0], found.at(-1)]).toEqual([low, high]);
      expect(found).toEqual([...new Set(found)].sort((a, b) => a - b));
    }
  });
});

describe("films over speed", () => {
  it("are curves of the bearings, broken where they are overloaded", () => {
    expect(leastFilms(answers)).toEqual([
      { name: "main 1", kind: "main", least: [2e-6, 1e-6] },
      { name: "big end 1", kind: "crankpin", least: [NaN, 3e-6] },
    ]);
    expect(leastFilms([])).toEqual([]);
  });

  it("have a thinnest one among those that carry their load", () => {
    const speeds = answers.map(({ speed }) => speed);
    expect(thinnestOf(leastFilms(answers), speeds)).toEqual({
      name: "main 1",
      speed: 2000 * RPM,
      film: 1e-6,
    });
    expect(thinnestOf([], [])).toBeUndefined();
  });

  it("say where they are overloaded", () => {
    expect(overloads(answers)).toEqual([{ name: "big end 1", speeds: [1000 * RPM] }]);
  });

  it("add up their friction", () => {
    expect(friction(answers, "main")).toEqual([100, 100]);
    expect(friction(answers)).toEqual([NaN, 200]);
  });
});
