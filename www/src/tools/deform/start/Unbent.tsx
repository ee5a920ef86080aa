import { backToSystems } from "#document/curve/back";
import { announce } from "#document/notice";
import { openTool } from "#document/tool";
import { Button } from "#ui/controls/Button";
import { PanelFoot } from "#ui/panel/PanelFoot";
import { bendItsPicture } from "./picture-of-states";

/** Why a graph-directed shape is not bent, and what can be done. */
export function Unbent() {
  return (
    <div class="panel">
      <section class="stack" aria-labelledby="unbent">
        <header class="section-head">
          <h2 id="unbent">This shape is not bent</h2>
        </header>
        <p>
          It has several states. The bend turns a part of each address round (Fujimoto, equations 5 and 6),
          and in a graph what is read the other way need not lead anywhere. Its picture is bent, as a
          photograph is: cut into parts of its own, and those into parts.
        </p>
        <div class="row">
          <Button kind="primary" icon="grid" onClick={() => void bendItsPicture()}>
            Bend its picture
          </Button>
          <Button icon="back" onClick={() => openTool("morph")}>
            Back to Morph
          </Button>
          <Button
            kind="quiet"
            onClick={() => {
              backToSystems();
              announce("The systems of maps are back.");
            }}
          >
            Bend the system of maps instead
          </Button>
        </div>
      </section>
      <PanelFoot />
    </div>
  );
}
