-- Space in voxels: lattice, occupancy of an epoch, change between two.

CREATE FUNCTION ab_grid(
    voxel float8 DEFAULT 0.01, tile ab_box DEFAULT NULL, margin float8 DEFAULT 0.01, no_return_range float8 DEFAULT 0,
    exact boolean DEFAULT false) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_grid_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_grid(float8, ab_box, float8, float8, boolean) IS
    'Voxels of an edge (metres) on the lattice of the reference system, those of a tile or all; a beam says empty up '
    'to the margin before its return (for noise and registration), without return up to no_return_range; exact: '
    'only voxels that a beam itself passes are empty, not those between neighbouring beams of a patch';

CREATE FUNCTION ab_grid(occupancy ab_occupancy) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_occupancy_grid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_grid(ab_occupancy) IS 'Lattice, tile and rules of an occupancy';

CREATE FUNCTION ab_grid(change ab_change) RETURNS ab_grid
    AS 'MODULE_PATHNAME', 'ab_change_grid' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_grid(ab_change) IS 'Lattice and tile of a change';

CREATE FUNCTION ab_tiles(area ab_box, size float8) RETURNS SETOF ab_box
    AS 'MODULE_PATHNAME', 'ab_tiles' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 100;
COMMENT ON FUNCTION ab_tiles(ab_box, float8) IS
    'The boxes of a lattice of tiles (edge in metres) that meet an area: neighbours share no voxel where the edge is '
    'a multiple of the voxel';

CREATE FUNCTION ab_box(occupancy ab_occupancy) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box(ab_occupancy) IS 'Box of the blocks of voxels of which something is known; NULL for none';

CREATE FUNCTION ab_box(change ab_change) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_tile_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 20;
COMMENT ON FUNCTION ab_box(ab_change) IS 'Box of the blocks of voxels that have a class; NULL for none';

-- Occupancy from patches; it adds up.
CREATE FUNCTION _ab_occupancy_accum(state internal, patch ab_scan, grid ab_grid) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 2000000;
COMMENT ON FUNCTION _ab_occupancy_accum(internal, ab_scan, ab_grid) IS 'Transition of ab_occupancy_agg';

CREATE FUNCTION _ab_occupancy_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_occupancy_combine(internal, internal) IS 'Combine of ab_occupancy_agg';

CREATE FUNCTION _ab_occupancy_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_occupancy_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_occupancy_serial(internal) IS 'Serialisation of ab_occupancy_agg';

CREATE FUNCTION _ab_occupancy_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_occupancy_deserial(bytea, internal) IS 'Deserialisation of ab_occupancy_agg';

CREATE FUNCTION _ab_occupancy_final(state internal) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_occupancy_final(internal) IS 'Final of ab_occupancy_agg';

