// How long arrows of loads are drawn: one scale that stays while the engine changes.

/** What an arrow of full length stands for. */
export interface Reach {
  /** [N] */
  force: number;
  /** Of couple and roll moment [N m]. */
  moment: number;
}

/** Arrows are drawn up to this many full lengths. */
export const LONGEST = 1.6;

/** The next of 1, 2, 5 times a power of ten. */
export function round(value: number): number {
  if (!(value > 0)) return 0;
  const power = 10 ** Math.floor(Math.log10(value));
  return ([1, 2, 5, 10].find((one) => one * power >= value * (1 - 1e-9)) ?? 10) * power;
}

/** A share of the full length, cut where the picture would end. */
export function cut(share: number): number {
  return Math.abs(share) > LONGEST ? LONGEST / Math.abs(share) : 1;
}

class ArrowScale {
  reach = $state.raw<Reach>();

  /** For loads up to these; loads that are nothing leave their scale to the first that are something. */
  fit({ force, moment }: Reach) {
    this.reach = { force: round(force), moment: round(moment) };
  }

  /** Where a kind of load has no scale yet it gets one. */
  complete({ force, moment }: Reach) {
    const now = this.reach;
    if (now && (now.force > 0 || force === 0) && (now.moment > 0 || moment === 0)) return;
    this.reach = { force: now?.force || round(force), moment: now?.moment || round(moment) };
  }
}

export const arrowScale = new ArrowScale();
