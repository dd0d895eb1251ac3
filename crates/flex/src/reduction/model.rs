//! A reduced model as plain data, its modes and its file.

use super::npz::{Array, read_npz, write_npz};
use crate::FlexError;
use crate::eigen::symmetric_eigen;
use serde::{Deserialize, Serialize};

/// Matrices of a crankshaft in the coordinates of reference points and fixed-interface modes, row by row.
///
/// Coordinates: of each reference point displacements along x, y, z [m] and rotations about them [rad]; then those of the modes, of modal mass
/// 1 kg. In a frame that turns about z with `W`:
///
/// ```text
/// m q'' + 2 W g q' + (k - W^2 n + W' g) q = W^2 f_c - W' f_e + f
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ReducedModel {
    /// Name and place [m] of each reference point.
    pub points: Vec<(String, [f64; 3])>,
    /// Natural frequencies with all reference points fixed [Hz].
    pub frequencies: Vec<f64>,
    /// Stiffness `k`.
    pub stiffness: Vec<f64>,
    /// Mass `m`.
    pub mass: Vec<f64>,
    /// `g = B^T M S B`, skew, `S u = e_z x u`.
    pub gyroscopic: Vec<f64>,
    /// `n = B^T S^T M S B`.
    pub centrifugal: Vec<f64>,
    /// `f_c = B^T M (x, y, 0)`: load of a unit of speed squared.
    pub centrifugal_load: Vec<f64>,
    /// `f_e = B^T M (-y, x, 0)`: load of a unit of angular acceleration, with its sign changed.
    pub euler_load: Vec<f64>,
}

/// A natural mode of a reduced model.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ReducedMode {
    /// Natural frequency [Hz]; of a rigid motion zero but for rounding.
    pub frequency: f64,
    /// Values of the coordinates, of modal mass 1 kg.
    pub coordinates: Vec<f64>,
}

/// Length of the names in a file.
const NAME: usize = 32;

impl ReducedModel {
    /// Number of coordinates.
    pub fn size(&self) -> usize {
        6 * self.points.len() + self.frequencies.len()
    }

    /// The stiffness with springs to the ground on coordinates: index and stiffness of each.
    pub fn with_springs(&self, springs: &[(usize, f64)]) -> ReducedModel {
        let (mut model, size) = (self.clone(), self.size());
        for (coordinate, stiffness) in springs.iter().filter(|(coordinate, _)| *coordinate < size) {
            model.stiffness[coordinate * (size + 1)] += stiffness;
        }
        model
    }

    /// The same model with the lowest `modes` of its fixed-interface modes.
    pub fn truncated(&self, modes: usize) -> ReducedModel {
        let (size, kept) = (self.size(), (6 * self.points.len() + modes).min(self.size()));
        let square = |matrix: &[f64]| -> Vec<f64> {
            matrix.chunks(size).take(kept).flat_map(|row| row[..kept].to_vec()).collect()
        };
        ReducedModel {
            points: self.points.clone(),
            frequencies: self.frequencies.iter().copied().take(modes).collect(),
            stiffness: square(&self.stiffness),
            mass: square(&self.mass),
            gyroscopic: square(&self.gyroscopic),
            centrifugal: square(&self.centrifugal),
            centrifugal_load: self.centrifugal_load.iter().copied().take(kept).collect(),
            euler_load: self.euler_load.iter().copied().take(kept).collect(),
        }
    }

