import init, { importFile } from "frond-ifs/exchange";

await init();
const text = `gasket {
  0.5 0 0 0.5 0 0 0.33
  0.5 0 0 0.5 0.5 0 0.33
  0.5 0 0 0.5 0.25 0.433 0.34
}`;
const { format, systems } = importFile(new TextEncoder().encode(text));
console.log(format, systems[0].name, systems[0].maps.length); // fractint gasket 3
