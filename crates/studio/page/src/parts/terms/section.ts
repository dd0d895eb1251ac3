// Sections of the book: where they begin and end, and what is in them. Its own subset of Markdown, no more.

/** As the book names its headings in addresses. */
export function slug(heading: string): string {
  return heading
    .trim()
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N}_ -]/gu, "")
    .replaceAll(" ", "-");
}

const HEADING = /^(#+) (.*)$/;

/** The section of a page with its heading; without an anchor what stands before the first section. `null` where there is none. */
export function section(page: string, anchor: string): string | null {
  const lines = page.split("\n");
  let isCode = false;
  let level = 0;
  const found: string[] = [];
  for (const line of lines) {
    if (line.startsWith("```")) isCode = !isCode;
    const heading = isCode ? null : HEADING.exec(line);
    if (heading) {
      const own = heading[1]?.length ?? 0;
      if (level > 0 && (own <= level || anchor === "")) break;
      if (level === 0 && (anchor === "" || slug(heading[2] ?? "") === anchor)) level = own;
    }
    if (level > 0) found.push(line);
  }
  return level > 0 ? found.join("\n").trim() : null;
}

export type Inline = { kind: "text" | "strong" | "em" | "code"; text: string };
export type Block =
  | { kind: "heading"; words: Inline[] }
  | { kind: "paragraph"; words: Inline[] }
  | { kind: "list"; items: Inline[][] }
  | { kind: "table"; head: Inline[][]; rows: Inline[][][] }
  | { kind: "code"; text: string };

const INLINE = /`([^`]+)`|\*\*([^*]+)\*\*|\*([^*\s][^*]*)\*|\[([^\]]*)\]\([^)]*\)|\[([A-Za-z]+\d{4}\w*)\]/g;

export function inline(text: string): Inline[] {
  const found: Inline[] = [];
  let at = 0;
  for (const match of text.matchAll(INLINE)) {
    if (match.index > at) found.push({ kind: "text", text: text.slice(at, match.index) });
    const [whole, code, strong, em, link, source] = match;
    if (code !== undefined) found.push({ kind: "code", text: code });
    else if (strong !== undefined) found.push({ kind: "strong", text: strong });
    else if (em !== undefined) found.push({ kind: "em", text: em });
    else found.push({ kind: "text", text: link ?? (source === undefined ? whole : `[${source}]`) });
    at = match.index + whole.length;
  }
  if (at < text.length) found.push({ kind: "text", text: text.slice(at) });
  return found;
}

const cells = (line: string) =>
  line
    .replace(/^\||\|$/g, "")
    .split(/(?<!\\)\|/)
    .map((cell) => inline(cell.trim().replaceAll("\\|", "|")));

/** What a section consists of; pictures are left to the book. */
export function blocks(markdown: string): Block[] {
  const found: Block[] = [];
  const lines = markdown.split("\n");
  for (let at = 0; at < lines.length;) {
    const line = lines[at] ?? "";
    const heading = HEADING.exec(line);
    if (line.startsWith("```")) {
      const end = lines.findIndex((other, index) => index > at && other.startsWith("```"));
      const last = end < 0 ? lines.length : end;
      found.push({ kind: "code", text: lines.slice(at + 1, last).join("\n") });
      at = last + 1;
    } else if (heading) {
      found.push({ kind: "heading", words: inline(heading[2] ?? "") });
      at += 1;
    } else if (line.startsWith("|")) {
      const rows: string[] = [];
      while (lines[at]?.startsWith("|")) rows.push(lines[at++] ?? "");
      found.push({ kind: "table", head: cells(rows[0] ?? ""), rows: rows.slice(2).map(cells) });
    } else if (/^[*-] /.test(line)) {
      const items: string[] = [];
      for (; /^[*-] |^ +\S/.test(lines[at] ?? ""); at++) {
        const own = lines[at] ?? "";
        if (/^[*-] /.test(own)) items.push(own.slice(2));
        else items.push(`${items.pop() ?? ""} ${own.trim()}`);
      }
      found.push({ kind: "list", items: items.map(inline) });
    } else if (line.trim() === "" || line.startsWith("![")) {
      at += 1;
    } else {
      const words: string[] = [];
      while (lines[at] && !/^(```|#+ |\||[*-] |!\[)/.test(lines[at] ?? "")) words.push(lines[at++] ?? "");
      if (words.length === 0) at += 1;
      else found.push({ kind: "paragraph", words: inline(words.join(" ")) });
    }
  }
  return found;
}
