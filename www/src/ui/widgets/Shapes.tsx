import { useState } from "preact/hooks";
import { GREY } from "#style/colours";
import { palette } from "#style/palette";
import type { MapRow3 } from "#wasm/api";
import { IconButton } from "../controls/Button";
import { KeptRow, KeptRows } from "../kept/KeptRow";
import { HalfTurns } from "../panel/HalfTurns";
import { EndCard } from "../shapes/EndCard";
import { FlattenedMaps } from "../shapes/FlattenedMaps";
import { Graph } from "../shapes/Graph";
import { MapBlocks } from "../shapes/MapBlocks";
import { MapList, MapTools } from "../shapes/MapList";
import { ShapeGrid } from "../shapes/ShapeGrid";
import { SubjectCard } from "../shapes/SubjectCard";
import { Thumbnail } from "../shapes/Thumbnail";
import { VerdictSign } from "../shapes/VerdictSign";
import { LONG, State, Widget } from "./Widget";

const nothing = () => {};
const TONES = ["whole", "close", "broken", "unknown"] as const;
const SHAPES = [
  { id: "dragon", name: "Dragon", about: "Two maps that turn." },
  { id: "long", name: LONG, about: `${LONG}.` },
];
const MAP: MapRow3 = [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 0.25, -0.25, 12];

export function Shapes() {
  const [chosen, choose] = useState("dragon");
  const [open, setOpen] = useState<number | null>(0);
  const card = { end: "a", note: "2 maps", count: "2 maps", picture: <Thumbnail bitmap={null} /> } as const;
  const kept = {
    picture: card.picture,
    about: "Some time ago",
    longest: 80,
    onName: nothing,
    onNamed: nothing,
  } as const;
  return (
    <>
      <Widget name="VerdictSign">
        {TONES.map((tone) => (
          <State key={tone} name={tone}>
            <VerdictSign tone={tone} />
          </State>
        ))}
      </Widget>
      <Widget name="SubjectCard">
        <State name="shown" wide>
          <SubjectCard picture={card.picture} name="Dragon" about="Two maps that turn." />
        </State>
        <State name="to press, long words" wide>
          <SubjectCard picture={card.picture} name={LONG} about={LONG} label="Long" onChoose={nothing} />
        </State>
      </Widget>
      <Widget name="HalfTurns">
        <State name="one, several, more than there are buttons for" wide>
          <HalfTurns other={[0, 1, 0]} onTurn={nothing} />
          <HalfTurns other={[1, 0, -1]} onTurn={nothing} />
          <HalfTurns other={[1, 1, 1, 1, 1]} onTurn={nothing} />
        </State>
      </Widget>
      <Widget name="KeptRow">
        <State name="shown, being named, not to be opened" wide>
          <KeptRows>
            <KeptRow {...kept} name="Dragon" onOpen={nothing} naming={false}>
              <IconButton icon="bin" label="Remove Dragon" kind="quiet" />
            </KeptRow>
            <KeptRow {...kept} name="Fern" onOpen={nothing} naming>
              <IconButton icon="bin" label="Remove Fern" kind="quiet" />
            </KeptRow>
            <KeptRow {...kept} name={LONG} naming={false}>
              <IconButton icon="bin" label={`Remove ${LONG}`} kind="quiet" />
            </KeptRow>
          </KeptRows>
        </State>
        <State name="in a panel, long words" wide>
          <KeptRows>
            <KeptRow {...kept} small name={LONG} onOpen={nothing} naming={false}>
              <IconButton icon="more" label={`More for ${LONG}`} kind="quiet" />
            </KeptRow>
          </KeptRows>
        </State>
      </Widget>
      <Widget name="EndCard">
        <State name="plain, with a button" wide>
          <EndCard {...card} name="Dragon" onChoose={nothing}>
            <IconButton icon="edit" label="Edit" kind="quiet" />
          </EndCard>
        </State>
        <State name="edited and being edited, long words" wide>
          <EndCard {...card} name={LONG} count="edited" editing onChoose={nothing} />
        </State>
      </Widget>
      <Widget name="Graph" state="one piece, two that are apart" wide>
        <Graph count={1} angles={[0]} edges={[]} colours={[palette("light")[1] ?? GREY]} label="One piece" />
        <Graph
          count={3}
          angles={[0, 2, 4]}
          edges={[[0, 1]]}
          colours={palette("light").slice(0, 3)}
          label="Three pieces, two of which are joined"
        />
      </Widget>
      <Widget name="MapBlocks" state="two maps, one number set apart" wide>
        <MapBlocks
          label="Maps"
          maps={[MAP, MAP]}
          marked={(map, place) => map === 1 && place === 0}
          mark="changed"
        />
      </Widget>
      <Widget name="FlattenedMaps" state="a number that grows" wide>
        <FlattenedMaps of={{ maps: [MAP], largest: 40, diverging: [[0, 1]] }} most={3} />
      </Widget>
      <Widget name="MapList" state="one of three is open, long words" wide>
        <MapList
          maps={["half as large", LONG, "turned"]}
          open={open}
          onOpen={setOpen}
          swatch={() => <VerdictSign tone="whole" />}
          fields={(index) => <MapTools maps={[1, 2, 3]} index={index} most={3} onPress={nothing} />}
        />
      </Widget>
      <Widget name="ShapeGrid" state="one chosen, no picture yet, long words" wide>
        <ShapeGrid
          presets={SHAPES}
          noteOf={() => "2 maps"}
          pictures={new Map()}
          chosen={chosen}
          onChoose={({ id }) => choose(id)}
        />
      </Widget>
    </>
  );
}
