//! Transforms as style sheets write them (CSS Transforms, levels 1 and 2), as far as they stay in the plane.

use kurbo::{Affine, Point, Rect, Vec2};

/// The size of letters where none is set, in pixels.
const FONT_SIZE: f64 = 16.0;

/// A length in pixels; parts (%) are those of `whole`.
pub fn length(text: &str, whole: f64) -> Option<f64> {
    let text = text.trim();
    let split = text.len()
        - text.bytes().rev().take_while(|byte| byte.is_ascii_alphabetic() || *byte == b'%').count();
    let (number, unit) = match text.split_at_checked(split)? {
        // 1e3 has no unit.
        (_, unit) if text.parse::<f64>().is_ok() && !unit.contains('%') => (text, ""),
        parts => parts,
    };
    let unit = match unit.to_ascii_lowercase().as_str() {
        "" | "px" => 1.0,
        "%" => whole / 100.0,
        "em" | "rem" => FONT_SIZE,
        "ex" | "ch" => FONT_SIZE / 2.0,
        "in" => 96.0,
        "cm" => 96.0 / 2.54,
        "mm" => 96.0 / 25.4,
        "q" => 96.0 / 101.6,
        "pt" => 96.0 / 72.0,
        "pc" => 16.0,
        _ => return None,
    };
    number.parse::<f64>().ok().map(|number| number * unit).filter(|length| length.is_finite())
}

/// An angle in radians; a number alone is in degrees, as in attributes.
fn angle(text: &str) -> Option<f64> {
    let text = text.trim();
    let (number, unit) =
        [("deg", 1.0), ("grad", 0.9), ("rad", 1_f64.to_degrees()), ("turn", 360.0), ("", 1.0)]
            .into_iter()
            .find_map(|(name, unit)| Some((text.strip_suffix(name)?, unit)))?;
    number.parse::<f64>().ok().map(|number| (number * unit).to_radians()).filter(|angle| angle.is_finite())
}

/// A factor, as a number or in parts of a hundred.
fn factor(text: &str) -> Option<f64> {
    let text = text.trim();
    let number = match text.strip_suffix('%') {
        Some(number) => number.parse::<f64>().ok()? / 100.0,
        None => text.parse().ok()?,
    };
    number.is_finite().then_some(number)
}

fn words(text: &str) -> Vec<&str> {
    text.split(|sign: char| sign.is_whitespace() || sign == ',')
        .filter(|word| !word.is_empty())
        .take(17)
        .collect()
}

/// A `transform`: `None` where it is miswritten, or leaves the plane. Lengths in parts are those of the box.
pub fn transform(text: &str, around: Rect) -> Option<Affine> {
    let mut all = Affine::IDENTITY;
    let mut rest = text.trim();
    if rest.eq_ignore_ascii_case("none") {
        return Some(all);
    }
    while !rest.is_empty() {
        let (name, after) = rest.split_once('(')?;
        let (inside, after) = after.split_once(')')?;
        let list = words(inside);
        let name = name.trim_matches(|sign: char| sign.is_whitespace() || sign == ',').to_ascii_lowercase();
        all *= one(&name, &list, around)?;
        rest = after.trim_start();
    }
    Some(all)
}

fn one(name: &str, list: &[&str], around: Rect) -> Option<Affine> {
    let x = |text| length(text, around.width());
    let y = |text| length(text, around.height());
    let numbers = || list.iter().map(|text| factor(text)).collect::<Option<Vec<f64>>>();
    Some(match (name, list) {
        ("matrix", _) => Affine::new(numbers()?.try_into().ok()?),
        ("matrix3d", _) => {
            let m: [f64; 16] = numbers()?.try_into().ok()?;
            Affine::new([m[0], m[1], m[4], m[5], m[12], m[13]])
        }
        ("translate" | "translatex", [a]) => Affine::translate((x(a)?, 0.0)),
        ("translate", [a, b]) | ("translate3d", [a, b, _]) => Affine::translate((x(a)?, y(b)?)),
        ("translatey", [b]) => Affine::translate((0.0, y(b)?)),
        ("translatez" | "perspective", _) => Affine::IDENTITY,
        ("scale", [a]) => Affine::scale(factor(a)?),
        ("scale", [a, b]) | ("scale3d", [a, b, _]) => Affine::scale_non_uniform(factor(a)?, factor(b)?),
        ("scalex", [a]) => Affine::scale_non_uniform(factor(a)?, 1.0),
        ("scaley", [b]) => Affine::scale_non_uniform(1.0, factor(b)?),
        ("scalez", _) => Affine::IDENTITY,
        ("rotate" | "rotatez", [a]) | ("rotate3d", ["0", "0", "1", a]) => Affine::rotate(angle(a)?),
        // As in attributes.
        ("rotate", [a, b, c]) => Affine::rotate_about(angle(a)?, Point::new(x(b)?, y(c)?)),
        // What is turned out of the plane is seen narrower.
        ("rotatex", [a]) => Affine::scale_non_uniform(1.0, angle(a)?.cos()),
        ("rotatey", [a]) => Affine::scale_non_uniform(angle(a)?.cos(), 1.0),
        ("skewx" | "skew", [a]) => Affine::skew(angle(a)?.tan(), 0.0),
        ("skew", [a, b]) => Affine::skew(angle(a)?.tan(), angle(b)?.tan()),
        ("skewy", [b]) => Affine::skew(0.0, angle(b)?.tan()),
        _ => return None,
    })
}

