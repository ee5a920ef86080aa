import { useState } from "preact/hooks";
import { useOwnId } from "../id";

/** What is wrong with the fields of one group, told in one place below them. */
export function useProblems() {
  const id = useOwnId("problems");
  const [problems, setProblems] = useState<Record<string, string>>({});
  const tellOf = (field: string) => ({
    id,
    tell: (words: string | null) =>
      setProblems(({ [field]: _old, ...others }) =>
        words === null ? others : { ...others, [field]: words },
      ),
  });
  const below = (
    <div id={id} role="alert">
      {Object.entries(problems).map(([field, words]) => (
        <p key={field} class="field-problem">
          {words}
        </p>
      ))}
    </div>
  );
  return { tellOf, below };
}
