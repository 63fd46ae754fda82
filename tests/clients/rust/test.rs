// SPDX-License-Identifier: Apache-2.0
//! What the Rust client gets from the library.

mod psc;

use psc::{Light, Map, Measure, Receiver, Sample, Sampler, Technique, Vector};

#[derive(Default)]
struct Tap {
    count: u32,
    failures: u32,
}

impl Tap {
    fn check(&mut self, name: &str, ok: bool) {
        self.count += 1;
        self.failures += !ok as u32;
        println!("{} {} - {}", if ok { "ok" } else { "not ok" }, self.count, name);
    }
}

fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs()
}

// Single calls, totals, and a wavefront against single calls.
fn every_shape(tap: &mut Tap, name: &str, light: &Light) -> Result<(), psc::Error> {
    let mut sampler = Sampler::new();
    let plain = Technique::new(Measure::SolidAngle, Map::Radial);
    let from = Receiver::surface([0.0; 3], [0.0, 0.0, 1.0]);
    let built = sampler.build(&plain, &from, light)?.expect("above the horizon");
    let s = built.sample(0.25, 0.75);
    let uv = built.invert(&s.direction).unwrap_or([9.0; 2]);
    tap.check(
        &format!("{}: a sample, its density and inverse, totals", name),
        near(built.pdf(&s.direction), s.pdf, 1e-9)
            && near(uv[0], 0.25, 1e-9)
            && near(uv[1], 0.75, 1e-9)
            && near(built.total(), built.solid_angle(), 1e-15),
    );

    let n = 1000;
    let golden = |k: usize, step: f64| (0.3 + k as f64 * step).fract();
    let point = |k: usize| [golden(k, 0.755) * 4.0 - 2.0, golden(k, 0.57) * 4.0 - 2.0, 0.0];
    let normal = |k: usize| [golden(k, 0.41) - 0.5, golden(k, 0.87) - 0.5, 0.25];
    let uv: Vec<[f64; 2]> = (0..n).map(|k| [golden(k, 0.618), golden(k, 0.414)]).collect();
    let positions: Vec<Vector> = (0..n).map(point).collect();
    let normals: Vec<Vector> = (0..n).map(normal).collect();
    let (mut samples, mut status) = (vec![Sample::default(); n], vec![-1; n]);
    psc::sample_n(
        &plain, &positions, Some(&normals), light, &uv, &mut samples, &mut status,
    )?;
    let mut same = status.contains(&0);
    for k in 0..n {
        let receiver = Receiver::surface(positions[k], normals[k]);
        same &= match sampler.build(&plain, &receiver, light)? {
            Some(built) => built.sample(uv[k][0], uv[k][1]) == samples[k],
            None => status[k] == psc::EMPTY,
        };
    }
    tap.check(&format!("{}: a wavefront gives what single calls give", name), same);
    Ok(())
}

fn main() -> Result<(), psc::Error> {
    let mut tap = Tap::default();
    let center: [f64; 3] = [0.3, -0.2, 2.0];
    let light = Light::Sphere { center, radius: 0.5 };
    let from = Receiver::surface([0.0; 3], [0.0, 0.0, 1.0]);
    let distance = center.iter().map(|x| x * x).sum::<f64>().sqrt();
    let exact = std::f64::consts::PI * (0.5 / distance).powi(2) * center[2] / distance;
    let mut sampler = Sampler::new();

    let technique = Technique::new(Measure::ProjectedSolidAngle, Map::Parallel);
    {
        let built = sampler.build(&technique, &from, &light)?.expect("above the horizon");
        let s = built.sample(0.25, 0.75);
        tap.check("the total of a sphere above the horizon", near(built.total(), exact, 1e-14));
        tap.check("the weight is the total", near(s.weight, exact, 1e-14));
        tap.check("pdf of the sample", near(built.pdf(&s.direction), s.pdf, 1e-12));
        let uv = built.invert(&s.direction).unwrap_or([9.0; 2]);
        tap.check("inverse of the sample", near(uv[0], 0.25, 1e-12) && near(uv[1], 0.75, 1e-12));
        tap.check("a direction away from the light", built.invert(&[1.0, 0.0, 0.0]).is_none()
            && built.pdf(&[1.0, 0.0, 0.0]) == 0.0);
    }
    let below = Receiver::surface([0.0; 3], [0.0, 0.0, -1.0]);
    tap.check("below the horizon", sampler.build(&technique, &below, &light)?.is_none());

    let sun = Light::Cap { axis: [0.0, 1.0, 1.0], half_angle: 0.00465 };
    let distant = sampler.build(&technique, &from, &sun)?.expect("the sun is up");
    tap.check("a distant light", distant.sample(0.5, 0.5).distance.is_infinite());

    let volume = Receiver::volume([0.0; 3]);
    let error = sampler.build(&technique, &volume, &light).err();
    let words = error.map_or(String::new(), |e| e.to_string());
    tap.check(&format!("errors are values: {}", words), words.contains("normal"));

    // Arrays of a million, and threads that share what was built.
    let uniform = Technique::new(Measure::SolidAngle, Map::Concentric);
    let built = sampler.build(&uniform, &from, &light)?.expect("still there");
    let n = 1_000_000;
    let uv: Vec<[f64; 2]> = (0..n)
        .map(|i| [(i as f64 + 0.5) / n as f64, (i as f64 * 0.618_033_988_749_894_9).fract()])
        .collect();
    let mut samples = vec![Sample::default(); n];
    built.sample_n(&uv, &mut samples);
    let mean = samples.iter().map(|s| s.weight).sum::<f64>() / n as f64;
    tap.check("the mean of a million samples", near(mean, exact, 1e-6));

    let same = std::thread::scope(|scope| {
        let threads: Vec<_> = uv
            .chunks(n / 4)
            .zip(samples.chunks(n / 4))
            .map(|(uv, samples)| {
                scope.spawn(move || {
                    uv.iter().zip(samples).all(|(p, s)| built.sample(p[0], p[1]) == *s)
                })
            })
            .collect();
        threads.into_iter().all(|thread| thread.join().unwrap_or(false))
    });
    tap.check("four threads share a sampler and get the same bits", same);

    let table = psc::Table::new(64)?;
    let disk = Light::Disk { center, normal: [0.0, 0.0, 1.0], radius: 0.5 };
    let looked_up = sampler.build(&Technique::tabulated(&table), &from, &disk)?.is_some();
    tap.check("the tabulated map", looked_up && psc::Table::new(1).is_err());

    let polygon = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.5, 1.0, 1.0], [0.5, 2.0, 1.0]];
    let (center, x, y, z) = ([0.5, -0.25, 1.0], [0.5, 0.0, 0.25], [0.0, 1.0, 0.0], [0.0, 0.0, 0.5]);
    for (name, light) in [
        ("sphere", Light::Sphere { center, radius: 0.5 }),
        ("cap", Light::Cap { axis: center, half_angle: 0.75 }),
        ("disk", Light::Disk { center, normal: [1.0, 0.5, 0.5], radius: 0.75 }),
        ("ellipse", Light::Ellipse { center, axis_u: x, axis_v: y }),
        ("ellipsoid", Light::Ellipsoid { center, axis_u: x, axis_v: y, axis_w: z }),
        ("triangle", Light::Triangle { v0: center, v1: x, v2: y }),
        ("rectangle", Light::Rectangle { corner: center, edge_u: x, edge_v: y }),
        ("polygon", Light::Polygon { vertices: &polygon }),
    ] {
        every_shape(&mut tap, name, &light)?;
    }

    println!("1..{}", tap.count);
    std::process::exit((tap.failures != 0) as i32);
}
