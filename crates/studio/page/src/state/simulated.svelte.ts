// The simulated run, and its playback in the 3-D view: both tabs show the same one.

import type { SimulationAnswer } from "../api/types";
import { type BlockPose, blockAt, thetaAt } from "../parts/simulate/simulated";
import { Search } from "./search.svelte";
import { view } from "./view.svelte";

class Simulated {
  readonly search = new Search<SimulationAnswer>("simulate");
  /** Time of the playback and of the markers in plots [s]. */
  #time = $state(0);
  playing = $state(false);
  /** By how much slower than the run it is shown. */
  slower = $state(20);
  /** By how much larger than it is the motion of the block is drawn. */
  magnification = $state(50);

  get time(): number {
    return this.#time;
  }

  /** The crank of the 3-D view follows. */
  set time(time: number) {
    this.#time = time;
    const run = this.search.value;
    if (run) view.theta = thetaAt(run, time);
  }

  /** Where the block is drawn; `null` without a run, or with a block that stands still. */
  readonly block: BlockPose | null = $derived.by(() => {
    const run = this.search.value;
    return run && !this.search.stale ? blockAt(run, this.#time, this.magnification) : null;
  });
}

export const simulated = new Simulated();
