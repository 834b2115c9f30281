//! Tolerance classes of ISO 286-1, such as H7 and g6: how far a size may be from its nominal.
//!
//! Numbers are micrometres, those of tables 1 to 5 of ISO 286-1:2010 for sizes to 500 mm. A class is a fundamental deviation, the letters,
//! which is that of the two limits nearer to the nominal, and a grade IT, the number, which is how far apart the limits are. Capital
//! letters are of holes.

/// Up to which size each range goes, that included (mm).
const MAIN: [f64; 13] = [
    3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0,
];
/// As above, for deviations that change more often.
const FINE: [f64; 25] = [
    3.0, 6.0, 10.0, 14.0, 18.0, 24.0, 30.0, 40.0, 50.0, 65.0, 80.0, 100.0, 120.0, 140.0, 160.0,
    180.0, 200.0, 225.0, 250.0, 280.0, 315.0, 355.0, 400.0, 450.0, 500.0,
];

/// Sizes that differ by this share are one.
const ROUNDING: f64 = 1e-12;
/// A column of a table without a value at some sizes.
const NONE: f64 = f64::NAN;

/// Standard tolerances of the grades 01, 0 and 1 to 18 (table 1), by [`MAIN`] sizes.
#[rustfmt::skip]
const GRADES: [[f64; 13]; 20] = [
    [0.3, 0.4, 0.4, 0.5, 0.6, 0.6, 0.8, 1.0, 1.2, 2.0, 2.5, 3.0, 4.0],
    [0.5, 0.6, 0.6, 0.8, 1.0, 1.0, 1.2, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0],
    [0.8, 1.0, 1.0, 1.2, 1.5, 1.5, 2.0, 2.5, 3.5, 4.5, 6.0, 7.0, 8.0],
    [1.2, 1.5, 1.5, 2.0, 2.5, 2.5, 3.0, 4.0, 5.0, 7.0, 8.0, 9.0, 10.0],
    [2.0, 2.5, 2.5, 3.0, 4.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 13.0, 15.0],
    [3.0, 4.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0],
    [4.0, 5.0, 6.0, 8.0, 9.0, 11.0, 13.0, 15.0, 18.0, 20.0, 23.0, 25.0, 27.0],
    [6.0, 8.0, 9.0, 11.0, 13.0, 16.0, 19.0, 22.0, 25.0, 29.0, 32.0, 36.0, 40.0],
    [10.0, 12.0, 15.0, 18.0, 21.0, 25.0, 30.0, 35.0, 40.0, 46.0, 52.0, 57.0, 63.0],
    [14.0, 18.0, 22.0, 27.0, 33.0, 39.0, 46.0, 54.0, 63.0, 72.0, 81.0, 89.0, 97.0],
    [25.0, 30.0, 36.0, 43.0, 52.0, 62.0, 74.0, 87.0, 100.0, 115.0, 130.0, 140.0, 155.0],
    [40.0, 48.0, 58.0, 70.0, 84.0, 100.0, 120.0, 140.0, 160.0, 185.0, 210.0, 230.0, 250.0],
    [60.0, 75.0, 90.0, 110.0, 130.0, 160.0, 190.0, 220.0, 250.0, 290.0, 320.0, 360.0, 400.0],
    [100.0, 120.0, 150.0, 180.0, 210.0, 250.0, 300.0, 350.0, 400.0, 460.0, 520.0, 570.0, 630.0],
    [140.0, 180.0, 220.0, 270.0, 330.0, 390.0, 460.0, 540.0, 630.0, 720.0, 810.0, 890.0, 970.0],
    [250.0, 300.0, 360.0, 430.0, 520.0, 620.0, 740.0, 870.0, 1000.0, 1150.0, 1300.0, 1400.0, 1550.0],
    [400.0, 480.0, 580.0, 700.0, 840.0, 1000.0, 1200.0, 1400.0, 1600.0, 1850.0, 2100.0, 2300.0, 2500.0],
    [600.0, 750.0, 900.0, 1100.0, 1300.0, 1600.0, 1900.0, 2200.0, 2500.0, 2900.0, 3200.0, 3600.0, 4000.0],
    [1000.0, 1200.0, 1500.0, 1800.0, 2100.0, 2500.0, 3000.0, 3500.0, 4000.0, 4600.0, 5200.0, 5700.0, 6300.0],
    [1400.0, 1800.0, 2200.0, 2700.0, 3300.0, 3900.0, 4600.0, 5400.0, 6300.0, 7200.0, 8100.0, 8900.0, 9700.0],
];

