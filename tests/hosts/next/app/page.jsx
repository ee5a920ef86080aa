import init, { connectedness, presets } from "frond-ifs";
import { Morph } from "./Morph";

export default async function Page() {
  await init();
  const { verdict } = connectedness(
    presets().find(({ id }) => id === "gasket"),
    { epsilon: 1e-4 },
  );
  return (
    <main>
      <p>The server says: {verdict}</p>
      <Morph t={0.4} />
    </main>
  );
}
