import init, { polar } from "frond-ifs/draw";

await init();
// A quarter turn and half the size.
const { angle, reflects, determinant } = polar([0, -0.5, 0.5, 0, 1, 2]);
console.log(angle === Math.PI / 2, reflects, determinant); // true false 0.25
