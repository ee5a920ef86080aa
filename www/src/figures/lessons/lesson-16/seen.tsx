/** An address as it is written, and where it leads. */
import type { Box } from "#document/framing";
import { Button } from "#ui/controls/Button";
import { useOwnId } from "#ui/id";
import layout from "../../kit/frame/layout.module.css";
import { gasket, HEIGHT } from "../../kit/maps/families";
import { apply, type Point } from "../../kit/maps/pieces";
import { Drawn, type Place } from "../../kit/picture/annotated";
import { text } from "../../kit/state/fields";
import { type Address, pieceOf, pointOf, readAddress } from "./address";
import css from "./page.module.css";

export const MAPS = gasket(0.5);
export const BOX: Box = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
const TRIANGLE: readonly Point[] = [
  [0, 0],
  [1, 0],
  [0.5, HEIGHT],
];
/** How what is typed stands in the address of the lesson. */
export const ADDRESS = text(/[\d() ]{0,30}/);
const KEYS = ["1", "2", "3", "(", ")"] as const;

interface AddressFieldProps {
  text: string;
  onText: (text: string) => void;
  label: string;
}

/** An address to be typed, with buttons for fingers, and what is wrong with it. */
export function AddressField({ text, onText, label }: AddressFieldProps) {
  const id = useOwnId("address");
  const address = readAddress(text, MAPS.length);
  const problem = typeof address === "string" ? address : "";
  return (
    <div class={css["field"]}>
      <label for={id}>{label}</label>
      <input
        id={id}
        class={css["typed"]}
        type="text"
        inputMode="numeric"
        autocomplete="off"
        spellcheck={false}
        maxLength={30}
        value={text}
        aria-invalid={problem !== ""}
        aria-describedby={`${id}-problem`}
        onInput={(event) => onText(event.currentTarget.value)}
      />
      <div class={layout["buttons"]}>
        {KEYS.map((key) => (
          <Button key={key} onClick={() => onText(text + key)}>
            {key}
          </Button>
        ))}
        <Button onClick={() => onText(text.slice(0, -1))} disabled={text === ""}>
          Back
        </Button>
      </div>
      <p id={`${id}-problem`} class={layout["missing"]} aria-live="polite">
        {problem}
      </p>
    </div>
  );
}

/** The shape with the piece or the point of an address. */
export function Seen({ address, target }: { address: Address | null; target?: Point }) {
  const piece = address ? pieceOf(MAPS, address) : null;
  const point = address ? pointOf(MAPS, address) : null;
  const steps = address?.first ?? [];
  const label =
    point !== null
      ? `The gasket with the point of that address, ${point[0].toFixed(3)} from the left and ${point[1].toFixed(3)} up.`
      : `The gasket with the piece of that address, ${2 ** steps.length} times smaller than the whole.`;
  return (
    <Drawn maps={MAPS} box={BOX} label={label}>
      {(place) => (
        <>
          {address &&
            steps.map((_, i) => {
              const inside = { first: steps.slice(0, i + 1), again: [] };
              return (
                <Outline key={i} place={place} map={pieceOf(MAPS, inside)} last={i === steps.length - 1} />
              );
            })}
          {target && <Mark place={place} at={target} kind="target" />}
          {piece && point && <Mark place={place} at={point} kind="here" />}
        </>
      )}
    </Drawn>
  );
}

function Outline({ place, map, last }: { place: Place; map: ReturnType<typeof pieceOf>; last: boolean }) {
  const corners = TRIANGLE.map((corner) => place(apply(map, corner)).join(" "));
  return <path class={`${css["piece"]} ${last ? css["last"] : ""}`} d={`M${corners.join("L")}Z`} />;
}

export function Mark({ place, at, kind }: { place: Place; at: Point; kind: "here" | "target" }) {
  const [x, y] = place(at);
  return (
    <circle
      class={kind === "here" ? css["here"] : css["target"]}
      cx={x}
      cy={y}
      r={kind === "here" ? 5 : 10}
    />
  );
}

export const readOr = (text: string) => {
  const address = readAddress(text, MAPS.length);
  return typeof address === "string" ? null : address;
};
