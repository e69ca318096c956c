//! Evidence to be expected: what stations would say of an object that is built as drawn.

use crate::geometry::{Solid, Vec3};
use crate::verify::evidence::{Evidence, StationOrigin};
use crate::verify::model::{EvidenceModel, Sums, SurfaceSums};
use crate::{Interrupt, Result, poll};

/// A scanner position that is planned.
#[derive(Debug, Clone, Copy)]
pub struct PlannedStation {
    /// World metres.
    pub origin: Vec3,
    /// Angle between neighbouring beams, radians.
    pub step: f64,
    /// Range of the scanner, metres.
    pub max_range: f64,
}

impl PlannedStation {
    /// Whether beams meet a face here at an incidence and range that count; not whether anything stands between.
    /// World metres.
    pub fn faces(&self, position: &Vec3, normal: &Vec3, model: &EvidenceModel) -> bool {
        let sight = position - self.origin;
        let range = sight.norm();
        range <= self.max_range && range > 0.0 && -sight.dot(normal) >= model.max_incidence.cos() * range
    }
}

impl Evidence {
    /// Evidence as if every planned station had met the drawn surface wherever it faces it and `is_free(station,
    /// sample)` says that nothing hides it: a full kernel of beams, none of them off by more than its noise.
    /// World metres.
    pub fn expected(
        solid: &Solid,
        model: EvidenceModel,
        stations: &[PlannedStation],
        is_free: impl Fn(&Vec3, &Vec3) -> bool,
        interrupt: Interrupt,
    ) -> Result<Self> {
        let mut out = Self::about(solid, model, true, interrupt)?;
        for (id, planned) in stations.iter().enumerate() {
            let at = out.station_index(id as i64 + 1, StationOrigin::At(planned.origin));
            let Self { samples, stations, .. } = &mut out;
            stations[at].step = planned.step as f32;
            for (b, block) in samples.blocks.iter().enumerate() {
                poll(interrupt)?;
                let normal = samples.normals[block.face as usize];
                let sees = |k: usize| {
                    let position = samples.position(block.start as usize + k);
                    planned.faces(&position, &normal, &model) && is_free(&planned.origin, &position)
                };
                let expected = |k| if sees(k) { SurfaceSums::full_kernel() } else { Sums::default() };
                let sums: Vec<Sums> = (0..block.len as usize).map(expected).collect();
                if sums.iter().any(|s| !s.is_empty()) {
                    stations[at].add_block(b as u32, &sums);
                }
            }
        }
        out.stations.retain(|s| !s.blocks.is_empty());
        Ok(out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NEVER;
    use crate::evidence::Loa;
    use crate::verify::{Verdict, VerdictRule};

    #[test]
    fn a_wall_before_and_behind_a_screen() {
        let wall = Solid::cuboid([5.0, -2.0, 0.0], [5.2, 2.0, 2.5]).unwrap();
        let station = |x: f64| PlannedStation { origin: Vec3::new(x, 0.0, 1.5), step: 2e-3, max_range: 50.0 };
        let model = EvidenceModel::default();
        // What stands before the wall hides its half with y > 0 from everywhere.
        let half = |_: &Vec3, p: &Vec3| p.y < 0.0;
        let e = Evidence::expected(&wall, model, &[station(0.0)], half, NEVER).unwrap();
        let s = e.summary(&model.question, &VerdictRule::default(), NEVER).unwrap();
        let seen = 0.5 * 4.0 * 2.5 / wall.area();
        assert!((s.coverage - seen).abs() < 0.01, "{} {seen}", s.coverage);
        assert_eq!((s.verdict, s.best_loa), (Verdict::Confirmed, Some(Loa::Loa40)));
        let both = Evidence::expected(&wall, model, &[station(0.0), station(10.0)], half, NEVER).unwrap();
        assert!(
            (both.summary(&model.question, &VerdictRule::default(), NEVER).unwrap().coverage - 2.0 * seen).abs() < 0.02
        );
        let none = Evidence::expected(&wall, model, &[station(0.0)], |_, _| false, NEVER).unwrap();
        assert!(none.stations().is_empty());
        // Registered to 5 mm, one station proves LOA30 (1.96 σ < 15 mm) and no more.
        let rough = EvidenceModel { sigma_station: 0.005, ..model };
        let e = Evidence::expected(&wall, rough, &[station(0.0)], half, NEVER).unwrap();
        assert_eq!(e.summary(&rough.question, &VerdictRule::default(), NEVER).unwrap().best_loa, Some(Loa::Loa30));
    }
}
