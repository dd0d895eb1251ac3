//! Cycles and traces: what a sweep over the speed asks for many times.

use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_cycle::{
    CylinderVolume, TraceOptions, TracePlace, ZoneSettings, ideal_cycle, indicated, read_trace, single_zone,
};
use lanchester_model::{Engine, GasCycle, GasProcess, GasSource};
use std::f64::consts::PI;
use std::hint::black_box;

const GAS: &str = include_str!("../../../examples/single-gas.toml");
const TRACE: &str = include_str!("../../../validation/traces/pressure-3000.csv");

fn cycle_of(engine: &Engine) -> &GasCycle {
    match engine.gas.as_ref().map(|gas| &gas.source) {
        Some(GasSource::Cycle(cycle)) => cycle,
        other => panic!("no cycle: {other:?}"),
    }
}

fn cycles(criterion: &mut Criterion) {
    let engine = lanchester_file::read(GAS).engine().expect("the example has no mistakes");
    let cycle = cycle_of(&engine);
    let volume =
        CylinderVolume::of_engine(&engine, Some(cycle.compression_ratio)).expect("it turns").remove(0);
    let GasProcess::SingleZone(zone) = &cycle.process else { panic!("no single zone") };
    criterion.bench_function("single zone to 1e-7 from cycle to cycle", |bencher| {
        bencher.iter(|| {
            single_zone(cycle, zone, &volume, black_box(4000.0 * PI / 30.0), &ZoneSettings::default())
        });
    });
    let otto = GAS.replace("\"single-zone\"", "\"otto\"");
    let otto =
        otto.split("[gas.intake]").next().unwrap_or("").to_string() + "[gas.fuel]\nenergy = \"1 kJ\"\n";
    let otto = lanchester_file::read(&otto).engine().expect("an Otto cycle");
    criterion.bench_function("Otto cycle", |bencher| {
        bencher.iter(|| ideal_cycle(black_box(cycle_of(&otto)), &volume));
    });
    let options = TraceOptions {
        name: "pressure-3000.csv",
        cycle: 4.0 * PI,
        gauge: false,
        ambient_pressure: 101_325.0,
        top_dead_centre: 0.0,
        place: TracePlace::Cylinder,
    };
    criterion.bench_function("trace of 1441 samples", |bencher| {
        bencher.iter(|| read_trace(black_box(TRACE), &options));
    });
    let trace = read_trace(TRACE, &options).expect("it is good").columns.remove(0).1;
    criterion.bench_function("indicated work of 1440 pieces", |bencher| {
        bencher.iter(|| indicated(black_box(&trace), &volume));
    });
}

criterion_group!(benches, cycles);
criterion_main!(benches);
