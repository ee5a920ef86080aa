//! Waiting for the graphics card, in tests and benches.

use std::future::Future;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

/// Natively a run waits for the card by itself, so that its future is ready when it is asked.
pub fn wait<F: Future>(future: F) -> F::Output {
    let mut future = pin!(future);
    let mut context = Context::from_waker(Waker::noop());
    loop {
        if let Poll::Ready(output) = future.as_mut().poll(&mut context) {
            return output;
        }
        std::thread::yield_now();
    }
}