CREATE AGGREGATE ab_occupancy_agg(patch ab_scan, grid ab_grid) (
    SFUNC = _ab_occupancy_accum, STYPE = internal, SSPACE = 50000000, COMBINEFUNC = _ab_occupancy_combine,
    SERIALFUNC = _ab_occupancy_serial, DESERIALFUNC = _ab_occupancy_deserial, FINALFUNC = _ab_occupancy_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_occupancy_agg(ab_scan, ab_grid) IS
    'Occupancy of the tile of a grid from patches, whatever their order; one grid a group. A NULL patch adds '
    'nothing. At most asbuilt.max_grid_memory at a time in every process';

CREATE FUNCTION _ab_occupancy_rollup_accum(state internal, occupancy ab_occupancy) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_occupancy_rollup_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION _ab_occupancy_rollup_accum(internal, ab_occupancy) IS 'Transition of ab_rollup_agg';

CREATE AGGREGATE ab_rollup_agg(occupancy ab_occupancy) (
    SFUNC = _ab_occupancy_rollup_accum, STYPE = internal, SSPACE = 50000000, COMBINEFUNC = _ab_occupancy_combine,
    SERIALFUNC = _ab_occupancy_serial, DESERIALFUNC = _ab_occupancy_deserial, FINALFUNC = _ab_occupancy_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_rollup_agg(ab_occupancy) IS
    'Adds up occupancy of one lattice: stations of an epoch, neighbouring tiles, solids of a model';

CREATE FUNCTION ab_rollup(o1 ab_occupancy, o2 ab_occupancy) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 400000;
COMMENT ON FUNCTION ab_rollup(ab_occupancy, ab_occupancy) IS
    'Adds up two occupancies of one lattice: as if all patches had been aggregated at once; NULL counts as nothing';

CREATE FUNCTION ab_union(o1 ab_occupancy, o2 ab_occupancy) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 400000;
COMMENT ON FUNCTION ab_union(ab_occupancy, ab_occupancy) IS 'The same as ab_rollup';

CREATE FUNCTION ab_occupancy(grid ab_grid, model boolean DEFAULT false) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_empty' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100;
COMMENT ON FUNCTION ab_occupancy(ab_grid, boolean) IS
    'An occupancy of which nothing is known: what ab_occupancy_agg of no rows would be, were it not NULL; or a model '
    'that fills nothing';

CREATE FUNCTION ab_clip(occupancy ab_occupancy, tile ab_box) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_clip' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_clip(ab_occupancy, ab_box) IS 'The voxels of an occupancy whose centres lie in a box';

-- What is where.
CREATE FUNCTION ab_state(occupancy ab_occupancy, x float8, y float8, z float8, threshold integer DEFAULT 3) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_occupancy_state' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_state(ab_occupancy, float8, float8, float8, integer) IS
    'State of the voxel that holds a point: occupied (as many returns as the threshold), ambiguous (the same, but '
    'beams passed too), empty, unknown';

CREATE TYPE ab_voxel_row AS (x float8, y float8, z float8, state text, hits integer);
COMMENT ON TYPE ab_voxel_row IS 'A voxel of an occupancy';
COMMENT ON COLUMN ab_voxel_row.x IS 'Centre, world metres';
COMMENT ON COLUMN ab_voxel_row.y IS 'Centre, world metres';
COMMENT ON COLUMN ab_voxel_row.z IS 'Centre, world metres';
COMMENT ON COLUMN ab_voxel_row.state IS 'occupied, ambiguous or empty';
COMMENT ON COLUMN ab_voxel_row.hits IS 'Number of returns in it, 255 for more';

CREATE FUNCTION ab_voxels(
    occupancy ab_occupancy, states text[] DEFAULT '{occupied,ambiguous}',
    threshold integer DEFAULT 3) RETURNS SETOF ab_voxel_row
    AS 'MODULE_PATHNAME', 'ab_occupancy_voxels' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 500000 ROWS 100000;
COMMENT ON FUNCTION ab_voxels(ab_occupancy, text[], integer) IS
    'Centres of the voxels of some states, with the returns in each (255 for more)';

CREATE FUNCTION ab_slice(occupancy ab_occupancy, axis text, at float8, threshold integer DEFAULT 3) RETURNS integer[]
    AS 'MODULE_PATHNAME', 'ab_occupancy_slice' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_slice(ab_occupancy, text, float8, integer) IS
    'The layer of voxels at a coordinate on an axis (x, y or z) as a picture: 0 unknown, 1 empty, 2 occupied, 3 '
    'ambiguous; rows along the later of the other axes, as far as anything is known';

CREATE TYPE ab_occupancy_summary_row AS (
    occupied bigint, ambiguous bigint, empty bigint, unknown bigint, occupied_m3 float8, ambiguous_m3 float8,
    empty_m3 float8, unknown_m3 float8);
COMMENT ON TYPE ab_occupancy_summary_row IS 'Voxels of an occupancy by state';
COMMENT ON COLUMN ab_occupancy_summary_row.occupied IS 'Number of occupied voxels';
COMMENT ON COLUMN ab_occupancy_summary_row.ambiguous IS 'Number of ambiguous voxels';
COMMENT ON COLUMN ab_occupancy_summary_row.empty IS 'Number of empty voxels';
COMMENT ON COLUMN ab_occupancy_summary_row.unknown IS
    'Number of unknown voxels; NULL where neither tile nor solid says of how many';
COMMENT ON COLUMN ab_occupancy_summary_row.occupied_m3 IS 'Volume of the occupied voxels, cubic metres';
COMMENT ON COLUMN ab_occupancy_summary_row.ambiguous_m3 IS 'Volume of the ambiguous voxels, cubic metres';
COMMENT ON COLUMN ab_occupancy_summary_row.empty_m3 IS 'Volume of the empty voxels, cubic metres';
COMMENT ON COLUMN ab_occupancy_summary_row.unknown_m3 IS
    'Volume of the unknown voxels, cubic metres; NULL where unknown is';

CREATE FUNCTION ab_summary(
    occupancy ab_occupancy, threshold integer DEFAULT 3, solid ab_solid DEFAULT NULL) RETURNS ab_occupancy_summary_row
    AS 'MODULE_PATHNAME', 'ab_occupancy_summary' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_summary(ab_occupancy, integer, ab_solid) IS
    'Voxels and cubic metres of each state, overall or of the voxels that a solid touches; unknown is NULL where '
    'neither tile nor solid says of how many';

CREATE FUNCTION ab_denoise(
    occupancy ab_occupancy, neighbours integer DEFAULT 1, threshold integer DEFAULT 1) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_denoise' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_denoise(ab_occupancy, integer, integer) IS
    'Without the returns of voxels that have fewer occupied neighbours than that, of the 26 around';

CREATE FUNCTION ab_downsample(occupancy ab_occupancy) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_occupancy_downsample' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_downsample(ab_occupancy) IS
    'Voxels twice as large: returns added up, passed where one of the eight was passed';

CREATE FUNCTION ab_voxelize(
    solid ab_solid, voxel float8, rule text DEFAULT 'centre', tile ab_box DEFAULT NULL) RETURNS ab_occupancy
    AS 'MODULE_PATHNAME', 'ab_voxelize' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_voxelize(ab_solid, float8, text, ab_box) IS
    'A solid as occupancy of which everything is known: the voxels whose centre lies inside (centre), that it '
    'touches (cover), or that its surface passes through (surface; the one rule for open surfaces); those of a tile '
    'or all';

CREATE TYPE ab_voxel_accuracy_row AS (max_error float8, absolute ab_loa, relative ab_loa, relative_linear ab_loa);
COMMENT ON TYPE ab_voxel_accuracy_row IS 'What voxels of an edge support';
COMMENT ON COLUMN ab_voxel_accuracy_row.max_error IS
    'Greatest distance of a point in a voxel from its centre, half the diagonal, metres';
COMMENT ON COLUMN ab_voxel_accuracy_row.absolute IS 'Finest level of accuracy that places keep; NULL for none';
COMMENT ON COLUMN ab_voxel_accuracy_row.relative IS
    'Finest level that distances keep, errors added as squares; NULL for none';
COMMENT ON COLUMN ab_voxel_accuracy_row.relative_linear IS
    'Finest level that distances keep, errors added linearly; NULL for none';

CREATE FUNCTION ab_voxel_accuracy(voxel float8) RETURNS ab_voxel_accuracy_row
    AS 'MODULE_PATHNAME', 'ab_voxel_accuracy' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10;
COMMENT ON FUNCTION ab_voxel_accuracy(float8) IS
    'What voxels of an edge support: greatest error of a centre, half the diagonal (Meyer 4.1), and the finest '
    'levels of accuracy that hold it, for places and for distances (errors added as squares or linearly, 4.4 and '
    '4.5)';

-- What changed.
CREATE FUNCTION ab_change(
    old ab_occupancy, new ab_occupancy, threshold integer DEFAULT 3, tolerance float8 DEFAULT NULL) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_between' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_change(ab_occupancy, ab_occupancy, integer, float8) IS
    'Voxels that are occupied in one of two epochs: confirmed, new, disappeared, unknown, ambiguous. A change counts '
    'only if the other epoch has nothing occupied within the tolerance (metres; NULL: the margin of the grids; 0: '
    'voxel by voxel). A model as old side: new means unmodelled, disappeared absent';

CREATE TYPE ab_change_summary_row AS (
    confirmed bigint, new bigint, disappeared bigint, unknown bigint, ambiguous bigint, total bigint,
    confirmed_m3 float8, new_m3 float8, disappeared_m3 float8, unknown_m3 float8, ambiguous_m3 float8, total_m3 float8,
    confirmed_share float8, new_share float8, disappeared_share float8, unknown_share float8, ambiguous_share float8);
COMMENT ON TYPE ab_change_summary_row IS 'Voxels of a change by class';
COMMENT ON COLUMN ab_change_summary_row.confirmed IS 'Number of confirmed voxels';
COMMENT ON COLUMN ab_change_summary_row.new IS 'Number of new voxels';
COMMENT ON COLUMN ab_change_summary_row.disappeared IS 'Number of disappeared voxels';
COMMENT ON COLUMN ab_change_summary_row.unknown IS 'Number of unknown voxels';
COMMENT ON COLUMN ab_change_summary_row.ambiguous IS 'Number of ambiguous voxels';
COMMENT ON COLUMN ab_change_summary_row.total IS 'Number of voxels that are occupied in one of the epochs';
COMMENT ON COLUMN ab_change_summary_row.confirmed_m3 IS 'Volume of the confirmed voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.new_m3 IS 'Volume of the new voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.disappeared_m3 IS 'Volume of the disappeared voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.unknown_m3 IS 'Volume of the unknown voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.ambiguous_m3 IS 'Volume of the ambiguous voxels, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.total_m3 IS 'Volume of all of them, cubic metres';
COMMENT ON COLUMN ab_change_summary_row.confirmed_share IS
    'Share of the confirmed voxels in all of them, 0 to 1; NULL for none';
COMMENT ON COLUMN ab_change_summary_row.new_share IS 'Share of the new voxels in all of them, 0 to 1; NULL for none';
COMMENT ON COLUMN ab_change_summary_row.disappeared_share IS
    'Share of the disappeared voxels in all of them, 0 to 1; NULL for none';
COMMENT ON COLUMN ab_change_summary_row.unknown_share IS
    'Share of the unknown voxels in all of them, 0 to 1; NULL for none';
COMMENT ON COLUMN ab_change_summary_row.ambiguous_share IS
    'Share of the ambiguous voxels in all of them, 0 to 1; NULL for none';

CREATE FUNCTION ab_summary(
    change ab_change, solid ab_solid DEFAULT NULL, margin float8 DEFAULT NULL) RETURNS ab_change_summary_row
    AS 'MODULE_PATHNAME', 'ab_change_summary' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_summary(ab_change, ab_solid, float8) IS
    'Voxels, cubic metres and shares of each class (total: occupied in one of the epochs), overall or of the voxels '
    'that a solid touches or that lie within the margin of those (metres; NULL: the tolerance of the change); shares '
    'are NULL for none';

CREATE TYPE ab_changed_voxel_row AS (x float8, y float8, z float8, class text);
COMMENT ON TYPE ab_changed_voxel_row IS 'A voxel of a change';
COMMENT ON COLUMN ab_changed_voxel_row.x IS 'Centre, world metres';
COMMENT ON COLUMN ab_changed_voxel_row.y IS 'Centre, world metres';
COMMENT ON COLUMN ab_changed_voxel_row.z IS 'Centre, world metres';
COMMENT ON COLUMN ab_changed_voxel_row.class IS
    'confirmed, new, disappeared, unknown or ambiguous; against a model unmodelled for new, absent for disappeared';

CREATE FUNCTION ab_voxels(change ab_change, classes text[] DEFAULT NULL) RETURNS SETOF ab_changed_voxel_row
    AS 'MODULE_PATHNAME', 'ab_change_voxels' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000 ROWS 100000;
COMMENT ON FUNCTION ab_voxels(ab_change, text[]) IS 'Centres of the voxels of some classes, or of all';

CREATE TYPE ab_component_row AS (class text, voxels bigint, volume float8, box ab_box, centroid float8[]);
COMMENT ON TYPE ab_component_row IS 'Voxels of a change that hang together';
COMMENT ON COLUMN ab_component_row.class IS
    'Their class: new or disappeared, or the one that was asked for; against a model unmodelled, absent';
COMMENT ON COLUMN ab_component_row.voxels IS 'How many they are';
COMMENT ON COLUMN ab_component_row.volume IS 'Their volume, cubic metres';
COMMENT ON COLUMN ab_component_row.box IS 'Box around them, world metres';
COMMENT ON COLUMN ab_component_row.centroid IS 'Mean of their centres: x, y, z, world metres';

CREATE FUNCTION ab_components(
    change ab_change, of_class text DEFAULT NULL, min_voxels integer DEFAULT 10,
    gap float8 DEFAULT NULL) RETURNS SETOF ab_component_row
    AS 'MODULE_PATHNAME', 'ab_change_components' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 500000 ROWS 20;
COMMENT ON FUNCTION ab_components(ab_change, text, integer, float8) IS
    'What is new or has disappeared (or is of the class named) as connected things of at least min_voxels, largest '
    'first; voxels hang together when the gap between them is less than that (metres; NULL: four voxels)';

CREATE FUNCTION ab_clip(change ab_change, tile ab_box) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_clip' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_clip(ab_change, ab_box) IS
    'The voxels of a change whose centres lie in a box: aggregate tiles a little larger than wanted, so that the '
    'tolerance sees across their borders, and clip their change';

CREATE FUNCTION ab_rollup(c1 ab_change, c2 ab_change) RETURNS ab_change
    AS 'MODULE_PATHNAME', 'ab_change_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_rollup(ab_change, ab_change) IS 'Changes of two tiles as one; NULL counts as nothing';

CREATE AGGREGATE ab_rollup_agg(change ab_change) (
    SFUNC = ab_rollup, STYPE = ab_change, COMBINEFUNC = ab_rollup, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_rollup_agg(ab_change) IS
    'Changes of tiles as one, so that ab_components sees what crosses their borders';
