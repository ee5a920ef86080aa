//! The attractor as pieces of about one size, within a window.

use frond_core::{Affine2, hash};

use crate::picture::window::Window;
use crate::pieces::frame::Frame;
use crate::pieces::letters::Letters;

/// A piece of the attractor on the screen.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// From unit coordinates to pixels.
    pub map: Affine2,
    /// The first letters of its word, one at least.
    pub letters: Letters,
    /// The length of the longer axis of its ellipse, in pixels: no two of its points are farther apart.
    pub size: f64,
}

impl Piece {
    fn new(map: Affine2, letters: Letters) -> Self {
        Self { map, letters, size: 2.0 * map.norm() }
    }
}

/// Takes the attractor apart until the pieces are `size` pixels or less, leaving out those that do not
/// touch the window. Returns whether `most` pieces were enough; if not, `pieces` holds a part of them.
pub fn cut(
    frame: &Frame,
    to_screen: Affine2,
    window: Window,
    size: f64,
    most: usize,
    pieces: &mut Vec<Piece>,
) -> bool {
    pieces.clear();
    let mut stack = vec![(to_screen, Letters::NONE)];
    // Words that end outside of the window cost time as well.
    let mut visits = 16 * most;
    while let Some((map, letters)) = stack.pop() {
        if visits == 0 || pieces.len() >= most {
            return false;
        }
        visits -= 1;
        if window.extent_once(&map).is_none() {
            continue;
        }
        let piece = Piece::new(map, letters);
        if letters.count() > 0 && piece.size <= size {
            pieces.push(piece);
            continue;
        }
        stack.extend(frame.maps.iter().enumerate().map(|(i, part)| (map * *part, letters.then(i))));
    }
    true
}

/// The most steps to such a piece.
const MOST_STEPS: u32 = 1000;

/// Some pieces of at most `size` pixels that touch the window, by chance: where there are too many for
/// all of them.
fn cut_at_random(
    frame: &Frame,
    to_screen: Affine2,
    window: Window,
    size: f64,
    count: usize,
    pieces: &mut Vec<Piece>,
) {
    pieces.clear();
    let steps = frame.steps.len();
    let mut random = 0;
    for _ in 0..count {
        let mut piece = Piece::new(to_screen, Letters::NONE);
        for _ in 0..MOST_STEPS {
            if piece.size <= size && piece.letters.count() > 0 {
                break;
            }
            random += 1;
            let first = hash::counter(31, random) as usize % steps;
            let next = (0..steps).map(|i| (first + i) % steps).find_map(|i| {
                let (step, letters) = frame.steps[i];
                let map = piece.map * step;
                window.extent_once(&map).map(|_| Piece::new(map, piece.letters.join(letters)))
            });
            let Some(next) = next else { break };
            piece = next;
        }
        if piece.letters.count() > 0 && piece.size <= size {
            pieces.push(piece);
        }
    }
}

/// Some large pieces, whatever they overlap, where there are too many small ones: all maps of a shape of `whole` pixels
/// that is seen whole, `count` pieces of a close view.
pub(crate) fn cut_roughly(
    frame: &Frame,
    to_screen: Affine2,
    window: Window,
    whole: f64,
    count: usize,
    pieces: &mut Vec<Piece>,
) {
    let seen = f64::from(window.width.max(window.height));
    if whole > 2.0 * seen {
        return cut_at_random(frame, to_screen, window, seen, count, pieces);
    }
    pieces.clear();
    let parts = frame.maps.iter().enumerate();
    pieces.extend(parts.map(|(i, part)| Piece::new(to_screen * *part, Letters::NONE.then(i))));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::view::View;
    use crate::testing::{NASTY, PLAIN, ifs};
    use frond_core::Hull;

    const WINDOW: Window = Window { width: 300, height: 200 };

    fn screen(name: &str) -> (Frame, Affine2) {
        let ifs = ifs(name);
        let hull = Hull::of(&ifs);
        let frame = Frame::within(&ifs, &hull);
        let to_screen =
            View::fit(&hull, WINDOW.width, WINDOW.height, 0.05).onto_screen(frame.to_world, WINDOW);
        (frame, to_screen)
    }

    #[test]
    fn pieces_are_of_the_size_asked_for() {
        for name in PLAIN {
            let (frame, to_screen) = screen(name);
            let mut pieces = Vec::new();
            assert!(cut(&frame, to_screen, WINDOW, 20.0, 100_000, &mut pieces), "{name}");
            assert!(!pieces.is_empty());
            assert!(pieces.iter().all(|p| p.size <= 20.0 && p.letters.count() > 0), "{name}");
        }
    }

    #[test]
    fn too_many_pieces_are_too_many() {
        let (frame, to_screen) = screen("overlap");
        let mut pieces = Vec::new();
        assert!(!cut(&frame, to_screen, WINDOW, 20.0, 5000, &mut pieces));
        assert!(pieces.len() <= 5000);
        for name in NASTY {
            let (frame, to_screen) = screen(name);
            cut_at_random(&frame, to_screen, WINDOW, 20.0, 500, &mut pieces);
            assert!(pieces.len() > 400, "{name}: {}", pieces.len());
            assert!(pieces.iter().all(|p| p.size <= 20.0 && p.letters.count() > 0), "{name}");
        }
    }

    #[test]
    fn outside_of_the_window_there_are_none() {
        let (frame, to_screen) = screen("gasket");
        let away = Affine2::from_row([1.0, 0.0, 0.0, 1.0, 1e4, 0.0]) * to_screen;
        let mut pieces = Vec::new();
        assert!(cut(&frame, away, WINDOW, 20.0, 1000, &mut pieces) && pieces.is_empty());
        cut_at_random(&frame, away, WINDOW, 20.0, 100, &mut pieces);
        assert!(pieces.is_empty());
    }
}
