/** What the page of a lesson is made of, in one place. */
export { Formula } from "../../kit/frame/formula";
export type { Heading } from "../../kit/frame/frame";
export { useKept } from "../../kit/state/kept";
export { ChoiceQuestion } from "./choice-question";
export { Guess } from "./choices";
export { Lesson, Question, Truth } from "./lesson";
export { nearWords, type Prediction, useChoice, usePrediction } from "./prediction";
