import { signal } from "@preact/signals";
import { createContext } from "preact";
import { type StateUpdater, useContext, useLayoutEffect, useState } from "preact/hooks";
import type { Field } from "./fields";
import { PageState } from "./page-state";

/** The page that one is in. Small pictures and tests are in none: there nothing is opened, and nothing kept. */
export const Page = createContext<PageState>(new PageState());

/** Values whose names it finds are seen as they are at first, whatever they were set to: of exercises on paper. */
export const seenAtFirst = signal<RegExp | null>(null);

/**
 * Values whose names it finds begin once more while it is set, and are what they were when it no longer is: on slides,
 * before a class, nobody sees what the teacher has tried. Each time that it is set they begin anew.
 */
export const afresh = signal<{ of: RegExp } | null>(null);

/** How a value begins, and how it is written: what `useKept` is given besides its name. */
export const kept = <T>(first: T, field: Field<T>): readonly [first: T, field: Field<T>] => [first, field];

/**
 * As `useState`, for what belongs into the address of the page: it begins as the address says, and what it becomes goes
 * into the link that is copied. No other value of the page may have the name, and links are a promise: it stays.
 */
export function useKept<T>(
  name: string,
  first: T,
  field: Field<T>,
): [value: T, set: (next: StateUpdater<T>) => void] {
  const page = useContext(Page);
  const [value, setValue] = useAfresh<T>(name, () => page.opened(name, field) ?? first, first);
  const text = field.write(value);
  useNoted(name, text === field.write(first) ? null : text);
  const asAtFirst = seenAtFirst.value?.test(name) ?? false;
  return [asAtFirst ? first : value, setValue];
}

/** As `useState`, for what begins once more with `first` while `afresh` is set for its name. */
export function useAfresh<T>(
  name: string,
  opened: T | (() => T),
  first: T,
): [value: T, set: (next: StateUpdater<T>) => void] {
  const [own, setOwn] = useState<T>(opened);
  const now = afresh.value;
  const [other, setOther] = useState<{ of: typeof now; value: T } | null>(null);
  if (now === null || !now.of.test(name)) return [own, setOwn];
  const set = (next: StateUpdater<T>) =>
    setOther((before) => {
      const value = before?.of === now ? before.value : first;
      return { of: now, value: typeof next === "function" ? (next as (value: T) => T)(value) : next };
    });
  return [other?.of === now ? other.value : first, set];
}

/** Notes a value of the page that is kept elsewhere; null where it is as it was at first. */
export function useNoted(name: string, text: string | null): void {
  const page = useContext(Page);
  useLayoutEffect(() => {
    page.note(name, text);
    return () => page.note(name, null);
  }, [page, name, text]);
}
