import { expect, test } from "vitest";
import { otherWords, signatureOf } from "./signature";

const bytes = (text: string) => Uint8Array.from(text, (sign) => sign.charCodeAt(0));

test.each([
  ["\x89PNG\r\n\x1a\n\0\0\0\rIHDR", { picture: "png" }],
  ["\xff\xd8\xff\xe0\0\x10JFIF", { picture: "jpeg" }],
  ["GIF89a", { picture: "gif" }],
  ["RIFF\x10\0\0\0WEBPVP8 ", { picture: "webp" }],
  ["BM\x10\x20\0\0\0\0\0\0", { picture: "bmp" }],
  ["\0\0\0\x20ftypmif1\0\0\0\0mif1avif", { picture: "avif" }],
  ["\0\0\0\x18ftypheic\0\0\0\0mif1heic", { other: "HEIC picture" }],
  ["\0\0\0\x20ftypmif1\0\0\0\0mif1heic", { other: "HEIC picture" }],
  ["\0\0\0\x18ftypmp42", { other: "film" }],
  ["II*\0\x08\0\0\0", { other: "TIFF picture" }],
  ["MM\0*\0\0\0\x08", { other: "TIFF picture" }],
  ["%PDF-1.7\n", { other: "PDF" }],
  ["{\\rtf1\\ansi", { other: "text with formatting (RTF)" }],
  ["PK\x03\x04..[Content_Types].xml..xl/workbook.xml", { other: "spreadsheet (xlsx)" }],
  ["PK\x03\x04..[Content_Types].xml..word/document.xml", { other: "document (docx)" }],
  ["PK\x03\x04..a.txt", { other: "ZIP archive" }],
  ["BMW,1\n2,3", null],
  ["x,y\n1,2", null],
  ["", null],
])("files are known by their first bytes: %j", (text, wanted) => {
  expect(signatureOf(bytes(text))).toEqual(wanted);
});

test("what is not read is named with what to do", () => {
  expect(otherWords("HEIC picture")).toBe(
    "a HEIC picture. Save it as JPEG and open that: on a phone, share it as “Most compatible”.",
  );
  expect(otherWords("TIFF picture")).toBe("a TIFF picture. Save it as JPEG or PNG and open that.");
  expect(otherWords("spreadsheet (xlsx)")).toBe("a spreadsheet (xlsx). Save its sheet as CSV and open that.");
  expect(otherWords("program")).toBe("a program.");
});
