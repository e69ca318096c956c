//! An ideal observer at the stations: what they can see of an object and of its place, by rays in the scene as it stood,
//! with nothing taken from the verifier.

use asbuilt_core::geometry::Vec3;
use asbuilt_fieldscan::optics::MAX_PANE_INCIDENCE;
use asbuilt_fieldscan::{Optics, View};

use super::samples::Sample;
use super::scene::Scene;
use super::why::{Kept, kept};

/// Drawn surfaces nearer than this to each other, and parallel, are one to a survey, metres.
pub const SAME_PLACE_M: f64 = 0.01;
/// A beam that ends this far behind a place, perpendicular to it, found it empty, metres: beyond what registration,
/// range and tolerance of construction leave open.
const EMPTY_BEHIND_M: f64 = 0.015;
/// A beam that ends this far before a place, perpendicular to it, was kept from it, metres.
const HIDDEN_BEFORE_M: f64 = 0.006;
/// Steepest incidence that the verifier is told to take into account, radians.
pub const MAX_INCIDENCE: f64 = 80.0 * std::f64::consts::PI / 180.0;
/// Built surfaces are looked for so far from where they are drawn, metres.
const REACH_M: f64 = 0.35;
/// Panes on a way, at most.
const MAX_PANES: usize = 12;

/// What is true at a sample of a drawn object.
#[derive(Debug, Clone, Copy, Default)]
pub struct Truth {
    /// Plane face.
    pub face: usize,
    /// Area that it stands for, m².
    pub area: f64,
    /// Of glass: only beams near its normal say anything of it.
    pub glass: bool,
    /// On a leaf, and on one that stands elsewhere.
    pub leaf: bool,
    pub turned: bool,
    /// Another object drawn here, where it is drawn or where it was built.
    pub shared_with: Option<usize>,
    /// That one's surface looks the other way: where it stands, it covers this one.
    pub covered: bool,
    /// Distance from the built surface that looks its way, metres; infinite where there is none.
    pub distance: f64,
    /// Beams that end on its built place.
    pub beams_on: f64,
    /// Beams that go through its drawn place, and return from farther behind.
    pub beams_through: f64,
    /// Beams that end behind its drawn place by less than that, and by more than it may be off itself.
    pub beams_past: f64,
    /// Who stands before its drawn place as seen from the station nearest to it, where no station sees it.
    pub hidden_by: Option<u32>,
    /// What kept all stations from its drawn place.
    pub kept: Option<Kept>,
}

impl Truth {
    /// Whether a station sees what was built of it, and it is nobody else's.
    pub fn own(&self) -> bool {
        self.beams_on > 0.0 && self.shared_with.is_none() && !self.turned
    }
}

/// The truth at every sample of an object.
pub fn truths(scene: &Scene, number: usize) -> Vec<Truth> {
    scene.samples[number].iter().map(|s| truth(scene, number, s)).collect()
}

fn truth(scene: &Scene, number: usize, sample: &Sample) -> Truth {
    let (object, fate) = (&scene.layout.objects[number], &scene.fates[number]);
    let leaf = object.leaf[sample.triangle];
    let is_missing = fate.is_missing(&sample.place);
    let built = fate.place(&sample.place, leaf);
    let shared = |place: &Vec3| scene.layout.coincident(place, &sample.normal, number, SAME_PLACE_M);
    let elsewhere = || (!is_missing && !fate.is_turned(leaf)).then(|| shared(&built)).flatten();
    let coincident = shared(&sample.place).or_else(elsewhere);
    let standing = &scene.standing[number];
    let mut out = Truth {
        face: sample.face,
        area: sample.area,
        glass: object.transparent[sample.triangle],
        leaf: leaf.is_some(),
        turned: fate.is_turned(leaf),
        shared_with: coincident.map(|c| c.0),
        covered: coincident.is_some_and(|c| c.1),
        distance: standing.distance(&sample.place, &sample.normal, object.is_closed, REACH_M).unwrap_or(f64::INFINITY),
        ..Truth::default()
    };
    let mut nearest = f64::INFINITY;
    for (i, station) in scene.stations.iter().enumerate() {
        let look = Look { scene, view: scene.view(i), eye: station.place, both_sides: !object.is_closed };
        let Some(sight) = look.at(&sample.place, &sample.normal, out.glass) else { continue };
        match look.outcome(&sight) {
            Outcome::Through => out.beams_through += look.beams(&sight, sample.area),
            Outcome::Past => out.beams_past += look.beams(&sight, sample.area),
            Outcome::Hidden(by) if sight.range < nearest => {
                (nearest, out.hidden_by) = (sight.range, Some(by));
            }
            _ => {}
        }
        if !is_missing {
            let on = look.at(&built, &sample.normal, out.glass).filter(|s| look.ends_on(s));
            out.beams_on += on.map_or(0.0, |s| look.beams(&s, sample.area));
        }
    }
    out.kept = Some(kept(scene, number, sample, out.shared_with.is_some()));
    if out.beams_on > 0.0 || out.beams_through > 0.0 {
        out.hidden_by = None;
    }
    out
}

