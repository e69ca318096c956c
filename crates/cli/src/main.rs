//! `asbuilt`: load models and laser scans into PostgreSQL, verify, compare epochs, simulate.
//!
//! * [`commands`]: what the user calls, one file each;
//! * `asbuilt_read`, a crate of its own: file formats, each read by a child process under a budget of memory;
//! * [`database`]: connection, tables, COPY;
//! * [`change`]: two epochs compared in voxels;
//! * [`frames`]: whether model and scans lie on each other;
//! * [`forecast`]: what a planned survey would prove;
//! * [`output`]: tables, CSV, JSON, progress.

mod change;
mod commands;
mod database;
mod forecast;
mod frames;
mod output;

use clap::{Parser, Subcommand};
use output::{say, say_error};

#[derive(Parser)]
#[command(
    name = "asbuilt",
    version,
    about = "Is the building what the model says?",
    long_about = "\
Is the building what the model says?

Load a building model (IFC) and laser scans with scanner positions into PostgreSQL, then ask for a verdict on every
building object: confirmed, deviating, absent, unobserved or conflicting, with the numbers that led to it.

The database is the one psql would reach: PGHOST, PGPORT, PGUSER, PGPASSWORD, PGDATABASE, or --db URL.

Example:
  asbuilt load model.ifc
  asbuilt load station1.e57 station2.e57 --epoch 2
  asbuilt verify --epoch 2 --loa LOA30
  asbuilt change --from 1 --to 2"
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Load models and scans into the database, making its tables if they are missing
    Load(commands::load::LoadArgs),
    /// What files hold and how they would be read, without a database
    Inspect(commands::inspect::InspectArgs),
    /// A verdict on every building object
    Verify(commands::verify::VerifyArgs),
    /// Why the verdict on an object is what it is
    Explain(commands::explain::ExplainArgs),
    /// What is new, what has gone, and in which object
    Change(commands::change::ChangeArgs),
    /// What a planned survey would prove, and where one more station helps most
    Forecast(commands::forecast::ForecastArgs),
    /// Simulate a laser scan of a model, with what was built otherwise
    Simulate(commands::simulate::SimulateArgs),
    /// What is loaded: models, scans by epoch, stations
    List(commands::list::ListArgs),
    /// Remove an epoch, a file or a station
    Remove(commands::remove::RemoveArgs),
    /// Mesh an IFC file and write the products to standard output (the loader's child process)
    #[command(hide = true)]
    MeshIfc(commands::mesh_ifc::MeshIfcArgs),
    /// Read a file of scans and write packed patches to standard output (the loader's child process)
    #[command(hide = true)]
    ReadScan(asbuilt_read::child::Job),
}

fn main() {
    let result = match arguments().command {
        Command::Load(args) => commands::load::run(&args),
        Command::Inspect(args) => commands::inspect::run(&args),
        Command::Verify(args) => commands::verify::run(&args),
        Command::Explain(args) => commands::explain::run(&args),
        Command::List(args) => commands::list::run(&args),
        Command::Remove(args) => commands::remove::run(&args),
        Command::Change(args) => commands::change::run(&args),
        Command::Forecast(args) => commands::forecast::run(&args),
        Command::Simulate(args) => commands::simulate::run(&args),
        Command::MeshIfc(args) => commands::mesh_ifc::run(&args),
        Command::ReadScan(job) => commands::read_scan::run(&job),
    };
    if let Err(error) = result {
        say_error("asbuilt", &error);
        std::process::exit(1);
    }
}

/// Parses the command line. Errors quote it, so they are made safe: it may hold hostile file names or a URL with a
/// password.
fn arguments() -> Cli {
    Cli::try_parse().unwrap_or_else(|error| {
        if !error.use_stderr() {
            error.exit();
        }
        error.render().to_string().lines().for_each(|line| say!("{line}"));
        std::process::exit(2);
    })
}
