//! A second opinion: replays a proof that the attractor of affine maps is in several pieces.
//!
//! It shares no code and no types with what finds such proofs, computes with whole numbers of any length
//! instead of floating point, and knows nothing of searching. Doubles are whole multiples of a power of two, so
//! that nothing is rounded anywhere. Only multiplications, additions and comparisons are used.
//!
//! # What a [`Certificate`] proves
//!
//! 1. *There is an attractor `A`, and it lies in `P`.* `P` is a convex polygon with an inside, and every word `u` of
//!    `letters` letters maps it into its own inside: `w_u(P)` is in `int P`. Let `D = P - P`, a symmetric convex body,
//!    and so the unit ball of a norm. For the linear part, `M_u D = M_u P - M_u P` lies in `int P - int P`, that is in
//!    `int D`, so that each of these finitely many words contracts in that norm. Therefore they have an attractor
//!    (Hutchinson 1981), which is that of the maps themselves, and which is in every compact set that they map into
//!    itself: in `P`.
//! 2. *Pieces are apart.* The piece `A_u = w_u(A)` of a word lies in `w_u(P)`. For each pair of words `(u, v)` of the
//!    certificate and its direction `n`, the greatest `n . x` over `w_u(P)` is less than the least over `w_v(P)`, so
//!    that `A_u` and `A_v` have no point in common.
//! 3. *Nothing was left out.* `side` parts the maps in two, neither part empty. `A_u` is the union of its parts `A_ui`,
//!    over all letters `i`. Beginning with each pair of letters `(i, j)` across the cut, and replacing one word of a
//!    pair by all its parts again and again, one arrives at pairs of the certificate. So `A_i` and `A_j` have no point
//!    in common.
//! 4. Hence `A` is the union of two compact sets that are not empty and do not meet: it is not connected.
//!
//! Each of these is checked by [`check`], in this order.
//!
//! ```
//! use frond_check::{Certificate, Pair, check};
//!
//! // Cantor's dust, more or less, in a box that is a little too large for it.
//! let third = 1.0 / 3.0;
//! let certificate = Certificate {
//!     maps: vec![[third, 0.0, 0.0, third, 0.0, 0.0], [third, 0.0, 0.0, third, 2.0 * third, 0.0]],
//!     polygon: vec![[-0.1, -0.1], [1.1, -0.1], [1.1, 0.1], [-0.1, 0.1]],
//!     letters: 1,
//!     side: vec![0, 1],
//!     pairs: vec![Pair { u: vec![0], v: vec![1], normal: [1.0, 0.0] }],
//! };
//! assert_eq!(check(&certificate).unwrap().pairs, 1);
//! ```

mod certificate;
mod cover;
mod polygon;
mod refused;
mod replay;
#[cfg(feature = "text")]
mod text;
mod whole;

pub use certificate::{Certificate, Pair};
pub use refused::Refused;
pub use replay::{Checked, check};
