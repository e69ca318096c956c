-- Belief and accuracy
-- Masses of belief in occupied and empty, their combination, what one observation says, and levels of accuracy.

-- ab_mass
SELECT ab_mass(0.5, 0.25) AS occupied_empty_unknown;

-- ab_belief
SELECT ab_belief(ab_mass(0.6, 0.1)) AS occupied, ab_belief(ab_mass(0.6, 0.1), 'empty') AS empty;

-- ab_plausibility
SELECT ab_plausibility(ab_mass(0.6, 0.1)) AS occupied, ab_plausibility(ab_mass(0.6, 0.1), 'empty') AS empty;

-- ab_pignistic
SELECT ab_pignistic(ab_mass(0.6, 0.1)) AS occupied;

-- ab_decide
SELECT ab_decide(ab_mass(0.96, 0.01)) AS sure, ab_decide(ab_mass(0.6, 0.1)) AS open,
       ab_decide(ab_mass(0.6, 0.1), 'pignistic', 0.7) AS by_a_bet;

-- ab_discount
-- A source that is right nine times out of ten.
SELECT ab_belief(ab_discount(ab_mass(0.6, 0.1), 0.9)) AS occupied;

-- ab_nonspecificity
SELECT ab_nonspecificity(ab_mass(0.6, 0.1)) AS bits;

-- ab_discord
SELECT ab_discord(ab_mass(0.6, 0.1)) AS bits;

-- ab_combine
SELECT rule, ab_belief(m) AS occupied, ab_belief(m, 'empty') AS empty
FROM   unnest(ARRAY['dempster', 'yager', 'pcr6', 'cautious']) rule,
       ab_combine(ab_mass(0.6, 0.1), ab_mass(0.2, 0.5), rule) m;
SELECT ab_belief(ab_combine(ab_mass(0.6, 0.1), ab_mass(0.5, 0.2))) AS by_dempster;

-- ab_conflict
SELECT ab_conflict(ab_mass(0.6, 0.1), ab_mass(0.2, 0.5)) AS conflict;

-- ab_contradiction
SELECT ab_contradiction(ab_combine(ab_mass(0.6, 0.1), ab_mass(0.2, 0.5), 'conjunctive')) AS of_the_empty_set;

-- ab_combine_agg
SELECT ab_belief(ab_combine_agg(m)) AS by_dempster, ab_belief(ab_combine_agg(m, 'yager')) AS by_yager,
       ab_belief(ab_combine_agg(m, 'dempster', 0.9)) AS each_discounted
FROM  (VALUES (ab_mass(0.6, 0.1)), (ab_mass(0.7, 0)), (ab_mass(0.5, 0.2))) v(m);

-- ab_kappa
-- For points 6 mm apart.
SELECT ab_kappa(0.006) AS per_m2;

-- ab_lambda
SELECT ab_lambda(0.0025) AS per_m;

-- ab_ray_mass
-- A beam that returns from 5 m: what it says before, at and behind its return.
SELECT x, round(ab_belief(m)::numeric, 4) AS occupied, round(ab_belief(m, 'empty')::numeric, 4) AS empty
FROM   unnest(ARRAY[4.9, 5, 5.1]) x, ab_ray_mass(ARRAY[0, 0, 1.6], ARRAY[5, 0, 1.6], ARRAY[x, 0, 1.6]) m;

-- ab_image_mass
SELECT x, round(ab_belief(m)::numeric, 4) AS occupied, round(ab_belief(m, 'empty')::numeric, 4) AS empty
FROM   unnest(ARRAY[4.98, 5, 5.02]) x, ab_image_mass(ARRAY[0, 0, 1.6], ARRAY[5, 0, 1.6], ARRAY[x, 0, 1.6]) m;

-- ab_tie_point_mass
-- May the surface lie 20 mm before the point? That depends on the point's own standard deviation.
SELECT sd, round(ab_belief(m)::numeric, 4) AS occupied, round(ab_belief(m, 'empty')::numeric, 4) AS empty
FROM   unnest(ARRAY[0, 0.005, 0.02]) sd,
       ab_tie_point_mass(ARRAY[0, 0, 1.6], ab_point(5, 0, 1.6, sd), ARRAY[4.98, 0, 1.6]) m;

-- ab_dense_mass
SELECT z, round(ab_belief(m)::numeric, 4) AS occupied, ab_belief(m, 'empty') AS empty
FROM   unnest(ARRAY[0, 0.004, 0.01]) z, ab_dense_mass(ARRAY[0, 0, 0], ARRAY[0, 0, 1], ARRAY[0, 0, z]) m;

-- ab_surface_mass
-- A tolerance of 2 mm: a surface that is met where it is drawn, and one that is met 10 mm behind.
SELECT deviation, round(ab_belief(m)::numeric, 4) AS occupied, round(ab_belief(m, 'empty')::numeric, 4) AS empty
FROM   unnest(ARRAY[0, -0.01]) deviation, ab_surface_mass(deviation, sd => 0.001, tolerance => 0.002) m;

-- ab_loa_class
SELECT loa, lower, upper, sigma FROM ab_loa_class();

-- ab_upper_bound
SELECT ab_upper_bound('LOA30') AS metres;

-- ab_loa_confidence
SELECT loa, ab_loa_confidence(loa, within => 0.005) AS within_5_mm
FROM   unnest(ARRAY['LOA20', 'LOA30', 'LOA40']::ab_loa[]) loa;

-- ab_convert_belief
-- Half sure within 2.5 mm: how sure within 7.5 mm, and at another level?
SELECT ab_convert_belief(0.5, 0.0025, 0.0075) AS wider, ab_convert_belief(0.5, 0.0025, 'LOA30'::ab_loa) AS at_loa30;

-- ab_convert_belief_linear
SELECT c.* FROM ab_convert_belief_linear(0.85, 0.002, 0.0075) c;

-- ab_relative_tolerance
SELECT ab_relative_tolerance(0.003, 0.004) AS squared, ab_relative_tolerance(0.003, 0.004, 'linear') AS linear;

-- ab_is_fit
-- A scanner of 2 mm for a tolerance of 15 mm.
SELECT ab_is_fit(0.002, 0.015) AS to_tell_levels, ab_is_fit(0.002, 0.015, 'proof') AS to_prove_it;

-- ab_din18710_class
SELECT class, lower, upper FROM ab_din18710_class();
