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
  { id: "weight", name: "Counterweights", kinds: ["counterweight"], light: "#3f9d63", dark: "#54b378" },
  { id: "shaft", name: "Balance shafts", kinds: ["shaft"], light: "#8fc3cc", dark: "#8fc6d0" },
  { id: "shaft-weight", name: "Their weights", kinds: ["shaft-weight"], light: "#1f8796", dark: "#2fa0b0" },
  { id: "bore", name: "Bores", kinds: ["bore"], light: "#7d93ad", dark: "#8ea6c4" },
];

/** The part that is chosen: a colour that no metal has. */
export const MARK = { light: "#d6197f", dark: "#ff74c4" };

const BY_KIND = new Map(GROUPS.flatMap((group) => group.kinds.map((kind) => [kind, group] as const)));

export function groupOf(kind: SceneKind): Group {
  const group = BY_KIND.get(kind);
  if (!group) throw new Error(`no group shows ${kind}`);
  return group;
}
