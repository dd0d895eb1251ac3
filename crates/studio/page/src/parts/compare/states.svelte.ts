// The states that are compared: the one being worked on, then the pinned ones.

import { SvelteMap } from "svelte/reactivity";
import type { Loads, Problem } from "../../api/types";
import { engine } from "../../state/engine.svelte";
import { loads } from "../../state/loads.svelte";
import { view, type Pin } from "../../state/view.svelte";

export interface Compared {
  /** Each once. */
  name: string;
  text: string;
  /** Number of its colour, from 1. */
  colour: number;
  loads: Loads | undefined;
  problem: Problem | undefined;
  pin: Pin | undefined;
}

interface Answer {
  loads: Loads | undefined;
  problem: Problem | undefined;
}

const COLOURS = 24;

/** A name that none has yet. */
export function another(name: string, names: readonly string[]): string {
  let own = name;
  for (let number = 2; names.includes(own); number++) own = `${name} (${number})`;
  return own;
}

class States {
  /** Loads of the pinned states, as they arrive. */
  answers = new SvelteMap<Pin, Answer>();

  all: Compared[] = $derived.by(() => {
    const names = ["Current state"];
    const now: Compared = {
      name: "Current state",
      text: engine.valid,
      colour: 1,
      loads: loads.now.value,
      problem: loads.now.problem,
      pin: undefined,
    };
    const pinned = view.pins.map((pin) => {
      const { loads, problem } = this.answers.get(pin) ?? { loads: undefined, problem: undefined };
      const name = another(pin.name, names);
      names.push(name);
      return { name, text: pin.text, colour: pin.colour, loads, problem, pin };
    });
    return [now, ...pinned];
  });

  /** Those that have loads. */
  drawn = $derived(
    this.all.filter((state): state is Compared & { loads: Loads } => state.loads !== undefined),
  );

  /** The state being worked on, kept beside what comes. */
  pin() {
    this.keep(engine.reading?.engine?.name ?? engine.untitled, engine.valid);
  }

  /** A text beside the state being worked on; under which name, which none has yet. */
  keep(name: string, text: string): string {
    const own = another(
      name,
      view.pins.map((pin) => pin.name),
    );
    const taken = view.pins.map((pin) => pin.colour);
    // The first colour is that of the current state.
    let colour = 2;
    while (taken.includes(colour) && colour < COLOURS) colour += 1;
    view.pins = [...view.pins, { name: own, text, colour }];
    return own;
  }

  rename(pin: Pin, name: string) {
    const own = name.trim();
    if (own === "" || own === pin.name) return;
    const renamed = { ...pin, name: own };
    const answer = this.answers.get(pin);
    if (answer) this.answers.set(renamed, answer);
    view.pins = view.pins.map((other) => (other === pin ? renamed : other));
  }

  remove(pin: Pin) {
    view.pins = view.pins.filter((other) => other !== pin);
    this.answers.delete(pin);
  }

  /** The pinned text in place of the current one; undo brings that back. */
  async open(pin: Pin) {
    await engine.set(pin.text, `open the pinned state “${pin.name}”`);
  }
}

export const states = new States();
