//! Parts of an `ab_solid`: what of it is glass, what may move.

use asbuilt_core::geometry::{Part, Parts};
use asbuilt_core::{Error, Result};

use super::SolidArg;
use super::solid::from_arrays;
use crate::pg::{Backend, BoolArray, F64Array, I32Array, RowField, SqlValue, TextArray, sql_functions};

/// What a caller tells of parts, an element for each.
struct Told {
    transparent: Option<Vec<bool>>,
    movable: Option<Vec<bool>>,
    names: Option<Vec<Option<String>>>,
}

impl Told {
    /// How many parts the lists are of; `None` where there is no list.
    fn count(&self) -> Result<Option<usize>> {
        let transparent = self.transparent.as_ref().map(Vec::len);
        let lengths = [transparent, self.movable.as_ref().map(Vec::len), self.names.as_ref().map(Vec::len)];
        let mut lengths = lengths.into_iter().flatten();
        let first = lengths.next();
        match lengths.find(|&n| Some(n) != first) {
            Some(other) => Err(Error::argument(
                "the lists transparent, movable and name",
                "of one length, an element for each part",
                format!("of {} and {other} elements", first.unwrap_or_default()),
            )),
            None => Ok(first),
        }
    }

    fn part(&self, n: usize) -> Part {
        let flag = |of: &Option<Vec<bool>>| of.as_ref().is_some_and(|flags| flags[n]);
        Part {
            name: self.names.as_ref().and_then(|names| names[n].clone()),
            is_transparent: flag(&self.transparent),
            is_movable: flag(&self.movable),
        }
    }
}

/// Without lists there are as many parts as triangles name.
fn parts(numbers: Vec<i32>, told: &Told) -> Result<Parts> {
    let number = |n: i32| u16::try_from(n).map_err(|_| Error::argument("a part number", "between 0 and 65535", n));
    let numbers = numbers.into_iter().map(number).collect::<Result<Vec<u16>>>()?;
    let named = numbers.iter().max().map_or(0, |&n| usize::from(n) + 1);
    let count = told.count()?.unwrap_or(named);
    Parts::new(numbers, (0..count).map(|n| told.part(n)).collect())
}

sql_functions! {
    fn ab_solid_make_parts(
        vertices: F64Array,
        triangles: I32Array,
        part: I32Array,
        transparent: Option<BoolArray>,
        movable: Option<BoolArray>,
        names: Option<TextArray>,
    ) {
        let told = Told {
            transparent: transparent.map(|flags| flags.list("transparent")).transpose()?,
            movable: movable.map(|flags| flags.list("movable")).transpose()?,
            names: names.map(|names| names.texts("name")).transpose()?,
        };
        let solid = from_arrays(&vertices, &triangles)?.with_parts(parts(part.list("part")?, &told)?)?;
        Ok(SqlValue::Bytes(solid.to_bytes(&Backend)?))
    }

    /// A solid without parts is one.
    fn ab_solid_parts(rows: Rows; solid: SolidArg) {
        let solid = solid.read()?;
        let whole = [Part::default()];
        let parts = solid.parts().map_or(&whole[..], Parts::list);
        for (n, (part, (triangles, area))) in parts.iter().zip(solid.part_measures()).enumerate() {
            rows.push(&[
                RowField::I32(n as i32),
                RowField::or_null(part.name.clone(), RowField::Text),
                RowField::F64(area),
                RowField::Bool(part.is_transparent),
                RowField::Bool(part.is_movable),
                RowField::I32(triangles as i32),
            ]);
        }
        Ok(SqlValue::Null)
    }

    fn ab_solid_triangle_parts(solid: SolidArg) {
        let solid = solid.read()?;
        let numbers = (0..solid.triangles().len()).map(|t| solid.parts().map_or(0, |parts| parts.number_of(t) as i32));
        let numbers: Vec<i32> = numbers.collect();
        let count = numbers.len() as i32;
        Ok(SqlValue::I32Array(numbers, vec![count]))
    }
}
