//! The order of the engines by one criterion.

use crate::compare::compared::Compared;
use serde::Serialize;

/// What engines are compared by: less is better.
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
    pub const ALL: [Criterion; 9] = [
        Criterion::Force,
        Criterion::Couple,
        Criterion::RollMoment,
        Criterion::MountForce,
        Criterion::FiringUnevenness,
        Criterion::TorqueUnevenness,
        Criterion::Flywheel,
        Criterion::AddedUnbalance,
        Criterion::Shafts,
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
        }
    }

    /// Its unit; empty for plain numbers.
    pub fn unit(self) -> &'static str {
        match self {
            Criterion::Force | Criterion::MountForce => "N",
            Criterion::Couple | Criterion::RollMoment => "N m",
            Criterion::Flywheel => "kg m2",
            Criterion::AddedUnbalance => "kg m",
            Criterion::FiringUnevenness | Criterion::TorqueUnevenness | Criterion::Shafts => "",
        }
    }

    /// Whether twice the engine has twice of it: a share of the reference has that share. How uneven an engine is has no size.
    pub fn is_of_size(self) -> bool {
        !matches!(self, Criterion::FiringUnevenness | Criterion::TorqueUnevenness)
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
        places.sort_by(|a, b| a.value.total_cmp(&b.value).then(a.engine.cmp(&b.engine)));
        // A rank is that of the first engine from which it cannot be told.
        let mut first = 0;
        for k in 0..places.len() {
            if places[k].value - places[first].value > SAME * largest {
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
    fn what_one_engine_does_not_have_ranks_none() {
        let engines = [engine(1.0, Some(0.0)), engine(2.0, None)];
        assert!(Ranking::of(Criterion::FiringUnevenness, &engines).is_none());
    }
}
