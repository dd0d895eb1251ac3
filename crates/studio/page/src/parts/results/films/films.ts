// What a plot of oil films is made of.

import type { BearingFilm } from "../../../api/types";

/** "main 2", "main 2 of crankshaft 2", "big end 3". */
export function nameOf(film: BearingFilm): string {
  if (film.kind === "crankpin") return `big end ${film.number}`;
  return film.crankshaft > 1 ? `main ${film.number} of crankshaft ${film.crankshaft}` : `main ${film.number}`;
}

/** Places of the journal's centre along and across the axis of its shell [m]. */
export function inShell(film: BearingFilm): { along: number[]; across: number[] } {
  const along: number[] = [];
  const across: number[] = [];
  film.orbit.eccentricity.forEach(([x, y], index) => {
    const angle = film.shell_angle?.[index] ?? 0;
    along.push(x * Math.cos(angle) + y * Math.sin(angle));
    across.push(y * Math.cos(angle) - x * Math.sin(angle));
  });
  return { along, across };
}

/** Thickness of the thinnest place of the film over the cycle [m]. */
export function thickness(film: BearingFilm): number[] {
  return film.orbit.eccentricity.map(([x, y]) => film.bearing.clearance - Math.hypot(x, y));
}

/** The film that is thinnest of all; none without films. */
export function thinnest(films: readonly BearingFilm[]): BearingFilm | undefined {
  return films.reduce<BearingFilm | undefined>(
    (least, film) => (least && least.orbit.least_film <= film.orbit.least_film ? least : film),
    undefined,
  );
}

/** What is to be said of a film beside its numbers. */
export function remark(film: BearingFilm): string {
  if (film.orbit.outcome === "overloaded") return "overloaded: the film does not carry this load";
  if (film.orbit.contact_time > 0) return "contact of the roughness";
  if (film.orbit.outcome === "not_periodic") return "does not repeat";
  if (film.orbit.least_film < film.roughness) return "below the roughness";
  return film.heat_balanced ? "" : "no heat balance";
}
