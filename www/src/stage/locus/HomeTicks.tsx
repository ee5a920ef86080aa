import css from "./locus.module.css";

const TICKS = [-1, 0, 1, 2];

/** Numbers along one side of the square from −1 to 2. */
export function HomeTicks({ axis }: { axis: "u" | "v" }) {
  return (
    <div class={`${css["locus-ticks"]} ${axis}`} aria-hidden="true">
      {TICKS.map((x) => (
        <span
          key={x}
          class={x === -1 ? "first" : x === 2 ? "last" : ""}
          style={{ "--at": `${(100 * (x + 1)) / 3}%` }}
        >
          <b>{String(x).replace("-", "−")}</b>
        </span>
      ))}
      <em style={{ "--at": "50%" }}>{axis}</em>
    </div>
  );
}
