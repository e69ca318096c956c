//! Objects, components and the whole, printed.

use anyhow::Result;
use postgres::error::SqlState;
use postgres::{Client, Row};
use serde_json::{Map, Value, json};

use crate::database::connect::explain;
use crate::output::{Format, Table, rounded, say};

/// The classes in the order of their columns.
const CLASSES: [&str; 5] = ["confirmed", "new", "disappeared", "unknown", "ambiguous"];

const COLUMNS: &str =
    "sum(s.confirmed)::bigint, sum(s.new)::bigint, sum(s.disappeared)::bigint, sum(s.unknown)::bigint,
       sum(s.ambiguous)::bigint, sum(s.total)::bigint, sum(s.confirmed_m3), sum(s.new_m3), sum(s.disappeared_m3),
       sum(s.unknown_m3), sum(s.ambiguous_m3), sum(s.total_m3)";

/// What the report is about.
pub struct Report {
    objects: Vec<Row>,
    components: Vec<Component>,
    total: Row,
}

struct Component {
    class: String,
    voxels: i64,
    volume: f64,
    min: Vec<f64>,
    max: Vec<f64>,
    centroid: Vec<f64>,
    /// Building objects whose boxes it meets.
    objects: Vec<String>,
}

impl Report {
    /// Asks the comparison in `asbuilt_change`. Voxels of an object may lie two voxels and the tolerance beside its box.
    pub fn ask(client: &mut Client, voxel: f64, tolerance: f64, min_voxels: i32, gap: Option<f64>) -> Result<Self> {
        let objects = format!(
            "SELECT {COLUMNS}, o.name, o.global_id
             FROM building_object o LEFT JOIN asbuilt_change c ON c.change && ab_expand(ab_box(o.solid), $2)
             LEFT JOIN LATERAL ab_summary(c.change, o.solid, $1) s ON true GROUP BY o.id ORDER BY o.id"
        );
        let components = "
            SELECT k.class, k.voxels, k.volume, ab_min(k.box), ab_max(k.box), k.centroid,
                   ARRAY(SELECT o.name FROM building_object o WHERE o.solid && k.box ORDER BY o.name)
            FROM  (SELECT ab_rollup_agg(change) AS change FROM asbuilt_change) c,
                   ab_components(c.change, NULL, $1, $2) k
            ORDER  BY k.voxels DESC";
        let total = format!("SELECT {COLUMNS} FROM asbuilt_change c, LATERAL ab_summary(c.change) s");
        let component = |row: &Row| Component {
            class: row.get(0),
            voxels: row.get(1),
            volume: row.get(2),
            min: row.get(3),
            max: row.get(4),
            centroid: row.get(5),
            objects: row.get(6),
        };
        // Components want the whole as one value; where that is too large, the objects are known all the same.
        let found = match client.query(components, &[&min_voxels, &gap]) {
            Ok(rows) => rows.iter().map(component).collect(),
            Err(error) if error.code() == Some(&SqlState::PROGRAM_LIMIT_EXCEEDED) => {
                say!("asbuilt: no components: {:#}", explain(error));
                Vec::new()
            }
            Err(error) => return Err(explain(error)),
        };
        Ok(Self {
            objects: client.query(&objects, &[&tolerance, &(tolerance + 2.0 * voxel)]).map_err(explain)?,
            components: found,
            total: client.query_one(&total, &[]).map_err(explain)?,
        })
    }

    /// Prints it; as CSV the objects alone.
    pub fn print(&self, format: Format) -> Result<()> {
        match format {
            Format::Json => println!("{}", serde_json::to_string_pretty(&self.json())?),
            Format::Csv => self.objects_table(true).print(format)?,
            Format::Table => {
                self.objects_table(false).print(format)?;
                println!();
                self.components_table().print_of(format, "component", "components")?;
                println!();
                self.total_table().print_of(format, "class", "classes")?;
            }
        }
        Ok(())
    }

