//! The proof: a lower bound computed from multipliers alone.
//!
//! For any point that holds the rows, and multipliers `y` with `SUM over g of |y| <= c_g + SUM of b_rg price_r`,
//!
//! ```text
//! SUM c_g t_g + p x  >=  SUM y . a(phi; x) + p x + SUM price_r (h_r x - B_r)
//!                    =   SUM y . a(phi; 0) - SUM price_r B_r  +  x . ( p + SUM A^T y + SUM price_r h_r )
//! ```
//! The last bracket is made 0 to rounding by the smallest change of the multipliers; what is left of it is charged with
//! the radius that every optimum lies in. Since `y . a(phi; 0)` is taken at the multipliers' own angles, the bound
//! holds whether or not these are the peaks.

use super::dense::{Matrix, RowFactors, add_scaled, dot, norm};
use super::programme::{Programme, Support};

/// Levels below this vanish.
const VANISHES: f64 = 1e-6;

/// Conditions that differ from the others by less than this share are theirs: what they ask beyond is rounding, and charged.
const DEPENDENT: f64 = 1e-10;

/// Multipliers made admissible, and what they prove.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Certificate {
    pub bound: f64,
    pub support: Vec<Support>,
    pub prices: Vec<f64>,
}

/// The bound that these multipliers prove, after the smallest change that makes them admissible.
///
/// `levels` are those of the point that the multipliers belong to: groups that vanish there need not use up their
/// weight. `radius` holds every point worth looking at.
pub(crate) fn certify(
    programme: &Programme,
    levels: &[f64],
    support: &[Support],
    prices: &[f64],
    radius: f64,
) -> Option<Certificate> {
    let mut support: Vec<Support> = support.iter().filter(|s| norm(&s.y) > 0.0).cloned().collect();
    let mut prices: Vec<f64> = prices.iter().map(|p| p.max(0.0)).collect();
    let directions: Vec<Matrix> =
        support.iter().map(|s| programme.groups[s.group].members[s.member].directions(s.angle)).collect();
    for _ in 0..3 {
        project(programme, levels, &directions, &mut support, &mut prices);
    }
    settle(programme, &mut support, &mut prices)?;
    let rest = stationarity(programme, &directions, &support, &prices);
    let mut bound = programme.offset;
    for one in &support {
        bound += dot(&one.y, &programme.groups[one.group].members[one.member].constant(one.angle));
    }
    for (row, price) in programme.rows.iter().zip(&prices) {
        bound -= price * row.most;
    }
    let rest = norm(&rest);
    if rest > 0.0 {
        bound -= rest * radius;
    }
    bound.is_finite().then_some(Certificate { bound, support, prices })
}

/// `p + SUM A^T y + SUM price h`.
pub(crate) fn stationarity(
    programme: &Programme,
    directions: &[Matrix],
    support: &[Support],
    prices: &[f64],
) -> Vec<f64> {
    let mut rest = programme.linear.clone();
    for (one, directions) in support.iter().zip(directions) {
        directions.add_transposed(&one.y, 1.0, &mut rest);
    }
    for (row, price) in programme.rows.iter().zip(prices) {
        add_scaled(&mut rest, *price, &row.directions);
    }
    rest
}

/// The smallest relative change of the multipliers that makes them stationary and gives every group its weight.
fn project(
    programme: &Programme,
    levels: &[f64],
    directions: &[Matrix],
    support: &mut [Support],
    prices: &mut [f64],
) {
    let n = programme.variables;
    // The terms of a mean over the cycle are left to [`settle`]: it loses no more than the change here.
    let terms = programme.terms_of_a_mean();
    let groups: Vec<usize> =
        (0..programme.groups.len()).filter(|&g| !terms[g] && support.iter().any(|s| s.group == g)).collect();
    let unknowns: usize = directions.iter().map(|d| d.rows).sum::<usize>() + prices.len();
    let mut matrix = Matrix::zeros(n + groups.len(), unknowns);
    let mut right: Vec<f64> =
        stationarity(programme, directions, support, prices).iter().map(|r| -r).collect();
    let mut at = 0;
    for (one, directions) in support.iter().zip(directions) {
        let size = norm(&one.y);
        let line = groups.iter().position(|&g| g == one.group);
        for m in 0..directions.rows {
            for j in 0..n {
                matrix[(j, at + m)] = size * directions[(m, j)];
            }
            if let Some(line) = line {
                matrix[(n + line, at + m)] = one.y[m];
            }
        }
        at += directions.rows;
    }
    for (r, row) in programme.rows.iter().enumerate() {
        for j in 0..n {
            matrix[(j, at + r)] = prices[r] * row.directions[j];
        }
        for &(group, share) in &row.shares {
            if let Some(line) = groups.iter().position(|&g| g == group) {
                matrix[(n + line, at + r)] = -prices[r] * share;
            }
        }
    }
    for &group in &groups {
        let sum: f64 = support.iter().filter(|s| s.group == group).map(|s| norm(&s.y)).sum();
        let short = programme.weight(group, prices) - sum;
        right.push(if levels[group] < VANISHES { short.min(0.0) } else { short });
    }
    let change = RowFactors::of(&matrix, DEPENDENT).shortest(&right);
    // A change that is not small would turn multipliers round.
    if change.iter().any(|c| !c.is_finite() || c.abs() > 0.5) {
        return;
    }
    let mut at = 0;
    for one in support.iter_mut() {
        let size = norm(&one.y);
        for m in 0..programme.groups[one.group].members[one.member].dimension() {
            one.y[m] += size * change[at];
            at += 1;
        }
    }
    for (price, change) in prices.iter_mut().zip(&change[at..]) {
        *price *= 1.0 + change;
    }
}

/// Makes `SUM of |y|` of every group at most its weight: a row of the group is raised, or all multipliers are scaled.
fn settle(programme: &Programme, support: &mut [Support], prices: &mut [f64]) -> Option<()> {
    let mut scale = 1.0f64;
    for group in 0..programme.groups.len() {
        let sum: f64 = support.iter().filter(|s| s.group == group).map(|s| norm(&s.y)).sum();
        let short = sum - programme.weight(group, prices);
        if short <= 0.0 {
            continue;
        }
        let row = programme.rows.iter().enumerate().find_map(|(r, row)| {
            let share = row.shares.iter().find(|s| s.0 == group)?;
            Some((r, share.1))
        });
        match row {
            Some((r, share)) => prices[r] += short / share,
            None if programme.cost[group] > 0.0 => scale = scale.min(programme.cost[group] / sum),
            None => return None,
        }
    }
    if scale < 1.0 {
        for one in support.iter_mut() {
            one.y.iter_mut().for_each(|y| *y *= scale);
        }
        prices.iter_mut().for_each(|p| *p *= scale);
    }
    Some(())
}
