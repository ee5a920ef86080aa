import { Select } from "#ui/controls/Select";

interface IndexSelectProps {
  /** What is chosen, where no label element says it. */
  label?: string;
  id?: string;
  value: number;
  count: number;
  onChange: (index: number) => void;
}

/** One of so many, by its number; the first is 1. */
export function IndexSelect({ label, id, value, count, onChange }: IndexSelectProps) {
  return (
    <Select
      id={id}
      aria-label={label}
      value={value}
      onChange={(event) => onChange(Number(event.currentTarget.value))}
    >
      {Array.from({ length: count }, (_, i) => (
        <option key={i} value={i}>
          {i + 1}
        </option>
      ))}
    </Select>
  );
}
