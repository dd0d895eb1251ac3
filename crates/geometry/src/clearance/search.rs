//! The least distance over all angles and all points of an outline, with its proof: best first, until no cell is left that may
//! hold a smaller one.

use crate::clearance::contact::{Contact, Range2};
use crate::clearance::motion::RodMotion;
use lanchester_shape::Point;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Gap between a distance and its proved bound at which a search ends [m].
pub const CLEARANCE_GAP: f64 = 1e-7;

/// Cells after which a search ends with the bound that it has.
pub(super) const MOST_CELLS: usize = 1_000_000;

/// Cells that a turn is cut into to begin with.
const CELLS_A_TURN: f64 = 6.0;

/// The nearest place that a search found.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nearest {
    /// Distance [m].
    pub distance: f64,
    /// It is nowhere smaller than this [m].
    pub bound: f64,
    /// Angle of crankshaft 1 [rad].
    pub theta: f64,
    /// Which contact.
    pub contact: usize,
    /// Point of the outline, in the directions of its crankshaft at angle zero [m].
    pub point: Point,
}

/// A cell to be searched.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    /// What orders cells: the smallest first.
    pub bound: f64,
    /// Which contact.
    pub contact: usize,
    /// Which piece of its plate.
    pub piece: usize,
    /// Which part of it, when.
    pub range: Range2,
    /// Whether to halve it by the angle.
    pub split_angle: bool,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Cell) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Cell) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Cell) -> Ordering {
        other.bound.total_cmp(&self.bound)
    }
}

impl Cell {
    /// Both halves.
    pub fn halves(&self) -> [Cell; 2] {
        let mut halves = [*self; 2];
        for (half, sign) in halves.iter_mut().zip([-1.0, 1.0]) {
            let range = &mut half.range;
            if self.split_angle {
                range.half_angle /= 2.0;
                range.theta += sign * range.half_angle;
            } else {
                range.half_part /= 2.0;
                range.part += sign * range.half_part;
            }
        }
        halves
    }
}

/// Cells that cover all contacts over the angles from `start` on through `span` [rad].
pub(super) fn cover(contacts: &[Contact], start: f64, span: f64) -> Vec<Cell> {
    let mut cells = Vec::new();
    for (contact, pair) in contacts.iter().enumerate() {
        let turns = span / std::f64::consts::TAU * pair.spindle.ratio.value().abs().max(1.0);
        let count = if pair.is_rigid { 1 } else { (CELLS_A_TURN * turns).ceil().max(1.0) as usize };
        let half_angle = 0.5 * span / count as f64;
        for piece in 0..pair.plate.pieces.len() {
            for at in 0..count {
                let theta = start + (2 * at + 1) as f64 * half_angle;
                let range = Range2 { theta, half_angle, part: 0.5, half_part: 0.5 };
                cells.push(Cell { bound: f64::NEG_INFINITY, contact, piece, range, split_angle: false });
            }
        }
    }
    cells
}

/// The least distance of all contacts over the angles from `start` on through `span` [rad].
pub(super) fn nearest<M: RodMotion>(contacts: &[Contact], motions: &[M], start: f64, span: f64) -> Nearest {
    nearest_below(contacts, motions, start, span, f64::INFINITY)
}

/// As [`nearest`], where a distance of `enough` [m] is as good as any larger one: the bound is that at most, and what is no nearer is not looked for.
pub(super) fn nearest_below<M: RodMotion>(
    contacts: &[Contact],
    motions: &[M],
    start: f64,
    span: f64,
    enough: f64,
) -> Nearest {
    let mut best = Nearest {
        distance: f64::INFINITY,
        bound: f64::INFINITY,
        theta: start,
        contact: 0,
        point: Point::ORIGIN,
    };
    let mut least = f64::INFINITY;
    for (index, contact) in contacts.iter().enumerate() {
        least = least.min(contact.section.least());
        // A body wholly within the outline keeps the edges at a distance, and yet is in front of the plate.
        let pose = contact.frame.pose(motions, start);
        if contact.holds_body(&pose, start) && contact.section.least() < best.distance {
            let point = (pose.origin - contact.spindle.axis).turned(-contact.spindle.angle(start));
            best = Nearest { distance: contact.section.least(), contact: index, point, ..best };
        }
    }
    let mut heap = BinaryHeap::new();
    let look = |mut cell: Cell, best: &mut Nearest| {
        let contact = &contacts[cell.contact];
        let piece = &contact.plate.pieces[cell.piece];
        let pose = contact.frame.pose(motions, cell.range.theta);
        let local = contact.local(piece, &cell.range, &pose);
        let level = contact.section.level(local.at);
        if level.distance < best.distance {
            let (theta, contact) = (cell.range.theta, cell.contact);
            let point = piece.edge.at(cell.range.part).0;
            *best = Nearest { distance: level.distance, theta, contact, point, ..*best };
        }
        let [_, bound] = local.bounds(&contact.section, &level);
        cell.bound = bound.max(cell.bound).max(contact.section.least());
        cell.split_angle = local.is_wider_in_angle();
        (cell.bound < best.distance.min(enough)).then_some(cell)
    };
    for cell in cover(contacts, start, span) {
        heap.extend(look(cell, &mut best));
    }
    let mut looked = 0;
    while let Some(cell) = heap.pop() {
        looked += 1;
        if cell.bound >= best.distance - CLEARANCE_GAP || best.distance <= least || looked > MOST_CELLS {
            return Nearest { bound: cell.bound.max(0.0).min(best.distance).min(enough), ..best };
        }
        for half in cell.halves() {
            heap.extend(look(half, &mut best));
        }
    }
    Nearest { bound: best.distance.min(enough), ..best }
}
