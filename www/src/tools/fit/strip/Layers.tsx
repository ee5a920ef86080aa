import { fitDocument } from "#document/fit";
import { Switch } from "#ui/controls/Switch";
import fitCss from "../fit.module.css";
import * as messages from "../messages";
import { knotsShown, outlineShown, photoShown } from "../stage/layers";
import { opened } from "../work/source";

/** What is drawn beside the fit. */
export function Layers() {
  const { model } = fitDocument.value;
  return (
    <fieldset class={fitCss["layers"]}>
      <legend class="unseen">{messages.shown}</legend>
      {opened.value && (
        <Switch
          checked={photoShown.value}
          onChange={(on) => {
            photoShown.value = on;
          }}
        >
          {messages.picture2}
        </Switch>
      )}
      <Switch
        checked={outlineShown.value}
        onChange={(on) => {
          outlineShown.value = on;
        }}
      >
        {messages.outline}
      </Switch>
      <Switch
        checked={knotsShown.value}
        onChange={(on) => {
          knotsShown.value = on;
        }}
      >
        {{ closed: messages.knots, spline: messages.controlPoints, collage: messages.featurePoints }[model]}
      </Switch>
    </fieldset>
  );
}
