//! From the Rust crates to `www/pkg`, which the page imports: Cargo, wasm-bindgen, wasm-opt.

use std::fs;
use std::path::{Path, PathBuf};
use std::thread;

use crate::command::{Outcome, ask, cargo_wasm, root, run, target};
use crate::modules::{MODULES, SCRIPTS, files, files_of};
use crate::node::{self, Tool};
use crate::package;
use crate::stamp::{self, Hash};
use crate::step::Steps;
use crate::tools::{self, WASM_TARGET};

/// How a module is made smaller: without drawing functions into each other, which LLVM has done, takes half of the time
/// and changes no size worth speaking of. Twice, since the second time finds 0.2% more. Nothing lies in the first 1024
/// bytes but the last kilobyte of the stack (the linker puts it below all data), so that an offset can go into the
/// instruction that reads: where the sum would wrap, it traps. Then what the module may use: the names of
/// .cargo/config.toml's features, as wasm-opt has them, with those that Rust turns on by itself.
const OPTIMISE: &str = "--low-memory-unused -O3 -O3 --skip-pass=inlining-optimizing --strip-producers \
    --strip-target-features --enable-simd --enable-bulk-memory --enable-bulk-memory-opt --enable-nontrapping-float-to-int \
    --enable-sign-ext --enable-mutable-globals --enable-reference-types --enable-multivalue \
    --enable-call-indirect-overlong";

/// Makes frond-fit as small as other people's libraries, with what it brings of their code.
const SMALL: &str = "--config profile.release.package.frond-fit.opt-level=\"z\"";

/// Makes frond-core small where it only prepares pictures, whose inner loops are in frond-render.
const SMALL_CORE: &str = "--config profile.release.package.frond-core.opt-level=\"s\"";

/// The same, frond-locus where it only prepares what the card decides, and frond-deform where it prepares what the card
/// bends.
const SMALL_AROUND: &str = "--config profile.release.package.frond-core.opt-level=\"s\" \
    --config profile.release.package.frond-locus.opt-level=\"s\" \
    --config profile.release.package.frond-deform.opt-level=\"s\"";

/// What lies in a crate's folder and is no part of a module.
const NO_SOURCES: [&str; 5] = ["tests", "benches", "examples", "pkg", "webdriver.json"];

/// Sees to it that `www/pkg` is what the sources say, with all the set-up that this needs.
pub fn build(steps: &mut Steps) -> Outcome {
    tools::wasm_target(steps)?;
    tools::wasm_bindgen(steps)?;
    node::packages(steps)?;
    rebuild(steps)
}

/// As [`build`], when the set-up is known to be done. A module whose crates are as they were is left alone.
pub fn rebuild(steps: &mut Steps) -> Outcome {
    let pkg = root().join("www/pkg");
    let mut stale = Vec::new();
    // Asking Cargo which crates a module is made of takes a moment each: not where nothing has changed at all.
    let (stamp, text) = (stamp_of("wasm"), inputs()?);
    if !stamp::holds(&stamp, &text) || !files().iter().all(|file| pkg.join(file).is_file()) {
        for (name, features) in MODULES {
            let text = hash(&crates(features)?)?;
            let there = files_of(name).iter().all(|file| pkg.join(file).is_file());
            if !there || !stamp::holds(&stamp_of(name), &text) {
                stale.push(Stale { name, features, text });
            }
        }
    }
    if !stale.is_empty() {
        let names: Vec<&str> = stale.iter().map(|module| module.name).collect();
        steps.run(&format!("build the wasm modules ({})", names.join(", ")), || make(&stale, &pkg))?;
    }
    for script in SCRIPTS {
        stamp::write_changed(
            &pkg.join(script),
            &fs::read_to_string(root().join("crate/web/js").join(script))?,
        )?;
    }
    package::write_manifest(&pkg)?;
    stamp::write_changed(&stamp, &text)
}

/// A module that has to be built, and the hash of what it will be built from.
struct Stale {
    name: &'static str,
    features: &'static str,
    text: String,
}

