//! Deciding a locus on the graphics card, by a compute shader.

use std::borrow::Cow;
use std::cell::Cell;
use std::future::Future;
use std::pin::Pin;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Poll, Waker};

use bytemuck::{Pod, Zeroable};
use thiserror::Error;

use super::webgpu::{adapter, name};

/// What is to be decided, as `frond_locus::SingleLocus` gives it.
#[derive(Clone, Copy, Debug)]
pub struct LocusJob<'a> {
    /// The number of maps, 1 to 8.
    pub maps: usize,
    /// Relative to the diameter of each attractor.
    pub epsilon: f32,
    /// For each column its part of every map.
    pub columns: &'a [[f32; 8]],
    /// The same for each row.
    pub rows: &'a [[f32; 8]],
}

/// Why there is no answer.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum LocusError {
    /// There is no adapter, or none that computes.
    #[error("There is no graphics card that computes here ({detail}). Use the processor.")]
    NoGpu {
        /// What was said about it.
        detail: String,
    },
    /// No maps, too many, or too many samples.
    #[error("A graphics card decides up to 8 maps and 16 million samples at once. Use the processor.")]
    Size,
    /// The device was lost.
    #[error("The graphics device was lost. Open another, or use the processor.")]
    Lost,
    /// The device refused what it was told.
    #[error("The graphics card does not do this ({detail}). Use the processor.")]
    Fault {
        /// What it said.
        detail: String,
    },
}

impl LocusError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoGpu { .. } => "no-gpu",
            Self::Size => "gpu-size",
            Self::Lost => "device-lost",
            Self::Fault { .. } => "gpu-fault",
        }
    }
}

/// A device that decides loci. It draws nothing, so that it needs no canvas, and may live in a worker.
#[derive(Debug)]
pub struct LocusGpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    pipeline: wgpu::ComputePipeline,
    bindings: wgpu::BindGroupLayout,
    trouble: Arc<Trouble>,
    /// The most samples of one command.
    pub at_once: Cell<u32>,
    /// The name of the graphics card, as far as is told.
    pub description: String,
    /// Whether the processor stands in for a graphics card: then nothing is won.
    pub software: bool,
}

/// What a device tells on its own.
#[derive(Debug, Default)]
struct Trouble {
    lost: AtomicBool,
    fault: Mutex<Option<String>>,
}

/// The first member of a uniform buffer must match the shader's `Job`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct Job {
    maps: u32,
    epsilon: f32,
    width: u32,
    height: u32,
    first: u32,
    padding: [u32; 3],
}

/// Samples along each side of a workgroup.
const WORKGROUP_SIDE: u32 = 8;
/// The most samples of one command, at first and where a card is quick: each takes microseconds of one core of the card
/// at most, and a card that does not answer for seconds is taken to hang. A large card is not half busy with the
/// former: an NVIDIA H200 takes 22 to 76 ms for 1024 x 1024 samples in commands of the former size, 10 to 23 ms in one.
const SAMPLES_AT_ONCE: [u32; 2] = [1 << 15, 1 << 20];
/// Milliseconds of a command that is soon done, which is a frame, and of one that takes too long.
const SOON_MS: f64 = 16.0;
const LATE_MS: f64 = 50.0;
/// The most samples of a job.
const MOST_SAMPLES: usize = 1 << 24;

impl LocusGpu {
    /// The most maps of a system.
    pub const MAX_MAPS: usize = 8;

