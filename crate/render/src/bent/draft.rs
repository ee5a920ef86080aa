//! A bent picture by points, on the processor: quickly enough for every frame of what moves, or complete with a sweep
//! of what they leave dark.

use frond_deform::Cursor;
use glam::Vec2;

use super::{Bent, BentSweep, Fineness, Placed, Verdict};
use crate::picture::bitmap::Bitmap;
use crate::picture::colour::code_of_colour;
use crate::picture::window::Window;
use crate::pieces::letters::Letters;
use crate::splat::all_lit;
use crate::splat::cloud::{Cloud, Clouds};

/// The largest pieces that points are drawn for, in pixels, and of one colour where the bend carries colours.
const PIECE: f64 = 48.0;
const COLOURED_PIECE: f64 = 6.0;
/// The distance of points, in pixels.
const SPACING: f64 = 0.85;
/// How far off a point may be drawn, in pixels.
const TOLERANCE: f64 = 1.0;
/// Pieces of this size are not cut any more where a bend is uneven, in pixels; with too many visits of pieces, the next
/// size is tried.
const FLOORS: [f64; 3] = [8.0, 16.0, 32.0];
const MOST_VISITS: u32 = 40_000;
/// The same before a picture is left to a sweep alone.
const MOST_OF_COMPLETE: u32 = 150_000;
/// Points for each pixel of the window, and on top, before the same.
const MOST_POINTS: (usize, usize) = (6, 500_000);

/// The distance of points where a sweep comes after them.
const COMPLETE_SPACING: f64 = 0.6;

/// The codes of a picture of a bent attractor, one a pixel, row after row: of colours that the bend carries where they
/// are `coloured`, else of letters.
#[must_use]
pub fn draft_codes(bent: &Bent<'_>, coloured: bool) -> Vec<u32> {
    let mut clouds = Clouds::new(bent.frame, PIECE, SPACING);
    let mut draft = Draft { window: bent.window, codes: Vec::new() };
    for (attempt, floor) in FLOORS.into_iter().enumerate() {
        let size = if coloured { COLOURED_PIECE.max(floor) } else { PIECE };
        let fineness = Fineness { floor, tolerance: TOLERANCE, ..Fineness::complete(size) };
        if draft.pieces(bent, &mut clouds, &fineness, coloured, (MOST_VISITS, attempt + 1 == FLOORS.len())) {
            break;
        }
    }
    draft.finish()
}

/// The codes of the complete picture, as a sweep finds them. Where they are of letters, points light most pixels first.
#[must_use]
pub fn complete_codes(bent: &Bent<'_>, detail: f64, coloured: bool) -> Vec<u32> {
    let mut sweep = BentSweep::new();
    let mut draft = Draft { window: bent.window, codes: Vec::new() };
    let mut points = |most| {
        let mut clouds = Clouds::new(bent.frame, PIECE, COMPLETE_SPACING);
        draft.pieces(bent, &mut clouds, &Fineness::complete(PIECE), false, (most, false))
    };
    if coloured || !points(MOST_OF_COMPLETE) {
        sweep.begin(bent, detail, coloured);
        sweep.run(bent, u64::MAX);
        return sweep.into_codes();
    }
    let (mut codes, width) = (draft.finish(), bent.window.width as usize);
    let mut settled = Bitmap::new(bent.window);
    for letter in (0..bent.frame.maps.len()).rev() {
        let least = Letters::NONE.then(letter).code();
        // Later maps lie on top of this one.
        settled.light_where(&codes, |code| *code >= least);
        sweep.begin_piece_on(bent, detail, letter, &settled);
        sweep.find(bent, u64::MAX, &mut |(x, y), code| codes[y as usize * width + x as usize] = code);
    }
    codes
}

struct Draft {
    window: Window,
    codes: Vec<u32>,
}

impl Draft {
    fn finish(mut self) -> Vec<u32> {
        self.codes.truncate(self.window.area());
        self.codes
    }

