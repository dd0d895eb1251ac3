//! Natural frequencies in torsion: `torsion frequency N` is that of mode N [Hz].

use lanchester::engine_chain;
use lanchester::file::EngineFile;
use lanchester::torsion::modes;

/// A natural frequency.
pub(crate) struct TorsionKey {
    /// Index of the mode.
    mode: usize,
}

impl TorsionKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<TorsionKey> {
        let number: usize = text.strip_prefix("torsion frequency ")?.parse().ok()?;
        Some(TorsionKey { mode: number.checked_sub(1)? })
    }

    /// Its value [Hz].
    pub fn of(&self, file: &EngineFile) -> Result<f64, String> {
        let crank = engine_chain(file, &[]).map_err(|error| error.to_string())?;
        let found = modes(&crank.chain, file.engine.speed.highest).map_err(|error| error.to_string())?;
        let mode = found.get(self.mode).ok_or_else(|| format!("the chain has {} modes", found.len()))?;
        Ok(mode.hertz())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        assert!(TorsionKey::parse("torsion frequency 2").is_some_and(|key| key.mode == 1));
        assert!(TorsionKey::parse("torsion frequency 0").is_none() && TorsionKey::parse("torsion").is_none());
    }
}
