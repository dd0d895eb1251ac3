// What a search over layouts is asked for, as the form has it.

import type { WebWeights } from "../../../api/types";
import { toSi } from "../../../state/units.svelte";
import { angles, FIRING, OBJECTIVES, USUAL } from "./layouts";

export type Firing = "all" | "even" | "none";

class LayoutSearch {
  /** Empty: as the engine has it. */
  cylinders = $state<number>();
  inLine = $state(false);
  bankAngles = $state("");
  splitAngles = $state("");
  /** Parts of a turn at which throws stand; 0: the usual ones. */
  parts = $state(0);
  weights = $state<WebWeights[]>(["own"]);
  firing = $state<Firing>("all");
  minimise = $state<string[]>([...USUAL, "uneven firing"]);
  limits = $state<{ objective: string; most: number }[]>([]);

  readonly banks = $derived(angles(this.bankAngles));
  readonly splits = $derived(angles(this.splitAngles));
  /** Without firing orders, or with even ones alone, the evenness of firing tells nothing. */
  readonly judgedBy = $derived(
    this.minimise.filter((name) =>
      this.firing === "none" ? !FIRING.includes(name) : this.firing !== "even" || name !== "uneven firing",
    ),
  );
  readonly possible = $derived(
    this.banks !== undefined &&
      this.splits !== undefined &&
      this.judgedBy.length > 0 &&
      this.weights.length > 0,
  );

  /** The question but for the engine. */
  readonly settings = $derived({
    cylinders: this.cylinders ?? null,
    in_line: this.inLine,
    bank_angles: this.banks ?? null,
    split_angles: this.splits ?? null,
    throw_parts: this.parts || null,
    counterweights: this.weights,
    without_firing: this.firing === "none",
    even_firing: this.firing === "even",
    minimise: this.judgedBy,
    limits: this.limits.map(({ objective, most }) => {
      const measure = OBJECTIVES.find(([name]) => name === objective)?.[1] ?? "none";
      return { objective, most: toSi(most, measure) };
    }),
  });

  toggle(name: string) {
    const order = OBJECTIVES.map(([known]) => known);
    const next = this.minimise.includes(name)
      ? this.minimise.filter((own) => own !== name)
      : [...this.minimise, name];
    this.minimise = next.sort((a, b) => order.indexOf(a) - order.indexOf(b));
  }

  toggleWeights(weights: WebWeights) {
    this.weights = this.weights.includes(weights)
      ? this.weights.filter((own) => own !== weights)
      : [...this.weights, weights];
  }
}

export const search = new LayoutSearch();