/// Fundamental deviations of shafts below the nominal (table 4), without their sign, by [`FINE`] sizes. Those of holes, above it, are the
/// same.
#[rustfmt::skip]
const CLEAR: [(&str, [f64; 25]); 11] = [
    ("a", [270.0, 270.0, 280.0, 290.0, 290.0, 300.0, 300.0, 310.0, 320.0, 340.0, 360.0, 380.0, 410.0, 460.0, 520.0, 580.0, 660.0, 740.0, 820.0, 920.0, 1050.0, 1200.0, 1350.0, 1500.0, 1650.0]),
    ("b", [140.0, 140.0, 150.0, 150.0, 150.0, 160.0, 160.0, 170.0, 180.0, 190.0, 200.0, 220.0, 240.0, 260.0, 280.0, 310.0, 340.0, 380.0, 420.0, 480.0, 540.0, 600.0, 680.0, 760.0, 840.0]),
    ("c", [60.0, 70.0, 80.0, 95.0, 95.0, 110.0, 110.0, 120.0, 130.0, 140.0, 150.0, 170.0, 180.0, 200.0, 210.0, 230.0, 240.0, 260.0, 280.0, 300.0, 330.0, 360.0, 400.0, 440.0, 480.0]),
    ("cd", [34.0, 46.0, 56.0, 70.0, 70.0, 85.0, 85.0, 100.0, 100.0, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE]),
    ("d", [20.0, 30.0, 40.0, 50.0, 50.0, 65.0, 65.0, 80.0, 80.0, 100.0, 100.0, 120.0, 120.0, 145.0, 145.0, 145.0, 170.0, 170.0, 170.0, 190.0, 190.0, 210.0, 210.0, 230.0, 230.0]),
    ("e", [14.0, 20.0, 25.0, 32.0, 32.0, 40.0, 40.0, 50.0, 50.0, 60.0, 60.0, 72.0, 72.0, 85.0, 85.0, 85.0, 100.0, 100.0, 100.0, 110.0, 110.0, 125.0, 125.0, 135.0, 135.0]),
    ("ef", [10.0, 14.0, 18.0, 23.0, 23.0, 28.0, 28.0, 35.0, 35.0, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE]),
    ("f", [6.0, 10.0, 13.0, 16.0, 16.0, 20.0, 20.0, 25.0, 25.0, 30.0, 30.0, 36.0, 36.0, 43.0, 43.0, 43.0, 50.0, 50.0, 50.0, 56.0, 56.0, 62.0, 62.0, 68.0, 68.0]),
    ("fg", [4.0, 6.0, 8.0, 10.0, 10.0, 12.0, 12.0, 15.0, 15.0, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE]),
    ("g", [2.0, 4.0, 5.0, 6.0, 6.0, 7.0, 7.0, 9.0, 9.0, 10.0, 10.0, 12.0, 12.0, 14.0, 14.0, 14.0, 15.0, 15.0, 15.0, 17.0, 17.0, 18.0, 18.0, 20.0, 20.0]),
    ("h", [0.0; 25]),
];

