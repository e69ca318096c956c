-- Session
-- What asbuilt takes in this session.

-- ab_memory
-- Bytes; they differ from session to session.
SELECT m.live <= m.peak AS in_order FROM ab_memory() m;
