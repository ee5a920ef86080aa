//! The static site in dist/, and the package beside it.

use std::fs;

use crate::command::{Outcome, command, root, run};
use crate::node::Tool;
use crate::package;
use crate::stamp;
use crate::step::Steps;
use crate::wasm;

/// Builds both, with all the set-up that this needs.
pub fn build(steps: &mut Steps) -> Outcome {
    wasm::build(steps)?;
    steps.once("build the site", || {
        run(&mut Tool::Vite.command("build --logLevel warn"))?;
        run(&mut Tool::Vite.command("build --config www/build/element.config.ts --logLevel warn"))?;
        run(&mut Tool::Vite.command("build --config www/build/elsewhere/config.ts --logLevel warn"))?;
        run(&mut Tool::Vite.command("build --config www/build/api/config.ts --logLevel warn"))?;
        run(&mut Tool::Vite.command("build --config www/build/offline.config.ts --logLevel warn"))?;
        run(&mut Tool::Vite.command("build --config www/build/package.config.ts --logLevel warn"))?;
        run(&mut Tool::Vite.command("build --config www/build/view.config.ts --logLevel warn"))?;
        relative()?;
        package::write()
    })
}

/// Writes the files of the site packed beside them, for hosts that send those.
pub fn pack() -> Outcome {
    run(command("node").args(["www/build/packed.mjs", "dist"]))
}

/// Refuses a page that asks for something from the root of its host: it would not work from a sub-folder.
fn relative() -> Outcome {
    for file in stamp::files(&root().join("dist"))? {
        if file.extension().is_some_and(|extension| extension == "html") {
            let text = fs::read_to_string(&file)?;
            for start in ["src=\"/", "href=\"/"] {
                if text.contains(start) {
                    return Err(
                        format!("{} holds {start}..\": addresses must be relative", file.display()).into()
                    );
                }
            }
        }
    }
    Ok(())
}
