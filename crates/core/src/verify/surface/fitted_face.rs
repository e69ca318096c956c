//! One face, as built: how far off it is, whatever the level of accuracy.

use super::compact::CompactDeviation;
use super::fitted_surface::FittedSurface;
use super::observations::Observations;
use crate::geometry::{FaceKind, Vec3};
use crate::num::stats::{MEDIAN_SD, median_and_spread};
use crate::verify::evidence::Evidence;
use crate::verify::model::EvidenceModel;
use crate::{Interrupt, Result, poll, poll_now_and_then};

/// Of a face that is not cut off by the ends of the search band at most this share lies as near to them as
/// [`BORDER_M`].
const MAX_AT_THE_END: f64 = 0.05;
/// σ of where a pane is met, metres: the echo of its other side, or of the second pane, mixes in.
const PANE_SD_M: f64 = 0.004;
/// Width of what is near an end of the search band, metres.
const BORDER_M: f64 = 0.015;

/// Where one face is.
#[derive(Debug, Clone)]
pub struct FittedFace {
    /// Outward unit normal.
    pub normal: Vec3,
    /// The smooth surface that it is a facet of.
    pub smooth_surface: u32,
    /// What it belongs to.
    pub kind: FaceKind,
    /// All samples, or those that were seen of a face that is not expected to be.
    pub samples: u64,
    /// It is no leaf or pane, or the object has nothing else.
    pub is_expected: bool,
    /// Samples at which any surface was seen within the search band.
    pub with_surface: u64,
    /// Most of the seen samples of its surface follow one trend.
    pub coherent: bool,
    /// Median deviation along the outward normal, metres, and its standard deviation.
    pub deviation: Option<(f64, f64)>,
    /// The part of that standard deviation that is the face's own: without registration and model.
    pub random_sd: f64,
    /// Share of each station in that deviation.
    pub stations: Vec<(usize, f64)>,
}

/// What was measured at the samples of a face that count for its deviation.
#[derive(Default)]
struct Measured {
    with_surface: u64,
    deviations: Vec<f64>,
    /// Sum of the variances of the beams' noise, m².
    noise: f64,
    independent: f64,
}

impl FittedFace {
    /// Every face of an object.
    pub fn all(
        e: &Evidence,
        observations: &Observations,
        on_surface: &[CompactDeviation],
        surfaces: &[FittedSurface],
        model: &EvidenceModel,
        interrupt: Interrupt,
    ) -> Result<Vec<Self>> {
        let is_expected = e.samples.expects();
        let face = |face: usize| {
            poll(interrupt)?;
            let smooth_surface = e.samples.surface_of_face[face];
            let coherent = surfaces.get(smooth_surface as usize).is_some_and(|s| s.coherent);
            let measured = Measured::at(face, observations, on_surface, coherent, interrupt)?;
            poll(interrupt)?;
            let shares = &observations.stations_of_face[face];
            let (with_surface, common) = (measured.with_surface, shares.common_variance(model));
            let truncated = measured.is_truncated(model);
            let (location, random_sd) = measured.location(coherent);
            let location = location.filter(|_| !truncated);
            let kind = e.samples.kinds[face];
            let of_pane = if kind == FaceKind::Transparent { PANE_SD_M } else { 0.0 };
            let with_sd =
                |d: f64| (d, (random_sd.powi(2) + common).sqrt().hypot(model.second_order_sd(d)).hypot(of_pane));
            Ok(Self {
                normal: e.samples.normals[face],
                smooth_surface,
                kind,
                samples: shares.samples,
                is_expected: is_expected(face),
                with_surface,
                coherent,
                deviation: location.map(with_sd),
                random_sd,
                stations: shares.shares().collect(),
            })
        };
        (0..observations.faces.len()).map(face).collect()
    }
}

impl Measured {
    fn at(
        face: usize,
        observations: &Observations,
        on_surface: &[CompactDeviation],
        coherent: bool,
        interrupt: Interrupt,
    ) -> Result<Self> {
        let run = observations.faces[face].clone();
        let mut out = Self::default();
        for (i, (s, on_surface)) in observations.seen[run.clone()].iter().zip(&on_surface[run]).enumerate() {
            poll_now_and_then(i, interrupt)?;
            let Some((body, deviation)) = observations.surface_body(s) else { continue };
            out.with_surface += 1;
            // Where the surface is known, what else was met there does not count.
            if !coherent || on_surface.is_some() {
                out.deviations.push(deviation);
                out.noise += f64::from(body.random_variance);
                out.independent += f64::from(s.independence);
            }
        }
        Ok(out)
    }

