import { describe, expect, it } from "vitest";
import { arrived, placeOf, withCheck } from "./link-mending";

const LINK = "v=1&a=0.5,0,0,0.5,0,0;0.5,0,0,0.5,0.5,0&b=gasket&match=2,1&path=points:0.1,0.2;0.4,0.7&t=0.25";
const NAMED = "v=1&a=gasket&b=fern&b-name=Fern%20%26%20stalk%2C%20mine.";

const sent = (text: string) => ({ text, cutAfter: null });

/** As others send it on; each was seen in a public bug report of some mailer, chat or page. */
const CHANGES: [string, (link: string) => string][] = [
  ["nothing", (link) => link],
  ["&amp;", (link) => link.replaceAll("&", "&amp;")],
  ["&#038;", (link) => link.replaceAll("&", "&#038;")],
  ["&#38;", (link) => link.replaceAll("&", "&#38;")],
  ["&amp;amp;", (link) => link.replaceAll("&", "&amp;amp;")],
  ["&amp%3B", (link) => link.replaceAll("&", "&amp%3B")],
  ["encoded as a whole", (link) => encodeURIComponent(link)],
  ["encoded twice", (link) => encodeURIComponent(encodeURIComponent(link))],
  ["encoded commas", (link) => link.replaceAll(",", "%2C").replaceAll(";", "%3b").replaceAll(":", "%3A")],
  ["quoted-printable", (link) => link.replaceAll("=", "=3D").replace("gas", "gas=\r\n")],
  ["zero-width spaces", (link) => link.replaceAll(";", ";\u200b")],
  ["encoded zero-width spaces", (link) => `${link}%E2%80%8B`],
  ["a line break", (link) => link.replace("match", "match").replace(";0.5", ";\n 0.5")],
  ...[".", ")", ",", ">", '"', "%20", ").", "%22%3E", "”", "\u200b", "?utm_source=mail&utm_medium=x"].map(
    (behind): [string, (link: string) => string] => [`${behind} behind it`, (link) => link + behind],
  ),
];

describe("arrived", () => {
  it.each(CHANGES)("puts right: %s", (_, change) => {
    // Old links have no check word.
    expect(arrived(change(LINK)).text.replace(/&utm_.*/, "")).toBe(LINK);
    expect(arrived(change(withCheck(LINK))).text.replace(/&utm_.*/, "")).toBe(LINK);
    expect(arrived(change(withCheck(LINK))).cutAfter).toBeNull();
  });

  it("leaves the user's own words alone", () => {
    expect(arrived(NAMED)).toEqual(sent(NAMED));
    expect(arrived(withCheck(NAMED))).toEqual(sent(NAMED));
    // Only the check word tells that the mark is not a part of the name.
    expect(arrived(`${withCheck(NAMED)})`)).toEqual(sent(NAMED));
    const joined = "v=1&a=gasket&a-name=%F0%9F%91%A9%E2%80%8D%F0%9F%8E%A8";
    expect(arrived(joined)).toEqual(sent(joined));
  });

  it("tells where a link was cut off, wherever that is", () => {
    const link = withCheck(LINK);
    for (let end = "v=1&c".length; end < link.length; end++) {
      const { text, cutAfter } = arrived(link.slice(0, end));
      expect(cutAfter, link.slice(0, end)).not.toBeNull();
      expect(LINK.startsWith(text) || text === "v=1&").toBe(true);
      // A mark at the very end may be the sentence's.
      expect(link.slice(0, end)).toContain(cutAfter);
    }
    expect(arrived(link.slice(0, link.indexOf("&match"))).cutAfter).toBe("5,0.5,0&b=gasket");
  });

  it("takes what was changed by hand for what it says", () => {
    const link = withCheck(LINK);
    expect(arrived(link.replace("b=gasket", "b=dragon-3"))).toEqual(
      sent(LINK.replace("b=gasket", "b=dragon-3")),
    );
    expect(arrived(link.replace("0.4,0.7", "0.5,0.7"))).toEqual(sent(LINK.replace("0.4,0.7", "0.5,0.7")));
    // Shorter than it was, and its end is there.
    expect(arrived(link.replace("0.1,0.2", "0,0"))).toEqual(sent(LINK.replace("0.1,0.2", "0,0")));
    expect(arrived(link.replace("&b=gasket", ""))).toEqual(sent(LINK.replace("&b=gasket", "")));
    expect(arrived(`${link}&compare=1`)).toEqual(sent(`${LINK}&compare=1`));
    expect(arrived(`${link}&fbclid=x`).text).toBe(`${LINK}&fbclid=x`);
  });

  it("has nothing to say of what is no link", () => {
    for (const text of ["", "learn", "figures/c6", "v=1", "a=gasket", "%", "v%3D1%", "check=1-2"]) {
      expect(arrived(text)).toEqual(sent(text));
      expect(withCheck(text)).toBe(text);
    }
  });
});

describe("placeOf", () => {
  it.each([
    ["learn/e1/r=0.3", "learn/e1/r=0.3"],
    ["learn/e1).", "learn/e1"],
    ["figures%2Fc6%2Fshare%3D1", "figures/c6/share=1"],
    ["figures/3?utm_source=x", "figures/3"],
    ["learn/12%20", "learn/12"],
    ["learn/class/title=Class%209b%20).", "learn/class/title=Class%209b"],
  ])("%s", (written, place) => {
    expect(placeOf(written)).toBe(place);
  });
});
