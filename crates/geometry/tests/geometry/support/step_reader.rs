//! A small reader of STEP files that knows nothing of the writer: it parses the entities, checks that shells are closed and
//! curves lie on their surfaces, and integrates over the analytic faces.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A value of ISO 10303-21.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    Number(f64),
    Text(String),
    Reference(usize),
    List(Vec<Value>),
    Word(String),
}

/// An entity: its kind and its values; of a complex one, all kinds with theirs.
pub type Entity = Vec<(String, Vec<Value>)>;

/// A parsed file.
#[derive(Debug)]
pub struct StepFile {
    pub entities: BTreeMap<usize, Entity>,
}

struct Reader<'a> {
    rest: &'a [u8],
}

impl Reader<'_> {
    fn skip(&mut self) {
        while self.rest.first().is_some_and(u8::is_ascii_whitespace) {
            self.rest = &self.rest[1..];
        }
    }

    fn take(&mut self, byte: u8) -> bool {
        self.skip();
        let found = self.rest.first() == Some(&byte);
        if found {
            self.rest = &self.rest[1..];
        }
        found
    }

    fn while_true(&mut self, keep: impl Fn(u8) -> bool) -> String {
        self.skip();
        let count = self.rest.iter().take_while(|byte| keep(**byte)).count();
        let (word, rest) = self.rest.split_at(count);
        self.rest = rest;
        String::from_utf8(word.to_vec()).unwrap()
    }

    fn list(&mut self) -> Vec<Value> {
        assert!(self.take(b'('), "a list begins with a bracket");
        let mut list = Vec::new();
        if self.take(b')') {
            return list;
        }
        loop {
            list.push(self.value());
            if self.take(b')') {
                return list;
            }
            assert!(self.take(b','), "values are separated by commas");
        }
    }

    fn value(&mut self) -> Value {
        self.skip();
        match self.rest[0] {
            b'#' => {
                self.rest = &self.rest[1..];
                Value::Reference(self.while_true(|b| b.is_ascii_digit()).parse().unwrap())
            }
            b'(' => Value::List(self.list()),
            b'\'' => {
                let mut text = Vec::new();
                self.rest = &self.rest[1..];
                loop {
                    let byte = self.rest[0];
                    self.rest = &self.rest[1..];
                    if byte == b'\'' {
                        if self.rest[0] != b'\'' {
                            return Value::Text(String::from_utf8(text).unwrap());
                        }
                        self.rest = &self.rest[1..];
                    }
                    text.push(byte);
                }
            }
            b'*' | b'$' => {
                let word = self.rest[0];
                self.rest = &self.rest[1..];
                Value::Word(char::from(word).to_string())
            }
            b'.' => Value::Word(self.while_true(|b| b == b'.' || b.is_ascii_alphabetic())),
            b'A'..=b'Z' => {
                let word = self.while_true(|b| b.is_ascii_alphanumeric() || b == b'_');
                let inner = self.list();
                Value::List(vec![Value::Word(word), Value::List(inner)])
            }
            _ => {
                let digits = self.while_true(|b| b"+-.0123456789E".contains(&b));
                assert!(!digits.contains('.') || !digits.starts_with('.'), "{digits}");
                Value::Number(digits.parse().unwrap())
            }
        }
    }

    fn entity(&mut self) -> Entity {
        let kind = |reader: &mut Self| {
            let word = reader.while_true(|b| b.is_ascii_alphanumeric() || b == b'_');
            (word, reader.list())
        };
        if !self.take(b'(') {
            return vec![kind(self)];
        }
        let mut all = Vec::new();
        while !self.take(b')') {
            all.push(kind(self));
        }
        all
    }
}

type Vector = [f64; 3];

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
fn along(a: Vector, t: f64, b: Vector) -> Vector {
    [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]]
}
fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Origin and three axes.
type Frame = (Vector, [Vector; 3]);

/// A solid as read.
#[derive(Debug)]
pub struct ReadSolid {
    pub name: String,
    pub faces: usize,
    /// Volume [mm^3].
    pub volume: f64,
    /// Centroid [mm].
    pub centroid: Vector,
}

/// Point and derivative by a parameter from 0 to 1.
type Parametric = dyn Fn(f64) -> (Vector, Vector);

enum Curve {
    Line(Vector, Vector),
    Ellipse(Frame, [f64; 2]),
    Hyperbola(Frame, [f64; 2]),
    /// Control points of cubic pieces that share their tangents.
    Spline(Vec<Vector>),
}

enum Surface {
    Plane(Frame),
    Cylinder(Frame, f64),
    /// Radius at the origin and half the angle at the tip.
    Cone(Frame, [f64; 2]),
}

