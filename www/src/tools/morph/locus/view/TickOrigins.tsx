import type { ComponentChildren } from "preact";
import { fixed } from "#format/numbers";
import { powerWords, resolutionWords } from "#format/verdict";
import locusCss from "#stage/locus/locus.module.css";
import * as messages from "../messages";
import type { Origin } from "./geometry";
import { large } from "./large";
import { axisOf, NAMES } from "./Ticks";
import { epsilon, family, view } from "./view";

/** From here on samples are but a few steps of f64 apart. */
const LAST_ZOOM = 1e12;

/**
 * What numbers of twelve digits would say at every tick, once: from where the ticks far down are counted, and in what;
 * where numbers end; and, where there is room, how near pieces count as touching.
 */
export function TickOrigins() {
  const [u, v] = [axisOf("u"), axisOf("v")];
  const { u: across, v: up } = NAMES[family.value];
  const parts: [key: string, words: ComponentChildren][] = [];
  if (u.origin && v.origin) {
    const same = u.origin.unit === v.origin.unit;
    const counted = ({ at, digits, unit }: Origin) =>
      `${at < 0 ? "+" : "−"} ${fixed(Math.abs(at), Math.min(20, digits))}${same ? "" : messages.inUnits(powerWords(unit))}`;
    parts.push(["u", [<i key="u">{across}</i>, ` ${counted(u.origin)}`]]);
    parts.push(["v", [<i key="v">{up}</i>, ` ${counted(v.origin)}`]]);
    if (same) parts.push(["unit", messages.countedIn(powerWords(u.origin.unit))]);
  }
  if (view.value.zoom >= LAST_ZOOM) parts.push(["end", messages.n64BitNumbersEnd]);
  if (large.value) parts.push(["epsilon", messages.ofDiameter(resolutionWords(epsilon.value))]);
  if (parts.length === 0) return null;
  return (
    <p class={`${locusCss["locus-origins"]} number`}>
      {parts.map(([key, words]) => (
        <span key={key}>{words}</span>
      ))}
    </p>
  );
}
