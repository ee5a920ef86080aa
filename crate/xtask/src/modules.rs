//! The modules that crate/web is built into, and the files of each.

/// The name of the files and the feature that makes them. The first describes and draws, and is all that the first
/// picture needs; the second has closed curves and graphs, where the page shows some; the third decides and proves,
/// in the workers; the fourth traces and fits outlines, in workers of its own; the fifth is for space, where its
/// tool is open; the sixth reads and writes files of other programs, when one is opened or saved; the seventh has
/// shapes of several states, where some are shown; the eighth draws a morph on other people's pages; of the others,
/// which draw on a graphics card, a visitor gets one.
pub const MODULES: [(&str, &str); 10] = [
    ("frond", "compute"),
    ("frond-curve", "curve"),
    ("frond-proof", "proof"),
    ("frond-fit", "fit"),
    ("frond-space", "space"),
    ("frond-exchange", "exchange"),
    ("frond-directed", "directed"),
    ("frond-morph", "morph"),
    ("frond-webgpu", "webgpu"),
    ("frond-webgl2", "webgl2"),
];

/// Scripts of crate/web/js, which choose among the modules.
pub const SCRIPTS: [&str; 2] = ["renderer.js", "renderer.d.ts"];

/// The files of one module.
pub fn files_of(name: &str) -> [String; 4] {
    [format!("{name}.js"), format!("{name}.d.ts"), format!("{name}_bg.wasm"), format!("{name}_bg.wasm.d.ts")]
}

/// What the page imports.
pub fn files() -> Vec<String> {
    MODULES.iter().flat_map(|(name, _)| files_of(name)).chain(SCRIPTS.map(str::to_owned)).collect()
}
