//! Units of length that drawings and models name.

use crate::shown;

/// Units of length: those of DXF's `$INSUNITS`, and SVG's pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// 25.4 mm.
    Inch,
    /// 12 inches.
    Foot,
    /// 5280 feet.
    Mile,
    /// A thousandth of a metre.
    Millimetre,
    /// A hundredth of a metre.
    Centimetre,
    /// A metre.
    Metre,
    /// A thousand metres.
    Kilometre,
    /// A millionth of an inch.
    Microinch,
    /// A thousandth of an inch.
    Mil,
    /// 36 inches.
    Yard,
    /// 10⁻¹⁰ m.
    Angstrom,
    /// 10⁻⁹ m.
    Nanometre,
    /// A millionth of a metre.
    Micrometre,
    /// A tenth of a metre.
    Decimetre,
    /// Ten metres.
    Decametre,
    /// A hundred metres.
    Hectometre,
    /// 10⁹ m.
    Gigametre,
    /// 149,597,870,700 m.
    AstronomicalUnit,
    /// Distance travelled by light in a Julian year.
    LightYear,
    /// 648,000/π astronomical units.
    Parsec,
    /// 1200/3937 m.
    SurveyFoot,
    /// A twelfth of a survey foot.
    SurveyInch,
    /// Three survey feet.
    SurveyYard,
    /// 5280 survey feet.
    SurveyMile,
    /// 1/96 inch.
    Pixel,
}

/// A unit's number in `$INSUNITS` (0 for none), its length in ångströms, and its names in models, the first the one that is
/// written.
struct Entry(Unit, i64, f64, &'static [&'static str]);

/// The lengths of the units in common use are whole numbers of ångströms, so that ratios of theirs are rounded once.
const UNITS: [Entry; 25] = [
    Entry(Unit::Inch, 1, 254e6, &["in", "inch", "inches", "\""]),
    Entry(Unit::Foot, 2, 3048e6, &["ft", "foot", "feet"]),
    Entry(Unit::Mile, 3, 16_093_440e6, &["mi", "mile", "miles"]),
    Entry(
        Unit::Millimetre,
        4,
        1e7,
        &[
            "mm",
            "millimetre",
            "millimeter",
            "millimetres",
            "millimeters",
        ],
    ),
    Entry(
        Unit::Centimetre,
        5,
        1e8,
        &[
            "cm",
            "centimetre",
            "centimeter",
            "centimetres",
            "centimeters",
        ],
    ),
    Entry(
        Unit::Metre,
        6,
        1e10,
        &["m", "metre", "meter", "metres", "meters"],
    ),
    Entry(
        Unit::Kilometre,
        7,
        1e13,
        &["km", "kilometre", "kilometer", "kilometres", "kilometers"],
    ),
    Entry(
        Unit::Microinch,
        8,
        254.0,
        &["uin", "µin", "μin", "microinch", "microinches"],
    ),
    Entry(Unit::Mil, 9, 254e3, &["mil", "mils", "thou"]),
    Entry(Unit::Yard, 10, 9144e6, &["yd", "yard", "yards"]),
    Entry(
        Unit::Angstrom,
        11,
        1.0,
        &["Å", "Å", "angstrom", "angstroms"],
    ),
    Entry(
        Unit::Nanometre,
        12,
        10.0,
        &["nm", "nanometre", "nanometer", "nanometres", "nanometers"],
    ),
    Entry(
        Unit::Micrometre,
        13,
        1e4,
        &["um", "µm", "μm", "micron", "microns"],
    ),
    Entry(
        Unit::Decimetre,
        14,
        1e9,
        &["dm", "decimetre", "decimeter", "decimetres", "decimeters"],
    ),
    Entry(
        Unit::Decametre,
        15,
        1e11,
        &["dam", "decametre", "decameter"],
    ),
    Entry(
        Unit::Hectometre,
        16,
        1e12,
        &["hm", "hectometre", "hectometer"],
    ),
    Entry(Unit::Gigametre, 17, 1e19, &["Gm", "gigametre", "gigameter"]),
    Entry(Unit::AstronomicalUnit, 18, 149_597_870_700e10, &["au"]),
    Entry(Unit::LightYear, 19, 9.460_730_472_580_8e25, &["ly"]),
    Entry(
        Unit::Parsec,
        20,
        149_597_870_700e10 * 648e3 / core::f64::consts::PI,
        &["parsec", "parsecs"],
    ),
    Entry(Unit::SurveyFoot, 21, SURVEY_FOOT, &["ftUS"]),
    Entry(Unit::SurveyInch, 22, SURVEY_FOOT / 12.0, &["inUS"]),
    Entry(Unit::SurveyYard, 23, SURVEY_FOOT * 3.0, &["ydUS"]),
    Entry(Unit::SurveyMile, 24, SURVEY_FOOT * 5280.0, &["miUS"]),
    Entry(Unit::Pixel, 0, 254e6 / 96.0, &["px"]),
];

