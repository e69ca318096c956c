-- The belief calculus: rules, measures, sensors, accuracy.

CREATE FUNCTION ab_combine(m1 ab_mass, m2 ab_mass, rule text) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_combine_by' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine(ab_mass, ab_mass, text) IS 'Two sources by a rule: dempster, conjunctive, disjunctive, yager, dubois_prade (as yager on two hypotheses), pcr6, murphy or cautious';

CREATE FUNCTION ab_contradiction(mass ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_contradiction' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_contradiction(ab_mass) IS 'Mass of the empty set: what the conjunctive rule leaves to contradiction';

CREATE FUNCTION ab_discount(mass ab_mass, reliability float8) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_mass_discount' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_discount(ab_mass, float8) IS 'The mass of a source that is reliable with this probability: the rest goes to unknown';

CREATE FUNCTION ab_pignistic(mass ab_mass, hypothesis text DEFAULT 'occupied') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_pignistic' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_pignistic(ab_mass, text) IS 'Pignistic probability: the unknown mass shared out, contradiction divided out';

CREATE FUNCTION ab_nonspecificity(mass ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_nonspecificity' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_nonspecificity(ab_mass) IS 'Nonspecificity, bits: how much is not known';

CREATE FUNCTION ab_discord(mass ab_mass) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_mass_discord' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_discord(ab_mass) IS 'Discord, bits (Klir and Ramer 1990): how much the mass contradicts itself';

CREATE FUNCTION ab_decide(mass ab_mass, criterion text DEFAULT 'belief', threshold float8 DEFAULT 0.95) RETURNS text
    AS 'MODULE_PATHNAME', 'ab_mass_decide' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_decide(ab_mass, text, float8) IS 'occupied, empty or unknown: the hypothesis whose belief, plausibility or pignistic probability reaches the threshold and exceeds the other ones';

-- Any number of sources.

CREATE FUNCTION ab_combine_accum(state internal, mass ab_mass) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_accum' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_accum(internal, ab_mass) IS 'Transition of ab_combine_agg';

CREATE FUNCTION ab_combine_accum(state internal, mass ab_mass, rule text) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_accum_by' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_accum(internal, ab_mass, text) IS 'Transition of ab_combine_agg with a rule';

CREATE FUNCTION ab_combine_accum(state internal, mass ab_mass, rule text, reliability float8) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_accum_by' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_accum(internal, ab_mass, text, float8) IS 'Transition of ab_combine_agg with a rule and reliabilities';

CREATE FUNCTION ab_combine_merge(left_state internal, right_state internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_merge' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_merge(internal, internal) IS 'Combine of ab_combine_agg';

CREATE FUNCTION ab_combine_serial(state internal) RETURNS bytea
    AS 'MODULE_PATHNAME', 'ab_combine_serial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_serial(internal) IS 'Serialisation of ab_combine_agg';

CREATE FUNCTION ab_combine_deserial(bytes bytea, dummy internal) RETURNS internal
    AS 'MODULE_PATHNAME', 'ab_combine_deserial' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_deserial(bytea, internal) IS 'Deserialisation of ab_combine_agg';

CREATE FUNCTION ab_combine_final(state internal) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_combine_final' LANGUAGE c IMMUTABLE PARALLEL SAFE;
COMMENT ON FUNCTION ab_combine_final(internal) IS 'Final of ab_combine_agg';

CREATE AGGREGATE ab_combine_agg(mass ab_mass) (
    SFUNC = ab_combine_accum, STYPE = internal, SSPACE = 200,
    COMBINEFUNC = ab_combine_merge, SERIALFUNC = ab_combine_serial, DESERIALFUNC = ab_combine_deserial,
    FINALFUNC = ab_combine_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_combine_agg(ab_mass) IS 'Dempsters rule over any number of distinct sources, in any order and by parallel workers';

CREATE AGGREGATE ab_combine_agg(mass ab_mass, rule text) (
    SFUNC = ab_combine_accum, STYPE = internal, SSPACE = 200,
    COMBINEFUNC = ab_combine_merge, SERIALFUNC = ab_combine_serial, DESERIALFUNC = ab_combine_deserial,
    FINALFUNC = ab_combine_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_combine_agg(ab_mass, text) IS 'Any number of sources by a rule, all at once and in any order: all rules but pcr6, which needs every combination of its sources; for it combine two by two with ab_combine, in an order you state. A row with a NULL adds nothing';

CREATE AGGREGATE ab_combine_agg(mass ab_mass, rule text, reliability float8) (
    SFUNC = ab_combine_accum, STYPE = internal, SSPACE = 200,
    COMBINEFUNC = ab_combine_merge, SERIALFUNC = ab_combine_serial, DESERIALFUNC = ab_combine_deserial,
    FINALFUNC = ab_combine_final, PARALLEL = SAFE);
COMMENT ON AGGREGATE ab_combine_agg(ab_mass, text, float8) IS 'The same, every source discounted by its reliability';

-- Sensors: what one observation says at a query point.

CREATE FUNCTION ab_kappa(spacing float8) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_kappa' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_kappa(float8) IS 'Decay across a ray, 1/m2, for which the kernel halves one point spacing (m) away: ln 2/spacing2';

CREATE FUNCTION ab_lambda(sigma float8, c float8 DEFAULT 3) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_lambda' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_lambda(float8, float8) IS 'Steepness along a ray, 1/m, for which the occupied band is 2 sigma (m) thick on either side: c/(2 sigma)';

CREATE FUNCTION ab_image_mass(origin float8[], point float8[], query float8[], kappa float8 DEFAULT 15000, lambda float8 DEFAULT 800, c float8 DEFAULT 5) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_ray_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_image_mass(float8[], float8[], float8[], float8, float8, float8) IS 'What an image ray to a point says at a query point: the ray model with its settings for images';

CREATE FUNCTION ab_tie_point_mass(origin float8[], point ab_point, query float8[], kappa float8 DEFAULT 15000, lambda float8 DEFAULT 800, c float8 DEFAULT 5) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_tie_point_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_tie_point_mass(float8[], ab_point, float8[], float8, float8, float8) IS 'What a tie point with its covariance, seen from a camera at origin, says at a query point: the ray model widened by the points own uncertainty along and across the ray';

CREATE FUNCTION ab_dense_mass(point float8[], normal float8[], query float8[], kappa float8 DEFAULT 6000, lambda float8 DEFAULT 1200, c float8 DEFAULT 5) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_dense_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_dense_mass(float8[], float8[], float8[], float8, float8, float8) IS 'What a point of a dense cloud with a face normal says at a query point: occupied or unknown (Meyer 2022, 5.12, 5.13)';

CREATE FUNCTION ab_surface_mass(deviation float8, sd float8, tolerance float8, coverage float8 DEFAULT 1, hit_share float8 DEFAULT 1, reliability float8 DEFAULT 0.99) RETURNS ab_mass
    AS 'MODULE_PATHNAME', 'ab_surface_mass' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_surface_mass(float8, float8, float8, float8, float8, float8) IS 'Mass that the built surface lies within the tolerance of the face, from a mean deviation (metres, + in front) with its standard deviation: the model surface';

-- Accuracy.

CREATE FUNCTION ab_loa_confidence(loa ab_loa, within float8) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_loa_confidence' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_loa_confidence(ab_loa, float8) IS 'Probability that a model of this level lies within this distance, metres';

CREATE FUNCTION ab_convert_belief(belief float8, sigma float8, sigma_to float8) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_convert_belief' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief(float8, float8, float8) IS 'A belief that holds within one standard deviation, as what it is worth within another, by quantiles';

CREATE FUNCTION ab_convert_belief(belief float8, sigma float8, loa ab_loa) RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_convert_belief_loa' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief(float8, float8, ab_loa) IS 'The same for a level of accuracy: its standard deviation is half its upper bound';

CREATE FUNCTION ab_convert_belief_linear(belief float8, sigma float8, sigma_to float8, divisor float8 DEFAULT 0.682689492137086, OUT belief_to float8, OUT capped boolean) RETURNS record
    AS 'MODULE_PATHNAME', 'ab_convert_belief_linear' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_convert_belief_linear(float8, float8, float8, float8) IS 'The published linear form, for comparison: can exceed 1 and is then capped and marked. Meyer 2022 divides by 2 Phi(1) - 1 in eq. 5.24 and by 0.95 in table 5.4';

CREATE FUNCTION ab_relative_tolerance(t1 float8, t2 float8, rule text DEFAULT 'squared') RETURNS float8
    AS 'MODULE_PATHNAME', 'ab_relative_tolerance' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_relative_tolerance(float8, float8, text) IS 'Tolerance of one object against another, from theirs: squared or linear';

CREATE FUNCTION ab_is_fit(sigma float8, tolerance float8, purpose text DEFAULT 'loa') RETURNS boolean
    AS 'MODULE_PATHNAME', 'ab_is_fit' LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE;
COMMENT ON FUNCTION ab_is_fit(float8, float8, text) IS 'Is a sensor of this standard deviation fit: at most a fifth of the tolerance to tell levels of accuracy (loa), a fifteenth to prove a tolerance (proof)';

CREATE FUNCTION ab_din18710_class(OUT class text, OUT lower float8, OUT upper float8, OUT source text) RETURNS SETOF record
    AS 'MODULE_PATHNAME', 'ab_din18710_class' LANGUAGE c STABLE STRICT PARALLEL SAFE ROWS 5;
COMMENT ON FUNCTION ab_din18710_class() IS 'DIN 18710-1 classes of positional accuracy: bounds of ONE standard deviation, metres. Not levels of accuracy, which bound two';
