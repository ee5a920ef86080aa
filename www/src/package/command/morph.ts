/** Links, and the morphs that they say. */
import { bendAt } from "#geometry/bend";
import { weighted } from "#geometry/maps/weighted";
import { pointsOf, uvAt } from "#geometry/path";
import type { Ifs, Scene, Shape } from "#wasm/api";
import { Refusal } from "./options";
import type { System } from "./system";

const systemOf = ({ maps, weights }: Shape): Ifs => weighted(maps, weights);

/** A morph as a link says it, and how to get on its way. */
export async function morphOf(scene: Scene, system: System) {
  if (scene.directed)
    throw new Refusal("Of shapes of several states the command only draws pictures and films: frond render.");
  if (scene.curves || scene.tool === "fit")
    throw new Refusal(
      "The command knows no closed curves. Save them in the studio, as SVG, as a film or as maps.",
    );
  if (scene.tool === "space")
    throw new Refusal(
      "This link is of space, of which the command only draws pictures and makes meshes: frond render, frond mesh.",
    );
  const draw = await system.draw();
  const { from, to, probabilities: [p, q] = [] } = draw.pair(systemOf(scene.a), systemOf(scene.b));
  const fitting = <T>(list: T[]) => (list.length === from.length ? list : []);
  const morph = {
    mode: scene.mode,
    ...(fitting(scene.correspondence).length > 0 ? { correspondence: scene.correspondence } : {}),
    ...(fitting(scene.turns).length > 0 ? { turns: scene.turns } : {}),
  };
  const ends: [Ifs, Ifs] = [weighted(from, p), weighted(to, q)];
  const planned = async (): Promise<Scene["path"]> => {
    const { path } = scene;
    if (path.kind !== "auto" || path.points.length > 0) return path;
    const { points } = await system.pool().planPath(...ends, morph);
    return { ...path, points: points.slice(1, -1) };
  };
  const at = async (moments: number[]): Promise<Ifs[]> => {
    const inside = moments.some((t) => t > 0 && t < 1);
    const points = pointsOf(inside ? await planned() : scene.path);
    return moments.map((t) => {
      const [u, v, w = 0] = uvAt(points, t);
      return draw.interpolate(...ends, { ...morph, u, v, w });
    });
  };
  return { draw, scene, ends, morph, planned, at };
}

/** Maps with their name, and their colours where a link or a file gives them some. */
export type NamedMaps = Ifs & { name: string; colours?: string[] };

/** Those of a document, one a map. */
export function withColours(ifs: Ifs, name: string, { palette }: Scene): NamedMaps {
  if (!palette || palette.length === 0) return { ...ifs, name };
  return { ...ifs, name, colours: ifs.maps.map((_, i) => palette[i % palette.length] ?? "") };
}

/** How a link bends its shape at a moment of its bending; null where it does not. */
export function bendOf({ deform, tool }: Scene) {
  if (!deform || !(deform.on || tool === "deform")) return null;
  if (deform.subject === "picture") {
    // The morph has no place for a photograph.
    if (tool !== "deform") return null;
    throw new Refusal("The photograph that is bent here is not in the link. Save the film in the studio.");
  }
  return (phase: number) => bendAt(deform, phase);
}
