//! The order of the engines by one criterion.

use crate::compare::compared::Compared;
use lanchester_task::Measured;
use serde::Serialize;

/// What engines are compared by: less is better, but of films and safeties.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "RankingCriterion")]
#[serde(rename_all = "kebab-case")]
pub enum Criterion {
    /// Largest force of the moving masses [N].
    Force,
    /// Largest couple [N m].
    Couple,
    /// Largest roll moment of the moving masses [N m].
    RollMoment,
    /// Largest force at any mount [N].
    MountForce,
    /// Departure of the firing intervals from even ones.
    FiringUnevenness,
    /// Excess energy over the work of a period.
    TorqueUnevenness,
    /// Inertia of the flywheel [kg m^2].
    Flywheel,
    /// Unbalance of counterweights and shaft weights [kg m].
    AddedUnbalance,
    /// Number of balance shafts.
    Shafts,
    /// Smallest oil film of any main bearing [m]: more is better.
    MainFilm,
    /// Smallest oil film of any big-end bearing [m]: more is better.
    CrankpinFilm,
    /// Smallest safety after UR M53: more is better.
    RuleSafety,
    /// Smallest safety of any fillet by finite elements: more is better.
    FilletSafety,
}

/// The engines by one criterion, best first.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Ranking {
    /// By what.
    pub criterion: Criterion,
    /// The engines in their order.
    pub places: Vec<Place>,
}

/// An engine in a ranking.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "RankingPlace")]
pub struct Place {
    /// Its place in the comparison.
    pub engine: usize,
    /// Rank, from 1; engines that cannot be told apart share it.
    pub rank: usize,
    /// What it has, in the unit of the criterion.
    pub value: f64,
}

/// Values closer than this share of the largest one share a rank.
const SAME: f64 = 1e-6;

impl Criterion {
    /// All of them.
    pub const ALL: [Criterion; 13] = [
        Criterion::Force,
        Criterion::Couple,
        Criterion::RollMoment,
        Criterion::MountForce,
        Criterion::FiringUnevenness,
        Criterion::TorqueUnevenness,
        Criterion::Flywheel,
        Criterion::AddedUnbalance,
        Criterion::Shafts,
        Criterion::MainFilm,
        Criterion::CrankpinFilm,
        Criterion::RuleSafety,
        Criterion::FilletSafety,
    ];

    /// Its name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Criterion::Force => "force",
            Criterion::Couple => "couple",
            Criterion::RollMoment => "roll moment",
            Criterion::MountForce => "mount force",
            Criterion::FiringUnevenness => "unevenness of firing",
            Criterion::TorqueUnevenness => "unevenness of torque",
            Criterion::Flywheel => "flywheel",
            Criterion::AddedUnbalance => "added unbalance",
            Criterion::Shafts => "balance shafts",
            Criterion::MainFilm => "main-bearing film",
            Criterion::CrankpinFilm => "crankpin film",
            Criterion::RuleSafety => "safety after UR M53",
            Criterion::FilletSafety => "fillet safety",
        }
    }

    /// Its unit; empty for plain numbers.
    pub fn unit(self) -> &'static str {
        match self {
            Criterion::Force | Criterion::MountForce => "N",
            Criterion::Couple | Criterion::RollMoment => "N m",
            Criterion::Flywheel => "kg m2",
            Criterion::AddedUnbalance => "kg m",
            Criterion::MainFilm | Criterion::CrankpinFilm => "m",
            Criterion::FiringUnevenness
            | Criterion::TorqueUnevenness
            | Criterion::Shafts
            | Criterion::RuleSafety
            | Criterion::FilletSafety => "",
        }
    }

    /// Whether twice the engine has twice of it: a share of the reference has that share. How uneven an engine is has no size.
    pub fn is_of_size(self) -> bool {
        !matches!(self, Criterion::FiringUnevenness | Criterion::TorqueUnevenness) && !self.more_is_better()
    }

    /// Whether the first is the one with the most.
    pub fn more_is_better(self) -> bool {
        matches!(
            self,
            Criterion::MainFilm | Criterion::CrankpinFilm | Criterion::RuleSafety | Criterion::FilletSafety
        )
    }

    /// What an engine has of it, in its unit; `None` where it is not known.
    pub fn value(self, engine: &Compared) -> Option<f64> {
        match self {
            Criterion::Force => Some(engine.force),
            Criterion::Couple => Some(engine.couple),
            Criterion::RollMoment => Some(engine.roll_moment),
            Criterion::MountForce => engine.mount_force,
            Criterion::FiringUnevenness => engine.firing_unevenness,
            Criterion::TorqueUnevenness => engine.torque.map(|torque| torque.excess_share),
            Criterion::Flywheel => engine.torque.and_then(|torque| torque.flywheel),
            Criterion::AddedUnbalance => Some(engine.counterweights + engine.shaft_weights),
            Criterion::Shafts => Some(engine.shafts as f64),
            Criterion::MainFilm => engine.main_film.value(),
            Criterion::CrankpinFilm => engine.crankpin_film.value(),
            Criterion::RuleSafety => engine.rule_safety.value(),
            Criterion::FilletSafety => engine.fillet_safety.as_ref().and_then(Measured::value),
        }
    }
}

