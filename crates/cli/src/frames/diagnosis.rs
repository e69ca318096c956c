//! What is said of model and scans that do not lie on each other.

use asbuilt_core::geometry::Aabb;

use super::fit::Boxes;
use super::hypothesis::{AS_READ, Hypothesis};

/// Scans of which this share lies near objects are where they belong.
const AT_HOME: f64 = 0.75;
/// Another reading must bring so much of them there …
const MUCH: f64 = 0.5;
/// … and so many times as much as there is now …
const TIMES: f64 = 2.0;
/// … or nearly all of them …
const NEARLY_ALL: f64 = 0.9;
/// … and this much more than there is; …
const MORE: f64 = 0.2;
/// … near so many times as many objects at the least: patches that are too large meet all.
const MANY: f64 = 0.5;
/// Scans and the model they are of differ in size by less than this.
const SIZE: f64 = 4.0;
/// Scans of which less than this lies near objects are somewhere else.
const ELSEWHERE: f64 = 0.02;
/// A station of which less than this lies near objects, where most of the others do, is not where it says.
const LOST: f64 = 0.05;

/// Scans so many times the model's size away are in another frame; a model is no smaller than this for it, metres.
const FAR: f64 = 10.0;
const SMALL_M: f64 = 10.0;

/// The scans of a station.
pub struct StationBoxes {
    pub name: String,
    pub patches: Vec<Aabb>,
}

/// Everything that is likely wrong, a sentence each with the way out.
pub fn diagnoses(objects: &[Aabb], stations: &[StationBoxes]) -> Vec<String> {
    let all: Vec<Aabb> = stations.iter().flat_map(|s| s.patches.iter().copied()).collect();
    let Some(boxes) = Boxes::new(objects, all) else { return Vec::new() };
    let fit = boxes.fit(&AS_READ);
    let is_plausible = boxes.are_patches_of_scanners(&AS_READ);
    if fit.patches >= AT_HOME && is_plausible {
        return lost_stations(objects, stations);
    }
    let fits = |h: &Hypothesis| {
        let other = boxes.fit(h);
        let is_all = other.patches >= NEARLY_ALL.max(fit.patches + MORE);
        let least = if is_plausible { TIMES * fit.patches } else { 0.0 };
        let is_better = is_all || other.patches >= least.max(MUCH);
        let has_size = (1.0 / SIZE..=SIZE).contains(&boxes.relative_size(h)) && boxes.are_patches_of_scanners(h);
        (is_better && other.objects >= MANY * fit.objects && has_size).then_some(other)
    };
    let best = Hypothesis::others().filter_map(|h| fits(&h).map(|fit| (h, fit)));
    let best = best.max_by(|a, b| (a.1.patches + a.1.objects).total_cmp(&(b.1.patches + b.1.objects)));
    if let Some((hypothesis, other)) = best {
        return vec![format!(
            "{} ({} of the patches would lie near an object, as they are {})",
            mended_by(&hypothesis),
            percent(other.patches),
            percent(fit.patches)
        )];
    }
    match fit.patches {
        few if few < ELSEWHERE => vec![apart(&boxes)],
        many if many >= MUCH => lost_stations(objects, stations),
        _ => Vec::new(),
    }
}

fn mended_by(h: &Hypothesis) -> String {
    match h.units() {
        [Some(unit), _] => format!(
            "the scans fit the model as if they counted in {}: load them with --file-unit {}, or where the file claims \
             metres, with --transform FILE that holds {}",
            unit.name(),
            unit.word(),
            h.rows()
        ),
        [_, Some(unit)] => format!(
            "the model fits the scans as if it counted in {} and was read as metres: load it with --file-unit {}",
            unit.name(),
            unit.word()
        ),
        _ => format!(
            "the scans fit the model with their axes exchanged: load them with --transform FILE that holds {}",
            h.rows()
        ),
    }
}

fn apart(boxes: &Boxes) -> String {
    let ([x, y, z], size) = boxes.apart();
    let far = x.hypot(y).hypot(z);
    if far > FAR * size.max(SMALL_M) {
        return format!(
            "the scans lie {far:.0} m from the model, as in a projected frame beside a local one: bring them into the model's with \
             --offset X,Y,Z or --transform FILE when loading them (their middles differ by {x:.1},{y:.1},{z:.1})"
        );
    }
    "no part of the scans comes near any object: are they registered, and in the model's coordinate system? --transform FILE brings \
     them there when they are loaded"
        .into()
}

/// Stations that lie nowhere near the model, where most do.
fn lost_stations(objects: &[Aabb], stations: &[StationBoxes]) -> Vec<String> {
    let share = |s: &StationBoxes| Boxes::new(objects, s.patches.clone()).map(|b| b.fit(&AS_READ).patches);
    let lost: Vec<&str> =
        stations.iter().filter(|s| share(s).is_some_and(|n| n < LOST)).map(|s| s.name.as_str()).collect();
    if lost.is_empty() || 2 * lost.len() > stations.len() {
        return Vec::new();
    }
    let (verb, it) = if lost.len() == 1 { ("lies", "it is") } else { ("lie", "they are") };
    vec![format!(
        "of the stations {} {verb} nowhere near an object, while most do: {it} likely not registered; register them, or load their \
         file with --transform FILE",
        lost.join(", ")
    )]
}

fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A house of two storeys and uneven rooms: floors, and walls along x and y.
    fn house() -> Vec<Aabb> {
        let mut out = Vec::new();
        for storey in 0..2 {
            let z = f64::from(storey) * 3.0;
            out.push(Aabb { min: [0.0, 0.0, z - 0.3], max: [12.0, 8.0, z] });
            for x in [0.0, 5.0, 8.5, 11.8] {
                out.push(Aabb { min: [x, 0.0, z], max: [x + 0.2, 8.0, z + 2.7] });
            }
            for y in [0.0, 3.5, 7.8] {
                out.push(Aabb { min: [0.0, y, z], max: [12.0, y + 0.2, z + 2.7] });
            }
        }
        out
    }

    /// Patches of half a metre on the surfaces of boxes, as some instrument counts them; a station a storey.
    fn scanned(to_scan: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<StationBoxes> {
        let mut stations = vec![Vec::new(), Vec::new()];
        for b in house() {
            let steps = |k: usize| ((b.max[k] - b.min[k]) / 0.5).ceil().max(1.0) as usize;
            for (i, j, k) in (0..steps(0))
                .flat_map(|i| (0..steps(1)).map(move |j| (i, j)))
                .flat_map(|(i, j)| (0..steps(2)).map(move |k| (i, j, k)))
            {
                let corner = |extra: usize| {
                    let at = [i + extra, j + extra, k + extra];
                    std::array::from_fn(|a| (b.min[a] + 0.5 * at[a] as f64).min(b.max[a]))
                };
                let [p, q] = [corner(0), corner(1)].map(&to_scan);
                let patch =
                    Aabb { min: std::array::from_fn(|a| p[a].min(q[a])), max: std::array::from_fn(|a| p[a].max(q[a])) };
                stations[usize::from(b.min[2] > 2.0)].push(patch);
            }
        }
        let named = |(i, patches): (usize, Vec<Aabb>)| StationBoxes { name: format!("S{i}"), patches };
        stations.into_iter().enumerate().map(named).collect()
    }

    #[test]
    fn each_trap_is_named_with_its_way_out() {
        let scaled = |s: f64| move |p: [f64; 3]| p.map(|v| v * s);
        let said = |stations: &[StationBoxes]| diagnoses(&house(), stations).join("; ");
        for (stations, expected) in [
            (scanned(scaled(1.0 / 0.3048)), "--file-unit ft"),
            (scanned(scaled(1000.0)), "--file-unit mm"),
            (scanned(scaled(100.0)), "--file-unit cm"),
            (scanned(scaled(0.001)), "load it with --file-unit mm"),
            (scanned(scaled(0.3048)), "load it with --file-unit ft"),
            (scanned(|[x, y, z]| [x, z, -y]), "1 0 0 0 / 0 0 -1 0 / 0 1 0 0 / 0 0 0 1"),
            (scanned(|[x, y, z]| [y, x, z]), "0 1 0 0 / 1 0 0 0 / 0 0 1 0"),
            (scanned(|[x, y, z]| [x + 512_345.0, y + 5.4e6, z + 101.0]), "--offset X,Y,Z"),
            (scanned(|[x, y, z]| [x + 40.0, y, z]), "are they registered"),
        ] {
            let said = said(&stations);
            assert!(said.contains(expected), "{expected}: {said:?}");
        }
        let mut one_lost = scanned(scaled(1.0));
        one_lost[1].patches.iter_mut().for_each(|p| *p = Hypothesis { scale: 3.0, ..AS_READ }.of_box(p));
        one_lost.push(StationBoxes { name: "S2".into(), patches: one_lost[0].patches.clone() });
        one_lost.push(StationBoxes { name: "S3".into(), patches: one_lost[0].patches.clone() });
        one_lost[1].patches.iter_mut().for_each(|p| (p.min[0], p.max[0]) = (p.min[0] + 50.0, p.max[0] + 50.0));
        assert!(said(&one_lost).contains("of the stations S1 lies nowhere"), "{}", said(&one_lost));
    }

    #[test]
    fn what_fits_is_left_alone() {
        assert_eq!(diagnoses(&house(), &scanned(|p| p)), Vec::<String>::new());
        // Registered to 5 cm; half of the patches of a garden around.
        assert_eq!(diagnoses(&house(), &scanned(|[x, y, z]| [x + 0.05, y - 0.05, z])), Vec::<String>::new());
        let mut garden = scanned(|p| p);
        let around = (0..garden[0].patches.len()).map(|i| {
            let (x, y) = (-20.0 + (i % 40) as f64, 15.0 + (i / 40) as f64);
            Aabb { min: [x, y, -0.5], max: [x + 1.0, y + 1.0, -0.4] }
        });
        let around: Vec<Aabb> = around.collect();
        garden[0].patches.extend(around);
        assert_eq!(diagnoses(&house(), &garden), Vec::<String>::new());
        assert_eq!(diagnoses(&[], &garden), Vec::<String>::new());
        assert_eq!(diagnoses(&house(), &[]), Vec::<String>::new());
    }
}
