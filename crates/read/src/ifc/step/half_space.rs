//! Half spaces bounded by a polygon (IfcPolygonalBoundedHalfSpace) whose plane is steep: the geometry library puts the
//! polygon on the plane and moves it by the size of what is cut. That falls short the steeper the plane is, and an
//! upright plane is left out. Such a half space is written as a long prism less the other half space.

use std::collections::{HashMap, HashSet};
use std::panic::{AssertUnwindSafe, catch_unwind};

use asbuilt_core::geometry::Vec3;

use super::dense::boundary;
use super::document::{Document, Edits};
use super::library::Library;
use super::record::Record;
use super::value::{Value, real};

/// Planes that lean by no more than about 65 degrees (cosine against the boundary's z) are left to the library: its
/// depth suffices for most of them, and mitred walls whose cuts meet, as in a model with 65 degrees, are too much for
/// its kernel when written out.
const STEEP_COS: f64 = 0.414;
/// A file whose half spaces need more records than this to be examined keeps the rest as they are.
const MAX_RECORDS: usize = 1 << 24;

pub fn write_out(
    document: &Document,
    angle: Option<f64>,
    free: &mut dyn Iterator<Item = u64>,
    edits: &mut Edits,
    notes: &mut Vec<(u64, String)>,
) {
    let mut all = document.all("IFCPOLYGONALBOUNDEDHALFSPACE").filter_map(|r| Some((r, HalfSpace::read(document, r)?)));
    let Some(first) = all.by_ref().find(|(_, h)| h.is_steep()) else { return };
    let mut library = Library::new(document.text(), angle);
    let mut reach = Reach::new(document);
    for (record, half) in std::iter::once(first).chain(all.filter(|(_, h)| h.is_steep())) {
        // The library's panics cost their own half space alone.
        let corners = || boundary(document, &mut library, half.boundary);
        let corners = catch_unwind(AssertUnwindSafe(corners)).ok().flatten();
        let written = corners.zip(reach.of(record.id)).and_then(|(c, reach)| half.text(record.id, &c, reach, free));
        match written {
            Some(text) => edits.replace(record.span.clone(), text),
            None => {
                notes.push((record.id, "a steep plane cuts it, perhaps too little: its boundary is not clear".into()))
            }
        }
    }
}

/// The records of a half space.
struct HalfSpace {
    plane: u64,
    /// The plane's normal points away from it.
    agrees: bool,
    boundary: u64,
    place: u64,
    /// Placements of the plane and of the boundary.
    frames: [AxisPlacement; 2],
    /// The boundary's axes as written.
    axes: [Option<u64>; 2],
}

impl HalfSpace {
    fn read(document: &Document, record: &Record) -> Option<Self> {
        let values = document.values(record);
        let [plane, place, boundary] = [values.first()?, values.get(2)?, values.get(3)?].map(Value::reference);
        let on = document.values_of(plane?, "IFCPLANE")?.first()?.reference()?;
        let axes = document.values_of(place?, "IFCAXIS2PLACEMENT3D")?;
        Some(Self {
            plane: plane?,
            agrees: values.get(1)?.is("T"),
            boundary: boundary?,
            place: place?,
            frames: [AxisPlacement::read(document, on)?, AxisPlacement::read(document, place?)?],
            axes: [1, 2].map(|i| axes.get(i).and_then(Value::reference)),
        })
    }

    fn is_steep(&self) -> bool {
        self.frames[0].z.dot(&self.frames[1].z).abs() < STEEP_COS
    }

    /// A prism that reaches beyond everything within `reach` of the zero, less what is on the plane's other side.
    fn text(&self, id: u64, corners: &[[f64; 2]], reach: f64, free: &mut dyn Iterator<Item = u64>) -> Option<String> {
        let frame = &self.frames[1];
        let middle = -frame.origin.dot(&frame.z);
        let (place, point) = (free.next()?, free.next()?);
        let at = |start: f64| {
            let axes = self.axes.map(|a| a.map_or("$".to_owned(), |id| format!("#{id}"))).join(",");
            let at = <[f64; 3]>::from(frame.origin + frame.z * start).map(real).join(",");
            format!("#{place}=IFCAXIS2PLACEMENT3D(#{point},{axes});\n#{point}=IFCCARTESIANPOINT(({at}));")
        };
        if !self.takes_any(corners, [middle - reach, middle + reach]) {
            // A level plane where nothing is: the library sees that it takes nothing away.
            let (level, rest) = (free.next()?, format!("#{},#{}", self.place, self.boundary));
            let out =
                format!("#{id}=IFCPOLYGONALBOUNDEDHALFSPACE(#{level},.F.,{rest});\n#{level}=IFCPLANE(#{place});\n");
            return Some(out + &at(middle + 4.0 * reach));
        }
        let [prism, other, profile, up] = [free.next()?, free.next()?, free.next()?, free.next()?];
        let (sense, depth) = (if self.agrees { "F" } else { "T" }, real(2.0 * reach));
        let (plane, boundary, at) = (self.plane, self.boundary, at(middle - reach));
        Some(format!(
            "#{id}=IFCBOOLEANRESULT(.DIFFERENCE.,#{prism},#{other});\n#{other}=IFCHALFSPACESOLID(#{plane},.{sense}.);\n\
             #{prism}=IFCEXTRUDEDAREASOLID(#{profile},#{place},#{up},{depth});\n\
             #{profile}=IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#{boundary});\n#{up}=IFCDIRECTION((0.,0.,1.));\n{at}"
        ))
    }

