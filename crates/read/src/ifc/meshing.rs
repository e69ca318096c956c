//! Meshes of single products, through the `ifc-lite` crates: the only place that knows their geometry.

use std::sync::Arc;

use ifc_lite_core::{EntityDecoder, EntityIndex, EntityScanner, IfcType, UnitScales, keyword_eq};
use ifc_lite_geometry::representation::{
    mapped_item_representation_id, pds_representation_ids, product_shape_id, rep_item_ids,
};
use ifc_lite_geometry::{
    GeometryRouter, ItemDedupCache, Mesh, RouterConfig, SharedBrepSignatureCache, SharedMappedItemCache,
    TessellationQuality, void_index_from_content,
};
use ifc_lite_processing::MeshFrame;
use ifc_lite_processing::element::{
    ElementJobKind, ElementMeshJob, MeshProductionContext, MeshProductionOptions, ProducedElementMeshes,
    produce_element_meshes,
};
use ifc_lite_processing::execution::{RouterCaches, SchedulerPolicy, build_router};
use rustc_hash::FxHashMap;

use super::diagnose;
use super::soup::Soup;

/// A model ready to be meshed, product by product, by any number of threads.
pub struct Meshing {
    text: &'static [u8],
    index: Arc<EntityIndex>,
    /// Openings of a host, including those of the whole it is part of.
    openings: FxHashMap<u32, Vec<u32>>,
    /// The file's units in metres and radians.
    metres: f64,
    radians: f64,
    /// The point that positions are relative to, world metres.
    zero: [f64; 3],
    caches: Caches,
}

struct Caches {
    items: ItemDedupCache,
    breps: SharedBrepSignatureCache,
    mapped: SharedMappedItemCache,
}

/// What a thread keeps from product to product.
#[derive(Default)]
pub struct Warm {
    points: FxHashMap<u32, (f64, f64, f64)>,
    placements: FxHashMap<u32, [f64; 16]>,
}

/// The result for a product.
pub struct Meshed {
    /// World metres.
    pub soup: Soup,
    /// What the library said about it.
    pub note: Option<String>,
    /// The record of each of its items, where it is known; the numbers of the mesh's parts count these.
    pub items: Vec<Option<u32>>,
}

impl Meshing {
    pub fn new(text: &'static [u8], index: Arc<EntityIndex>, radians: Option<f64>) -> Result<Self, String> {
        let mut decoder = EntityDecoder::with_arc_index(text, index.clone()).with_strict_reals();
        let units = UnitScales::resolve(text, None, &mut decoder);
        if let Some(unit) = units.length_unit_refused {
            return Err(format!("its unit of length (#{unit}) is unknown: name metres, millimetres, feet or the like"));
        }
        let (metres, radians) = (units.geometry_length_scale(), radians.unwrap_or(units.plane_angle_to_radians));
        decoder.seed_unit_scales(metres, radians);
        let router = GeometryRouter::from_config(RouterConfig { unit_scale: metres, ..RouterConfig::default() });
        let site = site_placement(text, &mut decoder, &router);
        let site = site.filter(|m| is_on_earth([m[12], m[13], m[14]]));
        let frame = MeshFrame::select(
            site.as_ref().map(<[f64; 16]>::as_slice),
            router.detect_rtc_offset_for_file(text, &mut decoder),
        );
        // One product placed nowhere must not take the others with it: each has a zero of its own beside this one.
        let zero = Some(frame.rtc_offset().into()).filter(|z| is_on_earth(*z)).unwrap_or_default();
        let openings = void_index_from_content(text, &mut decoder);
        Ok(Self {
            text,
            index,
            openings,
            metres,
            radians,
            zero,
            caches: Caches {
                items: GeometryRouter::new_dedup_cache(),
                breps: GeometryRouter::new_brep_signature_cache(),
                mapped: GeometryRouter::new_mapped_item_cache(),
            },
        })
    }

    /// The unit with which it is meshed, metres.
    pub fn metres(&self) -> f64 {
        self.metres
    }

    pub fn openings(&self, id: u32) -> &[u32] {
        self.openings.get(&id).map_or(&[], Vec::as_slice)
    }

