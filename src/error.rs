//! The one map from core's errors to SQLSTATE, message and hint.

use asbuilt_core::Error;
use asbuilt_core::error::{LatticeMismatch, Limited, MemoryOf, Mismatch};
use pgrx::pg_sys::errcodes::PgSqlErrorCode as Code;
use pgrx::pg_sys::panic::ErrorReport;

/// SQLSTATE of each of core's errors.
fn code(error: &Error) -> Code {
    match error {
        Error::Argument { .. }
        | Error::Empty { .. }
        | Error::Mismatch(_)
        | Error::Lattice(_)
        | Error::Covariance { .. } => Code::ERRCODE_INVALID_PARAMETER_VALUE,
        Error::TriangleIndex { .. } | Error::PartNumber { .. } => Code::ERRCODE_ARRAY_ELEMENT_ERROR,
        Error::OpenSurface | Error::TotalConflict | Error::Degenerate { .. } => Code::ERRCODE_DATA_EXCEPTION,
        Error::Syntax { .. } => Code::ERRCODE_INVALID_TEXT_REPRESENTATION,
        Error::Binary { .. } => Code::ERRCODE_INVALID_BINARY_REPRESENTATION,
        Error::Corrupted { .. } => Code::ERRCODE_DATA_CORRUPTED,
        Error::Version { .. } | Error::Section { .. } => Code::ERRCODE_FEATURE_NOT_SUPPORTED,
        Error::Limit { .. } => Code::ERRCODE_PROGRAM_LIMIT_EXCEEDED,
        Error::Memory { .. } | Error::OutOfMemory { .. } => Code::ERRCODE_OUT_OF_MEMORY,
        Error::Interrupted => Code::ERRCODE_QUERY_CANCELED,
    }
}

/// The way out, where there is one to name.
fn hint(error: &Error) -> Option<String> {
    Some(match error {
        Error::TriangleIndex { vertices, .. } => {
            format!("Vertex indices count from 0; the last one here is {}.", vertices.saturating_sub(1))
        }
        Error::PartNumber { .. } => {
            "Parts count from 0; give transparent, movable and name an element for each of them.".into()
        }
        Error::OpenSurface => {
            "Ask ab_closedness(solid) first; area, box and verdicts work on open surfaces too.".into()
        }
        Error::Version { .. } | Error::Section { .. } => {
            "Install the newer release: ALTER EXTENSION asbuilt UPDATE.".into()
        }
        Error::Covariance { .. } => {
            "A covariance is symmetric and has no negative eigenvalue; repair it, or give sd for a diagonal one.".into()
        }
        Error::TotalConflict => {
            "Discount the sources by their reliability (a mass below 1) before they are combined.".into()
        }
        Error::Corrupted { .. } => "Restore the value from a backup or load the scan again.".into(),
        Error::OutOfMemory { .. } => "Give it fewer rows at a time, or the server more memory.".into(),
        Error::Mismatch(mismatch) => of_mismatch(mismatch)?.into(),
        Error::Lattice(mismatch) => of_lattice(mismatch).into(),
        Error::Limit { what, .. } => of_limit(*what)?.into(),
        Error::Memory { what, at_ceiling, .. } => of_memory(*what, *at_ceiling).into(),
        Error::Argument { .. }
        | Error::Empty { .. }
        | Error::Syntax { .. }
        | Error::Binary { .. }
        | Error::Degenerate { .. }
        | Error::Interrupted => return None,
    })
}

fn of_mismatch(mismatch: &Mismatch) -> Option<&'static str> {
    match mismatch {
        Mismatch::GroupOfSolids | Mismatch::GroupOfModels => {
            Some("GROUP BY the object, so that every group holds one solid and one model.")
        }
        Mismatch::Solids | Mismatch::Models(_) | Mismatch::Samples => {
            Some("Roll up only evidence of the same solid, made with the same ab_evidence_model().")
        }
        Mismatch::PatchesAfterMerge => None,
    }
}

