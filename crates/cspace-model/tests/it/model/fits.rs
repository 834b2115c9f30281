//! Tolerance classes, and deviations of either sign.

use cspace_model::Host;
use cspace_model::model::{Parameter, Template};

/// A model with one parameter, or the message that it is refused with.
fn parameter(unit: &str, table: &str) -> Result<Parameter, String> {
    let text = format!(
        "{unit}\n[parameter]\np = {{ {table} }}\n[[part]]\nname = \"a\"\nloops = [{{ circle = 1, at = [0, 0] }}]\n"
    );
    let model = Template::from_text(text, "m.toml").and_then(|t| t.model(&Host::default()));
    match model {
        Ok(model) => Ok(model.parameters[0].clone()),
        Err(error) => Err(error.to_string()),
    }
}

/// Limits as the tables of ISO 286-2 have them, in micrometres.
#[test]
fn classes_have_the_limits_of_the_tables() {
    for (nominal, class, lower, upper) in [
        (20.0, "H7", 0.0, 21.0),
        (20.0, "g6", -20.0, -7.0),
        (3.0, "h6", -6.0, 0.0),
        (3.001, "h6", -8.0, 0.0),
        (25.0, "f7", -41.0, -20.0),
        (50.0, "k6", 2.0, 18.0),
        (50.0, "K7", -18.0, 7.0),
        (50.0, "k8", 0.0, 39.0),
        (30.0, "M7", -21.0, 0.0),
        (30.0, "N7", -28.0, -7.0),
        (30.0, "N9", -52.0, 0.0),
        (30.0, "P7", -35.0, -14.0),
        (30.0, "P8", -55.0, -22.0),
        (300.0, "M6", -41.0, -9.0),
        (2.0, "P7", -16.0, -6.0),
        (2.0, "N9", -29.0, -4.0),
        (2.0, "K7", -10.0, 0.0),
        (100.0, "H11", 0.0, 220.0),
        (100.0, "c11", -390.0, -170.0),
        (40.0, "s6", 43.0, 59.0),
        (60.0, "S7", -72.0, -42.0),
        (18.0, "js5", -4.0, 4.0),
        (18.0, "JS9", -21.5, 21.5),
        (10.0, "j6", -2.0, 7.0),
        (10.0, "J7", -7.0, 8.0),
        (8.0, "cd8", -78.0, -56.0),
        (500.0, "zc10", 2600.0, 2850.0),
        (1.0, "a11", f64::NAN, f64::NAN),
        (20.0, "t6", f64::NAN, f64::NAN),
        (501.0, "H7", f64::NAN, f64::NAN),
        (-1.0, "H7", f64::NAN, f64::NAN),
        (10.0, "j9", f64::NAN, f64::NAN),
        (10.0, "K9", f64::NAN, f64::NAN),
        (20.0, "H0", 0.0, 1.0),
        (20.0, "h01", -0.6, 0.0),
        (3.000_000_000_000_000_4, "H7", 0.0, 10.0),
    ] {
        let found = parameter(
            "unit = \"mm\"",
            &format!("value = {nominal:?}, tol = \"{class}\""),
        );
        match found {
            Err(_) => assert!(lower.is_nan(), "{nominal} {class}"),
            Ok(found) => {
                let (below, above) = found.deviations.unwrap();
                let [lo, hi] = [-below, above].map(|x| (x * 1e4).round() / 10.0);
                assert_eq!((lo, hi), (lower, upper), "{nominal} {class}");
            }
        }
    }
    for other in ["7H", "H", "h19", "hH7", "i6", "", "H07", "H00", "H001"] {
        let refused = parameter("unit = \"mm\"", &format!("value = 20, tol = \"{other}\""));
        assert!(refused.is_err(), "{other}");
    }
}

#[test]
fn classes_are_in_the_units_of_the_model() {
    let inch = parameter("unit = \"in\"", "value = 1, tol = \"H7\"").unwrap();
    // 25.4 mm.
    assert_eq!(inch.deviations, Some((0.0, 0.021 / 25.4)));
    let none = parameter("", "value = 20, tol = \"H7\"").unwrap_err();
    assert!(none.contains("unit"), "{none}");
    let unknown = parameter("unit = \"furlong\"", "value = 20, tol = \"H7\"").unwrap_err();
    assert!(unknown.contains("unit"), "{unknown}");
}

#[test]
fn deviations_have_either_sign() {
    let below = parameter("", "value = 20, plus = -0.007, minus = 0.020").unwrap();
    assert_eq!(below.deviations, Some((0.020, -0.007)));
    let above = parameter("", "value = 20, plus = 0.059, minus = -0.043").unwrap();
    assert_eq!(above.deviations, Some((-0.043, 0.059)));
    let crossed = parameter("", "value = 20, plus = -0.007, minus = -0.020").unwrap_err();
    assert!(crossed.contains("nothing between"), "{crossed}");
    for alone in ["plus = -0.01", "minus = -0.01"] {
        let crossed = parameter("", &format!("value = 20, {alone}")).unwrap_err();
        assert!(crossed.contains("nothing between"), "{crossed}");
    }
    let angle = parameter("unit = \"MM\"", "value = \"30deg\", tol = \"H7\"").unwrap_err();
    assert!(angle.contains("angle"), "{angle}");
    let both = parameter("unit = \"mm\"", "value = 20, tol = \"g6\", plus = 0.1").unwrap_err();
    assert!(both.contains("beside"), "{both}");
}
