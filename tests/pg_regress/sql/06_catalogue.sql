-- Every object has a comment, states volatility, strictness, PARALLEL; nothing depends on the search path.
SELECT p.oid::regprocedure AS without_comment
FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND x.extname = 'asbuilt' AND d.deptype = 'e'
JOIN pg_proc p ON d.classid = 'pg_proc'::regclass AND d.objid = p.oid
WHERE obj_description(p.oid, 'pg_proc') IS NULL;
SELECT p.oid::regprocedure AS not_parallel_safe
FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND x.extname = 'asbuilt' AND d.deptype = 'e'
JOIN pg_proc p ON d.classid = 'pg_proc'::regclass AND d.objid = p.oid
WHERE p.proparallel <> 's' OR p.provolatile = 'v';
SELECT t.typname AS without_comment
FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND x.extname = 'asbuilt' AND d.deptype = 'e'
JOIN pg_type t ON d.classid = 'pg_type'::regclass AND d.objid = t.oid
WHERE obj_description(t.oid, 'pg_type') IS NULL AND t.typname !~ '^_';
SELECT count(*) > 60 AS there_are_many FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND x.extname = 'asbuilt' AND d.deptype = 'e';
SELECT opcname, amvalidate(oid) FROM pg_opclass WHERE opcname ~ '^ab_' ORDER BY 1;

-- moved to another schema, with an empty search path
CREATE SCHEMA elsewhere;
ALTER EXTENSION asbuilt SET SCHEMA elsewhere;
SET search_path = pg_catalog;
SELECT verdict, best_loa, samples FROM elsewhere.ab_summary(
    (SELECT elsewhere.ab_evidence_agg(elsewhere.ab_solid(elsewhere.ab_box(0,0,0,1,1,1)), NULL, elsewhere.ab_evidence_model('LOA20'))));
SELECT loa FROM elsewhere.ab_loa_class() LIMIT 1;
RESET search_path;
ALTER EXTENSION asbuilt SET SCHEMA public;
DROP SCHEMA elsewhere;

-- a plain owner of the database may create it
CREATE ROLE asbuilt_plain;
GRANT CREATE ON DATABASE asbuilt_regress TO asbuilt_plain;
DROP EXTENSION asbuilt;
SET ROLE asbuilt_plain;
CREATE SCHEMA plain;
CREATE EXTENSION asbuilt SCHEMA plain;
SELECT plain.ab_mass(0.5, 0.25);
RESET ROLE;
DROP EXTENSION asbuilt;
DROP OWNED BY asbuilt_plain; DROP ROLE asbuilt_plain;
CREATE EXTENSION asbuilt;
