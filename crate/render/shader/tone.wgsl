// From coverage and density to alpha. CPU twin: src/picture/tone.rs.

fn cover(coverage: f32) -> f32 {
    return coverage * (2.0 - coverage);
}

const CONTRAST: f32 = 12.0;
const WHITE: f32 = 4.0;

fn tone(density: f32) -> f32 {
    return clamp(log2(1.0 + CONTRAST * density) / log2(1.0 + CONTRAST * WHITE), 0.0, 1.0);
}

fn glow(value: f32) -> f32 {
    let over = max(value - 0.75, 0.0);
    return over * over * 6.0;
}
