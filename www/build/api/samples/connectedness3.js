import init, { connectedness3, presets3 } from "frond-ifs/space";

await init();
for (const { name, maps } of presets3().slice(0, 4)) console.log(name, connectedness3(maps, {}).verdict);
