//! The tables of models and scans: how they are created and how they are recognised.

/// What the columns of a station's origin are.
macro_rules! origin_comments {
    () => {
        "COMMENT ON COLUMN @station.origin_source IS 'Who says where the scanner stood: file (that of the scans), \
         given (asbuilt load --origin, --origins FILE), recovered (--origins recover); NULL for points without origin, and for what was loaded before layout 3'; \
         COMMENT ON COLUMN @station.origin_sd IS 'Standard deviation of the scanner''s position along each axis, metres; \
         NULL where it is not known'"
    };
}

/// A table of models or scans.
pub struct TableOf {
    pub name: &'static str,
    /// The statement that creates it; `@` names are completed by [`super::names::Names::sql`].
    pub ddl: &'static str,
    /// Columns by which it is recognised: name and type, those of the extension with `ab_`.
    pub columns: &'static [(&'static str, &'static str)],
}

/// What the loader fills and the verdict reads, in the order in which they are created.
pub const TOUR: [TableOf; 3] = [
    TableOf {
        name: "building_object",
        ddl: "CREATE TABLE @building_object (
            id         bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
            global_id  text NOT NULL,
            ifc_class  text NOT NULL,
            name       text NOT NULL,
            storey     text,
            loa        @ext.ab_loa NOT NULL,
            solid      @ext.ab_solid,
            properties jsonb NOT NULL,
            source     text NOT NULL,
            UNIQUE (source, global_id)
        );
        CREATE INDEX building_object_solid_idx ON @building_object USING gist (solid);
        COMMENT ON TABLE @building_object IS 'Objects of the building model; solid is NULL where the geometry could not be meshed';",
        columns: &[
            ("id", "int8"),
            ("global_id", "text"),
            ("ifc_class", "text"),
            ("name", "text"),
            ("storey", "text"),
            ("loa", "ab_loa"),
            ("solid", "ab_solid"),
            ("properties", "jsonb"),
            ("source", "text"),
        ],
    },
    TableOf {
        name: "station",
        ddl: concat!(
            "CREATE TABLE @station (
            id            bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
            epoch         integer NOT NULL,
            name          text NOT NULL,
            pose          @ext.ab_pose,
            sensor        text,
            source        text NOT NULL,
            origin_source text,
            origin_sd     float8
        );
        CREATE INDEX station_epoch_idx ON @station (epoch);
        COMMENT ON TABLE @station IS 'Scanner positions: pose is the transform from scanner to world, as far as the file tells it; NULL for points without origin'; ",
            origin_comments!()
        ),
        // How its origin is known came with layout 3.
        columns: &[
            ("id", "int8"),
            ("epoch", "int4"),
            ("name", "text"),
            ("pose", "ab_pose"),
            ("sensor", "text"),
            ("source", "text"),
        ],
    },
    TableOf {
        name: "scan",
        ddl: "CREATE TABLE @scan (
            id         bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
            station_id bigint NOT NULL REFERENCES @station ON DELETE CASCADE,
            epoch      integer NOT NULL,
            patch      @ext.ab_scan NOT NULL
        );
        CREATE INDEX scan_patch_idx ON @scan USING gist (patch);
        CREATE INDEX scan_station_idx ON @scan (station_id);
        COMMENT ON TABLE @scan IS 'Patches of at most 4096 neighbouring beams of a station';",
        // Its key came with layout 2.
        columns: &[("station_id", "int8"), ("epoch", "int4"), ("patch", "ab_scan")],
    },
];

/// Layout of the tables that this program creates. 1: as in 0.1.0; 2: with `scan.id`; 3: with `station.origin_source` and
/// `station.origin_sd`.
pub const LAYOUT: i32 = 3;

/// The columns of [`TOUR`]'s station that came with layout 3.
pub const ORIGIN_COLUMNS: [(&str, &str); 2] = [("origin_source", "text"), ("origin_sd", "float8")];

/// Holds the number of their layout, for newer programs.
pub const LAYOUT_TABLE: TableOf = TableOf {
    name: "asbuilt_layout",
    ddl: "CREATE TABLE @asbuilt_layout (
            layout integer NOT NULL,
            one    boolean NOT NULL DEFAULT true CHECK (one) PRIMARY KEY
        );
        COMMENT ON TABLE @asbuilt_layout IS 'Layout of the tables building_object, station and scan, by which the program asbuilt knows what it has to bring up to date';
        GRANT SELECT ON @asbuilt_layout TO PUBLIC;",
    columns: &[("layout", "int4")],
};

/// What brings tables of one layout to the next.
pub struct Migration {
    pub from: i32,
    /// The place in [`TOUR`] of the table that it changes.
    pub table: usize,
    pub ddl: &'static str,
    /// How the user is told.
    pub what: &'static str,
}

/// In the order of layouts.
pub const MIGRATIONS: [Migration; 2] = [
    Migration {
        from: 1,
        table: 2,
        ddl: "ALTER TABLE @scan ADD COLUMN id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY",
        what: "scan has the primary key id",
    },
    // Who dropped the key of a scan table by hand has them already.
    Migration {
        from: 2,
        table: 1,
        ddl: concat!(
            "ALTER TABLE @station ADD COLUMN IF NOT EXISTS origin_source text, ADD COLUMN IF NOT EXISTS origin_sd float8; ",
            origin_comments!()
        ),
        what: "station has the columns origin_source and origin_sd",
    },
];
