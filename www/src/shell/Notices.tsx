import { announcement, dismiss, notices } from "#document/notice";
import { Toasts } from "#ui/overlay/Toasts";

/** What is said, on screen and aloud. */
export function Notices() {
  return (
    <>
      <div class="notices">
        <Toasts toasts={notices.value} onDismiss={dismiss} />
      </div>
      <p class="unseen" role="status" aria-live="polite">
        {announcement.value}
      </p>
    </>
  );
}
