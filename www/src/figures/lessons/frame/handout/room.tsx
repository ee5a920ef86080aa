import "./handout.css";
import { QrCode } from "#ui/overlay/QrCode";
import { useValue } from "../../../kit/workers";
import { paper } from "./paper";
import css from "./room.module.css";

/** Lines to write on, so many at least, and as many as the page has room for, or `most`; on paper only. */
export function Room({ lines, most = 99 }: { lines: number; most?: number }) {
  return <div class={css["room"]} style={{ "--lines": lines, "--most": most }} aria-hidden="true" />;
}

/** Squares of half a centimetre to draw on; on paper only. */
export function Squares() {
  return <div class={css["squares"]} aria-hidden="true" />;
}

/** Whose handout it is, and where the lesson is to be found; on paper only. */
export function Whose({ lesson }: { lesson: string }) {
  const address = `${location.origin}${location.pathname}#learn/${lesson}`;
  return (
    <div class={css["whose"]} aria-hidden="true">
      <span>Name</span>
      <span>Date</span>
      {useValue(paper) && (
        <>
          <QrCode address={address} />
          <p>{address.replace(/^https?:\/\//, "")}</p>
        </>
      )}
    </div>
  );
}
