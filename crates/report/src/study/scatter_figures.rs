//! Distribution of residual loads in production.

use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::xy_plot::{XyCurve, XyPlot};
use lanchester_study::scatter::{OutputScatter, ScatterStudy, WorstCase};

/// Share of the engines whose load does not exceed a value, with the nominal engine, the worst combination that was found, and the limits.
pub fn scatter_figure(study: &ScatterStudy) -> Figure {
    let panels =
        study.scatter.outputs.iter().zip(&study.worst_cases).map(|(own, worst)| panel(study, own, worst));
    Figure {
        id: "scatter".to_owned(),
        title: "Production scatter of the loads".to_owned(),
        caption: format!(
            "Share of {} engines whose load does not exceed a value, at {} rpm.",
            number::short(study.scatter.samples as f64, 4),
            number::short(number::rpm(study.speed), 4)
        ),
        panels: panels.collect(),
        columns: 2,
    }
}

fn panel(study: &ScatterStudy, own: &OutputScatter, worst: &WorstCase) -> Panel {
    let mut rising: Vec<(f64, f64)> = own.percentiles.iter().map(|p| (p.value, 100.0 * p.share)).collect();
    rising.sort_by(|a, b| a.1.total_cmp(&b.1));
    let upright = |name: &str, style: usize, at: f64| XyCurve {
        name: name.to_owned(),
        style,
        points: vec![(at, 0.0), (at, 100.0)],
        dots: false,
    };
    let mut curves = vec![
        XyCurve { name: "production".to_owned(), style: 0, points: rising, dots: false },
        upright("nominal", 1, own.nominal),
        upright("worst found", 2, worst.attained),
    ];
    let limits = study.limits.iter().filter(|limit| limit.output == own.output);
    curves.extend(limits.map(|limit| upright("limit", 3, limit.capability.limit)));
    let (name, unit) = (number::capital(&own.output.name()), own.output.unit());
    XyPlot { abscissa: &name, ordinate: "Share of the engines", units: [unit, "%"], polar: None, curves }
        .panel()
}
