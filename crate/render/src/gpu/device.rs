//! Which device there is and what it can do: the one place that asks.

use std::rc::Rc;

use js_sys::{Function, Promise, Reflect, global};
use thiserror::Error;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use wgpu::web_sys::{HtmlCanvasElement, OffscreenCanvas};

use super::events::{Event, Events, Loss};

/// Which interface to the graphics card is wanted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wanted {
    /// WebGPU, or WebGL2 where that is missing.
    #[default]
    Auto,
    /// WebGPU only.
    WebGpu,
    /// WebGL2 only.
    WebGl2,
}

/// What is drawn on.
#[derive(Clone, Debug)]
pub enum Canvas {
    /// A canvas of the page.
    Html(HtmlCanvasElement),
    /// One without a page, as in a worker.
    Offscreen(OffscreenCanvas),
}

impl Canvas {
    fn target(&self) -> wgpu::SurfaceTarget<'static> {
        match self.clone() {
            Self::Html(canvas) => wgpu::SurfaceTarget::Canvas(canvas),
            Self::Offscreen(canvas) => wgpu::SurfaceTarget::OffscreenCanvas(canvas),
        }
    }
}

/// Why there is no device.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum GpuError {
    /// Neither interface is there, or not the one that was asked for.
    #[error(
        "The browser offers no {wanted} for drawing ({detail}). Switch on hardware acceleration, or use \
         another browser."
    )]
    NoBackend {
        /// What was looked for.
        wanted: &'static str,
        /// What the browser said.
        detail: String,
    },
}

impl GpuError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoBackend { .. } => "no-gpu",
        }
    }
}

/// A device and the canvas that it draws on.
#[derive(Debug)]
pub struct Gpu {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    configured: bool,
    events: Events,
    /// `"webgpu"` or `"webgl2"`.
    pub backend: &'static str,
    /// The name of the graphics card, as far as the browser tells.
    pub description: String,
    /// Whether there is no graphics card, and the processor does its work: then points are dear.
    pub software: bool,
    /// The longest side of what can be drawn to.
    pub max_side: u32,
    /// The format for sums of weights.
    pub(super) sums: wgpu::TextureFormat,
    /// Whether that format can hold them. Almost every device has one; on others there are no densities,
    /// and colours are by map.
    pub(super) densities: bool,
}

impl Gpu {
    /// Opens a device for a canvas, and tells `listener` what happens to it.
    ///
    /// # Errors
    /// [`GpuError::NoBackend`].
    pub async fn open(
        canvas: &Canvas,
        wanted: Wanted,
        listener: Rc<dyn Fn(&Event)>,
    ) -> Result<Self, GpuError> {
        let mut refusal = String::from("not present");
        if cfg!(feature = "webgpu") && wanted != Wanted::WebGl2 {
            match Self::open_webgpu(canvas, &listener).await {
                Ok(gpu) => return Ok(gpu),
                Err(detail) => refusal = detail,
            }
        }
        if cfg!(feature = "webgl2") && wanted != Wanted::WebGpu {
            match Self::open_webgl2(canvas, &listener).await {
                Ok(gpu) => return Ok(gpu),
                Err(detail) => refusal = detail,
            }
        }
        let wanted = match wanted {
            Wanted::Auto => "WebGPU or WebGL2",
            Wanted::WebGpu => "WebGPU",
            Wanted::WebGl2 => "WebGL2",
        };
        Err(GpuError::NoBackend { wanted, detail: refusal })
    }

    async fn instance(backends: wgpu::Backends) -> wgpu::Instance {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = backends;
        wgpu::util::new_instance_with_webgpu_detection(descriptor).await
    }

