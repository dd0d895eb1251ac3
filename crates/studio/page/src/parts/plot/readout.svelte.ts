// What a plot reads out: at the pointer, by keys, else at the crank angle.

import { toSi } from "../../state/units.svelte";
import type { Frame } from "./frame.svelte";
import { nearest, places, pointAt, type Sample } from "./pick";
import { place, valueAt } from "./scale";
import type { Axis, Cursor, Series } from "./series";
import { bare, unitOf, written } from "./words";

export interface Source {
  series: readonly Series[];
  visible: readonly Series[];
  x: Axis;
  y: Axis;
  along: Axis | undefined;
  plane: boolean;
  cursor: Cursor | undefined;
  rest: number | undefined;
}

/** From the pointer to a point that is read out, and to one that is chosen [px]. */
const REACH = 60;
const CHOICE = 24;

export class Readout {
  /** Where the readout was put: a place on the axis [SI], or a point. */
  at = $state<number>();
  point = $state.raw<Sample>();
  #source: () => Source;
  #frame: Frame;

  constructor(frame: Frame, source: () => Source) {
    this.#frame = frame;
    this.#source = source;
  }

  /** All places that keys walk through. */
  #walk = $derived.by(() => {
    const { plane, visible } = this.#source();
    return plane ? [] : places(visible);
  });
  #reading = $derived.by(() => this.at ?? this.#source().cursor?.value ?? this.#source().rest);

  /** One value a series, where they share the x axis. */
  values = $derived.by(() => {
    const { plane, series, x, y } = this.#source();
    if (plane) return undefined;
    const reading = this.#reading;
    if (reading === undefined) return series.map(() => "");
    return series.map((one) => {
      const index = nearest(one.x, reading);
      // A bar tells of its own place alone.
      const beside = Math.abs((one.x[index] ?? NaN) - reading) > 1e-6 * toSi(1, x.measure);
      const value = one.y[index];
      return value === undefined || (one.kind === "bars" && beside) ? "–" : bare(value, y);
    });
  });

  /** The place on the axis, or all of a point. */
  text = $derived.by(() => {
    const { plane, visible, x, y, along } = this.#source();
    if (!plane) return this.#reading === undefined ? "" : written(this.#reading, x);
    const one = this.point && visible[this.point.series];
    if (!one || !this.point) return "";
    const { index } = this.point;
    const words = [one.labels?.[index] ?? (visible.length > 1 ? one.name : "")];
    if (one.along && along) words.push(written(one.along[index] ?? NaN, along));
    words.push(
      `${x.name} ${written(one.x[index] ?? NaN, x)}`,
      `${y.name} ${written(one.y[index] ?? NaN, y)}`,
    );
    return words.filter((word) => word !== "").join(" · ");
  });

  /** The same for those who hear it. */
  words = $derived.by(() => {
    const { plane, series, visible, x, y } = this.#source();
    if (plane) return this.text;
    const told = visible.map((one) => `${one.name} ${this.values?.[series.indexOf(one)] ?? ""} ${unitOf(y)}`);
    return `${x.name} ${this.text}: ${told.join(", ")}`;
  });

  index = $derived.by(() => {
    if (this.#source().plane) return this.point?.index ?? 0;
    return this.#reading === undefined ? 0 : nearest(this.#walk, this.#reading);
  });
  count = $derived.by(() => {
    const { plane, visible } = this.#source();
    return plane ? (visible[this.point?.series ?? 0]?.x.length ?? 0) : this.#walk.length;
  });

  /** The crosshair's line [px]. */
  line = $derived.by(() => (this.at === undefined ? undefined : place(this.#frame.maps[0], this.at)));
  /** Around the point that is read out [px]. */
  ring = $derived.by(() => {
    const one = this.point && this.#source().visible[this.point.series];
    if (!one || !this.point) return undefined;
    const [mapX, mapY] = this.#frame.maps;
    const cx = place(mapX, one.x[this.point.index] ?? NaN);
    const cy = place(mapY, one.y[this.point.index] ?? NaN);
    return Number.isFinite(cx + cy) ? { cx, cy } : undefined;
  });

  hover(here: [number, number] | undefined) {
    const [mapX, mapY] = this.#frame.maps;
    const walk = this.#walk;
    if (this.#source().plane) this.point = here && pointAt(this.#source().visible, mapX, mapY, here, REACH);
    else this.at = here && walk.length > 0 ? walk[nearest(walk, valueAt(mapX, here[0]))] : undefined;
  }

  step(by: number) {
    const to = Math.max(0, Math.min(this.count - 1, this.index + by));
    if (this.count === 0) return;
    if (this.#source().plane) {
      this.point = { series: this.point?.series ?? 0, index: this.point ? to : 0 };
      this.#follow();
    } else {
      this.at = this.#walk[to];
      if (this.at !== undefined) this.#frame.follow(this.at);
    }
  }

  /** In a plane: to the next series, at the same place along it. */
  turn(by: number) {
    const { plane, visible } = this.#source();
    if (!plane || visible.length === 0) return;
    const { series, index } = this.point ?? { series: -by, index: 0 };
    const next = (series + by + visible.length) % visible.length;
    const last = Math.max(0, (visible[next]?.x.length ?? 1) - 1);
    this.point = { series: next, index: Math.min(index, last) };
    this.#follow();
  }

  #follow() {
    const one = this.point && this.#source().visible[this.point.series];
    const [x, y] = [one?.x[this.point?.index ?? 0], one?.y[this.point?.index ?? 0]];
    if (x !== undefined && y !== undefined && Number.isFinite(x + y)) this.#frame.follow(x, y);
  }

  /** The point next to a place on the screen, or the one that is read out. */
  chosen(here: [number, number] | undefined): Sample | undefined {
    const [mapX, mapY] = this.#frame.maps;
    return here ? pointAt(this.#source().visible, mapX, mapY, here, CHOICE) : this.point;
  }

  clear() {
    this.at = undefined;
    this.point = undefined;
  }
}
