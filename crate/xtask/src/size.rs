//! The size gate: what a visitor downloads, before the first picture above all, as a host sends it (gzip).

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use flate2::Compression;
use flate2::write::GzEncoder;

use crate::command::{Outcome, root};
use crate::stamp;

/// Bytes of the module that describes and draws, at most: all of wasm that the first picture needs.
const MOST_FIRST_BYTES: usize = 195_000;
/// Bytes of wasm to the first picture that a graphics card draws, by WebGPU, at most: the module that describes and
/// draws, which computes a coarse one at once, and the renderer.
const MOST_PICTURE_BYTES: usize = 485_000;
/// Bytes of the renderer for WebGL2 at most: old laptops and phones are who needs it.
const MOST_WEBGL2_BYTES: usize = 238_000;
/// Bytes of the scripts that index.html loads by itself, at most; what is loaded when asked for is not among them.
const MOST_SCRIPT_BYTES: usize = 80_000;

/// Bytes of the script of `<frond-view>`, which holds all that an attractor needs, at most.
const MOST_ELEMENT_BYTES: usize = 150_000;
/// Bytes of the module that reads drawings, at most.
const MOST_SVG_BYTES: usize = 300_000;

/// Weighs dist/ and fails where it is too heavy.
///
/// The first picture, the renderers, the first script and the script of the element have limits. What comes after the
/// first picture is only weighed, but for the module that reads drawings: it is another's library, which may grow.
pub fn gate() -> Outcome {
    let dist = root().join("dist");
    let weigh =
        |name: &str| -> Outcome<usize> {
            let modules: Vec<PathBuf> = stamp::files(&dist.join("assets"))?
                .into_iter()
                .filter(|file| {
                    let file = file.file_name().unwrap_or_default().to_string_lossy();
                    file.starts_with(name) && file.ends_with(".wasm")
                })
                .collect();
            match &modules[..] {
                [module] => gzipped(module),
                _ => Err(format!("dist/assets holds {} modules {name}*.wasm: it must be one", modules.len())
                    .into()),
            }
        };
    let (first, proof, fit) = (weigh("frond-first_bg")?, weigh("frond-proof_bg")?, weigh("frond-fit_bg")?);
    let (svg, text) = (weigh("frond-svg_bg")?, weigh("frond-text_bg")?);
    let (bend, exact) = (weigh("frond-bend_bg")?, weigh("frond-exact_bg")?);
    let (curve, space) = (weigh("frond-curve_bg")?, weigh("frond-space_bg")?);
    let (exchange, directed) = (weigh("frond-exchange_bg")?, weigh("frond-directed_bg")?);
    let (webgpu, webgl2) = (weigh("frond-webgpu_bg")?, weigh("frond-webgl2_bg")?);
    let mut script = 0;
    for file in loaded(&dist)? {
        script += gzipped(&file)?;
    }
    let mut fits = true;
    for (what, bytes, most) in [
        ("wasm to the first picture", first, Some(MOST_FIRST_BYTES)),
        ("the same with WebGPU", first + webgpu, Some(MOST_PICTURE_BYTES)),
        ("the renderer for WebGL2", webgl2, Some(MOST_WEBGL2_BYTES)),
        ("wasm in all with WebGPU", first + proof + webgpu, None),
        ("wasm in all with WebGL2", first + proof + webgl2, None),
        ("wasm that bends", bend, None),
        ("wasm of exact numbers", exact, None),
        ("wasm of closed curves", curve, None),
        ("wasm that fits outlines", fit, None),
        ("wasm that reads drawings", svg, Some(MOST_SVG_BYTES)),
        ("wasm that reads tables", text, None),
        ("wasm of space", space, None),
        ("wasm of files", exchange, None),
        ("wasm of several states", directed, None),
        ("<frond-view>", gzipped(&dist.join("frond-view.js"))?, Some(MOST_ELEMENT_BYTES)),
        ("script", script, Some(MOST_SCRIPT_BYTES)),
    ] {
        let limit = most.map_or(String::new(), |most| format!(" of {:>5.1} kB", kilo(most)));
        println!("    {what:<25} {:>7.1} kB{limit} gzipped", kilo(bytes));
        fits &= most.is_none_or(|most| bytes <= most);
    }
    if !fits {
        return Err("the download is larger than its limit".into());
    }
    Ok(())
}

/// The scripts that index.html names, and all that they import at once.
fn loaded(dist: &Path) -> Outcome<BTreeSet<PathBuf>> {
    let page = dist.join("index.html");
    let text = fs::read_to_string(&page).map_err(|error| format!("{}: {error}", page.display()))?;
    let mut found = BTreeSet::new();
    let mut open: Vec<PathBuf> = quoted(&text, &["src=\"", "href=\""]).map(|name| dist.join(name)).collect();
    if !open.iter().any(|file| is_script(file)) {
        return Err("dist/index.html names no script: is the gate looking at the right thing?".into());
    }
    while let Some(file) = open.pop() {
        if is_script(&file) && file.is_file() && found.insert(fs::canonicalize(&file)?) {
            let text = fs::read_to_string(&file)?;
            let folder = file.parent().unwrap_or(dist);
            // `import"./a.js"` and `from"./a.js"` are loaded at once; `import("./a.js")` when asked for.
            let names = quoted(&text, &["from\"", "from \"", "import\"", "import \""]);
            open.extend(names.map(|name| folder.join(name)));
        }
    }
    Ok(found)
}

/// What stands between each of these openings and the next quotation mark.
fn quoted<'a>(text: &'a str, openings: &[&'a str]) -> impl Iterator<Item = &'a str> {
    openings
        .iter()
        .flat_map(move |opening| text.split(opening).skip(1))
        .filter_map(|rest| rest.split('"').next())
}

fn is_script(file: &Path) -> bool {
    file.extension().is_some_and(|extension| extension == "js")
}

fn gzipped(file: &Path) -> Outcome<usize> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(&fs::read(file)?)?;
    Ok(encoder.finish()?.len())
}

/// Kilobytes of 1000 bytes, to print.
fn kilo(bytes: usize) -> f64 {
    u32::try_from(bytes).map_or(f64::INFINITY, f64::from) / 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_imported_when_asked_for_is_not_counted() {
        let text =
            r#"import{a}from"./a.js";import"./b.js";const c=()=>import("./c.js");export{d}from"./d.js""#;
        let names: Vec<&str> = quoted(text, &["from\"", "import\""]).collect();
        assert_eq!(names, ["./a.js", "./d.js", "./b.js"]);
    }

    #[test]
    fn a_folder_is_weighed_by_what_its_page_loads() -> Outcome {
        let dist = std::env::temp_dir().join(format!("frond-size-{}", std::process::id()));
        fs::create_dir_all(dist.join("assets"))?;
        fs::write(dist.join("index.html"), r#"<script type="module" src="./assets/main.js"></script>"#)?;
        fs::write(dist.join("assets/main.js"), r#"import"./once.js";import("./later.js")"#)?;
        fs::write(dist.join("assets/once.js"), r#"import"./main.js""#)?;
        fs::write(dist.join("assets/later.js"), "")?;
        let found = loaded(&dist)?;
        let names: Vec<_> = found.iter().filter_map(|file| file.file_name()).collect();
        assert_eq!(names, ["main.js", "once.js"]);
        fs::write(dist.join("index.html"), "")?;
        assert!(loaded(&dist).is_err());
        Ok(fs::remove_dir_all(dist)?)
    }
}
