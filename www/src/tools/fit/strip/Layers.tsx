import { fitDocument } from "#document/fit";
import { Switch } from "#ui/controls/Switch";
import fitCss from "../fit.module.css";
import { knotsShown, outlineShown, photoShown } from "../stage/layers";
import { opened } from "../work/source";

/** What is drawn beside the fit. */
export function Layers() {
  const { model } = fitDocument.value;
  return (
    <fieldset class={fitCss["layers"]}>
      <legend class="unseen">Shown</legend>
      {opened.value && (
        <Switch
          checked={photoShown.value}
          onChange={(on) => {
            photoShown.value = on;
          }}
        >
          Picture
        </Switch>
      )}
      <Switch
        checked={outlineShown.value}
        onChange={(on) => {
          outlineShown.value = on;
        }}
      >
        Outline
      </Switch>
      <Switch
        checked={knotsShown.value}
        onChange={(on) => {
          knotsShown.value = on;
        }}
      >
        {{ closed: "Knots", spline: "Control points", collage: "Feature points" }[model]}
      </Switch>
    </fieldset>
  );
}
