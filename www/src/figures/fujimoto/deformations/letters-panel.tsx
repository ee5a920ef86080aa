import type { Box } from "#document/framing";
import type { Bend, MapRow } from "#wasm/api";
import { Panel } from "../../kit/frame/panel";
import type { Point } from "../../kit/maps/pieces";
import { PieceNames } from "../../kit/picture/annotated";
import { Bent } from "../../kit/picture/deformed";

interface LettersPanelProps {
  maps: MapRow[];
  rest: Bend;
  box: Box;
  aspect: number;
  /** Where the name of each piece stands. */
  names: readonly Point[];
  label: string;
}

/** The addressing rule, (X): each piece of a shape at rest by the letter of its map. */
export function LettersPanel({ rest, names, ...picture }: LettersPanelProps) {
  return (
    <Panel name="X" words="the letters of the codes">
      <Bent {...picture} bend={rest} grid={0}>
        {(place) => <PieceNames at={names.map(place)} />}
      </Bent>
    </Panel>
  );
}
