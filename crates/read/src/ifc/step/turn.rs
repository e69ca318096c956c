//! A model turned as a whole.

use super::document::{Document, Edits};
use super::value::Value;

/// Puts every placement that is relative to the world into one turned by this many degrees about the vertical axis.
pub fn turned_text(text: &[u8], degrees: f64) -> Option<Vec<u8>> {
    let document = Document::new(text);
    let mut free = document.free_numbers();
    let [world, axes, zero, up, along] = [free.next()?, free.next()?, free.next()?, free.next()?, free.next()?];
    let mut edits = Edits::default();
    let mut first = None;
    for record in document.all("IFCLOCALPLACEMENT") {
        if document.values(record).first() == Some(&Value::Absent) {
            edits.replace(document.argument_pieces(record).first()?.clone(), format!("#{world}"));
            first.get_or_insert(record.span.start);
        }
    }
    let (sin, cos) = degrees.to_radians().sin_cos();
    let placement = format!(
        "#{world}=IFCLOCALPLACEMENT($,#{axes});#{axes}=IFCAXIS2PLACEMENT3D(#{zero},#{up},#{along});\
         #{zero}=IFCCARTESIANPOINT((0.,0.,0.));#{up}=IFCDIRECTION((0.,0.,1.));#{along}=IFCDIRECTION(({cos:?},{sin:?},0.));\n"
    );
    let first = first?;
    edits.replace(first..first, placement);
    Some(edits.apply(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_world_itself_turns() {
        let text = b"#1=IFCLOCALPLACEMENT($,#2);#3=IFCLOCALPLACEMENT(#1,#4);";
        let seen = String::from_utf8(turned_text(text, 90.0).unwrap()).unwrap();
        assert!(seen.starts_with("#4=IFCLOCALPLACEMENT($,#5);"), "{seen}");
        assert!(seen.ends_with("\n#1=IFCLOCALPLACEMENT(#4,#2);#3=IFCLOCALPLACEMENT(#1,#4);"));
        assert_eq!(turned_text(b"#3=IFCLOCALPLACEMENT(#1,#4);", 90.0), None);
    }
}
