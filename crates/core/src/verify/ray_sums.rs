//! The `meyer2022` model's sums: logarithmic commonalities of every beam that passes near a sample.

use super::model::EvidenceModel;
use super::sums::Sums;
use crate::evidence::{LogCommonality, Mass, RayModel};
use crate::geometry::Vec3;
use crate::scan::View;

/// Fixed-point unit of a logarithm, 2⁻⁴⁴: 6e-14, with room for half a million.
const LOGARITHM: f64 = (1u64 << 44) as f64;
/// Beams whose mass is nowhere above this are left out.
const LEAST_MASS: f64 = 1e-13;

/// Distance across a beam within which it speaks, metres.
pub fn reach(model: &EvidenceModel) -> f64 {
    model.ray_model().reach(LEAST_MASS)
}

/// Adds the beams that pass near a sample; `offset` leads from the scanner to it.
pub fn gather(view: &View, offset: &Vec3, model: &EvidenceModel, sums: &mut Sums) {
    let rays: RayModel = model.ray_model();
    let reach = reach(model);
    let range = offset.norm();
    if range <= reach {
        return; // at the scanner itself
    }
    let Some(uv) = view.project(offset) else { return };
    let radius = (reach / range).asin().tan() * (1.0 + uv[0] * uv[0] + uv[1] * uv[1]) * 1.2;
    for slots in view.slots_in([uv[0] - radius, uv[1] - radius], [uv[0] + radius, uv[1] + radius]) {
        for slot in slots {
            let beam_range = view.ranges[slot];
            if beam_range.is_infinite() {
                continue;
            }
            let along = offset.dot(&view.directions[slot]);
            let across_squared = (offset - view.directions[slot] * along).norm_squared();
            if across_squared > reach * reach {
                continue;
            }
            let mass = rays.mass_at(along - beam_range, across_squared, beam_range).discounted(model.reliability);
            add_mass(&mass, sums);
        }
    }
}

/// Adds one source's mass, unless it says next to nothing.
pub fn add_mass(mass: &Mass, sums: &mut Sums) {
    if mass.unknown < 1.0 - LEAST_MASS {
        add(&mass.log_commonality(), sums);
    }
}

fn add(q: &LogCommonality, sums: &mut Sums) {
    for (sum, log) in sums.parts.iter_mut().zip([q.occupied, q.empty, q.unknown]) {
        *sum = sum.saturating_add((log * LOGARITHM).round() as i64);
    }
    sums.beams = sums.beams.saturating_add(1);
}

/// The commonalities of one station's beams.
pub fn reading(sums: &Sums) -> LogCommonality {
    let [occupied, empty, unknown, ..] = sums.parts.map(|p| p as f64 / LOGARITHM);
    LogCommonality { occupied, empty, unknown }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::Mass;
    use crate::scan::{Beam, Patch};

    #[test]
    fn equals_pairwise_combination_of_hand_computed_masses() {
        let beams: Vec<Beam> = (0..9)
            .map(|i| Beam { offset: Vec3::new(5.0, f64::from(i % 3) * 0.01, f64::from(i / 3) * 0.01), returned: true })
            .collect();
        let bytes = Patch::encode(0, Vec3::zeros(), 2e-3, 1e-4, &beams).unwrap().to_bytes();
        let (header, content) = Patch::beams_of(&bytes).unwrap();
        let view = View::new(header, &content.beams);
        let model = EvidenceModel::default();
        for query in [Vec3::new(4.998, 0.012, 0.007), Vec3::new(4.95, 0.0, 0.0), Vec3::new(5.02, 0.01, 0.01)] {
            let mut sums = Sums::default();
            gather(&view, &query, &model, &mut sums);
            let mut want = Mass::VACUOUS;
            for b in &beams {
                let m = RayModel::LASER.mass(&Vec3::zeros(), &b.offset, &query).discounted(model.reliability);
                want = want.combine(&m).unwrap();
            }
            let got = reading(&sums).mass().unwrap();
            assert!(
                (got.occupied - want.occupied).abs() < 1e-12 && (got.empty - want.empty).abs() < 1e-12,
                "{got:?} {want:?}"
            );
        }
    }
}
