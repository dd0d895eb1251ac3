// The graph file that is looked at: it stays while other tabs are seen.

class GraphFile {
  /** Text of the file; empty before one is opened. */
  text = $state("");
  /** What it is called in the list of examples; empty for a file of the user's own. */
  name = $state("");
  /** What was assumed for the graph of an engine. */
  notes = $state.raw<string[]>([]);
  /** Place of the cursor among the samples, from 0 to 1. */
  cursor = $state(0);

  open(text: string, name = "", notes: string[] = []) {
    this.text = text;
    this.name = name;
    this.notes = notes;
    this.cursor = 0;
  }
}

export const graphFile = new GraphFile();
