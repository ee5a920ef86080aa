//! Certificates.

use frond_check::Proof;

use crate::reader::Reader;

/// Certificates of both kinds.
pub const CERTIFICATE: Reader = Reader {
    name: "certificate",
    read,
    words: &[
        "\"maps\":[[0.5,0,0,0.5,0,0]]",
        "\"polygon\":[[0,0],[1,0],[0,1]]",
        "\"letters\":1",
        "\"side\":[0,1]",
        "\"pairs\":[]",
        "{\"u\":[0],\"v\":[1],\"normal\":[1,0]}",
        "\"gap\":0.5",
        "\"near\":[[[0],[1]]]",
        "\"links\":[]",
        "{\"kind\":\"point\",\"addresses\":[{\"head\":[0],\"repeat\":[1]},{\"head\":[1],\"repeat\":[0]}]}",
        "{\"kind\":\"area\",\"pair\":[0,1]}",
        "{\"kind\":\"difference\",\"pair\":[0,1],\"steps\":[[0,1]]}",
        "\"squares\":{\"size\":[1,1],\"cells\":[[0,0,0,1]]}",
        "null",
        "[",
        "]",
        "{",
        "}",
        ",",
        "255",
    ],
};

/// The longest document that is replayed: a certificate may take what its own bound of work allows, twenty seconds.
const LONGEST: usize = 4000;

fn read(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    let Ok(proof) = Proof::from_json(text) else { return };
    let written = match &proof {
        Proof::Disconnected(certificate) => certificate.to_json(),
        Proof::Connected(certificate) => certificate.to_json(),
        _ => return,
    };
    let again = Proof::from_json(&written.expect("finite numbers")).expect("what was written");
    assert_eq!(again, proof);
    if text.len() <= LONGEST {
        let checked = proof.check();
        assert_eq!(again.check(), checked);
        if let Err(refused) = checked {
            assert!(refused.to_string().len() < 700, "{refused}");
        }
    }
}
