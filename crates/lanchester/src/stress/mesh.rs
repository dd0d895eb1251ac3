//! Which crankshaft is meshed, how fine, and who says so.

use lanchester_flex::crank_mesh::CrankMeshOptions;
use lanchester_report::{MeshOrigin, MeshOrigins};
use lanchester_task::StressTask;

/// Which crankshaft, how fine.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StressMesh {
    /// Index of the crankshaft.
    pub crankshaft: usize,
    /// Size of its elements.
    pub options: CrankMeshOptions,
    /// Who says so.
    pub origins: MeshOrigins,
}

impl StressMesh {
    /// What is asked for goes first, then what the engine file says, then what is usual.
    pub fn of(
        file: Option<&StressTask>,
        crankshaft: usize,
        size: Option<f64>,
        fillet_elements: Option<usize>,
        usual: CrankMeshOptions,
    ) -> StressMesh {
        let in_file = file.map(|task| (task.mesh.size, task.mesh.fillet_elements)).unwrap_or_default();
        let (size, size_origin) = chosen(size, in_file.0, usual.size);
        let (fillet_elements, fillet_origin) = chosen(fillet_elements, in_file.1, usual.fillet_elements);
        StressMesh {
            crankshaft,
            options: CrankMeshOptions { size, fillet_elements, ..usual },
            origins: MeshOrigins { size: size_origin, fillet_elements: fillet_origin },
        }
    }
}

fn chosen<T>(asked: Option<T>, in_file: Option<T>, usual: T) -> (T, MeshOrigin) {
    match (asked, in_file) {
        (Some(asked), None) => (asked, MeshOrigin::Asked),
        (Some(asked), Some(_)) => (asked, MeshOrigin::AskedBeforeFile),
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
}
