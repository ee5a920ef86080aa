import "#ui/panel/fold.css";
import { lookForRoutes, routes } from "#compute/routes";
import { announce } from "#document/notice";
import { edit } from "#document/scene";
import { sameMaps } from "#geometry/maps/same-maps";
import { Button } from "#ui/controls/Button";
import { useOwnId } from "#ui/id";
import type { Route, RouteKind } from "#wasm/api";
import { routesOpen } from "../dialogs";
import { correspondence, shapes, turns } from "../document-signals";
import { isMatched, takeRoute } from "../ways";
import * as messages from "./messages";
import css from "./pairs.module.css";

const NAMES: Record<RouteKind, string> = {
  plain: messages.asThey,
  collapse: messages.throughFlatState,
  correspondence: messages.anotherPairing,
  symmetry: messages.throughSymmetry,
  mirror: messages.throughMirrorImage,
  refine: messages.withSmallerCopies,
  double: messages.withCopyUsedTwice,
  joints: messages.jointByJoint,
  place: messages.withShapeBMoved,
};

/** Ways to bring the two shapes to a morph, each in a sentence. */
export function Routes() {
  const found = routes.value;
  return (
    <details
      class={`fold ${css["pairs-more"]}`}
      id="routes"
      open={routesOpen.value}
      onToggle={(event) => {
        const { open } = event.currentTarget;
        routesOpen.value = open;
        if (open && routes.peek() === null) lookForRoutes();
      }}
    >
      <summary>{messages.otherPaths}</summary>
      {found === null && <Button onClick={lookForRoutes}>{messages.searchAgain}</Button>}
      {found?.list === null && <p class="hint">{messages.searching}</p>}
      {found?.problem != null && <p class="hint">{found.problem}</p>}
      {found?.problem == null && found?.list?.length === 0 && (
        <p class="hint">{messages.frondKnowsNoOther}</p>
      )}
      {found?.list && found.list.length > 0 && <List list={found.list} />}
    </details>
  );
}

function List({ list }: { list: readonly Route[] }) {
  const name = useOwnId("routes");
  const [a, b] = [shapes.a.value, shapes.b.value];
  const now = { correspondence: correspondence.value, turns: turns.value };
  const chosen = list.findIndex(
    (route) => sameMaps(route.from, a.maps) && sameMaps(route.to, b.maps) && isMatched(now, route),
  );
  return (
    <div class={css["routes"]} role="radiogroup" aria-label={messages.paths}>
      {list.map((route, i) => (
        <label key={`${i} ${route.kind}`} class={css["route"]}>
          <input
            type="radio"
            name={name}
            checked={i === chosen}
            onChange={() => {
              edit((before) => takeRoute(before, route));
              announce(route.about);
            }}
          />
          <span>
            <span class={css["route-name"]}>{NAMES[route.kind] ?? messages.anotherPath}</span> {route.about}
          </span>
        </label>
      ))}
    </div>
  );
}
