import type { ComponentChildren } from "preact";

/**
 * Notation of the papers, set apart from the words around it. All of it goes through here, so that it can become
 * MathML.
 */
export function Formula({ children }: { children: ComponentChildren }) {
  return <span class="symbol">{children}</span>;
}
