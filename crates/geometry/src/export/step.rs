//! STEP files (ISO 10303-21) of AP214, with the analytic surfaces.
//!
//! Each solid is a product of its own name with an `ADVANCED_BREP_SHAPE_REPRESENTATION` of a `MANIFOLD_SOLID_BREP`, or of a
//! `BREP_WITH_VOIDS` where it has cavities within. Several are the components of one more product, the assembly, each at its
//! place already: names stand in the tree of the CAD program, which forgets them of bodies within one product. Faces are planes, cylinders and cones, edges lines, circles, ellipses, hyperbolas and, where none of these is right, splines; each edge and each
//! vertex is written once and used by both faces, so that shells are watertight by construction. Lengths are millimetres.

use super::Solid;
use super::solid::{Curve, Surface};
use super::step_curve::{Conic, Rise, rise};
use lanchester_shape::{Cut, Edge, Point};
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

/// What the head of a STEP file says beside the solids.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StepHeader {
    /// Name of the file, and of the assembly where there are several solids.
    pub title: String,
    /// When it was made, as ISO 8601 has it. The library reads no clock: who wants the time of the day gives it.
    pub time: String,
}

impl Default for StepHeader {
    /// The title "crankshaft parts", at the beginning of 1970.
    fn default() -> StepHeader {
        StepHeader { title: "crankshaft parts".to_string(), time: "1970-01-01T00:00:00".to_string() }
    }
}

/// The text of a STEP file of solids ([`super::solids`]), in millimetres.
pub fn step(solids: &[Solid], header: &StepHeader) -> String {
    let mut file = File::new();
    let origin = file.placement([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let mut components = Vec::new();
    let mut styles = Vec::new();
    for solid in solids {
        let body = file.solid(solid);
        styles.push(file.style(body, solid.colour()));
        let name = text(solid.name());
        let units = file.units;
        let shape =
            file.add(&format!("ADVANCED_BREP_SHAPE_REPRESENTATION({name},(#{origin},#{body}),#{units})"));
        components.push((name, file.product(solid.name(), shape), shape));
    }
    let units = file.units;
    if solids.len() != 1 {
        let title = text(&header.title);
        let whole = file.add(&format!("SHAPE_REPRESENTATION({title},(#{origin}),#{units})"));
        let assembly = file.product(&header.title, whole);
        for (number, (name, definition, shape)) in components.iter().enumerate() {
            let usage = file.add(&format!(
                "NEXT_ASSEMBLY_USAGE_OCCURRENCE('{}',{name},'',#{assembly},#{definition},$)",
                number + 1
            ));
            let place = file.add(&format!("PRODUCT_DEFINITION_SHAPE('',$,#{usage})"));
            let identity = file.add(&format!("ITEM_DEFINED_TRANSFORMATION('','',#{origin},#{origin})"));
            let relation = file.add(&format!(
                "(REPRESENTATION_RELATIONSHIP('','',#{shape},#{whole})\
                 REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{identity})SHAPE_REPRESENTATION_RELATIONSHIP())"
            ));
            file.add(&format!("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{relation},#{place})"));
        }
    }
    let styles = references(&styles);
    file.add(&format!("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',{styles},#{units})"));

    let (title, time) = (text(&header.title), text(&header.time));
    format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('solids of crankshaft parts'),'2;1');\n\
         FILE_NAME({title},{time},(''),(''),'lanchester','lanchester','');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
        file.data
    )
}

/// The entities written so far, and the numbers of those that many use.
struct File {
    data: String,
    last: usize,
    units: usize,
    product_context: usize,
    design_context: usize,
}

impl File {
    fn new() -> File {
        let mut file = File { data: String::new(), last: 0, units: 0, product_context: 0, design_context: 0 };
        let context = file.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        file.add(&format!(
            "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{context})"
        ));
        file.product_context = file.add(&format!("PRODUCT_CONTEXT('',#{context},'mechanical')"));
        file.design_context =
            file.add(&format!("PRODUCT_DEFINITION_CONTEXT('part definition',#{context},'design')"));
        file.units = file.shared_units();
        file
    }

