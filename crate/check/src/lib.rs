//! A second opinion: replays a proof that the attractor of affine maps is in several pieces, or in one.
//!
//! It shares no code and no types with what finds such proofs, computes with whole numbers of any length
//! instead of floating point, and knows nothing of searching. Doubles are whole multiples of a power of two, so
//! that nothing is rounded anywhere. Only multiplications, additions and comparisons are used, and of squares whole
//! quotients.
//!
#![doc = include_str!("../picture.svg")]
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
//! # What a [`ConnectedCertificate`] proves
//!
//! 1. *There is an attractor `A`, and it lies in `P`*, as above, where here each map takes `P` into its inside. So all
//!    maps contract in the norm with the unit ball `D = P - P`, and any two points of `A` are at a distance of at
//!    most 1.
//! 2. *No gap is wider than `gap`.* Let g be the longest edge of the minimum spanning tree of the distances between
//!    the pieces `A_i`. For each pair of words `(a, b)` of `near`, no point of `w_a(P)` is farther from one of
//!    `w_b(P)` than `gap`, and these pairs reach all maps. So `g <= gap`.
//! 3. *Links hold.* A point with two addresses is in both of its pieces. Two pieces whose maps scale areas by factors
//!    with a sum of 1 or more meet: else a small enough neighbourhood of `A` would hold two disjoint images of itself
//!    and more. Copies of one shape and direction, see below, meet just if `L^-1 (t_j - t_i)` is a difference of two
//!    points of `A`. And two pieces `A_u`, `A_v` that lie across each other are nearer to each other than g, if g is
//!    not 0:
//!    - `A` is connected in steps of g: for words so long that their pieces are smaller than that, any two points
//!      of one piece are such a step apart, and the parts of the piece of a shorter word hang together by steps of
//!      those of `A`, made smaller. So `A_u` is connected by steps in `g M_u D`, and `Q_u`, the sum of `A_u`
//!      and `(g/2) M_u D`, by paths; and likewise `Q_v`.
//!    - Each of two parts of `A_u` is farther along its direction d than all of `w_v(P) + (gap/2) M_v D`, so that a
//!      ray along d from a point of it does not meet `Q_v`; and likewise for two parts of `A_v`, and `Q_u`.
//!    - No ray of the one piece meets one of the other: let `p + a d = q + b e` with `a, b >= 0`. Since `d . p > d . q`
//!      and `e . q > e . p`, times d it says that `b (d . e) > a |d|^2`, times e that `a (d . e) > b |e|^2`. So a,
//!      b and `d . e` are positive, and `(d . e)^2 > |d|^2 |e|^2`, which is never.
//!    - The directions alternate. So two paths, each along a ray, through `Q_u` or `Q_v` and out along the other ray,
//!      join alternating points of a large circle within it, and meet: `Q_u` and `Q_v` have a common point. Hence a
//!      point of `A_u` and one of `A_v` differ by a vector of `(g/2) (M_u D + M_v D)`, which is in the inside of
//!      `g D`.
//! 4. *Links reach every piece.* Were g not 0, all links would be shorter than g, and so the spanning tree: a
//!    contradiction. So all pieces hang together by pieces that meet, and `A` is connected (Hata 1985).
//!
//! *On a line.* Where two points of `A` differ, and every map takes the line through them into itself, `A` lies on this
//! line: it is in every closed set that the maps take into itself. Let a link say that a point of `A_j` lies between
//! two points of `A_i`, or is one of them. `A_i` is connected in steps of g, made smaller as `w_i` does (see above). So
//! this point is within half such a step of `A_i`, and the two pieces are nearer to each other than g, if g is not 0.
//!
//! *Differences.* Let all maps be `w_i(x) = L x + t_i`, and `D'` be the set of all differences `a - b` of two points
//! of `A`. `L a + t_i = L b + t_j` says that `a - b = L^-1 (t_j - t_i)`: the pieces `A_i` and `A_j` meet just if that
//! is in `D'`. Let K be the union of `squares`, each of which `x -> L^-1 (x - d)` takes into K, where d is a difference
//! of two translations. From x in K go back like this to `x_1, x_2, ..`, all in K. Then `x = d_1 + L d_2 + .. +
//! L^(n-1) d_n + L^n x_n`; the last term vanishes as n grows, and sums of `L^(n-1) t_k` are the points of `A`: so x is
//! in `D'`. And what one such step leads back from into `D'` is in `D'` itself.
//!
//! The crossing is a form of the *trap* of Calegari, Koch and Walker (arXiv 1410.8542). All this is checked by
//! [`check_connected`], in this order.
//!
//! # What a certificate with `exact` numbers proves
//!
//! A double stands for each entry of the maps, but [`Exact`] says which number it is meant to be: a sum of powers of
//! one root of a polynomial p, with fractions before them. All that is proved is proved of the maps `w_i` of these
//! numbers. Let `v_i` be those of the doubles.
//!
//! 1. *There is one such root.* p has different signs at the ends of an interval, so that it has a root between them;
//!    its derivative, computed for all numbers of the interval at once, is not 0 there, so that it has but one. Where
//!    an exact number is compared, the interval is first halved 256 times, so that the root stays in it.
//! 2. *What is drawn is what is proved.* Each exact number is within one unit in the last place of its double. A double
//!    of 0 stands for 0 alone.
//! 3. *Strict inequalities hold of all maps within these units.* Each says that `w_u(P)` is less far in a direction n
//!    than something else. How far it is, is bounded from above: by how far `v_u(P)` is, and for each letter by how far
//!    `w_i(x)` can be from `v_i(x)`, along what the letters before it make of n. For a word `u = i u'`,
//!    `w_u - v_u = (w_i - v_i) w_u' + V_i (w_u' - v_u')`, with `V_i` the linear part of `v_i`; and `w_u'(P)` lies in a
//!    box that holds P and its images under words of fewer than `letters` letters. Where `u'` is longer, its last
//!    `letters` letters take P into itself and may be left out: that is what was checked first, for which no box of
//!    longer words was needed. Widths of P itself do not depend on maps.
//! 4. *Equalities hold in a ring.* With h the highest coefficient of p, its degree d and `y = h x`, entries are
//!    fractions before powers of y, which is a root of q, with the highest coefficient 1. To put the root in for y is a
//!    homomorphism from `Q[y] / (q)` to the real numbers: sums, differences and products of equal classes are equal
//!    numbers. So equations that hold of classes hold of numbers, whether or not p has factors. That classes differ
//!    says nothing, and nothing is concluded from it: where a number must be positive, or not 0, an interval around it
//!    says so.
//!    - A point with two addresses is compared by Cramer's rule, multiplied across. What both are over is not 0, as a
//!      number: it is `|1 - M|` of a linear part M that contracts, whose eigenvalues are less than 1 in magnitude. The
//!      product of `1 - l` over both of these is even positive.
//!    - Areas are added up by their signs. That they reach 1 exactly is that the class of the difference is 0; else its
//!      sign is that of an interval.
//!    - On a line, that images stay there is an equality; that one point lies between others is a sign or one.
//!
//!    Links by differences of points are not checked of exact numbers.
//!
//! # How long it takes
//!
//! Lists and words have greatest lengths. Numbers grow with each letter of a word, so that a check counts its work in
//! multiplications of machine words. It sums what all claims take at the most before it computes anything, and refuses
//! a certificate that takes more than 20,000,000,000, some twenty seconds. It counts again as the work is done, where
//! long numbers are multiplied, so that no claim is left out. Of exact numbers the polynomial has a degree of at most
//! 16, a fraction 1,000 characters, and all of them 200,000: what it takes to read them is known from how long they
//! are. A tree of sums (Fenwick 1994) counts squares: n of them take n log n steps, however far each leads.
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
//!     exact: None,
//! };
//! assert_eq!(check(&certificate).unwrap().pairs, 1);
//! ```

mod certificate;
mod common_point;
mod connected;
mod cover;
mod crossing;
mod difference;
mod exact;
mod field;
mod joined;
mod limits;
mod line;
mod polygon;
mod proof;
mod refused;
mod replay;
#[cfg(feature = "text")]
mod text;
mod whole;
mod work;

pub use certificate::{Certificate, Pair};
pub use connected::{Address, ConnectedCertificate, Far, Link, Squares};
pub use exact::{Exact, ExactEntry};
pub use joined::{CheckedConnected, check_connected};
pub use proof::{CheckedProof, Proof};
pub use refused::Refused;
pub use replay::{Checked, check};

/// Runs the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
