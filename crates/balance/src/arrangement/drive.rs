//! Gears (and chains or belts) between crank and balance shafts: fewest meshes, then what fits.
//!
//! All axes stand still, so that ratio and distance give the pitch radii of two gears that mesh:
//!
//! ```text
//! R_a + R_b = d,  R_a n_a = R_b n_b                 R_a = d n_b/(n_a + n_b)
//! idler of radius R_i between them:  |p_i - p_a| = R_a + R_i,  |p_i - p_b| = R_b + R_i
//! ```
//! A mesh turns the sense of rotation; so does not a chain or belt. Gears run in planes beyond the end of the crank,
//! gears of one shaft with different radii in planes of their own. A shaft, and the stud of an idler, ends in the outermost
//! plane that it has a gear in; the crankshaft goes through all of them, to its pulley or flywheel. Every gear must clear the other gears of its plane and all axes that go farther out. The
//! planes are ordered so that they do, where they can.

use crate::arrangement::request::{DriveRule, PartSizes};
use crate::arrangement::result::{Clearance, DriveLink, DriveTrain, Gear, GearSeat};
use num_complex::Complex64;

/// Fewest teeth of a gear: below, the standard 20 deg tooth is undercut.
const FEWEST_TEETH: f64 = 17.0;

/// Shares of the axis distance that the end gears of an idler train fill where nothing else sets them.
const END_GEARS: [f64; 3] = [0.6, 0.75, 0.45];

/// Idlers: radius over that of one on the line between the two axes.
const IDLER_SIZES: [f64; 4] = [1.0, 1.2, 1.5, 2.0];

/// Tip of a tooth above its pitch circle, in modules.
const ADDENDUM: f64 = 1.0;

/// Root of a tooth below its pitch circle, in modules.
const DEDENDUM: f64 = 1.25;

/// How one shaft is driven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Coupling {
    /// Gears with so many idlers between.
    Idlers(usize),
    /// A chain or belt.
    Chain,
}

/// Which shaft drives which: parent and coupling of every shaft, node 0 the crank, node k + 1 shaft k.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DriveTree {
    edges: Vec<(usize, usize, Coupling)>,
    /// Meshes of the whole tree.
    pub meshes: usize,
    chains: usize,
}

/// All ways to drive shafts of these ratios, fewest meshes first.
pub(crate) fn drive_trees(ratios: &[i32], rule: DriveRule) -> Vec<DriveTree> {
    let count = ratios.len();
    let sense = |node: usize| if node == 0 { 1 } else { ratios[node - 1].signum() };
    let mut trees = Vec::new();
    for code in 0..(count + 1).pow(count as u32) {
        let parent: Vec<usize> = (0..count).map(|k| code / (count + 1).pow(k as u32) % (count + 1)).collect();
        let Some(order) = from_the_crank(&parent) else { continue };
        for detour in [0, 2] {
            let edges: Vec<_> = order
                .iter()
                .map(|&node| {
                    let driver = parent[node - 1];
                    let coupling = match (sense(driver) == sense(node), rule) {
                        (true, DriveRule::Gears) => Coupling::Idlers(1),
                        (true, DriveRule::ChainOrBelt) => Coupling::Chain,
                        (false, _) => Coupling::Idlers(detour),
                    };
                    (driver, node, coupling)
                })
                .collect();
            let tally = |of: &dyn Fn(Coupling) -> usize| edges.iter().map(|e| of(e.2)).sum();
            let meshes = tally(&|c| if let Coupling::Idlers(count) = c { count + 1 } else { 0 });
            let chains = tally(&|c| usize::from(c == Coupling::Chain));
            trees.push(DriveTree { edges, meshes, chains });
        }
    }
    trees.sort_by_key(|t| (t.meshes + t.chains, t.chains));
    trees.dedup();
    trees
}

