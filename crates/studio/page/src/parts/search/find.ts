// What the search of the studio finds: engines of the gallery, places of the page, numbers of the engine file, terms.

import type { KeyTable, TemplateInfo } from "../../api/types";
import { SECTIONS, type Section } from "../results/look.svelte";
import { STUDIES, type Study } from "../studies/studies.svelte";
import { TERMS } from "../terms/terms";
import { usualNames } from "./gallery";
import { plain, stems } from "./words";
import type { Tab } from "../../state/view.svelte";

export type Goal =
  | { kind: "engine"; template: TemplateInfo }
  | { kind: "place"; tab: Tab; section?: Section; study?: Study }
  | { kind: "key"; path: string }
  | { kind: "term"; term: string };

export interface Entry {
  name: string;
  about: string;
  /** Words that lead to it besides these. */
  also: string;
  goal: Goal;
}

const PLACES: { name: string; about: string; also: string; tab: Tab }[] = [
  {
    name: "Engine",
    about: "Form, sketch and text of the engine file",
    also: "edit numbers cylinders",
    tab: "engine",
  },
  {
    name: "3-D view",
    about: "The crank train as it turns, with its loads",
    also: "picture arrows",
    tab: "view",
  },
  {
    name: "Balance",
    about: "Counterweights and balance shafts, and their optimum",
    also: "optimise devices shafts arrangement",
    tab: "balance",
  },
  {
    name: "Counterweight",
    about: "Shapes of counterweights, clearance, files for CAD",
    also: "step stl export crankshaft body",
    tab: "counterweight",
  },
  {
    name: "Simulate",
    about: "The crank train in time, with events",
    also: "run misfire reactions",
    tab: "simulate",
  },
  { name: "Compare", about: "Pinned states side by side", also: "pins difference", tab: "compare" },
  { name: "Bond graph", about: "Drawing, causality and equations", also: "power poles", tab: "bondgraph" },
];

const ABOUT: Partial<Record<Section | Study, string>> = {
  forces: "What shakes the block, by angle and order",
  motion: "Travel, velocity and acceleration of the pistons",
  torque: "Torque, pressures, speed fluctuation and flywheel",
  bearings: "Loads of pins and main bearings",
  films: "Film thickness, pressure and heat of the bearings",
  mounts: "The block on its mounts",
  torsion: "Twist of the crankshaft over speed, dampers",
  crankshaft: "Shear and bending within the crankshaft",
  stress: "Finite elements, fillets with their error band, modes",
  sensitivity: "Which number of the engine changes what",
  explore: "Search over layouts, with cylinder spacing and balance shafts",
  scatter: "What tolerances do to a production",
  published: "Methods of the literature beside the optimum",
  workshop: "Bobweights, balancing from measurements, grades",
};

/** All that can be found. */
export function entries(templates: readonly TemplateInfo[], tables: readonly KeyTable[]): Entry[] {
  const places = PLACES.map(({ tab, ...one }): Entry => ({ ...one, goal: { kind: "place", tab } }));
  const sections = SECTIONS.map(([section, name]): Entry => ({
    name,
    about: ABOUT[section] ?? "",
    also: "results",
    goal: { kind: "place", tab: "results", section },
  }));
  const studies = STUDIES.map(([study, name]): Entry => ({
    name,
    about: ABOUT[study] ?? "",
    also: "studies",
    goal: { kind: "place", tab: "studies", study },
  }));
  const engines = templates.map((template): Entry => ({
    name: template.title,
    about: "Engine of the gallery",
    also: `${template.name} ${usualNames(template.name)}`,
    goal: { kind: "engine", template },
  }));
  const terms = TERMS.map(({ name, also, words }): Entry => ({
    name: name.charAt(0).toUpperCase() + name.slice(1),
    about: words,
    also: also ?? "",
    goal: { kind: "term", term: name },
  }));
  const keys = tables
    .filter(({ path }) => !path.includes("[]"))
    .flatMap(({ path, keys }) =>
      keys.map((key): Entry => {
        const own = path === "" ? key.name : `${path}.${key.name}`;
        return { name: own, about: key.doc, also: "", goal: { kind: "key", path: own } };
      }),
    );
  return [...places, ...sections, ...studies, ...terms, ...engines, ...keys];
}

/** What has every word; the name counts before other words, these before the explanation. */
export function find(all: readonly Entry[], wanted: string): Entry[] {
  const words = stems(wanted);
  if (words.length === 0) return [];
  const rated = all.flatMap((entry) => {
    const fields = [entry.name, entry.also, entry.about].map(plain);
    const ranks = words.map((word) => {
      const at = fields.findIndex((field) => field.includes(word));
      return at < 0 ? Infinity : 2 * at + (fields[at]?.startsWith(word) ? 0 : 1);
    });
    const rank = ranks.reduce((sum, own) => sum + own, 0);
    return Number.isFinite(rank) ? [{ entry, rank }] : [];
  });
  return rated.sort((a, b) => a.rank - b.rank).map(({ entry }) => entry);
}
