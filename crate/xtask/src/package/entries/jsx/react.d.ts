/** `import "frond-ifs/jsx/react"`, once in a program: `<frond-view>` with its types in the JSX of React 19. */
import type { DetailedHTMLProps, HTMLAttributes } from "react";
import type { FrondView, ViewAttributes, ViewEvents } from "../frond-view.js";

type Own = ViewAttributes & { [Name in keyof ViewEvents as `on${Name}`]?: (event: ViewEvents[Name]) => void };
type Known = DetailedHTMLProps<HTMLAttributes<FrondView>, FrondView>;

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "frond-view": Own & Omit<Known, keyof Own>;
    }
  }
}
