// The ground of a plot: its size, what of the axes is in sight, and the maps to pixels.

import { toSi } from "../../state/units.svelte";
import { matters } from "./pick";
import { axisTicks, equalised, limits, pixelMap, place, type PixelMap } from "./scale";
import type { Axis, Series } from "./series";
import { moved, within, type Zoom } from "./zoom";

/** Edges of the ground [px]. */
export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface Shape {
  /** Series in sight. */
  visible: readonly Series[];
  x: Axis;
  y: Axis;
  plane: boolean;
  equal: boolean;
  /** Wanted height, and the width that there is [px]. */
  height: number;
  room: number;
}

/** Above, below and beside the ground stand labels [px]. */
const ABOVE = 24;
const BELOW = 40;
export const RIGHT = 20;
const LEFT = { narrow: 52, wide: 62 };
const NARROW = 420;
/** A digit of a label, and what lies between the labels and the ground [px]. */
const DIGIT = 7.6;
const BESIDE = 9;
/** From tick to tick at least [px]. */
const TICKS = { x: 74, y: 42 };

export class Frame {
  zoomed = $state.raw<Zoom>();
  #shape: () => Shape;

  constructor(shape: () => Shape) {
    this.#shape = shape;
  }

  // Where the labels of the ordinate need more than what is usual, they get it.
  #left = $derived.by(() => {
    const { room, y, visible } = this.#shape();
    const count = Math.max(2, Math.round((this.tall - ABOVE - BELOW) / TICKS.y));
    const range = this.zoomed?.y ?? limits(y, visible, "y", toSi(1, y.measure), count, true);
    const labels = axisTicks(range, y, toSi(1, y.measure), count).map(({ label }) => label.length);
    return Math.max(
      room < NARROW ? LEFT.narrow : LEFT.wide,
      Math.ceil(DIGIT * Math.max(0, ...labels)) + BESIDE,
    );
  });
  // Where a unit is the same both ways the ground is a square.
  tall = $derived.by(() => {
    const { equal, room, height } = this.#shape();
    return equal ? Math.max(200, Math.min(room, height)) : height;
  });
  wide = $derived.by(() => {
    const { equal, room } = this.#shape();
    return equal ? Math.min(room, this.tall - ABOVE - BELOW + this.#left + RIGHT) : room;
  });
  box: Box = $derived({
    left: this.#left,
    top: ABOVE,
    right: Math.max(80, this.wide - RIGHT),
    bottom: this.tall - BELOW,
  });
  #countX = $derived(Math.max(2, Math.round((this.box.right - this.box.left) / TICKS.x)));
  #countY = $derived(Math.max(2, Math.round((this.box.bottom - this.box.top) / TICKS.y)));

  #fit(range: Zoom): Zoom {
    if (!this.#shape().equal) return range;
    const { left, top, right, bottom } = this.box;
    const [x, y] = equalised(range.x, range.y, right - left, bottom - top);
    return { x, y };
  }

  whole = $derived.by(() => {
    const { visible, x, y, plane } = this.#shape();
    return this.#fit({
      x: limits(x, visible, "x", toSi(1, x.measure), this.#countX, plane),
      y: limits(y, visible, "y", toSi(1, y.measure), this.#countY, true),
    });
  });
  shown = $derived(this.zoomed ? this.#fit(this.zoomed) : this.whole);
  maps: [PixelMap, PixelMap] = $derived.by(() => {
    const { x, y } = this.#shape();
    const { left, top, right, bottom } = this.box;
    const [from, to] = x.reversed ? [right, left] : [left, right];
    return [pixelMap(this.shown.x, from, to, x.log), pixelMap(this.shown.y, bottom, top, y.log)];
  });
  ticksX = $derived.by(() => {
    const { x } = this.#shape();
    return axisTicks(this.shown.x, x, toSi(1, x.measure), this.#countX);
  });
  ticksY = $derived.by(() => {
    const { y } = this.#shape();
    return axisTicks(this.shown.y, y, toSi(1, y.measure), this.#countY);
  });

  /** Moves what is zoomed until a place [SI] is in sight; without `y` along x alone. */
  follow(x: number, y?: number) {
    if (!this.zoomed) return;
    const { left, top, right, bottom } = this.box;
    const beyond = (pixel: number, from: number, to: number) =>
      Math.min(0, pixel - from) + Math.max(0, pixel - to);
    const dx = beyond(place(this.maps[0], x), left, right);
    const dy = y === undefined ? 0 : beyond(place(this.maps[1], y), top, bottom);
    if (dx !== 0 || dy !== 0) this.zoomed = within(moved(this.maps, this.shown, [-dx, -dy]), this.whole);
  }

  /** Nothing in sight stands above rounding noise. */
  vanishes = $derived.by(() => {
    const { visible, x, y, plane } = this.#shape();
    const still = (one: Series) => !matters(one.y, y.least ?? 0) && (!plane || !matters(one.x, x.least ?? 0));
    return y.least !== undefined && visible.length > 0 && visible.every(still);
  });
}
