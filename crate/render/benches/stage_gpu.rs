//! Milliseconds a frame of what the stage draws, by the card of this machine, where nobody sees it, and how far that is
//! from what the processor draws: `cargo xtask bench stage_gpu`.

#[cfg(all(frond_card, not(target_arch = "wasm32")))]
mod measure {
    use std::rc::Rc;
    use std::time::Instant;

    use frond_core::{Affine2, Affine3, Colouring, Hull, Ifs, Ifs3};
    use frond_deform::{Bend, Continuity, Mesh, Roughness, Settings, Spin};
    use frond_render::gpu::{Canvas, Event, Gpu, ReadBack, Stage, Stage3, Style, Uniforms3, Wanted};
    use frond_render::solid::{Camera, Cloud, Eye, Lamp, Lighting, Traversal, light};
    use frond_render::{Colours, RasterOptions, View, rasterize};
    use glam::{DQuat, DVec2, DVec3};

    const SIZE: [u32; 2] = [1280, 800];
    /// Frames that are drawn before any is measured.
    const WARM_UP: usize = 10;

    /// How much is measured.
    #[derive(Clone, Copy)]
    struct Bench {
        frames: usize,
        budgets: &'static [u64],
    }

    pub fn main() {
        let gpu = match pollster::block_on(Gpu::open(&Canvas::Texture, Wanted::Auto, Rc::new(hear))) {
            Ok(gpu) => gpu,
            Err(problem) => return println!("not measured, {}: {problem}", problem.code()),
        };
        let software = if gpu.software { " (no graphics card: this says nothing of speed)" } else { "" };
        println!("adapter: {}{software}", gpu.description);
        println!("{} x {}, up to {} a side", SIZE[0], SIZE[1], gpu.max_side);
        let bench = if gpu.software {
            Bench { frames: 3, budgets: &[200_000] }
        } else {
            Bench { frames: 200, budgets: &[1_000_000, 4_000_000, 16_000_000] }
        };
        bench.points();
        for &budget in bench.budgets.iter().filter(|_| std::env::args().all(|word| word != "points")) {
            bench.dragged(budget);
            bench.rests(budget);
            bench.dense(budget);
            bench.bent(budget);
            bench.space(budget);
        }
    }

    fn hear(event: &Event) {
        println!("    {event:?}");
    }

    /// A device that is asked for what a card is asked for, whatever it is.
    fn open() -> Gpu {
        let mut gpu = pollster::block_on(Gpu::open(&Canvas::Texture, Wanted::Auto, Rc::new(hear)))
            .expect("it was there before");
        gpu.software = false;
        gpu
    }

    /// Milliseconds of frames of one kind: until all was handed over, and until the card had drawn it. A page need not
    /// wait for the latter.
    #[derive(Default)]
    struct Frames {
        handed: Vec<f64>,
        drawn: Vec<f64>,
        points: u64,
    }

    impl Frames {
        fn add<S>(&mut self, stage: &mut S, gpu: impl Fn(&S) -> &Gpu, draw: impl FnOnce(&mut S) -> u64) {
            let start = Instant::now();
            self.points += draw(stage);
            self.handed.push(start.elapsed().as_secs_f64() * 1e3);
            gpu(stage).finish();
            self.drawn.push(start.elapsed().as_secs_f64() * 1e3);
        }

        fn tell(mut self, what: &str) {
            let count = self.drawn.len();
            let whole: f64 = self.drawn.iter().sum();
            let [handed, drawn] = [&mut self.handed, &mut self.drawn].map(|times| {
                times.sort_by(f64::total_cmp);
                [times[count / 2], times[count * 99 / 100]]
            });
            println!(
                "{what}: {:.2} ms a frame (one in 100 over {:.2}), handed over after {:.2} ({:.2}); {:.2} million points \
                 a frame, {:.0} million a second",
                drawn[0],
                drawn[1],
                handed[0],
                handed[1],
                self.points as f64 / count as f64 / 1e6,
                self.points as f64 / whole / 1e3,
            );
        }
    }

    impl Bench {
        /// Points as vertices, as WebGL2 has them, and computed, in turns: at once, then at rest.
        fn points(self) {
            for size in [[900, 600], [1800, 1200]] {
                for (name, ifs) in [("fern", fern(0.0)), ("dragon", dragon()), ("gasket", gasket())] {
                    println!("{name}, {} x {}, four pixels to one", size[0], size[1]);
                    for round in 0..2 {
                        for vertices in [true, false] {
                            let what = if vertices { "vertices" } else { "computed" };
                            let mut stage = stage_of(&ifs, size);
                            if vertices {
                                stage.draw_vertices();
                            }
                            // The first of a stage has textures to be made.
                            for _ in 0..4 {
                                stage.draw(u64::MAX);
                                stage.set_ifs(&ifs);
                            }
                            stage.gpu().finish();
                            let start = Instant::now();
                            let points = stage.draw(u64::MAX).points;
                            let handed = start.elapsed().as_secs_f64() * 1e3;
                            stage.gpu().finish();
                            let drawn = start.elapsed().as_secs_f64() * 1e3;
                            let rate = self.rate(&mut stage);
                            println!(
                                "    {round} {what}: at once {points} points in {drawn:.2} ms, handed over after \
                                 {handed:.2}; {rate:.0} million a second"
                            );
                            settle(&mut stage, 16_000_000);
                            println!("        its points: {:.0} million a second", self.rate(&mut stage));
                        }
                    }
                }
            }
        }

