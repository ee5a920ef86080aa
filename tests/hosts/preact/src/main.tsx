import { render } from "preact";
import { Morph } from "./Morph";

render(<Morph t={0.4} />, document.getElementById("root") as HTMLElement);
