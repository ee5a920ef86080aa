//! What a device tells on its own.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Something that happened to a device without being asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// The device is lost: nothing can be drawn on it any more.
    Lost(String),
    /// A call was in error, which is a fault of this program.
    Fault(String),
}

type Listener = Rc<dyn Fn(&Event)>;

thread_local! {
    /// Callbacks of a device must be `Send`, which nothing of JavaScript is: they hold a number, and what
    /// it stands for is here. wgpu calls them on the thread that made them.
    static LISTENERS: RefCell<HashMap<u32, Listener>> = RefCell::default();
    static NEXT: RefCell<u32> = const { RefCell::new(0) };
}

/// Hears what happens to one device for as long as it lives.
#[derive(Debug)]
pub(super) struct Events {
    id: u32,
    lost: Arc<AtomicBool>,
}

impl Events {
    /// Calls `listener` for each event: for a loss once.
    pub fn new(listener: Listener) -> Self {
        let id = NEXT.with_borrow_mut(|next| {
            *next += 1;
            *next
        });
        LISTENERS.with_borrow_mut(|all| all.insert(id, listener));
        Self { id, lost: Arc::new(AtomicBool::new(false)) }
    }

    /// Whether the device is lost.
    pub fn is_lost(&self) -> bool {
        self.lost.load(Ordering::Relaxed)
    }

    /// Tells that the device was seen to be lost by other means.
    pub fn loss(&self) -> Loss {
        Loss { id: self.id, lost: Arc::clone(&self.lost) }
    }
}

/// A way to tell what happens to a device: the page sees some of it, as when the context of WebGL goes.
#[derive(Clone, Debug)]
pub struct Loss {
    id: u32,
    lost: Arc<AtomicBool>,
}

impl Loss {
    /// Tells it; only the first time counts.
    pub fn tell(&self, reason: &str) {
        tell_loss(self.id, &self.lost, reason.to_owned());
    }

    /// Tells of a call that was in error. What fails after a loss fails because of it.
    pub(super) fn fault(&self, message: &str) {
        if !self.is_lost() {
            tell(self.id, &Event::Fault(message.to_owned()));
        }
    }

    /// Whether the device is lost.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.lost.load(Ordering::Relaxed)
    }
}

impl Drop for Events {
    fn drop(&mut self) {
        // A device that is no longer wanted is not lost.
        let _ = LISTENERS.try_with(|all| all.borrow_mut().remove(&self.id));
    }
}

fn tell_loss(id: u32, lost: &AtomicBool, reason: String) {
    if !lost.swap(true, Ordering::Relaxed) {
        tell(id, &Event::Lost(reason));
    }
}

fn tell(id: u32, event: &Event) {
    // The listener may drop the device, and with it its entry here.
    let listener = LISTENERS.with_borrow(|all| all.get(&id).cloned());
    if let Some(listener) = listener {
        listener(event);
    }
}
