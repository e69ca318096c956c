-- Levels of accuracy, belief masses, their rules and measures, sensors at a point.

CREATE TYPE ab_loa_class_row AS (loa ab_loa, lower float8, upper float8, sigma float8, source text);
COMMENT ON TYPE ab_loa_class_row IS 'A level of accuracy with its bounds';
COMMENT ON COLUMN ab_loa_class_row.loa IS 'The level';
COMMENT ON COLUMN ab_loa_class_row.lower IS 'Lower bound of the deviations at 95 %, metres';
COMMENT ON COLUMN ab_loa_class_row.upper IS 'Upper bound of the deviations at 95 %, metres: the tolerance of a verdict';
COMMENT ON COLUMN ab_loa_class_row.sigma IS 'Standard deviation that belongs to the upper bound, half of it, metres';
COMMENT ON COLUMN ab_loa_class_row.source IS 'Where the bounds come from';

CREATE FUNCTION ab_loa_class() RETURNS SETOF ab_loa_class_row
    AS 'MODULE_PATHNAME', 'ab_loa_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION ab_loa_class() IS
    'Bounds of the levels of accuracy, metres, held by 95 % (2 sigma) of deviations; sigma is upper/2';

CREATE FUNCTION ab_upper_bound(loa ab_loa) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_tolerance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_upper_bound(ab_loa) IS 'Upper bound of a level of accuracy, metres: the tolerance of a verdict';

CREATE FUNCTION ab_mass(occupied float8, empty float8) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_make' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_mass(float8, float8) IS 'A belief mass; what is left of 1 is unknown';

