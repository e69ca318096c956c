//! Planted truth on a real scan: `truth --planted`. The scan of ../shared/data/real-room stays as it is; surfaces of its
//! *model* are moved by known amounts along their normal, or new ones are added where the room is empty. The model is a
//! plan, right to some centimetres, so that what counts is the difference to the unmoved model.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use asbuilt_core::NEVER;
use asbuilt_core::evidence::Loa;
use asbuilt_core::geometry::{Solid, Vec3};
use asbuilt_core::verify::{Evidence, EvidenceModel, Question, Summary, SurveyObjects, Threads, Verdict, VerdictRule};
use asbuilt_read::ifc::read_within;
use asbuilt_read::packing::pack;
use asbuilt_read::{ReadOptions, read_scans};
use indicatif::ProgressBar;

use crate::tally::Share;

/// The surfaces that exist, by name in the model.
const SURFACES: [&str; 5] = ["floor", "ceiling", "wall-west", "wall-south", "wall-north"];
/// Shifts along the normal that looks into the room, metres, each to both sides.
const SHIFTS_M: [f64; 8] = [0.01, 0.02, 0.03, 0.04, 0.06, 0.08, 0.12, 0.2];
/// How far before a surface a copy of it is put where nothing stands, metres.
const ADDED_M: [f64; 2] = [0.6, 1.0];
/// The scanner's own platform ends here, metres.
const PLATFORM_M: f64 = 0.45;
/// As far as the verifier looks for a displaced surface, metres.
const REACH_M: f64 = 0.3;
/// Tolerance asked for, and the share of it within which a shift is at the border.
const CLASS: Loa = Loa::Loa20;
const BORDER: f64 = 0.25;
/// What a surveyor knows of this survey: ranges, and a registration by closest points (rms 2 cm of single points).
const SIGMA_RANGE_M: f64 = 0.005;
/// What lies farther off the surface stands before it, metres.
const CLUTTER_M: f64 = 0.06;
const SIGMA_STATION_M: f64 = 0.005;

/// One shift of one surface under some stations.
struct Shift {
    surface: &'static str,
    stations: &'static str,
    shift_m: f64,
    /// Of the unmoved model: verdict, and deviation along the normal into the room.
    before: Option<(f64, f64)>,
    /// What 95 % of its places keep once it is moved, metres, as they were measured one by one.
    kept_m: Option<f64>,
    after: Option<(f64, f64)>,
    said: Verdict,
    coverage: f64,
}

impl Shift {
    /// What the deviation should be now, metres along the normal into the room.
    fn expected(&self) -> Option<f64> {
        self.before.map(|b| b.0 - self.shift_m)
    }

    /// Right verdicts, by USIBD's rule for what was scanned; several at the border. `None` where the unmoved surface has
    /// no number.
    fn right(&self) -> Option<Vec<Verdict>> {
        let (off, kept) = (self.expected()?.abs(), self.kept_m?);
        let (sure, never) = (CLASS.upper() * (1.0 - BORDER), CLASS.upper() * (1.0 + BORDER));
        let mut right = Vec::new();
        if off <= never && kept <= never {
            right.push(Verdict::Confirmed);
        }
        if off > sure || kept > sure {
            right.push(Verdict::Deviating);
        }
        Some(right)
    }

    fn is_right(&self) -> Option<bool> {
        self.right().map(|r| r.contains(&self.said))
    }

    /// Whether the number is right within 3 σ of the difference, or 2 mm.
    fn number_is_right(&self) -> Option<bool> {
        let (expected, (after, sd)) = (self.expected()?, self.after?);
        Some((after - expected).abs() <= (3.0 * sd * 2f64.sqrt()).max(0.002))
    }

    fn line(&self) -> String {
        let number = |d: Option<(f64, f64)>| d.map_or("-".into(), |(v, s)| format!("{:.1} ± {:.1}", v * 1e3, s * 1e3));
        let mark = if self.is_right() == Some(false) || self.number_is_right() == Some(false) { " **" } else { "" };
        format!(
            "| {} | {} | {:+.0} | {} | {} | {} | {:.3} |{mark}",
            self.surface,
            self.stations,
            self.shift_m * 1e3,
            number(self.expected().zip(self.before).map(|(e, b)| (e, b.1))),
            number(self.after),
            self.said.name(),
            self.coverage,
        )
    }
}

