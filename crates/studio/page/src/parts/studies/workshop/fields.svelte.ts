// The sheet as its form has it; it stays while other tabs are open.

import type { Fields } from "./sheet";

class SheetFields {
  now = $state<Fields>({
    name: "crank",
    pins: 1,
    rods: 1,
    oil: "",
    share: "",
    parts: { big_end: "", bearing: "", small_end: "", piston: "", piston_pin: "", rings: "", locks: "" },
    grade: "",
    speed: "",
    mass: "",
    centre: "",
    displays: [
      { z: "", unbalance: "", angle: "" },
      { z: "", unbalance: "", angle: "" },
    ],
    planes: [
      { name: "front", z: "", radius: "" },
      { name: "rear", z: "", radius: "" },
    ],
  });
  /** Whether the open engine is the one of the sheet. */
  withEngine = $state(true);
  #followed = "";

  /** Takes pins and rods of an engine over, unless they are those of the one before: what was typed since stays. */
  follow({ pins, rods }: Pick<Fields, "pins" | "rods">) {
    const key = `${pins} ${rods}`;
    if (key === this.#followed) return;
    this.#followed = key;
    this.now.pins = pins;
    this.now.rods = rods;
  }
}

export const fields = new SheetFields();
