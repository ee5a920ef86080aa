//! `frond-check certificate.json ..`: replays certificates that were saved. Without names it reads one from standard
//! input. The exit status is 0 if all are accepted.

use std::io::Read;
use std::process::ExitCode;

use frond_check::{CheckedProof, Proof};

fn main() -> ExitCode {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let mut sound = true;
    if names.is_empty() {
        let mut text = String::new();
        let read = std::io::stdin().read_to_string(&mut text).map(|_| text);
        sound &= report("standard input", read);
    }
    for name in &names {
        sound &= report(name, std::fs::read_to_string(name));
    }
    if sound { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn report(name: &str, text: std::io::Result<String>) -> bool {
    let answer = text.map_err(|error| error.to_string()).and_then(|text| {
        let proof = Proof::from_json(&text).map_err(|error| error.to_string())?;
        proof.check().map_err(|refused| refused.to_string())
    });
    match answer {
        Ok(CheckedProof::Disconnected(found)) => {
            println!(
                "{name}: accepted. The attractor is in several pieces: {} pairs of pieces are apart, of at most {} letters.",
                found.pairs, found.longest
            );
            true
        }
        Ok(CheckedProof::Connected(found)) => {
            println!(
                "{name}: accepted. The attractor is in one piece: {} links hold it together, of at most {} letters.",
                found.links, found.longest
            );
            true
        }
        Err(why) => {
            println!("{name}: refused. {why}");
            false
        }
    }
}
