//! GeoGebra: one command that makes lists of points, each the images of the one before.

use super::depth::depth;
use crate::number::Number;
use crate::system::Row;

/// The most points of the last list.
const MAX_POINTS: usize = 3000;

pub fn write(rows: &[Row]) -> String {
    let images = |list: &str| {
        let image = |row: &Row| {
            let [a, b, c, d, e, f] = row.map(|x| format!("({})", Number::of(x)));
            format!("Zip(({a} x(P) + {b} y(P) + {e}, {c} x(P) + {d} y(P) + {f}), P, {list})")
        };
        rows.iter().map(image).collect::<Vec<_>>().join(", ")
    };
    let steps = depth(rows.len(), MAX_POINTS);
    let mut commands =
        vec!["\"A_0 = {(0, 0)}\"".to_owned(), "\"SetVisibleInView(A_0, 1, false)\"".to_owned()];
    for k in 0..steps {
        commands.push(format!("\"A_{{{}}} = Join({})\"", k + 1, images(&format!("A_{{{k}}}"))));
        if k + 1 < steps {
            commands.push(format!("\"SetVisibleInView(A_{{{}}}, 1, false)\"", k + 1));
        }
    }
    commands.push(format!("\"SetPointSize(A_{{{steps}}}, 1)\""));
    format!("Execute({{{}}})\n", commands.join(", "))
}
