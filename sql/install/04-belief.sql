-- Levels of accuracy and belief masses.

CREATE FUNCTION ab_loa_class(OUT loa ab_loa, OUT lower float8, OUT upper float8, OUT sigma float8, OUT source text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_loa_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION ab_loa_class() IS 'Bounds of the levels of accuracy, metres, held by 95 % (2 sigma) of deviations; sigma is upper/2';

CREATE FUNCTION ab_tolerance(loa ab_loa) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tolerance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_tolerance(ab_loa) IS 'Upper bound of a level of accuracy, metres: the tolerance of a verdict';

CREATE FUNCTION ab_mass(occupied float8, empty float8) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_make' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_mass(float8, float8) IS 'A belief mass; what is left of 1 is unknown';

CREATE FUNCTION ab_belief(mass ab_mass, hypothesis text DEFAULT 'occupied') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_belief' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_belief(ab_mass, text) IS 'Belief in ''occupied'' or ''empty''';

CREATE FUNCTION ab_plausibility(mass ab_mass, hypothesis text DEFAULT 'occupied') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_plausibility' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plausibility(ab_mass, text) IS 'Plausibility of ''occupied'' or ''empty'': belief plus the unknown mass';

CREATE FUNCTION ab_combine(m1 ab_mass, m2 ab_mass) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_combine' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine(ab_mass, ab_mass) IS 'Dempster''s rule for distinct sources; an error when they are in total conflict';

CREATE FUNCTION ab_conflict(m1 ab_mass, m2 ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_conflict' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_conflict(ab_mass, ab_mass) IS 'Mass that two sources put on contradictory hypotheses';

CREATE FUNCTION ab_ray_mass(origin float8[], point float8[], query float8[], kappa float8 DEFAULT 20000, lambda float8 DEFAULT 600, c float8 DEFAULT 3) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_ray_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ray_mass(float8[], float8[], float8[], float8, float8, float8) IS 'What one laser beam says at a query point, by the published ray model (Meyer 2022, 5.4 to 5.10, errata corrected)';
