//! Certificates as JSON.
//!
//! A number is written with as many digits as tell it from all other doubles, and read as the double nearest to what is
//! written: what is replayed is what the text says. That takes `float_roundtrip` of `serde_json`.

use serde::Deserialize;
use serde::de::IgnoredAny;

use crate::certificate::Certificate;
use crate::connected::ConnectedCertificate;
use crate::proof::Proof;

impl Certificate {
    /// Reads the form that [`Certificate::to_json`] writes, and that the page saves.
    ///
    /// # Errors
    /// What is wrong with the text, and where.
    pub fn from_json(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(text)
    }

    /// An object with the names of the fields.
    ///
    /// # Errors
    /// None, for finite numbers.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string(self)
    }
}

impl ConnectedCertificate {
    /// An object with the names of the fields.
    ///
    /// # Errors
    /// None, for finite numbers.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string(self)
    }
}

impl Proof {
    /// Reads a certificate of either kind: one with links says that the attractor is in one piece.
    ///
    /// # Errors
    /// What is wrong with the text, and where.
    pub fn from_json(text: &str) -> Result<Self, serde_json::Error> {
        #[derive(Deserialize)]
        struct Kind {
            links: Option<IgnoredAny>,
        }
        match serde_json::from_str::<Kind>(text)?.links {
            Some(_) => serde_json::from_str(text).map(Self::Connected),
            None => serde_json::from_str(text).map(Self::Disconnected),
        }
    }
}