/// A station looking at places.
pub struct Look<'a> {
    pub scene: &'a Scene,
    pub view: View<'a>,
    pub eye: Vec3,
    /// Triangles do not tell their outside.
    pub both_sides: bool,
}

/// The line from a station to a place that it looks at from in front.
pub struct Sight {
    direction: Vec3,
    pub range: f64,
    /// Cosine of the angle of incidence.
    pub cos: f64,
    glass: bool,
}

/// What a beam at a drawn place does.
pub enum Outcome {
    Through,
    /// It ends behind it, by less than proves it empty.
    Past,
    There,
    /// By whose surface.
    Hidden(u32),
    /// Nothing returns.
    Nothing,
}

impl Look<'_> {
    /// The line to a place; `None` where it is seen from behind, too steeply, or below the tripod.
    fn at(&self, place: &Vec3, normal: &Vec3, glass: bool) -> Option<Sight> {
        let least = if glass { (0.8 * MAX_PANE_INCIDENCE).cos() } else { MAX_INCIDENCE.cos() };
        self.towards(place, normal).filter(|s| s.cos > least).map(|s| Sight { glass, ..s })
    }

    /// The same at any incidence from in front, as if nothing were of glass.
    pub fn towards(&self, place: &Vec3, normal: &Vec3) -> Option<Sight> {
        let sight = place - self.eye;
        let range = sight.norm();
        let direction = sight / range;
        let towards = -direction.dot(normal);
        let cos = if self.both_sides { towards.abs() } else { towards };
        let scanner = &self.scene.plan.scanner;
        let is_in_view = direction.z > scanner.min_elevation.sin() && range < scanner.max_range;
        (cos > 0.0 && is_in_view).then_some(Sight { direction, range, cos, glass: false })
    }

    fn beams(&self, sight: &Sight, area: f64) -> f64 {
        area * sight.cos / (self.scene.plan.scanner.step * sight.range).powi(2)
    }

    /// What a beam at a drawn place does.
    pub fn outcome(&self, sight: &Sight) -> Outcome {
        let Some((range, power, owner)) = self.first_that_answers(sight) else { return Outcome::Nothing };
        let behind = (range - sight.range) * sight.cos;
        match () {
            () if behind < -HIDDEN_BEFORE_M => Outcome::Hidden(owner),
            () if behind < HIDDEN_BEFORE_M => Outcome::There,
            () if behind < EMPTY_BEHIND_M => Outcome::Past,
            () if power < self.scene.plan.scanner.receiver.min_power => Outcome::Nothing,
            () => Outcome::Through,
        }
    }

    /// Whether a beam at a built place ends there.
    fn ends_on(&self, sight: &Sight) -> bool {
        let Some((range, power, _)) = self.first_that_answers(sight) else { return false };
        let behind = (range - sight.range) * sight.cos;
        let is_bright = sight.glass || power >= self.scene.plan.scanner.receiver.min_power;
        behind.abs() < HIDDEN_BEFORE_M && is_bright
    }

    /// The first surface that is no pane (or, looking at a pane, the pane itself) along a line: its range, the power of
    /// its echo, and whose it is.
    fn first_that_answers(&self, sight: &Sight) -> Option<(f64, f64, u32)> {
        let mut beyond = 1e-6;
        for _ in 0..MAX_PANES {
            let met = self.view.first(&self.eye, &sight.direction, beyond)?;
            let is_pane = met.material.optics == Optics::Glass;
            let is_aim = sight.glass && (met.range - sight.range).abs() * sight.cos < HIDDEN_BEFORE_M;
            if !is_pane || is_aim {
                let cos = met.normal.dot(&sight.direction).abs();
                return Some((met.range, met.material.reflectivity * cos / met.range.powi(2), met.owner));
            }
            beyond = met.range + 1e-6;
        }
        None
    }
}
