//! Cutting a scan into angular tiles.

use super::beam::{Beam, MAX_BEAMS};
use super::cone::Cone;
use super::halve::halve;
use crate::geometry::Vec3;
use crate::{Interrupt, Result, poll_now_and_then};

/// Widest tile on the cube map, about 1 rad: sparse scans get more and smaller tiles rather than wide cones.
const MAX_EXTENT: f64 = 1.0;

/// Cuts beams into tiles of at most [`MAX_BEAMS`] neighbouring directions; each is a list of beam numbers in scan
/// order. Every beam is in exactly one tile; beams of zero length are in none.
///
/// Directions are projected onto the faces of a cube (no pole, unlike azimuth and elevation). Then each face is halved
/// across its longer side into equal counts until the tiles are small.
pub fn tiles(beams: &[Beam], interrupt: Interrupt) -> Result<Vec<Vec<u32>>> {
    let mut faces: [Vec<CubeMapPoint>; 6] = Default::default();
    for (i, b) in beams.iter().enumerate() {
        poll_now_and_then(i, interrupt)?;
        if let Some((face, uv)) = cube_map(&b.offset) {
            faces[face].push(CubeMapPoint { uv, beam: i as u32 });
        }
    }
    let mut out = Vec::new();
    for face in &mut faces {
        halve(face, &|p| p.beam, &|p, axis| p.uv[axis], &wide, &mut out, interrupt)?;
    }
    Ok(out)
}

/// Angle between neighbouring beams, radians, when the scanner does not tell it: the square root of the solid angle
/// that the tile covers per beam. The covered part is counted in cells that hold about four beams each, so that holes
/// do not widen it.
pub fn mean_step(beams: &[Beam]) -> f64 {
    let directions: Vec<Vec3> = beams.iter().filter_map(|b| b.offset.try_normalize(1e-12)).collect();
    let cone = Cone::around(&directions);
    let basis = cone.basis();
    let image: Vec<[f64; 2]> =
        directions.iter().map(|d| basis.map(|b| d.dot(&b) / d.dot(&cone.axis).max(0.1))).collect();
    let side = |k: usize| {
        let (lo, hi) = image.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[k]), h.max(p[k])));
        (lo, (hi - lo).max(1e-6))
    };
    let sides = [side(0), side(1)];
    let cells = ((image.len() as f64 / 4.0).sqrt().floor()).max(1.0);
    let mut occupied = vec![false; (cells * cells) as usize];
    for p in &image {
        let [c, r] = [0, 1].map(|k| ((p[k] - sides[k].0) / sides[k].1 * cells).min(cells - 0.5) as usize);
        occupied[r * cells as usize + c] = true;
    }
    let covered = occupied.iter().filter(|&&o| o).count();
    let area = sides[0].1 * sides[1].1 * covered as f64 / (cells * cells);
    (area / image.len().max(1) as f64).sqrt().max(1e-6)
}

struct CubeMapPoint {
    uv: [f64; 2],
    beam: u32,
}

/// The face of the cube that a direction meets, and where on it, each coordinate in [−1, 1].
fn cube_map(v: &Vec3) -> Option<(usize, [f64; 2])> {
    let axis = v.iamax();
    let top = v[axis].abs();
    if top.is_nan() || top <= 1e-9 {
        return None;
    }
    let face = 2 * axis + usize::from(v[axis] < 0.0);
    Some((face, [v[(axis + 1) % 3] / top, v[(axis + 2) % 3] / top]))
}

/// The longer side of a tile that is too large.
fn wide(places: &[CubeMapPoint]) -> Option<usize> {
    let side = |k: usize| {
        let (lo, hi) =
            places.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), p| (lo.min(p.uv[k]), hi.max(p.uv[k])));
        hi - lo
    };
    let extent = [side(0), side(1)];
    let is_tile = places.len() <= MAX_BEAMS && extent[0].max(extent[1]) <= MAX_EXTENT;
    (!is_tile).then(|| usize::from(extent[1] > extent[0]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;

    #[test]
    fn a_full_sphere_is_cut_into_narrow_full_tiles() {
        let step = 8e-3;
        let beams: Vec<Beam> = (0..785 * 390)
            .map(|i| {
                let (az, el) = (f64::from(i / 390) * step, f64::from(i % 390) * step - 1.55);
                Beam { offset: Vec3::new(el.cos() * az.cos(), el.cos() * az.sin(), el.sin()) * 5.0, returned: true }
            })
            .collect();
        let tiles = tiles(&beams, NEVER).unwrap();
        let mut seen = vec![0; beams.len()];
        for tile in &tiles {
            assert!(tile.len() <= MAX_BEAMS && tile.is_sorted());
            tile.iter().for_each(|&b| seen[b as usize] += 1);
            let directions: Vec<Vec3> = tile.iter().map(|&b| beams[b as usize].offset.normalize()).collect();
            assert!(Cone::around(&directions).half_angle < 0.75);
        }
        assert!(seen.iter().all(|&n| n == 1));
        assert!(tiles.len() * MAX_BEAMS < beams.len() * 5 / 4, "{} tiles", tiles.len());
    }

    #[test]
    fn step_is_found_from_the_beams() {
        let grid = |step: f64, holes: bool| -> Vec<Beam> {
            (0..64 * 64)
                .filter(|i| !holes || i % 64 < 32)
                .map(|i| Vec3::new(1.0, f64::from(i % 64) * step, f64::from(i / 64) * step))
                .map(|offset| Beam { offset, returned: true })
                .collect()
        };
        for (step, holes) in [(1e-3, false), (5e-3, false), (2e-3, true)] {
            let got = mean_step(&grid(step, holes));
            assert!((got / step - 1.0).abs() < 0.1, "{got} for {step}");
        }
        assert!(mean_step(&[]) > 0.0);
    }

    #[test]
    fn degenerate_scans() {
        let beam = |v: Vec3| Beam { offset: v, returned: true };
        assert!(tiles(&[], NEVER).unwrap().is_empty());
        assert!(tiles(&[beam(Vec3::zeros())], NEVER).unwrap().is_empty());
        let same = vec![beam(Vec3::x()); 10_000];
        assert_eq!(tiles(&same, NEVER).unwrap().iter().map(Vec::len).sum::<usize>(), 10_000);
        assert_eq!(tiles(&[beam(Vec3::x()), beam(-Vec3::x())], NEVER).unwrap().len(), 2);
    }
}
