//! What the options of `balance` change about a task: of a command line or of the studio.

use crate::balance_task::WHAT_FITS;
use crate::balance_task::{BalanceTask, Catalogue, Cost, Seat};
use crate::default_task::{CrankWeightPlaces, crank_weights};
use crate::durability::{AtLeast, DurabilityCriterion};
use crate::give_up;
use crate::option::{self, BadQuantity};
use crate::room::{RoomFault, RoomFaultKind, TaskDevice, room_faults};
use crate::speed_weight::weighted_speed;
use lanchester_model::Engine;
use lanchester_units::nearest;

/// Options as text, each as `lanchester balance` takes it.
#[derive(Debug, Clone, Default)]
pub struct TaskOptions {
    /// What stands before the name of an option where a message names it: `--` on a command line.
    pub prefix: &'static str,
    /// Free weights on the crankshafts in place of the task's.
    pub counterweights: Option<CrankWeightPlaces>,
    /// Shafts that are added ([`BalanceTask::add_shaft`]).
    pub shafts: Vec<String>,
    /// What is minimised ([`option::stage`]), in place of the task's stages and orders to cancel.
    pub minimise: Vec<String>,
    /// What stages give up for those after them ([`option::give_up`]), in place of what the task says.
    pub give_up: Vec<String>,
    /// What must hold ([`option::limit`]); replaces limits on the same.
    pub limits: Vec<String>,
    /// Films and safeties that are to be large ([`DurabilityCriterion::read`]), in place of those of the task.
    pub maximise: Vec<String>,
    /// Films and safeties that must not fall below a value ([`AtLeast::read`]); each replaces one on the same.
    pub at_least: Vec<String>,
    /// Largest cost ([`option::budget`]), in place of the task's.
    pub budget: Option<String>,
    /// Orders that must vanish ([`option::cancel`]), in place of the task's stages and limits.
    pub cancel: Vec<String>,
    /// Least unbalance of every free weight on a crankshaft that is used.
    pub least: Option<String>,
    /// Largest unbalance of every free weight on a crankshaft, or `what fits`.
    pub most: Option<String>,
    /// Step in which every free weight on a crankshaft is made ([`option::mass_or_unbalance`]).
    pub step: Option<String>,
    /// Whether all free weights on crankshafts have the same amount of their steps or lists.
    pub equal_parts: bool,
    /// Whether every free weight on a crankshaft may be left out.
    pub optional: bool,
    /// Most optional devices that may be used at once.
    pub most_optional: Option<usize>,
    /// Speeds at which forces at mounts with springs and loads with gas are judged ([`weighted_speed`]), in place of the task's.
    pub speeds: Vec<String>,
}

/// A task with options, and what is odd about them.
#[derive(Debug, Clone, PartialEq)]
pub struct ChangedTask {
    /// The task.
    pub task: BalanceTask,
    /// Devices of the options that may strike the crank or stand far out; the engine file's own are told where it is read.
    pub warnings: Vec<RoomFault>,
}

impl TaskOptions {
    /// A task of an engine with these options.
    ///
    /// # Errors
    /// [`BadQuantity`] where an option cannot be read or has no meaning for this engine, two contradict each other, a shaft goes
    /// through a crank, or nothing is free.
    pub fn change(&self, engine: &Engine, mut task: BalanceTask) -> Result<ChangedTask, BadQuantity> {
        if let Some(places) = self.counterweights {
            self.replace_crank_weights(engine, &mut task, places)?;
        }
        let (own_shafts, own_weights) = (task.shafts.len(), task.weights.len());
        for text in &self.shafts {
            task.add_shaft(text, &self.name("shaft"))?;
        }
        // Of what stands in the file its reader has told.
        let of_options = |fault: &RoomFault| match fault.device {
            TaskDevice::Shaft(index) => index >= own_shafts,
            TaskDevice::Weight(index) => index >= own_weights,
        };
        let warnings: Vec<_> = room_faults(engine, &task).into_iter().filter(of_options).collect();
        if let Some(fault) = warnings.iter().find(|fault| fault.kind == RoomFaultKind::Through) {
            return Err(refused(fault.message.clone(), fault.hint));
        }
        self.bound_crank_weights(&mut task)?;
        self.set_aims(engine, &mut task)?;
        if task.weights.is_empty() && task.inertias.is_empty() {
            return Err(refused(
                "nothing is free: there is no weight whose unbalance could be found".into(),
                &format!(
                    "give {} or {}, or a section [balance] in the engine file",
                    self.name("counterweights"),
                    self.name("shaft")
                ),
            ));
        }
        if task.asks_for_cost()
            && task.shaft_costs.is_empty()
            && task.weights.iter().all(|weight| weight.cost == Cost::default())
        {
            return Err(refused(
                "a cost is asked for, and no weight or shaft costs anything".into(),
                "give fixed_cost or cost_per_kg to the weights of [balance], or fixed_cost to its shafts",
            ));
        }
        Ok(ChangedTask { task, warnings })
    }

