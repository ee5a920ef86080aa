//! The JavaScript API as a package of its own, for demo makers who do not want the studio.

use std::fs;
use std::path::Path;

use crate::command::{Outcome, root, target};
use crate::modules::files;
use crate::stamp;

const MANIFEST: &str = include_str!("package/package.json");
/// The entries: all that needs no graphics card, in the browser and in Node.
const ENTRIES: [(&str, &str); 3] = [
    ("index.js", include_str!("package/index.js")),
    ("index.d.ts", include_str!("package/index.d.ts")),
    ("node.js", include_str!("package/node.js")),
];

/// Writes what makes a folder with wasm-bindgen's files a package: its manifest and its entries.
pub fn write_manifest(folder: &Path) -> Outcome {
    stamp::write_changed(
        &folder.join("package.json"),
        &MANIFEST.replace("0.0.0", env!("CARGO_PKG_VERSION")),
    )?;
    for (name, text) in ENTRIES {
        stamp::write_changed(&folder.join(name), text)?;
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
    for file in ["LICENSE-MIT", "LICENSE-APACHE", "README.md"] {
        let path = root().join(file);
        if path.is_file() {
            fs::copy(path, package.join(file))?;
        }
    }
    write_manifest(&package)
}
