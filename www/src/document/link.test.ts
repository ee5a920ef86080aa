import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Scene } from "#wasm/api";
import { Link, parseRoute, route } from "./link";
import { notices } from "./notice";
import { canUndo, edit, endGesture, replace, scene, start, undo } from "./scene";

const blank: Scene = { ...scene.peek() };

/** A codec that holds only the moment and the first turn. */
const codec = {
  defaultScene: () => ({ ...blank }),
  encodeScene(what: Scene) {
    if (what.turns.length > 3) throw { code: "too-long", message: "Too long." };
    return `t=${what.t}&turn=${what.turns[0] ?? 0}`;
  },
  decodeScene(text: string) {
    const match = /^t=([\d.]+)&turn=(\d+)$/.exec(text);
    if (!match)
      return { scene: { ...blank }, problem: { code: "bad-link", message: "This link is damaged." } };
    return { scene: { ...blank, t: Number(match[1]), turns: [Number(match[2])] } };
  },
};

class Bar {
  text = "";
  writes = 0;
  read = () => this.text;
  write = (fragment: string) => {
    this.text = fragment;
    this.writes++;
  };
}

let bar: Bar;
let link: Link;
let stop: () => void;

beforeEach(() => {
  vi.useFakeTimers();
  start(blank);
  bar = new Bar();
  link = new Link(codec, bar);
});

afterEach(() => {
  stop?.();
  vi.useRealTimers();
});

function open(text: string): void {
  bar.text = text;
  link.open();
  stop = link.watch();
}

