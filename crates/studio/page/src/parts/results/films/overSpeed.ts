// Least films and friction over the speeds of the engine.

import type { BearingFilm, BearingFilms } from "../../../api/types";
import { nameOf } from "./films";

const RPM = Math.PI / 30;
/** Steps between speeds [rpm], times a power of ten. */
const STEPS = [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];
/** Most steps from the lowest to the highest speed. */
const MOST = 18;

/** Speeds from the lowest to the highest [rad/s]: both, and round ones between. */
export function roundSpeeds(lowest: number, highest: number): number[] {
  if (!(highest > lowest)) return [highest];
  const [low, high] = [lowest / RPM, highest / RPM];
  const least = (high - low) / MOST;
  const power = 10 ** Math.floor(Math.log10(least));
  const step = (STEPS.find((one) => one * power >= least * (1 - 1e-9)) ?? 10) * power;
  const between: number[] = [];
  for (let k = Math.floor(low / step); k * step < high; k++)
    if (k * step > low + 0.3 * step && k * step < high - 0.3 * step) between.push(k * step * RPM);
  return [lowest, ...between, highest];
}

export interface Curve {
  name: string;
  kind: BearingFilm["kind"];
  /** Least film at each speed [m]; not a number where the film is overloaded. */
  least: number[];
}

const isOverloaded = (film: BearingFilm) => film.orbit.outcome === "overloaded";

/** Least film of every bearing over the speeds of the answers, in the order of the bearings. */
export function leastFilms(answers: readonly BearingFilms[]): Curve[] {
  return (answers[0]?.films ?? []).map((first, index) => ({
    name: nameOf(first),
    kind: first.kind,
    least: answers.map(({ films }) => {
      const film = films[index];
      return film && !isOverloaded(film) ? film.orbit.least_film : NaN;
    }),
  }));
}

export interface Thinnest {
  name: string;
  speed: number;
  film: number;
}

/** The thinnest of all films at all speeds that carry their load. */
export function thinnestOf(curves: readonly Curve[], speeds: readonly number[]): Thinnest | undefined {
  let found: Thinnest | undefined;
  for (const { name, least } of curves)
    least.forEach((film, index) => {
      if (Number.isFinite(film) && !(found && found.film <= film))
        found = { name, speed: speeds[index] ?? NaN, film };
    });
  return found;
}

/** The speeds at which films are overloaded, by bearing. */
export function overloads(answers: readonly BearingFilms[]): { name: string; speeds: number[] }[] {
  return (answers[0]?.films ?? [])
    .map((first, index) => ({
      name: nameOf(first),
      speeds: answers
        .filter(({ films }) => films[index] && isOverloaded(films[index]))
        .map(({ speed }) => speed),
    }))
    .filter(({ speeds }) => speeds.length > 0);
}

/** Friction power of all bearings of a kind over speed [W]; not a number where one is overloaded. */
export function friction(answers: readonly BearingFilms[], kind?: BearingFilm["kind"]): number[] {
  return answers.map(({ films }) => {
    const of = films.filter((film) => kind === undefined || film.kind === kind);
    return of.some(isOverloaded) ? NaN : of.reduce((sum, film) => sum + film.orbit.friction_power, 0);
  });
}
