import { loadSpace } from "#wasm/space";
import { Frame, type Heading } from "../../kit/frame/frame";
import {
  BY_FIGURE_IV,
  differsBy,
  MATRICES,
  stateOf,
  TurnedTriangle,
  turnedInTool,
  useTurnedTriangle,
} from "../space/triangle";

/** What stands in its address. */
export const STATE = stateOf([0, 0, 0]);

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** Sierpinski's triangle in space, as it was made. */
export function Page(heading: Heading) {
  const turned = useTurnedTriangle(STATE);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          Three maps, each of which draws everything halfway to a corner: their attractor is Sierpinski’s
          triangle, a flat shape in space. To turn it, Frond turns no point. It turns the three maps, by eq 1
          of the paper, and draws what they say then. Drag the picture to walk around it; move the sliders to
          turn it, and watch the numbers.
        </p>
      }
      found={
        <p>
          A half is a half from all sides: the matrix 0.5 I is the same after every turn, and only the
          translations move. Maps that also flatten whatever leaves the plane of the triangle have the very
          same attractor, but their matrices turn with it. One picture, two sets of parameters: choose above.
        </p>
      }
      parameters={[
        { name: "Maps", symbol: "N", value: "3" },
        { name: "Matrix of each", symbol: "A", value: MATRICES[turned.form] },
        { name: "Corners", value: "(0.58, 0.12, 0), (−0.18, 0, 0) and (−0.18, 0.6, 0)" },
        { name: "Dimension", value: "ln 3 / ln 2 = 1.585" },
      ]}
      captions={["Fig i Sierpinski Triangle"]}
      reconstructed={`Printed are the matrices, 0.5 I, and the second numbers of the translations: 0.06, 0.00 and 0.30. The first numbers are cut off. They are reconstructed: ${BY_FIGURE_IV}.`}
      differs={differsBy(turned.form)}
      studio={turnedInTool(turned)}
    >
      <TurnedTriangle of={turned} label="Sierpinski’s triangle, drawn from the parameters beside it" />
    </Frame>
  );
}
