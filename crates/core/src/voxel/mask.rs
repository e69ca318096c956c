//! A solid drawn in voxels: those inside, layer by layer of columns along x.

use super::block::{Block, EDGE};
use std::cmp::Ordering;

use super::blocks::{Around, Bits, BlockMap, block_of, has, put, slots};
use super::grid::{Grid, Span};
use super::occupancy::Occupancy;
use super::surface::for_each_on_surface;
use crate::error::{Error, Result};
use crate::geometry::{Closedness, Solid, Vec3};
use crate::num::sort::sort;
use crate::{Grow, Interrupt, poll, poll_now_and_then};

/// Attempts at a column that hits a seam of the mesh, each a little aside.
const ATTEMPTS: u32 = 8;

/// Which voxels a solid fills.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    /// Those whose centre lies inside; a closed solid.
    Centre,
    /// Those that it touches at all; a closed solid.
    Cover,
    /// Those that its surface passes through; open surfaces too.
    Surface,
}

impl Rule {
    /// Reads `centre`, `cover`, `surface`.
    pub fn parse(text: &str) -> Result<Self> {
        match text {
            "centre" => Ok(Self::Centre),
            "cover" => Ok(Self::Cover),
            "surface" => Ok(Self::Surface),
            _ => Err(Error::argument("the rule", "centre, cover or surface", text)),
        }
    }
}

/// A set of voxels.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mask {
    pub(super) blocks: BlockMap<Bits>,
}

impl Mask {
    /// The voxels of a grid's tile that a solid fills.
    pub fn of(solid: &Solid, grid: &Grid, rule: Rule, interrupt: Interrupt) -> Result<Self> {
        if rule != Rule::Surface && solid.closedness() == Closedness::Open {
            return Err(Error::OpenSurface);
        }
        let mut out = Self::default();
        let bounds = solid.bounds();
        let (low, high) = (grid.index(&bounds.min.into())?, grid.index(&bounds.max.into())?);
        let span = grid.span().common(&Span([0, 1, 2].map(|i| [low[i], high[i] + 1])));
        if span.is_empty() {
            return Ok(out);
        }
        let local = Local::new(solid, grid, low);
        if rule != Rule::Surface {
            out.fill(&local, &span, interrupt)?;
        }
        if rule != Rule::Centre {
            for t in 0..solid.triangles().len() {
                poll(interrupt)?;
                let within = Span([0, 1, 2].map(|i| span.0[i].map(|v| v - low[i])));
                for_each_on_surface(&local.corners(t), &within, interrupt, |v| {
                    out.insert([0, 1, 2].map(|i| v[i] + low[i]), interrupt)
                })?;
            }
        }
        Ok(out)
    }

    /// Whether a voxel belongs to it.
    pub fn holds(&self, voxel: [i64; 3]) -> bool {
        let slot = Block::slot(voxel);
        self.blocks.get(&block_of(voxel)).is_some_and(|bits| has(bits, slot))
    }

    /// Number of its voxels in a box of voxels.
    pub fn len_within(&self, span: &Span) -> u64 {
        let inside = |(key, bits): (&[i32; 3], &Bits)| {
            let span = span.of_block(*key);
            (0..8).map(|word| u64::from((bits[word] & span[word]).count_ones())).sum::<u64>()
        };
        self.blocks.iter().map(inside).sum()
    }

    /// Number of voxels.
    pub fn len(&self) -> u64 {
        self.blocks.values().flatten().map(|w| u64::from(w.count_ones())).sum()
    }

    /// Whether it holds no voxel.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The voxels of a block that belong to it or lie within `gap` metres of one that does.
    pub(super) fn near(&self, key: [i32; 3], among: &Bits, steps: &[[i64; 3]]) -> Bits {
        let own = self.blocks.get(&key).copied().unwrap_or_default();
        let around = Around::new(&self.blocks, key);
        let mut out: Bits = std::array::from_fn(|word| own[word] & among[word]);
        for slot in slots(&std::array::from_fn(|word| among[word] & !own[word])) {
            if steps.iter().any(|&step| around.has(slot, step)) {
                put(&mut out, slot);
            }
        }
        out
    }

    /// First and last block on every axis, with their neighbours; the first behind the last for none.
    pub(super) fn reach(&self) -> [[i32; 2]; 3] {
        let none = [[i32::MAX, i32::MIN]; 3];
        self.blocks.keys().fold(none, |reach, key| {
            std::array::from_fn(|i| {
                [reach[i][0].min(key[i].saturating_sub(1)), reach[i][1].max(key[i].saturating_add(1))]
            })
        })
    }

