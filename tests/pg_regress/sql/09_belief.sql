-- The belief calculus, and the published tables.
SET extra_float_digits = 1;
-- rules on (.6,.1,.3) and (.2,.5,.3)
SELECT rule, round(ab_belief(m)::numeric, 9) occupied, round(ab_belief(m, 'empty')::numeric, 9) empty, round(ab_contradiction(m)::numeric, 9) contradiction
FROM (SELECT rule, ab_combine(ab_mass(0.6, 0.1), ab_mass(0.2, 0.5), rule) m
      FROM unnest(ARRAY['dempster','conjunctive','disjunctive','yager','dubois_prade','pcr6','murphy','cautious']) rule) x;
SELECT ab_combine(ab_mass(1, 0), ab_mass(0, 1), 'yager') AS yager, ab_combine(ab_mass(1, 0), ab_mass(0, 1), 'conjunctive') AS conjunctive, ab_combine(ab_mass(0.5, 0), ab_mass(0.5, 0), 'cautious') AS cautious;
SELECT m = m::text::ab_mass AS round_trips FROM (SELECT ab_combine(ab_mass(0.9, 0.05), ab_mass(0.1, 0.7), 'conjunctive') m) x;
-- aggregates: as pairwise where associative, whatever the order; NULLs add nothing; no row, no mass
CREATE TABLE source AS SELECT i AS id, ab_mass(0.3 * (0.5 + 0.5 * sin(i)), 0.2 * (0.5 + 0.5 * cos(7 * i))) AS m FROM generate_series(1, 20000) i;
SELECT rule, bool_and(abs(ab_belief(a) - ab_belief(b)) < 1e-12) AS order_does_not_matter
FROM (SELECT rule, (SELECT ab_combine_agg(m, rule ORDER BY id) FROM source WHERE id <= 50) a, (SELECT ab_combine_agg(m, rule ORDER BY id DESC) FROM source WHERE id <= 50) b
      FROM unnest(ARRAY['dempster','conjunctive','disjunctive','yager','dubois_prade','murphy','cautious']) rule) x GROUP BY 1 ORDER BY 1;
SELECT ab_combine_agg(m) IS NULL AS nothing FROM source WHERE false;
SELECT ab_combine_agg(m) = ab_combine_agg(m) FILTER (WHERE m IS NOT NULL) AS nulls_add_nothing FROM (SELECT m FROM source WHERE id < 9 UNION ALL SELECT NULL) x;
SELECT abs(ab_belief(ab_combine_agg(m, 'dempster', 0.9)) - ab_belief(ab_combine_agg(ab_discount(m, 0.9)))) < 1e-15 AS discounted FROM source WHERE id < 9;
-- workers
SET parallel_setup_cost = 0; SET parallel_tuple_cost = 0; SET min_parallel_table_scan_size = 0; SET max_parallel_workers_per_gather = 2;
ALTER TABLE source SET (parallel_workers = 2);
EXPLAIN (COSTS OFF) SELECT ab_combine_agg(m) FROM source;
CREATE TABLE result AS SELECT 'workers' AS by, ab_combine_agg(m) AS m FROM source;
SET max_parallel_workers_per_gather = 0;
INSERT INTO result SELECT 'one', ab_combine_agg(m) FROM source;
SELECT max(ab_belief(m)) - min(ab_belief(m)) < 1e-13 AS same, max(ab_belief(m)) > 0 AS some FROM result;
RESET parallel_setup_cost; RESET parallel_tuple_cost; RESET min_parallel_table_scan_size; RESET max_parallel_workers_per_gather;
DROP TABLE source, result;
-- measures
SELECT ab_pignistic(m), ab_pignistic(m, 'empty'), ab_nonspecificity(m), round(ab_discord(m)::numeric, 9) discord, ab_decide(m), ab_decide(m, 'pignistic', 0.7), ab_discount(m, 0.5) FROM (SELECT ab_mass(0.6, 0.1) m) x;
SELECT bool_and(ab_belief(m, h) <= ab_pignistic(m, h) + 1e-15 AND ab_pignistic(m, h) <= ab_plausibility(m, h) + 1e-15) AS ordered, count(*)
FROM (SELECT ab_mass(i / 10.0, j / 10.0) m, h FROM generate_series(0, 10) i, generate_series(0, 10 - i) j, unnest(ARRAY['occupied', 'empty']) h) x;

