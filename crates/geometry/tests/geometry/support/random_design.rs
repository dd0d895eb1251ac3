//! The task of the tool paper, and random designs of a task's ranges.

use lanchester_geometry::{
    CounterweightShape, Design, DesignLimits, DesignSettings, DesignTask, Range, Shoulder,
};

/// The ranges of the tool paper's table 3, as far as its two designs tell them.
pub fn paper() -> DesignTask {
    DesignTask {
        unbalance: 8.0e-3,
        least_balance: 1.0,
        most_balance: None,
        density: 8000.0,
        web_radius: Range::new(0.01, 0.02),
        rectangle_height: Range::new(0.02, 0.03),
        shoulder: Shoulder::Angle(Range::new(0.0, 1.46)),
        arc_radius: Range::new(0.05, 0.07),
        arc_angle: Range::new(0.79, 3.13),
        thickness: Range::new(0.005, 0.03),
        limits: DesignLimits::default(),
        settings: DesignSettings::default(),
    }
}

/// A seeded stream of numbers in [0, 1).
pub struct Stream(pub u64);

impl Stream {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn within(&mut self, range: Range) -> f64 {
        range.least + self.next() * (range.most - range.least)
    }
}

/// A design with every dimension drawn from its range, the thickness half the time just enough; `None` where it is none of the family.
pub fn random_design(task: &DesignTask, stream: &mut Stream) -> Option<Design> {
    let (r, h) = (stream.within(task.web_radius), stream.within(task.rectangle_height));
    let (radius, alpha) = (stream.within(task.arc_radius), stream.within(task.arc_angle));
    let shoulder = radius * (alpha / 2.0).sin() - r;
    let big_h = match task.shoulder {
        Shoulder::Angle(range) => shoulder * stream.within(range).tan(),
        Shoulder::Height(range) => stream.within(range),
    };
    let any = stream.within(task.thickness);
    let enough = stream.next() < 0.5;
    if shoulder < 0.0 {
        return None;
    }
    let shape = CounterweightShape {
        web_radius: r,
        rectangle_height: h,
        shoulder_height: big_h,
        arc_radius: radius,
        arc_angle: alpha,
    };
    if shape.crown() < r {
        return None;
    }
    let needed = task.unbalance * task.least_balance / (task.density * shape.moments().first.x);
    let thickness = if enough { needed.max(task.thickness.least) } else { any };
    Some(Design::of(task, shape, thickness))
}

/// By how much, as a part of each limit, a design passes the worst of them; negative within all.
pub fn violation(task: &DesignTask, design: &Design) -> f64 {
    let limits = &task.limits;
    let mut worst = f64::NEG_INFINITY;
    let mut at_most = |value: f64, limit: f64| worst = worst.max((value - limit) / limit.abs().max(1e-12));
    at_most(-design.balance, -task.least_balance);
    at_most(design.balance, task.most_balance.unwrap_or(f64::MAX));
    at_most(design.mass, limits.mass.unwrap_or(f64::MAX));
    at_most(design.swept_radius, limits.swept_radius.unwrap_or(f64::MAX));
    at_most(design.inertia, limits.inertia.unwrap_or(f64::MAX));
    at_most(design.half_width, limits.half_width.unwrap_or(f64::MAX));
    let shape = &design.shape;
    let mut range = |value: f64, range: Range| {
        // A range may begin at zero: lengths are held against a metre's thousandth there.
        worst = worst.max((value - range.most) / range.most.max(1e-3));
        worst = worst.max((range.least - value) / range.most.max(1e-3));
    };
    range(design.thickness, task.thickness);
    range(shape.web_radius, task.web_radius);
    range(shape.rectangle_height, task.rectangle_height);
    range(shape.arc_radius, task.arc_radius);
    range(shape.arc_angle, task.arc_angle);
    match task.shoulder {
        Shoulder::Angle(angle) if design.shoulder > 1e-9 => range(design.shoulder_angle, angle),
        Shoulder::Angle(_) => {}
        Shoulder::Height(height) => range(shape.shoulder_height, height),
    }
    if let Some(height) = limits.shoulder_height {
        range(shape.shoulder_height, height);
    }
    if let (Some(angle), true) = (limits.shoulder_angle, design.shoulder > 1e-9) {
        range(design.shoulder_angle, angle);
    }
    worst
}
