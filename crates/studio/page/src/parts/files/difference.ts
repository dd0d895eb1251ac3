// What differs between two texts, line by line.

export interface Line {
  sign: " " | "-" | "+";
  text: string;
}

/** Above so many pairs of lines the middle is shown as wholly replaced: the table would not fit the memory. */
const MOST_PAIRS = 4_000_000;

/** The lines of both texts in order; `-` only in the old one, `+` only in the new one. */
export function difference(before: string, after: string): Line[] {
  const a = before.split("\n");
  const b = after.split("\n");
  let head = 0;
  while (head < a.length && head < b.length && a[head] === b[head]) head += 1;
  let tail = 0;
  while (
    tail < a.length - head &&
    tail < b.length - head &&
    a[a.length - 1 - tail] === b[b.length - 1 - tail]
  )
    tail += 1;
  const same = (text: string): Line => ({ sign: " ", text });
  return [
    ...a.slice(0, head).map(same),
    ...middle(a.slice(head, a.length - tail), b.slice(head, b.length - tail)),
    ...a.slice(a.length - tail).map(same),
  ];
}

/** By the longest common subsequence. */
function middle(a: string[], b: string[]): Line[] {
  const out = a.map((text): Line => ({ sign: "-", text }));
  const into = b.map((text): Line => ({ sign: "+", text }));
  if (a.length * b.length > MOST_PAIRS) return [...out, ...into];
  const width = b.length + 1;
  const common = new Uint32Array((a.length + 1) * width);
  for (let i = a.length - 1; i >= 0; i -= 1)
    for (let j = b.length - 1; j >= 0; j -= 1)
      common[i * width + j] =
        a[i] === b[j]
          ? common[(i + 1) * width + j + 1]! + 1
          : Math.max(common[(i + 1) * width + j]!, common[i * width + j + 1]!);
  const lines: Line[] = [];
  let i = 0;
  let j = 0;
  while (i < a.length && j < b.length) {
    if (a[i] === b[j]) {
      lines.push({ sign: " ", text: a[i]! });
      i += 1;
      j += 1;
    } else if (common[(i + 1) * width + j]! >= common[i * width + j + 1]!) lines.push(out[i++]!);
    else lines.push(into[j++]!);
  }
  return [...lines, ...out.slice(i), ...into.slice(j)];
}

/** A run of lines that are shown; `left`: how many equal lines before it are not. */
export interface Hunk {
  left: number;
  lines: Line[];
}

/** The changed lines with a few equal ones around them. */
export function hunks(lines: Line[], around = 2): Hunk[] {
  const near = lines.map((_, at) =>
    lines.slice(Math.max(0, at - around), at + around + 1).some((line) => line.sign !== " "),
  );
  const found: Hunk[] = [];
  let left = 0;
  lines.forEach((line, at) => {
    if (!near[at]) {
      left += 1;
      return;
    }
    if (left > 0 || found.length === 0) found.push({ left, lines: [] });
    left = 0;
    found.at(-1)?.lines.push(line);
  });
  return found;
}
