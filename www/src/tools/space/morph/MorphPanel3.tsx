import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { announce } from "#document/notice";
import { changeSpace } from "#document/space/edits";
import { choose, setMoment, setView, space, spaceReady } from "#document/space/space";
import { HomeTicks } from "#stage/locus/HomeTicks";
import { Legend } from "#stage/locus/Legend";
import { LocusHead, statesIn } from "#stage/locus/LocusHead";
import locusCss from "#stage/locus/locus.module.css";
import type { LocusStyle } from "#stage/locus/paint";
import { Button } from "#ui/controls/Button";
import { solid } from "#wasm/space";
import { EPSILON } from "#workers/lanes/locus-fill";
import * as messages from "../messages";
import { presets } from "../shape/object/presets";
import { Ends } from "./Ends";
import { Matching, othersWords } from "./Matching";
import { MomentPanel } from "./MomentPanel";
import { startingWith, withoutMorph } from "./morph-edits";
import css from "./morph3.module.css";
import { PathPanel } from "./PathPanel";
import { pause } from "./play";
import { Square } from "./Square";
import { locus, matched, morph } from "./work";

/** The morph of the first object: to what, where it holds together, and the path. */
export function MorphPanel3() {
  return spaceReady.value ? <Parts /> : null;
}

function Parts() {
  useEffect(() => pause, []);
  const now = space.value;
  if (!now) return null;
  return (
    <>
      <Ends />
      {morph.value === null ? (
        <Begin />
      ) : matched.value ? (
        <>
          <MomentPanel />
          <LocusPanel />
          <PathPanel />
          <Matching />
          <Last />
        </>
      ) : (
        <>
          <p class="notes" role="status">
            {messages.unequalMaps(
              now.objects[0]?.name ?? "",
              now.objects[0]?.maps.length ?? 0,
              morph.value.to.name,
              morph.value.to.maps.length,
            )}
          </p>
          <Last />
        </>
      )}
    </>
  );
}

function Begin() {
  return (
    <section class={css["morph3-part"]} aria-label={messages.startMorph}>
      <p class="hint">{messages.aboutMorph(othersWords())}</p>
      <DragonButton />
    </section>
  );
}

/** The best known of them, with the path that keeps it in one piece. */
function DragonButton() {
  return (
    <Button
      icon="play"
      description={messages.tetrahedronAndCurledDragon}
      onClick={() => {
        const at = (id: string) => presets().find((preset) => preset.id === id);
        const [a, b] = [at("tetrahedron"), at("dragon-curled")];
        if (!a || !b) return;
        const shape = ({ id, name, maps }: typeof a) => ({ preset: id, name, maps });
        const order = solid.correspondence3(a.maps, b.maps);
        if (!changeSpace((before) => startingWith(before, shape(a), shape(b), order))) return;
        choose(0);
        setMoment(0);
        setView(null);
        announce(messages.tetrahedronTurnsIntoDragon);
      }}
    >
      {messages.tetrahedronToDragonIn}
    </Button>
  );
}

function Last() {
  return (
    <section class={css["morph3-last"]} aria-label={messages.morph2}>
      {othersWords() !== "" && <p class="hint">{othersWords()}</p>}
      <Button
        kind="quiet"
        icon="close"
        description={messages.firstObjectStaysAs}
        onClick={() => {
          pause();
          if (changeSpace(withoutMorph)) announce(messages.morphRemoved);
        }}
      >
        {messages.removeMorph}
      </Button>
      <DragonButton />
    </section>
  );
}

/** How the field is shown: a way of looking, no part of the document. */
const style = signal<LocusStyle>("gap");
const states = statesIn(locus);

function LocusPanel() {
  return (
    <section class="locus" aria-labelledby="locus3-title">
      <LocusHead id="locus3-title" style={style} />
      <div class={locusCss["locus-plot"]}>
        <HomeTicks axis="v" />
        <Square style={style.value} />
        <HomeTicks axis="u" />
      </div>
      <Legend states={states.value} epsilon={EPSILON} style={style.value} />
    </section>
  );
}
