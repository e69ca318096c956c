-- Uncertain geometry and belief: what is refused, and why.
\set VERBOSITY default
-- numbers
SELECT ab_point('nan', 0, 0);
SELECT ab_point(1e300, 0, 0);
SELECT ab_point(0, 0, 0, sd => -0.001);
SELECT ab_point(0, 0, 0, sd => 'infinity');
SELECT ab_point(0, 0, 0, covariance => '{1,0,0,1}');
SELECT ab_point(0, 0, 0, covariance => '{{1,0,0,0},{0,1,0,0},{0,0,1,0}}');
SELECT ab_point(0, 0, 0, covariance => '{{1,0,0},{0,1,0},{0,0,-1e-6}}');
SELECT ab_point(0, 0, 0, covariance => '{{1,2,0},{2,1,0},{0,0,1}}');
SELECT ab_point(0, 0, 0, covariance => '{{1,0.5,0},{0.4,1,0},{0,0,1}}');
SELECT ab_point(0, 0, 0, covariance => '{{1,0,0},{0,1,0},{0,0,nan}}');
SELECT ab_point(0, 0, 0, sd => 0.1, covariance => '{{1,0,0},{0,1,0},{0,0,1}}');
SELECT ab_line(ARRAY[1,2,3]::float8[], ARRAY[1,2,3]::float8[]);
SELECT ab_line(ARRAY[1,2]::float8[], ARRAY[1,2,3]::float8[]);
SELECT ab_plane(ARRAY[0,0,0]::float8[], ARRAY[0,0,0]::float8[]);
SELECT ab_plane(ARRAY[0,0,0]::float8[], ARRAY[0,0,1]::float8[], sd_tilt => 'nan');
SELECT ab_pose(ARRAY[0,0,0]::float8[], ARRAY[0,0,0,0]::float8[]);
SELECT ab_pose(ARRAY[0,0,0]::float8[], ARRAY[1,0,0]::float8[]);
SELECT ab_pose(ARRAY[0,0,0]::float8[], scale => 0);
SELECT ab_pose(ARRAY[0,0,0]::float8[], scale => -1);
-- text and binary
SELECT '(1,2)'::ab_point;
SELECT '(1,2,3;1,0,0,1,0)'::ab_point;
SELECT '(1,2,3;1,0,0,1,0,-1)'::ab_point;
SELECT '(0,0,0,0,0,2)'::ab_plane;
SELECT '(0,0,0,0,0,1;0,0,0,0,0,0,0,1,0,0)'::ab_plane;
SELECT '(2,0,0,0,0,0,0,1)'::ab_pose;
SELECT '{1,2,3,4}'::float8[]::ab_point;
SELECT '{{1,2,3},{4,5,6}}'::float8[]::ab_line;
-- what the objects do not determine
SELECT ab_line(ab_point(1,2,3), ab_point(1,2,3));
SELECT ab_plane(ab_point(0,0,0), ab_point(1,1,1), ab_point(3,3,3));
SELECT ab_plane(ab_line(ab_point(0,0,0), ab_point(1,1,1)), ab_point(600000,600000,600000));
SELECT ab_intersection(ab_plane(ARRAY[0,0,0], ARRAY[0,0,1]), ab_plane(ARRAY[0,0,1], ARRAY[0,0,1]));
SELECT ab_intersection(ab_plane(ARRAY[0,0,0], ARRAY[0,0,1]), ab_plane(ARRAY[0,0,1], ARRAY[0,1,1]), ab_plane(ARRAY[0,0,1], ARRAY[0,1,0]));
SELECT ab_intersection(ab_line('{0,0,1}'::float8[], '{1,0,1}'::float8[]), ab_plane(ARRAY[0,0,0], ARRAY[0,0,1]));
SELECT ab_plane_agg(ab_point(i, 2 * i, 3 * i)) FROM generate_series(1, 9) i;
SELECT ab_plane_agg(ab_point(i, i * i, 0)) FROM generate_series(1, 2) i;
SELECT ab_line_agg(ab_point(1, 1, 1)) FROM generate_series(1, 9) i;
SELECT ab_line_agg(NULL::ab_point), ab_plane(ARRAY[]::ab_point[]);
-- singular covariances: fewer degrees of freedom, and contradiction where nothing may vary
SELECT * FROM ab_test_same(ab_point(0,0,0), ab_point(0,0,0));
SELECT * FROM ab_test_same(ab_point(0,0,0), ab_point(0,0,0.001));
SELECT * FROM ab_test_same(ab_point(0,0,0, covariance => '{1e-6,0,0,0,0,0,0,0,0}'), ab_point(0.002,0,0));
SELECT * FROM ab_test_same(ab_point(0,0,0, covariance => '{1e-6,0,0,0,0,0,0,0,0}'), ab_point(0,0.002,0));
SELECT ab_mahalanobis(ab_point(0,0,0), ab_point(0,0,1));
SELECT ab_is_same(ab_point(0,0,0), ab_point(0,0,0), significance => 0);
SELECT ab_is_same(ab_point(0,0,0), ab_point(0,0,0), significance => 'nan');
SELECT * FROM ab_ellipsoid(ab_point(0,0,0), 1);
SELECT ab_box(ab_point(0,0,0), 0);
SELECT ab_within(ab_point(0,0,0), ab_point(0,0,0), 6);
-- belief
SELECT ab_combine(ab_mass(1, 0), ab_mass(0, 1));
SELECT ab_combine(ab_mass(1, 0), ab_mass(0, 1), 'bayes');
SELECT ab_combine(ab_mass(1, 0), ab_mass(0.5, 0), 'cautious');
SELECT ab_combine_agg(m) FROM (VALUES (ab_mass(1, 0)), (ab_mass(0, 1))) v(m);
SELECT ab_combine_agg(m, 'pcr6') FROM (VALUES (ab_mass(0.5, 0))) v(m);
SELECT ab_combine_agg(m, r) FROM (VALUES (ab_mass(0.5, 0), 'yager'), (ab_mass(0.5, 0), 'murphy')) v(m, r);
SELECT ab_combine_agg(m, 'dempster', 2) FROM (VALUES (ab_mass(0.5, 0))) v(m);
SELECT ab_discount(ab_mass(0.5, 0), -1), 1;
SELECT ab_pignistic(ab_combine(ab_mass(1, 0), ab_mass(0, 1), 'conjunctive'));
SELECT ab_decide(ab_mass(0.5, 0), 'gut');
SELECT ab_decide(ab_mass(0.5, 0), threshold => 2);
SELECT '(0.5,0.2,0.2,0.3)'::ab_mass;
SELECT '(0.5,0.2,0.2)'::ab_mass;
SELECT ab_tie_point_mass(ARRAY[0,0,0]::float8[], ab_point(1,0,0), ARRAY[0,0,'nan']::float8[]);
SELECT ab_dense_mass(ARRAY[0,0,0]::float8[], ARRAY[0,0,0]::float8[], ARRAY[0,0,0]::float8[]);
SELECT ab_image_mass(ARRAY[0,0,0]::float8[], ARRAY[1,0,0]::float8[], ARRAY[1,0,0]::float8[], kappa => 0);
SELECT ab_surface_mass(0, 0, 0.01);
SELECT ab_kappa(0);
SELECT ab_convert_belief(1.5, 0.001, 0.001);
SELECT ab_relative_tolerance(0.01, 0.01, 'cubed');
SELECT ab_is_fit(0.001, 0.015, 'fun');
SELECT 'alive';
