import { useMemo } from "preact/hooks";
import { startRun } from "../../kit/connectedness/buffer-run";
import { Buffer } from "../../kit/connectedness/index-buffer";
import { gasket } from "../../kit/maps/families";
import { Small } from "../../kit/picture/small";

export function Thumb() {
  const run = useMemo(() => {
    const started = startRun(gasket(0.49), 17, 3000);
    started.plotTo(3000);
    return started;
  }, []);
  return (
    <Small>
      <Buffer run={run} count={run.count} label={null} />
    </Small>
  );
}
