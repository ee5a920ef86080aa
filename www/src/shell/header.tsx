import type { ComponentChildren } from "preact";
import { route } from "#document/link";
import { selection } from "#document/morph";
import { setTheme, type Theme, theme } from "#document/preferences";
import { openTool, tool } from "#document/tool";
import { filmProgress, filmTold, openFilm, openMesh, openPicture, openRecent, openShare } from "#film/open";
import { commandCalled, help, withKey } from "#ui/commands";
import { Icon } from "#ui/controls/Icon";
import { askForFile } from "#ui/files/door";
import { startExport } from "#ui/files/exporting";
import { lazily } from "#ui/lazy";
import { Menu, type MenuItem } from "#ui/overlay/Menu";
import type { Tool as ToolName } from "#wasm/api";
import { CURVE_FILES, insteadOnStage, printStage, saveCurve, savePicture, studioHref } from "./actions";
import { Glyph, type GlyphName } from "./glyphs";
import * as messages from "./messages";
import css from "./shell.module.css";
import { openedTool, TOOLS } from "./tools";

const FilmChip = lazily(() => import("#film/FilmChip").then((module) => module.FilmChip));

const NEXT_THEME: Record<Theme, Theme> = { auto: "light", light: "dark", dark: "auto" };
const THEME_WORDS: Record<Theme, string> = {
  auto: messages.themeSystem,
  light: messages.themeLight,
  dark: messages.themeDark,
};

/** The bar on top: where one is, and what can be done with the document as a whole. */
export function Header() {
  const at = route.value.page;
  const studio = at === "studio";
  return (
    <header class="header">
      {/* No link: fragments of the address are documents here. */}
      <button type="button" class={css["skip"]} onClick={skip}>
        {messages.skipTo(studio ? "picture" : "text")}
      </button>
      <a class="wordmark" href={studioHref()} onClick={stay}>
        <Mark />
        Frond
      </a>
      <nav class={css["places"]} aria-label={messages.places}>
        <Place href="#learn" here={at === "learn"}>
          {messages.learn}
        </Place>
        {TOOLS.map(({ id, label }) => (
          <ToolPlace key={id} name={id}>
            {label}
          </ToolPlace>
        ))}
        <Place href="#figures" here={at === "figures"}>
          {messages.figures}
        </Place>
      </nav>
      <PlaceChoice />
      {filmTold.value && <FilmChip />}
      <div class="tools">
        {studio && <StudioTools />}
        <Tool
          glyph={theme.value}
          label={messages.changeTheme(THEME_WORDS[theme.value])}
          class="wide"
          onClick={() => setTheme(NEXT_THEME[theme.peek()])}
        />
        {studio && (
          <button type="button" class="button quiet share" onClick={openShare} aria-label={messages.share}>
            <Glyph name="link" />
            <span>{messages.share}</span>
          </button>
        )}
        <div class={css["narrow-only"]}>
          <Menu label={messages.more} items={moreItems(studio)} />
        </div>
      </div>
    </header>
  );
}

/** What a narrow header has no room for. */
function moreItems(studio: boolean): MenuItem[] {
  const themes = (["auto", "light", "dark"] as const).map((choice) => ({
    label: THEME_WORDS[choice],
    ...(theme.value === choice ? { icon: "check" as const } : {}),
    onSelect: () => setTheme(choice),
  }));
  if (!studio) return themes;
  return [OPEN, RECENT, ...saveItems(), HELP, ...themes];
}

const OPEN: MenuItem = { label: messages.openFileItem, icon: "open", onSelect: () => askForFile() };

const openHelp = () => {
  help.value = true;
};

const HELP: MenuItem = { label: messages.helpItem, onSelect: openHelp };

const RECENT: MenuItem = { label: messages.recentItem, onSelect: openRecent };

/** The files that what is open can be saved as. */
function saveItems(): MenuItem[] {
  const items =
    insteadOnStage.value === "curves" ? curveItems() : [{ label: messages.saveAsPng, onSelect: savePicture }];
  items.push({ label: messages.print, onSelect: printStage });
  const { entry, tool } = openedTool();
  if (entry.stage === undefined || tool?.still) {
    items.push({ label: messages.pictureAnySize, onSelect: openPicture });
  }
  if (tool?.maps && !insteadOnStage.value) items.push({ label: messages.mapsAsText, onSelect: startExport });
  if (tool?.MeshDialog) items.push({ label: messages.meshFor3D, onSelect: openMesh });
  if (!tool?.films) return items;
  const done = filmProgress.value;
  const film = done === null ? messages.filmItem : messages.filmMade(Math.floor(100 * done));
  return [...items, { label: film, icon: "play", onSelect: openFilm }];
}

