// Which study is looked at, and what was found; it stays while other tabs are open.

import type { FoundLayouts, ScatterFound } from "../../api/types";
import { Turns } from "./turns.svelte";

export const STUDIES = [
  ["explore", "Explore layouts"],
  ["scatter", "Production scatter"],
  ["published", "Published methods"],
  ["workshop", "Workshop"],
] as const;
export type Study = (typeof STUDIES)[number][0];

class Studies {
  shown = $state<Study>("explore");
  readonly layouts = new Turns<FoundLayouts>("explore");
  readonly scatter = new Turns<ScatterFound>("scatter");
}

export const studies = new Studies();
