import { createContext } from "preact";
import type { PaperExercise } from "./teaching";

/** The address of the lesson that one is in, as `e1`. */
export const LessonId = createContext("");

/** The exercises that its handout has. */
export const OnPaper = createContext<readonly (PaperExercise | "same")[]>([]);
