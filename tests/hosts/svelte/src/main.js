import { mount } from "svelte";
import Morph from "./Morph.svelte";

mount(Morph, { target: document.getElementById("root"), props: { t: 0.4 } });