/// Length in ångströms.
const SURVEY_FOOT: f64 = 1200e10 / 3937.0;

impl Unit {
    /// All units.
    pub fn all() -> impl Iterator<Item = Self> {
        UNITS.iter().map(|e| e.0)
    }

    fn entry(self) -> &'static Entry {
        // The table has every unit.
        UNITS.iter().find(|e| e.0 == self).unwrap_or(&UNITS[3])
    }

    /// The label in a model's `unit`.
    pub fn label(self) -> &'static str {
        self.entry().3[0]
    }

    /// Length of this unit in another.
    pub fn ratio(self, to: Self) -> f64 {
        self.entry().2 / to.entry().2
    }

    /// The unit of a label.
    pub fn of_label(label: &str) -> Option<Self> {
        let of = |label: &str| UNITS.iter().find(|e| e.3.contains(&label)).map(|e| e.0);
        let label = label.trim();
        of(label).or_else(|| of(&label.to_lowercase()))
    }

    /// Number in DXF's `$INSUNITS`; 0 if there is none.
    pub(crate) fn dxf(self) -> i64 {
        self.entry().1
    }

    /// The unit of a number of DXF's `$INSUNITS`.
    pub(crate) fn of_dxf(number: i64) -> Option<Self> {
        let entry = UNITS.iter().find(|e| e.1 == number && number != 0);
        entry.map(|e| e.0)
    }
}

/// Conversion of a drawing's lengths to those of a model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Conversion<'a> {
    /// Numbers are used unchanged: the units are equal, or one of them is not named.
    None,
    /// Both units are known, and differ.
    Between(Unit, Unit),
    /// The numbers are taken as they are, for the label of the model's unit is not that of a known one.
    Unknown(Unit, &'a str),
}

impl<'a> Conversion<'a> {
    /// Conversion from the unit that a drawing names to the unit of a label.
    pub fn new(from: Option<Unit>, label: Option<&'a str>) -> Self {
        match (from, label, label.and_then(Unit::of_label)) {
            (Some(from), _, Some(to)) if from != to => Self::Between(from, to),
            (Some(from), Some(label), None) => Self::Unknown(from, label),
            _ => Self::None,
        }
    }

    /// Factor by which every length is multiplied.
    pub fn factor(self) -> f64 {
        match self {
            Self::Between(from, to) => from.ratio(to),
            Self::None | Self::Unknown(..) => 1.0,
        }
    }

    /// Note for users of the drawing; `unscaled` is the setting that takes the numbers as they are.
    pub fn note(self, unscaled: &str) -> Option<String> {
        match self {
            Self::None => None,
            Self::Between(from, to) => Some(format!(
                "the drawing is in {:?}, the model in {:?}: lengths are multiplied by {:?}; {unscaled} takes the numbers as they are",
                from.label(),
                to.label(),
                self.factor()
            )),
            Self::Unknown(from, label) => Some(format!(
                "the drawing is in {:?}, the model in {}, which is no known unit: nothing is converted",
                from.label(),
                shown::start(label)
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{UNITS, Unit};

    #[test]
    fn every_unit_is_found_by_its_names_and_its_number() {
        for (k, entry) in UNITS.iter().enumerate() {
            assert!(entry.3.iter().all(|n| Unit::of_label(n) == Some(entry.0)));
            assert_eq!(
                UNITS[k + 1..].iter().find(|e| e.0 == entry.0).map(|e| e.1),
                None
            );
            let number = entry.0.dxf();
            assert_eq!(Unit::of_dxf(number), (number != 0).then_some(entry.0));
        }
        assert_eq!([0, -1, 25].map(Unit::of_dxf), [None; 3]);
        assert_eq!(Unit::of_label("furlong"), None);
    }

    /// Definitions, as they are written in the standards.
    #[test]
    fn ratios_are_those_of_the_definitions() {
        for (from, to, ratio) in [
            (Unit::Inch, Unit::Millimetre, 25.4),
            (Unit::Foot, Unit::Inch, 12.0),
            (Unit::Mile, Unit::Foot, 5280.0),
            (Unit::Inch, Unit::Micrometre, 25400.0),
            (Unit::Mil, Unit::Inch, 1e-3),
            (Unit::Microinch, Unit::Inch, 1e-6),
            (Unit::Yard, Unit::Metre, 0.9144),
            (Unit::Nanometre, Unit::Metre, 1e-9),
            (Unit::Inch, Unit::Pixel, 96.0),
            (Unit::Metre, Unit::SurveyFoot, 3937.0 / 1200.0),
            (Unit::SurveyMile, Unit::SurveyInch, 63360.0),
            (Unit::Gigametre, Unit::Kilometre, 1e6),
        ] {
            assert_eq!(from.ratio(to), ratio, "{from:?} {to:?}");
        }
        let parsec = Unit::Parsec.ratio(Unit::LightYear);
        assert!((parsec / 3.261_563_777_167_43 - 1.0).abs() < 1e-13);
    }
}
