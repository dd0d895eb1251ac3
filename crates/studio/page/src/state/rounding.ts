// The one rule of rounding, as the program's reports have it: a value below a billionth of the largest of its kind is
// rounding and is shown as 0. Of one kind is what is added up in the same sum, or could be.

/** A value below this share of the largest of its kind is rounding. */
const SHARE = 1e-9;
/** Moments of forces through one point vanish with all their parts: at this lever [m] the forces tell what is rounding. */
const LEVER = 0.01;

/** Below this values are rounding, where the largest of their kind is the largest of `values`, in the same unit. */
export function below(...values: (number | null | undefined)[]): number {
  return SHARE * values.reduce((most: number, one) => Math.max(most, Math.abs(one || 0)), 0);
}

/** The value, or 0 where it is not above `noise`. */
export function clean(value: number, noise: number): number {
  return Math.abs(value) <= noise ? 0 : value;
}

/** The largest of a kind of moments of forces up to `force`: at least theirs at a lever of a centimetre. */
export function largestMoment(moment: number, force: number): number {
  return Math.max(Math.abs(moment), LEVER * Math.abs(force));
}
