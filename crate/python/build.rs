//! How the library is linked.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    // What src/elementary.rs defines is meant in here, whatever else of these names a program has loaded before.
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "linux") {
        println!("cargo:rustc-link-arg-cdylib=-Wl,-Bsymbolic");
    }
}