impl StepFile {
    pub fn parse(text: &str) -> StepFile {
        assert!(text.starts_with("ISO-10303-21;") && text.trim_end().ends_with("END-ISO-10303-21;"));
        assert!(text.is_ascii());
        let data = &text[text.find("DATA;").unwrap() + 5..];
        let mut reader = Reader { rest: &data.as_bytes()[..data.rfind("ENDSEC;").unwrap()] };
        let mut entities = BTreeMap::new();
        while reader.take(b'#') {
            let number = reader.while_true(|b| b.is_ascii_digit()).parse().unwrap();
            assert!(reader.take(b'='));
            assert!(entities.insert(number, reader.entity()).is_none(), "number {number} twice");
            assert!(reader.take(b';'));
        }
        assert!(reader.rest.is_empty());
        let file = StepFile { entities };
        for value in file.entities.values().flatten().flat_map(|(_, values)| values) {
            file.check_references(value);
        }
        file
    }

    fn check_references(&self, value: &Value) {
        match value {
            Value::Reference(number) => assert!(self.entities.contains_key(number), "#{number} is missing"),
            Value::List(values) => values.iter().for_each(|value| self.check_references(value)),
            _ => {}
        }
    }

    /// Kind and values of a simple entity.
    fn get(&self, value: &Value) -> (&str, &[Value]) {
        let Value::Reference(number) = value else { panic!("no reference: {value:?}") };
        let [(kind, values)] = &self.entities[number][..] else { panic!("#{number} is complex") };
        (kind, values)
    }

    /// Values of a simple entity of this kind.
    fn expect(&self, value: &Value, kind: &str) -> &[Value] {
        let (found, values) = self.get(value);
        assert_eq!(found, kind);
        values
    }

    fn triple(&self, value: &Value, kind: &str) -> Vector {
        let Value::List(numbers) = &self.expect(value, kind)[1] else { panic!("no list") };
        [0, 1, 2].map(|i| number(&numbers[i]))
    }

    fn frame(&self, value: &Value) -> Frame {
        let values = self.expect(value, "AXIS2_PLACEMENT_3D");
        let z = self.triple(&values[2], "DIRECTION");
        let x = self.triple(&values[3], "DIRECTION");
        assert!(
            (dot(z, z) - 1.0).abs() < 1e-14 && (dot(x, x) - 1.0).abs() < 1e-14 && dot(x, z).abs() < 1e-14
        );
        (self.triple(&values[1], "CARTESIAN_POINT"), [x, cross(z, x), z])
    }

    fn vertex(&self, value: &Value) -> Vector {
        self.triple(&self.expect(value, "VERTEX_POINT")[1], "CARTESIAN_POINT")
    }

    fn curve(&self, value: &Value) -> Curve {
        match self.get(value) {
            ("LINE", values) => {
                let vector = self.expect(&values[2], "VECTOR");
                let direction = self.triple(&vector[1], "DIRECTION");
                assert!((dot(direction, direction) - 1.0).abs() < 1e-14);
                Curve::Line(self.triple(&values[1], "CARTESIAN_POINT"), direction)
            }
            ("CIRCLE", values) => Curve::Ellipse(self.frame(&values[1]), [number(&values[2]); 2]),
            ("ELLIPSE", values) => Curve::Ellipse(self.frame(&values[1]), [2, 3].map(|k| number(&values[k]))),
            ("HYPERBOLA", values) => {
                Curve::Hyperbola(self.frame(&values[1]), [2, 3].map(|k| number(&values[k])))
            }
            ("B_SPLINE_CURVE_WITH_KNOTS", values) => self.spline(values),
            (kind, _) => panic!("no such curve: {kind}"),
        }
    }

    fn surface(&self, value: &Value) -> Surface {
        match self.get(value) {
            ("PLANE", values) => Surface::Plane(self.frame(&values[1])),
            ("CONICAL_SURFACE", values) => {
                Surface::Cone(self.frame(&values[1]), [2, 3].map(|k| number(&values[k])))
            }
            ("CYLINDRICAL_SURFACE", values) => Surface::Cylinder(self.frame(&values[1]), number(&values[2])),
            (kind, _) => panic!("no such surface: {kind}"),
        }
    }

