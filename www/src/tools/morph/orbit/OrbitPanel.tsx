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
import * as messages from "./messages";
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
    <section class={css["orbit-panel"]} aria-label={messages.followPoint}>
      <header class="section-head">
        <h2 tabIndex={-1} ref={heading}>
          {messages.followPoint}
        </h2>
        <Button kind="primary" icon="check" onClick={toggleOrbit}>
          {messages.done}
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
        label={messages.whatToDoWith}
        value={way}
        options={[
          { value: "apply", label: messages.applyMaps, description: messages.eachMapTakesPoint },
          {
            value: "read",
            label: messages.address,
            description: messages.readAddressPieceContains,
          },
          {
            value: "game",
            label: messages.reachCell,
            description: messages.gameChooseThrowsLead,
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
            {messages.reachFramedCellIn} <a href="#learn/e31">{messages.lessonOnThisGame}</a>
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
            {messages.clickPictureToChoose} <a href="#learn/e16">{messages.whatAddress}</a>
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
