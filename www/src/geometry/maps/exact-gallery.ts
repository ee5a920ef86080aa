/** What entries of the maps of the gallery mean. Those of the other shapes are what their digits say. */
import { GALLERY } from "./exact";

const hexagon = "1/3,2/3,sqrt(3)/3";
const board = "1/3,2/3";
const terdragon = "sqrt(3)/6,sqrt(3)/3";

for (const [preset, formulas] of [
  ["gasket", "sqrt(3)/4"],
  ["terdragon", terdragon],
  ["terdragon-mirrored", terdragon],
  ["koch", "1/3,2/3,1/6,sqrt(3)/6"],
  ["carpet", board],
  ["vicsek", board],
  ["pentagon", "(3-sqrt(5))/2,(sqrt(5)-1)/2,(3-sqrt(5))/4,sin(36deg),tan(36deg)/2"],
  ["hexagon", hexagon],
  ["hexaflake", hexagon],
  ["gosper", "5/14,2/7,1/14,sqrt(3)/14,sqrt(3)/7,3sqrt(3)/14"],
] as const)
  GALLERY.set(preset, formulas);
