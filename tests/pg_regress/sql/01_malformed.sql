-- Malformed input first: every refusal names the value, none harms the backend.
\set VERBOSITY default

-- text
SELECT 'BOX3D(1 2 3)'::ab_box;
SELECT 'BOX3D(1 2 3,4 5 nan)'::ab_box;
SELECT '(0.5,0.6,0)'::ab_mass;
SELECT '(1,0)'::ab_mass;
SELECT 'LOA35'::ab_loa;
SELECT ''::ab_solid;
SELECT 'ab_solid:1:zz'::ab_solid;
SELECT 'ab_solid:1:0153'::ab_solid;
SELECT 'ab_scan:1:01'::ab_scan;
SELECT 'ab_scan:1:0950'::ab_scan;
SELECT 'ab_evidence:1:'::ab_evidence;
SELECT 'spacing=0'::ab_evidence_model;
SELECT 'colour=red'::ab_evidence_model;

-- constructors
SELECT ab_box(0, 0, 0, 1, 1, 'infinity');
SELECT ab_mass(0.7, 0.4);
SELECT ab_mass('nan', 0);
SELECT ab_combine(ab_mass(1, 0), ab_mass(0, 1));
SELECT ab_belief(ab_mass(0.5, 0.2), 'present');
SELECT ab_solid(ARRAY[[0,0,0],[1,0,0],[0,1,'nan']]::float8[], ARRAY[[0,1,2]]);
SELECT ab_solid(ARRAY[[0,0,0],[1,0,0],[0,1,'infinity']]::float8[], ARRAY[[0,1,2]]);
SELECT ab_solid(ARRAY[[0,0,0],[1,0,0],[0,1,0]]::float8[], ARRAY[[0,1,3]]);
SELECT ab_solid(ARRAY[[0,0,0],[1,0,0],[0,1,0]]::float8[], ARRAY[[0,1,-1]]);
SELECT ab_solid(ARRAY[[0,0],[1,0]]::float8[], ARRAY[[0,1,1]]);
SELECT ab_solid(ARRAY[0,1,2]::float8[], ARRAY[[0,0,0]]);
SELECT ab_solid('{}', '{}');
SELECT ab_solid(ARRAY[[0,0,0],[1,0,NULL],[0,1,0]]::float8[], ARRAY[[0,1,2]]);
SELECT ab_scan(ARRAY[0,0,0]::float8[], '{}');
SELECT ab_scan(ARRAY[0,0]::float8[], ARRAY[[1,2,3]]::float8[]);
SELECT ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[1,2,'nan']]::float8[]);
SELECT ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[1,2,3]]::float8[], step => -1);
SELECT ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[1,2,3]]::float8[], quantum => 0);
SELECT ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[1,0,0],[-1,0,0]]::float8[]);
SELECT ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[1e6,0,0]]::float8[]);
SELECT ab_scan(ARRAY[0,0,0]::float8[], (SELECT array_agg(ARRAY[5, i * 1e-4, 0]::float8[]) FROM generate_series(1, 4097) i));
SELECT ab_evidence_model(sigma_range => -0.001);
SELECT ab_evidence_model(model => 'other');
SELECT ab_evidence_model(spacing => 'nan');
SELECT ab_evidence_model(confidence => 1);

-- binary: truncated, too long, not finite, huge counts, newer versions
SELECT encode(_ab_solid_send(ab_solid(ab_box(0,0,0,1,1,1))), 'hex') AS solid \gset
SELECT encode(_ab_scan_send(ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[1,0,0],[1,0.01,0]]::float8[])), 'hex') AS scan \gset
SELECT ('ab_solid:1:' || left(:'solid', 100))::ab_solid;
SELECT ('ab_solid:1:' || :'solid' || '00')::ab_solid;
SELECT ('ab_solid:1:09' || substr(:'solid', 3))::ab_solid;
SELECT ('ab_solid:1:' || overlay(:'solid' placing 'ffffffff' from 9 for 8))::ab_solid;
SELECT ('ab_solid:1:' || overlay(:'solid' placing '000000000000f87f' from 161 for 16))::ab_solid;
SELECT ('ab_scan:1:' || left(:'scan', 380))::ab_scan;
SELECT ('ab_scan:1:' || left(:'scan', length(:'scan') - 2))::ab_scan;
SELECT ('ab_scan:1:09' || substr(:'scan', 3))::ab_scan;
SELECT ('ab_scan:1:' || overlay(:'scan' placing 'ffffffff' from 9 for 8))::ab_scan;
SELECT ('ab_scan:1:' || overlay(:'scan' placing 'ff' from length(:'scan') - 1 for 2))::ab_scan;

SELECT ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[1,2,3]]::float8[], step => 1e39);
SELECT ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[1,2,3]]::float8[], step => 1e-50);
SELECT encode(_ab_evidence_send(ab_evidence_agg(ab_solid(ab_box(5,-0.1,-0.1,5.1,0.1,0.1)), ab_scan(ARRAY[0,0,0]::float8[], ARRAY[[5,0,0],[5,0.01,0]]::float8[], 0.002), ab_evidence_model(spacing => 0.1))), 'hex') AS evidence \gset
SELECT ('ab_evidence:1:' || left(:'evidence', 300))::ab_evidence;
SELECT ('ab_evidence:1:' || :'evidence' || '00')::ab_evidence;
SELECT ('ab_evidence:1:09' || substr(:'evidence', 3))::ab_evidence;
SELECT ('ab_evidence:1:' || overlay(:'evidence' placing 'ffffffff' from 33 for 8))::ab_evidence;
SELECT ('ab_evidence:1:' || overlay(:'evidence' placing 'ffffffff' from 41 for 8))::ab_evidence;
SELECT ('ab_evidence:1:' || overlay(:'evidence' placing 'ffffffffffffef7f' from 209 for 16))::ab_evidence;

-- evidence that does not belong together
WITH w AS (SELECT ab_evidence_agg(ab_solid(ab_box(0,0,0,1,1,1)), NULL, ab_evidence_model()) a,
                  ab_evidence_agg(ab_solid(ab_box(0,0,0,1,1,2)), NULL, ab_evidence_model()) b)
SELECT ab_rollup(a, b) FROM w;
WITH w AS (SELECT ab_evidence_agg(ab_solid(ab_box(0,0,0,1,1,1)), NULL, ab_evidence_model(spacing => 0.1)) a,
                  ab_evidence_agg(ab_solid(ab_box(0,0,0,1,1,1)), NULL, ab_evidence_model(spacing => 0.2)) c)
SELECT ab_rollup(a, c) FROM w;
SELECT ab_evidence_agg(ab_solid(ab_box(0,0,0,1,1,i)), NULL, ab_evidence_model()) FROM generate_series(1, 2) i;
-- a solid that is too large for the spacing is sampled more coarsely; one without area not at all
SELECT ab_count(ab_evidence_agg(ab_solid(ab_box(0,0,0,100,100,1)), NULL, ab_evidence_model())) BETWEEN 4999990 AND 5000010 AS coarser;
SELECT ab_count(e), ab_verdict(e) FROM (SELECT ab_evidence_agg(ab_solid(ARRAY[[0,0,0],[1,0,0],[2,0,0]]::float8[], ARRAY[[0,1,2]]), NULL, ab_evidence_model()) e) x;


SELECT ab_expand(ab_box(0,0,0,1,2,3), -0.6);

-- the backend is still there
SELECT 'alive';
