import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import { family, setPlane, sides } from "./view";

type Plane = "morph" | "m" | "polygon";

let lastSides = 3;

/** What is mapped: the morph, or a family whose map is a shape of its own. */
export function Planes() {
  const plane: Plane = family.value === "morph" ? "morph" : sides.value === 2 ? "m" : "polygon";
  return (
    <div class="planes">
      <Segmented<Plane>
        label="What is mapped"
        value={plane}
        options={[
          { value: "morph", label: "This morph", description: "All that the two shapes can become" },
          {
            value: "m",
            label: "Pairs (M)",
            description: "Shapes of two copies, turned and shrunk by s: {s z − 1, s z + 1}",
          },
          {
            value: "polygon",
            label: "Polygons",
            description: "Copies at the corners of a polygon, all turned and shrunk by s",
          },
        ]}
        onChange={(next) => {
          if (next === "morph") setPlane("morph", 2);
          else setPlane("polygon", next === "m" ? 2 : lastSides);
        }}
      />
      {plane === "polygon" && (
        <NumberField
          label="Corners"
          symbol="n"
          value={sides.value}
          min={3}
          max={64}
          whole
          onChange={(next) => {
            if (!Number.isInteger(next)) return "A whole number, please.";
            lastSides = next;
            setPlane("polygon", next);
            return undefined;
          }}
        />
      )}
    </div>
  );
}
