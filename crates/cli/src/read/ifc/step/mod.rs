//! The text of a STEP file, as the field writes it, made what the geometry library can read:
//!
//! * [`envelope`]: what stands around it; UTF-16;
//! * [`encoding`]: names that are no UTF-8;
//! * [`numbers`]: numbers of records beyond 32 bits;
//! * [`profiles`], [`steel`], [`centre_line`], [`curves`], [`line`], [`parameters`]: shapes that the library lacks or reads otherwise than meant;
//! * [`dense`]: profiles that it would thin out; [`library`]: what is asked of it;
//! * [`half_space`], [`voids`]: cuts that it makes too small, or not;
//! * [`sweep`]: solids that it narrows at corners, or lacks;
//! * [`turn`]: a model turned as a whole;
//! * [`units`], [`map_conversion`]: what is read of it beside the geometry;
//! * [`record`], [`value`], [`document`]: the text, record by record.

mod centre_line;
mod curves;
mod dense;
mod document;
mod encoding;
mod envelope;
mod half_space;
mod library;
mod line;
mod map_conversion;
mod numbers;
mod parameters;
mod profiles;
mod record;
mod steel;
mod sweep;
mod turn;
mod units;
mod value;
mod voids;

use std::borrow::Cow;
use std::collections::HashMap;

use document::{Document, Edits};
pub use map_conversion::MapConversion;
pub use turn::turned_text;
pub use value::references;

/// A file as the geometry library reads it.
pub struct Step<'a> {
    pub text: Cow<'a, [u8]>,
    /// What the user should know.
    pub words: Vec<String>,
    /// The same about single records, by their numbers.
    pub notes: Vec<(u64, String)>,
    /// Numbers in the file of records that have others here.
    pub original: HashMap<u64, u64>,
    /// Radians of the unit of angles, where it is not the one that the file tells.
    pub angle: Option<f64>,
    pub map_conversion: Option<MapConversion>,
    /// Metres of the project's unit of length.
    pub length_unit: Option<f64>,
}

impl<'a> Step<'a> {
    pub fn read(bytes: &'a [u8]) -> Result<Self, String> {
        let (mut words, mut notes, mut original) = (Vec::new(), Vec::new(), HashMap::new());
        let text = encoding::readable(envelope::open(bytes, &mut words)?, &mut words);
        let text = numbers::within_reach(text, &mut original)?;
        let document = Document::new(&text);
        let mended = units::mended_angle(&document);
        let angle = mended.as_ref().map(|m| m.0);
        words.extend(mended.map(|m| m.1));
        let map_conversion = MapConversion::read(&document);
        let length_unit = units::project_metres(&document);
        let edits = edits(&document, &text, angle, &mut notes);
        // What was written out may be dense.
        let (may_be_dense, has_sweeps) =
            (!edits.is_empty() || dense::is_needed(&document), sweep::is_needed(&document));
        let text = if edits.is_empty() { text } else { Cow::Owned(edits.apply(&text)) };
        let text = if may_be_dense { dense::keep(text, angle) } else { text };
        let text = if has_sweeps { sweep::write_out(text, angle, &mut notes) } else { text };
        Ok(Self { text, words, notes, original, angle, map_conversion, length_unit })
    }

    /// A record's number in the file.
    pub fn shown(&self, id: u32) -> u64 {
        self.original.get(&u64::from(id)).copied().unwrap_or(u64::from(id))
    }
}

fn edits(document: &Document, text: &[u8], angle: Option<f64>, notes: &mut Vec<(u64, String)>) -> Edits {
    let mut edits = Edits::default();
    let mut free = document.free_numbers();
    profiles::write_out(document, &mut free, &mut edits);
    centre_line::write_out(document, &mut free, &mut edits);
    steel::write_out(document, &mut free, &mut edits, notes);
    curves::write_out_trimmed(document, &mut free, &mut edits, notes);
    parameters::take(document, &mut free, &mut edits, notes);
    half_space::write_out(document, (text, angle), &mut free, &mut edits, notes);
    voids::write_out(document, &mut free, &mut edits);
    // Legal in IFC2x3, where it is no abstract type yet; of the same three attributes.
    for record in document.all("IFCPRODUCTREPRESENTATION") {
        edits.replace(record.keyword.clone(), "IFCPRODUCTDEFINITIONSHAPE");
    }
    edits
}
