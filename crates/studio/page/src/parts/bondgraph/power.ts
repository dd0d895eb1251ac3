// How wide a bond is drawn for the power that it carries, and the numbers of a file that may be changed.

/** Width of the bond that carries the most [px]. */
export const WIDEST = 14;

/** Largest power of all bonds over all samples [W]. */
export function largest(bonds: readonly { power: readonly number[] }[]): number {
  let most = 0;
  for (const { power } of bonds) for (const value of power) most = Math.max(most, Math.abs(value));
  return most;
}

/** Area goes with power as the eye sees it: the width with its root. */
export function width(power: number | undefined, most: number): number {
  return power === undefined || most === 0 ? 0 : WIDEST * Math.sqrt(Math.abs(power) / most);
}

/** Sample that a cursor from 0 to 1 stands at. */
export function sample(cursor: number, count: number): number {
  return Math.max(0, Math.min(count - 1, Math.round(cursor * (count - 1))));
}

/** A parameter of a graph file: its name, number and what stands behind the number. */
export interface Parameter {
  name: string;
  number: number;
  unit: string;
}

/** The graph file among files that were opened together: the one that no other uses. */
export function chief<T extends { name: string; text: string }>(files: readonly T[]): T | undefined {
  const graphs = files.filter(({ name }) => name.endsWith(".toml"));
  const isUsed = (own: T) => graphs.some((other) => other !== own && other.text.includes(`${own.name}"`));
  return graphs.find((own) => !isUsed(own)) ?? graphs[0];
}

const LINE = /^\s*([A-Za-z_]\w*)\s*=\s*"([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*([^"]*)"/;

/** Parameters that are one number with its unit, in the order of the file. */
export function parameters(text: string): Parameter[] {
  const found: Parameter[] = [];
  let within = false;
  for (const line of text.split("\n")) {
    if (/^\s*\[/.test(line)) within = line.trim().startsWith("[parameters]");
    const parts = within ? LINE.exec(line) : null;
    const number = Number(parts?.[2]);
    if (parts?.[1] && Number.isFinite(number) && isUnit(parts[3] ?? ""))
      found.push({ name: parts[1], number, unit: parts[3] ?? "" });
  }
  return found;
}

/** What goes on after a number as an expression is no unit. */
function isUnit(rest: string): boolean {
  return !/^[-+*/^(]/.test(rest.trim()) && !/[+(]/.test(rest);
}

/** The file with another number for a parameter; everything else stays as it is. */
export function withNumber(text: string, name: string, number: number): string {
  let within = false;
  const lines = text.split("\n").map((line) => {
    if (/^\s*\[/.test(line)) within = line.trim().startsWith("[parameters]");
    const parts = within ? LINE.exec(line) : null;
    if (parts?.[1] !== name || parts[2] === undefined) return line;
    const at = line.indexOf(parts[2], line.indexOf('"'));
    return line.slice(0, at) + String(number) + line.slice(at + parts[2].length);
  });
  return lines.join("\n");
}