    /// A product with its shape: the number of its definition.
    fn product(&mut self, name: &str, shape: usize) -> usize {
        let (name, number) = (text(name), self.last + 1);
        let (context, design) = (self.product_context, self.design_context);
        let product = self.add(&format!("PRODUCT('{number}',{name},'',(#{context}))"));
        self.add(&format!("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#{product}))"));
        let formation = self.add(&format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
        let definition = self.add(&format!("PRODUCT_DEFINITION('design','',#{formation},#{design})"));
        let of_shape = self.add(&format!("PRODUCT_DEFINITION_SHAPE('',$,#{definition})"));
        self.add(&format!("SHAPE_DEFINITION_REPRESENTATION(#{of_shape},#{shape})"));
        definition
    }

    /// Writes an entity and gives its number.
    fn add(&mut self, entity: &str) -> usize {
        self.last += 1;
        writeln!(self.data, "#{}={entity};", self.last).expect("invariant: writing to a string succeeds");
        self.last
    }

    /// Millimetre, radian, steradian, and how far points may lie apart that are one: the number of the context.
    fn shared_units(&mut self) -> usize {
        let length = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
        let angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        let solid_angle = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
        let within = number(1e3 * super::RESOLUTION);
        let uncertainty = self.add(&format!(
            "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({within}),#{length},'distance_accuracy_value','')"
        ));
        self.add(&format!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{uncertainty}))\
             GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid_angle}))REPRESENTATION_CONTEXT('',''))"
        ))
    }

    /// A point [m].
    fn point(&mut self, at: [f64; 3]) -> usize {
        let at = triple(at.map(|x| 1e3 * x));
        self.add(&format!("CARTESIAN_POINT('',{at})"))
    }

    fn direction(&mut self, along: [f64; 3]) -> usize {
        self.add(&format!("DIRECTION('',{})", triple(along)))
    }

    fn placement(&mut self, at: [f64; 3], axis: [f64; 3], reference: [f64; 3]) -> usize {
        let (at, axis, reference) = (self.point(at), self.direction(axis), self.direction(reference));
        self.add(&format!("AXIS2_PLACEMENT_3D('',#{at},#{axis},#{reference})"))
    }

    fn solid(&mut self, solid: &Solid) -> usize {
        let vertices: Vec<(usize, usize)> = solid
            .vertices
            .iter()
            .map(|at| {
                let point = self.point(*at);
                (point, self.add(&format!("VERTEX_POINT('',#{point})")))
            })
            .collect();
        let edges: Vec<usize> = solid
            .edges
            .iter()
            .map(|side| {
                let (from, to) = (solid.vertices[side.from], solid.vertices[side.to]);
                let curve = match side.curve {
                    Curve::Line => self.line(vertices[side.from].0, from, to),
                    Curve::Arc(arc) => self.circle(&arc, from[2]),
                    Curve::Rise(plan, slope) => match rise(&plan, &slope) {
                        Rise::Line => self.line(vertices[side.from].0, from, to),
                        Rise::Circle => self.circle(&plan, from[2]),
                        Rise::Conic(conic) => self.conic(&conic),
                        Rise::Spline(points) => self.spline(&points),
                    },
                };
                let (from, to) = (vertices[side.from].1, vertices[side.to].1);
                self.add(&format!("EDGE_CURVE('',#{from},#{to},#{curve},.T.)"))
            })
            .collect();
        let mut shells = vec![Vec::new(); solid.shells];
        for face in &solid.faces {
            let mut bounds = Vec::with_capacity(face.loops.len());
            for (at, boundary) in face.loops.iter().enumerate() {
                let oriented: Vec<usize> = boundary
                    .iter()
                    .map(|(edge, forward)| {
                        let sense = if *forward { 'T' } else { 'F' };
                        self.add(&format!("ORIENTED_EDGE('',*,*,#{},.{sense}.)", edges[*edge]))
                    })
                    .collect();
                let boundary = self.add(&format!("EDGE_LOOP('',{})", references(&oriented)));
                let kind = if at == 0 { "FACE_OUTER_BOUND" } else { "FACE_BOUND" };
                bounds.push(self.add(&format!("{kind}('',#{boundary},.T.)")));
            }
            let (first, forward) = face.loops[0][0];
            let side = &solid.edges[first];
            let begin = solid.vertices[if forward { side.from } else { side.to }];
            let (surface, sense) = self.surface(&face.surface, begin);
            let bounds = references(&bounds);
            shells[face.shell].push(self.add(&format!("ADVANCED_FACE('',{bounds},#{surface},.{sense}.)")));
        }
        let name = text(solid.name());
        let shells: Vec<usize> =
            shells.iter().map(|faces| self.add(&format!("CLOSED_SHELL('',{})", references(faces)))).collect();
        if shells.len() == 1 {
            return self.add(&format!("MANIFOLD_SOLID_BREP({name},#{})", shells[0]));
        }
        // The faces of a cavity already have their normals out of the material, into the cavity.
        let cavities: Vec<usize> = shells[1..]
            .iter()
            .map(|shell| self.add(&format!("ORIENTED_CLOSED_SHELL('',*,#{shell},.T.)")))
            .collect();
        self.add(&format!("BREP_WITH_VOIDS({name},#{},{})", shells[0], references(&cavities)))
    }

    /// A surface and whether its own normal is that of the face; `begin` is a point of it [m].
    fn surface(&mut self, surface: &Surface, begin: [f64; 3]) -> (usize, char) {
        match *surface {
            Surface::Level { up } => {
                let normal = [0.0, 0.0, if up { 1.0 } else { -1.0 }];
                let placement = self.placement(begin, normal, [1.0, 0.0, 0.0]);
                (self.add(&format!("PLANE('',#{placement})")), 'T')
            }
            Surface::Flat { normal } => {
                let placement = self.placement(begin, [normal.x, normal.y, 0.0], [0.0, 0.0, 1.0]);
                (self.add(&format!("PLANE('',#{placement})")), 'T')
            }
            Surface::Round { centre, radius, outwards } => {
                let out = towards(Point::new(begin[0], begin[1]) - centre);
                let placement = self.placement([centre.x, centre.y, begin[2]], [0.0, 0.0, 1.0], out);
                let radius = number(1e3 * radius);
                let surface = self.add(&format!("CYLINDRICAL_SURFACE('',#{placement},{radius})"));
                (surface, if outwards { 'T' } else { 'F' })
            }
            Surface::Slope(slope) => {
                let at = Point::new(begin[0], begin[1]);
                let Cut::Turned { radius } = slope.cut else {
                    let deeper = slope.deeper(at).right();
                    let placement = self.placement(begin, slope.normal(at), [deeper.x, deeper.y, 0.0]);
                    return (self.add(&format!("PLANE('',#{placement})")), 'T');
                };
                let axis = [0.0, 0.0, slope.into];
                let placement = self.placement([0.0, 0.0, slope.face], axis, towards(at));
                let (radius, angle) = (number(1e3 * radius), number(FRAC_PI_2 - slope.angle));
                (self.add(&format!("CONICAL_SURFACE('',#{placement},{radius},{angle})")), 'T')
            }
        }
    }

    /// A line from a point that is written already.
    fn line(&mut self, start: usize, from: [f64; 3], to: [f64; 3]) -> usize {
        let along = [0, 1, 2].map(|i| to[i] - from[i]);
        let length = along[0].hypot(along[1]).hypot(along[2]);
        let direction = self.direction(along.map(|x| x / length));
        let vector = self.add(&format!("VECTOR('',#{direction},1.)"));
        self.add(&format!("LINE('',#{start},#{vector})"))
    }

    /// The circle of an arc, run in the sense of the arc from where it begins.
    fn circle(&mut self, arc: &Edge, z: f64) -> usize {
        let centre = arc.centre();
        let axis = [0.0, 0.0, if arc.bulge > 0.0 { 1.0 } else { -1.0 }];
        let placement = self.placement([centre.x, centre.y, z], axis, towards(arc.from - centre));
        let radius = number(1e3 * arc.radius());
        self.add(&format!("CIRCLE('',#{placement},{radius})"))
    }

    /// An ellipse or a hyperbola.
    fn conic(&mut self, conic: &Conic) -> usize {
        let placement = self.placement(conic.centre, conic.normal, conic.first);
        let [first, second] = conic.axes.map(|axis| number(1e3 * axis));
        self.add(&format!("{}('',#{placement},{first},{second})", conic.kind))
    }

    /// A spline of cubic pieces that share their tangents: both ends and two points for each piece.
    fn spline(&mut self, points: &[[f64; 3]]) -> usize {
        let controls: Vec<usize> = points.iter().map(|at| self.point(*at)).collect();
        let pieces = (points.len() - 2) / 2;
        let inner = vec!["2"; pieces - 1];
        let counts = [vec!["4"], inner, vec!["4"]].concat().join(",");
        let knots: Vec<String> = (0..=pieces).map(|k| number(k as f64)).collect();
        let (controls, knots) = (references(&controls), knots.join(","));
        self.add(&format!(
            "B_SPLINE_CURVE_WITH_KNOTS('',3,{controls},.UNSPECIFIED.,.F.,.F.,({counts}),({knots}),.UNSPECIFIED.)"
        ))
    }

    fn style(&mut self, item: usize, colour: [f64; 3]) -> usize {
        let [red, green, blue] = colour.map(number);
        let colour = self.add(&format!("COLOUR_RGB('',{red},{green},{blue})"));
        let fill = self.add(&format!("FILL_AREA_STYLE_COLOUR('',#{colour})"));
        let area = self.add(&format!("FILL_AREA_STYLE('',(#{fill}))"));
        let surface = self.add(&format!("SURFACE_STYLE_FILL_AREA(#{area})"));
        let side = self.add(&format!("SURFACE_SIDE_STYLE('',(#{surface}))"));
        let usage = self.add(&format!("SURFACE_STYLE_USAGE(.BOTH.,#{side})"));
        let assignment = self.add(&format!("PRESENTATION_STYLE_ASSIGNMENT((#{usage}))"));
        self.add(&format!("STYLED_ITEM('color',(#{assignment}),#{item})"))
    }
}

