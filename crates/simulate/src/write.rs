//! Simulated scans as an E57 file: grid, poses, beams without return.

use std::fs::File;
use std::io::{BufWriter, Cursor, Write};
use std::path::Path;

use anyhow::{Context, Result};
use e57::{E57Writer, Quaternion, Record, RecordDataType, RecordName, RecordValue, Transform, Translation};

use crate::scanner::SimulatedScan;

/// Unit of the coordinates in the file, metres: far below the noise, a third of the bytes.
const QUANTUM_M: f64 = 1e-5;

/// Writes one point cloud per scan. The bytes depend only on the scans.
pub fn write_e57(path: &Path, scans: &[SimulatedScan]) -> Result<()> {
    // The library writes in small pieces and reads back: cheaper in memory than on disk.
    let mut memory = Cursor::new(Vec::new());
    let mut writer = E57Writer::new(&mut memory, "{a5b01170-0000-4000-8000-000000000000}")?;
    for (i, scan) in scans.iter().enumerate() {
        let guid = format!("{{a5b01170-0000-4000-8000-{:012x}}}", i + 1);
        let mut cloud = writer.add_pointcloud(&guid, prototype(scan))?;
        cloud.set_name(Some(format!("station {}", i + 1)));
        let half = 0.5 * scan.heading;
        cloud.set_transform(Some(Transform {
            rotation: Quaternion { w: half.cos(), x: 0.0, y: 0.0, z: half.sin() },
            translation: Translation { x: scan.registered.x, y: scan.registered.y, z: scan.registered.z },
        }));
        for s in &scan.shots {
            let coordinate = |c: f64| RecordValue::ScaledInteger((c / QUANTUM_M).round() as i64);
            cloud.add_point(vec![
                coordinate(s.point.x),
                coordinate(s.point.y),
                coordinate(s.point.z),
                RecordValue::Integer(i64::from(!s.returned)),
                RecordValue::Integer(i64::from(s.row)),
                RecordValue::Integer(i64::from(s.column)),
            ])?;
        }
        cloud.finalize()?;
    }
    writer.finalize()?;
    drop(writer);
    let mut file = BufWriter::new(File::create(path).with_context(|| format!("{}: cannot write", path.display()))?);
    file.write_all(memory.get_ref())
        .and_then(|()| file.flush())
        .with_context(|| format!("{}: cannot write", path.display()))
}

fn prototype(scan: &SimulatedScan) -> Vec<Record> {
    let coordinate = |name| Record {
        name,
        data_type: RecordDataType::ScaledInteger {
            min: i64::from(i32::MIN),
            max: i64::from(i32::MAX),
            scale: QUANTUM_M,
            offset: 0.0,
        },
    };
    let index = |name, count: u32| Record {
        name,
        data_type: RecordDataType::Integer { min: 0, max: i64::from(count.max(2) - 1) },
    };
    vec![
        coordinate(RecordName::CartesianX),
        coordinate(RecordName::CartesianY),
        coordinate(RecordName::CartesianZ),
        Record::CARTESIAN_INVALID_STATE,
        index(RecordName::RowIndex, scan.rows),
        index(RecordName::ColumnIndex, scan.columns),
    ]
}
