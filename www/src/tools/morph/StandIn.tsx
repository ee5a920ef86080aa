/** What takes the place of systems in this tool: loaded when there is some. */
import { fetchCurves } from "#curve/parts";
import { standIn } from "#document/stand-in";
import { lazily } from "#ui/lazy";
import { gallery } from "./dialogs";

const CurvePart = lazily(() => fetchCurves().then((parts) => parts.CurvePart));
const DirectedPart = lazily(() => import("#directed/index").then((module) => module.DirectedPart));

const choose = (end: "a" | "b") => {
  gallery.value = end;
};

/** A place of the page that is theirs. */
export function StandIn({ part }: { part: "panel" | "chip" | "evidence" }) {
  const Part = standIn.value === "directed" ? DirectedPart : CurvePart;
  return <Part part={part} choose={choose} />;
}
