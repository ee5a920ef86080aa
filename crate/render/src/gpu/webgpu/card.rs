//! The device.

use std::sync::Arc;

use crate::gpu::events::Loss;
use crate::gpu::words::Format;

/// A device of WebGPU.
#[derive(Debug)]
pub struct Card {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    sums: wgpu::TextureFormat,
    canvas: wgpu::TextureFormat,
    /// Its name, as far as the browser tells.
    pub description: String,
    /// Whether the browser says that it is no graphics card.
    pub software: bool,
    /// The longest side of what can be drawn to.
    pub max_side: u32,
    /// The most pixels whose codes it computes.
    pub most_codes: u64,
    /// Whether it can add up weights.
    pub densities: bool,
}

impl Card {
    pub const BACKEND: &'static str = "webgpu";

    /// Opens a device.
    pub(super) async fn request(adapter: &wgpu::Adapter) -> Result<(wgpu::Device, wgpu::Queue), String> {
        let own = adapter.limits();
        let descriptor = wgpu::DeviceDescriptor {
            // Sums of many small weights are truer in 32 bits, where these can be blended.
            required_features: adapter.features() & wgpu::Features::FLOAT32_BLENDABLE,
            required_limits: wgpu::Limits {
                max_buffer_size: own.max_buffer_size,
                max_storage_buffer_binding_size: own.max_storage_buffer_binding_size,
                ..wgpu::Limits::downlevel_defaults().using_resolution(own)
            },
            ..wgpu::DeviceDescriptor::default()
        };
        adapter.request_device(&descriptor).await.map_err(|e| e.to_string())
    }

    /// What can be done with a device, where the canvas is of such a format. It tells what happens to it.
    pub(super) async fn new(
        adapter: &wgpu::Adapter,
        (device, queue): (wgpu::Device, wgpu::Queue),
        canvas: wgpu::TextureFormat,
        loss: Loss,
    ) -> Self {
        let lost = loss.clone();
        device.set_device_lost_callback(move |reason, message| {
            lost.tell(&if message.is_empty() { format!("{reason:?}") } else { message });
        });
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| loss.fault(&error.to_string())));
        let float32 = device.features().contains(wgpu::Features::FLOAT32_BLENDABLE);
        Self {
            description: name(adapter).await,
            software: adapter.get_info().device_type == wgpu::DeviceType::Cpu,
            max_side: device.limits().max_texture_dimension_2d,
            most_codes: device.limits().max_storage_buffer_binding_size / 4,
            densities: true,
            sums: if float32 { wgpu::TextureFormat::Rgba32Float } else { wgpu::TextureFormat::Rgba16Float },
            canvas,
            device,
            queue,
        }
    }

    /// What wgpu calls such a format.
    pub(super) fn format(&self, format: Format) -> wgpu::TextureFormat {
        match format {
            Format::Word => wgpu::TextureFormat::R32Uint,
            Format::Sums => self.sums,
            Format::Colours => wgpu::TextureFormat::Rgba8Unorm,
            Format::Canvas => self.canvas,
            Format::Depth => wgpu::TextureFormat::Depth24Plus,
        }
    }

    /// Waits until all is done that it was told.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn finish(&self) {
        let _ = self.device.poll(wgpu::PollType::wait_indefinitely());
    }

    /// Destroys the device.
    pub fn destroy(&self) {
        self.device.destroy();
    }
}

/// The fastest adapter that is there.
pub async fn adapter() -> Result<(wgpu::Instance, wgpu::Adapter), String> {
    let instance = instance().await?;
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        ..wgpu::RequestAdapterOptions::default()
    };
    let adapter = instance.request_adapter(&options).await.map_err(|e| e.to_string())?;
    Ok((instance, adapter))
}

#[cfg(target_arch = "wasm32")]
async fn instance() -> Result<wgpu::Instance, String> {
    if !wgpu::util::is_browser_webgpu_supported().await {
        return Err("no WebGPU adapter".into());
    }
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::BROWSER_WEBGPU;
    Ok(wgpu::util::new_instance_with_webgpu_detection(descriptor).await)
}

#[cfg(not(target_arch = "wasm32"))]
#[expect(clippy::unused_async, reason = "the browser has to be waited for")]
async fn instance() -> Result<wgpu::Instance, String> {
    Ok(wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle()))
}

/// What a browser tells of its adapter, which wgpu does not pass on. Empty where anything is missing.
#[cfg(target_arch = "wasm32")]
pub async fn name(_: &wgpu::Adapter) -> String {
    use js_sys::{Function, Promise, Reflect, global};
    use wasm_bindgen::{JsCast, JsValue};
    use wasm_bindgen_futures::JsFuture;

    async fn info() -> Result<JsValue, JsValue> {
        let gpu = Reflect::get(&Reflect::get(&global(), &"navigator".into())?, &"gpu".into())?;
        let request: Function = Reflect::get(&gpu, &"requestAdapter".into())?.dyn_into()?;
        let adapter = JsFuture::from(request.call0(&gpu)?.dyn_into::<Promise>()?).await?;
        Reflect::get(&adapter, &"info".into())
    }
    let info = info().await.unwrap_or(JsValue::UNDEFINED);
    let field = |name: &str| Reflect::get(&info, &name.into()).ok().and_then(|value| value.as_string());
    let names =
        ["vendor", "architecture", "device", "description"].map(|name| field(name).unwrap_or_default());
    names.into_iter().filter(|name| !name.is_empty()).collect::<Vec<_>>().join(", ")
}

/// What the system tells of an adapter.
#[cfg(not(target_arch = "wasm32"))]
pub async fn name(adapter: &wgpu::Adapter) -> String {
    let info = adapter.get_info();
    format!("{}, {:?}, {} {}", info.name, info.backend, info.driver, info.driver_info)
}
