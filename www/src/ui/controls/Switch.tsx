import "./choice.css";
import type { ComponentChildren } from "preact";

interface SwitchProps {
  children: ComponentChildren;
  checked: boolean;
  onChange: (checked: boolean) => void;
  description?: string;
  disabled?: boolean;
}

/** On or off, at once. */
export function Switch({ children, checked, onChange, description, disabled = false }: SwitchProps) {
  return (
    <label class="switch" title={description}>
      <input
        type="checkbox"
        role="switch"
        checked={checked}
        aria-checked={checked}
        disabled={disabled}
        onChange={(event) => onChange(event.currentTarget.checked)}
      />
      <span class="switch-track" aria-hidden="true" />
      <span>{children}</span>
    </label>
  );
}
