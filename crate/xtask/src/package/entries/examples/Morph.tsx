// A component for React 19: a morph with a slider of its own, which says whether it holds together.
import "frond-ifs/jsx/react"; // the types of <frond-view>
import "frond-ifs/view"; // the element itself
import { useState } from "react";

export function Morph({ from = "dragon-3", to = "gasket" }: { from?: string; to?: string }) {
  const [t, setT] = useState(0.4);
  const [words, setWords] = useState("");
  return (
    <figure>
      <frond-view
        a={from}
        b={to}
        t={t}
        label={`${from} becomes ${to}`}
        onverdict={({ detail }) => setWords(detail.words)}
        onerror={({ detail }) => setWords(detail.message)}
        verdict
      />
      <input
        type="range"
        min={0}
        max={1}
        step={0.001}
        value={t}
        aria-label="Time"
        onChange={({ target }) => setT(Number(target.value))}
      />
      <figcaption role="status">{words}</figcaption>
    </figure>
  );
}
