/** The link of the document, and the ways in which it goes to others. */
import { useEffect, useState } from "preact/hooks";
import { ownPicture, pictureShown } from "#document/deform/picture";
import { notify, wordsOf } from "#document/notice";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import { exportOpen } from "#film/open";
import type { Still } from "#film/subject";
import { escaped } from "#format/html";
import { withCheck } from "#format/link-mending";
import { Button } from "#ui/controls/Button";
import { Dialog } from "#ui/overlay/Dialog";
import { QrCode } from "#ui/overlay/QrCode";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { Scene } from "#wasm/api";
import { frond } from "#wasm/core";
import { link } from "../actions";
import { moving } from "../moving";
import { openedTool } from "../tools";
import { AUTOPLAY, type Moves, themeOf } from "./folder";
import * as messages from "./messages";
import { Publish } from "./Publish";
import { seenOf } from "./seen";
import css from "./share.module.css";

const STARTS = [
  { value: "here", label: messages.thisMoment },
  { value: "first", label: messages.beginning },
] as const;

const MOVES: readonly { value: Moves; label: string; description: string }[] = [
  { value: "once", label: messages.playOnce, description: messages.playsThereAndBack },
  { value: "on", label: messages.loop, description: messages.untilSomeonePauses },
  { value: "still", label: messages.paused, description: messages.untilSomeonePressesPlay },
];
const QUERY: Record<Moves, string> = { once: "?play=once", on: "?play", still: "?play=still" };

type Grounds = "page" | "here";
const GROUNDS = (isDark: boolean): readonly { value: Grounds; label: string; description: string }[] => [
  { value: "page", label: messages.readersTheme, description: messages.lightOrDarkAs },
  {
    value: "here",
    label: isDark ? messages.dark : messages.light,
    description: messages.sameBackgroundAndColours,
  },
];

/** From one of the two sheets to the other, or out: a sheet that has gone already closes nothing. */
const leave = (from: "share" | "publish", to: "share" | null) => () => {
  if (exportOpen.peek() === from) exportOpen.value = to;
};
const close = leave("share", null);

/** What somebody is sent: a link, as a QR code, or by what the system has for it. What plays stands still meanwhile. */
export function ShareDialog({ still }: { still: (() => Promise<Still>) | undefined }) {
  const [start, setStart] = useState<(typeof STARTS)[number]["value"]>("here");
  const [moves, setMoves] = useState<Moves>(openedTool().tool?.timeline ? "once" : "still");
  const [ground, setGround] = useState<Grounds>("page");
  const [told, setTold] = useState<Told | null>(null);
  const [seen, setSeen] = useState("");
  // Once it stands, the address is read again.
  const [, setStood] = useState(false);
  const address = addressWith(start, moves, ground === "here" ? (dark.value ? "dark" : "light") : null);
  useEffect(() => {
    // What is sent is what is seen. The address bar holds all of the document, for whoever comes back to it here.
    if (moving()) openedTool().tool?.timeline?.toggle();
    link.flush();
    setStood(true);
  }, []);
  useEffect(() => {
    void seenWords(ground === "here").then(setSeen);
  }, [ground]);
  if (address === null) {
    return (
      <Dialog title={messages.share} onClose={close}>
        <p>{messages.noLink}</p>
      </Dialog>
    );
  }
  if (exportOpen.value === "publish" && still)
    return <Publish address={address} moves={moves} still={still} onClose={leave("publish", "share")} />;
  return (
    <Dialog title={messages.share} about={seen} onClose={close}>
      <div class={css["share"]}>
        <div class={css["share-link"]}>
          <input
            class={css["address"]}
            aria-label={messages.link}
            readOnly
            value={address}
            onFocus={(event) => event.currentTarget.select()}
          />
          <Button kind="primary" icon="copy" onClick={() => void copy(messages.link, address).then(setTold)}>
            {messages.copy}
          </Button>
        </div>
        <p class={`hint ${css["share-told"]}`} role="status">
          {told && !isForPages(told.of) && told.words}
        </p>
        {openedTool().tool?.timeline && (
          <>
            <ChoiceRow
              label={messages.startAt}
              options={STARTS}
              value={start}
              onChange={(next) => {
                setStart(next);
                setTold(CHANGED);
              }}
            />
            <ChoiceRow
              label={messages.whenOpened}
              options={MOVES}
              value={moves}
              onChange={(next) => {
                setMoves(next);
                setTold(CHANGED);
              }}
            />
          </>
        )}
        <ChoiceRow
          label={messages.theme}
          options={GROUNDS(dark.value)}
          value={ground}
          onChange={(next) => {
            setGround(next);
            setTold(CHANGED);
          }}
        />
        <QrCode address={address} />
        {"share" in navigator && (
          <div class={css["share-more"]}>
            <Button onClick={() => void send(address)}>{messages.send}</Button>
          </div>
        )}
        <p class="hint">{messages.forYourOwnWeb}</p>
        <div class={css["share-more"]}>
          <Button
            icon="copy"
            description={messages.iframeForPageBlog}
            onClick={() => void copy(messages.embedCode, frameOf(address)).then(setTold)}
          >
            {messages.copyEmbedCode}
          </Button>
          <Button
            icon="copy"
            description={messages.twoLinesHtmlScript}
            onClick={() => void copy(messages.element, elementOf(address, moves)).then(setTold)}
          >
            {messages.copyElement}
          </Button>
          {still && (
            <Button
              description={messages.readyMadeWebPage}
              onClick={() => {
                exportOpen.value = "publish";
              }}
            >
              {messages.publish}
            </Button>
          )}
          <a class="button" href="./elsewhere.html" target="_blank" rel="noopener">
            {messages.moreOptions}
          </a>
        </div>
        <p class={`hint ${css["share-told"]}`} role="status">
          {told && isForPages(told.of) && told.words}
        </p>
      </div>
    </Dialog>
  );
}

