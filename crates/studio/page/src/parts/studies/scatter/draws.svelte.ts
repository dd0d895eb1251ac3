// What a production scatter is asked for, as the form has it.

class Draws {
  samples = $state(100_000);
  seed = $state(1);
  capability = $state(1.33);
  limits = $state("");
  ordersOnly = $state(false);

  readonly settings = $derived({
    samples: this.samples,
    seed: this.seed,
    orders_only: this.ordersOnly,
    capability: this.capability,
    limits: this.limits
      .split(";")
      .map((limit) => limit.trim())
      .filter((limit) => limit !== ""),
  });
}

export const draws = new Draws();
