// Complex amplitudes as arrows that turn.

type Phasor = readonly [number, number];

/** An amplitude after a turn [rad], counted as the crank turns. */
export function turnedBy(angle: number, [re, im]: Phasor): [number, number] {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [re * cos - im * sin, re * sin + im * cos];
}

/** What is left of a sum without some of its parts. */
export function less(sum: Phasor, parts: readonly Phasor[]): [number, number] {
  return parts.reduce<[number, number]>(([re, im], part) => [re - part[0], im - part[1]], [sum[0], sum[1]]);
}
