import { gasket } from "../../kit/maps/families";
import { Fitted } from "../../kit/picture/fitted";

const APART = gasket(0.47);

/** The gasket of which the table tells, with its pieces a little apart. */
export const Thumb = () => <Fitted of={APART} />;
