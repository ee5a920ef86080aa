/** How far a bend is from the plain one, and how its lift is shared out over the levels. */
import { bendAt } from "#document/deform/bend";
import type { Bend } from "#wasm/api";
import { bends } from "#wasm/bend";
import { GASKET, KE, liftOf } from "../../fujimoto/deformations/lifted-gasket";

/** The roughness of the lesson, until somebody changes it. */
export const DELTA = 0.75;

/** The lifted gasket with these two numbers, pulled so far. */
export function lifted(kb: number, delta: number, pull = 1): Bend {
  return bendAt(liftOf({ kb, delta }), pull);
}

/** So many letters are tried in all ways; the rest are the first. */
const TRIED = 5;

/** Codes of points of a piece, as long as what is shuffled. */
function codesIn(piece: readonly number[]): number[][] {
  const free = Math.min(TRIED, KE - piece.length);
  return Array.from({ length: 3 ** free }, (_, number) => {
    const letters = Array.from({ length: KE - piece.length }, (_, i) =>
      i < free ? Math.floor(number / 3 ** i) % 3 : 0,
    );
    return [...piece, ...letters];
  });
}

/** By how much a bend moves points of a piece otherwise than the plain one does, at most, in sizes of the piece. */
export function apartFromPlain(piece: readonly number[], kb: number, delta: number): number {
  const codes = codesIn(piece);
  const tails = codes.map((): [number, number] => [0, 0]);
  const [bent, plain] = [lifted(kb, delta), lifted(KE, delta)].map((bend) =>
    bends().deform({ maps: GASKET }, bend, codes, tails),
  );
  let most = 0;
  for (let i = 0; i < 2 * codes.length; i += 2) {
    const dx = (bent?.[i] ?? 0) - (plain?.[i] ?? 0);
    const dy = (bent?.[i + 1] ?? 0) - (plain?.[i + 1] ?? 0);
    most = Math.max(most, Math.hypot(dx, dy));
  }
  return most * 2 ** piece.length;
}

/** All of it; the far corner, 1111; and 2333, which is next to the middle of the long side. */
export const WHOLE: readonly number[] = [];
export const FAR: readonly number[] = [0, 0, 0, 0];
export const NEAR: readonly number[] = [1, 2, 2, 2];

/** The first exercise: no farther from the plain bend than this part of the size. */
export const NEARLY_PLAIN = 0.01;
/** The second: so quiet in the far corner, and still so lively beside the pull. */
export const QUIET = 0.02;
export const LIVELY = 0.05;

export const isQuietAndLively = (far: number, near: number) => far <= QUIET && near >= LIVELY;

/** The shares of the levels kb, kb + 1, .., ke, for whole kb (eq 13): each is delta times the one before. */
export function shares(kb: number, delta: number): number[] {
  const powers = Array.from({ length: KE - kb + 1 }, (_, j) => delta ** j);
  const sum = powers.reduce((all, one) => all + one, 0);
  return powers.map((one) => one / sum);
}
