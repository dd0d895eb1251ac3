//! Criteria of main-bearing loads in words.

use lanchester_file::{read, template};
use lanchester_model::Engine;
use lanchester_task::{Criterion, Load, Mains, Statistic, criterion, criterion_name};

fn four() -> Engine {
    read(template("in-line-4").unwrap().text).engine().unwrap()
}

#[test]
fn every_name_reads_back_as_its_criterion() {
    let engine = four();
    let mains = [Mains::All, Mains::Largest, Mains::One(0), Mains::One(4)];
    let gas = [Statistic::Rms, Statistic::Mean, Statistic::Peak]
        .into_iter()
        .flat_map(|statistic| mains.map(|mains| Criterion::MainsWithGas(statistic, mains)))
        .filter(|one| *one != Criterion::MainsWithGas(Statistic::Peak, Mains::All))
        .filter(|one| *one != Criterion::MainsWithGas(Statistic::Mean, Mains::Largest));
    let means = [Mains::All, Mains::One(0)].map(Criterion::MainMean);
    let statistics = mains.map(Criterion::MainRms).into_iter().chain(means).chain(gas);
    let loads = [Load::LargestMainLoad, Load::MainLoad(2)];
    let peaks = loads
        .into_iter()
        .flat_map(|l| [Criterion::Peak(l), Criterion::Order(l, 1.0), Criterion::Order(l, 0.5)]);
    for one in statistics.chain(peaks) {
        let name = criterion_name(&one, &engine);
        assert_eq!(criterion(&name, &engine), Ok(one), "{name}");
    }
}

#[test]
fn names_as_people_write_them() {
    let engine = four();
    let read = |text: &str| criterion(text, &engine).unwrap();
    assert_eq!(read("main-bearing load"), Criterion::Peak(Load::LargestMainLoad));
    assert_eq!(read("largest  main-bearing load"), Criterion::Peak(Load::LargestMainLoad));
    assert_eq!(read(" main-bearing  load rms "), Criterion::MainRms(Mains::All));
    assert_eq!(read("main-bearing load 3"), Criterion::Peak(Load::MainLoad(2)));
    assert_eq!(read("main-bearing load 3 rms"), Criterion::MainRms(Mains::One(2)));
    assert_eq!(read("main-bearing load 3 order 1"), Criterion::Order(Load::MainLoad(2), 1.0));
    assert_eq!(read("main-bearing load mean"), Criterion::MainMean(Mains::All));
    let gas = |statistic, mains| Criterion::MainsWithGas(statistic, mains);
    assert_eq!(read("main-bearing load with  gas"), gas(Statistic::Peak, Mains::Largest));
    assert_eq!(read("main-bearing load 3 with gas"), gas(Statistic::Peak, Mains::One(2)));
    assert_eq!(read("largest main-bearing load rms with gas"), gas(Statistic::Rms, Mains::Largest));
}

#[test]
fn what_is_no_main_bearing() {
    let engine = four();
    let refused = |text: &str| {
        let bad = criterion(text, &engine).expect_err(text);
        format!("{}; {}", bad.message, bad.hint)
    };
    assert!(refused("main-bearing load 6").contains("there are main bearings 1 to 5"));
    assert!(refused("main-bearing load 6 order 1").contains("there are main bearings 1 to 5"));
    for text in [
        "main-bearing load 0",
        "main-bearing load front",
        "main-bearing load 3 4",
        "largest main-bearing load 3",
        "main-bearing load rms mean",
        "main-bearing load with",
    ] {
        assert!(refused(text).contains("a number from 1 on"), "{text}");
    }
    assert!(refused("largest main-bearing load mean").contains("write \"main-bearing load mean\""));
    assert!(refused("main-bearing laod").contains("did you mean \"main-bearing load\"?"));
    assert!(refused("main-bearing load rns").contains("a number from 1 on"));
    assert!(refused("main-baering load rms").contains("did you mean \"main-bearing load rms\"?"));
}