    fn name(&self, option: &str) -> String {
        format!("{}{option}", self.prefix)
    }

    /// What is minimised, what must hold, what must vanish.
    fn set_aims(&self, engine: &Engine, task: &mut BalanceTask) -> Result<(), BadQuantity> {
        let wanted =
            self.minimise.len() + self.limits.len() + self.give_up.len() + usize::from(self.budget.is_some());
        if !self.cancel.is_empty() && wanted > 0 {
            return Err(refused(
                format!(
                    "orders that must vanish stand in place of what is minimised and of limits, got {} beside {}, {} or {}",
                    self.name("cancel"),
                    self.name("minimise"),
                    self.name("limit"),
                    self.name("give-up")
                ),
                "ask for one of them",
            ));
        }
        if !self.minimise.is_empty() {
            let stage = |text: &String| option::stage(text, engine, &self.name("minimise"));
            task.stages = self.minimise.iter().map(stage).collect::<Result<_, _>>()?;
            task.cancel.clear();
            task.give_up.clear();
        }
        if !self.give_up.is_empty() {
            if !task.cancel.is_empty() {
                return Err(refused(
                    format!(
                        "{} has no effect: [balance] asks for orders that must vanish",
                        self.name("give-up")
                    ),
                    &format!("add {} with what is to be minimised", self.name("minimise")),
                ));
            }
            let stages = task.stages_or_default();
            let mut list = Vec::new();
            let mut taken = Vec::new();
            for (place, text) in self.give_up.iter().enumerate() {
                let (stage, given) = option::give_up(text, place, &stages, engine, &self.name("give-up"))?;
                if taken.contains(&stage) {
                    return Err(refused(
                        format!(
                            "{} '{text}' is for stage {}, which has one already",
                            self.name("give-up"),
                            stage + 1
                        ),
                        "give one for each stage",
                    ));
                }
                taken.push(stage);
                give_up::put(&mut list, stage, given);
            }
            task.give_up = list;
        }
        if !self.cancel.is_empty() {
            let orders = |text: &String| option::cancel(text, engine, &self.name("cancel"));
            let lists: Vec<_> = self.cancel.iter().map(orders).collect::<Result<_, _>>()?;
            (task.cancel, task.stages, task.limits) = (lists.concat(), Vec::new(), Vec::new());
            task.give_up.clear();
        }
        let limits = self.limits.iter().map(|text| option::limit(text, engine, &self.name("limit")));
        let budget = self.budget.iter().map(|text| option::budget(text, &self.name("budget")));
        for limit in limits.chain(budget).collect::<Vec<_>>() {
            let limit = limit?;
            task.limits.retain(|known| known.criterion != limit.criterion);
            task.limits.push(limit);
        }
        if !self.maximise.is_empty() {
            let read = |text: &String| DurabilityCriterion::read(text, engine);
            task.durability.maximise = self.maximise.iter().map(read).collect::<Result<_, _>>()?;
        }
        for text in &self.at_least {
            let own = AtLeast::read(text, engine, &self.name("at-least"))?;
            task.durability.at_least.retain(|known| known.criterion != own.criterion);
            task.durability.at_least.push(own);
        }
        if !self.speeds.is_empty() {
            if !engine.is_on_springs() && !task.counts_gas() && task.durability.is_empty() {
                return Err(refused(
                    format!(
                        "{} has no effect: no mount of the engine has springs, and no criterion counts the gas",
                        self.name("speed")
                    ),
                    "leave it out: all other loads are largest at the highest speed",
                ));
            }
            if !task.counts_mounts() && !task.counts_gas() && task.durability.is_empty() {
                return Err(refused(
                    format!(
                        "{} has no effect: neither a mount force nor a load with gas is minimised or limited",
                        self.name("speed")
                    ),
                    "name one, such as \"mount force\", or leave it out: all other loads are largest at the highest speed",
                ));
            }
            let speed = |text: &String| weighted_speed(text, &self.name("speed"));
            task.judge_at(&self.speeds.iter().map(speed).collect::<Result<Vec<_>, _>>()?);
            if let Some(place) = task.speeds.iter().position(|speed| !engine.speed.holds(*speed)) {
                return Err(refused(
                    format!(
                        "the engine does not run at {}, as {} asks",
                        self.speeds[place],
                        self.name("speed")
                    ),
                    "give a speed between the lowest and the highest of `speed`",
                ));
            }
        }
        Ok(())
    }

