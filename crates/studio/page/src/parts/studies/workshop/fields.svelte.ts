// The sheet as its form has it; it stays while other tabs are open.

import type { Fields } from "./sheet";

class SheetFields {
  now = $state<Fields>({
    name: "crank",
    pins: 0,
    rods: 1,
    oil: "",
    share: "",
    parts: { big_end: "", bearing: "", small_end: "", piston: "", piston_pin: "", rings: "", locks: "" },
    grade: "",
    speed: "",
    mass: "",
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
}

export const fields = new SheetFields();
