-- docs/api.md, from the catalogue.
\pset pager off
SELECT '# SQL reference' || E'\n\n' || 'Made from the COMMENTs in the database by `make docs`. Lengths in metres, angles in radians.' || E'\n\n' || '## Types' || E'\n\n' || '| type | what |' || E'\n' || '| --- | --- |';
CREATE TEMP VIEW member AS
SELECT d.classid, d.objid FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND d.refclassid = 'pg_extension'::regclass
WHERE x.extname = 'asbuilt' AND d.deptype = 'e';
SELECT format('| `%s` | %s |', t.typname, obj_description(t.oid, 'pg_type'))
FROM member m JOIN pg_type t ON m.classid = 'pg_type'::regclass AND m.objid = t.oid
WHERE t.typname !~ '^_|_010$' AND t.typtype <> 'c' ORDER BY t.typname;
SELECT E'\n## Functions and aggregates\n\n| function | returns | what |\n| --- | --- | --- |';
SELECT format('| `%s(%s)` | `%s` | %s |', p.proname, pg_get_function_arguments(p.oid), pg_get_function_result(p.oid), obj_description(p.oid, 'pg_proc'))
FROM member m JOIN pg_proc p ON m.classid = 'pg_proc'::regclass AND m.objid = p.oid
WHERE p.proname !~ '^_'
ORDER BY p.proname, pg_get_function_arguments(p.oid);
SELECT E'\n## Rows\n\nWhat functions of several columns return. Later versions add columns at the end.';
SELECT coalesce(CASE WHEN a.attnum = 1 THEN format(E'\n### %s\n\n%s.\n\n| column | type | what |\n| --- | --- | --- |\n', t.typname, obj_description(t.oid, 'pg_type')) END, '')
    || format('| `%s` | `%s` | %s |', a.attname, format_type(a.atttypid, NULL), col_description(a.attrelid, a.attnum))
FROM member m JOIN pg_type t ON m.classid = 'pg_type'::regclass AND m.objid = t.oid AND t.typtype = 'c'
JOIN pg_attribute a ON a.attrelid = t.typrelid AND a.attnum > 0 ORDER BY t.typname, a.attnum;
SELECT E'\n## Operators\n\n| operator | what |\n| --- | --- |';
SELECT format('| `%s %s %s` | %s |', format_type(o.oprleft, NULL), o.oprname, format_type(o.oprright, NULL), obj_description(o.oid, 'pg_operator'))
FROM member m JOIN pg_operator o ON m.classid = 'pg_operator'::regclass AND m.objid = o.oid
ORDER BY o.oprname, format_type(o.oprleft, NULL), format_type(o.oprright, NULL);
SELECT E'\n## Operator classes\n\n| class | for | what |\n| --- | --- | --- |';
SELECT format('| `%s` (%s) | `%s` | %s |', c.opcname, CASE a.amname WHEN 'gist' THEN 'GiST' ELSE a.amname END, format_type(c.opcintype, NULL), obj_description(c.oid, 'pg_opclass'))
FROM member m JOIN pg_opclass c ON m.classid = 'pg_opclass'::regclass AND m.objid = c.oid JOIN pg_am a ON a.oid = c.opcmethod ORDER BY c.opcname;
