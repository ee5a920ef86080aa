/** A point that is followed on the stage: what it is led by, and the game of reaching a cell. */
import { useSignalEffect } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { stageStyle } from "#stage/picture-style";
import { mainMaps } from "#stage/stage";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { listenForEscape } from "#ui/escape";
import { applied, back } from "#ui/orbit/follow";
import { orbitKey } from "#ui/orbit/keys";
import { OrbitControls } from "#ui/orbit/OrbitControls";
import { TargetControls } from "#ui/orbit/TargetControls";
import { toggleOrbit } from "../dialogs";
import css from "./orbit-overlay.module.css";
import {
  deepest,
  followed,
  game,
  gameProblem,
  goTo,
  hindrance,
  nextTarget,
  orbit,
  playing,
  setOrbit,
  setWay,
  showWay,
  takeNearest,
  throwAgain,
  throwBack,
  throws,
  throwTo,
  weights,
  words,
} from "./state";

export function OrbitPanel() {
  const heading = useRef<HTMLHeadingElement>(null);
  // At once: whoever sees the panel may press a key.
  useLayoutEffect(() => {
    const side = heading.current?.closest(".side");
    // The button that was pressed is further down now.
    if (document.activeElement === document.body || side?.contains(document.activeElement))
      heading.current?.focus({ preventScroll: true });
    if (side) side.scrollTop = 0;
    const stopEscape = listenForEscape(toggleOrbit);
    // Before the keys of the tool, of which some are digits, too.
    document.addEventListener("keydown", onKey, { capture: true });
    return () => {
      document.removeEventListener("keydown", onKey, { capture: true });
      stopEscape();
    };
  }, []);
  // A shape that cannot be played on is followed all the same.
  useSignalEffect(() => {
    if (gameProblem.value) playing.value = false;
  });
  return (
    <section class={css["orbit-panel"]} aria-label="Follow a point">
      <header class="section-head">
        <h2 tabIndex={-1} ref={heading}>
          Follow a point
        </h2>
        <Button kind="primary" icon="check" onClick={toggleOrbit}>
          Done
        </Button>
      </header>
      {hindrance.value ? <p class="problem">{hindrance.value}</p> : <Followed />}
    </section>
  );
}

function Followed() {
  const count = mainMaps.value.length;
  const colours = stageStyle.value.palette ?? [];
  const problem = gameProblem.value;
  const way = playing.value ? "game" : orbit.value.way === "apply" ? "apply" : "read";
  return (
    <>
      <Segmented
        label="What is done with the point"
        value={way}
        options={[
          { value: "apply", label: "Apply maps", description: "Each map takes the point to another place" },
          {
            value: "read",
            label: "Address",
            description: "Read the address: in which piece is the point, and in which piece of that?",
          },
          {
            value: "game",
            label: "Reach a cell",
            description: "A game: choose the throws that lead into the framed cell",
            disabled: problem !== null,
          },
        ]}
        onChange={(next) => {
          playing.value = next === "game";
          if (next !== "game") setWay(next);
        }}
      />
      {problem !== null && <p class="hint">{problem}</p>}
      {playing.value ? (
        <>
          <p class="hint">
            Reach the framed cell in as few throws as you can. Press a number, its key, or a piece in the
            picture. <a href="#learn/e31">The lesson on it</a>
          </p>
          <TargetControls
            game={game.value}
            letters={throws.value}
            maps={count}
            colours={colours}
            deepest={deepest.value}
            onThrow={throwTo}
            onBack={throwBack}
            onAgain={throwAgain}
            onNew={nextTarget}
            onShow={showWay}
          />
        </>
      ) : (
        <>
          <p class="hint">
            Press the picture to choose a point, or drag the ring.{" "}
            <a href="#learn/e16">What is an address?</a>
          </p>
          <OrbitControls
            orbit={orbit.value}
            followed={followed.value}
            maps={count}
            weights={weights.value}
            colours={colours}
            words={words.value}
            onOrbit={setOrbit}
            onPoint={(point) => goTo(point, 0)}
            onNearest={takeNearest}
          />
        </>
      )}
    </>
  );
}

function onKey(event: KeyboardEvent): void {
  if (hindrance.peek() || document.querySelector("dialog[open]") !== null) return;
  const key = orbitKey(event, mainMaps.peek().length);
  // Letters are read, not chosen: then digits are what they are elsewhere.
  if (key === null || (key !== "back" && !playing.peek() && orbit.peek().way !== "apply")) return;
  event.preventDefault();
  if (playing.peek()) {
    if (key === "back") throwBack();
    else throwTo(key);
  } else setOrbit(key === "back" ? back(orbit.peek()) : applied(orbit.peek(), key));
}
