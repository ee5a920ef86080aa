import { Button } from "../controls/Button";
import { Segmented } from "../controls/Segmented";
import * as messages from "../messages";
import { useFocusKept } from "./focus";
import { MapButtons } from "./MapButtons";
import css from "./orbit.module.css";
import { Spoken } from "./Spoken";
import { type Game, gameSpoken, gameWords, MOST_THROWS } from "./words";

interface TargetControlsProps {
  game: Game;
  /** The throws so far, the first one first. */
  letters: readonly number[];
  maps: number;
  colours: readonly string[];
  deepest: number;
  onThrow: (letter: number) => void;
  onBack: () => void;
  onAgain: () => void;
  /** Another cell with an address of so many letters. */
  onNew: (length: number) => void;
  onShow: () => void;
}

/** A cell that is to be reached by choosing maps, in as few throws as can be. */
export function TargetControls(props: TargetControlsProps) {
  const { game, letters, maps, colours, deepest, onThrow, onBack, onAgain, onNew, onShow } = props;
  const words = gameWords(game);
  const length = String(game.target.length);
  const done = game.reached || letters.length >= MOST_THROWS;
  const controls = useFocusKept(letters.length === 0);
  return (
    <div class={css["orbit-controls"]} ref={controls}>
      <MapButtons verb={messages.throwMap} count={maps} colours={colours} disabled={done} onMap={onThrow} />
      <p class={css["orbit-address"]}>
        <span>{messages.thrown}</span>
        <strong data-testid="orbit-thrown">
          {letters.length === 0 ? messages.nothingYet : letters.map((letter) => letter + 1).join(" ")}
        </strong>
      </p>
      <div class={css["orbit-row"]}>
        <Button icon="back" disabled={letters.length === 0} onClick={onBack}>
          {messages.back}
        </Button>
        <Button icon="reset" disabled={letters.length === 0} onClick={onAgain}>
          {messages.startOver}
        </Button>
        <Button onClick={() => onNew(game.target.length)}>{messages.newTarget}</Button>
        <Button onClick={onShow}>{messages.showSolution}</Button>
      </div>
      <p class={`${css["orbit-words"]} ${game.reached ? css["orbit-reached"] : ""}`} data-testid="orbit-game">
        {words}
      </p>
      <div class={css["orbit-row"]}>
        <span class={css["orbit-name"]} aria-hidden="true">
          {messages.lettersCell}
        </span>
        <Segmented
          label={messages.lettersCell}
          value={length}
          options={Array.from({ length: deepest }, (_, i) => ({ value: `${i + 1}`, label: `${i + 1}` }))}
          onChange={(next) => onNew(Number(next))}
        />
      </div>
      <Spoken words={gameSpoken(game)} playing={false} />
    </div>
  );
}
