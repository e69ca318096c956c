//! Findings in English.

use super::cause::{Cause, Shortfall, SurfaceMeant};
use super::finding::Finding;
use crate::geometry::Vec3;
use crate::verify::evidence::Why;
use crate::verify::verdict::rule::Verdict;

/// One finding as one sentence, or two.
pub fn sentence(finding: &Finding) -> String {
    match finding {
        Finding::Verdict { verdict, question } => format!(
            "{} at {} (±{}), asked with a confidence of {}.",
            title(*verdict),
            question.loa.name(),
            mm(question.tolerance()),
            percent(question.confidence)
        ),
        Finding::NoDeviations { kind } => {
            format!("The model {} does not measure how far off a surface is.", kind.name())
        }
        Finding::Seen { seen, samples, stations } => format!(
            "Seen were {seen} of {samples} places on its surface ({}), by {stations} {}.",
            percent(*seen as f64 / (*samples).max(1) as f64),
            if *stations == 1 { "station" } else { "stations" }
        ),
        Finding::Together { confidence } => format!(
            "No place was met by enough beams to be sure of it alone: a place counts from a belief of {} on, and nearly \
            all of them say the same.",
            percent(*confidence)
        ),
        Finding::Kept { shares } => {
            let kept: Vec<String> =
                shares.iter().map(|(why, share)| format!("{} ({})", kept(*why), percent(*share))).collect();
            format!("What kept its surface from being seen: {}.", kept.join(", "))
        }
        Finding::Divided { in_place, elsewhere, empty, silent, tolerance } => format!(
            "Of the places seen, {} show it within ±{} of the drawing, {} show it farther off, {} were found empty, \
            and {} tell nothing of it.",
            percent(*in_place),
            mm(*tolerance),
            percent(*elsewhere),
            percent(*empty),
            percent(*silent)
        ),
        Finding::Because { verdict, cause, tolerance } => {
            format!("{}, because {}.", title(*verdict), because(cause, *tolerance))
        }
        Finding::Accuracy { quantile, sd } => format!(
            "95 % of its worst surface lies within {} of the drawing; where the surface lies is known to {} (1 σ).",
            mm_tenths(*quantile),
            mm_tenths(*sd)
        ),
        Finding::Best { loa } => format!("The finest class that it keeps is {}.", loa.name()),
        Finding::NoFiner { loa, shortfall } => {
            let class = format!("{} (±{})", loa.name(), mm(loa.upper()));
            match shortfall {
                Shortfall::NotKept => format!("{class} it does not keep."),
                Shortfall::Unproven { probability, asked } => format!(
                    "{class} is not claimed: the survey shows it with a probability of {}, and {} is asked.",
                    percent_short_of(*probability, *asked),
                    percent(*asked)
                ),
            }
        }
    }
}

fn title(verdict: Verdict) -> &'static str {
    ["Confirmed", "Deviating", "Absent", "Unobserved", "Conflicting"][verdict as usize]
}

fn kept(why: Why) -> &'static str {
    match why {
        Why::HiddenByObject => "another drawn object in front of it",
        Why::HiddenByOther => "something in front of it that is not drawn",
        Why::TooFew => "too few beams",
        Why::TooSteep => "beams that met it too steeply",
        Why::NotLookedAt => "no beam was sent there",
        Why::NoReturn => "beams that did not come back",
        Why::SharedFace => "another object drawn at the same place",
    }
}

fn because(cause: &Cause, tolerance: f64) -> String {
    match cause {
        Cause::NothingSeen => "none of its surface was seen".into(),
        Cause::FewSeen { seen, asked } => format!("only {seen} places were seen, and {asked} are asked"),
        Cause::LittleSeen { share, asked } => {
            format!(
                "only {} of its surface was seen, and {} is asked",
                percent_short_of(*share, *asked),
                percent(*asked)
            )
        }
        Cause::Contradiction { conflict, most } => format!(
            "its stations contradict each other: their conflict is {}, and {} is the most allowed. \
            ab_stations(evidence) tells what each of them saw; often one is registered wrongly, or something moved \
            between them",
            percent(*conflict),
            percent(*most)
        ),
        Cause::LittleDecided { share, asked } => format!(
            "only {} of what was seen tells anything of it, and {} is asked",
            percent_short_of(*share, *asked),
            percent(*asked)
        ),
        Cause::Empty { share, most } => format!(
            "{} of the places that tell anything were found empty, more than {}, and hardly any shows it",
            percent(*share),
            percent(*most)
        ),
        Cause::Beside { share } => format!(
            "{} of its place was found empty, but beside it stands a surface that belongs to no other drawn object",
            percent(*share)
        ),
        Cause::Elsewhere { normal, deviation, sd, share } => format!(
            "a surface that belongs to no other drawn object, flat and as large as {} of {}, stands {} {} the drawing \
            (σ {})",
            percent(*share),
            face_that_looks(normal),
            mm_tenths(deviation.abs()),
            side(*deviation),
            mm_tenths(*sd)
        ),
        Cause::Displaced { surface, within, asked, enough } => displaced(surface, *within, *asked, *enough, tolerance),
        Cause::SeenThrough { surface, empty } => {
            format!("part of it is missing: {} of {} was found empty", percent(*empty), named(surface))
        }
        Cause::OutOfPlace { share, asked } => format!(
            "only {} of the places that tell anything show it where it is drawn, and {} is asked",
            percent_short_of(*share, *asked),
            percent(*asked)
        ),
        Cause::TooUnsure { sd, certain, asked } => format!(
            "what was seen lies where it is drawn, but is known only to {} (1 σ), too little for ±{}; taken place by \
            place, {} is certain, and {} is asked",
            mm_tenths(*sd),
            mm(tolerance),
            percent_short_of(*certain, *asked),
            percent(*asked)
        ),
        Cause::TooFewMeasured { independent, asked } => format!(
            "what was seen lies where it is drawn, but so few beams tell of it that they are worth {independent:.1} \
            places measured by themselves, and {asked:.0} are asked"
        ),
        Cause::InPlace { asked } => {
            format!(
                "at least {} of every well-seen surface lies within ±{} of the drawing",
                percent(*asked),
                mm(tolerance)
            )
        }
    }
}

