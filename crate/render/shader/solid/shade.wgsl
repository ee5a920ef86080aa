// From depths to a picture. CPU twin: src/solid/shade.rs.

struct Lamp {
    // Towards the light, as the eye has it; how much light comes from everywhere.
    towards: vec4<f32>,
    // What fog fades into; how much at the farthest depth.
    ground: vec4<f32>,
    // Upwards, as the eye has it; the height of the eye.
    up: vec4<f32>,
    // The nearest and the farthest depth; the lowest and the highest height that is painted.
    range: vec4<f32>,
    // Width and height of the source, in pixels.
    size: vec2<i32>,
    // Pixels a unit at depth 1.
    focal: f32,
    // How dark hollows are.
    hollows: f32,
    // 1 to paint by height, 0 by maps.
    height: f32,
    // Pixels of the source for each one that is shown, each way.
    factor: i32,
    // How far hollows are looked for: 1 in a picture that has as many pixels as it is to have in the end.
    reach: f32,
    // How much of the light from everywhere what is around keeps off: not used here.
    occlusion: f32,
    // Sky light, gloss, 1 for the curve of film; the last is not used here. Cast shadows and what is far around are
    // seen in the complete picture that the processor lights.
    finish: vec4<f32>,
    // A colour for each object that has one: its alpha is 1.
    tints: array<vec4<f32>, 60>,
}

@group(0) @binding(0) var<uniform> lamp: Lamp;
@group(0) @binding(2) var codes: texture_2d<u32>;
@group(0) @binding(3) var depths: texture_2d<u32>;

fn inside(at: vec2<i32>) -> bool {
    return all(at >= vec2<i32>(0)) && all(at < lamp.size);
}

fn code_at(at: vec2<i32>) -> u32 {
    if !inside(at) {
        return 0u;
    }
    return textureLoad(codes, at, 0).r;
}

// Far away where nothing is seen.
const NOTHING_DEPTH: f32 = 1e30;

fn depth_at(at: vec2<i32>) -> f32 {
    if code_at(at) == 0u {
        return NOTHING_DEPTH;
    }
    return bitcast<f32>(textureLoad(depths, at, 0).r);
}

fn point_at(at: vec2<i32>, depth: f32) -> vec3<f32> {
    let middle = 0.5 * vec2<f32>(lamp.size);
    let away = (vec2<f32>(at) + 0.5 - middle) / lamp.focal;
    return vec3<f32>(away.x, -away.y, 1.0) * depth;
}

fn normal_at(at: vec2<i32>, depth: f32) -> vec3<f32> {
    var squares = vec3<f32>(0.0);
    var slopes = vec2<f32>(0.0);
    for (var dy = -2; dy <= 2; dy++) {
        for (var dx = -2; dx <= 2; dx++) {
            let near = depth_at(at + vec2<i32>(dx, dy));
            if near < NOTHING_DEPTH {
                // In pixels. Of a plane it is the inverse of the depth that changes evenly from pixel to pixel.
                let step = lamp.focal * (1.0 - depth / near);
                let f = vec2<f32>(f32(dx), f32(dy));
                let weight = 1.0 / (1.0 + 0.15 * step * step);
                squares += weight * vec3<f32>(f.x * f.x, f.x * f.y, f.y * f.y);
                slopes += weight * f * step;
            }
        }
    }
    let det = squares.x * squares.z - squares.y * squares.y;
    if det < 1e-3 {
        return vec3<f32>(0.0, 0.0, -1.0);
    }
    let gx = (slopes.x * squares.z - slopes.y * squares.y) / det;
    let gy = (slopes.y * squares.x - slopes.x * squares.y) / det;
    // Rows go down, y goes up; and beside the middle of the picture the eye looks at a slant.
    let slant = point_at(at, 1.0);
    return normalize(vec3<f32>(gx, -gy, slant.y * gy - slant.x * gx - 1.0));
}

// What stands out of the plane of the surface on a ring; what lies beyond the border of the picture is not known.
fn ring_at(at: vec2<i32>, depth: f32, normal: vec3<f32>, radius: f32, turn: f32) -> f32 {
    let unit = depth / lamp.focal;
    let own = point_at(at, depth);
    var covered = 0.0;
    var known = 0.0;
    for (var ray = 0; ray < 8; ray++) {
        let angle = 6.2831855 * (f32(ray) + turn) / 8.0;
        let next = at + vec2<i32>(round(radius * vec2<f32>(cos(angle), sin(angle))));
        if !inside(next) {
            continue;
        }
        known += 1.0;
        let there = depth_at(next);
        if there >= NOTHING_DEPTH {
            continue;
        }
        let way = (point_at(next, there) - own) / (radius * unit);
        let rise = dot(normal, way);
        if rise > 0.0 {
            covered += min(0.7 * rise, 1.0) / (1.0 + 0.02 * dot(way, way));
        }
    }
    return covered / max(known, 1.0);
}

