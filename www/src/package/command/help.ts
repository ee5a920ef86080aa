/** What each command is for and which options it knows: the command reads it, and --help prints it. */

import { WHITE } from "#style/colours";

/** The name of an option, what stands after it, if anything does, and what it does. */
export type Option = readonly [name: string, value: string | null, words: string];

export interface Words {
  /** What stands after the command. */
  takes: string;
  /** In a few words. */
  short: string;
  options: readonly Option[];
  /** More that one has to know, in sentences. */
  more: string;
  examples: readonly string[];
}

const QUIET: Option = ["quiet", null, "say nothing but what goes wrong"];
const out = (words: string): Option => ["out", "FILE", words];
const T: Option = ["t", "0.5", "the moment, 0 to 1; without it that of the link"];
const EPSILON: Option = [
  "epsilon",
  "0.0017",
  "gaps below this part of the diameter count as none; without it 1/600",
];
const SUBJECT = "LINK|FILE|-";

export const RENDER: Words = {
  takes: SUBJECT,
  short: "a picture or a film of what a link or a file shows",
  options: [
    out("x.png, .svg, .gif, .apng, .zip, .mp4, .webm or .mov; - is the standard output"),
    ["as", "png", "the kind of file, where the name does not say it"],
    ["width", "1200", "in pixels"],
    ["height", "900", "in pixels"],
    ["background", WHITE, "what is behind the shape; without it a picture is clear, a video white"],
    ["t", "0.5", "the moment of a picture, 0 to 1; without it that of the link"],
    ["seconds", "8", "how long a film is; without it as long as in the studio"],
    ["fps", "25", "frames a second"],
    ["frames", "200|1-100", "so many frames, or those from the first to the last; with .png a file each"],
    ["resume", null, "leave alone the frames that are there already, whole, and show the same"],
    ["ease", "in-out", "start and stop gently"],
    ["hold", "1", "stand still for so many seconds more at each end"],
    ["jobs", "4", "draw with so many workers; without it with as many as there are cores"],
    QUIET,
  ],
  more:
    "Every picture holds the link of its own moment: the studio opens it as that. Frames are named " +
    "x-0001.png, x-0002.png .. Frames are drawn by as many workers as there are cores. The same command " +
    "writes the same bytes on every machine; videos do so with the same ffmpeg, which has to be installed " +
    "for them. Ctrl-C leaves no file that is not whole.",
  examples: [
    'frond render "a=fern&b=tree" --out x.png --t 0.4',
    'frond render "a=fern&b=tree" --out x.png --frames 1-100 --seconds 8 --resume',
    "frond render shape.ifs --out - --as png > shape.png",
  ],
};

export const LOCUS: Words = {
  takes: "LINK|-",
  short: "verdict and gap of every sample of the (u, v) plane",
  options: [
    out("x.csv or x.npy; - is the standard output"),
    ["as", "csv", "csv or npy, where the name does not say it"],
    ["width", "301", "samples across, both ends included"],
    ["height", "301", "samples up"],
    ["bounds", "-1,2,-1,2", "u0,u1,v0,v1: the part of the plane"],
    ["w", "0", "the slice: how far the stretch is ahead of the turn"],
    EPSILON,
    QUIET,
  ],
  more: "Each row is u, v, the verdict and the gap (CSV), or they are an array of NumPy's (.npy).",
  examples: ['frond locus "a=dragon-3&b=gasket" --bounds 0,1,0,1 --width 101 --height 101 --out x.csv'],
};

export const CONNECTEDNESS: Words = {
  takes: SUBJECT,
  short: "whether a shape is in one piece, as JSON",
  options: [T, EPSILON, QUIET],
  more: "The exit code is 0 where it is in one piece or seems to be, and 1 where it is not.",
  examples: ["frond connectedness shape.ifs"],
};

