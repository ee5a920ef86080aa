/** The chosen object, taken in hand. */
import { placeObject } from "#document/space/edits";
import { chosen, IDENTITY } from "#document/space/space";
import { determinant3 } from "#geometry/maps/affine3";
import { HandPanel } from "#ui/hand/HandPanel";
import { handOn } from "#ui/hand/hold";
import { MatrixFields } from "#ui/hand/MatrixFields";
import { ParameterTable } from "#ui/hand/ParameterTable";
import type { MapRow3 } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { facts, factsOf, made, moved, parameters } from "../now";
import { TwelveFields } from "./TwelveFields";

const hand = handOn<MapRow3>({
  axes: ["x", "y", "z"],
  id: () => chosen.value,
  identity: IDENTITY,
  moved,
  ball: facts,
  ballNow: () => factsOf(parameters.peek()),
  transform: (by) => by,
  compose: (outer, inner) => solid.compose3(outer, inner),
  place: placeObject,
});

export function ObjectHand() {
  return (
    <>
      <HandPanel
        of={hand}
        as="made"
        matrix={
          <MatrixFields
            key={chosen.value}
            moved={moved.value}
            fields={(map, onChange) => <TwelveFields map={map} onChange={onChange} onDone={() => {}} />}
            sizes={messages.volumes}
            determinant={determinant3}
            name="object"
            place={placeObject}
          />
        }
      />
      <ParameterTable made={made.value} now={parameters.value} moved={moved.value} as="made" />
    </>
  );
}
