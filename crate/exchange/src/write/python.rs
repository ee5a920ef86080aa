//! A Python program that draws the shape by the chaos game, many points at once.

use crate::number::Number;
use crate::system::{Maps, System};

pub fn write(system: &System) -> String {
    let size = match system.maps {
        Maps::Plane(_) | Maps::Directed(_) => 2,
        Maps::Space(_) | Maps::Objects(_) => 3,
    };
    let list =
        |numbers: &[f64]| numbers.iter().map(|&x| Number::of(x).to_string()).collect::<Vec<_>>().join(", ");
    let rows: Vec<String> =
        system.maps.rows().into_iter().map(|row| format!("    [{}],", list(row))).collect();
    let has_roots = system.maps.rows().into_iter().flatten().any(|&x| Number::of(x).has_root());
    let weights = system.weights();
    let total: f64 = weights.iter().sum();
    // Rounding must not stand between them and the sum 1, which NumPy asks for.
    let weights: Vec<String> = weights.iter().map(|weight| format!("{:.6}", weight / total)).collect();
    let about = if size == 2 {
        "# A map is a row [a, b, c, d, e, f]: x' = a x + b y + e, y' = c x + d y + f."
    } else {
        "# A map is a row of twelve numbers: the rows of its matrix, then its shift."
    };
    let root = if has_roots { "from math import sqrt\n\n" } else { "" };
    let draw = if size == 2 {
        "plt.figure(figsize=(8, 8))\n\
         plt.scatter(points[:, 0], points[:, 1], s=0.2, c=last, cmap=\"turbo\", linewidths=0)\n\
         plt.axis(\"equal\")\n\
         plt.axis(\"off\")\n"
    } else {
        "axes = plt.figure(figsize=(8, 8)).add_subplot(projection=\"3d\")\n\
         axes.scatter(points[:, 0], points[:, 1], points[:, 2], s=0.2, c=last, cmap=\"turbo\", linewidths=0)\n\
         axes.set_aspect(\"equal\")\n"
    };
    format!(
        "# {title}, from Frond. Runs with NumPy and Matplotlib: pip install numpy matplotlib\n\
         {root}import matplotlib.pyplot as plt\n\
         import numpy as np\n\
         \n\
         {about}\n\
         maps = np.array([\n{rows}\n])\n\
         weights = np.array([{weights}])\n\
         \n\
         linear = maps[:, :{squared}].reshape(-1, {size}, {size})\n\
         shift = maps[:, {squared}:]\n\
         \n\
         # The chaos game, for many points at once. All begin at the fixed point of the first map, which is part of the shape.\n\
         random = np.random.default_rng(1)\n\
         start = np.linalg.solve(np.eye({size}) - linear[0], shift[0])\n\
         points = np.tile(start, (100_000, 1))\n\
         for _ in range(50):\n    \
             last = random.choice(len(maps), size=len(points), p=weights / weights.sum())\n    \
             points = np.einsum(\"nij,nj->ni\", linear[last], points) + shift[last]\n\
         \n\
         {draw}plt.show()\n",
        title = system.title(),
        rows = rows.join("\n"),
        weights = weights.join(", "),
        squared = size * size,
    )
}