    /// A largest amount that cannot be read, with the word that it may be meant to be.
    fn or_what_fits(&self, bad: BadQuantity) -> BadQuantity {
        let is_near = self.most.as_ref().is_some_and(|most| nearest(most, [WHAT_FITS].into_iter()).is_some());
        let hint =
            if is_near { format!("did you mean {} '{WHAT_FITS}'?", self.name("most")) } else { bad.hint };
        BadQuantity { hint, ..bad }
    }

    /// Bounds the weights on crankshafts, and says how many optional devices may be used.
    fn bound_crank_weights(&self, task: &mut BalanceTask) -> Result<(), BadQuantity> {
        let amount = |text: &Option<String>, option: &str| {
            text.as_ref().map(|text| option::unbalance(text, &self.name(option))).transpose()
        };
        let fits = self.most.as_ref().is_some_and(|text| text.trim() == WHAT_FITS);
        let most =
            if fits { None } else { amount(&self.most, "most").map_err(|bad| self.or_what_fits(bad))? };
        let least = amount(&self.least, "least")?;
        let followers: Vec<usize> = task.ties.iter().map(|tie| tie.second).collect();
        for (index, weight) in task.weights.iter_mut().enumerate() {
            if !matches!(weight.seat, Seat::Crankshaft(_)) {
                continue;
            }
            if fits {
                (weight.most, weight.fits) = (None, true);
            } else if most.is_some() {
                (weight.most, weight.fits) = (most, false);
            }
            // A follower does what its leader does.
            if !followers.contains(&index) {
                weight.least = least.unwrap_or(weight.least);
                weight.optional |= self.optional;
                if let Some(step) = &self.step {
                    let step = option::mass_or_unbalance(step, weight.radius, &self.name("weight-step"))?;
                    let ends = weight.most.filter(|most| *most < step * (1.0 - 1e-9));
                    if ends.is_some() {
                        return Err(refused(
                            format!(
                                "{} is larger than the largest amount of \"{}\"",
                                self.name("weight-step"),
                                weight.name
                            ),
                            "give a smaller step, or a larger largest amount",
                        ));
                    }
                    (weight.catalogue, weight.drill) = (Some(Catalogue::Steps(step)), None);
                }
                if self.equal_parts && weight.catalogue.is_none() {
                    return Err(refused(
                        format!(
                            "{} has no effect on \"{}\": it has any amount",
                            self.name("equal-parts"),
                            weight.name
                        ),
                        &format!("add {} '200 g mm'", self.name("weight-step")),
                    ));
                }
                if self.equal_parts {
                    weight.equal_parts = Some("counterweight".into());
                }
            }
        }
        let Some(most) = self.most_optional else { return Ok(()) };
        let shafts = task.shafts.iter().any(|shaft| shaft.optional);
        if !shafts && !task.weights.iter().any(|w| w.optional) && !task.inertias.iter().any(|i| i.optional) {
            return Err(refused(
                format!("{} counts optional devices, and nothing is optional", self.name("most-optional")),
                &format!(
                    "add {} for the weights on the crank, or write a shaft like {} '-1 @ 0 mm, 100 mm @ 0 mm @ optional, most 0.02 kg m'",
                    self.name("optional"),
                    self.name("shaft")
                ),
            ));
        }
        task.most_optional = Some(most);
        Ok(())
    }

    /// Drops the free weights on crankshafts with their ties, and sets those asked for in their place.
    fn replace_crank_weights(
        &self,
        engine: &Engine,
        task: &mut BalanceTask,
        places: CrankWeightPlaces,
    ) -> Result<(), BadQuantity> {
        task.keep_weights(|weight| matches!(weight.seat, Seat::Shaft(_)));
        let weights = crank_weights(engine, places);
        if weights.is_empty() && places != CrankWeightPlaces::None {
            let option = self.name("counterweights");
            return Err(match places {
                CrankWeightPlaces::Webs => refused(
                    format!("{option} webs needs the places of the webs, and the file does not give them"),
                    "add web_distance to [crank]",
                ),
                _ => refused(
                    format!("{option} file needs counterweights in the file, and it has none"),
                    &format!("{option} throws puts one in the plane of every throw"),
                ),
            });
        }
        task.weights.extend(weights);
        Ok(())
    }
}

fn refused(message: String, hint: &str) -> BadQuantity {
    BadQuantity { message, hint: hint.into() }
}
