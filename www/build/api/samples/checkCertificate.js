import init, { certificate, checkCertificate } from "frond-ifs";

await init();
// Cantor's set: two thirds of a segment.
const cantor = {
  maps: [
    [1 / 3, 0, 0, 1 / 3, 0, 0],
    [1 / 3, 0, 0, 1 / 3, 2 / 3, 0],
  ],
};
const proof = certificate(cantor, {});
console.log(JSON.stringify(checkCertificate(proof)));
