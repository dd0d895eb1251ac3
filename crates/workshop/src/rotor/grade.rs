//! Permissible residual unbalance of a balance quality grade, and whether the rotor keeps it.

use crate::error::WorkshopError;
use crate::rotor::plane::{Plane, PlaneUnbalance, in_two_planes};
use lanchester_task::workshop::{Rotor, Sheet};
use num_complex::Complex64;
use serde::Serialize;

/// What a balance quality grade allows.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Grade {
    /// [`WORKSHOP_VERSION`](crate::WORKSHOP_VERSION).
    pub version: u32,
    /// Name of the sheet.
    pub name: String,
    /// Permissible speed of the centre of mass [m/s].
    pub grade: f64,
    /// Service speed [rad/s].
    pub speed: f64,
    /// Mass of the rotor [kg].
    pub mass: f64,
    /// Permissible residual specific unbalance, the eccentricity of the centre of mass [m].
    pub eccentricity: f64,
    /// Permissible residual unbalance of the whole rotor, U_per [kg m].
    pub permissible: f64,
    /// Resultant of the measured unbalances [kg m]; `None` where none are measured.
    #[schemars(with = "Option<[f64; 2]>")]
    pub resultant: Option<Complex64>,
    /// The share of each bearing; empty where supports or centre of mass are not given.
    pub bearings: Vec<GradedBearing>,
    /// The share of each correction plane whose place is given; empty without bearings.
    pub planes: Vec<GradedPlane>,
    /// Whether the measured unbalance keeps the grade: at both bearings where they are known. Where they are not, a resultant beyond
    /// U_per does not, one within it does if it is measured in one plane; several planes may have a couple that only bearings can judge.
    /// `None` where nothing is measured, or that couple is not judged.
    pub kept: Option<bool>,
}

/// What a bearing may carry.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct GradedBearing {
    /// Where along the shaft, z [m].
    pub z: f64,
    /// Permissible residual unbalance in its plane [kg m].
    pub permissible: f64,
    /// The measured unbalances moved to both bearings: this bearing's part [kg m].
    #[schemars(with = "Option<[f64; 2]>")]
    pub measured: Option<Complex64>,
    /// Whether it is kept.
    pub kept: Option<bool>,
}

/// What may be left in a correction plane.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct GradedPlane {
    /// Name of the plane.
    pub name: String,
    /// Where along the shaft, z [m].
    pub z: f64,
    /// With no more than this in every plane, at whatever angles, no bearing exceeds its share [kg m].
    pub permissible: f64,
    /// The measured unbalances moved to the planes: this plane's part [kg m]. Only where there are one or two planes.
    #[schemars(with = "Option<[f64; 2]>")]
    pub measured: Option<Complex64>,
    /// Whether it is kept. Keeping all is enough, though more than is needed, for the bearings to keep theirs.
    pub kept: Option<bool>,
}

const PURPOSE: &str = "a balance quality grade";

/// Least share of a bearing, lest the remote one be asked for what no machine measures.
const LEAST_SHARE: f64 = 0.3;

/// Largest share of a bearing. One that carries an overhung centre of mass is built for the load.
fn most_share(between: bool) -> f64 {
    if between { 0.7 } else { 1.3 }
}

/// What the grade of the sheet allows, and whether these unbalances keep it.
///
/// ```text
/// e_per = G/omega        U_per = m G/omega          U_per [g mm] = 9549 G [mm/s] m [kg] / n [rpm]
/// U_A = U_per |z_B - z_c|/(z_B - z_A)               U_B = U_per |z_c - z_A|/(z_B - z_A)
/// ```
/// A bearing's share is the force that the whole of U_per would put on it from the centre of mass z_c, but no less than
/// 0.3 U_per, and no more than 0.7 U_per where z_c lies between the bearings, 1.3 U_per where it lies outside. The shares of
/// the correction planes use up those of the bearings in the worst case of all angles:
/// `SUM |lever| U_plane <= share` of each bearing, with equality at both where that is possible with two planes,
/// and equal amounts in all planes else.
///
/// # Errors
/// [`WorkshopError::Missing`] if the sheet gives no mass, service speed or grade.
/// # Source
/// U_per and the shares of the bearings with their limits: `[Iso21940]` part 11. Shares of the planes: book, "Balance quality
/// grades".
pub(crate) fn of_unbalances(
    sheet: &Sheet,
    measured: Option<&[PlaneUnbalance]>,
) -> Result<Grade, WorkshopError> {
    let rotor = &sheet.rotor;
    let need =
        |value: Option<f64>, needed, hint| value.ok_or_else(|| WorkshopError::missing(needed, PURPOSE, hint));
    let mass = need(rotor.mass, "the mass of the rotor", "add mass = \"12 kg\" to [rotor]")?;
    let speed = need(rotor.speed, "the service speed", "add speed = \"6000 rpm\" to [rotor]")?;
    let grade = need(rotor.grade, "the grade itself", "add grade = \"G 6.3\" to [rotor]")?;
    let permissible = mass * grade / speed;
    let resultant = measured.map(|all| all.iter().map(|at| at.unbalance).sum::<Complex64>());
    let bearings = bearings(rotor, permissible, measured)?;
    let planes = planes(sheet, &bearings, measured)?;
    let kept = match (bearings.as_slice(), resultant) {
        ([], Some(resultant)) => {
            let has_couple = measured.is_some_and(|all| all.iter().any(|at| at.z != all[0].z));
            let within = resultant.norm() <= permissible;
            (!within || !has_couple).then_some(within)
        }
        (bearings, Some(_)) => Some(bearings.iter().all(|bearing| bearing.kept == Some(true))),
        (_, None) => None,
    };
    Ok(Grade {
        version: crate::WORKSHOP_VERSION,
        name: sheet.name.clone(),
        grade,
        speed,
        mass,
        eccentricity: grade / speed,
        permissible,
        resultant,
        bearings,
        planes,
        kept,
    })
}

