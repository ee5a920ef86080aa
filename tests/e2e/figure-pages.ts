import type { Page } from "@playwright/test";
import { ROWS } from "../../www/src/figures/list";

type RowId = "from-the-paper" | "deformation" | "rough-curves" | "in-space" | "lessons";

/** The addresses of a row of figures, from the page's own list: a new figure is tested like the others. */
export function idsOf(id: RowId): string[] {
  return ROWS.find((row) => row.id === id)?.figures.map((figure) => figure.id) ?? [];
}

export const ALL: readonly string[] = ROWS.flatMap(({ figures }) => figures.map(({ id }) => id));

/** Opens the page of a figure, or of all where there is none named, anew. */
export async function open(page: Page, figure: string): Promise<void> {
  if (page.url() !== "about:blank") await page.goto("about:blank");
  await page.goto(`./#figures${figure === "" ? "" : `/${figure}`}`);
  await page.getByRole("heading", { level: 1 }).waitFor();
}
