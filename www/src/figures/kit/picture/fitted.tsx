import { useMemo } from "preact/hooks";
import type { MapRow } from "#wasm/api";
import { boxAround } from "../maps/morphs";
import { Picture } from "./picture";

/** A shape as large as its place, for a small picture that its surroundings describe. */
export function Fitted({ of: maps }: { of: MapRow[] }) {
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Picture maps={maps} box={box} label={null} />;
}