fn bearings(
    rotor: &Rotor,
    permissible: f64,
    measured: Option<&[PlaneUnbalance]>,
) -> Result<Vec<GradedBearing>, WorkshopError> {
    let (Some(supports), Some(centre)) = (rotor.supports, rotor.centre) else { return Ok(Vec::new()) };
    let planes = [("first support", supports[0]), ("second support", supports[1])]
        .map(|(name, z)| Plane { name: name.into(), z });
    let parts = measured.map(|all| in_two_planes(all, &planes)).transpose()?;
    let between = supports[0] <= centre && centre <= supports[1];
    let bearing = |k: usize| {
        let lever = (supports[1 - k] - centre).abs() / (supports[1] - supports[0]);
        let permissible = permissible * lever.clamp(LEAST_SHARE, most_share(between));
        let measured = parts.as_ref().map(|parts| parts[k].unbalance);
        let kept = measured.map(|measured| measured.norm() <= permissible);
        GradedBearing { z: supports[k], permissible, measured, kept }
    };
    Ok(vec![bearing(0), bearing(1)])
}

fn planes(
    sheet: &Sheet,
    bearings: &[GradedBearing],
    measured: Option<&[PlaneUnbalance]>,
) -> Result<Vec<GradedPlane>, WorkshopError> {
    let [first, second] = bearings else { return Ok(Vec::new()) };
    let placed: Vec<Plane> = sheet
        .planes
        .iter()
        .filter_map(|plane| Some(Plane { name: plane.name.clone(), z: plane.z? }))
        .collect();
    let places: Vec<f64> = placed.iter().map(|plane| plane.z).collect();
    let shares = plane_shares(&places, [first, second]);
    let parts: Option<Vec<Complex64>> = match (placed.as_slice(), measured) {
        ([_], Some(all)) => Some(vec![all.iter().map(|at| at.unbalance).sum()]),
        ([one, other], Some(all)) => {
            let parts = in_two_planes(all, &[one.clone(), other.clone()])?;
            Some(parts.map(|part| part.unbalance).to_vec())
        }
        _ => None,
    };
    let graded = placed.into_iter().zip(shares).enumerate().map(|(k, (plane, permissible))| {
        let measured = parts.as_ref().map(|parts| parts[k]);
        let kept = measured.map(|measured| measured.norm() <= permissible);
        GradedPlane { name: plane.name, z: plane.z, permissible, measured, kept }
    });
    Ok(graded.collect())
}

/// Amounts in planes `places` that keep both bearings whatever their angles [kg m].
fn plane_shares(places: &[f64], bearings: [&GradedBearing; 2]) -> Vec<f64> {
    let [z_a, z_b] = bearings.map(|bearing| bearing.z);
    let [u_a, u_b] = bearings.map(|bearing| bearing.permissible);
    let on_a = |z: f64| ((z_b - z) / (z_b - z_a)).abs();
    let on_b = |z: f64| ((z - z_a) / (z_b - z_a)).abs();
    if let &[one, other] = places {
        let determinant = on_a(one) * on_b(other) - on_a(other) * on_b(one);
        let shares = [u_a * on_b(other) - u_b * on_a(other), u_b * on_a(one) - u_a * on_b(one)]
            .map(|numerator| numerator / determinant);
        if shares.iter().all(|share| share.is_finite() && *share > 0.0) {
            return shares.to_vec();
        }
    }
    let most = |permissible: f64, lever: &dyn Fn(f64) -> f64| {
        permissible / places.iter().map(|z| lever(*z)).sum::<f64>()
    };
    // A lever sum of 0 limits nothing: all planes lie in the other bearing.
    vec![most(u_a, &on_a).min(most(u_b, &on_b)); places.len()]
}
