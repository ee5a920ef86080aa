/**
 * "What the proofs rest on": the theorems behind every "In one piece, proved", and behind "In pieces, proved", each
 * with its proof. The sections are named as the reasons of the programming interface are.
 */
import { escaped } from "../src/format/html.ts";
import { mathml } from "./mathml.ts";

interface Theorem {
  /** The kinds of reasons that rest on it; the first names its section. */
  kinds: readonly string[];
  title: string;
  /** Markup, with formulas as $TeX$. */
  text: string;
}

const INTRODUCTION = String.raw`
      <p>Throughout, $f_1, \dots, f_N$ are affine maps of the plane that contract in one norm: there is an
      $s < 1$ with $\lvert f_k(x) - f_k(y) \rvert \le s \lvert x - y \rvert$ for all of them. Their attractor $A$
      is the one non-empty compact set with $$A = \bigcup_{i=1}^{N} f_i(A)$$ (Hutchinson 1981). For a
      word $u = k_1 k_2 \dots k_n$ write $f_u$ for $f_{k_1} \circ \dots \circ f_{k_n}$, $A_u = f_u(A)$ for its piece and $\lvert u \rvert$ for the
      norm of the linear part of $f_u$. The <em>gap</em> $g$ is the longest edge of a shortest tree that joins the pieces $A_1, \dots, A_N$, an
      edge being as long as its two pieces are apart.</p>`;

