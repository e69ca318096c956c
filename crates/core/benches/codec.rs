//! Packing and unpacking a patch: `cargo bench -p asbuilt-core`.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Patch};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

/// A tile of 64 scan lines on a wall 6 m away, 2.5 mrad apart, with the noise of a current scanner.
fn tile() -> Vec<Beam> {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let (range_noise, angle_noise) = (Normal::new(0.0, 0.001).unwrap(), Normal::new(0.0, 4e-5).unwrap());
    let mut beam = |row: i32, column: i32| {
        let (azimuth, elevation) = (
            0.3 + f64::from(column) * 2.5e-3 + angle_noise.sample(&mut rng),
            -0.1 + f64::from(row) * 2.5e-3 + angle_noise.sample(&mut rng),
        );
        let direction = Vec3::new(elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin());
        Beam { offset: direction * (6.0 / direction.x + range_noise.sample(&mut rng)), returned: true }
    };
    (0..64).flat_map(|column| (0..64).map(move |row| (row, column))).map(|(r, c)| beam(r, c)).collect()
}

fn codec(c: &mut Criterion) {
    let beams = tile();
    let packed = Patch::encode(1, Vec3::zeros(), 2.5e-3, Patch::QUANTUM_M, &beams).unwrap().to_bytes();
    eprintln!("{:.2} bytes a beam", packed.len() as f64 / beams.len() as f64);
    let mut group = c.benchmark_group("patch of 4096 beams");
    group.throughput(Throughput::Elements(beams.len() as u64));
    group.bench_function("decode to beams", |b| b.iter(|| Patch::beams_of(&packed).unwrap()));
    group.bench_function("encode", |b| b.iter(|| Patch::encode(1, Vec3::zeros(), 2.5e-3, 1e-4, &beams).unwrap()));
    group.finish();
}

criterion_group!(benches, codec);
criterion_main!(benches);
