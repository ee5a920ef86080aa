// From coverage and density to alpha. CPU twin: src/picture/tone.rs.

fn cover(coverage: f32) -> f32 {
    return coverage * (2.0 - coverage);
}

const MOST: f32 = 1e6;
const MIDDLE: f32 = 1.25;
const MIST = 300.0;
const MIST_PART: f32 = 0.4;
const FULL: f32 = 0.62;
const LIGHT_FROM: f32 = 0.45;
const MOST_LIGHT: f32 = 0.8;

fn respond(density: f32, slope: f32) -> f32 {
    let odds = MIDDLE * pow(clamp(density, 0.0, MOST), slope);
    return odds / (1.0 + odds);
}

fn tone(density: f32, response: f32) -> f32 {
    let mist = log2(1.0 + MIST * clamp(density, 0.0, MOST)) / log2(1.0 + MIST);
    return MIST_PART * min(mist, 1.0) + (1.0 - MIST_PART) * min(response / FULL, 1.0);
}

fn glow(response: f32) -> f32 {
    let over = max((response - LIGHT_FROM) / (1.0 - LIGHT_FROM), 0.0);
    return MOST_LIGHT * over * (0.6 + 0.4 * over);
}
