//! Transforms as drawings write them.

use kurbo::{Affine, Vec2};

/// A list of `matrix`, `translate`, `scale`, `rotate`, `skewX` and `skewY`; what is miswritten ends the list.
pub fn transform(text: &str) -> Affine {
    let mut all = Affine::IDENTITY;
    let mut rest = text;
    while let Some((word, after)) = rest.split_once('(') {
        let Some((inside, after)) = after.split_once(')') else { break };
        // None of them has more than six numbers: a seventh makes it miswritten.
        let numbers: Vec<f64> = inside
            .split(|sign: char| sign.is_whitespace() || sign == ',')
            .filter(|part| !part.is_empty())
            .map_while(|part| part.parse().ok())
            .take(7)
            .collect();
        let word = word.trim_matches(|sign: char| sign.is_whitespace() || sign == ',');
        all *= match (word, &numbers[..]) {
            ("matrix", &[a, b, c, d, e, f]) => Affine::new([a, b, c, d, e, f]),
            ("translate", &[x]) => Affine::translate((x, 0.0)),
            ("translate", &[x, y]) => Affine::translate((x, y)),
            ("scale", &[s]) => Affine::scale(s),
            ("scale", &[x, y]) => Affine::scale_non_uniform(x, y),
            ("rotate", &[turn]) => Affine::rotate(turn.to_radians()),
            ("rotate", &[turn, x, y]) => {
                let centre = Vec2::new(x, y);
                Affine::translate(centre) * Affine::rotate(turn.to_radians()) * Affine::translate(-centre)
            }
            ("skewX", &[turn]) => Affine::skew(turn.to_radians().tan(), 0.0),
            ("skewY", &[turn]) => Affine::skew(0.0, turn.to_radians().tan()),
            _ => break,
        };
        rest = after;
    }
    all
}

#[cfg(test)]
mod tests {
    use kurbo::Point;

    use super::*;

    #[test]
    fn the_last_is_done_first() {
        let at = |text: &str| {
            let p = transform(text) * Point::new(1.0, 2.0);
            [p.x, p.y].map(|value| (1e6 * value).round() / 1e6)
        };
        assert_eq!(at("translate(10, 20) scale(2)"), [12.0, 24.0]);
        assert_eq!(at("scale(2 3),translate(10)"), [22.0, 6.0]);
        assert_eq!(at("rotate(90)"), [-2.0, 1.0]);
        assert_eq!(at("rotate(180 1 1)"), [1.0, 0.0]);
        assert_eq!(at("matrix(1 2 3 4 5 6)"), [12.0, 16.0]);
        assert_eq!(at("skewX(45)"), [3.0, 2.0]);
        for odd in ["", "rotate(", "rotate)", "scale()", "scale(x)", "none", "translate(1,2,3,4)"] {
            assert_eq!(at(odd), [1.0, 2.0], "{odd}");
        }
    }
}
