/** A page around the component that is shown: it says when it is, and hears what the component says. */
import { Morph } from "example:react";
import { render } from "preact";
import { useState } from "preact/hooks";

function Host() {
  const [t, setT] = useState(0.4);
  const [words, setWords] = useState("");
  return (
    <>
      <Morph t={t} onVerdict={setWords} />
      <label>
        t{" "}
        <input
          type="range"
          min="0"
          max="1"
          step="0.01"
          value={t}
          onInput={({ currentTarget }) => setT(currentTarget.valueAsNumber)}
        />
      </label>{" "}
      <output>{words}</output>
    </>
  );
}

const place = document.getElementById("react");
if (place) render(<Host />, place);