    /// Meshes a product with its openings cut out.
    pub fn mesh(&self, id: u32, warm: &mut Warm) -> Meshed {
        self.with_decoder(warm, |decoder, router| self.produce(id, decoder, router))
    }

    /// The product, or an opening, without any cut.
    pub fn uncut(&self, id: u32, warm: &mut Warm) -> Option<Soup> {
        let parts = self.with_decoder(warm, |decoder, router| {
            let entity = decoder.decode_by_id(id).ok()?;
            router.process_element_parts(&entity, decoder).ok()
        });
        let mut soup = Soup::default();
        for Mesh { positions, indices, origin, .. } in parts?.iter().map(|m| m as &Mesh) {
            soup.add(positions, indices, |p| self.world(p, *origin));
        }
        Some(soup)
    }

    /// Whether a product has any shape at all.
    pub fn is_drawn(&self, id: u32, warm: &mut Warm) -> bool {
        self.with_decoder(warm, |decoder, _| {
            let entity = decoder.decode_by_id(id).ok();
            entity.and_then(|e| product_shape_id(&e)).is_some()
        })
    }

    /// Whether its shape is cut or joined from others.
    pub fn is_boolean(&self, id: u32, warm: &mut Warm) -> bool {
        self.with_decoder(warm, |decoder, _| {
            let shape = decoder.decode_by_id(id).ok().and_then(|e| product_shape_id(&e));
            let Some(shape) = shape.and_then(|s| decoder.decode_by_id(s).ok()) else { return false };
            let mut open: Vec<u32> = pds_representation_ids(&shape).collect();
            // A map may lead to another; none leads on for long.
            for _ in 0..64 {
                let Some(representation) = open.pop().and_then(|r| decoder.decode_by_id(r).ok()) else { break };
                for item in rep_item_ids(&representation) {
                    let Ok(item) = decoder.decode_by_id(item) else { continue };
                    if item.ifc_type.is_subtype_of(IfcType::IfcBooleanResult) {
                        return true;
                    }
                    open.extend(mapped_item_representation_id(&item, decoder));
                }
            }
            false
        })
    }

    /// Lends `work` what the thread keeps between products.
    fn with_decoder<T>(
        &self,
        warm: &mut Warm,
        work: impl FnOnce(&mut EntityDecoder<'static>, &GeometryRouter) -> T,
    ) -> T {
        let mut decoder = self.decoder(warm);
        let done = work(&mut decoder, &self.router());
        warm.points = decoder.take_point_cache();
        warm.placements = decoder.take_placement_transform_cache();
        done
    }

    fn world(&self, position: [f64; 3], origin: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| position[k] + origin[k] + self.zero[k])
    }

    fn decoder(&self, warm: &mut Warm) -> EntityDecoder<'static> {
        let mut decoder = EntityDecoder::with_arc_index(self.text, self.index.clone()).with_strict_reals();
        decoder.set_point_cache(std::mem::take(&mut warm.points));
        decoder.set_placement_transform_cache(std::mem::take(&mut warm.placements));
        decoder.seed_unit_scales(self.metres, self.radians);
        decoder
    }

    fn router(&self) -> GeometryRouter {
        let config = RouterConfig {
            unit_scale: self.metres,
            tessellation_quality: TessellationQuality::Medium,
            rtc_offset: self.zero.into(),
            // Positions relative to each element's centre: in a projected system the library's single precision
            // would lose centimetres.
            local_frame: Some(true),
            ..RouterConfig::default()
        };
        let caches = RouterCaches {
            items: self.caches.items.clone(),
            brep_signatures: self.caches.breps.clone(),
            mapped_items: self.caches.mapped.clone(),
        };
        build_router(config, SchedulerPolicy::PerJob, caches, None, None, None)
    }

    fn produce(&self, id: u32, decoder: &mut EntityDecoder<'static>, router: &GeometryRouter) -> Meshed {
        let Ok(entity) = decoder.decode_by_id(id) else {
            return Meshed { soup: Soup::default(), note: Some("its record cannot be read".into()), items: Vec::new() };
        };
        let (no_styles, no_palettes, no_colours, no_textures) = Default::default();
        let context = MeshProductionContext {
            void_index: &self.openings,
            geometry_style_index: &no_styles,
            indexed_colour_full: &no_palettes,
            element_material_colors: &no_colours,
            texture_index: &no_textures,
            site_local_rotation: None,
        };
        let job = ElementMeshJob {
            id,
            ifc_type: entity.ifc_type.clone(),
            entity: &entity,
            kind: ElementJobKind::Product,
            element_color: None,
            metadata: None,
        };
        let produced = produce_element_meshes(&job, &context, &MeshProductionOptions::default(), decoder, router);
        let mut note = complaint(&produced, decoder, router);
        let (mut soup, mut items) = (Soup::default(), Vec::new());
        for mesh in produced.meshes.iter().filter(|m| m.geometry_class == 0) {
            soup.begin_part(number(&mut items, mesh.geometry_item_id));
            soup.add(&mesh.positions, &mesh.indices, |p| self.world(p, mesh.origin));
        }
        if soup.triangles.is_empty() {
            note = self.loss(id, note, produced.degenerate_triangles_dropped > 0);
        }
        Meshed { soup, note, items }
    }

    /// Why a product has no mesh: what its records tell, otherwise what the library says.
    fn loss(&self, id: u32, note: Option<String>, is_degenerate: bool) -> Option<String> {
        const POINTS: &str = "all its triangles are points or lines: its coordinates are too large beside its size, or \
            its faces have no area";
        let found = diagnose::of(&diagnose::IfcFile { text: self.text, index: &self.index }, id);
        let said = found.map(|f| format!("it cannot be meshed: {f}")).or(is_degenerate.then(|| POINTS.into()));
        said.or(note)
    }
}