CREATE FUNCTION ab_belief(mass ab_mass, hypothesis text DEFAULT 'occupied') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_belief' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_belief(ab_mass, text) IS 'Belief in ''occupied'' or ''empty''';

CREATE FUNCTION ab_plausibility(mass ab_mass, hypothesis text DEFAULT 'occupied') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_plausibility' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_plausibility(ab_mass, text) IS
    'Plausibility of ''occupied'' or ''empty'': belief plus the unknown mass';

CREATE FUNCTION ab_combine(m1 ab_mass, m2 ab_mass) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_combine' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine(ab_mass, ab_mass) IS
    'Dempster''s rule for distinct sources; an error when they are in total conflict';

CREATE FUNCTION ab_conflict(m1 ab_mass, m2 ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_conflict' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_conflict(ab_mass, ab_mass) IS 'Mass that two sources put on contradictory hypotheses';

CREATE FUNCTION ab_ray_mass(
    origin float8[], point float8[], query float8[], kappa float8 DEFAULT 20000, lambda float8 DEFAULT 600,
    c float8 DEFAULT 3) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_ray_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_ray_mass(float8[], float8[], float8[], float8, float8, float8) IS
    'What one laser beam says at a query point, by the published ray model (Meyer 2022, 5.4 to 5.10, errata '
    'corrected)';

-- The belief calculus: rules, measures, sensors, accuracy.
CREATE FUNCTION ab_combine(m1 ab_mass, m2 ab_mass, rule text) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_combine_by' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine(ab_mass, ab_mass, text) IS
    'Two sources by a rule: dempster, conjunctive, disjunctive, yager, dubois_prade (as yager on two hypotheses), '
    'pcr6, murphy or cautious';

CREATE FUNCTION ab_contradiction(mass ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_contradiction' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_contradiction(ab_mass) IS
    'Mass of the empty set: what the conjunctive rule leaves to contradiction';

CREATE FUNCTION ab_discount(mass ab_mass, reliability float8) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_discount' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_discount(ab_mass, float8) IS
    'The mass of a source that is reliable with this probability: the rest goes to unknown';

CREATE FUNCTION ab_pignistic(mass ab_mass, hypothesis text DEFAULT 'occupied') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_pignistic' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_pignistic(ab_mass, text) IS
    'Pignistic probability: the unknown mass shared out, contradiction divided out';

CREATE FUNCTION ab_nonspecificity(mass ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_nonspecificity' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_nonspecificity(ab_mass) IS 'Nonspecificity, bits: how much is not known';

CREATE FUNCTION ab_discord(mass ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_discord' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_discord(ab_mass) IS 'Discord, bits (Klir and Ramer 1990): how much the mass contradicts itself';

CREATE FUNCTION ab_decide(mass ab_mass, criterion text DEFAULT 'belief', threshold float8 DEFAULT 0.95) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_mass_decide' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_decide(ab_mass, text, float8) IS
    'occupied, empty or unknown: the hypothesis whose belief, plausibility or pignistic probability reaches the '
    'threshold and exceeds the other ones';

-- Any number of sources.
CREATE FUNCTION _ab_combine_accum(state internal, mass ab_mass) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_combine_accum(internal, ab_mass) IS 'Transition of ab_combine_agg';

CREATE FUNCTION _ab_combine_accum(state internal, mass ab_mass, rule text) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_accum_by' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_combine_accum(internal, ab_mass, text) IS 'Transition of ab_combine_agg with a rule';

CREATE FUNCTION _ab_combine_accum(state internal, mass ab_mass, rule text, reliability float8) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_accum_by' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_combine_accum(internal, ab_mass, text, float8) IS
    'Transition of ab_combine_agg with a rule and reliabilities';

CREATE FUNCTION _ab_combine_merge(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_merge' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_combine_merge(internal, internal) IS 'Combine of ab_combine_agg';

CREATE FUNCTION _ab_combine_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_combine_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_combine_serial(internal) IS 'Serialisation of ab_combine_agg';

CREATE FUNCTION _ab_combine_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION _ab_combine_deserial(bytea, internal) IS 'Deserialisation of ab_combine_agg';

CREATE FUNCTION _ab_combine_final(state internal) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_combine_final' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION _ab_combine_final(internal) IS 'Final of ab_combine_agg';

CREATE AGGREGATE ab_combine_agg(mass ab_mass) (
    SFUNC = _ab_combine_accum, STYPE = internal, SSPACE = 200, COMBINEFUNC = _ab_combine_merge,
    SERIALFUNC = _ab_combine_serial, DESERIALFUNC = _ab_combine_deserial, FINALFUNC = _ab_combine_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_combine_agg(ab_mass) IS
    'Dempsters rule over any number of distinct sources, in any order and by parallel workers';

CREATE AGGREGATE ab_combine_agg(mass ab_mass, rule text) (
    SFUNC = _ab_combine_accum, STYPE = internal, SSPACE = 200, COMBINEFUNC = _ab_combine_merge,
    SERIALFUNC = _ab_combine_serial, DESERIALFUNC = _ab_combine_deserial, FINALFUNC = _ab_combine_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_combine_agg(ab_mass, text) IS
    'Any number of sources by a rule, all at once and in any order: all rules but pcr6, which needs every '
    'combination of its sources; for it combine two by two with ab_combine, in an order you state. A row with a NULL '
    'adds nothing';

CREATE AGGREGATE ab_combine_agg(mass ab_mass, rule text, reliability float8) (
    SFUNC = _ab_combine_accum, STYPE = internal, SSPACE = 200, COMBINEFUNC = _ab_combine_merge,
    SERIALFUNC = _ab_combine_serial, DESERIALFUNC = _ab_combine_deserial, FINALFUNC = _ab_combine_final,
    PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_combine_agg(ab_mass, text, float8) IS 'The same, every source discounted by its reliability';

-- Sensors: what one observation says at a query point.
CREATE FUNCTION ab_kappa(spacing float8) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_kappa' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_kappa(float8) IS
    'Decay across a ray, 1/m2, for which the kernel halves one point spacing (m) away: ln 2/spacing2';

CREATE FUNCTION ab_lambda(sigma float8, c float8 DEFAULT 3) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_lambda' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lambda(float8, float8) IS
    'Steepness along a ray, 1/m, for which the occupied band is 2 sigma (m) thick on either side: c/(2 sigma)';

CREATE FUNCTION ab_image_mass(
    origin float8[], point float8[], query float8[], kappa float8 DEFAULT 15000, lambda float8 DEFAULT 800,
    c float8 DEFAULT 5) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_ray_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_image_mass(float8[], float8[], float8[], float8, float8, float8) IS
    'What an image ray to a point says at a query point: the ray model with its settings for images';

CREATE FUNCTION ab_tie_point_mass(
    origin float8[], point ab_point, query float8[], kappa float8 DEFAULT 15000, lambda float8 DEFAULT 800,
    c float8 DEFAULT 5) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_tie_point_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_tie_point_mass(float8[], ab_point, float8[], float8, float8, float8) IS
    'What a tie point with its covariance, seen from a camera at origin, says at a query point: the ray model '
    'widened by the points own uncertainty along and across the ray';

CREATE FUNCTION ab_dense_mass(
    point float8[], normal float8[], query float8[], kappa float8 DEFAULT 6000, lambda float8 DEFAULT 1200,
    c float8 DEFAULT 5) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_dense_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_dense_mass(float8[], float8[], float8[], float8, float8, float8) IS
    'What a point of a dense cloud with a face normal says at a query point: occupied or unknown (Meyer 2022, 5.12, '
    '5.13)';

CREATE FUNCTION ab_surface_mass(
    deviation float8, sd float8, tolerance float8, coverage float8 DEFAULT 1, hit_share float8 DEFAULT 1,
    reliability float8 DEFAULT 0.99) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_surface_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_surface_mass(float8, float8, float8, float8, float8, float8) IS
    'Mass that the built surface lies within the tolerance of the face, from a mean deviation (metres, + in front) '
    'with its standard deviation: the model surface';

-- Accuracy.
CREATE FUNCTION ab_loa_confidence(loa ab_loa, within float8) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_loa_confidence' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_loa_confidence(ab_loa, float8) IS
    'Probability that a model of this level lies within this distance, metres';

CREATE FUNCTION ab_convert_belief(belief float8, sigma float8, sigma_to float8) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_convert_belief' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief(float8, float8, float8) IS
    'A belief that holds within one standard deviation, as what it is worth within another, by quantiles';

CREATE FUNCTION ab_convert_belief(belief float8, sigma float8, loa ab_loa) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_convert_belief_loa' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief(float8, float8, ab_loa) IS
    'The same for a level of accuracy: its standard deviation is half its upper bound';

CREATE TYPE ab_converted_belief_row AS (belief_to float8, capped boolean);
COMMENT ON TYPE ab_converted_belief_row IS 'A belief at another accuracy';
COMMENT ON COLUMN ab_converted_belief_row.belief_to IS 'The belief within the other standard deviation, 0 to 1';
COMMENT ON COLUMN ab_converted_belief_row.capped IS 'Whether the formula gave more than 1, which belief_to then is';

CREATE FUNCTION ab_convert_belief_linear(
    belief float8, sigma float8, sigma_to float8,
    divisor float8 DEFAULT 0.682689492137086) RETURNS ab_converted_belief_row
    AS 'MODULE_PATHNAME', 'ab_convert_belief_linear' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief_linear(float8, float8, float8, float8) IS
    'The published linear form, for comparison: can exceed 1 and is then capped and marked. Meyer 2022 divides by 2 '
    'Phi(1) - 1 in eq. 5.24 and by 0.95 in table 5.4';

CREATE FUNCTION ab_relative_tolerance(t1 float8, t2 float8, rule text DEFAULT 'squared') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_relative_tolerance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_relative_tolerance(float8, float8, text) IS
    'Tolerance of one object against another, from theirs: squared or linear';

CREATE FUNCTION ab_is_fit(sigma float8, tolerance float8, purpose text DEFAULT 'loa') RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_fit' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_fit(float8, float8, text) IS
    'Is a sensor of this standard deviation fit: at most a fifth of the tolerance to tell levels of accuracy (loa), '
    'a fifteenth to prove a tolerance (proof)';

CREATE TYPE ab_din18710_class_row AS (class text, lower float8, upper float8, source text);
COMMENT ON TYPE ab_din18710_class_row IS 'A class of positional accuracy with its bounds';
COMMENT ON COLUMN ab_din18710_class_row.class IS 'The class, L1 to L5';
COMMENT ON COLUMN ab_din18710_class_row.lower IS 'Lower bound of one standard deviation, metres';
COMMENT ON COLUMN ab_din18710_class_row.upper IS 'Upper bound of one standard deviation, metres';
COMMENT ON COLUMN ab_din18710_class_row.source IS 'Where the bounds come from';

CREATE FUNCTION ab_din18710_class() RETURNS SETOF ab_din18710_class_row
    AS 'MODULE_PATHNAME', 'ab_din18710_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION ab_din18710_class() IS
    'DIN 18710-1 classes of positional accuracy: bounds of ONE standard deviation, metres. Not levels of accuracy, '
    'which bound two';
