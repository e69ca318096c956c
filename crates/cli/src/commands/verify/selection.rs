//! Which objects are printed and counted. A filter chooses among verdicts that are there already: the neighbours of an
//! object are known, whatever is asked for.

use std::collections::HashSet;

use anyhow::{Context, Result, bail};
use postgres::{IsolationLevel, Row};

use crate::database::connect::{Database, explain, set_path};

/// What to print of all that was verified.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Which objects (all are verified, and know each other)")]
pub struct SelectionArgs {
    /// Only objects of this IFC class, e.g. IfcWall or IfcWall*; may be given several times
    #[arg(long, value_name = "CLASS")]
    class: Vec<String>,
    /// Only objects of this storey; * stands for any text
    #[arg(long, value_name = "NAME")]
    storey: Vec<String>,
    /// Only objects of this name; * stands for any text
    #[arg(long, value_name = "NAME")]
    name: Vec<String>,
    /// Only objects for which this SQL condition holds on building_object o, e.g. "o.properties ->> 'Status' = 'new'"
    #[arg(long = "where", value_name = "SQL")]
    condition: Option<String>,
    /// Only these objects: ids or GlobalIds, separated by commas
    #[arg(long, value_name = "ID,…", value_delimiter = ',')]
    only: Vec<String>,
    /// Not these objects: ids or GlobalIds, separated by commas
    #[arg(long, value_name = "ID,…", value_delimiter = ',')]
    exclude: Vec<String>,
}

/// What tells an object.
struct Told {
    id: i64,
    global_id: String,
    ifc_class: String,
    name: String,
    storey: Option<String>,
}

impl SelectionArgs {
    /// The ids of what is asked for. An id that is nobody's is an error, and so is asking for nothing that exists.
    pub fn ids(&self, db: &mut Database) -> Result<HashSet<i64>> {
        let all = objects(db)?;
        let given = self.only.iter().chain(&self.exclude);
        given.map(|given| of(&all, given)).collect::<Result<Vec<_>>>()?;
        let holding = self.condition.as_deref().map(|condition| holding(db, condition)).transpose()?;
        let chosen: HashSet<i64> = all
            .iter()
            .filter(|o| self.names(o) && holding.as_ref().is_none_or(|ids| ids.contains(&o.id)))
            .map(|o| o.id)
            .collect();
        if chosen.is_empty() && !all.is_empty() {
            bail!("none of the {} objects is asked for: {}", all.len(), self.nearest(&all));
        }
        Ok(chosen)
    }

    fn names(&self, o: &Told) -> bool {
        let is_any = |patterns: &[String], text: &str| patterns.is_empty() || patterns.iter().any(|p| fits(p, text));
        is_any(&self.class, &o.ifc_class)
            && is_any(&self.name, &o.name)
            && is_any(&self.storey, o.storey.as_deref().unwrap_or(""))
            && (self.only.is_empty() || self.only.iter().any(|id| o.is(id)))
            && !self.exclude.iter().any(|id| o.is(id))
    }

    /// What there is to choose from, where a filter fits nothing.
    fn nearest(&self, all: &[Told]) -> String {
        let list = |what: &str, of: &dyn Fn(&Told) -> String| {
            let mut names: Vec<String> = all.iter().map(of).collect();
            names.sort();
            names.dedup();
            let shown: Vec<&str> = names.iter().take(20).map(String::as_str).collect();
            format!("the {what} are {}{}", shown.join(", "), if names.len() > 20 { ", …" } else { "" })
        };
        let fits_none = |patterns: &[String], of: &dyn Fn(&Told) -> String| {
            !patterns.is_empty() && !all.iter().any(|o| patterns.iter().any(|p| fits(p, &of(o))))
        };
        let storey = |o: &Told| o.storey.clone().unwrap_or_default();
        match () {
            () if fits_none(&self.class, &|o| o.ifc_class.clone()) => list("classes", &|o| o.ifc_class.clone()),
            () if fits_none(&self.storey, &storey) => list("storeys", &storey),
            () if fits_none(&self.name, &|o| o.name.clone()) => list("names", &|o| o.name.clone()),
            () => "no object fits all that was given".into(),
        }
    }
}

impl Told {
    fn is(&self, given: &str) -> bool {
        self.global_id == given || given.parse() == Ok(self.id)
    }
}

/// The ids of objects of which ids or GlobalIds are given.
pub fn ids_of(db: &mut Database, given: &[String]) -> Result<Vec<i64>> {
    let all = objects(db)?;
    Ok(given.iter().map(|given| of(&all, given)).collect::<Result<Vec<_>>>()?.concat())
}

/// The ids of those of which this is the id or the GlobalId: of two models in one project, several.
fn of(all: &[Told], given: &str) -> Result<Vec<i64>> {
    let ids: Vec<i64> = all.iter().filter(|o| o.is(given)).map(|o| o.id).collect();
    if ids.is_empty() {
        bail!("no object has the id or GlobalId {given}; asbuilt verify lists all, with their ids");
    }
    Ok(ids)
}

fn objects(db: &mut Database) -> Result<Vec<Told>> {
    let sql = db.sql("SELECT id, global_id, ifc_class, name, storey FROM @building_object");
    let told = |row: &Row| Told {
        id: row.get(0),
        global_id: row.get(1),
        ifc_class: row.get(2),
        name: row.get(3),
        storey: row.get(4),
    };
    Ok(db.client.query(&sql, &[]).map_err(explain)?.iter().map(told).collect())
}

/// The ids for which the user's condition holds: read only, under the user's own search path, and nothing of it stays.
fn holding(db: &mut Database, condition: &str) -> Result<HashSet<i64>> {
    let sql = format!("SELECT o.id FROM {} o WHERE ({condition}\n)", db.names.table("building_object"));
    let path = db.user_path.clone();
    let read_only = db.client.build_transaction().read_only(true).isolation_level(IsolationLevel::RepeatableRead);
    let mut tx = read_only.start().map_err(explain)?;
    set_path(&mut tx, &path)?;
    let rows = tx.query(&sql, &[]).map_err(explain).with_context(|| format!("--where {condition:?}"))?;
    let ids = rows.iter().map(|r| r.try_get(0)).collect::<Result<_, _>>().map_err(explain)?;
    tx.rollback().map_err(explain)?;
    Ok(ids)
}

/// Whether a text fits a pattern, whatever its case; `*` stands for any text.
fn fits(pattern: &str, text: &str) -> bool {
    let (pattern, text) = (pattern.to_lowercase(), text.to_lowercase());
    let mut parts = pattern.split('*');
    let Some(mut rest) = text.strip_prefix(parts.next().unwrap_or("")) else { return false };
    let Some(last) = parts.next_back() else { return rest.is_empty() };
    for part in parts {
        let Some(at) = rest.find(part) else { return false };
        rest = &rest[at + part.len()..];
    }
    rest.ends_with(last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns() {
        for (pattern, text, is) in [
            ("IfcWall", "IfcWall", true),
            ("ifcwall", "IfcWall", true),
            ("IfcWall", "IfcWallStandardCase", false),
            ("IfcWall*", "IfcWallStandardCase", true),
            ("*Case", "IfcWallStandardCase", true),
            ("*wall*case*", "IfcWallStandardCase", true),
            ("a*b*c", "a1c2b3c", true),
            ("a*b*c", "acb", false),
            ("ab*ba", "aba", false),
            ("*", "", true),
            ("", "", true),
            ("", "a", false),
            ("Tür*", "TÜR 1", true),
            ("a.c", "abc", false),
        ] {
            assert_eq!(fits(pattern, text), is, "{pattern} {text}");
        }
    }
}
