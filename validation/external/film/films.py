"""Steady journal-bearing films by another discretisation: bilinear finite elements on the half film, SciPy's sparse LU and,
for Reynolds' condition, projected successive over-relaxation. Writes films.json."""
import json, platform
import numpy as np, scipy
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu


def assemble(ratio, slenderness, around, axial):
    """Nodes around from the largest film (0) over a turn, along from the middle to the end; p = 0 on both edges and the end."""
    a = np.pi + np.linspace(0, 2 * np.pi, around + 1)
    s = np.linspace(0, 1, axial + 1)
    da, ds = a[1] - a[0], s[1] - s[0]
    node = lambda i, j: i * (axial + 1) + j
    gauss = np.array([-1, 1]) / np.sqrt(3)
    rows, cols, vals = [], [], []
    b = np.zeros((around + 1) * (axial + 1))
    for i in range(around):
        k = np.zeros((4, 4)); f = np.zeros(4)
        for g in gauss:
            for q in gauss:
                n = 0.25 * np.array([(1 - g) * (1 - q), (1 + g) * (1 - q), (1 + g) * (1 + q), (1 - g) * (1 + q)])
                dg = 0.25 * np.array([-(1 - q), 1 - q, 1 + q, -(1 + q)]) * 2 / da
                dq = 0.25 * np.array([-(1 - g), -(1 + g), 1 + g, 1 - g]) * 2 / ds
                angle = a[i] + 0.5 * da * (1 + g)
                h3 = (1 - ratio * np.cos(angle)) ** 3
                w = 0.25 * da * ds
                k += w * h3 * (np.outer(dg, dg) + np.outer(dq, dq) / slenderness ** 2)
                # v = -w_m z x e: v.n = -sin(a) per unit of w_m e, closing before the least film at a = 2 pi.
                f += w * -np.sin(angle) * n
        for j in range(axial):
            at = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]
            for p in range(4):
                b[at[p]] += f[p]
                for r in range(4):
                    rows.append(at[p]); cols.append(at[r]); vals.append(k[p, r])
    size = len(b)
    K = coo_matrix((vals, (rows, cols)), shape=(size, size)).tocsr()
    free = np.array([node(i, j) for i in range(1, around) for j in range(axial)])
    return a, s, K[free][:, free].tocsc(), b[free], free


def reynolds(K, b):
    """Complementarity by an active set whose end is checked against the conditions themselves."""
    active = b > 0
    for _ in range(300):
        p = np.zeros(len(b))
        at = np.where(active)[0]
        p[at] = splu(K[at][:, at].tocsc()).solve(b[at])
        wanted = np.where(active, p > 0, b - K @ p > 1e-14)
        if (wanted == active).all():
            return p
        active = wanted
    raise SystemExit("no set found")


def case(ratio, slenderness, condition, around=240, axial=30):
    a, s, K, b, free = assemble(ratio, slenderness, around, axial)
    p = np.zeros((around + 1) * (axial + 1))
    p[free] = reynolds(K, b) if condition == "reynolds" else np.maximum(splu(K).solve(b), 0)
    p = p.reshape(around + 1, axial + 1)
    mean = np.trapezoid(p, s, axis=1)
    force = np.array([np.trapezoid(mean * np.cos(a), a), np.trapezoid(mean * np.sin(a), a)])
    # F = 12 mu R^3 L/c^3 (w/2) eps c |f|; S = mu w/(2 pi) (R/c)^2 2 R L/F = 1/(6 pi eps |f|)
    size = np.hypot(*force)
    return dict(
        slenderness=slenderness, ratio=ratio, condition=condition, cells=[around, axial],
        sommerfeld=1 / (6 * np.pi * ratio * size),
        attitude_deg=float(np.degrees(np.arctan2(abs(force[1]), force[0]))),
        mean_over_largest_pressure=float(size / 2 / p.max()),
    )


if __name__ == "__main__":
    cases = []
    for condition in ("reynolds", "gumbel"):
        for slenderness in (0.25, 0.5, 1.0):
            for ratio in (0.2, 0.6, 0.8, 0.9, 0.95):
                cases.append(case(ratio, slenderness, condition))
    json.dump(dict(numpy=np.__version__, scipy=scipy.__version__, python=platform.python_version(), cases=cases), open("films.json", "w"), indent=1)
    for c in cases:
        print(c)
