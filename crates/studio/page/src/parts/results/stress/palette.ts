// Colours of contours: ten bands of viridis, which keep their order for every eye and in print without colour.

export const BANDS = [
  "#440154",
  "#482878",
  "#3e4a89",
  "#31688e",
  "#26828e",
  "#1f9e89",
  "#35b779",
  "#6ece58",
  "#b5de2b",
  "#fde725",
] as const;

/** Of what lies above the scale. */
export const ABOVE = "#d6197f";

/** A round end of a scale of bands [in the unit shown], not below the largest value. */
export function roundEnd(largest: number): number {
  if (!(largest > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(largest));
  const step =
    [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find((own) => own * power >= largest * (1 - 1e-9)) ?? 10;
  return step * power;
}
