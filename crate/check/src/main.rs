//! `frond-check certificate.json ..`: replays certificates that were saved. Without names it reads one from standard
//! input. The exit status is 0 if all are accepted.

use std::fs::File;
use std::io::{Error, ErrorKind, Read};
use std::process::ExitCode;

use frond_check::{CheckedProof, Proof};

fn main() -> ExitCode {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let mut sound = true;
    if names.is_empty() {
        sound &= report("standard input", read(std::io::stdin()));
    }
    for name in &names {
        sound &= report(name, File::open(name).and_then(read));
    }
    if sound { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// More than the largest certificate that is checked can have, without blanks.
const MOST_MIB: u64 = 128;

/// What there is, if that has an end.
fn read(from: impl Read) -> Result<String, Error> {
    let mut text = String::new();
    from.take((MOST_MIB << 20) + 1).read_to_string(&mut text)?;
    if text.len() as u64 > MOST_MIB << 20 {
        let why = format!("The file is too large: at most {MOST_MIB} MiB are read of a certificate.");
        return Err(Error::new(ErrorKind::FileTooLarge, why));
    }
    Ok(text)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_end_is_refused() {
        assert_eq!(read(&b"{}"[..]).unwrap(), "{}");
        let why = read(std::io::repeat(b' ')).unwrap_err();
        assert_eq!(why.to_string(), "The file is too large: at most 128 MiB are read of a certificate.");
        assert!(read(&b"\xff"[..]).is_err());
    }
}
