import init, { presets } from "frond-ifs/draw";

await init();
for (const { id, name, maps } of presets()) console.log(`${id}: ${name}, ${maps.length} maps`);
