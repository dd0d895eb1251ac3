use super::*;
use lanchester_balance::optimise;
use lanchester_file::{read, template};
use lanchester_literature::{
    ArrangementOptions, arranged, arrangement_task, crank_load, crank_task, swept_crank,
};
use lanchester_mechanism::{LoadRequest, loads};
use lanchester_task::BalanceTask;

fn results(name: &str) -> (Engine, Vec<ArrangementResult>) {
    let text = template(name).expect("it is in the gallery").text;
    let engine = read(text).engine().expect("it is valid");
    let options = ArrangementOptions::default();
    let result = |arrangement: TwinArrangement| {
        let fitted = arranged(&engine, arrangement, &options).expect("it has one crankshaft");
        let loads = loads(&fitted, &LoadRequest { samples: 90, ..LoadRequest::default() });
        let best = |task: BalanceTask| {
            (!task.stages.is_empty()).then(|| optimise(&fitted, &task).expect("it is a task of this engine"))
        };
        ArrangementResult {
            arrangement,
            loads: loads.expect("it is valid"),
            judged: crank_load(&engine, &options).expect("it is valid"),
            sweep: swept_crank(&engine, arrangement, &options).expect("it is valid"),
            crank_optimum: best(crank_task(&engine, arrangement, &options).expect("it is valid")),
            optimum: best(arrangement_task(&engine, arrangement, &options).expect("it is valid")),
            engine: fitted,
        }
    };
    let results = TwinArrangement::ALL.into_iter().map(result).collect();
    (engine, results)
}

fn page(name: &str) -> String {
    let (engine, arrangements) = results(name);
    let provenance = Provenance::default();
    arrangements_report(&ArrangementsInput {
        engine: &engine,
        arrangements: &arrangements,
        provenance: &provenance,
        warnings: &[],
    })
}

#[test]
fn every_arrangement_has_its_section_and_the_contents_lead_to_it() {
    let page = page("twin-360");
    for number in 1..=9 {
        assert_eq!(page.matches(&format!("id=\"arrangement-{number}\"")).count(), 1);
        assert_eq!(page.matches(&format!("href=\"#arrangement-{number}\"")).count(), 1);
    }
    // Nothing is loaded from elsewhere.
    assert!(!page.contains("src=") && !page.contains("http"));
}

#[test]
fn the_sweep_is_drawn_where_there_is_one() {
    let (_, arrangements) = results("twin-360");
    let swept: Vec<usize> =
        arrangements.iter().filter(|a| a.sweep.is_some()).map(|a| a.arrangement.number()).collect();
    assert_eq!(swept, [2, 5]);
    // The whole curve and the close-up, each.
    assert_eq!(page("twin-360").matches("over the counterweight of throw 1").count(), 4);
}

#[test]
fn an_arrangement_without_its_devices_says_which_it_equals() {
    // An in-line four has no first order: 2, 3 and 4 are 1.
    let page = page("in-line-4");
    assert_eq!(page.matches("the same as arrangement 1").count(), 3);
    assert!(page.contains("have no first order"));
}

#[test]
fn the_maxima_are_those_of_the_loads() {
    let (_, arrangements) = results("twin-180");
    let table = maxima_table(&arrangements);
    let couple = table.columns.iter().position(|c| c.header == "|M|").expect("it is a column");
    for (row, result) in table.rows.iter().zip(&arrangements) {
        let Cell::Number { value, .. } = row[couple] else { panic!("a couple is a number") };
        let peak = result.loads.total.peaks.couple.max.value;
        assert!(value == peak || (value == 0.0 && peak < 1e-6), "{value} {peak}");
    }
}

#[test]
fn the_true_optimum_is_never_above_the_published_sizes() {
    for name in ["twin-360", "twin-180", "boxer-2", "single"] {
        let (_, arrangements) = results(name);
        let mut better = 0;
        for result in &arrangements {
            if let Some(load) = result.judged {
                let Some(optimal) = result.optimal(load) else {
                    continue;
                };
                let sized = result.sized(load);
                // What is cancelled stays at the noise of both.
                assert!(optimal <= sized * (1.0 + 1e-8) + 1e-5, "{name} {:?}", result.arrangement);
                better += usize::from(optimal < 0.999 * sized);
            }
            if let (Some(sweep), Some(crank)) = (&result.sweep, result.optimal_crank()) {
                // The grid misses peaks between its angles, so that its value alone may lie below.
                assert!((sweep.best().unbalance - crank.unbalance).abs() < 3e-4, "{name} {crank:?}");
            }
        }
        assert!(better > 0 || name == "twin-180", "{name}");
    }
}
