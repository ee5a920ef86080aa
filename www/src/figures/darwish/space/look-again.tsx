import { Button } from "#ui/controls/Button";
import type { SpaceView } from "#wasm/api";

interface LookAgainProps {
  view: SpaceView;
  /** From where the paper looks. */
  home: SpaceView;
  onView: (view: SpaceView) => void;
}

/** Back to where the paper looks from, along x. */
export function LookAgain({ view, home, onView }: LookAgainProps) {
  const away = Math.abs(view.turn - home.turn) + Math.abs(view.tilt - home.tilt) > 1e-9;
  return (
    <Button kind="quiet" icon="reset" disabled={!away} onClick={() => onView(home)}>
      Look along x again
    </Button>
  );
}
