/** The figures of the paper as live pages. */
export function Figures({ figure }: { figure: string | null }) {
  return <p>{figure ? `Figure ${figure}` : "Figures"}</p>;
}