    /// Whether any corner of the prism lies on the half space's side.
    fn takes_any(&self, corners: &[[f64; 2]], ends: [f64; 2]) -> bool {
        let [plane, frame] = &self.frames;
        let sign = if self.agrees { -1.0 } else { 1.0 };
        let is_within = |&[u, v]: &[f64; 2], end: f64| {
            let p = frame.origin + frame.x * u + frame.y() * v + frame.z * end;
            sign * (p - plane.origin).dot(&plane.z) > 0.0
        };
        corners.iter().any(|c| ends.iter().any(|&end| is_within(c, end)))
    }
}

/// An IfcAxis2Placement3D, its axes orthonormal.
struct AxisPlacement {
    origin: Vec3,
    z: Vec3,
    x: Vec3,
}

impl AxisPlacement {
    fn read(document: &Document, id: u64) -> Option<Self> {
        let values = document.values_of(id, "IFCAXIS2PLACEMENT3D")?;
        let vector =
            |i: usize| Some(Vec3::from(*document.coordinates(values.get(i)?.reference()?)?.first_chunk::<3>()?));
        let origin = vector(0)?;
        let z = unit(vector(1).unwrap_or_else(Vec3::z))?;
        let across = |v: Vec3| unit(v + z * -v.dot(&z));
        let x = across(vector(2).unwrap_or_else(Vec3::x)).or_else(|| across(Vec3::y()))?;
        Some(Self { origin, z, x })
    }

    fn y(&self) -> Vec3 {
        self.z.cross(&self.x)
    }
}

fn unit(v: Vec3) -> Option<Vec3> {
    let length = v.norm();
    (length > 1e-12 && length.is_finite()).then(|| v / length)
}

/// How far from the zero anything may lie that a half space cuts.
struct Reach<'a> {
    document: &'a Document<'a>,
    /// What each half space is taken from.
    hosts: HashMap<u64, Vec<u64>>,
    left: usize,
}

impl<'a> Reach<'a> {
    fn new(document: &'a Document<'a>) -> Self {
        let mut hosts: HashMap<u64, Vec<u64>> = HashMap::new();
        for record in ["IFCBOOLEANCLIPPINGRESULT", "IFCBOOLEANRESULT"].into_iter().flat_map(|k| document.all(k)) {
            let values = document.values(record);
            if let [_, Value::Reference(host), Value::Reference(cutter)] = values[..] {
                hosts.entry(cutter).or_default().push(host);
            }
        }
        Self { document, hosts, left: MAX_RECORDS }
    }

    /// The sum of the largest coordinates in each kind of record that they are made of: points, and what moves them.
    fn of(&mut self, cutter: u64) -> Option<f64> {
        let mut open = self.hosts.get(&cutter)?.clone();
        let (mut seen, mut largest) = (HashSet::new(), HashMap::new());
        while let Some(id) = open.pop() {
            let Some(record) = self.document.find(id).filter(|_| seen.insert(id)) else { continue };
            self.left = self.left.checked_sub(1)?;
            open.extend(self.document.references_of(record));
            if self.document.is(record, "IFCREVOLVEDAREASOLID") {
                // Its number is an angle.
                continue;
            }
            let here = self.document.values(record).iter().map(size).fold(0.0, f64::max);
            let kind = largest.entry(&self.document.text()[record.keyword.clone()]).or_insert(0.0f64);
            *kind = kind.max(here);
        }
        let sum: f64 = largest.iter().map(|(k, x)| if *k == b"IFCCARTESIANPOINT" { 3.0 * x } else { *x }).sum();
        // Along the diagonal of a cube.
        Some(2.0 * sum).filter(|r| r.is_finite() && *r > 0.0)
    }
}

fn size(value: &Value) -> f64 {
    let inner = value.list().iter().map(size).fold(0.0, f64::max);
    value.number().map_or(inner, f64::abs)
}
