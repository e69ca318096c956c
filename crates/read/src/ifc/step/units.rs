//! Units of a file, and the angles that its arcs are written in.

use std::f64::consts::{PI, TAU};

use super::document::Document;
use super::value::Value;

const DEGREE: f64 = PI / 180.0;

/// A unit of length in metres.
pub fn metres(document: &Document, unit: u64) -> Option<f64> {
    factor(document, unit, 0)
}

/// The project's unit of length, metres.
pub fn project_metres(document: &Document) -> Option<f64> {
    project_unit(document, "LENGTHUNIT")
}

/// Whether the project has a unit of length, whatever its factor; a context-dependent unit does not count.
pub fn names_length(document: &Document) -> bool {
    let record = unit_of(document, "LENGTHUNIT").and_then(|unit| document.find(unit));
    record.is_some_and(|r| !document.is(r, "IFCCONTEXTDEPENDENTUNIT"))
}

fn project_unit(document: &Document, kind: &str) -> Option<f64> {
    factor(document, unit_of(document, kind)?, 0)
}

fn unit_of(document: &Document, kind: &str) -> Option<u64> {
    let project = document.all("IFCPROJECT").next()?;
    let values = document.values(project);
    let assignment = document.values_of(values.get(8)?.reference()?, "IFCUNITASSIGNMENT")?;
    let units = assignment.first()?.list().iter().filter_map(Value::reference);
    let is_kind = |id: &u64| document.find(*id).is_some_and(|r| document.values(r).get(1).is_some_and(|v| v.is(kind)));
    units.into_iter().find(is_kind)
}

/// The value of a unit in SI.
fn factor(document: &Document, unit: u64, depth: usize) -> Option<f64> {
    const PREFIXES: [(&str, f64); 10] = [
        ("GIGA", 1e9),
        ("MEGA", 1e6),
        ("MILLI", 1e-3),
        ("CENTI", 1e-2),
        ("DECI", 1e-1),
        ("DECA", 1e1),
        ("HECTO", 1e2),
        ("KILO", 1e3),
        ("MICRO", 1e-6),
        ("NANO", 1e-9),
    ];
    let record = document.find(unit)?;
    let values = document.values(record);
    if document.is(record, "IFCSIUNIT") {
        let prefix = values.get(2)?;
        return match prefix {
            Value::Absent => Some(1.0),
            _ => PREFIXES.iter().find(|(name, _)| prefix.is(name)).map(|p| p.1),
        };
    }
    let is_based = document.is(record, "IFCCONVERSIONBASEDUNIT");
    if !(is_based || document.is(record, "IFCCONVERSIONBASEDUNITWITHOFFSET")) || depth > 8 {
        return None;
    }
    let measure = document.values_of(values.get(3)?.reference()?, "IFCMEASUREWITHUNIT")?;
    let inner = factor(document, measure.get(1)?.reference()?, depth + 1)?;
    Some(measure.first()?.number()? * inner).filter(|f| f.is_finite() && *f > 0.0)
}

/// What the trims of arcs and the angles of revolutions say about their unit.
#[derive(Debug, Default)]
struct Votes {
    radians: usize,
    degrees: usize,
    /// The largest of the angles that exceed a full turn in radians.
    beyond: Option<f64>,
}

impl Votes {
    /// Revolutions make at most a full turn; an arc that starts there may end a turn later.
    fn angle(&mut self, angle: f64) {
        if angle.abs() > TAU + 0.01 && self.beyond.is_none_or(|b| b < angle.abs()) {
            self.beyond = Some(angle.abs());
        }
    }

    /// An angle that is a simple fraction of a turn in radians, but no round number of degrees.
    fn part_of_turn(&mut self, angle: f64) {
        let parts = angle.abs() / (PI / 12.0);
        self.radians += usize::from((0.5..24.5).contains(&parts) && (parts - parts.round()).abs() < 1e-5);
    }

    /// An angle of more than two turns in radians, and no more than two in degrees.
    fn must_be_degrees(&self) -> bool {
        self.radians == 0 && self.beyond.is_some_and(|b| b > 2.0 * TAU + 0.01 && b <= 720.01)
    }
}

