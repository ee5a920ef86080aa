import init, { bounds } from "frond-ifs/draw";

await init();
// Two halves of the segment from 0 to 1.
const segment = {
  maps: [
    [0.5, 0, 0, 0.5, 0, 0],
    [0.5, 0, 0, 0.5, 0.5, 0],
  ],
};
const { max, dimension } = bounds(segment);
console.log(max[0].toFixed(3), dimension.toFixed(3)); // 1.000 1.000
