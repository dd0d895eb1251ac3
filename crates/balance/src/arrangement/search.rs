//! The search: every candidate's best weights, its place, drive, bearings and price.

use crate::arrangement::bearing::bearing_loads;
use crate::arrangement::candidate::{Candidate, candidates, components, is_searched, load_scale, task};
use crate::arrangement::drive::DriveLoad;
use crate::arrangement::envelope::Envelope;
use crate::arrangement::front::{mark_front, simplest};
use crate::arrangement::half_disc::{HalfDisc, cylinder_mass};
use crate::arrangement::placement::{Ground, Placement, Tenant};
use crate::arrangement::request::{ArrangementRequest, Judged, MountPlaces, Target};
use crate::arrangement::result::*;
use crate::arrangement::spacing::extent;
use crate::arrangement::wording;
use crate::consequences::inside_the_crank;
use crate::{Answer, BalanceError, Outcome, as_it_stands, fitted, optimise};
use lanchester_model::{Engine, EngineParts, Mount};
use lanchester_task::{BalanceTask, Criterion, Limit, Load, Place, Seat, Stage};
use num_complex::Complex64;

/// A residual this share above the limit still reaches it.
const REACHED: f64 = 1e-6;

/// Weights lighter by less than this share are no arrangement of their own.
const WORTHWHILE: f64 = 1e-3;

/// Spacings that differ by less than this share are the same.
const SAME_SPACING: f64 = 1e-9;

/// How often weights may ask for another place and places for other weights, where both depend on one another.
const ROUNDS: usize = 6;

/// Room on a shaft between a weight and the bearing beside it [m].
const BEARING_GAP: f64 = 0.01;

/// Every arrangement of crank weights and balance shafts that the request allows and the engine can use, each at its
/// best, with drive and price, and the Pareto front.
///
/// Balance shafts of the engine file are taken out first, and crank weights that an earlier search put into it: the
/// search is about which ones to fit. Its other counterweights stay.
///
/// # Errors
/// [`BalanceError`] where a number of the request has no meaning, the mounts are missing, the reference has nothing
/// to compare with, or the engine's loads cannot be computed. A limit that nobody reaches and a shaft without a place
/// are part of the answer.
pub fn arrangements(engine: &Engine, request: &ArrangementRequest) -> Result<Arrangements, BalanceError> {
    request.check()?;
    let (limit, limit_source) = limit(request)?;
    let own_spacing = engine.spacing();
    let mut spacings = Vec::new();
    for scale in scales(request, own_spacing)? {
        let searched = searched_engine(engine, request, scale)?;
        spacings.push(Search::new(&searched, request, limit).run(scale, own_spacing.map(|s| s * scale))?);
    }
    let nearest = limit.and_then(|limit| nearest(&spacings, request, limit));
    Ok(Arrangements {
        version: ARRANGEMENTS_VERSION,
        engine: engine.name.clone(),
        criterion: request.criterion,
        speed: engine.speed.highest,
        limit,
        limit_source,
        assumptions: wording::assumptions(engine, request),
        spacings,
        nearest,
    })
}

/// The engine that arrangements are fitted to: no balance shafts, the mounts of the request, and every z of throws,
/// cylinders and counterweights times `scale` ([`SpacingArrangements::scale`]).
///
/// # Errors
/// [`BalanceError::Engine`] where there is no such engine: a scale that is not positive, a mount that stands nowhere.
pub fn searched_engine(
    engine: &Engine,
    request: &ArrangementRequest,
    scale: f64,
) -> Result<Engine, BalanceError> {
    let searched = engine.stretched(scale).map_err(BalanceError::engine)?;
    let change = |parts: &mut EngineParts| {
        parts.shafts.clear();
        parts.counterweights.retain(|weight| !is_searched(&weight.name));
        parts.mounts = mounts(engine, request);
    };
    searched.with(change).map_err(BalanceError::engine)
}

