//! Lines and arcs of DXF entities, in units of the drawing.

use super::DrawingError;
use super::dxf_tags::Record;
use super::strand::Strand;
use lanchester_shape::Edge;
use lanchester_shape::Point;

/// Edges and whether they close.
pub(super) type Edges = (Vec<Edge>, bool);

/// The plane of an entity: as the drawing, or seen from below.
#[derive(Clone, Copy)]
struct Plane {
    mirrored: bool,
}

impl Plane {
    /// From the extrusion direction. By the arbitrary axis algorithm of DXF that of (0, 0, -1) has x turned round.
    fn of(entity: &Record) -> Result<Plane, DrawingError> {
        let default = [0.0, 0.0, 1.0];
        let mut normal = default;
        for (value, code) in normal.iter_mut().zip([210, 220, 230]) {
            *value = entity.optional(code)?.unwrap_or(*value);
        }
        let across = normal[0].hypot(normal[1]);
        if across.is_nan() || across > 1e-9 * normal[2].abs() || normal[2] == 0.0 {
            let hint = "draw in the plane z = 0, or flatten the drawing";
            return Err(entity.unsupported("does not lie in the plane of the drawing", hint));
        }
        Ok(Plane { mirrored: normal[2] < 0.0 })
    }

    fn point(self, x: f64, y: f64) -> Point {
        Point::new(if self.mirrored { -x } else { x }, y)
    }

    fn edge(self, edge: Edge) -> Edge {
        if !self.mirrored {
            return edge;
        }
        let map = |point: Point| self.point(point.x, point.y);
        Edge { from: map(edge.from), to: map(edge.to), bulge: -edge.bulge }
    }
}

/// LINE.
pub(super) fn line(entity: &Record) -> Result<Edges, DrawingError> {
    let number = |code, missing| entity.number(code, missing);
    let from = Point::new(number(10, "beginning (10)")?, number(20, "beginning (20)")?);
    let to = Point::new(number(11, "end (11)")?, number(21, "end (21)")?);
    let heights = [entity.optional(30)?, entity.optional(31)?].map(Option::unwrap_or_default);
    if heights[0] != heights[1] {
        let hint = "draw in the plane z = 0, or flatten the drawing";
        return Err(entity.unsupported("rises out of the plane of the drawing", hint));
    }
    Ok((vec![Edge::line(from, to)], false))
}

fn centre_and_radius(entity: &Record) -> Result<(Point, f64), DrawingError> {
    let centre = Point::new(entity.number(10, "centre (10)")?, entity.number(20, "centre (20)")?);
    let radius = entity.number(40, "radius (40)")?;
    if radius > 0.0 {
        return Ok((centre, radius));
    }
    Err(entity.unsupported("has a radius that is not positive", "delete it or draw it again"))
}

/// CIRCLE.
pub(super) fn circle(entity: &Record) -> Result<Edges, DrawingError> {
    let plane = Plane::of(entity)?;
    let (centre, radius) = centre_and_radius(entity)?;
    Ok((Strand::circle(plane.point(centre.x, centre.y), radius), true))
}

/// ARC: anticlockwise, angles in degrees.
pub(super) fn arc(entity: &Record) -> Result<Edges, DrawingError> {
    let plane = Plane::of(entity)?;
    let (centre, radius) = centre_and_radius(entity)?;
    let start = entity.number(50, "start angle (50)")?;
    let end = entity.number(51, "end angle (51)")?;
    let sweep = end - start;
    if sweep.abs() == 360.0 {
        return Ok((Strand::circle(plane.point(centre.x, centre.y), radius), true));
    }
    let sweep = sweep.rem_euclid(360.0);
    if sweep == 0.0 {
        return Err(entity.unsupported("ends where it begins", "draw a circle, or delete it"));
    }
    let edge = Edge::arc(centre, radius, start.rem_euclid(360.0).to_radians(), sweep.to_radians());
    Ok((vec![plane.edge(edge)], false))
}

/// A corner while its groups are read.
#[derive(Clone, Copy, Default)]
struct Corner {
    x: f64,
    y: Option<f64>,
    bulge: f64,
}

const WIDE: (&str, &str) = ("has a width", "draw the border of the line instead of a wide line");

/// LWPOLYLINE.
pub(super) fn light_polyline(entity: &Record) -> Result<Edges, DrawingError> {
    let plane = Plane::of(entity)?;
    let closed = entity.integer(70)? & 1 != 0;
    let mut corners: Vec<Corner> = Vec::new();
    for tag in entity.tags {
        match (tag.code, corners.last_mut()) {
            (10, _) => corners.push(Corner { x: tag.number()?, ..Corner::default() }),
            (20, Some(corner)) => corner.y = Some(tag.number()?),
            (42, Some(corner)) => corner.bulge = tag.number()?,
            (20 | 42, None) => return Err(tag.wrong("the x of a vertex (10) before")),
            (40 | 41 | 43, _) if tag.number()? != 0.0 => return Err(entity.unsupported(WIDE.0, WIDE.1)),
            _ => {}
        }
    }
    if let Some(count) = entity.tag(90)
        && count.integer()? != corners.len() as i64
    {
        return Err(count.wrong("the number of vertices that follow"));
    }
    let missing = DrawingError::Missing { entity: entity.place(), missing: "y of a vertex (20)" };
    let corners: Option<Vec<(Point, f64)>> =
        corners.iter().map(|corner| Some((Point::new(corner.x, corner.y?), corner.bulge))).collect();
    Ok(polyline_edges(plane, &corners.ok_or(missing)?, closed))
}

/// POLYLINE with the VERTEX entities that follow it.
pub(super) fn polyline(entity: &Record, vertices: &[Record]) -> Result<Edges, DrawingError> {
    let plane = Plane::of(entity)?;
    let flags = entity.integer(70)?;
    if flags & 4 != 0 {
        let hint = "replace the spline by arcs, or export arcs";
        return Err(entity.unsupported("is the frame of a spline", hint));
    }
    if flags & (8 | 16 | 64) != 0 {
        return Err(entity.unsupported("is a line or a mesh in space", "flatten it to a plane polyline"));
    }
    let mut corners = Vec::with_capacity(vertices.len());
    for vertex in std::iter::once(entity).chain(vertices) {
        for code in [40, 41] {
            if vertex.optional(code)?.is_some_and(|width| width != 0.0) {
                return Err(entity.unsupported(WIDE.0, WIDE.1));
            }
        }
    }
    for vertex in vertices {
        let at = Point::new(vertex.number(10, "x (10)")?, vertex.number(20, "y (20)")?);
        corners.push((at, vertex.optional(42)?.unwrap_or_default()));
    }
    Ok(polyline_edges(plane, &corners, flags & 1 != 0))
}

fn polyline_edges(plane: Plane, corners: &[(Point, f64)], closed: bool) -> Edges {
    let edges = Strand::of_corners(corners, closed).into_iter().map(|edge| plane.edge(edge)).collect();
    (edges, closed)
}
