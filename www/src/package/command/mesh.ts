/** Surfaces around shapes of space. */
import { palette } from "#style/palette";
import type { MeshFormat } from "#wasm/api";
import { shownObject } from "#workers/space/shown";
import { kindOf, number, type Options, outOf, Refusal, STANDARD, whole } from "./options";
import { progress } from "./progress";
import { nameOf, subjectOf } from "./subject";
import type { System } from "./system";

const KINDS: readonly MeshFormat[] = ["stl", "ply", "glb"];
/** Points of the shape between two words of how many there are. */
const POINTS = 200_000;

export async function mesh(word: string, options: Options, system: System): Promise<number> {
  const out = outOf(options);
  const format = kindOf(options, KINDS);
  const wanted = {
    fineness: whole(options, "fineness", 16, 640, 160),
    size: number(options, "size", 1, 10_000, 100),
    ...(options["wall"] === undefined ? {} : { wall: number(options, "wall", 0, 1000, 0) }),
  };
  const { scene } = await subjectOf(word, system);
  if (scene.tool !== "space")
    throw new Refusal(
      `A mesh is of a shape of space, and ${scene.a && word.includes("=") ? "this link" : nameOf(word)} is of the plane: frond export or frond render.`,
    );
  const { SpaceMesher, SpaceMotion, defaultSpace, unpackSpace } = await system.space();
  const space = scene.space?.packed ? unpackSpace(scene.space.packed) : defaultSpace();
  const { timeline } = space;
  if (!timeline && options["t"] !== undefined)
    throw new Refusal("Nothing moves here, and so there are no moments: leave --t away.");
  const seconds = timeline?.seconds ?? 1;
  const at = Math.min(1, (scene.space?.at ?? 0) / seconds);
  const motion = new SpaceMotion(space);
  const { objects } = motion.at(number(options, "t", 0, 1, at) * seconds);
  motion.free();
  const shapes = objects.map((object, i) => shownObject(object, space.objects[i]));
  const mesher = new SpaceMesher(shapes, wanted);
  const meter = progress(system);
  while (!mesher.run(POINTS)) meter.say(0, `${mesher.found} points`);
  meter.end();
  const made = mesher.finish();
  const { triangles, parts, size: sides, wall } = made.facts();
  await system.write(out, made.file(format, palette("light")));
  made.free();
  const mm = sides.map((side) => Number(side.toPrecision(3))).join(" x ");
  system.tell(
    `${out === STANDARD ? "Written" : out}: ${triangles} triangles in ${parts === 1 ? "one part" : `${parts} parts`}, ${mm} mm, ${Number(wall.toPrecision(3))} mm thick at least`,
  );
  return 0;
}
