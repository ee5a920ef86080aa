import { useMemo } from "preact/hooks";
import { preset } from "../../kit/frame/studio-link";
import { Fitted } from "../../kit/picture/fitted";

export function Thumb() {
  const { maps } = useMemo(() => preset("fern"), []);
  return <Fitted of={maps} />;
}
