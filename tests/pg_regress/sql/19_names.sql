-- Names: what people call, what only PostgreSQL calls, words that SQL keeps, rows and their columns.
CREATE TEMP VIEW ours AS
SELECT p.* FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND x.extname = 'asbuilt' AND d.deptype = 'e'
JOIN pg_proc p ON d.classid = 'pg_proc'::regclass AND d.objid = p.oid;
CREATE TEMP VIEW row_column AS
SELECT t.typname, a.attrelid, a.attnum, a.attname, a.atttypid
FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND x.extname = 'asbuilt' AND d.deptype = 'e'
JOIN pg_type t ON d.classid = 'pg_type'::regclass AND d.objid = t.oid AND t.typtype = 'c'
JOIN pg_attribute a ON a.attrelid = t.typrelid AND a.attnum > 0;
SELECT count(*) > 100 AS for_people, count(*) FILTER (WHERE proname ~ '^_ab_') > 300 AS for_postgresql,
       count(*) FILTER (WHERE proname !~ '^_?ab_') AS neither FROM ours;

-- Behind operators, types, indexes, the planner and aggregates: begins with _ab_. What people call may serve, too.
SELECT p.oid::regprocedure AS serves_postgresql_too FROM ours p
WHERE p.proname !~ '^_ab_'
AND  (p.oid IN (SELECT oprcode FROM pg_operator) OR p.oid IN (SELECT oprrest FROM pg_operator) OR p.oid IN (SELECT oprjoin FROM pg_operator)
   OR p.oid IN (SELECT unnest(ARRAY[typinput, typoutput, typreceive, typsend, typanalyze]) FROM pg_type)
   OR p.oid IN (SELECT amproc FROM pg_amproc)
   OR p.oid IN (SELECT unnest(ARRAY[aggtransfn, aggfinalfn, aggcombinefn, aggserialfn, aggdeserialfn]) FROM pg_aggregate)
   OR p.prokind = 'f' AND 'internal'::regtype = ANY (p.proargtypes))
ORDER BY 1::text;
-- ... and nothing else does, but what is kept of 0.1.0, and what 22_declarations asks
SELECT p.oid::regprocedure AS called_by_nobody FROM ours p
WHERE p.proname ~ '^_ab_' AND p.proname !~ '_010$' AND p.proname <> '_ab_declared'
AND NOT EXISTS (SELECT FROM pg_depend d WHERE d.refclassid = 'pg_proc'::regclass AND d.refobjid = p.oid AND d.deptype IN ('n', 'i', 'a'));
SELECT p.oid::regprocedure AS looks_like_an_array_type FROM ours p JOIN pg_type t ON t.typname = p.proname AND t.typcategory = 'A';
-- free for what comes
SELECT p.oid::regprocedure AS taken FROM ours p WHERE proname IN ('ab_tolerance', 'ab_compare', 'ab_equal', 'ab_hash');
SELECT ab_upper_bound('LOA30');

-- Words that SQL keeps are no parameters and no columns; "e" says nothing.
WITH word AS (SELECT word FROM pg_get_keywords() WHERE catcode = 'R' OR catcode = 'C' AND word <> 'position'
              UNION ALL SELECT 'e')
SELECT p.oid::regprocedure AS function, n AS kept_word FROM ours p, unnest(p.proargnames) n JOIN word ON word = n WHERE p.proname !~ '_010$'
UNION ALL SELECT NULL, typname || '.' || attname FROM row_column JOIN word ON word = attname;

-- Several columns are a named row, whose columns are explained: with unit, frame and sign.
SELECT p.oid::regprocedure AS nameless_row FROM ours p
WHERE p.proname !~ '_010$' AND (p.prorettype = 'record'::regtype OR p.proargmodes && '{o,b,t}'::"char"[]);
SELECT typname, attname AS unexplained FROM row_column WHERE coalesce(length(col_description(attrelid, attnum)), 0) < 8;
SELECT typname, attname AS without_unit FROM row_column
WHERE atttypid IN ('float8'::regtype, 'float8[]'::regtype)
AND   col_description(attrelid, attnum) !~* 'metres|radians|0 to 1|unit|squares|probability|statistic'
ORDER BY 1, 2;
SELECT DISTINCT typname FROM row_column ORDER BY 1;
SELECT typname AS returned_by_nothing FROM (SELECT DISTINCT typname FROM row_column) r
WHERE NOT EXISTS (SELECT FROM ours p JOIN pg_type t ON t.oid = p.prorettype WHERE t.typname = r.typname);
DROP VIEW ours, row_column;
