/** What a fit is called. */
import * as messages from "../messages";

/** Of a file without its ending, as long as links allow. */
export function plainName(name: string): string {
  return name.replace(/\.[a-z]{3,7}$/i, "").slice(0, 40) || messages.leaf;
}
