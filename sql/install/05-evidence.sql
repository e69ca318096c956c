-- Evidence about a solid, and what follows from it.

CREATE FUNCTION ab_evidence_model(
    loa ab_loa DEFAULT 'LOA30', model text DEFAULT 'surface', spacing float8 DEFAULT NULL,
    sigma_range float8 DEFAULT NULL, sigma_angle float8 DEFAULT NULL, sigma_station float8 DEFAULT NULL,
    sigma_model float8 DEFAULT NULL, confidence float8 DEFAULT NULL, reliability float8 DEFAULT NULL,
    max_incidence float8 DEFAULT NULL, no_return_range float8 DEFAULT NULL, no_return_weight float8 DEFAULT NULL,
    kappa float8 DEFAULT NULL, lambda float8 DEFAULT NULL, c float8 DEFAULT NULL, reach float8 DEFAULT NULL)
    RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_model_make' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_evidence_model(
    ab_loa, text, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8, float8,
    float8, float8) IS
    'Parameters of evidence and verdict; what is not given keeps the default of a current terrestrial scanner. '
    'model: surface or meyer2022; lengths in metres, angles in radians. reach: how far from its drawn place '
    'ab_verify_table looks for an object that is not there, 0.3 m where it is not given';

CREATE FUNCTION ab_rollup(e1 ab_evidence, e2 ab_evidence) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_rollup' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 1000000;
COMMENT ON FUNCTION ab_rollup(ab_evidence, ab_evidence) IS
    'Adds up evidence about the same solid, exactly: as if all patches had been aggregated at once';

CREATE FUNCTION ab_reach(solid ab_solid, model ab_evidence_model DEFAULT NULL) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_model_reach' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_reach(ab_solid, ab_evidence_model) IS
    'Box of a solid grown by as far as evidence looks around it: what to join patches with (patch && ab_reach(solid))';

CREATE TYPE ab_summary_row AS (
    verdict text, best_loa ab_loa, samples bigint, coverage float8, confirmed float8, refuted float8, open float8,
    conflict float8, deviation float8, deviation_sd float8, shift float8[], shift_sd float8[],
    deviation_normal float8[], deviation_face integer, reason text, reason_shares float8[], hidden_by text);
COMMENT ON TYPE ab_summary_row IS 'A verdict with the numbers that led to it';
COMMENT ON COLUMN ab_summary_row.verdict IS
    'confirmed, deviating, absent, unobserved or conflicting, at the level of accuracy that was asked';
COMMENT ON COLUMN ab_summary_row.best_loa IS
    'Finest level of accuracy that 95 % of every well-seen surface keeps, proven at the confidence; NULL for none';
COMMENT ON COLUMN ab_summary_row.samples IS
    'Number of samples on the surface of the solid; of leaves and panes those that were seen';
COMMENT ON COLUMN ab_summary_row.coverage IS 'Share of the samples that were seen, 0 to 1';
COMMENT ON COLUMN ab_summary_row.confirmed IS
    'Share of the seen samples at which belief in "built here" reaches the confidence, 0 to 1; NULL where none was '
    'seen';
COMMENT ON COLUMN ab_summary_row.refuted IS
    'Share of the seen samples at which belief in "not built here" reaches it, 0 to 1; NULL where none was seen';
COMMENT ON COLUMN ab_summary_row.open IS
    'Share of the seen samples that are neither, 0 to 1; with confirmed and refuted 1; NULL where none was seen';
COMMENT ON COLUMN ab_summary_row.conflict IS
    'Mean conflict between stations over the seen samples, 0 to 1; NULL where none was seen';
COMMENT ON COLUMN ab_summary_row.deviation IS
    'Median deviation of the face meant along its outward normal, metres, + in front of it (outside): of the largest '
    'face that is certainly off, else of the largest; NULL where no face is seen';
