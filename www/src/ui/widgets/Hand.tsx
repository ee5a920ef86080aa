/** What a shape is moved by, and words that explain themselves. */
import { signal } from "@preact/signals";
import { after3, determinant3 } from "#geometry/maps/affine3";
import type { MapRow3 } from "#wasm/api";
import { HandPanel } from "../hand/HandPanel";
import { handOn } from "../hand/hold";
import { MatrixFields } from "../hand/MatrixFields";
import { ParameterTable } from "../hand/ParameterTable";
import { QrCode } from "../overlay/QrCode";
import { NameInput } from "../shapes/NameInput";
import { Meaning } from "../terms/Meaning";
import { Term } from "../terms/Term";
import { LONG, Widget } from "./Widget";

const nothing = () => {};
const REST: MapRow3 = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
const MADE: MapRow3 = [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 0.25, -0.25, 12];
const NOW: MapRow3 = [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 0.75, -0.25, 12];
const BALL = { centre: [0, 0, 0], radius: 1 } as const;

const moved = signal(REST);
const hand = handOn<MapRow3>({
  axes: ["x", "y", "z"],
  id: () => "one",
  identity: REST,
  moved,
  ball: signal({ ...BALL, centre: [...BALL.centre] }),
  ballNow: () => ({ ...BALL, centre: [...BALL.centre] }),
  transform: (by) => by,
  compose: after3,
  place: (put) => {
    moved.value = put ?? REST;
  },
});

export function Hand() {
  return (
    <>
      <Widget name="HandPanel" state="at rest" wide>
        <HandPanel of={hand} as="made" matrix={<p>Its matrix</p>} />
      </Widget>
      <Widget name="MatrixFields" state="a map that leaves all as it is" wide>
        <MatrixFields
          moved={REST}
          fields={() => <p>A field for each number</p>}
          sizes="Volumes"
          determinant={determinant3}
          name="object"
          place={nothing}
        />
      </Widget>
      <Widget name="ParameterTable" state="one number has changed" wide>
        <ParameterTable made={[MADE, MADE]} now={[MADE, NOW]} moved={REST} as="made" />
      </Widget>
      <Widget name="QrCode" state="of a short link" wide>
        <QrCode address="https://example.org/#a=fern" />
      </Widget>
      <Widget name="NameInput" state="a long name" wide>
        <NameInput label="Name" name={LONG} longest={60} onName={nothing} />
      </Widget>
      <Widget name="Term" state="to press" wide>
        <Term name="gap">the widest gap</Term>
      </Widget>
      <Widget name="Meaning" state="of a word with a lesson" wide>
        <Meaning name="proved" />
      </Widget>
    </>
  );
}
