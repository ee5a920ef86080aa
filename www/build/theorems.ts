/**
 * "What the proofs rest on": the theorems behind every "In one piece, proved", each with its proof. The sections are
 * named as the reasons of the programming interface are.
 */

interface Theorem {
  /** The kinds of reasons that rest on it; the first names its section. */
  kinds: readonly string[];
  title: string;
  /** Markup. */
  text: string;
}

const i = (letters: string) => `<i>${letters}</i>`;
const piece = (letter: string) => `<i>A<sub>${letter}</sub></i>`;
const map = (letter: string) => `<i>f<sub>${letter}</sub></i>`;

const INTRODUCTION = `
      <p>Throughout, ${map("1")}, …, ${map("N")} are affine maps of the plane that contract in one norm: there is an
      ${i("s")} &lt; 1 with |${map("k")}(x) − ${map("k")}(y)| ≤ ${i("s")} |x − y| for all of them. Their attractor ${i("A")}
      is the one non-empty compact set with ${i("A")} = ${map("1")}(${i("A")}) ∪ … ∪ ${map("N")}(${i("A")}) (Hutchinson 1981). For a
      word ${i("u")} = k<sub>1</sub>k<sub>2</sub>…k<sub>n</sub> write ${map("u")} for ${map("k<sub>1</sub>")} ∘ … ∘
      ${map("k<sub>n</sub>")}, ${piece("u")} = ${map("u")}(${i("A")}) for its piece and |${i("u")}| for the norm of the linear part of ${map("u")}.
      The <em>gap</em> ${i("g")} is the longest edge of a shortest tree that joins the pieces ${piece("1")}, …, ${piece("N")}, an edge being
      as long as its two pieces are apart.</p>`;

