//! The text of a STEP file from the field, rewritten so that the geometry library can read it:
//!
//! * [`envelope`]: what surrounds it; UTF-16;
//! * [`encoding`]: names that are no UTF-8;
//! * [`numbers`]: record numbers beyond 32 bits;
//! * [`lost`]: records that would be lost silently; [`bodies`]: which representations are a body;
//! * [`profiles`], [`steel`], [`centre_line`], [`curves`], [`line`], [`parameters`]: shapes that the library lacks or
//!   misreads;
//! * [`dense`]: profiles that it would thin out; [`library`]: what is asked of it;
//! * [`half_space`], [`voids`]: cuts that it makes too small, or not at all;
//! * [`sweep`]: solids that it narrows at corners, or lacks;
//! * [`turn`]: a model turned as a whole;
//! * [`units`], [`map_conversion`]: what is read besides the geometry;
//! * [`record`], [`value`], [`document`]: the text, record by record.

mod bodies;
mod centre_line;
mod curves;
mod dense;
mod document;
mod encoding;
mod envelope;
mod half_space;
mod library;
mod line;
mod lost;
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

pub use document::Document;
use document::Edits;
pub use map_conversion::MapConversion;
pub use turn::turned_text;
pub use value::{Value, references};

/// A file as the geometry library reads it.
pub struct Step<'a> {
    pub text: Cow<'a, [u8]>,
    /// What the user should know.
    pub words: Vec<String>,
    /// The same for single records, by their numbers.
    pub notes: Vec<(u64, String)>,
    /// The original numbers of records that were renumbered.
    pub original: HashMap<u64, u64>,
    /// The unit of angles in radians, where it is not the one that the file declares.
    pub angle: Option<f64>,
    pub map_conversion: Option<MapConversion>,
    /// The project's unit of length in metres.
    pub length_unit: Option<f64>,
    /// Whether the project has a unit of length, whatever its value.
    pub names_length: bool,
}

impl<'a> Step<'a> {
    pub fn read(bytes: &'a [u8]) -> Result<Self, String> {
        let (mut words, mut notes, mut original) = (Vec::new(), Vec::new(), HashMap::new());
        let text = encoding::readable(envelope::open(bytes, &mut words)?, &mut words);
        let text = lost::separated(text, &mut words);
        let text = numbers::within_reach(text, &mut original)?;
        let document = Document::new(&text);
        lost::doubled(&document, &mut words);
        let mended = units::mended_angle(&document);
        let angle = mended.as_ref().map(|m| m.0);
        words.extend(mended.map(|m| m.1));
        let map_conversion = MapConversion::read(&document);
        let (length_unit, names_length) = (units::project_metres(&document), units::names_length(&document));
        let edits = edits(&document, angle, &mut Said { notes: &mut notes, words: &mut words });
        // What was written out may be dense.
        let (may_be_dense, has_sweeps) =
            (!edits.is_empty() || dense::is_needed(&document), sweep::is_needed(&document));
        let text = if edits.is_empty() { text } else { Cow::Owned(edits.apply(&text)) };
        let text = if may_be_dense { dense::keep(text, angle) } else { text };
        let text = if has_sweeps { sweep::write_out(text, angle, &mut notes) } else { text };
        Ok(Self { text, words, notes, original, angle, map_conversion, length_unit, names_length })
    }

    /// The unit of length that counts, the one used for meshing, and what to tell the user where the file declares
    /// another.
    pub fn settled_unit(&self, meshed: f64) -> (Option<f64>, Option<String>) {
        if !self.names_length {
            return (None, None);
        }
        let word = match self.length_unit {
            Some(told) if (told / meshed - 1.0).abs() < 1e-6 => None,
            Some(told) => Some(format!(
                "its unit of length is {meshed} m by its name and {told} m by its factor: {meshed} m taken; repair the \
                 unit if its sizes are wrong"
            )),
            None => Some(format!("its unit of length has no factor that can be: {meshed} m taken by its name")),
        };
        (Some(meshed), word)
    }

    /// A record's number in the file.
    pub fn shown(&self, id: u32) -> u64 {
        self.original.get(&u64::from(id)).copied().unwrap_or(u64::from(id))
    }
}

/// A single record.
pub struct Described {
    /// The keyword, in capitals.
    pub keyword: String,
    pub references: Vec<u64>,
    /// Its arguments, as far as they are numbers; `None` where they are not a list of values.
    pub numbers: Option<Vec<Option<f64>>>,
}

/// The record that a text begins with.
pub fn described(text: &[u8]) -> Option<Described> {
    let record = record::Records::new(text).next()?;
    let mut all = Vec::new();
    references(&text[record.arguments.clone()], 0, |_, id| all.push(id));
    let numbers = value::values(&text[record.arguments.clone()]);
    Some(Described {
        keyword: String::from_utf8_lossy(&text[record.keyword.clone()]).to_ascii_uppercase(),
        references: all,
        numbers: numbers.map(|all| all.iter().map(value::Value::number).collect()),
    })
}

/// What is said about records, by their numbers, and about the file.
struct Said<'a> {
    notes: &'a mut Vec<(u64, String)>,
    words: &'a mut Vec<String>,
}

fn edits(document: &Document, angle: Option<f64>, said: &mut Said) -> Edits {
    let (mut edits, mut free) = (Edits::default(), document.free_numbers());
    let Said { notes, words } = said;
    profiles::write_out(document, &mut free, &mut edits);
    centre_line::write_out(document, &mut free, &mut edits);
    steel::write_out(document, &mut free, &mut edits, notes);
    curves::write_out_trimmed(document, &mut free, &mut edits, notes);
    parameters::take(document, &mut free, &mut edits, notes);
    half_space::write_out(document, angle, &mut free, &mut edits, notes);
    voids::write_out(document, &mut free, &mut edits);
    bodies::choose(document, &mut edits, notes, words);
    // Legal in IFC2x3, where it is no abstract type yet; of the same three attributes.
    for record in document.all("IFCPRODUCTREPRESENTATION") {
        edits.replace(record.keyword.clone(), "IFCPRODUCTDEFINITIONSHAPE");
    }
    edits
}