function curveItems(): MenuItem[] {
  return CURVE_FILES.map((kind) => ({
    label: messages.saveAs(kind.toUpperCase()),
    onSelect: () => saveCurve(kind),
  }));
}

/** Takes back or takes again whatever the key does: in some tools what is no part of the document comes first. */
function Back({ glyph, label }: { glyph: "undo" | "redo"; label: string }) {
  const command = commandCalled(glyph);
  return (
    <Tool
      glyph={glyph}
      label={label}
      command={glyph}
      disabled={command?.enabled?.() !== true}
      onClick={() => command?.run?.(0)}
    />
  );
}

function StudioTools() {
  return (
    <>
      <Back glyph="undo" label={messages.undo} />
      <Back glyph="redo" label={messages.redo} />
      <Tool glyph="open" label={messages.openFile} command="open" class="wide" onClick={() => askForFile()} />
      <Tool glyph="recent" label={messages.recent} class="wide" onClick={openRecent} />
      <div class="wide">
        <Menu label={messages.save} icon="save" items={saveItems()} />
      </div>
      <Tool glyph="help" command="help" label={messages.help} class="wide" onClick={openHelp} />
    </>
  );
}

/** Past the header. */
function skip(): void {
  const places = document.querySelectorAll<HTMLElement>("main :is([role='application'], h1[tabindex])");
  // Of two stages one is away.
  [...places].find((place) => place.getClientRects().length > 0)?.focus();
}

/** Whoever is in the studio already stays in it: the address in the link may be older than the document. */
function stay(event: MouseEvent): void {
  if (route.peek().page === "studio" && event.button === 0 && !event.ctrlKey && !event.metaKey) {
    event.preventDefault();
  }
}

function Place({ href, here, children }: { href: string; here: boolean; children: ComponentChildren }) {
  return (
    <a href={href} aria-current={here ? "page" : undefined} onClick={here ? stay : undefined}>
      {children}
    </a>
  );
}

/** The places as one choice, where there is no room to name them all. */
function PlaceChoice() {
  const at = route.value.page;
  const here = at === "studio" ? tool.value : at;
  return (
    <div class={css["place-choice"]}>
      <select
        aria-label={messages.toolOrPage}
        value={here}
        onChange={(event) => {
          const to = event.currentTarget.value as ToolName | "figures" | "learn";
          if (to === "figures" || to === "learn") location.hash = to;
          else {
            if (at !== "studio") location.hash = studioHref(to);
            enter(to);
          }
        }}
      >
        <option value="learn">{messages.learn}</option>
        {TOOLS.map(({ id, label }) => (
          <option key={id} value={id}>
            {label}
          </option>
        ))}
        <option value="figures">{messages.figures}</option>
      </select>
      <Icon name="down" size={16} />
    </div>
  );
}

function enter(to: ToolName): void {
  selection.value = null;
  openTool(to);
}

/** A tool of the studio: another one of the same document. */
function ToolPlace({ name, children }: { name: ToolName; children: ComponentChildren }) {
  const studio = route.value.page === "studio";
  const here = studio && tool.value === name;
  return (
    <a
      href={studioHref(name)}
      aria-current={here ? "page" : undefined}
      onClick={(event) => {
        if (event.button !== 0 || event.ctrlKey || event.metaKey) return;
        if (studio) event.preventDefault();
        enter(name);
      }}
    >
      {children}
    </a>
  );
}

interface ToolProps {
  glyph: GlyphName;
  label: string;
  /** Whose key its tip names. */
  command?: string;
  class?: string;
  disabled?: boolean;
  onClick: () => void;
}

function Tool({ glyph, label, command, class: extra, disabled = false, onClick }: ToolProps) {
  return (
    <button
      type="button"
      class={`button quiet icon-button ${extra ?? ""}`}
      aria-label={label}
      title={withKey(label, command)}
      disabled={disabled}
      onClick={onClick}
    >
      <Glyph name={glyph} />
    </button>
  );
}

/** Three leaflets, each half the size of the whole: a frond. */
function Mark() {
  return (
    <svg class="mark" width="1.375rem" height="1.375rem" viewBox="0 0 24 24" aria-hidden="true">
      <path d="M12 22V9" stroke="currentColor" stroke-width="1.75" stroke-linecap="round" fill="none" />
      <path class="leaf-1" d="M12 10.5c-2.6-2.2-2.6-5.8 0-8.5 2.6 2.7 2.6 6.3 0 8.5z" />
      <path class="leaf-2" d="M11.6 17.5C7.6 17.9 5 15.500 4.400 11.500c4-.4 6.6 2 7.2 6z" />
      <path class="leaf-3" d="M12.400 17.500c4 .4 6.600-2 7.200-6-4-.4-6.600 2-7.200 6z" />
    </svg>
  );
}
