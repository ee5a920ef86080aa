/** The deformations of Figures 4 to 6: which mesh moves how, and what differs from panel to panel. */

import { AT_REST } from "#document/deform/bend";
import { fixed } from "#format/numbers";
import type { Deformation, DeformKey, MapRow } from "#wasm/api";
import { studioHref } from "../../kit/frame/studio-link";
import { movesOf, type NamedMesh } from "./meshes";

/** What a deformation by a mesh is, where nothing else is said. */
export function deformationBy(mesh: NamedMesh, settings: Partial<Deformation>): Deformation {
  return { ...AT_REST, box: mesh.box, keys: once(mesh), loop: false, ...settings };
}

/** From rest to the fullest. */
export function once(mesh: NamedMesh): DeformKey[] {
  return [
    { at: 0, moves: movesOf(mesh, 0) },
    { at: 1, moves: movesOf(mesh, 1) },
  ];
}

/** To one side, back, to the other side, and back again. */
export function toAndFro(mesh: NamedMesh): DeformKey[] {
  return [0, 1, 0, -1].map((part, i) => ({ at: i / 4, moves: movesOf(mesh, part) }));
}

/** The link to the studio with a shape bent so. */
export function bentHref(name: string, maps: MapRow[], deform: Deformation): string {
  const shape = { name, maps };
  return studioHref({ a: shape, b: shape, deform });
}

/** A panel of a figure: its letter, and what its deformation has of its own. */
export interface BentPanel {
  letter: string;
  /** A word or two. */
  words: string;
  settings: Partial<Deformation>;
}

/** Its numbers in a line. */
export function numbersOf({ settings: { kb, delta } }: BentPanel): string {
  const rough = Array.isArray(delta)
    ? delta.slice(0, 3).map((one) => fixed(one))
    : delta === undefined
      ? []
      : [fixed(delta)];
  return [kb === undefined ? "" : `kb ${kb}`, rough.length > 0 ? `δ ${rough.join(", ")}` : ""]
    .filter(Boolean)
    .join(", ");
}
