import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import * as messages from "../messages";
import { family, setPlane, sides } from "./view";

type Plane = "morph" | "m" | "polygon";

let lastSides = 3;

/** What is mapped: the morph, or a family whose map is a shape of its own. */
export function Planes() {
  const plane: Plane = family.value === "morph" ? "morph" : sides.value === 2 ? "m" : "polygon";
  return (
    <div class="planes">
      <Segmented<Plane>
        label={messages.familyShapes}
        value={plane}
        options={[
          { value: "morph", label: messages.thisMorph, description: messages.allCanLieBetween },
          {
            value: "m",
            label: messages.pairsM,
            description: messages.shapesTwoCopiesRotated,
          },
          {
            value: "polygon",
            label: messages.polygons,
            description: messages.copiesAtCornersPolygon,
          },
        ]}
        onChange={(next) => {
          if (next === "morph") setPlane("morph", 2);
          else setPlane("polygon", next === "m" ? 2 : lastSides);
        }}
      />
      {plane === "polygon" && (
        <NumberField
          label={messages.corners}
          symbol="n"
          value={sides.value}
          min={3}
          max={64}
          whole
          onChange={(next) => {
            if (!Number.isInteger(next)) return messages.enterWholeNumber;
            lastSides = next;
            setPlane("polygon", next);
            return undefined;
          }}
        />
      )}
    </div>
  );
}