const THEOREMS: readonly Theorem[] = [
  {
    kinds: ["shared-points", "neighbours"],
    title: "Pieces that share points",
    text: String.raw`
      <p><strong>Theorem</strong> (Hata 1985). Draw an edge between two maps whose pieces meet. If this graph is connected, so is
      $A$.</p>
      <p><strong>Proof.</strong> Let $g = 0$, which is the same. $A$ is connected in steps of any length $\varepsilon$: for $n$ so large that
      all pieces of $n$ letters are smaller than $\varepsilon$, any two points of one of these are a step apart, and the parts of the piece of a
      shorter word hang together, since those of $A$ do. A compact set that is connected in steps of any length is
      connected. ∎</p>
      <p>That two pieces have a point in common is shown by its two addresses, whose points are compared without rounding. Where the pieces
      lie to each other in finitely many ways (the neighbour graph of Bandt and Graf 1992 is finite), such points are found by an
      endless path in that graph.</p>`,
  },
  {
    kinds: ["area"],
    title: "Pieces too large to lie side by side",
    text: String.raw`
      <p><strong>Theorem.</strong> If $\lvert \det f_i \rvert + \lvert \det f_j \rvert \ge 1$, the pieces $A_i$ and $A_j$ meet.</p>
      <p><strong>Proof.</strong> Suppose that they do not. Let $B$ be all points within $r$ of $A$, where $r$ is so small that the points
      within $s r$ of $A_i$ and those within $s r$ of $A_j$ are apart. The images $f_i(B)$ and
      $f_j(B)$ lie in these two disjoint sets, both compact and inside $B$, and what $B$ has beside them has a positive area. So the area of $B$
      is more than $\lvert \det f_i \rvert + \lvert \det f_j \rvert$ times itself, and the sum is below 1. ∎</p>`,
  },
  {
    kinds: ["crossings"],
    title: "Pieces that cross",
    text: String.raw`
      <p>The idea is the <em>trap</em> by which Danny Calegari, Sarah Koch and Alden Walker found inner points of the set $M$
      (“Roots, Schottky semigroups, and a proof of Bandt's conjecture”, arXiv 1410.8542): an attractor is connected in steps
      as short as its gap, so that two smaller copies whose ends take turns around a disc would have to come nearer to each other than that
      gap. They take it for two similarities with one factor. Stated here for any number of affine maps, with a graph of pairs in place of the one
      pair, and with straight rays in place of arcs around a disc.</p>
      <p><strong>Theorem.</strong> Let $G \ge g$, and $r_u = \lvert u \rvert\, G / 2$ for a word $u$. Suppose that for a word
      $u$ that begins with $i$ and a word $v$ that begins with $j$ there are points $p_1, p_2$ of $A_u$ and
      $q_1, q_2$ of $A_v$, and for each of them a unit vector, such that</p>
      <ol>
        <li>along its vector each $p$ is beyond all of $A_v$ by more than $r_v$, and each $q$ beyond all of $A_u$ by
        more than $r_u$;</li>
        <li>the vectors alternate: those of $p_1, q_1, p_2, q_2$ are in cyclic order.</li>
      </ol>
      <p>If the graph of all pairs $(i, j)$ for which there are such points is connected, then $A$ is connected. Pairs that are known to
      meet for another reason count as well.</p>
      <p><strong>Lemma.</strong> From each of these points let a ray go along its vector. No ray of a $p$ meets one of a $q$.</p>
      <p><strong>Proof.</strong> Let $p + a d = q + b e$ with $a, b \ge 0$ and unit vectors $d, e$. Times $d$ this is
      $b\,(d \cdot e) = a + d \cdot (p - q) > a$, times $e$ it is $a\,(d \cdot e) = b + e \cdot (q - p) > b$. So $a$ and $b$ are positive, and
      $d \cdot e$ is more than both $a / b$ and $b / a$, one of which is at least 1: a contradiction. ∎</p>
      <p><strong>Proof.</strong> Suppose that $g > 0$. As above, $A$ is connected in steps of $g$, and so
      $A_u$ in steps of $\lvert u \rvert\, g$. The union $P$ of the closed discs of radius $\lvert u \rvert\, g / 2 \le r_u$ about
      its points is therefore connected by paths, and so is the union $Q$ of those of radius $\lvert v \rvert\, g / 2$ about the points of
      $A_v$. A large disc $D$ holds $P$, $Q$ and the beginnings of the rays. One path goes from the boundary of $D$ along the ray to
      $p_1$, within $P$ to $p_2$ and out along its ray; another one likewise by $q_1$, $Q$ and $q_2$. They join
      alternating points of the boundary inside $D$, so they meet. Not on two rays, by the lemma; nor on a ray of the one and in the union of the
      other, by 1. So $P$ and $Q$ meet, and the distance of $A_i$ and $A_j$ is at most that of $A_u$ and $A_v$, which is at most
      $(\lvert u \rvert + \lvert v \rvert)\, g / 2 \le s g < g$. As this holds for the edges of a connected graph, and as pieces
      that meet are at distance 0, the longest edge of a shortest tree is below $g$: a contradiction. So
      $g = 0$, and $A$ is connected by Hata's theorem. ∎</p>
      <p>All conditions are strict inequalities, between points and convex hulls: a little play in the maps leaves them true. This is why what
      proves one sample of the map of parameters mostly proves its neighbours, each of which is checked on its own. That two bars lie across
      each other is no proof while $G$ is not known to be small: they may pass through each other's gaps.</p>`,
  },
  {
    kinds: ["line"],
    title: "Pieces that overlap on a line",
    text: String.raw`
      <p><strong>Theorem.</strong> Let $A$ lie on a line. If a point of $A_j$ lies between two points of $A_i$ for the edges
      $(i, j)$ of a connected graph, then $A$ is connected. Pairs that are known to meet for another reason count as well.</p>
      <p><strong>Proof.</strong> Suppose that $g > 0$. $A$ is connected in steps of $g$, and so $A_i$ in steps of
      $\lvert f_i \rvert\, g \le s g$. A point of the line between two points of $A_i$ is therefore within
      $s g / 2$ of a point of $A_i$, and so the two pieces are nearer to each other than $g$. The longest edge of a shortest tree is below
      $g$: a contradiction. So $g = 0$, and $A$ is connected by Hata's theorem. ∎</p>
      <p>That $A$ lies on a line is shown by two of its points: where every map takes the line through them into itself, that line
      holds $A$.</p>`,
  },
  {
    kinds: ["differences"],
    title: "Copies of one shape, turned and shrunk alike",
    text: String.raw`
      <p>Copies of one shape, size and direction never cross. Let $f_k(x) = L x + t_k$ with one linear part $L$ for all $k$, and
      let $D$ be the set of all differences $a - b$ of two points of $A$.</p>
      <p><strong>Theorem.</strong> $A_i$ and $A_j$ meet just if $L^{-1}(t_j - t_i)$ lies in $D$. And $D$
      holds every bounded set $K$ each point $x$ of which has a pair $(k, l)$ with $L^{-1}(x - (t_k - t_l))$ in $K$.</p>
      <p><strong>Proof.</strong> $L a + t_i = L b + t_j$ says that $a - b = L^{-1}(t_j - t_i)$.
      For the second part, from $x$ go to $x_1 = L^{-1}(x - d_1)$, from there to $x_2 = L^{-1}(x_1 - d_2)$, and so on, all in $K$, where
      each $d_n$ is a difference $t_k - t_l$. Then $$x = d_1 + L d_2 + \dots + L^{n-1} d_n + L^n x_n.$$ The last
      term vanishes as $n$ grows, since $K$ is bounded and $L$ contracts; and the sums of $L^{n-1} t_k$ are the points of $A$, so that
      $x$ is the difference of two of them. ∎</p>
      <p>Frond takes for $K$ squares of a grid. It begins with all that $D$ may reach and leaves out every square whose way back leaves what is left
      for all pairs $(k, l)$, until none does. For two maps such sums are how the set $M$ of Barnsley and Harrington (1985) was
      looked at from the beginning: its $s$ are those of which some sum $\pm 1 + d_1 s + d_2 s^2 + \dots$, each $d_n$ being $-1$,
      0 or 1, is 0.</p>`,
  },
  {
    kinds: ["one-map", "equal-maps", "common-point"],
    title: "One point, or one shape",
    text: `
      <p>One map has its fixed point for an attractor, and so have several that leave the same point where it is. If all maps are the same, so are
      all pieces.</p>`,
  },
  {
    kinds: ["joints"],
    title: "Joints that stay joined",
    text: String.raw`
      <p>This is about a whole path. Maps $f_1, \dots, f_N$ are a <em>zipper</em> with the ends $p \ne q$ if there are points
      $z_0 = p, z_1, \dots, z_N = q$ such that each $f_k$ takes $p$ and $q$ to $z_{k-1}$ and $z_k$, in this order or in the
      other; in which, is its signature (Aseev, Tetenov and Kravchenko 2003). Koch's curve, dragons and Lévy's curve are attractors of zippers.
      So is the gasket, if its maps are followed by symmetries that it has, which change no piece.</p>
      <p><strong>Theorem.</strong> The attractor of a zipper is connected. If $f_1, \dots, f_N$ and $g_1, \dots, g_N$ are zippers
      with the same ends and signature, and contract in one norm, then at every $t$ of $[0, 1]$ the maps
      $h_k = (1 - t) f_k + t g_k$ are a zipper that contracts, and its attractor is connected.</p>
      <p><strong>Proof.</strong> $\{p, q\}$ lies in its own image, since $p$ is the image of $p$ or of $q$ under $f_1$, and $q$ under
      $f_N$. A compact set that lies in its own image lies in the attractor. So each piece $A_k$ has the points
      $z_{k-1}$ and $z_k$, neighbours meet, and Hata's theorem says the rest. That each $h_k$ takes one end to
      $w_{k-1}$ and the other to $w_k$, with $w_k$ in place of $z_k$ on the straight line from the one to the other, is
      linear in the maps, and so is that $w_0 = p$ and $w_N = q$. A norm of matrices is convex, so where it is at most $s$ for
      $f_k$ and $g_k$, it is for $h_k$. ∎</p>
      <p>A similarity takes the ends of any zipper to those of another and leaves it the shape that it is. Different numbers of maps
      become the same where pieces are split into all of theirs. What rounding leaves of the joints is bounded: if both ends are within
      $d$ of their images, no norm is above $s < 1$ and joints are joined to within $j$, pieces that meet there are no further apart than
      $$j + \frac{2 s d}{1 - s}.$$</p>`,
  },
  {
    kinds: ["apart"],
    title: "Pieces that lie apart",
    text: `
      <p><strong>Theorem.</strong> Let $P$ be a convex polygon that all words of some $n$ letters map into itself, and let the maps be
      divided into two kinds, neither of them empty. Begin with all pairs $(i, j)$ of a map of the first kind and one of the second. Put
      in the place of a pair $(u, v)$ of words either all $(uk, v)$ or all $(u, vk)$, where $k$ goes through all maps, and so on, finitely
      often. If for each pair that is left a straight line has $f_u(P)$ on its one side and $f_v(P)$ on its other, without touching
      either, then $A$ is not connected.</p>
      <p><strong>Proof.</strong> The words of $n$ letters have the attractor $A$, too. Their images of $P$, and the images of these, lie
      in $P$ and come as near to $A$ as one likes (Hutchinson 1981). So $A$ lies in $P$, and each $A_u$ in $f_u(P)$. Therefore $A_u$ and
      $A_v$ have no point in common where $(u, v)$ is left. Since $A_u$ is the union of all $A_{uk}$, the same is then true of the pairs in whose
      place others were put, and in the end of all $(i, j)$. So $A$ is the union of two sets, the pieces of the one kind and those of the
      other, which are not empty, compact, and have no point in common. ∎</p>`,
  },
];

