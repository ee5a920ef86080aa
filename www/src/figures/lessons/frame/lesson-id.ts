import { createContext } from "preact";

/** The address of the lesson that one is in, as `e1`. */
export const LessonId = createContext("");