    /// Opens a device of its own on the fastest adapter.
    ///
    /// # Errors
    /// [`LocusError::NoGpu`].
    pub async fn open() -> Result<Self, LocusError> {
        let no_gpu = |detail: String| LocusError::NoGpu { detail };
        let (_, adapter) = adapter().await.map_err(no_gpu)?;
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("locus"),
            required_limits: wgpu::Limits::downlevel_defaults(),
            ..wgpu::DeviceDescriptor::default()
        };
        let (device, queue) = adapter.request_device(&descriptor).await.map_err(|e| no_gpu(e.to_string()))?;
        let trouble = Arc::new(Trouble::default());
        trouble.watch(&device);
        let (pipeline, bindings) = pipeline(&device);
        let description = name(&adapter).await;
        let is_cpu = adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        let software = super::is_software(is_cpu, &description);
        let at_once = Cell::new(SAMPLES_AT_ONCE[0]);
        Ok(Self { device, queue, pipeline, bindings, trouble, at_once, description, software })
    }

    /// Decides all samples, row by row from the bottom: for each the bits of the gap, with the number of the state in
    /// the lowest three (`frond_locus::unpack_single`).
    ///
    /// # Errors
    /// All but [`LocusError::NoGpu`].
    pub async fn run(&self, job: LocusJob<'_>) -> Result<Vec<u32>, LocusError> {
        self.begin(job)?.answers().await
    }

    /// Has the card begin with it.
    ///
    /// # Errors
    /// All but [`LocusError::NoGpu`].
    pub fn begin(&self, job: LocusJob<'_>) -> Result<Deciding<'_>, LocusError> {
        let LocusJob { maps, epsilon, columns, rows } = job;
        if !(1..=Self::MAX_MAPS).contains(&maps) || columns.len() % maps != 0 || rows.len() % maps != 0 {
            return Err(LocusError::Size);
        }
        let (width, height) = (columns.len() / maps, rows.len() / maps);
        let samples = width.checked_mul(height).filter(|n| *n <= MOST_SAMPLES).ok_or(LocusError::Size)?;
        if samples == 0 {
            return Ok(Deciding { gpu: self, back: None });
        }
        self.trouble.check()?;
        let (width, height) = (width as u32, height as u32);
        let input = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
        let columns = self.filled("columns", input, bytemuck::cast_slice(columns));
        let rows = self.filled("rows", input, bytemuck::cast_slice(rows));
        let size = samples as u64 * 4;
        let answers =
            self.buffer("answers", wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC, size);
        let back = self.buffer("read", wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST, size);
        let band = (self.at_once.get() / width).next_multiple_of(WORKGROUP_SIDE).max(WORKGROUP_SIDE);
        for first in (0..height).step_by(band as usize) {
            let own = Job { maps: maps as u32, epsilon, width, height, first, padding: [0; 3] };
            let uniform = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST;
            let job = self.filled("job", uniform, bytemuck::bytes_of(&own));
            self.dispatch([&job, &columns, &rows, &answers], width, band.min(height - first));
        }
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(&answers, 0, &back, 0, size);
        self.queue.submit([encoder.finish()]);
        Ok(Deciding { gpu: self, back: Some(back) })
    }

    /// Tells how many milliseconds so many samples took: where commands are soon done the next ones are larger, where
    /// they take long they are smaller.
    pub fn took(&self, samples: usize, milliseconds: f64) {
        let [least, most] = SAMPLES_AT_ONCE;
        let at_once = self.at_once.get();
        let commands = samples.div_ceil(at_once as usize).max(1);
        let each = milliseconds / commands as f64;
        if each < SOON_MS && commands > 1 {
            self.at_once.set((at_once * 2).min(most));
        } else if each > LATE_MS {
            self.at_once.set((at_once / 2).max(least));
        }
    }

    /// Waits until the card has done all that it was asked.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn finish(&self) {
        let _ = self.device.poll(wgpu::PollType::wait_indefinitely());
    }

    fn buffer(&self, label: &str, usage: wgpu::BufferUsages, size: u64) -> wgpu::Buffer {
        let descriptor =
            wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false };
        self.device.create_buffer(&descriptor)
    }

    fn filled(&self, label: &str, usage: wgpu::BufferUsages, bytes: &[u8]) -> wgpu::Buffer {
        let buffer = self.buffer(label, usage, bytes.len() as u64);
        self.queue.write_buffer(&buffer, 0, bytes);
        buffer
    }

    /// One command of its own, so that the card has time for others in between.
    fn dispatch(&self, buffers: [&wgpu::Buffer; 4], width: u32, rows: u32) {
        let entries: Vec<_> = buffers
            .iter()
            .enumerate()
            .map(|(k, buffer)| wgpu::BindGroupEntry {
                binding: k as u32,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let bindings = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("locus"),
            layout: &self.bindings,
            entries: &entries,
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &bindings, &[]);
            pass.dispatch_workgroups(width.div_ceil(WORKGROUP_SIDE), rows.div_ceil(WORKGROUP_SIDE), 1);
        }
        self.queue.submit([encoder.finish()]);
    }
}

/// What the card works on.
#[derive(Debug)]
pub struct Deciding<'a> {
    gpu: &'a LocusGpu,
    back: Option<wgpu::Buffer>,
}

impl Deciding<'_> {
    /// The answers, once they have come: see [`LocusGpu::run`].
    ///
    /// # Errors
    /// [`LocusError::Lost`] and [`LocusError::Fault`].
    pub async fn answers(self) -> Result<Vec<u32>, LocusError> {
        let Some(back) = self.back else { return Ok(Vec::new()) };
        let arrival = Arrival::default();
        let told = arrival.clone();
        back.map_async(wgpu::MapMode::Read, .., move |result| told.tell(result.is_ok()));
        // The browser looks after itself.
        #[cfg(not(target_arch = "wasm32"))]
        self.gpu.finish();
        let arrived = arrival.await;
        self.gpu.trouble.check()?;
        match back.slice(..).get_mapped_range() {
            Ok(bytes) if arrived => Ok(bytemuck::pod_collect_to_vec(&bytes)),
            _ => Err(LocusError::Lost),
        }
    }
}

impl Drop for LocusGpu {
    fn drop(&mut self) {
        self.device.destroy();
    }
}

impl Trouble {
    fn watch(self: &Arc<Self>, device: &wgpu::Device) {
        let own = Arc::clone(self);
        device.set_device_lost_callback(move |_, _| own.lost.store(true, Ordering::Relaxed));
        let own = Arc::clone(self);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            hold(&own.fault).get_or_insert(error.to_string());
        }));
    }

    fn check(&self) -> Result<(), LocusError> {
        if self.lost.load(Ordering::Relaxed) {
            return Err(LocusError::Lost);
        }
        match hold(&self.fault).clone() {
            Some(detail) => Err(LocusError::Fault { detail }),
            None => Ok(()),
        }
    }
}

fn hold<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Waits for a callback.
#[derive(Clone, Debug, Default)]
struct Arrival(Arc<Mutex<(Option<bool>, Option<Waker>)>>);

impl Arrival {
    fn tell(&self, well: bool) {
        let mut state = hold(&self.0);
        state.0 = Some(well);
        let waker = state.1.take();
        drop(state);
        if let Some(waker) = waker {
            waker.wake();
        }
    }
}

impl Future for Arrival {
    type Output = bool;

    fn poll(self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<bool> {
        let mut state = hold(&self.0);
        state.0.map_or_else(
            || {
                state.1 = Some(context.waker().clone());
                Poll::Pending
            },
            Poll::Ready,
        )
    }
}

fn pipeline(device: &wgpu::Device) -> (wgpu::ComputePipeline, wgpu::BindGroupLayout) {
    let source =
        wgpu::ShaderSource::Wgsl(Cow::Borrowed(include_str!(concat!(env!("OUT_DIR"), "/locus.wgsl"))));
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some("locus"), source });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("locus"),
        layout: None,
        module: &module,
        entry_point: Some("decide_samples"),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });
    let bindings = pipeline.get_bind_group_layout(0);
    (pipeline, bindings)
}
