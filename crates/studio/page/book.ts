// Sections of the book that the page's terms lead to: they are built into the page, so that a link works without network and server.

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { section } from "./src/parts/terms/section";

const NAME = "virtual:book";
const TERMS = fileURLToPath(new URL("src/parts/terms/terms.ts", import.meta.url));
const BOOK = fileURLToPath(new URL("../../../docs/src/", import.meta.url));

export function book(): Plugin {
  return {
    name: "lanchester-book",
    resolveId: (source) => (source === NAME ? `\0${NAME}` : null),
    load(id) {
      if (id !== `\0${NAME}`) return null;
      const places = readFileSync(TERMS, "utf8").matchAll(/book: "([^"]+)"/g);
      const sections: Record<string, string> = {};
      for (const [, place = ""] of places) {
        const [page = "", anchor = ""] = place.split("#");
        const path = `${BOOK}${page}.md`;
        this.addWatchFile(path);
        const found = section(readFileSync(path, "utf8"), anchor);
        if (found === null) throw new Error(`${page}.md of the book has no heading for #${anchor}`);
        sections[place] = found;
      }
      return `export default ${JSON.stringify(sections)};`;
    },
  };
}
