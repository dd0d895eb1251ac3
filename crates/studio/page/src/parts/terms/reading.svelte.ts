// Which section of the book is open.

class Reading {
  /** The term whose section is read. */
  term = $state<string>();
}

export const reading = new Reading();
