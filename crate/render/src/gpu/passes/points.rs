//! Pictures of planned points.

use crate::gpu::device::Gpu;
use crate::gpu::interface::{Buffer, Usage};
use crate::gpu::target::{Paint, Target};
use crate::plan::{Batch, Plan};
use crate::points::{Instance, Vertex};

/// A [`Plan`] that is drawn, all at once or bit by bit.
#[derive(Debug)]
pub(in crate::gpu) struct PointsPass {
    vertices: Buffer,
    instances: Buffer,
    /// What is drawn next: a batch, and an instance within it.
    next: (usize, u32),
    clear: bool,
}

impl PointsPass {
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            vertices: Buffer::new(&gpu.card, "vertices", Usage::Items),
            instances: Buffer::new(&gpu.card, "instances", Usage::Items),
            next: (0, 0),
            clear: true,
        }
    }

    /// Begins to draw what was points_pass.
    pub fn begin(&mut self, gpu: &Gpu, plan: &Plan, target: &Target) {
        self.vertices.fill(&gpu.card, &plan.vertices);
        self.instances.fill(&gpu.card, &plan.instances);
        target.prepare(gpu, 1.0, plan.tinted, plan.sides);
        self.next = (0, 0);
        self.clear = true;
    }

    /// Draws about `budget` more points. Returns whether all are drawn.
    pub fn go_on(&mut self, gpu: &Gpu, paint: Paint<'_>, plan: &Plan, target: &Target, budget: u64) -> bool {
        let portion = self.portion(plan, budget);
        target.draw(gpu, paint, self.clear, &self.vertices, &self.instances, &portion);
        self.clear = false;
        self.next.0 >= plan.batches.len()
    }

    /// Draws dots on what was drawn before, once all points are.
    pub fn dots(&mut self, gpu: &Gpu, paint: Paint<'_>, target: &Target, dots: &[Instance]) {
        self.vertices.fill(&gpu.card, &[Vertex::DOT]);
        self.instances.fill(&gpu.card, dots);
        let all = Batch { vertices: 0..1, instances: 0..dots.len() as u32 };
        target.draw(gpu, paint, false, &self.vertices, &self.instances, &[all]);
    }

    /// The batches of the next points.
    fn portion(&mut self, plan: &Plan, mut budget: u64) -> Vec<Batch> {
        let mut portion = Vec::new();
        while let Some(batch) = plan.batches.get(self.next.0) {
            let instance = self.next.1;
            let each = batch.vertices.len() as u64;
            let waiting = batch.instances.len() as u32 - instance;
            let fit = (budget / each.max(1)).min(u64::from(waiting)) as u32;
            // One at least, or there would be no end.
            let count = if portion.is_empty() { fit.max(waiting.min(1)) } else { fit };
            let first = batch.instances.start + instance;
            portion.push(Batch { vertices: batch.vertices.clone(), instances: first..first + count });
            budget = budget.saturating_sub(each * u64::from(count));
            if count < waiting {
                self.next.1 += count;
                break;
            }
            self.next = (self.next.0 + 1, 0);
        }
        portion
    }
}