    /// Draws all pieces in the window, later ones first. Returns whether these were not too many; if they are the
    /// `last` that are tried, what is left is drawn without being cut.
    fn pieces(
        &mut self,
        bent: &Bent<'_>,
        clouds: &mut Clouds,
        fineness: &Fineness,
        coloured: bool,
        (most, last): (u32, bool),
    ) -> bool {
        self.codes.clear();
        // One more than there are pixels: points outside of the window go there.
        self.codes.resize(self.window.area() + 1, 0);
        let most_points = MOST_POINTS.0 * self.window.area() + MOST_POINTS.1;
        let code = |cursor: &Cursor, letters: Letters| {
            if coloured { code_of_colour(bent.tint(cursor)) } else { letters.code() }
        };
        let (mut visits, mut points) = (0, 0);
        let mut stack: Vec<(Cursor, Letters, usize)> = vec![(bent.bend.whole(), Letters::NONE, 0)];
        while let Some((cursor, letters, depth)) = stack.pop() {
            visits += 1;
            if visits > most || points > most_points {
                if !last {
                    return false;
                }
                if points > 2 * most_points {
                    break;
                }
                let placed = bent.placed(&cursor);
                points += self.stamp(&placed, clouds.for_size(placed.size()), code(&cursor, letters));
                continue;
            }
            let (verdict, extent) = bent.judge(&cursor, depth, 1.0, fineness);
            let Some(extent) = extent else { continue };
            if all_lit(&self.codes, self.window, extent.pixels) {
                continue;
            }
            match verdict {
                Verdict::Outside => {}
                Verdict::Whole(placed) | Verdict::Rough(placed) => {
                    points += self.stamp(&placed, clouds.for_size(placed.size()), code(&cursor, letters));
                }
                Verdict::Split => {
                    stack.extend(
                        (0..bent.frame.maps.len()).map(|letter| {
                            (bent.bend.child(&cursor, letter), letters.then(letter), depth + 1)
                        }),
                    );
                }
            }
        }
        true
    }

    /// Lights dark pixels with the points of a piece. Returns how many points there are.
    fn stamp(&mut self, placed: &Placed, cloud: &Cloud, code: u32) -> usize {
        let Placed { map, twist, along, up } = placed;
        let (linear, middle) = (map.linear.as_mat2(), map.translation.as_vec2());
        let [twist, along, up] = [twist, along, up].map(|v| v.as_vec2());
        let size = Vec2::new(self.window.width as f32, self.window.height as f32);
        for point in &cloud.points {
            let at = Vec2::from(point.position);
            let at = linear * at + middle + twist * (along.dot(at) * up.dot(at));
            // What is no number is outside as well.
            let inside = at.x >= 0.0 && at.y >= 0.0 && at.x < size.x && at.y < size.y;
            let pixel = (at.y as usize).wrapping_mul(self.window.width as usize).wrapping_add(at.x as usize);
            let pixel = if inside { pixel } else { self.window.area() };
            if let Some(pixel) = self.codes.get_mut(pixel) {
                *pixel = if *pixel == 0 { code } else { *pixel };
            }
        }
        cloud.points.len()
    }
}

#[cfg(test)]
mod tests {
    use frond_deform::{Bend, Continuity, Settings, Spin, Tint};

    use super::*;
    use crate::bent::tests::{Subject, WINDOW, mesh, settings};
    use crate::testing::NASTY;

    fn swept(subject: &Subject, coloured: bool) -> Vec<u32> {
        let (bent, mut sweep) = (subject.bent(), BentSweep::new());
        sweep.begin(&bent, 0.0625, coloured);
        sweep.run(&bent, u64::MAX);
        sweep.into_codes()
    }

    /// Whether a pixel, or one beside it, is lit.
    fn lit_near(codes: &[u32], at: usize) -> bool {
        let (width, height) = (WINDOW.width as usize, WINDOW.height as usize);
        let (x, y) = (at % width, at / width);
        let mut rows = y.saturating_sub(1)..(y + 2).min(height);
        rows.any(|y| (x.saturating_sub(1)..(x + 2).min(width)).any(|x| codes[y * width + x] > 0))
    }

    /// How many of the pixels that one picture lights lie beside no pixel of the other.
    fn apart(of: &[u32], from: &[u32]) -> usize {
        (0..of.len()).filter(|at| of[*at] > 0 && !lit_near(from, *at)).count()
    }

    #[test]
    fn drafts_are_nowhere_a_pixel_away_from_what_a_sweep_finds() {
        for name in ["right gasket", "gasket", "dragon", "carpet", "fern", "koch", "square"] {
            for (share, settings) in [
                (0.0, settings(0.0, 9.0, 0.5, Spin::None)),
                (0.15, settings(0.0, 9.0, 0.75, Spin::None)),
                (0.1, Settings { continuity: Continuity::Published, ..settings(0.0, 6.0, 0.5, Spin::None) }),
            ] {
                let subject = Subject::plain(name, share, settings);
                let (drawn, truth) = (draft_codes(&subject.bent(), false), swept(&subject, false));
                let count = truth.iter().filter(|code| **code > 0).count();
                let (beside, missed) = (apart(&drawn, &truth), apart(&truth, &drawn));
                assert!(beside * 200 <= count, "{name} {share}: {beside} of {count} are not there");
                assert!(missed * 100 <= count, "{name} {share}: {missed} of {count} are missed");
                let first = |code: &u32| code.saturating_sub(1) >> 12;
                let both = drawn.iter().zip(&truth).filter(|(a, b)| **a > 0 && **b > 0);
                let other = both.filter(|(a, b)| first(a) != first(b)).count();
                assert!(other * 25 <= count, "{name} {share}: {other} of {count} are of another map");
            }
        }
    }