fn hollow_at(at: vec2<i32>, depth: f32, normal: vec3<f32>) -> f32 {
    let radii = lamp.reach * vec4<f32>(2.0, 5.0, 12.0, 28.0);
    let sum = 0.2 * ring_at(at, depth, normal, radii.x, 0.0) + 0.3 * ring_at(at, depth, normal, radii.y, 0.25)
        + 0.3 * ring_at(at, depth, normal, radii.z, 0.5) + 0.2 * ring_at(at, depth, normal, radii.w, 0.75);
    return min(sum, 1.0);
}

fn lit(at: vec2<i32>) -> vec4<f32> {
    let code = code_at(at);
    if code == 0u {
        return vec4<f32>(0.0);
    }
    let depth = depth_at(at);
    let place = code - 1u;
    var colour = colour_of((place & 0x3ffffu) + 1u);
    let tint = lamp.tints[min(place >> 18u, 59u)];
    if tint.a > 0.5 {
        colour = tint.rgb;
    }
    if lamp.height > 0.5 {
        let height = lamp.up.w + dot(lamp.up.xyz, point_at(at, depth));
        let share = clamp((height - lamp.range.z) / max(lamp.range.w - lamp.range.z, 1e-30), 0.0, 1.0);
        colour = mix(colours.palette[1].rgb, colours.palette[0].rgb, share);
    }
    let normal = normal_at(at, depth);
    let facing = max(dot(normal, lamp.towards.xyz), 0.0);
    let open = 1.0 - lamp.hollows * hollow_at(at, depth, normal);
    let rise = 0.5 + 0.5 * dot(normal, lamp.up.xyz);
    let white = vec3<f32>(1.0);
    let dome = mix(vec3<f32>(0.62, 0.48, 0.36), vec3<f32>(0.95, 1.25, 1.75), rise);
    let sky = lamp.towards.w * mix(white, dome, lamp.finish.x);
    let sun = (1.0 - lamp.towards.w) * facing * mix(white, vec3<f32>(1.22, 1.0, 0.74), lamp.finish.x);
    var shine = pow(colour, vec3<f32>(2.2)) * (sky + sun);
    if lamp.finish.y > 0.0 {
        let eye = -normalize(point_at(at, 1.0));
        let half = normalize(eye + lamp.towards.xyz);
        let sharp = trunc(6.0 + 250.0 * lamp.finish.y * lamp.finish.y);
        let slanted = 0.04 + 0.96 * pow(1.0 - clamp(dot(eye, half), 0.0, 1.0), 5.0);
        shine += lamp.finish.y * slanted * pow(max(dot(normal, half), 0.0), sharp) * (sharp + 8.0) * 0.25 * sun;
    }
    shine *= open;
    if lamp.finish.z > 0.5 {
        shine *= 1.85;
        let most = max(shine.r, max(shine.g, shine.b));
        let over = most - 0.55;
        if over > 0.0 {
            let tone = 0.55 + 0.45 * over / (over + 0.45);
            shine = mix(shine * (tone / most), vec3<f32>(tone), over / (over + 6.0));
        }
    } else {
        shine *= 1.25;
    }
    let light = pow(shine, vec3<f32>(1.0 / 2.2));
    let fog = lamp.ground.w * clamp((depth - lamp.range.x) / max(lamp.range.y - lamp.range.x, 1e-30), 0.0, 1.0);
    return vec4<f32>(clamp(mix(light, lamp.ground.rgb, fog), vec3<f32>(0.0), vec3<f32>(1.0)), 1.0);
}

@fragment
fn light_fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let at = vec2<i32>(position.xy) * lamp.factor;
    var sum = vec4<f32>(0.0);
    for (var y = 0; y < lamp.factor; y++) {
        for (var x = 0; x < lamp.factor; x++) {
            // Light adds up as it is, not as it is written.
            let one = lit(at + vec2<i32>(x, y));
            sum += vec4<f32>(pow(one.rgb, vec3<f32>(2.2)), one.a);
        }
    }
    if sum.a == 0.0 {
        return sum;
    }
    let alpha = sum.a / f32(lamp.factor * lamp.factor);
    return vec4<f32>(pow(sum.rgb / sum.a, vec3<f32>(1.0 / 2.2)) * (1.0 + (alpha - 1.0) * colours.premultiply), alpha);
}
