//! What a point stands on.

/// The entries of a table that tell what a point does, and what each counts; they sum to 1.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Footing {
    count: usize,
    entries: [u32; 9],
    shares: [f64; 9],
}

impl Footing {
    /// One entry alone.
    pub const fn of(entry: u32) -> Self {
        Self {
            count: 1,
            entries: [entry, 0, 0, 0, 0, 0, 0, 0, 0],
            shares: [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        }
    }

    /// One more; what counts nothing is passed over, and so is what there is no room for.
    #[inline]
    pub fn add(&mut self, entry: u32, share: f64) {
        if share != 0.0 && self.count < self.entries.len() {
            (self.entries[self.count], self.shares[self.count]) = (entry, share);
            self.count += 1;
        }
    }

    /// The entries and what they count.
    #[inline]
    pub fn iter(&self) -> impl Iterator<Item = (usize, f64)> {
        let entries = self.entries.iter().map(|&entry| entry as usize);
        entries.zip(self.shares).take(self.count)
    }
}
