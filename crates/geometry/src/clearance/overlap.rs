//! Where bodies overlap: at which angles, and how deep.

use crate::clearance::contact::{Contact, Range2};
use crate::clearance::motion::RodMotion;
use crate::clearance::search::{CLEARANCE_GAP, Cell, MOST_CELLS, cover};
use lanchester_shape::Point;
use std::collections::{BinaryHeap, VecDeque};

/// Ranges of angles that are neither clear nor overlapping for certain are cut down to this [rad].
const FINEST: f64 = 1e-6;

/// Ranges of angles that are looked at, at most; what is left undecided then counts as overlapping.
const MOST_RANGES: usize = 20_000;

/// Cuts of edges in one range of angles, at most.
const MOST_CUTS: usize = 4_000;

/// Whether bodies overlap over a range of angles.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Verdict {
    /// At none of them.
    Clear,
    /// At all of them.
    Overlapping,
    /// Not told.
    Undecided,
}

/// Angles at which any of the contacts overlaps, as ranges [from, to] that rise; one that runs over the end of the period
/// ends beyond it.
pub(super) fn overlapping_angles<M: RodMotion>(
    contacts: &[Contact],
    motions: &[M],
    period: f64,
) -> Vec<[f64; 2]> {
    let count = (16.0 * period / std::f64::consts::TAU).ceil().max(16.0) as usize;
    let half = 0.5 * period / count as f64;
    let mut waiting: VecDeque<(f64, f64)> = (0..count).map(|at| ((2 * at + 1) as f64 * half, half)).collect();
    let (mut found, mut looked) = (Vec::new(), 0);
    while let Some((theta, half)) = waiting.pop_front() {
        looked += 1;
        match verdict(contacts, motions, theta, half) {
            Verdict::Clear => {}
            Verdict::Undecided if half > 0.5 * FINEST && looked < MOST_RANGES => {
                let quarter = half / 2.0;
                waiting.extend([(theta - quarter, quarter), (theta + quarter, quarter)]);
            }
            Verdict::Overlapping | Verdict::Undecided => found.push([theta - half, theta + half]),
        }
    }
    found.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for range in found {
        match joined.last_mut() {
            Some(last) if range[0] <= last[1] + FINEST => last[1] = last[1].max(range[1]),
            _ => joined.push(range),
        }
    }
    if let [first, .., last] = joined.as_mut_slice()
        && first[0] < FINEST
        && last[1] > period - FINEST
    {
        last[1] = period + first[1];
        joined.remove(0);
    }
    joined
}

fn verdict<M: RodMotion>(contacts: &[Contact], motions: &[M], theta: f64, half: f64) -> Verdict {
    let mut verdict = Verdict::Clear;
    for contact in contacts {
        let pose = contact.frame.pose(motions, theta);
        let mut is_clear = true;
        let mut cuts = 0;
        for piece in &contact.plate.pieces {
            let mut waiting = vec![(0.5, 0.5)];
            while let Some((part, half_part)) = waiting.pop() {
                cuts += 1;
                let range = Range2 { theta, half_angle: half, part, half_part };
                let local = contact.local(piece, &range, &pose);
                let level = contact.section.level(local.at);
                let [_, bound] = local.bounds(&contact.section, &level);
                if bound > 0.0 {
                    continue;
                }
                let moved = local.by_angle.norm() + local.rest_of_angle;
                if contact.section.depth(local.at) > moved {
                    return Verdict::Overlapping;
                }
                // Below what the angle moves, a finer look at the edge tells nothing.
                let along = local.by_part.norm() + (local.rest - local.rest_of_angle);
                if along > 0.25 * moved && cuts < MOST_CUTS {
                    let quarter = half_part / 2.0;
                    waiting.extend([(part - quarter, quarter), (part + quarter, quarter)]);
                } else {
                    is_clear = false;
                }
            }
        }
        if !is_clear {
            verdict = Verdict::Undecided;
        } else if contact.holds_body(&pose, theta) {
            // No edge is met over the whole range: the body is within the outline all the time.
            return Verdict::Overlapping;
        }
    }
    verdict
}

/// The farthest that contacts reach along the cylinder axis into piston or liner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Deepest {
    /// How far [m].
    pub depth: f64,
    /// It is nowhere more than this [m].
    pub bound: f64,
    /// Angle of crankshaft 1 [rad].
    pub theta: f64,
    /// Which contact.
    pub contact: usize,
    /// Point of the outline, in the directions of its crankshaft at angle zero [m].
    pub point: Point,
}

/// How far piston or liner would have to be moved along the cylinder axis, at all angles, to clear the contacts: the largest
/// `x` of their points that meet it beside the axis. The search is that of the least distance, for the smallest `-x`.
pub(super) fn deepest<M: RodMotion>(contacts: &[Contact], motions: &[M], period: f64) -> Deepest {
    let mut best = Deepest { depth: 0.0, bound: 0.0, theta: 0.0, contact: 0, point: Point::ORIGIN };
    let mut heap = BinaryHeap::new();
    let look = |mut cell: Cell, best: &mut Deepest| {
        let contact = &contacts[cell.contact];
        let piece = &contact.plate.pieces[cell.piece];
        let pose = contact.frame.pose(motions, cell.range.theta);
        let local = contact.local(piece, &cell.range, &pose);
        let beside = contact.section.beside(local.at.y);
        let across = local.by_angle.y.abs() + local.by_part.y.abs() + local.rest;
        if beside > across {
            return None;
        }
        if beside <= 0.0 && local.at.x > best.depth {
            let point = piece.edge.at(cell.range.part).0;
            let (theta, contact) = (cell.range.theta, cell.contact);
            *best = Deepest { depth: local.at.x, theta, contact, point, ..*best };
        }
        let reach = local.at.x + local.by_angle.x.abs() + local.by_part.x.abs() + local.rest;
        cell.bound = (-reach).max(cell.bound);
        cell.split_angle = local.is_wider_in_angle();
        (-cell.bound > best.depth).then_some(cell)
    };
    for cell in cover(contacts, 0.0, period) {
        heap.extend(look(cell, &mut best));
    }
    let mut looked = 0;
    while let Some(cell) = heap.pop() {
        looked += 1;
        if -cell.bound <= best.depth + CLEARANCE_GAP || looked > MOST_CELLS {
            return Deepest { bound: best.depth.max(-cell.bound), ..best };
        }
        for half in cell.halves() {
            heap.extend(look(half, &mut best));
        }
    }
    Deepest { bound: best.depth, ..best }
}
