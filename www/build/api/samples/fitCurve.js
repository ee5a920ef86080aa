import init, { fitCurve } from "frond-ifs/fit";

await init();
const square = [0, 0, 1, 0, 1, 1, 0, 1];
const { figures, bytes } = fitCurve(square, { numbers: 12 });
console.log(JSON.stringify(figures), bytes);
