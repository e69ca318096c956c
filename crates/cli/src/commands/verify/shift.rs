//! A rigid offset with its standard deviation, printed.

use serde_json::Value;

use crate::output::{Format, LengthUnit};

/// Numbers along x, y and z; `None` where the seen faces do not determine one, or any. Metres.
pub type NumbersByAxis = Option<Vec<Option<f64>>>;

/// One text for people, a number a column for spreadsheets, arrays for programs.
pub fn shift_columns(format: Format, unit: LengthUnit) -> Vec<String> {
    let names: &[&str] = match format {
        Format::Table => &["shift"],
        Format::Csv | Format::CsvExact => &["shift_x", "shift_y", "shift_z", "shift_sd_x", "shift_sd_y", "shift_sd_z"],
        Format::Json => &["shift", "shift_sd"],
    };
    names.iter().map(|name| unit.column(name)).collect()
}

/// The offset and its standard deviation under these columns, to a tenth of a millimetre.
pub fn shift(format: Format, unit: LengthUnit, offset: NumbersByAxis, sd: NumbersByAxis) -> Vec<Value> {
    let values = |axes: &NumbersByAxis| axes.as_ref().map(|a| a.iter().map(|v| unit.value(*v)).collect::<Vec<_>>());
    match format {
        Format::Table => {
            let words = |axes: Vec<Option<f64>>, word: &dyn Fn(f64) -> String| {
                axes.into_iter().map(|v| v.map_or("-".into(), word)).collect::<Vec<_>>().join(", ")
            };
            let text = |(o, s)| format!("({}) +/- ({})", words(o, &|v| unit.signed(v)), words(s, &|v| unit.text(v)));
            vec![offset.zip(sd).map_or(Value::Null, |both| text(both).into())]
        }
        Format::Csv | Format::CsvExact => {
            [offset, sd].iter().flat_map(|axes| values(axes).unwrap_or(vec![Value::Null; 3])).collect()
        }
        Format::Json => [offset, sd].iter().map(|axes| values(axes).map_or(Value::Null, Value::from)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shift_is_told_in_numbers() {
        let (offset, sd) =
            (Some(vec![Some(0.012_14), None, Some(-0.0003)]), Some(vec![Some(0.0004), None, Some(0.001)]));
        let told = |format, unit| {
            let values = shift(format, unit, offset.clone(), sd.clone());
            assert_eq!(values.len(), shift_columns(format, unit).len());
            assert!(shift(format, unit, None, None).iter().all(Value::is_null));
            Value::from(values).to_string()
        };
        let (m, mm) = (LengthUnit::M, LengthUnit::Mm);
        assert_eq!(told(Format::Table, m), r#"["(+0.0121, -, -0.0003) +/- (0.0004, -, 0.0010)"]"#);
        assert_eq!(told(Format::Table, mm), r#"["(+12.1, -, -0.3) +/- (0.4, -, 1.0)"]"#);
        assert_eq!(told(Format::Csv, m), "[0.0121,null,-0.0003,0.0004,null,0.001]");
        assert_eq!(told(Format::Json, mm), "[[12.1,null,-0.3],[0.4,null,1.0]]");
        assert_eq!(shift_columns(Format::Json, mm), ["shift_mm", "shift_sd_mm"]);
    }
}
