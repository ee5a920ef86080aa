/** What a tool has to bring. */
import type { ComponentType } from "preact";
import type { Keep } from "#document/history";
import { FILM } from "#film/open";
import type { Films, Still } from "#film/subject";
import type { Command } from "#ui/commands";
import type { NamedMaps } from "#ui/files/exporting";
import { type Timeline, timeCommands } from "#ui/strip/timeline";
import type { Tool as ToolName } from "#wasm/api";
import type { PainterBackend } from "./surface/painter";

/** A tool of the studio: what it shows and what can be done in it, as one value. */
export interface Tool {
  /** In place of the picture that tools share. */
  Stage?: ComponentType<{ backend: "auto" | PainterBackend }>;
  /** Laid over the shared picture. */
  Overlay?: ComponentType;
  /** What is said of the shared picture, below it. */
  Verdict?: ComponentType;
  /** Why, beside it. */
  Evidence?: ComponentType;
  Panel: ComponentType;
  /** Below the picture: time, or what takes its place. */
  Strip: ComponentType;
  /** What moves in it: the keys of time follow. */
  timeline?: Timeline;
  /** All other keys. */
  commands: () => readonly Command[];
  /** Its maps, to be written for other programs. */
  maps?: () => readonly NamedMaps[];
  /** Takes a file of the kind that it reads itself. */
  open?: (file: File) => void | Promise<void>;
  /** Saves what a stage of its own shows. */
  savePng?: () => void | Promise<void>;
  /** What a stage of its own shows, to be drawn at any size. */
  still?: () => Promise<Still>;
  /** The dialog in which its bodies are saved for other programs. */
  MeshDialog?: ComponentType;
  /** What moves in it, to be filmed. */
  films?: () => Promise<Films>;
}

/** All that keys do in a tool: in time, and else. */
export const commandsOf = ({
  timeline,
  commands,
  films,
}: Pick<Tool, "timeline" | "commands" | "films">): readonly Command[] => [
  ...(timeline ? timeCommands(timeline) : []),
  ...commands(),
  ...(films ? [FILM] : []),
];

/** A tool as the page knows it before it is opened. */
export interface ToolEntry {
  id: ToolName;
  /** In the bar on top. */
  label: string;
  /** Of the page. */
  title: string;
  /** What its panel is about. */
  side: string;
  /** What its stage is about, where it has one of its own. */
  stage?: string;
  /** Part of the first script, or else fetched when it is first opened. */
  tool: Tool | (() => Promise<Tool>);
  /** Said where it could not be fetched. */
  missing?: string;
  /** What undo leaves to whoever looks, of its part of the document. */
  keepOnUndo?: Keep;
  /** Fetches what may be asked for later, so that it is there without a network, too. */
  fetchAhead?: () => Promise<unknown>;
}
