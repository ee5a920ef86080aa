import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { Button, type ButtonProps } from "../controls/Button";

interface FileButtonProps extends Pick<ButtonProps, "kind" | "disabled"> {
  /** What the field is called by those who look for it. */
  label: string;
  accept: string;
  onFile: (file: File) => void;
  children: ComponentChildren;
}

/** Asks for a file. */
export function FileButton({ label, accept, onFile, ...button }: FileButtonProps) {
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <Button {...button} onClick={() => input.current?.click()} />
      <input
        ref={input}
        class="unseen"
        type="file"
        accept={accept}
        aria-label={label}
        tabIndex={-1}
        onChange={(event) => {
          const [file] = event.currentTarget.files ?? [];
          if (file) onFile(file);
          // The same file once more is a choice, too.
          event.currentTarget.value = "";
        }}
      />
    </>
  );
}