const THEOREMS: readonly Theorem[] = [
  {
    kinds: ["shared-points", "neighbours"],
    title: "Pieces that share points",
    text: `
      <p><strong>Theorem</strong> (Hata 1985). Draw an edge between two maps whose pieces meet. If this graph is connected, so is
      ${i("A")}.</p>
      <p><strong>Proof.</strong> Let ${i("g")} = 0, which is the same. ${i("A")} is connected in steps of any length ε: for n so large that
      all pieces of n letters are smaller than ε, any two points of one of these are a step apart, and the parts of the piece of a
      shorter word hang together, since those of ${i("A")} do. A compact set that is connected in steps of any length is
      connected. ∎</p>
      <p>That two pieces have a point in common is shown by its two addresses, whose points are compared without rounding. Where the pieces
      lie to each other in finitely many ways (the neighbour graph of Bandt and Graf 1992 is finite), such points are found by an
      endless path in that graph.</p>`,
  },
  {
    kinds: ["area"],
    title: "Pieces too large to lie side by side",
    text: `
      <p><strong>Theorem.</strong> If |det ${map("i")}| + |det ${map("j")}| ≥ 1, the pieces ${piece("i")} and ${piece("j")} meet.</p>
      <p><strong>Proof.</strong> Suppose that they do not. Let B be all points within r of ${i("A")}, where r is so small that the points
      within ${i("s")}r of ${piece("i")} and those within ${i("s")}r of ${piece("j")} are apart. The images ${map("i")}(B) and
      ${map("j")}(B) lie in these two disjoint sets, both compact and inside B, and what B has beside them has a positive area. So the area of B
      is more than |det ${map("i")}| + |det ${map("j")}| times itself, and the sum is below 1. ∎</p>`,
  },
  {
    kinds: ["crossings"],
    title: "Pieces that cross",
    text: `
      <p>The idea is the <em>trap</em> by which Danny Calegari, Sarah Koch and Alden Walker found inner points of the set M
      (“Roots, Schottky semigroups, and a proof of Bandt's conjecture”, arXiv 1410.8542): an attractor is connected in steps
      as short as its gap, so that two smaller copies whose ends take turns around a disc would have to come nearer to each other than that
      gap. They take it for two similarities with one factor. Stated here for any number of affine maps, with a graph of pairs in place of the one
      pair, and with straight rays in place of arcs around a disc.</p>
      <p><strong>Theorem.</strong> Let G ≥ ${i("g")}, and r<sub>u</sub> = |${i("u")}| G / 2 for a word ${i("u")}. Suppose that for a word
      ${i("u")} that begins with i and a word ${i("v")} that begins with j there are points p<sub>1</sub>, p<sub>2</sub> of ${piece("u")} and
      q<sub>1</sub>, q<sub>2</sub> of ${piece("v")}, and for each of them a unit vector, such that</p>
      <ol>
        <li>along its vector each p is beyond all of ${piece("v")} by more than r<sub>v</sub>, and each q beyond all of ${piece("u")} by
        more than r<sub>u</sub>;</li>
        <li>the vectors alternate: those of p<sub>1</sub>, q<sub>1</sub>, p<sub>2</sub>, q<sub>2</sub> are in cyclic order.</li>
      </ol>
      <p>If the graph of all pairs (i, j) for which there are such points is connected, then ${i("A")} is connected. Pairs that are known to
      meet for another reason count as well.</p>
      <p><strong>Lemma.</strong> From each of these points let a ray go along its vector. No ray of a p meets one of a q.</p>
      <p><strong>Proof.</strong> Let p + ad = q + be with a, b ≥ 0 and unit vectors d, e. Times d this is b (d · e) = a + d · (p − q)
      &gt; a, times e it is a (d · e) = b + e · (q − p) &gt; b. So a and b are positive, and d · e is more than both a / b and b / a, one of which
      is at least 1: a contradiction. ∎</p>
      <p><strong>Proof.</strong> Suppose that ${i("g")} &gt; 0. As above, ${i("A")} is connected in steps of ${i("g")}, and so
      ${piece("u")} in steps of |${i("u")}| ${i("g")}. The union P of the closed discs of radius |${i("u")}| ${i("g")} / 2 ≤ r<sub>u</sub> about
      its points is therefore connected by paths, and so is the union Q of those of radius |${i("v")}| ${i("g")} / 2 about the points of
      ${piece("v")}. A large disc D holds P, Q and the beginnings of the rays. One path goes from the boundary of D along the ray to
      p<sub>1</sub>, within P to p<sub>2</sub> and out along its ray; another one likewise by q<sub>1</sub>, Q and q<sub>2</sub>. They join
      alternating points of the boundary inside D, so they meet. Not on two rays, by the lemma; nor on a ray of the one and in the union of the
      other, by 1. So P and Q meet, and the distance of ${piece("i")} and ${piece("j")} is at most that of ${piece("u")} and ${piece("v")}, which is at most
      (|${i("u")}| + |${i("v")}|) ${i("g")} / 2 ≤ ${i("s")}${i("g")} &lt; ${i("g")}. As this holds for the edges of a connected graph, and as pieces
      that meet are at distance 0, the longest edge of a shortest tree is below ${i("g")}: a contradiction. So
      ${i("g")} = 0, and ${i("A")} is connected by Hata's theorem. ∎</p>
      <p>All conditions are strict inequalities, between points and convex hulls: a little play in the maps leaves them true. This is why what
      proves one sample of the map of parameters mostly proves its neighbours, each of which is checked on its own. That two bars lie across
      each other is no proof while G is not known to be small: they may pass through each other's gaps.</p>
      <p><strong>On a line</strong> nothing can cross. There one point of ${piece("i")} between two points of ${piece("j")} does the same: it
      is within |${map("j")}| ${i("g")} / 2 of a point of ${piece("j")}, and so nearer than ${i("g")}.</p>`,
  },
  {
    kinds: ["differences"],
    title: "Copies of one shape, turned and shrunk alike",
    text: `
      <p>Copies of one shape, size and direction never cross. Let ${map("k")}(x) = Lx + t<sub>k</sub> with one linear part L for all k, and
      let D be the set of all differences a − b of two points of ${i("A")}.</p>
      <p><strong>Theorem.</strong> ${piece("i")} and ${piece("j")} meet just if L<sup>−1</sup>(t<sub>j</sub> − t<sub>i</sub>) lies in D. And D
      holds every bounded set K each point x of which has a pair (k, l) with L<sup>−1</sup>(x − (t<sub>k</sub> − t<sub>l</sub>)) in K.</p>
      <p><strong>Proof.</strong> La + t<sub>i</sub> = Lb + t<sub>j</sub> says that a − b = L<sup>−1</sup>(t<sub>j</sub> − t<sub>i</sub>).
      For the second part, from x go to x<sub>1</sub> = L<sup>−1</sup>(x − d<sub>1</sub>), from there to x<sub>2</sub> =
      L<sup>−1</sup>(x<sub>1</sub> − d<sub>2</sub>), and so on, all in K, where each d<sub>n</sub> is a difference t<sub>k</sub> −
      t<sub>l</sub>. Then x = d<sub>1</sub> + Ld<sub>2</sub> + … + L<sup>n−1</sup>d<sub>n</sub> + L<sup>n</sup>x<sub>n</sub>. The last
      term vanishes as n grows, since K is bounded and L contracts; and the sums of L<sup>n−1</sup>t<sub>k</sub> are the points of ${i("A")}, so that
      x is the difference of two of them. ∎</p>
      <p>Frond takes for K squares of a grid. It begins with all that D may reach and leaves out every square whose way back leaves what is left
      for all pairs (k, l), until none does. For two maps such sums are how the set M of Barnsley and Harrington (1985) was
      looked at from the beginning: its s are those of which some sum ±1 + d<sub>1</sub>s + d<sub>2</sub>s<sup>2</sup> + …, each d<sub>n</sub> −1,
      0 or 1, is 0.</p>`,
  },
  {
    kinds: ["one-map", "equal-maps", "common-point"],
    title: "One point, or one shape",
    text: `
      <p>One map has its fixed point for an attractor, and so have several that leave the same point where it is. If all maps are the same, so are
      all pieces.</p>`,
  },
];