/// Fundamental deviations of shafts above the nominal (table 5), by [`FINE`] sizes.
#[rustfmt::skip]
const TIGHT: [(&str, [f64; 25]); 14] = [
    ("m", [2.0, 4.0, 6.0, 7.0, 7.0, 8.0, 8.0, 9.0, 9.0, 11.0, 11.0, 13.0, 13.0, 15.0, 15.0, 15.0, 17.0, 17.0, 17.0, 20.0, 20.0, 21.0, 21.0, 23.0, 23.0]),
    ("n", [4.0, 8.0, 10.0, 12.0, 12.0, 15.0, 15.0, 17.0, 17.0, 20.0, 20.0, 23.0, 23.0, 27.0, 27.0, 27.0, 31.0, 31.0, 31.0, 34.0, 34.0, 37.0, 37.0, 40.0, 40.0]),
    ("p", [6.0, 12.0, 15.0, 18.0, 18.0, 22.0, 22.0, 26.0, 26.0, 32.0, 32.0, 37.0, 37.0, 43.0, 43.0, 43.0, 50.0, 50.0, 50.0, 56.0, 56.0, 62.0, 62.0, 68.0, 68.0]),
    ("r", [10.0, 15.0, 19.0, 23.0, 23.0, 28.0, 28.0, 34.0, 34.0, 41.0, 43.0, 51.0, 54.0, 63.0, 65.0, 68.0, 77.0, 80.0, 84.0, 94.0, 98.0, 108.0, 114.0, 126.0, 132.0]),
    ("s", [14.0, 19.0, 23.0, 28.0, 28.0, 35.0, 35.0, 43.0, 43.0, 53.0, 59.0, 71.0, 79.0, 92.0, 100.0, 108.0, 122.0, 130.0, 140.0, 158.0, 170.0, 190.0, 208.0, 232.0, 252.0]),
    ("t", [NONE, NONE, NONE, NONE, NONE, NONE, 41.0, 48.0, 54.0, 66.0, 75.0, 91.0, 104.0, 122.0, 134.0, 146.0, 166.0, 180.0, 196.0, 218.0, 240.0, 268.0, 294.0, 330.0, 360.0]),
    ("u", [18.0, 23.0, 28.0, 33.0, 33.0, 41.0, 48.0, 60.0, 70.0, 87.0, 102.0, 124.0, 144.0, 170.0, 190.0, 210.0, 236.0, 258.0, 284.0, 315.0, 350.0, 390.0, 435.0, 490.0, 540.0]),
    ("v", [NONE, NONE, NONE, NONE, 39.0, 47.0, 55.0, 68.0, 81.0, 102.0, 120.0, 146.0, 172.0, 202.0, 228.0, 252.0, 284.0, 310.0, 340.0, 385.0, 425.0, 475.0, 530.0, 595.0, 660.0]),
    ("x", [20.0, 28.0, 34.0, 40.0, 45.0, 54.0, 64.0, 80.0, 97.0, 122.0, 146.0, 178.0, 210.0, 248.0, 280.0, 310.0, 350.0, 385.0, 425.0, 475.0, 525.0, 590.0, 660.0, 740.0, 820.0]),
    ("y", [NONE, NONE, NONE, NONE, NONE, 63.0, 75.0, 94.0, 114.0, 144.0, 174.0, 214.0, 254.0, 300.0, 340.0, 380.0, 425.0, 470.0, 520.0, 580.0, 650.0, 730.0, 820.0, 920.0, 1000.0]),
    ("z", [26.0, 35.0, 42.0, 50.0, 60.0, 73.0, 88.0, 112.0, 136.0, 172.0, 210.0, 258.0, 310.0, 365.0, 415.0, 465.0, 520.0, 575.0, 640.0, 710.0, 790.0, 900.0, 1000.0, 1100.0, 1250.0]),
    ("za", [32.0, 42.0, 52.0, 64.0, 77.0, 98.0, 118.0, 148.0, 180.0, 226.0, 274.0, 335.0, 400.0, 470.0, 535.0, 600.0, 670.0, 740.0, 820.0, 920.0, 1000.0, 1150.0, 1300.0, 1450.0, 1600.0]),
    ("zb", [40.0, 50.0, 67.0, 90.0, 108.0, 136.0, 160.0, 200.0, 242.0, 300.0, 360.0, 445.0, 525.0, 620.0, 700.0, 780.0, 880.0, 960.0, 1050.0, 1200.0, 1300.0, 1500.0, 1650.0, 1850.0, 2100.0]),
    ("zc", [60.0, 80.0, 97.0, 130.0, 150.0, 188.0, 218.0, 274.0, 325.0, 405.0, 480.0, 585.0, 690.0, 800.0, 900.0, 1000.0, 1150.0, 1250.0, 1350.0, 1550.0, 1700.0, 1900.0, 2100.0, 2400.0, 2600.0]),
];

/// Lower deviations of the shafts j5 and j6, and j7, without their sign; upper deviations of the holes J6, J7 and J8 (tables 2 and 4).
#[rustfmt::skip]
const J_SHAFT: [[f64; 13]; 2] = [
    [2.0, 2.0, 2.0, 3.0, 4.0, 5.0, 7.0, 9.0, 11.0, 13.0, 16.0, 18.0, 20.0],
    [4.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 15.0, 18.0, 21.0, 26.0, 28.0, 32.0],
];
#[rustfmt::skip]
const J_HOLE: [[f64; 13]; 3] = [
    [2.0, 5.0, 5.0, 6.0, 8.0, 10.0, 13.0, 16.0, 18.0, 22.0, 25.0, 29.0, 33.0],
    [4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 18.0, 22.0, 26.0, 30.0, 36.0, 39.0, 43.0],
    [6.0, 10.0, 12.0, 15.0, 20.0, 24.0, 28.0, 34.0, 41.0, 47.0, 55.0, 60.0, 66.0],
];
/// Lower deviations of the shafts k4 to k7 (table 5); other grades have 0.
const K: [f64; 13] = [
    0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0, 5.0,
];

/// A tolerance class, such as H7.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fit {
    /// The letters in lower case.
    letters: String,
    is_hole: bool,
    /// −1 for 01.
    grade: i8,
}

