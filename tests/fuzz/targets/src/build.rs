//! Values built out of the fuzzer's bytes, and the seeds of all targets.

use asbuilt_core::NEVER;
use asbuilt_core::geometry::{Solid, SurfaceKind, Vec3};
use asbuilt_core::scan::{Beam, Beams, Origins, Patch, PatchBuilder, PatchSpec, Return, Spacing};
use asbuilt_core::verify::{Collector, Evidence, EvidenceModel, ModelKind};
use asbuilt_core::voxel::{ChangeSettings, FillRule, Grid, Occupancy, VoxelChange, VoxelSet};

use crate::bounded;
use crate::input::Input;
use crate::value::{edits, questions, same_through_bytes};

pub fn patch(data: &[u8]) {
    let Some(patch) = packed(&mut Input(data)) else { return };
    let bytes = patch.to_bytes();
    assert_eq!(Patch::from_bytes(&bytes).as_ref(), Ok(&patch), "a patch changed through its bytes");
    edits(&bytes);
}

/// A patch of some beams with some planes.
fn packed(input: &mut Input) -> Option<Patch> {
    let flags = input.byte();
    let origins = [Origins::One, Origins::Each, Origins::Unknown][usize::from(flags % 3)];
    let setting = PatchSpec {
        origins,
        station: i64::from(input.byte()),
        origin: Vec3::from(input.vector()),
        spacing: Spacing::of(origins, input.metres().abs()),
        quantum: [1e-4, 1e-3, 1e-6, 0.5][usize::from(flags >> 2 & 3)],
    };
    let n = usize::from(input.byte()) + 1;
    let mut content = Beams::default();
    for _ in 0..n {
        let returned = origins == Origins::Unknown || !input.byte().is_multiple_of(5);
        content.beams.push(Beam { offset: Vec3::from(input.vector()), returned });
    }
    content.starts = (origins == Origins::Each).then(|| (0..n).map(|_| Vec3::from(input.vector())).collect());
    content.intensity = (flags & 32 != 0).then(|| (0..n).map(|_| u16::from(input.byte()) << 4).collect());
    content.colour = (flags & 64 != 0).then(|| (0..n).map(|_| [input.byte(), 7, input.byte()]).collect());
    Patch::pack(&setting, &content).ok()
}

pub fn evidence(data: &[u8]) {
    let mut input = Input(data);
    let corner = input.vector();
    let Ok(solid) = Solid::cuboid(corner, [0, 1, 2].map(|i| corner[i] + 0.1 + input.metres().abs().min(2.0))) else {
        return;
    };
    let mut model = EvidenceModel { spacing: 0.3, ..EvidenceModel::default() };
    if input.byte() % 2 == 1 {
        model.kind = ModelKind::Meyer2022;
    }
    let Ok(mut collector) = bounded(|i| Collector::new(&solid, model, i)) else { return };
    for _ in 0..3 {
        if let Some(patch) = packed(&mut input) {
            let _ = bounded(|i| collector.absorb(&patch.to_bytes(), i));
        }
    }
    let evidence = collector.into_evidence();
    same_through_bytes(&evidence);
    questions(&evidence);
}

/// Small valid values; the first of each target is short, so that its checksums are found.
pub fn seeds(target: &str) -> Vec<Vec<u8>> {
    match target {
        "solid" => solids().iter().map(|s| s.to_bytes(NEVER).unwrap()).collect(),
        "ewkb" => solids()
            .iter()
            .flat_map(|s| [SurfaceKind::Tin, SurfaceKind::Polyhedral].map(|k| s.to_ewkb(k, NEVER).unwrap()))
            .collect(),
        "patch" => [9, 30].map(|n| wall(n).to_bytes()).into(),
        "gathered" => vec![rows(12).to_bytes(NEVER).unwrap()],
        "evidence" => [1.0, 0.4].map(|spacing| seen(spacing).to_bytes(NEVER).unwrap()).into(),
        "occupancy" => vec![drawn(0.5).to_bytes(NEVER).unwrap(), drawn(0.1).to_bytes(NEVER).unwrap()],
        "change" => vec![changed(0.5).to_bytes(NEVER).unwrap(), changed(0.1).to_bytes(NEVER).unwrap()],
        "texts" => texts(),
        _ => vec![(0..=255).collect(), vec![1; 200], (0..900).map(|i| (i * 7 % 251) as u8).collect()],
    }
}

fn solids() -> Vec<Solid> {
    let triangle = vec![Vec3::zeros(), Vec3::x(), Vec3::y()];
    vec![
        Solid::new(triangle, vec![[0, 1, 2]]).unwrap(),
        Solid::cuboid([0.0; 3], [1.0, 2.0, 3.0]).unwrap(),
        Solid::cylinder([0.0; 3], 0.5, 2.0, 7).unwrap(),
    ]
}

fn wall(n: u32) -> Patch {
    let beam = |i: u32| Beam {
        offset: Vec3::new(5.0, f64::from(i % 6) * 0.02, f64::from(i / 6) * 0.02),
        returned: i % 4 != 3,
    };
    Patch::encode(7, Vec3::new(1.0, 2.0, 3.0), 0.004, 1e-4, &(0..n).map(beam).collect::<Vec<_>>()).unwrap()
}

fn rows(n: u32) -> PatchBuilder {
    let mut g = PatchBuilder::default();
    for i in 0..n {
        let point = Vec3::new(5.0, f64::from(i) * 0.01, 0.0);
        g.push(3, &Return { point, origin: Some(Vec3::zeros()), intensity: Some(9), colour: None }, NEVER).unwrap();
    }
    g
}

fn seen(spacing: f64) -> Evidence {
    let solid = Solid::cuboid([6.0, 1.9, 2.9], [6.2, 2.3, 3.2]).unwrap();
    let model = EvidenceModel { spacing, ..EvidenceModel::default() };
    let mut collector = Collector::new(&solid, model, NEVER).unwrap();
    collector.absorb(&wall(30).to_bytes(), NEVER).unwrap();
    collector.into_evidence()
}

fn drawn(voxel: f64) -> Occupancy {
    let solid = Solid::cuboid([0.0; 3], [1.0, 1.0, 0.5]).unwrap();
    let grid = Grid::new(voxel, solid.bounds(), 0.0, 0.0).unwrap();
    VoxelSet::of(&solid, &grid, FillRule::Centre, NEVER).unwrap().into_model(grid, NEVER).unwrap()
}

fn changed(voxel: f64) -> VoxelChange {
    let settings = ChangeSettings { threshold: 1, tolerance: 0.0 };
    let new = Occupancy::new(*drawn(voxel).grid());
    VoxelChange::between(&drawn(voxel), &new, settings, NEVER).unwrap()
}

fn texts() -> Vec<Vec<u8>> {
    [
        "\0BOX3D(1 2 3,4 5 6)",
        "\u{1}voxel=0.1 margin=0.01 no_return_range=0 exact=false tile=BOX3D(0 0 0,1 1 1)",
        "\u{2}LOA40 meyer2022 spacing=0.1 sigma_range=0.001",
        "\u{3}(0.6,0.1,0.3)",
        "\u{4}(1,2,3;1e-6,0,0,1e-6,0,1e-6)",
        "\u{5}(0,0,0,1,2,3)",
        "\u{6}(0,0,0,0,0,1)",
        "\u{7}(1,0,0,0,1,2,3,1)",
    ]
    .map(|t| t.as_bytes().to_vec())
    .into()
}
