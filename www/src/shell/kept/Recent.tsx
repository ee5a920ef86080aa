import { useEffect, useMemo, useState } from "preact/hooks";
import { thumbnails } from "#compute/results";
import { thumbnailsOf } from "#compute/thumbnails";
import { DirectedThumb } from "#directed/Thumb";
import { reasonOf } from "#document/kept/database";
import { LONGEST_NAME } from "#document/kept/rows";
import { announce } from "#document/notice";
import { exportOpen } from "#film/open";
import { whenWords } from "#format/when";
import { Button, IconButton } from "#ui/controls/Button";
import { KeptRow, KeptRows } from "#ui/kept/KeptRow";
import { Dialog } from "#ui/overlay/Dialog";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import type { Scene } from "#wasm/api";
import { frond } from "#wasm/core";
import { TOOLS } from "../tools";
import { trouble } from "./keeping";
import * as messages from "./messages";
import css from "./recent.module.css";
import { goOn, keeping, store } from "./start";
import { MOST, type Row } from "./store";

const ABOUT = messages.aboutRecent(MOST) + messages.photosAndOutlinesNot;

/** What is kept in this browser. */
export function Recent() {
  const [rows, setRows] = useState<Row[] | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const [sure, setSure] = useState(false);
  const told = problem ?? trouble.value;

  /** Does something, and shows what is there then. */
  const after = async (work: Promise<unknown>, words = "") => {
    try {
      await work;
      setRows(await store.list());
      setProblem(null);
      if (words) announce(words);
    } catch (reason) {
      setRows((before) => before ?? []);
      setProblem(reasonOf(reason));
    }
  };
  // biome-ignore lint/correctness/useExhaustiveDependencies: once, when it is opened.
  useEffect(() => void after(keeping.flush()), []);
  const scenes = useMemo(() => new Map((rows ?? []).map((row) => [row.id, sceneOf(row)])), [rows]);
  useEffect(() => {
    const shapes = [...scenes].flatMap(([id, scene]) =>
      scene && pictured(scene)
        ? [
            { id: `kept-a-${id}`, maps: scene.a.maps },
            { id: `kept-b-${id}`, maps: scene.b.maps },
          ]
        : [],
    );
    return thumbnailsOf(shapes);
  }, [scenes]);
  const close = () => {
    exportOpen.value = null;
  };

  return (
    <Dialog wide title={messages.recent} about={ABOUT} onClose={close}>
      {told && (
        <p class={css["recent-problem"]} role="status">
          {told}
        </p>
      )}
      {rows?.length === 0 && !told && <p class="hint">{messages.nothingYetFrondSaves}</p>}
      <KeptRows>
        {rows?.map((row) => (
          <Entry
            key={row.id}
            row={row}
            scene={scenes.get(row.id) ?? null}
            onOpen={() => {
              close();
              goOn(row);
            }}
            onRename={(name) => after(store.rename(row.id, name))}
            onPin={() => after(store.pin(row.id, !row.pinned))}
            onRemove={() => after(store.remove(row.id), messages.wasRemoved(row.name))}
          />
        ))}
      </KeptRows>
      {rows && rows.length > 0 && (
        <div class={css["recent-foot"]}>
          {sure ? (
            <>
              <p class="hint">{messages.openDocumentStaysRemove}</p>
              <Button
                kind="danger"
                onClick={() => {
                  setSure(false);
                  void after(store.clear(), messages.listEmpty);
                }}
              >
                {messages.removeAll(rows.length)}
              </Button>
              <Button onClick={() => setSure(false)}>{messages.keepThem}</Button>
            </>
          ) : (
            <Button icon="bin" onClick={() => setSure(true)}>
              {messages.clearAll}
            </Button>
          )}
        </div>
      )}
    </Dialog>
  );
}

interface EntryProps {
  row: Row;
  /** None: the reader of links does not take it. */
  scene: Scene | null;
  onOpen: () => void;
  onRename: (name: string) => void;
  onPin: () => void;
  onRemove: () => void;
}

function Entry({ row, scene, onOpen, onRename, onPin, onRemove }: EntryProps) {
  const [naming, setNaming] = useState(false);
  const name = row.name || messages.untitled;
  const tool = TOOLS.find(({ id }) => id === (scene?.tool ?? "morph"))?.label;
  return (
    <KeptRow
      name={row.name}
      picture={
        scene?.directed && inPlane(scene) ? (
          <>
            <DirectedThumb states={scene.directed.a.states} />
            <DirectedThumb states={scene.directed.b.states} />
          </>
        ) : scene && pictured(scene) ? (
          <>
            <Thumbnail bitmap={thumbnails.value.get(`kept-a-${row.id}`)} />
            <Thumbnail bitmap={thumbnails.value.get(`kept-b-${row.id}`)} />
          </>
        ) : (
          <span class={css["recent-plain"]}>{scene === null ? "?" : tool}</span>
        )
      }
      about={
        <>
          {scene === null ? messages.thisVersionFrondCannot : tool} · {whenWords(row.time)}
          {row.pinned && messages.pinnedAside}
        </>
      }
      onOpen={scene === null ? undefined : onOpen}
      naming={naming}
      longest={LONGEST_NAME}
      onName={onRename}
      onNamed={() => setNaming(false)}
    >
      <IconButton icon="edit" kind="quiet" label={messages.rename(name)} onClick={() => setNaming(true)} />
      <Button kind="quiet" pressed={row.pinned} onClick={onPin} description={messages.keepPermanently(name)}>
        {row.pinned ? messages.unpin : messages.pin}
        <span class="unseen"> {name}</span>
      </Button>
      <IconButton icon="bin" kind="quiet" label={messages.remove(name)} onClick={onRemove} />
    </KeptRow>
  );
}

/** What was kept, by the reader of links. */
function sceneOf({ fragment }: Row): Scene | null {
  try {
    const { scene, problem } = frond.decodeScene(fragment);
    return problem ? null : scene;
  } catch {
    return null;
  }
}

/** Whether it is about two shapes of the plane. */
const inPlane = ({ tool }: Scene): boolean => tool !== "space" && tool !== "fit";

/** Whether these are systems. */
const pictured = (scene: Scene): boolean => inPlane(scene) && !scene.curves && !scene.directed;
