//! All figures of an engine's loads, in the groups in which the report shows them.

use crate::engine::crank_view::crank_view;
use crate::engine::frame_sketch::frame_sketch;
use crate::engine::front_view::front_view;
use crate::engine::side_view::side_view;
use crate::kit::figure::Figure;
use crate::kit::magnitude::Magnitude;
use crate::loads::hodograph::{couple_hodograph, force_hodograph};
use crate::loads::motion_plot::motion_plot;
use crate::loads::over_angle::over_angle;
use crate::loads::share_plot::share_plots;
use crate::loads::spectrum::{couple_spectrum, force_spectrum, roll_spectrum};
use crate::loads::star::{couple_stars, force_stars, told_orders};
use crate::loads::story::{Told, story};
use lanchester_mechanism::Loads;
use lanchester_model::Engine;

pub(crate) struct Gallery {
    pub drawings: Vec<Figure>,
    /// The crank with its weights, and what each throw and device adds: none without devices.
    pub balance: Vec<Figure>,
    pub spectra: Vec<Figure>,
    pub curves: Vec<Figure>,
    pub hodographs: Vec<Figure>,
    pub stars: Vec<Figure>,
    pub stories: Vec<Figure>,
    pub motion: Option<Figure>,
    pub frame: Figure,
}

impl Gallery {
    pub fn of(engine: &Engine, loads: &Loads) -> Gallery {
        let noise = Magnitude::of(loads);
        let stories = told_orders(loads).into_iter().take(2).map(Told::Order).chain([Told::Whole]);
        let mut stars = vec![force_stars(loads, engine.rotation), couple_stars(loads, engine.rotation)];
        stars.retain(|figure| !figure.panels.is_empty());
        let mut spectra = vec![force_spectrum(loads), couple_spectrum(loads)];
        if loads.total.peaks.roll_moment.max_abs() > noise.roll_noise() {
            spectra.push(roll_spectrum(loads));
        }
        Gallery {
            drawings: vec![front_view(engine), side_view(engine)],
            balance: crank_view(engine).into_iter().chain(share_plots(engine, loads)).collect(),
            spectra,
            curves: over_angle(loads),
            hodographs: vec![
                force_hodograph(loads, engine.rotation),
                couple_hodograph(loads, engine.rotation),
            ],
            stars,
            stories: stories.filter_map(|told| story(engine, loads, told)).collect(),
            motion: motion_plot(loads),
            frame: frame_sketch(engine.rotation),
        }
    }

    pub fn into_figures(self) -> Vec<Figure> {
        let groups = [
            self.drawings,
            self.balance,
            self.spectra,
            self.curves,
            self.hodographs,
            self.stars,
            self.stories,
        ];
        groups.into_iter().flatten().chain(self.motion).chain([self.frame]).collect()
    }
}