    /// As an occupancy of which everything is known.
    pub fn into_model(self, grid: Grid, interrupt: Interrupt) -> Result<Occupancy> {
        let mut out = Occupancy::of_model(grid);
        for (round, (key, bits)) in self.blocks.into_iter().enumerate() {
            poll_now_and_then(round, interrupt)?;
            let mut hits = Box::new([0u8; 512]);
            slots(&bits).for_each(|slot| hits[slot] = u8::MAX);
            out.insert(key, Block { traversed: [0; 8], hits: Some(hits) }, interrupt)?;
        }
        Ok(out)
    }

    fn insert(&mut self, voxel: [i64; 3], interrupt: Interrupt) -> Result<()> {
        put(self.block(voxel, interrupt)?, Block::slot(voxel));
        Ok(())
    }

    /// The block of a voxel, made where it is missing.
    fn block(&mut self, voxel: [i64; 3], interrupt: Interrupt) -> Result<&mut Bits> {
        self.blocks.grow(1, interrupt)?;
        Ok(self.blocks.entry(block_of(voxel)).or_default())
    }

    /// Voxels whose centre lies inside, eight layers at a time.
    fn fill(&mut self, local: &Local, span: &Span, interrupt: Interrupt) -> Result<()> {
        let [_, _, [first, end]] = span.0;
        let mut z = first;
        while z < end {
            let above = (z.div_euclid(EDGE) + 1) * EDGE;
            let layers = [z, above.min(end)];
            let crossings = local.crossings(layers, span.0[1], 0.0, interrupt)?;
            for (round, column) in crossings.chunk_by(|a, b| a.column == b.column).enumerate() {
                poll_now_and_then(round, interrupt)?;
                match runs(column) {
                    Some(runs) => self.set_runs(&runs, column[0].column, local, span, interrupt)?,
                    None => self.fill_seam(column[0].column, local, span, interrupt)?,
                }
            }
            z = above;
        }
        Ok(())
    }

    /// A column whose crossings do not add up: it passes through a seam of the mesh. A little aside it does not.
    fn fill_seam(&mut self, column: [i64; 2], local: &Local, span: &Span, interrupt: Interrupt) -> Result<()> {
        for attempt in 1..=ATTEMPTS {
            let aside = 1e-7 * f64::from(attempt * attempt);
            let [z, y] = column;
            let crossings = local.crossings([z, z + 1], [y, y + 1], aside, interrupt)?;
            if let Some(runs) = runs(&crossings) {
                return self.set_runs(&runs, column, local, span, interrupt);
            }
        }
        let reason =
            "its mesh has a gap that a column of voxels passes through; the rule 'surface' needs no inside".into();
        Err(Error::Degenerate { what: "the inside of the solid", reason })
    }

    /// Sets the voxels of a column whose centres lie between two crossings, in voxels from `low`.
    fn set_runs(
        &mut self,
        runs: &[[f64; 2]],
        [z, y]: [i64; 2],
        local: &Local,
        span: &Span,
        interrupt: Interrupt,
    ) -> Result<()> {
        for [from, to] in runs {
            let number = |x: f64| (x - 0.5).ceil().clamp(-1e10, 1e10) as i64 + local.low[0];
            let (first, end) = (number(*from).max(span.0[0][0]), number(*to).min(span.0[0][1]));
            let mut x = first;
            while x < end {
                poll_now_and_then((x.div_euclid(EDGE) & 1023) as usize, interrupt)?;
                let stop = ((x.div_euclid(EDGE) + 1) * EDGE).min(end);
                let slot = Block::slot([x, y, z]);
                let bits = (u64::MAX >> (64 - (stop - x))) << (slot % 64);
                self.block([x, y, z], interrupt)?[slot / 64] |= bits;
                x = stop;
            }
        }
        Ok(())
    }
}

/// Where a column along x passes through the mesh.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    /// Numbers of its voxels along z and y.
    column: [i64; 2],
    x: f64,
    /// +1 into the solid, -1 out of it.
    winding: i32,
}

impl Crossing {
    fn place(&self) -> ([i64; 2], f64, i32) {
        (self.column, self.x, self.winding)
    }
}

