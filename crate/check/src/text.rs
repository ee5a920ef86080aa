//! Certificates as JSON.
//!
//! A number is written with as many digits as tell it from all other doubles, and read as the double nearest to what is
//! written: what is replayed is what the text says. That takes `float_roundtrip` of `serde_json`.

use crate::certificate::Certificate;

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
