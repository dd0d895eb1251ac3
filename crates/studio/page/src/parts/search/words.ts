// How words are compared in a search.

/** Hyphens and underscores are spaces. */
export const plain = (text: string): string => text.toLowerCase().replaceAll(/[-–_]/g, " ");

/** A plural finds its singular, and the other way round. */
const stem = (word: string) => (word.length > 3 ? word.replace(/(?<![su])s$/, "") : word);

export const stems = (wanted: string): string[] => plain(wanted).split(/\s+/).filter(Boolean).map(stem);

/** Whether a text has every word. */
export function holds(text: string, wanted: string): boolean {
  const told = plain(text);
  return stems(wanted).every((word) => told.includes(word));
}
