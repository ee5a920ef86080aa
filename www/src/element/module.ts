/** The element for `import`: it brings what decides and proves along, in files that bundlers know of. */
import { FrondView } from "./element";
import { bringProof } from "./proof";

bringProof(async () => {
  const parts = await Promise.all([
    import("frond-proof?part=1"),
    import("frond-proof?part=2"),
    import("frond-proof?part=3"),
    import("frond-proof?part=4"),
  ]);
  return parts.map(({ text }) => text).join("");
});

export { FrondView };
