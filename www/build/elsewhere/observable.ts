/** As much of a notebook as the cells that are shown need. */
import { join, slider, view } from "example:observable";

const Inputs = {
  range([least, most]: [number, number], { label }: { label: string }) {
    const input = document.createElement("input");
    Object.assign(input, { type: "range", min: least, max: most, step: "any", value: (least + most) / 2 });
    const whole = document.createElement("label");
    whole.append(`${label} `, input);
    return whole;
  },
};

/** Cells without values in them, as those of the page. */
function html([text = ""]: TemplateStringsArray): HTMLElement {
  const template = document.createElement("template");
  template.innerHTML = text;
  return document.importNode(template.content, true).firstElementChild as HTMLElement;
}

/** As a notebook loads what is no module of its kind. */
const require = (address: string) =>
  new Promise((_, reject) => {
    const script = document.createElement("script");
    script.onload = script.onerror = () => reject(new Error("This is no module for notebooks."));
    script.src = address;
    document.head.append(script);
  });

const place = document.getElementById("observable");
const input = slider({ Inputs });
const shown = await view({ require, html });
const joined = () => join({ view: shown, t: input.querySelector("input")?.valueAsNumber ?? 0 });
input.addEventListener("input", joined);
place?.append(input, shown);
joined();