const OUTLOOK = `
      <h2>What is computed</h2>
      <p>Points are compared by exact arithmetic in quadratic number fields, areas by exact sums of doubles. Crossings and differences are found in
      floating point, with bounds for what rounding can do that are added to every comparison: such a proof is as good as the program that
      computes these bounds. The source says how, beside each of them. “In pieces, proved” comes with a certificate that a checker of its own
      replays in whole numbers, and that can be saved; so do common points, areas, differences and crossings, where the checker takes for the norm that
      whose unit ball is the difference of two points of a polygon which all maps take into its inside. “Looks whole” is no proof, and is never called one.</p>
      <h2>Sources</h2>
      <p>C. Bandt, S. Graf: Self-similar sets VII. A characterization of self-similar fractals with positive Hausdorff measure. Proc. AMS 114,
      1992. M. F. Barnsley, A. N. Harrington: A Mandelbrot set for pairs of linear maps. Physica D 15, 1985. D. Calegari, S. Koch, A. Walker: Roots,
      Schottky semigroups, and a proof of Bandt's conjecture. Ergodic Theory Dynam. Systems 37, 2017. M. Hata: On the structure of
      self-similar sets. Japan J. Appl. Math. 2, 1985. J. E. Hutchinson: Fractals and self similarity. Indiana Univ. Math. J. 30, 1981.</p>`;

/** The middle of the page. */
export function theorems(): string {
  const sections = THEOREMS.map(({ kinds, title, text }) => {
    const anchors = kinds.map((kind) => `<span id="${kind}"></span>`).join("");
    return `
      <h2>${anchors}${title}</h2>${text}`;
  });
  return [INTRODUCTION, ...sections, OUTLOOK].join("\n");
}
