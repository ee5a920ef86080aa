import { scene } from "#document/scene";
import type { Tool } from "#wasm/api";
import { frond } from "#wasm/core";
import type { Figure, Row } from "../figure";
import { find, hrefOf } from "../list";
import type { Section } from "./section";
import css from "./sections.module.css";

const TOOLS: Readonly<Record<Tool, string>> = {
  morph: "Morph",
  deform: "Deform",
  fit: "Fit",
  space: "Space",
};

/** The sections of a paper, each with the ways to what shows it. */
export function Sections({ row, sections }: { row: Row; sections: readonly Section[] }) {
  return (
    <ul class={css["sections"]}>
      {sections.map((section) => (
        <li key={section.number}>
          <span class={css["number"]}>{section.number}</span>
          <div>
            <strong>{section.title}</strong>
            <p>{section.about}</p>
            <Shown row={row} section={section} />
          </div>
        </li>
      ))}
    </ul>
  );
}

function Shown({ row, section: { pages = [], also = [], tools = [] } }: { row: Row; section: Section }) {
  const ways = [
    ...[...pages, ...also].flatMap((id) => {
      const page = find(id);
      return page ? [{ href: hrefOf(page.figure), name: nameOf(page.row, page.figure, row) }] : [];
    }),
    ...tools.map((tool) => ({ href: toolHref(tool), name: `the tool ${TOOLS[tool]}` })),
  ];
  if (ways.length === 0) return null;
  return (
    <p class={css["ways"]}>
      {ways.map(({ href, name }) => (
        <a key={name} href={href}>
          {name}
        </a>
      ))}
    </p>
  );
}

/** A page of another paper says of which. */
function nameOf(its: Row, { number, title }: Figure, row: Row): string {
  const other = its.paper !== undefined && its.id !== row.id ? `${its.paper}, ` : "";
  return `${other}${number}: ${title}`;
}

/** Where a tool is, with the document as it stands. */
function toolHref(tool: Tool): string {
  try {
    return `#${frond.encodeScene({ ...scene.peek(), tool })}`;
  } catch {
    // More than a link holds: the tool with what everybody begins with.
    return `#v=1&tool=${tool}`;
  }
}
