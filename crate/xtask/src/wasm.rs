//! From the Rust crates to `www/pkg`, which the page imports: Cargo, wasm-bindgen, wasm-opt.

use std::fs;
use std::path::{Path, PathBuf};
use std::thread;

use crate::command::{Outcome, cargo_wasm, root, run, target};
use crate::node::{self, Tool};
use crate::package;
use crate::stamp::{self, Hash};
use crate::step::Steps;
use crate::tools::{self, WASM_TARGET};

/// What the module may use. The names of .cargo/config.toml's features, as wasm-opt has them, with those that Rust
/// turns on by itself.
const OPTIMISE: &str = "-O3 --enable-simd --enable-bulk-memory --enable-bulk-memory-opt --enable-nontrapping-float-to-int \
    --enable-sign-ext --enable-mutable-globals --enable-reference-types --enable-multivalue \
    --enable-call-indirect-overlong";

/// The modules that crate/web is built into: the name of the files and the feature that makes it. The first describes and
/// draws, and is all that the first picture needs; the second has closed curves and graphs, where the page shows some; the
/// third decides and proves, in the workers; the fourth traces and fits outlines, in workers of its own; the fifth is for
/// space, where its tool is open; of the others, which draw on a graphics card, a visitor gets one.
const MODULES: [(&str, &str); 7] = [
    ("frond", "compute"),
    ("frond-curve", "curve"),
    ("frond-proof", "proof"),
    ("frond-fit", "fit"),
    ("frond-space", "space"),
    ("frond-webgpu", "webgpu"),
    ("frond-webgl2", "webgl2"),
];

/// Scripts of crate/web/js, which choose among the modules.
const SCRIPTS: [&str; 2] = ["renderer.js", "renderer.d.ts"];

/// What the page imports.
pub fn files() -> Vec<String> {
    let of = |(name, _): (&str, &str)| {
        ["js", "d.ts"]
            .map(|ending| format!("{name}.{ending}"))
            .into_iter()
            .chain(["wasm", "wasm.d.ts"].map(|ending| format!("{name}_bg.{ending}")))
            .collect::<Vec<_>>()
    };
    MODULES.into_iter().flat_map(of).chain(SCRIPTS.map(str::to_owned)).collect()
}

/// Sees to it that `www/pkg` is what the sources say, with all the set-up that this needs.
pub fn build(steps: &mut Steps) -> Outcome {
    tools::wasm_target(steps)?;
    tools::wasm_bindgen(steps)?;
    node::packages(steps)?;
    rebuild(steps)
}

/// As [`build`], when the set-up is known to be done.
pub fn rebuild(steps: &mut Steps) -> Outcome {
    let stamp = target().join("xtask/wasm.stamp");
    let pkg = root().join("www/pkg");
    let text = inputs()?;
    if stamp::holds(&stamp, &text) && files().iter().all(|file| pkg.join(file).is_file()) {
        return Ok(());
    }
    steps.run("build the wasm modules", || {
        let made = make()?;
        fs::create_dir_all(&pkg)?;
        for file in files() {
            // Each is there in whole or not at all: a server may be reading.
            let part = pkg.join(format!("{file}.part"));
            fs::copy(made.join(&file), &part)?;
            fs::rename(part, pkg.join(&file))?;
        }
        package::write_manifest(&pkg)?;
        stamp::write(&stamp, &text)
    })
}

/// The hash of everything that the module is made from.
pub fn inputs() -> Outcome<String> {
    let mut hash = Hash::new(&[OPTIMISE]);
    for file in ["Cargo.toml", "Cargo.lock", "rust-toolchain.toml", ".cargo/config.toml", "package-lock.json"]
    {
        hash.path(&root().join(file))?;
    }
    for folder in sources()? {
        hash.path(&folder)?;
    }
    Ok(hash.text())
}

/// The folders that hold the module's sources: all crates but this one, without their tests.
fn sources() -> Outcome<Vec<PathBuf>> {
    let mut found = Vec::new();
    for folder in fs::read_dir(root().join("crate"))? {
        let folder = folder?.path();
        if folder.file_name().is_some_and(|name| name == "xtask") || !folder.is_dir() {
            continue;
        }
        for entry in fs::read_dir(&folder)? {
            let path = entry?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if !["tests", "benches", "examples", "pkg", "webdriver.json"].contains(&&*name) {
                found.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}

/// Builds into a folder of its own, which it returns. While one module is compiled, which takes one core at its end, those
/// before it are bound and made smaller.
fn make() -> Outcome<PathBuf> {
    let made = target().join("xtask/pkg");
    if made.exists() {
        fs::remove_dir_all(&made)?;
    }
    fs::create_dir_all(&made)?;
    thread::scope(|scope| -> Outcome {
        let mut finishing = Vec::new();
        for (name, feature) in MODULES {
            run(&mut cargo_wasm(&format!(
                "build --package frond-web --lib --release --target {WASM_TARGET} --no-default-features --features {feature}"
            )))?;
            // The next one is built in the same place.
            let raw = made.join(format!("{name}.raw.wasm"));
            fs::copy(target().join(WASM_TARGET).join("release/frond_web.wasm"), &raw)?;
            let made = &made;
            // An error of this kind does not go from thread to thread: its words do.
            finishing
                .push(scope.spawn(move || finish(name, &raw, made).map_err(|problem| problem.to_string())));
        }
        for one in finishing {
            one.join().map_err(|_| "a module could not be finished")??;
        }
        Ok(())
    })?;
    for script in SCRIPTS {
        fs::copy(root().join("crate/web/js").join(script), made.join(script))?;
    }
    Ok(made)
}

/// Bindings for what Cargo built, and the module itself as small as it gets.
fn finish(name: &str, raw: &Path, made: &Path) -> Outcome {
    run(tools::tool("wasm-bindgen")
        .arg(raw)
        .args(["--target", "web", "--out-name", name, "--out-dir"])
        .arg(made))?;
    fs::remove_file(raw)?;
    optimise(&made.join(format!("{name}_bg.wasm")))
}

fn optimise(module: &Path) -> Outcome {
    let small = module.with_extension("opt");
    run(Tool::WasmOpt.command(OPTIMISE).arg(module).arg("-o").arg(&small))?;
    Ok(fs::rename(small, module)?)
}
