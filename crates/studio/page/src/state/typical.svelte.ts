// Typical values for what the engine file leaves out: text with comments that name them so, one step of undo.

import { post, Refused } from "../api/client";
import type { Completed, Problem, TypicalSection } from "../api/types";
import { engine } from "./engine.svelte";

/** Sections that have typical values, and what they are called on buttons. */
export const TYPICAL: Record<TypicalSection, string> = {
  "piston.bore": "bore",
  "crank.web_distance": "distance of webs",
  "counterweights.at": "webs of counterweights",
  "crank.body": "crankshaft as a body",
  "crank.material": "material of the crankshaft",
  gas: "gas",
  friction: "friction",
  flywheel: "flywheel",
  bearings: "bearings",
  block: "block",
  mount: "mounts",
  tolerances: "tolerances",
  balance: "free weights",
  counterweight_design: "shapes of counterweights",
  clearance: "clearance",
  shaft_weight_design: "shapes of shaft weights",
  torsion: "torsion",
  damper: "damper",
  simulation: "run in time",
};

/** Sections within these keys of the file that it says nothing of; `present`: whether it has a path. */
export function missing(keys: readonly string[], present: (path: string) => boolean): TypicalSection[] {
  const sections = Object.keys(TYPICAL) as TypicalSection[];
  return sections.filter((section) => {
    const top = section.split(".")[0] ?? "";
    // A detail of a table is offered where the table is there: it says nothing without.
    return keys.includes(top) && !present(section) && (top === section || present(top));
  });
}

/** The section that a message asks for first, if there are typical values for it: "give `inertia` in [flywheel]". */
export function askedFor(message: string): TypicalSection | undefined {
  const sections = Object.keys(TYPICAL) as TypicalSection[];
  const named = [...message.matchAll(/\[\[?([a-z_.]+)\]/g)].map((found) => found[1]);
  return sections.find((section) => section === named[0]);
}

class Typical {
  /** Whether an answer is awaited. */
  busy = $state(false);
  /** What became of the last wish, in a sentence: what was left out, and why. */
  said = $state("");
  problem = $state.raw<Problem>();

  constructor() {
    engine.whenOpened(() => this.#forget());
  }

  #forget() {
    this.said = "";
    this.problem = undefined;
  }

  /** Inserts typical values for these sections, for all that are missing where none is named; whether any were added. */
  async insert(sections: readonly TypicalSection[]): Promise<boolean> {
    if (this.busy) return false;
    this.#forget();
    this.busy = true;
    const text = engine.text;
    try {
      const done = await post<Completed>("/api/complete", { text, sections });
      // Typing goes before: what was asked of an older text is not put in its place.
      if (engine.text !== text) return false;
      const names = done.added.map((section) => TYPICAL[section]);
      const left = done.left_out.map(({ section, why }) => `${TYPICAL[section]} is left out: ${why}`);
      this.said = [
        names.length > 0 ? `Typical values for ${names.join(", ")}` : "Nothing was added",
        ...left,
      ].join(". ");
      await engine.set(done.text, `typical values for ${names.join(", ")}`);
      return names.length > 0;
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      this.problem = error.problem;
      return false;
    } finally {
      this.busy = false;
    }
  }
}

export const typical = new Typical();
