/** Finds elements as Playwright does, where a browser is driven by plain WebDriver. */

/** One step of a way to an element; a pattern crosses to the page as its source. */
export type Step =
  | { by: "css" | "test"; text: string }
  | { by: "text" | "label"; match: Match }
  | { by: "role"; role: string; match?: Match }
  | { by: "first" };

export interface Match {
  text: string;
  flags?: string;
  exact?: boolean;
}

export function matching(name: string | RegExp, exact = false): Match {
  return typeof name === "string" ? { text: name, exact } : { text: name.source, flags: name.flags };
}

/** The visible elements at the end of one of the ways. It runs in the page as its text, and names nothing outside. */
export function find(ways: Step[][]): Element[] {
  const tags: Record<string, string> = {
    button: "button, summary",
    link: "a[href]",
    slider: "input[type=range]",
    spinbutton: "input[type=number]",
    radio: "input[type=radio]",
    heading: "h1, h2, h3, h4",
    region: "section",
    dialog: "dialog",
    main: "main",
  };
  const plain = (text: string | null | undefined) => (text ?? "").replace(/\s+/g, " ").trim();
  const fits = (text: string, match: Match | undefined) => {
    if (!match) return true;
    if (match.flags !== undefined) return new RegExp(match.text, match.flags).test(text);
    return match.exact ? text === match.text : text.toLowerCase().includes(match.text.toLowerCase());
  };
  const name = (element: Element): string => {
    const others = element.getAttribute("aria-labelledby")?.split(/\s+/) ?? [];
    if (others.length > 0)
      return plain(others.map((id) => document.getElementById(id)?.textContent).join(" "));
    const label = element.getAttribute("aria-label");
    if (label) return plain(label);
    const labels = [...((element as HTMLInputElement).labels ?? [])];
    if (labels.length > 0) return plain(labels.map(({ textContent }) => textContent).join(" "));
    return plain(element.textContent) || plain(element.getAttribute("title"));
  };
  const within = (root: ParentNode, step: Step): Element[] => {
    if (step.by === "css") return [...root.querySelectorAll(step.text)];
    if (step.by === "test") return [...root.querySelectorAll(`[data-testid="${step.text}"]`)];
    if (step.by === "label")
      return [...root.querySelectorAll("input, select, textarea")].filter((it) => fits(name(it), step.match));
    if (step.by === "role") {
      const implied = tags[step.role];
      const css = `[role=${step.role}]${implied ? `, :is(${implied}):not([role])` : ""}`;
      return [...root.querySelectorAll(css)].filter((it) => fits(name(it), step.match));
    }
    if (step.by === "text") {
      const all = [...root.querySelectorAll("*")].filter((it) => fits(plain(it.textContent), step.match));
      // The innermost.
      return all.filter((it) => !all.some((other) => other !== it && it.contains(other)));
    }
    return [];
  };
  const ends = ways.map((steps) =>
    steps.reduce<(Document | Element)[]>(
      (roots, step) =>
        step.by === "first" ? roots.slice(0, 1) : [...new Set(roots.flatMap((root) => within(root, step)))],
      [document],
    ),
  );
  return ends.flat().filter((it): it is Element => it instanceof Element && it.checkVisibility());
}
