-- The functions and types of the installed release, as rows of the table released (release, kind, name, arguments).
SELECT format('INSERT INTO released VALUES (%L, %L, %L, %L);', :'release', kind, name, arguments)
FROM   pg_depend d JOIN pg_extension x ON d.refobjid = x.oid AND d.refclassid = 'pg_extension'::regclass
       CROSS JOIN LATERAL (
           SELECT 'function', proname, oidvectortypes(proargtypes) FROM pg_proc
           WHERE  d.classid = 'pg_proc'::regclass AND d.objid = oid
           UNION ALL
           SELECT 'type', typname, NULL FROM pg_type WHERE d.classid = 'pg_type'::regclass AND d.objid = oid
       ) m(kind, name, arguments)
WHERE  x.extname = 'asbuilt' AND d.deptype = 'e' AND name ~ '^ab_'
ORDER  BY kind, name, arguments;
