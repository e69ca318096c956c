//! Swept solids that the geometry library narrows at corners, draws coarsely, or lacks: built here and handed to it as triangles.
//!
//! * [`path`]: the line that is followed, and its corners;
//! * [`section`]: the profile; [`roll`]: how it is turned about the line;
//! * [`rings`]: the profile along the line, mitred at corners; [`taper`]: from one profile to another;
//! * [`turned`]: about an axis;
//! * [`skin`]: the surface through the rings, as text;
//! * [`shapes`]: what is read of the file.

mod path;
mod rings;
mod roll;
mod section;
mod shapes;
mod skin;
mod taper;
mod turned;

use std::borrow::Cow;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::document::{Document, Edits};
use shapes::Shapes;
use skin::Skin;

/// What is built here.
#[derive(Debug, Clone, Copy)]
pub enum SweepKind {
    /// A profile along a curve, turned by a surface or a direction.
    Along,
    Disk,
    /// A disk along a polyline with rounded corners.
    RoundedDisk,
    TaperedExtrusion,
    TaperedRevolution,
    Revolution,
}

const KINDS: [(&str, SweepKind); 7] = [
    ("IFCSURFACECURVESWEPTAREASOLID", SweepKind::Along),
    ("IFCFIXEDREFERENCESWEPTAREASOLID", SweepKind::Along),
    ("IFCSWEPTDISKSOLID", SweepKind::Disk),
    ("IFCSWEPTDISKSOLIDPOLYGONAL", SweepKind::RoundedDisk),
    ("IFCEXTRUDEDAREASOLIDTAPERED", SweepKind::TaperedExtrusion),
    ("IFCREVOLVEDAREASOLIDTAPERED", SweepKind::TaperedRevolution),
    ("IFCREVOLVEDAREASOLID", SweepKind::Revolution),
];

pub fn is_needed(document: &Document) -> bool {
    KINDS.iter().any(|(keyword, _)| document.all(keyword).next().is_some())
}

/// Writes them out; what cannot be built stays as it is, with a note where the library's version may be wrong.
pub fn write_out<'a>(text: Cow<'a, [u8]>, angle: Option<f64>, notes: &mut Vec<(u64, String)>) -> Cow<'a, [u8]> {
    let document = Document::new(&text);
    let mut free = document.free_numbers();
    let mut edits = Edits::default();
    let mut shapes = None;
    for (keyword, kind) in KINDS {
        for record in document.all(keyword) {
            let shapes = shapes.get_or_insert_with(|| Shapes::new(&text, angle));
            let Ok(id) = u32::try_from(record.id) else { continue };
            // The library's panics cost their own solid alone.
            let built = catch_unwind(AssertUnwindSafe(|| shapes.build(id, kind))).unwrap_or_else(|_| Built::default());
            match built.skins {
                Some(skins) if !skins.is_empty() => {
                    let Some(list) = free.next() else { break };
                    edits.replace(record.span.clone(), Skin::text(&skins, record.id, list));
                }
                _ => notes.extend(built.doubt.map(|doubt| (record.id, doubt))),
            }
        }
    }
    drop(shapes);
    if edits.is_empty() { text } else { Cow::Owned(edits.apply(&text)) }
}

/// A solid's surfaces, or what is doubtful if the library has to build it.
#[derive(Default)]
pub struct Built {
    skins: Option<Vec<Skin>>,
    doubt: Option<String>,
}

#[cfg(test)]
mod tests;
