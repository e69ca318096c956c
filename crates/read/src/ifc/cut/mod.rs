//! The openings of a product, cut and proven: the geometry library is wrong where recesses overlap windows. Every cut
//! is judged; a wrong one is made again by the first method that gives a right one: the grid of the faces' planes, an
//! independent kernel, the library on a copy of the model turned by a generic angle. What cannot be proven is reported.
//!
//! * [`grid`]: boxes cut out of boxes;
//! * [`kernel`], [`clean`]: any closed solids, by another library, and how they are prepared for it;
//! * [`line`]: where a line is inside a mesh;
//! * [`judge`]: whether a cut is right;
//! * [`turned`]: the model in another direction.

mod clean;
mod grid;
mod judge;
mod kernel;
mod line;
mod turned;

use std::sync::OnceLock;
use std::time::{Duration, Instant};

#[cfg(test)]
pub use judge::SplitMix64;
use judge::{Finding, common, judge};

use super::meshing::{Meshed, Meshing, Warm};
use super::soup::Soup;

/// Volumes that differ by less than this are the same.
const SAME_VOLUME: f64 = 3e-4;
/// Number of lines through each opening that prove a cut.
const LINES: usize = 48;
/// Generic angles, degrees: far from the axes, from their diagonals and from each other.
const TURNS: [f64; 3] = [33.71, 61.29, 17.93];

/// A model with its turned copies, which are made when they are needed.
pub struct Cutter {
    upright: Meshing,
    text: &'static [u8],
    radians: Option<f64>,
    turned: [OnceLock<Option<Meshing>>; 3],
}

/// A product with its openings cut, and what it took.
pub struct Cut {
    pub meshed: Meshed,
    /// Time the check took.
    pub check: Duration,
    /// Why its cut is not proven.
    pub unproven: Option<String>,
    /// It was cut again.
    pub mended: bool,
}

impl Cutter {
    pub fn new(upright: Meshing, text: &'static [u8], radians: Option<f64>) -> Self {
        Self { upright, text, radians, turned: Default::default() }
    }

    pub fn mesh(&self, id: u32, warm: &mut Warm) -> Cut {
        let mut cut = self.with_openings(id, warm);
        let is_sound = cut.mended || cut.unproven.is_some() || cut.meshed.soup.triangles.is_empty();
        if !is_sound && self.upright.is_boolean(id, warm) && cut.meshed.soup.is_open() {
            // The library's complaint says the same in its own words.
            cut.meshed.note = cut.meshed.note.filter(|n| !n.starts_with(super::meshing::DIFFICULT));
            cut.unproven = Some(GAPS.into());
        }
        cut
    }

    fn with_openings(&self, id: u32, warm: &mut Warm) -> Cut {
        let mut cut = Cut { meshed: self.upright.mesh(id, warm), check: Duration::ZERO, unproven: None, mended: false };
        if self.upright.openings(id).is_empty() || cut.meshed.soup.triangles.is_empty() {
            return cut;
        }
        let start = Instant::now();
        let (tools, lost) = self.tools(id, warm);
        match self.upright.uncut(id, warm) {
            Some(host) => {
                let tools: Vec<Soup> = tools.into_iter().filter(|tool| reaches(&host, tool)).collect();
                if !tools.is_empty() {
                    self.prove(id, &host, &tools, &mut cut);
                }
            }
            None => cut.unproven = Some(UNJUDGED.into()),
        }
        if !lost.is_empty() {
            cut.unproven = Some(format!("{} has no geometry that can be meshed: it was not cut out", named(&lost)));
        }
        cut.check = start.elapsed();
        cut
    }

