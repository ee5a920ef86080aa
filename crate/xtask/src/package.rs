//! The JavaScript API as a package of its own, for demo makers who do not want the studio.

use std::fs;
use std::path::Path;

use crate::command::{Outcome, root, target};
use crate::modules::files;
use crate::stamp;

const MANIFEST: &str = include_str!("package/package.json");
/// The first entry: all that needs no graphics card, in the browser and in Node; and the types of the element, which
/// the site builds.
const FIRST: [(&str, &str); 4] = [
    ("index.js", include_str!("package/entries/index.js")),
    ("index.d.ts", include_str!("package/entries/index.d.ts")),
    ("frond-view.d.ts", include_str!("package/entries/frond-view.d.ts")),
    ("node/index.js", include_str!("package/entries/node/index.js")),
];
/// The other entries that work in Node, and the modules that they are.
const OTHERS: [(&str, &str); 7] = [
    ("draw", "frond"),
    ("curve", "frond-curve"),
    ("proof", "frond-proof"),
    ("fit", "frond-fit"),
    ("space", "frond-space"),
    ("exchange", "frond-exchange"),
    ("morph", "frond-morph"),
];
/// Such an entry for Node.
const OTHER: &str = include_str!("package/node-module.js");

/// Writes what makes a folder with wasm-bindgen's files a package: its manifest and its entries.
pub fn write_manifest(folder: &Path) -> Outcome {
    stamp::write_changed(
        &folder.join("package.json"),
        &MANIFEST.replace("0.0.0", env!("CARGO_PKG_VERSION")),
    )?;
    fs::create_dir_all(folder.join("node"))?;
    for (name, text) in FIRST {
        stamp::write_changed(&folder.join(name), text)?;
    }
    for (name, module) in OTHERS {
        stamp::write_changed(&folder.join(format!("node/{name}.js")), &OTHER.replace("MODULE", module))?;
    }
    Ok(())
}

/// Writes the package into target/package/frond, from `www/pkg`.
pub fn write() -> Outcome {
    let package = target().join("package/frond");
    if package.exists() {
        fs::remove_dir_all(&package)?;
    }
    fs::create_dir_all(&package)?;
    for file in files() {
        fs::copy(root().join("www/pkg").join(&file), package.join(&file))?;
    }
    fs::copy(root().join("dist/frond-view.js"), package.join("frond-view.js"))?;
    for file in ["LICENSE-MIT", "LICENSE-APACHE"] {
        let path = root().join(file);
        if path.is_file() {
            fs::copy(path, package.join(file))?;
        }
    }
    stamp::write_changed(&package.join("README.md"), include_str!("package/entries/README.md"))?;
    write_manifest(&package)
}
