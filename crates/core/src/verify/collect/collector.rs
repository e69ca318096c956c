//! Adding patches to the evidence about one solid.

use std::sync::{Arc, OnceLock};

use super::drawn_object::{DrawnObject, margin};
use super::point_index::PointIndex;
use crate::geometry::{Solid, Vec3};
use crate::scan::{PatchHeader, RangeImage};
use crate::verify::aim::{Aim, AimedAt, BeamCrossing, OtherObjects, Unpacked, UnpackedBeams};
use crate::verify::evidence::{BLOCK, Evidence, SampleBlock, Samples, StationOrigin};
use crate::verify::model::{BeamModel, BeamOutcome, EvidenceModel, Sums, with_model};
use crate::{Interrupt, Result, poll};

/// Evidence being collected: the value, and the solid made ready for beams.
#[derive(Debug)]
pub struct Collector {
    pub(super) evidence: Evidence,
    pub(super) drawn: Arc<DrawnObject>,
    /// Ball (local centre, radius) around each block of samples.
    balls: Vec<(Vec3, f64)>,
    /// Made when the first point without a beam comes.
    pub(super) point_index: OnceLock<PointIndex>,
    /// Displaced by its own thickness, no beam aimed at it meets it.
    is_slim: bool,
}

impl Collector {
    /// Spreads samples over the solid; no patch was added yet.
    pub fn new(solid: &Solid, model: EvidenceModel, interrupt: Interrupt) -> Result<Self> {
        let drawn = DrawnObject::new(solid, model, interrupt)?;
        Self::begin(solid, Arc::new(drawn), false, interrupt)
    }

    /// The same for one of many objects: beams that other objects explain are left out of all that comes.
    pub(super) fn among_neighbours(solid: &Solid, drawn: Arc<DrawnObject>, interrupt: Interrupt) -> Result<Self> {
        Self::begin(solid, drawn, true, interrupt)
    }

    fn begin(solid: &Solid, drawn: Arc<DrawnObject>, knows_neighbours: bool, interrupt: Interrupt) -> Result<Self> {
        let evidence = Evidence::about(solid, drawn.model, knows_neighbours, interrupt)?;
        let (balls, is_slim) = (evidence.samples.balls(interrupt)?, evidence.samples.is_slim());
        Ok(Self { evidence, drawn, balls, point_index: OnceLock::new(), is_slim })
    }

    /// The evidence so far.
    pub fn evidence(&self) -> &Evidence {
        &self.evidence
    }

    /// Gives up the evidence.
    pub fn into_evidence(self) -> Evidence {
        self.evidence
    }

    /// Adds evidence from another collector of the same solid.
    pub fn merge(&mut self, other: &Evidence, interrupt: Interrupt) -> Result<()> {
        self.evidence.merge(other, interrupt)
    }

    /// Whether a patch can tell anything of the solid, by its header alone.
    pub fn concerns(&self, header: &PatchHeader) -> bool {
        self.drawn.concerns(header)
    }

    /// Adds what a packed patch tells. Points without origin count for the face nearest to them, and never for empty
    /// space.
    pub fn absorb(&mut self, patch: &[u8], interrupt: Interrupt) -> Result<()> {
        if !self.concerns(&PatchHeader::read(patch)?) {
            return Ok(());
        }
        let patch = Unpacked::of(patch, self.evidence.model.intensity.is_some())?;
        let aim = self.drawn.aim(&patch, interrupt)?;
        self.absorb_aimed(&patch, &aim, None, interrupt)
    }

    /// The samples, to be searched by points.
    pub(super) fn point_index(&self, interrupt: Interrupt) -> Result<&PointIndex> {
        if let Some(index) = self.point_index.get() {
            return Ok(index);
        }
        let made = PointIndex::of(&self.evidence.samples, interrupt)?;
        Ok(self.point_index.get_or_init(|| made))
    }

    /// Adds what a patch tells whose aim is known. What is rather one of the `others`' does not displace this one.
    pub(super) fn absorb_aimed(
        &mut self,
        patch: &Unpacked,
        aim: &Aim,
        others: Option<OtherObjects<'_>>,
        interrupt: Interrupt,
    ) -> Result<()> {
        with_model!(self.evidence.model.kind, M => self.absorb_with::<M>(patch, aim, others, interrupt))
    }

