-- docs/api.md, from the catalogue, from the table file (topic, source, result): docs/examples and what they print, and
-- from the table released (release, kind, name, arguments): functions and types of the earlier releases.
CREATE TEMP VIEW member AS
SELECT d.classid, d.objid
FROM   pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND d.refclassid = 'pg_extension'::regclass
WHERE  x.extname = 'asbuilt' AND d.deptype = 'e';

-- Parts of a file: first its title, a few sentences and what its examples share; then the examples, each with its head.
CREATE TEMP TABLE part AS
SELECT topic, n, part FROM file, regexp_split_to_table(source,
       '^-- (?=ab_[a-z0-9_]+(?:\([^)]*\))?(?: and ab_[a-z0-9_]+(?:\([^)]*\))?)*$)', 'n') WITH ORDINALITY u(part, n);
CREATE TEMP TABLE topic AS
SELECT topic, (regexp_match(part, '^-- ([^\n]*)'))[1] AS title,
       rtrim(replace((regexp_match(part, '^--[^\n]*\n((?:--[^\n]*\n)*)'))[1], '-- ', ''), E'\n') AS says,
       btrim(regexp_replace(part, '^(--[^\n]*\n)*', ''), E'\n') AS shared
FROM   part WHERE n = 1;
CREATE TEMP TABLE example AS
SELECT topic, n, (regexp_match(s.part, '^[^\n]*'))[1] AS head,
       btrim(substr(s.part, strpos(s.part, E'\n')), E' \n') AS sql,
       btrim(substr(r.part, strpos(r.part || E'\n', E'\n')), E'\n') AS result
FROM   part s JOIN
      (SELECT topic, n, regexp_replace(part, ' *\+?$', '', 'gn') AS part    -- psql's + at the end of a line in a cell
       FROM   file, regexp_split_to_table(result, '^@@ ', 'n') WITH ORDINALITY u(part, n)) r USING (topic, n)
WHERE  n > 1;

-- The first of some releases; without any, the one that is installed.
CREATE FUNCTION pg_temp.first(releases text[]) RETURNS text LANGUAGE sql RETURN (
    SELECT coalesce((SELECT r FROM unnest(releases) r ORDER BY string_to_array(r, '.')::integer[] LIMIT 1),
                    (SELECT extversion FROM pg_extension WHERE extname = 'asbuilt')));
CREATE FUNCTION pg_temp.short(type text) RETURNS text LANGUAGE sql RETURN replace(type, 'double precision', 'float8');
CREATE TEMP TABLE entry AS
SELECT p.oid, p.proname AS name, oidvectortypes(p.proargtypes) AS arguments,
       format('%s(%s)', p.proname, pg_temp.short(regexp_replace(
           pg_get_function_arguments(p.oid), '::[a-z_ ]+(\[\])?(?=,|$)', '', 'g'))) AS signature,
       pg_temp.short(pg_get_function_result(p.oid)) AS result, p.prokind = 'a' AS is_aggregate,
       t.typrelid AS row, t.typname AS row_name, obj_description(p.oid, 'pg_proc') AS what, p.pronargs, p.pronargdefaults
FROM   member m JOIN pg_proc p ON m.classid = 'pg_proc'::regclass AND m.objid = p.oid
       JOIN pg_type t ON t.oid = p.prorettype
WHERE  p.proname ~ '^ab_';

-- The release in which a function came; where it came with fewer parameters, that one, too: a call that the earlier
-- release knew leaves out the others, which have defaults.
CREATE TEMP TABLE came AS
SELECT oid, CASE WHEN more > 0 THEN format('since %s, its last %s parameters since %s', with_fewer, more, with_all)
                 ELSE format('since %s', with_all) END AS since
FROM  (SELECT e.oid, e.pronargs - min(r.given) AS more,
              pg_temp.first(array_agg(r.release) FILTER (WHERE r.given < e.pronargs)) AS with_fewer,
              pg_temp.first(array_agg(r.release) FILTER (WHERE r.given = e.pronargs)) AS with_all
       FROM   entry e LEFT JOIN
             (SELECT release, name, arguments, coalesce(cardinality(string_to_array(arguments, ', ')), 0) AS given
              FROM   released WHERE kind = 'function') r
           ON r.name = e.name
          AND (r.arguments = e.arguments
               OR r.given BETWEEN e.pronargs - e.pronargdefaults AND e.pronargs - 1
                  AND starts_with(e.arguments || ', ', CASE r.given WHEN 0 THEN '' ELSE r.arguments || ', ' END)
                  AND NOT EXISTS (SELECT FROM entry o WHERE (o.name, o.arguments) = (r.name, r.arguments)))
       GROUP  BY e.oid, e.pronargs) c;

-- A head is a name, for all overloads that no other head names with their arguments, or a name with its arguments.
CREATE TEMP TABLE head AS
SELECT topic, n, h AS head, split_part(h, '(', 1) AS name, CASE WHEN h ~ '\(' THEN to_regprocedure(h)::oid END AS oid
FROM   example, regexp_split_to_table(head, ' and ') h;
CREATE TEMP TABLE shown AS
SELECT h.topic, h.n, h.head, e.*
FROM   head h JOIN (entry JOIN came USING (oid)) e
    ON e.oid = h.oid OR h.head = e.name AND NOT EXISTS (SELECT FROM head o WHERE o.oid = e.oid);

