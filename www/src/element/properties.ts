/** Each attribute of the element as a property: it reads the attribute, and writes it. */
import { SECONDS } from "./light";
import { isOn, mapsTextOf, meansOn, pathTextOf, textOf } from "./values";

/** Where there are no elements, as on a server, the class is there all the same, for whoever imports it. */
const Page = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

type Text = string | null;
/** What may be written: what means nothing is told, and not thrown. */
type Any = unknown;

export class Properties extends Page {
  get src(): Text {
    return this.getAttribute("src");
  }
  set src(value: Any) {
    this.write("src", textOf(value));
  }

  get a(): Text {
    return this.getAttribute("a");
  }
  set a(value: Any) {
    this.write("a", mapsTextOf(value));
  }

  get b(): Text {
    return this.getAttribute("b");
  }
  set b(value: Any) {
    this.write("b", mapsTextOf(value));
  }

  get path(): Text {
    return this.getAttribute("path");
  }
  set path(value: Any) {
    this.write("path", pathTextOf(value));
  }

  get tool(): Text {
    return this.getAttribute("tool");
  }
  set tool(value: Any) {
    this.write("tool", textOf(value));
  }

  get theme(): Text {
    return this.getAttribute("theme");
  }
  set theme(value: Any) {
    this.write("theme", textOf(value));
  }

  get poster(): Text {
    return this.getAttribute("poster");
  }
  set poster(value: Any) {
    this.write("poster", textOf(value));
  }

  get label(): Text {
    return this.getAttribute("label");
  }
  set label(value: Any) {
    this.write("label", textOf(value));
  }

  get studio(): Text {
    return this.getAttribute("studio");
  }
  set studio(value: Any) {
    this.write("studio", textOf(value));
  }

  get seconds(): number {
    const text = this.getAttribute("seconds");
    const asked = text === null || text.trim() === "" ? SECONDS.usual : Number(text);
    return Number.isFinite(asked) ? Math.min(SECONDS.most, Math.max(SECONDS.least, asked)) : SECONDS.usual;
  }
  set seconds(value: Any) {
    this.write("seconds", textOf(value));
  }

  get controls(): boolean {
    return isOn(this.getAttribute("controls"));
  }
  set controls(value: Any) {
    this.toggleAttribute("controls", meansOn(value));
  }

  get autoplay(): boolean {
    return isOn(this.getAttribute("autoplay"));
  }
  set autoplay(value: Any) {
    this.toggleAttribute("autoplay", meansOn(value));
  }

  get loop(): boolean {
    return isOn(this.getAttribute("loop"));
  }
  set loop(value: Any) {
    this.toggleAttribute("loop", meansOn(value));
  }

  get locus(): boolean {
    return isOn(this.getAttribute("locus"));
  }
  set locus(value: Any) {
    this.toggleAttribute("locus", meansOn(value));
  }

  get panel(): boolean {
    return isOn(this.getAttribute("panel"));
  }
  set panel(value: Any) {
    this.toggleAttribute("panel", meansOn(value));
  }

  /** Writes an attribute; null takes it away. */
  protected write(name: string, text: Text): void {
    if (text === null) this.removeAttribute(name);
    else this.setAttribute(name, text);
  }
}
