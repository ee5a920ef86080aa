import layout from "../../kit/frame/layout.module.css";
import { HEIGHT } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";
import { list } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { isSameAddress, pointOf } from "./address";
import { ADDRESS, AddressField, MAPS, readOr, Seen } from "./seen";

/** Where the pieces 31 and 32 touch. */
const TOUCH: Point = [0.5, HEIGHT / 2];
const NEAR = 1e-9;

export function Exercises() {
  return (
    <>
      <Find
        number={1}
        target={[0.25, HEIGHT / 2]}
        hints={[
          "It is in piece 1 and in piece 3, where the two meet.",
          "In piece 1 it is the top corner: the digit 3, again and again.",
        ]}
      >
        Give an address of the marked point, the middle of the left side.
      </Find>
      <Find
        number={2}
        target={[1 / 3, 0]}
        hints={[
          "It is in piece 1. In there it is two thirds along: so in piece 2 of it. Within that it is one third along again.",
          "The same two digits come again and again.",
        ]}
      >
        Give an address of the marked point, one third along the bottom.
      </Find>
      <Both />
    </>
  );
}

interface FindProps {
  number: number;
  target: Point;
  hints: readonly string[];
  children: string;
}

function Find({ number, target, hints, children }: FindProps) {
  const [text, setText] = useKept(`x${number}.address`, "", ADDRESS);
  const address = readOr(text);
  const point = address && pointOf(MAPS, address);
  const off = point && Math.hypot(point[0] - target[0], point[1] - target[1]);
  const solved = off !== null && off < 1e-9;
  return (
    <Exercise
      number={number}
      ask={children}
      hints={hints}
      solved={solved}
      status={
        off === null
          ? "A point has digits without end: end with brackets."
          : solved
            ? `${text} leads there.`
            : `${text} leads to a point ${off.toFixed(3)} away from it.`
      }
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Seen address={address} target={target} />
        <AddressField label="Your address" text={text} onText={setText} />
      </div>
    </Exercise>
  );
}

const NAMES = ["One address", "The other address"] as const;

/** Both addresses of a point in which two pieces touch. */
function Both() {
  const [texts, setTexts] = useKept<readonly string[]>("x3.addresses", ["", ""], list(ADDRESS, 2, 2, ";"));
  const addresses = texts.map(readOr);
  const isThere = addresses.map((address) => {
    const point = address && pointOf(MAPS, address);
    return point !== null && Math.hypot(point[0] - TOUCH[0], point[1] - TOUCH[1]) < NEAR;
  });
  const [one, other] = addresses;
  const count = isThere.filter(Boolean).length;
  const isOne = count === 2 && one && other && isSameAddress(one, other);
  const solved = count === 2 && !isOne;
  // What still has to be found is shown.
  const shown = addresses[isThere[0] ? 1 : 0] ?? null;
  return (
    <Exercise
      number={3}
      ask="Two small pieces touch in the marked point. Give both of its addresses."
      hints={[
        "Both pieces are in piece 3: they are 31 and 32.",
        "In piece 31 it is the right corner: the digit 2, again and again. In piece 32 it is the left corner.",
      ]}
      solved={solved}
      status={
        solved
          ? "One point, two addresses: it belongs to two pieces."
          : isOne
            ? "Both lead there, but they are one address, written in two ways."
            : count === 1
              ? "One of them leads there. The other begins in the other piece."
              : "Neither leads there yet."
      }
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Seen address={shown} target={TOUCH} />
        <div>
          {NAMES.map((name, i) => (
            <AddressField
              key={name}
              label={name}
              text={texts[i] ?? ""}
              onText={(text) => setTexts(texts.map((now, k) => (k === i ? text : now)))}
            />
          ))}
        </div>
      </div>
    </Exercise>
  );
}
