import { expect, test } from "vitest";
import { jsonOf } from "#directed/files";
import { scene } from "#document/scene";
import { mayHoldLink, tellFile } from "./tell";

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
])("a text of the kind %s is known: %s", (kind, text) => {
  expect(told(text)).toBe(kind);
  expect(told(`\ufeff${text}`)).toBe(kind);
});

test("a picture that Frond saved says so", () => {
  expect(mayHoldLink(bytes("\x89PNG\r\n\x1a\n....iTXtFrond link\0\0\0\0\0#v=1"))).toBe(true);
  expect(mayHoldLink(bytes("\x89PNG\r\n\x1a\n....tEXtComment\0Frond link"))).toBe(false);
});

test("a document that was saved as JSON opens as one", () => {
  expect(told(jsonOf(scene.peek(), null))).toBe("maps");
});
