//! Which representations of a product are its body: the geometry library considers only their types, and would add
//! clearances, references and fallbacks to the body.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use super::document::{Document, Edits};
use super::lost::listed;
use super::record::Record;
use super::value::Value;

/// A representation that the library would mesh.
struct Body {
    id: u64,
    /// 0 for the body itself; `None` for what is not a body.
    rank: Option<u8>,
    /// Whether it is drawn for plans, sketches and the like.
    is_drawing: bool,
}

/// Removes from every product's representations what is not a body, or is a second body of the same shape.
pub fn choose(document: &Document, edits: &mut Edits, notes: &mut Vec<(u64, String)>, words: &mut Vec<String>) {
    let mut bodiless = Vec::new();
    for shape in document.all("IFCPRODUCTDEFINITIONSHAPE").chain(document.all("IFCPRODUCTREPRESENTATION")) {
        let values = document.values(shape);
        let ids: Vec<u64> = values.get(2).map_or(&[][..], Value::list).iter().filter_map(Value::reference).collect();
        for id in ids.iter().filter(|id| document.find(**id).is_none()) {
            notes.push((shape.id, format!("its representation #{id} is not in the file")));
        }
        let bodies: Vec<Body> = ids.iter().filter_map(|&id| Body::read(document, id)).collect();
        let kept = kept(document, &bodies);
        if kept.len() == bodies.len() {
            continue;
        }
        if kept.is_empty() {
            bodiless.push(shape.id);
        }
        let gone: HashSet<u64> = bodies.iter().map(|b| b.id).filter(|id| !kept.contains(id)).collect();
        let left: Vec<String> = ids.iter().filter(|id| !gone.contains(id)).map(|id| format!("#{id}")).collect();
        if let Some(piece) = document.argument_pieces(shape).get(2) {
            edits.replace(piece.clone(), format!("({})", left.join(",")));
        }
    }
    if !bodiless.is_empty() {
        let all = listed(&bodiless);
        words.push(format!("shapes of clearances or references only, no bodies, are left out: {all}"));
    }
}

/// The best representation; among equally good ones that draw the same, the first.
fn kept(document: &Document, bodies: &[Body]) -> HashSet<u64> {
    let Some(best) = bodies.iter().filter_map(|b| b.rank).min() else { return HashSet::new() };
    let mut of_rank: Vec<&Body> = bodies.iter().filter(|b| b.rank == Some(best)).collect();
    if best == 0 && of_rank.iter().any(|b| !b.is_drawing) {
        of_rank.retain(|b| !b.is_drawing);
    }
    if of_rank.len() > 1 {
        let mut drawn = HashSet::new();
        of_rank.retain(|b| signature(document, b.id).is_none_or(|s| drawn.insert(s)));
    }
    of_rank.iter().map(|b| b.id).collect()
}

impl Body {
    fn read(document: &Document, id: u64) -> Option<Self> {
        let record = document.find(id).filter(|r| document.is(r, "IFCSHAPEREPRESENTATION"))?;
        let values = document.values(record);
        let text = |k: usize| values.get(k).and_then(Value::text).map(<[u8]>::trim_ascii).filter(|t| !t.is_empty());
        is_meshed(text(2).or(text(1))).then(|| Self {
            id,
            rank: rank(text(1)),
            is_drawing: values.first().and_then(Value::reference).is_some_and(|c| is_drawing(document, c)),
        })
    }
}

/// As the library decides; where nothing is specified, it meshes.
fn is_meshed(kind: Option<&[u8]>) -> bool {
    const KINDS: [&[u8]; 12] = [
        b"Body",
        b"SweptSolid",
        b"Brep",
        b"CSG",
        b"Clipping",
        b"Tessellation",
        b"MappedRepresentation",
        b"SolidModel",
        b"SurfaceModel",
        b"Surface3D",
        b"AdvancedSweptSolid",
        b"AdvancedBrep",
    ];
    kind.is_none_or(|k| KINDS.contains(&k))
}

fn rank(identifier: Option<&[u8]>) -> Option<u8> {
    let Some(name) = identifier.map(<[u8]>::to_ascii_lowercase) else { return Some(1) };
    match &name[..] {
        b"body" => Some(0),
        b"facetation" => Some(2),
        b"body-fallback" => Some(3),
        b"surface" | b"box" | b"axis" | b"footprint" => Some(4),
        b"clearance" | b"reference" | b"lighting" | b"cog" | b"profile" => None,
        _ => Some(1),
    }
}

