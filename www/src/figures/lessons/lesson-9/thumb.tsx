import { unevenGasket } from "../../kit/maps/families";
import { Fitted } from "../../kit/picture/fitted";

const ALONE = unevenGasket([0.5, 0.5, 0.3]);

export const Thumb = () => <Fitted of={ALONE} />;
