// What is asked of the optimiser and of the search over arrangements: it belongs to the page, not to the file, and
// outlives a change of tabs.

import type { Arrangements, BalanceAnswer } from "../../../api/types";
import { engine } from "../../../state/engine.svelte";
import { Search } from "../../../state/search.svelte";
import { EACH } from "./criteria";

/** A load, or one order of it. */
export interface Aim {
  id: number;
  load: string;
  /** Empty: its peak over the cycle. */
  order: string;
}

/** Something that must not pass a value, as typed. */
export interface Bound extends Aim {
  most: string;
}

let count = 0;
export function aim(load: string, order = ""): Aim {
  return { id: ++count, load, order };
}

/** An aim as the server reads it: `force order 2`. */
function spoken(one: Aim): string {
  return one.order === "" ? one.load : `${one.load} order ${one.order}`;
}

/** What is typed with commas between. */
export function listed(text: string): string[] {
  return text
    .split(",")
    .map((one) => one.trim())
    .filter((one) => one !== "");
}

/** What is to be minimised, in which order, within what limits; or the orders that must vanish instead. */
export class BalanceTask {
  stages = $state<Aim[]>([]);
  limits = $state<Bound[]>([]);
  cancel = $state<Aim[]>([]);

  constructor(...loads: string[]) {
    this.stages = loads.map((load) => aim(load));
  }

  /** As the server reads it. */
  readonly said = $derived({
    minimise: this.cancel.length > 0 ? [] : this.stages.map(spoken),
    limits: this.#bounds((limit) => limit.load !== EACH).map((limit) => `${spoken(limit)} = ${limit.most}`),
    cancel: this.cancel.map(spoken),
    most: this.#bounds((limit) => limit.load === EACH).at(-1)?.most ?? null,
  });

  /** Limits that are asked: orders that must vanish come in place of all of them. */
  #bounds(wanted: (limit: Bound) => boolean): Bound[] {
    return this.cancel.length > 0 ? [] : this.limits.filter(wanted);
  }
}

/** What the optimiser may change: the cards that are not locked, what `[balance]` says, or new weights. */
export type Free = "devices" | "balance" | "webs" | "throws";

class Optimising {
  readonly task = new BalanceTask("force", "couple");
  free = $state<Free>("devices");
  locked = $state.raw<ReadonlySet<string>>(new Set());
  /** What ends a search over choices, as typed; empty: as usual. */
  gap = $state("");
  maxNodes = $state<number | null>(null);
  timeLimit = $state("");
  /** What earlier stages give up for later ones, as typed: `force = 1 %`. */
  giveUp = $state("");
  /** Oil films and safeties: not below a value, and as large as may be. */
  atLeast = $state("");
  large = $state("");
  /** Which weights can be made, what they may cost and at which speeds loads count, as typed; empty: whatever the file says. */
  step = $state("");
  equalParts = $state(false);
  whatFits = $state(false);
  budget = $state("");
  speeds = $state("");
  /** How many engines are drawn within their tolerances; none: the engine as it is meant. */
  engines = $state<number | null>(null);
  worstShare = $state("");
  readonly found = new Search<BalanceAnswer>("balance");

  constructor() {
    engine.whenOpened(() => {
      this.free = "devices";
      this.locked = new Set();
    });
  }

  /** A locked device stays as it is. */
  lock(name: string, on: boolean) {
    const others = [...this.locked].filter((one) => one !== name);
    this.locked = new Set(on ? [...others, name] : others);
  }

  /** Locked devices that the engine has. */
  #present(): string[] {
    const { counterweights = [], shafts = [] } = engine.summary ?? {};
    return [...counterweights, ...shafts].map(({ name }) => name).filter((name) => this.locked.has(name));
  }

  ask() {
    return this.found.ask("/api/balance", {
      ...this.task.said,
      free: this.free,
      locked: this.free === "devices" ? this.#present() : [],
      shafts: [],
      most: this.whatFits ? "what fits" : this.task.said.most,
      give_up: listed(this.giveUp),
      at_least: listed(this.atLeast),
      maximise: listed(this.large),
      step: this.step.trim() || null,
      equal_parts: this.equalParts,
      budget: this.budget.trim() || null,
      speeds: listed(this.speeds),
      robust: this.engines,
      worst_share: this.engines === null ? null : this.worstShare.trim() || null,
      gap: this.gap.trim() || null,
      max_nodes: this.maxNodes,
      time_limit: this.timeLimit.trim() || null,
    });
  }
}

export const optimising = new Optimising();

/** The search over arrangements, and which of them is looked at. */
class Arranging {
  readonly task = new BalanceTask("force");
  mostShafts = $state(2);
  drive = $state("gears");
  readonly found = new Search<Arrangements>("arrangements");
  /** Index of the arrangement that is looked at. */
  picked = $state<number>();

  async ask() {
    this.picked = undefined;
    const { minimise, limits } = this.task.said;
    const found = await this.found.ask("/api/arrangements", {
      minimise: minimise[0] ?? null,
      limits,
      most_shafts: this.mostShafts,
      drive: this.drive,
    });
    const spacing = found?.spacings[0];
    if (spacing) this.picked = spacing.simplest ?? spacing.front.at(-1);
  }
}

export const arranging = new Arranging();
