//! Where on the Earth a model says it lies: IfcMapConversion, in metres.

use super::document::Document;
use super::units::{metres, project_metres};
use super::value::Value;

/// Eastings, northings and height are metres, whatever the file counts in.
#[derive(Debug, Clone, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct MapConversion {
    /// Name of the coordinate system, such as EPSG:25832.
    pub system: String,
    pub eastings: f64,
    pub northings: f64,
    pub height: f64,
    /// From the map's east to the model's x axis, counter-clockwise, degrees.
    pub angle: f64,
    pub scale: f64,
}

impl MapConversion {
    /// The first IfcMapConversion of a file.
    pub fn read(document: &Document) -> Option<Self> {
        let record = document.all("IFCMAPCONVERSION").chain(document.all("IFCMAPCONVERSIONSCALED")).next()?;
        let values = document.values(record);
        let number = |i: usize| values.get(i).and_then(Value::number);
        let system = document.values_of(values.get(1)?.reference()?, "IFCPROJECTEDCRS").unwrap_or_default();
        let own = system.get(6).and_then(Value::reference).and_then(|unit| metres(document, unit));
        let unit = own.or_else(|| project_metres(document)).unwrap_or(1.0);
        let name = system.first().and_then(Value::text).map(|t| String::from_utf8_lossy(t).into_owned());
        Some(Self {
            system: name.unwrap_or_default(),
            eastings: number(2)? * unit,
            northings: number(3)? * unit,
            height: number(4)? * unit,
            angle: number(6).unwrap_or(0.0).atan2(number(5).unwrap_or(1.0)).to_degrees(),
            scale: number(7).unwrap_or(1.0),
        })
    }

    pub fn shown(&self) -> String {
        format!(
            "map conversion ({}): eastings {:.3} m, northings {:.3} m, height {:.3} m, {:.6}° from east to x, scale {}; \
             told only, the model is loaded in its own coordinates",
            if self.system.is_empty() { "coordinate system not named" } else { &self.system },
            self.eastings,
            self.northings,
            self.height,
            self.angle,
            self.scale
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn in_metres_by_the_maps_unit_or_the_projects() {
        let seen = |unit: &str| {
            let text = format!(
                "#1=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);#2=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);\
                 #3=IFCUNITASSIGNMENT((#1));#4=IFCPROJECT('x',$,$,$,$,$,$,$,#3);\
                 #22=IFCPROJECTEDCRS('EPSG:25832',$,$,$,$,$,{unit});\
                 #23=IFCMAPCONVERSION(#6,#22,512345.,5412345.,101.5,0.8660254,0.5,$);"
            );
            MapConversion::read(&Document::new(text.as_bytes())).unwrap()
        };
        let (map, project) = (seen("#2"), seen("$"));
        assert_eq!((map.eastings, map.height, map.scale), (512345.0, 101.5, 1.0));
        assert!((map.angle - 30.0).abs() < 1e-5);
        assert!((project.eastings - 512.345).abs() < 1e-9 && (project.northings - 5412.345).abs() < 1e-9);
    }
}
