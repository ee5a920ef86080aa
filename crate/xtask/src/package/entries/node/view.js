// There are no elements in Node: a page that is drawn on a server imports the element all the same.
export function FrondView() {}
FrondView.proof = null;
