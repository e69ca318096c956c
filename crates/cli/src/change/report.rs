//! Objects, components and totals, printed.

use std::io::Write;

use anyhow::Result;
use asbuilt_core::voxel::ChangeComponent;
use serde_json::{Map, Value, json};

use super::classes::ObjectClass;
use super::tally::{ChangeReport, Counted};
use crate::output::{Format, LengthUnit, Table, rounded, to_stdout};

/// The classes in the order of their columns.
const CLASSES: [&str; 5] = ["confirmed", "new", "disappeared", "unknown", "ambiguous"];

impl ChangeReport {
    /// Prints it; as CSV the objects alone.
    pub fn print(&self, format: Format, unit: LengthUnit) -> Result<()> {
        match format {
            Format::Json => {
                let text = serde_json::to_string_pretty(&self.json(unit))?;
                to_stdout(|out| Ok(writeln!(out, "{text}")?))?;
            }
            Format::Csv | Format::CsvExact => self.objects_table(format, unit).print(format)?,
            Format::Table => {
                self.objects_table(format, unit).print(format)?;
                to_stdout(|out| Ok(writeln!(out)?))?;
                self.components_table().print_of(format, "component", "components")?;
                to_stdout(|out| Ok(writeln!(out)?))?;
                self.total_table().print_of(format, "class", "classes")?;
            }
        }
        Ok(())
    }

    fn json(&self, unit: LengthUnit) -> Value {
        let object = |object: &Counted| {
            let mut o = Map::new();
            o.insert("name".into(), object.name.clone().into());
            o.insert("global_id".into(), object.global_id.clone().into());
            o.extend(self.counts(&object.voxels));
            if self.has_classes {
                o.extend(ObjectClass::json(object.class.as_ref(), unit));
            }
            Value::Object(o)
        };
        let place = |v: &[f64]| v.iter().map(|x| rounded(Some(*x), 6)).collect::<Vec<_>>();
        let component = |(class, c, objects): &(&str, ChangeComponent, Vec<String>)| {
            json!({"class": class, "voxels": c.voxels, "volume_m3": rounded(Some(self.volume(c.voxels)), 6),
                   "box": {"min": place(&c.bounds.min), "max": place(&c.bounds.max)},
                   "centroid": place(c.centroid.as_slice()), "objects": objects})
        };
        let mut total = self.counts(&self.total);
        for (class, share) in CLASSES.iter().zip(shares(&self.total)) {
            total.insert(format!("{class}_share"), share);
        }
        json!({"objects": self.objects.iter().map(object).collect::<Vec<_>>(),
               "components": self.components.iter().map(component).collect::<Vec<_>>(), "total": total})
    }

    /// For people the class comes first; in CSV after the columns that programs know.
    fn objects_table(&self, format: Format, unit: LengthUnit) -> Table {
        let wide = format != Format::Table;
        let volumes: Vec<String> = CLASSES.iter().chain(&["total"]).map(|c| format!("{c}_m3")).collect();
        let mut counted: Vec<&str> = [&CLASSES[..], &["total"]].concat();
        counted.extend(volumes[if wide { 0..6 } else { 1..3 }].iter().map(String::as_str));
        let classes = if self.has_classes { ObjectClass::columns(format, unit) } else { Vec::new() };
        let classes: Vec<&str> = classes.iter().map(String::as_str).collect();
        let columns = match wide {
            true => [vec!["name", "global_id"], counted.clone(), classes].concat(),
            false => [vec!["name"], classes, counted.clone()].concat(),
        };
        let mut table = Table::new(&columns);
        for object in &self.objects {
            let all = self.counts(&object.voxels);
            let name = Value::from(object.name.clone());
            let counts: Vec<Value> = counted.iter().map(|&c| all[c].clone()).collect();
            let class =
                if self.has_classes { ObjectClass::cells(object.class.as_ref(), format, unit) } else { Vec::new() };
            table.push(match wide {
                true => [vec![name, object.global_id.clone().into()], counts, class].concat(),
                false => [vec![name], class, counts].concat(),
            });
        }
        table
    }

    fn components_table(&self) -> Table {
        let mut table = Table::new(&["class", "voxels", "volume_m3", "centroid", "size_m", "objects there"]);
        for (class, c, objects) in &self.components {
            let place =
                |v: &[f64], digits: usize| v.iter().map(|x| format!("{x:.digits$}")).collect::<Vec<_>>().join(" ");
            let size: Vec<f64> = c.bounds.min.iter().zip(&c.bounds.max).map(|(a, b)| b - a).collect();
            table.push(vec![
                (*class).into(),
                c.voxels.into(),
                rounded(Some(self.volume(c.voxels)), 5),
                place(c.centroid.as_slice(), 2).into(),
                place(&size, 2).into(),
                objects.join(", ").into(),
            ]);
        }
        table
    }

    fn total_table(&self) -> Table {
        let mut table = Table::new(&["class", "voxels", "volume_m3", "share_percent"]);
        let all = self.counts(&self.total);
        for (class, share) in CLASSES.iter().zip(shares(&self.total)) {
            let percent = share.as_f64().map(|s| 100.0 * s);
            let volume = all[&format!("{class}_m3")].clone();
            table.push(vec![(*class).into(), all[*class].clone(), volume, rounded(percent, 1)]);
        }
        table
    }

    fn volume(&self, voxels: u64) -> f64 {
        voxels as f64 * self.voxel_volume
    }

    /// Voxels and cubic metres by the names of their columns.
    fn counts(&self, voxels: &[u64; 5]) -> Map<String, Value> {
        let all = || CLASSES.iter().zip(voxels.iter().copied()).chain([(&"total", voxels.iter().sum())]);
        let volume = |n: u64| rounded(Some(self.volume(n)), 6);
        all()
            .map(|(c, n)| (c.to_string(), n.into()))
            .chain(all().map(|(c, n)| (format!("{c}_m3"), volume(n))))
            .collect()
    }
}

/// Shares of the total; NULL if the total is zero.
fn shares(voxels: &[u64; 5]) -> Vec<Value> {
    let total: u64 = voxels.iter().sum();
    let share = |n: &u64| if total == 0 { Value::Null } else { rounded(Some(*n as f64 / total as f64), 4) };
    voxels.iter().map(share).collect()
}
