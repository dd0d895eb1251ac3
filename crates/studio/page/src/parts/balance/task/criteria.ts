// What balancing can judge, in the words of the file.

/** Loads whose peak, or one order of which, is judged. */
export const PEAKS = ["force", "couple", "roll moment", "force x", "force y", "couple x", "couple y"];
/** What has no orders. */
export const ADDED = ["added unbalance", "added mass"];
export const BENDING = "bending moment";
/** Inertia loads of all main bearings together, and the largest of any; one by its number may be typed. */
export const MAINS = ["main-bearing load rms", "main-bearing load"];
export const MOUNTS = "mount force";
/** What a limit on the amount of every weight is called on the page: the file gives each weight its own. */
export const EACH = "each weight";

/** Values to start from, by the beginning of a criterion. */
const USUAL: readonly [string, string][] = [
  ["force", "500 N"],
  ["mount", "500 N"],
  ["couple", "50 N m"],
  ["roll", "50 N m"],
  ["bending", "500 N m"],
  ["main", "5 kN"],
  ["added unbalance", "0.05 kg m"],
  ["added mass", "2 kg"],
  [EACH, "0.02 kg m"],
];

export function usual(criterion: string): string {
  return USUAL.find(([start]) => criterion.startsWith(start))?.[1] ?? "";
}

/** Criteria to choose from where any may be typed. */
export const CRITERIA: readonly string[] = [
  ...PEAKS,
  ...["force", "couple"].flatMap((load) => ["1", "2"].map((order) => `${load} order ${order}`)),
  ...MAINS,
  BENDING,
  MOUNTS,
  ...ADDED,
];
