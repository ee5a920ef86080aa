import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import { list, number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { chances } from "./dice";

/** A chance as parts of 100. */
export const percent = (chance: number) => `${fixed(100 * chance, 1)} of 100`;

/** A weight for each face of the die; `name` is theirs in the address of the lesson. */
export function useWeights(name: string, first: readonly number[]) {
  const [weights, setWeights] = useKept(name, first, list(number(0.01, 1, 2), first.length, first.length));
  const each = useMemo(() => chances(weights), [weights]);
  const set = (face: number, weight: number) =>
    setWeights(weights.map((old, i) => (i === face ? weight : old)));
  return { weights, each, set };
}

/** A slider for each weight, with the chance that comes of it. */
export function Weights({ of: { weights, each, set } }: { of: ReturnType<typeof useWeights> }) {
  return (
    <>
      {weights.map((weight, i) => (
        <SliderControl
          // Faces have no name but their number: it is their key.
          key={i}
          label={`Weight of face ${i + 1}`}
          range={[0.01, 1]}
          value={weight}
          text={`${fixed(weight)}: ${percent(each[i] ?? 0)}`}
          onChange={(next) => set(i, next)}
        />
      ))}
    </>
  );
}