DO $$
DECLARE faults text;
BEGIN
    SELECT string_agg(fault, E'\n' ORDER BY fault) INTO faults FROM (
        SELECT format('no example: %s(%s)', name, arguments) FROM entry WHERE oid NOT IN (SELECT oid FROM shown)
        UNION ALL
        SELECT format('more than one example: %s', oid::regprocedure) FROM shown GROUP BY oid HAVING count(*) > 1
        UNION ALL
        SELECT format('%s.sql: no title', topic) FROM topic WHERE title IS NULL
        UNION ALL
        SELECT format('%s.sql: %s is no function, or has its example elsewhere', topic, head)
        FROM head WHERE (topic, n, head) NOT IN (SELECT topic, n, head FROM shown)
        UNION ALL
        SELECT format('%s.sql: %s is not called in its example', topic, h.head)
        FROM head h JOIN example e USING (topic, n) WHERE e.sql !~ format('\m%s\(', h.name)
        UNION ALL
        SELECT format('%s.sql: %s: %s', topic, head, CASE
            WHEN result = '' THEN 'nothing to look at'
            WHEN result ~ '[0-9a-f]{40}' THEN 'a long hex value'
            WHEN result ~ 'e-(1[1-9]|[2-9][0-9])' THEN 'a number that is nothing but rounding'
            WHEN result ~ '(\n[^\n]*){24}' THEN 'a result of more than 24 lines'
            WHEN result ~ '[^\n]{161}' THEN 'a result of more than 160 characters a line' END)
        FROM example
        WHERE result = '' OR result ~ '[0-9a-f]{40}|e-(1[1-9]|[2-9][0-9])|(\n[^\n]*){24}|[^\n]{161}'
    ) f(fault);
    IF faults IS NOT NULL THEN RAISE EXCEPTION E'docs/examples:\n%', faults; END IF;
END $$;

SELECT E'# SQL reference\n\nMade by `make docs` from the COMMENTs in the database and from [docs/examples](examples), '
    || E'whose SQL it runs.\nLengths in metres, angles in radians. Results are printed with six digits '
    || E'(`extra_float_digits = -9`).\n\n*Since* names the first release that has a function of this name with these '
    || E'parameters, or a type of this name;\nthe columns that a function returns may have become more since '
    || E'([changes](../CHANGELOG.md)).\n';
SELECT format('- [%s](#%s)', title, replace(lower(title), ' ', '-'))
FROM  (SELECT topic, title FROM topic UNION ALL VALUES ('', 'Types'), ('~1', 'Operators'), ('~2', 'Operator classes')) t
ORDER  BY topic;

SELECT E'\n## Types\n\n| type | since | what |\n| --- | --- | --- |';
SELECT format('| `%s` | %s | %s |', t.typname,
              pg_temp.first(ARRAY(SELECT release FROM released WHERE (kind, name) = ('type', t.typname))),
              obj_description(t.oid, 'pg_type'))
FROM   member m JOIN pg_type t ON m.classid = 'pg_type'::regclass AND m.objid = t.oid
WHERE  t.typname !~ '^_|_010$' AND t.typtype <> 'c' ORDER BY t.typname;

-- Topic by topic, in the order of the examples: signatures, columns of rows, the example and what it prints.
CREATE TEMP VIEW columns AS
SELECT topic, n, format(E'\nColumns of `%s`:\n\n| column | type | what |\n| --- | --- | --- |\n%s\n', row_name,
       string_agg(format('| `%s` | `%s` | %s |', attname, pg_temp.short(format_type(atttypid, NULL)),
                         col_description(attrelid, attnum)), E'\n' ORDER BY attnum)) AS text
FROM  (SELECT DISTINCT topic, n, row, row_name FROM shown) s
       JOIN pg_attribute ON attrelid = row AND attnum > 0 AND NOT attisdropped
WHERE  row <> 0 GROUP BY topic, n, row_name;
SELECT text FROM (
    SELECT topic, 1 AS n, format(E'\n## %s\n\n%s', title, says) || CASE WHEN shared = '' THEN '' ELSE
           format(E'\n\nThe examples of this topic use:\n\n```sql\n%s\n```', shared) END AS text
    FROM   topic
    UNION ALL
    SELECT topic, n, format(E'\n### %s\n\n%s\n%s\n```sql\n%s\n```\n\n```text\n%s\n```', e.head,
           (SELECT string_agg(format('- `%s` → `%s`%s, %s: %s', signature, s.result,
                                     CASE WHEN is_aggregate THEN ', aggregate' ELSE '' END, since, what),
                              E'\n' ORDER BY is_aggregate, signature)
            FROM shown s WHERE (s.topic, s.n) = (e.topic, e.n)),
           (SELECT coalesce(string_agg(c.text, '' ORDER BY c.text), '')
            FROM columns c WHERE (c.topic, c.n) = (e.topic, e.n)),
           sql, e.result)
    FROM   example e) x
ORDER  BY topic, n;

SELECT E'\n## Operators\n\n| operator | what |\n| --- | --- |';
SELECT format('| `%s %s %s` | %s |', l, o.oprname, r, obj_description(o.oid, 'pg_operator'))
FROM   member m JOIN pg_operator o ON m.classid = 'pg_operator'::regclass AND m.objid = o.oid,
       format_type(o.oprleft, NULL) l, format_type(o.oprright, NULL) r
ORDER  BY o.oprname, l, r;

SELECT E'\n## Operator classes\n\n| class | index | for | what |\n| --- | --- | --- | --- |';
SELECT format('| `%s` | %s | `%s` | %s |', c.opcname, CASE a.amname WHEN 'gist' THEN 'GiST' ELSE a.amname END,
              format_type(c.opcintype, NULL), obj_description(c.oid, 'pg_opclass'))
FROM   member m JOIN pg_opclass c ON m.classid = 'pg_opclass'::regclass AND m.objid = c.oid
       JOIN pg_am a ON a.oid = c.opcmethod ORDER BY c.opcname;