fn stamp_of(name: &str) -> PathBuf {
    target().join(format!("xtask/{name}.stamp"))
}

/// The hash of everything that the modules are made from.
pub fn inputs() -> Outcome<String> {
    let mut all = Vec::new();
    for folder in fs::read_dir(root().join("crate"))? {
        let folder = folder?.path();
        if !["python", "testing", "xtask"].map(|name| folder.ends_with(name)).contains(&true) {
            all.push(folder);
        }
    }
    all.sort();
    hash(&all)
}

/// The folders of the crates that a module is made of, itself among them.
fn crates(features: &str) -> Outcome<Vec<PathBuf>> {
    let line = format!(
        "tree --package frond-web --no-default-features --features {features} --target {WASM_TARGET} \
         --edges normal,build --prefix none --format {{p}}"
    );
    let text =
        ask(&mut cargo_wasm(&line)).ok_or("`cargo tree` cannot say what the wasm modules are made of")?;
    // The crates of this repository are those with a folder: `frond-core v0.1.0 (/home/me/frond/crate/core)`.
    let folders =
        text.lines().filter_map(|line| line.split_once(" (")?.1.split_once(')').map(|(folder, _)| folder));
    let mut found: Vec<PathBuf> = folders.map(PathBuf::from).filter(|folder| folder.is_dir()).collect();
    found.sort();
    found.dedup();
    if found.is_empty() { Err("`cargo tree` names no crate of this repository".into()) } else { Ok(found) }
}

/// The hash of the settings and of the sources in these folders, without tests.
fn hash(folders: &[PathBuf]) -> Outcome<String> {
    let mut hash = Hash::new(&[OPTIMISE, SMALL, SMALL_CORE, SMALL_AROUND]);
    for file in ["Cargo.toml", "Cargo.lock", "rust-toolchain.toml", ".cargo/config.toml", "package-lock.json"]
    {
        hash.path(&root().join(file))?;
    }
    for folder in folders {
        let mut entries =
            fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Outcome<Vec<_>>>()?;
        entries.sort();
        for path in entries {
            if !NO_SOURCES.iter().any(|name| path.ends_with(name)) {
                hash.path(&path)?;
            }
        }
    }
    Ok(hash.text())
}

/// Builds modules into `pkg`. While one is compiled, which takes one core at its end, the one before it is bound and
/// made smaller. The last, which draw on a graphics card, are made first: they are the largest, and nothing waits for
/// them then.
fn make(modules: &[Stale], pkg: &Path) -> Outcome {
    let made = target().join("xtask/pkg");
    fs::create_dir_all(&made)?;
    fs::create_dir_all(pkg)?;
    thread::scope(|scope| -> Outcome {
        let mut finishing = Vec::new();
        for module in modules.iter().rev() {
            let (name, features) = (module.name, module.features);
            let small = match name {
                // What reads files runs once for each, and no frame waits for it.
                "frond-svg" | "frond-text" => SMALL,
                // The first picture waits for its download.
                "frond-first" => SMALL_CORE,
                "frond-webgpu" => SMALL_AROUND,
                _ => "",
            };
            run(&mut cargo_wasm(&format!(
                "build --package frond-web --lib --release --target {WASM_TARGET} --no-default-features --features {features} {small}"
            )))?;
            // The next one is built in the same place.
            let raw = made.join(format!("{name}.raw.wasm"));
            fs::copy(target().join(WASM_TARGET).join("release/frond_web.wasm"), &raw)?;
            let made = &made;
            // An error of this kind does not go from thread to thread: its words do.
            finishing
                .push((module, scope.spawn(move || finish(name, &raw, made).map_err(|e| e.to_string()))));
        }
        for (module, finished) in finishing {
            finished.join().map_err(|_| "a module could not be finished")??;
            for file in files_of(module.name) {
                // Each is there in whole or not at all: a server may be reading.
                let part = pkg.join(format!("{file}.part"));
                fs::copy(made.join(&file), &part)?;
                fs::rename(part, pkg.join(&file))?;
            }
            stamp::write(&stamp_of(module.name), &module.text)?;
        }
        Ok(())
    })
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
