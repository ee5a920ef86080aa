/**
 * `import "frond-ifs/jsx/vue"`, once in a program: `<frond-view>` with its types in the templates and the JSX of Vue.
 * Tell Vue's compiler that it is an element: `isCustomElement: (tag) => tag === "frond-view"`.
 */
import type { HTMLAttributes, PublicProps } from "vue";
import type { FrondView, ViewAttributes, ViewEvents } from "../frond-view.js";

type Heard = { [Name in keyof ViewEvents as `on${Capitalize<Name>}`]?: (event: ViewEvents[Name]) => void };
type Own = ViewAttributes & Heard;

type View = new () => FrondView & {
  /** Read by templates alone. */
  $props: Own & Omit<HTMLAttributes, keyof Own> & PublicProps;
};

declare module "vue" {
  interface GlobalComponents {
    "frond-view": View;
  }
}
