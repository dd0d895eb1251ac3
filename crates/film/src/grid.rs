//! Cells of the unrolled film: rings of cells around, columns along the axis.

use crate::error::{FilmError, require, require_film};
use crate::plane::{self, Plane};
use std::f64::consts::{PI, TAU};

/// Cells of the unrolled film. Around: n columns between given angles; along: m equal cells over half the length (symmetric films) or all of it.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmGrid {
    /// Angles of the n + 1 faces around, rising, the last one turn after the first [rad].
    pub faces: Vec<f64>,
    /// Cells along the axis, m.
    pub axial: usize,
    /// Whether they cover half the length, from the middle to the end.
    pub half: bool,
}

impl FilmGrid {
    /// Equal cells, a face at `origin`.
    ///
    /// # Errors
    /// [`FilmError::Number`] below 8 cells around or 2 along.
    pub fn uniform(around: usize, axial: usize, half: bool, origin: f64) -> Result<FilmGrid, FilmError> {
        check(around, axial)?;
        let faces = (0..=around).map(|i| origin + TAU * i as f64 / around as f64).collect();
        Ok(FilmGrid { faces, axial, half })
    }

    /// Cells half as dense as equal ones everywhere and for the other half equal in Sommerfeld's angle, so that the narrow pressure at high
    /// eccentricity is resolved; symmetric about the direction of least film.
    ///
    /// # Errors
    /// [`FilmError::Number`] below 8 cells around or 2 along, [`FilmError::Eccentricity`] at 1 and above.
    pub fn graded(
        around: usize,
        axial: usize,
        half: bool,
        eccentricity_ratio: Plane,
    ) -> Result<FilmGrid, FilmError> {
        check(around, axial)?;
        let (along, ratio) = plane::direction(eccentricity_ratio);
        require_film(ratio)?;
        let origin = along[1].atan2(along[0]);
        let stretch = ((1.0 + ratio) / (1.0 - ratio)).sqrt();
        // g = 2 atan(stretch tan(a/2)) is Sommerfeld's angle; wanted is a with (a + g)/2 = u, u equal steps in [0, pi]. With t = tan(a/2):
        // tan u = (1 + stretch) t/(1 - stretch t^2), a quadratic.
        let place = |u: f64| {
            let (sin, cos) = u.sin_cos();
            let linear = (1.0 + stretch) * cos;
            let root = (linear * linear + 4.0 * stretch * sin * sin).sqrt();
            2.0 * if cos >= 0.0 {
                (2.0 * sin).atan2(root + linear)
            } else {
                (root - linear).atan2(2.0 * stretch * sin)
            }
        };
        let mut faces = vec![origin; around + 1];
        for i in 0..around.div_ceil(2) {
            let a = place(PI * (1.0 - 2.0 * i as f64 / around as f64));
            (faces[i], faces[around - i]) = (origin - a, origin + a);
        }
        faces[0] = origin - PI;
        faces[around] = origin + PI;
        Ok(FilmGrid { faces, axial, half })
    }

    /// Columns around, n.
    pub fn around(&self) -> usize {
        self.faces.len() - 1
    }

    /// Middle of column `i` [rad].
    pub fn angle(&self, i: usize) -> f64 {
        0.5 * (self.faces[i] + self.faces[i + 1])
    }

    /// Place of cell `j` along the axis, -1 to 1 times half the length.
    pub fn place(&self, j: usize) -> f64 {
        let step = (j as f64 + 0.5) / self.axial as f64;
        if self.half { step } else { 2.0 * step - 1.0 }
    }

    /// Height of a cell along the axis, against half the length.
    pub(crate) fn height(&self) -> f64 {
        if self.half { 1.0 / self.axial as f64 } else { 2.0 / self.axial as f64 }
    }
}

fn check(around: usize, axial: usize) -> Result<(), FilmError> {
    require(around >= 8, "cells around the film", "8 or more", around as f64)?;
    require(axial >= 2, "cells along the film", "2 or more", axial as f64)
}