/// Shafts in an order in which every driver comes before what it drives; `None` if some drive one another in a ring.
fn from_the_crank(parent: &[usize]) -> Option<Vec<usize>> {
    let mut order: Vec<usize> = Vec::with_capacity(parent.len());
    while order.len() < parent.len() {
        let next = (1..=parent.len())
            .find(|n| !order.contains(n) && (parent[n - 1] == 0 || order.contains(&parent[n - 1])))?;
        order.push(next);
    }
    Some(order)
}

/// Where the axes are.
pub(crate) struct Axes<'a> {
    /// Positions of the shafts.
    pub places: &'a [Complex64],
    /// Their speeds over that of crankshaft 1.
    pub ratios: &'a [i32],
    /// Radius of the crankshaft where gears run past it [m].
    pub journal_radius: f64,
    /// Sizes.
    pub parts: &'a PartSizes,
}

impl Axes<'_> {
    fn place(&self, node: usize) -> Complex64 {
        if node == 0 { Complex64::ZERO } else { self.places[node - 1] }
    }

    fn speed(&self, node: usize) -> f64 {
        if node == 0 { 1.0 } else { f64::from(self.ratios[node - 1]) }
    }

    fn seat(node: usize) -> GearSeat {
        if node == 0 { GearSeat::Crank } else { GearSeat::Shaft(node - 1) }
    }

    /// The drive of one tree with its narrowest place.
    pub fn drive(&self, tree: &DriveTree) -> (DriveTrain, Clearance) {
        let mut train = DriveTrain { gears: Vec::new(), links: Vec::new(), planes: 0 };
        for &(driver, node, coupling) in &tree.edges {
            match coupling {
                Coupling::Idlers(0) => self.mesh(&mut train, driver, node),
                Coupling::Idlers(1) => self.idle(&mut train, driver, node),
                Coupling::Idlers(_) => self.idle_twice(&mut train, driver, node),
                Coupling::Chain => self.chain(&mut train, driver, node),
            }
        }
        let clearance = self.order_planes(&mut train);
        (train, clearance)
    }

    /// Orders the gear planes so that all parts clear, or else come least into each other's way.
    fn order_planes(&self, train: &mut DriveTrain) -> Clearance {
        let mut order: Vec<usize> = (1..=train.planes).collect();
        let mut best = (self.clearance(train), train.clone());
        // Heap's method: all orders, one exchange a step.
        let mut state = vec![0; order.len()];
        let mut depth = 1;
        let original = train.clone();
        while depth < order.len() && best.0.distance < self.parts.clearance {
            if state[depth] < depth {
                order.swap(if depth % 2 == 0 { 0 } else { state[depth] }, depth);
                let mut trial = original.clone();
                trial.gears.iter_mut().for_each(|g| g.plane = order[g.plane - 1]);
                let clearance = self.clearance(&trial);
                if clearance.distance > best.0.distance {
                    best = (clearance, trial);
                }
                state[depth] += 1;
                depth = 1;
            } else {
                state[depth] = 0;
                depth += 1;
            }
        }
        *train = best.1;
        best.0
    }

    /// The gear of this radius on `node`: one that is there already, or a new one in a new plane.
    fn gear(&self, train: &mut DriveTrain, node: usize, radius: f64) -> usize {
        let seat = Axes::seat(node);
        let same = |g: &Gear| g.seat == seat && (0.5 * g.pitch_diameter - radius).abs() < 1e-6;
        train.gears.iter().position(same).unwrap_or_else(|| {
            train.planes += 1;
            let plane = train.planes;
            self.add(train, seat, self.place(node), radius, self.speed(node), plane)
        })
    }

    fn add(
        &self,
        train: &mut DriveTrain,
        seat: GearSeat,
        place: Complex64,
        radius: f64,
        ratio: f64,
        plane: usize,
    ) -> usize {
        let gear = Gear { seat, x: place.re, y: place.im, pitch_diameter: 2.0 * radius, ratio, plane };
        train.gears.push(gear);
        train.gears.len() - 1
    }

    fn link(train: &mut DriveTrain, chain: bool, path: &[usize]) {
        train.links.extend(path.windows(2).map(|w| DriveLink { driver: w[0], driven: w[1], chain }));
    }

    /// Two gears that mesh.
    fn mesh(&self, train: &mut DriveTrain, driver: usize, node: usize) {
        let distance = (self.place(node) - self.place(driver)).norm();
        let (own, other) = (self.speed(driver).abs(), self.speed(node).abs());
        let radius = distance * other / (own + other);
        let first = self.gear(train, driver, radius);
        let plane = train.gears[first].plane;
        let place = self.place(node);
        let second = self.add(train, Axes::seat(node), place, distance - radius, self.speed(node), plane);
        Axes::link(train, false, &[first, second]);
    }

    /// Two gears with an idler between: of gears that the driver has already and new ones the first that clears, with
    /// the idler on the line or beside it that leaves most room.
    fn idle(&self, train: &mut DriveTrain, driver: usize, node: usize) {
        let (from, to) = (self.place(driver), self.place(node));
        let distance = (to - from).norm();
        let (own, other) = (self.speed(driver).abs(), self.speed(node).abs());
        let fresh = END_GEARS.map(|share| share * distance * other / (own + other));
        let seat = Axes::seat(driver);
        let here = train.gears.iter().filter(|g| g.seat == seat).map(|g| 0.5 * g.pitch_diameter);
        let mut radii: Vec<f64> = here.collect();
        radii.extend(fresh);
        let mut best: Option<(f64, DriveTrain)> = None;
        for radius in radii {
            if best.as_ref().is_some_and(|b| b.0 >= self.parts.clearance) {
                break;
            }
            let end = radius * own / other;
            let straight = 0.5 * (distance - radius - end);
            if straight <= 0.0 {
                continue;
            }
            for size in IDLER_SIZES {
                let idler = size * straight;
                let [a, b] = [radius + idler, end + idler];
                let along = (a * a - b * b + distance * distance) / (2.0 * distance);
                let beside = (a * a - along * along).max(0.0).sqrt();
                let sides: &[f64] = if size > 1.0 { &[1.0, -1.0] } else { &[0.0] };
                for side in sides {
                    let place = from + (to - from) / distance * Complex64::new(along, side * beside);
                    let mut trial = train.clone();
                    let first = self.gear(&mut trial, driver, radius);
                    let plane = trial.gears[first].plane;
                    let ratio = -self.speed(driver) * radius / idler;
                    let middle = self.add(&mut trial, GearSeat::Idler, place, idler, ratio, plane);
                    let last = self.add(&mut trial, Axes::seat(node), to, end, self.speed(node), plane);
                    Axes::link(&mut trial, false, &[first, middle, last]);
                    let room = self.order_planes(&mut trial).distance;
                    if best.as_ref().is_none_or(|b| room > b.0 + 1e-9) {
                        best = Some((room, trial));
                    }
                }
            }
        }
        if let Some((_, trial)) = best {
            *train = trial;
        }
    }

    /// Two gears with two equal idlers on the line between them.
    fn idle_twice(&self, train: &mut DriveTrain, driver: usize, node: usize) {
        let (from, to) = (self.place(driver), self.place(node));
        let distance = (to - from).norm();
        let (own, other) = (self.speed(driver).abs(), self.speed(node).abs());
        let radius = 0.5 * distance * other / (own + other);
        let end = 0.5 * distance - radius;
        let idler = 0.125 * distance;
        let unit = (to - from) / distance;
        let first = self.gear(train, driver, radius);
        let plane = train.gears[first].plane;
        let ratio = self.speed(driver) * radius / idler;
        let near = self.add(train, GearSeat::Idler, from + unit * (radius + idler), idler, -ratio, plane);
        let far = self.add(train, GearSeat::Idler, to - unit * (end + idler), idler, ratio, plane);
        let last = self.add(train, Axes::seat(node), to, end, self.speed(node), plane);
        Axes::link(train, false, &[first, near, far, last]);
    }

    /// Two sprockets, the smaller as small as it may be.
    fn chain(&self, train: &mut DriveTrain, driver: usize, node: usize) {
        let (own, other) = (self.speed(driver).abs(), self.speed(node).abs());
        let smallest = self.smallest(Axes::seat(driver)).max(self.smallest(Axes::seat(node)) * other / own);
        let first = self.gear(train, driver, smallest);
        let plane = train.gears[first].plane;
        let (place, radius) = (self.place(node), smallest * own / other);
        let second = self.add(train, Axes::seat(node), place, radius, self.speed(node), plane);
        Axes::link(train, true, &[first, second]);
    }

    /// Radius of the axis of a gear's seat [m].
    fn axis_radius(&self, seat: GearSeat) -> f64 {
        match seat {
            GearSeat::Crank => self.journal_radius,
            GearSeat::Shaft(_) | GearSeat::Idler => self.parts.shaft_radius,
        }
    }

    /// Smallest pitch radius of a gear [m]: enough teeth, and a rim of a module around its seat.
    fn smallest(&self, seat: GearSeat) -> f64 {
        let module = self.parts.gear_module;
        (0.5 * FEWEST_TEETH * module).max(self.axis_radius(seat) + (1.0 + DEDENDUM) * module)
    }

    /// The narrowest place between the gears and what passes them; a gear too small for its teeth counts as well.
    pub fn clearance(&self, train: &DriveTrain) -> Clearance {
        let at = |g: &Gear| Complex64::new(g.x, g.y);
        let tip = |g: &Gear| 0.5 * g.pitch_diameter + ADDENDUM * self.parts.gear_module;
        let mut narrowest = (f64::INFINITY, Gap::None);
        let mut take = |distance: f64, gap: Gap| {
            if distance < narrowest.0 {
                narrowest = (distance, gap);
            }
        };
        let outermost = |seat: GearSeat| {
            let planes = train.gears.iter().filter(|g| g.seat == seat).map(|g| g.plane);
            if seat == GearSeat::Crank { usize::MAX } else { planes.max().unwrap_or(0) }
        };
        let meshing = |a: usize, b: usize| {
            train.links.iter().any(|l| (l.driver, l.driven) == (a, b) || (l.driver, l.driven) == (b, a))
        };
        for (index, gear) in train.gears.iter().enumerate() {
            let spare = 0.5 * gear.pitch_diameter - self.smallest(gear.seat);
            if spare < 0.0 {
                take(spare, Gap::TooSmall(index));
            }
            for (other, second) in train.gears.iter().enumerate().skip(index + 1) {
                if second.plane == gear.plane && !meshing(index, other) {
                    let gap = Gap::Gears(index, other);
                    take((at(gear) - at(second)).norm() - tip(gear) - tip(second), gap);
                }
            }
            for node in 0..=self.places.len() {
                let seat = Axes::seat(node);
                if seat != gear.seat && outermost(seat) > gear.plane {
                    let distance = (at(gear) - self.place(node)).norm() - tip(gear) - self.axis_radius(seat);
                    take(distance, Gap::Axis(index, node));
                }
            }
            for idler in &train.gears {
                if idler.seat == GearSeat::Idler && idler.plane > gear.plane {
                    let stud = self.axis_radius(GearSeat::Idler);
                    take((at(gear) - at(idler)).norm() - tip(gear) - stud, Gap::Stud(index));
                }
            }
        }
        for link in train.links.iter().filter(|l| l.chain) {
            let (from, to) = (&train.gears[link.driver], &train.gears[link.driven]);
            for node in (0..=self.places.len())
                .filter(|n| ![from.seat, to.seat].contains(&Axes::seat(*n)))
                .filter(|n| outermost(Axes::seat(*n)) >= from.plane)
            {
                let along = (self.place(node) - at(from)) / (at(to) - at(from));
                let beside = (along.im * (at(to) - at(from)).norm()).abs();
                if (0.0..=1.0).contains(&along.re) {
                    let room = beside - tip(from).max(tip(to)) - self.axis_radius(Axes::seat(node));
                    take(room, Gap::Axis(link.driver, node));
                }
            }
            let room = (at(from) - at(to)).norm() - tip(from) - tip(to);
            take(room, Gap::Gears(link.driver, link.driven));
        }
        Clearance { distance: narrowest.0, between: narrowest.1.words(self, train) }
    }
}

