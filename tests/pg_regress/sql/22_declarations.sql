-- Every C function is declared in SQL as its body reads its arguments (sql_functions! in src).
CREATE TEMP VIEW reads AS
SELECT word[1] AS symbol, word[2:] AS parameters
FROM (SELECT string_to_array(line, ' ') AS word FROM _ab_declared() line) AS function;
CREATE TEMP VIEW c_function AS
SELECT p.oid::regprocedure AS function, p.proisstrict, p.proargtypes::oid[] AS types, p.pronargs, r.*
FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND x.extname = 'asbuilt' AND d.deptype = 'e'
JOIN pg_proc p ON d.classid = 'pg_proc'::regclass AND d.objid = p.oid
JOIN pg_language l ON l.oid = p.prolang AND l.lanname = 'c' LEFT JOIN reads r ON r.symbol = p.prosrc;
SELECT count(*) > 500 AS functions, count(DISTINCT symbol) > 390 AS symbols, sum(pronargs) > 1000 AS parameters,
       count(*) FILTER (WHERE symbol IS NULL) AS not_told FROM c_function;
SELECT symbol AS told_twice FROM reads GROUP BY symbol HAVING count(*) > 1;

-- Types; where one symbol serves several they stand side by side.
CREATE TEMP VIEW other_type AS
SELECT function, n, declared, parameters[n] AS reads
FROM c_function, unnest(types) WITH ORDINALITY AS given(type, n)
JOIN pg_type t ON t.oid = type LEFT JOIN pg_type e ON e.oid = t.typelem AND t.typcategory = 'A',
coalesce(e.typname || '[]', t.typname) AS declared
WHERE declared <> ALL (string_to_array(coalesce(rtrim(parameters[n], '?'), ''), '|'));
-- What the declaration leaves out at the end may be NULL.
CREATE TEMP VIEW too_few AS
SELECT function, parameters FROM c_function
WHERE EXISTS (SELECT FROM unnest(parameters[pronargs + 1:]) AS rest WHERE rest NOT LIKE '%?');
-- STRICT if no parameter may be NULL, and only then; without parameters it means nothing.
CREATE TEMP VIEW other_null AS
SELECT function, proisstrict, parameters FROM c_function
WHERE pronargs > 0 AND proisstrict = ('?' = ANY (SELECT right(p, 1) FROM unnest(parameters) p));
SELECT * FROM other_type ORDER BY 1::text, 2;
SELECT * FROM too_few ORDER BY 1::text;
SELECT * FROM other_null ORDER BY 1::text;

-- Several types: what is compared as bytes, tiles, which begin alike, and GiST, where the strategy number tells which.
SELECT regexp_replace(array_to_string(parameters, ', '), 'ab_solid\|ab_scan\|ab_evidence\|\S+', 'any bytes', 'g')
       AS several, string_agg(symbol, ' ' ORDER BY symbol COLLATE "C") AS symbols
FROM reads WHERE array_to_string(parameters, ' ') LIKE '%|%' GROUP BY 1 ORDER BY min(symbol) COLLATE "C";

-- A default that SQL writes and the library has, too. Evidence without a model has all of the library's own; what rows
-- are packed with is what ab_scan() says. (A default of NULL is known to the library alone.)
SELECT proname AS function, parameter, (regexp_match(written, '^''?([^'':]*)'))[1] AS in_sql, value AS in_library
FROM (SELECT ab_model(ab_evidence_agg(ab_solid(ab_box(0, 0, 0, 1, 1, 1)), NULL, NULL::ab_evidence_model))) AS all_of(model),
     string_to_table(model::text, ' ') AS word,
     split_part(word, '=', 1) AS name, split_part(word, '=', 2) AS value,
     pg_proc, generate_series(1, pronargs) AS n, pg_get_function_arg_default(pg_proc.oid, n) AS written,
     LATERAL (SELECT proargnames[n] AS parameter) AS named
WHERE proname IN ('ab_evidence_model', '_ab_evidence_model_make_010', 'ab_ray_mass', 'ab_lambda', 'ab_surface_mass')
      AND parameter = name AND written NOT LIKE 'NULL%'
ORDER BY proname, parameter COLLATE "C";
SELECT (SELECT ab_scan_agg(x, 0, 0, ARRAY[0, 0, 0]) FROM generate_series(5, 6) x)[1]::text
       = ab_scan(ARRAY[0, 0, 0], ARRAY[[5, 0, 0], [6, 0, 0]])::text AS same_station_step_and_quantum;

-- The test itself: declarations that differ are found.
BEGIN;
CREATE FUNCTION wrong(ab_point, float8) RETURNS ab_box AS '$libdir/asbuilt', 'ab_box_expand' LANGUAGE c IMMUTABLE STRICT;
CREATE FUNCTION nullable(ab_box, float8) RETURNS ab_box AS '$libdir/asbuilt', 'ab_box_expand' LANGUAGE c IMMUTABLE;
CREATE FUNCTION shorter(ab_box) RETURNS ab_box AS '$libdir/asbuilt', 'ab_box_expand' LANGUAGE c IMMUTABLE STRICT;
CREATE FUNCTION longer(ab_box, float8, text) RETURNS ab_box AS '$libdir/asbuilt', 'ab_box_expand' LANGUAGE c IMMUTABLE STRICT;
ALTER EXTENSION asbuilt ADD FUNCTION wrong(ab_point, float8);
ALTER EXTENSION asbuilt ADD FUNCTION nullable(ab_box, float8);
ALTER EXTENSION asbuilt ADD FUNCTION shorter(ab_box);
ALTER EXTENSION asbuilt ADD FUNCTION longer(ab_box, float8, text);
SELECT * FROM other_type ORDER BY 1::text, 2;
SELECT * FROM too_few ORDER BY 1::text;
SELECT * FROM other_null ORDER BY 1::text;
ROLLBACK;
DROP VIEW other_type, too_few, other_null, c_function, reads;