/// Scales of all z for the spacings of the request.
fn scales(request: &ArrangementRequest, own: Option<f64>) -> Result<Vec<f64>, BalanceError> {
    // The engine's own spacing is a difference of planes.
    let rounded = |scale: f64| if (scale - 1.0).abs() < SAME_SPACING { 1.0 } else { scale };
    match (&request.spacings[..], own) {
        ([], _) => Ok(vec![1.0]),
        (wanted, Some(own)) => Ok(wanted.iter().map(|s| rounded(s / own)).collect()),
        (_, None) => Err(BalanceError::Missing {
            criterion: "another cylinder spacing".to_owned(),
            needed: "throws or cylinders in more than one plane",
            hint: "leave the spacings out",
        }),
    }
}

/// The mounts that count.
fn mounts(engine: &Engine, request: &ArrangementRequest) -> Vec<Mount> {
    match request.mounts {
        MountPlaces::Engine => engine.mounts.clone(),
        MountPlaces::Spacing(apart) => [("front", -0.5), ("rear", 0.5)]
            .map(|(name, side)| Mount {
                name: name.to_owned(),
                x: 0.0,
                y: 0.0,
                z: side * apart,
                spring: None,
            })
            .to_vec(),
    }
}

/// The value that is good enough, and where it comes from.
fn limit(request: &ArrangementRequest) -> Result<(Option<f64>, Option<String>), BalanceError> {
    let name = request.criterion.name();
    match &request.target {
        Target::None => Ok((None, None)),
        Target::Limit { most } => Ok((Some(*most), Some("as asked for".to_owned()))),
        Target::Reference { engine, share } => {
            let reference =
                engine.with(|parts| parts.mounts = mounts(engine, request)).map_err(BalanceError::engine)?;
            let value = share * as_it_stands(&reference, request.criterion.criterion())?;
            // Below this share of its moving masses' largest load it does not shake at all.
            let scale = load_scale(&reference);
            let scale = if request.criterion == Judged::Couple { scale[1] } else { scale[0] };
            if value > 1e-6 * share * scale {
                return Ok((Some(value), Some(wording::share_of(*share, name, &engine.name))));
            }
            Err(BalanceError::Missing {
                criterion: format!("comparing the {name} with {}", engine.name),
                needed: "a reference that shakes in this way, and its value is 0",
                hint: "choose another criterion, or give a limit",
            })
        }
    }
}

/// What an answer leaves of a criterion.
fn after(answer: &Answer, criterion: Criterion) -> f64 {
    answer.effects.iter().find(|e| e.criterion == criterion).map_or(f64::NAN, |e| e.after)
}

/// How close the best comes, where nobody reaches the limit.
fn nearest(spacings: &[SpacingArrangements], request: &ArrangementRequest, limit: f64) -> Option<Nearest> {
    if spacings.iter().any(|s| s.simplest.is_some()) {
        return None;
    }
    let all = spacings.iter().enumerate().flat_map(|(spacing, s)| {
        let possible = s.arrangements.iter().enumerate().filter(|(_, a)| a.possible);
        possible.map(move |(arrangement, a)| (spacing, arrangement, a.residual))
    });
    let (spacing, arrangement, residual) = all.min_by(|a, b| a.2.total_cmp(&b.2))?;
    let best = &spacings[spacing];
    let reason =
        wording::nearest(request, &best.arrangements[arrangement].name, best.spacing, residual, limit);
    Some(Nearest { spacing, arrangement, residual, reason })
}

/// What the weights of an arrangement are chosen for.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Aim {
    /// The smallest residual, then the lightest weights that leave it.
    Smallest,
    /// The lightest weights that leave no more than this.
    Lightest {
        /// Limit of the criterion.
        most: f64,
    },
}

/// The search at one spacing.
struct Search<'a> {
    engine: &'a Engine,
    request: &'a ArrangementRequest,
    limit: Option<f64>,
    /// Whether what is judged or limited depends on where shafts stand across the crank.
    place_matters: bool,
    /// Length that the weights of a shaft may have [m]: alone on their shaft, and two of them.
    room: [f64; 2],
}

/// The parts of one shaft, before it has a place.
struct SizedShaft {
    /// Planes and unbalances.
    weights: Vec<(f64, Complex64)>,
    discs: Vec<HalfDisc>,
    sweep: f64,
    bearing_planes: [f64; 2],
}

