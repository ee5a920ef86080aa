import { announce } from "#document/notice";
import { halfTurnWay, halfTurnWords } from "#format/path-words";
import { Button } from "#ui/controls/Button";
import * as messages from "../messages";

interface HalfTurnsProps {
  /** For each map the whole turns that make its half turn the other one; 0 where it makes none. */
  other: readonly number[];
  /** Gives each map that many turns more. */
  onTurn: (by: readonly number[]) => void;
}

/** More buttons than that are no choice: then all turn at once, and each by itself in the list of pairs. */
const MOST_BUTTONS = 4;

/** Half a turn is as short either way: says for which maps, and offers the other one. */
export function HalfTurns({ other, onTurn }: HalfTurnsProps) {
  const words = halfTurnWords(other);
  if (words === null) return null;
  const maps = other.flatMap((turn, map) => (turn === 0 ? [] : [{ map, way: halfTurnWay(-turn) }]));
  return (
    <>
      <p>{words}</p>
      {maps.length > MOST_BUTTONS ? (
        <Button
          kind="quiet"
          onClick={() => {
            onTurn(other);
            announce(messages.allNowMakeOther);
          }}
        >
          {messages.turnAllThemOther}
        </Button>
      ) : (
        maps.map(({ map, way }) => (
          <Button
            key={map}
            kind="quiet"
            onClick={() => {
              onTurn(other.map((turn, i) => (i === map ? turn : 0)));
              announce(messages.mapTurnsNow(map + 1, way));
            }}
          >
            {messages.turnMap(map + 1, way)}
          </Button>
        ))
      )}
    </>
  );
}
