import type { ComponentChildren } from "preact";
import { useEffect, useMemo, useState } from "preact/hooks";
import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { Choice, SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { list } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import lessonCss from "../frame/lesson.module.css";
import { Board } from "./board";
import {
  ACROSS,
  attractorWorst,
  bound,
  COPY,
  type Copy,
  collageWorst,
  contraction,
  FEWEST,
  MOST,
  mapOf,
  SIZES,
  START,
  tame,
  UP,
  WIDTHS,
} from "./collage";

/** The copies of a player, and how well they cover the leaf; `name` is theirs in the address of the lesson. */
export function useCollage(name: string) {
  const [copies, setCopies] = useKept(name, START, list(COPY, FEWEST, MOST, ";"));
  const [chosen, choose] = useState(0);
  const maps = useMemo(() => copies.map(mapOf), [copies]);
  const collage = useMemo(() => collageWorst(maps), [maps]);
  const set = (index: number, copy: Copy) =>
    setCopies((now) => now.map((one, i) => (i === index ? copy : one)));
  const count = (next: readonly Copy[]) => {
    setCopies(next);
    choose(Math.min(chosen, next.length - 1));
  };
  const s = contraction(maps);
  return { copies, chosen, choose, maps, collage, s, most: bound(collage?.distance ?? 0, s), set, count };
}

export type Collage = ReturnType<typeof useCollage>;

/** So long after the last change, in milliseconds, what the maps make is measured. */
const REST_MS = 120;

/** How far what the maps make is from the leaf; undefined while copies are moved, null where it leaves the board. */
export function useMade(maps: Collage["maps"]) {
  const [found, setFound] = useState<{ maps: Collage["maps"]; worst: ReturnType<typeof attractorWorst> }>();
  useEffect(() => {
    const timer = setTimeout(() => setFound({ maps, worst: attractorWorst(maps) }), REST_MS);
    return () => clearTimeout(timer);
  }, [maps]);
  return found?.maps === maps ? found.worst : undefined;
}

export const madeWords = (made: ReturnType<typeof useMade>) =>
  made === undefined ? "…" : made === null ? "beyond the board" : `about ${fixed(made.distance)}`;

type Shown = "copies" | "made";
const SHOWN = [
  { value: "copies", label: "the copies" },
  { value: "made", label: "what they make" },
] as const;

interface GameProps {
  collage: Collage;
  /** What is said of it below the board. */
  children: ComponentChildren;
}

/** The board with all that moves its copies, by hand and by keys. */
export function Game({ collage: of, children }: GameProps) {
  const [shown, setShown] = useState<Shown>("copies");
  const distance = fixed(of.collage?.distance ?? 0);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <div class={lessonCss["ask"]}>
        <Board
          copies={of.copies}
          chosen={of.chosen}
          made={shown === "made"}
          worst={shown === "copies" ? of.collage : null}
          label={`A leaf and ${of.copies.length} smaller copies of it. Together they are ${distance} off the leaf.`}
          onChange={of.set}
          onChoose={of.choose}
        />
        <Choice label="Show" options={SHOWN} value={shown} onChange={(next: Shown) => setShown(next)} />
        {children}
      </div>
      <Controls of={of} />
    </div>
  );
}

function Controls({ of: { copies, chosen, choose, set, count } }: { of: Collage }) {
  const copy = copies[chosen] ?? copies[0];
  if (!copy) return null;
  const change = (part: Partial<Copy>) => set(chosen, tame({ ...copy, ...part }));
  const degrees = `${fixed(copy.turn, 0)}°`;
  return (
    <div class={lessonCss["ask"]}>
      <Choice
        label="Copy"
        options={copies.map((_, i) => ({ value: String(i), label: String(i + 1) }))}
        value={String(chosen)}
        onChange={(next) => choose(Number(next))}
      />
      <SliderControl
        label="across"
        range={ACROSS}
        value={copy.at[0]}
        onChange={(x) => change({ at: [x, copy.at[1]] })}
      />
      <SliderControl
        label="up"
        range={UP}
        value={copy.at[1]}
        onChange={(y) => change({ at: [copy.at[0], y] })}
      />
      <SliderControl label="size" range={SIZES} value={copy.size} onChange={(size) => change({ size })} />
      <SliderControl
        label="width for its size"
        range={WIDTHS}
        value={copy.width}
        onChange={(width) => change({ width })}
      />
      <SliderControl
        label="turn"
        range={[-180, 179]}
        step={1}
        value={copy.turn}
        text={degrees}
        onChange={(turn) => change({ turn })}
      />
      <div class={layout["buttons"]}>
        <Button
          disabled={copies.length >= MOST}
          onClick={() => count([...copies, { at: [0, 0.45], size: 0.3, width: 1, turn: 0 }])}
        >
          One more copy
        </Button>
        <Button
          disabled={copies.length <= FEWEST}
          onClick={() => count(copies.filter((_, i) => i !== chosen))}
        >
          Without copy {chosen + 1}
        </Button>
        <Button icon="reset" onClick={() => count(START)}>
          Start again
        </Button>
      </div>
    </div>
  );
}