export const ANALYZE: Words = {
  takes: SUBJECT,
  short: "open set condition, dimension and boundary of a shape, exactly",
  options: [
    [
      "numbers",
      "1/3,sqrt(3)/6",
      "what entries of the maps stand for: one that is the double nearest to such a number is that number",
    ],
    ["json", null, "as JSON"],
    ["budget", "20000", "look at so many pairs of pieces at most"],
    T,
    QUIET,
  ],
  more:
    "Entries that stand for no number are what their digits say. A link says itself what the numbers of its " +
    "shapes stand for, and so does the gallery; a file does not. The exit code is 1 where nothing was decided.",
  examples: ['frond analyze "a=koch&b=koch&t=0"', "frond analyze dust.json --numbers 1/3,2/3 --json"],
};

export const DISTANCE: Words = {
  takes: "LINK|-",
  short: "how far A and B are from each other (Hausdorff distance), as JSON",
  options: [
    ["tolerance", "0.0001", "how near the bounds shall be, in parts of the size of both; without it 0.0001"],
    QUIET,
  ],
  more:
    "The distance is between lower and upper. Of the two points one lies in A and one in B; one of them is " +
    "at least lower from all of the other shape.",
  examples: ['frond distance "a=fern&b=tree"'],
};

export const CERTIFICATE: Words = {
  takes: SUBJECT,
  short: "a proof of what connectedness says, as JSON that check replays",
  options: [
    [
      "of",
      "one|several|path",
      "that it is in one piece, or in several; without it whichever holds. Or that a path holds",
    ],
    out("x.json; without it the standard output"),
    T,
    EPSILON,
    QUIET,
  ],
  more:
    "A proof of a path says how wide a gap is at most, anywhere on the way of a link; where the link " +
    "leaves the path to Frond, it is planned first. The exit code is 1 where no proof was found.",
  examples: [
    "frond certificate dust.json --of several --out proof.json",
    'frond certificate "a=dragon-3&b=gasket" --of path | frond check -',
  ],
};

export const CHECK: Words = {
  takes: "CERTIFICATE|-",
  short: "replays a proof that a shape is in one piece, or in several, or that a path holds",
  options: [QUIET],
  more:
    "Proofs about shapes are replayed in exact arithmetic by a program that shares no code with the one " +
    "that found them. That a path holds is computed again, and has to come out no worse. The exit code is " +
    "1 where a proof is refused.",
  examples: ["frond check proof.json"],
};

export const PLAN: Words = {
  takes: "LINK|-",
  short: "a path between two shapes on which they stay in one piece, if there is one",
  options: [
    ["as", "json", "json, or link: the same link, with this path in it"],
    out("x.json; without it the standard output"),
    EPSILON,
    ["axes", "2", "3: also with the stretch ahead of the turn, where the plane has no way"],
    ["size", "97", "samples a side of the map that it looks through, 16 to 512"],
    QUIET,
  ],
  more: "The exit code is 1 where the best path that was found breaks.",
  examples: ['frond render "$(frond plan "a=dragon-3&b=gasket" --as link)" --out x.gif'],
};

export const EXPORT: Words = {
  takes: SUBJECT,
  short: "the maps, as other programs read them",
  options: [
    ["as", "FORMAT", "json, fractint, flame, csv, svg, latex, tikz, python, geogebra .."],
    out("the file; without it the standard output"),
    T,
    QUIET,
  ],
  more: "",
  examples: ['frond export "a=fern&b=tree" --as tikz'],
};

export const TRACE: Words = {
  takes: "PICTURE|-",
  short: "the outline of what a photograph or a mask shows",
  options: [
    out("x.svg or x.csv; without it the standard output"),
    ["as", "svg", "svg or csv, where the name does not say it"],
    ["threshold", "0", "-1 to 1: less or more of the picture is taken for the leaf"],
    ["piece", "1", "which of the pieces, the largest first"],
    ["no-stalk", null, "take the stalk off"],
    QUIET,
  ],
  more:
    "PNG and JPEG are read, at most 64 megapixels. What is traced is in pixels, of a picture of more than " +
    "4 megapixels in those of a smaller one. An SVG has y down, a CSV up.",
  examples: ["frond trace leaf.jpg --out leaf.svg"],
};

