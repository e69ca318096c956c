//! The openings of a product, cut and proven: the geometry library takes shortcuts that are wrong for some walls
//! nearly parallel to an axis. Every cut is judged; one that is wrong is made again in a copy of the model turned by
//! a generic angle, where no shortcut applies, and judged again; what cannot be proven is said.
//!
//! * [`line`]: where a line is inside a mesh;
//! * [`judge`]: whether a cut is right;
//! * [`turned`]: the model in another direction.

mod judge;
mod line;
mod turned;

use std::sync::OnceLock;
use std::time::{Duration, Instant};

use judge::{Finding, common, judge};

use super::meshing::{Meshed, Meshing, Warm};
use super::soup::Soup;

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
    /// It was cut once more.
    pub mended: bool,
}

impl Cutter {
    pub fn new(upright: Meshing, text: &'static [u8], radians: Option<f64>) -> Self {
        Self { upright, text, radians, turned: Default::default() }
    }

    pub fn mesh(&self, id: u32, warm: &mut Warm) -> Cut {
        let mut cut = Cut { meshed: self.upright.mesh(id, warm), check: Duration::ZERO, unproven: None, mended: false };
        let start = Instant::now();
        if self.upright.openings(id).is_empty() || cut.meshed.soup.triangles.is_empty() {
            return cut;
        }
        let Some((host, tools)) = self.operands(id, warm) else { return cut };
        if !tools.is_empty() {
            let finding = judge(&host, &tools, &cut.meshed.soup, u64::from(id));
            if let Finding::Wrong(off) = finding {
                match self.again(id, &host, &tools) {
                    Some(meshed) => (cut.meshed, cut.mended) = (meshed, true),
                    None => cut.unproven = Some(doubt(off)),
                }
            }
        }
        cut.check = start.elapsed();
        cut
    }

    /// The product uncut, and those of its openings that reach it.
    fn operands(&self, id: u32, warm: &mut Warm) -> Option<(Soup, Vec<Soup>)> {
        let host = self.upright.uncut(id, warm)?;
        let tools = self.upright.openings(id).iter().filter_map(|&opening| self.upright.uncut(opening, warm));
        let reaches = |tool: &Soup| {
            let (low, high) = common(&host, tool);
            (0..3).all(|k| high[k] > low[k])
        };
        let tools = tools.filter(reaches).collect();
        Some((host, tools))
    }

    /// The first cut in a turned model that is right.
    fn again(&self, id: u32, host: &Soup, tools: &[Soup]) -> Option<Meshed> {
        self.turned.iter().zip(TURNS).find_map(|(cell, turn)| {
            let meshing = cell.get_or_init(|| turned::model(self.text, turn, self.radians)).as_ref()?;
            let mut meshed = meshing.mesh(id, &mut Warm::default());
            turned::back(&mut meshed.soup, turn);
            (judge(host, tools, &meshed.soup, u64::from(id)) == Finding::Right).then_some(meshed)
        })
    }
}

fn doubt(off: f64) -> String {
    if off.is_finite() {
        format!(
            "its openings could not be cut as they are drawn: {off:.3} m too much or too little on a line through \
             them; do not trust its openings, or repair the model"
        )
    } else {
        "its openings could not be cut: what is left has holes; do not trust its openings, or repair the model".into()
    }
}
