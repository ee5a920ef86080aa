/** The icons, drawn on a 24-unit grid with a 1.75-unit round pen; `fill` ones are solid. */

const STROKES = {
  add: "M12 5v14M5 12h14",
  remove: "M5 12h14",
  close: "M6 6l12 12M18 6L6 18",
  check: "M5 12.5l4.5 4.5L19 7",
  back: "M19 12H5M11 6l-6 6 6 6",
  arrow: "M4 12h15M13.5 6.5L19 12l-5.5 5.5",
  swap: "M4 8.5h15M15 4.5l4 4-4 4M20 15.5H5M9 11.5l-4 4 4 4",
  edit: "M4 20l1-4.5L15.8 4.7a1.6 1.6 0 0 1 2.3 0l1.2 1.2a1.6 1.6 0 0 1 0 2.3L8.5 19 4 20zM13.8 6.8l3.4 3.4",
  more: "M6 12h.01M12 12h.01M18 12h.01",
  copy: "M9 9h10v10H9zM15 9V5H5v10h4",
  print: "M7 9V4h10v5M7 17H4.5v-6.5h15V17H17M7 14.5h10V20H7z",
  slides: "M3.5 5h17v11h-17zM12 16v3.5M8.5 19.5h7M10.5 8.5l3.5 2-3.5 2z",
  link: "M10 14a4 4 0 0 0 5.7 0l3.1-3.1a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3.1 3.1a4 4 0 0 0 5.7 5.7l1-1",
  reflect: "M12 3.5v17M9 7L4 17h5zM15 7l5 10h-5z",
  reset: "M5 5v5h5M5.6 10A7.5 7.5 0 1 1 4.8 14",
  bin: "M5 7h14M9.5 7V4.5h5V7M7 7l1 12.5h8L17 7M10.5 10.5v6M13.5 10.5v6",
  loop: "M17 3.5l3 3-3 3M20 6.5H9a5 5 0 0 0-5 5M7 20.5l-3-3 3-3M4 17.5h11a5 5 0 0 0 5-5",
  once: "M3.5 12h13M12 7.5l4.5 4.5-4.5 4.5M20 6v12",
  swing: "M3.5 12h17M8 7.5L3.5 12 8 16.5M16 7.5l4.5 4.5-4.5 4.5",
  grid: "M4.5 4.5h6v6h-6zM13.5 4.5h6v6h-6zM4.5 13.5h6v6h-6zM13.5 13.5h6v6h-6z",
  keyboard: "M3.5 6.5h17v11h-17zM7 10h.01M10.3 10h.01M13.7 10h.01M17 10h.01M8 14h8",
  down: "M6 9.5l6 6 6-6",
  up: "M6 14.5l6-6 6 6",
  enlarge: "M13.5 4.5h6v6M19.5 4.5l-6 6M10.5 19.5h-6v-6M4.5 19.5l6-6",
  whole: "M4.5 9V4.5H9M15 4.5h4.5V9M4.5 15v4.5H9M15 19.5h4.5V15",
  save: "M12 4v11M7.5 11l4.5 4.5L16.5 11M5 19.5h14",
  file: "M7 3.5h6.5l4.5 4.5v12.5H7zM13.5 3.5V8H18M10 12.5h5M10 16h5",
  open: "M12 15V4M7.5 8.5L12 4l4.5 4.5M5 19.5h14",
  warning: "M12 4.5l8.5 15h-17zM12 10v4.5M12 17h.01",
} as const;

const FILLS = {
  play: "M8 5.2v13.6a.8.8 0 0 0 1.2.7l10.6-6.8a.8.8 0 0 0 0-1.4L9.2 4.5A.8.8 0 0 0 8 5.2z",
  pause: "M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",
} as const;

export type IconName = keyof typeof STROKES | keyof typeof FILLS;

/** Decoration only: whatever holds an icon names itself in words. `size` is in pixels of a page of usual size. */
export function Icon({ name, size = 20 }: { name: IconName; size?: number }) {
  const solid = name in FILLS;
  const path = solid ? FILLS[name as keyof typeof FILLS] : STROKES[name as keyof typeof STROKES];
  return (
    <svg
      class="icon"
      // In the page's own measure, so that it grows with the words.
      width={`${size / 16}rem`}
      height={`${size / 16}rem`}
      viewBox="0 0 24 24"
      aria-hidden="true"
      fill={solid ? "currentColor" : "none"}
      stroke={solid ? "none" : "currentColor"}
      stroke-width={name === "more" ? 2.6 : 1.75}
      stroke-linecap="round"
      stroke-linejoin="round"
    >
      <path d={path} />
    </svg>
  );
}
