//! One sketch.

use crate::generate::document::{document, file_of};
use crate::generate::pen::Pen;

/// A sketch: a file of the book's pictures, with words for readers who cannot see it.
pub struct Sketch {
    /// Its name below `docs/src/images/theory`, without the ending.
    pub name: &'static str,
    /// Title.
    pub title: &'static str,
    /// What it shows.
    pub says: &'static str,
    /// Width and height [px].
    pub size: (f64, f64),
    /// Draws it.
    pub draw: fn(&mut Pen),
}

impl Sketch {
    /// Where it stands in the repository.
    pub fn file(&self) -> String {
        file_of(self.name)
    }

    /// The drawing as a document with its own styles.
    pub fn svg(&self) -> String {
        let mut pen = Pen::new();
        (self.draw)(&mut pen);
        document(pen, self.name, self.title, self.says, self.size)
    }
}
