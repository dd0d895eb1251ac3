// What can be shown and hidden, in the order of the legend.

import type { SceneKind } from "../api/types";

export interface Group {
  id: string;
  name: string;
  kinds: SceneKind[];
  /** Colour of the metal in the light theme and in the dark one: told apart by hue and by lightness. */
  light: string;
  dark: string;
}

export const GROUPS: Group[] = [
  { id: "piston", name: "Pistons", kinds: ["piston"], light: "#c3cad3", dark: "#d5dbe3" },
  { id: "rod", name: "Connecting rods", kinds: ["rod"], light: "#4f93d2", dark: "#5a9fe0" },
  { id: "crank", name: "Webs", kinds: ["web"], light: "#8b95a3", dark: "#8792a2" },
  { id: "pin", name: "Journals and pins", kinds: ["journal", "crankpin"], light: "#d9b25f", dark: "#e0bb6a" },
  { id: "weight", name: "Counterweights", kinds: ["counterweight"], light: "#d8743c", dark: "#e8834a" },
  { id: "shaft", name: "Balance shafts", kinds: ["shaft"], light: "#79b08c", dark: "#84bd98" },
  { id: "shaft-weight", name: "Their weights", kinds: ["shaft-weight"], light: "#2f8a57", dark: "#3fa56b" },
  { id: "bore", name: "Bores", kinds: ["bore"], light: "#7d93ad", dark: "#8ea6c4" },
];

const BY_KIND = new Map(GROUPS.flatMap((group) => group.kinds.map((kind) => [kind, group] as const)));

export function groupOf(kind: SceneKind): Group {
  const group = BY_KIND.get(kind);
  if (!group) throw new Error(`no group shows ${kind}`);
  return group;
}