COMMENT ON COLUMN ab_summary_row.deviation_sd IS 'Standard deviation of deviation, metres';
COMMENT ON COLUMN ab_summary_row.shift IS
    'Rigid offset of the built object from the drawn one: three elements along the world''s x, y, z, metres, + along '
    'the axis; an element is NULL where the seen faces do not determine that axis to 6 degrees; NULL where none is';
COMMENT ON COLUMN ab_summary_row.shift_sd IS 'Standard deviation of each element of shift, metres; NULL where that is';
COMMENT ON COLUMN ab_summary_row.deviation_normal IS
    'Outward unit normal of the face that deviation is of, along the axes of the world; NULL where that is';
COMMENT ON COLUMN ab_summary_row.deviation_face IS
    'Number of that face, in the order of ab_faces, from 1; the same in every epoch in which it is well seen';
COMMENT ON COLUMN ab_summary_row.reason IS
    'Why it is unobserved, by the largest share: hidden_by_object, hidden_by_other, too_few, too_steep, not_looked_at, '
    'no_return or shared_face; NULL for other verdicts, and where only ab_evidence_agg looked';
COMMENT ON COLUMN ab_summary_row.reason_shares IS
    'Share of the samples for each reason: hidden by another drawn object, hidden by what nobody drew, too few beams, '
    'beams too steep, not looked at, nothing returned, on a face that another object shares; each 0 to 1, in sum 1; NULL '
    'where reason is';
COMMENT ON COLUMN ab_summary_row.hidden_by IS
    'Always NULL: evidence does not know the names of others; see ab_verify_table';

