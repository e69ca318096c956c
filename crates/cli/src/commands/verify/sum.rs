//! The order in which verdicts are printed, and what they add up to.

use super::query::{Named, VerifiedObject};

/// Verdicts from the best to the worst, as SQL's `ab_verdict_kind` orders them.
const SEVERITY: [&str; 5] = ["confirmed", "unobserved", "conflicting", "deviating", "absent"];

/// A verdict on an object.
#[derive(clap::ValueEnum, Debug, Clone, Copy, PartialEq, Eq)]
pub enum VerdictName {
    /// Built, within the tolerance
    Confirmed,
    /// Too little was seen to say
    Unobserved,
    /// Stations contradict each other
    Conflicting,
    /// Built, but displaced beyond the tolerance
    Deviating,
    /// Its space was seen empty
    Absent,
}

impl VerdictName {
    pub fn name(self) -> &'static str {
        SEVERITY[self as usize]
    }
}

/// What to print first.
#[derive(clap::ValueEnum, Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum SortKey {
    /// As loaded
    #[default]
    Id,
    /// By name
    Name,
    /// By IFC class
    Class,
    /// By storey
    Storey,
    /// The worst verdict first
    Verdict,
    /// The largest deviation first, whichever way
    Deviation,
    /// What was seen least first
    Coverage,
}

/// Sorts; what is equal stays in the order of ids.
pub fn sort(objects: &mut [VerifiedObject], key: SortKey) {
    let text = |o: &VerifiedObject, column| o.text(column).map(str::to_lowercase);
    match key {
        SortKey::Id => {}
        SortKey::Name => objects.sort_by_cached_key(|o| text(o, Named::Name)),
        SortKey::Class => objects.sort_by_cached_key(|o| text(o, Named::Class)),
        SortKey::Storey => objects.sort_by_cached_key(|o| text(o, Named::Storey)),
        SortKey::Verdict => objects.sort_by_key(|o| std::cmp::Reverse(severity(&o.verdict))),
        SortKey::Deviation => {
            let off = |o: &VerifiedObject| o.deviation().map_or(-1.0, f64::abs);
            objects.sort_by(|a, b| off(b).total_cmp(&off(a)));
        }
        SortKey::Coverage => {
            let seen = |o: &VerifiedObject| o.coverage().unwrap_or(-1.0);
            objects.sort_by(|a, b| seen(a).total_cmp(&seen(b)));
        }
    }
}

fn severity(verdict: &str) -> usize {
    SEVERITY.iter().position(|v| *v == verdict).unwrap_or(SEVERITY.len())
}

/// `12 of 218 objects: 9 confirmed, 2 deviating, 1 absent`.
pub fn sum<'a>(verdicts: impl Iterator<Item = &'a str> + Clone, all: usize) -> String {
    let count = |verdict: &str| verdicts.clone().filter(|v| *v == verdict).count();
    let shown = verdicts.clone().count();
    let of = if shown == all { String::new() } else { format!(" of {all}") };
    let what = if all == 1 { "object" } else { "objects" };
    let parts: Vec<String> =
        SEVERITY.iter().map(|v| (count(v), v)).filter(|(n, _)| *n > 0).map(|(n, v)| format!("{n} {v}")).collect();
    let colon = if parts.is_empty() { "" } else { ": " };
    format!("{shown}{of} {what}{colon}{}", parts.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums() {
        let said = |verdicts: &[&'static str], all| sum(verdicts.iter().copied(), all);
        assert_eq!(said(&["absent", "confirmed", "confirmed"], 3), "3 objects: 2 confirmed, 1 absent");
        assert_eq!(said(&["deviating"], 218), "1 of 218 objects: 1 deviating");
        assert_eq!(said(&["unobserved"], 1), "1 object: 1 unobserved");
        assert_eq!(said(&[], 0), "0 objects");
    }

    #[test]
    fn every_verdict_has_its_place() {
        for verdict in <VerdictName as clap::ValueEnum>::value_variants() {
            assert_eq!(severity(verdict.name()), *verdict as usize);
        }
    }
}
