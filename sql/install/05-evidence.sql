-- Evidence about a solid, and what follows from it.

CREATE FUNCTION ab_evidence_model(
    loa ab_loa DEFAULT 'LOA30', model text DEFAULT 'surface',
    spacing float8 DEFAULT NULL, sigma_range float8 DEFAULT NULL, sigma_angle float8 DEFAULT NULL, sigma_station float8 DEFAULT NULL,
    sigma_model float8 DEFAULT NULL, confidence float8 DEFAULT NULL, reliability float8 DEFAULT NULL, max_incidence float8 DEFAULT NULL,
    no_return_range float8 DEFAULT NULL, no_return_weight float8 DEFAULT NULL, kappa float8 DEFAULT NULL, lambda float8 DEFAULT NULL, c float8 DEFAULT NULL) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_evidence_model_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_evidence_model(ab_loa, text, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8) IS 'Parameters of evidence and verdict; what is not given keeps the default of a current terrestrial scanner. model: surface or meyer2022; lengths in metres, angles in radians';

CREATE FUNCTION ab_rollup(e1 ab_evidence, e2 ab_evidence) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_rollup(ab_evidence, ab_evidence) IS 'Adds up evidence about the same solid, exactly: as if all patches had been aggregated at once';

CREATE FUNCTION ab_summary(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL,
    OUT verdict text, OUT best_loa ab_loa, OUT samples bigint, OUT coverage float8,
    OUT confirmed float8, OUT refuted float8, OUT open float8, OUT conflict float8,
    OUT deviation float8, OUT deviation_sd float8, OUT shift text) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_summary' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION ab_summary(ab_evidence, ab_loa, float8, float8, float8, float8) IS 'Verdict with the numbers that led to it: coverage is seen/all samples; confirmed, refuted and open are shares of the seen ones; deviation is the median of the worst well-seen face along its outward normal, metres; shift is the rigid offset along the directions that the seen faces determine';

