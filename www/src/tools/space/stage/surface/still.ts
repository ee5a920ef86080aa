import { lampInBands, litInBands, reliefInBands } from "#workers/space/bands";
import type { Relief } from "#workers/space/picture";
import { lookOf, sameView, type Wanted } from "./surface";

/** Whether the light is of a kind that the processor alone casts. */
export const castsShadows = ({ light }: Pick<Wanted, "light">): boolean =>
  (light.shadows ?? 0) > 0 || (light.occlusion ?? 0) > 0;

/** As far as what was carved before the lamp hangs on the light. */
const lampOf = ({ light }: Wanted): string => JSON.stringify([light.side, light.front]);

/**
 * Makes complete pictures. What was carved is kept for as long as the view stays: other light and other colours need no
 * more carving.
 */
export class Still {
  #view: Wanted | null = null;
  readonly #reliefs = new Map<number, Relief>();
  #lamp: { key: string; depth: Float32Array<ArrayBuffer> } | null = null;

  /** What is carved, with so many pixels for each that is shown. */
  async relief(wanted: Wanted, factor: 1 | 2, signal: AbortSignal): Promise<Relief> {
    this.#look(wanted);
    const kept = this.#reliefs.get(factor);
    if (kept) return kept;
    const { sight, view, width, height } = wanted;
    const size = { width: width * factor, height: height * factor };
    const relief = await reliefInBands({ objects: sight.objects, view, ...size }, { signal });
    if (this.#view && sameView(this.#view, wanted)) this.#reliefs.set(factor, relief);
    return relief;
  }

  /** The same, lit. */
  async lit(wanted: Wanted, factor: 1 | 2, relief: Relief, signal: AbortSignal): Promise<ImageData> {
    const { sight, view, light } = wanted;
    const lamp = await this.#lampDepth(wanted, signal);
    const reach = factor / wanted.factor;
    const around = sight.handle.lightReach(view, light, reach);
    const request = { ...lookOf(wanted), factor, view, light, objects: sight.objects };
    return litInBands(request, relief, { lamp, reach, around, signal });
  }

  async #lampDepth(wanted: Wanted, signal: AbortSignal): Promise<Float32Array<ArrayBuffer>> {
    const { sight, view, light, width, height } = wanted;
    const side = sight.handle.lampSide(view, light, width, height);
    if (side === 0) return new Float32Array(0);
    this.#look(wanted);
    const key = lampOf(wanted);
    if (this.#lamp?.key === key) return this.#lamp.depth;
    const depth = await lampInBands({ objects: sight.objects, view, light, width, height }, side, { signal });
    if (this.#view && sameView(this.#view, wanted)) this.#lamp = { key, depth };
    return depth;
  }

  /** Lets go what is of another view. */
  #look(wanted: Wanted): void {
    if (this.#view && sameView(this.#view, wanted)) return;
    this.#view = wanted;
    this.#reliefs.clear();
    this.#lamp = null;
  }
}
