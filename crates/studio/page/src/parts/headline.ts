// The few numbers that are always seen, out of the loads.

import type { Loads, OrderLoads } from "../api/types";
import { digits, type Measure } from "../state/units.svelte";
import { noise } from "./results/forces/magnitude";

export interface Figure {
  name: string;
  /** What it is, in full. */
  about: string;
  measure: Measure;
  /** SI. */
  value: number;
}

/** What each number is, in full; before there are loads the numbers are not numbers. */
export function figures(loads: Loads | undefined): Figure[] {
  const peaks = loads?.total.peaks;
  const least = loads && noise(loads);
  const clean = (value: number | undefined, kind: "force" | "couple" | "roll_moment") => {
    if (value === undefined || !least) return NaN;
    return Math.abs(value) > least[kind] ? value : 0;
  };
  const order = (wanted: number) => loads?.total.orders.find((entry) => entry.order === wanted);
  const force = (wanted: number) =>
    clean(loads && sum(order(wanted), "force_forward", "force_backward"), "force");
  const couple = (wanted: number) =>
    clean(loads && sum(order(wanted), "couple_forward", "couple_backward"), "couple");
  const roll =
    peaks && Math.max(Math.abs(peaks.roll_moment.max.value), Math.abs(peaks.roll_moment.min.value));
  return [
    {
      name: "Peak force",
      about: "Largest shaking force of the moving parts on the block over the cycle, of all orders together",
      measure: "force",
      value: clean(peaks?.force.max.value, "force"),
    },
    {
      name: "Force, order 1",
      about: "Largest force of first order: it goes round once a revolution",
      measure: "force",
      value: force(1),
    },
    {
      name: "Force, order 2",
      about: "Largest force of second order: twice a revolution",
      measure: "force",
      value: force(2),
    },
    {
      name: "Peak couple",
      about: "Largest couple about the reference point, yaw and pitch together, of all orders together",
      measure: "moment",
      value: clean(peaks?.couple.max.value, "couple"),
    },
    {
      name: "Couple, order 1",
      about: "Largest couple of first order",
      measure: "moment",
      value: couple(1),
    },
    {
      name: "Couple, order 2",
      about: "Largest couple of second order",
      measure: "moment",
      value: couple(2),
    },
    {
      name: "Roll moment",
      about: "Largest moment of the inertia forces about the crank axis, in either sense; without gas",
      measure: "moment",
      value: clean(roll, "roll_moment"),
    },
  ];
}

type Turning = "force_forward" | "force_backward" | "couple_forward" | "couple_backward";

/** Both parts in line: the major half axis of the order's ellipse. */
function sum(order: OrderLoads | undefined, forward: Turning, backward: Turning): number {
  return order ? Math.hypot(...order[forward]) + Math.hypot(...order[backward]) : 0;
}

/** Change from before to now, in words; empty where there is none. */
export function change(before: number, now: number): string {
  if (before === now) return "same";
  if (before === 0) return "new";
  if (now === 0) return "gone";
  const percent = (now / before - 1) * 100;
  if (Math.abs(percent) < 0.05) return "same";
  if (percent > 999) return `× ${digits(now / before, 3)}`;
  return `${percent < 0 ? "−" : "+"}${Math.abs(percent).toFixed(Math.abs(percent) < 10 ? 1 : 0)} %`;
}
