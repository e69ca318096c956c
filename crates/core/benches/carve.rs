//! Carving a tile of 4096 beams on a wall 6 m away into an occupancy: beams per second on one core.

use asbuilt_core::NEVER;
use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Patch};
use asbuilt_core::voxel::{Grid, Occupancy, traverse};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

/// 64 x 64 beams at a step of 2.5 mrad, about an azimuth.
fn tile(azimuth: f64) -> Vec<u8> {
    let beam = |i: usize| {
        let (a, e) = (azimuth + (i % 64) as f64 * 2.5e-3, -0.1 + (i / 64) as f64 * 2.5e-3);
        Beam { offset: Vec3::new(e.cos() * a.cos(), e.cos() * a.sin(), e.sin()) * 6.0, returned: true }
    };
    let beams: Vec<Beam> = (0..4096).map(beam).collect();
    Patch::encode(1, Vec3::new(0.3, 0.2, 1.5), 2.5e-3, Patch::QUANTUM_M, &beams).unwrap().to_bytes()
}

fn carve(c: &mut Criterion) {
    let mut group = c.benchmark_group("carve 4096 beams of 6 m");
    group.throughput(Throughput::Elements(4096));
    for exact in [false, true] {
        for (voxel, azimuth) in [(0.02, 0.1), (0.02, 0.7), (0.02, 1.5), (0.01, 0.1), (0.01, 0.7)] {
            let patch = tile(azimuth);
            let grid = Grid { exact, ..Grid::new(voxel, Grid::EVERYWHERE, 0.0, 5.0).unwrap() };
            let name = if exact { "exact" } else { "filled" };
            group.bench_function(format!("{name}, {} mm, azimuth {azimuth}", voxel * 1e3), |b| {
                let mut o = Occupancy::new(grid);
                b.iter(|| o.absorb(&patch, NEVER).unwrap());
            });
        }
    }
    group.finish();
}

/// Voxels that a beam passes, and how many of them are stepped through per second: one by one, and in slabs of bits.
fn steps(c: &mut Criterion) {
    let mut group = c.benchmark_group("voxel steps");
    for (voxel, azimuth) in [(0.02, 0.1), (0.02, 0.7), (0.01, 0.7)] {
        let (header, content) = Patch::content_of(&tile(azimuth)).unwrap();
        let start = header.origin / voxel;
        let ends: Vec<Vec3> = content.beams.iter().map(|b| start + b.offset / voxel).collect();
        let mut passed = 0u64;
        ends.iter().for_each(|end| traverse(&start, end, |_| passed += 1));
        group.throughput(Throughput::Elements(passed));
        group.bench_function(format!("one by one, {} mm, azimuth {azimuth}", voxel * 1e3), |b| {
            b.iter(|| {
                let mut sum = 0i64;
                ends.iter().for_each(|end| traverse(&start, end, |v| sum ^= v[0] + v[1] + v[2]));
                sum
            });
        });
        let patch = tile(azimuth);
        let grid = Grid { exact: true, ..Grid::new(voxel, Grid::EVERYWHERE, 0.0, 5.0).unwrap() };
        group.bench_function(format!("carved exactly, {} mm, azimuth {azimuth}", voxel * 1e3), |b| {
            let mut o = Occupancy::new(grid);
            b.iter(|| o.absorb(&patch, NEVER).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, carve, steps);
criterion_main!(benches);