    /// The device comes before the surface: a canvas that has once been used for WebGPU cannot go back.
    async fn open_webgpu(canvas: &Canvas, listener: &Rc<dyn Fn(&Event)>) -> Result<Self, String> {
        if !wgpu::util::is_browser_webgpu_supported().await {
            return Err("no WebGPU adapter".into());
        }
        let instance = Self::instance(wgpu::Backends::BROWSER_WEBGPU).await;
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..wgpu::RequestAdapterOptions::default()
        };
        let adapter = instance.request_adapter(&options).await.map_err(|e| e.to_string())?;
        // Sums of many small weights are truer in 32 bits, where these can be blended.
        let float32 = adapter.features() & wgpu::Features::FLOAT32_BLENDABLE;
        let device = Self::device(&adapter, float32).await?;
        let surface = instance.create_surface(canvas.target()).map_err(|e| e.to_string())?;
        let sums = if float32.is_empty() {
            wgpu::TextureFormat::Rgba16Float
        } else {
            wgpu::TextureFormat::Rgba32Float
        };
        Self::new("webgpu", &adapter, device, surface, sums, webgpu_names().await, listener)
    }

    /// The surface comes before the adapter: it is the WebGL context that everything else is made of.
    async fn open_webgl2(canvas: &Canvas, listener: &Rc<dyn Fn(&Event)>) -> Result<Self, String> {
        let instance = Self::instance(wgpu::Backends::GL).await;
        let surface = instance.create_surface(canvas.target()).map_err(|e| e.to_string())?;
        let options = wgpu::RequestAdapterOptions {
            compatible_surface: Some(&surface),
            ..wgpu::RequestAdapterOptions::default()
        };
        let adapter = instance.request_adapter(&options).await.map_err(|e| e.to_string())?;
        let device = Self::device(&adapter, wgpu::Features::empty()).await?;
        // Blending 32 bits needs an extension that wgpu does not look for.
        let half = wgpu::TextureFormat::Rgba16Float;
        let usages = adapter.get_texture_format_features(half).allowed_usages;
        let sums = if usages.contains(wgpu::TextureUsages::RENDER_ATTACHMENT) {
            half
        } else {
            wgpu::TextureFormat::Rgba8Unorm
        };
        let info = adapter.get_info();
        let names = join([info.name, info.driver, info.driver_info]);
        Self::new("webgl2", &adapter, device, surface, sums, names, listener)
    }

    async fn device(
        adapter: &wgpu::Adapter,
        features: wgpu::Features,
    ) -> Result<(wgpu::Device, wgpu::Queue), String> {
        let descriptor = wgpu::DeviceDescriptor {
            required_features: features,
            required_limits: wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits()),
            ..wgpu::DeviceDescriptor::default()
        };
        adapter.request_device(&descriptor).await.map_err(|e| e.to_string())
    }

    fn new(
        backend: &'static str,
        adapter: &wgpu::Adapter,
        (device, queue): (wgpu::Device, wgpu::Queue),
        surface: wgpu::Surface<'static>,
        sums: wgpu::TextureFormat,
        description: String,
        listener: &Rc<dyn Fn(&Event)>,
    ) -> Result<Self, String> {
        let mut config = surface.get_default_config(adapter, 1, 1).ok_or("the canvas cannot be drawn on")?;
        let capabilities = surface.get_capabilities(adapter);
        // Colours are sRGB already: the first format that leaves them alone.
        if let Some(format) = capabilities.formats.iter().find(|format| !format.is_srgb()) {
            config.format = *format;
        }
        // wgpu lists but one mode for canvases, yet hands this one to WebGPU. With WebGL it is the only one.
        if backend == "webgpu" {
            config.alpha_mode = wgpu::CompositeAlphaMode::PreMultiplied;
        }
        let events = Events::new(Rc::clone(listener));
        events.watch(&device);
        let software =
            super::is_software(adapter.get_info().device_type == wgpu::DeviceType::Cpu, &description);
        let max_side = device.limits().max_texture_dimension_2d;
        Ok(Self {
            device,
            queue,
            surface,
            config,
            configured: false,
            events,
            backend,
            description,
            software,
            max_side,
            sums,
            densities: sums != wgpu::TextureFormat::Rgba8Unorm,
        })
    }

    /// Sets the size of the canvas, in pixels.
    pub(super) fn resize(&mut self, width: u32, height: u32) {
        self.config.width = width;
        self.config.height = height;
        self.configured = width > 0 && height > 0 && !self.is_lost();
        if self.configured {
            self.surface.configure(&self.device, &self.config);
        }
    }

    /// The format of the canvas.
    pub(super) fn format(&self) -> wgpu::TextureFormat {
        self.config.format
    }

    /// What is shown next, if the canvas can be had now.
    pub(super) fn frame(&self) -> Option<wgpu::SurfaceTexture> {
        use wgpu::CurrentSurfaceTexture as Current;
        if !self.configured || self.is_lost() {
            return None;
        }
        match self.surface.get_current_texture() {
            Current::Success(frame) | Current::Suboptimal(frame) => return Some(frame),
            Current::Timeout | Current::Occluded => return None,
            _ => {}
        }
        // Outdated: once more with a new chain of frames.
        self.surface.configure(&self.device, &self.config);
        match self.surface.get_current_texture() {
            Current::Success(frame) | Current::Suboptimal(frame) => Some(frame),
            _ => None,
        }
    }

    /// Whether the device is lost, so that no call has an effect any more.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.events.is_lost()
    }

    /// A way to tell that the device is lost.
    #[must_use]
    pub fn loss(&self) -> Loss {
        self.events.loss()
    }

    /// Destroys the device, as if it had been lost.
    pub fn destroy(&self) {
        if !self.is_lost() {
            self.device.destroy();
            self.loss().tell("it was destroyed");
        }
    }
}

/// What WebGPU tells of its adapter, which wgpu does not pass on. Empty where anything is missing.
pub(super) async fn webgpu_names() -> String {
    async fn info() -> Result<JsValue, JsValue> {
        let gpu = Reflect::get(&Reflect::get(&global(), &"navigator".into())?, &"gpu".into())?;
        let request: Function = Reflect::get(&gpu, &"requestAdapter".into())?.dyn_into()?;
        let adapter = JsFuture::from(request.call0(&gpu)?.dyn_into::<Promise>()?).await?;
        Reflect::get(&adapter, &"info".into())
    }
    let info = info().await.unwrap_or(JsValue::UNDEFINED);
    let field = |name: &str| Reflect::get(&info, &name.into()).ok().and_then(|value| value.as_string());
    join(["vendor", "architecture", "device", "description"].map(|name| field(name).unwrap_or_default()))
}

fn join<const N: usize>(parts: [String; N]) -> String {
    let parts: Vec<_> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.join(", ")
}
