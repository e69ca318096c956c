//! What of a triangle lies within an image: the rest of it is beside or behind the scanner.

/// Most corners of a triangle without what lies beyond four sides.
const MAX_CORNERS: usize = 8;
/// Sides are drawn this much wider, in the image plane at unit distance: rounding.
const SLACK: f64 = 1e-6;

/// A rectangle of the image, and how deep behind it the part of a triangle lies that is seen through it.
#[derive(Debug, Clone, Copy)]
pub struct Window {
    /// In the image plane at unit distance.
    pub min: [f64; 2],
    pub max: [f64; 2],
    /// Along the image's axis, metres: no place of the part is nearer to the scanner.
    pub depth: f64,
}

/// Corners of a convex polygon: to the right, up and along the axis, metres from the scanner.
struct Polygon {
    corners: [[f64; 3]; MAX_CORNERS],
    len: usize,
}

impl Window {
    /// On a triangle (to the right, up and along the axis, metres), through an image that ends at `min` and `max`; `None`
    /// where nothing of it is seen (Sutherland & Hodgman 1974, in homogeneous coordinates).
    pub fn on(triangle: &[[f64; 3]; 3], (min, max): ([f64; 2], [f64; 2])) -> Option<Self> {
        let mut polygon = Polygon { corners: [[0.0; 3]; MAX_CORNERS], len: 3 };
        polygon.corners[..3].copy_from_slice(triangle);
        for k in 0..2 {
            polygon = polygon.without(|c| c[k] - (min[k] - SLACK) * c[2]).without(|c| (max[k] + SLACK) * c[2] - c[k]);
        }
        let corners = polygon.corners[..polygon.len].iter();
        let depth = corners.clone().map(|c| c[2]).fold(f64::INFINITY, f64::min);
        let mut window = Self { min: max, max: min, depth: depth.max(0.0) };
        for c in corners {
            for k in 0..2 {
                // At the scanner itself a corner is everywhere.
                let (low, high) = if c[2] > 0.0 { (c[k] / c[2], c[k] / c[2]) } else { (min[k], max[k]) };
                window.min[k] = window.min[k].min(low - SLACK);
                window.max[k] = window.max[k].max(high + SLACK);
            }
        }
        (polygon.len > 0).then_some(window)
    }
}

impl Polygon {
    /// What of it lies where `height` is not negative.
    fn without(&self, height: impl Fn(&[f64; 3]) -> f64) -> Self {
        let mut out = Self { corners: [[0.0; 3]; MAX_CORNERS], len: 0 };
        let mut push = |corner: [f64; 3]| {
            if let Some(place) = out.corners.get_mut(out.len) {
                *place = corner;
                out.len += 1;
            }
        };
        for i in 0..self.len {
            let (a, b) = (&self.corners[i], &self.corners[(i + 1) % self.len]);
            let (above, next) = (height(a), height(b));
            if above >= 0.0 {
                push(*a);
            }
            if (above >= 0.0) != (next >= 0.0) {
                let t = above / (above - next);
                push(std::array::from_fn(|k| a[k] + (b[k] - a[k]) * t));
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Of places spread over a triangle, whatever is seen in the image is seen through the window, and lies behind its
        /// depth.
        #[test]
        fn nothing_that_is_seen_is_lost(
            triangle in prop::array::uniform3(prop::array::uniform3(-4.0..4.0f64)),
            low in prop::array::uniform2(-0.8..0.0f64), size in prop::array::uniform2(0.0..0.8f64))
        {
            let high = [low[0] + size[0], low[1] + size[1]];
            let window = Window::on(&triangle, (low, high));
            for i in 0..=40 {
                for j in 0..=40 - i {
                    let (u, v) = (f64::from(i) / 40.0, f64::from(j) / 40.0);
                    let place: [f64; 3] =
                        std::array::from_fn(|k| triangle[0][k] * (1.0 - u - v) + triangle[1][k] * u + triangle[2][k] * v);
                    let image = [place[0] / place[2], place[1] / place[2]];
                    if place[2] > 1e-6 && (0..2).all(|k| (low[k]..=high[k]).contains(&image[k])) {
                        let window = window.expect("something is seen");
                        prop_assert!((0..2).all(|k| (window.min[k]..=window.max[k]).contains(&image[k])));
                        prop_assert!(place[2] >= window.depth - 1e-9);
                    }
                }
            }
        }
    }
}
