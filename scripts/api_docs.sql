-- docs/api.md, from the catalogue and from the table file (topic, source, result): docs/examples and what they print.
CREATE TEMP VIEW member AS
SELECT d.classid, d.objid FROM pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND d.refclassid = 'pg_extension'::regclass
WHERE x.extname = 'asbuilt' AND d.deptype = 'e';

-- A file begins with its title, a few sentences, and what its examples share; then come the examples.
CREATE TEMP TABLE topic AS
SELECT topic, (regexp_match(source, '^-- ([^\n]*)'))[1] AS title, replace(says[1], '-- ', '') AS says,
       btrim((regexp_match(source, '^(?:--[^\n]*\n)*(.*?)(?:\n-- ab_|$)'))[1], E'\n') AS shared
FROM  (SELECT *, regexp_match(source, '^--[^\n]*\n((?:-- (?!ab_)[^\n]*\n)*)') AS says FROM file) f;

CREATE TEMP TABLE example AS
SELECT s.topic, s.n, (regexp_match(s.part, '^[^\n]*'))[1] AS head, btrim(substr(s.part, strpos(s.part, E'\n')), E' \n') AS sql,
       btrim(substr(r.part, strpos(r.part || E'\n', E'\n')), E'\n') AS result
FROM  (SELECT topic, n, part FROM file,
       regexp_split_to_table(source, '^-- (?=ab_[a-z0-9_]+(?:\([^)]*\))?(?: and ab_[a-z0-9_]+(?:\([^)]*\))?)*$)', 'n')
       WITH ORDINALITY u(part, n)) s
JOIN  (SELECT topic, n, regexp_replace(part, ' *\+?$', '', 'gn') AS part FROM file, regexp_split_to_table(result, '^@@ ', 'n')
       WITH ORDINALITY u(part, n)) r USING (topic, n)
WHERE  n > 1;

CREATE TEMP TABLE entry AS
SELECT p.oid, p.proname AS name, oidvectortypes(p.proargtypes) AS arguments,
       format('%s(%s)', p.proname, replace(regexp_replace(pg_get_function_arguments(p.oid), '::[a-z_ ]+(\[\])?(?=,|$)', '', 'g'),
                                           'double precision', 'float8')) AS signature,
       replace(pg_get_function_result(p.oid), 'double precision', 'float8') AS result,
       p.prokind = 'a' AS is_aggregate, t.typrelid AS row, t.typname AS row_name, obj_description(p.oid, 'pg_proc') AS what
FROM   member m JOIN pg_proc p ON m.classid = 'pg_proc'::regclass AND m.objid = p.oid
       JOIN pg_type t ON t.oid = p.prorettype
WHERE  p.proname ~ '^ab_';

-- A head is a name, for all overloads that no other head names with their arguments, or a name with its arguments.
CREATE TEMP TABLE head AS
SELECT topic, n, h AS head, split_part(h, '(', 1) AS name, CASE WHEN h ~ '\(' THEN to_regprocedure(h)::oid END AS oid
FROM   example, regexp_split_to_table(head, ' and ') h;
CREATE TEMP TABLE shown AS
SELECT h.topic, h.n, h.head, e.* FROM head h JOIN entry e ON e.oid = h.oid
    OR h.head = e.name AND NOT EXISTS (SELECT FROM head o WHERE o.oid = e.oid);

DO $$
DECLARE faults text;
BEGIN
    SELECT string_agg(fault, E'\n' ORDER BY fault) INTO faults FROM (
        SELECT format('no example in docs/examples: %s(%s)', name, arguments) FROM entry WHERE oid NOT IN (SELECT oid FROM shown)
        UNION ALL
        SELECT format('%s: more than one example', oid::regprocedure) FROM shown GROUP BY oid HAVING count(*) > 1
        UNION ALL
        SELECT format('docs/examples/%s.sql: %s is no function, or has its example elsewhere', topic, h.head)
        FROM head h WHERE NOT EXISTS (SELECT FROM shown s WHERE (s.topic, s.n, s.head) = (h.topic, h.n, h.head))
        UNION ALL
        SELECT format('docs/examples/%s.sql: %s is not called in its example', topic, h.head)
        FROM head h JOIN example e USING (topic, n) WHERE e.sql !~ format('\m%s\(', h.name)
        UNION ALL
        SELECT format('docs/examples/%s.sql: %s: %s', topic, head, CASE
            WHEN result = '' THEN 'nothing to look at'
            WHEN result ~ '[0-9a-f]{40}' THEN 'a long hex value'
            WHEN result ~ 'e-(1[1-9]|[2-9][0-9])' THEN 'a number that is but rounding'
            ELSE 'a result of more than 24 lines or 160 characters' END)
        FROM example WHERE result = '' OR result ~ '[0-9a-f]{40}|e-(1[1-9]|[2-9][0-9])' OR result ~ '(\n.*){24}' OR result ~ '[^\n]{161}'
        UNION ALL
        SELECT format('docs/examples/%s.sql: no title', topic) FROM topic WHERE title IS NULL
    ) f(fault);
    IF faults IS NOT NULL THEN RAISE EXCEPTION E'docs/examples:\n%', faults; END IF;
