//! Maps of erosion potential on a wall (Peters and el Moctar 2020, eqs 3.49, 3.62 and 3.64).
//!
//! linear:  c = sum_i p_i / sum over all elements            squared:  c = sum_i p_i^2 / sum over all elements
//!
//! p: impact pressures (Pa) of the Lagrangian model, or intensities c_jet of the Eulerian one. Shares depend on the size of the
//! elements; the densities, shares per area (1/m2), do not.

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A piece of a wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WallElement {
    /// Centre, m.
    pub centre: [f64; 3],
    /// Unit normal, into the liquid.
    pub normal: [f64; 3],
    /// Area, m2.
    pub area: f64,
}

/// Sums of impacts over the elements of a wall.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PotentialMap {
    elements: Vec<WallElement>,
    linear: Vec<f64>,
    squared: Vec<f64>,
    impacts: Vec<u64>,
}

/// A wall that cannot carry a map, or a place that is not on it.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SurfaceError {
    /// No elements.
    #[error("the wall has no elements, but a map needs at least one")]
    Empty,
    /// Not an element.
    #[error(
        "element {element} of the wall has area {area} m2 or a centre or normal that is not finite, but areas must be \
         positive and normals of length one"
    )]
    Element {
        /// Number of the element, from 0.
        element: usize,
        /// Its area, m2.
        area: f64,
    },
    /// No such element.
    #[error(
        "there is no element {element} on this wall, whose elements are numbered from 0 to {last}"
    )]
    Outside {
        /// Number asked for.
        element: usize,
        /// Last number.
        last: usize,
    },
    /// An amount that is not a positive number.
    #[error("the impact on element {element} is {amount}, but it must be finite and not negative")]
    Amount {
        /// Number of the element.
        element: usize,
        /// What was to be added.
        amount: f64,
    },
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl WallElement {
    fn valid(&self) -> bool {
        let finite = self.centre.iter().all(|x| x.is_finite());
        let unit = (dot(self.normal, self.normal) - 1.0).abs() < 1e-6;
        finite && unit && self.area > 0.0 && self.area.is_finite()
    }
}

impl PotentialMap {
    /// An empty map.
    ///
    /// # Errors
    /// If there are no elements or one has no area, no finite centre or no unit normal.
    pub fn new(elements: Vec<WallElement>) -> Result<Self, SurfaceError> {
        let n = elements.len();
        if n == 0 {
            return Err(SurfaceError::Empty);
        }
        if let Some(element) = elements.iter().position(|e| !e.valid()) {
            let area = elements[element].area;
            return Err(SurfaceError::Element { element, area });
        }
        Ok(Self {
            elements,
            linear: vec![0.0; n],
            squared: vec![0.0; n],
            impacts: vec![0; n],
        })
    }

    /// The element whose centre is nearest to a point; the first of several.
    #[must_use]
    pub fn nearest(&self, point: [f64; 3]) -> usize {
        let square = |e: &WallElement| {
            let d = [0, 1, 2].map(|k| e.centre[k] - point[k]);
            dot(d, d)
        };
        let mut best = (0, f64::INFINITY);
        for (k, element) in self.elements.iter().enumerate() {
            let d = square(element);
            if d < best.1 {
                best = (k, d);
            }
        }
        best.0
    }

    /// Adds an impact: an impact pressure in Pa, or an intensity.
    ///
    /// # Errors
    /// If there is no such element or the amount is negative or not finite.
    pub fn add(&mut self, element: usize, amount: f64) -> Result<(), SurfaceError> {
        if element >= self.elements.len() {
            let last = self.elements.len() - 1;
            return Err(SurfaceError::Outside { element, last });
        }
        if !(amount >= 0.0 && amount.is_finite()) {
            return Err(SurfaceError::Amount { element, amount });
        }
        self.linear[element] += amount;
        self.squared[element] += amount * amount;
        self.impacts[element] += 1;
        Ok(())
    }

    /// The elements.
    #[must_use]
    pub fn elements(&self) -> &[WallElement] {
        &self.elements
    }

    /// Number of impacts per element.
    #[must_use]
    pub fn impacts(&self) -> &[u64] {
        &self.impacts
    }

    /// Share of each element in the sum of all impacts (3.49, 3.62); `None` before the first impact.
    #[must_use]
    pub fn linear(&self) -> Option<Vec<f64>> {
        shares(&self.linear)
    }

    /// Share of each element in the sum of the squares of all impacts (3.64); `None` before the first impact.
    #[must_use]
    pub fn squared(&self) -> Option<Vec<f64>> {
        shares(&self.squared)
    }

    /// Shares per area, 1/m2.
    #[must_use]
    pub fn density(&self, shares: &[f64]) -> Vec<f64> {
        let areas = self.elements.iter().map(|e| e.area);
        shares.iter().zip(areas).map(|(c, a)| c / a).collect()
    }
}

fn shares(sums: &[f64]) -> Option<Vec<f64>> {
    let total: f64 = sums.iter().sum();
    (total > 0.0).then(|| sums.iter().map(|s| s / total).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(n: usize) -> Vec<WallElement> {
        let element = |k: usize| WallElement {
            centre: [k as f64, 0.0, 0.0],
            normal: [0.0, 0.0, 1.0],
            area: 2.0,
        };
        (0..n).map(element).collect()
    }

    #[test]
    fn shares_by_hand() {
        let mut map = PotentialMap::new(row(3)).unwrap();
        assert!(map.linear().is_none());
        let hit = map.nearest([0.6, 0.0, 5.0]);
        assert_eq!(hit, 1);
        map.add(hit, 3.0).unwrap();
        map.add(2, 0.5).unwrap();
        map.add(2, 0.5).unwrap();
        assert_eq!(map.linear().unwrap(), [0.0, 0.75, 0.25]);
        assert_eq!(map.squared().unwrap(), [0.0, 9.0 / 9.5, 0.5 / 9.5]);
        assert_eq!(map.impacts(), [0, 1, 2]);
        assert_eq!(map.density(&map.linear().unwrap())[1], 0.375);
    }

    #[test]
    fn bad_walls_and_impacts_are_refused() {
        assert!(PotentialMap::new(vec![]).is_err());
        let mut flat = row(2);
        flat[1].area = 0.0;
        let message = PotentialMap::new(flat).unwrap_err().to_string();
        assert!(message.contains("element 1"), "{message}");
        let mut map = PotentialMap::new(row(2)).unwrap();
        assert!(map.add(2, 1.0).is_err() && map.add(0, f64::NAN).is_err());
        assert_eq!(map.impacts(), [0, 0]);
    }
}