    fn json(&self) -> Value {
        let object = |row: &Row| {
            let mut o = Map::new();
            o.insert("name".into(), row.get::<_, String>(12).into());
            o.insert("global_id".into(), row.get::<_, String>(13).into());
            o.extend(counts(row));
            Value::Object(o)
        };
        let place = |v: &[f64]| v.iter().map(|x| rounded(Some(*x), 6)).collect::<Vec<_>>();
        let component = |c: &Component| {
            json!({"class": c.class, "voxels": c.voxels, "volume_m3": rounded(Some(c.volume), 6),
                   "box": {"min": place(&c.min), "max": place(&c.max)}, "centroid": place(&c.centroid),
                   "objects": c.objects})
        };
        let mut total = counts(&self.total);
        for (class, share) in CLASSES.iter().zip(shares(&self.total)) {
            total.insert(format!("{class}_share"), share);
        }
        json!({"objects": self.objects.iter().map(object).collect::<Vec<_>>(),
               "components": self.components.iter().map(component).collect::<Vec<_>>(), "total": total})
    }

    fn objects_table(&self, wide: bool) -> Table {
        let mut columns = vec!["name"];
        columns.extend(wide.then_some("global_id"));
        columns.extend(CLASSES);
        columns.push("total");
        let volumes: Vec<String> = CLASSES.iter().chain(&["total"]).map(|c| format!("{c}_m3")).collect();
        let shown: Vec<&str> = volumes.iter().map(String::as_str).collect();
        let shown = if wide { &shown[..] } else { &shown[1..3] };
        columns.extend(shown);
        let mut table = Table::new(&columns);
        for row in &self.objects {
            let all = counts(row);
            let mut cells = vec![Value::from(row.get::<_, String>(12))];
            cells.extend(wide.then(|| Value::from(row.get::<_, String>(13))));
            cells.extend(columns[cells.len()..].iter().map(|&c| all[c].clone()));
            table.push(cells);
        }
        table
    }

    fn components_table(&self) -> Table {
        let mut table = Table::new(&["class", "voxels", "volume_m3", "centroid", "size_m", "objects there"]);
        for c in &self.components {
            let place =
                |v: &[f64], digits: usize| v.iter().map(|x| format!("{x:.digits$}")).collect::<Vec<_>>().join(" ");
            let size: Vec<f64> = c.min.iter().zip(&c.max).map(|(a, b)| b - a).collect();
            table.push(vec![
                c.class.clone().into(),
                c.voxels.into(),
                rounded(Some(c.volume), 5),
                place(&c.centroid, 2).into(),
                place(&size, 2).into(),
                c.objects.join(", ").into(),
            ]);
        }
        table
    }

    fn total_table(&self) -> Table {
        let mut table = Table::new(&["class", "voxels", "volume_m3", "share_percent"]);
        let all = counts(&self.total);
        for (class, share) in CLASSES.iter().zip(shares(&self.total)) {
            let percent = share.as_f64().map(|s| 100.0 * s);
            let volume = all[&format!("{class}_m3")].clone();
            table.push(vec![(*class).into(), all[*class].clone(), volume, rounded(percent, 1)]);
        }
        table
    }
}

/// Voxels and cubic metres by the names of their columns; 0 where there are none.
fn counts(row: &Row) -> Map<String, Value> {
    let names = || CLASSES.iter().chain(&["total"]);
    let voxels = names().enumerate().map(|(i, c)| (c.to_string(), row.get::<_, Option<i64>>(i).unwrap_or(0).into()));
    let volume = |i: usize| rounded(Some(row.get::<_, Option<f64>>(6 + i).unwrap_or(0.0)), 6);
    voxels.chain(names().enumerate().map(|(i, c)| (format!("{c}_m3"), volume(i)))).collect()
}

/// Parts of the total; NULL of nothing.
fn shares(row: &Row) -> Vec<Value> {
    let total = row.get::<_, Option<i64>>(5).unwrap_or(0);
    let share = |i: usize| row.get::<_, Option<i64>>(i).unwrap_or(0) as f64 / total as f64;
    (0..CLASSES.len()).map(|i| if total == 0 { Value::Null } else { rounded(Some(share(i)), 4) }).collect()
}
