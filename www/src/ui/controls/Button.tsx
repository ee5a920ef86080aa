import "./button.css";
import type { ComponentChildren, Ref } from "preact";
import { withKey } from "../commands";
import { Icon, type IconName } from "./Icon";

export interface ButtonProps {
  children?: ComponentChildren;
  onClick?: (event: MouseEvent) => void;
  icon?: IconName;
  /** `quiet` has no border until it is pointed at; `primary` is the one thing to do here. */
  kind?: "plain" | "quiet" | "primary" | "danger";
  disabled?: boolean;
  /** On or off: a toggle. Leave it out for an ordinary button. */
  pressed?: boolean;
  /** More than the label says; shown when pointed at and read after the name. */
  description?: string;
  /** The command that it stands for, whose key is told with the description. */
  command?: string;
  class?: string | undefined;
  type?: "button" | "submit";
  role?: "menuitem";
  popup?: "menu" | "dialog";
  expanded?: boolean;
  buttonRef?: Ref<HTMLButtonElement>;
}

interface IconButtonProps extends Omit<ButtonProps, "children" | "icon"> {
  icon: IconName;
  /** Its name in words, also its tooltip. */
  label: string;
}

/** A button with words on it. */
export function Button({ children, ...props }: ButtonProps) {
  return <Base {...props}>{children}</Base>;
}

/** A button with only a drawing on it, named for those who hear it and for those who point at it. */
export function IconButton({ label, description, class: extra, ...props }: IconButtonProps) {
  return (
    <Base
      {...props}
      class={`icon-button ${extra ?? ""}`}
      label={label}
      description={description === undefined ? label : `${label}: ${description}`}
    />
  );
}

function Base(props: ButtonProps & { label?: string }) {
  const { children, kind = "plain", icon, label, description, pressed, disabled, popup, expanded } = props;
  return (
    <button
      ref={props.buttonRef ?? null}
      type={props.type ?? "button"}
      role={props.role}
      class={`button ${kind} ${props.class ?? ""}`}
      disabled={disabled ?? false}
      aria-label={label}
      aria-pressed={pressed}
      aria-haspopup={popup}
      aria-expanded={expanded}
      title={description === undefined ? undefined : withKey(description, props.command)}
      onClick={props.onClick}
    >
      {icon !== undefined && <Icon name={icon} />}
      {children}
    </button>
  );
}
