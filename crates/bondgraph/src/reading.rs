//! A graph from a description or a graph file.

use crate::description::Description;
use crate::graph::Graph;
use crate::mistake::Mistakes;
use crate::{check, file};
use lanchester_diagnostic::Diagnostic;

impl Graph {
    /// Checks a description.
    ///
    /// # Errors
    /// Every mistake at once, each with what mends it.
    pub fn new(description: &Description) -> Result<Graph, Vec<Diagnostic>> {
        let mut mistakes = Mistakes::default();
        let mut description = description.clone();
        crate::relax::relax(&mut description, &mut mistakes);
        let graph = check::check(&description, &mut mistakes);
        graph.filter(|_| !mistakes.any()).ok_or_else(|| mistakes.into_diagnostics(""))
    }

    /// Reads a graph file.
    ///
    /// # Errors
    /// Every mistake at once, with place and hint. No text makes this panic.
    pub fn read(text: &str) -> Result<Graph, Vec<Diagnostic>> {
        Graph::read_with(text, &|_| None)
    }

    /// The same for a file that uses others; `look_up` gives their texts by the names that [`crate::used_graphs`] finds.
    ///
    /// # Errors
    /// As [`Graph::read`]; a mistake in a used graph is shown where it is used.
    pub fn read_with(text: &str, look_up: &dyn Fn(&str) -> Option<String>) -> Result<Graph, Vec<Diagnostic>> {
        let mut mistakes = Mistakes::default();
        let mut description = file::read(text, look_up, &mut mistakes);
        crate::subgraph::assemble(&mut description, look_up, 0, &mut mistakes);
        crate::relax::relax(&mut description, &mut mistakes);
        let graph = check::check(&description, &mut mistakes);
        let graph = graph.map(|graph| Graph { source: text.to_owned(), ..graph });
        graph.filter(|_| !mistakes.any()).ok_or_else(|| mistakes.into_diagnostics(text))
    }
}