END $$;

SELECT E'# SQL reference\n\nMade by `make docs` from the COMMENTs in the database and from [docs/examples](examples), whose SQL it runs.\n'
    || E'Lengths in metres, angles in radians. Results are printed with six digits (`extra_float_digits = -9`).\n\n'
    || string_agg(format('- [%s](#%s)', title, replace(lower(regexp_replace(title, '[^A-Za-z0-9 _-]', '', 'g')), ' ', '-')), E'\n' ORDER BY place, title)
FROM  (SELECT 1 AS place, 'Types' AS title UNION ALL SELECT 3, unnest(ARRAY['Operators', 'Operator classes'])) f
      FULL JOIN (SELECT 2 AS place, title, topic FROM topic) t USING (place, title);

SELECT E'\n## Types\n\n| type | what |\n| --- | --- |';
SELECT format('| `%s` | %s |', t.typname, obj_description(t.oid, 'pg_type'))
FROM member m JOIN pg_type t ON m.classid = 'pg_type'::regclass AND m.objid = t.oid
WHERE t.typname !~ '^_|_010$' AND t.typtype <> 'c' ORDER BY t.typname;

-- Topic by topic, in the order of its examples: signatures, columns of rows, the example and what it prints.
SELECT text FROM (
    SELECT topic, 0 AS n, format(E'\n## %s\n', title) || coalesce(E'\n' || nullif(says, ''), '')
        || CASE WHEN shared <> '' THEN format(E'\nThe examples of this topic use:\n\n```sql\n%s\n```\n', shared) ELSE '' END AS text
    FROM topic
    UNION ALL
    SELECT topic, n, format(E'### %s\n\n%s\n%s\n```sql\n%s\n```\n\n```text\n%s\n```\n', replace(e.head, 'double precision', 'float8'),
        (SELECT string_agg(format('- `%s` → `%s`%s: %s', signature, result, CASE WHEN is_aggregate THEN ', aggregate' ELSE '' END, what),
                           E'\n' ORDER BY is_aggregate, signature) FROM shown s WHERE (s.topic, s.n) = (e.topic, e.n)),
        coalesce((SELECT string_agg(columns, '' ORDER BY row_name) FROM (
            SELECT row_name, format(E'\nColumns of `%s`:\n\n| column | type | what |\n| --- | --- | --- |\n%s\n', row_name,
                string_agg(format('| `%s` | `%s` | %s |', a.attname, replace(format_type(a.atttypid, NULL), 'double precision', 'float8'),
                                  col_description(a.attrelid, a.attnum)), E'\n' ORDER BY a.attnum)) AS columns
            FROM (SELECT DISTINCT row, row_name FROM shown s WHERE (s.topic, s.n) = (e.topic, e.n)) s
                 JOIN pg_attribute a ON a.attrelid = s.row AND a.attnum > 0 AND NOT a.attisdropped
            WHERE s.row <> 0 GROUP BY row_name) c), ''),
        e.sql, e.result)
    FROM example e) x
ORDER BY topic, n;

SELECT E'## Operators\n\n| operator | what |\n| --- | --- |';
SELECT format('| `%s %s %s` | %s |', format_type(o.oprleft, NULL), o.oprname, format_type(o.oprright, NULL), obj_description(o.oid, 'pg_operator'))
FROM member m JOIN pg_operator o ON m.classid = 'pg_operator'::regclass AND m.objid = o.oid
ORDER BY o.oprname, format_type(o.oprleft, NULL), format_type(o.oprright, NULL);

SELECT E'\n## Operator classes\n\n| class | index | for | what |\n| --- | --- | --- | --- |';
SELECT format('| `%s` | %s | `%s` | %s |', c.opcname, CASE a.amname WHEN 'gist' THEN 'GiST' ELSE a.amname END, format_type(c.opcintype, NULL), obj_description(c.oid, 'pg_opclass'))
FROM member m JOIN pg_opclass c ON m.classid = 'pg_opclass'::regclass AND m.objid = c.oid JOIN pg_am a ON a.oid = c.opcmethod ORDER BY c.opcname;
