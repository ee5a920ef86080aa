import { placeObject } from "#document/space/edits";
import { chosen, IDENTITY } from "#document/space/space";
import { determinant3 } from "#geometry/maps/affine3";
import { NumberField } from "#ui/controls/NumberField";
import { useProblems } from "#ui/controls/problems";
import { HandPanel } from "#ui/hand/HandPanel";
import { handOn } from "#ui/hand/hold";
import { MatrixFields } from "#ui/hand/MatrixFields";
import { ParameterTable } from "#ui/hand/ParameterTable";
import equationsCss from "#ui/shapes/equations.module.css";
import type { MapRow3 } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { facts, factsOf, made, moved, parameters } from "../now";

interface TwelveFieldsProps {
  map: MapRow3;
  /** Takes the map, or says why it cannot be; `place` is that of the number that was changed. */
  onChange: (map: MapRow3, place: number) => string | undefined;
  onDone: () => void;
}

const AXES = ["x", "y", "z"] as const;

/** The twelve numbers of a map of space, laid out as the three equations that they are. */
export function TwelveFields({ map, onChange, onDone }: TwelveFieldsProps) {
  const { tellOf, below } = useProblems();
  const field = (place: number, label: string, symbol: string) => (
    <NumberField
      key={place}
      terse
      label={label}
      symbol={symbol}
      value={map[place] ?? 0}
      digits={4}
      onChange={(value) => {
        const next = map.with(place, value) as MapRow3;
        return onChange(next, place);
      }}
      onDone={onDone}
      problems={tellOf(String(place))}
    />
  );
  return (
    <div class={equationsCss["equations"]}>
      {AXES.map((axis, row) => (
        <div key={axis} class={`${equationsCss["equation"]} ${equationsCss["of-space"]}`}>
          <span class={equationsCss["equation-axis"]} aria-hidden="true">
            {axis}′ =
          </span>
          {AXES.map((from, column) => field(3 * row + column, messages.newFrom(axis, from), from))}
          {field(9 + row, messages.moveAlong(axis), "+")}
        </div>
      ))}
      {below}
    </div>
  );
}

// The chosen object, taken in hand.

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
