/** What the pages of functions do: they run their samples, and search. Without it they are read all the same. */

type Run = (
  console: { log(...values: unknown[]): void },
  document: { querySelector(): unknown },
) => Promise<void>;

const said = (value: unknown) =>
  typeof value === "string" ? value : value instanceof Object ? JSON.stringify(value) : String(value);

for (const button of document.querySelectorAll<HTMLButtonElement>("button[data-sample]")) {
  button.hidden = false;
  button.addEventListener("click", () => run(button));
}

async function run(button: HTMLButtonElement): Promise<void> {
  const place = button.parentElement;
  const output = place?.querySelector("output");
  const { sample } = button.dataset;
  if (!place || !output || button.ariaDisabled === "true") return;
  button.ariaDisabled = "true";
  output.textContent = "Running …";
  place.querySelector("canvas")?.remove();
  const lines: string[] = [];
  const shown = () => {
    output.textContent = lines.join("\n");
  };
  try {
    // It is seen that it runs, before a long answer holds up the page.
    await new Promise((painted) => setTimeout(painted, 50));
    const { default: call }: { default: Run } = await import(
      /* @vite-ignore */ new URL(`samples/${sample}.js`, location.href).href
    );
    await call(
      { log: (...values) => lines.push(values.map(said).join(" ")) },
      { querySelector: () => canvas(place, sample) },
    );
  } catch (problem) {
    lines.push(problem instanceof Error ? problem.message : said((problem as { message?: unknown }).message));
  }
  shown();
  button.ariaDisabled = null;
}

/** A canvas that takes on the size of what is put on it. */
function canvas(place: Element, sample = "") {
  return {
    getContext: () => ({
      putImageData(data: ImageData) {
        const own = document.createElement("canvas");
        own.width = data.width;
        own.height = data.height;
        own.setAttribute("role", "img");
        own.setAttribute("aria-label", `The picture of the sample of ${sample}`);
        own.getContext("2d")?.putImageData(data, 0, 0);
        place.append(own);
      },
    }),
  };
}

const form = document.querySelector<HTMLFormElement>("form[role=search]");
const field = form?.querySelector("input");
const found = document.querySelector("#found");
if (form && field) {
  form.hidden = false;
  if (found) {
    field.value = new URLSearchParams(location.search).get("q") ?? "";
    field.addEventListener("input", search);
    search();
  }
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const address = new URL("index.html", location.href);
    address.searchParams.set("q", field.value);
    if (found) history.replaceState(null, "", address);
    else location.href = address.href;
  });
}

/** Leaves what has all the words. */
function search(): void {
  const words = (field?.value ?? "").toLowerCase().split(/\s+/).filter(Boolean);
  let [all, left] = [0, 0];
  for (const section of document.querySelectorAll("section")) {
    let here = 0;
    for (const row of section.querySelectorAll("li")) {
      const text = row.textContent?.toLowerCase() ?? "";
      row.hidden = !words.every((word) => text.includes(word));
      all++;
      if (!row.hidden) here++;
    }
    section.hidden = here === 0;
    left += here;
  }
  if (found)
    found.textContent =
      words.length === 0 ? "" : left === 0 ? "Nothing has these words." : `${left} of ${all}`;
}
