/** Why something could not be computed. */

export const windowFailed = (error: string) => `This part could not be computed: ${error}`;

export const locusFailed = (error: string) => `The locus could not be computed: ${error}`;

export const containsInvalidNumbers = "it contains invalid numbers";
export const windowEmpty = "its window is empty";
export const tooFarOut = "it is too far out";

export const pairingsFailed = (error: string) => `The search for other pairings failed: ${error}`;

export const planFailed = (error: string) => `The search for a path failed: ${error}`;

export const proofWouldNeedMore = "The proof would need more pieces than Frond can check.";

export const routesFailed = (error: string) => `The search for other paths failed: ${error}`;

export const searchFailed = (problem: string) => `The search for other paths could not start: ${problem}`;