    /// A cubic spline with every knot within it twice, one apart.
    fn spline(&self, values: &[Value]) -> Curve {
        let list = |value: &Value| -> Vec<Value> {
            let Value::List(values) = value else { panic!("no list: {value:?}") };
            values.clone()
        };
        assert_eq!(values[1], Value::Number(3.0));
        let points: Vec<Vector> =
            list(&values[2]).iter().map(|point| self.triple(point, "CARTESIAN_POINT")).collect();
        let counts: Vec<f64> = list(&values[6]).iter().map(number).collect();
        let knots: Vec<f64> = list(&values[7]).iter().map(number).collect();
        let last = counts.len() - 1;
        for (k, (count, knot)) in counts.iter().zip(&knots).enumerate() {
            assert_eq!((*count, *knot), (if k == 0 || k == last { 4.0 } else { 2.0 }, k as f64));
        }
        assert_eq!((points.len(), knots.len()), (2 * last + 2, last + 1));
        Curve::Spline(points)
    }

    /// Whether lengths are millimetres.
    pub fn is_in_millimetres(&self) -> bool {
        let milli = [Value::Word(".MILLI.".into()), Value::Word(".METRE.".into())];
        self.entities.values().any(|entity| {
            entity.iter().any(|(kind, values)| kind == "SI_UNIT" && values[..] == milli)
                && entity.iter().any(|(kind, _)| kind == "LENGTH_UNIT")
        })
    }

    /// The solids of the shape representation, checked and integrated. `slack` is how far points may lie off curves and
    /// surfaces [mm].
    pub fn solids(&self, slack: f64) -> Vec<ReadSolid> {
        let of = |kind: &str| {
            self.entities.values().filter(|e| e[0].0 == kind).map(|e| e[0].1.clone()).collect::<Vec<_>>()
        };
        // Every component stands in the assembly where it is.
        for transformation in of("ITEM_DEFINED_TRANSFORMATION") {
            assert_eq!(self.frame(&transformation[2]), self.frame(&transformation[3]));
        }
        let representations = of("ADVANCED_BREP_SHAPE_REPRESENTATION");
        let count = representations.len();
        let components = if count == 1 { 0 } else { count };
        assert_eq!(of("NEXT_ASSEMBLY_USAGE_OCCURRENCE").len(), components);
        assert_eq!(of("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION").len(), components);
        assert_eq!(of("SHAPE_DEFINITION_REPRESENTATION").len(), count + usize::from(count > 1));
        let items = representations.iter().flat_map(|values| {
            let Value::List(items) = &values[1] else { panic!("no items") };
            items
        });
        let mut solids = Vec::new();
        for item in items {
            let (kind, values) = self.get(item);
            let mut shells = Vec::new();
            match kind {
                "AXIS2_PLACEMENT_3D" => continue,
                "MANIFOLD_SOLID_BREP" => shells.push(values[1].clone()),
                "BREP_WITH_VOIDS" => {
                    shells.push(values[1].clone());
                    let Value::List(voids) = &values[2] else { panic!("no voids") };
                    for void in voids {
                        let oriented = self.expect(void, "ORIENTED_CLOSED_SHELL");
                        assert_eq!(oriented[3], Value::Word(".T.".into()));
                        shells.push(oriented[2].clone());
                    }
                }
                _ => panic!("no solid: {kind}"),
            }
            let Value::Text(name) = &values[0] else { panic!("no name") };
            let (mut sums, mut faces) = ([0.0; 4], 0);
            for (at, shell) in shells.iter().enumerate() {
                let (part, count) = self.shell(shell, slack);
                assert_eq!(part[0] > 0.0, at == 0, "the outer shell holds volume, cavities take it away");
                faces += count;
                sums = [0, 1, 2, 3].map(|i| sums[i] + part[i]);
            }
            let centroid = [1, 2, 3].map(|i| sums[i] / sums[0]);
            solids.push(ReadSolid { name: name.clone(), faces, volume: sums[0], centroid });
        }
        solids
    }

    /// Volume and first moments within a closed shell, and how many faces it has.
    fn shell(&self, shell: &Value, slack: f64) -> ([f64; 4], usize) {
        let Value::List(faces) = &self.expect(shell, "CLOSED_SHELL")[1] else { panic!("no faces") };
        let mut uses: BTreeMap<usize, Vec<bool>> = BTreeMap::new();
        let mut sums = [0.0; 4];
        for face in faces {
            let part = self.face(face, slack, &mut uses);
            sums = [0, 1, 2, 3].map(|i| sums[i] + part[i]);
        }
        for (edge, senses) in uses {
            assert!(senses.len() == 2 && senses[0] != senses[1], "edge #{edge} is used {senses:?}");
        }
        (sums, faces.len())
    }

