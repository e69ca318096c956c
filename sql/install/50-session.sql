-- What a session may ask of asbuilt itself.

CREATE TYPE ab_memory_row AS (live bigint, peak bigint);
COMMENT ON TYPE ab_memory_row IS 'What asbuilt takes in a session';
COMMENT ON COLUMN ab_memory_row.live IS 'Bytes now';
COMMENT ON COLUMN ab_memory_row.peak IS 'Most bytes ever, or since from_now';

CREATE FUNCTION ab_memory(from_now boolean DEFAULT false) RETURNS ab_memory_row
    AS 'MODULE_PATHNAME' LANGUAGE c VOLATILE PARALLEL RESTRICTED;
COMMENT ON FUNCTION ab_memory(boolean) IS
    'Bytes that asbuilt''s values and work take in this session''s process now, and the most they ever took; '
    'from_now begins the peak anew. What PostgreSQL itself holds of them (rows, results) is not counted';

CREATE FUNCTION _ab_declared() RETURNS SETOF text
    AS 'MODULE_PATHNAME', 'ab_declared' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_declared() IS
    'The C functions of asbuilt, each with the parameter types that it reads; ? where NULL is a value';
