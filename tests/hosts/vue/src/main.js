import { createApp } from "vue";
import Morph from "./Morph.vue";

createApp(Morph, { t: 0.4 }).mount("#root");