    /// What a face adds to volume and first moments by the divergence theorem.
    fn face(&self, face: &Value, slack: f64, uses: &mut BTreeMap<usize, Vec<bool>>) -> [f64; 4] {
        let values = self.expect(face, "ADVANCED_FACE");
        let surface = self.surface(&values[2]);
        let sense = if values[3] == Value::Word(".T.".into()) { 1.0 } else { -1.0 };
        let Value::List(bounds) = &values[1] else { panic!("no bounds") };
        let mut sums = [0.0; 5];
        for bound in bounds {
            let (kind, bound) = self.get(bound);
            assert!(kind == "FACE_OUTER_BOUND" || kind == "FACE_BOUND");
            assert_eq!(bound[2], Value::Word(".T.".into()));
            let Value::List(edges) = &self.expect(&bound[1], "EDGE_LOOP")[1] else { panic!("no edges") };
            let mut ends: Vec<[Value; 2]> = Vec::new();
            for edge in edges {
                let oriented = self.expect(edge, "ORIENTED_EDGE");
                let forward = oriented[4] == Value::Word(".T.".into());
                let Value::Reference(number) = oriented[3] else { panic!("no edge") };
                uses.entry(number).or_default().push(forward);
                let curve = self.expect(&oriented[3], "EDGE_CURVE");
                assert_eq!(curve[4], Value::Word(".T.".into()));
                let (from, to) = (curve[1].clone(), curve[2].clone());
                ends.push(if forward { [from, to] } else { [to, from] });
                let (start, end) = (self.vertex(&curve[1]), self.vertex(&curve[2]));
                let part = edge_integral(&surface, &self.curve(&curve[3]), [start, end], slack);
                sums = [0, 1, 2, 3, 4].map(|i| sums[i] + if forward { part[i] } else { -part[i] });
            }
            for (one, next) in ends.iter().zip(ends.iter().cycle().skip(1)) {
                assert_eq!(one[1], next[0], "a loop is open");
            }
        }
        // The loops run anticlockwise about the normal of the face, which `sense` tells from that of the surface.
        assert!(sense * sums[4] > 0.0, "a face is inside out");
        [0, 1, 2, 3].map(|i| sums[i])
    }
}

