// What is looked at, and how: nothing of it changes the engine.

export const TABS = ["engine", "view", "balance", "counterweight", "results", "compare"] as const;
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
  /** Speed at which loads are shown [rad/s]; `undefined`: the highest of the engine. */
  speed = $state<number>();
  /** Path of the key whose field has the focus; the sketch shows it. */
  field = $state<string>();
  pins = $state.raw<Pin[]>([]);
}

function firstTheme(): Theme {
  const kept = localStorage.getItem("lanchester-theme");
  if (kept === "light" || kept === "dark") return kept;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

export const view = new View();
