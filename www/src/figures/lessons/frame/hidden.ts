import { createContext } from "preact";

/** Whether the lesson keeps for now what is right to itself: so a class sheet has it. */
export const Hidden = createContext(false);
