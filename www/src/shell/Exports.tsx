/**
 * The dialogs of what goes out: films, pictures, meshes and the link, for the open tool. Loaded when one is
 * first opened.
 */
import { FilmDialog } from "#film/FilmDialog";
import { exportOpen } from "#film/open";
import { PictureDialog } from "#film/PictureDialog";
import { link } from "./actions";
import { printable } from "./print/print";
import { ShareDialog } from "./ShareDialog";
import { addressOf, stageStill } from "./save";
import { openedTool } from "./tools";

printable(() => link.fragment());

export function Exports() {
  const { entry, tool } = openedTool();
  const still = entry.stage === undefined ? stageStill : tool?.still;
  if (exportOpen.value === "share" || exportOpen.value === "publish") return <ShareDialog still={still} />;
  if (exportOpen.value === "film") return tool?.films ? <FilmDialog films={tool.films} /> : null;
  if (exportOpen.value === "mesh") return tool?.MeshDialog ? <tool.MeshDialog /> : null;
  return still ? <PictureDialog still={still} link={() => addressOf(link.fragment())} /> : null;
}