export const FIT: Words = {
  takes: "OUTLINE|PICTURE|-",
  short: "a closed curve of few numbers, or few bytes, near an outline",
  options: [
    ["numbers", "260", "so many numbers, 12 to 2000, for a curve made of copies of its own arcs"],
    ["bytes", "150", "in place of them: so many bytes, 32 to 4000, for corners and parabolas"],
    ["smoothing", "0", "how much the outline is smoothed first, 0 to 1"],
    ["piece", "1", "which of the outlines of a file, or pieces of a picture, the largest first"],
    ["threshold", "0", "of a picture, -1 to 1: less or more of it is taken for the leaf"],
    ["no-stalk", null, "of a picture: take the stalk off"],
    ["as", "link", "link, svg, json or csv, where the name does not say it"],
    out("x.svg, x.json or x.csv; without it the standard output"),
    QUIET,
  ],
  more:
    "Outlines are read from SVG, CSV and other tables, GeoJSON and TopoJSON; pictures, PNG and JPEG, are " +
    "traced first. A link opens the curve in Fit.",
  examples: [
    "frond fit leaf.jpg --numbers 60 --out leaf.svg",
    "frond trace leaf.jpg --as csv | frond fit - --bytes 100",
  ],
};

export const MESH: Words = {
  takes: SUBJECT,
  short: "a surface around shapes of space, for printers and other programs",
  options: [
    out("x.stl, x.ply or x.glb; - is the standard output"),
    ["as", "stl", "stl, ply or glb, where the name does not say it"],
    ["size", "100", "the longest side, in millimetres"],
    ["fineness", "160", "samples along it, 16 to 640"],
    ["wall", "0.8", "how thick it is at least, in millimetres; three samples are the least"],
    ["t", "0.5", "the moment of the time line, 0 to 1; without it that of the link"],
    QUIET,
  ],
  more: "The subject is a link of space, or a file with maps of space.",
  examples: ['frond mesh "tool=space" --size 60 --out sponge.stl'],
};

const HEAD = "frond: the studio without a browser";
const TAIL = [
  'A link is one of the studio, or what stands behind its #, in quotes: "a=fern&b=tree". ' +
    "A file holds maps (.ifs, .flame, .aifs, JSON, a table), or a link (a PNG of Frond's, a text). " +
    "- is the standard input; --out - is the standard output.",
  "frond help COMMAND says what its options do; frond --version which Frond this is.",
  "Exit codes: 0 done, 1 the answer is no, 2 it could not be done, 130 interrupted by Ctrl-C.",
];

/** All commands, a line each. */
export function helpOf(commands: Readonly<Record<string, Words>>): string {
  const heads = Object.entries(commands).map(
    ([name, { takes, short }]) => [`frond ${name} ${takes}`, short] as const,
  );
  return [HEAD, "", ...columns(heads), "", ...TAIL.flatMap((words) => wrapped(words, COLUMNS))].join("\n");
}

/** One command, with all of its options. */
export function helpOn(name: string, { takes, short, options, more, examples }: Words): string {
  const rows = options.map(
    ([option, value, words]) => [`--${option}${value === null ? "" : ` ${value}`}`, words] as const,
  );
  return [
    `frond ${name} ${takes}`,
    `  ${short}`,
    "",
    ...columns(rows),
    ...(more === "" ? [] : ["", ...wrapped(more, COLUMNS)]),
    "",
    ...examples.map((example) => `  ${example}`),
  ].join("\n");
}

/** As wide as many a terminal is. */
const COLUMNS = 100;

function columns(rows: readonly (readonly [left: string, right: string])[]): string[] {
  const width = Math.max(...rows.map(([left]) => left.length));
  return rows.flatMap(([left, right]) =>
    wrapped(right, COLUMNS - width - 4).map((line, i) => `  ${(i > 0 ? "" : left).padEnd(width)}  ${line}`),
  );
}

function wrapped(words: string, width: number): string[] {
  const lines: string[] = [""];
  for (const word of words.split(" ")) {
    const last = lines.at(-1) ?? "";
    if (last === "") lines[lines.length - 1] = word;
    else if (last.length + 1 + word.length <= width) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}
