declare module "virtual:book" {
  /** Markdown of the sections that terms lead to, by page and anchor. */
  const sections: Record<string, string>;
  export default sections;
}
