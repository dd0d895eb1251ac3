// What of the results is looked at; it stays while other tabs are open.

import type { Cavitation } from "../../api/types";
import type { Seen } from "./mounts/shaken";

export const SECTIONS = [
  ["forces", "Forces and couples"],
  ["motion", "Motion"],
  ["torque", "Torque"],
  ["bearings", "Bearings"],
  ["films", "Oil films"],
  ["mounts", "Mounts"],
  ["torsion", "Torsional vibration"],
  ["crankshaft", "Inside the crankshaft"],
  ["stress", "Stress"],
  ["sensitivity", "What matters most"],
] as const;
export type Section = (typeof SECTIONS)[number][0];

export type By = "whole" | "parts" | "cylinders";

class Look {
  section = $state<Section>("forces");
  /** How loads are split. */
  by = $state<By>("whole");
  /** What the stars of the cylinders show. */
  stars = $state<"force" | "couple">("force");
  /** How the torque is split. */
  torqueBy = $state<"cause" | "cylinder">("cause");
  /** Bearings also without counterweights. */
  bare = $state(false);
  /** Share of the reciprocating forces in shear and bending. */
  share = $state(0);
  counterweights = $state(true);
  /** Model of cavitation of the oil films. */
  cavitation = $state<"file" | Cavitation>("file");
  /** Bearing whose film is unrolled; `undefined`: that with the thinnest. */
  film = $state<string>();
  /** From where the orbits of the mounts are seen. */
  seen = $state<Seen>("front");
  model = $state<"free_beam" | "throw_by_throw">("free_beam");
}

export const look = new Look();