/// The properties `translate`, `rotate` and `scale`, in the order in which they act.
pub fn property(name: &str, text: &str, around: Rect) -> Option<Affine> {
    let list = words(text);
    match (name, &list[..]) {
        (_, ["none"]) => Some(Affine::IDENTITY),
        ("rotate", [a] | ["z", a] | [a, "z"] | ["0", "0", "1", a]) => Some(Affine::rotate(angle(a)?)),
        ("rotate", ["x", a] | [a, "x"]) => one("rotatex", &[*a], around),
        ("rotate", ["y", a] | [a, "y"]) => one("rotatey", &[*a], around),
        ("translate" | "scale", [a, b, _]) => one(name, &[*a, *b], around),
        ("translate" | "scale", list) => one(name, list, around),
        _ => None,
    }
}

/// A `transform-origin` in the box.
pub fn origin(text: &str, around: Rect) -> Option<Point> {
    let list = words(text);
    let (mut a, mut b) = match list[..] {
        [only] => (only, "center"),
        [a, b] | [a, b, _] => (a, b),
        _ => return None,
    };
    if matches!(a, "top" | "bottom") || matches!(b, "left" | "right") {
        (a, b) = (b, a);
    }
    let along = |text: &str, whole: f64| match text {
        "left" | "top" => Some(0.0),
        "center" => Some(whole / 2.0),
        "right" | "bottom" => Some(whole),
        text => length(text, whole),
    };
    Some(around.origin() + Vec2::new(along(a, around.width())?, along(b, around.height())?))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Rect = Rect::new(10.0, 20.0, 50.0, 100.0);

    fn rounded(p: Point) -> [f64; 2] {
        [p.x, p.y].map(|value| (1e6 * value).round() / 1e6)
    }

    #[test]
    fn the_last_is_done_first() {
        let at = |text: &str| transform(text, BOX).map(|map| rounded(map * Point::new(1.0, 2.0)));
        for (text, there) in [
            ("translate(10, 20) scale(2)", [12.0, 24.0]),
            ("translate(10px, 25%) scale(200%)", [12.0, 24.0]),
            ("scale(2 3),translate(10)", [22.0, 6.0]),
            ("rotate(90)", [-2.0, 1.0]),
            ("ROTATE(0.25turn)", [-2.0, 1.0]),
            ("rotate(100grad)", [-2.0, 1.0]),
            ("rotate(180 1 1)", [1.0, 0.0]),
            ("matrix(1 2 3 4 5 6)", [12.0, 16.0]),
            ("skewX(45deg)", [3.0, 2.0]),
            ("scaleX(-1) translateY(1in)", [-1.0, 98.0]),
            ("rotateY(180deg)", [-1.0, 2.0]),
            ("translate3d(1px, 2px, 3px)", [2.0, 4.0]),
            (" none ", [1.0, 2.0]),
            ("", [1.0, 2.0]),
        ] {
            assert_eq!(at(text), Some(there), "{text}");
        }
        for odd in
            ["rotate(", "rotate)", "scale()", "scale(x)", "translate(1,2,3,4)", "turn(3)", "rotate(1e999)"]
        {
            assert_eq!(at(odd), None, "{odd}");
        }
    }

    #[test]
    fn an_origin_is_in_the_box() {
        for (text, there) in [
            ("center", [30.0, 60.0]),
            ("50% 50%", [30.0, 60.0]),
            ("top", [30.0, 20.0]),
            ("bottom left", [10.0, 100.0]),
            ("right 10px 3px", [50.0, 30.0]),
            ("1px 2px", [11.0, 22.0]),
        ] {
            assert_eq!(origin(text, BOX).map(rounded), Some(there), "{text}");
        }
        assert_eq!(origin("here", BOX), None);
        let turned = property("rotate", "z 90deg", BOX).map(|map| rounded(map * Point::new(1.0, 2.0)));
        assert_eq!(turned, Some([-2.0, 1.0]));
    }
}
