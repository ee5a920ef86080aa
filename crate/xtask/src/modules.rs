//! The modules that crate/web is built into, and the files of each.

/// The name of the files and the features that make them. The first describes, draws and bends: the package has it. The
/// page has these two apart: what describes and draws, all that the first picture needs, and what bends, where
/// something is bent. Then there are closed curves and graphs, where the page shows some; what decides and proves, in
/// the workers; what proves of exact numbers, where a shape has some; what traces and fits outlines, in workers of its
/// own, and there what reads drawings, tables and JSON, when one is opened; space, where its tool is open; what reads
/// and writes files of other programs, when one is opened or saved; shapes of several states, where some are shown; and
/// what draws a morph on other people's pages. Of the others, which draw on a graphics card, a visitor gets one.
pub const MODULES: [(&str, &str); 15] = [
    ("frond", "compute,bend"),
    ("frond-first", "compute"),
    ("frond-bend", "bend"),
    ("frond-curve", "curve"),
    ("frond-proof", "proof"),
    ("frond-exact", "exact"),
    ("frond-fit", "fit"),
    ("frond-svg", "svg"),
    ("frond-text", "text"),
    ("frond-space", "space"),
    ("frond-exchange", "exchange"),
    ("frond-directed", "directed"),
    ("frond-morph", "morph"),
    ("frond-webgpu", "webgpu"),
    ("frond-webgl2", "webgl2"),
];

/// Those that the package does without. Its command alone reads drawings and tables.
const PAGE_ALONE: [&str; 2] = ["frond-first", "frond-bend"];

/// Scripts of crate/web/js, which choose among the modules.
pub const SCRIPTS: [&str; 2] = ["renderer.js", "renderer.d.ts"];

/// The files of one module.
pub fn files_of(name: &str) -> [String; 4] {
    [format!("{name}.js"), format!("{name}.d.ts"), format!("{name}_bg.wasm"), format!("{name}_bg.wasm.d.ts")]
}

/// What the page imports.
pub fn files() -> Vec<String> {
    files_with(|_| true)
}

/// What the package brings.
pub fn packaged() -> Vec<String> {
    files_with(|name| !PAGE_ALONE.contains(&name))
}

fn files_with(wanted: impl Fn(&str) -> bool) -> Vec<String> {
    let modules = MODULES.iter().filter(|(name, _)| wanted(name)).flat_map(|(name, _)| files_of(name));
    modules.chain(SCRIPTS.map(str::to_owned)).collect()
}
