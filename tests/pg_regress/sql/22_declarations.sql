-- Every C function is declared in SQL as its body reads its arguments (sql_functions! in src).

CREATE VIEW declared AS
SELECT symbol, parameters, regexp_split_to_array(nullif(parameters, ''), ' ') AS list FROM _ab_declared();

-- An argument of each C function, and what the body takes it for; a type may be one of several.
CREATE VIEW argument AS
SELECT f.oid, f.oid::regprocedure::text AS function, f.prosrc AS symbol, a.i,
       coalesce(e.typname || '[]', t.typname) AS type, rtrim(d.list[a.i], '?') AS expected
FROM (SELECT p.* FROM pg_proc p JOIN pg_language l ON l.oid = p.prolang
      JOIN pg_depend x ON x.classid = 'pg_proc'::regclass AND x.objid = p.oid AND x.deptype = 'e'
      JOIN pg_extension ext ON ext.oid = x.refobjid AND ext.extname = 'asbuilt' WHERE l.lanname = 'c') f
JOIN declared d ON d.symbol = f.prosrc AND d.parameters IS NOT NULL
CROSS JOIN LATERAL unnest(f.proargtypes::oid[]) WITH ORDINALITY a(oid, i)
JOIN pg_type t ON t.oid = a.oid
LEFT JOIN pg_type e ON e.oid = t.typelem AND t.typcategory = 'A';

CREATE VIEW c_function AS
SELECT p.oid::regprocedure::text AS function, p.prosrc AS symbol, p.proisstrict AS strict, p.pronargs AS count, d.*
FROM pg_proc p JOIN pg_language l ON l.oid = p.prolang AND l.lanname = 'c'
JOIN pg_depend x ON x.classid = 'pg_proc'::regclass AND x.objid = p.oid AND x.deptype = 'e'
JOIN pg_extension ext ON ext.oid = x.refobjid AND ext.extname = 'asbuilt'
LEFT JOIN declared d(declared_symbol, parameters, list) ON d.declared_symbol = p.prosrc;

-- Symbols without a declaration, and functions that fetch their arguments themselves: this number may only fall.
SELECT count(*) FILTER (WHERE declared_symbol IS NULL) AS undeclared,
       count(*) FILTER (WHERE declared_symbol IS NOT NULL AND parameters IS NULL) AS untyped,
       count(parameters) > 500 AS typed, count(DISTINCT declared_symbol) > 390 AS symbols
FROM c_function;
SELECT symbol FROM declared GROUP BY symbol HAVING count(*) > 1;

-- Types.
SELECT function, i, type, expected FROM argument
WHERE type <> ALL (string_to_array(coalesce(expected, ''), '|')) ORDER BY 1, 2;

-- Arguments at the end may be missing where NULL is a value.
SELECT function, parameters FROM c_function WHERE count > coalesce(cardinality(list), 0)
   OR EXISTS (SELECT FROM unnest(list[count + 1:]) AS rest WHERE rest NOT LIKE '%?') ORDER BY 1;

-- STRICT where NULL is no value of any parameter, and only there.
SELECT function, strict, parameters FROM c_function
WHERE parameters IS NOT NULL AND strict <> (parameters NOT LIKE '%?%') AND count > 0 ORDER BY 1;

-- One symbol for several types: where the stored forms are compared as bytes or begin alike, and in GiST, where the
-- strategy number tells the type.
SELECT symbol, parameters FROM declared WHERE parameters LIKE '%|%' ORDER BY symbol COLLATE "C";

DROP VIEW c_function, argument, declared;
