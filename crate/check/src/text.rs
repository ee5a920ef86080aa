//! Certificates as JSON, which keeps every digit of a double.

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