    fn absorb_with<M: BeamModel>(
        &mut self,
        patch: &Unpacked,
        aim: &Aim,
        others: Option<OtherObjects<'_>>,
        interrupt: Interrupt,
    ) -> Result<()> {
        match (&patch.beams, aim) {
            (_, Aim::Aside) => Ok(()),
            (_, Aim::At(crossings)) if crossings.is_empty() && !self.is_slim => Ok(()),
            (UnpackedBeams::FromOne(view), Aim::At(crossings)) => {
                let place = StationOrigin::At(view.header.origin);
                self.absorb_crossings::<M>(view, crossings, place, others, Some, interrupt)?;
                match others {
                    Some(others) if self.is_slim => self.absorb_beside::<M>(view, crossings, others, interrupt),
                    _ => Ok(()),
                }
            }
            (UnpackedBeams::FromOne(view), _) => {
                self.absorb_view::<M>(view, StationOrigin::At(view.header.origin), Some, interrupt)
            }
            // Each place counts alone; together they are one station.
            (UnpackedBeams::FromMany(views), _) => {
                for view in views {
                    if self.concerns(&view.header) {
                        self.absorb_view::<M>(view, StationOrigin::Many, Some, interrupt)?;
                    }
                }
                Ok(())
            }
            (UnpackedBeams::Points(points), Aim::Near(near)) => {
                self.absorb_cloud::<M>(&patch.header, points, near, others, interrupt)
            }
            (UnpackedBeams::Points(_), _) => Ok(()),
        }
    }

    /// `keep` may take back some of what the beams met.
    pub(super) fn absorb_view<M: BeamModel>(
        &mut self,
        view: &RangeImage,
        place: StationOrigin,
        keep: impl Fn(BeamOutcome) -> Option<BeamOutcome>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let crossings = if M::CROSSES_SURFACE { self.drawn.crossings(view, interrupt)? } else { Vec::new() };
        self.absorb_crossings::<M>(view, &crossings, place, None, keep, interrupt)
    }

    fn absorb_crossings<M: BeamModel>(
        &mut self,
        view: &RangeImage,
        crossings: &[BeamCrossing],
        place: StationOrigin,
        others: Option<OtherObjects<'_>>,
        keep: impl Fn(BeamOutcome) -> Option<BeamOutcome>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let model = self.evidence.model;
        let aimed = AimedAt { target: &self.drawn.target, crossings, others };
        match M::beams(view, &aimed, &model, keep, interrupt)? {
            Some(beams) => self.gather::<M>(view, place, &beams, interrupt),
            None => Ok(()),
        }
    }

    /// Adds the beams of a view to every sample that they may concern.
    fn gather<M: BeamModel>(
        &mut self,
        view: &RangeImage,
        place: StationOrigin,
        beams: &M::PreparedBeams<'_>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let header = &view.header;
        let (margin, reach, beside) = (margin(header), self.drawn.reach(header), M::beside_cone(beams));
        let number = self.evidence.station_index(header.station, place);
        let Evidence { samples, stations, .. } = &mut self.evidence;
        let station = &mut stations[number];
        let gathering =
            BlockGatherer::<'_, '_, M> { samples, scanner_local: header.origin - samples.reference, place, beams };
        let mut buffer = [Sums::default(); BLOCK];
        for (i, (block, (centre, radius))) in samples.blocks.iter().zip(&self.balls).enumerate() {
            let offset = centre - gathering.scanner_local;
            if offset.norm() - radius > reach
                || gathering.looks_away(block, &offset, *radius)
                || !header.cone.meets_ball(&offset, radius + beside, margin)
                || !M::may_tell_of(beams, &offset, *radius)
            {
                continue;
            }
            if i % 16 == 0 {
                poll(interrupt)?;
            }
            let sums = &mut buffer[..block.len as usize];
            sums.fill(Sums::default());
            gathering.add_to(block, sums);
            if sums.iter().any(|s| !s.is_empty()) {
                station.add_block(i as u32, sums);
                station.step = station.step.max(view.step() as f32);
            }
        }
        stations.retain(|s| !s.blocks.is_empty());
        self.evidence.check_size()
    }
}

/// The samples of an object and the beams of a view, to be brought together block by block.
struct BlockGatherer<'a, 'v, M: BeamModel> {
    samples: &'a Samples,
    scanner_local: Vec3,
    place: StationOrigin,
    beams: &'a M::PreparedBeams<'v>,
}

impl<M: BeamModel> BlockGatherer<'_, '_, M> {
    /// Whether a block in a ball at `offset` from the scanner looks away from it.
    fn looks_away(&self, block: &SampleBlock, offset_scanner: &Vec3, radius: f64) -> bool {
        let normal = &self.samples.normals[block.face as usize];
        M::CROSSES_SURFACE && !self.samples.two_sided && offset_scanner.dot(normal) > radius
    }

    fn add_to(&self, block: &SampleBlock, sums: &mut [Sums]) {
        let normal = &self.samples.normals[block.face as usize];
        // Deviations count towards the scanner; where there are many, along the normal.
        let turns = self.place == StationOrigin::Many && M::MEASURES_DEVIATIONS;
        for (k, sums) in sums.iter_mut().enumerate() {
            let offset = self.samples.local(block.start as usize + k) - self.scanner_local;
            let behind = self.samples.two_sided && offset.dot(normal) > 0.0;
            if behind && turns {
                let mut towards_scanner = Sums::default();
                M::gather(self.beams, &offset, &-normal, &mut towards_scanner);
                sums.add(&M::turned(&towards_scanner));
            } else {
                M::gather(self.beams, &offset, &if behind { -normal } else { *normal }, sums);
            }
        }
    }
}
