"""Runs exported Modelica text in the Modelica compiler rumoca and stores the curves.

Usage: python run.py  (rumoca 0.10 from a package index; `lanchester bondgraph export FILE > NAME.mo` gives the models)
"""

import json
import pathlib

import rumoca

here = pathlib.Path(__file__).parent
cases = {
    "mass-spring-damper": ("mass_spring_damper", 4.0, 40, ["mass_flow", "spring_effort"]),
    "dc-motor": ("dc_motor", 0.5, 50, ["coil_flow", "flywheel_flow"]),
    "slider-crank": ("slider_crank", 1.0, 50, ["crank_flow", "piston_flow", "piston_effort"]),
    "three-cylinder": (
        "Three_cylinder_engine_with_balancer_shaft",
        0.06,
        60,
        ["theta", "crankshaft_flow", "crankshaft_effort", "piston1_x_effort", "rod2_y_effort", "rod_turn3_effort"],
    ),
}
for name, (model, duration, samples, variables) in cases.items():
    compiled = rumoca.Session().load(str(here / f"{name}.mo"), model=model)
    config = rumoca.SimConfig(rtol=1e-10, atol=1e-12, max_wall_seconds=60)
    result = compiled.simulate(t=(0, duration), dt=duration / samples, config=config)
    table = {"tool": f"rumoca {rumoca.version()}", "graph": name, "rtol": 1e-10, "atol": 1e-12}
    table["time"] = [float(t) for t in result.time]
    for variable in variables:
        table[variable] = [float(v) for v in result[variable]]
    (here / f"{name}.json").write_text(json.dumps(table, indent=1) + "\n")
    print(name, {variable: table[variable][-1] for variable in variables})