/// The standard tolerance of a grade.
fn standard(grade: i8, main: usize) -> f64 {
    GRADES[(grade + 1) as usize][main]
}

impl Fit {
    /// A class as it is written on a drawing; `None` of other texts.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        let digits = text.find(|c: char| c.is_ascii_digit())?;
        let (letters, number) = text.split_at(digits);
        let is_hole = letters.chars().all(|c| c.is_ascii_uppercase());
        let is_shaft = letters.chars().all(|c| c.is_ascii_lowercase());
        let lower = letters.to_ascii_lowercase();
        let known = (CLEAR.iter().chain(&TIGHT).map(|row| row.0)).chain(["j", "js", "k"]);
        let grade = match number {
            "01" => -1,
            "0" => 0,
            _ if number.starts_with('0') => return None,
            _ => number.parse().ok().filter(|grade| *grade <= 18)?,
        };
        let is_class = (is_hole || is_shaft) && known.into_iter().any(|name| name == lower);
        is_class.then_some(Self {
            letters: lower,
            is_hole,
            grade,
        })
    }

    /// The lower and the upper deviation from a nominal size (mm, both); `None` where the standard's tables have none.
    pub(super) fn deviations(&self, nominal: f64) -> Option<[f64; 2]> {
        if nominal.is_nan() || nominal <= 0.0 {
            return None;
        }
        // A size that is computed misses the end of a range by rounding.
        let is_in = |to: &f64| nominal <= to * (1.0 + ROUNDING);
        let main = MAIN.iter().position(is_in)?;
        let fine = FINE.iter().position(is_in)?;
        // Sizes to 1 mm have no coarse grades, and no very loose fits.
        let is_tiny = nominal <= 1.0;
        if is_tiny && (self.grade >= 14 || ["a", "b"].contains(&&*self.letters)) {
            return None;
        }
        let width = standard(self.grade, main);
        let row = |table: &[(&str, [f64; 25])]| {
            let row = table.iter().find(|row| row.0 == self.letters);
            row.map(|row| row.1[fine])
        };
        let [lower, upper] = if self.letters == "js" {
            [-0.5 * width, 0.5 * width]
        } else if let Some(off) = row(&CLEAR) {
            match self.is_hole {
                true => [off, off + width],
                false => [-off - width, -off],
            }
        } else if self.is_hole {
            let upper = self.upper_of_hole(main, row(&TIGHT), is_tiny)?;
            [upper - width, upper]
        } else {
            let lower = self.lower_of_shaft(main, row(&TIGHT))?;
            [lower, lower + width]
        };
        let found = [lower, upper].map(|micrometres| micrometres / 1e3);
        found.iter().all(|x| x.is_finite()).then_some(found)
    }

    /// The lower deviation of a shaft j to zc.
    fn lower_of_shaft(&self, main: usize, tight: Option<f64>) -> Option<f64> {
        match (&*self.letters, self.grade) {
            ("j", 5 | 6) => Some(-J_SHAFT[0][main]),
            ("j", 7) => Some(-J_SHAFT[1][main]),
            ("j", 8) if main == 0 => Some(-6.0),
            ("j", _) => None,
            ("k", 4..=7) => Some(K[main]),
            ("k", _) => Some(0.0),
            _ => tight,
        }
    }

    /// The upper deviation of a hole J to ZC: that of the shaft of these letters, but so that a hole of a grade with a shaft of the next finer
    /// one fits as tightly as the shaft's hole H would: Δ, which table 3 has beside.
    fn upper_of_hole(&self, main: usize, tight: Option<f64>, is_tiny: bool) -> Option<f64> {
        let delta = match (main, self.grade) {
            (0, _) => 0.0,
            (_, 3..=8) => standard(self.grade, main) - standard(self.grade - 1, main),
            _ => NONE,
        };
        match (&*self.letters, self.grade) {
            ("j", 6..=8) => Some(J_HOLE[(self.grade - 6) as usize][main]),
            ("j", _) => None,
            ("k", ..=8) => Some(-K[main] + delta),
            ("k", _) => (main == 0).then_some(0.0),
            // The one exception: M6 over 250 to 315.
            ("m", 6) if main == 10 => Some(-9.0),
            ("m" | "n", ..=8) => Some(-tight? + delta),
            ("n", _) if main > 0 => Some(0.0),
            ("n", _) => Some(-tight?).filter(|_| !is_tiny),
            (_, ..=7) => Some(-tight? + delta),
            _ => Some(-tight?),
        }
    }
}
