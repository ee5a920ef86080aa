import init, { decodeScene } from "frond-ifs/draw";

await init();
const { scene, problem } = decodeScene("a=fern&b=tree");
console.log(scene.a.name, scene.b.maps.length, problem);
