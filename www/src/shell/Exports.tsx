/**
 * The dialogs of what goes out: films, pictures, meshes and the link, for the open tool, and of what is kept. Loaded
 * when one is first opened.
 */
import { FilmDialog } from "#film/FilmDialog";
import { exportOpen } from "#film/open";
import { PictureDialog } from "#film/picture/PictureDialog";
import { link } from "./actions";
import { Recent } from "./kept/Recent";
import { printable } from "./print/print";
import { ShareDialog } from "./publish/ShareDialog";
import { addressOf, stageStill } from "./save";
import { openedTool } from "./tools";

printable(() => link.fragment());

export function Exports() {
  const { entry, tool } = openedTool();
  const still = entry.stage === undefined ? stageStill : tool?.still;
  if (exportOpen.value === "share" || exportOpen.value === "publish") return <ShareDialog still={still} />;
  if (exportOpen.value === "recent") return <Recent />;
  if (exportOpen.value === "film") return <FilmDialog films={tool?.films} />;
  if (exportOpen.value === "mesh") return tool?.MeshDialog ? <tool.MeshDialog /> : null;
  return still ? <PictureDialog still={still} link={() => addressOf(link.fragment())} /> : null;
}
