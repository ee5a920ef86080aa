import init, { LinkedMorph } from "frond-ifs/morph";

await init();
const morph = new LinkedMorph("a=fern&b=tree");
console.log(morph.a, "-", morph.b);
console.log(morph.maps(0.5, 0.5, 0).length / 6); // 4
morph.free();