/// The model's bodies by name, and the packed patches of each station.
struct Room {
    names: Vec<String>,
    solids: Vec<Solid>,
    stations: Vec<(Vec3, Vec<Vec<u8>>)>,
}

impl Room {
    fn read(folder: &Path) -> Result<Self> {
        let model = read_within(&folder.join("model.ifc"))?;
        let (mut names, mut solids) = (Vec::new(), Vec::new());
        for product in &model.products {
            if let Some(solid) = product.solid()? {
                names.push(product.name.clone());
                solids.push(solid);
            }
        }
        let mut stations = Vec::new();
        let options = ReadOptions::default();
        read_scans(&folder.join("scans.e57"), &options, &ProgressBar::hidden(), &mut |mut scan| {
            let (mut patches, place) = (Vec::new(), scan.anchor);
            pack(&mut scan, stations.len() as i64 + 1, PLATFORM_M, |patch| {
                patches.push(patch.to_vec());
                Ok(())
            })?;
            stations.push((place, patches));
            Ok(())
        })?;
        Ok(Self { names, solids, stations })
    }

    fn number(&self, name: &str) -> Result<usize> {
        self.names.iter().position(|n| n == name).with_context(|| format!("the room has no {name}"))
    }

    /// The normal of an object's largest face that looks to a station.
    fn normal(&self, number: usize) -> Result<Vec3> {
        let (solid, eye) = (&self.solids[number], self.stations[0].0);
        let facing = (0..solid.triangles().len()).filter_map(|t| {
            let [a, b, c] = solid.corners(t);
            let twice = (b - a).cross(&(c - a));
            (twice.dot(&(eye - a)) > 0.0).then_some(twice)
        });
        let largest = facing.max_by(|a, b| a.norm().total_cmp(&b.norm()));
        largest.and_then(|n| n.try_normalize(0.0)).context("no face looks to the station")
    }

    /// Verdicts on all objects, one of them replaced, by some stations.
    fn judged(&self, solids: &[Solid], stations: &[usize]) -> Result<Vec<Judged>> {
        let model = EvidenceModel {
            question: Question { loa: CLASS, ..Question::default() },
            sigma_range: SIGMA_RANGE_M,
            sigma_station: SIGMA_STATION_M,
            ..EvidenceModel::default()
        };
        let objects: Vec<(Solid, EvidenceModel)> = solids.iter().map(|s| (s.clone(), model)).collect();
        let objects = SurveyObjects::new(objects, Threads::Pool, NEVER)?;
        let patches: Vec<&Vec<u8>> = stations.iter().flat_map(|s| &self.stations[*s].1).collect();
        let judge = |(evidence, said): (Evidence, asbuilt_core::verify::Judged)| {
            let summary = said.summary;
            let normal = summary.deviation_face.map(|(_, normal)| normal);
            let mut deviations = Vec::new();
            evidence.for_each_sample(&model.question, NEVER, |_, sample_normal, belief| {
                let is_of_face = normal.is_some_and(|n| n.dot(sample_normal) > 0.99) && belief.seen;
                deviations.extend(belief.deviation.filter(|_| is_of_face).map(|d| d.0));
            })?;
            Ok(Judged { summary, normal, deviations })
        };
        let rule = VerdictRule::default();
        objects.verified(&patches, 32, &rule, Threads::Pool, NEVER)?.into_iter().map(judge).collect()
    }
}

/// What was said of one object.
struct Judged {
    summary: Summary,
    /// Of the face that the deviation is of.
    normal: Option<Vec3>,
    /// Of the samples of that face, metres.
    deviations: Vec<f64>,
}

impl Judged {
    /// The deviation along the normal into the room, if the face that it is of looks along it.
    fn along_room(&self, normal: &Vec3) -> Option<(f64, f64)> {
        let (value, sd) = self.summary.deviation?;
        let along = self.normal?.dot(normal);
        (along.abs() > 0.9).then(|| (value * along.signum(), sd))
    }

