/** `import "frond-ifs/jsx/svelte"`, once in a program: `<frond-view>` with its types in the markup of Svelte 5. */
import type { HTMLAttributes } from "svelte/elements";
import type { FrondView, ViewAttributes, ViewEvents } from "../frond-view.js";

type Own = ViewAttributes & { [Name in keyof ViewEvents as `on${Name}`]?: (event: ViewEvents[Name]) => void };

declare module "svelte/elements" {
  interface SvelteHTMLElements {
    "frond-view": Own & Omit<HTMLAttributes<FrondView>, keyof Own>;
  }
}
