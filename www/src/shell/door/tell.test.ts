import { expect, test } from "vitest";
import { jsonOf } from "#directed/files";
import { scene } from "#document/scene";
import { mayHoldLink, tellFile, tellPasted, wordsForOther } from "./tell";
import { headOf } from "./tell-head";

const told = (text: string) => tellFile(new TextEncoder().encode(text));
const bytes = (text: string) => Uint8Array.from(text, (sign) => sign.charCodeAt(0));

test.each([
  ["picture", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"],
  ["picture", "\xff\xd8\xff\xe0\0\x10JFIF"],
  ["picture", "RIFF\x10\0\0\0WEBPVP8 "],
  ["other", "PK\x03\x04\0\0"],
  ["other", "%PDF-1.4\n\0\0"],
  ["other", "\0\0\0\x18ftypmp42"],
])("bytes of a %s are known", (kind, text) => {
  expect(tellFile(bytes(text))).toBe(kind);
});

test.each([
  ["empty", " \r\n"],
  ["outline", "<?xml version='1.0'?>\n<svg xmlns='http://www.w3.org/2000/svg'/>"],
  ["outline", "x,y\n1,2\n3,4"],
  ["outline", "0,5;1,5\n2;3"],
  ["outline", '{"type":"FeatureCollection","features":[]}'],
  ["outline", "[[1,2],[3,4]]"],
  ["maps", "; a fern\nfern {\n 0 0 0 .16 0 0 .01\n}"],
  ["maps", "sponge (3D) { 1 2 3 }"],
  ["maps", "a,b,c,d,e,f,p\n0.5,0,0,0.5,0,0,0.3"],
  ["maps", "0,5;0;0;0,5;0;0"],
  ["maps", ".5 0 0 .5 0 0\n"],
  ["maps", "<flames name='a'><flame/></flames>"],
  ["maps", "<Flames><flame/></Flames>"],
  ["maps", "<jwf-flame name='a'><layer/></jwf-flame>"],
  ["other", "<IFS><flame_transform/></IFS>"],
  ["maps", "@\n$dim=2\nA=2^-1*A"],
  ["maps", '{"name":"Fern","maps":[[1,2,3,4,5,6]]}'],
  ["maps", "[[1,2,3,4,5,6]]"],
  ["maps", '{"a":{"maps":[]},"b":{},"path":{}}'],
  ["animation", '{"frond":"space","packed":"x"}'],
  ["animation", '{"frames":[]}'],
  ["other", "<html><body>maps</body></html>"],
  // Rows of maps as books, encyclopedias and other programs print them.
  ["maps", "T1  0.00  0.00  0.00  0.16  0.00  0.00  0.01\nT2  0.85  0.04 -0.04  0.85  0.00  1.60  0.85"],
  ["maps", "ƒ1\t0\t0\t0\t0.16\t0\t0\t0.01\tStem\nƒ2\t0.85\t0.04\t−0.04\t0.85\t0\t1.6\t0.85\tLeaflets"],
  ["maps", "f1: 0 0 0 0.16 0 0 0.01"],
  ["maps", "1) 0 0 0 0.16 0 0 0.01"],
  ["maps", "1. 0 0 0 0.16 0 0 0.01"],
  ["maps", "#1 0 0 0 0.16 0 0 0.01"],
  ["maps", "1 0.85 0.04 –0.04 0.85 0 1.60 0.85"],
  ["maps", "0.85\u00a00.04\u2009−0.04\u20090.85\u00a00\u00a01.60"],
  [
    "maps",
    "| map | a | b | c | d | e | f |\n|---|---|---|---|---|---|---|\n| f1 | 0 | 0 | 0 | 0.16 | 0 | 0 |",
  ],
  ["maps", "ifs = [\n (0, 0, 0, 0.16, 0, 0, 0.01),\n (0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85),\n]"],
  ["maps", "[0, 0, 0, 0.16, 0, 0, 0.01],\n[0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85]"],
  ["maps", "(0, 0, 0, 0.16, 0, 0), (0.85, 0.04, -0.04, 0.85, 0, 1.6), (0.2, -0.26, 0.23, 0.22, 0, 1.6)"],
  ["maps", "1/3 0 0 1/3 0 0 25%\n1/6 −√3/6 √3/6 1/6 1/3 3/2 75%"],
  ["maps", "0,5 0,0 0,0 0,5 1,0 0,0"],
  ["maps", "0,5, 0, 0, 0,5, 1, 0"],
  ["maps", "0 0 0 1 0 0 0 1 0 0 0 1 0.5"],
  ["maps", "a & b & c & d & e & f\\\\\n0 & 0 & 0 & 0{,}16 & 0 & 0\\\\"],
  ["maps", "\\hline 0 0 0 1"],
  ["maps", "f1(x, y) = (0, 0.16y)\nf2(x, y) = (0.85x + 0.04y, −0.04x + 0.85y + 1.6)"],
  ["maps", "x' = 0.85x + 0.04y; y' = 1.6 + 0.85y - 0.04x"],
  ["maps", "{{0, 0, 0, 0.16, 0, 0}, {0.85, 0.04, -0.04, 0.85, 0, 1.6}}"],
  ["maps", "0 0 0 .5 0 0\n\x1a"],
  // Columns beside x and y, and points that are parted by commas.
  ["outline", "leaf,area,BX,BY,X,Y\n7,123.5,1,2,300,62.8\n7,123.5,1,2,307,52.7"],
  ["outline", "id;r;g;b;n;Easting;Northing\n1;2;3;4;5;6;7"],
  ["outline", "y,x\n62.8,300\n52.7,308"],
  ["outline", "0,0 4,0 4,3"],
  ["outline", "T1 1 2\nT2 3 4"],
  ["outline", "1 2 3 4 5 6 7 8 9"],
  ["outline", "x,1\ny,2"],
  ["outline", "LM=4\n1 2\n3 4\n5 6\n7 8\nID=1"],
  // JSON by its keys, and by its rows.
  ["maps", '{"transforms":[{"a":0,"b":0,"c":0,"d":0.16,"e":0,"f":0,"p":0.01}]}'],
  ["maps", '{"iterations":28,"transformations":[["1","0, .16*y"],["7",".2*x -.26*y, .23*x + .22*y + 1.6"]]}'],
  ["maps", "[[0,0,0,0.16,0,0,0.01],[0.85,0.04,-0.04,0.85,0,1.6,0.85]]"],
  ["maps", '[{"A":1,"B":2,"C":3,"D":4,"E":5,"F":6}]'],
  ["maps", '[["1/3","0","0","1/3","0","0"]]'],
  ["maps", '{"leaf":[[1,2,3,4,5,6],[1,2,3,4,5,6]]}'],
  ["maps", '{"rows":[[1,2,3,4,5,6]]}'],
  ["maps", '[{"matrix":[[0.5,0],[0,0.5]],"translation":[1,2]}]'],
  ["maps", '[{"x":"0.5*x + 1","y":"0.5*y"}]'],
  ["maps", '{"functions":[["0","x/2, y/2"]]}'],
  ["outline", '{"rows":[[1,2],[3,4]]}'],
  ["maps", '[["0.5x + 1, 0.5y"],["0.5x, 0.5y"]]'],
  ["maps", "[[[0.5, -0.25, 1], [0.125, 0.75, 2]]]"],
  ["maps", "[[[0.5, -0.25, 1], [0.125, 0.75, 2], [0, 0, 1]]]"],
  ["outline", "[[[0, 0, 5], [4, 0, 5], [4, 3, 5], [0, 0, 5]]]"],
  ["outline", '[["x1","y1"],[1,2],[3,4]]'],
  ["outline", '{"points":[1,2,3,4,5,6]}'],
  ["outline", '[{"x":1,"y":2},{"x":3,"y":4}]'],
  ["outline", '[{"type":"Feature","geometry":{"type":"Polygon","coordinates":[[[1,2,3],[3,4,3]]]}}]'],
  [
    "outline",
    '{"type":"Topology","objects":{},"arcs":[[[0,0],[9,0]]],"transform":{"scale":[1,1]},"functions":[]}',
  ],
  ["outline", '{"annotations":[{"segmentation":[[1,2,3,4,5,6]]}],"rules":[1]}'],
  ["outline", '{"shapes":[{"points":[[1,2],[3,4]]}],"imagePath":"a","maps":1}'],
  ["outline", '{"1":{"regions":[{"shape_attributes":{"all_points_x":[1,2,3,4,5,6]}}]}}'],
  ["outline", '[{"value":{"polygonlabels":["leaf"],"points":[[1,2],[3,4]]}}]'],
  ["outline", "# a licence\n// of two lines\n[[1,2],[3,4]]"],
  // What stands before a drawing may name others.
  ["outline", '<!-- <flame> and > --><!DOCTYPE svg [ <!ENTITY a "]>"> ]><svg/>'],
  ["maps", "<?xml version='1.0'?><!-- no <svg> --><flame/>"],
  ["other", "<!-- <svg/>"],
])("a text of the kind %s is known: %s", (kind, text) => {
  expect(told(text)).toBe(kind);
  expect(told(`\ufeff${text}`)).toBe(kind);
});

const wide = (text: string, first: number) =>
  Uint8Array.from(
    [...text].flatMap((sign) => (first === 0 ? [sign.charCodeAt(0), 0] : [0, sign.charCodeAt(0)])),
  );

test.each([
  ["maps", "0.5 0 0 0.5 0 0\n"],
  ["outline", "x,y\n1,2\n3,4"],
  ["outline", "<svg/>"],
])("UTF-16 without a mark is known by its zeros: %s", (kind, text) => {
  expect(tellFile(wide(text, 0))).toBe(kind);
  expect(tellFile(wide(text, 1))).toBe(kind);
});

test("zeros alone are no text, and what ends a text is none", () => {
  expect(tellFile(bytes("\0\0\0\0\0\0"))).toBe("other");
  expect(tellFile(bytes("1,2\0,3"))).toBe("other");
  expect(tellFile(bytes(" \r\n\x1a"))).toBe("empty");
  // The dash of Windows.
  expect(tellFile(bytes("0.85 0.04 \x960.04 0.85 0 1.6"))).toBe("maps");
});

test.each([
  ["outline", `<?xml version="1.0"?>\n<!-- ${"words of a licence\n".repeat(9_000)} -->\n<svg/>`],
  ["maps", `<!-- ${"words of a licence\n".repeat(9_000)} --><flames/>`],
  ["outline", `<!DOCTYPE svg [ <!ENTITY a "${"x".repeat(99_999)}"> ]><svg/>`],
  ["maps", `${" \n".repeat(99_999)}{"maps":[[1,2,3,4,5,6]]}`],
])("what stands before the beginning may be long: %s", async (kind, text) => {
  const head = await headOf(new Blob([text]));
  expect(head.length).toBe(text.length);
  expect(tellFile(head)).toBe(kind);
});

test("of a file that begins at once only the head is read", async () => {
  expect((await headOf(new Blob(["1,2\n".repeat(99_999)]))).length).toBe(65_536);
  expect((await headOf(new Blob(["<svg>", " ".repeat(999_999)]))).length).toBe(999_999 + 5);
});

test("what is not read is named, whatever its name says", () => {
  expect(wordsForOther(bytes("\0\0\0\x18ftypheic"))).toBe(
    "This is a HEIC picture. Save it as JPEG and open that: on a phone, share it as “Most compatible”.",
  );
  expect(tellFile(bytes("{\\rtf1\\ansi 1 2 3 4 5 6}"))).toBe("other");
  expect(wordsForOther(bytes("\x01\x02"))).toMatch(/^Frond does not read this type of file\./);
});

test.each([
  ["outline", '<svg width="4" height="3"><path d="M0 0H4V3Z"/></svg>'],
  ["outline", "x,y\n1,2\n3,4\n5,0"],
  ["outline", '{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,0]]]}'],
  ["maps", "T1 0 0 0 0.16 0 0 0.01"],
  ["maps", "fern {\n 0 0 0 .16 0 0 .01\n}"],
  ["maps", "leaf { ; by hand\n .5 0 0 .5 0 0\n}"],
  ["maps", "@\n$dim=2\nA=2^-1*A"],
  ["maps", "@ # by hand\nA = 2^-1*A"],
  [null, "milk, bread and 2 eggs"],
  [null, "42"],
  [null, "1 2\n3 4"],
  [null, "function f() { return 1; }"],
  [null, '{"name":"a package","version":"1.0.0"}'],
  [null, "@somebody hello"],
  [null, "; a remark"],
  [null, "<div>words</div>"],
  [null, ""],
])("a text that is pasted is meant as %s: %s", (kind, text) => {
  expect(tellPasted(text)).toBe(kind);
});

test("a picture that Frond saved says so", () => {
  expect(mayHoldLink(bytes("\x89PNG\r\n\x1a\n....iTXtFrond link\0\0\0\0\0#v=1"))).toBe(true);
  expect(mayHoldLink(bytes("\x89PNG\r\n\x1a\n....tEXtComment\0Frond link"))).toBe(false);
});

test("a document that was saved as JSON opens as one", () => {
  expect(told(jsonOf(scene.peek(), null))).toBe("maps");
});
