//! Shaders as each interface takes them: for WebGPU their text without comments, which are a part of what a visitor
//! downloads; for WebGL2 what they are in its own language, so that nothing has to be translated there.

use std::env::var_os;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// What is compiled together, by the names that the engine has for it, and the files of each.
const MODULES: [(&str, &[&str]); 6] = [
    ("POINTS", &["colour", "points"]),
    ("RESOLVE", &["colour", "tone", "screen", "resolve"]),
    ("SHEET", &["sheet"]),
    ("SPACE_POINTS", &["solid/kept", "solid/points"]),
    ("SPACE_SPLAT", &["screen", "solid/kept", "solid/splat"]),
    ("SPACE_LIGHT", &["colour", "screen", "solid/kept", "solid/shade", "solid/hole_fill"]),
];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=shader");
    let to = PathBuf::from(var_os("OUT_DIR").unwrap_or_default());
    fs::write(to.join("locus.wgsl"), plain("locus")?)?;
    let mut webgpu = format!("pub const SPLAT: Shader = Shader({:?});\n", plain("splat")?);
    let mut webgl2 = String::new();
    for (name, files) in MODULES {
        let text = files.iter().map(|file| plain(file)).collect::<Result<String, _>>()?;
        webgpu += &format!("pub const {name}: Shader = Shader({text:?});\n");
        #[cfg(feature = "webgl2")]
        if std::env::var("CARGO_CFG_TARGET_ARCH").is_ok_and(|arch| arch == "wasm32") {
            let stages = glsl::stages(&text).map_err(|problem| format!("{name}: {problem}"))?;
            webgl2 += &format!("pub const {name}: Shader = Shader(&[{stages}]);\n");
        }
    }
    fs::write(to.join("webgpu.rs"), webgpu)?;
    Ok(fs::write(to.join("webgl2.rs"), std::mem::take(&mut webgl2))?)
}

/// Spaces of WGSL that tell nothing apart, and what stands for them; those at a minus do, in `a - -b`.
const SPACED: [[&str; 2]; 6] =
    [[", ", ","], [": ", ":"], [" = ", "="], [" + ", "+"], [" * ", "*"], [" {", "{"]];

/// A file of WGSL without comments and without white space that is of no use. Lines keep their numbers.
fn plain(name: &str) -> std::io::Result<String> {
    let text = fs::read_to_string(Path::new("shader").join(name).with_extension("wgsl"))?;
    // WGSL has no strings, so that this is always a comment.
    Ok(text
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default().trim().to_owned() + "\n")
        .map(|line| SPACED.iter().fold(line, |line, [spaced, plain]| line.replace(spaced, plain)))
        .collect())
}

/// The language of WebGL2.
#[cfg(feature = "webgl2")]
mod glsl {
    use std::error::Error;

    use naga::back::glsl::{Options, PipelineOptions, Version, Writer, WriterFlags};
    use naga::compact::{KeepUnused, compact};
    use naga::proc::BoundsCheckPolicies;
    use naga::valid::{Capabilities, ValidationFlags, Validator};
    use naga::{EntryPoint, GlobalVariable, Handle, Module};

    /// The entry points of a module, each as a program of its own.
    pub fn stages(wgsl: &str) -> Result<String, Box<dyn Error>> {
        let whole = naga::front::wgsl::parse_str(wgsl).map_err(|problem| problem.emit_to_string(wgsl))?;
        whole.entry_points.iter().map(|entry| stage(&whole, entry)).collect()
    }

    /// Its name, its text, and for each block of numbers and each texture what it is called there and which binding it
    /// has here.
    fn stage(whole: &Module, entry: &EntryPoint) -> Result<String, Box<dyn Error>> {
        let mut module = whole.clone();
        module.entry_points.retain(|other| other.name == entry.name);
        compact(&mut module, KeepUnused::No);
        let info = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module)?;
        let options = Options {
            version: Version::Embedded { version: 300, is_webgl: true },
            // The first row on top, depths from 0 to 1, as in WebGPU; and points of one pixel.
            writer_flags: WriterFlags::ADJUST_COORDINATE_SPACE | WriterFlags::FORCE_POINT_SIZE,
            ..Options::default()
        };
        let name = &entry.name;
        let pipeline =
            PipelineOptions { shader_stage: entry.stage, entry_point: name.clone(), multiview: None };
        let (mut text, policies) = (String::new(), BoundsCheckPolicies::default());
        let seen = Writer::new(&mut text, &module, &info, &options, &pipeline, policies)?.write()?;
        let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
        let text: String = lines.map(|line| line.to_owned() + "\n").collect();
        let binding_of = |variable: Handle<GlobalVariable>| {
            module.global_variables[variable].binding.map_or(0, |place| place.binding)
        };
        let mut blocks: Vec<_> =
            seen.uniforms.iter().map(|(variable, name)| (name, binding_of(*variable))).collect();
        let mut textures: Vec<_> =
            seen.texture_mapping.iter().map(|(name, mapping)| (name, binding_of(mapping.texture))).collect();
        // The same each time, whatever the order of a map.
        blocks.sort();
        textures.sort();
        Ok(format!(
            "Stage {{ name: {name:?}, text: {text:?}, blocks: &{blocks:?}, textures: &{textures:?} }},\n"
        ))
    }
}