        /// Millions of points a second, with nothing in the way of the card.
        fn rate(self, stage: &mut Stage) -> f64 {
            let times = self.frames as u64 / 4 + 1;
            stage.draw_again(1);
            stage.gpu().finish();
            let start = Instant::now();
            let points = stage.draw_again(times);
            stage.gpu().finish();
            points as f64 / start.elapsed().as_secs_f64() / 1e6
        }

        /// A map of a fern is dragged: each frame is another shape, planned and drawn anew. Then it rests.
        fn dragged(self, budget: u64) {
            let mut stage = stage(&fern(0.0));
            let mut frames = Frames::default();
            for k in 0..WARM_UP + self.frames {
                if k == WARM_UP {
                    frames = Frames::default();
                }
                stage.set_ifs(&fern(0.01 * (k as f64 / 20.0).sin()));
                frames.add(&mut stage, Stage::gpu, |stage| stage.draw(budget).points);
            }
            frames.tell(&format!("fern, dragged, {budget} points"));
            stage.set_ifs(&fern(0.0));
            settle(&mut stage, budget);
            compare(&stage, &fern(0.0), None);
        }

        /// Shapes that are seen for the first time, until they are complete: a full one and a thin one.
        fn rests(self, budget: u64) {
            for (name, ifs) in [("dragon", dragon()), ("gasket", gasket())] {
                println!("{name}, at rest, {budget} points");
                let mut stage = stage(&ifs);
                settle(&mut stage, budget);
                compare(&stage, &ifs, None);
            }
        }

        /// The chaos game, until there are enough of its points.
        fn dense(self, budget: u64) {
            let mut stage = stage(&fern(0.0));
            stage.set_style(Style { colouring: Colouring::Density, ..Style::default() });
            let mut frames = Frames::default();
            let mut before = 0;
            for _ in 0..self.frames {
                let mut settled = false;
                frames.add(&mut stage, Stage::gpu, |stage| {
                    let drawn = stage.draw(budget);
                    settled = drawn.settled;
                    drawn.points - std::mem::replace(&mut before, drawn.points)
                });
                if settled {
                    break;
                }
            }
            frames.tell(&format!("fern, density by the chaos game, {budget} points"));
        }

        /// The middle of a gasket is pulled by its mesh. Then it rests.
        fn bent(self, budget: u64) {
            let ifs = gasket();
            let mut stage = stage(&ifs);
            stage.set_bend(Some(bend(&ifs, 0.1)));
            let mut frames = Frames::default();
            for k in 0..WARM_UP + self.frames {
                if k == WARM_UP {
                    frames = Frames::default();
                }
                stage.move_mesh(&pull(0.1 + 0.05 * (k as f64 / 20.0).sin()));
                frames.add(&mut stage, Stage::gpu, |stage| stage.draw(budget).points);
            }
            frames.tell(&format!("gasket, bent and pulled, {budget} points"));
            stage.move_mesh(&pull(0.1));
            settle(&mut stage, budget);
            compare(&stage, &ifs, Some(&bend(&ifs, 0.1)));
        }

        /// A tetrahedron of space is turned. Then it is carved by the processor, and lit by the card.
        fn space(self, budget: u64) {
            let ifs = tetrahedron();
            let systems = std::slice::from_ref(&ifs);
            let mut stage = Stage3::new(open());
            stage.resize(SIZE[0], SIZE[1]);
            stage.set_clouds(&[Cloud::new(&ifs, 0, budget as usize, 1)]);
            let mut frames = Frames::default();
            for k in 0..WARM_UP + self.frames {
                if k == WARM_UP {
                    frames = Frames::default();
                }
                let (uniforms, _) = seen(systems, 0.5 + k as f64 / 100.0);
                stage.set_uniforms(uniforms);
                frames.add(&mut stage, Stage3::gpu, |stage| stage.draw().points);
            }
            frames.tell(&format!("tetrahedron, turned, {budget} points"));
            let (uniforms, mut traversal) = seen(systems, 0.5);
            stage.set_uniforms(uniforms);
            let start = Instant::now();
            traversal.run(usize::MAX);
            let carved = start.elapsed().as_secs_f64() * 1e3;
            let buffer = traversal.depth_buffer();
            let mut frames = Frames::default();
            for _ in 0..self.frames {
                frames.add(&mut stage, Stage3::gpu, |stage| {
                    assert!(stage.put_still(SIZE, buffer.depth(), buffer.codes()) && stage.draw().complete);
                    0
                });
            }
            frames.tell(&format!("tetrahedron, carved in {carved:.0} ms by one core and lit"));
            let twin = light(buffer, &uniforms.still_lamp, &uniforms.colours, None);
            let shown = picture(stage.read());
            let off = shown.iter().zip(&twin).filter(|(a, b)| a.abs_diff(**b) > 6).count();
            println!("    {off} of {} bytes are not as the processor lights them", twin.len());
        }
    }

