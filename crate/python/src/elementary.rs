//! Sine and its like, as the modules for browsers have them, so that answers are the same bit for bit.
//!
//! IEEE 754 says every bit of a sum or a root, but not of a sine: each system has its own, and they differ in the last
//! bit now and then. Rust calls them by the names of C. Defined here, these names mean the functions of the crate libm,
//! which Rust itself uses where there is no system, as in WebAssembly. `build.rs` sees to it that the names are bound
//! within this library, and nothing outside of it sees them.

macro_rules! of_one {
    ($($name:ident: $number:ty),* $(,)?) => {
        $(
            #[unsafe(no_mangle)]
            extern "C" fn $name(x: $number) -> $number {
                libm::$name(x)
            }
        )*
    };
}

macro_rules! of_two {
    ($($name:ident: $number:ty),* $(,)?) => {
        $(
            #[unsafe(no_mangle)]
            extern "C" fn $name(x: $number, y: $number) -> $number {
                libm::$name(x, y)
            }
        )*
    };
}

of_one!(
    acos: f64, acosf: f32, asin: f64, asinf: f32, atan: f64, atanf: f32, cbrt: f64, cbrtf: f32, cos: f64, cosf: f32,
    cosh: f64, coshf: f32, exp: f64, expf: f32, exp2: f64, exp2f: f32, expm1: f64, expm1f: f32, log: f64, logf: f32,
    log10: f64, log10f: f32, log1p: f64, log1pf: f32, log2: f64, log2f: f32, sin: f64, sinf: f32, sinh: f64, sinhf: f32,
    tan: f64, tanf: f32, tanh: f64, tanhf: f32,
);
of_two!(atan2: f64, atan2f: f32, hypot: f64, hypotf: f32, pow: f64, powf: f32);

/// Both of one angle, which the compiler may ask for where a program asks for each.
///
/// # Safety
/// As C has it: both pointers can be written to.
#[unsafe(no_mangle)]
unsafe extern "C" fn sincos(x: f64, sin: *mut f64, cos: *mut f64) {
    // SAFETY: the caller's word.
    unsafe {
        sin.write(libm::sin(x));
        cos.write(libm::cos(x));
    }
}

/// The same of single numbers.
///
/// # Safety
/// As C has it: both pointers can be written to.
#[unsafe(no_mangle)]
unsafe extern "C" fn sincosf(x: f32, sin: *mut f32, cos: *mut f32) {
    // SAFETY: the caller's word.
    unsafe {
        sin.write(libm::sinf(x));
        cos.write(libm::cosf(x));
    }
}
