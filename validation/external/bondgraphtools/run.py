"""State equations of the shipped linear graphs by BondGraphTools, as matrices.

Usage: python run.py  (BondGraphTools 0.4.6 from a package index)

Reads the graph files of examples/bond-graphs itself: elements, bonds and parameters, all numbers in SI units. A source is set to the
value that is asked for; the equations are linear in states and sources, so that differences of their values give the matrices.

BondGraphTools takes power into a two-port at both ports: TF has e_1 = R e_0 and f_0 = -R f_1, GY has e_1 = -R f_0 and e_0 = R f_1.
A ratio f2 = n f1 of ours is R = 1/n, a ratio e1 = r f2 is R = -r.
"""

import json
import pathlib
import re
import tomllib

import BondGraphTools as bgt
import sympy

here = pathlib.Path(__file__).parent
graphs = here.parents[2] / "examples" / "bond-graphs"
names = ["mass-spring-damper", "dc-motor", "two-tanks", "torsion-chain", "gear-train", "hydraulic-press"]
# Units of these files that are not those of SI themselves.
scale = {"mH": 1e-3, "mm": 1e-3}


def number(text, known):
    """An expression of numbers with units, and of parameters."""
    text = str(text)
    plain = re.fullmatch(r"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(.*)", text)
    if plain and not re.match(r"[*/+^-]", plain[2]):
        return float(plain[1]) * scale.get(plain[2].strip(), 1.0)
    return float(sympy.sympify(text.replace("^", "**"), locals=dict(known)))


def parameters(file):
    known = {}
    for name, text in file.get("parameters", {}).items():
        known[name] = number(text, known)
    return known


def element(name, law, known, sources):
    kind = law["kind"].removeprefix("M")
    value = lambda key: number(law[key], known)
    if kind in ("0", "1"):
        return bgt.new(kind, name=name)
    if kind in ("Se", "Sf"):
        return bgt.new(kind, name=name, value=sources.get(name, 0))
    if kind == "R":
        return bgt.new(kind, name=name, value=value("resistance"))
    if kind == "C":
        return bgt.new(kind, name=name, value=value("capacitance") if "capacitance" in law else 1 / value("stiffness"))
    if kind == "I":
        return bgt.new(kind, name=name, value=value("inertia"))
    ratio = value("ratio")
    return bgt.new(kind, name=name, value=1 / ratio if kind == "TF" else -ratio)


def relations(file, sources):
    """Rates of the states by their expressions, in the order of the states."""
    known = parameters(file)
    model = bgt.new(name="model")
    parts = {name: element(name, law, known, sources) for name, law in file["elements"].items()}
    bgt.add(model, *parts.values())
    for bond in file["bonds"]["list"]:
        ends = []
        for end in bond.split(">"):
            name, _, port = end.strip().partition(".")
            ends.append((parts[name], int(port) - 1) if port else parts[name])
        bgt.connect(*ends)
    states = {str(symbol): component.name for symbol, (component, _) in model.state_vars.items()}
    order = sorted(states, key=lambda symbol: int(symbol.split("_")[1]))
    x = [sympy.Symbol(symbol) for symbol in order]
    dx = [sympy.Symbol(f"d{symbol}") for symbol in order]
    # Every symbol of the relations by its name: BondGraphTools makes its own.
    laws = [sympy.sympify(str(law)) for law in model.constitutive_relations]
    return states, order, x, dx, laws


def rates(file, sources):
    """A and the constant part of x' = A x + b, states that follow eliminated; names of the states that are left."""
    states, order, x, dx, laws = relations(file, sources)
    # Relations without rates tie states to one another: those followers go.
    ties = [law for law in laws if not (law.free_symbols & set(dx))]
    return states, order, x, dx, laws, ties


table = {}
for name in names:
    file = tomllib.loads((graphs / f"{name}.toml").read_text())
    inputs = [own for own, law in file["elements"].items() if law["kind"] in ("Se", "Sf")]
    cases = [{}] + [{own: 1} for own in inputs]
    a, columns = None, []
    for case in cases:
        states, order, x, dx, laws, ties = rates(file, case)
        kept = list(range(len(x)))
        if ties:
            # The first of the states that a tie names leads; the others are expressed by it.
            lead = sympy.solve(ties, x[1:], dict=True)[0]
            follow = {dx[x.index(var)]: expression.subs(dict(zip(x, dx))) for var, expression in lead.items()}
            laws = [law.subs(lead).subs(follow) for law in laws if law not in ties]
            kept = [index for index, var in enumerate(x) if var not in lead]
        solved = sympy.solve(laws, [dx[index] for index in kept], dict=True)[0]
        own = [sympy.expand(solved[dx[index]]) for index in kept]
        matrix = [[float(rate.coeff(x[index])) for index in kept] for rate in own]
        rest = [float(rate.subs({var: 0 for var in x})) for rate in own]
        if a is None:
            a = matrix
        else:
            columns.append(rest)
    table[name] = {
        "states": [states[order[index]] for index in kept],
        "inputs": inputs,
        "a": a,
        "b": [[column[row] for column in columns] for row in range(len(a))],
    }
    print(name, table[name])
table = {"tool": "BondGraphTools 0.4.6", "graphs": table}
(here / "matrices.json").write_text(json.dumps(table, indent=1) + "\n")
