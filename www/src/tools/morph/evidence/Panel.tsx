import { useEffect, useState } from "preact/hooks";
import { type Proof as Proved, proof, told } from "#compute/proof";
import { prove } from "#compute/prove";
import { verdict } from "#compute/results";
import { boxOf } from "#document/framing";
import { shown, shownColours } from "#document/morph";
import { notify, wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import { percent } from "#format/path-words";
import { shareOf, shareWords, verdictWords } from "#format/verdict";
import { hulls } from "#stage/evidence/marks";
import { EvidencePanel } from "#stage/evidence/Panel";
import { evidenceKept } from "#stage/evidence/shown";
import { stageStyle } from "#stage/picture-style";
import { Button } from "#ui/controls/Button";
import { Switch } from "#ui/controls/Switch";
import { download, plainName } from "#ui/files/download";
import { Graph } from "#ui/shapes/Graph";
import type { Certificate, ConnectedCertificate, Connectedness, MapRow, Reason } from "#wasm/api";
import { frond } from "#wasm/core";
import { CHIP_ID, PANEL_ID } from "../dialogs";
import type { Exact as ExactPart } from "./Exact";
import css from "./evidence.module.css";
import { accountOf, addressWords, checkWords, clusterWords, gapWords, linkWords } from "./evidence-text";
import * as messages from "./messages";

/** What is known of the picture on the stage, and why. */
export function MorphEvidence() {
  // While something moves, the last answer stands.
  const answer = verdict.value;
  return (
    <EvidencePanel
      id={PANEL_ID}
      chip={CHIP_ID}
      title={verdictWords(told.value, answer?.epsilon).text}
      stale={answer?.stale ?? false}
    >
      {answer && <Account answer={answer.connectedness} epsilon={answer.epsilon} />}
    </EvidencePanel>
  );
}

function Account({ answer, epsilon }: { answer: Connectedness; epsilon: number }) {
  const gap = gapWords(answer);
  return (
    <>
      <p>{accountOf(answer, epsilon)}</p>
      {answer.reason && <Because reason={answer.reason} />}
      <Exact reason={answer.reason} />
      {gap !== null && (
        <p>
          <span class={css["evidence-name"]}>{messages.widestGap}</span> {gap}.
        </p>
      )}
      {answer.components.length > 0 && <Groups answer={answer} />}
      {answer.verdict === "disconnected" && <Why kind="apart" />}
      <InWords answer={answer} />
      {isWritten(answer) && <Proof connected={answer.verdict === "connected"} />}
      <Switch
        checked={evidenceKept.value}
        onChange={(on) => {
          evidenceKept.value = on;
        }}
      >
        {messages.keepMarksOnPicture}
      </Switch>
      <Button kind="quiet" icon="save" onClick={() => void saveDrawing(answer, epsilon)}>
        {messages.saveDrawingSvg}
      </Button>
    </>
  );
}

async function saveDrawing(answer: Connectedness, epsilon: number): Promise<void> {
  const maps = shown.peek();
  const { a, b, t } = scene.peek();
  const name = t === 0 ? a.name : t === 1 ? b.name : messages.fromToAt(a.name, b.name, percent(t));
  try {
    const { evidenceDrawing } = await import("./drawing");
    const gap = answer.closest && answer.verdict === "disconnected" ? answer.closest : null;
    const text = evidenceDrawing({
      title: `${name}: ${verdictWords(told.peek(), epsilon).text}`,
      words: [accountOf(answer, epsilon), answer.reason?.text ?? ""].join(" ").trim(),
      maps,
      hull: frond.bounds({ maps }).hull,
      colours: shownColours("light"),
      links: answer.reason?.links ?? [],
      sides: hulls.peek(),
      gap: gap && { ...gap, words: shareWords(shareOf(answer)) },
    });
    download(
      new Blob([text], { type: "image/svg+xml" }),
      `frond-${plainName(name, "shape", 48)}-evidence.svg`,
    );
  } catch (problem) {
    notify({ kind: "error", text: messages.drawingFailed(wordsOf(problem)) });
  }
}

/** What the shape looks like, for those who do not see it. */
function InWords({ answer }: { answer: Connectedness }) {
  const [words, setWords] = useState("");
  // biome-ignore lint/correctness/useExhaustiveDependencies: another answer is about another picture
  useEffect(() => {
    let current = true;
    void import("./describe")
      .then(({ describeStage }) => describeStage())
      .then((said) => current && setWords(said))
      .catch(() => {});
    return () => {
      current = false;
    };
  }, [answer]);
  return (
    <details>
      <summary>{messages.descriptionPicture}</summary>
      <p>{words}</p>
    </details>
  );
}

/** Kinds of reasons that are written down as certificates. */
const WRITTEN: readonly string[] = [
  ...["shared-points", "neighbours", "crossings", "line", "area", "differences"],
  ...["one-map", "equal-maps", "common-point"],
];

/** Whether there may be a proof that a checker can replay. */
function isWritten({ verdict, reason }: Connectedness): boolean {
  return (
    verdict === "disconnected" || (verdict === "connected" && (!reason || WRITTEN.includes(reason.kind)))
  );
}

/** What there is to say about exact numbers; fetched when the panel is first opened. */
function Exact({ reason }: { reason: Reason | undefined }) {
  const [Part, setPart] = useState<typeof ExactPart | null>(null);
  useEffect(() => {
    void import("./Exact").then(
      (part) => setPart(() => part.Exact),
      () => {},
    );
  }, []);
  return Part && <Part reason={reason} />;
}

const MOST_LINKS = 12;

/** What holds it together, and on which readings of numbers that hangs, if on any. */
function Because({ reason }: { reason: Reason }) {
  const { kind, text, assuming, links } = reason;
  const example = links.find(({ kind }) => kind === "point")?.words[0];
  return (
    <div class={css["evidence-reason"]} data-testid="evidence-reason">
      <p>{text}</p>
      {assuming.length > 0 && (
        <details>
          <summary>{messages.howNumbersInterpreted}</summary>
          <p>{messages.notExact(assuming.join("; "))}</p>
        </details>
      )}
      {links.length > 0 && (
        <details>
          <summary>{messages.wherePiecesTouch}</summary>
          <ul>
            {links.slice(0, MOST_LINKS).map((link) => (
              <li key={`${link.kind} ${link.pair.join()} ${link.words.join()}`}>{linkWords(link)}</li>
            ))}
            {links.length > MOST_LINKS && <li>{messages.moreLinks(links.length - MOST_LINKS)}</li>}
          </ul>
          {example !== undefined && <p>{addressWords(example)}</p>}
        </details>
      )}
      <Why kind={kind} />
    </div>
  );
}

/** The theorem that it rests on, by the name of its section. */
function Why({ kind }: { kind: Reason["kind"] | "apart" }) {
  return (
    <p>
      <a href={`./theorems.html#${kind}`} target="_blank" rel="noopener">
        {messages.whyProof}
      </a>
    </p>
  );
}

/** Which pieces meet, as a drawing and in words. */
function Groups({ answer }: { answer: Connectedness }) {
  const maps = shown.value;
  const count = answer.components.length;
  return (
    <figure class={css["evidence-groups"]}>
      <Graph
        count={count}
        angles={maps.length === count ? anglesOf(maps) : answer.components.map((_, i) => i)}
        edges={answer.overlaps}
        colours={stageStyle.value.palette}
        label={messages.piecesMeeting(
          answer.overlaps.map(([i, j]) => messages.pairWith(i + 1, j + 1)).join(", ") || messages.none,
        )}
      />
      <figcaption>
        <span class={css["evidence-name"]}>{messages.piecesConnected}</span>
        <span class="number">{clusterWords(answer.components)}</span>
      </figcaption>
    </figure>
  );
}

/** In which direction from the middle of the whole each piece lies. */
function anglesOf(maps: readonly MapRow[]): number[] {
  const box = boxOf([...maps]);
  const x = box ? (box.x0 + box.x1) / 2 : 0;
  const y = box ? (box.y0 + box.y1) / 2 : 0;
  return maps.map(([a, b, c, d, e, f]) => Math.atan2(c * x + d * y + f - y, a * x + b * y + e - x));
}

/** The proof that it is in one piece, or in several: made, checked, and given away when asked for. */
export function Proof({ connected }: { connected: boolean }) {
  const now = proof.value;
  return (
    <div class={css["evidence-proof"]}>
      {now?.state === "there" ? (
        <Button onClick={() => saveProof(now.certificate)}>{messages.downloadProof}</Button>
      ) : (
        <Button disabled={now?.state === "asked"} onClick={prove}>
          {messages.checkProof}
        </Button>
      )}
      <p role="status">{proofWords(now, connected)}</p>
      {now?.state === "there" && (
        <p>
          {messages.checkElsewhere} <code>{messages.checkCommand(FILE)}</code>
        </p>
      )}
    </div>
  );
}

function proofWords(now: Proved | null, connected: boolean): string {
  switch (now?.state) {
    case "asked":
      return messages.writingAndCheckingProof;
    case "there":
      return `${checkWords(now.check)} ${now.numbers ? messages.aboutExact : ""}`.trim();
    case "none":
      return messages.noProof(now.why);
    default:
      return connected ? messages.checksEveryContactBetween : messages.checksAllPiecesOn;
  }
}

const FILE = "frond-proof.json";

function saveProof(certificate: Certificate | ConnectedCertificate): void {
  try {
    const blob = new Blob([`${JSON.stringify(certificate)}\n`], { type: "application/json" });
    download(blob, FILE);
  } catch (problem) {
    notify({ kind: "error", text: messages.proofFailed(wordsOf(problem)) });
  }
}
