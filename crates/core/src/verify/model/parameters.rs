//! Parameters of the evidence.

use super::intensity::IntensityNoise;
use super::kind::ModelKind;
use super::question::Question;
use crate::error::{Error, Result};
use crate::evidence::{Loa, RayModel};
use crate::num::bytes::{ByteReader, Put};
use crate::num::text::number;
use crate::scan::{JOIN_MARGIN_M, NO_RETURN_REACH_M};

/// How evidence is gathered, stored with its sums, and what is asked of it unless a query asks otherwise: SQL's
/// `ab_evidence_model`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvidenceModel {
    /// Which model.
    pub kind: ModelKind,
    /// What is asked. Its tolerance also says how far in front of a face its surface is looked for.
    pub question: Question,
    /// Distance between samples on the solid, metres.
    pub spacing: f64,
    /// Standard deviation of a range, metres.
    pub sigma_range: f64,
    /// Standard deviation of a direction, radians.
    pub sigma_angle: f64,
    /// Standard deviation of a station's registration, metres per axis: common to all its beams.
    pub sigma_station: f64,
    /// Standard deviation of the model's own surface and of what else all beams have in common (datum, the scanner's bias),
    /// metres.
    pub sigma_model: f64,
    /// Reliability α of a station: the most belief it can give. Below 1, so that nothing can veto.
    pub reliability: f64,
    /// Beams that meet a face at more than this from its normal, radians, tell nothing of it.
    pub max_incidence: f64,
    /// A beam without return counts as empty space up to this range, metres.
    pub no_return_range: f64,
    /// Weight of such beams (0 ignores them): dark and glossy surfaces do not return either.
    pub no_return_weight: f64,
    /// Ray model `meyer2022`: decay across the ray, 1/m².
    pub kappa: f64,
    /// Ray model: steepness along the ray, 1/m.
    pub lambda: f64,
    /// Ray model: half-width of the occupied band in units of 1/λ.
    pub c: f64,
    /// How far from its drawn place an object is looked for by a second look, metres: evidence itself does not depend on
    /// it.
    pub reach: f64,
    /// Range noise by intensity, where patches have it; `None`: `sigma_range` holds for all beams.
    pub intensity: Option<IntensityNoise>,
}

impl Default for EvidenceModel {
    /// A current terrestrial laser scanner, registered to a millimetre, against a LOA30 model.
    fn default() -> Self {
        Self {
            kind: ModelKind::Surface,
            question: Question::default(),
            spacing: 0.02,
            sigma_range: 0.001,
            sigma_angle: 4e-5,
            sigma_station: 0.001,
            sigma_model: 0.0,
            reliability: 0.99,
            max_incidence: 80f64.to_radians(),
            no_return_range: NO_RETURN_REACH_M,
            no_return_weight: 0.25,
            kappa: RayModel::LASER.kappa,
            lambda: RayModel::LASER.lambda,
            c: RayModel::LASER.c,
            reach: 0.3,
            intensity: None,
        }
    }
}

type ParameterRow = (&'static str, fn(&mut EvidenceModel) -> &mut f64, f64, f64, &'static str);

/// Name, place, allowed range, and that range in words, of every number.
const FIELDS: [ParameterRow; 13] = [
    ("spacing", |m| &mut m.spacing, 1e-4, EvidenceModel::MAX_SPACING_M, "between 0.0001 and 10 m"),
    ("sigma_range", |m| &mut m.sigma_range, 0.0, 1.0, "between 0 and 1 m"),
    ("sigma_angle", |m| &mut m.sigma_angle, 0.0, 0.1, "between 0 and 0.1 rad"),
    ("sigma_station", |m| &mut m.sigma_station, 0.0, 1.0, "between 0 and 1 m"),
    ("sigma_model", |m| &mut m.sigma_model, 0.0, 1.0, "between 0 and 1 m"),
    ("confidence", |m| &mut m.question.confidence, 0.5, 0.9999, "between 0.5 and 0.9999"),
    ("reliability", |m| &mut m.reliability, 0.5, 0.999999, "between 0.5 and 0.999999"),
    ("max_incidence", |m| &mut m.max_incidence, 0.1, 1.55, "between 0.1 and 1.55 rad"),
    ("no_return_range", |m| &mut m.no_return_range, 0.0, NO_RETURN_REACH_M, "between 0 and 30 m"),
    ("no_return_weight", |m| &mut m.no_return_weight, 0.0, 1.0, "between 0 and 1"),
    ("kappa", |m| &mut m.kappa, 1e3, 1e12, "between 1000 and 1e12 per square metre"),
    ("lambda", |m| &mut m.lambda, 1.0, 1e9, "between 1 and 1e9 per m"),
    ("c", |m| &mut m.c, 0.01, 100.0, "between 0.01 and 100"),
];