/// Which parts are nearest to one another.
#[derive(Debug, Clone, Copy)]
enum Gap {
    None,
    TooSmall(usize),
    Gears(usize, usize),
    Axis(usize, usize),
    Stud(usize),
}

impl Gap {
    fn words(self, axes: &Axes<'_>, train: &DriveTrain) -> String {
        let on = |seat: GearSeat| match seat {
            GearSeat::Crank => "the crank".to_owned(),
            GearSeat::Shaft(k) => format!("shaft {:+}", axes.ratios[k]),
            GearSeat::Idler => "its stud".to_owned(),
        };
        let gear = |k: usize| match train.gears[k].seat {
            GearSeat::Idler => "an idler".to_owned(),
            seat => format!("the gear of {}", on(seat)),
        };
        match self {
            Gap::None => "no two parts".to_owned(),
            Gap::TooSmall(a) => format!("{} and the smallest gear that its seat and teeth allow", gear(a)),
            Gap::Gears(a, b) => format!("{} and {}", gear(a), gear(b)),
            Gap::Axis(a, node) => format!("{} and {}", gear(a), on(Axes::seat(node))),
            Gap::Stud(a) => format!("{} and the stud of an idler", gear(a)),
        }
    }
}

/// What turning the shafts asks of the drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DriveLoad {
    /// Power at the crank [W].
    pub power: f64,
    /// Largest torque at a driven gear [N m].
    pub torque: f64,
}

