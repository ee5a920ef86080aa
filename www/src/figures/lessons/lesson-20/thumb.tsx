import { Small } from "../../kit/picture/small";
import { Chart } from "./chart";
import { useProved } from "./proved";

export function Thumb() {
  const { field } = useProved(true);
  return (
    <Small>
      <Chart field={field} label={null} />
    </Small>
  );
}
