//! The JavaScript API as a package of its own, for demo makers who do not want the studio.

use std::fs;
use std::path::Path;

use crate::command::{Outcome, command, root, run, target};
use crate::modules::packaged;
use crate::stamp;

const MANIFEST: &str = include_str!("package/package.json");
/// What is written by hand, as it lies in the package.
const ENTRIES: &str = "crate/xtask/src/package/entries";
/// The entries for Node that are a module each, and these modules.
const OTHERS: [(&str, &str); 9] = [
    ("draw", "frond"),
    ("curve", "frond-curve"),
    ("proof", "frond-proof"),
    ("exact", "frond-exact"),
    ("fit", "frond-fit"),
    ("space", "frond-space"),
    ("exchange", "frond-exchange"),
    ("directed", "frond-directed"),
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
    let entries = root().join(ENTRIES);
    for file in stamp::files(&entries)? {
        stamp::write_changed(&folder.join(file.strip_prefix(&entries)?), &fs::read_to_string(&file)?)?;
    }
    for (name, module) in OTHERS {
        stamp::write_changed(&folder.join(format!("node/{name}.js")), &OTHER.replace("MODULE", module))?;
    }
    Ok(())
}

/// Writes the package into target/package/frond: the modules from `www/pkg`, and what www/build/package.config.ts made
/// of their bindings.
pub fn write() -> Outcome {
    let package = target().join("package/frond");
    if package.exists() {
        fs::remove_dir_all(&package)?;
    }
    fs::create_dir_all(&package)?;
    for file in packaged() {
        fs::copy(root().join("www/pkg").join(&file), package.join(&file))?;
    }
    for file in ["frond-view.js", "licenses.txt", "sbom.cdx.json"] {
        fs::copy(root().join("dist").join(file), package.join(file))?;
    }
    // Where its configuration has them written.
    let parts = root().join("target/package/parts");
    for part in stamp::files(&parts)? {
        let to = package.join(part.strip_prefix(&parts)?);
        fs::create_dir_all(to.parent().ok_or("a part of the package has no folder")?)?;
        fs::copy(&part, to)?;
    }
    for file in ["LICENSE-MIT", "LICENSE-APACHE"] {
        let path = root().join(file);
        if path.is_file() {
            fs::copy(path, package.join(file))?;
        }
    }
    write_manifest(&package)?;
    // What follows from its files: sizes, hashes, and what editors know of the element.
    run(command("node").arg("www/build/package/finish.mjs").arg(&package))
}