/// The unit in which angles are written, in radians, where it is not the one that the file declares, and why.
pub fn mended_angle(document: &Document) -> Option<(f64, String)> {
    let told = project_unit(document, "PLANEANGLEUNIT");
    let votes = votes(document);
    let is_degree = |unit: f64| (unit / DEGREE - 1.0).abs() < 1e-3;
    let proven = |mine: usize, other: usize| mine > 0 && other == 0;
    let largest = votes.beyond.map_or(String::new(), |x| format!(" up to {x:?}"));
    match told {
        None if proven(votes.degrees, votes.radians) || (votes.radians == 0 && votes.beyond.is_some()) => {
            Some((DEGREE, format!("the file names no unit of plane angles; its angles{largest} are read in degrees")))
        }
        Some(1.0) if proven(votes.degrees, votes.radians) => {
            Some((DEGREE, "the file names radians, but the ends of its arcs are in degrees: read so".into()))
        }
        Some(1.0) if votes.must_be_degrees() => Some((
            DEGREE,
            format!("the file names radians, but its angles{largest} are more than two turns: read in degrees"),
        )),
        None | Some(1.0) if votes.beyond.is_some_and(|b| b > 2.0 * TAU + 0.01) => Some((
            1.0,
            format!(
                "the file has angles{largest}: no radians, nor clearly degrees; read in radians, arcs may be wrong"
            ),
        )),
        Some(unit) if is_degree(unit) && votes.beyond.is_none() && proven(votes.radians, votes.degrees) => {
            Some((1.0, "the file names degrees, but its angles are in radians: read so".into()))
        }
        _ => None,
    }
}

fn votes(document: &Document) -> Votes {
    const ANGLE: usize = 3;
    let mut votes = Votes::default();
    for record in document.all("IFCTRIMMEDCURVE") {
        arc(document, &document.values(record), &mut votes);
    }
    for keyword in ["IFCREVOLVEDAREASOLID", "IFCREVOLVEDAREASOLIDTAPERED"] {
        for angle in document.all(keyword).filter_map(|r| document.values(r).get(ANGLE)?.number()) {
            votes.angle(angle);
            votes.part_of_turn(angle);
        }
    }
    votes
}

/// The ends of an arc, whose points reveal the unit of its angles.
fn arc(document: &Document, values: &[Value], votes: &mut Votes) {
    let Some(conic) = values.first().and_then(|v| Conic::read(document, v.reference()?)) else { return };
    for trim in values.iter().skip(1).take(2) {
        let Some(angle) = trim.list().iter().find_map(Value::number) else { continue };
        votes.angle(angle);
        let point = trim.list().iter().find_map(Value::reference).and_then(|id| document.coordinates(id));
        let Some(true_angle) = point.and_then(|p| conic.angle(&p)) else {
            votes.part_of_turn(angle);
            continue;
        };
        let off = |unit: f64| (angle * unit - true_angle + PI).rem_euclid(TAU) - PI;
        match (off(1.0).abs(), off(DEGREE).abs()) {
            (near, far) if near < 0.01 && far > 0.1 => votes.radians += 1,
            (far, near) if near < 0.01 && far > 0.1 => votes.degrees += 1,
            _ => {}
        }
    }
}

/// A circle or an ellipse in its plane; three-dimensional ones only where they are placed upright.
struct Conic {
    centre: [f64; 2],
    axis: [f64; 2],
    radii: [f64; 2],
}

impl Conic {
    fn read(document: &Document, id: u64) -> Option<Self> {
        let (values, second) = match document.values_of(id, "IFCCIRCLE") {
            Some(values) => (values, 1),
            None => (document.values_of(id, "IFCELLIPSE")?, 2),
        };
        let radii = [values.get(1)?.number()?, values.get(second)?.number()?];
        let placement = values.first()?.reference()?;
        let (placement, axis_at) = match document.values_of(placement, "IFCAXIS2PLACEMENT2D") {
            Some(placement) => (placement, 1),
            None => (document.values_of(placement, "IFCAXIS2PLACEMENT3D")?, 2),
        };
        let normal = placement.get(1).filter(|_| axis_at == 2).and_then(Value::reference);
        let is_upright =
            normal.is_none_or(|id| document.coordinates(id).is_some_and(|n| n.len() == 3 && n[2] > 0.9999));
        let centre = document.coordinates(placement.first()?.reference()?)?.first_chunk().copied()?;
        let axis = placement.get(axis_at).and_then(Value::reference).and_then(|id| document.coordinates(id));
        let axis = axis.and_then(|a| a.first_chunk().copied()).unwrap_or([1.0, 0.0]);
        is_upright.then_some(Self { centre, axis, radii })
    }