impl DriveTrain {
    /// Power from the crank for shafts that need `powers` [W] at their own axes, each mesh or chain losing its share, at crank speed
    /// `speed` [rad/s].
    pub(crate) fn load(&self, powers: &[f64], efficiency: f64, speed: f64) -> DriveLoad {
        let mut torque = 0.0f64;
        let power = self.demand(GearSeat::Crank, None, powers, efficiency, speed, &mut torque);
        DriveLoad { power, torque }
    }

    /// Power that a seat needs, with all that it drives; an idler is known by its gear.
    fn demand(
        &self,
        seat: GearSeat,
        idler: Option<usize>,
        powers: &[f64],
        efficiency: f64,
        speed: f64,
        torque: &mut f64,
    ) -> f64 {
        let own = if let GearSeat::Shaft(k) = seat { powers[k] } else { 0.0 };
        let drives = |l: &&DriveLink| match idler {
            Some(gear) => l.driver == gear,
            None => self.gears[l.driver].seat == seat,
        };
        let mut sum = own;
        for link in self.links.iter().filter(drives) {
            let driven = &self.gears[link.driven];
            let idler = (driven.seat == GearSeat::Idler).then_some(link.driven);
            let needed = self.demand(driven.seat, idler, powers, efficiency, speed, torque);
            *torque = torque.max(needed / (driven.ratio.abs() * speed));
            sum += needed / efficiency;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(places: &[Complex64], ratios: &[i32], tree: &DriveTree) -> (DriveTrain, Clearance) {
        let parts = PartSizes::default();
        let axes = Axes { places, ratios, journal_radius: 0.02, parts: &parts };
        let (train, clearance) = axes.drive(tree);
        for link in train.links.iter().filter(|l| !l.chain) {
            let (a, b) = (&train.gears[link.driver], &train.gears[link.driven]);
            let distance = (a.x - b.x).hypot(a.y - b.y);
            // Pitch circles touch, rim speeds agree, senses are opposed.
            assert!((distance - 0.5 * (a.pitch_diameter + b.pitch_diameter)).abs() < 1e-12, "{a:?} {b:?}");
            assert!((a.ratio * a.pitch_diameter + b.ratio * b.pitch_diameter).abs() < 1e-12);
            assert_eq!(a.plane, b.plane);
        }
        for (k, ratio) in ratios.iter().enumerate() {
            let of_shaft = train.gears.iter().filter(|g| g.seat == GearSeat::Shaft(k));
            assert!(of_shaft.clone().count() > 0);
            assert!(of_shaft.clone().all(|g| g.ratio == f64::from(*ratio)));
        }
        (train, clearance)
    }

    #[test]
    fn fewest_meshes_by_sense() {
        let fewest = |ratios: &[i32]| drive_trees(ratios, DriveRule::Gears)[0].meshes;
        assert_eq!(fewest(&[-1]), 1);
        assert_eq!(fewest(&[2]), 2);
        // A pair: one from the crank, the other from it.
        assert_eq!(fewest(&[1, -1]), 2);
        assert_eq!(fewest(&[2, -2]), 2);
        assert_eq!(fewest(&[1, -1, 2, -2]), 4);
        let chains = &drive_trees(&[2], DriveRule::ChainOrBelt)[0];
        assert_eq!((chains.meshes, chains.chains), (0, 1));
        assert_eq!(drive_trees(&[], DriveRule::Gears).len(), 1);
    }

    #[test]
    fn every_tree_keeps_ratios_and_senses() {
        let places = [Complex64::new(-0.12, 0.06), Complex64::new(-0.12, -0.06), Complex64::new(0.0, 0.15)];
        for tree in drive_trees(&[-2, 2, 1], DriveRule::Gears) {
            check(&places, &[-2, 2, 1], &tree);
        }
    }

    #[test]
    fn a_second_order_shaft_with_the_crank_meshes_over_an_idler() {
        let places = [Complex64::new(-0.12, 0.05)];
        let trees = drive_trees(&[2], DriveRule::Gears);
        let (train, clearance) = check(&places, &[2], &trees[0]);
        assert_eq!(train.gears.len(), 3);
        assert!(clearance.distance > 0.0, "{clearance:?}");
        let crank = train.gears.iter().find(|g| g.seat == GearSeat::Crank).unwrap();
        let shaft = train.gears.iter().find(|g| g.seat == GearSeat::Shaft(0)).unwrap();
        assert!((crank.pitch_diameter - 2.0 * shaft.pitch_diameter).abs() < 1e-12);
    }

    #[test]
    fn gears_of_mirrored_shafts_that_mesh_run_into_the_crank() {
        // Two shafts at y = +-100 mm meshing with one another meet on the crank's own axis.
        let places = [Complex64::new(0.0, 0.1), Complex64::new(0.0, -0.1)];
        let trees = drive_trees(&[1, -1], DriveRule::Gears);
        let (_, clearance) = check(&places, &[1, -1], &trees[0]);
        assert!(clearance.distance < 0.0 && clearance.between.contains("crank"), "{clearance:?}");
        let parts = PartSizes::default();
        let axes = Axes { places: &places, ratios: &[1, -1], journal_radius: 0.02, parts: &parts };
        let fits = trees.iter().find(|t| axes.drive(t).1.distance >= parts.clearance).unwrap();
        assert_eq!(fits.meshes, 3);
    }

    #[test]
    fn power_and_torque_add_up_along_the_drive() {
        let places = [Complex64::new(-0.12, 0.06), Complex64::new(-0.12, -0.06)];
        let trees = drive_trees(&[-2, 2], DriveRule::Gears);
        let (train, _) = check(&places, &[-2, 2], &trees[0]);
        let load = train.load(&[100.0, 50.0], 0.9, 400.0);
        // The second shaft's power passes two meshes, the first shaft's one.
        assert!((load.power - (100.0 + 50.0 / 0.9) / 0.9).abs() < 1e-9);
        assert!((load.torque - (100.0 + 50.0 / 0.9) / 800.0).abs() < 1e-12);
    }
}