/// What an edge adds to: volume, three first moments, area about the normal of the surface.
fn edge_integral(surface: &Surface, curve: &Curve, [start, end]: [Vector; 2], slack: f64) -> [f64; 5] {
    let near = |a: Vector, b: Vector| dot(minus(a, b), minus(a, b)).sqrt() < slack;
    // Pieces of the curve: point and derivative by a parameter from 0 to 1.
    let (point, pieces): (Box<Parametric>, usize) = match curve {
        Curve::Line(origin, direction) => {
            let (from, to) = (dot(minus(start, *origin), *direction), dot(minus(end, *origin), *direction));
            assert!(to > from, "a line runs against its direction");
            let (origin, direction) = (*origin, *direction);
            let derivative = along([0.0; 3], to - from, direction);
            (Box::new(move |t| (along(origin, from + t * (to - from), direction), derivative)), 1)
        }
        Curve::Ellipse((centre, [x, y, _]), [first, second]) => {
            let angle = |at: Vector| {
                let out = minus(at, *centre);
                (dot(out, *y) / second).atan2(dot(out, *x) / first)
            };
            let from = angle(start);
            let sweep = (angle(end) - from).rem_euclid(TAU);
            let (centre, x, y, first, second) = (*centre, *x, *y, *first, *second);
            let point = move |t: f64| {
                let (s, c) = (from + t * sweep).sin_cos();
                let at = along(along(centre, first * c, x), second * s, y);
                (at, along(along([0.0; 3], -first * s * sweep, x), second * c * sweep, y))
            };
            (Box::new(point), (sweep / 0.3).ceil() as usize)
        }
        Curve::Hyperbola((centre, [x, y, _]), [first, second]) => {
            let parameter = |at: Vector| (dot(minus(at, *centre), *y) / second).asinh();
            let (from, to) = (parameter(start), parameter(end));
            assert!(to > from, "a hyperbola runs against its direction");
            let (centre, x, y, first, second) = (*centre, *x, *y, *first, *second);
            let point = move |t: f64| {
                let u = from + t * (to - from);
                let at = along(along(centre, first * u.cosh(), x), second * u.sinh(), y);
                let derivative = along(along([0.0; 3], first * u.sinh(), x), second * u.cosh(), y);
                (at, derivative.map(|d| d * (to - from)))
            };
            (Box::new(point), ((to - from) / 0.2).ceil() as usize)
        }
        Curve::Spline(points) => {
            let (points, pieces) = (points.clone(), points.len() / 2 - 1);
            let point = move |t: f64| {
                let piece = ((t * pieces as f64) as usize).min(pieces - 1);
                let middle = |k: usize| [0, 1, 2].map(|i| 0.5 * (points[2 * k][i] + points[2 * k + 1][i]));
                let from = if piece == 0 { points[0] } else { middle(piece) };
                let to = if piece + 1 == pieces { points[2 * pieces + 1] } else { middle(piece + 1) };
                let (b, c) = (points[2 * piece + 1], points[2 * piece + 2]);
                let v = t * pieces as f64 - piece as f64;
                let u = 1.0 - v;
                let at = [0, 1, 2].map(|i| {
                    u * u * u * from[i] + 3.0 * u * u * v * b[i] + 3.0 * u * v * v * c[i] + v * v * v * to[i]
                });
                let derivative = [0, 1, 2].map(|i| {
                    let slope =
                        u * u * (b[i] - from[i]) + 2.0 * u * v * (c[i] - b[i]) + v * v * (to[i] - c[i]);
                    3.0 * slope * pieces as f64
                });
                (at, derivative)
            };
            (Box::new(point), pieces)
        }
    };
    assert!(near(point(0.0).0, start) && near(point(1.0).0, end), "a vertex is off its curve");
    let mut sums = [0.0; 5];
    for piece in 0..pieces {
        for (node, weight) in GAUSS {
            let t = (piece as f64 + 0.5 + 0.5 * node) / pieces as f64;
            let (at, derivative) = point(t);
            let step = along([0.0; 3], 0.5 * weight / pieces as f64, derivative);
            // INTEGRAL g du dv = CLOSED INTEGRAL (INTEGRAL g du) dv, from the line u = 0 to the edge.
            let (origin, axis, dv, normal): (Vector, Vector, f64, Vector) = match surface {
                Surface::Plane((origin, [x, y, z])) => {
                    let (u, height) = (dot(minus(at, *origin), *x), dot(minus(at, *origin), *z));
                    assert!(height.abs() < slack, "a curve is off its plane by {height}");
                    (along(at, -u, *x), along([0.0; 3], u, *x), dot(step, *y), *z)
                }
                Surface::Cone((origin, [_, _, z]), [radius, angle]) => {
                    let height = dot(minus(at, *origin), *z);
                    let foot = along(*origin, height, *z);
                    let out = minus(at, foot);
                    let distance = dot(out, out).sqrt();
                    let off = (distance - radius - height * angle.tan()).abs() * angle.cos();
                    assert!(off < slack, "a curve is off its cone by {off}");
                    let out = along([0.0; 3], 1.0 / distance, out);
                    let tip = along(*origin, -radius / angle.tan(), *z);
                    let normal = along(along([0.0; 3], angle.cos(), out), -angle.sin(), *z);
                    // From the tip to the edge and against the angle; the width shrinks towards the tip, see below.
                    (tip, minus(at, tip), -dot(step, cross(*z, out)), normal)
                }
                Surface::Cylinder((origin, [_, _, z]), radius) => {
                    let height = dot(minus(at, *origin), *z);
                    let foot = along(at, -height, *z);
                    let out = minus(foot, *origin);
                    let distance = dot(out, out).sqrt();
                    assert!((distance - radius).abs() < slack, "a curve is off its cylinder");
                    let out = along([0.0; 3], 1.0 / distance, out);
                    // u along the axis and v against the angle: right-handed about the normal outwards.
                    (foot, along([0.0; 3], height, *z), -dot(step, cross(*z, out)), out)
                }
            };
            let length = dot(axis, axis).sqrt();
            let sign = match surface {
                Surface::Cone(..) => 1.0,
                Surface::Plane((_, [x, ..])) => dot(axis, *x).signum(),
                Surface::Cylinder((_, [_, _, z]), _) => dot(axis, *z).signum(),
            };
            for (node, weight) in GAUSS {
                let p = along(origin, 0.5 + 0.5 * node, axis);
                let shrink = if let Surface::Cone(..) = surface { 0.5 + 0.5 * node } else { 1.0 };
                let da = sign * length * 0.5 * weight * dv * shrink;
                // A third of the flux of x, and of x^2/2 e_x, y^2/2 e_y, z^2/2 e_z.
                sums[0] += dot(p, normal) / 3.0 * da;
                for i in 0..3 {
                    sums[i + 1] += p[i] * p[i] / 2.0 * normal[i] * da;
                }
                sums[4] += da;
            }
        }
    }
    sums
}

fn number(value: &Value) -> f64 {
    let Value::Number(number) = value else { panic!("no number: {value:?}") };
    *number
}

/// Five Gauss points on [-1, 1].
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];
