import { useEffect } from "preact/hooks";
import { Square } from "../../kit/locus/locus-square";
import { STRAIGHT } from "../../kit/maps/morphs";
import { Small } from "../../kit/picture/small";
import { chart, followChart } from "../dragon/dragon";

export function Thumb() {
  useEffect(followChart, []);
  const { field, plan } = chart.value;
  const lines = [
    { name: "straight", points: STRAIGHT, dashed: true },
    ...(plan ? [{ name: "planned", points: plan.points }] : []),
  ];
  return (
    <Small>
      <Square field={field} label={null} lines={lines} />
    </Small>
  );
}
