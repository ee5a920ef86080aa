//! Descent on pairs of words in f32, with a stack of fixed size. Shader twin: the middle part of
//! crate/render/shader/locus.wgsl.

use glam::{Vec2, Vec4};

use super::support::{Map, SupportTable, image, norm, product, pulled};

/// The most maps of a system.
pub(super) const MAX_MAPS: usize = 8;
/// How far a descent can go back. It may go deeper: that finds points that touch all the same.
const STACK_SIZE: usize = 64;
/// Directions tried on a pair.
const DIRECTIONS_PER_PAIR: usize = 2;
/// Keeps divisors above zero; f32 may lose what is smaller.
const SMALLEST_DIVISOR: f32 = 1e-30;
/// Where nothing is known of a distance yet.
const FAR: f32 = 1e9;

/// Two pieces: their matrices, and the step from the middle of the first to that of the second. Differences of
/// middles lose less to rounding than the middles would.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pair {
    pub a: Vec4,
    pub b: Vec4,
    pub step: Vec2,
}

/// What was found out about a pair.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    /// A lower bound of the distance, 0 where the two may meet.
    pub apart: f32,
    /// How near their middles are, against what reaches from one to the other.
    pub overlap: f32,
    /// The square of the distance of two points, one of each piece.
    pub reach: f32,
}

/// How a descent ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// All parts are apart.
    Apart,
    /// Two points come within the resolution.
    Met,
    /// The budget, the stack or the precision of f32 did not suffice.
    Unknown,
}

/// Everything that is the same for all pairs of one system. Lengths are in units of the frame, where the attractor lies
/// in the unit disc.
#[derive(Clone, Debug)]
pub(super) struct Descent<'a> {
    pub maps: &'a [Map],
    pub table: SupportTable,
    /// How far the distance of two computed pieces may be off.
    pub margin: f32,
    /// Pieces within this distance touch.
    pub resolution: f32,
    /// The same over the diameter of the attractor: pairs whose stretches sum up to less are that small.
    pub small: f32,
    /// Pairs looked at.
    pub looks: u32,
    /// The square of the least distance known between points of the two pieces that are descended on.
    pub reach: f32,
    /// A lower bound of their distance, when all parts are apart.
    pub lower: f32,
}

impl Descent<'_> {
    /// Bounds the distance of two pieces: along the line between their middles, then along a better one (a step of
    /// Frank & Wolfe's algorithm on their difference).
    pub fn look(&self, pair: &Pair) -> Look {
        let mut seen = Look { apart: 0.0, overlap: FAR, reach: FAR };
        let mut normal = pair.step;
        for _ in 0..DIRECTIONS_PER_PAIR {
            let (far_a, p) = self.table.support(pulled(pair.a, normal));
            let (far_b, q) = self.table.support(-pulled(pair.b, normal));
            let along = normal.dot(pair.step);
            let far = far_a + far_b;
            let between = pair.step + image(pair.b, q) - image(pair.a, p);
            seen.reach = seen.reach.min(between.dot(between));
            let length = normal.dot(normal).sqrt();
            let off = along - far - self.margin * length;
            if off > 0.0 {
                seen.apart = off / length;
                return seen;
            }
            seen.overlap = seen.overlap.min(along / far.max(SMALLEST_DIVISOR));
            let turn = normal - between;
            let t = (normal.dot(turn) / turn.dot(turn).max(SMALLEST_DIVISOR)).clamp(0.0, 1.0);
            normal -= turn * t;
        }
        seen
    }

    /// The part `index` of the larger piece, which is the first or the second, with the other.
    fn part(&self, whole: &Pair, index: usize, first: bool) -> Pair {
        let map = &self.maps[index];
        if first {
            let step = whole.step - image(whole.a, map.shift);
            Pair { a: product(whole.a, map.linear), step, ..*whole }
        } else {
            let step = whole.step + image(whole.b, map.shift);
            Pair { b: product(whole.b, map.linear), step, ..*whole }
        }
    }

    /// Whether two points at this squared distance show that pieces touch.
    pub fn touch(&self, reach: f32) -> bool {
        reach <= self.resolution * self.resolution
    }

    /// Descends on a pair that may meet, depth first, parts that overlap most before their sisters. Parts are let go
    /// once they are apart by `shade` times the least distance known: with 0 that settles whether the two meet, with
    /// nearly 1 how far apart they are. `limit` bounds the looks, counted on from those of the descents before.
    pub fn descend(&mut self, root: Pair, shade: f32, limit: u32) -> End {
        let mut stack = [Pair::default(); STACK_SIZE];
        // The parts to look into at each level, three bits each in their order, their number from bit 24 on, and
        // whether it is the first piece that was split in bit 31.
        let mut plans = [0_u32; STACK_SIZE];
        let mut level = 0;
        // The first level that is still remembered.
        let mut floor = 0;
        stack[0] = root;
        let mut fresh = true;
        self.lower = FAR;
        loop {
            let pair = stack[level % STACK_SIZE];
            if fresh {
                let sizes = norm(pair.a) + norm(pair.b);
                if sizes <= self.small && shade == 0.0 {
                    return End::Met;
                }
                if sizes <= self.margin || self.looks >= limit {
                    return End::Unknown;
                }
                let first = pair.a.dot(pair.a) >= pair.b.dot(pair.b);
                let mut keys = [FAR; MAX_MAPS];
                let mut kept = 0_u32;
                for (index, key) in keys[..self.maps.len()].iter_mut().enumerate() {
                    let seen = self.look(&self.part(&pair, index, first));
                    self.looks += 1;
                    self.reach = self.reach.min(seen.reach);
                    if self.touch(seen.reach) {
                        return End::Met;
                    }
                    if seen.apart > 0.0 && seen.apart * seen.apart >= shade * shade * self.reach {
                        self.lower = self.lower.min(seen.apart);
                    } else {
                        *key = if seen.apart > 0.0 { 2.0 + seen.apart } else { seen.overlap.min(2.0) };
                        kept += 1;
                    }
                }
                let mut plan = kept << 24 | u32::from(first) << 31;
                for place in 0..kept {
                    let mut least = 0;
                    for index in 1..self.maps.len() {
                        if keys[index] < keys[least] {
                            least = index;
                        }
                    }
                    keys[least] = FAR;
                    plan |= (least as u32) << (3 * place);
                }
                plans[level % STACK_SIZE] = plan;
            }
            let plan = plans[level % STACK_SIZE];
            if plan >> 24 & 15 == 0 {
                if level == floor {
                    return if floor == 0 { End::Apart } else { End::Unknown };
                }
                level -= 1;
                fresh = false;
                continue;
            }
            // The next part goes, the others move up.
            let rest = (plan & 0x00ff_ffff) >> 3;
            plans[level % STACK_SIZE] = rest | ((plan & 0xff00_0000) - (1 << 24));
            level += 1;
            floor = floor.max((level + 1).saturating_sub(STACK_SIZE));
            stack[level % STACK_SIZE] = self.part(&pair, (plan & 7) as usize, plan >> 31 == 1);
            fresh = true;
        }
    }
}
