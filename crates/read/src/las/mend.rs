//! What writers get wrong in the header of a LAS file, corrected before the library sees it.

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};

use anyhow::{Context, Result, bail};

use crate::overlay::Overlay;

/// The file and what was corrected.
pub type Mended = (BufReader<Overlay<File>>, Vec<String>);

/// Bytes of the header of versions 1.3 and 1.4.
const HEAD_1_3: u16 = 235;
const HEAD_1_4: u16 = 375;
/// Bytes of a record's header.
const VLR_HEAD: u64 = 54;

/// Opens the file.
pub fn open(file: File) -> Result<Mended> {
    let mut file = Overlay::new(file)?;
    let mut head = vec![0; usize::from(HEAD_1_4).min(file.len() as usize)];
    file.rewind()?;
    file.read_exact(&mut head)?;
    if head.len() < 227 || !head.starts_with(b"LASF") {
        bail!("not a readable LAS file: it does not begin with the head of one");
    }
    let mut notes = Vec::new();
    check_scales(&head)?;
    notes.extend(mend_version(&head, &mut file));
    notes.extend(mend_count(&head, &mut file));
    notes.extend(mend_records(&head, &mut file)?);
    file.rewind()?;
    Ok((BufReader::with_capacity(1 << 20, file), notes))
}

fn u16_at(head: &[u8], at: usize) -> u16 {
    u16::from_le_bytes(std::array::from_fn(|k| head[at + k]))
}

fn u32_at(head: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(std::array::from_fn(|k| head[at + k]))
}

fn check_scales(head: &[u8]) -> Result<()> {
    for (axis, at) in [("x", 131), ("y", 139), ("z", 147)] {
        let scale = f64::from_le_bytes(std::array::from_fn(|k| head[at + k]));
        if scale == 0.0 || !scale.is_finite() {
            bail!("its scale of {axis} is {scale}: its points are lost; write it again with one such as 0.001");
        }
    }
    Ok(())
}

/// Newer versions keep the fields that are needed; the length of the header tells which there are.
fn mend_version(head: &[u8], file: &mut Overlay<File>) -> Option<String> {
    let minor = head[25];
    let known = match u16_at(head, 94) {
        HEAD_1_4.. => 4,
        HEAD_1_3.. => 3,
        _ => 2,
    };
    if minor <= 4 {
        return None;
    }
    file.put(25, vec![known]);
    Some(format!("version {}.{minor} is newer than this program, and was read as 1.{known}", head[24]))
}

/// From version 1.4 on there are two counts; the 64-bit one takes precedence over the old one.
fn mend_count(head: &[u8], file: &mut Overlay<File>) -> Option<String> {
    if head[25] < 4 || u16_at(head, 94) < HEAD_1_4 || head.len() < usize::from(HEAD_1_4) {
        return None;
    }
    let old = u64::from(u32_at(head, 107));
    let long = u64::from_le_bytes(std::array::from_fn(|k| head[247 + k]));
    if old == 0 || long == 0 || old == long {
        return None;
    }
    file.put(107, vec![0; 4]);
    Some(format!("its old count of points is {old} and its count of version 1.4 is {long}, which was taken"))
}

/// Records that end beyond the start of the points do not exist.
fn mend_records(head: &[u8], file: &mut Overlay<File>) -> Result<Option<String>> {
    let (mut at, points, told) = (u64::from(u16_at(head, 94)), u64::from(u32_at(head, 96)), u32_at(head, 100));
    let mut found = 0;
    while found < told && at + VLR_HEAD <= points {
        file.seek(SeekFrom::Start(at))?;
        let mut record = [0; VLR_HEAD as usize];
        file.read_exact(&mut record).context("it ends within its records")?;
        let end = at + VLR_HEAD + u64::from(u16_at(&record, 20));
        if end > points {
            break;
        }
        (at, found) = (end, found + 1);
    }
    if found == told {
        return Ok(None);
    }
    file.put(100, found.to_le_bytes().to_vec());
    Ok(Some(format!("its head promises {told} records and has room for {found}")))
}
