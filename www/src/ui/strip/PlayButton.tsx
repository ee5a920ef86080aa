import "./play-button.css";
import { IconButton } from "../controls/Button";
import * as messages from "../messages";

interface PlayButtonProps {
  playing: boolean;
  onToggle: () => void;
  /** Why there is nothing to play. */
  still?: string | undefined;
}

export function PlayButton({ playing, onToggle, still }: PlayButtonProps) {
  return (
    <IconButton
      class="play"
      command="play"
      icon={playing ? "pause" : "play"}
      label={playing ? messages.pause : messages.play}
      disabled={still !== undefined}
      {...(still === undefined ? {} : { description: still })}
      onClick={onToggle}
    />
  );
}