/// The same of the one that is not stored with the sums.
const REACH: ParameterRow = ("reach", |m| &mut m.reach, 0.0, 2.0, "between 0 and 2 m");

impl EvidenceModel {
    /// Widest spacing of samples, metres.
    pub const MAX_SPACING_M: f64 = 10.0;

    /// Bytes of the stored form: model u32 (its upper three bytes: noise by intensity), level of accuracy u32, then the
    /// numbers as f64, little-endian.
    pub const LEN: usize = 8 + 8 * FIELDS.len();

    /// Names of the numeric parameters, in the order of [`EvidenceModel::set`]'s table and of the text form.
    pub fn names() -> impl Iterator<Item = &'static str> {
        FIELDS.iter().map(|f| f.0)
    }

    /// The numeric parameters, in the order of [`EvidenceModel::names`]. In SI units.
    pub fn numbers(&self) -> [f64; 13] {
        let mut copy = *self;
        FIELDS.map(|(_, place, ..)| *place(&mut copy))
    }

    /// Sets a numeric parameter by name, checking its range. In SI units.
    pub fn set(&mut self, name: &str, value: f64) -> Result<()> {
        let &(what, place, min, max, expected) = FIELDS
            .iter()
            .chain([&REACH])
            .find(|f| f.0 == name)
            .ok_or_else(|| Error::argument("the parameter", "one of ab_evidence_model's", format!("'{name}'")))?;
        if !(min..=max).contains(&value) {
            return Err(Error::argument(what, expected, value));
        }
        *place(self) = value;
        Ok(())
    }

    /// Variance that no number of beams and no registration takes away, m²: a tenth of a millimetre, the zero point of
    /// a good scanner.
    pub fn least_variance(&self) -> f64 {
        1e-8
    }

    /// Variance that a mean over samples shares, m², where the squares of the stations' shares in it add up to `squares`:
    /// registration averages out over stations only, the model not.
    pub fn common_variance(&self, squares: f64) -> f64 {
        self.sigma_station.powi(2) * squares + self.sigma_model.powi(2) + self.least_variance()
    }

    /// σ of a deviation's second order, metres: a surface off by this much is also turned a little, and beams meet it
    /// beside the place that they tell of.
    pub fn second_order_sd(&self, deviation: f64) -> f64 {
        0.01 * deviation
    }

    /// How far behind a face a return is still the face's surface, metres; farther behind, the beam passed through it.
    /// The bound of the coarsest level of accuracy: any can be asked of the same evidence, and what lies farther off is
    /// in none of them.
    pub fn band_behind(&self) -> f64 {
        Loa::Loa10.upper()
    }

    /// How far in front of a face a return may be the face's surface, metres; farther in front it is something else
    /// that hides it. No wider than the tolerance asks for: furniture stands there.
    pub fn band_in_front(&self) -> f64 {
        (self.question.tolerance() + 0.05).clamp(0.1, JOIN_MARGIN_M)
    }

    /// How far from the drawn surface anything is added up, metres.
    pub fn band(&self) -> f64 {
        self.band_behind().max(self.band_in_front())
    }

    /// How far from the drawn surface anything is looked for, metres.
    pub fn farthest(&self) -> f64 {
        self.reach.max(self.band())
    }

    /// The ray model's parameters.
    pub fn ray_model(&self) -> RayModel {
        RayModel { kappa: self.kappa, lambda: self.lambda, c: self.c }
    }

    /// The parameters in which two models differ, as text.
    pub fn difference(&self, other: &Self) -> String {
        let (a, b) = (self.to_text(), other.to_text());
        let pairs = a.split(' ').zip(b.split(' ')).filter(|(x, y)| x != y);
        pairs.map(|(x, y)| format!("{x} and {y}")).collect::<Vec<_>>().join(", ")
    }

    /// Appends the stored form.
    pub fn write(&self, out: &mut Vec<u8>) {
        out.put_u32(self.kind as u32 | IntensityNoise::packed(self.intensity));
        out.put_u32(self.question.loa as u32);
        // Zero has no sign: text and binary forms say the same.
        self.numbers().iter().for_each(|&x| out.put_f64(x + 0.0));
    }

    /// Reads the stored form, checking every range.
    pub fn read(r: &mut ByteReader) -> Result<Self> {
        let word = r.u32()?;
        let number = word & 0xff;
        let kind = ModelKind::of_number(number).ok_or_else(|| r.bad(format!("unknown evidence model {number}")))?;
        let loa = r.u32()?;
        let loa = *Loa::ALL.get(loa as usize).ok_or_else(|| r.bad(format!("unknown level of accuracy {loa}")))?;
        let question = Question { loa, ..Question::default() };
        let mut model = Self { kind, question, intensity: IntensityNoise::unpacked(word), ..Self::default() };
        if IntensityNoise::packed(model.intensity) != word & !0xff {
            return Err(r.bad(format!("noise by intensity {word:#x}")));
        }
        for name in Self::names() {
            model.set(name, r.f64()?)?;
        }
        Ok(model)
    }

    /// Text form `model=surface loa=LOA30 spacing=0.02 …`.
    pub fn to_text(&self) -> String {
        let mut out = format!("model={} loa={}", self.kind.name(), self.question.loa.name());
        for (name, value) in Self::names().zip(self.numbers()) {
            out += &format!(" {name}={}", number(value));
        }
        if self.reach != Self::default().reach {
            out += &format!(" reach={}", number(self.reach));
        }
        if let Some(noise) = self.intensity {
            out += &format!(" intensity={}^{}", noise.reference, number(noise.exponent()));
        }
        out
    }

    /// Reads [`EvidenceModel::to_text`]'s form; what is not named keeps its default, and a level of accuracy need
    /// not be named (SQL reads `ab_evidence_model('LOA20')` as this text, not as a call).
    pub fn from_text(text: &str) -> Result<Self> {
        let bad = || Error::syntax("ab_evidence_model", text);
        let mut m = Self::default();
        for word in text.split_whitespace() {
            let (name, value) = word.split_once('=').unwrap_or(("loa", word));
            match name {
                "model" => m.kind = ModelKind::parse(value)?,
                "loa" => m.question.loa = Loa::parse(value)?,
                "intensity" => {
                    let (reference, exponent) = value.split_once('^').ok_or_else(bad)?;
                    let reference = reference.parse().map_err(|_| bad())?;
                    m.intensity = Some(IntensityNoise::new(reference, exponent.parse().map_err(|_| bad())?)?);
                }
                _ => m.set(name, value.parse().map_err(|_| bad())?)?,
            }
        }
        Ok(m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_round_trips_and_checks_ranges() {
        let mut m = EvidenceModel::default();
        m.question.loa = Loa::Loa40;
        m.kind = ModelKind::Meyer2022;
        m.set("sigma_range", 0.1 + 0.2).unwrap();
        m.set("reach", 0.5).unwrap();
        assert_eq!(EvidenceModel::from_text(&m.to_text()).unwrap(), m);
        m.set("reach", 0.3).unwrap();
        m.intensity = Some(IntensityNoise::new(1200, 1.5).unwrap());
        let mut bytes = Vec::new();
        m.write(&mut bytes);
        assert_eq!(EvidenceModel::read(&mut ByteReader::new(&bytes, "model")).unwrap(), m);
        assert_eq!(EvidenceModel::from_text(&m.to_text()).unwrap(), m);
        assert_eq!(EvidenceModel::from_text("").unwrap(), EvidenceModel::default());
        assert_eq!(EvidenceModel::from_text("LOA20").unwrap().question.loa, Loa::Loa20);
        for bad in ["spacing", "spacing=x", "spacing=0", "spacing=nan", "model=other", "loa=LOA35", "colour=1"] {
            assert!(EvidenceModel::from_text(bad).is_err(), "{bad}");
        }
        let e = EvidenceModel::from_text("sigma_range=-0.001").unwrap_err();
        assert_eq!(e.to_string(), "sigma_range must be between 0 and 1 m, not -0.001");
    }
}
