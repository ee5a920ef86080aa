/** A curve of the plane as a word of the document: "t,x,y;..:cx,cxy,cyx,cy,from,to;..". */
import { type Factor, MOST_PIECES, type PlaneCurve, type Point } from "./curve";

export const toWord = ({ points, pieces }: PlaneCurve): string =>
  [points, pieces.map(({ factor, span }) => [...factor, ...span])]
    .map((rows) => rows.map((row) => row.map(plain).join(",")).join(";"))
    .join(":");

/** No plus in exponents, which a link would have to escape. */
const plain = (x: number) => String(x + 0).replace("+", "");

/** The curve of a word; null where it is none. Whether its factors shrink is not asked here. */
export function fromWord(word: string): PlaneCurve | null {
  const [points, pieces, ...rest] = word.split(":").map(rows);
  const count = pieces?.length ?? 0;
  if (!points || !pieces || rest.length > 0 || count < 1 || count > MOST_PIECES) return null;
  const isPoint = (row: number[]): row is Point => row.length === 3;
  const ends = (row: number[]) =>
    row.slice(4).every((end) => Number.isInteger(end) && end >= 0 && end <= count);
  if (points.length !== count + 1 || !points.every(isPoint)) return null;
  if (!pieces.every((row) => row.length === 6 && ends(row))) return null;
  return {
    points,
    pieces: pieces.map(([cx = 0, cxy = 0, cyx = 0, cy = 0, from = 0, to = 0]) => {
      const factor: Factor = [cx, cxy, cyx, cy];
      return { factor, span: [from, to] };
    }),
  };
}

function rows(text: string): number[][] | null {
  const list = text.split(";").map((row) => row.split(",").map((x) => (x === "" ? Number.NaN : Number(x))));
  return list.every((row) => row.every(Number.isFinite)) ? list : null;
}