    /// Natural modes at rest, the lowest first.
    pub fn modes(&self) -> Vec<ReducedMode> {
        let size = self.size();
        // m = V D V^T; the modes of D^-1/2 V^T k V D^-1/2. A row of `vectors` is an eigenvector.
        let (values, vectors) = symmetric_eigen(&self.mass, size);
        let scaled: Vec<f64> = values
            .iter()
            .zip(vectors.chunks(size))
            .flat_map(|(value, row)| row.iter().map(move |v| v / value.max(f64::MIN_POSITIVE).sqrt()))
            .collect();
        let mut product = vec![0.0; size * size];
        for (row, to) in scaled.chunks(size).zip(product.chunks_mut(size)) {
            for (v, k) in row.iter().zip(self.stiffness.chunks(size)) {
                for (to, k) in to.iter_mut().zip(k) {
                    *to += v * k;
                }
            }
        }
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut operator = vec![0.0; size * size];
        for (i, row) in product.chunks(size).enumerate() {
            for (j, column) in scaled.chunks(size).enumerate().take(i + 1) {
                let value = dot(row, column);
                (operator[i * size + j], operator[j * size + i]) = (value, value);
            }
        }
        let (squares, shapes) = symmetric_eigen(&operator, size);
        let mode = |(square, shape): (&f64, &[f64])| {
            let mut coordinates = vec![0.0; size];
            for (share, row) in shape.iter().zip(scaled.chunks(size)) {
                for (q, v) in coordinates.iter_mut().zip(row) {
                    *q += share * v;
                }
            }
            ReducedMode { frequency: square.max(0.0).sqrt() / std::f64::consts::TAU, coordinates }
        };
        squares.iter().zip(shapes.chunks(size)).map(mode).collect()
    }

    /// As the bytes of a `.npz` file, which NumPy reads: `stiffness`, `mass`, `gyroscopic`, `centrifugal` (square), `centrifugal_load`,
    /// `euler_load`, `frequencies`, `points`, `names`.
    pub fn to_npz(&self) -> Vec<u8> {
        let size = self.size();
        let square = |values: &[f64]| Array::Numbers { shape: vec![size, size], values: values.to_vec() };
        let line = |values: &[f64]| Array::Numbers { shape: vec![values.len()], values: values.to_vec() };
        let points = self.points.iter().flat_map(|(_, at)| *at).collect();
        let names = self.points.iter().map(|(name, _)| name.clone()).collect();
        write_npz(&[
            ("stiffness", square(&self.stiffness)),
            ("mass", square(&self.mass)),
            ("gyroscopic", square(&self.gyroscopic)),
            ("centrifugal", square(&self.centrifugal)),
            ("centrifugal_load", line(&self.centrifugal_load)),
            ("euler_load", line(&self.euler_load)),
            ("frequencies", line(&self.frequencies)),
            ("points", Array::Numbers { shape: vec![self.points.len(), 3], values: points }),
            ("names", Array::Words { length: NAME, values: names }),
        ])
    }

    /// From the bytes that [`ReducedModel::to_npz`] gives.
    ///
    /// # Errors
    /// [`FlexError::File`] where something is missing, damaged, or of another size.
    pub fn from_npz(bytes: &[u8]) -> Result<ReducedModel, FlexError> {
        let arrays = read_npz(bytes)?;
        let wrong = |message: String| FlexError::File { what: "reduced model", message };
        let find = |name: &str| {
            let found = arrays.iter().find(|(own, _)| own == name).map(|(_, array)| array);
            found.ok_or_else(|| wrong(format!("the array {name} is missing")))
        };
        let numbers = |name: &str, wanted: &[usize]| match find(name)? {
            Array::Numbers { shape, values } if wanted.is_empty() || shape == wanted => {
                if let Some(value) = values.iter().find(|value| !value.is_finite()) {
                    return Err(wrong(format!("the array {name} holds {value}")));
                }
                Ok(values.clone())
            }
            Array::Numbers { shape, .. } => {
                Err(wrong(format!("the array {name} has the shape {shape:?}, needed {wanted:?}")))
            }
            Array::Words { .. } => Err(wrong(format!("the array {name} holds words, needed numbers"))),
        };
        let Array::Words { values: names, .. } = find("names")? else {
            return Err(wrong("the array names holds numbers, needed words".to_owned()));
        };
        let points = numbers("points", &[names.len(), 3])?;
        let frequencies = numbers("frequencies", &[])?;
        let size = 6 * names.len() + frequencies.len();
        let points = names.iter().cloned().zip(points.chunks(3).map(|at| [at[0], at[1], at[2]]));
        Ok(ReducedModel {
            points: points.collect(),
            frequencies,
            stiffness: numbers("stiffness", &[size, size])?,
            mass: numbers("mass", &[size, size])?,
            gyroscopic: numbers("gyroscopic", &[size, size])?,
            centrifugal: numbers("centrifugal", &[size, size])?,
            centrifugal_load: numbers("centrifugal_load", &[size])?,
            euler_load: numbers("euler_load", &[size])?,
        })
    }
}