    #[test]
    fn with_a_sweep_of_what_is_dark_they_are_the_picture_of_a_sweep() {
        for name in ["right gasket", "dragon", "carpet", "fern", "koch", "dust", "singular"] {
            for (share, delta) in [(0.0, 0.5), (0.15, 0.75)] {
                let subject = Subject::plain(name, share, settings(0.0, 9.0, delta, Spin::None));
                let (drawn, truth) = (complete_codes(&subject.bent(), 0.0625, false), swept(&subject, false));
                let first = |code: &u32| code.div_ceil(1 << 12);
                let count = truth.iter().filter(|code| **code > 0).count();
                let differ = drawn.iter().zip(&truth).filter(|(a, b)| first(a) != first(b)).count();
                assert!(differ * 400 <= count, "{name} {share}: {differ} of {count}");
            }
        }
    }

    #[test]
    fn a_square_that_is_bent_has_no_hole() {
        let subject = Subject::plain("square", 0.1, settings(0.0, 9.0, 0.5, Spin::None));
        let mut drawn = draft_codes(&subject.bent(), false);
        crate::splat::close_holes(&mut drawn, WINDOW);
        let truth = swept(&subject, false);
        let width = WINDOW.width as usize;
        let full = |codes: &[u32], at: usize, side: usize| {
            (0..side).all(|dy| codes[at + dy * width..][..side].iter().all(|code| *code > 0))
        };
        let inside: Vec<usize> = (0..truth.len() - 5 * width)
            .filter(|at| at % width < width - 5 && full(&truth, *at, 5))
            .map(|at| at + 2 * width + 2)
            .collect();
        let dark = inside.iter().filter(|at| drawn[**at] == 0).count();
        assert!(inside.len() > 1000 && dark == 0, "{dark} of {}", inside.len());
    }

    #[test]
    fn points_are_where_a_piece_is_placed_however_it_is_twisted() {
        let subject = Subject::plain("square", 0.0, settings(0.0, 3.0, 0.5, Spin::None));
        let placed = Placed {
            map: frond_core::Affine2::from_row([30.0, 5.0, -4.0, 25.0, 60.0, 48.0]),
            twist: glam::DVec2::new(20.0, -12.0),
            along: glam::DVec2::X,
            up: glam::DVec2::Y,
        };
        let mut clouds = Clouds::new(subject.bent().frame, PIECE, SPACING);
        let mut draft = Draft { window: WINDOW, codes: vec![0; WINDOW.area()] };
        let cloud = clouds.for_size(PIECE);
        draft.stamp(&placed, cloud, 7);
        let mut seen = vec![0; WINDOW.area()];
        for point in &cloud.points {
            let at = placed.at(Vec2::from(point.position).as_dvec2());
            let pixel = WINDOW.pixel(at).map(|(x, y)| (y * WINDOW.width + x) as usize);
            pixel.into_iter().for_each(|pixel| seen[pixel] = 7);
        }
        let differ = draft.codes.iter().zip(&seen).filter(|(a, b)| a != b).count();
        assert!(seen.contains(&7) && differ <= 4, "{differ}");
    }

    #[test]
    fn what_overlaps_without_end_takes_no_more_points_than_there_may_be() {
        for name in NASTY {
            let subject = Subject::plain(name, 0.1, settings(0.0, 9.0, 0.75, Spin::None));
            let codes = draft_codes(&subject.bent(), false);
            // A mesh around so long a line takes all of it out of the window.
            let lit = codes.iter().any(|code| *code > 0) || *name == "slow line";
            assert!(lit && codes.len() == WINDOW.area(), "{name}");
        }
    }

    #[test]
    fn colours_are_those_that_the_bend_carries() {
        let colours = (0..16).map(|i| [f64::from(i) / 15.0, 0.5, 0.0]).collect();
        let tint = Tint { colours, kb: 0.0, ke: 0.0, roughness: 0.0, superposed: true };
        let settings = settings(0.0, 3.0, 0.3, Spin::None);
        let subject = Subject::new("square", |ifs| {
            Bend::new(ifs.maps(), mesh(ifs, 0.05, false), settings, Some(tint)).unwrap()
        });
        let (drawn, truth) = (draft_codes(&subject.bent(), true), swept(&subject, true));
        let red = |code: u32| f64::from((code - 1) >> 16);
        let both: Vec<_> = drawn.iter().zip(&truth).filter(|(a, b)| **a > 0 && **b > 0).collect();
        let differ = both.iter().filter(|(a, b)| (red(**a) - red(**b)).abs() > 40.0).count();
        assert!(both.len() > 1000 && differ * 50 < both.len(), "{differ} of {}", both.len());
    }
}