const OUTLOOK = `
      <h2>What is computed</h2>
      <p>Points are compared by exact arithmetic in quadratic number fields, areas by exact sums of doubles. Crossings and differences are found in
      floating point, with bounds for what rounding can do that are added to every comparison: such a proof is as good as the program that
      computes these bounds. The source says how, beside each of them. A shape in pieces has a certificate that a checker of its own replays in
      whole numbers, and that can be saved. It is called proved once the checker has taken it. Common points, overlaps on a line, areas,
      differences and crossings have certificates, too; for them the checker takes the norm whose unit ball is the difference of two points of
      a polygon which all maps take into its inside. “Looks whole” is no proof, and is never called one.</p>
      <h2>Sources</h2>
      <p>V. V. Aseev, A. V. Tetenov, A. S. Kravchenko: On selfsimilar Jordan curves on the plane. Siberian Math. J. 44, 2003. C. Bandt, S. Graf: Self-similar sets VII. A characterization of self-similar fractals with positive Hausdorff measure. Proc. AMS 114,
      1992. M. F. Barnsley, A. N. Harrington: A Mandelbrot set for pairs of linear maps. Physica D 15, 1985. D. Calegari, S. Koch, A. Walker: Roots,
      Schottky semigroups, and a proof of Bandt's conjecture. Ergodic Theory Dynam. Systems 37, 2017. M. Hata: On the structure of
      self-similar sets. Japan J. Appl. Math. 2, 1985. J. E. Hutchinson: Fractals and self similarity. Indiana Univ. Math. J. 30, 1981.</p>`;

