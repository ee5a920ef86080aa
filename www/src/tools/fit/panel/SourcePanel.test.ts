import { expect, test } from "vitest";
import { ACCEPT, READS } from "./SourcePanel";

test("what the words name can be chosen in the file dialog", () => {
  const endings: Record<string, string> = {
    PNG: "image/png",
    JPEG: "image/jpeg",
    WebP: "image/webp",
    SVG: ".svg",
    CSV: ".csv",
    TPS: ".tps",
    GeoJSON: ".geojson",
    TopoJSON: ".topojson",
    "or JSON from COCO": ".json",
  };
  expect(READS.split(", ").slice(0, 9)).toEqual(Object.keys(endings));
  expect(READS).toMatch(/COCO, LabelMe, VIA or QuPath$/);
  for (const ending of Object.values(endings)) expect(ACCEPT.split(",")).toContain(ending);
});
