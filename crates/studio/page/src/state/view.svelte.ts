// What is looked at, and how: nothing of it changes the engine.

import { engine } from "./engine.svelte";

export const TABS = [
  "engine",
  "view",
  "balance",
  "counterweight",
  "results",
  "simulate",
  "studies",
  "compare",
  "bondgraph",
] as const;
export type Tab = (typeof TABS)[number];
export type Theme = "light" | "dark";

/** A state that was pinned to compare others with. */
export interface Pin {
  name: string;
  text: string;
  /** Number of its colour, from 1. */
  colour: number;
}

class View {
  tab = $state<Tab>("engine");
  theme = $state<Theme>(firstTheme());
  /** Crank angle of the 3-D view and of the markers in plots [rad]. */
  theta = $state(0);
  playing = $state(false);
  /** The search of the studio is open. */
  searching = $state(false);
  /** Lowest and highest speed that can be chosen [rad/s]; an engine of one speed is seen from a tenth of it. */
  readonly speeds = $derived.by(() => {
    const { lowest_speed: lowest, highest_speed: highest } = engine.summary ?? {
      lowest_speed: 0,
      highest_speed: 0,
    };
    return { lowest: lowest < highest ? lowest : highest / 10, highest };
  });
  #speed = $state<number>();
  /** Path of the key whose field has the focus; the sketch shows it. */
  field = $state<string>();
  pins = $state.raw<Pin[]>([]);

  /** Speed at which loads are shown [rad/s]; `undefined`: the highest of the engine, as for one that it does not reach. */
  get speed(): number | undefined {
    const { lowest, highest } = this.speeds;
    const speed = this.#speed;
    if (speed === undefined || highest === 0) return speed;
    return speed < lowest * (1 - ROUNDING) || speed > highest * (1 + ROUNDING) ? undefined : speed;
  }

  set speed(speed: number | undefined) {
    this.#speed = speed;
  }
}

/** What rounding to whole revolutions may leave of a speed at the end of the range. */
const ROUNDING = 1e-3;

function firstTheme(): Theme {
  const kept = localStorage.getItem("lanchester-theme");
  if (kept === "light" || kept === "dark") return kept;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

export const view = new View();
