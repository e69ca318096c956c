//! How to read scans: on the command line of `load` and `inspect`, and of the process that reads for them.

use asbuilt_core::geometry::Vec3;
use clap::ValueEnum;

use super::frame::parse_metres;
use super::origin::Listing;
use super::{Columns, FrameOptions, IdentityPose, OriginsChoice, Unit};

#[derive(clap::Args, Debug, Clone, Default)]
pub struct ReadOptions {
    /// The scanner's position, for files that do not tell it
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = parse_metres)]
    pub origin: Option<Vec3>,
    /// Several scanner positions: a text with a line station,x,y,z[,sd] each (metres), where a station is a point source id of LAS,
    /// or the name or the number of a scan; or none: points without origin, whatever the file says; or recover: find the
    /// position from the order of the points, where it proves it (whole scans of a tripod, one a file or a point source id)
    #[arg(long, value_name = "FILE|none|recover", conflicts_with = "origin")]
    pub origins: Option<OriginsChoice>,
    /// Keep the intensity of every return (E57, LAS, LAZ, texts with a column i); 1 to 2 bytes a beam more
    #[arg(long)]
    pub intensity: bool,
    /// Keep the colour of every return (E57, LAS, LAZ, texts with columns r, g, b); up to 3 bytes a beam more
    #[arg(long, alias = "color")]
    pub colour: bool,
    /// What the columns of a text of points hold, in their order: n (number), x, y, z, i (intensity), r, g, b, - (passed over)
    #[arg(long, value_name = "n,x,y,z,…", allow_hyphen_values = true)]
    pub columns: Option<Columns>,
    /// A comma within a number of a text is its decimal mark, where the numbers themselves do not tell
    #[arg(long)]
    pub decimal_comma: bool,
    /// What the numbers of a file count in that does not tell it itself
    #[arg(long, value_name = "UNIT")]
    pub file_unit: Option<Unit>,
    #[command(flatten)]
    pub frame: FrameOptions,
    /// Keep the points of LAS and LAZ that are classified as noise (classes 7 and 18)
    #[arg(long)]
    pub keep_noise: bool,
    /// What to make of a scanner at zero without rotation, as merged clouds have it
    #[arg(long, value_enum, default_value_t)]
    pub identity_pose: IdentityPose,
}

impl ReadOptions {
    /// Refuses a listing of origins or a transform that cannot be read, before anything else is done.
    pub fn check(&self) -> anyhow::Result<()> {
        self.frame.model_from_file()?;
        match &self.origins {
            Some(OriginsChoice::Listed(file)) => Listing::read(file).map(|_| ()),
            _ => Ok(()),
        }
    }

    /// As arguments of a command line.
    pub fn arguments(&self) -> Vec<String> {
        let mut out = vec![format!("--identity-pose={}", word(&self.identity_pose))];
        out.extend(self.origin.map(|o| format!("--origin={},{},{}", o.x, o.y, o.z)));
        out.extend(self.origins.as_ref().map(|origins| format!("--origins={origins}")));
        out.extend(self.columns.as_ref().map(|columns| format!("--columns={columns}")));
        out.extend(self.file_unit.map(|unit| format!("--file-unit={}", word(&unit))));
        out.extend(self.frame.arguments());
        let flags = [
            (self.intensity, "--intensity"),
            (self.colour, "--colour"),
            (self.decimal_comma, "--decimal-comma"),
            (self.keep_noise, "--keep-noise"),
        ];
        out.extend(flags.iter().filter(|(is_set, _)| *is_set).map(|(_, flag)| (*flag).to_owned()));
        out
    }
}

/// A value as it is written on the command line.
pub fn word(value: &impl ValueEnum) -> String {
    value.to_possible_value().map(|v| v.get_name().to_owned()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        options: ReadOptions,
    }

    #[test]
    fn what_is_handed_on_is_what_was_given() {
        let given = ReadOptions {
            origin: Some(Vec3::new(-0.1, 1e-7, 5e6)),
            origins: None,
            intensity: true,
            colour: true,
            columns: Some("-,y,x,z".parse().unwrap()),
            decimal_comma: true,
            file_unit: Some(Unit::UsFt),
            frame: FrameOptions { offset: parse_metres("-1e6,0.25,-3").ok(), transform: None },
            keep_noise: true,
            identity_pose: IdentityPose::Merged,
        };
        let listed = |text: &str| ReadOptions { origin: None, origins: text.parse().ok(), ..given.clone() };
        let transformed = FrameOptions { offset: None, transform: Some("a b.txt".into()) };
        let turned = ReadOptions { frame: transformed, ..given.clone() };
        for options in [turned, listed("none"), listed("recover"), listed("-a b.csv"), given, ReadOptions::default()] {
            let line = Line::parse_from(["read-scan".to_owned()].into_iter().chain(options.arguments()));
            assert_eq!(format!("{:?}", line.options), format!("{options:?}"));
        }
    }
}
