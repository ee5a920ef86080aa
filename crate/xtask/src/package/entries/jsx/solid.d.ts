/** `import "frond-ifs/jsx/solid"`, once in a program: `<frond-view>` with its types in the JSX of Solid. */
import type { JSX } from "solid-js";
import type { FrondView, ViewAttributes, ViewEvents } from "../frond-view.js";

type Own = ViewAttributes & {
  [Name in keyof ViewEvents as `on:${Name}`]?: (event: ViewEvents[Name]) => void;
};

declare module "solid-js" {
  namespace JSX {
    interface IntrinsicElements {
      "frond-view": Own & Omit<JSX.HTMLAttributes<FrondView>, keyof Own>;
    }
  }
}