/** As in lessons: what is selected is copied with its formulas as LaTeX. */
const COPY = `<script>
document.addEventListener("copy", (event) => {
  const selection = getSelection();
  if (!selection || selection.isCollapsed || !event.clipboardData) return;
  const box = document.createElement("div");
  const range = selection.getRangeAt(0);
  const around = range.commonAncestorContainer;
  const inside = (around.closest ? around : around.parentElement)?.closest("[data-tex]");
  if (inside) {
    event.clipboardData.setData("text/plain", inside.dataset.tex);
    event.preventDefault();
    return;
  }
  box.append(range.cloneContents());
  const html = box.innerHTML;
  const formulas = box.querySelectorAll("[data-tex]");
  if (formulas.length === 0) return;
  for (const one of formulas) one.replaceWith("$" + one.dataset.tex + "$");
  for (const one of box.querySelectorAll("p, li, h2")) one.append("\\n\\n");
  // The lines of the source are none of the text.
  const text = box.textContent.replace(/[^\\S\\n]*\\n[^\\S\\n]+/g, " ").replace(/\\n{2,}\\s*/g, "\\n").trim();
  event.clipboardData.setData("text/plain", text);
  event.clipboardData.setData("text/html", html);
  event.preventDefault();
});
</script>`;

/** Formulas as MathML: $ $ in a line, $$ $$ on a line of their own. */
function withFormulas(text: string): string {
  return text.replace(/\$\$([^$]+)\$\$|\$([^$]+)\$/g, (_, own?: string, inline?: string) => {
    const tex = own ?? inline ?? "";
    const kind = own === undefined ? "" : ' class="display"';
    return `<span${kind} data-tex="${escaped(tex)}">${mathml(tex, own !== undefined)}</span>`;
  });
}

/** The middle of the page. */
export function theorems(): string {
  const sections = THEOREMS.map(({ kinds, title, text }) => {
    const anchors = kinds.map((kind) => `<span id="${kind}"></span>`).join("");
    return `
      <h2>${anchors}${title}</h2>${withFormulas(text)}`;
  });
  return [withFormulas(INTRODUCTION), ...sections, OUTLOOK, COPY].join("\n");
}