describe("Link", () => {
  it("writes a check word, and says where a link was cut off", () => {
    const decodeScene = (text: string) => ({
      scene: { ...blank, t: Number(/t=([\d.]+)/.exec(text)?.[1] ?? 0) },
    });
    const encodeScene = ({ t }: Scene) => `v=1&t=${t}&colour=map`;
    link = new Link({ ...codec, decodeScene, encodeScene }, bar);
    open("v=1&t=0.5&colour=map");
    expect(notices.value).toEqual([]);
    replace({ ...scene.peek(), t: 0.75 });
    link.flush();
    const written = bar.text;
    expect(written).toMatch(/^v=1&check=[0-9a-z-]+&t=0.75&colour=map$/);
    // One's own address is no link that was followed.
    link.follow();
    expect(canUndo.value).toBe(false);
    bar.text = written.slice(0, -11);
    link.follow();
    expect(scene.peek().t).toBe(0.75);
    expect(notices.value.map(({ text }) => text)).toEqual([
      "This link seems to be cut off after “t=0.75”. Ask for it again. Frond shows what is left of it.",
    ]);
  });

  it("does not write over a link that was followed while it waited", () => {
    open("t=0.5&turn=1");
    replace({ ...scene.peek(), t: 0.75 });
    bar.text = "t=0.25&turn=2";
    vi.advanceTimersByTime(5000);
    expect(bar.text).toBe("t=0.25&turn=2");
    link.follow();
    expect(scene.value).toMatchObject({ t: 0.25, turns: [2] });
    // From then on it is kept as ever.
    replace({ ...scene.peek(), t: 0.5 });
    vi.advanceTimersByTime(5000);
    expect(bar.text).toBe("t=0.5&turn=2");
  });

  it("opens the default without a fragment and leaves the address alone", () => {
    open("");
    vi.advanceTimersByTime(5000);
    expect(scene.value).toEqual(blank);
    expect(bar.writes).toBe(0);
  });

  it("opens what the address holds", () => {
    open("t=0.25&turn=2");
    expect(scene.value.t).toBe(0.25);
    expect(canUndo.value).toBe(false);
  });

  it("says so when it cannot, and opens the default", () => {
    open("gibberish");
    expect(scene.value).toEqual(blank);
    expect(notices.value.some((notice) => notice.text.includes("damaged"))).toBe(true);
  });

  it("writes a change once it has come to rest", () => {
    open("");
    for (let i = 1; i <= 50; i++) {
      replace({ ...scene.value, t: i / 100 });
      vi.advanceTimersByTime(16);
    }
    expect(bar.writes).toBe(0);
    vi.advanceTimersByTime(1000);
    expect(bar.writes).toBe(1);
    expect(bar.text).toBe("t=0.5&turn=0");
  });

  it("waits for the end of a drag", () => {
    open("");
    edit((now) => ({ ...now, turns: [4] }), { gesture: "drag" });
    vi.advanceTimersByTime(5000);
    expect(bar.writes).toBe(0);
    endGesture();
    vi.advanceTimersByTime(1000);
    expect(bar.text).toBe("t=0&turn=4");
  });

  it("follows the back button, as a step that can be undone", () => {
    open("t=0.25&turn=2");
    bar.text = "t=0.5&turn=3";
    link.follow();
    expect(scene.value.turns).toEqual([3]);
    undo();
    expect(scene.value.turns).toEqual([2]);
  });

  it("does not write into the entry of a page that was just come to", () => {
    open("t=0.25&turn=2");
    replace({ ...scene.value, t: 0.5 });
    bar.text = "figures/3";
    link.follow();
    vi.advanceTimersByTime(5000);
    expect(bar.text).toBe("figures/3");
    expect(route.value).toEqual({ page: "figures", figure: "3", state: "" });
  });

  it("comes back to the document as it was left", () => {
    open("t=0.25&turn=2");
    replace({ ...scene.value, t: 0.5 });
    link.flush();
    const left = bar.text;
    bar.text = "figures";
    link.follow();
    const before = scene.value;
    bar.text = left;
    link.follow();
    expect(scene.value).toBe(before);
    expect(route.value.page).toBe("studio");
  });

  it("says so when the document does not fit into a link", () => {
    open("");
    edit((now) => ({ ...now, turns: [1, 2, 3, 4] }));
    vi.advanceTimersByTime(1000);
    expect(bar.writes).toBe(0);
    expect(notices.value.some((notice) => notice.text.includes("Too long"))).toBe(true);
    expect(link.fragment()).toBeNull();
    // The address is that of another document: it is not to be shared.
    expect(link.flush()).toBe(false);
    edit((now) => ({ ...now, turns: [1] }));
    expect(link.flush()).toBe(true);
    expect(bar.text).toBe("t=0&turn=1");
  });

  it("keeps a document that does not fit into a link while one looks at the figures", () => {
    open("");
    edit((now) => ({ ...now, turns: [1, 2, 3, 4] }));
    bar.text = "figures";
    link.follow();
    bar.text = "";
    link.follow();
    expect(scene.value.turns).toEqual([1, 2, 3, 4]);
    expect(route.value.page).toBe("studio");
  });
});

describe("parseRoute", () => {
  it("knows the figures from documents", () => {
    expect(parseRoute("")).toEqual({ page: "studio" });
    expect(parseRoute("figures")).toEqual({ page: "figures", figure: null, state: "" });
    expect(parseRoute("figures/table-1")).toEqual({ page: "figures", figure: "table-1", state: "" });
    expect(parseRoute("v=1&a=figures")).toEqual({ page: "studio" });
    expect(parseRoute("figures/../../x")).toEqual({ page: "studio" });
    expect(parseRoute("learning")).toEqual({ page: "studio" });
  });

  it("finds a page whose address was changed on its way, and leaves alone what it is set to", () => {
    expect(parseRoute("learn/e1).")).toEqual({ page: "learn", figure: "e1", state: "" });
    const state = "title=Class%209b&says=Why%3F%20Tell.";
    expect(parseRoute(`learn/class/${state}`)).toEqual({ page: "learn", figure: "class", state });
  });

  it("knows the lessons, also by the addresses that they had", () => {
    expect(parseRoute("learn")).toEqual({ page: "learn", figure: null, state: "" });
    expect(parseRoute("learn/e1")).toEqual({ page: "learn", figure: "e1", state: "" });
    expect(parseRoute("learn/e1/at=question&r=0.3")).toEqual({
      page: "learn",
      figure: "e1",
      state: "at=question&r=0.3",
    });
    expect(parseRoute("figures/e11")).toEqual({ page: "learn", figure: "e11", state: "" });
  });
});
