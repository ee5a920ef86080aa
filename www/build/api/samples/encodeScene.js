import init, { decodeScene, encodeScene } from "frond-ifs/draw";

await init();
const { scene } = decodeScene("a=dragon-3&b=gasket");
scene.t = 0.25;
console.log(encodeScene(scene));
