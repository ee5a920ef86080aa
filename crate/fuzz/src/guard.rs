//! How long a document may take, and how much memory.

use std::fs;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Memory is counted for all threads at once: one document is tried at a time.
static ALONE: Mutex<()> = Mutex::new(());

const MOST_MEMORY: usize = 256 << 20;
const MOST_SECONDS: f64 = 1.0;

/// Does the work, and holds what it takes against the limits.
///
/// # Panics
/// Where it takes more than 256 MB beside what is there already, or twice more than a second of the processor.
pub fn within_limits(work: impl Fn()) {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    MEMORY.reset_peak_usage();
    let before = MEMORY.current_usage();
    let start = Instant::now();
    work();
    let taken = MEMORY.peak_usage().saturating_sub(before);
    assert!(taken <= MOST_MEMORY, "{taken} bytes of memory");
    // What it took by the clock on the wall says nothing while other programs run, and asking for the time of the
    // processor takes longer than most documents.
    if start.elapsed().as_secs_f64() <= MOST_SECONDS {
        return;
    }
    if let Some(start) = processor_seconds() {
        work();
        let seconds = processor_seconds().unwrap_or(start) - start;
        assert!(seconds <= MOST_SECONDS, "{seconds} seconds");
    }
}

/// Seconds of the processor that this thread has had, where the system tells them.
fn processor_seconds() -> Option<f64> {
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    told.split_whitespace().next()?.parse::<f64>().ok().map(|nanoseconds| nanoseconds * 1e-9)
}
