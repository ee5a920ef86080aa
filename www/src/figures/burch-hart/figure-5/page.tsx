import { Frame, type Heading } from "../../kit/frame/frame";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { type Breakage, shareWords, stretchWords } from "../../kit/maps/breakage";
import { STRAIGHT } from "../../kit/maps/morphs";
import { useTime } from "../../kit/time/time";
import { SAMPLES } from "../../kit/workers";
import { dragon } from "../dragon/dragon";
import { DragonChoice, dragonParameters, WHY_DRAGON } from "../dragon/dragon-choice";
import { dragonWords, Film, useBroken } from "../dragon/film";

/** Dragon to gasket along the straight line. */
export function Page(heading: Heading) {
  const time = useTime(0.5);
  const broken = useBroken(STRAIGHT);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          Turns, stretches and shifts all go from the dragon’s to the gasket’s in step. Both ends are in one
          piece, but nothing keeps the shapes between them together: hatched frames, and the hatched parts of
          the slider, are broken.
        </p>
      }
      found={<Found broken={broken} />}
      parameters={[
        ...dragonParameters(),
        { name: "Path", value: "u = v = t, straight" },
        { name: "Resolution of the verdicts", symbol: "ε", value: "1/600 of the shape" },
      ]}
      captions={["Figure 5: Polar interpolation of IFS attractors ignoring connectedness."]}
      reconstructed={WHY_DRAGON}
      studio={{ href: studioHref({ a: preset(dragon.value), b: preset("gasket"), t: time.t }) }}
    >
      <DragonChoice />
      <Film name="Figure 5" points={STRAIGHT} time={time} broken={broken} />
    </Frame>
  );
}

function Found({ broken }: { broken: Breakage | null }) {
  if (!broken) return <p>Looking at {SAMPLES} moments of the morph …</p>;
  const [first, second] = broken.halves;
  return (
    <p>
      From {dragonWords()}, {shareWords(broken.share)} of {SAMPLES} moments are broken: {shareWords(first)} of
      the first half and {shareWords(second)} of the second
      {broken.stretches.length > 0 && <> (t = {stretchWords(broken.stretches)})</>}. The paper saw it
      “particularly in the latter half of the morph”
      {second > first ? ", as here." : "; with this dragon it is the first half that suffers more."}
    </p>
  );
}
