//! A bent picture as points.

use std::ops::Range;

use glam::DVec2;

use super::{Bent, Cut, Cutter, Fineness, Moving, Placed};
use crate::pieces::frame::Frame;
use crate::pieces::letters::Letters;
use crate::plan::{Batch, Detail, Plan};
use crate::points::Instance;

/// A [`Plan`] of a bent attractor: pieces so small that each is placed by one map, with a cloud as fine as the piece is
/// stretched there.
#[derive(Debug, Default)]
pub struct BentPlan {
    /// What is drawn.
    pub plan: Plan,
    cutter: Cutter,
    /// Pieces of about one size together.
    buckets: Vec<Vec<Instance>>,
    /// The instances of each bucket, once they are in the plan.
    groups: Vec<Range<u32>>,
    /// The vertices of the cloud of each bucket, as far as it is known, and how fine they are.
    clouds: Vec<Option<Range<u32>>>,
    detail: Option<Detail>,
    coloured: bool,
}

/// The size of the pieces in the first bucket, in pixels. In each of the others they are larger by the root of 2.
const SMALLEST_BUCKET: f64 = 0.25;
const BUCKETS: usize = 27;

fn bucket(size: f64) -> usize {
    // A cast of what is no number gives 0.
    ((2.0 * (size / SMALLEST_BUCKET).log2()).ceil() as usize).min(BUCKETS - 1)
}

fn largest(bucket: usize) -> f64 {
    SMALLEST_BUCKET * 2.0_f64.powf(0.5 * bucket as f64)
}

impl BentPlan {
    /// Begins to plan, for so many pieces at most. With `coloured` pieces have the colours that the bend carries.
    pub fn begin(&mut self, bent: &Bent<'_>, most: usize, coloured: bool) {
        self.cutter.begin(bent, most);
        self.coloured = coloured;
        self.clear(bent);
        // Another shape has other clouds.
        self.detail = None;
    }

    /// Visits at most so many pieces. With `moving` they are kept, to be followed.
    pub fn run(
        &mut self,
        bent: &Bent<'_>,
        fineness: &Fineness,
        visits: u64,
        mut moving: Option<&mut Moving>,
    ) -> Cut {
        let (buckets, coloured) = (&mut self.buckets, self.coloured);
        let cut = self.cutter.run(bent, fineness, visits, |piece| {
            let tint = if coloured { bent.tint(&piece.cursor) } else { 0 };
            put(buckets, &piece.placed, piece.letters, tint);
            if let Some(moving) = &mut moving {
                moving.push(piece.cursor, piece.letters, tint);
            }
        });
        self.plan.exact = cut == Cut::Complete;
        cut
    }

    /// Takes all pieces out, to put in others of the same shape.
    fn clear(&mut self, bent: &Bent<'_>) {
        self.buckets.resize_with(BUCKETS, Vec::new);
        self.buckets.iter_mut().for_each(Vec::clear);
        self.plan.sides = bent.sides.to_card();
        self.plan.tinted = self.coloured;
        self.plan.exact = false;
    }

    /// Puts the pieces that were kept where they are when the control points of the mesh are displaced so.
    pub fn follow(&mut self, bent: &Bent<'_>, displacements: &[DVec2], moving: &mut Moving) {
        self.clear(bent);
        let buckets = &mut self.buckets;
        moving.follow(bent, displacements, |placed, letters, tint| put(buckets, placed, letters, tint));
    }

    /// Gives the pieces their clouds. May be called again for another detail.
    pub fn compose(&mut self, frame: &Frame, detail: Detail) {
        if self.buckets.iter().any(|pieces| !pieces.is_empty()) || self.groups.is_empty() {
            self.plan.instances.clear();
            self.groups.clear();
            for pieces in &mut self.buckets {
                let first = self.plan.instances.len() as u32;
                self.plan.instances.append(pieces);
                self.groups.push(first..self.plan.instances.len() as u32);
            }
        }
        if self.detail != Some(detail) {
            self.detail = Some(detail);
            self.plan.vertices.clear();
            self.clouds.clear();
            self.clouds.resize(BUCKETS, None);
        }
        self.plan.batches.clear();
        for (bucket, instances) in self.groups.iter().enumerate().filter(|(_, group)| !group.is_empty()) {
            let known = self.clouds[bucket].take();
            let vertices = known.unwrap_or_else(|| self.plan.cloud(frame, largest(bucket), detail));
            self.clouds[bucket] = Some(vertices.clone());
            self.plan.batches.push(Batch { vertices, instances: instances.clone() });
        }
    }

    /// Bytes that it holds for each point that is drawn from it.
    #[must_use]
    pub fn bytes_a_point(&self) -> f64 {
        let bytes = size_of_val(&self.plan.instances[..]) + size_of_val(&self.plan.vertices[..]);
        bytes as f64 / self.plan.points().max(1) as f64
    }
}

fn put(buckets: &mut [Vec<Instance>], placed: &Placed, letters: Letters, tint: u32) {
    if let Some(pieces) = buckets.get_mut(bucket(placed.size())) {
        pieces.push(placed.to_card(letters, tint));
    }
}
