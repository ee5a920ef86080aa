//! `cargo xtask`: everything that is done with this repository, each command with all the set-up that it needs.
//!
//! - [`command`] runs other programs; [`step`] names what runs, times it and counts it.
//! - [`tools`], [`node`] and [`browser`] see to it that what is needed is there.
//! - [`wasm`] and [`package`] make `www/pkg` of the [`modules`]; [`site`] makes `dist/`; [`size`] weighs it.
//! - [`circles`] keeps files from importing in circles: [`imports`] finds who imports what.
//! - [`folders`] keeps folders from being too full and comments from being too wide.
//! - [`python`] makes the wheel of the package for Python, and tries it.
//! - [`serve`], [`mod@test`] and [`mod@bench`] are the commands of those names.

mod bench;
mod browser;
mod circles;
mod command;
mod folders;
mod fuzz;
mod imports;
mod modules;
mod node;
mod package;
mod python;
mod serve;
mod site;
mod size;
mod stamp;
mod step;
mod test;
mod tools;
mod wasm;

use std::process::ExitCode;

use command::Outcome;
use step::Steps;

const HELP: &str = "\
Frond's tasks. Each sets up what it needs: only Rust (rustup) and Node 20.19 or later have to be there.

Usage: cargo xtask <command>

  serve [--port N] [--open | --no-open]
      Serve the studio on this machine and keep it up to date while sources change. A browser is opened
      where there is a screen. Without --port it is 5173, or the next port that is free.

  build
      Write the site into dist/: plain files that work from any folder of any static host, without
      special headers. FROND_SITE is the address that it will have, such as https://example.org/frond/: with it
      pages that are sent unfold with their picture, and there is a sitemap. Write the JavaScript API as a package into target/package/frond, too:
      `npm install path/to/target/package/frond`, then `import init, { attractor } from \"frond-ifs\"`.
      FROND_SITE becomes its `homepage`; FROND_REPOSITORY, such as https://github.com/name/frond, says where its
      sources and issues are.

  test [name ..] [-- test ..]
      Run every check but those that run only when named, or those whose group or step has one of these names:
TESTS
      After -- name the tests that shaders, vitest, webgl2, webgpu and phone are to run, e.g.
      `cargo xtask test webgl2 -- keys.spec.ts`.
      The end-to-end tests take FROND_CHROMIUM as the browser where it is set, and the tests of exact
      answers take FROND_KNOWN as the directory of the answers (default: tests/known).

  python
      Write the wheel of the package for Python into target/python: `pip install` takes it. Python 3.10 or later has to
      be there, which FROND_PYTHON may name; it is the one that `test` uses, too.

  bench [name ..]
      Measure: the benches of each crate, then the page in Chromium. Names choose some of them.

  setup
      Do only the set-up of everything above, e.g. before going off line.

  help
      Print this.
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (name, rest) = match arguments.split_first() {
        Some((name, rest)) => (name.as_str(), rest),
        None => ("help", &[][..]),
    };
    if matches!(name, "help" | "--help" | "-h") || rest.iter().any(|word| word == "--help" || word == "-h") {
        print!("{}", HELP.replace("TESTS\n", &test::list()));
        return ExitCode::SUCCESS;
    }
    let mut steps = Steps::default();
    let outcome = match name {
        "serve" => serve::serve(&mut steps, rest),
        "build" => build(&mut steps, rest),
        "test" => test::test(&mut steps, rest),
        "python" => python::build(&mut steps, rest),
        "bench" => bench::bench(&mut steps, rest),
        "setup" => setup(&mut steps, rest),
        other => Err(format!("there is no command `{other}`: `cargo xtask help` lists them").into()),
    };
    if let Err(problem) = &outcome {
        eprintln!("\n{problem}");
    }
    // Last, so that the line to look at is the last line.
    if name == "test" && steps.any() {
        steps.summary();
    }
    if outcome.is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn build(steps: &mut Steps, arguments: &[String]) -> Outcome {
    command::no_arguments("build", arguments)?;
    site::build(steps)?;
    steps.run("size", size::gate)?;
    steps.run("pack what hosts send", site::pack)?;
    println!("\nThe site is in dist/, the package in target/package/frond.");
    Ok(())
}

fn setup(steps: &mut Steps, arguments: &[String]) -> Outcome {
    command::no_arguments("setup", arguments)?;
    tools::wasm_target(steps)?;
    tools::components(steps)?;
    tools::wasm_bindgen(steps)?;
    node::packages(steps)?;
    browser::set_up(steps)
}
