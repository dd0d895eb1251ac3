//! Engine mounts.

use super::Reader;
use crate::diagnostic::Mistake;
use crate::document::Section;
use crate::mount::Mount;

impl<'a> Reader<'a> {
    pub(super) fn mounts(&mut self) -> Option<Vec<Mount>> {
        let sections = self.root.tables("mount").or(&[])?;
        let mounts: Vec<Option<Mount>> =
            sections.iter().enumerate().map(|(index, section)| self.mount(index, section)).collect();
        for (index, mount) in mounts.iter().enumerate() {
            let Some(mount) = mount else { continue };
            let twin = mounts[..index].iter().position(|other| {
                other.as_ref().is_some_and(|other| (other.x, other.y, other.z) == (mount.x, mount.y, mount.z))
            });
            if let Some(twin) = twin {
                let (one, two) = (twin + 1, index + 1);
                self.mistakes.push(
                    Mistake::error(
                        "E0507",
                        sections[index].span.clone(),
                        format!("mounts {one} and {two} stand in one place"),
                    )
                    .related(sections[twin].span.clone(), "the other"),
                );
            }
        }
        mounts.into_iter().collect()
    }

    fn mount(&mut self, index: usize, section: &'a Section) -> Option<Mount> {
        let name = section.text("name").or(format!("mount {}", index + 1));
        let [x, y, z] = ["x", "y", "z"].map(|key| self.required(section, key, section.number(key)));
        Some(Mount { name: name?, x: x?, y: y?, z: z?, spring: None })
    }
}