type Copied = "Link" | "Embed code" | "Element";

/** What came of copying, in words: they stand by the buttons of what was copied. */
interface Told {
  of: Copied;
  words: string;
}

const isForPages = (of: Copied) => of !== "Link";

const CHANGED: Told = { of: "Link", words: messages.linkHasChangedCopy };

/** What is the same for all who open the link: the background belongs to a picture of space, and else to the page. */
async function seenWords(same: boolean): Promise<string> {
  if (pictureShown.peek() !== null && ownPicture.peek()) {
    return messages.linkContainsDeformationBut;
  }
  if (same) return messages.anyoneWithLinkSees;
  if (scene.peek().tool !== "space") return messages.anyoneWithLinkSeesThis;
  const { space } = await import("#document/space/space");
  const background = space.peek()?.background;
  return background === undefined || background === "page"
    ? messages.anyoneWithLinkSeesSame
    : messages.anyoneWithLinkSees;
}

function addressWith(start: "here" | "first", moves: Moves, theme: "light" | "dark" | null): string | null {
  const { deform, space } = scene.peek();
  const first = {
    t: 0,
    ...(deform ? { deform: { ...deform, phase: 0 } } : {}),
    ...(space ? { space: { ...space, at: 0 } } : {}),
  };
  const fragment = fragmentOf({ ...scene.peek(), ...(start === "first" ? first : {}) });
  if (fragment === null) return null;
  const query = theme ? `${QUERY[moves]}&theme=${theme}` : QUERY[moves];
  return `${location.origin}${location.pathname}${query}#${fragment}`;
}

/** What is seen of a document as a fragment; null where no link can hold it. */
function fragmentOf(now: Scene): string | null {
  try {
    return withCheck(frond.encodeScene(seenOf(now, frond.defaultScene())));
  } catch {
    return null;
  }
}

/** The document in a frame of another page: what stands in the address goes on in `embed.html`. */
export function frameOf(address: string): string {
  const url = new URL(address);
  url.pathname = url.pathname.replace(/[^/]*$/, "embed.html");
  return `<iframe src="${escaped(url.href)}" title="A fractal in Frond" width="640" height="400" style="border:0;max-width:100%" loading="lazy"></iframe>`;
}

/** The same as an element as large, with the script that defines it. */
export function elementOf(address: string, moves: Moves): string {
  const script = new URL("./frond-view.js", address).href;
  const theme = themeOf(address);
  return `<script src="${escaped(script)}"></script>\n<frond-view src="${escaped(address)}"${theme ? ` theme="${theme}"` : ""} style="max-width:640px;aspect-ratio:640/400" controls${AUTOPLAY[moves]}></frond-view>`;
}

async function copy(of: Copied, text: string): Promise<Told> {
  try {
    await navigator.clipboard.writeText(text);
    return { of, words: messages.wasCopied(of) };
  } catch {
    const instead = isForPages(of) ? messages.allowClipboard : messages.copyYourself;
    return { of, words: messages.copyingBlocked(instead) };
  }
}

async function send(url: string): Promise<void> {
  try {
    await navigator.share({ title: messages.frond, url });
  } catch (problem) {
    // Who changes their mind needs no word of it.
    if (!(problem instanceof DOMException && problem.name === "AbortError")) {
      notify({ kind: "error", text: messages.sharingFailed(wordsOf(problem)) });
    }
  }
}
