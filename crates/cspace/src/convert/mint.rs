//! Points and vectors of `mint`.

use crate::geometry::{Point, Vector};

impl From<mint::Point2<f64>> for Point {
    fn from(p: mint::Point2<f64>) -> Self {
        Self::new(p.x, p.y)
    }
}

impl From<Point> for mint::Point2<f64> {
    fn from(p: Point) -> Self {
        Self { x: p.x, y: p.y }
    }
}

impl From<mint::Vector2<f64>> for Vector {
    fn from(v: mint::Vector2<f64>) -> Self {
        Self::new(v.x, v.y)
    }
}

impl From<Vector> for mint::Vector2<f64> {
    fn from(v: Vector) -> Self {
        Self { x: v.x, y: v.y }
    }
}

impl mint::IntoMint for Point {
    type MintType = mint::Point2<f64>;
}

impl mint::IntoMint for Vector {
    type MintType = mint::Vector2<f64>;
}
