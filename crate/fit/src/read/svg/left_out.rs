//! What of a drawing is not looked at, and how that is told.

use super::super::problem::Remark;

/// What was met in a drawing and is not an outline, each once, as the reader is told of it.
#[derive(Default)]
pub struct LeftOut(Vec<&'static str>);

impl LeftOut {
    pub fn add(&mut self, what: &'static str) {
        if !self.0.contains(&what) {
            self.0.push(what);
        }
    }

    pub fn remark(&self) -> Option<Remark> {
        let message = || format!("Not looked at: {}.", self.0.join(", "));
        (!self.0.is_empty()).then(|| Remark::new("ignored", message()))
    }
}
