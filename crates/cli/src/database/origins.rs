//! How many stations tell where they stood.

use anyhow::Result;

use super::connect::{Database, explain};
use crate::output::say;

/// Stations of an epoch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StationOrigins {
    pub stations: i64,
    pub without_origin: i64,
}

/// Patches of a moving platform have an origin a beam, and their station has no pose; all patches of a station are alike.
const COUNT: &str = "
SELECT pg_catalog.count(*), pg_catalog.count(*) FILTER (WHERE t.pose IS NULL AND NOT coalesce(
           (SELECT (@ext.ab_range(s.patch)).nearest IS NOT NULL FROM @scan s WHERE s.station_id = t.id LIMIT 1::int8), false))
FROM   @station t
WHERE  t.epoch = $1::int4";

impl StationOrigins {
    fn count(db: &mut Database, epoch: i32) -> Result<Self> {
        let row = db.client.query_one(&db.sql(COUNT), &[&epoch]).map_err(explain)?;
        Ok(Self { stations: row.get(0), without_origin: row.get(1) })
    }

    /// Says on standard error what verdicts on an epoch suffer from stations without origin.
    pub fn warn(db: &mut Database, epoch: i32) -> Result<()> {
        if let Some(remark) = Self::count(db, epoch)?.remark() {
            say!("asbuilt: {remark}");
        }
        Ok(())
    }

    /// What is to be said of verdicts on them; `None` where every station has an origin.
    pub fn remark(&self) -> Option<String> {
        let Self { stations, without_origin } = *self;
        let cost = match without_origin {
            0 => return None,
            n if n == stations => "no object can be absent",
            _ => "no object is absent by them alone",
        };
        Some(format!(
            "{without_origin} of {stations} stations have no origin: their points say where something is, never that a place \
             is empty, so {cost}; tell where the scanners stood: asbuilt load … --origins FILE"
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_said() {
        let said = |stations, without_origin| StationOrigins { stations, without_origin }.remark();
        assert_eq!(said(3, 0), None);
        assert!(said(3, 1).is_some_and(|s| s.starts_with("1 of 3 stations") && s.contains("by them alone")));
        assert!(said(3, 3).is_some_and(|s| s.contains("no object can be absent") && s.contains("--origins FILE")));
    }
}
