//! `ab_scan_agg`: patches from rows of returns.

use asbuilt_core::geometry::Vec3;
use asbuilt_core::scan::{Beam, Patch, mean_step, tiles};
use asbuilt_core::{Error, Result};

use crate::pg::{AggState, Args, Ret, aggregate_state, deserialised_state, interrupt, sql_functions};

/// Returns of one aggregate: they are in memory, 24 bytes each.
const MAX_RETURNS: usize = 20_000_000;

/// The returns of one station, relative to its origin.
#[derive(Default)]
struct State {
    station: i64,
    origin: Option<Vec3>,
    offsets: Vec<Vec3>,
}

impl State {
    /// The origin and station of all rows, or the error that they are several.
    fn agree(&mut self, origin: Vec3, station: i64) -> Result<()> {
        match self.origin {
            None => (self.origin, self.station) = (Some(origin), station),
            Some(o) if o == origin && self.station == station => {}
            Some(_) => {
                let expected = "the same for all rows of a group";
                return Err(Error::argument("origin and station of ab_scan_agg", expected, "several"));
            }
        }
        Ok(())
    }

    fn check_size(&self) -> Result<()> {
        if self.offsets.len() <= MAX_RETURNS {
            return Ok(());
        }
        let (value, limit) = (self.offsets.len().to_string(), MAX_RETURNS.to_string());
        Err(Error::Limit { what: "the number of returns of one ab_scan_agg", value, limit })
    }

    /// Packed tiles of neighbours.
    fn patches(&self) -> Result<Vec<Vec<u8>>> {
        let Some(origin) = self.origin else { return Ok(Vec::new()) };
        let beams: Vec<Beam> = self.offsets.iter().map(|&offset| Beam { offset, returned: true }).collect();
        let mut out = Vec::new();
        for tile in tiles(&beams) {
            interrupt();
            let own: Vec<Beam> = tile.iter().map(|&i| beams[i as usize]).collect();
            out.push(Patch::encode(self.station, origin, mean_step(&own), Patch::QUANTUM_M, &own)?.to_bytes());
        }
        Ok(out)
    }
}

fn state(args: &Args, i: usize) -> Result<AggState<State>> {
    aggregate_state(args, i, || Ok(State::default()))
}

sql_functions! {
    /// transition(state, x, y, z, origin, station): a row with a NULL adds nothing.
    fn ab_scan_accum(args) {
        let mut state = state(args, 0)?;
        if (1..args.len()).any(|i| args.is_null(i)) {
            return Ok(state.ret());
        }
        let own = state.get();
        let origin = Vec3::from(args.vector::<3>(4, "the origin")?);
        own.agree(origin, args.i64(5))?;
        let point = Vec3::new(args.f64(1), args.f64(2), args.f64(3));
        if let Some(c) = point.iter().chain(origin.iter()).find(|c| !(-1e9..=1e9).contains(*c)) {
            return Err(Error::argument("a scan coordinate", "finite and within 1e9 m", c));
        }
        own.offsets.push(point - origin);
        own.check_size()?;
        Ok(state.ret())
    }

    fn ab_scan_combine(args) {
        let mut left = state(args, 0)?;
        if !args.is_null(1) {
            let mut right = state(args, 1)?;
            if let Some(origin) = right.get().origin {
                left.get().agree(origin, right.get().station)?;
            }
            left.get().offsets.extend_from_slice(&right.get().offsets);
            left.get().check_size()?;
        }
        Ok(left.ret())
    }

    fn ab_scan_serial(args) {
        let mut state = state(args, 0)?;
        let own = state.get();
        let mut out = own.station.to_ne_bytes().to_vec();
        let all = own.origin.iter().chain(&own.offsets).flat_map(|v| v.iter());
        all.for_each(|c| out.extend_from_slice(&c.to_ne_bytes()));
        Ok(Ret::Bytes(out))
    }

    fn ab_scan_deserial(args) {
        let bad = || Error::binary("the state of ab_scan_agg", "it is cut short");
        let (station, rest) = args.bytes(0).split_first_chunk::<8>().ok_or_else(bad)?;
        let (vectors, rest) = rest.as_chunks::<24>();
        if !rest.is_empty() {
            return Err(bad());
        }
        let vector = |b: &[u8; 24]| Vec3::from_fn(|i, _| f64::from_ne_bytes(std::array::from_fn(|k| b[8 * i + k])));
        let (origin, offsets) = vectors.split_first().map_or((None, &[][..]), |(o, rest)| (Some(vector(o)), rest));
        let station = i64::from_ne_bytes(*station);
        Ok(deserialised_state(State { station, origin, offsets: offsets.iter().map(vector).collect() }).ret())
    }

    fn ab_scan_final(args) {
        if args.is_null(0) {
            return Ok(Ret::Null);
        }
        Ok(Ret::VarlenaArray(state(args, 0)?.get().patches()?))
    }
}
