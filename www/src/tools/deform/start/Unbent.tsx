import { backToSystems } from "#document/curve/back";
import { announce } from "#document/notice";
import { openTool } from "#document/tool";
import { Button } from "#ui/controls/Button";
import { PanelFoot } from "#ui/panel/PanelFoot";
import * as messages from "../messages";
import { bendItsPicture } from "./picture-of-states";

/** Why a graph-directed shape is not bent, and what can be done. */
export function Unbent() {
  return (
    <div class="panel">
      <section class="stack" aria-labelledby="unbent">
        <header class="section-head">
          <h2 id="unbent">{messages.thisShapeNotDeformed}</h2>
        </header>
        <p>{messages.hasSeveralStatesDeformation}</p>
        <div class="row">
          <Button kind="primary" icon="grid" onClick={() => void bendItsPicture()}>
            {messages.deformPicture}
          </Button>
          <Button icon="back" onClick={() => openTool("morph")}>
            {messages.backToMorph}
          </Button>
          <Button
            kind="quiet"
            onClick={() => {
              backToSystems();
              announce(messages.backToSystemsMaps);
            }}
          >
            {messages.deformSystemMapsInstead}
          </Button>
        </div>
      </section>
      <PanelFoot />
    </div>
  );
}
