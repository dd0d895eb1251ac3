// What the pictures of torsional vibration are made of.

import type { TorsionAnswer, TorsionDamper } from "../../../api/types";
import type { Measure } from "../../../state/units.svelte";
import { parted, plain } from "../../balance/devices/devices";
import { orderTitle } from "../../order";
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

/** All orders in true phase, and the strongest alone. */
export function twists({ speeds, orders, twist }: TorsionAnswer): Series[] {
  const strongest = twist.by_order
    .map((values, index) => ({ values, order: orders[index] ?? 0, peak: peak(values).value }))
    .sort((a, b) => b.peak - a.peak)
    .slice(0, DRAWN);
  return [
    { name: "all orders", x: speeds, y: twist.total, colour: 1, width: 2.5 },
    ...strongest.map(({ values, order }, index) => ({
      name: orderTitle(order),
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
          name: orderTitle(order),
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
        name: `${orderTitle(order)} meets mode ${mode}`,
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

/** What a number of the damper is: how it is called, and its unit on the page and in a file that has none yet. */
export const NUMBERS = {
  ring_inertia: { name: "Ring inertia", measure: "inertia", unit: "kg m2" },
  damping: { name: "Damping", measure: "angular-damping", unit: "N m s/rad" },
  stiffness: { name: "Stiffness", measure: "angular-stiffness", unit: "N m/rad" },
} as const satisfies Record<keyof Tried, { name: string; measure: Measure; unit: string }>;

/** A number as the file has it: its text, and the SI value of that. */
export interface Typed {
  text: unknown;
  si: number;
}

/** What was tried, as edits of the engine file: the unit that is typed there stays. */
export function lines(
  tried: Tried,
  file: (number: keyof Tried) => Typed | undefined,
): { path: string; value: string }[] {
  const numbers = Object.keys(NUMBERS) as (keyof Tried)[];
  return numbers.flatMap((number) => {
    const value = tried[number];
    if (value === undefined) return [];
    const own = file(number);
    const typed = parted(own?.text);
    const written =
      own && typed && typed.number > 0 && own.si > 0
        ? `${plain((typed.number * value) / own.si)} ${typed.unit}`
        : `${plain(value)} ${NUMBERS[number].unit}`;
    return [{ path: `damper.${number}`, value: written }];
  });
}

/** The numbers that a slider moves: those that this kind of damper has. */
export function numbersOf(damper: TorsionDamper): (keyof Tried)[] {
  return damper.kind === "viscous" && damper.stiffness === 0
    ? ["ring_inertia", "damping"]
    : damper.kind === "rubber" && damper.damping === 0
      ? ["ring_inertia", "stiffness"]
      : ["ring_inertia", "damping", "stiffness"];
}
