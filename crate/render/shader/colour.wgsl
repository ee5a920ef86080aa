// What colour a piece has. CPU twin: src/picture/colour.rs.

struct Colours {
    palette: array<vec4<f32>, 64>,
    source: vec2<i32>,
    factor: f32,
    maps: f32,
    contrast: f32,
    gain: f32,
    premultiply: f32,
    // 1 where codes are colours, eight bits each.
    tinted: f32,
    slope: f32,
    towards: f32,
    unused: vec2<f32>,
}

@group(0) @binding(1) var<uniform> colours: Colours;

fn colour_of(code: u32) -> vec3<f32> {
    let packed = code - 1u;
    if colours.tinted > 0.5 {
        let bytes = vec3<u32>(packed >> 16u, packed >> 8u, packed) & vec3<u32>(255u);
        return vec3<f32>(bytes) / 255.0;
    }
    let base = colours.palette[(packed >> 12u) & 63u].rgb;
    let second = f32((packed >> 6u) & 63u);
    let third = f32(packed & 63u);
    let at = (second + (third + 0.5) / colours.maps) / colours.maps;
    let shift = (at - 0.5) * 2.0 * colours.contrast;
    let towards = select(0.0, 1.0, shift > 0.0);
    return base + (vec3<f32>(towards) - base) * abs(shift);
}
