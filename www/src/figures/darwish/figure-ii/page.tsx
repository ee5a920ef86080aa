import { fixed } from "#format/numbers";
import { loadSpace } from "#wasm/space";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import { tex } from "../../kit/notation/tex";
import {
  differsBy,
  MATRICES,
  stateOf,
  THAT_OF_FIGURE_I,
  TurnedTriangle,
  turnedInTool,
  useTurnedTriangle,
} from "../space/triangle";
import type { Angles } from "../space/turning";

/** So that the translations are those that can be read in print. */
const TURNED: Angles = [-31, -35, -24];

/** What stands in its address. */
export const STATE = stateOf(TURNED);

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** The triangle turned about x, y and z. */
export function Page(heading: Heading) {
  const turned = useTurnedTriangle(STATE);
  const { angles } = turned;
  return (
    <Frame
      {...heading}
      lead={
        <p>
          The same triangle, turned about x, then about y, then about z. Each matrix <Formula>A</Formula> has
          become <Formula tex={tex`T A T^{-1}`} />: the map looked at from axes that were turned. A half stays
          a half, as in the print; let the maps also flatten, and their matrices turn. What differs from how
          it was made is underlined. The line below the table draws the same 2,000 points in both ways, from
          these parameters and by turning the old points, and says how far they are apart.
        </p>
      }
      found={
        <p>
          The order counts: about x first and z last is another turn than about z first. The paper says “about
          x,y,z”, and not by how much. In all of them the trace and the determinant of every matrix stay what
          they are, and so does the dimension.
        </p>
      }
      parameters={[
        ...(["x", "y", "z"] as const).map((axis, k) => ({
          name: `Turned about ${axis}`,
          value: `${fixed(angles[k] ?? 0, 0)}°`,
        })),
        { name: "Matrix of each map as made", symbol: "A", value: MATRICES[turned.form] },
        { name: "Eq 1", value: [tex`A' = T A T^{-1}`, tex`b' = T b + t - A' t`] },
      ]}
      captions={["Fig ii After rotation about x,y,z"]}
      reconstructed={`Printed are the matrices, 0.50 on the diagonal and ±0.00 beside it, and the second numbers of the translations: −0.06, 0.03 and 0.23. Of another row 0.14 is left. The angles are not printed: these bring out all four. ${THAT_OF_FIGURE_I}`}
      differs={[
        differsBy(turned.form),
        "Eq 1 is conjugation, w′ = T w T⁻¹: it holds in any dimension and for every T that can be undone, turns or not. The paper’s matrix of a rotation about z turns clockwise; angles here are counter-clockwise.",
      ]
        .filter(Boolean)
        .join(" ")}
      studio={turnedInTool(turned)}
    >
      <TurnedTriangle
        of={turned}
        label={`The triangle turned by ${angles.join(", ")} degrees about x, y and z`}
      />
    </Frame>
  );
}
