import { describe, expect, it, vi } from "vitest";
import { type Field, flag, list, number, oneOf, parts, point, text, whole } from "./fields";
import { addressOf, PageState, valuesIn } from "./page-state";

describe("fields", () => {
  const places = list(point(-2, 2), 0, 3, ";");
  const eye = parts({ turn: number(0, 360, 1), name: oneOf(["near", "far"]) });
  it.each<[string, Field<never>, unknown, string]>([
    ["a number", number(0, 1) as Field<never>, 0.3125, "0.3125"],
    ["a small number", number(0, 1, 9) as Field<never>, 2e-9, "2e-9"],
    ["a whole number", whole(-5, 5) as Field<never>, -3, "-3"],
    ["a word", oneOf(["a", "b"]) as Field<never>, "b", "b"],
    ["a text", text(/[12]{0,4}/) as Field<never>, "121", "121"],
    ["on", flag as Field<never>, true, "1"],
    ["a point", point(-2, 2) as Field<never>, [0.5, -1.25], "0.5,-1.25"],
    [
      "several points",
      places as Field<never>,
      [
        [0, 1],
        [1, 2],
      ],
      "0,1;1,2",
    ],
    ["no points", places as Field<never>, [], ""],
    ["parts", eye as Field<never>, { turn: 12.5, name: "far" }, "12.5,far"],
  ])("write %s and read it back", (_, field, value, written) => {
    expect(field.write(value as never)).toBe(written);
    expect(field.read(written)).toEqual(value);
  });

  it.each<[string, Field<never>, string]>([
    ["what is no number", number(0, 1) as Field<never>, "0x1"],
    ["nothing", number(0, 1) as Field<never>, ""],
    ["infinity", number(-1e9, Infinity) as Field<never>, "Infinity"],
    ["beyond the range", number(0, 1) as Field<never>, "1.01"],
    ["a fraction for a whole number", whole(0, 9) as Field<never>, "1.5"],
    ["another word", oneOf(["a"]) as Field<never>, "constructor"],
    ["a text of another form", text(/[12]{0,4}/) as Field<never>, "12121"],
    ["another line", text(/[12]*/) as Field<never>, "12\n<b>"],
    ["half of a point", point(0, 1) as Field<never>, "0.5"],
    ["too many points", places as Field<never>, "0,0;0,0;0,0;0,0"],
    ["one bad point", places as Field<never>, "0,0;x,0"],
    ["more parts than there are", eye as Field<never>, "1,far,1"],
    ["fewer", eye as Field<never>, "1"],
  ])("do not read %s", (_, field, written) => {
    expect(field.read(written)).toBeNull();
  });
});

describe("the address of a page", () => {
  it("is read as it was written", () => {
    const values = [
      ["at", "question"],
      ["way", "0.3,0.6;1,1"],
      ["said", "50% & more, “ja” + #"],
    ] as const;
    expect(addressOf(values.slice(0, 2))).toBe("at=question&way=0.3,0.6;1,1");
    expect([...(valuesIn(addressOf(values)) ?? [])]).toEqual(values);
    expect(valuesIn("")?.size).toBe(0);
  });

  it.each(["<b>=1", "a=%", "=", `a=${"1".repeat(5000)}`])("is not read from %s", (address) => {
    const onUnread = vi.fn();
    expect(valuesIn(address)).toBeNull();
    new PageState("learn/e1", address, onUnread);
    expect(onUnread).toHaveBeenCalledOnce();
  });

  it("opens what it says, and tells of what it cannot read", () => {
    const onUnread = vi.fn();
    const page = new PageState("learn/e1", "t=0.5&s=ten", onUnread);
    expect(page.opened("t", number(0, 1))).toBe(0.5);
    expect(page.opened("u", number(0, 1))).toBeNull();
    expect(onUnread).not.toHaveBeenCalled();
    expect(page.opened("s", number(0, 1))).toBeNull();
    expect(onUnread).toHaveBeenCalledOnce();
  });

  it("holds what is noted, and no more", () => {
    const page = new PageState("learn/e1", "t=0.5");
    expect(page.fragment()).toBe("#learn/e1");
    page.note("s", "1");
    page.note("t", "0.25");
    page.note("s", null);
    expect(page.fragment([["at", "picture"]])).toBe("#learn/e1/at=picture&t=0.25");
  });
});
