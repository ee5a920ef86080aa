/**
 * Steps of the browser's history between the tools, and to each shape that is chosen: its back button returns to the
 * tool before, or to the shapes before.
 *
 * Where the document is still the one that was open there, only the tool goes back, and all that was done meanwhile
 * stays: whoever goes back wants to leave a tool, and has Undo for what was made in it. An entry of another document
 * brings that one back, as any link does, and that can be undone.
 */
import { effect } from "@preact/signals";
import { onChoice } from "#document/editing/choice";
import { openings, route } from "#document/link";
import { selection } from "#document/morph";
import { edit, scene } from "#document/scene";
import { openTool } from "#document/tool";
import { endEditing } from "#tools/morph/dialogs";
import type { Scene, Tool } from "#wasm/api";

/** What is noted with an entry of the history: the tool, and which document of this tab it is. */
interface Mark {
  tool: Tool;
  of: string;
}

/** The browser's history, or the tests' own. */
export interface Entries {
  /** What is noted with the present one. */
  mark(): unknown;
  /** Writes into the present one, or begins another. */
  write(mark: Mark, fragment: string, begin: boolean): void;
}

/** What is needed of the link between document and address. */
interface Linked {
  fragment(change?: Partial<Scene>): string | null;
  /** The address was changed from outside. */
  follow(): void;
  holding: boolean;
}

export class ToolSteps {
  readonly #link: Linked;
  readonly #entries: Entries;
  #document: string;
  #tool = toolNow();
  #opened = openings.peek();
  /** What was there at the entries that a choice of shapes has left, or gone back from. */
  readonly #left = new Map<string, Scene>();
  #stopWaiting = () => {};

  constructor(link: Linked, entries: Entries) {
    this.#link = link;
    this.#entries = entries;
    this.#document = read(entries.mark())?.of ?? another();
  }

  /** Begins an entry with each change of the tool. Returns the end of it. */
  watch(): () => void {
    return effect(() => {
      const to = scene.value.tool ?? "morph";
      const from = this.#tool;
      this.#tool = to;
      if (openings.peek() !== this.#opened) {
        this.#opened = openings.peek();
        this.#document = read(this.#entries.mark())?.of ?? another();
      } else if (to !== from) this.#begin(from, to);
    });
  }

  /** A shape is about to be chosen, now or when what it takes is there: it begins an entry. */
  choosing(): void {
    this.#stopWaiting();
    const before = scene.peek();
    const left = this.#link.fragment();
    const tool = this.#tool;
    const stop = effect(() => {
      if (scene.value === before) return;
      this.#stopWaiting();
      const here = this.#link.fragment();
      // A change of the tool begins an entry by itself.
      if (toolNow() !== tool || route.peek().page !== "studio" || left === null || here === null) return;
      this.#left.set(this.#document, before);
      this.#entries.write({ tool, of: this.#document }, left, false);
      this.#document = another();
      this.#entries.write({ tool, of: this.#document }, here, true);
      this.#link.follow();
    });
    const timer = setTimeout(() => this.#stopWaiting(), CHOICE_MS);
    this.#stopWaiting = () => {
      clearTimeout(timer);
      this.#stopWaiting = () => {};
      stop();
    };
  }

  #begin(from: Tool, to: Tool): void {
    const left = this.#link.fragment({ tool: from });
    const here = this.#link.fragment();
    // The address is that of a page, or of another document where no link can hold this one.
    if (route.peek().page !== "studio" || left === null || here === null) return;
    const of = this.#document;
    this.#entries.write({ tool: from, of }, left, false);
    this.#entries.write({ tool: to, of }, here, true);
    this.#link.follow();
  }

  /** The browser went to another entry, and `Link.follow` is still to come: it finds the address up to date. */
  came(): void {
    const mark = read(this.#entries.mark());
    if (!mark) return;
    const there = mark.of === this.#document ? null : this.#left.get(mark.of);
    if (there === undefined) return;
    // Not one more entry.
    this.#tool = mark.tool;
    if (there) {
      this.#left.set(this.#document, scene.peek());
      this.#document = mark.of;
      edit(() => there);
    } else openTool(mark.tool);
    const fragment = this.#link.fragment();
    this.#entries.write(mark, fragment ?? "", false);
  }
}

/** So long a choice may take: what is only fetched for it comes over the network. */
const CHOICE_MS = 10_000;

const toolNow = (): Tool => scene.peek().tool ?? "morph";

/** Over a reload, too, no two of a tab are called the same. */
const another = () => Math.random().toString(36).slice(2);

const TOOLS: readonly unknown[] = ["morph", "deform", "fit", "space"] satisfies Tool[];

/** Other pages of this host may have written there. */
function read(mark: unknown): Mark | null {
  if (typeof mark !== "object" || mark === null) return null;
  const { tool, of } = mark as Partial<Mark>;
  return typeof of === "string" && TOOLS.includes(tool) ? { tool: tool as Tool, of } : null;
}

/** The history of this tab. */
const tab: Entries = {
  mark: () => history.state,
  write(mark, fragment, begin) {
    history[begin ? "pushState" : "replaceState"](mark, "", `#${fragment}`);
    here = placeNow();
  },
};

/** Where in the browser's history the page was last. */
let here: number | null = null;

/** Which entry of the browser's history this is; null where the browser does not say. */
function placeNow(): number | null {
  const { navigation } = globalThis as { navigation?: { currentEntry?: { index: number } | null } };
  return navigation?.currentEntry?.index ?? null;
}

/** Closes a dialog, or ends editing; false where there is neither. */
function leaveOne(): boolean {
  const dialog = [...document.querySelectorAll("dialog[open]")].at(-1);
  if (dialog) dialog.dispatchEvent(new Event("cancel", { cancelable: true }));
  else if (selection.peek() && route.peek().page === "studio") endEditing();
  else return false;
  return true;
}

export function beStepped(link: Linked): void {
  const steps = new ToolSteps(link, tab);
  steps.watch();
  onChoice(() => steps.choosing());
  here = placeNow();
  addEventListener("popstate", () => {
    const from = here;
    here = placeNow();
    if (link.holding) {
      // The word that the address has changed comes with this one, and is nobody's.
      setTimeout(() => {
        link.holding = false;
      });
      return;
    }
    // Back leaves what lies over the page first, and all else stays. A link that is pressed leads on.
    if (from !== null && here !== null && here < from && leaveOne()) {
      link.holding = true;
      history.go(from - here);
      return;
    }
    steps.came();
  });
}
