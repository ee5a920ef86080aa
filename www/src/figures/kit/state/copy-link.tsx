import { useContext } from "preact/hooks";
import { notify } from "#document/notice";
import { IconButton } from "#ui/controls/Button";
import { Page } from "./kept";
import { stepIn } from "./steps";

interface CopyLinkProps {
  /** The step that the link leads to; without it, the beginning. */
  step?: string;
  class?: string | undefined;
}

/** Copies a link that opens the page as it is now. */
export function CopyLink({ step, class: own }: CopyLinkProps) {
  const page = useContext(Page);
  const copy = async () => {
    const { origin, pathname } = location;
    const address = `${origin}${pathname}${page.fragment(step === undefined ? [] : [stepIn(step)])}`;
    try {
      await navigator.clipboard.writeText(address);
      notify({
        kind: "info",
        text: `Link copied. It opens this ${step === undefined ? "page" : "step"} as it is now.`,
      });
    } catch {
      notify({ kind: "error", text: `Copying was not allowed here. This is the link: ${address}` });
    }
  };
  return page.place === "" ? null : (
    <IconButton
      icon="link"
      kind="quiet"
      class={own}
      label={step === undefined ? "Copy a link" : "Copy a link to this step"}
      description="it opens all as it is now"
      onClick={copy}
    />
  );
}
