import { lettersOf } from "./cells";
import { Field } from "./field";

const TARGET = lettersOf("13");
const THROWS = lettersOf("31");

export function Thumb() {
  return <Field label={null} target={TARGET} throws={THROWS} size={1.6} />;
}
