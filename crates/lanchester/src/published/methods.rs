//! Every published method for one engine, each beside the proved optimum of its own devices.

use crate::published::arrangements::arrangements;
use lanchester_balance::{Answer, BalanceError, Outcome};
use lanchester_literature::{
    BalanceFactor, BalancerPhase, CrankLoad, MatrixMethod, PublishedMethod, SHAFT_DISTANCE, SweepOptions,
    outer_throws, swept, with_even_crank,
};
use lanchester_mechanism::{Kinematics, LoadRequest, total_loads};
use lanchester_model::Engine;
use lanchester_report::{method_source, residual_noise};
use lanchester_task::{Criterion, Load};
use serde::Serialize;

/// Largest load over the cycle at the highest speed, force [N] or couple [N m].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MethodLoad {
    /// With the sizes of the method.
    pub method: f64,
    /// With the proved optimum of the same devices: force first, then couple; of the sweep the load that it sweeps for.
    pub optimum: Option<f64>,
}

/// What a method leaves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MethodLoads {
    /// Force [N].
    pub force: MethodLoad,
    /// Couple [N m].
    pub couple: MethodLoad,
}

/// A published method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "of")]
pub enum MethodKind {
    /// The matrix method.
    Matrix,
    /// The rule of the thesis for an engine of its own: of an in-line three or four, else the share of 50 %.
    Half,
    /// The share of 50 % beside such a rule.
    Share,
    /// The sweep of the crank.
    Sweep,
    /// One of the nine arrangements.
    Arrangement {
        /// Its number in the thesis.
        number: usize,
    },
    /// All nine, where none can be had.
    Arrangements,
}

/// A published method for an engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MethodResult {
    /// Its name.
    pub name: String,
    /// Where it was published.
    pub source: String,
    /// Which.
    pub kind: MethodKind,
    /// What it leaves.
    pub left: Option<MethodLoads>,
    /// Why it cannot be used for this engine.
    pub refused: Option<String>,
}

const TWIN_THESIS: &str = "Louvigny, Preliminary design of twin-cylinder engines, 2008";

/// The matrix method, the half rules, the sweep and the nine arrangements, with the sizes that their commands take by themselves.
///
/// ```
/// let template = lanchester::file::template("in-line-4").expect("it is in the gallery");
/// let engine = lanchester::file::read(template.text).engine().expect("the gallery has no mistakes");
/// let all = lanchester::published_methods(&engine);
/// let matrix = all[0].left.expect("it can be used");
/// // An in-line four has no couple to leave, and the optimum halves the force that two pairs of shafts leave.
/// assert_eq!(matrix.couple.method, 0.0);
/// assert!(matrix.force.optimum.is_some_and(|optimum| optimum < 0.6 * matrix.force.method));
/// ```
pub fn published_methods(engine: &Engine) -> Vec<MethodResult> {
    let half =
        PublishedMethod::half_rule(engine, outer_throws(engine), SHAFT_DISTANCE, BalancerPhase::CouplePeak);
    let matrix = PublishedMethod::Matrix(MatrixMethod::usual(engine, SHAFT_DISTANCE));
    let mut all = vec![
        fitted(engine, "Matrix method", MethodKind::Matrix, &matrix),
        fitted(engine, half_name(&half), MethodKind::Half, &half),
    ];
    if !matches!(half, PublishedMethod::Factor(_)) {
        let share = PublishedMethod::Factor(BalanceFactor::BEST);
        all.push(fitted(engine, half_name(&share), MethodKind::Share, &share));
    }
    all.push(sweep(engine));
    all.extend(nine(engine));
    all
}

/// The engine as it is, beside the methods.
///
/// # Errors
/// [`BalanceError`] where its loads cannot be computed.
pub fn loads_as_it_is(engine: &Engine) -> Result<MethodLoads, BalanceError> {
    Ok(loads(engine, peaks(engine)?, [None, None]))
}

fn half_name(method: &PublishedMethod) -> &'static str {
    match method {
        PublishedMethod::ThreeCylinder(_) => "50 % rule with a balancer shaft",
        PublishedMethod::FourCylinder(_) => "Two second-order shafts",
        _ => "50 % balance factor",
    }
}

fn fitted(engine: &Engine, name: &str, kind: MethodKind, method: &PublishedMethod) -> MethodResult {
    let found = method.fit(engine, &[]);
    let source = match &found {
        Ok(found) => method_source(&found.found),
        Err(_) => String::new(),
    };
    let left = found.and_then(|found| {
        let method = peaks(&found.fitted)?;
        Ok(loads(engine, method, [Load::Force, Load::Couple].map(|load| best(&found.optimum, load))))
    });
    result(name.to_string(), source, kind, left)
}

fn sweep(engine: &Engine) -> MethodResult {
    let left = swept(engine, None, Kinematics::Exact, &SweepOptions::fitting(engine)).and_then(|found| {
        let method = peaks(&with_even_crank(engine, found.best.unbalance))?;
        let optimum = found.optimal().map(|crank| crank.criterion);
        let optima = match found.sweep.load {
            CrankLoad::Force => [optimum, None],
            CrankLoad::Couple => [None, optimum],
        };
        Ok(loads(engine, method, optima))
    });
    result("Sweep of the crank".to_string(), TWIN_THESIS.to_string(), MethodKind::Sweep, left)
}

fn nine(engine: &Engine) -> Vec<MethodResult> {
    let name = |number: usize, name: &str| format!("Arrangement {number}: {name}");
    match arrangements(engine, &LoadRequest::default()) {
        Ok(nine) => nine
            .iter()
            .map(|own| {
                let both = [CrankLoad::Force, CrankLoad::Couple];
                let left =
                    loads(engine, both.map(|load| own.sized(load)), both.map(|load| own.optimal(load)));
                let number = own.arrangement.number();
                result(
                    name(number, own.arrangement.name()),
                    TWIN_THESIS.to_string(),
                    MethodKind::Arrangement { number },
                    Ok(left),
                )
            })
            .collect(),
        Err(error) => vec![result(
            "Nine arrangements".to_string(),
            TWIN_THESIS.to_string(),
            MethodKind::Arrangements,
            Err(error),
        )],
    }
}

fn result(
    name: String,
    source: String,
    kind: MethodKind,
    left: Result<MethodLoads, BalanceError>,
) -> MethodResult {
    let (left, refused) = match left {
        Ok(left) => (Some(left), None),
        Err(error) => (None, Some(error.to_string())),
    };
    MethodResult { name, source, kind, left, refused }
}

/// What the same devices leave at least, where it is proved.
fn best(optimum: &Answer, load: Load) -> Option<f64> {
    let own = optimum.effects.iter().find(|effect| effect.criterion == Criterion::Peak(load));
    own.filter(|_| optimum.outcome == Outcome::Optimal).map(|effect| effect.after)
}

fn peaks(engine: &Engine) -> Result<[f64; 2], BalanceError> {
    let peaks = total_loads(engine, &LoadRequest::default())?.peaks;
    Ok([peaks.force.max.value, peaks.couple.max.value])
}

/// Loads of which what is rounding beside the moving masses is 0.
fn loads(engine: &Engine, method: [f64; 2], optima: [Option<f64>; 2]) -> MethodLoads {
    let load = |place: usize, unit: &str| {
        let noise = residual_noise(engine, unit);
        let clean = |value: f64| if value.abs() < noise { 0.0 } else { value };
        MethodLoad { method: clean(method[place]), optimum: optima[place].map(clean) }
    };
    MethodLoads { force: load(0, "N"), couple: load(1, "N m") }
}