impl<'a> Search<'a> {
    fn new(engine: &'a Engine, request: &'a ArrangementRequest, limit: Option<f64>) -> Search<'a> {
        let [front, rear] = extent(engine.cylinders.iter().map(|c| c.z));
        let bore = engine.cylinders.iter().filter_map(|c| c.bore).fold(0.0f64, f64::max);
        let radius = engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
        let length = rear - front + if bore > 0.0 { bore } else { 1.8 * radius };
        let room = [length / 2.0, length / 3.0];
        let mut search = Search { engine, request, limit, place_matters: false, room };
        let limits = request.limits.iter().map(|l| l.criterion);
        search.place_matters =
            limits.chain([request.criterion.criterion()]).any(|criterion| search.sees_place(&criterion));
        search
    }

    /// Whether a criterion depends on where shafts stand across the crank: mounts on the crank's own axis carry no
    /// roll moment.
    fn sees_place(&self, criterion: &Criterion) -> bool {
        match criterion {
            Criterion::Peak(load) | Criterion::Order(load, _) => match load {
                Load::RollMoment => true,
                load if load.is_at_mounts() => self.engine.mounts.iter().any(|m| m.x.hypot(m.y) > 1e-9),
                _ => false,
            },
            Criterion::MainRms(_) | Criterion::MainMean(_) | Criterion::MainsWithGas(..) => false,
            Criterion::AddedMass | Criterion::AddedUnbalance | Criterion::Cost => false,
        }
    }

    fn run(&self, scale: f64, spacing: Option<f64>) -> Result<SpacingArrangements, BalanceError> {
        let components = components(self.engine, &self.request.shaft_orders)?;
        let (candidates, mut left_out) = candidates(self.engine, self.request, &components);
        let envelope = Envelope::of(self.engine, &self.request.parts);
        let mut ground = Ground::new(&envelope, self.request);
        // What all devices together leave: who reaches it needs no more of them.
        let most = candidates.iter().max_by_key(|c| (c.shafts.len(), c.crank)).cloned();
        let fullest =
            most.map(|c| self.arrange(&c, &mut ground, Aim::Smallest).map(|a| (c, a))).transpose()?;
        let floor =
            fullest.as_ref().map_or(0.0, |(_, a)| a.answer.stages.first().map_or(0.0, |s| s.lower_bound));
        let mut examined: Vec<(Candidate, Arrangement, Option<Arrangement>)> =
            Vec::with_capacity(candidates.len());
        for candidate in candidates {
            let enough = examined.iter().find(|(smaller, a, _)| {
                !self.place_matters
                    && candidate.contains(smaller)
                    && a.possible
                    && a.residual <= floor * (1.0 + REACHED)
            });
            if let Some((_, smaller, _)) = enough {
                left_out.push(wording::enough(&candidate.name(), &smaller.name));
                continue;
            }
            let arrangement = match &fullest {
                Some((known, arrangement)) if *known == candidate => arrangement.clone(),
                _ => self.arrange(&candidate, &mut ground, Aim::Smallest)?,
            };
            // Where fewer devices do, lighter weights of more devices are no use.
            let needed = !examined.iter().any(|(smaller, a, _)| {
                a.possible && a.reaches_limit == Some(true) && candidate.contains(smaller)
            });
            let lightest = if needed { self.lightest(&candidate, &arrangement, &mut ground)? } else { None };
            examined.push((candidate, arrangement, lightest));
        }
        let mut arrangements: Vec<Arrangement> =
            examined.into_iter().flat_map(|(_, a, lightest)| std::iter::once(a).chain(lightest)).collect();
        let (left, roll) = arrangements.first().map_or((0.0, 0.0), |a| (a.residual, a.roll_moment));
        // Where nothing added breaks a further limit it has no residual.
        let baseline = if left.is_finite() {
            left
        } else {
            as_it_stands(self.engine, self.request.criterion.criterion())?
        };
        let front = mark_front(&mut arrangements, baseline, roll);
        let simplest = self.limit.and_then(|_| simplest(&arrangements));
        Ok(SpacingArrangements { spacing, scale, baseline, arrangements, front, simplest, left_out })
    }

    /// The same devices with the lightest weights that hold the limit, where they are lighter than those of the
    /// smallest residual.
    fn lightest(
        &self,
        candidate: &Candidate,
        smallest: &Arrangement,
        ground: &mut Ground<'_>,
    ) -> Result<Option<Arrangement>, BalanceError> {
        let Some(limit) = self.limit.filter(|_| {
            smallest.possible && smallest.reaches_limit == Some(true) && smallest.price.weights > 0
        }) else {
            return Ok(None);
        };
        // A limit that can only just be held would have no inner point.
        let most = limit.max(smallest.residual) * (1.0 + 0.5 * REACHED);
        let lightest = self.arrange(candidate, ground, Aim::Lightest { most })?;
        let lighter = lightest.price.unbalance < smallest.price.unbalance * (1.0 - WORTHWHILE);
        Ok((lightest.possible && lightest.reaches_limit == Some(true) && lighter).then_some(lightest))
    }

    /// What the weights of a candidate are chosen for, with its shafts at these places.
    fn task(&self, candidate: &Candidate, places: &[Complex64], aim: Aim) -> BalanceTask {
        let mut task = task(self.engine, self.request, candidate, places);
        if let Aim::Lightest { most } = aim {
            task.limits.push(Limit { criterion: self.request.criterion.criterion(), most });
            task.stages = vec![Stage { terms: vec![(1.0, Criterion::AddedUnbalance)] }];
        }
        task
    }

    /// The best weights. Where a later stage is too flat to be solved, what comes before it stands.
    fn solved(&self, mut task: BalanceTask) -> Result<Answer, BalanceError> {
        let mut answer = optimise(self.engine, &task)?;
        while matches!(answer.outcome, Outcome::Stopped { .. })
            && answer.weights.is_empty()
            && !task.weights.is_empty()
            && task.stages.len() > 1
        {
            task.stages.pop();
            answer = optimise(self.engine, &task)?;
        }
        Ok(answer)
    }

    /// One arrangement: weights, places, drive, price.
    fn arrange(
        &self,
        candidate: &Candidate,
        ground: &mut Ground<'_>,
        aim: Aim,
    ) -> Result<Arrangement, BalanceError> {
        let place_matters = self.place_matters && !candidate.shafts.is_empty();
        let mut task_now = self.task(candidate, &[], aim);
        if place_matters {
            // Before the places are known these limits have no meaning.
            task_now.limits.retain(|l| !self.sees_place(&l.criterion));
        }
        let mut answer = self.solved(task_now)?;
        let mut sized = self.sized(candidate, &answer);
        let mut sweeps: Vec<f64> = sized.iter().map(|s| s.sweep).collect();
        let mut placed = self.placed(candidate, &sized, &sweeps, ground);
        let mut settled = !place_matters;
        for _ in 0..ROUNDS {
            let Some(Ok(placement)) = placed.as_ref().filter(|_| !settled) else { break };
            answer = self.solved(self.task(candidate, &placement.places, aim))?;
            sized = self.sized(candidate, &answer);
            // Lighter weights fit where heavier ones did; heavier ones need a place of their own, and there new weights.
            settled = sized.iter().zip(&sweeps).all(|(new, room)| new.sweep <= *room);
            if !settled {
                sweeps = sized.iter().zip(&sweeps).map(|(new, room)| new.sweep.max(*room)).collect();
                placed = self.placed(candidate, &sized, &sweeps, ground);
            }
        }
        // Weights for one place are none for another.
        let placed = placed.map(|placement| {
            placement.and_then(|p| if settled { Ok(p) } else { Err(wording::no_settled_place()) })
        });
        self.priced(candidate, aim, answer, sized, placed)
    }

    /// Sizes of the weights of every shaft.
    fn sized(&self, candidate: &Candidate, answer: &Answer) -> Vec<SizedShaft> {
        let parts = &self.request.parts;
        (0..candidate.shafts.len())
            .map(|index| {
                let on_shaft = answer.task.weights.iter().zip(&answer.weights);
                let weights: Vec<(f64, Complex64)> = on_shaft
                    .filter(|(free, _)| free.seat == Seat::Shaft(index))
                    .map(|(_, found)| (found.z, found.unbalance))
                    .collect();
                let room = self.room[usize::from(weights.len() > 1)];
                let largest = weights.iter().map(|w| w.1.norm()).fold(0.0, f64::max);
                let needed = HalfDisc::radius_for(largest, room, parts.density);
                // Whole millimetres, and a rim around the shaft.
                let rule = (needed.max(1.5 * parts.shaft_radius) * 1e3 - 1e-6).ceil() * 1e-3;
                let sweep = parts.weight_sweep.unwrap_or(rule);
                let discs: Vec<HalfDisc> =
                    weights.iter().map(|w| HalfDisc::of(w.1.norm(), sweep, parts.density)).collect();
                let bearing_planes = parts.bearing_planes.unwrap_or_else(|| {
                    let ends = weights.iter().zip(&discs);
                    let [front, rear] =
                        extent(ends.flat_map(|(w, d)| [w.0 - 0.5 * d.length, w.0 + 0.5 * d.length]));
                    [front - BEARING_GAP, rear + BEARING_GAP]
                });
                SizedShaft { weights, discs, sweep, bearing_planes }
            })
            .collect()
    }

    /// Places and drive for shafts that have this much room; `None` without shafts.
    fn placed(
        &self,
        candidate: &Candidate,
        sized: &[SizedShaft],
        sweeps: &[f64],
        ground: &mut Ground<'_>,
    ) -> Option<Result<Placement, Clearance>> {
        if sized.is_empty() {
            return None;
        }
        let tenants: Vec<Tenant> = candidate
            .shafts
            .iter()
            .zip(sized.iter().zip(sweeps))
            .map(|(shaft, (sized, &sweep))| {
                let speed = f64::from(shaft.ratio) * self.engine.speed.highest;
                let unbalance: Complex64 = sized.weights.iter().map(|w| w.1).sum();
                Tenant { ratio: shaft.ratio, sweep, force: unbalance * speed * speed }
            })
            .collect();
        Some(ground.place(&tenants))
    }

    fn priced(
        &self,
        candidate: &Candidate,
        aim: Aim,
        mut answer: Answer,
        sized: Vec<SizedShaft>,
        placed: Option<Result<Placement, Clearance>>,
    ) -> Result<Arrangement, BalanceError> {
        // An arrangement of nothing has no stages but loads all the same.
        let empty = answer.task.weights.is_empty();
        let found =
            !matches!(answer.outcome, Outcome::Infeasible { .. }) && (empty || !answer.weights.is_empty());
        let places: Vec<Complex64> = match &placed {
            Some(Ok(placement)) => placement.places.clone(),
            _ => vec![Complex64::ZERO; candidate.shafts.len()],
        };
        let speed = self.engine.speed.highest;
        let parts = &self.request.parts;
        let shafts: Vec<ArrangedShaft> = (candidate.shafts.iter().zip(&sized).zip(&places))
            .enumerate()
            .map(|(index, ((shaft, sized), place))| {
                let [front, rear] = sized.bearing_planes;
                let shaft_mass = cylinder_mass(parts.shaft_radius, rear - front, parts.density);
                let own = 0.5 * shaft_mass * parts.shaft_radius.powi(2);
                ArrangedShaft {
                    name: candidate.shaft_name(index),
                    ratio: shaft.ratio,
                    layout: shaft.layout,
                    x: place.re,
                    y: place.im,
                    weight_sweep: sized.sweep,
                    weight_length: sized.discs.iter().map(|d| d.length).fold(0.0, f64::max),
                    weight_mass: sized.discs.iter().map(|d| d.mass).sum(),
                    shaft_mass,
                    inertia: own + sized.discs.iter().map(HalfDisc::inertia).sum::<f64>(),
                    bearing_planes: sized.bearing_planes,
                    bearing_loads: bearing_loads(
                        &sized.weights,
                        sized.bearing_planes,
                        f64::from(shaft.ratio) * speed,
                    ),
                }
            })
            .collect();
        let drive = match &placed {
            Some(Ok(placement)) => Some(&placement.drive),
            _ => None,
        };
        let price = self.price(candidate, &answer, &shafts, drive);
        for (index, place) in places.iter().enumerate() {
            (answer.task.shafts[index].x, answer.task.shafts[index].y) =
                (Place::At(place.re), Place::At(place.im));
            if let Some(shaft) = answer.shafts.get_mut(index) {
                (shaft.x, shaft.y) = (place.re, place.im);
            }
        }
        let balanced = fitted(self.engine, &answer);
        let [force, couple, roll_moment] = crate::arrangement::peaks::peaks(&balanced)?;
        for effect in answer.effects.iter_mut().filter(|e| e.criterion == Criterion::Peak(Load::RollMoment)) {
            effect.after = roll_moment;
        }
        let [main_load, bending_moment] = inside_the_crank(&balanced)?;
        let residual = if found { after(&answer, self.request.criterion.criterion()) } else { f64::NAN };
        let clearance = placed.as_ref().map(|p| match p {
            Ok(placement) => placement.clearance.clone(),
            Err(clearance) => clearance.clone(),
        });
        let possible = found && !matches!(placed, Some(Err(_)));
        Ok(Arrangement {
            name: match aim {
                Aim::Smallest => candidate.name(),
                Aim::Lightest { .. } => wording::lightest(&candidate.name()),
            },
            label: match aim {
                Aim::Smallest => candidate.label(),
                Aim::Lightest { .. } => wording::lightest_label(&candidate.label()),
            },
            lightest: aim != Aim::Smallest,
            crank_weights: candidate.crank,
            shafts,
            residual,
            reaches_limit: self.limit.map(|limit| residual <= limit * (1.0 + REACHED)),
            force,
            couple,
            roll_moment,
            main_load,
            bending_moment,
            drive: placed.and_then(Result::ok).map(|p| p.drive),
            clearance,
            price,
            possible,
            on_front: false,
            answer,
        })
    }

    fn price(
        &self,
        candidate: &Candidate,
        answer: &Answer,
        shafts: &[ArrangedShaft],
        drive: Option<&DriveTrain>,
    ) -> Price {
        let (parts, speed) = (&self.request.parts, self.engine.speed.highest);
        let radius = self.engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
        let radius = parts.crank_weight_radius.unwrap_or(radius);
        let on_crank = answer.task.weights.iter().zip(&answer.weights);
        let crank: f64 = on_crank
            .filter(|(free, _)| matches!(free.seat, Seat::Crankshaft(_)))
            .map(|(_, found)| found.unbalance.norm() / radius)
            .fold(0.0, |sum, mass| sum + mass);
        let mut price = Price {
            shafts: candidate.shafts.len(),
            weights: answer.weights.len(),
            bearings: 2 * shafts.len(),
            unbalance: answer.weights.iter().fold(0.0, |sum, w| sum + w.unbalance.norm()),
            weight_mass: shafts.iter().fold(crank, |sum, s| sum + s.weight_mass),
            drive_mass: shafts.iter().fold(0.0, |sum, s| sum + s.shaft_mass),
            inertia: shafts
                .iter()
                .fold(crank * radius * radius, |sum, s| sum + f64::from(s.ratio * s.ratio) * s.inertia),
            bearing_load: shafts.iter().flat_map(|s| s.bearing_loads).fold(0.0, f64::max),
            ..Price::default()
        };
        let Some(drive) = drive else { return price };
        price.meshes = drive.links.iter().filter(|l| !l.chain).count();
        price.chains = drive.links.len() - price.meshes;
        price.idlers = drive.gears.iter().filter(|g| g.seat == GearSeat::Idler).count();
        price.bearings += price.idlers;
        for gear in &drive.gears {
            let radius = 0.5 * gear.pitch_diameter;
            let mass = cylinder_mass(radius, parts.gear_width, parts.density);
            price.drive_mass += mass;
            price.inertia += 0.5 * mass * (radius * gear.ratio).powi(2);
        }
        let friction: Vec<f64> = shafts
            .iter()
            .map(|s| {
                let load: f64 = s.bearing_loads.iter().sum();
                parts.bearing_friction * load * parts.shaft_radius * f64::from(s.ratio.abs()) * speed
            })
            .collect();
        let DriveLoad { power, torque } = drive.load(&friction, parts.mesh_efficiency, speed);
        (price.drive_power, price.drive_torque) = (power, torque);
        price
    }
}
