import init, { exportMaps } from "frond-ifs/exchange";

await init();
const koch = {
  name: "Half",
  maps: [
    [0.5, 0, 0, 0.5, 0, 0],
    [0.5, 0, 0, 0.5, 0.5, 0],
  ],
};
console.log(exportMaps(koch, "latex"));
