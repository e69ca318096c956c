//! The stored form of change.

use super::classes::Classes;
use super::settings::ChangeSettings;
use super::value::VoxelChange;
use crate::Interrupt;
use crate::error::Result;
use crate::num::bytes::{ByteReader, Put};
use crate::voxel::lattice::block_bytes::{ABOVE_THE_LAST, read_bits, read_blocks, write_bits, write_blocks, write_key};
use crate::voxel::lattice::{TileFormat, TileHeader};

const FORMAT: TileFormat = TileFormat::CHANGE;

/// Flag of a block whose voxels are all of classes below 4: its third plane is not written.
const TWO_PLANES: u8 = 2;

impl VoxelChange {
    /// Layout version written by this release.
    pub const VERSION: u8 = FORMAT.version;

    /// The stored and transmitted form; equal changes have equal bytes.
    ///
    /// Little-endian: the header (its notes: 1 against a model, the threshold), the tolerance f64, then per block, in
    /// the order of their numbers, a byte of flags, its number as occupancy has it, and two or three planes of bits.
    pub fn to_bytes(&self, interrupt: Interrupt) -> Result<Vec<u8>> {
        let blocks = self.blocks.in_order(interrupt, |classes| classes)?;
        let keys = blocks.iter().map(|(key, _)| *key).collect::<Vec<_>>();
        let notes = [u8::from(self.against_model), self.settings.threshold];
        FORMAT.write(notes, &self.grid, keys.iter().copied(), interrupt, |out| {
            out.put_f64(self.settings.tolerance);
            write_blocks(blocks, out, interrupt, write_classes)
        })
    }

    /// The header alone.
    pub fn header(bytes: &[u8]) -> Result<TileHeader> {
        FORMAT.header(bytes)
    }

    /// Reads bytes, foreign ones too.
    pub fn from_bytes(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let (mut r, header) = FORMAT.read(bytes, interrupt)?;
        let settings = ChangeSettings { threshold: header.notes[1], tolerance: r.f64()? };
        if header.notes[0] > 1 || settings.threshold == 0 || !(0.0..=1e4).contains(&settings.tolerance) {
            return Err(r.bad(format!("notes {:?}, tolerance {}", header.notes, settings.tolerance)));
        }
        let against_model = header.notes[0] == 1;
        let mut out = Self { grid: header.grid, settings, against_model, blocks: Default::default() };
        read_blocks(r, &header, interrupt, |r, flags, key| out.blocks.insert(key, read_classes(r, flags)?, interrupt))?;
        Ok(out)
    }
}

fn write_classes(key: [i32; 3], last: [i32; 3], classes: &Classes, out: &mut Vec<u8>) {
    let two = classes.0[2] == [0; 8];
    write_key(key, last, if two { TWO_PLANES } else { 0 }, out);
    let planes = if two { 2 } else { 3 };
    classes.0[..planes].iter().for_each(|bits| write_bits(bits, out));
}

fn read_classes(r: &mut ByteReader, flags: u8) -> Result<Classes> {
    if flags & !(ABOVE_THE_LAST | TWO_PLANES) != 0 {
        return Err(r.bad(format!("flags {flags:#04x} of a block")));
    }
    let mut classes = Classes::default();
    let planes = if flags & TWO_PLANES != 0 { 2 } else { 3 };
    for plane in &mut classes.0[..planes] {
        *plane = read_bits(r)?;
    }
    if classes.are_valid() { Ok(classes) } else { Err(r.bad("a class that does not exist")) }
}

#[cfg(test)]
mod tests {
    use super::super::class::ChangeClass;
    use super::*;
    use crate::voxel::lattice::Grid;
    use crate::{AtOnce, NEVER};
    use proptest::prelude::*;

    fn any_change() -> impl Strategy<Value = VoxelChange> {
        let voxel = (prop::array::uniform3(-3i32..3), 0usize..512, 0usize..5);
        (prop::collection::vec(voxel, 0..300), 1u8.., any::<bool>()).prop_map(|(voxels, threshold, against_model)| {
            let grid = Grid::new(0.02, Grid::EVERYWHERE, 0.01, 5.0).unwrap();
            let settings = ChangeSettings { threshold, tolerance: 0.01 };
            let mut c = VoxelChange { grid, settings, against_model, blocks: Default::default() };
            for (key, slot, class) in voxels {
                let classes = c.blocks.made(key, NEVER).unwrap();
                if classes.get(slot).is_none() {
                    classes.set(slot, ChangeClass::ALL[class]);
                }
            }
            c
        })
    }

    proptest! {
        #[test]
        fn bytes_round_trip(c in any_change()) {
            let bytes = c.to_bytes(NEVER).unwrap();
            let back = VoxelChange::from_bytes(&bytes, NEVER).unwrap();
            prop_assert_eq!(&back, &c);
            prop_assert_eq!(back.to_bytes(NEVER).unwrap(), bytes);
        }

        #[test]
        fn damage_is_noticed(c in any_change(), at in any::<usize>(), x in 1u8.., cut in 0usize..3) {
            let mut bytes = c.to_bytes(NEVER).unwrap();
            let n = bytes.len();
            bytes[at % n] ^= x;
            bytes.truncate(n - cut);
            prop_assert!(VoxelChange::from_bytes(&bytes, NEVER).is_err());
        }

        #[test]
        fn nonsense_under_a_right_checksum(
            c in any_change(),
            flips in prop::collection::vec((any::<usize>(), any::<u8>()), 1..9),
        ) {
            let bytes = c.to_bytes(NEVER).unwrap();
            let (body, header) = FORMAT.read(&bytes, NEVER).unwrap();
            let mut body = body.clone().take(body.remaining()).unwrap().to_vec();
            let n = body.len();
            flips.into_iter().for_each(|(at, x)| body[at % n] = x);
            let keys: Vec<_> = c.blocks.keys().copied().collect();
            let bytes = FORMAT.write(header.notes, &header.grid, keys.iter().copied(), NEVER, |out| {
                out.extend_from_slice(&body);
                Ok(())
            });
            let _ = VoxelChange::from_bytes(&bytes.unwrap(), NEVER);
        }
    }

    #[test]
    fn memory_is_bounded() {
        let grid = Grid::new(0.02, Grid::EVERYWHERE, 0.01, 5.0).unwrap();
        let settings = ChangeSettings { threshold: 3, tolerance: 0.0 };
        let mut c = VoxelChange { grid, settings, against_model: false, blocks: Default::default() };
        (0..100_000).for_each(|i| {
            c.blocks.made([0, 0, i], NEVER).unwrap().set(3, ChangeClass::New);
        });
        let bytes = c.to_bytes(NEVER).unwrap();
        assert!(VoxelChange::from_bytes(&bytes, &AtOnce(100_000)).is_err());
    }
}