impl PartialEq for Crossing {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Crossing {}

impl PartialOrd for Crossing {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Crossing {
    /// By column, then along it.
    fn cmp(&self, other: &Self) -> Ordering {
        let ((a, x, v), (b, y, w)) = (self.place(), other.place());
        a.cmp(&b).then(x.total_cmp(&y)).then(v.cmp(&w))
    }
}

/// The parts of a column inside the mesh, by winding number; `None` where the crossings do not add up to 0.
fn runs(crossings: &[Crossing]) -> Option<Vec<[f64; 2]>> {
    let (mut winding, mut from, mut out) = (0, 0.0, Vec::new());
    for c in crossings {
        let before = winding;
        winding += c.winding;
        match (before, winding) {
            (0, _) => from = c.x,
            (_, 0) => out.push([from, c.x]),
            _ => {}
        }
    }
    (winding == 0).then_some(out)
}

/// The columns along x of one layer.
struct Columns {
    layer: i64,
    /// Its height, in voxels from `low`.
    z: f64,
    /// Numbers of the first, and of the one behind the last.
    y: [i64; 2],
    /// How far off their centres, in voxels.
    aside: f64,
}

/// A solid in voxels, counted from one of its own.
struct Local<'a> {
    solid: &'a Solid,
    vertices: Vec<Vec3>,
    low: [i64; 3],
}

impl<'a> Local<'a> {
    fn new(solid: &'a Solid, grid: &Grid, low: [i64; 3]) -> Self {
        let at = |v: &Vec3| Vec3::from_fn(|i, _| v[i] / grid.voxel - low[i] as f64);
        Self { solid, vertices: solid.vertices().iter().map(at).collect(), low }
    }

    fn corners(&self, t: usize) -> [Vec3; 3] {
        self.solid.triangles()[t].map(|i| self.vertices[i as usize])
    }

    /// The crossings of columns `y` in layers `z`, sorted by column and then along it. Edges are half-open and each is
    /// evaluated alike for both its triangles, so that a closed mesh is crossed an even number of times; `aside` moves
    /// the columns off their centres.
    fn crossings(&self, z: [i64; 2], y: [i64; 2], aside: f64, interrupt: Interrupt) -> Result<Vec<Crossing>> {
        let mut out = Vec::new();
        for t in 0..self.solid.triangles().len() {
            poll_now_and_then(t, interrupt)?;
            let corners = self.corners(t);
            let [low, high] = extent(&corners, 2);
            let first = ((low - 1.0).floor().clamp(-1e10, 1e10) as i64 + self.low[2]).max(z[0]);
            let last = ((high + 1.0).ceil().clamp(-1e10, 1e10) as i64 + self.low[2]).min(z[1] - 1);
            for layer in first..=last {
                let at_z = (layer - self.low[2]) as f64 + 0.5 + 0.618 * aside;
                poll(interrupt)?;
                self.cross_layer(&corners, &Columns { layer, z: at_z, y, aside }, &mut out, interrupt)?;
            }
        }
        sort(&mut out, interrupt)?;
        Ok(out)
    }

    /// The columns of one layer that a triangle crosses.
    fn cross_layer(
        &self,
        c: &[Vec3; 3],
        columns: &Columns,
        out: &mut Vec<Crossing>,
        interrupt: Interrupt,
    ) -> Result<()> {
        let &Columns { layer, z, y, aside } = columns;
        let mut ends: [Option<(f64, i32)>; 3] = [None; 3];
        for (i, end) in ends.iter_mut().enumerate() {
            let (p, q) = (&c[i], &c[(i + 1) % 3]);
            if (p[2] <= z) != (q[2] <= z) {
                // From its lower end, whichever triangle asks.
                let (a, b) = if p[2] < q[2] { (p, q) } else { (q, p) };
                *end = Some((a[1] + (z - a[2]) / (b[2] - a[2]) * (b[1] - a[1]), if p[2] < q[2] { 1 } else { -1 }));
            }
        }
        let mut ends = ends.into_iter().flatten();
        let (Some(a), Some(b)) = (ends.next(), ends.next()) else { return Ok(()) };
        let ((left, winding), (right, _)) = if a.0 <= b.0 { (a, b) } else { (b, a) };
        let number = |at: f64| (at - 0.5 - aside).ceil().clamp(-1e10, 1e10) as i64 + self.low[1];
        let normal = (c[1] - c[0]).cross(&(c[2] - c[0]));
        let [x_low, x_high] = extent(c, 0);
        for row in number(left).max(y[0])..number(right).min(y[1]) {
            let at_y = (row - self.low[1]) as f64 + 0.5 + aside;
            let x = c[0][0] - (normal[1] * (at_y - c[0][1]) + normal[2] * (z - c[0][2])) / normal[0];
            let x = if x.is_finite() { x.clamp(x_low, x_high) } else { x_low };
            out.grow(1, interrupt)?;
            out.push(Crossing { column: [layer, row], x, winding });
        }
        Ok(())
    }
}

fn extent(corners: &[Vec3; 3], axis: usize) -> [f64; 2] {
    corners.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], c| [a.min(c[axis]), b.max(c[axis])])
}
