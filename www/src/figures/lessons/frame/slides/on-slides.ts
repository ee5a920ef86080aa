/** Which slide of a lesson is shown, and how an address says so. */
import { signal } from "@preact/signals";

/** From 0; null while the lesson is a page. */
export const slide = signal<number | null>(null);

/** What a slide must not show: what was guessed, and what was made of exercises. */
export const ANSWERS = /^(?:guess|shown|hints|x\d.*)$/;

/**
 * Addresses count steps, from 1: the words and the picture of a lesson are two steps, and one slide. So a link leads to
 * the same step as when each was a slide of its own.
 */
export const slideOfStep = (step: number) => Math.max(0, step - 2);
export const stepOfSlide = (at: number) => (at === 0 ? 1 : at + 2);

/** The steps of a lesson by slides: its words and its picture are seen together. */
export function slidesOf<T>(steps: readonly T[]): T[][] {
  const [words, picture, ...others] = steps;
  if (words === undefined || picture === undefined) return steps.map((one) => [one]);
  return [[words, picture], ...others.map((one) => [one])];
}
