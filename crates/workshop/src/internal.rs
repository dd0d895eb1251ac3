//! External to internal balance: slugs in two counterweights for the weights that come off flywheel and damper.

use crate::error::WorkshopError;
use crate::removal::slug::{Slug, SlugPlan, slug_plan};
use crate::rotor::plane::{Plane, PlaneUnbalance, in_two_planes};
use lanchester_task::workshop::Sheet;
use num_complex::Complex64;
use serde::Serialize;

/// One counterweight that takes slugs.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct InternalPlane {
    /// Name of its plane.
    pub name: String,
    /// Its plane [m].
    pub z: f64,
    /// The slugs.
    pub plan: SlugPlan,
}

/// Weights outside moved inside.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct InternalBalance {
    /// [`crate::WORKSHOP_VERSION`].
    pub version: u32,
    /// Name of the sheet.
    pub name: String,
    /// Weights that come off.
    pub externals: Vec<PlaneUnbalance>,
    /// The counterweights.
    pub planes: [InternalPlane; 2],
    /// Whether both have room for all that they need.
    pub reached: bool,
    /// Static unbalance that is left where they have not [kg m].
    #[schemars(with = "[f64; 2]")]
    pub static_left: Complex64,
    /// Couple unbalance about z = 0 that is left [kg m^2].
    #[schemars(with = "[f64; 2]")]
    pub couple_left: Complex64,
}

