import { plan3 } from "#compute/plan";
import { plan, stuck } from "#compute/results";
import { bestWords } from "#format/path-words";
import pathCss from "#stage/locus/path.module.css";
import { Button } from "#ui/controls/Button";
import { Switch } from "#ui/controls/Switch";
import { openMatching, openRoutes } from "../../dialogs";
import { mode } from "../../document-signals";
import * as messages from "../messages";
import { setThird, third } from "./automatic";

/** What else there is where the automatic path cannot hold, or has been led through the third parameter. */
export function WayElse() {
  const further = plan3.value;
  const looking = further !== null && further.plan === null;
  const best = further?.plan ?? plan.value;
  const inVain = further?.plan != null && !third.value;
  return (
    <div class={pathCss["path-else"]}>
      {stuck.value && !looking && (
        <p class="hint">{bestWords(best?.apart === true, further?.plan != null)}</p>
      )}
      {mode.value === "polar" && (
        <Switch checked={third.value} onChange={setThird} description={messages.stretchMayLeadOr}>
          {looking ? messages.withThirdParameterSearching : messages.withThirdParameter}
        </Switch>
      )}
      {inVain && <p class="hint">{messages.thirdParameterDoesNot}</p>}
      {stuck.value && (
        <div class={pathCss["path-offers"]}>
          <Button kind="quiet" onClick={openMatching}>
            {messages.otherPairings}
          </Button>
          <Button kind="quiet" onClick={openRoutes}>
            {messages.otherPaths}
          </Button>
        </div>
      )}
    </div>
  );
}