    /// Whether the surface goes on where nothing is looked for: its median would be too small.
    fn is_truncated(&self, model: &EvidenceModel) -> bool {
        let (in_front, behind) = (model.band_in_front() - BORDER_M, model.band_behind() - BORDER_M);
        let at_the_end = self.deviations.iter().filter(|d| **d > in_front || **d < -behind).count();
        at_the_end as f64 > MAX_AT_THE_END * self.deviations.len() as f64
    }

    /// The median deviation, metres, and the standard deviation that is the face's own.
    fn location(mut self, coherent: bool) -> (Option<f64>, f64) {
        let count = self.deviations.len();
        let location = median_and_spread(&mut self.deviations);
        // The median of what is independent; a bent face spreads by its shape, which is not noise.
        let scatter = if coherent { self.noise / count.max(1) as f64 } else { location.map_or(0.0, |l| l.1.powi(2)) };
        let random_sd = MEDIAN_SD * (scatter / f64::max(self.independent, 1.0)).sqrt();
        (location.map(|l| l.0), random_sd)
    }
}

#[cfg(test)]
mod tests {
    use super::super::fitted_object::FittedObject;
    use super::*;
    use crate::NEVER;
    use crate::geometry::Solid;
    use crate::scan::{Beam, Patch};
    use crate::verify::Collector;

    #[test]
    fn where_a_face_is_and_how_well_that_is_known() {
        let measured = |deviations: &[f64], noise: f64, independent: f64| Measured {
            with_surface: deviations.len() as u64,
            deviations: deviations.to_vec(),
            noise,
            independent,
        };
        assert_eq!(measured(&[], 0.0, 0.0).location(true), (None, 0.0));
        assert_eq!(measured(&[], 0.0, 0.0).location(false), (None, 0.0));
        let four = [0.010, 0.012, 0.014, 0.100];
        // Of one surface the beams' noise counts: σ² of each over as many as are independent.
        let (location, sd) = measured(&four, 4.0 * 1e-6, 4.0).location(true);
        assert!((location.unwrap() - 0.013).abs() < 1e-12);
        assert!((sd - MEDIAN_SD * 1e-3 / 2.0).abs() < 1e-12, "{sd}");
        // Of whatever was met the scatter.
        let (location, sd) = measured(&four, 4.0 * 1e-6, 4.0).location(false);
        assert!((location.unwrap() - 0.013).abs() < 1e-12);
        assert!((sd - MEDIAN_SD * 1.4826 * 0.002 / 2.0).abs() < 1e-12, "{sd}");
        // Samples that share their beams are never worth less than one.
        let (_, sd) = measured(&four, 4.0 * 1e-6, 0.1).location(true);
        assert!((sd - MEDIAN_SD * 1e-3).abs() < 1e-12, "{sd}");
    }

    #[test]
    fn a_displaced_face_is_where_it_was_built() {
        let wall = Solid::cuboid([4.0, -0.5, -0.5], [4.2, 0.5, 0.5]).unwrap();
        let model = EvidenceModel::default();
        let mut collector = Collector::new(&wall, model, NEVER).unwrap();
        for station in [3, 5] {
            let end = |i: i32| Vec3::new(3.988, f64::from(i % 60) * 0.02 - 0.6, f64::from(i / 60) * 0.02 - 0.6);
            let beams: Vec<Beam> = (0..3600).map(|i| Beam { offset: end(i), returned: true }).collect();
            let patch = Patch::encode(station, Vec3::zeros(), 5e-3, 1e-4, &beams).unwrap();
            collector.absorb(&patch.to_bytes(), NEVER).unwrap();
        }
        let evidence = collector.into_evidence();
        let faces = FittedObject::of(&evidence, &model, NEVER).unwrap().faces;
        assert_eq!(faces.len(), 6);
        for face in &faces {
            let Some((deviation, sd)) = face.deviation else {
                assert!(face.with_surface == 0 && face.stations.is_empty() && face.normal.x > -0.5);
                continue;
            };
            assert!(face.normal.x < -0.5 && face.coherent && face.with_surface > face.samples * 9 / 10);
            assert!((deviation - 0.012).abs() < 1e-4, "{deviation}");
            // Two stations, each registered to a millimetre.
            let common = (model.sigma_station.powi(2) / 2.0 + model.least_variance()).sqrt();
            assert!(sd >= common && sd < 1.1 * common.hypot(face.random_sd).hypot(1.2e-4), "{sd}");
            assert!(face.stations.len() == 2 && face.stations.iter().all(|s| (s.1 - 0.5).abs() < 1e-9));
        }
        assert_eq!(faces.iter().filter(|f| f.deviation.is_some()).count(), 1);
    }
}
