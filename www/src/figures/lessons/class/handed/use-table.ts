import { useEffect, useRef, useState } from "preact/hooks";
import { reasonOf } from "#document/kept/database";
import { type Answers, keyOf, latest, titlesOf } from "../answers";
import { type Arrival, arrive } from "./arrive";
import { HandedIn } from "./handed-in";

const kept = new HandedIn();

/** All that was handed in, of which the answers to one sheet are shown. */
export interface Answered {
  /** Null until it is known what this browser has kept. */
  all: readonly Answers[] | null;
  titles: readonly string[];
  /** The sheet whose table is shown. */
  title: string;
  shown: readonly Answers[];
  /** Why nothing is kept. */
  problem: string | null;
  show(title: string): void;
  /**
   * Takes answers in, and shows the table of the sheet that is named. `kept` resolves once the browser has kept them,
   * or `problem` says why it has not.
   */
  take(found: readonly Answers[], title: string | undefined): { arrivals: Arrival[]; kept: Promise<void> };
  /** They leave the table once the browser has let go of them: who sees them gone may close the page. */
  remove(gone: readonly Answers[]): Promise<void>;
  /** Puts back what was removed. */
  restore(gone: readonly Answers[]): Promise<void>;
}

export function useTable(): Answered {
  const [all, showAll] = useState<readonly Answers[] | null>(null);
  // What comes in while other answers are being read is added to them.
  const now = useRef<readonly Answers[]>([]);
  const [wanted, show] = useState<string | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const set = (next: readonly Answers[]) => {
    now.current = next;
    showAll(next);
  };
  const after = (work: Promise<void>): Promise<void> =>
    work.then(
      () => setProblem(null),
      (reason) => setProblem(reasonOf(reason)),
    );
  useEffect(() => {
    let here = true;
    const begin = (found: readonly Answers[]) => {
      if (!here) return;
      now.current = latest([...now.current, ...found]);
      showAll(now.current);
    };
    // Where nothing is kept, that is told when there is something to keep.
    kept.list().then(begin, () => begin([]));
    return () => {
      here = false;
    };
  }, []);
  const titles = titlesOf(all ?? []);
  const title = titles.find((one) => one === wanted) ?? titles[0] ?? "";
  return {
    all,
    titles,
    title,
    shown: (all ?? []).filter((one) => one.title === title),
    problem,
    show,
    take(found, title) {
      const { all: next, arrivals } = arrive(now.current, found);
      set(next);
      if (title !== undefined) show(title);
      const taken = arrivals.filter(({ outcome }) => outcome === "new" || outcome === "newer");
      const keeping = taken.length > 0 ? after(kept.keep(taken.map(({ answers }) => answers))) : undefined;
      return { arrivals, kept: keeping ?? Promise.resolve() };
    },
    async remove(gone) {
      const keys = new Set(gone.map(keyOf));
      await after(kept.remove(gone));
      set(now.current.filter((one) => !keys.has(keyOf(one))));
    },
    async restore(gone) {
      await after(kept.keep(gone));
      set(latest([...now.current, ...gone]));
    },
  };
}
