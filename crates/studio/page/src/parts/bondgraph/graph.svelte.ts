// The graph file that is looked at: it stays while other tabs are seen.

class GraphFile {
  /** Text of the file; empty before one is opened. */
  text = $state("");
  /** What it is called in the list of examples; empty for a file of the user's own. */
  name = $state("");
  /** What was assumed for the graph of an engine. */
  notes = $state.raw<string[]>([]);
  /** Texts of other graphs and tables that were opened beside it, by their names. */
  parts = $state.raw<Record<string, string>>({});
  /** The bond whose curves are seen; empty: the one that carries the most. */
  bond = $state("");
  /** Place of the cursor among the samples, from 0 to 1. */
  cursor = $state(0);

  open(text: string, name = "", notes: string[] = [], parts: Record<string, string> = {}) {
    this.text = text;
    this.name = name;
    this.notes = notes;
    this.parts = parts;
    this.cursor = 0;
    this.bond = "";
  }
}

export const graphFile = new GraphFile();