impl Ranking {
    /// The engines by `criterion`; `None` where one of them does not have it.
    pub fn of(criterion: Criterion, engines: &[Compared]) -> Option<Ranking> {
        let values = engines.iter().map(|engine| criterion.value(engine)).collect::<Option<Vec<f64>>>()?;
        let largest = values.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
        let mut places: Vec<Place> =
            values.iter().enumerate().map(|(engine, &value)| Place { engine, rank: 1, value }).collect();
        let sense = if criterion.more_is_better() { -1.0 } else { 1.0 };
        places.sort_by(|a, b| (sense * a.value).total_cmp(&(sense * b.value)).then(a.engine.cmp(&b.engine)));
        // A rank is that of the first engine from which it cannot be told.
        let mut first = 0;
        for k in 0..places.len() {
            if sense * (places[k].value - places[first].value) > SAME * largest {
                first = k;
            }
            places[k].rank = first + 1;
        }
        Some(Ranking { criterion, places })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::similar::Similar;
    use lanchester_task::Unmeasured;

    fn unknown() -> Measured {
        Measured::Unknown(Unmeasured { reason: "no oil".into(), remedy: "give it".into() })
    }

    fn engine(force: f64, firing: Option<f64>) -> Compared {
        Compared {
            engine: String::new(),
            with: None,
            similar: Similar::SAME,
            speed: 1.0,
            displacement: None,
            force,
            force_leading: None,
            couple: 0.0,
            couple_leading: None,
            roll_moment: 0.0,
            mount_force: None,
            main_load: None,
            main_film: unknown(),
            crankpin_film: unknown(),
            rule_safety: unknown(),
            fillet_safety: None,
            bending_moment: None,
            balance_rate: None,
            firing_unevenness: firing,
            torque: None,
            counterweights: 0.0,
            shafts: 0,
            shaft_weights: 0.0,
            added_mass: None,
        }
    }

    #[test]
    fn equals_share_a_rank_and_the_next_one_counts_them() {
        let engines = [3.0, 1.0, 1.0 + 1e-9, 2.0].map(|force| engine(force, None));
        let ranking = Ranking::of(Criterion::Force, &engines).unwrap();
        let order: Vec<(usize, usize)> = ranking.places.iter().map(|p| (p.engine, p.rank)).collect();
        assert_eq!(order, [(1, 1), (2, 1), (3, 3), (0, 4)]);
        let couples = Ranking::of(Criterion::Couple, &engines).unwrap();
        assert!(couples.places.iter().all(|place| place.rank == 1));
    }

    #[test]
    fn of_films_the_thickest_comes_first() {
        let film =
            |value| Measured::Known { value, place: String::new(), speed: 1.0, left_out: String::new() };
        let mut engines = [engine(1.0, None), engine(1.0, None), engine(1.0, None)];
        for (engine, value) in engines.iter_mut().zip([2e-6, 5e-6, 2e-6]) {
            engine.main_film = film(value);
        }
        let ranking = Ranking::of(Criterion::MainFilm, &engines).unwrap();
        let order: Vec<(usize, usize)> = ranking.places.iter().map(|p| (p.engine, p.rank)).collect();
        assert_eq!(order, [(1, 1), (0, 2), (2, 2)]);
        // What is not known is no film of 0: it ranks nobody.
        engines[0].main_film = unknown();
        assert!(Ranking::of(Criterion::MainFilm, &engines).is_none());
    }

    #[test]
    fn what_one_engine_does_not_have_ranks_none() {
        let engines = [engine(1.0, Some(0.0)), engine(2.0, None)];
        assert!(Ranking::of(Criterion::FiringUnevenness, &engines).is_none());
    }
}
