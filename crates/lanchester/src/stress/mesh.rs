//! Which crankshaft is meshed, how fine, and who says so.

use lanchester_flex::FlexError;
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_model::Engine;
use lanchester_report::{MeshOrigin, MeshOrigins};
use lanchester_task::StressTask;
use std::sync::Arc;

/// Nodes of a mesh of which nobody says how many elements it has across a fillet: what an ordinary computer solves in minutes and in 6 GiB.
pub const MOST_NODES: usize = 220_000;

/// Which crankshaft, how fine.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StressMesh {
    /// Index of the crankshaft.
    pub crankshaft: usize,
    /// Size of its elements.
    pub options: CrankMeshOptions,
    /// Who says so.
    pub origins: MeshOrigins,
    /// A mesh from elsewhere instead.
    pub own: Option<MeshFile>,
}

/// A file with the mesh of a crankshaft: a CalculiX deck.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFile {
    /// Its name in the engine file.
    pub name: String,
    /// What it holds; none until somebody has read it.
    pub text: Option<Arc<str>>,
}

impl StressMesh {
    /// What is asked for goes first, then what the engine file says, then what is usual. Where the file names a mesh of its own and nothing is asked for,
    /// that mesh counts: its text is still to be read.
    pub fn of(
        file: Option<&StressTask>,
        crankshaft: usize,
        size: Option<f64>,
        fillet_elements: Option<usize>,
        usual: CrankMeshOptions,
    ) -> StressMesh {
        let in_file = file.map(|task| (task.mesh.size, task.mesh.fillet_elements)).unwrap_or_default();
        let named = file.and_then(|task| task.mesh.file.as_ref()).filter(|_| crankshaft == 0);
        let is_asked = size.is_some() || fillet_elements.is_some();
        let own = named.filter(|_| !is_asked).map(|name| MeshFile { name: name.clone(), text: None });
        let (size, size_origin) = chosen(size, in_file.0, usual.size, named.is_some());
        let (fillet_elements, fillet_origin) =
            chosen(fillet_elements, in_file.1, usual.fillet_elements, named.is_some());
        StressMesh {
            crankshaft,
            options: CrankMeshOptions { size, fillet_elements, ..usual },
            origins: MeshOrigins { size: size_origin, fillet_elements: fillet_origin },
            own,
        }
    }

    /// The same, for one mesh of a study that asks for each of its meshes: its elements across a fillet stay as they are.
    pub(crate) fn held(self) -> StressMesh {
        let fillet_elements = match self.origins.fillet_elements {
            MeshOrigin::Usual => MeshOrigin::Asked,
            said => said,
        };
        StressMesh { origins: MeshOrigins { fillet_elements, ..self.origins }, ..self }
    }

    /// Meshes the crankshaft from its body. Where nobody says how many elements stand across a fillet, there are as many as usual, or as [`MOST_NODES`]
    /// and sound elements leave room for: 2 at least.
    pub(crate) fn meshed(&self, engine: &Engine) -> Result<(CrankMesh, StressMesh), FlexError> {
        let mut own = self.clone();
        let nobody_says = own.options.fillets && own.origins.fillet_elements == MeshOrigin::Usual;
        loop {
            let found = crank_mesh(engine, own.crankshaft, own.options);
            let is_too_fine = match &found {
                Ok(found) => found.mesh.nodes.len() > MOST_NODES,
                Err(error) => matches!(error, FlexError::Crowded { .. }),
            };
            if !(is_too_fine && nobody_says && own.options.fillet_elements > 2) {
                return Ok((found?, own));
            }
            own.options.fillet_elements -= 2;
            own.origins.fillet_elements = MeshOrigin::Fitted;
        }
    }
}

/// `has_mesh`: whether the file names a mesh of its own.
fn chosen<T>(asked: Option<T>, in_file: Option<T>, usual: T, has_mesh: bool) -> (T, MeshOrigin) {
    match (asked, in_file) {
        (Some(asked), None) if !has_mesh => (asked, MeshOrigin::Asked),
        (Some(asked), _) => (asked, MeshOrigin::AskedBeforeFile),
        (None, Some(in_file)) => (in_file, MeshOrigin::File),
        (None, None) => (usual, MeshOrigin::Usual),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_task::MeshTask;

    #[test]
    fn what_is_asked_goes_before_the_file_and_the_file_before_what_is_usual() {
        let mesh = MeshTask { size: Some(0.014), ..MeshTask::default() };
        let task = StressTask { mesh, cases: Vec::new() };
        let of = |size, count| StressMesh::of(Some(&task), 0, size, count, CrankMeshOptions::default());
        let plain = of(None, None);
        assert_eq!((plain.options.size, plain.options.fillet_elements), (0.014, 6));
        assert_eq!(
            (plain.origins.size, plain.origins.fillet_elements),
            (MeshOrigin::File, MeshOrigin::Usual)
        );
        let asked = of(Some(0.02), Some(2));
        assert_eq!((asked.options.size, asked.options.fillet_elements), (0.02, 2));
        assert_eq!(
            (asked.origins.size, asked.origins.fillet_elements),
            (MeshOrigin::AskedBeforeFile, MeshOrigin::Asked)
        );
        let usual = CrankMeshOptions { fillet_elements: 2, ..CrankMeshOptions::default() };
        assert_eq!(StressMesh::of(None, 0, None, None, usual).options, usual);
    }

    #[test]
    fn a_crankshaft_of_many_throws_has_fewer_elements_where_nobody_says_how_many() {
        let text = include_str!("../../../../examples/in-line-4-crank-by-elements.toml");
        let engine = lanchester_file::read(text).engine().expect("the example has no mistakes");
        let fine = CrankMeshOptions { fillet_elements: 4, ..CrankMeshOptions::default() };
        let (found, own) = StressMesh::of(None, 0, None, None, fine).meshed(&engine).expect("it is meshed");
        assert!(found.mesh.nodes.len() <= MOST_NODES && own.options.fillet_elements == 2, "{own:?}");
        assert_eq!(own.origins.fillet_elements, MeshOrigin::Fitted);
        // One more pair would be too many.
        let more = CrankMeshOptions { fillet_elements: own.options.fillet_elements + 2, ..own.options };
        let asked = StressMesh::of(None, 0, None, Some(more.fillet_elements), more);
        let (found, asked) = asked.meshed(&engine).expect("it is meshed");
        assert!(found.mesh.nodes.len() > MOST_NODES);
        // What is asked for stays.
        assert_eq!((asked.options, asked.origins.fillet_elements), (more, MeshOrigin::Asked));
    }

    #[test]
    fn a_mesh_of_the_file_counts_where_no_other_is_asked_for() {
        let mesh = MeshTask { file: Some("crank.inp".to_owned()), ..MeshTask::default() };
        let task = StressTask { mesh, cases: Vec::new() };
        let of = |crankshaft, size| {
            StressMesh::of(Some(&task), crankshaft, size, None, CrankMeshOptions::default())
        };
        assert_eq!(of(0, None).own.map(|own| own.name).as_deref(), Some("crank.inp"));
        assert_eq!(of(1, None).own, None);
        let asked = of(0, Some(0.01));
        assert_eq!((asked.own, asked.origins.size), (None, MeshOrigin::AskedBeforeFile));
    }
}
