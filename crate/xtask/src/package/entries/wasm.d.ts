/** The address of the module, as bundlers give it; to be handed to `init`. */
declare const address: string;
export default address;
