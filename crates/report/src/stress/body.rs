//! What was meshed of a crankshaft: mesh, material, what is left out.

use crate::kit::number;
use lanchester_flex::Material;
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions};
use lanchester_model::{Origin, Sourced};
use serde::Serialize;

/// A meshed crankshaft.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankSheet {
    /// Name of the engine.
    pub engine: String,
    /// Number of the crankshaft, from 1.
    pub crankshaft: usize,
    /// Its material.
    pub material: StressMaterial,
    /// The file that its mesh comes from; none where it is meshed from its body.
    pub own_file: Option<String>,
    /// How fine it is meshed; says nothing of a mesh from a file.
    pub options: CrankMeshOptions,
    /// Who says so.
    pub origins: MeshOrigins,
    /// The mesh: its quality, its corners, what is not meshed; the nodes themselves are not serialised.
    pub crank: CrankMesh,
    /// Mass of the exact body without fillets, of what is meshed; of a mesh from a file that of the body with nose and flange, 0 where the engine file has no body [kg].
    pub exact_mass: f64,
    /// Volume that fillets add, by Pappus's rule, times the density [kg].
    pub fillet_mass: f64,
}

/// Who says how fine a mesh is; a study of convergence refines it on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
pub struct MeshOrigins {
    /// Of the size of the elements.
    pub size: MeshOrigin,
    /// Of the elements across a fillet.
    pub fillet_elements: MeshOrigin,
}

/// Who says a number of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MeshOrigin {
    /// Nobody: the usual number.
    #[default]
    Usual,
    /// Nobody: fewer than usual, so that the mesh is sound and can be solved on an ordinary computer.
    Fitted,
    /// The engine file.
    File,
    /// The request; the file says nothing.
    Asked,
    /// The request, before the engine file, which says something else.
    AskedBeforeFile,
}

impl MeshOrigin {
    /// In words, where the engine file has a say.
    fn words(self) -> Option<&'static str> {
        match self {
            MeshOrigin::Usual | MeshOrigin::Asked => None,
            MeshOrigin::Fitted => Some(
                "fewer than usual, for a sound mesh that is solved in minutes: stresses of fillets are coarse, and more elements can be asked for",
            ),
            MeshOrigin::File => Some("as [crank.mesh] of the engine file says"),
            MeshOrigin::AskedBeforeFile => {
                Some("as asked for, before that of [crank.mesh] in the engine file")
            }
        }
    }
}

/// Elastic constants with their origin, and the yield strength where the file gives one.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StressMaterial {
    /// Elastic constants and density.
    pub elastic: Material,
    /// Where Young's modulus comes from.
    pub origin: Origin,
    /// Yield strength [Pa].
    pub yield_strength: Option<Sourced>,
}

impl CrankSheet {
    /// Lines on mesh, material and what is left out.
    pub fn words(&self) -> Vec<String> {
        let quality = &self.crank.quality;
        let [tetrahedra, wedges, hexahedra] = quality.elements;
        let kinds = [(tetrahedra, "tetrahedra"), (wedges, "wedges"), (hexahedra, "hexahedra")];
        let kinds: Vec<String> = kinds
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, kind)| format!("{} quadratic {kind}", number::whole(*count as u128)))
            .collect();
        let fineness = match &self.own_file {
            Some(file) => format!("from {file}"),
            None => format!(
                "elements of {} mm, {} across the 90 deg of a fillet",
                number::trimmed(1e3 * self.options.size, 4),
                self.options.fillet_elements
            ),
        };
        let mut words = vec![format!(
            "Mesh: {} nodes, {}; {fineness}; smallest scaled Jacobian {:.2}, smallest angle {:.0} deg.",
            number::whole(quality.nodes as u128),
            kinds.join(", "),
            quality.least_jacobian,
            quality.least_angle.to_degrees(),
        )];
        let origins = [
            ("size of the elements", self.origins.size.words()),
            ("elements across a fillet", self.origins.fillet_elements.words()),
        ];
        let told: Vec<String> =
            origins.iter().filter_map(|(what, origin)| Some(format!("{what} {}", (*origin)?))).collect();
        if !told.is_empty() {
            words.push(format!("Fineness of the mesh: {}.", told.join("; ")));
        }
        let exact = self.exact_mass + self.fillet_mass;
        let mass = number::short(quality.mass, 6);
        words.push(match &self.own_file {
            Some(_) if exact == 0.0 => format!("Mass of the mesh {mass} kg."),
            Some(_) => format!(
                "Mass of the mesh {mass} kg; of [crank.body] with nose and flange, without fillets {} kg (difference {:.1} %).",
                number::short(exact, 6),
                100.0 * (quality.mass / exact - 1.0),
            ),
            None => format!(
            "Mass of the mesh {mass} kg; of the exact body {} kg, of which fillets {} kg (difference {:.1e}).",
            number::short(exact, 6),
            number::short(self.fillet_mass, 3),
            (quality.mass / exact - 1.0).abs(),
        )
        });
        let elastic = &self.material.elastic;
        let mut material = format!(
            "Material: Young's modulus {} GPa ({}), Poisson's ratio {}, density {} kg/m3",
            number::trimmed(1e-9 * elastic.youngs_modulus, 4),
            self.material.origin,
            number::trimmed(elastic.poisson_ratio, 3),
            number::trimmed(elastic.density, 5),
        );
        match self.material.yield_strength {
            Some(strength) => material.push_str(&format!(
                ", yield strength {} MPa ({}).",
                number::trimmed(1e-6 * strength.value, 4),
                strength.origin
            )),
            None => material.push_str(
                "; no yield strength, so no safety (give yield_strength or a preset in [crank.material]).",
            ),
        }
        words.push(material);
        if !self.crank.left_out.is_empty() {
            words.push(format!("Not meshed: {}.", self.crank.left_out.join(", ")));
        }
        words.extend(self.weight_words());
        words
    }

    /// What counterweights without a shape do: nothing where there are none.
    fn weight_words(&self) -> Option<String> {
        let weights = &self.crank.weights;
        let mut places: Vec<&str> = Vec::new();
        for weight in weights {
            if !places.contains(&weight.place.as_str()) {
                places.push(&weight.place);
            }
        }
        let last = places.pop()?;
        let places =
            if places.is_empty() { last.to_owned() } else { format!("{} and {last}", places.join(", ")) };
        let sum: f64 = weights.iter().map(|weight| weight.unbalance[0].hypot(weight.unbalance[1])).sum();
        let (count, are) = match weights.len() {
            1 => ("1 counterweight has".to_owned(), "force acts"),
            count => (format!("{count} counterweights have"), "forces act"),
        };
        Some(format!(
            "{count} no shape ({} g mm together): the centrifugal {are} on {places}, spread over the part of a web beyond the journal on its side; their masses are not in the mesh.",
            number::short(1e6 * sum, 5)
        ))
    }
}
