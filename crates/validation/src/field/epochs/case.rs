//! One object of one pair of epochs: what may be said, what was said.

use asbuilt_core::verify::{ObjectChange, ObjectChangeClass};

use super::deed::{Deed, Done};
use super::right::{Right, Seen, right};
use crate::field::layout::Kind;
use crate::field::scene::Scene;

/// An object-case.
#[derive(Debug)]
pub struct Case {
    pub scene: usize,
    pub model: String,
    pub id: String,
    pub class: String,
    pub name: String,
    pub kind: Kind,
    pub done: Done,
    /// Displacement between the epochs, millimetres.
    pub moved_mm: [f64; 3],
    pub right: Right,
    pub said: ObjectChange,
    /// The displacement's error in σ along each determined axis.
    pub errors: Vec<f64>,
}

impl Case {
    /// What was said of an object.
    pub fn of(epochs: &[Scene; 2], number: usize, deed: &Deed, seen: &[Seen; 2], said: ObjectChange) -> Self {
        let object = &epochs[0].layout.objects[number];
        let common_sd = epochs[0].common_sd().hypot(epochs[1].common_sd());
        let by = deed.fates[1].shift - deed.fates[0].shift;
        let is_rigid = matches!(deed.done, Done::Stands | Done::Moved);
        let errors = said.displacement.iter().filter(|_| is_rigid).flat_map(|d| {
            let shift = d.shift.clone();
            (0..3).filter(move |i| d.shift.determines(*i)).map(move |i| (shift.vector[i] - by[i]) / shift.sd(i))
        });
        Self {
            scene: epochs[0].plan.number,
            model: epochs[0].plan.name(),
            id: object.id.clone(),
            class: object.class.clone(),
            name: object.name.clone(),
            kind: object.kind,
            done: deed.done,
            moved_mm: (by * 1e3).into(),
            right: right(deed, &epochs[0].samples[number], seen, common_sd),
            errors: errors.collect(),
            said,
        }
    }

    /// Whether the class is right.
    pub fn is_right(&self) -> bool {
        self.right.classes.contains(&self.said.class)
    }

    /// Whether nothing was done to it.
    pub fn is_unchanged(&self) -> bool {
        matches!(self.done, Done::Stands | Done::Missing)
    }

    /// Whether it is said to have changed.
    pub fn is_called_changed(&self) -> bool {
        !matches!(self.said.class, ObjectChangeClass::Unchanged | ObjectChangeClass::NotComparable)
    }

    /// Whether nothing was said of it.
    pub fn is_declined(&self) -> bool {
        self.said.class == ObjectChangeClass::NotComparable
    }

    /// A line of the list of cases.
    pub fn line(&self) -> String {
        let text = |s: &str| format!("\"{}\"", s.replace('"', "'"));
        let [x, y, z] = self.moved_mm;
        let (r, s) = (&self.right, &self.said.samples);
        let right: Vec<&str> = r.classes.iter().map(|c| c.name()).collect();
        let shift = self.said.displacement.as_ref().map_or_else(
            || "-,-,-".into(),
            |d| format!("{},{:.1e},{:.1}", text(&d.shift.to_text()), d.chance, d.floor * 1e3),
        );
        [
            format!("{},{},{}", self.scene, text(&self.model), u8::from(self.is_right())),
            format!("{},{},{},{}", text(&self.id), self.class, text(&self.name), self.kind.name()),
            format!("{},{x:.1},{y:.1},{z:.1},{},{}", self.done.name(), right.join("|"), self.said.class.name()),
            format!("{},{},{},{},{},{},{}", s.samples, s.seen_in_both, s.kept, s.displaced, s.lost, s.won, s.empty),
            format!("{:.3},{:.3},{:.3},{:.3},{:.0},{:.1}", r.kept, r.lost, r.won, r.empty, r.beams, r.visible_m * 1e3),
            shift,
        ]
        .join(",")
    }

    /// The columns of [`Self::line`].
    pub const HEAD: &str = "scene,model,is_right,id,class,name,kind,done,dx_mm,dy_mm,dz_mm,right,said,samples,\
        seen_in_both,kept,displaced,lost,won,empty,true_kept,true_lost,true_won,true_empty,beams,visible_mm,shift,\
        chance,floor_mm";
}
