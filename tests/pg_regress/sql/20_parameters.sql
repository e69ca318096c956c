-- Parameters (ab_evidence_model, ab_grid) are stored as words: what a later release adds has room, what was not given stays away.
SELECT ab_evidence_model(), ab_evidence_model(NULL, NULL) AS nothing;
SELECT ab_evidence_model('LOA40', spacing => 0.05), ab_with_sensor(ab_evidence_model(NULL, NULL), 'phase') AS of_a_sensor;
SELECT 'LOA20'::ab_evidence_model, ''::ab_evidence_model AS nothing, 'spacing=1 loa=LOA20 spacing=2'::ab_evidence_model AS once, ab_grid(0.1);
SELECT typname, typlen FROM pg_type WHERE typname IN ('ab_evidence_model', 'ab_grid', 'ab_evidence_model_010') ORDER BY 1;

-- Given is not the same as left to the default, but evidence is made alike.
CREATE TABLE cube AS SELECT ab_solid(ab_box(0, 0, 0, 1, 1, 1)) AS solid;
SELECT ab_evidence_model() = ab_evidence_model(sigma_station => 0.001) AS same_parameters,
       (SELECT ab_evidence_agg(solid, NULL, ab_evidence_model()) = ab_evidence_agg(solid, NULL, ab_evidence_model(sigma_station => 0.001)) FROM cube) AS same_evidence,
       ab_evidence_model(sigma_model => '-0') = ab_evidence_model(sigma_model => 0) AS zero_has_no_sign;
SELECT ab_model(ab_evidence_agg(solid, NULL, 'LOA20')) AS all_of_them FROM cube;

-- Text and binary give the same value back.
CREATE TABLE parameters (model ab_evidence_model, grid ab_grid);
INSERT INTO parameters VALUES (ab_with_intensity(ab_evidence_model('LOA40', spacing => 0.1), 1200, 1.5), ab_grid(0.1, ab_box(0, 0, 0, 1, 1, 1))), ('', 'voxel=2');
\copy parameters TO '/tmp/asbuilt_regress_parameters.bin' (FORMAT binary)
CREATE TABLE back (LIKE parameters);
\copy back FROM '/tmp/asbuilt_regress_parameters.bin' (FORMAT binary)
\! rm -f /tmp/asbuilt_regress_parameters.bin
SELECT count(*) FROM parameters p JOIN back b USING (model, grid) WHERE p::text = b::text AND model::text::ab_evidence_model = model AND grid::text::ab_grid = grid;
SELECT DISTINCT model FROM (TABLE parameters UNION ALL TABLE back) x ORDER BY model;

-- Damage, and values of a later release, are told.
CREATE CAST (bytea AS ab_grid) WITHOUT FUNCTION;
CREATE CAST (bytea AS ab_evidence_model) WITHOUT FUNCTION;
\set VERBOSITY sqlstate
SELECT ab_occupancy(set_byte(_ab_grid_send(ab_grid(0.1)), 20, 0)::ab_grid);
SELECT ab_occupancy(set_byte(_ab_grid_send(ab_grid(0.1)), 0, 2)::ab_grid);
SELECT ab_with_sensor(set_byte(_ab_evidence_model_send('LOA20'), 18, 0)::ab_evidence_model, 'phase');
SELECT ab_with_sensor(_ab_grid_send(ab_grid(0.1))::ab_evidence_model, 'phase');
\set VERBOSITY default

-- The type of 0.1.0 has a fixed length, and becomes one of today where that is asked for.
CREATE TABLE old AS SELECT 'loa=LOA20 spacing=0.2'::ab_evidence_model_010 AS model;
SELECT model FROM old;
SELECT ab_with_sensor(model, 'pulse') FROM old;
SELECT (ab_summary(ab_evidence_agg(solid, NULL, model))).samples AS by_the_old_one, (ab_summary(ab_evidence_agg(solid, NULL, ab_evidence_model('LOA20', spacing => 0.2)))).samples FROM cube, old;
SELECT _ab_model_010(_ab_evidence_agg_010(solid, NULL, model)) AS as_then FROM cube, old;
ALTER TABLE old ALTER model TYPE ab_evidence_model;
SELECT model = ab_model(ab_evidence_agg(solid, NULL, model)) AS all_given FROM cube, old GROUP BY model;
DROP TABLE cube, parameters, back, old; DROP CAST (bytea AS ab_grid); DROP CAST (bytea AS ab_evidence_model);