    fn angle(&self, point: &[f64]) -> Option<f64> {
        let ([x, y], [c, s]) = (*point.first_chunk()?, self.axis);
        let (x, y) = (x - self.centre[0], y - self.centre[1]);
        let angle = ((c * y - s * x) / self.radii[1]).atan2((c * x + s * y) / self.radii[0]);
        angle.is_finite().then_some(angle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(units: &str, trims: &str) -> String {
        format!(
            "#1=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);#2=IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.);\
             #3=IFCUNITASSIGNMENT(({units}));#4=IFCPROJECT('x',$,$,$,$,$,$,$,#3);\
             #5=IFCCARTESIANPOINT((1.,0.));#6=IFCAXIS2PLACEMENT2D(#5,$);#7=IFCCIRCLE(#6,2.);\
             #8=IFCCARTESIANPOINT((3.,0.));#9=IFCCARTESIANPOINT((1.,2.));#10=IFCTRIMMEDCURVE(#7,{trims},.T.,.PARAMETER.);\
             #11=IFCMEASUREWITHUNIT(IFCPLANEANGLEMEASURE(0.0174532925),#2);\
             #12=IFCCONVERSIONBASEDUNIT($,.PLANEANGLEUNIT.,'DEGREE',#11);"
        )
    }

    fn mended(units: &str, trims: &str) -> Option<f64> {
        mended_angle(&Document::new(file(units, trims).as_bytes())).map(|m| m.0)
    }

    #[test]
    fn the_ends_of_arcs_tell_their_unit() {
        let (none, radians, degrees) = ("#1", "#1,#2", "#1,#12");
        let p = |a: &str, b: &str| format!("(IFCPARAMETERVALUE({a})),(IFCPARAMETERVALUE({b}))");
        assert_eq!(mended(none, &p("0.", "180.")), Some(DEGREE));
        assert_eq!(mended(none, &p("0.", "3.14159")), None);
        let both = |b: &str| format!("(IFCPARAMETERVALUE(0.),#8),(IFCPARAMETERVALUE({b}),#9)");
        assert_eq!(mended(none, &both("90.")), Some(DEGREE));
        assert_eq!(mended(radians, &both("90.")), Some(DEGREE));
        assert_eq!(mended(radians, &both("1.5707963")), None);
        assert_eq!(mended(degrees, &both("1.5707963")), Some(1.0));
        assert_eq!(mended(degrees, &both("90.")), None);
        // Two turns or less may be radians, hundreds of turns are nothing: as told.
        assert_eq!(mended(radians, &p("0.", "12.")), None);
        assert_eq!(mended(radians, &p("0.", "180.")), Some(DEGREE));
        assert_eq!(mended(radians, &p("0.", "1.E6")), Some(1.0));
    }

    #[test]
    fn revolutions_tell_their_unit() {
        let trims = "(IFCPARAMETERVALUE(0.)),(IFCPARAMETERVALUE(1.))";
        let mended = |units: &str, angle: &str| {
            let text = format!("{}#20=IFCREVOLVEDAREASOLID($,$,$,{angle});", file(units, trims));
            mended_angle(&Document::new(text.as_bytes())).map(|m| m.0)
        };
        let (none, radians, degrees) = ("#1", "#1,#2", "#1,#12");
        assert_eq!(
            (mended(none, "90."), mended(radians, "90."), mended(radians, "360.")),
            (Some(DEGREE), Some(DEGREE), Some(DEGREE))
        );
        assert_eq!(
            (mended(none, "1.5707963"), mended(radians, "6.2831853"), mended(degrees, "90.")),
            (None, None, None)
        );
        assert_eq!(mended(degrees, "1.5707963"), Some(1.0));
    }

    #[test]
    fn lengths() {
        let text = file("#1", "(),()");
        let document = Document::new(text.as_bytes());
        assert_eq!(project_metres(&document), Some(1e-3));
        assert_eq!(metres(&document, 12), Some(0.0174532925));
        assert_eq!(metres(&document, 3), None);
    }
}