/// Whether a context belongs to a view other than the model's.
fn is_drawing(document: &Document, context: u64) -> bool {
    let Some(record) = document.find(context) else { return false };
    let values = document.values(record);
    if document.is(record, "IFCGEOMETRICREPRESENTATIONSUBCONTEXT") {
        return values.get(8).is_some_and(|v| matches!(v, Value::Enumerated(_)) && !v.is("MODEL_VIEW"));
    }
    values.get(1).and_then(Value::text).is_some_and(|t| t.eq_ignore_ascii_case(b"Plan"))
}

/// What a representation draws, independent of its records' numbers; `None` where it is too large to compare.
fn signature(document: &Document, representation: u64) -> Option<u64> {
    let items = document.values(document.find(representation)?).into_iter().nth(3)?;
    let (mut hasher, mut left) = (DefaultHasher::new(), 20_000);
    draw(document, &items, &mut hasher, &mut left, 0).then(|| hasher.finish())
}

fn draw(document: &Document, value: &Value, hasher: &mut DefaultHasher, left: &mut u32, depth: usize) -> bool {
    if *left == 0 || depth > 64 {
        return false;
    }
    *left -= 1;
    let inner = match value {
        Value::Absent => return true,
        Value::Number(x) => {
            (x + 0.0).to_bits().hash(hasher);
            return true;
        }
        Value::Text(t) | Value::Enumerated(t) => {
            t.hash(hasher);
            return true;
        }
        Value::Reference(id) => {
            let Some(record) = document.find(*id) else { return false };
            keyword(document, record).hash(hasher);
            document.values(record)
        }
        Value::List(all) | Value::Typed(_, all) => all.clone(),
    };
    inner.len().hash(hasher);
    inner.iter().all(|v| draw(document, v, hasher, left, depth + 1))
}

fn keyword(document: &Document, record: &Record) -> Vec<u8> {
    document.text()[record.keyword.clone()].to_ascii_uppercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    const ITEMS: &str = "#10=IFCX(#11,1.);#11=IFCP((0.,1.));#12=IFCX(#13,1.);#13=ifcp((0.,1.0));#14=IFCX(#13,2.);\
        #6=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#5,$);\
        #7=IFCGEOMETRICREPRESENTATIONSUBCONTEXT('Body','Model',*,*,*,*,#6,$,.PLAN_VIEW.,$);";

    /// What remains of a product's representations: identifier, context and item of each.
    fn left(representations: &[(&str, u64, u64)]) -> String {
        let mut text = ITEMS.to_owned();
        for (k, (name, context, item)) in representations.iter().enumerate() {
            text += &format!("#{}=IFCSHAPEREPRESENTATION(#{context},'{name}','Brep',(#{item}));", 20 + k);
        }
        let all: Vec<String> = (0..representations.len()).map(|k| format!("#{}", 20 + k)).collect();
        text += &format!("#30=IFCPRODUCTDEFINITIONSHAPE($,$,({}));", all.join(","));
        let (mut edits, mut words) = (Edits::default(), Vec::new());
        choose(&Document::new(text.as_bytes()), &mut edits, &mut Vec::new(), &mut words);
        let text = String::from_utf8(edits.apply(text.as_bytes())).unwrap();
        text[text.rfind("$,(").unwrap() + 3..text.len() - 3].to_owned() + words.first().map_or("", |_| "!")
    }

    #[test]
    fn the_body_alone() {
        for other in ["Clearance", "Reference", "Body-FallBack", "Facetation", "CoG"] {
            assert_eq!(left(&[(other, 6, 14), ("Body", 6, 10)]), "#21", "{other}");
        }
        assert_eq!(left(&[("Body-FallBack", 6, 10)]), "#20");
        assert_eq!(left(&[("Clearance", 6, 10)]), "!");
        // The same twice, others, and one that is drawn for plans.
        assert_eq!(left(&[("Body", 6, 10), ("Body", 6, 12)]), "#20");
        assert_eq!(left(&[("Body", 6, 10), ("Body", 6, 14)]), "#20,#21");
        assert_eq!(left(&[("Body", 7, 10), ("Body", 6, 14)]), "#21");
    }
}
