import { useEffect } from "preact/hooks";
import { choice, listen } from "./door";
import { Picker } from "./Picker";

/** What opens files, and asks which of several systems is meant. */
export function Door() {
  useEffect(listen, []);
  return choice.value && <Picker />;
}
