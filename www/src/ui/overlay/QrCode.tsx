import { useMemo } from "preact/hooks";
import { encode } from "uqr";
import { NIGHT, WHITE } from "#style/colours";
import * as messages from "../messages";
import css from "./qr-code.module.css";

interface QrCodeProps {
  address: string;
  label?: string;
  /** As wide as there is room, to be read from a distance. */
  large?: boolean;
}

/** A link for a telephone that is held before the screen. */
export function QrCode({ address, label = messages.qrCodeLink, large = false }: QrCodeProps) {
  const code = useMemo(() => {
    try {
      return encode(address, { ecc: "L", border: 4 });
    } catch {
      return null;
    }
  }, [address]);
  if (!code) return <p class="hint">{messages.linkTooLongFor}</p>;
  const { size, data } = code;
  const path = data
    .flatMap((row, y) => row.flatMap((dark, x) => (dark ? [`M${x} ${y}h1v1h-1z`] : [])))
    .join("");
  return (
    <svg
      class={`${css["code"]} ${large ? css["large"] : ""}`}
      viewBox={`0 0 ${size} ${size}`}
      role="img"
      aria-label={label}
    >
      <rect width={size} height={size} fill={WHITE} />
      <path d={path} fill={NIGHT} shape-rendering="crispEdges" />
    </svg>
  );
}
