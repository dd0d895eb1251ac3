"""Stress at the fillet of a stepped round shaft in bending, torsion and tension: axisymmetric bodies with Fourier harmonics in
the angle, triangles of fourth order with curved edges (scikit-fem, meshes by gmsh). Writes shaft.json.

Harmonic n of the displacement: u_r cos nt, u_t sin nt, u_z cos nt (n = 0: torsion is u_t alone, tension u_r and u_z).
Unknowns are (u_r, w, u_z) with w = u_t + n u_r, which vanishes on the axis for n = 0 and n = 1. Lengths in mm, stresses in MPa."""
import json, multiprocessing, platform, sys
import gmsh, numpy as np, scipy, skfem
from scipy.sparse.linalg import splu
from skfem import Basis, BilinearForm, ElementTriP4, ElementVector, FacetBasis, LinearForm, MeshTri, MeshTri2

YOUNG, POISSON = 210e3, 0.3
HARMONIC = {"bending": 1, "torsion": 0, "tension": 0, "shear": 1}
LOADS = ("bending", "torsion", "tension")
SHAPES = [(50, 60, 3), (50, 60, 4), (50, 60, 2.5), (50, 55, 3), (48, 72, 4)]
ELEMENTS = [5, 10, 20]  # elements along the fillet of the three meshes


def shaft_outline(d, D, R, length):
    """Half section of the shaft: points (r, z), {segment: centre of its arc}. The shoulder stands at z = 0, the thin side below."""
    end = np.arccos(max(0, 1 - (D - d) / 2 / R))  # below 90 deg where the fillet reaches the large cylinder first
    foot, top = (d / 2, -R), (d / 2 + R * (1 - np.cos(end)), R * (np.sin(end) - 1))
    points = [(0, -length * d), (d / 2, -length * d), foot, top]
    points += [(D / 2, 0)] if top[0] < D / 2 - 1e-9 else []
    return points + [(D / 2, length * d), (0, length * d)], {2: (d / 2 + R, -R)}


def cavity_outline(radius, size):
    """Half section of a cylinder with a spherical cavity in its middle."""
    points = [(0, -size), (size, -size), (size, size), (0, size), (0, radius), (radius, 0), (0, -radius)]
    return points, {4: (0, 0), 5: (0, 0)}


