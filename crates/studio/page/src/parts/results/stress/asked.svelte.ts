// What was asked of the stress of the crankshaft, and its answers: they stay while other tabs are open.

import type { BandsFound, ModesAnswer, StressAnswer, StressPlan } from "../../../api/types";
import { Search } from "../../../state/search.svelte";
import { toSi } from "../../../state/units.svelte";
import { view } from "../../../state/view.svelte";
import { Turns } from "../../studies/turns.svelte";

export type Holds = "journals" | "clamped-ends" | "springs" | "free";

class Asked {
  readonly plan = new Search<StressPlan>("stress-plan");
  readonly cycle = new Search<StressAnswer>("stress");
  readonly modes = new Search<ModesAnswer>("stress-modes");
  /** Error bands of the fillets of what is shown, from three meshes. */
  readonly bands = new Turns<BandsFound>("stress-bands");
  shows = $state<"cycle" | "modes">("cycle");
  /** Size of the elements, in the unit that is shown. */
  size = $state<number | null>(null);
  fillet = $state<"" | "2" | "4" | "6" | "8">("");
  holds = $state<Holds>("journals");
  /** Of each journal [kN/mm]. */
  stiffness = $state<number | null>(500);
  inertiaOnly = $state(false);
  readonly now = $derived(this.shows === "cycle" ? this.cycle : this.modes);
  readonly busy = $derived(this.cycle.busy || this.modes.busy);

  #mesh(): Record<string, unknown> {
    return {
      ...(this.size === null ? {} : { size: toSi(this.size, "length") }),
      ...(this.fillet === "" ? {} : { fillet_elements: Number(this.fillet) }),
    };
  }

  #settings(): Record<string, unknown> {
    return {
      ...this.#mesh(),
      support: this.holds,
      ...(this.holds === "springs" ? { stiffness: 1e6 * (this.stiffness ?? 0) } : {}),
      ...(view.speed === undefined ? {} : { speed: view.speed }),
      ...(this.inertiaOnly ? { inertia_only: true } : {}),
    };
  }

  async compute() {
    if (this.shows === "modes") {
      await this.modes.ask("/api/stress/modes", this.#mesh());
      return;
    }
    const settings = this.#settings();
    this.cycle.busy = true;
    const plan = await this.plan.ask("/api/stress/plan", settings);
    if (!plan || !this.cycle.busy) {
      this.cycle.stop();
      this.cycle.problem = this.plan.problem;
      return;
    }
    const found = await this.cycle.ask("/api/stress", settings);
    if (found) view.theta = found.worst_theta;
  }

  /** Bands of the stress that is shown: the same speed, support and gas. */
  readonly bandsOfCycle = $derived(
    this.bands.value &&
      this.bands.text === this.cycle.text &&
      JSON.stringify(this.bands.settings) === JSON.stringify(this.cycle.settings)
      ? this.bands.value
      : undefined,
  );

  async findBands() {
    const settings = this.cycle.settings;
    await this.bands.run("/api/stress/bands", settings, (text, so_far) => ({
      stress: { text, ...settings },
      so_far,
    }));
  }

  stop() {
    this.plan.stop();
    this.cycle.stop();
    this.modes.stop();
  }
}

export const asked = new Asked();