    /// Checks the library's cut; where it is wrong, takes the first right one of the other methods.
    fn prove(&self, id: u32, host: &Soup, tools: &[Soup], cut: &mut Cut) {
        let grid = grid::cut(host, tools);
        let is_near = |volume: f64| (cut.meshed.soup.volume() - volume).abs() <= SAME_VOLUME * volume;
        let (finding, exact) = match grid {
            Some(grid) if !is_near(grid.volume) => (Finding::Wrong(0.0), Some(grid.soup)),
            // Their volumes are the same: few lines suffice.
            Some(grid) => (judge(host, tools, &cut.meshed.soup, 4), Some(grid.soup)),
            None => (judge(host, tools, &cut.meshed.soup, LINES), None),
        };
        let off = match finding {
            // Few lines may miss a gap.
            Finding::Right if cut.meshed.soup.is_open() && !host.is_open() => f64::INFINITY,
            Finding::Right => return,
            Finding::Open => return cut.unproven = Some(UNJUDGED.into()),
            Finding::Wrong(off) => off,
        };
        let is_right = |left: &Soup| judge(host, tools, left, LINES) == Finding::Right && !left.is_open();
        // By the openings that it cut, a hair's breadth larger: a line that grazes a face would see much of the hair.
        let is_its_own =
            |(left, cut): &(Soup, Vec<Soup>)| judge(host, cut, left, LINES) == Finding::Right && !left.is_open();
        let by_kernel = |by: &[f64]| kernel::all_ways(host, tools, by).find(is_its_own).map(|(left, _)| left);
        let exact = exact.filter(is_right).or_else(|| by_kernel(&[0.0]));
        // Enlarged ones last: where an opening folds flat upon itself they would cut a slit as wide as they grew.
        let right = exact.or_else(|| self.again(id, is_right)).or_else(|| by_kernel(&kernel::OUTWARDS_M));
        match right {
            Some(mut soup) => {
                soup.take_parts(&cut.meshed.soup);
                let items = std::mem::take(&mut cut.meshed.items);
                let is_gone = soup.triangles.is_empty();
                let note = is_gone.then(|| "nothing is left of it: its openings cut it away entirely".to_owned());
                // What the library found hard about its own cut is past; shapes that it lacks are lacking still.
                let note =
                    note.or_else(|| cut.meshed.note.take().filter(|n| !n.starts_with(super::meshing::DIFFICULT)));
                (cut.meshed, cut.mended) = (Meshed { soup, note, items }, true);
            }
            None => cut.unproven = Some(doubt(off)),
        }
    }

    /// Its openings, and the record numbers of those that are drawn but cannot be meshed.
    fn tools(&self, id: u32, warm: &mut Warm) -> (Vec<Soup>, Vec<u32>) {
        let (mut tools, mut lost) = (Vec::new(), Vec::new());
        for &opening in self.upright.openings(id) {
            match self.upright.uncut(opening, warm) {
                Some(tool) if !tool.triangles.is_empty() => tools.push(tool),
                _ if self.upright.is_drawn(opening, warm) => lost.push(opening),
                _ => {}
            }
        }
        (tools, lost)
    }

    /// The first cut in a turned model that is right.
    fn again(&self, id: u32, is_right: impl Fn(&Soup) -> bool) -> Option<Soup> {
        self.turned.iter().zip(TURNS).find_map(|(cell, turn)| {
            let meshing = cell.get_or_init(|| turned::model(self.text, turn, self.radians)).as_ref()?;
            let mut soup = meshing.mesh(id, &mut Warm::default()).soup;
            turned::back(&mut soup, turn);
            is_right(&soup).then_some(soup)
        })
    }
}

const UNJUDGED: &str = "whether its openings are cut as they are drawn cannot be told: it, or one of them, is no closed \
    solid; look at its openings before you trust them";

const GAPS: &str = "its own cuts (IfcBooleanResult) left it with gaps: do not trust its shape, or repair the model";

fn reaches(host: &Soup, tool: &Soup) -> bool {
    let (low, high) = common(host, tool);
    (0..3).all(|k| high[k] > low[k])
}

fn named(openings: &[u32]) -> String {
    let all: Vec<String> = openings.iter().map(|id| format!("#{id}")).collect();
    format!("opening {}", all.join(", "))
}

fn doubt(off: f64) -> String {
    if off < 1e-3 {
        "its openings could not be cut as they are drawn: skins are left in them; do not trust its openings, or repair \
            the model"
            .into()
    } else if off.is_finite() {
        format!(
            "its openings could not be cut as they are drawn: {off:.3} m too much or too little on a line through \
             them; do not trust its openings, or repair the model"
        )
    } else {
        "its openings could not be cut: what is left has holes; do not trust its openings, or repair the model".into()
    }
}
