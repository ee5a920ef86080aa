//! All readers.

mod png;

pub use png::PNG;

/// Hands the names of all readers to a macro, which makes a test of each.
#[macro_export]
macro_rules! all_readers {
    ($tests:ident) => {
        $tests! {
            png: PNG
        }
    };
}
