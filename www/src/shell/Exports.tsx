/** The dialogs of films and pictures, for the tool that is open. Loaded when one is first opened. */
import { FilmDialog } from "#film/FilmDialog";
import { exportOpen } from "#film/open";
import { PictureDialog } from "#film/PictureDialog";
import { link } from "./actions";
import { addressOf, stageStill } from "./save";
import { openedTool } from "./tools";

export function Exports() {
  const { entry, tool } = openedTool();
  if (exportOpen.value === "film") return tool?.films ? <FilmDialog films={tool.films} /> : null;
  const still = entry.stage === undefined ? stageStill : tool?.still;
  return still ? <PictureDialog still={still} link={() => addressOf(link.fragment())} /> : null;
}
