//! Intensity and colour of points that are read as plain numbers.

use asbuilt_core::scan::{Beam, Beams};

use super::ReadOptions;
use super::text::{ColumnRole, Columns};

/// What was measured of every point besides its place.
#[derive(Debug, Default)]
pub struct Planes {
    intensity: Option<Vec<f64>>,
    colour: Option<Vec<[f64; 3]>>,
}

impl Planes {
    /// The attributes that the columns hold and the user wants.
    pub fn wanted(columns: &Columns, options: &ReadOptions) -> Self {
        let has = |c| columns.place(c).is_some();
        let is_coloured = has(ColumnRole::Red) && has(ColumnRole::Green) && has(ColumnRole::Blue);
        Self {
            intensity: (options.intensity && has(ColumnRole::Intensity)).then(Vec::new),
            colour: (options.colour && is_coloured).then(Vec::new),
        }
    }

    pub fn add(&mut self, value: impl Fn(ColumnRole) -> Option<f64>) {
        let number = |c| value(c).unwrap_or(0.0);
        if let Some(plane) = &mut self.intensity {
            plane.push(number(ColumnRole::Intensity));
        }
        if let Some(plane) = &mut self.colour {
            plane.push([ColumnRole::Red, ColumnRole::Green, ColumnRole::Blue].map(number));
        }
    }

    /// The content of the points: intensities of 0 to 1, -2048 to 2047 (PTS) or 0 to 65535, colours of 0 to 1 or 255.
    pub fn content(self, beams: Vec<Beam>) -> Beams {
        let mut content = Beams::of(beams);
        content.intensity = self.intensity.map(|plane| {
            let low = plane.iter().copied().fold(0.0, f64::min);
            let high = plane.iter().copied().fold(0.0, f64::max);
            let (shift, scale) =
                if low < 0.0 { (2048.0, 16.0) } else { (0.0, if high <= 1.0 { 65_535.0 } else { 1.0 }) };
            plane.iter().map(|i| ((i + shift) * scale).round() as u16).collect()
        });
        content.colour = self.colour.map(|plane| {
            let high = plane.iter().flatten().copied().fold(0.0, f64::max);
            let scale = if high <= 1.0 { 255.0 } else { 1.0 };
            plane.iter().map(|c| c.map(|part| (part * scale).round() as u8)).collect()
        });
        content
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asbuilt_core::geometry::Vec3;

    #[test]
    fn ranges_of_values_are_told_apart() {
        let columns: Columns = "x,y,z,i,r,g,b".parse().unwrap();
        let options = ReadOptions { intensity: true, colour: true, ..ReadOptions::default() };
        for (intensity, colour, expected, part) in
            [(0.5, 0.2, 32_768, 51), (1000.0, 51.0, 1000, 51), (-2048.0, 51.0, 0, 51)]
        {
            let mut planes = Planes::wanted(&columns, &options);
            planes.add(|c| Some(if c == ColumnRole::Intensity { intensity } else { colour }));
            let content = planes.content(vec![Beam { offset: Vec3::zeros(), returned: true }]);
            assert_eq!(content.intensity, Some(vec![expected]));
            assert_eq!(content.colour, Some(vec![[part; 3]]));
        }
    }
}
