//! How long thumbnails and whole stages take to draw on the CPU, and points of clouds.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use frond_core::{Affine2, Colouring, Ifs};
use frond_render::{Flood, Frame, RasterOptions, rasterize};
use glam::DVec2;

fn shapes() -> [(&'static str, Ifs); 3] {
    let turned = |scale: f64, degrees: f64, e: f64, f: f64| {
        Affine2::similitude(scale, degrees.to_radians(), DVec2::new(e, f))
    };
    let of = |maps: Vec<Affine2>| Ifs::new(maps).expect("a valid IFS");
    let s = 0.5_f64.sqrt();
    [
        (
            "gasket",
            of(vec![turned(0.5, 0.0, 0.0, 0.0), turned(0.5, 0.0, 0.5, 0.0), turned(0.5, 0.0, 0.25, 0.433)]),
        ),
        ("dragon", of(vec![turned(s, 45.0, 0.0, 0.0), turned(s, 135.0, 1.0, 0.0)])),
        // Overlaps everywhere.
        ("overlap", of(vec![turned(0.9, 0.0, 0.0, 0.0), turned(0.9, 40.0, 0.1, 0.0)])),
    ]
}

fn raster(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("rasterize");
    group.sample_size(20);
    for (name, ifs) in shapes() {
        for (width, height) in [(160, 120), (1000, 700)] {
            for colouring in [Colouring::Map, Colouring::Density] {
                let options = RasterOptions { width, height, colouring, ..RasterOptions::default() };
                let id = BenchmarkId::new(name, format!("{width} {colouring:?}"));
                group.bench_function(id, |bencher| {
                    bencher.iter(|| rasterize(black_box(&ifs), &options));
                });
            }
        }
    }
}

fn cloud(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("cloud");
    for (name, ifs) in shapes() {
        group.bench_function(BenchmarkId::new("frame", name), |bencher| {
            bencher.iter(|| Frame::of(black_box(&ifs)));
        });
        let frame = Frame::of(&ifs);
        for size in [64, 512] {
            group.bench_function(BenchmarkId::new("flood", format!("{name} {size}")), |bencher| {
                bencher.iter(|| {
                    let mut flood = Flood::new(black_box(&frame), size);
                    flood.run(u64::MAX);
                    flood.into_points().len()
                });
            });
        }
    }
}

criterion_group!(benches, raster, cloud);
criterion_main!(benches);
