// What the pictures of torsional vibration are made of.

import type { TorsionAnswer, TorsionDamper } from "../../../api/types";
import type { Marker, Series } from "../../plot/series";

/** Numbers of a damper that are tried out in place of those of the file. */
export interface Tried {
  ring_inertia?: number;
  damping?: number;
  stiffness?: number;
}

/** Orders and modes drawn one by one. */
const DRAWN = 4;

/** Place and size of the largest value. */
export function peak(values: readonly number[]): { at: number; value: number } {
  let at = 0;
  values.forEach((value, index) => {
    if (value > (values[at] ?? -Infinity)) at = index;
  });
  return { at, value: values[at] ?? NaN };
}

/** "order 4.5" */
export function orderName(order: number): string {
  return `order ${Number(order.toFixed(3))}`;
}

/** All orders in true phase, and the strongest alone. */
export function twists({ speeds, orders, twist }: TorsionAnswer): Series[] {
  const strongest = twist.by_order
    .map((values, index) => ({ values, order: orders[index] ?? 0, peak: peak(values).value }))
    .sort((a, b) => b.peak - a.peak)
    .slice(0, DRAWN);
  return [
    { name: "all orders", x: speeds, y: twist.total, colour: 1, width: 2.5 },
    ...strongest.map(({ values, order }, index) => ({
      name: orderName(order),
      x: speeds,
      y: values,
      colour: index + 2,
    })),
  ];
}

/** Natural frequencies [Hz] and the orders that meet them strongest, over speed. */
export function campbell({ campbell: { speeds, frequencies, criticals } }: TorsionAnswer): {
  series: Series[];
  markers: Marker[];
} {
  const hertz = (values: readonly number[]) => values.map((value) => value / (2 * Math.PI));
  const last = speeds.at(-1) ?? 0;
  const strongest = criticals.slice(0, 2 * DRAWN);
  const reached = Math.max(1, ...strongest.map(({ mode }) => mode));
  const modes = frequencies.slice(0, Math.min(reached, DRAWN));
  const top = 1.1 * Math.max(...modes.flatMap((values) => hertz(values)), 0);
  const orders = [...new Set(strongest.map(({ order }) => order))].sort((a, b) => a - b);
  return {
    series: [
      ...modes.map((values, index) => ({
        name: `mode ${index + 1}`,
        x: speeds,
        y: hertz(values),
        colour: index + 1,
      })),
      ...orders.map((order) => {
        const end = Math.min(last, (2 * Math.PI * top) / order);
        return {
          name: orderName(order),
          x: [0, end],
          y: [0, (order * end) / (2 * Math.PI)],
          colour: 6,
          dash: "2 3",
          width: 1.2,
        };
      }),
    ],
    markers: strongest
      .filter(({ mode }) => mode <= modes.length)
      .map(({ speed, frequency, order, mode }) => ({
        x: speed,
        y: frequency / (2 * Math.PI),
        name: `${orderName(order)} meets mode ${mode}`,
      })),
  };
}

/** Shapes of the first modes along the chain. */
export function shapes({ modes, stations }: TorsionAnswer): Series[] {
  return modes.slice(0, DRAWN).map((mode, index) => ({
    name: `mode ${index + 1}, ${(mode.frequency / (2 * Math.PI)).toPrecision(4)} Hz`,
    x: stations.map((_, place) => place + 1),
    y: mode.shape,
    colour: index + 1,
    labels: stations,
  }));
}

/** Scale of a slider: a round number some times above what the file says. */
export function most(value: number): number {
  if (!(value > 0)) return 1;
  const raw = 4 * value;
  const size = 10 ** Math.floor(Math.log10(raw));
  return ([1, 2, 5, 10].find((step) => step * size >= raw) ?? 10) * size;
}

/** What of the tried numbers differs from the damper of the file, as lines of the engine file. */
export function lines(tried: Tried): { path: string; value: string }[] {
  const text = (value: number | undefined, unit: string) =>
    value === undefined ? undefined : `${Number(value.toPrecision(6))} ${unit}`;
  const all = [
    { path: "damper.ring_inertia", value: text(tried.ring_inertia, "kg m2") },
    { path: "damper.damping", value: text(tried.damping, "N m s/rad") },
    { path: "damper.stiffness", value: text(tried.stiffness, "N m/rad") },
  ];
  return all.filter((line): line is { path: string; value: string } => line.value !== undefined);
}

/** The numbers that a slider moves: those that this kind of damper has. */
export function numbersOf(damper: TorsionDamper): (keyof Tried)[] {
  return damper.kind === "viscous" && damper.stiffness === 0
    ? ["ring_inertia", "damping"]
    : damper.kind === "rubber" && damper.damping === 0
      ? ["ring_inertia", "stiffness"]
      : ["ring_inertia", "damping", "stiffness"];
}
