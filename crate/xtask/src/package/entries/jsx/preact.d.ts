/** `import "frond-ifs/jsx/preact"`, once in a program: `<frond-view>` with its types in the JSX of Preact. */
import type { HTMLAttributes } from "preact";
import type { FrondView, ViewAttributes, ViewEvents } from "../frond-view.js";

type Own = ViewAttributes & { [Name in keyof ViewEvents as `on${Name}`]?: (event: ViewEvents[Name]) => void };

declare module "preact" {
  namespace JSX {
    interface IntrinsicElements {
      "frond-view": Own & Omit<HTMLAttributes<FrondView>, keyof Own>;
    }
  }
}
