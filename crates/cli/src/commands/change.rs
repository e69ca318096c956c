//! `asbuilt change`: what is new, what has gone, and in which object.

use std::path::PathBuf;

use anyhow::{Result, bail};
use asbuilt_core::voxel::Grid;
use postgres::IsolationLevel;

use crate::change::classes::{SurveyArgs, classes};
use crate::change::export;
use crate::change::tally::{ChangeReport, Parts};
use crate::change::tiles::{Comparison, Old, compare};
use crate::database::connect::{Database, DatabaseArgs, explain};
use crate::database::tables;
use crate::output::{Format, LengthUnit, count, say};

#[derive(clap::Args, Debug)]
#[command(after_long_help = "\
Space is cut into voxels. Of an epoch a voxel is occupied (as many returns as the threshold), empty (beams passed) or
unknown. Between epochs it is confirmed (occupied in both), new (empty, then occupied), disappeared (occupied, then
empty), unknown (occupied in one, not seen in the other) or ambiguous (passed in one, with too few returns nearby).
Against the model, new means built but not drawn, disappeared means drawn but seen empty.

Of every object it is said what became of it between two epochs (change): unchanged (as before, or in neither), appeared,
gone, moved (by more than chance and registration; shift says how far, new against old), partly (part of it appeared or
is gone), or not_comparable (too little was seen in both). That comes from where it is drawn, sample by sample, of which
both epochs saw the share seen_in_both; neighbours are known. What nobody drew is a component.

A change counts only if the other epoch has nothing occupied within the tolerance. Voxels of an object are those that
it touches, or that lie within the tolerance of these. Components are what is new or gone as connected things, with
the objects whose boxes they meet. A threshold of 3 wants about three returns a voxel: with sparse scans, take larger
voxels or --threshold 1.

CSV is guarded against spreadsheets: a text that begins with = + - @, a tab or a carriage return gets an apostrophe
before it, numbers never; --format csv-exact writes everything as it is.

Examples:
  asbuilt change --from 1 --to 2
  asbuilt change --from 1 --to 2 --voxel 0.02 --threshold 1 --export change.ply
  asbuilt change --model --to 2 --format json")]
pub struct ChangeArgs {
    /// Older epoch
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        required_unless_present = "model",
        conflicts_with = "model"
    )]
    from: Option<i32>,
    /// Newer epoch
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    to: i32,
    /// Compare the drawn model with the epoch, instead of an older one
    #[arg(long)]
    model: bool,
    /// Edge of a voxel, metres
    #[arg(long, default_value_t = 0.01, value_name = "M", allow_hyphen_values = true)]
    voxel: f64,
    /// Returns from which a voxel is occupied
    #[arg(long, default_value_t = 3, value_name = "N", allow_hyphen_values = true)]
    threshold: i32,
    /// Gap within which something occupied in the other epoch is the same thing, metres; 0 compares voxel by voxel
    /// [default: the margin]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    tolerance: Option<f64>,
    /// A beam says "empty" up to this far before its return, metres: for noise and registration
    #[arg(long, default_value_t = Grid::MARGIN_M, value_name = "M", allow_hyphen_values = true)]
    margin: f64,
    /// A beam without return says "empty" up to this range, metres
    #[arg(long, default_value_t = 0.0, value_name = "M", allow_hyphen_values = true)]
    no_return_range: f64,
    /// Only voxels that a beam itself passes are empty, not those between neighbouring beams
    #[arg(long)]
    exact: bool,
    /// Least voxels of a component
    #[arg(long, default_value_t = 30, value_name = "N", allow_hyphen_values = true)]
    min_voxels: i32,
    /// Voxels with less than this gap hang together, metres [default: four voxels]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    gap: Option<f64>,
    /// Edge of the tiles that are compared one after the other, metres [default: 800 voxels]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    tile: Option<f64>,
    /// Write the voxels as a coloured point cloud: .ply, .las or .laz (green confirmed, yellow new, red disappeared,
    /// blue unknown, grey ambiguous)
    #[arg(long, value_name = "FILE")]
    export: Option<PathBuf>,
    /// Unit of shifts [default: mm in tables, m in CSV and JSON]
    #[arg(long, value_enum, value_name = "UNIT")]
    units: Option<LengthUnit>,
    /// How to print; CSV has the objects alone
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    survey: SurveyArgs,
    #[command(flatten)]
    database: DatabaseArgs,
}

pub fn run(args: &ChangeArgs) -> Result<()> {
    if let Some(path) = &args.export {
        export::check(path)?;
    }
    let comparison = comparison(args)?;
    let Ok(least) = u64::try_from(args.min_voxels) else { bail!("--min-voxels {} must be 0 or more", args.min_voxels) };
    let mut db = args.database.connect()?;
    check_epochs(&mut db, args)?;
    // All tiles see the same data, and nothing is written: a hot standby answers too.
    let one_view = db.client.build_transaction().read_only(true).isolation_level(IsolationLevel::RepeatableRead);
    let mut tx = one_view.start().map_err(explain)?;
    let tiles = compare(&mut tx, &db.names, &comparison)?;
    let mut report =
        ChangeReport::of(&mut tx, &db.names, &tiles, comparison.tolerance(), &Parts { least, gap: args.gap })?;
    if let Some(from) = args.from {
        report.classify(classes(&mut tx, &db.names, &args.survey, [from, args.to])?);
    }
    tx.rollback().map_err(explain)?;
    if let Some(path) = &args.export {
        say!("{}: {} voxels", path.display(), count(export::write(&tiles, report.total.iter().sum(), path)?));
    }
    report.print(args.format, LengthUnit::or_default(args.units, args.format))
}

fn comparison(args: &ChangeArgs) -> Result<Comparison> {
    // What the server would refuse tile by tile is refused at once.
    Grid::new(args.voxel, Grid::EVERYWHERE, args.margin, args.no_return_range)?;
    let tile = args.tile.unwrap_or(800.0 * args.voxel);
    if !(tile >= args.voxel && tile.is_finite()) {
        bail!("the tile must be at least a voxel, {} m, not {tile}", args.voxel);
    }
    Ok(Comparison {
        old: args.from.map_or(Old::Model, Old::Epoch),
        new: args.to,
        voxel: args.voxel,
        threshold: args.threshold,
        tolerance: args.tolerance,
        margin: args.margin,
        no_return_range: args.no_return_range,
        exact: args.exact,
        // Tiles end between voxels, not in them.
        tile: (tile / args.voxel).round() * args.voxel,
    })
}

fn check_epochs(db: &mut Database, args: &ChangeArgs) -> Result<()> {
    tables::check_loaded(db)?;
    for epoch in args.from.iter().chain([&args.to]) {
        tables::check_epoch(db, *epoch)?;
    }
    if args.model {
        let drawn = db.sql("SELECT EXISTS (SELECT FROM @building_object WHERE solid IS NOT NULL)");
        if !db.client.query_one(&drawn, &[]).map_err(explain)?.get::<_, bool>(0) {
            bail!("there is no model to compare with; load one: asbuilt load MODEL.ifc");
        }
    }
    Ok(())
}
