// What the optimiser is asked: it belongs to the page, not to the file, and outlives a change of tabs.

import type { Arrangements, BalanceAnswer } from "../../api/types";
import { Task } from "../../state/task.svelte";

/** What may be changed: the cards that are not locked, what `[balance]` says, or new weights. */
export type Free = "devices" | "balance" | "webs" | "throws";

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
export function spoken(one: Aim): string {
  return one.order === "" ? one.load : `${one.load} order ${one.order}`;
}

class Wishes {
  free = $state<Free>("devices");
  locked = $state.raw<ReadonlySet<string>>(new Set());
  stages = $state<Aim[]>([aim("force"), aim("couple")]);
  limits = $state<Bound[]>([]);
  cancel = $state<Aim[]>([]);
  readonly found = new Task<BalanceAnswer>("balance");

  /** A locked device stays as it is. */
  lock(name: string, on: boolean) {
    const others = [...this.locked].filter((one) => one !== name);
    this.locked = new Set(on ? [...others, name] : others);
  }

  /** `devices`: names of those that the engine has. */
  optimise(text: string, devices: string[]) {
    const cancels = this.cancel.length > 0;
    return this.found.ask("/api/balance", text, {
      free: this.free,
      locked: this.free === "devices" ? devices.filter((name) => this.locked.has(name)) : [],
      minimise: cancels ? [] : this.stages.map(spoken),
      limits: cancels ? [] : this.limits.map((limit) => `${spoken(limit)} = ${limit.most}`),
      cancel: this.cancel.map(spoken),
      shafts: [],
    });
  }
}

export const wishes = new Wishes();

/** The search over arrangements, and what was picked of it. */
class Arranging {
  criterion = $state("force");
  /** As typed; empty: none. */
  limit = $state("");
  mostShafts = $state(2);
  drive = $state("gears");
  readonly found = new Task<Arrangements>("arrangements");

  settings() {
    return {
      minimise: this.criterion,
      limits: this.limit.trim() === "" ? [] : [`${this.criterion} = ${this.limit.trim()}`],
      most_shafts: this.mostShafts,
      drive: this.drive,
    };
  }
}

export const arranging = new Arranging();