def mesh_of(points, arcs, fine, coarse, growth):
    """Triangles of size `fine` on the arcs, growing with the distance up to `coarse`; edges on arcs are bent through the circle."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for option in ("MeshSizeExtendFromBoundary", "MeshSizeFromPoints", "MeshSizeFromCurvature"):
        gmsh.option.setNumber("Mesh." + option, 0)
    geo, field = gmsh.model.geo, gmsh.model.mesh.field
    at = [geo.addPoint(r, z, 0) for r, z in points]
    lines = []
    for i, (p, q) in enumerate(zip(at, at[1:] + at[:1])):
        lines.append(geo.addCircleArc(p, geo.addPoint(*arcs[i], 0), q) if i in arcs else geo.addLine(p, q))
    geo.addPlaneSurface([geo.addCurveLoop(lines)])
    geo.synchronize()
    distance, size = field.add("Distance"), field.add("MathEval")
    field.setNumbers(distance, "CurvesList", [lines[i] for i in arcs or range(len(lines))])
    field.setNumber(distance, "Sampling", 2000)
    field.setString(size, "F", f"Min({fine}+{growth}*F{distance},{coarse})")
    field.setAsBackgroundMesh(size)
    gmsh.model.mesh.generate(2)
    tags, xyz, _ = gmsh.model.mesh.getNodes()
    triangles = gmsh.model.mesh.getElementsByType(2)[1].reshape(-1, 3)
    gmsh.finalize()
    used, t = np.unique(triangles, return_inverse=True)
    place = {tag: k for k, tag in enumerate(tags)}
    p = xyz.reshape(-1, 3)[[place[tag] for tag in used], :2].T
    straight = MeshTri(np.ascontiguousarray(p), np.ascontiguousarray(t.reshape(-1, 3).T))
    return bent(straight, points, arcs)


def bent(straight, points, arcs):
    """The mesh with quadratic edges through the arcs, the facets on them, and their centre."""
    mesh = MeshTri2.from_mesh(straight)
    if not arcs:
        return mesh, np.array([], int), None
    start = min(arcs)
    centre = np.array(arcs[start], float)[:, None]
    radius = np.hypot(*(np.array(points[start]) - centre[:, 0]))
    outer = straight.boundary_facets()
    away = np.hypot(*(straight.p[:, straight.facets[:, outer]] - centre[:, :, None]))
    facets = outer[(abs(away - radius) < 1e-6 * radius).all(axis=0)]
    middles = mesh.dofs.get_facet_dofs(facets).flatten()
    middles = middles[middles >= straight.p.shape[1]]
    x = mesh.doflocs.copy()
    off = x[:, middles] - centre
    x[:, middles] = centre + radius * off / np.hypot(*off)
    return MeshTri2(x, mesh.t), facets, centre


def strain(u, r, n):
    """Amplitudes (rr, tt, zz, rz, rt, tz) of the strains; shear strains are the angles."""
    (u_r, w, u_z), g = u, u.grad
    return np.array([g[0, 0], ((1 - n) * u_r + n * w) / r, g[2, 1], g[0, 1] + g[2, 0],
                     g[1, 0] - n * g[0, 0] - w / r, g[1, 1] - n * g[0, 1] - n * u_z / r])


def stress(u, r, n, poisson):
    e = strain(u, r, n)
    shear = YOUNG / 2 / (1 + poisson)
    volume = 2 * shear * poisson / (1 - 2 * poisson) * (e[0] + e[1] + e[2])
    return np.array([2 * shear * e[0] + volume, 2 * shear * e[1] + volume, 2 * shear * e[2] + volume, *(shear * e[3:])])


class Body:
    """Stiffness of one harmonic, factorised, with its rigid motions held at points where self-equilibrated loads have no reaction."""

    def __init__(self, meshed, n, poisson=POISSON):
        self.mesh, self.arc, self.centre = meshed
        self.n, self.poisson = n, poisson
        self.element = ElementVector(ElementTriP4(), 3)
        basis = Basis(self.mesh, self.element, intorder=12)
        self.unknowns = basis.N
        K = BilinearForm(lambda u, v, s: sum(stress(u, s.x[0], n, poisson) * strain(v, s.x[0], n)) * s.x[0]).assemble(basis)
        r, z = self.mesh.p[:, :basis.nodal_dofs.shape[1]]
        low, high = np.argmin(r * 1e6 + z), np.argmin(r * 1e6 - z)
        held, nodal = basis.get_dofs(lambda x: x[0] < 1e-9).all(["u^2", "u^3" if n else "u^1"]), basis.nodal_dofs
        pins = [nodal[0, low], nodal[0, high]] if n else [nodal[2, low], nodal[1, np.argmax(r * 1e6 + z)]]
        self.free = np.setdiff1d(np.arange(basis.N), np.concatenate([held, pins]))
        self.lu = splu(K.tocsr()[self.free][:, self.free].tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                       options={"SymmetricMode": True})

    def solve(self, nominal):
        """Displacements and strain energy under the tractions of the stress nominal(r, z) = (rz, zz, rt, tz) on the outside."""
        top, low, out = self.mesh.p[1].max(), self.mesh.p[1].min(), self.mesh.p[0].max()
        loaded = self.mesh.facets_satisfying(
            lambda x: (abs(x[1] - top) < 1e-9) | (abs(x[1] - low) < 1e-9) | (abs(x[0] - out) < 1e-9), boundaries_only=True)

        def power(v, s):
            rz, zz, rt, tz = nominal(*s.x)
            n_r, n_z = s.n
            t_r, t_t, t_z = rz * n_z, rt * n_r + tz * n_z, rz * n_r + zz * n_z
            return (t_r * v[0] + t_t * (v[1] - self.n * v[0]) + t_z * v[2]) * s.x[0]

        f = LinearForm(power).assemble(FacetBasis(self.mesh, self.element, intorder=12, facets=loaded))
        u = np.zeros(self.unknowns)
        u[self.free] = self.lu.solve(f[self.free])
        return u, 0.5 * f @ u * (np.pi if self.n else 2 * np.pi)

    def on_arc(self, u, points=41):
        """Points of the arc (r, z) and the amplitudes of the stresses there."""
        basis = FacetBasis(self.mesh, self.element, facets=self.arc,
                           quadrature=(np.linspace(0, 1, points)[None], np.full(points, 1 / points)))
        x = np.array(basis.global_coordinates())
        keep = x[0] > 1e-6  # the ends of a cavity's arc lie on the axis
        s = stress(basis.interpolate(u), np.where(keep, x[0], 1), self.n, self.poisson)
        return x[:, keep], s[:, keep]


def measures(s, cos, sin):
    """Largest principal stress, largest shear stress and von Mises stress of amplitudes at the angle with these cos nt, sin nt."""
    rr, tt, zz, rz = s[:4] * cos
    rt, tz = s[4:] * sin
    principal = np.linalg.eigvalsh(np.moveaxis(np.array([[rr, rt, rz], [rt, tt, tz], [rz, tz, zz]]), -1, 0))
    mises = np.sqrt(((principal - np.roll(principal, 1, axis=1)) ** 2).sum(axis=1) / 2)
    return principal[:, 2], (principal[:, 2] - principal[:, 0]) / 2, mises


def nominal(load, d, D):
    """Stress of plain shafts, 1 at the surface of the thin one; the same moment, torque or force in the thick one."""
    def at(r, z):
        ratio = np.where(z > 0, d / D, 1.0)
        linear, zero = r / (d / 2) * ratio ** 4, 0 * r
        return {"bending": (zero, linear, zero, zero), "torsion": (zero, zero, zero, linear),
                "tension": (zero, ratio ** 2, zero, zero)}[load]
    return at


def fillet_factors(shape, load, body):
    """Kt (in torsion of shear), von Mises factor, and the angles of both from the tangent point at the small cylinder."""
    d, D, R = shape
    x, s = body.on_arc(body.solve(nominal(load, d, D))[0])
    angle = np.degrees(np.arctan2(x[1] - body.centre[1], body.centre[0] - x[0]))
    first, shear, mises = measures(s, 1.0, 0.0 if body.n else 1.0)
    for t in np.radians(range(15, 91, 15)) if body.n else []:
        aside, _, mises_aside = measures(s, np.cos(t), np.sin(t))
        assert aside.max() < first.max() and mises_aside.max() < mises.max(), "peak outside the plane of the moment"
    peak, mises = (shear, mises / np.sqrt(3)) if load == "torsion" else (first, mises)
    return np.array([peak.max(), mises.max(), angle[peak.argmax()], angle[mises.argmax()]])


def bodies(shape, elements, length=2.5, poisson=POISSON):
    """Bodies of both harmonics on one mesh: all sizes in proportion to 1 / elements."""
    d, D, R = shape
    meshed = mesh_of(*shaft_outline(d, D, R, length), R * np.pi / 2 / elements, d / elements, 1.8 / elements)
    return {n: Body(meshed, n, poisson) for n in (0, 1)}


def richardson(values):
    """Value and band of three meshes, each of half the size of the one before. Without an order from 0.5 to 6 the value is that of the
    finest mesh and the band three times the last difference where that is at most a quarter of the first, else three times the larger
    of both. No band is below 1e-4 of the value, about as close as the spherical cavity comes to its closed form."""
    a, b, c = values
    first, last = b - a, c - b
    if 2 ** 0.5 * abs(last) <= first * np.sign(last) <= 2 ** 6 * abs(last):
        extrapolated = c + last / (first / last - 1)
        return extrapolated, max(3 * abs(extrapolated - c), 1e-4 * c)
    return c, max(3 * (abs(last) if 4 * abs(last) <= abs(first) else max(abs(first), abs(last))), 1e-4 * c)


# Kt = SUM C_i (2h/D)^(i-1), C_i = a + b q + c q^2, q^2 = h/R: rows a, b, c of C_1 to C_4 for a range of h/R. Sources in README.md.
POLYNOMIALS = {
    "roark": {
        "bending": [(0.25, 2, [(0.927, 1.149, -0.086), (0.015, -3.281, 0.837), (0.847, 1.716, -0.506), (-0.790, 0.417, -0.246)]),
                    (2, 20, [(1.225, 0.831, -0.010), (-3.790, 0.958, -0.257), (7.374, -4.834, 0.862), (-3.809, 3.046, -0.595)])],
        "torsion": [(0.25, 2, [(0.953, 0.680, -0.053), (-0.493, -1.820, 0.517), (1.621, 0.908, -0.529), (-1.081, 0.232, 0.065)])],
        "tension": [(0.25, 2, [(0.927, 1.149, -0.086), (0.011, -3.029, 0.948), (-0.304, 3.979, -1.737), (0.366, -2.098, 0.875)]),
                    (2, 20, [(1.225, 0.831, -0.010), (-1.831, -0.318, -0.049), (2.236, -0.522, 0.176), (-0.630, 0.009, -0.117)])]},
    "pilkey": {
        "bending": [(0.1, 2, [(0.947, 1.206, -0.131), (0.022, -3.405, 0.915), (0.869, 1.777, -0.555), (-0.810, 0.422, -0.260)]),
                    (2, 20, [(1.232, 0.832, -0.008), (-3.813, 0.968, -0.260), (7.423, -4.868, 0.869), (-3.839, 3.070, -0.600)])],
        "torsion": [(0.25, 4, [(0.905, 0.783, -0.075), (-0.437, -1.969, 0.553), (1.557, 1.073, -0.578), (-1.061, 0.171, 0.086)])],
        "tension": [(0.1, 2, [(0.926, 1.157, -0.099), (0.012, -3.036, 0.961), (-0.302, 3.977, -1.744), (0.365, -2.098, 0.878)]),
                    (2, 20, [(1.200, 0.860, -0.022), (-1.805, -0.346, -0.038), (2.198, -0.486, 0.165), (-0.593, -0.028, -0.106)])]}}


def printed_factor(source, shape, load):
    """Factor by a published formula, None outside its range."""
    d, D, R = shape
    h = (D - d) / 2
    if source == "tipton":
        ratio = (D / d) ** 2
        root = (-0.14 - 0.363 * ratio + 0.503 * ratio ** 2) / (1 - 2.39 * ratio + 3.368 * ratio ** 2)
        return 0.632 + 0.377 * (D / d) ** -4.4 + (R / d) ** -0.5 * root ** 0.5 if load == "bending" else None
    for low, high, rows in POLYNOMIALS[source][load]:
        if low <= h / R <= high:
            return sum((a + b * (h / R) ** 0.5 + c * h / R) * (2 * h / D) ** i for i, (a, b, c) in enumerate(rows))
    return None


def plain_shaft_errors(load, d=50.0, length=250.0):
    """Largest error of any stress over the nominal one, and error of the energy, of a shaft without a step."""
    outline = [(0, -length / 2), (d / 2, -length / 2), (d / 2, length / 2), (0, length / 2)]
    body = Body(mesh_of(outline, {}, 8, 8, 0), HARMONIC[load])
    u, energy = body.solve(nominal(load, d, d))
    basis = Basis(body.mesh, body.element, intorder=6)
    x = np.array(basis.global_coordinates())
    rz, zz, rt, tz = nominal(load, d, d)(*x)
    exact = np.array([0 * rz, 0 * rz, zz, rz, rt, tz])
    error = abs(stress(basis.interpolate(u), x[0], body.n, POISSON) - exact).max()
    # Half the mean of the squared stress over the modulus, times the volume: M^2 L / (2 E I) and so on.
    share, modulus = {"bending": (1 / 4, YOUNG), "torsion": (1 / 2, YOUNG / 2 / (1 + POISSON)), "tension": (1, YOUNG)}[load]
    closed = share * np.pi * d ** 2 / 4 * length / (2 * modulus)
    return error, abs(energy / closed - 1)


def cavity_factors(elements=24, size=30.0):
    """Factors at a spherical cavity of radius 1, each beside its closed form for an infinite body."""
    meshed = mesh_of(*cavity_outline(1.0, size), np.pi / elements, 3.0, 0.2)
    loads = {"tension": lambda r, z: (0 * r, 0 * r + 1, 0 * r, 0 * r), "torsion": lambda r, z: (0 * r, 0 * r, 0 * r, r),
             "shear": lambda r, z: (0 * r + 1, 0 * r, 0 * r, 0 * r - 1)}
    closed = {"tension": (27 - 15 * POISSON) / 2 / (7 - 5 * POISSON), "torsion": 5 / 4,
              "shear": 15 * (1 - POISSON) / (7 - 5 * POISSON)}
    found = {}
    for load, field in loads.items():
        body = Body(meshed, HARMONIC[load])
        _, s = body.on_arc(body.solve(field)[0])
        cos, sin = (0.0, 1.0) if load == "shear" else (1.0, 1.0)
        found[load] = {"computed": measures(s, cos, sin)[0 if load == "tension" else 1].max(), "closed_form": closed[load]}
    return found


def one_load(shape, load, meshes):
    factors = np.array([fillet_factors(shape, load, mesh[HARMONIC[load]]) for mesh in meshes])
    (kt, band), (mises, mises_band) = richardson(factors[:, 0]), richardson(factors[:, 1])
    result = {"kt": kt, "kt_band": band, "kt_meshes": list(factors[:, 0]), "kt_angle_deg": factors[2, 2], "von_mises": mises,
              "von_mises_band": mises_band, "von_mises_meshes": list(factors[:, 1]), "von_mises_angle_deg": factors[2, 3]}
    for source in ("roark", "pilkey", "tipton"):
        value = printed_factor(source, shape, load)
        result[source] = value
        result[source + "_error_percent"] = None if value is None else 100 * (value / kt - 1)
    print(shape, load, f"Kt {kt:.5f} +- {band:.1e}, von Mises {mises:.5f}, at {factors[2, 2]:.1f} deg", flush=True)
    return result


def rounded(value):
    if isinstance(value, dict):
        return {key: rounded(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(entry) for entry in value]
    return float(f"{value:.7g}") if isinstance(value, (float, np.floating)) else value


def one_shaft(shape):
    meshes = [bodies(shape, elements) for elements in ELEMENTS]
    return {"d_mm": shape[0], "D_mm": shape[1], "R_mm": shape[2], "unknowns": [int(mesh[0].unknowns) for mesh in meshes],
            **{load: one_load(shape, load, meshes) for load in LOADS}}


def checks():
    varied = lambda **how: {load: fillet_factors(SHAPES[0], load, body[HARMONIC[load]])[:2].tolist()
                            for body in [bodies(SHAPES[0], ELEMENTS[1], **how)] for load in LOADS}
    return {"plain_shaft_errors": {load: dict(zip(("stress", "energy"), plain_shaft_errors(load))) for load in LOADS},
            "spherical_cavity": cavity_factors(),
            "kt_and_von_mises_by_length_over_d": {str(length): varied(length=length) for length in (2.5, 3.5, 5.0)},
            "kt_and_von_mises_by_poisson": {str(poisson): varied(poisson=poisson) for poisson in (0.25, 0.3, 0.35)}}


def main():
    with multiprocessing.Pool(int(sys.argv[1]) if len(sys.argv) > 1 else None) as pool:
        checked, shafts = pool.apply_async(checks), pool.map(one_shaft, SHAPES, chunksize=1)
        answer = {"scikit-fem": skfem.__version__, "gmsh": gmsh.__version__, "numpy": np.__version__, "scipy": scipy.__version__,
                  "python": platform.python_version(), "young_MPa": YOUNG, "poisson": POISSON, "elements_along_90_deg": ELEMENTS,
                  "shafts": shafts, "checks": checked.get()}
    open("shaft.json", "w").write(json.dumps(rounded(answer), indent=1) + "\n")


if __name__ == "__main__":
    main()