fn of_lattice(mismatch: &LatticeMismatch) -> &'static str {
    match mismatch {
        LatticeMismatch::SharedVoxels => "Cut them first: ab_clip(change, tile).",
        LatticeMismatch::ChangeSettings => "Compare all tiles with the same threshold and tolerance.",
        LatticeMismatch::CutVoxels { .. } => "Give the tile borders that are multiples of the larger voxel.",
        LatticeMismatch::DrawnAndSeen => {
            "Models add up to models and epochs to epochs; ab_change(model, epoch) compares them."
        }
        LatticeMismatch::TilesApart(..) => "Roll up tiles that touch or overlap, neighbour by neighbour.",
        LatticeMismatch::VoxelSize(..) | LatticeMismatch::Rules(..) | LatticeMismatch::GroupOfGrids(..) => {
            "Aggregate both with the same ab_grid(); ab_downsample(occupancy) doubles the voxels of the finer one."
        }
    }
}

fn of_limit(what: Limited) -> Option<&'static str> {
    match what {
        Limited::Offset => Some("Use a coarser quantum, or give coordinates nearer the scanner."),
        Limited::UnionBeams => Some("Join fewer patches; ab_retile(patches) cuts many into tiles of neighbours."),
        Limited::ConeAngle | Limited::PatchBeams => {
            Some("Cut the beams into angular tiles first, as `asbuilt load` does.")
        }
        Limited::GroupReturns => Some("Group the returns by station, or by station and area: a group is in memory."),
        Limited::VoxelIndex => Some("Use larger voxels, or bring the coordinates nearer to zero."),
        Limited::Slice => Some("Cut the occupancy first: ab_clip(occupancy, box)."),
        Limited::Tiles => Some("Use larger tiles, or a smaller area."),
        Limited::Parts => Some("Give triangles that share their flags the same number."),
        Limited::PartName => Some("Give it a shorter name: left(name, 100)."),
        Limited::Evidence => Some("Put the samples farther apart (spacing), or split the solid."),
        Limited::FitPoints => Some("Fit to a sample of the points: WHERE random() < 0.1."),
        Limited::StoredForm | Limited::TextForm | Limited::TextArgument | Limited::Triangles => None,
    }
}

fn of_memory(what: MemoryOf, at_ceiling: bool) -> &'static str {
    match what {
        _ if at_ceiling => "asbuilt.memory_ceiling is the limit, a superuser's to raise; or ask for less at a time.",
        MemoryOf::Grids => {
            "Aggregate tile by tile: FROM ab_tiles(box, size) t JOIN scan ON patch && t; or use larger voxels, or raise \
            asbuilt.max_grid_memory."
        }
        MemoryOf::Evidence | MemoryOf::Session => {
            "Verify storey by storey, or with samples farther apart (spacing), or raise asbuilt.max_evidence_memory."
        }
    }
}

/// Whose fault unreadable bytes are: those given to an input function are the client's, others were stored by this
/// database.
fn seen_by(error: &Error, function: &str) -> (Error, Code) {
    let (ty, reason) = match error {
        Error::Binary { ty, reason } | Error::Corrupted { ty, reason } => (*ty, reason.clone()),
        other => return (other.clone(), code(other)),
    };
    if function.ends_with("_in") {
        return (Error::Binary { ty, reason }, Code::ERRCODE_INVALID_TEXT_REPRESENTATION);
    }
    // A geometry's bytes come from PostGIS, or from whoever gave them.
    let foreign = function.ends_with("_recv") || ty == "geometry";
    let error = if foreign { Error::Binary { ty, reason } } else { Error::Corrupted { ty, reason } };
    let code = code(&error);
    (error, code)
}

/// The PostgreSQL report of an error that occurred in SQL function `function`.
pub fn report(error: &Error, function: &'static str) -> ErrorReport {
    let (error, code) = seen_by(error, function);
    let report = ErrorReport::new(code, error.to_string(), function);
    match hint(&error) {
        Some(hint) => report.set_hint(hint),
        None => report,
    }
}
