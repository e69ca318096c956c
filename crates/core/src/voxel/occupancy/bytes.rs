//! The stored form of occupancy.

use super::known::{DRAWN, KnownBlock, KnownTile};
use super::value::Occupancy;
use crate::Interrupt;
use crate::error::Result;
use crate::num::bytes::{ByteReader, Put};
use crate::voxel::lattice::bits::{Bits, slots};
use crate::voxel::lattice::block_bytes::{ABOVE_THE_LAST, read_bits, read_blocks, write_bits, write_blocks, write_key};
use crate::voxel::lattice::{TileFormat, TileHeader, VoxelBlock};

const FORMAT: TileFormat = TileFormat::OCCUPANCY;

/// Flags of a block, beside [`ABOVE_THE_LAST`].
const HAS_HITS: u8 = 2;
const ALL_TRAVERSED: u8 = 4;
/// All counts but 0 are alike, as in models and where beams are rare: one count, and bits.
const ALIKE: u8 = 8;
const FLAGS: u8 = ABOVE_THE_LAST | HAS_HITS | ALL_TRAVERSED | ALIKE;

impl Occupancy {
    /// Layout version written by this release.
    pub const VERSION: u8 = FORMAT.version;

    /// The stored and transmitted form; equal occupancy has equal bytes.
    ///
    /// Little-endian: the header (its first note is 1 for a model), then per block, in the order of their numbers, a
    /// byte of flags, its number (three varint differences, unless it lies above the last), its traversals (two bits a
    /// word, then the words as written) unless all are set, and its counts: how many, then slot difference and count,
    /// varints; or where all are alike that count and the bits of its voxels. In a drawn model all counts are 255.
    pub fn to_bytes(&self, interrupt: Interrupt) -> Result<Vec<u8>> {
        let blocks = self.sorted(interrupt)?;
        let keys = blocks.iter().map(|(key, _)| *key).collect::<Vec<_>>();
        FORMAT.write([u8::from(self.is_model()), 0], &self.grid, keys.iter().copied(), interrupt, |out| {
            write_blocks(blocks, out, interrupt, |key, last, block, out| match block {
                KnownBlock::Seen(block) => write_seen(key, last, block, out),
                KnownBlock::Drawn(filled) => write_drawn(key, last, filled, out),
            })
        })
    }

    /// The header alone.
    pub fn header(bytes: &[u8]) -> Result<TileHeader> {
        FORMAT.header(bytes)
    }

    /// Reads bytes, foreign ones too.
    pub fn from_bytes(bytes: &[u8], interrupt: Interrupt) -> Result<Self> {
        let (r, header) = FORMAT.read(bytes, interrupt)?;
        let mut out = match header.notes {
            [0, 0] => Self::new(header.grid),
            [1, 0] => Self::of_model(header.grid),
            other => return Err(r.bad(format!("notes {other:?}"))),
        };
        read_blocks(r, &header, interrupt, |r, flags, key| {
            let block = read_block(r, flags)?;
            match &mut out.known {
                KnownTile::Seen(blocks) => blocks.insert(key, block, interrupt),
                KnownTile::Drawn(set) => set.insert_block(key, filled(r, &block)?, interrupt),
            }
        })?;
        Ok(out)
    }
}

fn write_seen(key: [i32; 3], last: [i32; 3], block: &VoxelBlock, out: &mut Vec<u8>) {
    let all = block.traversed == [u64::MAX; 8];
    let hits = block.hits.as_deref().filter(|h| h.iter().any(|&n| n > 0));
    let flag = |set: bool, flag: u8| if set { flag } else { 0 };
    let most = hits.map_or(0, |h| h.iter().copied().max().unwrap_or(0));
    let alike = hits.is_some_and(|h| h.iter().all(|&n| n == 0 || n == most));
    write_key(key, last, flag(hits.is_some(), HAS_HITS) | flag(all, ALL_TRAVERSED) | flag(alike, ALIKE), out);
    if !all {
        write_bits(&block.traversed, out);
    }
    if alike {
        out.push(most);
        write_bits(&block.occupied(1), out);
    } else if let Some(hits) = hits {
        out.put_varint(hits.iter().filter(|&&n| n > 0).count() as u64);
        let mut before = 0;
        for (slot, &count) in hits.iter().enumerate().filter(|(_, n)| **n > 0) {
            out.put_varint((slot - before) as u64);
            out.push(count);
            before = slot;
        }
    }
}