CREATE FUNCTION ab_verdict(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_verdict' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION ab_verdict(ab_evidence, ab_loa, float8, float8, float8, float8) IS 'confirmed, deviating, absent, unobserved or conflicting; at another level of accuracy or confidence than the evidence was made for, if asked';

CREATE FUNCTION ab_shift(
    e ab_evidence,
    OUT x float8, OUT y float8, OUT z float8, OUT x_sd float8, OUT y_sd float8, OUT z_sd float8) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_shift' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION ab_shift(ab_evidence) IS 'Rigid offset of the built object against the drawn one, metres; NULL along axes that the seen faces do not determine';

CREATE FUNCTION ab_samples(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    OUT "position" float8[], OUT normal float8[], OUT mass ab_mass,
    OUT deviation float8, OUT deviation_sd float8, OUT beams integer) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_samples' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 10000;
COMMENT ON FUNCTION ab_samples(ab_evidence, ab_loa, float8) IS 'Every sample with its belief and its signed deviation (+ in front of the face); for heat maps';

CREATE FUNCTION ab_faces(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    OUT normal float8[], OUT samples bigint, OUT seen bigint, OUT confirmed bigint, OUT refuted bigint,
    OUT open bigint, OUT pierced bigint, OUT deviation float8, OUT deviation_sd float8) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_faces' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 20;
COMMENT ON FUNCTION ab_faces(ab_evidence, ab_loa, float8) IS 'Every face of the solid with its share in the verdict';

CREATE FUNCTION ab_box(e ab_evidence) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_evidence_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box(ab_evidence) IS 'Box of the solid that the evidence is about';

CREATE FUNCTION ab_count(e ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_count(ab_evidence) IS 'Number of samples';

CREATE FUNCTION ab_station_count(e ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_station_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_station_count(ab_evidence) IS 'Number of stations that spoke';

CREATE FUNCTION ab_model(e ab_evidence) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_evidence_get_model' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_model(ab_evidence) IS 'The parameters that the evidence was made with';

-- Transition and its kin of the aggregates; not for direct use.

CREATE FUNCTION ab_evidence_accum(state internal, solid ab_solid, patch ab_scan, model ab_evidence_model) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_evidence_accum(internal, ab_solid, ab_scan, ab_evidence_model) IS 'Transition of ab_evidence_agg';

CREATE FUNCTION ab_rollup_accum(state internal, e ab_evidence) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_rollup_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 500000;
COMMENT ON FUNCTION ab_rollup_accum(internal, ab_evidence) IS 'Transition of ab_rollup_agg';

CREATE FUNCTION ab_evidence_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_evidence_combine(internal, internal) IS 'Combine of ab_evidence_agg';

CREATE FUNCTION ab_evidence_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_evidence_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_evidence_serial(internal) IS 'Serialisation of ab_evidence_agg';

CREATE FUNCTION ab_evidence_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION ab_evidence_deserial(bytea, internal) IS 'Deserialisation of ab_evidence_agg';

CREATE FUNCTION ab_evidence_final(state internal) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION ab_evidence_final(internal) IS 'Final of ab_evidence_agg';

CREATE AGGREGATE ab_evidence_agg(solid ab_solid, patch ab_scan, model ab_evidence_model) (
    SFUNC = ab_evidence_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_evidence_combine, SERIALFUNC = ab_evidence_serial, DESERIALFUNC = ab_evidence_deserial,
    FINALFUNC = ab_evidence_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_evidence_agg(ab_solid, ab_scan, ab_evidence_model) IS
    'What the beams of all patches say about one solid. A NULL patch adds nothing but keeps the object: it comes out as unobserved';

CREATE AGGREGATE ab_rollup_agg(e ab_evidence) (
    SFUNC = ab_rollup_accum, STYPE = internal, SSPACE = 1000000,
    COMBINEFUNC = ab_evidence_combine, SERIALFUNC = ab_evidence_serial, DESERIALFUNC = ab_evidence_deserial,
    FINALFUNC = ab_evidence_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_rollup_agg(ab_evidence) IS 'Adds up evidence about the same solid, exactly';

CREATE FUNCTION ab_verify_table(
    objects text, scans text, model ab_evidence_model DEFAULT NULL, keep_evidence boolean DEFAULT true,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL,
    OUT id bigint, OUT e ab_evidence, OUT verdict text, OUT best_loa ab_loa, OUT samples bigint, OUT coverage float8,
    OUT confirmed float8, OUT refuted float8, OUT open float8, OUT conflict float8,
    OUT deviation float8, OUT deviation_sd float8, OUT shift text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_verify_table' LANGUAGE c STABLE PARALLEL RESTRICTED COST 100000000 ROWS 1000;
COMMENT ON FUNCTION ab_verify_table(text, text, ab_evidence_model, boolean, float8, float8, float8) IS 'Evidence and verdict of every object of one query (id, solid, perhaps its own ab_evidence_model) from the patches of another; every patch is unpacked once for all objects. Uses as many threads as a parallel plan would have processes (max_parallel_workers_per_gather + 1)';

CREATE FUNCTION ab_stations(
    e ab_evidence, OUT station bigint, OUT origin float8[], OUT seen bigint, OUT added bigint) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_stations' LANGUAGE c STABLE PARALLEL SAFE COST 10000000 ROWS 5;
COMMENT ON FUNCTION ab_stations(ab_evidence) IS 'What each station contributed: the samples that it sees by itself, and those that would be unseen without it; origin NULL for moving platforms and points without origin';

CREATE FUNCTION ab_explain(
    e ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_explain' LANGUAGE c STABLE PARALLEL SAFE COST 10000000;
COMMENT ON FUNCTION ab_explain(ab_evidence, ab_loa, float8, float8, float8, float8) IS 'Why the verdict is what it is: what was seen, what that says, which threshold decided, why no finer level of accuracy holds';

CREATE FUNCTION ab_sensor(
    sensor text DEFAULT NULL,
    OUT name text, OUT sigma_range float8, OUT sigma_angle float8, OUT sigma_station float8, OUT max_range float8, OUT description text)
    RETURNS SETOF record AS 'MODULE_PATHNAME', 'ab_sensor' LANGUAGE c IMMUTABLE PARALLEL SAFE ROWS 6;
COMMENT ON FUNCTION ab_sensor(text) IS 'Standard uncertainties of a kind of scanner, of the order that field tests by ISO 17123-9 find: phase, hybrid, pulse, compact, handheld or tablet; all without a name. Metres and radians';

CREATE FUNCTION ab_with_sensor(model ab_evidence_model, sensor text) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_with_sensor' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_with_sensor(ab_evidence_model, text) IS 'The same parameters with a sensor''s standard uncertainties: sigma_range, sigma_angle and sigma_station of ab_sensor';

CREATE FUNCTION ab_with_intensity(model ab_evidence_model, reference integer, exponent float8 DEFAULT 1) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_with_intensity' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_with_intensity(ab_evidence_model, integer, float8) IS 'The same parameters with range noise by intensity: sigma_range holds from the reference on (the sensor''s own unit), below it the variance grows by (reference/intensity)^exponent. For patches with intensities; exponent 1 is shot noise';
