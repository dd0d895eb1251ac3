// Mathematics that the server wrote.

/** Draws MathML of the server, whose names are escaped there. */
export const drawn = (mathml: string) => (node: HTMLElement) => {
  node.innerHTML = mathml;
};