-- M Table 5.2: a model of the level lies within 1 mm (LOA30 printed .1034, exact .1061)
SELECT loa, round(ab_loa_confidence(loa, 0.001)::numeric, 4) AS p FROM ab_loa_class() WHERE loa >= 'LOA20' ORDER BY loa DESC;
-- M Table 5.3
SELECT m, ab_belief(m), ab_belief(m, 'empty'), ab_plausibility(m), ab_plausibility(m, 'empty') FROM (VALUES ('(0.2,0.5,0.3)'::ab_mass), ('(0.95,0.05,0)')) v(m);
-- M Table 5.4, by the linear form with its printed constants: divisor .95, LOA30 with sigma 15 mm
SELECT sigma, bel, round((ab_convert_belief_linear(bel, sigma, 0.0005, 0.95)).belief_to::numeric, 4) AS loa50, round((ab_convert_belief_linear(bel, sigma, 0.0025, 0.95)).belief_to::numeric, 4) AS loa40,
       round((ab_convert_belief_linear(bel, sigma, 0.015, 0.95)).belief_to::numeric, 4) AS loa30
FROM (VALUES (0.002, 0.85), (0.0025, 0.73)) v(sigma, bel);
-- … whose own equation exceeds 1
SELECT * FROM ab_convert_belief_linear(0.85, 0.002, 0.0075);
-- M Table 8.1, by quantiles from sigma 2.5 mm (.955 at .5 mm is exactly .3115, .412 at 7.5 mm .896)
SELECT sigma, round(ab_convert_belief(0.412, 0.0025, sigma)::numeric, 3) AS "from .412", round(ab_convert_belief(0.683, 0.0025, sigma)::numeric, 3) AS "from .683", round(ab_convert_belief(0.75, 0.0025, sigma)::numeric, 3) AS "from .75",
       round(ab_convert_belief(0.85, 0.0025, sigma)::numeric, 3) AS "from .85", round(ab_convert_belief(0.955, 0.0025, sigma)::numeric, 4) AS "from .955"
FROM unnest(ARRAY[0.0025, 0.0005, 0.0075, 0.015]) sigma;
SELECT ab_convert_belief(0.85, 0.0025, 'LOA40'::ab_loa) = ab_convert_belief(0.85, 0.0025, 0.0025) AS loa40_is_2_5_mm;
SELECT ab_relative_tolerance(0.003, 0.004), ab_relative_tolerance(0.003, 0.004, 'linear'), ab_is_fit(0.003, 0.015), ab_is_fit(0.003, 0.015, 'proof');
SELECT * FROM ab_din18710_class();
SELECT loa, lower, upper, sigma, source FROM ab_loa_class() LIMIT 2;

-- sensors
SELECT round(ab_kappa(0.005)::numeric) AS kappa, ab_lambda(0.0025) AS lambda;
SELECT ab_image_mass(ARRAY[0,0,0]::float8[], ARRAY[5,0,0]::float8[], ARRAY[5,0,0]::float8[]) = ab_ray_mass(ARRAY[0,0,0]::float8[], ARRAY[5,0,0]::float8[], ARRAY[5,0,0]::float8[], 15000, 800, 5) AS image_settings;
SELECT round(ab_belief(ab_dense_mass(ARRAY[0,0,0]::float8[], ARRAY[0,0,2]::float8[], ARRAY[0,0,z]::float8[]))::numeric, 6) AS occupied, ab_belief(ab_dense_mass(ARRAY[0,0,0]::float8[], ARRAY[0,0,2]::float8[], ARRAY[0,0,z]::float8[]), 'empty') AS empty FROM unnest(ARRAY[0, 0.004, 0.01]) z;
SELECT sd, round(ab_belief(m)::numeric, 4) occupied, round(ab_belief(m, 'empty')::numeric, 4) empty
FROM unnest(ARRAY[0, 0.005, 0.02]) sd, LATERAL (SELECT ab_tie_point_mass(ARRAY[0,0,0]::float8[], ab_point(5,0,0,sd), ARRAY[4.98,0,0]::float8[]) m) x;
SELECT round(ab_belief(ab_surface_mass(0, 0.001, 0.002))::numeric, 6) AS within, round(ab_belief(ab_surface_mass(-0.01, 0.001, 0.002), 'empty')::numeric, 6) AS behind, round(ab_plausibility(ab_surface_mass(0.01, 0.001, 0.002), 'empty')::numeric, 6) AS before_it;
