// The way from an engine with unbalances to one whose counterweights can be designed: one section of the file after the other.

import type { Edit, EngineSummary, FileEntry } from "../../api/types";
import { apart, type Written } from "../balance/devices/devices";
import type { Sizes } from "./shape/sizes";
import { bodyEdits, clearanceStart, onFreeWebs, ontoWebs, shapesStart, webEdits } from "./start";

export interface Step {
  name: string;
  section: string;
  done: boolean;
  /** What adds the section; none as long as something before it is missing. */
  edits: Edit[] | undefined;
}

/** The steps in their order; `sizes`: none where the file names no bore. */
export function steps(
  engine: EngineSummary,
  entries: readonly FileEntry[],
  sizes: Sizes | undefined,
): [Step, ...Step[]] {
  const written: Written = (path) => entries.find((entry) => entry.path === path)?.value;
  const { counterweights } = engine;
  const short = counterweights.some((weight) => weight.path === null);
  const onWeb = counterweights.some((weight) =>
    weight.path === null ? /^web \d+$/.test(weight.name) : written(`${weight.path}.web`) !== undefined,
  );
  const one = (path: string, value: unknown): Edit[] => [{ path, value }];

  function webs(of: Sizes): Edit[] | undefined {
    if (counterweights.length > 0 && !short) return ontoWebs(counterweights, written, of.free);
    const has = entries.some((entry) => entry.path.startsWith("counterweights."));
    return [
      ...webEdits(of, entries),
      has
        ? { path: "counterweights.at", value: "webs" }
        : {
            path: "counterweights",
            value: { rotating_share: "100 %", reciprocating_share: "0 %", at: "webs" },
          },
    ];
  }

  return [
    {
      name: "Counterweights on the webs",
      section: "counterweights",
      done: onWeb,
      edits: sizes && webs(sizes),
    },
    {
      name: "Journals, pins and webs as bodies",
      section: "crank.body",
      done: engine.has_crank_body,
      edits: sizes && bodyEdits(sizes, entries),
    },
    {
      name: "Shapes to choose from",
      section: "counterweight_design",
      done: engine.has_shape_task,
      edits: sizes && one("counterweight_design", shapesStart(sizes)),
    },
    {
      name: "What the crankshaft must not touch",
      section: "clearance",
      done: engine.has_envelope,
      edits: sizes && one("clearance", clearanceStart(sizes)),
    },
    {
      name: "Each weight an entry of its own",
      section: "counterweight",
      done: !short && counterweights.length > 0,
      edits:
        sizes && onWeb && engine.has_crank_body
          ? apart({ ...engine, counterweights: onFreeWebs(counterweights, sizes.free) })
          : undefined,
    },
  ];
}