    /// What 95 % of the samples around the median keep once the face is moved by `shift_m` along the normal; what lies
    /// farther off than [`CLUTTER_M`] stands before it.
    fn kept(&self, normal: &Vec3, shift_m: f64) -> Option<f64> {
        let along = self.normal?.dot(normal).signum();
        let (median, _) = self.along_room(normal)?;
        let near = self.deviations.iter().map(|d| d * along).filter(|d| (d - median).abs() <= CLUTTER_M);
        let mut off: Vec<f64> = near.map(|d| (d - shift_m).abs()).collect();
        off.sort_by(f64::total_cmp);
        off.get(off.len() * 95 / 100).copied()
    }
}

/// Moves the surfaces, judges, and writes a table; skipped loudly where the data is not there.
pub fn run(report: Option<&Path>) -> Result<()> {
    let folder: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/real-room");
    if !folder.is_dir() {
        eprintln!("SKIPPED: {} is not there", folder.display());
        return Ok(());
    }
    let room = Room::read(&folder)?;
    let mut shifts = Vec::new();
    let mut added = Vec::new();
    for (name, stations) in [("1", &[0usize][..]), ("2", &[1][..]), ("both", &[0, 1][..])] {
        let before = room.judged(&room.solids, stations)?;
        for surface in SURFACES {
            let (number, normal) = (room.number(surface)?, room.normal(room.number(surface)?)?);
            for shift_m in SHIFTS_M.into_iter().flat_map(|s| [s, -s]) {
                let mut solids = room.solids.clone();
                solids[number] = moved(&room.solids[number], &(normal * shift_m))?;
                let after = room.judged(&solids, stations)?.swap_remove(number);
                let kept_m = before[number].kept(&normal, shift_m);
                let (before, number) = (before[number].along_room(&normal), after.along_room(&normal));
                let Summary { verdict: said, coverage, .. } = after.summary;
                shifts.push(Shift { surface, stations: name, shift_m, before, kept_m, after: number, said, coverage });
            }
            for off in ADDED_M {
                let mut solids = room.solids.clone();
                solids.push(moved(&room.solids[number], &(normal * off))?);
                let verdict = room.judged(&solids, stations)?.pop().map(|j| j.summary.verdict);
                added.push((surface, name, off, verdict.unwrap_or(Verdict::Unobserved)));
            }
        }
    }
    let text = told(&shifts, &added);
    print!("{text}");
    let page = format!("{}{text}", include_str!("planted.md"));
    report
        .map_or(Ok(()), |path| std::fs::write(path, &page).with_context(|| format!("{}: cannot write", path.display())))
}

fn moved(solid: &Solid, by: &Vec3) -> Result<Solid> {
    let vertices = solid.vertices().iter().map(|v| v + by).collect();
    Ok(Solid::new(vertices, solid.triangles().to_vec())?)
}

fn told(shifts: &[Shift], added: &[(&str, &str, f64, Verdict)]) -> String {
    let off = |s: &&Shift| s.expected().map_or(s.shift_m.abs(), f64::abs);
    let reachable = || shifts.iter().filter(|s| off(s) <= REACH_M);
    let known = shifts.iter().filter_map(Shift::is_right);
    let beyond = shifts.iter().filter(|s| off(s) > CLASS.upper() * (1.0 + BORDER));
    let rows = [
        ("verdict right at LOA20", Share::of(known, |r| *r)),
        ("a number is given, of the shifts within reach", Share::of(reachable(), |s| s.after.is_some())),
        ("the number is right", Share::of(shifts.iter().filter_map(Shift::number_is_right), |r| *r)),
        ("confirmed beyond 1.25 T", Share::of(beyond, |s| s.said == Verdict::Confirmed)),
        ("added where nothing stands, and absent", Share::of(added, |a| a.3 == Verdict::Absent)),
        ("added where nothing stands, and confirmed", Share::of(added, |a| a.3 == Verdict::Confirmed)),
    ];
    let mut out = String::from("| planted on real-room | |\n| --- | --- |\n");
    for (what, share) in rows {
        let _ = writeln!(out, "| {what} | {} |", share.text());
    }
    out += "\n| surface | stations | moved by, mm | deviation expected, mm | said, mm | verdict | coverage |\n";
    out += "| --- | --- | ---: | ---: | ---: | --- | ---: |\n";
    shifts.iter().for_each(|s| out += &(s.line() + "\n"));
    out
}