    /// Draws on until nothing changes any more.
    fn settle(stage: &mut Stage, budget: u64) {
        let start = Instant::now();
        for k in 1..=10_000 {
            let drawn = stage.draw(budget);
            stage.gpu().finish();
            if drawn.settled {
                let took = start.elapsed().as_secs_f64() * 1e3;
                let word = if drawn.complete { "complete" } else { "not complete" };
                return println!(
                    "    at rest: {word} after {k} frames, {took:.0} ms, {} points",
                    drawn.points
                );
            }
        }
        println!("    at rest: it comes to no end");
    }

    /// Lit pixels that the card has and the processor has not, and the other way round.
    fn compare(stage: &Stage, ifs: &Ifs, bend: Option<&Bend>) {
        let options = RasterOptions {
            width: SIZE[0],
            height: SIZE[1],
            view: Some(view(ifs)),
            bend,
            ..RasterOptions::default()
        };
        let truth = rasterize(ifs, &options).expect("a picture");
        let seen = picture(stage.read());
        let count = |which: fn(bool, bool) -> bool| {
            let pixels = seen.chunks_exact(4).zip(truth.chunks_exact(4));
            pixels.filter(|(a, b)| which(a[3] > 0, b[3] > 0)).count()
        };
        println!(
            "    of {} lit pixels {} are missing and {} too many",
            count(|_, truth| truth),
            count(|seen, truth| truth && !seen),
            count(|seen, truth| seen && !truth),
        );
    }

    fn picture(read: Option<ReadBack>) -> Vec<u8> {
        let read = read.expect("a picture");
        loop {
            if let Some(picture) = read.take() {
                return picture.expect("the card is there");
            }
        }
    }

    fn stage(ifs: &Ifs) -> Stage {
        stage_of(ifs, SIZE)
    }

    fn stage_of(ifs: &Ifs, size: [u32; 2]) -> Stage {
        let mut stage = Stage::new(open());
        stage.resize(size[0], size[1], 1.0);
        stage.set_ifs(ifs);
        stage.set_view(View::fit(&Hull::of(ifs), size[0], size[1], 0.05));
        stage
    }

    fn view(ifs: &Ifs) -> View {
        View::fit(&Hull::of(ifs), SIZE[0], SIZE[1], 0.05)
    }

    fn fern(turn: f64) -> Ifs {
        let rows = [
            [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
            [0.85, 0.04 + turn, -0.04 - turn, 0.85, 0.0, 1.6],
            [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
            [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
        ];
        Ifs::new(rows.map(Affine2::from_row).to_vec()).expect("a fern")
    }

    fn dragon() -> Ifs {
        let side = 0.5_f64.sqrt();
        let maps = [(45.0_f64, DVec2::ZERO), (135.0, DVec2::X)];
        Ifs::new(maps.map(|(turn, to)| Affine2::similitude(side, turn.to_radians(), to)).to_vec())
            .expect("a dragon")
    }

    fn gasket() -> Ifs {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::Y];
        Ifs::new(corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5)).to_vec()).expect("a gasket")
    }

    /// The control points of a mesh of 4 by 4, those in the middle moved.
    fn pull(by: f64) -> Vec<DVec2> {
        let moved = |i| if [5, 6, 9, 10].contains(&i) { DVec2::splat(by) } else { DVec2::ZERO };
        (0..16).map(moved).collect()
    }

    fn bend(ifs: &Ifs, by: f64) -> Bend {
        let mesh = Mesh::new(DVec2::ZERO, DVec2::ONE, 4, 4, pull(by)).expect("a mesh");
        let settings = Settings {
            kb: 1.0,
            ke: 5.0,
            roughness: Roughness::Constant(0.6),
            spin: Spin::None,
            continuity: Continuity::Auto,
            superposed: true,
        };
        Bend::new(ifs.maps(), mesh, settings, None).expect("a bend")
    }

    fn tetrahedron() -> Ifs3 {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let maps = corners.map(|c| Affine3::similitude(0.5, DQuat::IDENTITY, c * 0.5));
        Ifs3::new(maps.to_vec()).expect("a tetrahedron")
    }

    /// How it is seen from one side, and what carves it there.
    fn seen(systems: &[Ifs3], turn: f64) -> (Uniforms3, Traversal) {
        let camera = Camera::around(DVec3::splat(0.25), 2.6, turn, 0.4, 0.6).expect("a camera");
        let traversal = Traversal::new(systems, &camera, SIZE[0], SIZE[1]);
        let lamp = Lamp::new(&Lighting::default(), &camera, SIZE, 1, traversal.range());
        let eye = Eye::new(&camera, SIZE[0], SIZE[1], traversal.range());
        let colours = Colours::new(Colouring::Address, &[], 4);
        (Uniforms3 { eye, lamp, still_lamp: lamp, colours }, traversal)
    }
}

fn main() {
    #[cfg(all(frond_card, not(target_arch = "wasm32")))]
    measure::main();
}