/// A block of a model as one whose voxels hold so many returns, and which no beam passed.
fn write_drawn(key: [i32; 3], last: [i32; 3], filled: &Bits, out: &mut Vec<u8>) {
    let flags = if *filled == [0; 8] { 0 } else { HAS_HITS | ALIKE };
    write_key(key, last, flags, out);
    write_bits(&[0; 8], out);
    if flags != 0 {
        out.push(DRAWN);
        write_bits(filled, out);
    }
}

/// The voxels of a stored block of a model.
fn filled(r: &ByteReader, block: &VoxelBlock) -> Result<Bits> {
    let mut counts = block.hits.iter().flat_map(|hits| hits.iter());
    if block.traversed != [0; 8] || counts.any(|n| ![0, DRAWN].contains(n)) {
        return Err(r.bad("a drawn model with returns or beams that passed"));
    }
    Ok(block.occupied(1))
}

fn read_block(r: &mut ByteReader, flags: u8) -> Result<VoxelBlock> {
    if flags & !FLAGS != 0 {
        return Err(r.bad(format!("flags {flags:#04x} of a block")));
    }
    let traversed = if flags & ALL_TRAVERSED != 0 { [u64::MAX; 8] } else { read_bits(r)? };
    let mut block = VoxelBlock { traversed, hits: None };
    if flags & ALIKE != 0 {
        let (count, bits) = (r.u8()?, read_bits(r)?);
        if flags & HAS_HITS == 0 || count == 0 || bits == [0; 8] {
            return Err(r.bad("counts that are alike, but none"));
        }
        let hits = block.hits.get_or_insert_with(|| Box::new([0; 512]));
        slots(&bits).for_each(|slot| hits[slot] = count);
    } else if flags & HAS_HITS != 0 {
        let mut slot = 0;
        for _ in 0..r.varint()? {
            slot += usize::try_from(r.varint()?).unwrap_or(usize::MAX).min(512);
            let count = r.u8()?;
            if slot >= 512 || count == 0 {
                return Err(r.bad("a count that no voxel has"));
            }
            block.hits.get_or_insert_with(|| Box::new([0; 512]))[slot] = count;
        }
    }
    Ok(block)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxel::lattice::Grid;
    use crate::voxel::lattice::bits::slot_of;
    use crate::voxel::lattice::block_map::{BlockMap, block_of};
    use crate::voxel::model::VoxelSet;
    use crate::{AtOnce, NEVER};
    use proptest::prelude::*;

    fn seen(blocks: BlockMap<VoxelBlock>) -> Occupancy {
        let grid = Grid::new(0.02, Grid::EVERYWHERE, 0.01, 5.0).unwrap();
        Occupancy { known: KnownTile::Seen(blocks), ..Occupancy::new(grid) }
    }

    fn any_occupancy() -> impl Strategy<Value = Occupancy> {
        let voxel = prop::array::uniform3(-40i64..40);
        (prop::collection::vec((voxel, 0u8..3), 0..300), prop::collection::vec(prop::array::uniform3(-4i32..4), 0..20))
            .prop_map(|(voxels, full)| {
                let mut blocks = BlockMap::default();
                for (v, what) in voxels {
                    let block: &mut VoxelBlock = blocks.made(block_of(v), NEVER).unwrap();
                    if what > 0 {
                        block.hit(slot_of(v), 1);
                    }
                    if what < 2 {
                        block.traverse(slot_of(v));
                    }
                }
                for key in full {
                    blocks.insert(key, VoxelBlock { traversed: [u64::MAX; 8], hits: None }, NEVER).unwrap();
                }
                seen(blocks)
            })
    }

    proptest! {
        #[test]
        fn bytes_round_trip(o in any_occupancy()) {
            let bytes = o.to_bytes(NEVER).unwrap();
            let back = Occupancy::from_bytes(&bytes, NEVER).unwrap();
            prop_assert_eq!(&back, &o);
            prop_assert_eq!(back.to_bytes(NEVER).unwrap(), bytes.clone());
            let header = Occupancy::header(&bytes).unwrap();
            prop_assert_eq!(header.blocks as usize, o.sorted(NEVER).unwrap().len());
            let bounds = header.bounds();
            o.for_each(1, NEVER, |v, _, _| assert!(bounds.unwrap().holds(&o.grid().centre(v)))).unwrap();
        }

        #[test]
        fn damage_is_noticed(o in any_occupancy(), at in any::<usize>(), x in 1u8.., cut in 0usize..3) {
            let mut bytes = o.to_bytes(NEVER).unwrap();
            let n = bytes.len();
            bytes[at % n] ^= x;
            bytes.truncate(n - cut);
            prop_assert!(Occupancy::from_bytes(&bytes, NEVER).is_err());
        }

        #[test]
        fn nonsense_under_a_right_checksum(tail in prop::collection::vec(any::<u8>(), 0..300), blocks in 1usize..5) {
            let grid = Grid::new(0.02, Grid::EVERYWHERE, 0.0, 5.0).unwrap();
            let keys = [[i32::MIN; 3], [i32::MAX; 3]].repeat(blocks);
            let bytes = FORMAT.write([0, 0], &grid, keys.iter().copied(), NEVER, |out| {
                out.extend_from_slice(&tail);
                Ok(())
            });
            let _ = Occupancy::from_bytes(&bytes.unwrap(), NEVER);
        }
    }

    /// A model is stored as an occupancy whose voxels hold 255 returns each: what any release reads.
    #[test]
    fn a_model_is_stored_as_returns() {
        let grid = Grid::new(0.02, Grid::EVERYWHERE, 0.01, 5.0).unwrap();
        let (mut set, mut blocks) = (VoxelSet::default(), BlockMap::<VoxelBlock>::default());
        for v in [[0, 0, 0], [1, 0, 0], [-3, 9, 100], [-3, 9, 108]] {
            set.insert(v, NEVER).unwrap();
            blocks.made(block_of(v), NEVER).unwrap().hit(slot_of(v), DRAWN);
        }
        let model = set.into_model(grid, NEVER).unwrap();
        let bytes = model.to_bytes(NEVER).unwrap();
        assert_eq!(Occupancy::from_bytes(&bytes, NEVER).unwrap(), model);
        let as_seen = |notes, blocks: &BlockMap<VoxelBlock>| {
            let o = seen(blocks.clone());
            let sorted = o.sorted(NEVER).unwrap();
            let keys: Vec<_> = sorted.iter().map(|(key, _)| *key).collect();
            FORMAT
                .write(notes, &grid, keys.iter().copied(), NEVER, |out| {
                    write_blocks(sorted, out, NEVER, |key, last, block, out| match block {
                        KnownBlock::Seen(block) => write_seen(key, last, block, out),
                        KnownBlock::Drawn(_) => unreachable!(),
                    })
                })
                .unwrap()
        };
        assert_eq!(as_seen([1, 0], &blocks), bytes);
        blocks.made([0, 0, 0], NEVER).unwrap().traverse(7);
        assert!(Occupancy::from_bytes(&as_seen([0, 0], &blocks), NEVER).is_ok());
        assert!(Occupancy::from_bytes(&as_seen([1, 0], &blocks), NEVER).is_err());
    }

    /// Few bytes can stand for much memory: room is asked for before it is taken.
    #[test]
    fn memory_is_bounded() {
        let full = VoxelBlock { traversed: [u64::MAX; 8], hits: None };
        let mut blocks = BlockMap::default();
        (0..100_000).for_each(|i| blocks.insert([0, 0, i], full.clone(), NEVER).unwrap());
        let o = seen(blocks);
        let bytes = o.to_bytes(NEVER).unwrap();
        assert!(bytes.len() < 100_000 + 4000, "a full block takes a byte: {}", bytes.len());
        assert!(Occupancy::from_bytes(&bytes, &AtOnce(100_000)).is_err());
    }
}