/// Slugs for the sheet's first two planes that take over from its external weights.
///
/// # Errors
/// [`WorkshopError`] where the sheet has no external weights, slugs, or two planes with place and radius, or its slugs
/// cannot be.
pub fn internal_balance(sheet: &Sheet) -> Result<InternalBalance, WorkshopError> {
    const PURPOSE: &str = "moving weights inside";
    if sheet.externals.is_empty() {
        let hint = "add [[external]] with name, z, unbalance and angle for every weight that comes off";
        return Err(WorkshopError::missing("an external weight", PURPOSE, hint));
    }
    let Some(room) = sheet.slug else {
        let hint = "add [slug] with diameter, longest, density and rim";
        return Err(WorkshopError::missing("the slug", PURPOSE, hint));
    };
    let [front, rear] = sheet.planes.as_slice() else {
        return Err(WorkshopError::Impossible {
            what: format!("two counterweights take the slugs, got {} planes", sheet.planes.len()),
            hint: "give exactly two [[plane]] with name, z and radius",
        });
    };
    let place = |plane: &lanchester_task::workshop::Plane| match (plane.z, plane.radius) {
        (Some(z), Some(radius)) => Ok((Plane { name: plane.name.clone(), z }, radius)),
        _ => Err(WorkshopError::missing(
            format!("z and radius of plane \"{}\"", plane.name),
            PURPOSE,
            "z is the middle of the counterweight, radius the distance of the slugs' axes from the crank axis",
        )),
    };
    let places = [place(front)?, place(rear)?];
    let externals: Vec<PlaneUnbalance> = sheet
        .externals
        .iter()
        .map(|weight| PlaneUnbalance {
            name: weight.name.clone(),
            z: weight.z,
            unbalance: Complex64::from_polar(weight.unbalance, weight.angle),
        })
        .collect();
    let wanted = in_two_planes(&externals, &[places[0].0.clone(), places[1].0.clone()])?;
    let plan = |index: usize| {
        let (plane, radius) = &places[index];
        let slug = Slug {
            diameter: room.diameter,
            longest: room.longest,
            radius: *radius,
            density: room.density,
            crank_density: room.crank_density,
            land: room.land,
            rim: room.rim,
            sector: room.sector,
        };
        let allowed = &sheet.planes[index].allowed;
        let plan = slug_plan(&plane.name, wanted[index].unbalance, allowed, &slug)?;
        Ok::<_, WorkshopError>(InternalPlane { name: plane.name.clone(), z: plane.z, plan })
    };
    let planes = [plan(0)?, plan(1)?];
    let reached = planes.iter().all(|plane| plane.plan.reached);
    // Rounding is no unbalance.
    let left = |plane: &InternalPlane| match plane.plan.reached {
        true => Complex64::ZERO,
        false => plane.plan.wanted - plane.plan.gained,
    };
    Ok(InternalBalance {
        version: crate::WORKSHOP_VERSION,
        name: sheet.name.clone(),
        externals,
        static_left: planes.iter().map(left).sum(),
        couple_left: planes.iter().map(|plane| plane.z * left(plane)).sum(),
        planes,
        reached,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_file::workshop::read_sheet;

    const SHEET: &str = "name = \"to inside\"\n\
        [[external]]\nname = \"damper\"\nz = \"-300 mm\"\nunbalance = \"6 kg mm\"\nangle = \"150 deg\"\n\
        [[external]]\nname = \"flywheel\"\nz = \"320 mm\"\nunbalance = \"5 kg mm\"\nangle = \"-20 deg\"\n\
        [[plane]]\nname = \"front\"\nz = \"-210 mm\"\nradius = \"70 mm\"\n\
        [[plane]]\nname = \"rear\"\nz = \"210 mm\"\nradius = \"70 mm\"\n\
        [slug]\ndiameter = \"25.4 mm\"\nlongest = \"22 mm\"\ndensity = \"17 g/cm3\"\nrim = \"90 mm\"\n";

    fn sheet(text: &str) -> Sheet {
        let reading = read_sheet(text);
        reading.sheet.unwrap_or_else(|| panic!("{:?}", reading.diagnostics))
    }

    /// What the slugs bring has the same sum and moment as what came off.
    #[test]
    fn sum_and_moment_stay() {
        let got = internal_balance(&sheet(SHEET)).unwrap();
        assert!(got.reached && got.static_left == Complex64::ZERO);
        let off: Complex64 = got.externals.iter().map(|e| e.unbalance).sum();
        let on: Complex64 = got.planes.iter().map(|p| p.plan.gained).sum();
        assert!((off - on).norm() < 1e-15);
        let off: Complex64 = got.externals.iter().map(|e| e.unbalance * e.z).sum();
        let on: Complex64 = got.planes.iter().map(|p| p.plan.gained * p.z).sum();
        assert!((off - on).norm() < 1e-15);
        assert_eq!(got.planes.iter().map(|p| p.plan.directions.len()).collect::<Vec<_>>(), [2, 2]);
    }

    /// Slugs of 9 mm have not room for all: what is left in the two planes is the rest, by sum and by moment.
    #[test]
    fn what_has_no_room_is_left() {
        let got = internal_balance(&sheet(&SHEET.replace("25.4 mm", "9 mm"))).unwrap();
        assert!(!got.reached);
        let off: Complex64 = got.externals.iter().map(|e| e.unbalance).sum();
        let on: Complex64 = got.planes.iter().map(|p| p.plan.gained).sum();
        assert!((off - on - got.static_left).norm() < 1e-15 && got.static_left.norm() > 1e-5);
        let off: Complex64 = got.externals.iter().map(|e| e.unbalance * e.z).sum();
        let on: Complex64 = got.planes.iter().map(|p| p.plan.gained * p.z).sum();
        assert!((off - on - got.couple_left).norm() < 1e-15 && got.couple_left.norm() > 1e-5);
    }

    #[test]
    fn what_is_missing_is_named() {
        let said = |text: &str| internal_balance(&sheet(text)).unwrap_err().to_string();
        let (before, slug) = SHEET.split_at(SHEET.find("[slug]").unwrap());
        assert!(said(before).contains("the slug is needed"));
        assert!(said(&format!("name = \"x\"\n{slug}")).contains("an external weight is needed"));
        let one = SHEET.replace("[[plane]]\nname = \"rear\"\nz = \"210 mm\"\nradius = \"70 mm\"\n", "");
        assert!(said(&one).contains("got 1 planes"));
        assert!(said(&SHEET.replacen("radius = \"70 mm\"\n", "", 1)).contains("plane \"front\""));
    }
}
