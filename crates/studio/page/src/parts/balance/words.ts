// Criteria, numbers of proofs and verdicts in plain words.

import type { Answer, Effect, FoundLimit, FoundStage, Load, Mains, Method, Statistic } from "../../api/types";
import { counted, type Measure } from "../../state/units.svelte";
import { orderTitle } from "../order";

/** What balancing judges; another list of criteria has the plain name among the types. */
export type Criterion = Effect["criterion"];

const MAIN_LOAD = "main-bearing load";

export function loadName(load: Load): string {
  if (typeof load === "object") {
    if ("main-load" in load) return `${MAIN_LOAD} ${load["main-load"] + 1}`;
    if ("mount-force-with-gas" in load) return `force at mount ${load["mount-force-with-gas"] + 1} with gas`;
    return `force at mount ${load["mount-force"] + 1}`;
  }
  if (load === "largest-mount-force") return "mount force";
  if (load === "largest-mount-force-with-gas") return "mount force with gas";
  if (load === "largest-main-load") return MAIN_LOAD;
  return load.replaceAll("-", " ");
}

/** The name of what counts of main-bearing loads over the cycle. */
function statisticName(statistic: Statistic, mains: Mains): string {
  const word = statistic === "peak" ? "" : ` ${statistic}`;
  if (mains === "largest" && statistic !== "peak") return `largest ${MAIN_LOAD}${word}`;
  return typeof mains === "string" ? `${MAIN_LOAD}${word}` : `${MAIN_LOAD} ${mains.one + 1}${word}`;
}

export function criterionName(criterion: Criterion): string {
  if (typeof criterion === "string") return criterion.replaceAll("-", " ");
  if ("peak" in criterion) return loadName(criterion.peak);
  if ("main-rms" in criterion) return statisticName("rms", criterion["main-rms"]);
  if ("main-mean" in criterion) return statisticName("mean", criterion["main-mean"]);
  if ("mains-with-gas" in criterion) return `${statisticName(...criterion["mains-with-gas"])} with gas`;
  return `${loadName(criterion.order[0])} ${orderTitle(criterion.order[1])}`;
}

/** What a criterion measures. */
export function measureOf(criterion: Criterion): Measure {
  if (criterion === "added-mass") return "mass";
  if (criterion === "added-unbalance") return "unbalance";
  if (criterion === "cost") return "none";
  if ("main-rms" in criterion || "main-mean" in criterion || "mains-with-gas" in criterion) return "force";
  const load = "peak" in criterion ? criterion.peak : criterion.order[0];
  const moments: Load[] = ["couple", "couple-x", "couple-y", "roll-moment", "bending-moment"];
  return moments.includes(load) ? "moment" : "force";
}

/** Whether several criteria are added, each as a share of the value given for it. */
export function isWeightedSum(stage: FoundStage): boolean {
  return stage.term_weights.length !== 1 || stage.term_weights[0] !== 1;
}

/** What an active limit costs: `relaxed by 1 kg m, the force falls by 120 N.` */
export function priceWords(limit: FoundLimit, answer: Answer): string {
  const stage = limit.stage === null || limit.stage === undefined ? undefined : answer.stages[limit.stage];
  if (!stage) return "it is reached.";
  const [only] = stage.terms;
  const objective = isWeightedSum(stage) || !only ? "weighted sum" : criterionName(only[0]);
  const price = Number(Math.abs(limit.price).toPrecision(4));
  const per = limit.price_unit.replace(/^1 /, "");
  const which = { "at-most": "made larger", "at-least": "made smaller", given: "made smaller" }[limit.side];
  const change = limit.price < 0 ? "made larger" : which;
  return `${change}, it lowers the ${objective} by ${price} ${per} (shadow price).`;
}

/** Whether the proof leaves nothing open that could be seen. */
export function isClosed(stage: FoundStage): boolean {
  return stage.gap <= 1e-6 * Math.max(Math.abs(stage.value), Number.MIN_VALUE);
}

/** A gap as part of the value. */
export function gapWords(stage: FoundStage): string {
  if (stage.value === 0 || isClosed(stage)) return "closed";
  return `${((100 * stage.gap) / Math.abs(stage.value)).toPrecision(2)} %`;
}

export function methodWords(method: Method): string {
  const times = (count: number, what: string) => `${counted(count)} ${what}${count === 1 ? "" : "s"}`;
  if (method.kind === "convex")
    return `One convex problem, solved ${times(method.solves, "time")} until its crank angles were exact: it has no other optimum.`;
  return `All choices were searched: ${times(method.nodes, "branch-and-bound node")}, ${times(method.solves, "convex problem")}. Every node that was pruned holds nothing better.`;
}

/** Angles [rad] that hold an optimum up, each once, in degrees. */
export function angleWords(angles: readonly number[], most = 8): string {
  const degrees = [...new Set(angles.map((theta) => Math.round((theta * 1800) / Math.PI) / 10))].sort(
    (a, b) => a - b,
  );
  const named = degrees.slice(0, most).map((degree) => `${degree}°`);
  return named.join(", ") + (degrees.length > most ? ` and ${degrees.length - most} more` : "");
}

/** A ratio with its sign: `−1`, `+2`. */
export function ratioName(ratio: number): string {
  return `${ratio < 0 ? "−" : "+"}${Math.abs(ratio)}`;
}
