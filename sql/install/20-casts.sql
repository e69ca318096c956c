-- Casts between uncertain objects and their numbers.

CREATE CAST (ab_point AS float8[]) WITH FUNCTION ab_numbers(ab_point);
COMMENT ON CAST (ab_point AS float8[]) IS 'All its numbers';

CREATE CAST (float8[] AS ab_point) WITH FUNCTION ab_point_of(float8[]);
COMMENT ON CAST (float8[] AS ab_point) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE CAST (ab_line AS float8[]) WITH FUNCTION ab_numbers(ab_line);
COMMENT ON CAST (ab_line AS float8[]) IS 'All its numbers';

CREATE CAST (float8[] AS ab_line) WITH FUNCTION ab_line_of(float8[]);
COMMENT ON CAST (float8[] AS ab_line) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE CAST (ab_plane AS float8[]) WITH FUNCTION ab_numbers(ab_plane);
COMMENT ON CAST (ab_plane AS float8[]) IS 'All its numbers';

CREATE CAST (float8[] AS ab_plane) WITH FUNCTION ab_plane_of(float8[]);
COMMENT ON CAST (float8[] AS ab_plane) IS 'From its coordinates alone (exact) or from all its numbers';

CREATE CAST (ab_pose AS float8[]) WITH FUNCTION ab_numbers(ab_pose);
COMMENT ON CAST (ab_pose AS float8[]) IS 'All its numbers';

CREATE CAST (float8[] AS ab_pose) WITH FUNCTION ab_pose_of(float8[]);
COMMENT ON CAST (float8[] AS ab_pose) IS 'From its coordinates alone (exact) or from all its numbers';
