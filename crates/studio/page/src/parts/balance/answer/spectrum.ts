// Orders of force and couple as rows of two-sided bars.

import type { LoadSet, OrderLoads } from "../../../api/types";

/** Amounts of one order in either sense. */
export interface Sides {
  backward: number;
  forward: number;
}

export interface Row {
  order: number;
  force: { now: Sides; before: Sides | undefined };
  couple: { now: Sides; before: Sides | undefined };
}

export interface Spectrum {
  rows: Row[];
  /** Largest amount of any order, now or before: the length of the longest bar. */
  force: number;
  couple: number;
}

/** Below this part of the largest an order is not listed. */
const SEEN = 1e-5;

const size = ([re, im]: readonly [number, number]) => Math.hypot(re, im);

function sides(order: OrderLoads | undefined, what: "force" | "couple", least: number): Sides {
  if (!order) return { backward: 0, forward: 0 };
  const clean = (amount: readonly [number, number]) => (size(amount) > least ? size(amount) : 0);
  return { forward: clean(order[`${what}_forward`]), backward: clean(order[`${what}_backward`]) };
}

/** The orders that are there, now or before; order 1 and 2 always. What is not above `least` is rounding and counts as nothing. */
export function spectrum(
  now: LoadSet,
  before: LoadSet | undefined,
  least: { force: number; couple: number },
): Spectrum {
  const orders = [...new Set([...now.orders, ...(before?.orders ?? [])].map((one) => one.order))];
  orders.sort((a, b) => a - b);
  const find = (set: LoadSet | undefined, order: number) => set?.orders.find((one) => one.order === order);
  const rows = orders
    .filter((order) => order > 0)
    .map((order): Row => {
      const of = (what: "force" | "couple") => ({
        now: sides(find(now, order), what, least[what]),
        before: before && sides(find(before, order), what, least[what]),
      });
      return { order, force: of("force"), couple: of("couple") };
    });
  const most = (what: "force" | "couple") =>
    Math.max(
      0,
      ...rows.flatMap(({ [what]: { now, before } }) =>
        [now, before].flatMap((one) => (one ? [one.forward, one.backward] : [])),
      ),
    );
  const [force, couple] = [most("force"), most("couple")];
  const seen = (row: Row) =>
    row.order === 1 ||
    row.order === 2 ||
    [row.force.now, row.force.before].some((one) => one && largest(one) > SEEN * force) ||
    [row.couple.now, row.couple.before].some((one) => one && largest(one) > SEEN * couple);
  return { rows: rows.filter(seen), force, couple };
}

function largest(one: Sides): number {
  return Math.max(one.forward, one.backward);
}