/// Unit vector in the plane across the crank.
fn towards(vector: Point) -> [f64; 3] {
    let unit = vector * (1.0 / vector.norm());
    [unit.x, unit.y, 0.0]
}

fn references(numbers: &[usize]) -> String {
    let all: Vec<String> = numbers.iter().map(|number| format!("#{number}")).collect();
    format!("({})", all.join(","))
}

fn triple([x, y, z]: [f64; 3]) -> String {
    format!("({},{},{})", number(x), number(y), number(z))
}

/// A real of ISO 10303-21: always with a point, the exponent with a capital E; the shortest that reads back as the same bits.
fn number(value: f64) -> String {
    // Plus zero turns a negative zero into a positive one.
    let digits = format!("{:?}", value + 0.0);
    match digits.split_once('e') {
        Some((mantissa, exponent)) if mantissa.contains('.') => format!("{mantissa}E{exponent}"),
        Some((mantissa, exponent)) => format!("{mantissa}.E{exponent}"),
        None => digits.strip_suffix('0').filter(|rest| rest.ends_with('.')).unwrap_or(&digits).to_string(),
    }
}

/// A string of ISO 10303-21 in its quotes: apostrophes and backslashes doubled, what is not ASCII as hexadecimal code points.
fn text(words: &str) -> String {
    let mut quoted = String::from("'");
    for letter in words.chars() {
        match letter {
            '\'' => quoted.push_str("''"),
            '\\' => quoted.push_str("\\\\"),
            ' '..='~' => quoted.push(letter),
            _ => {
                quoted.push_str(if u32::from(letter) < 0x10000 { "\\X2\\" } else { "\\X4\\" });
                let width = if u32::from(letter) < 0x10000 { 4 } else { 8 };
                write!(quoted, "{:0width$X}", u32::from(letter))
                    .expect("invariant: writing to a string succeeds");
                quoted.push_str("\\X0\\");
            }
        }
    }
    quoted.push('\'');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_a_point_and_a_capital_exponent() {
        let cases =
            [(0.0, "0."), (-0.0, "0."), (1.0, "1."), (-2.5, "-2.5"), (1e-7, "1.E-7"), (1.5e300, "1.5E300")];
        for (value, expected) in cases {
            assert_eq!(number(value), expected);
        }
        assert_eq!(number(100.0), "100.");
    }

    #[test]
    fn strings_are_quoted_and_coded() {
        assert_eq!(text("crank's \\ web"), "'crank''s \\\\ web'");
        assert_eq!(text("Kr\u{f6}pfung\n"), "'Kr\\X2\\00F6\\X0\\pfung\\X2\\000A\\X0\\'");
        assert_eq!(text("\u{1f600}"), "'\\X4\\0001F600\\X0\\'");
    }
}