/// The number of the next item; when all numbers are taken, the last one, of which nothing is known.
fn number(items: &mut Vec<Option<u32>>, item: Option<u32>) -> u16 {
    const LAST: usize = u16::MAX as usize;
    items.truncate(LAST);
    items.push(item.filter(|_| items.len() < LAST));
    (items.len() - 1) as u16
}

/// No coordinate of a building can be larger, metres.
pub const FARTHEST_M: f64 = 1e9;

fn is_on_earth(at: [f64; 3]) -> bool {
    at.iter().all(|c| c.abs() <= FARTHEST_M)
}

/// Placement of the first site, metres, as a matrix by columns.
fn site_placement(text: &[u8], decoder: &mut EntityDecoder, router: &GeometryRouter) -> Option<[f64; 16]> {
    let mut scanner = EntityScanner::new(text);
    while let Some((_, keyword, start, end)) = scanner.next_entity() {
        if keyword_eq(keyword, "IFCSITE") {
            let site = decoder.decode_at(start, end).ok()?;
            return router.resolve_scaled_placement(&site, decoder).ok();
        }
    }
    None
}

/// How a note begins that only concerns the cut.
pub const DIFFICULT: &str = "cut with difficulty";

/// What the library could not do, in words.
fn complaint(produced: &ProducedElementMeshes, decoder: &EntityDecoder, router: &GeometryRouter) -> Option<String> {
    let mut reasons = Vec::new();
    let unsupported = router.take_unsupported_items();
    if !unsupported.is_empty() {
        let mut kinds: Vec<&str> = unsupported.keys().map(String::as_str).collect();
        kinds.sort_unstable();
        let kinds = kinds.join(", ");
        reasons.push(format!(
            "its {kinds} cannot be meshed: look at its profile, depth and references, or export it as a Brep"
        ));
    }
    let refused: Vec<String> = decoder.refused_record_ids().into_iter().take(5).map(|id| format!("#{id}")).collect();
    if !refused.is_empty() {
        reasons.push(format!("impossible numbers in {}", refused.join(", ")));
    }
    let failures = produced.csg_failures.values().flatten().map(|f| format!("{} ({:?})", f.reason.label(), f.op));
    let mut failures: Vec<String> = failures.collect();
    failures.sort();
    failures.dedup();
    if !failures.is_empty() {
        reasons.push(format!("{DIFFICULT}: {}", failures.join(", ")));
    }
    if produced.degenerate_triangles_dropped > 0 {
        reasons.push(format!("{} degenerate triangles dropped", produced.degenerate_triangles_dropped));
    }
    (!reasons.is_empty()).then(|| reasons.join("; "))
}
