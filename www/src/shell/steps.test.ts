import { beforeEach, expect, it } from "vitest";
import { Link } from "#document/link";
import { canUndo, edit, replace, scene, start, undo } from "#document/scene";
import { openTool } from "#document/tool";
import type { Scene, Tool } from "#wasm/api";
import { ToolSteps } from "./steps";

const blank: Scene = { ...scene.peek() };

/** A codec that holds only the tool and the first turn. */
const codec = {
  defaultScene: () => ({ ...blank }),
  encodeScene(what: Scene) {
    if (what.turns.length > 3) throw { code: "too-long", message: "Too long." };
    return `${what.tool ?? "morph"}&${what.turns[0] ?? 0}`;
  },
  decodeScene(text: string) {
    const [tool, turn] = text.split("&");
    return { scene: { ...blank, tool: tool as Tool, turns: [Number(turn)] } };
  },
};

/** The history of a tab. */
class Tab {
  entries: { state: unknown; hash: string }[] = [{ state: null, hash: "morph&1" }];
  at = 0;
  steps: ToolSteps;
  readonly link = new Link(codec, {
    read: () => this.#here().hash,
    write: (hash) => {
      this.#here().hash = hash;
    },
  });

  constructor() {
    this.link.open();
    this.steps = this.begin();
  }

  /** As after a reload. */
  begin(): ToolSteps {
    return new ToolSteps(this.link, {
      mark: () => this.#here().state,
      write: (state, hash, begin) => {
        if (begin) this.entries = this.entries.slice(0, ++this.at);
        this.entries[this.at] = { state, hash };
      },
    });
  }

  #here() {
    const here = this.entries[this.at];
    if (!here) throw new Error("not there");
    return here;
  }

  go(by: number): void {
    this.at += by;
    this.#here();
    this.steps.came();
    this.link.follow();
  }

  /** A link of the page, or one that was pasted. */
  open(hash: string): void {
    this.entries = [...this.entries.slice(0, ++this.at), { state: null, hash }];
    this.steps.came();
    this.link.follow();
  }

  hashes = () => this.entries.map(({ hash }) => hash);
}

let tab: Tab;
let stop = () => {};
const turn = (by: number) => edit((now) => ({ ...now, turns: [by] }));

beforeEach(() => {
  stop();
  start(blank);
  tab = new Tab();
  stop = tab.steps.watch();
});

it("begins an entry with each tool, and none with what is done in one", () => {
  turn(2);
  openTool("deform");
  turn(3);
  replace({ ...scene.peek(), t: 0.5 });
  openTool("deform");
  expect(tab.hashes()).toEqual(["morph&2", "deform&2"]);
  openTool("fit");
  expect(tab.hashes()).toEqual(["morph&2", "deform&3", "fit&3"]);
});

it("goes back to the tool before, and keeps what was done meanwhile", () => {
  openTool("deform");
  turn(3);
  tab.go(-1);
  expect(scene.value).toMatchObject({ tool: "morph", turns: [3] });
  expect(tab.hashes()).toEqual(["morph&3", "deform&1"]);
  turn(4);
  tab.go(1);
  expect(scene.value).toMatchObject({ tool: "deform", turns: [4] });
  // Each of the two was a step of undo, the tools were none.
  undo();
  undo();
  expect([scene.value.turns, canUndo.value]).toEqual([[1], false]);
});

it("brings another document back as a step of undo", () => {
  openTool("deform");
  tab.open("fit&7");
  tab.go(-1);
  expect(scene.value).toMatchObject({ tool: "deform", turns: [1] });
  undo();
  expect(scene.value.turns).toEqual([7]);
  // Which was a change of the tool, too: from here on only that goes back.
  turn(5);
  tab.go(-1);
  expect(scene.value).toMatchObject({ tool: "deform", turns: [5] });
  tab.go(-1);
  expect(scene.value).toMatchObject({ tool: "morph", turns: [5] });
});

it("knows its entries after the page was loaded again", () => {
  openTool("deform");
  stop();
  tab.steps = tab.begin();
  stop = tab.steps.watch();
  turn(6);
  tab.go(-1);
  expect(scene.value).toMatchObject({ tool: "morph", turns: [6] });
});

it("leaves the address of a page alone, and what no link can hold", () => {
  tab.open("figures/3");
  openTool("space");
  expect(tab.hashes()).toEqual(["morph&1", "figures/3"]);
  tab.go(-1);
  edit((now) => ({ ...now, turns: [1, 2, 3, 4] }));
  openTool("fit");
  expect(tab.entries.length).toBe(2);
});

it("does not trust what another page has noted", () => {
  openTool("deform");
  for (const state of [1, { tool: "fit" }, { tool: "shell", of: "x" }]) {
    tab.entries[0] = { state, hash: "morph&9" };
    tab.go(-1);
    expect(scene.value.turns).toEqual([9]);
    tab.go(1);
  }
});

it("begins an entry with each shape that is chosen, to which Back leads with nothing lost", () => {
  turn(2);
  tab.steps.choosing();
  turn(5);
  turn(6);
  expect(tab.hashes().length).toBe(2);
  expect(tab.hashes()[0]).toContain("morph&2");
  // What is done afterwards is of the same entry.
  const precise = 0.1 + 0.2;
  turn(precise);
  const chosen = scene.peek();
  tab.go(-1);
  expect(scene.peek().turns).toEqual([2]);
  tab.go(1);
  expect(scene.peek()).toBe(chosen);
  undo();
  expect(scene.peek().turns).toEqual([2]);
});

it("begins none where nothing is chosen after all, or the tool changes with it", async () => {
  turn(2);
  tab.steps.choosing();
  tab.steps.choosing();
  openTool("deform");
  await Promise.resolve();
  turn(3);
  expect(tab.hashes().length).toBe(2);
  tab.go(-1);
  expect(scene.peek().tool ?? "morph").toBe("morph");
  expect(scene.peek().turns).toEqual([3]);
});