fn displaced(surface: &SurfaceMeant, within: f64, asked: f64, enough: f64, tolerance: f64) -> String {
    let measured = match surface {
        SurfaceMeant::Smooth { deviation: Some((d, sd)), .. } => {
            format!("; it lies {} {} the drawing (σ {})", mm_tenths(d.abs()), side(*d), mm_tenths(*sd))
        }
        _ => String::new(),
    };
    format!(
        "only {} of {} lies within ±{} of the drawing, and {} is asked ({} would do, for what chance explains)\
        {measured}",
        percent_short_of(within, enough),
        named(surface),
        mm(tolerance),
        percent(asked),
        percent(enough)
    )
}

fn side(deviation: f64) -> &'static str {
    if deviation >= 0.0 { "outside" } else { "inside" }
}

fn named(surface: &SurfaceMeant) -> String {
    match surface {
        SurfaceMeant::All => "all its surfaces together".into(),
        SurfaceMeant::Smooth { faces: 1, normal, .. } => face_that_looks(normal),
        SurfaceMeant::Smooth { faces, normal, .. } => format!("the surface of {faces} faces with {}", looks(normal)),
    }
}

fn face_that_looks(normal: &Vec3) -> String {
    format!("the face with {}", looks(normal))
}

fn looks(n: &Vec3) -> String {
    format!("the outward normal ({:.2}, {:.2}, {:.2})", n.x + 0.0, n.y + 0.0, n.z + 0.0)
}

/// Metres as millimetres.
fn mm(metres: f64) -> String {
    format!("{} mm", metres * 1e3)
}

fn mm_tenths(metres: f64) -> String {
    format!("{:.1} mm", metres * 1e3)
}

fn percent(share: f64) -> String {
    format!("{} %", (share * 1e3).round() / 10.0)
}

/// A share that falls short of another, in words where both read the same.
fn percent_short_of(share: f64, bound: f64) -> String {
    if percent(share) == percent(bound) { format!("just under {}", percent(bound)) } else { percent(share) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_name_what_was_measured_and_what_was_asked() {
        let surface = |faces| SurfaceMeant::Smooth { faces, normal: -Vec3::y(), deviation: Some((-0.0312, 0.0007)) };
        let displaced = |surface, within| Cause::Displaced { surface, within, asked: 0.95, enough: 0.91 };
        let rest = "lies within ±15 mm of the drawing, and 95 % is asked (91 % would do, for what chance explains)";
        let looks = "with the outward normal (0.00, -1.00, 0.00)";
        for (cause, expected) in [
            (Cause::NothingSeen, "none of its surface was seen".to_string()),
            (
                Cause::LittleSeen { share: 0.01996, asked: 0.02 },
                "only just under 2 % of its surface was seen, and 2 % is asked".into(),
            ),
            (Cause::FewSeen { seen: 3, asked: 5 }, "only 3 places were seen, and 5 are asked".into()),
            (displaced(SurfaceMeant::All, 0.9004), format!("only 90 % of all its surfaces together {rest}")),
            (
                displaced(surface(1), 0.123),
                format!("only 12.3 % of the face {looks} {rest}; it lies 31.2 mm inside the drawing (σ 0.7 mm)"),
            ),
            (
                Cause::SeenThrough { surface: surface(12), empty: 0.81 },
                format!("part of it is missing: 81 % of the surface of 12 faces {looks} was found empty"),
            ),
        ] {
            assert_eq!(because(&cause, 0.015), expected);
        }
    }
}