CREATE FUNCTION ab_summary(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS ab_summary_row
    AS 'MODULE_PATHNAME', 'ab_evidence_summary' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION ab_summary(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'Verdict with the numbers that led to it: coverage is seen/all samples; confirmed, refuted and open are shares '
    'of the seen ones; deviation is the median of the face meant along its outward normal, metres; shift '
    'is the rigid offset along the directions that the seen faces determine';

CREATE FUNCTION ab_verdict(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_verdict' LANGUAGE c STABLE PARALLEL SAFE COST 5000000;
COMMENT ON FUNCTION ab_verdict(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'confirmed, deviating, absent, unobserved or conflicting; at another level of accuracy or confidence than the '
    'evidence was made for, if asked';

CREATE TYPE ab_shift_row AS (shift float8[], shift_sd float8[]);
COMMENT ON TYPE ab_shift_row IS 'A rigid offset';
COMMENT ON COLUMN ab_shift_row.shift IS
    'Rigid offset of the built object from the drawn one: three elements along the world''s x, y, z, metres, + along '
    'the axis; an element is NULL where the seen faces do not determine that axis to 6 degrees; NULL where none is';
COMMENT ON COLUMN ab_shift_row.shift_sd IS 'Standard deviation of each element of shift, metres; NULL where that is';

CREATE FUNCTION ab_shift(evidence ab_evidence) RETURNS ab_shift_row
    AS 'MODULE_PATHNAME', 'ab_evidence_shift' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION ab_shift(ab_evidence) IS
    'Rigid offset of the built object against the drawn one, metres; NULL along axes that the seen faces do not '
    'determine';

CREATE TYPE ab_sample_row AS (
    "position" float8[], normal float8[], mass ab_mass, deviation float8, deviation_sd float8, beams integer);
COMMENT ON TYPE ab_sample_row IS 'A sample on the surface of a solid, and what is believed there';
COMMENT ON COLUMN ab_sample_row."position" IS 'Where it is drawn: x, y, z, world metres';
COMMENT ON COLUMN ab_sample_row.normal IS 'Outward unit normal of its face along the axes of the world';
COMMENT ON COLUMN ab_sample_row.mass IS 'Belief that the object is built here (occupied) or is not (empty)';
COMMENT ON COLUMN ab_sample_row.deviation IS
    'Distance of the built surface along the normal, metres, + in front of the face (outside); NULL where no surface '
    'was met';
COMMENT ON COLUMN ab_sample_row.deviation_sd IS 'Standard deviation of deviation, metres';
COMMENT ON COLUMN ab_sample_row.beams IS 'Number of beams that say something of it';

CREATE FUNCTION ab_samples(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL) RETURNS SETOF ab_sample_row
    AS 'MODULE_PATHNAME', 'ab_samples' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 10000;
COMMENT ON FUNCTION ab_samples(ab_evidence, ab_loa, float8) IS
    'Every sample with its belief and its signed deviation (+ in front of the face); for heat maps';

CREATE TYPE ab_face_row AS (
    normal float8[], samples bigint, seen bigint, confirmed bigint, refuted bigint, open bigint, pierced bigint,
    deviation float8, deviation_sd float8);
COMMENT ON TYPE ab_face_row IS 'A face of a solid, and its share in the verdict';
COMMENT ON COLUMN ab_face_row.normal IS 'Outward unit normal along the axes of the world';
COMMENT ON COLUMN ab_face_row.samples IS 'Number of its samples';
COMMENT ON COLUMN ab_face_row.seen IS
    'Of these: of which enough beams say something; confirmed, refuted and open add up to them';
COMMENT ON COLUMN ab_face_row.confirmed IS 'Seen samples at which belief in "built here" reaches the confidence';
COMMENT ON COLUMN ab_face_row.refuted IS
    'Seen samples at which belief in "not built here" reaches it, or that share the displacement of the face';
COMMENT ON COLUMN ab_face_row.open IS 'Seen samples that are neither';
COMMENT ON COLUMN ab_face_row.pierced IS 'Of the refuted: through which beams passed';
COMMENT ON COLUMN ab_face_row.deviation IS
    'Median deviation along the normal, metres, + in front of the face (outside); NULL where no surface was met';
COMMENT ON COLUMN ab_face_row.deviation_sd IS 'Standard deviation of deviation, metres';

CREATE FUNCTION ab_faces(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL) RETURNS SETOF ab_face_row
    AS 'MODULE_PATHNAME', 'ab_faces' LANGUAGE c STABLE PARALLEL SAFE COST 5000000 ROWS 20;
COMMENT ON FUNCTION ab_faces(ab_evidence, ab_loa, float8) IS 'Every face of the solid with its share in the verdict';

CREATE FUNCTION ab_box(evidence ab_evidence) RETURNS ab_box
    AS 'MODULE_PATHNAME', 'ab_evidence_box' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_box(ab_evidence) IS 'Box of the solid that the evidence is about';

CREATE FUNCTION ab_count(evidence ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_count(ab_evidence) IS 'Number of samples';

CREATE FUNCTION ab_station_count(evidence ab_evidence) RETURNS integer
    AS 'MODULE_PATHNAME', 'ab_evidence_station_count' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_station_count(ab_evidence) IS 'Number of stations that spoke';

CREATE FUNCTION ab_model(evidence ab_evidence) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_model_of_evidence' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_model(ab_evidence) IS 'The parameters that the evidence was made with';

-- Transition and its kin of the aggregates; not for direct use.
CREATE FUNCTION _ab_evidence_accum(
    state internal, solid ab_solid, patch ab_scan, model ab_evidence_model) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_model_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_evidence_accum(internal, ab_solid, ab_scan, ab_evidence_model) IS
    'Transition of ab_evidence_agg';

CREATE FUNCTION _ab_rollup_accum(state internal, evidence ab_evidence) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_rollup_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 500000;
COMMENT ON FUNCTION _ab_rollup_accum(internal, ab_evidence) IS 'Transition of ab_rollup_agg';

CREATE FUNCTION _ab_evidence_combine(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_combine' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_evidence_combine(internal, internal) IS 'Combine of ab_evidence_agg';

CREATE FUNCTION _ab_evidence_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_evidence_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_evidence_serial(internal) IS 'Serialisation of ab_evidence_agg';

CREATE FUNCTION _ab_evidence_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_evidence_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200000;
COMMENT ON FUNCTION _ab_evidence_deserial(bytea, internal) IS 'Deserialisation of ab_evidence_agg';

CREATE FUNCTION _ab_evidence_final(state internal) RETURNS ab_evidence
    AS 'MODULE_PATHNAME', 'ab_evidence_final' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100000;
COMMENT ON FUNCTION _ab_evidence_final(internal) IS 'Final of ab_evidence_agg';

CREATE AGGREGATE ab_evidence_agg(solid ab_solid, patch ab_scan, model ab_evidence_model) (
    SFUNC = _ab_evidence_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_evidence_combine,
    SERIALFUNC = _ab_evidence_serial, DESERIALFUNC = _ab_evidence_deserial, FINALFUNC = _ab_evidence_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_evidence_agg(ab_solid, ab_scan, ab_evidence_model) IS
    'What the beams of all patches say about one solid. A NULL patch adds nothing but keeps the object: it comes out '
    'as unobserved';

CREATE AGGREGATE ab_rollup_agg(evidence ab_evidence) (
    SFUNC = _ab_rollup_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_evidence_combine,
    SERIALFUNC = _ab_evidence_serial, DESERIALFUNC = _ab_evidence_deserial, FINALFUNC = _ab_evidence_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_rollup_agg(ab_evidence) IS 'Adds up evidence about the same solid, exactly';

CREATE TYPE ab_verdict_row AS (
    id bigint, evidence ab_evidence, verdict text, best_loa ab_loa, samples bigint, coverage float8, confirmed float8,
    refuted float8, open float8, conflict float8, deviation float8, deviation_sd float8, shift float8[],
    shift_sd float8[], deviation_normal float8[], deviation_face integer, reason text, reason_shares float8[],
    hidden_by text, drawn_twice text);
COMMENT ON TYPE ab_verdict_row IS
    'An object that was verified: its evidence, its verdict and the numbers that led to it';
COMMENT ON COLUMN ab_verdict_row.id IS 'The object''s id, from the query of objects';
COMMENT ON COLUMN ab_verdict_row.evidence IS
    'What the beams say of it; NULL where it is not kept, or the object has no solid';
COMMENT ON COLUMN ab_verdict_row.verdict IS
    'confirmed, deviating, absent, unobserved or conflicting, at the level of accuracy that was asked; NULL without '
    'a solid';
COMMENT ON COLUMN ab_verdict_row.best_loa IS
    'Finest level of accuracy that 95 % of every well-seen surface keeps, proven at the confidence; NULL for none';
COMMENT ON COLUMN ab_verdict_row.samples IS
    'Number of samples on the surface of the solid, of leaves and panes those that were seen; NULL without a solid';
COMMENT ON COLUMN ab_verdict_row.coverage IS 'Share of the samples that were seen, 0 to 1; NULL without a solid';
COMMENT ON COLUMN ab_verdict_row.confirmed IS
    'Share of the seen samples at which belief in "built here" reaches the confidence, 0 to 1; NULL where none was '
    'seen';
COMMENT ON COLUMN ab_verdict_row.refuted IS
    'Share of the seen samples at which belief in "not built here" reaches it, 0 to 1; NULL where none was seen';
COMMENT ON COLUMN ab_verdict_row.open IS
    'Share of the seen samples that are neither, 0 to 1; with confirmed and refuted 1; NULL where none was seen';
COMMENT ON COLUMN ab_verdict_row.conflict IS
    'Mean conflict between stations over the seen samples, 0 to 1; NULL where none was seen';
COMMENT ON COLUMN ab_verdict_row.deviation IS
    'Median deviation of the face meant along its outward normal, metres, + in front of it (outside): of the largest '
    'face that is certainly off, else of the largest; NULL where no face is seen';
COMMENT ON COLUMN ab_verdict_row.deviation_sd IS 'Standard deviation of deviation, metres';
COMMENT ON COLUMN ab_verdict_row.shift IS
    'Rigid offset of the built object from the drawn one: three elements along the world''s x, y, z, metres, + along '
    'the axis; an element is NULL where the seen faces do not determine that axis to 6 degrees; NULL where none is';
COMMENT ON COLUMN ab_verdict_row.shift_sd IS 'Standard deviation of each element of shift, metres; NULL where that is';
COMMENT ON COLUMN ab_verdict_row.deviation_normal IS
    'Outward unit normal of the face that deviation is of, along the axes of the world; NULL where that is';
COMMENT ON COLUMN ab_verdict_row.deviation_face IS
    'Number of that face, in the order of ab_faces, from 1; the same in every epoch in which it is well seen';
COMMENT ON COLUMN ab_verdict_row.reason IS
    'Why it is unobserved, by the largest share: hidden_by_object, hidden_by_other, too_few, too_steep, not_looked_at, '
    'no_return or shared_face; NULL for other verdicts, and where only ab_evidence_agg looked';
COMMENT ON COLUMN ab_verdict_row.reason_shares IS
    'Share of the samples for each reason: hidden by another drawn object, hidden by what nobody drew, too few beams, '
    'beams too steep, not looked at, nothing returned, on a face that another object shares; each 0 to 1, in sum 1; NULL '
    'where reason is';
COMMENT ON COLUMN ab_verdict_row.hidden_by IS
    'Id of the object that hides most of what drawn objects hide of an unobserved one; NULL where none does';
COMMENT ON COLUMN ab_verdict_row.drawn_twice IS
    'Id of another object that is drawn at the same place, 95 % of the surface of each within 10 mm of the other: the '
    'same body in two models, judged as one; NULL where none is';

CREATE FUNCTION ab_verify_table(
    objects text, scans text, model ab_evidence_model DEFAULT NULL, keep_evidence boolean DEFAULT true,
    min_confirmed float8 DEFAULT NULL, min_coverage float8 DEFAULT NULL,
    max_conflict float8 DEFAULT NULL) RETURNS SETOF ab_verdict_row
    AS 'MODULE_PATHNAME', 'ab_verify_table' LANGUAGE c STABLE PARALLEL RESTRICTED COST 100000000 ROWS 1000;
COMMENT ON FUNCTION ab_verify_table(text, text, ab_evidence_model, boolean, float8, float8, float8) IS
    'Evidence and verdict of every object of one query (id, solid, perhaps its own ab_evidence_model) from the '
    'patches of another; every patch is unpacked once for all objects. Uses as many threads as a parallel plan would '
    'have processes (max_parallel_workers_per_gather + 1)';

CREATE TYPE ab_change_class AS ENUM ('unchanged', 'appeared', 'gone', 'moved', 'partly', 'not_comparable');
COMMENT ON TYPE ab_change_class IS
    'What became of an object between two epochs: it stands as before (or in neither of them), it appeared, it is '
    'gone, it stands elsewhere than before, part of it appeared or is gone, or too little of it was seen in both';

-- What became of objects.
CREATE TYPE ab_object_change_row AS (
    id bigint, change ab_change_class, seen_in_both float8, shift float8[], shift_sd float8[], shift_chance float8,
    samples bigint, in_both float8, only_in_old float8, only_in_new float8, in_neither float8);
COMMENT ON TYPE ab_object_change_row IS 'What became of an object between two epochs, and the numbers that say so';
COMMENT ON COLUMN ab_object_change_row.id IS 'The object''s id, from the query of objects';
COMMENT ON COLUMN ab_object_change_row.change IS 'What became of it; NULL without a solid';
COMMENT ON COLUMN ab_object_change_row.seen_in_both IS
    'Share of the samples on its surface that both epochs saw, 0 to 1; NULL without a solid';
COMMENT ON COLUMN ab_object_change_row.shift IS
    'Offset of the object in the new epoch against the old one: three elements along the world''s x, y, z, metres, + '
    'along the axis; an element is NULL where the faces that both epochs saw do not determine that axis to 6 degrees; '
    'NULL where none does, and where the object appeared, is gone or is not comparable';
COMMENT ON COLUMN ab_object_change_row.shift_sd IS
    'Standard deviation of each element of shift, the registrations of both epochs included, metres; NULL where that '
    'is';
COMMENT ON COLUMN ab_object_change_row.shift_chance IS
    'Probability of so long a shift by chance if the object did not move, 0 to 1; NULL where shift is';
COMMENT ON COLUMN ab_object_change_row.samples IS 'Number of samples on the surface of the solid; NULL without a solid';
COMMENT ON COLUMN ab_object_change_row.in_both IS
    'Share of the samples that both epochs saw that show the object in both, 0 to 1; NULL where there are none. With '
    'the next three less than 1: what hides it, or is not sure, says nothing';
COMMENT ON COLUMN ab_object_change_row.only_in_old IS
    'Share of them that show it in the old epoch, and its place empty in the new one, 0 to 1; NULL where there are '
    'none';
COMMENT ON COLUMN ab_object_change_row.only_in_new IS
    'Share of them that show its place empty in the old epoch, and it in the new one, 0 to 1; NULL where there are '
    'none';
COMMENT ON COLUMN ab_object_change_row.in_neither IS
    'Share of them that show its place empty in both, 0 to 1; NULL where there are none';

CREATE FUNCTION ab_change_table(
    objects text, old_scans text, new_scans text, model ab_evidence_model DEFAULT NULL,
    new_model ab_evidence_model DEFAULT NULL) RETURNS SETOF ab_object_change_row
    AS 'MODULE_PATHNAME', 'ab_change_table' LANGUAGE c STABLE PARALLEL RESTRICTED COST 200000000 ROWS 1000;
COMMENT ON FUNCTION ab_change_table(text, text, text, ab_evidence_model, ab_evidence_model) IS
    'What became of every object of one query (id, solid, perhaps its own ab_evidence_model) between the patches of a '
    'second and of a third one, where it is drawn; objects know each other as in ab_verify_table. new_model: how the '
    'new epoch was surveyed (standard deviations, incidence, beams without return), for all objects; NULL for as the '
    'old one. Threads as in ab_verify_table';

CREATE TYPE ab_station_row AS (station bigint, origin float8[], seen bigint, added bigint);
COMMENT ON TYPE ab_station_row IS 'What a station contributed to evidence';
COMMENT ON COLUMN ab_station_row.station IS 'Number of the station';
COMMENT ON COLUMN ab_station_row.origin IS
    'Where its beams start: x, y, z, world metres; NULL for moving platforms and points without origin';
COMMENT ON COLUMN ab_station_row.seen IS 'Number of samples that it sees by itself';
COMMENT ON COLUMN ab_station_row.added IS 'Number of samples that would be unseen without it';

CREATE FUNCTION ab_stations(evidence ab_evidence) RETURNS SETOF ab_station_row
    AS 'MODULE_PATHNAME', 'ab_stations' LANGUAGE c STABLE PARALLEL SAFE COST 10000000 ROWS 5;
COMMENT ON FUNCTION ab_stations(ab_evidence) IS
    'What each station contributed: the samples that it sees by itself, and those that would be unseen without it; '
    'origin NULL for moving platforms and points without origin';

CREATE FUNCTION ab_explain(
    evidence ab_evidence, loa ab_loa DEFAULT NULL, confidence float8 DEFAULT NULL, min_confirmed float8 DEFAULT NULL,
    min_coverage float8 DEFAULT NULL, max_conflict float8 DEFAULT NULL) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_explain' LANGUAGE c STABLE PARALLEL SAFE COST 10000000;
COMMENT ON FUNCTION ab_explain(ab_evidence, ab_loa, float8, float8, float8, float8) IS
    'Why the verdict is what it is: what was seen, what that says, which threshold decided, why no finer level of '
    'accuracy holds';

CREATE TYPE ab_sensor_row AS (
    name text, sigma_range float8, sigma_angle float8, sigma_station float8, max_range float8, description text);
COMMENT ON TYPE ab_sensor_row IS 'Standard uncertainties of a kind of scanner';
COMMENT ON COLUMN ab_sensor_row.name IS 'The name that ab_with_sensor takes';
COMMENT ON COLUMN ab_sensor_row.sigma_range IS 'Standard deviation of a range, metres';
COMMENT ON COLUMN ab_sensor_row.sigma_angle IS 'Standard deviation of an angle, radians';
COMMENT ON COLUMN ab_sensor_row.sigma_station IS
    'Standard deviation of a station''s registration along an axis, metres';
COMMENT ON COLUMN ab_sensor_row.max_range IS 'Farthest that it measures, metres';
COMMENT ON COLUMN ab_sensor_row.description IS 'What kind of scanner it is';

CREATE FUNCTION ab_sensor(sensor text DEFAULT NULL) RETURNS SETOF ab_sensor_row
    AS 'MODULE_PATHNAME', 'ab_sensor' LANGUAGE c IMMUTABLE PARALLEL SAFE ROWS 6;
COMMENT ON FUNCTION ab_sensor(text) IS
    'Standard uncertainties of a kind of scanner, of the order that field tests by ISO 17123-9 find: phase, hybrid, '
    'pulse, compact, handheld or tablet; all without a name. Metres and radians';

CREATE FUNCTION ab_with_sensor(model ab_evidence_model, sensor text) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_with_sensor' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_with_sensor(ab_evidence_model, text) IS
    'The same parameters with a sensor''s standard uncertainties: sigma_range, sigma_angle and sigma_station of '
    'ab_sensor';

CREATE FUNCTION ab_with_intensity(
    model ab_evidence_model, reference integer, exponent float8 DEFAULT 1) RETURNS ab_evidence_model
    AS 'MODULE_PATHNAME', 'ab_with_intensity' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_with_intensity(ab_evidence_model, integer, float8) IS
    'The same parameters with range noise by intensity: sigma_range holds from the reference on (the sensor''s own '
    'unit), below it the variance grows by (reference/intensity)^exponent. For patches with intensities; exponent 1 '
    'is shot noise';

-- Evidence from tie points.
CREATE FUNCTION _ab_evidence_accum(
    state internal, solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_model_accum_point' LANGUAGE c IMMUTABLE PARALLEL SAFE COST 2000;
COMMENT ON FUNCTION _ab_evidence_accum(internal, ab_solid, ab_point, float8[], ab_evidence_model) IS
    'Transition of ab_evidence_agg over tie points';

CREATE AGGREGATE ab_evidence_agg(solid ab_solid, point ab_point, cameras float8[], model ab_evidence_model) (
    SFUNC = _ab_evidence_accum, STYPE = internal, SSPACE = 1000000, COMBINEFUNC = _ab_evidence_combine,
    SERIALFUNC = _ab_evidence_serial, DESERIALFUNC = _ab_evidence_deserial, FINALFUNC = _ab_evidence_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_evidence_agg(ab_solid, ab_point, float8[], ab_evidence_model) IS
    'What tie points say about one solid: a surface at each point, once, with the point''s own covariance, and empty '
    'space along the rays from its cameras (n x 3, metres). Choose spacing near the distance of the points; join '
    'the objects that the rays may have pierced too, not only those near the points. The model meyer2022 takes every '
    'ray as a source of its own, without covariance. A NULL point keeps the object';
