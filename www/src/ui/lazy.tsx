import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { loadAgain, notify, wordsOf } from "#document/notice";
import * as messages from "./messages";

/** A component that is loaded when it is first shown: nothing until then. */
export function lazily<P extends object>(load: () => Promise<ComponentType<P>>): ComponentType<P> {
  const there = signal<{ Component: ComponentType<P> } | null>(null);
  return function Lazy(props: P) {
    useEffect(() => {
      if (there.peek()) return;
      load().then(
        (Component) => {
          there.value = { Component };
        },
        (problem) =>
          notify({
            kind: "error",
            text: messages.partNotLoaded(wordsOf(problem)),
            action: loadAgain,
          }),
      );
    }, []);
    const Component = there.value?.Component;
    return Component ? <Component {...props} /> : null;
  };
}
