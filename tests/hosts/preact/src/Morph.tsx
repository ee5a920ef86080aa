import { useState } from "preact/hooks";
import "frond-ifs/view";
import "frond-ifs/jsx/preact";

export function Morph({ t }: { t: number }) {
  const [words, setWords] = useState("");
  const heard = ({ detail }: CustomEvent<{ words: string }>) => setWords(detail.words);
  return (
    <>
      <frond-view a="dragon-3" b="gasket" t={t} controls verdict onverdict={heard} />
      <output>{words}</output>
    </>
  );
}
