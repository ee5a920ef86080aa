from pathlib import Path

import anywidget
import traitlets

package = Path("node_modules/frond-ifs")


class Morph(anywidget.AnyWidget):
    _esm = package.joinpath("frond-view.module.js").read_text() + """
export default {
  render({ model, el }) {
    customElements.get("frond-view").proof = model.get("proof");
    el.innerHTML = '<frond-view a="dragon-3" b="gasket" t="0.4" controls verdict></frond-view>';
  },
};
"""
    proof = traitlets.Bytes(package.joinpath("frond-proof_bg.wasm").read_bytes()).tag(sync=True)
